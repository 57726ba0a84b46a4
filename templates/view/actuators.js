// What pulls and pushes: tendons along links, which bend with them, and cylinders across joints.

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
