// Requirements and governing results, and all results at one position.

import { h, script } from "./dom.js";
import { number, word } from "./words.js";

const cell = (tag, ...children) => h(tag, {}, ...children);
const head = (...names) => h("thead", {}, h("tr", {}, ...names.map((name) => h("th", { scope: "col" }, name))));

// A quantity with its value and where it is so, and what it is.
function line(symbol, of, value, chosen, ...rest) {
  const name = script(symbol);
  const button = of ? h("button", { type: "button", class: "plain", onclick: () => chosen(of) }, name) : name;
  return h("div", { class: "line" }, h("span", {}, button, " = ", value), ...rest);
}

function requirements(list, chosen) {
  const row = ({ sentence, symbol, of, value, limit, passed, verdict, utilisation }) => {
    const used = h("span", {}, utilisation ? `${utilisation} % ` : "", h("strong", {}, script(verdict)));
    const both = h("span", {}, script(value), " ", script(limit));
    return h("li", { class: passed ? "kept" : "broken" }, h("div", {}, script(sentence)), line(symbol, of, both, chosen, used));
  };
  return h("ul", { class: "results" }, ...list.map(row));
}

function results(list, chosen) {
  const row = ({ symbol, of, text, value, at }) =>
    h("li", {}, line(symbol, of, script(value), chosen, h("span", {}, script(at))), h("div", { class: "quiet" }, script(text)));
  return h("ul", { class: "results" }, ...list.map(row));
}

// What is always in view; `chosen` takes the name of a result whose curve is wanted.
export function verdict(host, shown, chosen) {
  const part = (title, ...content) => [h("h2", {}, title), ...content];
  // What someone has unfolded stays so.
  const before = new Set([...host.querySelectorAll("details[open]")].map(({ id }) => id));
  const folded = (id, title, open, content) => h("details", { id, open: open || before.has(id) }, h("summary", {}, title), content);
  const broken = shown.requirements.some(({ passed }) => !passed);
  const apart = shown.identities.some(({ passed }) => !passed);
  host.replaceChildren(
    ...part(word("caption.requirements"), h("p", { class: broken ? "broken" : "kept" }, script(shown.verdict))),
    ...(shown.requirements.length ? [requirements(shown.requirements, chosen)] : []),
    ...shown.warnings.map((warning) => h("p", { class: "warning" }, script(warning))),
    ...(shown.governing.length ? part(word("caption.governing"), results(shown.governing, chosen)) : []),
    ...(shown.summary.length ? [folded("whole", word("caption.summary"), false, results(shown.summary, chosen))] : []),
    ...(shown.identities.length ? [folded("identities", word("chapter.identities"), apart, requirements(shown.identities, chosen))] : []),
  );
}

// Every result at the slider's position.
export class Table {
  constructor(host) {
    this.host = host;
  }

  show(shown) {
    const [coordinate] = shown.columns;
    this.cells = [];
    const any = shown.published.length > 0;
    const row = (column) => {
      const value = h("td", { class: "number" });
      const known = new Map();
      for (const { name, at, value } of shown.published) {
        const near = coordinate.values.findIndex((x) => Math.abs(x - at) <= 1e-9 * Math.max(1, Math.abs(at)));
        if (name === column.name && near >= 0) known.set(near, number(value));
      }
      const published = any ? h("td", { class: "number" }) : null;
      this.cells.push({ value, published, known, texts: column.texts });
      return h("tr", {}, h("th", { scope: "row" }, script(column.symbol)), value, published, cell("td", column.unit), cell("td", script(column.text)));
    };
    const names = [word("head.symbol"), word("head.value"), ...(any ? [word("head.published")] : []), word("head.unit"), word("head.meaning")];
    this.host.replaceChildren(h("table", {}, head(...names), h("tbody", {}, ...shown.columns.map(row))));
  }

  at(row) {
    for (const { value, published, known, texts } of this.cells) {
      value.textContent = texts[row];
      if (published) published.textContent = known.get(row) ?? "";
    }
  }
}
