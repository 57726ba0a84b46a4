// The controls of the page, and the hooks that tests read.

const options = (id, values, chosen, text, change) => {
  for (const value of values) find(id).append(new Option(text(value), value, value === chosen, value === chosen));
  find(id).addEventListener("change", () => change(Number(find(id).value)));
};
const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10];
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
  const covered = new Set(state.shown.meshes ? [...robot.worn].map((part) => part.link) : []);
  const links = [...new Map(robot.scene.links.filter((x) => !covered.has(x) && x.radius && norm(x.reach) > 1e-9).map((x) => [x.owner, x])).values()];
  const rows = links.slice(0, 8).map((x) => [`background:var(--c${x.owner % 8})`, "", x.name.replace(/\[0\]$/, "").replace(/_/g, " ")]);
  if (ghostly) rows.push(["background:var(--soft)", "faint", modes ? "at rest" : ghostly.label]);
  for (const [kind, [name, unit]] of Object.entries(KINDS))
    if (state.shown[kind] && scales[kind]) rows.push([`background:var(--${kind})`, "", `${name}: ${+scales[kind].toPrecision(3)} ${unit || DRIVEN} per ${+cell.toPrecision(3)} m`]);
  if (modes && links.some((x) => x.twists)) rows.push(["background:var(--dark-metal)", "", "line along a link that twists"]);
  if (state.shown.floor) rows.push(["", "grid", `${+cell.toPrecision(3)} m`]);
  if (state.magnified !== 1) rows.push(["", "none", `bending drawn × ${state.magnified}`]);
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
const SWITCHES = { trail: "Path of the tip", floor: "Floor", frames: "Frames of the links", force: "Joint forces", moment: "Joint moments", drive: "Torques of drives", ghost: "Ghost", meshes: "Meshes" };
for (const [name, text] of Object.entries(SWITCHES)) {
  if ((name in KINDS && !scales[name]) || (name === "ghost" && !ghost) || (name === "meshes" && !robot.skins.length)) continue;
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
options("magnify", MAGNIFICATIONS, state.magnified, (x) => `× ${x}`, magnify);
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

function alone() {
  state.marked = true;
  space.background = new THREE.Color(0);
  for (const kind of ["trail", "frames", "force", "moment", "drive", "floor", "ghost"]) state.shown[kind] = false;
  robot.group.traverse((mesh) => { if (mesh.isMesh) mesh.visible = false; });
}

/** For tests and for scripts in the page: time, magnification, the camera, and the ends of links alone in plain colours. */
window.screwgen = {
  data, state, ground, seek: (time) => { play(false); seek(time); draw(); }, play, look, magnify: (value) => { magnify(value); draw(); }, theme,
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
  /** Where the eyes of a link's cylinders are drawn, on the carrier and on the link, inertial frame, m. */
  eyes: (link) => robot.parts[link].cylinders.map((cylinder) => cylinder.eyes),
  /** The points at which the lines of forces are drawn, inertial frame, m. */
  lines: () => robot.lines.map((line) => line.points),
  touching: () => robot.touching.map((mesh) => world.worldToLocal(mesh.getWorldPosition(new THREE.Vector3())).toArray()),
  /** What the last picture asked of the graphics: calls and triangles. */
  cost: () => ({ calls: renderer.info.render.calls, triangles: renderer.info.render.triangles }),
  /** When what was asked for has been drawn and shown. */
  settled: () => new Promise((done) => {
    state.stale = true;
    let left = 3;
    const next = () => requestAnimationFrame(left-- ? next : done);
    next();
  }),
  /** Draw nothing but the end of a link's tube, in a colour. */
  mark: (link, color) => {
    alone();
    for (const mesh of robot.parts[link].bent) {
      mesh.material = bending(new THREE.MeshBasicMaterial({ color, side: THREE.DoubleSide }), robot.parts[link].uniforms, false, true);
      mesh.visible = true;
    }
    draw();
  },
  /** Draw nothing but a mesh of a URDF, in a colour. */
  markMesh: (k, color) => {
    alone();
    const mesh = robot.skins[k];
    const paint = new THREE.MeshBasicMaterial({ color, side: THREE.DoubleSide });
    mesh.material = mesh.bends ? bending(paint, mesh.bends, false, false, true) : paint;
    mesh.visible = true;
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
