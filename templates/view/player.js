// The page: time, the camera, what is shown, and the hooks that tests read.

const data = JSON.parse(document.getElementById("data").textContent);
const find = (id) => document.getElementById(id);
const scenes = data.scenes.map(unpacked);
const motions = data.clips.map((clip) => new Motion(clip));
const modes = data.kind === "modes";
const ghostly = data.ghost === null ? null : motions[data.ghost];
const state = {
  clip: 0, time: 0, playing: true, speed: 1, magnified: 1, loop: true,
  shown: { trail: true, frames: false, force: false, moment: false, drive: false, floor: true, ghost: true },
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

/** The places of all tips over a motion, in the axes of the page; the last link's as a path. */
const MOST = 1500;
function travelled(robot, motion, magnified) {
  const count = Math.min(motion.t.length, MOST);
  const path = new Float32Array(3 * count);
  const [low, high] = [new THREE.Vector3(Infinity, Infinity, Infinity), new THREE.Vector3(-Infinity, -Infinity, -Infinity)];
  const leaf = robot.scene.links.findLastIndex((link) => link.radius > 0 || link.bodies.length);
  const times = [];
  const at = new THREE.Vector3();
  for (let k = 0; k < count; k++) {
    const row = count > 1 ? Math.round((k * (motion.t.length - 1)) / (count - 1)) : 0;
    const found = poses(robot.scene, motion.q.map((x) => x[row]), magnified);
    times.push(motion.t[row]);
    path.set(found[leaf].tip.at, 3 * k);
    for (const { frame, tip } of found)
      for (const p of [frame.at, tip.at]) {
        at.set(...p).applyQuaternion(world.quaternion);
        low.min(at);
        high.max(at);
      }
  }
  return { path, times, low, high };
}
const nice = (x) => {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * [5, 2, 1].find((k) => k * power <= x * 1.0001);
};
const reachOf = motions.map((m) => travelled(m === ghostly ? ghost : robot, m, 1));
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
  const whole = new THREE.Line(geometry, new THREE.LineBasicMaterial({ transparent: true, opacity: 0.22 }));
  const done = new THREE.Line(geometry.clone(), new THREE.LineBasicMaterial({ transparent: true, opacity: k ? 0.45 : 0.95 }));
  whole.frustumCulled = done.frustumCulled = false;
  world.add(whole, done);
  return { owner, whole, done, times: [] };
});

