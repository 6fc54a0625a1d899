"use strict";

// One plot: uPlot, a line for the time shown, a legend with the numbers at that time.

class Plot {
  constructor(report, playback, subject) {
    Object.assign(this, {report, playback, subject});
    this.isVector = report.contenders[0].components[subject.key] > 1;
    this.contender = report.contenders[0];  // of a plot with a single contender
    this.wholeRange = false;
    this.chart = element("div", {class: "chart"});
    this.note = element("p", {class: "note"});
    this.legend = element("ul", {class: "legend"});
    this.tools = element("div", {class: "plot-tools"});
    this.figure = element("figure", {class: "plot", id: `plot-${subject.key}`},
      element("figcaption", {}, element("h3", {}, subject.label), element("p", {}, subject.meaning)),
      this.tools, this.chart, this.note, this.legend);
    this.addTools();
  }

  addTools() {
    if (this.isVector) {
      const choice = element("select", {"aria-label": "Contender of this plot"},
        ...this.report.contenders.map(({name, number}) => element("option", {value: number}, name)));
      choice.addEventListener("change", () => {
        this.contender = this.report.contenders[Number(choice.value)];
        this.rebuild();
      });
      this.tools.append(element("label", {}, "of ", choice));
    }
    if (!cutOf(this.report, this.subject)) return;
    const box = element("input", {type: "checkbox"});
    box.addEventListener("change", () => {
      this.wholeRange = box.checked;
      this.rebuild();
    });
    this.cutTool = element("label", {}, box, " whole range");
    this.tools.append(this.cutTool);
  }

  /** Redraws everything after a change of colours, contender or range. */
  rebuild() {
    if (this.chart.clientWidth === 0) return;
    if (this.uplot) this.uplot.destroy();
    this.uplot = null;
    this.lines = this.isVector
      ? kBodyAxes.map((_, axis) => lineOf(this.report, this.contender, this.subject, axis))
      : this.report.contenders.map(contender => lineOf(this.report, contender, this.subject));
    this.legends = this.lines.map((_, number) => this.legendEntry(number));
    this.legend.replaceChildren(...this.legends.map(entry => entry.item));
    const isEmpty = this.lines.every(line => line.every(value => value === null || value === undefined));
    this.figure.classList.toggle("is-empty", isEmpty);
    if (isEmpty) {
      this.note.textContent = "Unknown here.";
      return;
    }
    this.chooseScale();
    this.uplot = new uPlot(this.options(), [this.report.times, ...this.lines], this.chart);
    this.timeLine = element("div", {class: "time-line"});
    this.uplot.over.append(this.timeLine);
    this.listen();
    this.showNote();
  }

  legendEntry(number) {
    const value = element("span", {class: "value"});
    const axis = kBodyAxes[number];
    const swatch = this.isVector ? lineSwatch(`var(--ink-${axis})`, kAxisDashes[axis]) : palette.swatch(number);
    const name = this.isVector ? axis : this.report.contenders[number].name;
    const item = element("li", {}, swatch, element("span", {class: "name", title: name}, name), value);
    return {item, value};
  }

  isShown(number) {
    return this.isVector || this.report.contenders[number].visible;
  }

  chooseScale() {
    const [low, high] = extent(this.lines.filter((_, number) => this.isShown(number)));
    this.isLog = Boolean(this.subject.is_logarithmic || (this.subject.is_adaptive && low > 0 && high > 20 * low));
    const cut = cutOf(this.report, this.subject);
    this.isCut = Boolean(cut && (low < cut[0] || high > cut[1]));
    this.cut = this.isCut && !this.wholeRange ? cut : null;
    if (this.isLog) this.range = logRange(low, high);
    else if (this.cut) this.range = linearRange(Math.max(low, this.cut[0]), Math.min(high, this.cut[1]));
    else this.range = linearRange(low, high);
  }

  options() {
    const ink = palette.ink;
    const axis = {stroke: ink.text, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif",
      labelGap: 2, grid: {stroke: ink.grid, width: 1}, ticks: {stroke: ink.grid, width: 1, size: 5}};
    const end = this.report.times[this.playback.last];
    return {
      ...this.size(), legend: {show: false}, cursor: {show: false}, padding: [8 + 4 * this.fastContenders().length, 14, 0, 0],
      scales: {
        x: {time: false, range: () => [0, end > 0 ? end : this.report.scenario.duration]},
        y: {distr: this.isLog ? 3 : 1, range: () => this.range},
      },
      axes: [
        {...axis, label: "t, s", labelSize: 18, size: 26, values: (_, splits) => linearTexts(splits)},
        {...axis, label: `${this.subject.label}, ${unitText(this.subject.unit)}`, labelSize: 18, size: 58,
          ...(this.isLog ? {splits: (u, _, low, high) => logSplits(low, high, u.bbox.height / uPlot.pxRatio)} : {}),
          filter: (_, splits) => splits,
          values: (_, splits) => (this.isLog ? logTexts(splits) : linearTexts(splits))},
      ],
      series: [{}, ...this.lines.map((line, number) => this.seriesOptions(line, number))],
      // uPlot knows the position of a time only after it has drawn itself, which is after this call.
      hooks: {draw: [u => this.drawFastMarks(u), () => this.showTime()]},
    };
  }

