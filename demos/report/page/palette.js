"use strict";

// One colour per contender, the same in the whole page and, on a light background, in polhode_viewer: those of Okabe and
// Ito, which colour-blind people can tell apart, darkened or lightened where the background needs it, and two more.
// Contenders after the last colour get dashed lines.

const kColours = {
  light: ["#0072b2", "#d55e00", "#009e73", "#cc5fa0", "#3ba3e0", "#d98e00", "#3c4147", "#998a00", "#882255"],
  dark: ["#3d9be0", "#f07a28", "#12b886", "#e08fc0", "#8fd0f7", "#f0b030", "#ffffff", "#f0e442", "#c2406e"],
};
const kDashes = [[], [7, 4], [2, 3]];

// Other colours, for canvases, which cannot read the style sheet.
const kInks = {
  light: {text: "#1b1f24", faint: "#5b636d", grid: "#dfe3e8", x: "#b3261e", y: "#1e7d32", z: "#2455c3",
    omega: "#8a5a00", momentum: "#6a2fa0", rotor: "#00707a", diverged: "#9aa0a6", ground: "#8d99a6", edge: "#20242a"},
  dark: {text: "#e8eaed", faint: "#a9b1ba", grid: "#333940", x: "#ff8a80", y: "#7edb8a", z: "#8fb4ff",
    omega: "#ffc861", momentum: "#cfa3ff", rotor: "#5fd7e0", diverged: "#70767d", ground: "#6d7883", edge: "#f1f3f5"},
};

const palette = {
  darkQuery: window.matchMedia("(prefers-color-scheme: dark)"),

  get theme() {
    return this.darkQuery.matches ? "dark" : "light";
  },
  get ink() {
    return kInks[this.theme];
  },
  colour(number) {
    const colours = kColours[this.theme];
    return colours[number % colours.length];
  },
  dash(number) {
    return kDashes[Math.floor(number / kColours.light.length) % kDashes.length];
  },

  /** Sets the colours as CSS properties, so that elements that use them follow the theme. */
  apply(count) {
    const style = document.documentElement.style;
    for (let number = 0; number < count; ++number) style.setProperty(`--contender-${number}`, this.colour(number));
    for (const name of ["x", "y", "z", "omega", "momentum", "rotor"]) style.setProperty(`--ink-${name}`, this.ink[name]);
  },

  /** Returns a piece of a contender's line, for legends. */
  swatch(number) {
    return lineSwatch(`var(--contender-${number})`, this.dash(number));
  },
};

function lineSwatch(colour, dash) {
  const swatch = svgElement("svg", {class: "swatch", width: 26, height: 10, viewBox: "0 0 26 10", "aria-hidden": "true"});
  const line = svgElement("line", {x1: 1, y1: 5, x2: 25, y2: 5, "stroke-width": 3, "stroke-dasharray": dash.join(" ")});
  line.style.setProperty("stroke", colour);
  swatch.append(line);
  return swatch;
}
