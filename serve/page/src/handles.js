// Points of the drawing that one may drag: each sets one or two numbers of the scene's text.

import { plain, s } from "./dom.js";
import { word } from "./words.js";

// How far an arrow key moves one, in the drawing's own units; with Shift ten times as far.
const STEP = 1;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// What a number is when its point lies there: m or rad.
function value({ by, from, direction, zero }, [x, y], now) {
  const [u, v] = [x - from[0], y - from[1]];
  if (by === "distance") return Math.hypot(u, v);
  if (by === "along") return u * direction[0] + v * direction[1];
  const angle = Math.atan2(v, u) - zero;
  return angle + 2 * Math.PI * Math.round((now - angle) / (2 * Math.PI));
}

export class Handles {
  // Where the text may be read and changed.
  constructor(editor) {
    this.editor = editor;
    this.layer = s("g", { class: "handles" });
    this.circles = [];
  }

  // The text has changed otherwise: where the numbers stand is known again with what it gives.
  release() {
    this.loose = true;
  }

  at(marks, drawing) {
    this.drawing = drawing;
    this.marks = marks.filter((mark) => mark.kind === "handle");
    while (this.circles.length > this.marks.length) this.circles.pop().remove();
    while (this.circles.length < this.marks.length) this.circles.push(this.circle(this.circles.length));
    this.marks.forEach((mark, i) => {
      if (this.held !== this.circles[i]) this.put(this.circles[i], mark);
    });
  }

  put(circle, { at, sets }) {
    const [cx, cy] = this.drawing.frame.place(at);
    circle.setAttribute("cx", cx);
    circle.setAttribute("cy", cy);
    const names = sets.map(({ number }) => plain(this.drawing.drawing.numbers[number].symbol));
    circle.setAttribute("aria-label", word("page.drag", { keys: names.join(", ") }));
  }

  circle(i) {
    const circle = s("circle", { class: "handle", r: 9, tabindex: 0, role: "button" });
    circle.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      circle.focus();
      circle.setPointerCapture(event.pointerId);
      this.held = circle;
    });
    circle.addEventListener("pointermove", (event) => {
      if (this.held !== circle) return;
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.layer.getScreenCTM().inverse());
      circle.setAttribute("cx", x);
      circle.setAttribute("cy", y);
      this.move(i, this.drawing.frame.world([x, y]));
    });
    const let_go = () => {
      if (this.held !== circle) return;
      this.held = undefined;
      this.put(circle, this.marks[i]);
    };
    circle.addEventListener("pointerup", let_go);
    circle.addEventListener("pointercancel", let_go);
    circle.addEventListener("keydown", (event) => {
      const way = ARROWS[event.key];
      if (!way) return;
      event.preventDefault();
      const [x, y] = this.drawing.frame.place(this.marks[i].at);
      const far = event.shiftKey ? 10 * STEP : STEP;
      this.move(i, this.drawing.frame.world([x + far * way[0], y + far * way[1]]));
    });
    this.layer.append(circle);
    return circle;
  }

  // Writes what the numbers are when this handle lies there, with as many decimals as can be seen.
  move(i, point) {
    if (this.loose) return;
    const { numbers } = this.drawing.drawing;
    const text = this.editor.text;
    const changes = this.marks[i].sets.map((set) => {
      const number = numbers[set.number];
      const [from, to] = number.utf16;
      const written = value(set, point, Number.parseFloat(text.slice(from, to)) * number.factor) / number.factor;
      const far = set.by === "direction" ? Math.hypot(point[0] - set.from[0], point[1] - set.from[1]) : 1;
      const seen = 1 / (this.drawing.frame.scale * number.factor * Math.max(far, 1e-6));
      const decimals = Math.min(Math.max(number.decimals, Math.ceil(-Math.log10(seen))), 8);
      const fixed = written.toFixed(decimals);
      return { number, from, to, insert: `${Number(fixed) === 0 ? fixed.replace("-", "") : fixed} ${number.unit}` };
    });
    this.marks[i] = { ...this.marks[i], at: point };
    this.editor.change(changes.map(({ from, to, insert }) => ({ from, to, insert })));
    for (const { number, from, to, insert } of changes) {
      const longer = insert.length - (to - from);
      number.utf16 = [number.utf16[0], number.utf16[1] + longer];
      for (const other of numbers) {
        if (other.utf16[0] > number.utf16[0]) other.utf16 = other.utf16.map((at) => at + longer);
      }
    }
    this.loose = false;
  }
}
