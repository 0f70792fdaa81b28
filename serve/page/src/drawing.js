// The mechanism at every position, from the shapes of the book's drawing: metres, y upwards.

import { byId, h, label, s } from "./dom.js";
import { current, word } from "./words.js";

const LARGEST = [640, 400];
const MARGIN = [40, 34];
const LOAD = 34;

const along = ([x, y], [u, v]) => {
  const length = Math.hypot(u - x, v - y);
  return length > 1e-9 ? [(u - x) / length, (v - y) / length] : [0, -1];
};

// Points that must be in the picture.
function extent(mark) {
  switch (mark.kind) {
    case "body":
    case "path":
      return mark.points;
    case "line":
    case "arrow":
      return [mark.from, mark.to];
    case "handle":
    case "force":
    case "aside":
      return [];
    case "distance": {
      const [x, y] = along(mark.from, mark.to);
      return [mark.from, mark.to].map(([u, v]) => [u - y * mark.offset, v + x * mark.offset]);
    }
    default:
      return [mark.at];
  }
}

const marksAt = (drawn, row) => drawn.positions[row].map((mark) => (typeof mark === "number" ? drawn.still[mark] : mark));

// One frame for all positions, so that nothing but the mechanism moves; further points may have to be in it.
function frame(drawings, further = []) {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  const include = (point) => {
    for (const axis of [0, 1]) {
      low[axis] = Math.min(low[axis], point[axis]);
      high[axis] = Math.max(high[axis], point[axis]);
    }
  };
  for (const drawn of drawings) {
    for (const mark of [...drawn.still, ...drawn.positions.flat()]) {
      if (typeof mark !== "number") extent(mark).forEach(include);
    }
  }
  further.forEach(include);
  const size = [0, 1].map((axis) => Math.max(high[axis] - low[axis], 1e-6));
  const scale = Math.min(...[0, 1].map((axis) => (LARGEST[axis] - 2 * MARGIN[axis]) / size[axis]));
  return {
    scale,
    size: [0, 1].map((axis) => size[axis] * scale + 2 * MARGIN[axis]),
    world: ([u, v]) => [(u - MARGIN[0]) / scale + low[0], high[1] - (v - MARGIN[1]) / scale],
    place: ([x, y]) => [(x - low[0]) * scale + MARGIN[0], (high[1] - y) * scale + MARGIN[1]].map((v) => Math.round(v * 100) / 100),
  };
}

export const line = (points, properties) => s("polyline", { points: points.join(" "), ...properties });

export function head(from, tip) {
  const [x, y] = along(from, tip);
  const corner = (side) => [tip[0] - 9 * x - 2.6 * side * y, tip[1] - 9 * y + 2.6 * side * x];
  return s("polygon", { class: "head", points: [tip, corner(1), corner(-1)].join(" ") });
}

function support([x, y]) {
  const ground = y + 14;
  const hatches = [0, 1, 2, 3, 4, 5].map((i) => {
    const start = x - 11 + 4.4 * i;
    return line([[start, ground], [start - 4.4, ground + 5]], { class: "thin" });
  });
  const triangle = s("polygon", { class: "support", points: [[x, y], [x - 8, ground], [x + 8, ground]].join(" ") });
  return [triangle, line([[x - 13, ground], [x + 13, ground]], { class: "medium" }), ...hatches];
}

// The ends of a distance that is drawn beside its line.
function measured(from, to, offset) {
  const [x, y] = along(from, to);
  return [from, to].map(([u, v]) => [u + y * offset, v - x * offset]);
}

