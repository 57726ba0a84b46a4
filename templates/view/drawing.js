// The picture: a robot's parts in three.js, and the space that they stand in.

const AROUND = 24;
const vector = (v) => new THREE.Vector3(...v);

/** What the modes do to a vertex: the section's displacement and turn are summed up from the columns of its link. */
const BENT = (between) => `
uniform sampler2D shapes; uniform sampler2D modal; uniform vec3 base; uniform vec3 reach; uniform int count;
attribute vec2 place; varying float along;
vec3 centre; mat3 turn;
void bend() {
  vec3 u = vec3(0.0), v = vec3(0.0); ${between ? "int row = int(place.y); float share = place.y - float(row); int next = share > 0.0 ? row + 1 : row;" : "int row = int(place.y + 0.5);"}
  for (int k = 0; k < count; k++) {
    float eta = texelFetch(modal, ivec2(k, 0), 0).r;
    ${["u", "v"].map((x, n) => {
    const at = (row) => `texelFetch(shapes, ivec2(2 * k + ${n}, ${row}), 0).xyz`;
    return `${x} += eta * ${between ? `mix(${at("row")}, ${at("next")}, share)` : at("row")};`;
  }).join(" ")}
  }
  centre = base + place.x * reach + u; along = place.x;
  float a = dot(v, v), c1 = 1.0, c2 = 0.5;
  if (a > 1e-8) { float angle = sqrt(a); c1 = sin(angle) / angle; c2 = (1.0 - cos(angle)) / a; }
  mat3 h = mat3(0.0, v.z, -v.y, -v.z, 0.0, v.x, v.y, -v.x, 0.0);
  turn = mat3(1.0) + c1 * h + c2 * h * h;
}`;

/** Let a material's vertices follow the modes of a link, also `between` the rows of its table; if it marks the end of the
 * tube, nothing else of it is drawn. */
function bending(material, uniforms, lit, marks = false, between = false) {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader.replace("#include <common>", `#include <common>${BENT(between)}`);
    if (lit) shader.vertexShader = shader.vertexShader.replace("#include <beginnormal_vertex>", "bend(); vec3 objectNormal = turn * normal;");
    shader.vertexShader = shader.vertexShader.replace("#include <begin_vertex>", `${lit ? "" : "bend();"} vec3 transformed = centre + turn * position;`);
    if (marks) {
      shader.fragmentShader = shader.fragmentShader.replace("#include <common>", "#include <common>\nvarying float along;");
      shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>", "if (along < 0.95) discard;");
    }
  };
  material.customProgramCacheKey = () => `bent ${lit} ${marks} ${between}`;
  return material;
}

/** A tube of unit sections: `place` holds s and the row of the table, `position` the offset from the centreline. */
function tube(link, radius) {
  const along = new THREE.Vector3(...link.reach).normalize();
  const frame = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(1, 0, 0), along);
  const [position, normal, place, index] = [[], [], [], []];
  const ring = (row, offset, facing) => {
    for (let j = 0; j <= AROUND; j++) {
      const angle = (2 * Math.PI * j) / AROUND;
      const out = new THREE.Vector3(0, Math.cos(angle), Math.sin(angle)).applyQuaternion(frame);
      position.push(...out.clone().multiplyScalar(offset).toArray());
      normal.push(...(facing ? along.clone().multiplyScalar(facing) : out).toArray());
      place.push(link.places[row], row);
    }
  };
  const last = link.rows - 1;
  ring(0, 0, -1);
  ring(0, radius, -1);
  for (let row = 0; row <= last; row++) ring(row, radius, 0);
  ring(last, radius, 1);
  ring(last, 0, 1);
  const rings = place.length / 2 / (AROUND + 1);
  for (let i = 0; i + 1 < rings; i++)
    for (let j = 0; j < AROUND; j++) {
      const a = i * (AROUND + 1) + j;
      const b = a + AROUND + 1;
      index.push(a, a + 1, b, b, a + 1, b + 1);
    }
  const out = new THREE.BufferGeometry();
  out.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
  out.setAttribute("normal", new THREE.Float32BufferAttribute(normal, 3));
  out.setAttribute("place", new THREE.Float32BufferAttribute(place, 2));
  out.setIndex(index);
  return out;
}

