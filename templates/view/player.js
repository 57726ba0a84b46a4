// The page: time, the camera, and what is shown.

const data = JSON.parse(document.getElementById("data").textContent);
const find = (id) => document.getElementById(id);
for (const scene of data.scenes) if (scene.meshes === "as the first") scene.meshes = data.scenes[0].meshes;
const scenes = data.scenes.map(unpacked);
const motions = data.clips.map((clip) => new Motion(clip));
const modes = data.kind === "modes";
const MAGNIFICATIONS = [0, 1, 2, 5, 10, 20, 50, 100];
const ghostly = data.ghost === null ? null : motions[data.ghost];
const state = {
  clip: 0, time: 0, playing: true, speed: 1, magnified: 1, loop: true,
  shown: { trail: true, frames: false, force: false, moment: false, drive: false, floor: true, ghost: true, meshes: true },
};
const motion = () => motions[state.clip];
const end = () => Math.max(motion().end, ghostly && !modes ? ghostly.end : 0) || 1;

// ---------------------------------------------------------------- the space

const gravity = vector(scenes[0].gravity);
const world = new THREE.Group(); // turned so that what falls falls along −z
if (gravity.length() > 1e-9) world.quaternion.setFromUnitVectors(gravity.clone().normalize(), new THREE.Vector3(0, 0, -1));
const space = new THREE.Scene();
space.add(world);
const LIGHT = new THREE.Vector3(-0.35, -0.25, -1);
const sun = new THREE.DirectionalLight(0xffffff, 2.1);
sun.position.copy(LIGHT).negate();
const sky = new THREE.HemisphereLight(0xffffff, 0xb4bcc6, 2.3);
space.add(sun, sky);
const rim = new THREE.DirectionalLight(0xffffff, 0.5);
rim.position.set(-1, -2, 0.6);
space.add(rim);

const robot = new Robot(scenes[motions[0].clip.scene], css, false);
world.add(robot.group);
const ghost = ghostly && new Robot(scenes[ghostly.clip.scene], css, true);
if (ghost) world.add(ghost.group);
robot.triads = robot.parts.map((part) => {
  const out = triad(0.09 * robot.scene.size);
  part.frame.add(out);
  return out;
});

/** The places of all tips, bodies and rigid meshes over a motion, in the axes of the page; the last link's tip as a path. */
const MOST = 1500;
const SURVEYED = 60;
function travelled(robot, motion, magnified) {
  const count = Math.min(motion.t.length, MOST);
  const path = new Float32Array(3 * count);
  const [low, high] = [new THREE.Vector3(Infinity, Infinity, Infinity), new THREE.Vector3(-Infinity, -Infinity, -Infinity)];
  const leaf = robot.scene.links.findLastIndex((link) => link.radius > 0 || link.bodies.length);
  const times = [];
  const cloud = [];
  let keep = true;
  const include = (p) => {
    const at = new THREE.Vector3(...p).applyQuaternion(world.quaternion);
    low.min(at);
    high.max(at);
    if (keep) cloud.push(at);
  };
  robot.scene.corners.forEach(include);
  for (let k = 0; k < count; k++) {
    const row = count > 1 ? Math.round((k * (motion.t.length - 1)) / (count - 1)) : 0;
    const found = poses(robot.scene, motion.q.map((x) => x[row]), magnified);
    times.push(motion.t[row]);
    path.set(found[leaf].tip.at, 3 * k);
    keep = k % Math.ceil(count / SURVEYED) === 0 || k === count - 1;
    found.forEach(({ frame, tip }, i) => {
      for (const p of [frame.at, tip.at]) include(p);
      for (const p of robot.scene.links[i].corners) include(plus(frame.at, turned(frame.turn, p)));
      for (const p of robot.scene.links[i].ends) include(plus(tip.at, turned(tip.turn, p)));
    });
  }
  return { path, times, low, high, cloud };
}
/** The largest of some factors with which the tips of a motion are at most this share of the robot away from where they
 * are without bending; 1 where they are seen to bend as they are. */
