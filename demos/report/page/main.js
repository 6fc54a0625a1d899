"use strict";

// Assembles the page.

function start() {
  const report = readReport();
  palette.apply(report.contenders.length);
  showOverview(report);
  const playback = new Playback(report.times, report.scenario.duration);
  const list = new ContenderList(report);
  const transport = new Transport(report, playback);
  showFigures(report);
  const plots = new Plots(report, playback);
  const stage = makeStage(report, playback);
  listenToKeys(playback, stage);

  list.addEventListener("change", () => {
    if (stage) stage.showVisible();
    plots.rebuild();
    transport.showMarks();
    showHidden(report);
  });
  palette.darkQuery.addEventListener("change", () => {
    palette.apply(report.contenders.length);
    plots.rebuild();
    if (stage) stage.applyPalette();
  });

  // For tests: the state of the page.
  window.polhodeReport = {
    get index() { return playback.index; },
    get last() { return playback.last; },
    get t_s() { return playback.t_s; },
    get end_s() { return playback.times[playback.last]; },
    get playing() { return playback.playing; },
    get speed() { return playback.speed; },
  };
  // Two frames later everything requested has been drawn.
  requestAnimationFrame(() => requestAnimationFrame(() => { document.documentElement.dataset.ready = "true"; }));
}

/** Creates the views, or none without WebGL; the rest of the page works without them. */
function makeStage(report, playback) {
  if (hasWebGL()) {
    try {
      return new Stage(report, playback);
    } catch (error) {
      console.error(error);
    }
  }
  byId("stage-missing").hidden = false;
  for (const id of ["stage", "stage-hint"]) byId(id).hidden = true;
  document.querySelector(".stage-tools").hidden = true;
  return null;
}

try {
  start();
} catch (error) {
  byId("trouble").textContent = `The report cannot be shown. ${error.message}`;
  byId("trouble").hidden = false;
  throw error;
}