/** The surface of a mesh of a URDF; on a link that bends as offsets from its sections, as a tube. */
function surface(mesh, link) {
  const [x, y, z, rows] = mesh.columns;
  const raw = bytes(mesh.index).buffer;
  const out = new THREE.BufferGeometry();
  const position = new Float32Array(3 * x.length);
  const set = (k, p) => position.set(p, 3 * k);
  const place = rows && Array.from(rows, (row) => {
    const low = Math.min(Math.floor(row), link.rows - 2);
    return link.places[low] + (row - low) * (link.places[low + 1] - link.places[low]);
  });
  x.forEach((_, k) => set(k, place ? plus(plus(link.base, times(place[k], link.reach)), [x[k], y[k], z[k]]) : [x[k], y[k], z[k]]));
  out.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
  out.setIndex(new THREE.BufferAttribute(mesh.wide ? new Uint32Array(raw) : new Uint16Array(raw), 1));
  out.computeVertexNormals();
  if (!place) return out;
  x.forEach((_, k) => set(k, [x[k], y[k], z[k]]));
  out.getAttribute("position").array.set(position);
  out.setAttribute("place", new THREE.Float32BufferAttribute(place.flatMap((s, k) => [s, rows[k]]), 2));
  return out;
}

function table(width, height, data) {
  const out = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.FloatType);
  out.needsUpdate = true;
  return out;
}

/** The columns of a link into the data of their texture; an exact rod has one, its sections. */
function put(shapes, link, columns) {
  const width = Math.max(link.count, 1);
  for (let k = 0; k < link.count; k++)
    for (let row = 0; row < link.rows; row++)
      for (let c = 0; c < 6; c++)
        shapes[((row * width + k) * 2 + (c > 2 ? 1 : 0)) * 4 + (c % 3)] = columns[(k * link.rows + row) * 6 + c];
}

/** The uniforms of a link: its columns as a texture, and its modal coordinates, which change. */
function uniformsOf(link) {
  const width = Math.max(link.count, 1);
  const shapes = new Float32Array(2 * width * link.rows * 4);
  if (!link.fine) put(shapes, link, link.shape);
  return {
    shapes: { value: table(2 * width, link.rows, shapes) }, modal: { value: table(width, 1, new Float32Array(4 * width)) },
    base: { value: vector(link.base) }, reach: { value: vector(link.reach) }, count: { value: link.count },
  };
}

/** An arrow from the origin along +y, with a second head if it stands for a moment. */
class Arrow {
  constructor(material, width, heads) {
    this.group = new THREE.Group();
    this.head = 5 * width;
    this.shaft = new THREE.Mesh(new THREE.CylinderGeometry(width, width, 1, 12), material);
    this.heads = Array.from({ length: heads }, () => new THREE.Mesh(new THREE.ConeGeometry(2.6 * width, this.head, 16), material));
    this.group.add(this.shaft, ...this.heads);
  }

  point(at, v) {
    const length = norm(v);
    this.group.visible = length > 0.3 * this.head;
    if (!this.group.visible) return;
    this.group.position.set(...at);
    this.group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), vector(v).divideScalar(length));
    const head = Math.min(this.head, length / (this.heads.length + 0.2));
    const shaft = length - head * this.heads.length;
    this.shaft.scale.y = shaft;
    this.shaft.position.y = shaft / 2;
    this.heads.forEach((cone, k) => { cone.position.y = length - head * (k + 0.5); cone.scale.setScalar(head / this.head); });
  }
}

