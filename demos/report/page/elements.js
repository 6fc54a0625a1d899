"use strict";

// Creates elements of the page. Texts are always inserted as text, since names come from files and must not be read as HTML.

function byId(id) {
  return document.getElementById(id);
}

/** Creates an element with attributes and children; children are elements or texts. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

function svgElement(tag, attributes = {}) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

/** Creates a dt and its dd for each pair. */
function fillDescriptions(list, pairs) {
  list.replaceChildren(...pairs.flatMap(([term, text]) => [element("dt", {}, term), element("dd", {}, text)]));
}

/** Sets the text only if it changes, to avoid computing the layout again. */
function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/** Runs the work once before the next frame, however often it is requested until then. */
function oncePerFrame(work) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      work();
    });
  };
}
