"use strict";

// Handles the keyboard, except for keys that the focused element needs.

const kKeys = [
  ["Space", "play or pause"],
  ["\u2190 \u2192", "one record back or forward"],
  ["Home, End", "to the start, to the end"],
  ["+ \u2212", "play faster, slower"],
  ["W A S D", "turn the views"],
  ["I, O", "zoom in, out"],
  ["H, ?", "this help"],
];

function listenToKeys(playback, stage) {
  fillDescriptions(byId("help-keys"), kKeys);
  byId("help").addEventListener("click", toggleHelp);
  const turn = (azimuth, elevation) => stage && stage.orbit.turn(azimuth, elevation);
  const zoom = factor => stage && stage.orbit.zoomBy(factor);
  const actions = {
    " ": () => playback.toggle(),
    arrowleft: () => playback.seek(playback.index - 1),
    arrowright: () => playback.seek(playback.index + 1),
    home: () => playback.seek(0),
    end: () => playback.seek(playback.last),
    "+": () => playback.changeSpeed(1),
    "=": () => playback.changeSpeed(1),  // the key of + without Shift on many keyboards
    "-": () => playback.changeSpeed(-1),
    a: () => turn(-0.1, 0), d: () => turn(0.1, 0), w: () => turn(0, 0.1), s: () => turn(0, -0.1),
    i: () => zoom(1.25), o: () => zoom(0.8),
    h: toggleHelp, "?": toggleHelp,
  };
  document.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.toLowerCase();
    const action = actions[key];
    if (!action || needsKey(document.activeElement, key)) return;
    if (byId("help-dialog").open && action !== toggleHelp) return;
    event.preventDefault();
    action();
  });
}

function needsKey(focused, key) {
  if (!focused || focused === document.body) return false;
  const moves = ["arrowleft", "arrowright", "home", "end"].includes(key);
  if (focused.matches("select")) return true;
  if (focused.matches("button, summary, input[type=checkbox]")) return key === " ";
  if (focused.matches(".scroll-box, #command")) return moves;  // they scroll sideways
  return false;
}

function toggleHelp() {
  const dialog = byId("help-dialog");
  if (dialog.open) dialog.close();
  else dialog.showModal();
}
