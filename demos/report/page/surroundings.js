"use strict";

// What stands around the body: light, and the ground if the scenario has one.

class Surroundings {
  constructor(report, radius) {
    this.root = new THREE.Group();
    this.hemisphere = new THREE.HemisphereLight(0xffffff, 0x9098a0, 0.75);
    this.lamp = new THREE.DirectionalLight(0xffffff, 0.55);
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
    const size = 60 * this.cell;
    this.ground = new THREE.Group();
    this.ground.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.up);
    this.plate = new THREE.MeshBasicMaterial({transparent: true, opacity: 0.25, side: THREE.DoubleSide, depthWrite: false});
    const plate = new THREE.Mesh(new THREE.PlaneGeometry(size, size), this.plate);
    this.lines = new THREE.LineBasicMaterial({transparent: true, opacity: 0.6});
    const points = [];
    for (let i = -30; i <= 30; ++i) {
      const at = i * this.cell;
      points.push(new THREE.Vector3(at, -size / 2, 0), new THREE.Vector3(at, size / 2, 0));
      points.push(new THREE.Vector3(-size / 2, at, 0), new THREE.Vector3(size / 2, at, 0));
    }
    this.ground.add(plate, new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points), this.lines));
    this.root.add(this.ground);
  }

  /** The ground has no end: its grid goes along with what is looked at, by whole cells. */
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