function retrace() {
  if (!modes) frame = [low.clone(), high.clone()];
  trails.forEach((trail, k) => {
    const { path, times, ...corners } = travelled(trail.owner, k ? ghostly : motion(), state.magnified);
    if (!modes) {
      frame[0].min(corners.low);
      frame[1].max(corners.high);
    }
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
let frame = [low, high]; // what the camera looks at: the corners of the motion, as it is magnified
try {
  renderer = new THREE.WebGLRenderer({ canvas: find("space"), antialias: !software(), preserveDrawingBuffer: false });
} catch {
  find("failed").textContent = "This browser draws no WebGL; the curves below are shown all the same.";
  find("failed").hidden = false;
}

function look() {
  const box = find("stage").getBoundingClientRect();
  camera.aspect = box.width / Math.max(box.height, 1);
  const across = Math.atan(Math.tan((camera.fov * Math.PI) / 360) * Math.min(camera.aspect, 1));
  const [first, last] = frame;
  const spread = last.clone().sub(first);
  const middle = first.clone().add(last).multiplyScalar(0.5);
  const wide = spread.x > 2.2 * spread.y;
  const way = (spread.y > 2.2 * spread.x ? new THREE.Vector3(1, -0.42, 0.42) : new THREE.Vector3(wide ? 0.42 : 0.75, -1, 0.45)).normalize();
  const radius = Math.max(spread.length() / 2, 0.45 * robot.scene.size) * (camera.aspect > 1.4 ? 0.86 : 1.02);
  camera.position.copy(middle).addScaledVector(way, radius / Math.sin(across));
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
  for (const panel of panels) panel.draw();
  state.stale = true;
}

// ---------------------------------------------------------------- time

let found = [];
function draw() {
  const now = motion().at(modes ? state.time : Math.min(state.time, motion().end));
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
const drawn = [];
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
  drawn.push(stamp);
  if (drawn.length > 240) drawn.shift();
  if (stamp - told > 60 || !state.playing) {
    tell();
    told = stamp;
  }
}

// ---------------------------------------------------------------- controls of the page

const options = (id, values, chosen, text, change) => {
  for (const value of values) find(id).append(new Option(text(value), value, value === chosen, value === chosen));
  find(id).addEventListener("change", () => change(Number(find(id).value)));
};
const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10];
const MAGNIFICATIONS = [0, 1, 2, 5, 10, 20, 50, 100];
function magnify(value) {
  state.magnified = value;
  find("magnify").value = String(value);
  retrace();
  legend();
  state.stale = true;
}
function theme(dark) {
  document.documentElement.classList.toggle("dark", dark);
  space.background = new THREE.Color(css("--paper"));
  sun.intensity = dark ? 1.9 : 2.1;
  sky.intensity = dark ? 1.5 : 2.3;
  for (const part of [robot, ghost, floor, ...shadows]) if (part) part.repaint();
  for (const [kind, paint] of Object.entries(paints)) paint.color.set(css(`--${kind}`));
  for (const { whole, done } of trails) for (const line of [whole, done]) line.material.color.set(css("--trail"));
  for (const panel of panels) panel.draw();
  state.stale = true;
}
function legend() {
  const links = [...new Map(robot.scene.links.filter((x) => x.radius && norm(x.reach) > 1e-9).map((x) => [x.owner, x])).values()];
  const rows = links.slice(0, 8).map((x) => [`background:var(--c${x.owner % 8})`, "", x.name.replace(/\[0\]$/, "").replace(/_/g, " ")]);
  if (ghostly) rows.push(["background:var(--soft)", "faint", modes ? "at rest" : ghostly.label]);
  for (const [kind, [name, unit]] of Object.entries(KINDS))
    if (state.shown[kind] && scales[kind]) rows.push([`background:var(--${kind})`, "", `${name}: ${+scales[kind].toPrecision(3)} ${unit || DRIVEN} per ${+cell.toPrecision(3)} m`]);
  if (state.shown.floor) rows.push(["", "grid", `${+cell.toPrecision(3)} m`]);
  if (state.magnified !== 1) rows.push(["", "none", `bending × ${state.magnified}`]);
  find("legend").replaceChildren(...rows.map(([style, kind, text]) => {
    const row = document.createElement("li");
    const mark = document.createElement("i");
    if (kind === "none") mark.remove();
    else row.append(mark);
    mark.style.cssText = style;
    if (kind) mark.className = kind;
    row.append(text);
    return row;
  }));
}
function facts() {
  const [kept, all] = motion().clip.samples || [];
  find("facts").textContent = modes ? `${motions.length - 1} modes · ${motion().label}`
    : ghostly ? `${motion().label} · ghost: ${ghostly.label}` : `${motion().label}${kept < all ? ` · ${kept} of ${all} samples` : ""}`;
}

const panels = (motions[0].clip.panels || []).map((own) => {
  const other = ghostly && (ghostly.clip.panels || []).find((x) => x.title === own.title);
  return new Panel(find("panels"), other ? [own, other] : [own], end(), (t) => { play(false); seek(t); });
});
const SWITCHES = { trail: "Path of the tip", floor: "Floor", frames: "Frames of the links", force: "Joint forces", moment: "Joint moments", drive: "Torques of drives", ghost: "Ghost" };
for (const [name, text] of Object.entries(SWITCHES)) {
  if ((name in KINDS && !scales[name]) || (name === "ghost" && !ghost)) continue;
  const label = document.createElement("label");
  const box = Object.assign(document.createElement("input"), { type: "checkbox", name, checked: state.shown[name] });
  box.addEventListener("change", () => { state.shown[name] = box.checked; state.stale = true; legend(); });
  label.append(box, text);
  find("switches").append(label);
}
if (modes) {
  find("choose").hidden = false;
  motions.forEach((m, k) => { if (m !== ghostly) find("clips").append(new Option(m.label, k)); });
  find("clips").addEventListener("change", () => { state.clip = Number(find("clips").value); facts(); retrace(); state.stale = true; });
}
options("speed", SPEEDS, 1, (x) => `${x} ×`, (x) => { state.speed = x; });
options("magnify", MAGNIFICATIONS, 1, (x) => `× ${x}`, magnify);
find("scrub").max = String(end());
find("scrub").addEventListener("input", () => { play(false); seek(Number(find("scrub").value)); });
find("play").addEventListener("click", () => play(!state.playing));
find("loop").addEventListener("change", () => { state.loop = find("loop").checked; });
find("reset").addEventListener("click", () => { look(); state.stale = true; });
const isDark = () => document.documentElement.classList.contains("dark");
find("theme").addEventListener("click", () => theme(!isDark()));
document.addEventListener("pointerdown", (event) => { if (!find("layers").contains(event.target)) find("layers").open = false; });
const step = (list, now, by) => list[Math.min(Math.max(list.indexOf(now) + by, 0), list.length - 1)];
const KEYS = {
  " ": () => play(!state.playing),
  ArrowLeft: (event) => { play(false); seek(state.time - end() / (event.shiftKey ? 20 : 200)); },
  ArrowRight: (event) => { play(false); seek(state.time + end() / (event.shiftKey ? 20 : 200)); },
  Home: () => seek(0),
  End: () => { play(false); seek(end()); },
  "[": () => { state.speed = step(SPEEDS, state.speed, -1); find("speed").value = String(state.speed); },
  "]": () => { state.speed = step(SPEEDS, state.speed, 1); find("speed").value = String(state.speed); },
  m: () => magnify(step(MAGNIFICATIONS, state.magnified, 1)),
  M: () => magnify(step(MAGNIFICATIONS, state.magnified, -1)),
  r: () => { look(); state.stale = true; },
  d: () => theme(!isDark()),
};
document.addEventListener("keydown", (event) => {
  const act = KEYS[event.key];
  if (!act || event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
  if (event.target.tagName === "BUTTON" && event.key === " ") return;
  event.preventDefault();
  act(event);
});

// ---------------------------------------------------------------- hooks, and the start

/** For tests and for scripts in the page: time, magnification, the camera, and the ends of links alone in plain colours. */
window.screwgen = {
  data, state, seek: (time) => { play(false); seek(time); draw(); }, play, look, magnify: (value) => { magnify(value); draw(); }, theme,
  show: (name, on) => { state.shown[name] = on; legend(); draw(); },
  /** Where a point of the inertial frame is drawn: pixels of the page. */
  project: (point) => {
    camera.updateMatrixWorld();
    const at = vector(point).applyQuaternion(world.quaternion).project(camera);
    const box = find("space").getBoundingClientRect();
    return [box.left + ((at.x + 1) / 2) * box.width, box.top + ((1 - at.y) / 2) * box.height];
  },
  camera: () => {
    camera.updateMatrixWorld();
    const whole = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    return { matrix: whole.multiply(new THREE.Matrix4().makeRotationFromQuaternion(world.quaternion)).transpose().toArray() };
  },
  poses: () => found,
  frames: () => drawn.slice(),
  /** When what was asked for has been drawn and shown. */
  settled: () => new Promise((done) => {
    state.stale = true;
    let left = 3;
    const next = () => requestAnimationFrame(left-- ? next : done);
    next();
  }),
  /** Draw nothing but the end of a link's tube, in a colour. */
  mark: (link, color) => {
    state.marked = true;
    space.background = new THREE.Color(0);
    for (const kind of ["trail", "frames", "force", "moment", "drive", "floor", "ghost"]) state.shown[kind] = false;
    robot.group.traverse((mesh) => { if (mesh.isMesh) mesh.visible = false; });
    for (const mesh of robot.parts[link].bent) {
      mesh.material = bending(new THREE.MeshBasicMaterial({ color, side: THREE.DoubleSide }), robot.parts[link].uniforms, false, true);
      mesh.visible = true;
    }
    draw();
  },
};
if (renderer) {
  controls = new THREE.OrbitControls(camera, find("space"));
  Object.assign(controls, { enableDamping: true, dampingFactor: 0.12, maxDistance: 20 * extent, minDistance: 0.05 * extent, zoomToCursor: true });
}
/** What the page's address asks for behind its #: `t` in s, `bending`, `theme`, `show`. */
function asked(wanted) {
  for (const name of (wanted.get("show") || "").split(",")) {
    if (!(name in state.shown)) continue;
    state.shown[name] = true;
    for (const box of find("switches").querySelectorAll(`[name=${name}]`)) box.checked = true;
  }
  if (Number(wanted.get("bending")) > 0) magnify(Number(wanted.get("bending")));
  if (wanted.has("theme")) theme(wanted.get("theme") === "dark");
  if (wanted.has("t")) {
    play(false);
    seek(Number(wanted.get("t")) || 0);
  }
  legend();
}
const prefers = matchMedia("(prefers-color-scheme: dark)");
prefers.addEventListener("change", () => theme(prefers.matches));
look();
resize();
look();
theme(prefers.matches);
new ResizeObserver(resize).observe(find("stage"));
retrace();
legend();
facts();
play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
asked(new URLSearchParams(location.hash.slice(1)));
draw();
tell();
requestAnimationFrame((stamp) => { before = stamp; tick(stamp); });
window.screwgen.ready = performance.now();
