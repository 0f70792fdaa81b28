// The scenes that are open. Texts stay while another scene is shown; a file is written only when it is asked for.

import { told } from "./ask.js";
import { byId, h } from "./dom.js";
import { word } from "./words.js";

// How often files are looked at while the page is seen, in ms.
const LOOK = 2000;

const lines = (text) => text.replaceAll("\r\n", "\n");

export class Scenes {
  constructor(editor, say, opened) {
    Object.assign(this, { editor, say, opened, known: new Map(), select: byId("scene"), button: byId("save") });
    const failed = (error) => say(error.message);
    this.select.addEventListener("change", () => this.show(this.select.value).catch(failed));
    this.button.addEventListener("click", () => this.save().catch(failed));
    addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key !== "s") return;
      event.preventDefault();
      this.save().catch(failed);
    });
    addEventListener("beforeunload", (event) => {
      if ([...this.known.values()].some((scene) => scene.writable && scene.text !== scene.saved)) event.preventDefault();
    });
    setInterval(() => document.visibilityState === "visible" && this.look().catch(() => {}), LOOK);
  }

  list(files) {
    this.files = files;
    files.forEach((name, i) => this.select.append(h("option", { value: i }, name)));
  }

  get scene() {
    return this.known.get(this.current);
  }

  async show(id) {
    if (!this.known.has(id)) {
      const { text, ...scene } = await told("open", { scene: id });
      const saved = lines(text);
      this.known.set(id, { ...scene, id, text: saved, saved, returns: text.includes("\r\n") });
    }
    if (![...this.select.options].some((option) => option.value === id)) {
      this.select.append(h("option", { value: id }, id));
    }
    this.select.value = id;
    this.current = id;
    this.editor.open(this.scene.text);
    this.state();
    this.opened();
  }

  // A scene that was found here, under its own name: no file has it.
  add(text) {
    const name = text.match(/^name\s*=\s*"([^"]*)"/m)?.[1] ?? "scene";
    let id = name;
    for (let i = 2; this.known.has(id); i += 1) id = `${name} (${i})`;
    const own = lines(text);
    this.known.set(id, { id, called: id, writable: false, text: own, saved: own, returns: false });
    return this.show(id);
  }

  changed(text) {
    this.scene.text = text;
    this.state();
  }

  state() {
    const { writable, text, saved } = this.scene;
    this.button.disabled = !writable || text === saved;
  }

  // As it would be in its file.
  text() {
    const { text, returns } = this.scene;
    return returns ? text.replaceAll("\n", "\r\n") : text;
  }

  async save() {
    const { scene } = this;
    if (!scene.writable) {
      this.say(word("page.read_only"));
      return;
    }
    const { id, text, hash } = scene;
    scene.hash = await told("save", { scene: id, text: this.text(), hash });
    scene.saved = text;
    this.state();
    this.say(word("page.saved", { name: scene.called }));
  }

  // Follows what other programs write, unless it was changed here too.
  async look() {
    const { scene } = this;
    if (!scene?.writable) return;
    const { text, hash } = await told("open", { scene: scene.id });
    if (hash === scene.hash || scene !== this.scene) return;
    if (scene.text !== scene.saved) {
      this.say(word("page.changed_elsewhere", { name: scene.called }));
      return;
    }
    scene.hash = hash;
    scene.text = scene.saved = lines(text);
    this.editor.open(scene.text);
    this.state();
    this.opened();
  }
}
