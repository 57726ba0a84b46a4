// What pulls and pushes: tendons along links, which bend with them, cylinders across joints, springs and ropes between frames.

const SIDES = 8;
/** How long the barrel of a cylinder is, over the distance of its eyes at zero coordinates. */
const BARREL = 0.55;

/** A tendon as a thin tube: `place` holds s and the row of the table between rows, `position` the offset. */
function thread(link, tendon, radius) {
  const [position, normal, place, index] = [[], [], [], []];
  const row = (s) => {
    const high = Math.max(1, link.places.findIndex((x) => x >= s - 1e-12));
    return high - 1 + (s - link.places[high - 1]) / (link.places[high] - link.places[high - 1]);
  };
  tendon.places.forEach((s, k) => {
    for (let j = 0; j <= SIDES; j++) {
      const out = [0, Math.cos((2 * Math.PI * j) / SIDES), Math.sin((2 * Math.PI * j) / SIDES)];
      position.push(...plus([0, ...tendon.offsets[k]], times(radius, out)));
      normal.push(...out);
      place.push(s, Math.min(row(s), link.rows - 1));
    }
  });
  for (let k = 0; k + 1 < tendon.places.length; k++)
    for (let j = 0; j < SIDES; j++) {
      const a = k * (SIDES + 1) + j;
      const b = a + SIDES + 1;
      index.push(a, a + 1, b, b, a + 1, b + 1);
    }
  const out = new THREE.BufferGeometry();
  out.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
  out.setAttribute("normal", new THREE.Float32BufferAttribute(normal, 3));
  out.setAttribute("place", new THREE.Float32BufferAttribute(place, 2));
  out.setIndex(index);
  return out;
}

/** Meshes of the tendons of a link, which follow its modes. */
function threads(link, uniforms, radius, paint) {
  return link.tendons.map((tendon) => {
    const mesh = new THREE.Mesh(thread(link, tendon, radius), bending(paint("--thread"), uniforms, true, false, true));
    [mesh.frustumCulled, mesh.bends, mesh.between] = [false, uniforms, true];
    return mesh;
  });
}

/** A cylinder between its eyes: a barrel at the carrier, and a rod as far as the link. */
class Cylinder {
  constructor(found, thick, paint) {
    const bar = (radius, color) => new THREE.Mesh(new THREE.CylinderGeometry(radius, radius, 1, 20).translate(0, 0.5, 0), paint(color));
    [this.found, this.group] = [found, new THREE.Group()];
    [this.barrel, this.rod] = [bar(thick, "--dark-metal"), bar(0.55 * thick, "--metal")];
    this.barrel.scale.y = BARREL * norm(plus(found.link, times(-1, found.carrier)));
    this.group.add(this.barrel, this.rod);
  }

  /** `stages`: the frames of a joint before each of its axes, and behind the last one. */
  follow(stages) {
    const eye = (stage, at) => plus(stage.at, turned(stage.turn, at));
    this.eyes = [eye(stages[this.found.axis], this.found.carrier), eye(stages[this.found.axis + 1], this.found.link)];
    const way = plus(this.eyes[1], times(-1, this.eyes[0]));
    const long = Math.max(norm(way), 1e-9);
    this.group.position.set(...this.eyes[0]);
    this.group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), vector(times(1 / long, way)));
    this.rod.scale.y = long;
  }
}

/** Points of the line of a force, by how it is drawn; turns of a coil, its straight ends, and where it widens. */
const POINTS = { spring: 112, rope: 25, line: 2 };
const [TURNS, LEAD, RAMP] = [7, 0.12, 0.05];

/** The points between two ends, as in screwgen/viewer/lines.py; `down`: a unit vector to where things fall, `spare`: how
 * much longer a rope is than its way, whatever the magnification of the modes. */