function drawn(mark, { place, scale }) {
  switch (mark.kind) {
    case "body": {
      const kind = mark.faint ? "faint" : mark.closed ? "body" : "bar";
      const points = mark.points.map(place).join(" ");
      return [s(mark.closed ? "polygon" : "polyline", { class: kind, points })];
    }
    case "pin": {
      const [cx, cy] = place(mark.at);
      const pin = s("circle", { class: mark.faint ? "faint" : "pin", cx, cy, r: mark.faint ? 2 : 3.4 });
      return [...(mark.fixed ? support([cx, cy]) : []), pin];
    }
    case "path":
      return [line(mark.points.map(place), { class: "path" })];
    case "line":
      return [line([place(mark.from), place(mark.to)], { class: "axis" })];
    case "arrow": {
      const [from, to] = [place(mark.from), place(mark.to)];
      return [line([from, to], { class: "thin" }), head(from, to)];
    }
    case "load": {
      const [x, y] = place(mark.at);
      return [line([[x, y + 3], [x, y + LOAD]], { class: "medium" }), head([x, y], [x, y + LOAD])];
    }
    case "distance": {
      const [from, to] = [place(mark.from), place(mark.to)];
      const [a, b] = measured(from, to, mark.offset * scale);
      return [
        line([from, a], { class: "thin" }),
        line([to, b], { class: "thin" }),
        line([a, b], { class: "thin" }),
        head(b, a),
        head(a, b),
      ];
    }
    case "angle": {
      const at = place(mark.at);
      const radius = mark.radius * scale;
      const on = (angle, r = radius) => [at[0] + r * Math.cos(angle), at[1] - r * Math.sin(angle)];
      const arc = Array.from({ length: 33 }, (_, i) => on(mark.from + ((mark.to - mark.from) * i) / 32));
      return [line([at, on(mark.from, radius + 12)], { class: "thin" }), line(arc, { class: "thin" }), head(arc[30], arc[32])];
    }
    default:
      return [];
  }
}

function named(mark, { place, scale }) {
  const beside = ([x, y], [dx, dy]) => ({ class: "name", x: x + dx, y: y + dy });
  switch (mark.kind) {
    case "label":
      return label(mark.text, beside(place(mark.at), [6, -7]));
    case "number":
      return label([[String(mark.number), "plain"]], { ...beside(place(mark.at), [0, 5]), "text-anchor": "middle" });
    case "load":
      return label(mark.text, beside(place(mark.at), [6, LOAD]));
    case "distance": {
      const [a, b] = measured(place(mark.from), place(mark.to), mark.offset * scale);
      return label(mark.text, beside([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], [4, -4]));
    }
    case "angle": {
      const middle = (mark.from + mark.to) / 2;
      const [x, y] = place(mark.at);
      const radius = mark.radius * scale + 12;
      return label(mark.text, { ...beside([x, y], [radius * Math.cos(middle), 4 - radius * Math.sin(middle)]), "text-anchor": "middle" });
    }
    default:
      return null;
  }
}

function group(marks, frame) {
  const names = marks.map((mark) => named(mark, frame)).filter(Boolean);
  return s("g", {}, ...marks.flatMap((mark) => drawn(mark, frame)), ...names);
}

const canvas = ({ size }) => s("svg", { viewBox: `0 0 ${size.join(" ")}`, role: "img", class: "mechanism" });

// A picture of one position.
export function picture(drawing, row = 0) {
  const own = frame([drawing]);
  const svg = canvas(own);
  svg.append(group(marksAt(drawing, row), own));
  return svg;
}

// Where the load hangs in a frame of a run: its head, and itself.
function hung(drawing, row, hangs) {
  const head = marksAt(drawing, row).find((mark) => mark.kind === "load")?.at;
  const [forward, up] = hangs?.[row] ?? [];
  return head && forward != null ? [head, [head[0] + forward, head[1] + up]] : null;
}

// The load on its rope, in place of the weight at the head.
function rope([head, load], frame) {
  const [x, y] = frame.place(load);
  return s("g", {}, line([frame.place(head), [x, y]], { class: "medium" }), s("rect", { class: "weight", x: x - 6, y, width: 12, height: 10 }));
}

// A drawing that moves: each position is built once, when it is first seen. Over it lie forces, and handles to drag by.
export class Drawing {
  constructor(host, handles, forces, seen) {
    Object.assign(this, { host, handles, forces, asides: byId("asides"), wanted: new Set() });
    this.seen = seen;
  }

