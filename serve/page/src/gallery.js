// The ready scenes, each with its drawing.

import { told } from "./ask.js";
import { byId, h } from "./dom.js";
import { picture } from "./drawing.js";
import { current } from "./words.js";

export class Gallery {
  constructor(chosen) {
    this.chosen = chosen;
    this.dialog = byId("gallery");
    byId("close-gallery").addEventListener("click", () => this.dialog.close());
  }

  // In another language it is asked for again.
  speak() {
    byId("cards").replaceChildren();
  }

  async open() {
    this.dialog.showModal();
    const cards = byId("cards");
    if (cards.childElementCount) return;
    const ready = await told("gallery", { language: current() });
    cards.replaceChildren(...ready.map((scene) => this.card(scene)));
  }

  card({ id, title, drawing }) {
    const open = () => {
      this.dialog.close();
      this.chosen(id);
    };
    const svg = picture(drawing);
    svg.setAttribute("aria-hidden", "true");
    return h("button", { type: "button", class: "card", "data-scene": id, onclick: open }, svg, h("span", {}, title));
  }
}