/** A robot that is drawn; a ghost is translucent. `palette` gives colours by name. */
class Robot {
  constructor(scene, palette, ghost) {
    [this.scene, this.palette, this.ghost, this.group, this.paints] = [scene, palette, ghost, new THREE.Group(), []];
    this.thin = Math.max(0.006 * scene.size, Math.min(...scene.links.map((x) => x.radius || Infinity)));
    this.parts = scene.links.map((link) => this.part(link));
    this.feet = scene.links.filter((x) => x.parent < 0 && !x.loose).map((link) => this.foot(link));
    this.lines = scene.lines.map((line) => new Line(line, scene.gravity, (color) => this.paint(color)));
    for (const line of this.lines) this.group.add(line.group);
    this.touching = scene.surfaces.map((found) => this.surface(found));
    [this.plain, this.worn] = [new Set(), new Set()]; // what meshes stand for, and the parts that have some
    this.skins = (scene.meshes || []).map((mesh) => this.skin(mesh));
    this.repaint();
  }

  /** A mesh of a URDF, in place of the tube, the joints and the bodies of its link. */
  skin(mesh) {
    const part = this.parts[mesh.link];
    const paint = this.paint(mesh.color, { shininess: 25 });
    const bends = mesh.table.data.length > 3;
    const out = new THREE.Mesh(surface(mesh, part && part.link), bends ? bending(paint, part.uniforms, true, false, true) : paint);
    if (bends) [out.bends, out.between] = [part.uniforms, true];
    out.frustumCulled = !bends;
    const owner = part && part.link.owner;
    const over = this.parts.filter((x) => part && x.link.owner === owner);
    for (const x of over) this.worn.add(x);
    for (const x of part ? over.flatMap((y) => y.solids) : this.feet) this.plain.add(x);
    (part ? part.frame : this.group).add(out);
    return out;
  }

  /** Show meshes, or what they stand for. */
  wear(on) {
    for (const mesh of this.skins) mesh.visible = on;
    for (const mesh of this.plain) mesh.visible = !on;
    for (const part of this.worn) part.covered = on;
  }

  paint(color, options = {}) {
    const ghostly = this.ghost ? { transparent: true, opacity: 0.34, depthWrite: false } : {};
    const material = new THREE.MeshPhongMaterial({ shininess: 40, specular: 0x2c3036, ...ghostly, ...options });
    this.paints.push([material, color]);
    return material;
  }

