"use strict";

// The recorded body in 3D, with its axes, its angular velocity, its angular momentum and that of its rotors. There is one
// model; it takes the pose of one contender after the other, each for its own view.

class BodyModel {
  constructor(report) {
    this.report = report;
    this.radius = BodyModel.radiusOf(report.body);
    this.root = new THREE.Group();

    this.solid = new THREE.Group();  // transformed by R_WB, rotation or not
    this.solid.matrixAutoUpdate = false;
    this.ghost = new THREE.Group();  // the same in its true size
    this.ghost.matrixAutoUpdate = false;
    this.material = new THREE.MeshLambertMaterial({vertexColors: true, side: THREE.DoubleSide, polygonOffset: true,
      polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    this.edges = new THREE.LineBasicMaterial();
    this.ghostEdges = new THREE.LineBasicMaterial({depthTest: false});
    this.addParts();
    this.addAxes();
    this.addJoint();

    // Where arrows are parallel, the thin ones extend beyond the thick ones.
    this.omega = new Arrow(this.radius, "\u03c9", 0.024, 1.5);
    this.momentum = new Arrow(this.radius, "L", 0.042, 1.12);
    this.rotor = new Arrow(this.radius, "h", 0.06, 1.12);
    this.root.add(this.solid, this.ghost, this.omega.root, this.momentum.root, this.rotor.root);
    const longest = key => Math.max(...report.contenders.map(each => length(each.vector(key, 0))));
    this.longest = {omega: longest("omega_W"), momentum: longest("L_W")};
    this.applyPalette();
  }

  /** Returns the radius of a sphere around the origin that encloses the body. */
  static radiusOf(body) {
    if (!body.parts) return body.radius;
    const corner = new THREE.Vector3();
    let radius = 0;
    for (const {half_extents: [x, y, z], at, q = [1, 0, 0, 0]} of body.parts) {
      for (let i = 0; i < 8; ++i) {
        corner.set(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
        corner.applyQuaternion(new THREE.Quaternion(q[1], q[2], q[3], q[0])).add(new THREE.Vector3(...at));
        radius = Math.max(radius, corner.length());
      }
    }
    return radius;
  }

  addParts() {
    const add = (geometry, outline, place) => {
      const mesh = new THREE.Mesh(geometry, this.material);
      const lines = new THREE.LineSegments(outline, this.edges);
      const ghostLines = new THREE.LineSegments(outline, this.ghostEdges);
      for (const each of [mesh, lines, ghostLines]) place(each);
      this.solid.add(mesh, lines);
      this.ghost.add(ghostLines);
    };
    if (!this.report.body.parts) {
      add(beachBall(this.radius), greatCircles(1.003 * this.radius), () => {});
      return;
    }
    for (const part of this.report.body.parts) {
      const [x, y, z] = part.half_extents;
      const box = white(new THREE.BoxGeometry(2 * x, 2 * y, 2 * z));
      const [w, qx, qy, qz] = part.q || [1, 0, 0, 0];
      add(box, new THREE.EdgesGeometry(box), each => {
        each.position.set(...part.at);
        each.quaternion.set(qx, qy, qz, w);
      });
    }
  }

  addAxes() {
    this.axisMaterials = {};
    this.letters = {};
    for (const [name, direction] of [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]]) {
      const material = new THREE.LineBasicMaterial();
      const tip = new THREE.Vector3(...direction).multiplyScalar(1.1 * this.radius);
      this.axisMaterials[name] = material;
      this.solid.add(new THREE.Line(new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), tip]), material));
      this.letters[name] = new Letter(name, 0.27 * this.radius);
      this.letters[name].tip = tip.multiplyScalar(1.12);
      this.root.add(this.letters[name].sprite);
    }
  }

  addJoint() {
    const joint = this.report.scenario.constraint;
    if (!joint || !joint.pivot_B) return;
    this.jointMaterial = new THREE.MeshBasicMaterial({depthTest: false, transparent: true});
    const dot = new THREE.Mesh(new THREE.SphereGeometry(0.05 * this.radius, 16, 12), this.jointMaterial);
    dot.position.set(...joint.pivot_B);
    this.solid.add(dot);
  }

  /**
   * Takes the contender's pose, with letters so many times their size. Returns by what the view has to step back to hold
   * a swollen body; null: no pose.
   */
  pose(contender, record, isOver, letterScale) {
    const R = contender.series.R_WB.subarray(9 * record, 9 * record + 9);
    const position = contender.vector("position_W", record);
    if (![...R, ...position].every(Number.isFinite)) return null;
    setMatrix(this.solid, R, position);
    const longestColumn = Math.max(length(R.subarray(0, 3)), length(R.subarray(3, 6)), length(R.subarray(6, 9)));
    const isSwollen = Math.abs(contender.series.det_R[record] - 1) > 0.02;
    const stepBack = Math.max(1, longestColumn / 1.4);

    this.material.color.set(isOver ? palette.ink.diverged : palette.colour(contender.number));
    this.material.transparent = isSwollen;
    this.material.opacity = isSwollen ? 0.45 : 1;
    this.material.depthWrite = !isSwollen;
    this.ghost.visible = isSwollen;
    if (isSwollen) setMatrix(this.ghost, orthonormal(R), position);

    for (const letter of Object.values(this.letters)) {
      letter.sprite.position.copy(letter.tip).applyMatrix4(this.solid.matrix);
      letter.resize(letterScale * stepBack);
    }
    for (const [arrow, key, longest] of [[this.omega, "omega_W", this.longest.omega],
      [this.momentum, "L_W", this.longest.momentum], [this.rotor, "rotor_momentum_W", this.longest.momentum]]) {
      arrow.point(position, contender.vector(key, record), longest, stepBack, letterScale);
    }
    return stepBack;
  }

  applyPalette() {
    const ink = palette.ink;
    this.edges.color.set(ink.edge);
    this.ghostEdges.color.set(ink.text);
    if (this.jointMaterial) this.jointMaterial.color.set(ink.text);
    for (const name of ["x", "y", "z"]) {
      this.axisMaterials[name].color.set(ink[name]);
      this.letters[name].paint(ink[name]);
    }
    this.omega.paint(ink.omega);
    this.momentum.paint(ink.momentum);
    this.rotor.paint(ink.rotor);
  }
}