const [SEEN, BARELY] = [0.06, 0.02];
function preset(robot, motion, factors) {
  const count = Math.min(motion.t.length, SURVEYED);
  let most = 0;
  for (let k = 0; k < count; k++) {
    const q = motion.q.map((x) => x[count > 1 ? Math.round((k * (motion.t.length - 1)) / (count - 1)) : 0]);
    const [bent, straight] = [1, 0].map((factor) => poses(robot.scene, q, factor));
    bent.forEach((x, i) => { most = Math.max(most, norm(plus(x.tip.at, times(-1, straight[i].tip.at)))); });
  }
  const share = most / robot.scene.size;
  return share > 1e-7 && share < BARELY ? Math.max(1, ...factors.filter((x) => x * share <= SEEN)) : 1;
}
const nice = (x) => {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * [5, 2, 1].find((k) => k * power <= x * 1.0001);
};
if (!modes && !robot.scene.closed) state.magnified = preset(robot, motions[0], MAGNIFICATIONS);
const reachOf = motions.map((m) => travelled(m === ghostly ? ghost : robot, m, state.magnified));
const framed = modes ? [reachOf[data.ghost]] : reachOf; // of modes the robot at rest, with room to vibrate
const room = modes ? 0.15 * robot.scene.size : 0;
const low = framed.reduce((a, x) => a.min(x.low), framed[0].low.clone()).subScalar(room);
const high = framed.reduce((a, x) => a.max(x.high), framed[0].high.clone()).addScalar(room);
const extent = Math.max(high.clone().sub(low).length(), robot.scene.size);
const middle = low.clone().add(high).multiplyScalar(0.5);
const ground = low.z - 0.035 * robot.scene.size - 1.5 * robot.thin;
const falls = gravity.length() > 1e-9;
const cell = nice(extent / 5);
const floor = grid(cell, 1.15 * extent);
floor.position.set(Math.round(middle.x / cell) * cell, Math.round(middle.y / cell) * cell, ground);
space.add(floor);
const shadows = falls ? [robot, ghost].filter(Boolean).slice(0, 1).map((r) => new Shadows(r, world, LIGHT, ground - 1e-4 * extent)) : [];
for (const shadow of shadows) space.add(shadow.group);

const trails = [robot, ghost].filter(Boolean).map((owner, k) => {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(new Float32Array(3 * MOST), 3));
  const whole = new THREE.Line(geometry, new THREE.LineBasicMaterial({ transparent: true, opacity: 0.4 }));
  const done = new THREE.Line(geometry.clone(), new THREE.LineBasicMaterial({ transparent: true, opacity: k ? 0.45 : 0.95 }));
  whole.frustumCulled = done.frustumCulled = false;
  world.add(whole, done);
  return { owner, whole, done, times: [] };
});

function retrace() {
  if (!modes) frame = framed.flatMap((x) => x.cloud);
  trails.forEach((trail, k) => {
    const { path, times, cloud } = travelled(trail.owner, k ? ghostly : motion(), state.magnified);
    if (!modes) frame.push(...cloud);
    for (const line of [trail.whole, trail.done]) {
      line.geometry.attributes.position.array.set(path);
      line.geometry.attributes.position.needsUpdate = true;
      line.geometry.setDrawRange(0, times.length);
    }
    trail.times = times;
  });
}

// ---------------------------------------------------------------- arrows