  part(link) {
    const frame = new THREE.Group();
    const tip = new THREE.Group();
    this.group.add(frame, tip);
    const out = { link, frame, tip, uniforms: uniformsOf(link), bent: [], solids: [] };
    if (link.radius && norm(link.reach) > 1e-9) {
      const geometry = tube(link, link.radius);
      const skin = new THREE.Mesh(geometry, bending(this.paint(`--c${link.owner % 8}`), out.uniforms, true));
      skin.frustumCulled = false;
      frame.add(skin);
      skin.bends = out.uniforms;
      out.bent.push(skin);
    }
    if (!link.welded && !link.loose) this.joint(link, frame);
    if (!link.loose && link.screws.some((s) => s.travel)) {
      out.rail = new THREE.Mesh(new THREE.CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0), this.paint("--dark-metal"));
      this.group.add(out.rail);
    }
    for (const body of link.bodies) (body.tip ? tip : frame).add(this.body(body, body.tip ? [0, 0, 0] : link.base));
    out.solids = [...frame.children, ...tip.children];
    out.covered = false;
    const paint = (color) => this.paint(color);
    for (const mesh of threads(link, out.uniforms, 0.25 * this.thin, paint)) frame.add(mesh);
    const seam = { places: Array.from(link.places), offsets: link.places.map(() => [0, 1.01 * link.radius]) };
    const seams = modes && link.twists && link.radius ? threads({ ...link, tendons: [seam] }, out.uniforms, 0.12 * link.radius, () => this.paint("--dark-metal")) : [];
    for (const mesh of seams) frame.add(mesh);
    out.cylinders = link.cylinders.map((found) => new Cylinder(found, 1.3 * this.thin, paint));
    for (const cylinder of out.cylinders) this.group.add(cylinder.group);
    return out;
  }

  /** A box or a ball about its place, which is stated from a point. */
  body(found, from, options) {
    const geometry = found.box ? new THREE.BoxGeometry(...found.box.map((x) => Math.max(x, 1e-3 * this.scene.size))) : new THREE.SphereGeometry(found.ball, 32, 20);
    const mesh = new THREE.Mesh(geometry, this.paint("--metal", options));
    mesh.position.set(...plus(found.at, from));
    if (found.turn) mesh.quaternion.set(...found.turn);
    return mesh;
  }

  /** What touches, at the tip of a link or on the world; what is clear hides nothing. */
  surface(found) {
    const mesh = this.body(found, [0, 0, 0], found.clear ? { transparent: true, opacity: 0.22, depthWrite: false } : {});
    (found.link < 0 ? this.group : this.parts[found.link].tip).add(mesh);
    return mesh;
  }

  joint(link, frame) {
    const radius = 1.55 * Math.max(link.radius, this.thin);
    const first = link.screws[0];
    const slide = first && !first.turn;
    const shape = slide ? new THREE.BoxGeometry(2.2 * radius, 3 * radius, 2.2 * radius) : new THREE.CylinderGeometry(radius, radius, 3.2 * radius, 28);
    link.screws.slice(slide ? 0 : -1).slice(0, 1).forEach((screw) => {
      const mesh = new THREE.Mesh(shape, this.paint("--dark-metal"));
      mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), vector(screw.axis).normalize());
      mesh.position.set(...link.base);
      frame.add(mesh);
    });
  }

  foot(link) {
    const up = vector(this.scene.gravity).multiplyScalar(link.hangs ? 1 : -1); // a robot that hangs has its foot above it
    const way = up.length() > 1e-9 ? up.normalize() : new THREE.Vector3(0, 0, 1);
    const radius = 0.035 * this.scene.size;
    const mesh = new THREE.Mesh(new THREE.CylinderGeometry(0.8 * radius, 1.25 * radius, 0.9 * radius, 36), this.paint("--dark-metal"));
    mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), way);
    mesh.position.set(...link.mount.at).addScaledVector(way, -0.45 * radius - (link.screws.length ? 1.2 * this.thin : 0));
    this.group.add(mesh);
    return mesh;
  }

  repaint() {
    for (const [material, color] of this.paints) {
      if (!color.startsWith("#")) material.color.set(css(color));
      else material.color.set(color).multiplyScalar(0.8); // white, too, leaves room for the light
    }
  }

  /** Put everything where it is at the coordinates `q`, with the modes magnified. */
  pose(q, magnified) {
    const found = poses(this.scene, q, magnified);
    this.parts.forEach((part, i) => {
      const { frame, tip, joint, coordinates, stages } = found[i];
      for (const cylinder of part.cylinders) cylinder.follow(stages);
      part.frame.position.set(...frame.at);
      part.frame.quaternion.set(...frame.turn);
      part.tip.position.set(...tip.at);
      part.tip.quaternion.set(...tip.turn);
      const { shapes, modal } = part.uniforms;
      if (part.link.fine) {
        put(shapes.value.image.data, part.link, coordinates);
        shapes.value.needsUpdate = true;
      }
      (part.link.fine ? [1] : coordinates).forEach((x, k) => { modal.value.image.data[4 * k] = x; });
      modal.value.needsUpdate = true;
      if (part.rail) {
        const way = plus(plus(frame.at, turned(frame.turn, part.link.base)), times(-1, joint.at));
        const long = norm(way);
        part.rail.visible = long > 1e-6 && !part.covered;
        part.rail.position.set(...joint.at);
        if (part.rail.visible) part.rail.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), vector(times(1 / long, way)));
        part.rail.scale.set(0.6 * this.thin, Math.max(long, 1e-6), 0.6 * this.thin);
      }
    });
    const real = this.lines.length && magnified !== 1 ? poses(this.scene, q) : found;
    for (const line of this.lines) line.follow(found, real);
    return found;
  }
}

