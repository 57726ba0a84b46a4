// Where everything is: the poses of a robot's links from its coordinates, as the model has them.

const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const floats = (text) => new Float32Array(bytes(text).buffer);

/** The columns of a block of rounded numbers, as arrays of doubles. */
function columns(block) {
  return block.data.map((text, k) => {
    const raw = bytes(text).buffer;
    const counts = block.wide[k] ? new Uint32Array(raw) : new Uint16Array(raw);
    return Float64Array.from(counts, (n) => block.low[k] + block.step[k] * n);
  });
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const times = (k, a) => [k * a[0], k * a[1], k * a[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(...a);

/** Unit quaternions are [x, y, z, w]. */
const chain = (a, b) => [
  a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
  a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
  a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
  a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
];
function turned(q, v) {
  const t = times(2, cross(q, v));
  return plus(v, plus(times(q[3], t), cross(q, t)));
}
function exponential(v) {
  const angle = norm(v);
  const k = angle > 1e-9 ? Math.sin(angle / 2) / angle : 0.5;
  return [k * v[0], k * v[1], k * v[2], Math.cos(angle / 2)];
}
const pose = (at, turn) => ({ at, turn });
const behind = (a, b) => pose(plus(a.at, turned(a.turn, b.at)), chain(a.turn, b.turn));
const ORIGIN = pose([0, 0, 0], [0, 0, 0, 1]);

/** The links of a scene with their tables unpacked: `shape[(mode * rows + row) * 6 + component]`. */
function unpacked(scene) {
  for (const link of scene.links) {
    link.shape = floats(link.columns);
    link.rows = link.places.length;
    link.count = link.fine ? 1 : link.modes + link.pairs.length / 2; // an exact rod has its sections as one column
    [link.corners, link.ends] = [[], []]; // what rigid parts reach: in the frame of the link, and in that of its tip
  }
  scene.corners = scene.lines.flatMap((line) => line.ends.filter((end) => end.link < 0).map((end) => end.at));
  for (const found of scene.surfaces) (found.link < 0 ? scene.corners : scene.links[found.link].ends).push(...surrounding(found, [0, 0, 0]));
  for (const mesh of scene.meshes || []) {
    mesh.columns = columns(mesh.table);
    if (mesh.columns.length > 3) continue; // it bends along the centreline
    const ends = mesh.columns.map((x) => [x.reduce((a, b) => Math.min(a, b)), x.reduce((a, b) => Math.max(a, b))]);
    const corners = mesh.link < 0 ? scene.corners : scene.links[mesh.link].corners;
    for (let k = 0; k < 8; k++) corners.push([ends[0][k & 1], ends[1][(k >> 1) & 1], ends[2][k >> 2]]);
  }
  const worn = new Set((scene.meshes || []).filter((mesh) => mesh.link >= 0).map((mesh) => scene.links[mesh.link].owner));
  for (const link of scene.links.filter((x) => !worn.has(x.owner)))
    for (const body of link.bodies) (body.tip ? link.ends : link.corners).push(...surrounding(body, body.tip ? [0, 0, 0] : link.base));
  return scene;
}

/** Points of a body's surface, about a place in its frame: the corners of a box, or of a ball six and eight between them. */
function surrounding(body, place) {
  const signs = Array.from({ length: 8 }, (_, k) => [2 * (k & 1) - 1, (k & 2) - 1, (k >> 1 & 2) - 1]);
  const ball = () => [...signs.map((x) => times(body.ball / Math.sqrt(3), x)), ...[0, 1, 2].flatMap((k) => [-1, 1].map((x) => [0, 1, 2].map((i) => (i === k ? x * body.ball : 0))))];
  const points = body.box ? signs.map((x) => turned(body.turn, x.map((s, k) => (s * body.box[k]) / 2))) : ball();
  return points.map((x) => plus(plus(x, body.at), place));
}

/** A rotation vector of a unit quaternion, the one near another: turns go on beyond half of one. */
function logarithm(q, other) {
  const size = norm(q.slice(0, 3));
  if (size < 1e-12) return [0, 0, 0];
  const angle = 2 * Math.atan2(size, q[3]);
  const full = 2 * Math.PI * Math.round((dot(other, q) / size - angle) / (2 * Math.PI));
  return times((angle + full) / size, q.slice(0, 3));
}

/** The sections of an exact rod, six numbers a row: displacement and rotation vector, of its strains step by step. */
function integrated(link, q, magnified) {
  const out = new Float64Array(6 * link.rows);
  const steps = link.fine * (link.rows - 1);
  const length = norm(link.reach);
  let [at, turn] = [[0, 0, 0], ORIGIN.turn];
  for (let step = 0; step < steps; step++) {
    const row = Math.floor(step / link.fine) + 1;
    const h = ((link.places[row] - link.places[row - 1]) * length) / link.fine;
    const strain = [1, 0, 0, 0, 0, 0];
    if (link.curved) for (let c = 0; c < 6; c++) strain[c] += link.shape[(link.modes * steps + step) * 6 + c];
    for (let k = 0; k < link.modes; k++)
      for (let c = 0; c < 6; c++) strain[c] += magnified * q[link.eta + k] * link.shape[(k * steps + step) * 6 + c];
    const bend = strain.slice(3);
    at = plus(at, times(h, turned(chain(turn, exponential(times(h / 2, bend))), strain.slice(0, 3))));
    turn = chain(turn, exponential(times(h, bend)));
    if ((step + 1) % link.fine) continue;
    const before = Array.from(out.subarray(6 * row - 3, 6 * row));
    out.set([...plus(at, [-link.places[row] * length, 0, 0]), ...logarithm(turn, before)], 6 * row);
  }
  return out;
}

/** The modal coordinates of a link, magnified, and behind them their products; of an exact rod its sections. */
function modal(link, q, magnified) {
  if (link.fine) return integrated(link, q, magnified);
  const out = new Float64Array(link.count);
  for (let k = 0; k < link.modes; k++) out[k] = magnified * q[link.eta + k];
  for (let k = link.modes, p = 0; k < link.count; k++, p += 2) out[k] = out[link.pairs[p]] * out[link.pairs[p + 1]];
  return out;
}

/** The pose of a section in the link's frame; with `drawn` its turn is that of the material, whatever links follow. */
function section(link, row, coordinates, drawn = false) {
  const moved = link.fine ? Array.from(coordinates.subarray(6 * row, 6 * row + 6)) : [0, 0, 0, 0, 0, 0];
  for (let k = 0; k < link.count && !link.fine; k++)
    for (let c = 0; c < 6; c++) moved[c] += coordinates[k] * link.shape[(k * link.rows + row) * 6 + c];
  const at = plus(plus(link.base, times(link.places[row], link.reach)), moved);
  const turn = link.turns || drawn ? exponential(moved.slice(3)) : [0, 0, 0, 1];
  return pose(at, row === link.rows - 1 ? chain(turn, link.axes) : turn);
}

/** Every link: `frame`, its modal `coordinates`, `joint` (where its mount is), `axes` of its screws, its `stages` before and
 * behind each of these, and its `tip`. */
function poses(scene, q, magnified = 1) {
  const out = [];
  for (const link of scene.links) {
    const parent = link.parent < 0 ? null : out[link.parent];
    const carrier = parent ? section(scene.links[link.parent], link.place, parent.coordinates) : ORIGIN;
    const from = parent ? behind(parent.frame, carrier) : ORIGIN;
    const joint = behind(from, pose(link.mount.at, link.mount.turn));
    let frame = joint;
    const turned_by = (k) => unit([q[k + 1], q[k + 2], q[k + 3], q[k]]);
    if (link.in_space) frame = pose(q.slice(link.joint, link.joint + 3), turned_by(link.joint + 3));
    if (link.ball) frame = behind(joint, pose(ORIGIN.at, turned_by(link.joint)));
    const axes = [];
    const stages = [frame];
    link.screws.forEach((screw, k) => {
      const x = q[link.joint + k];
      axes.push(turned(frame.turn, screw.axis));
      const turn = screw.turn ? exponential(times(x, screw.axis)) : ORIGIN.turn;
      frame = behind(frame, pose(times(screw.travel * x, screw.axis), turn));
      stages.push(frame);
    });
    if (!link.in_space) frame = behind(frame, pose(times(-1, link.base), ORIGIN.turn));
    const coordinates = modal(link, q, magnified);
    const tip = behind(frame, section(link, link.rows - 1, coordinates));
    out.push({ frame, coordinates, joint, axes, stages, tip });
  }
  return out;
}
const unit = (q) => times4(1 / Math.hypot(...q), q);
const times4 = (k, q) => q.map((x) => k * x);

/** A motion: its coordinates and forces at any time, on straight lines between samples. */
class Motion {
  constructor(clip) {
    this.label = clip.label;
    this.t = columns(clip.t)[0];
    this.q = columns(clip.q);
    this.forces = clip.forces ? columns(clip.forces) : [];
    this.end = this.t[this.t.length - 1];
    this.clip = clip;
  }

  place(time) {
    let low = 0;
    let high = this.t.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.t[middle] <= time) low = middle;
      else high = middle;
    }
    const span = this.t[high] - this.t[low];
    return [low, high, span > 0 ? Math.min(Math.max((time - this.t[low]) / span, 0), 1) : 0];
  }

  static mix(columns, [low, high, share]) {
    return columns.map((x) => (1 - share) * x[low] + share * x[high]);
  }

  at(time) {
    const place = this.place(time);
    return { q: Motion.mix(this.q, place), forces: Motion.mix(this.forces, place) };
  }
}