  // What is shown where it is asked for: a box for each kind that the drawing has.
  choices() {
    const marks = [...this.drawing.still, ...this.drawing.positions.flat()];
    const kinds = new Set(marks.map((mark) => mark.of).filter(Boolean));
    const box = (of) => {
      const change = (event) => {
        if (event.target.checked) this.wanted.add(of);
        else this.wanted.delete(of);
        this.built.clear();
        this.seen();
      };
      const input = h("input", { type: "checkbox", id: `with-${of}`, checked: this.wanted.has(of), onchange: change });
      return h("label", { class: "field" }, input, " ", word(`page.${of}`));
    };
    if ([...kinds].join() === this.kinds && current() === this.language) return;
    [this.kinds, this.language] = [[...kinds].join(), current()];
    this.asides.replaceChildren(...[...kinds].map(box));
  }

  // Positions of the working range, with what varies over it; while something is dragged the frame stays.
  show(drawing, columns) {
    this.set(drawing, null, this.handles.held && !this.hangs ? this.frame : frame([drawing]));
    this.handles.loose = false;
    this.forces.take(drawing, columns, this.frame);
  }

  // Frames of a run, in which the load may hang from the head.
  play(drawing, hangs) {
    const loads = hangs.length ? drawing.positions.map((_, row) => hung(drawing, row, hangs)?.[1]).filter(Boolean) : [];
    this.set(drawing, hangs, frame([drawing], loads));
    this.forces.take(null);
  }

  set(drawing, hangs, frame) {
    Object.assign(this, { drawing, hangs, frame, built: new Map() });
    if (!this.svg) {
      // Once: what is put in again loses the focus.
      this.moves = s("g");
      this.svg = canvas(frame);
      this.svg.append(this.moves, this.forces.layer, this.handles.layer);
      this.host.prepend(this.svg);
    }
    this.svg.setAttribute("viewBox", `0 0 ${frame.size.join(" ")}`);
    this.choices();
  }

  build(row) {
    const load = hung(this.drawing, row, this.hangs);
    const asked = (mark) => (mark.kind === "aside" ? (this.wanted.has(mark.of) ? [mark.mark] : []) : [mark]);
    const marks = marksAt(this.drawing, row)
      .filter((mark) => !(load && mark.kind === "load"))
      .flatMap(asked);
    const all = group(marks, this.frame);
    if (load) all.append(rope(load, this.frame));
    return all;
  }

  at(row, says) {
    if (!this.built.has(row)) this.built.set(row, this.build(row));
    this.moves.replaceChildren(this.built.get(row));
    this.svg.setAttribute("aria-label", says);
    const marks = marksAt(this.drawing, row);
    this.forces.at(marks, row);
    this.handles.at(this.hangs ? [] : marks, this);
  }
}

// The crane from above in a frame of a run: the boom, and the load beside its head.
export function above(drawing, run, row) {
  const at = (row) => {
    const marks = marksAt(drawing, row);
    const axis = marks.find((mark) => mark.kind === "line" && mark.from[0] === mark.to[0])?.from[0] ?? 0;
    const reach = (marks.find((mark) => mark.kind === "load")?.at[0] ?? axis) - axis;
    const [forward, , left] = run.hangs[row] ?? [0, 0, 0];
    return { reach, load: [reach + forward, left] };
  };
  const far = Math.max(...run.slewed.map((_, row) => Math.hypot(...at(row).load)), 1e-6);
  const [middle, scale] = [80, 66 / far];
  const angle = run.slewed[row];
  const turned = ([x, y]) => {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    return [middle + scale * (x * cos - y * sin), middle - scale * (x * sin + y * cos)];
  };
  const { reach, load } = at(row);
  const [cx, cy] = turned(load);
  return s(
    "svg",
    { viewBox: "0 0 160 160", class: "mechanism above", "aria-hidden": "true" },
    s("circle", { class: "faint", cx: middle, cy: middle, r: scale * far }),
    line([[middle - 72, middle], [middle + 72, middle]], { class: "axis" }),
    line([[middle, middle], turned([reach, 0])], { class: "bar" }),
    line([turned([reach, 0]), [cx, cy]], { class: "thin" }),
    s("circle", { class: "pin", cx: middle, cy: middle, r: 3.4 }),
    s("circle", { class: "weight", cx, cy, r: 4 }),
  );
}