/** A vector that starts in the centre of mass. Its part inside the body shines through faintly. */
class Arrow {
  constructor(radius, name, thickness, reachAtStart) {
    this.radius = radius;
    this.reachAtStart = reachAtStart;
    this.root = new THREE.Group();
    this.shafts = [];
    this.heads = [];
    this.materials = [
      new THREE.MeshBasicMaterial(),
      new THREE.MeshBasicMaterial({depthFunc: THREE.GreaterDepth, depthWrite: false, transparent: true, opacity: 0.35}),
    ];
    const shaft = new THREE.CylinderGeometry(thickness, thickness, 1, 12).translate(0, 0.5, 0);
    const head = new THREE.ConeGeometry(2.6 * thickness, 0.26, 16).translate(0, -0.14, 0);
    for (const material of this.materials) {
      this.shafts.push(new THREE.Mesh(shaft, material));
      this.heads.push(new THREE.Mesh(head, material));
    }
    this.turned = new THREE.Group();
    this.turned.add(...this.shafts, ...this.heads);
    this.letter = new Letter(name, 0.3 * radius);
    this.root.add(this.turned, this.letter.sprite);
  }

  /** Scales vectors so that the longest initial one extends beyond the body. Much greater ones end with the view. */
  point(position, vector, longest, scale, letterScale) {
    const size = length(vector);
    this.root.visible = Number.isFinite(size) && size > 0 && longest > 0;
    if (!this.root.visible) return;
    const direction = new THREE.Vector3(...vector).divideScalar(size);
    const reach = this.reachAtStart * Math.min(1.2, Math.max(0.3, size / longest));
    this.root.position.set(...position);
    this.turned.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), direction);
    this.turned.scale.setScalar(scale * this.radius);
    for (const shaft of this.shafts) shaft.scale.set(1, reach - 0.2, 1);
    for (const head of this.heads) head.position.y = reach;
    this.letter.sprite.position.copy(direction).multiplyScalar((reach + 0.2) * scale * this.radius);
    this.letter.resize(letterScale * scale);
  }

  paint(colour) {
    for (const material of this.materials) material.color.set(colour);
    this.letter.paint(colour);
  }
}

/** A letter that always faces the reader. */
class Letter {
  constructor(text, size) {
    this.text = text;
    this.size = size;
    this.canvas = element("canvas", {width: 64, height: 64});
    this.texture = new THREE.CanvasTexture(this.canvas);
    this.sprite = new THREE.Sprite(new THREE.SpriteMaterial({map: this.texture, depthTest: false}));
    this.sprite.renderOrder = 1;
  }

  resize(scale) {
    this.sprite.scale.setScalar(this.size * scale);
  }

  paint(colour) {
    const context = this.canvas.getContext("2d");
    context.clearRect(0, 0, 64, 64);
    context.font = "bold 46px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = colour;
    context.fillText(this.text, 32, 32);
    this.texture.needsUpdate = true;
  }
}

function length(vector) {
  return Math.hypot(...vector);
}

/** Returns R column by column, and the position. */
function setMatrix(object, R, position) {
  object.matrix.set(
    R[0], R[3], R[6], position[0],
    R[1], R[4], R[7], position[1],
    R[2], R[5], R[8], position[2],
    0, 0, 0, 1);
  object.matrixWorldNeedsUpdate = true;
}

/** Returns a rotation close to the matrix: its columns, orthogonalized one after the other. */
function orthonormal(R) {
  const x = new THREE.Vector3(R[0], R[1], R[2]).normalize();
  const y = new THREE.Vector3(R[3], R[4], R[5]);
  y.addScaledVector(x, -y.dot(x)).normalize();
  const z = new THREE.Vector3().crossVectors(x, y);
  return [...x, ...y, ...z];
}

function white(geometry) {
  const count = geometry.attributes.position.count;
  geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(3 * count).fill(1), 3));
  return geometry;
}

/** Returns a sphere with light and dark octants, which make its rotation visible. */
function beachBall(radius) {
  const ball = new THREE.SphereGeometry(radius, 48, 32).toNonIndexed();
  const positions = ball.attributes.position;
  const colours = new Float32Array(3 * positions.count);
  for (let corner = 0; corner < positions.count; corner += 3) {
    let product = 1;
    for (const axis of ["getX", "getY", "getZ"]) {
      product *= positions[axis](corner) + positions[axis](corner + 1) + positions[axis](corner + 2);
    }
    colours.fill(product > 0 ? 1 : 0.55, 3 * corner, 3 * corner + 9);
  }
  ball.setAttribute("color", new THREE.BufferAttribute(colours, 3));
  return ball;
}

/** Returns the outlines of a sphere: its intersections with the planes of the axes. */
function greatCircles(radius) {
  const points = [];
  for (let plane = 0; plane < 3; ++plane) {
    for (let i = 0; i < 64; ++i) {
      for (const angle of [i, i + 1].map(corner => corner * Math.PI / 32)) {
        const point = [0, 0, 0];
        point[plane] = radius * Math.cos(angle);
        point[(plane + 1) % 3] = radius * Math.sin(angle);
        points.push(new THREE.Vector3(...point));
      }
    }
  }
  return new THREE.BufferGeometry().setFromPoints(points);
}
