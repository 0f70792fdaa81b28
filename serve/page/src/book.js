// The book's pages, when nothing newer has come for a moment (in ms): only changed ones are fetched, and an old page stays until the new one is there.

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

  // Of this text, soon: when nothing newer has come for a moment.
  want(text, level) {
    const wanted = JSON.stringify([text, level, current()]);
    if (wanted === this.wanted) return;
    this.wanted = wanted;
    this.places = null;
    clearTimeout(this.timer);
    this.controller?.abort();
    this.timer = setTimeout(() => this.make(text, level), PAUSE);
  }

  async make(text, level) {
    const controller = (this.controller = new AbortController());
    this.state.textContent = word("page.making");
    try {
      const reply = await ask("book", { text, level, language: current() }, controller.signal);
      const { sheets, places } = await reply.json();
      await this.show(sheets);
      this.state.textContent = "";
      this.places = places;
      this.turn();
    } catch (error) {
      if (controller.signal.aborted) return;
      this.wanted = null;
      this.state.textContent = error.message;
    }
  }

  async show(sheets) {
    const old = [...this.host.children];
    old.slice(sheets.length).forEach((page) => page.remove());
    const swaps = sheets.map(async ({ hash, width, height }, i) => {
      if (old[i]?.dataset.hash === hash) return;
      const alt = word("page.page_of", { page: i + 1, count: sheets.length });
      const page = h("img", { "data-hash": hash, width: Math.round(width), height: Math.round(height), alt });
      const inView = old[i] && old[i].getBoundingClientRect().top < innerHeight && old[i].getBoundingClientRect().bottom > 0;
      if (!inView) page.loading = "lazy";
      page.src = pageOfBook(hash);
      if (inView) await page.decode().catch(() => {});
      if (old[i]) old[i].replaceWith(page);
      else this.host.append(page);
    });
    await Promise.all(swaps);
  }
}
