"use strict";

// The views of the bodies side by side. They are parts of one canvas, which lies behind them.

const kFieldOfView_deg = 32;

function hasWebGL() {
  const canvas = document.createElement("canvas");
  return Boolean(canvas.getContext("webgl2") || canvas.getContext("webgl"));
}

class Stage {
  constructor(report, playback) {
    this.report = report;
    this.playback = playback;
    this.canvas = byId("stage-canvas");
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true});
    this.renderer.setScissorTest(true);
    this.renderer.autoClear = false;
    this.camera = new THREE.PerspectiveCamera(kFieldOfView_deg);
    this.model = new BodyModel(report);
    this.surroundings = new Surroundings(report, this.model.radius);
    this.scene = new THREE.Scene();
    this.scene.add(this.surroundings.root, this.model.root);
    this.views = report.contenders.map(contender => new View(contender));
    byId("viewports").append(...this.views.map(view => view.figure));
    byId("viewports").dataset.few = report.contenders.length <= 2;

    this.frameMotion();
    this.orbit = new Orbit(this.surroundings.up);
    this.orbit.listenTo(byId("viewports"));
    this.drawSoon = oncePerFrame(() => this.draw());
    this.orbit.addEventListener("change", this.drawSoon);
    playback.addEventListener("time", this.drawSoon);
    byId("follow").addEventListener("change", this.drawSoon);
    byId("zoom-in").addEventListener("click", () => this.orbit.zoomBy(1.25));
    byId("zoom-out").addEventListener("click", () => this.orbit.zoomBy(0.8));
    byId("reset-view").addEventListener("click", () => this.orbit.reset());
    this.canvas.addEventListener("webglcontextlost", event => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", this.drawSoon);
    new ResizeObserver(() => this.resize()).observe(byId("viewports"));
    this.resize();
  }

  /** The camera stays fixed if the motion stays within a few sizes of the body, and follows the body otherwise. */
  frameMotion() {
    const box = new THREE.Box3();
    for (const {series} of this.report.contenders) {
      for (let i = 0; i + 2 < series.position_W.length; i += 3) {
        const point = new THREE.Vector3(...series.position_W.subarray(i, i + 3));
        if (point.toArray().every(Number.isFinite)) box.expandByPoint(point);
      }
    }
    this.centre = box.getCenter(new THREE.Vector3());
    const reach = 0.5 * box.getSize(new THREE.Vector3()).length();
    this.isFar = reach > 8 * this.model.radius;
    byId("follow").checked = this.isFar;
    byId("follow-label").hidden = reach < 0.01 * this.model.radius;
    // Arrows and letters extend beyond the body.
    const followed = 1.8 * this.model.radius;
    this.reach = {followed, fixed: followed + Math.min(reach, 30 * this.model.radius)};
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = byId("viewports");
    if (width === 0 || height === 0) return;
    // A canvas that is too large for the graphics memory stays black.
    const ratio = Math.min(window.devicePixelRatio || 1, 2, 4096 / width, 4096 / height);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.draw();
  }

  showVisible() {
    for (const view of this.views) view.figure.hidden = !view.contender.visible;
    this.resize();
  }

  applyPalette() {
    this.model.applyPalette();
    this.surroundings.applyPalette();
    this.draw();
  }

  draw() {
    const all = byId("viewports").getBoundingClientRect();
    this.renderer.setScissor(0, 0, all.width, all.height);
    this.renderer.clear();
    for (const view of this.views) {
      if (!view.contender.visible) continue;
      const record = view.contender.recordAt[this.playback.index];
      const isOver = view.contender.isOver(this.playback.t_s);
      view.show(record, isOver);
      const place = view.window.getBoundingClientRect();
      const bottom = all.bottom - place.bottom;
      this.renderer.setViewport(place.left - all.left, bottom, place.width, place.height);
      this.renderer.setScissor(place.left - all.left, bottom, place.width, place.height);
      this.drawView(view.contender, record, isOver, place.width / place.height);
    }
  }

  drawView(contender, record, isOver, aspect) {
    const isFollowed = byId("follow").checked;
    const reachAtOnce = isFollowed ? this.reach.followed : this.reach.fixed;
    const stepBack = this.model.pose(contender, record, isOver, Math.min(2, reachAtOnce / this.reach.followed));
    if (stepBack === null) return;
    const target = isFollowed ? new THREE.Vector3(...contender.vector("position_W", record)) : this.centre;
    const reach = stepBack * reachAtOnce / this.orbit.zoom;
    const halfAngle = Math.atan(Math.tan(kFieldOfView_deg * Math.PI / 360) * Math.min(1, aspect));
    this.orbit.place(this.camera, target, reach / Math.sin(halfAngle));
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    this.surroundings.lookedAt(target, this.camera);
    this.renderer.render(this.scene, this.camera);
  }
}

/** The frame of one contender's view: its name and its present state. */
class View {
  constructor(contender) {
    this.contender = contender;
    const name = element("span", {class: "name", title: contender.name}, contender.name);
    this.window = element("div", {class: "window"});
    this.fast = element("span", {class: "badge fast", title: "Here Bullet turns a body less than the velocity it reports"},
      "fast: |\u03c9| dt > \u03c0/4");
    this.swollen = element("span", {class: "badge"});
    this.error = element("span", {class: "readout"});
    this.over = element("span", {class: "badge over"});
    this.figure = element("figure", {class: "viewport"},
      element("figcaption", {}, palette.swatch(contender.number), name),
      this.window, element("div", {class: "badges"}, this.over, this.fast, this.swollen), this.error);
  }

  show(record, isOver) {
    const {series, divergedAt_s} = this.contender;
    const det = series.det_R[record];
    this.fast.hidden = isOver || !(series.past_cut[record] > 0);
    this.swollen.hidden = !(Math.abs(det - 1) > 0.02);
    setText(this.swollen, `${det > 1 ? "swollen" : "shrunk"}: det R = ${shortNumber(det, 3)}`);
    this.figure.classList.toggle("is-over", isOver);
    this.over.hidden = !isOver;
    setText(this.over, isOver ? `diverged at t = ${shortNumber(divergedAt_s, 6)} s` : "");
    const error = series.energy_error[record];
    setText(this.error, Number.isFinite(error) ? `E/E\u2080\u22121 = ${signedNumber(error, 2)}` : "");
  }
}
