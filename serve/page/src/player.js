// The slider and what plays it: rows are picked, nothing is asked of the program.

import { byId } from "./dom.js";
import { word } from "./words.js";

// How long the whole range takes, in ms; a run takes its own time, but for these limits.
const SWEEP = 5000;
const RUN = [3000, 30000];

export class Player {
  constructor(moved) {
    this.moved = moved;
    this.slider = byId("position");
    this.button = byId("play");
    this.slider.addEventListener("input", () => {
      this.stop();
      this.see();
    });
    this.button.addEventListener("click", () => (this.playing ? this.stop() : this.play()));
  }

  get row() {
    return Number(this.slider.value);
  }

  // Of so many rows, there and back; or frames of a run of a duration, in s. It stays where it is unless a row is given.
  range(rows, row, duration) {
    this.slider.max = rows - 1;
    this.sweep = duration == null ? SWEEP : Math.min(Math.max(1000 * duration, RUN[0]), RUN[1]);
    this.back = duration == null;
    if (row != null) this.slider.value = row;
  }

  set(row) {
    this.stop();
    this.slider.value = row;
    this.see();
  }

  // Once for each frame, however often the slider moves.
  see() {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = undefined;
      this.moved(this.row);
    });
  }

  play() {
    const last = Number(this.slider.max);
    const begun = performance.now() - (this.row / Math.max(last, 1)) * this.sweep;
    const step = (now) => {
      const part = ((now - begun) / this.sweep) % (this.back ? 2 : 1);
      this.slider.value = Math.round(last * (part < 1 ? part : 2 - part));
      this.moved(this.row);
      this.playing = requestAnimationFrame(step);
    };
    this.playing = requestAnimationFrame(step);
    this.speak();
  }

  stop() {
    cancelAnimationFrame(this.playing);
    this.playing = undefined;
    this.speak();
  }

  speak() {
    this.button.textContent = word(this.playing ? "page.pause" : "page.play");
    this.button.setAttribute("aria-pressed", Boolean(this.playing));
  }
}