function linePath(line, near, far, down, spare) {
  const way = plus(far, times(-1, near));
  const at = (s) => plus(near, times(s, way));
  const share = (k) => k / (POINTS[line.drawn] - 1);
  const every = (make) => Array.from({ length: POINTS[line.drawn] }, (_, k) => make(share(k)));
  if (line.drawn === "spring") {
    const smooth = (x) => { const y = Math.min(Math.max(x, 0), 1); return y * y * (3 - 2 * y); };
    const turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), vector(times(1 / Math.max(norm(way), 1e-9), way)));
    const [y, z] = [[1, 0, 0], [0, 1, 0]].map((e) => vector(e).applyQuaternion(turn).toArray());
    return every((s) => {
      const wide = line.wide * smooth((s - LEAD) / RAMP) * smooth((1 - LEAD - s) / RAMP);
      const angle = (2 * Math.PI * TURNS * (s - LEAD)) / (1 - 2 * LEAD);
      return plus(at(s), times(wide, plus(times(Math.cos(angle), y), times(Math.sin(angle), z))));
    });
  }
  if (line.drawn !== "rope" || spare <= 0) return every(at);
  const hung = (sag) => every((s) => plus(at(s), times(4 * s * (1 - s) * sag, down)));
  const long = (points) => points.slice(1).reduce((sum, p, k) => sum + norm(plus(p, times(-1, points[k]))), 0);
  const length = norm(way) + spare;
  let [low, high] = [0, length];
  for (let k = 0; k < 40; k++) {
    const middle = (low + high) / 2;
    if (long(hung(middle)) < length) low = middle;
    else high = middle;
  }
  return hung(low);
}

/** A wire of so many points, which are given anew at each time. */
class Wire {
  constructor(count, radius, material) {
    const [geometry, index] = [new THREE.BufferGeometry(), []];
    for (let k = 0; k + 1 < count; k++)
      for (let j = 0; j < SIDES; j++) {
        const [a, b] = [k * SIDES + j, k * SIDES + ((j + 1) % SIDES)];
        index.push(a, b, a + SIDES, a + SIDES, b, b + SIDES);
      }
    for (const name of ["position", "normal"])
      geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * count * SIDES), 3));
    geometry.setIndex(index);
    [this.radius, this.mesh] = [radius, new THREE.Mesh(geometry, material)];
    this.mesh.frustumCulled = false;
  }

  follow(points) {
    const { position, normal } = this.mesh.geometry.attributes;
    let out = [0.31, 0.53, 0.79]; // across the wire, turned as little as it can from one point to the next
    points.forEach((at, k) => {
      const along = plus(points[Math.min(k + 1, points.length - 1)], times(-1, points[Math.max(k - 1, 0)]));
      const x = times(1 / Math.max(norm(along), 1e-12), along);
      out = plus(out, times(-dot(out, x), x));
      out = times(1 / Math.max(norm(out), 1e-12), out);
      const other = cross(x, out);
      for (let j = 0; j < SIDES; j++) {
        const angle = (2 * Math.PI * j) / SIDES;
        const way = plus(times(Math.cos(angle), out), times(Math.sin(angle), other));
        normal.setXYZ(k * SIDES + j, ...way);
        position.setXYZ(k * SIDES + j, ...plus(at, times(this.radius, way)));
      }
    });
    position.needsUpdate = normal.needsUpdate = true;
  }
}

/** The line of a force between frames: a coil, a rope that hangs where it is slack, or straight; rings at points of the world. */
const RING = 25;
class Line {
  constructor(line, gravity, paint) {
    [this.line, this.group] = [line, new THREE.Group()];
    this.down = norm(gravity) > 1e-9 ? times(1 / norm(gravity), gravity) : [0, 0, -1];
    this.wire = new Wire(POINTS[line.drawn], line.thick, paint(line.drawn === "spring" ? "--metal" : "--thread"));
    this.rings = line.ends.map((end) => end.link < 0 && new Wire(RING, 1.4 * line.thick, paint("--dark-metal")));
    this.group.add(...[this.wire, ...this.rings].filter(Boolean).map((wire) => wire.mesh));
  }

  /** `found`: the poses of all links, `real`: those without magnification. */
  follow(found, real) {
    const between = (poses) => this.line.ends.map(({ link, at }) => (link < 0 ? at : poses[link].tip.at));
    const [ends, [near, far]] = [between(found), between(real)];
    this.points = linePath(this.line, ...ends, this.down, this.line.rest - norm(plus(far, times(-1, near))));
    this.wire.follow(this.points);
    const way = plus(ends[1], times(-1, ends[0]));
    const x = times(1 / Math.max(norm(way), 1e-12), way);
    const other = cross(x, Math.abs(dot(x, this.down)) < 0.99 ? this.down : [1, 0, 0]);
    const y = times(1 / Math.max(norm(other), 1e-12), cross(other, x));
    const around = Array.from({ length: RING }, (_, k) => (2 * Math.PI * k) / (RING - 1));
    const ring = (at) => around.map((a) => plus(at, times(5 * this.line.thick, plus(times(Math.cos(a), x), times(Math.sin(a), y)))));
    this.rings.forEach((wire, k) => wire && wire.follow(ring(ends[k])));
  }
}
