"use strict";

// The bar at the bottom: play, slider, time, speed; and the marks of fast steps and divergences under the slider.

class Transport {
  constructor(report, playback) {
    this.report = report;
    this.playback = playback;
    this.distance_s = (playback.times[playback.last] - playback.times[0]) / Math.max(1, playback.last);
    const scrubber = byId("scrubber");
    scrubber.max = playback.last;
    scrubber.disabled = playback.last === 0;
    scrubber.addEventListener("input", () => playback.seek(scrubber.valueAsNumber));
    byId("play").addEventListener("click", () => playback.toggle());
    byId("back").addEventListener("click", () => playback.seek(playback.index - 1));
    byId("forward").addEventListener("click", () => playback.seek(playback.index + 1));
    byId("speed").append(...playback.speeds.map(speed => element("option", {value: speed}, `${speed}\u00d7`)));
    byId("speed").addEventListener("change", event => playback.setSpeed(Number(event.target.value)));
    playback.addEventListener("time", () => this.showTime());
    playback.addEventListener("state", () => this.showState());
    this.showTime();
    this.showState();
    this.showMarks();
  }

  showTime() {
    const {t_s, index} = this.playback;
    const text = timeText(t_s, this.distance_s) + " s";
    byId("scrubber").value = index;
    byId("scrubber").setAttribute("aria-valuetext", text);
    setText(byId("clock"), `t = ${text}`);
  }

  showState() {
    const {playing, speed} = this.playback;
    const text = playing ? "Pause" : "Play";
    setText(byId("play"), text);
    byId("play").setAttribute("aria-label", text);
    byId("speed").value = speed;
  }

  /** Draws a lane for each visible contender that has marks. */
  showMarks() {
    const marked = this.report.visibleContenders.filter(each => each.isFast || each.divergedAt_s !== null);
    const marks = byId("track-marks");
    marks.setAttribute("viewBox", `0 0 ${Math.max(1, this.playback.last)} ${3 * Math.max(1, marked.length)}`);
    marks.style.height = `${Math.min(24, 4 * marked.length)}px`;
    marks.replaceChildren(...marked.map((contender, lane) => this.lane(contender, lane)));
  }

  lane(contender, lane) {
    const y = 3 * lane + 1.5;
    let path = "";
    for (const [from, to] of fastStretches(this.report, contender)) path += `M${from - 1} ${y}H${to}`;
    const line = svgElement("path", {d: path, "stroke-width": 2});
    line.style.setProperty("stroke", `var(--contender-${contender.number})`);
    const group = svgElement("g");
    group.append(line);
    if (contender.divergedAt_s !== null) {
      // From the contender's divergence on.
      const from = contender.recordAt.findIndex((_, i) => contender.isOver(this.report.times[i]));
      group.append(svgElement("path", {d: `M${from} ${y}H${this.playback.last}`, "stroke-width": 1, class: "over"}));
    }
    return group;
  }
}

/** Returns pairs of first and last time index of the intervals in which the contender had steps past pi/4. */
function fastStretches(report, contender) {
  const stretches = [];
  let from = null;
  for (let i = 1; i < report.times.length; ++i) {
    const fast = !contender.isOver(report.times[i]) && contender.series.past_cut[contender.recordAt[i]] > 0;
    if (fast && from === null) from = i;
    if (!fast && from !== null) {
      stretches.push([from, i - 1]);
      from = null;
    }
  }
  if (from !== null) stretches.push([from, report.times.length - 1]);
  return stretches;
}
