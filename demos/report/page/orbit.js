"use strict";

// The camera, the same in all views. Events: "change".

const kStartView = {azimuth: 0.7, elevation: 0.42, zoom: 1};

class Orbit extends EventTarget {
  constructor(up) {
    super();
    this.up = up;
    // Any two perpendicular directions along the ground.
    this.aside = Math.abs(up.x) < 0.9 ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 1, 0);
    this.aside.addScaledVector(up, -up.dot(this.aside)).normalize();
    this.ahead = new THREE.Vector3().crossVectors(up, this.aside);
    this.pointers = new Map();
    this.reset();
  }

  reset() {
    Object.assign(this, kStartView);
    this.changed();
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(1.55, Math.max(-1.55, this.elevation + elevation));
    this.changed();
  }

  zoomBy(factor) {
    this.zoom = Math.min(20, Math.max(0.05, this.zoom * factor));
    this.changed();
  }

  changed() {
    this.dispatchEvent(new Event("change"));
  }

  place(camera, target, distance_m) {
    const level = Math.cos(this.elevation);
    camera.position.copy(target)
      .addScaledVector(this.aside, distance_m * level * Math.cos(this.azimuth))
      .addScaledVector(this.ahead, distance_m * level * Math.sin(this.azimuth))
      .addScaledVector(this.up, distance_m * Math.sin(this.elevation));
    camera.up.copy(this.up);
    camera.near = distance_m / 50;
    camera.far = distance_m * 50;
    camera.lookAt(target);
  }

  /** One pointer turns, two zoom by their distance. The wheel without Ctrl scrolls the page. */
  listenTo(surface) {
    surface.addEventListener("pointerdown", event => {
      if (event.button !== 0) return;
      this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
      surface.setPointerCapture(event.pointerId);
    });
    surface.addEventListener("pointermove", event => this.dragged(event));
    for (const end of ["pointerup", "pointercancel"]) {
      surface.addEventListener(end, event => this.pointers.delete(event.pointerId));
    }
    surface.addEventListener("wheel", event => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-0.002 * event.deltaY));
    }, {passive: false});
  }

  dragged(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const spread = () => {
      const [[ax, ay], [bx, by]] = [...this.pointers.values()];
      return Math.hypot(ax - bx, ay - by);
    };
    const spreadBefore = this.pointers.size === 2 ? spread() : 0;
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.pointers.size === 1) {
      this.turn(-0.01 * (event.clientX - before[0]), 0.01 * (event.clientY - before[1]));
    } else if (spreadBefore > 0) {
      this.zoomBy(spread() / spreadBefore);
    }
  }
}