const KINDS = { force: ["Joint forces", "N", 1], moment: ["Joint moments", "N·m", 2], drive: ["Drives", "", 2] };
const paints = Object.fromEntries(Object.keys(KINDS).map((kind) => [kind, new THREE.MeshPhongMaterial({ shininess: 20 })]));
const arrows = robot.scene.links.flatMap((link, i) => {
  const make = (kind, k, turn) => {
    const arrow = new Arrow(paints[kind], 0.0045 * robot.scene.size, kind === "force" || (kind === "drive" && !turn) ? 1 : 2);
    world.add(arrow.group);
    return { kind, link: i, k, turn, arrow };
  };
  const own = link.welded ? [] : [make("force", 6 * i + 3), make("moment", 6 * i)];
  return [...own, ...link.screws.map((screw, k) => make("drive", 6 * robot.scene.links.length + link.force + k, screw.turn))];
});
const turns = new Set(robot.scene.links.flatMap((link) => link.screws.map((screw) => screw.turn)));
const DRIVEN = turns.has(false) ? (turns.has(true) ? "N·m, N" : "N") : "N·m";
/** N or N·m for each cell of the grid, so that the largest arrow is about a quarter of the robot. */
const scales = Object.fromEntries(Object.keys(KINDS).map((kind) => {
  let most = 0;
  const columns = motions[0].forces;
  for (const { kind: own, k } of arrows) {
    if (own !== kind || !columns.length) continue;
    const parts = kind === "drive" ? [columns[k]] : [columns[k], columns[k + 1], columns[k + 2]];
    parts[0].forEach((_, row) => { most = Math.max(most, Math.hypot(...parts.map((x) => x[row]))); });
  }
  return [kind, most > 1e-9 ? nice((3.2 * most * cell) / robot.scene.size) : 0];
}));

function push(found, forces) {
  for (const { kind, link, k, arrow } of arrows) {
    arrow.group.visible = false;
    if (!state.shown[kind] || !scales[kind] || !forces.length) continue;
    const { frame, axes } = found[link];
    const value = kind === "drive" ? times(forces[k], axes[k - 6 * robot.scene.links.length - robot.scene.links[link].force])
      : turned(frame.turn, [forces[k], forces[k + 1], forces[k + 2]]);
    arrow.point(plus(frame.at, turned(frame.turn, robot.scene.links[link].base)), times(cell / scales[kind], value));
  }
}

// ---------------------------------------------------------------- camera and renderer

const camera = new THREE.PerspectiveCamera(32, 1, 0.01 * extent, 40 * extent);
camera.up.set(0, 0, 1);
/** Whether the processor draws: edges are then not smoothed, which takes half of its time. */
function software() {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context && context.getExtension("WEBGL_debug_renderer_info");
  const name = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  if (context) context.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name) && !location.hash.includes("smooth");
}
let renderer = null;
let controls = null;
/** What the camera looks at: the places of the motion, as it is magnified; of modes the corners of where they may be. */
let frame = Array.from({ length: 8 }, (_, k) => new THREE.Vector3(...[0, 1, 2].map((i) => (k >> i & 1 ? high : low).getComponent(i))));
try {
  renderer = new THREE.WebGLRenderer({ canvas: find("space"), antialias: !software(), preserveDrawingBuffer: false });
} catch {
  find("failed").textContent = "This browser draws no WebGL; the curves below are shown all the same.";
  find("failed").hidden = false;
}

/** Where on an axis of the picture, and from how far, all `places` are between -below and above, tangents from its middle. */
function fitted(places, depths, below, above) {
  const most = (sign, tangent) => places.reduce((a, x, k) => Math.max(a, sign * x + tangent * depths[k]), -Infinity);
  const [top, bottom] = [most(1, above), most(-1, below)];
  return { near: (top + bottom) / (above + below), at: (far) => (top - bottom + (below - above) * far) / 2 };
}

