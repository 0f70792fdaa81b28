// Runs in time: each is asked for when it is to be seen, and played frame by frame.

import { newest, told } from "./ask.js";
import { byId, h, plain } from "./dom.js";
import { above } from "./drawing.js";
import { current, word } from "./words.js";

export class Runs {
  // `changed` is called when another one, or none, is to be seen, `failed` with what went wrong.
  constructor(changed, failed) {
    this.changed = changed;
    this.select = byId("run");
    this.plan = byId("plan");
    this.list = [];
    this.run = null;
    this.select.addEventListener("change", () => this.want());
    this.ask = newest(async (text) => {
      const { asked } = this;
      try {
        this.list = await told("runs", { text, language: current() });
        this.listed = asked;
        this.fill();
        this.take();
      } catch (error) {
        failed(error);
      }
    });
  }

  // What the list is of: a text, in a language.
  get asked() {
    return `${current()} ${this.text}`;
  }

  // Of a text that gives runs, or not.
  of(text, any) {
    this.text = text;
    byId("with-runs").hidden = !any;
    if (!any) this.select.value = "";
    if (this.select.value === "") {
      this.run = null;
      // Of another text they may have other names.
      if (this.listed !== this.asked) this.list = [];
    }
    this.fill();
    if (this.select.value !== "") this.want();
  }

  want() {
    if (this.select.value === "" || this.listed === this.asked) this.take();
    else this.ask(this.text);
  }

  // What is chosen is seen from now on.
  take() {
    this.run = this.select.value === "" ? null : (this.list[this.select.value] ?? null);
    this.changed();
  }

  // Its names are known with the first that is wanted.
  fill() {
    const chosen = this.select.value;
    const names = this.list.length ? this.list.map((run) => plain(run.name)) : [word("page.in_time")];
    const option = (name, i) => h("option", { value: i }, name);
    this.select.replaceChildren(h("option", { value: "" }, word("page.working_range")), ...names.map(option));
    this.select.value = chosen in names ? chosen : "";
  }

  at(row) {
    const { run } = this;
    const slews = run?.slewed.length;
    this.plan.hidden = !slews;
    if (slews) this.plan.replaceChildren(above(run.drawing, run, row));
  }
}
