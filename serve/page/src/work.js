// Work that takes minutes: begun, watched and stopped from here.

import { pageOfBook, told } from "./ask.js";
import { byId, h } from "./dom.js";
import { current, word } from "./words.js";

// How often the program is asked how it stands, in ms.
const LOOK = 500;

export class Work {
  // `design` tells what it begins with; `found` takes a scene that was written, with the design that it came of, `failed` what
  // went wrong.
  constructor(design, found, failed) {
    Object.assign(this, { design, found, failed });
    for (const button of document.querySelectorAll("[data-begin]")) {
      button.addEventListener("click", () => this.begin(button.dataset.begin).catch((error) => this.ended({ printed: error.message, failed: true })));
    }
    byId("stop").addEventListener("click", () => told("stop", { task: this.task }).catch(failed));
  }

  state(running) {
    byId("stop").disabled = !running;
    for (const button of document.querySelectorAll("[data-begin]")) button.disabled = running;
    byId("progress").hidden = !running;
  }

  async begin(what) {
    byId("said").replaceChildren();
    this.state(true);
    this.origin = this.design();
    byId("progress").value = 0;
    const { task } = await told("begin", { what, text: this.origin.text, language: current() });
    this.task = task;
    for (;;) {
      const { percent, ended, picture } = await told("look", { task });
      byId("progress").value = percent;
      byId("progress").textContent = `${percent} %`;
      if (ended) {
        this.ended(ended, picture);
        return;
      }
      await new Promise((later) => setTimeout(later, LOOK));
    }
  }

  ended({ printed, failed, scene }, picture) {
    this.state(false);
    const shown = [h("pre", { class: failed ? "broken" : null }, printed)];
    if (picture) shown.push(h("img", { src: pageOfBook(picture.hash), width: picture.width, height: picture.height, alt: word("page.trade") }));
    if (scene) this.found(scene, this.origin);
    byId("said").replaceChildren(...shown);
  }
}
