"use strict";

// All plots of the page.

class Plots {
  constructor(report, playback) {
    this.plots = report.plots.map(subject => new Plot(report, playback, subject));
    byId("plots").append(...this.plots.map(plot => plot.figure));
    const stride = Math.max(...report.contenders.map(contender => contender.stride));
    if (stride > 1) {
      byId("stride-note").textContent = `Each point stands for ${stride} steps, of which it shows the largest error.`;
    }
    byId("fast-note").hidden = !report.contenders.some(contender => contender.isFast);
    this.rebuild();
    playback.addEventListener("time", oncePerFrame(() => this.plots.forEach(plot => plot.showTime())));
    let width = byId("plots").clientWidth;
    new ResizeObserver(() => {
      if (byId("plots").clientWidth === width) return;
      width = byId("plots").clientWidth;
      this.plots.forEach(plot => plot.resize());
    }).observe(byId("plots"));
  }

  rebuild() {
    this.plots.forEach(plot => plot.rebuild());
  }
}
