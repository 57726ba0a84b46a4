// Curves over time below the picture: drawn once, with a cursor that moves over them.

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const shown = (x) => (Math.abs(x) < 5e-5 ? "0" : Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3 ? x.toExponential(2) : x.toPrecision(3)).replace("-", "−");
const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"]];
const LEFT = 46;
/** Of a link's first, second and third axis or direction; set points are wide and pale, ghosts dotted. */
const DASHES = [[], [8, 4], [8, 3, 2, 3]];
const [TOP, BOTTOM, RIGHT] = [6, 20, 8];

/** Round numbers between two ends, about `count` of them. */
function ticks(low, high, count) {
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((k) => k * power >= raw * 0.8);
  const out = [];
  for (let x = Math.ceil(low / step - 1e-9) * step; x <= high + 1e-9 * step; x += step) out.push(Math.abs(x) < step / 1e6 ? 0 : x);
  return out;
}

/** Of each curve, how many run where it does, and its place among these: they take turns, so that none hides another. */
const [LIKE, COMPARED] = [0.008, 40];
function alike(curves, range) {
  const out = new Map();
  for (const curve of curves) {
    const same = curves.filter((other) => other.goal === curve.goal && other.ghost === curve.ghost && Array.from({ length: COMPARED }, (_, k) => {
      const t = curve.x[0] + (k / (COMPARED - 1)) * (curve.x[curve.x.length - 1] - curve.x[0]);
      return Math.abs(valueAt(curve, t) - valueAt(other, t)) < LIKE * range;
    }).every(Boolean));
    out.set(curve, [same.indexOf(curve), same.length]);
  }
  return out;
}

class Panel {
  /** `sets`: the same panel of the run and, perhaps, of its ghost; `seek`: what a click on a time calls. */
  constructor(parent, sets, end, seek) {
    this.end = end;
    this.curves = sets.flatMap((panel, k) =>
      panel.curves.map((c) => ({ ...c, color: `--${c.color}`, ghost: k > 0, x: floats(c.x), y: floats(c.y) })));
    const largest = Math.max(...this.curves.map((c) => c.y.reduce((a, y) => Math.max(a, Math.abs(y)), 0)));
    const [factor, prefix] = (sets[0].unit && PREFIXES.find(([f]) => largest >= f * 0.8)) || [1, ""];
    this.factor = factor;
    const element = document.createElement("div");
    element.className = "panel";
    element.innerHTML = "<h2></h2><div class='values'></div><div class='plot'><canvas></canvas><div class='pointer'></div><div class='cursor'></div></div>";
    parent.append(element);
    const part = (name) => element.querySelector(name);
    part("h2").append(sets[0].title + " ", Object.assign(document.createElement("small"), { textContent: prefix + sets[0].unit }));
    [this.values, this.plot, this.canvas, this.cursor, this.pointer] = [".values", ".plot", "canvas", ".cursor", ".pointer"].map(part);
    this.numbers = this.curves.filter((c) => !c.goal).map((c) => {
      const value = document.createElement("b");
      const own = c.ghost && this.values.querySelector(`[data-label="${CSS.escape(c.label)}"]`);
      const text = own || document.createElement("span");
      text.dataset.label = c.label;
      text.append(own ? " ┆ " : `${c.label} `, value);
      if (!own) this.values.append(text);
      text.classList.toggle(`dash${c.dash}`, c.dash > 0);
      return { text, value, curve: c };
    });
    const time = (event) => {
      const box = this.plot.getBoundingClientRect();
      return Math.min(Math.max(((event.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT)) * this.end, 0), this.end);
    };
    this.plot.addEventListener("pointerdown", (event) => { this.plot.setPointerCapture(event.pointerId); seek(time(event)); });
    this.plot.addEventListener("pointermove", (event) => {
      if (event.buttons) seek(time(event));
      this.hover = time(event);
      this.move(this.now);
    });
    this.plot.addEventListener("pointerleave", () => { this.hover = undefined; this.move(this.now); });
    this.now = 0;
  }

