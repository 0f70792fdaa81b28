// The book's pages, when nothing was written for a moment (in ms): only changed ones are fetched, and an old page stays until the new one is there.

import { ask, pageOfBook } from "./ask.js";
import { byId, h } from "./dom.js";
import { current, word } from "./words.js";

const PAUSE = 150;

export class Book {
  constructor(host) {
    this.host = host;
    this.state = byId("book-state");
    this.wanted = null;
    this.label = null;
    this.places = null;
    this.written = 0;
  }

  // Something was written just now.
  note() {
    this.written = performance.now();
  }

  // Turns to where a symbol is given or has its formula, as soon as the book that is wanted is there.
  open(label) {
    this.label = label;
    this.turn();
  }

  turn() {
    if (this.label === null || this.places === null) return;
    const page = this.places[this.label];
    if (page === undefined) this.state.textContent = word("page.no_formula");
    else this.host.children[page - 1].scrollIntoView();
    this.label = null;
  }

  // Of this text, when nothing newer was written for a moment.
  want(text, level) {
    const wanted = JSON.stringify([text, level, current()]);
    if (wanted === this.wanted) return;
    this.wanted = wanted;
    this.places = null;
    clearTimeout(this.timer);
    this.controller?.abort();
    this.timer = setTimeout(() => this.make(text, level), this.written + PAUSE - performance.now());
  }

  async make(text, level) {
    const controller = (this.controller = new AbortController());
    this.state.textContent = word("page.making");
    try {
      const reply = await ask("book", { text, level, language: current() }, controller.signal);
      const { sheets, places } = await reply.json();
      const later = await this.show(sheets);
      this.state.textContent = "";
      this.places = places;
      this.turn();
      for (const put of later) {
        await painted();
        if (controller.signal.aborted) return;
        put();
      }
    } catch (error) {
      if (controller.signal.aborted) return;
      this.wanted = null;
      this.state.textContent = error.message;
    }
  }

  // The pages in view, and new ones; what puts each of the others in its place, which keeps the browser from painting
  // these, is returned.
  async show(sheets) {
    const old = [...this.host.children];
    old.slice(sheets.length).forEach((page) => page.remove());
    const swaps = [];
    const later = [];
    sheets.forEach(({ hash, width, height }, i) => {
      const before = old[i];
      if (before?.dataset.hash === hash) return;
      const alt = word("page.page_of", { page: i + 1, count: sheets.length });
      const page = h("img", { "data-hash": hash, width: Math.round(width), height: Math.round(height), alt });
      const put = () => {
        if (!isInView(before)) page.loading = "lazy";
        page.src = pageOfBook(hash);
        before.replaceWith(page);
      };
      if (!before) {
        page.loading = "lazy";
        page.src = pageOfBook(hash);
        this.host.append(page);
      } else if (isInView(before)) {
        page.src = pageOfBook(hash);
        swaps.push(page.decode().catch(() => {}).then(() => before.replaceWith(page)));
      } else later.push(put);
    });
    await Promise.all(swaps);
    return later;
  }
}

const isInView = (page) => {
  const { top, bottom } = page.getBoundingClientRect();
  return top < innerHeight && bottom > 0;
};

const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