const NARROWEST = 190; // pixels of a panel of curves
const MARGINS = [innerWidth > 640 ? 62 : 104, 44, 24]; // pixels that the title, the legend and the sides take
function look() {
  const box = find("stage").getBoundingClientRect();
  camera.aspect = box.width / Math.max(box.height, 1);
  const [first, last] = [frame.reduce((a, p) => a.min(p), frame[0].clone()), frame.reduce((a, p) => a.max(p), frame[0].clone())];
  const [spread, middle] = [last.clone().sub(first), first.clone().add(last).multiplyScalar(0.5)];
  const wide = spread.x > 2.2 * spread.y;
  const way = (spread.y > 2.2 * spread.x ? new THREE.Vector3(1, -0.42, 0.42) : new THREE.Vector3(wide ? 0.42 : 0.75, -1, 0.45)).normalize();
  const right = new THREE.Vector3(0, 0, 1).cross(way).normalize();
  const up = way.clone().cross(right);
  const [places, heights, depths] = [right, up, way].map((axis) => frame.map((p) => p.clone().sub(middle).dot(axis)));
  const half = Math.tan((camera.fov * Math.PI) / 360);
  const [above, below, aside] = MARGINS.map((pixels) => half * Math.max(1 - (2 * pixels) / Math.max(box.height, 1), 0.5));
  const across = aside + half * (camera.aspect - 1);
  const [x, y] = [fitted(places, depths, across, across), fitted(heights, depths, below, above)];
  const far = Math.max(x.near, y.near, (0.45 * robot.scene.size) / (half * Math.min(camera.aspect, 1)));
  middle.addScaledVector(right, x.at(far)).addScaledVector(up, y.at(far));
  camera.position.copy(middle).addScaledVector(way, far);
  if (controls) {
    controls.target.copy(middle);
    controls.update();
  } else camera.lookAt(middle);
}

function resize() {
  const box = find("stage").getBoundingClientRect();
  camera.aspect = box.width / Math.max(box.height, 1);
  camera.updateProjectionMatrix();
  if (renderer) {
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(box.width, box.height, false);
  }
  const fit = Math.max(1, Math.floor(find("panels").clientWidth / NARROWEST)); // whole panels, the others scroll
  find("panels").style.setProperty("--whole", Math.min(panels.length, fit) || 1);
  for (const panel of panels) panel.draw();
  state.stale = true;
}

// ---------------------------------------------------------------- time

let found = [];
function draw() {
  const now = motion().at(modes ? state.time : Math.min(state.time, motion().end));
  if (!state.marked) for (const owner of [robot, ghost]) owner?.wear(state.shown.meshes);
  found = robot.pose(now.q, state.magnified);
  if (ghost) ghost.pose(ghostly.at(Math.min(state.time, ghostly.end)).q, state.magnified);
  push(found, now.forces);
  for (const trail of trails) {
    let count = trail.times.findIndex((t) => t > state.time);
    if (count < 0) count = trail.times.length;
    trail.whole.visible = trail.done.visible = state.shown.trail && !(trail.owner === ghost && (modes || !state.shown.ghost));
    trail.done.geometry.setDrawRange(0, count);
  }
  if (ghost) ghost.group.visible = state.shown.ghost;
  for (const axes of robot.triads) axes.visible = state.shown.frames;
  floor.visible = state.shown.floor;
  world.updateMatrixWorld(true);
  for (const shadow of shadows) {
    shadow.group.visible = state.shown.floor && camera.position.z > ground && !state.marked;
    if (shadow.group.visible) shadow.follow();
  }
  if (renderer) renderer.render(space, camera);
  state.stale = false;
}

function tell() {
  find("clock").textContent = modes ? `${(100 * state.time / end()).toFixed(0).padStart(3)} % of a period` : `${state.time.toFixed(3)} / ${+end().toFixed(3)} s`;
  find("scrub").value = String(state.time);
  for (const panel of panels) panel.move(state.time);
}

function seek(time, stay = true) {
  state.time = Math.min(Math.max(time, 0), end());
  if (stay && state.playing && time !== state.time) play(false);
  state.stale = true;
  tell();
}

function play(on) {
  if (on && state.time >= end()) state.time = 0;
  state.playing = on;
  find("play").classList.toggle("running", on);
}

let before = 0;
let told = 0;
function tick(stamp) {
  requestAnimationFrame(tick);
  const passed = Math.min((stamp - before) / 1000, 0.25);
  before = stamp;
  if (state.playing) {
    state.time += passed * state.speed * (modes ? end() / 2.4 : 1);
    if (state.time > end()) {
      if (state.loop) state.time %= end();
      else {
        state.time = end();
        play(false);
      }
    }
    state.stale = true;
  }
  if (controls && controls.update()) state.stale = true;
  if (!state.stale) return;
  draw();
  if (stamp - told > 60 || !state.playing) {
    tell();
    told = stamp;
  }
}
