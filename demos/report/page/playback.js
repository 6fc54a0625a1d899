"use strict";

// The time shown by the whole page. Events: "time" (the index changed), "state" (playing or the speed changed).

class Playback extends EventTarget {
  constructor(times, duration_s) {
    super();
    this.times = times;
    this.index = 0;
    this.playing = false;
    this.clock_s = times[0];  // position of the playback, between two records
    this.speeds = Playback.speedsFor(duration_s);
    this.speed = this.speeds[Math.floor(this.speeds.length / 2)];
    this.frame = timestamp => this.advance(timestamp);
  }

  /** Returns a series of speeds around one that plays the run in a reasonable time: real time if possible. */
  static speedsFor(duration_s) {
    const ladder = [1, 2, 5];
    const middle = duration_s >= 2 && duration_s <= 120 ? 0 : Math.round(3 * Math.log10(duration_s / 20));
    return Array.from({length: 13}, (_, i) => {
      const place = middle + i - 6;
      const decade = Math.floor(place / 3);
      return Number((ladder[place - 3 * decade] * 10 ** decade).toPrecision(3));
    });
  }

  get t_s() {
    return this.times[this.index];
  }

  get last() {
    return this.times.length - 1;
  }

  /** Moves to the time that the reader chose. */
  seek(index) {
    this.moveTo(Math.min(this.last, Math.max(0, Math.round(index))));
    this.clock_s = this.t_s;
  }

  seekTime(t_s) {
    const index = this.indexAt(t_s);
    const nearer = index < this.last && this.times[index + 1] - t_s < t_s - this.times[index];
    this.seek(nearer ? index + 1 : index);
  }

  toggle() {
    if (this.playing) {
      this.stop();
      return;
    }
    if (this.last === 0) return;
    if (this.index === this.last) this.seek(0);
    this.playing = true;
    this.before = null;
    requestAnimationFrame(this.frame);
    this.dispatchEvent(new Event("state"));
  }

  stop() {
    this.playing = false;
    this.dispatchEvent(new Event("state"));
  }

  /** Changes the speed by one of the series. */
  changeSpeed(places) {
    const place = this.speeds.indexOf(this.speed) + places;
    this.setSpeed(this.speeds[Math.min(this.speeds.length - 1, Math.max(0, place))]);
  }

  setSpeed(speed) {
    this.speed = speed;
    this.dispatchEvent(new Event("state"));
  }

  moveTo(index) {
    if (index === this.index) return;
    this.index = index;
    this.dispatchEvent(new Event("time"));
  }

  /** Returns the last index up to this time. */
  indexAt(t_s) {
    let low = 0;
    let high = this.last;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= t_s) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  advance(timestamp) {
    if (!this.playing) return;
    if (this.before !== null) {
      this.clock_s += 0.001 * (timestamp - this.before) * this.speed;
      this.moveTo(this.indexAt(this.clock_s));
    }
    this.before = timestamp;
    if (this.index === this.last) this.stop();
    else requestAnimationFrame(this.frame);
  }
}
