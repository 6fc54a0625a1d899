"use strict";

// The surroundings of the body: light, and the ground if the scenario has one.

class Surroundings {
  constructor(report, radius) {
    this.root = new THREE.Group();
    this.hemisphere = new THREE.HemisphereLight(0xffffff, 0xa0a0a0, 0.8);
    this.lamp = new THREE.DirectionalLight(0xffffff, 0.35);
    this.root.add(this.hemisphere, this.lamp, this.lamp.target);
    this.up = new THREE.Vector3(0, 0, 1);
    if (report.ground) this.addGround(report.ground, radius);
    this.hemisphere.position.copy(this.up);
    this.applyPalette();
  }

  addGround(ground, radius) {
    this.up.set(...ground.normal).normalize();
    this.height = ground.height;
    this.cell = radius;
    const cells = 40;
    const size = cells * this.cell;
    this.ground = new THREE.Group();
    this.ground.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.up);
    this.plate = new THREE.MeshBasicMaterial({
      transparent: true, opacity: 0.25, side: THREE.DoubleSide, depthWrite: false});
    const plate = new THREE.Mesh(new THREE.PlaneGeometry(size, size), this.plate);
    this.lines = new THREE.LineBasicMaterial({transparent: true, opacity: 0.6});
    this.ground.add(plate, new THREE.LineSegments(this.grid(cells), this.lines));
    this.root.add(this.ground);
  }

  /** Draws the grid cell by cell: some renderers do not draw a line that begins far behind the camera. */
  grid(cells) {
    const points = [];
    const add = (x, y) => points.push(new THREE.Vector3((x - cells / 2) * this.cell, (y - cells / 2) * this.cell, 0));
    for (let line = 0; line <= cells; ++line) {
      for (let i = 0; i < cells; ++i) {
        add(line, i);
        add(line, i + 1);
        add(i, line);
        add(i + 1, line);
      }
    }
    return new THREE.BufferGeometry().setFromPoints(points);
  }

  /** The ground is unbounded: its grid follows the camera's target, by whole cells. */
  lookedAt(target, camera) {
    this.lamp.position.copy(camera.position);
    this.lamp.target.position.copy(target);
    if (!this.ground) return;
    const inverse = this.ground.quaternion.clone().invert();
    const local = target.clone().applyQuaternion(inverse);
    local.set(Math.round(local.x / this.cell) * this.cell, Math.round(local.y / this.cell) * this.cell, this.height);
    this.ground.position.copy(local.applyQuaternion(this.ground.quaternion));
  }

  applyPalette() {
    if (!this.ground) return;
    this.plate.color.set(palette.ink.ground);
    this.lines.color.set(palette.ink.ground);
  }
}
