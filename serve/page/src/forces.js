// Forces of a position as arrows, all to one scale.

import { byId, s } from "./dom.js";
import { head, line } from "./drawing.js";
import { number } from "./words.js";

// The longest arrow, as a part of the drawing's shorter side.
const LONGEST = 0.3;

// The greatest of 1, 2, 5, 10 … that is not above a value.
function round(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [5, 2, 1].find((step) => step * power <= value * (1 + 1e-12)) * power;
}

export class Forces {
  constructor() {
    this.layer = s("g", { class: "forces" });
    this.box = byId("forces");
  }

  // What varies over the working range, or nothing.
  take(drawing, columns = [], frame) {
    const known = new Map(columns.map((column) => [column.name, column]));
    // Of results that this scene does not have nothing is shown.
    this.known = (mark) => mark.kind === "force" && mark.sum.every(([name]) => known.has(name));
    this.sum = (mark, row) => {
      const parts = mark.sum.map(([name, [x, y]]) => [x, y].map((part) => part * known.get(name).values[row]));
      return parts.reduce(([x, y], [u, v]) => [x + u, y + v]);
    };
    const rows = drawing?.positions ?? [];
    const every = rows.flatMap((marks, row) => {
      const placed = marks.map((mark) => (typeof mark === "number" ? drawing.still[mark] : mark));
      return placed.filter(this.known).map((mark) => Math.hypot(...this.sum(mark, row)));
    });
    this.most = Math.max(...every.filter(Number.isFinite), 0);
    this.frame = frame;
    this.unit = columns.find(({ name }) => rows[0]?.some((mark) => mark.sum?.[0][0] === name))?.unit ?? "kN";
    byId("with-forces").hidden = !this.most;
  }

  at(marks, row) {
    const shown = this.most && this.box.checked ? marks.filter(this.known) : [];
    if (!shown.length) {
      this.layer.replaceChildren();
      return;
    }
    const scale = (LONGEST * Math.min(...this.frame.size)) / this.most;
    const arrow = (mark) => {
      const [x, y] = this.sum(mark, row);
      const amount = Math.hypot(x, y);
      if (!(amount * scale > 3)) return [];
      const from = this.frame.place(mark.at);
      const tip = [from[0] + x * scale, from[1] - y * scale];
      const beside = { class: "name", x: tip[0] + 5, y: tip[1] + 4 };
      return [line([from, tip], { class: "force" }), head(from, tip), s("text", beside, number(Number(amount.toPrecision(3))))];
    };
    const told = round(this.most);
    const [x, y] = [12, this.frame.size[1] - 10];
    const measure = [
      line([[x, y], [x + told * scale, y]], { class: "force" }),
      s("text", { class: "name", x, y: y - 6 }, `${number(told)} ${this.unit}`),
    ];
    this.layer.replaceChildren(...shown.flatMap(arrow), ...measure);
  }
}