  seriesOptions(line, number) {
    const axis = kBodyAxes[number];
    const count = line.filter(value => value !== null && value !== undefined).length;
    return {
      stroke: this.isVector ? palette.ink[axis] : palette.colour(number),
      dash: this.isVector ? kAxisDashes[axis] : palette.dash(number),
      width: 1.75, show: this.isShown(number), points: {show: count < 25, size: 6},
    };
  }

  size() {
    const width = this.chart.clientWidth;
    return {width, height: Math.round(Math.min(280, Math.max(240, 0.5 * width)))};
  }

  resize() {
    if (this.uplot) this.uplot.setSize(this.size());
    else this.rebuild();
  }

  fastContenders() {
    const shown = this.isVector ? [this.contender] : this.report.visibleContenders;
    return shown.filter(contender => contender.isFast);
  }

  /** Draws the marks above the plot, in a lane for each contender with fast steps. */
  drawFastMarks(u) {
    const {ctx, bbox} = u;
    ctx.save();
    ctx.lineWidth = 2 * uPlot.pxRatio;
    ctx.setLineDash([]);  // may be left from the last line
    this.fastContenders().forEach((contender, lane) => {
      const y = bbox.top - (4 + 4 * lane) * uPlot.pxRatio;
      ctx.strokeStyle = palette.colour(contender.number);
      ctx.beginPath();
      for (const [from, to] of fastStretches(this.report, contender)) {
        const left = u.valToPos(this.report.times[from - 1], "x", true);
        const right = u.valToPos(this.report.times[to], "x", true);
        ctx.moveTo(left, y);
        ctx.lineTo(Math.max(right, left + uPlot.pxRatio), y);
      }
      ctx.stroke();
    });
    ctx.restore();
  }

  /** Clicking or dragging in the plot moves the time. */
  listen() {
    const over = this.uplot.over;
    const seek = event => {
      const left = event.clientX - over.getBoundingClientRect().left;
      this.playback.seekTime(this.uplot.posToVal(left, "x"));
    };
    over.addEventListener("pointerdown", event => {
      if (event.button !== 0) return;
      over.setPointerCapture(event.pointerId);
      seek(event);
    });
    over.addEventListener("pointermove", event => {
      if (over.hasPointerCapture(event.pointerId)) seek(event);
    });
  }

  showNote() {
    const notes = [];
    const isAtFloor = (line, number) => this.isShown(number) && line.includes(kLogFloor);
    if (this.subject.is_logarithmic && this.lines.some(isAtFloor)) {
      notes.push(`0, which has no logarithm, and what is smaller than ${powerOfTen(-17)} is drawn there.`);
    }
    if (this.cut) {
      const [low, high] = this.cut;
      const isBeyond = line => line.some(value => typeof value === "number" && (value < low || value > high));
      const beyond = this.isVector ? [this.contender]
        : this.report.visibleContenders.filter(({number}) => isBeyond(this.lines[number]));
      notes.push(`The axis is cut; beyond it: ${beyond.map(({name}) => name).join(", ")}.`);
    }
    if (this.cutTool) this.cutTool.hidden = !this.isCut;
    this.note.textContent = notes.join(" ");
  }

  showTime() {
    if (!this.uplot) return;
    const {index, t_s} = this.playback;
    this.timeLine.style.transform = `translateX(${this.uplot.valToPos(t_s, "x").toFixed(2)}px)`;
    this.legends.forEach(({item, value}, number) => {
      const contender = this.isVector ? this.contender : this.report.contenders[number];
      item.hidden = !this.isShown(number);
      setText(value, this.valueText(contender, number, contender.recordAt[index], t_s));
    });
  }

  valueText(contender, number, record, t_s) {
    if (contender.isOver(t_s)) return "diverged";
    const value = contender.value(this.subject.key, record, this.isVector ? number : 0);
    return shortNumber(this.subject.is_logarithmic ? Math.abs(value) : value, this.subject.is_adaptive ? 6 : 3);
  }
}
