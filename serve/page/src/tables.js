// Requirements and governing results, and all results at one position.

import { h, script } from "./dom.js";
import { number, word } from "./words.js";

const cell = (tag, ...children) => h(tag, {}, ...children);
const head = (...names) => h("thead", {}, h("tr", {}, ...names.map((name) => h("th", { scope: "col" }, name))));

const button = (onclick, ...children) => h("button", { type: "button", class: "plain", onclick }, ...children);

// A quantity with its value and where it is so, what it is, and the way to its formula.
function line({ symbol, of, label }, value, asked, ...rest) {
  const name = script(symbol);
  const curve = of ? button(() => asked.curve(of), name) : name;
  return h("div", { class: "line" }, h("span", {}, curve, " = ", value), ...rest, button(() => asked.formula(label), word("page.formula")));
}

function requirements(list, asked) {
  const row = (one) => {
    const { sentence, value, limit, passed, verdict, utilisation, old } = one;
    const used = h("span", {}, utilisation ? `${utilisation} % ` : "", h("strong", {}, script(verdict)));
    const both = h("span", {}, script(value), " ", script(limit));
    return h("li", { class: `${passed ? "kept" : "broken"}${old ? " old" : ""}` }, h("div", {}, script(sentence)), line(one, both, asked, used));
  };
  return h("ul", { class: "results" }, ...list.map(row));
}

function results(list, asked) {
  const row = (one) =>
    h("li", {}, line(one, script(one.value), asked, h("span", {}, script(one.at))), h("div", { class: "quiet" }, script(one.text)));
  return h("ul", { class: "results" }, ...list.map(row));
}

// Results of which runs in time are still awaited, with those of the design before in their places.
export function expecting(next, before) {
  if (!next.awaits_runs || before?.name !== next.name || before.language !== next.language) return next;
  const key = ({ sentence, of }) => JSON.stringify([sentence, of]);
  const kept = (list) => {
    const known = new Set(next[list].map(key));
    const gone = before[list].filter((one) => !known.has(key(one)));
    return [...next[list], ...gone.map((one) => ({ ...one, old: true }))];
  };
  return { ...next, requirements: kept("requirements"), identities: kept("identities"), expected: before.warnings };
}

// What is always in view; `asked` takes the name of a result whose `curve` is wanted, the label of one whose `formula` is.
export function verdict(host, shown, asked) {
  const part = (title, ...content) => [h("h2", {}, title), ...content];
  // What someone has unfolded stays so.
  const before = new Set([...host.querySelectorAll("details[open]")].map(({ id }) => id));
  const folded = (id, title, open, content) => h("details", { id, open: open || before.has(id) }, h("summary", {}, title), content);
  const broken = shown.requirements.some(({ passed, old }) => !passed && !old);
  const apart = shown.identities.some(({ passed }) => !passed);
  const awaited = shown.awaits_runs ? h("span", { class: "quiet awaited" }, ` (${word("page.awaits_runs")})`) : null;
  host.replaceChildren(
    ...part(word("caption.requirements"), h("p", { class: broken ? "broken" : "kept" }, script(shown.verdict), awaited)),
    ...(shown.requirements.length ? [requirements(shown.requirements, asked)] : []),
    ...shown.warnings.map((warning) => h("p", { class: "warning" }, script(warning))),
    ...(shown.expected ?? []).map((warning) => h("p", { class: "warning old" }, script(warning))),
    ...(shown.governing.length ? part(word("caption.governing"), results(shown.governing, asked)) : []),
    ...(shown.summary.length ? [folded("whole", word("caption.summary"), false, results(shown.summary, asked))] : []),
    ...(shown.identities.length ? [folded("identities", word("chapter.identities"), apart, requirements(shown.identities, asked))] : []),
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
        const near = coordinate.values.findIndex((x) => Math.abs(x - at) <= 1e-8 * Math.max(1, Math.abs(at)));
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