/** Axes of a frame, a third of which are as long as the others are thin. */
function triad(length) {
  const line = new THREE.BufferGeometry();
  const ends = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].flatMap((axis) => [0, 0, 0, ...times(length, axis)]);
  const shades = [[0.82, 0.27, 0.25], [0.25, 0.62, 0.32], [0.27, 0.42, 0.85]].flatMap((c) => [...c, ...c]);
  line.setAttribute("position", new THREE.Float32BufferAttribute(ends, 3));
  line.setAttribute("color", new THREE.Float32BufferAttribute(shades, 3));
  return new THREE.LineSegments(line, new THREE.LineBasicMaterial({ vertexColors: true }));
}

/** The floor's grid about a place: lines that fade away from it, one `cell` apart. */
function grid(cell, radius) {
  const count = Math.ceil(radius / cell);
  const [ends, shares] = [[], []];
  const segment = (a, b) => {
    for (const [x, y] of [a, b]) {
      ends.push(x, y, 0);
      shares.push(Math.max(0, 1 - (Math.hypot(x, y) / (count * cell)) ** 1.6));
    }
  };
  for (let i = -count; i <= count; i++)
    for (let j = -count; j < count; j++) {
      if (Math.hypot(i, j + 0.5) > count) continue;
      segment([i * cell, j * cell], [i * cell, (j + 1) * cell]);
      segment([j * cell, i * cell], [(j + 1) * cell, i * cell]);
    }
  const out = new THREE.BufferGeometry();
  out.setAttribute("position", new THREE.Float32BufferAttribute(ends, 3));
  out.setAttribute("color", new THREE.Float32BufferAttribute(new Float32Array(3 * shares.length), 3));
  const lines = new THREE.LineSegments(out, new THREE.LineBasicMaterial({ vertexColors: true }));
  lines.repaint = () => {
    const [far, near] = [new THREE.Color(css("--paper")), new THREE.Color(css("--grid"))];
    const color = new THREE.Color();
    shares.forEach((share, k) => color.copy(far).lerp(near, share).toArray(out.attributes.color.array, 3 * k));
    out.attributes.color.needsUpdate = true;
  };
  return lines;
}

/** Flat shadows of a robot's parts on the floor: the same shapes, projected along the light. */
class Shadows {
  constructor(robot, root, light, height) {
    this.material = new THREE.MeshBasicMaterial();
    this.pairs = [];
    this.group = new THREE.Group();
    const [x, y, z] = light.toArray();
    this.flat = new THREE.Matrix4().set(1, 0, -x / z, (x / z) * height, 0, 1, -y / z, (y / z) * height, 0, 0, 0, height, 0, 0, 0, 1);
    robot.group.traverse((mesh) => {
      if (!mesh.isMesh) return;
      const material = mesh.bends ? bending(new THREE.MeshBasicMaterial(), mesh.bends, false, false, Boolean(mesh.between)) : this.material;
      const twin = new THREE.Mesh(mesh.geometry, material);
      [twin.matrixAutoUpdate, twin.frustumCulled, twin.renderOrder] = [false, false, -1];
      this.pairs.push([mesh, twin]);
      this.group.add(twin);
    });
  }

  repaint() {
    for (const [, twin] of this.pairs) twin.material.color.set(css("--shadow"));
  }

  follow() {
    for (const [mesh, twin] of this.pairs) {
      twin.visible = mesh.visible;
      twin.matrix.multiplyMatrices(this.flat, mesh.matrixWorld);
    }
  }
}