  draw() {
    const box = this.plot.getBoundingClientRect();
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    [this.width, this.canvas.width, this.canvas.height] = [box.width, box.width * ratio, box.height * ratio];
    const pen = this.canvas.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    const all = this.curves.map((c) => [c.y.reduce((a, y) => Math.min(a, y), Infinity), c.y.reduce((a, y) => Math.max(a, y), -Infinity)]);
    let [low, high] = [Math.min(...all.map((x) => x[0])), Math.max(...all.map((x) => x[1]))];
    const room = Math.max(0.06 * (high - low), 1e-3 * Math.max(Math.abs(low), Math.abs(high)), 1e-12);
    [low, high] = [(low - room) / this.factor, (high + room) / this.factor];
    const x = (t) => LEFT + (t / this.end) * (box.width - LEFT - RIGHT);
    const y = (value) => TOP + ((high - value) / (high - low)) * (box.height - TOP - BOTTOM);
    this.axes(pen, box, low, high, x, y);
    this.alike = alike(this.curves, (high - low) * this.factor);
    for (const curve of [...this.curves].sort((a, b) => b.goal - a.goal || b.ghost - a.ghost)) {
      pen.beginPath();
      pen.strokeStyle = css(curve.color);
      pen.globalAlpha = curve.goal ? 0.35 : curve.ghost ? 0.75 : 1;
      const [place, count] = this.alike.get(curve);
      if (count > 1) pen.setLineDash([7, 7 * (count - 1)]);
      else pen.setLineDash(curve.ghost ? [2, 3] : DASHES[curve.dash % DASHES.length]);
      pen.lineDashOffset = count > 1 ? -7 * place : 0;
      pen.lineWidth = curve.goal ? 5 : 1.5;
      pen.lineJoin = "round";
      curve.x.forEach((t, k) => pen[k ? "lineTo" : "moveTo"](x(t), y(curve.y[k] / this.factor)));
      pen.stroke();
    }
    pen.globalAlpha = 1;
    for (const { text, curve } of this.numbers) text.style.color = css(curve.color);
    this.move(this.now);
  }

  axes(pen, box, low, high, x, y) {
    pen.font = "11px system-ui, sans-serif";
    pen.fillStyle = css("--soft");
    pen.strokeStyle = css("--line");
    pen.lineWidth = 1;
    const steps = ticks(low, high, 4);
    const digits = Math.max(0, Math.min(6, -Math.floor(Math.log10(steps.length > 1 ? steps[1] - steps[0] : 1) + 1e-9)));
    const large = steps.some((value) => Math.abs(value) >= 1e5);
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const value of steps) {
      const text = large && value ? value.toExponential(1).replace("e+", "e") : value.toFixed(digits);
      pen.fillText(text.replace("-", "−"), LEFT - 7, y(value));
      pen.beginPath();
      pen.moveTo(LEFT, Math.round(y(value)) + 0.5);
      pen.lineTo(box.width - RIGHT, Math.round(y(value)) + 0.5);
      pen.stroke();
    }
    pen.textBaseline = "alphabetic";
    const times = ticks(0, this.end, Math.max(2, Math.floor(box.width / 80)));
    times.forEach((t, k) => {
      const last = k === times.length - 1;
      pen.textAlign = last && x(t) > box.width - 24 ? "right" : "center";
      pen.fillText(`${+t.toPrecision(6)}${last ? " s" : ""}`, last ? Math.min(x(t), box.width - 2) : x(t), box.height - 5);
    });
  }

  /** Put the cursor at a time, and the values there, or where the mouse is, above. */
  move(time) {
    this.now = time;
    const place = (t) => `translateX(${(LEFT + (t / this.end) * (this.width - LEFT - RIGHT)).toFixed(1)}px)`;
    this.cursor.style.transform = place(time);
    this.pointer.style.display = this.hover === undefined ? "none" : "block";
    if (this.hover !== undefined) this.pointer.style.transform = place(this.hover);
    const at = this.hover ?? time;
    for (const { value, curve } of this.numbers) value.textContent = shown(valueAt(curve, at) / this.factor);
  }
}

/** The value of a curve between its points. */
function valueAt({ x, y }, t) {
  let [low, high] = [0, x.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle] <= t) low = middle;
    else high = middle;
  }
  const share = x[high] > x[low] ? Math.min(Math.max((t - x[low]) / (x[high] - x[low]), 0), 1) : 0;
  return (1 - share) * y[low] + share * y[high];
}
