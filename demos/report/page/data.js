"use strict";

// Decodes the data that polhode_compare wrote into the page, and merges the contenders' times.

/** Decodes base64 into floats, which are little-endian as on all machines with browsers. */
function decodeFloats(text) {
  const bytes = Uint8Array.from(atob(text), character => character.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

/** One contender's records. NaN is an unknown number. */
class Contender {
  constructor(json, number, components) {
    this.number = number;  // its index, which determines the colour
    this.name = json.name;
    this.summary = json.summary || "";
    this.figures = json.figures;
    this.cells = json.cells;  // the same as texts
    this.visible = true;
    this.count = json.series.count;
    this.stride = json.series.stride;  // steps that a record stands for
    this.components = components;
    this.series = {past_cut: decodeFloats(json.series.past_cut)};
    for (const [key, size] of Object.entries(components)) {
      const text = json.series[key];  // missing if all numbers are 0
      this.series[key] = text ? decodeFloats(text) : new Float32Array(size * this.count);
    }
    this.isFast = this.series.past_cut.some(steps => steps > 0);
    this.recordAt = null;  // by time index: the last record up to that time
  }

  get divergedAt_s() {
    return this.figures.diverged_at_s ?? null;
  }

  get lastTime_s() {
    return this.series.t_s[this.count - 1];
  }

  /** Returns true after the last record of a contender that diverged. */
  isOver(t_s) {
    return this.divergedAt_s !== null && t_s > this.lastTime_s;
  }

  /** Returns one number of a record, for a vector the component along an axis. */
  value(key, record, axis = 0) {
    return this.series[key][this.components[key] * record + axis];
  }

  vector(key, record) {
    return this.series[key].subarray(3 * record, 3 * record + 3);
  }
}

/** All data of the page. */
class Report {
  constructor(json) {
    Object.assign(this, {version: json.polhode_version, precision: json.precision, command: json.command,
      scenario: json.scenario, inertia_B: json.inertia_B, body: json.body, ground: json.ground || null,
      steps: json.steps, note: json.note || "", columns: json.columns, plots: json.plots});
    this.contenders = json.contenders.map((contender, number) => new Contender(contender, number, json.components));
    this.times = this.sharedTimes();
    for (const contender of this.contenders) contender.recordAt = this.recordsAt(contender);
  }

  /** Returns the times of all contenders' records, each once, and the times of divergences, which follow the last record. */
  sharedTimes() {
    const all = this.contenders.flatMap(contender => Array.from(contender.series.t_s));
    for (const contender of this.contenders) {
      if (contender.divergedAt_s !== null) all.push(Math.fround(contender.divergedAt_s));
    }
    all.sort((a, b) => a - b);
    // Two contenders may round the same time differently.
    const same_s = 0.01 * this.scenario.dt;
    return Float64Array.from(all.filter((t_s, i) => i === 0 || t_s - all[i - 1] > same_s));
  }

  recordsAt(contender) {
    const late_s = 0.02 * this.scenario.dt;
    let record = 0;
    return Int32Array.from(this.times, t_s => {
      while (record + 1 < contender.count && contender.series.t_s[record + 1] <= t_s + late_s) ++record;
      return record;
    });
  }

  /** Returns a contender's numbers by time index: undefined between its records, null if unknown. */
  alongTimes(contender, numberOf) {
    return Array.from(this.times, (t_s, i) => {
      const record = contender.recordAt[i];
      if (contender.isOver(t_s)) return null;
      if (i > 0 && contender.recordAt[i - 1] === record) return undefined;
      const value = numberOf(record);
      return Number.isFinite(value) ? value : null;
    });
  }

  get hasRotors() {
    return this.contenders.some(contender => contender.series.rotor_momentum_W.some(value => value !== 0));
  }

  get visibleContenders() {
    return this.contenders.filter(contender => contender.visible);
  }
}

function readReport() {
  const text = byId("report-data").textContent;
  if (text.startsWith("@")) throw new Error("This page is the template of a report and has no data.");
  return new Report(JSON.parse(text));
}
