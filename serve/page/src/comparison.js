// Designs side by side: what differs in what they say, what comes out, and what is kept.

import { h, plain, script } from "./dom.js";
import { word } from "./words.js";

// Rows of which not all designs say the same.
function differing(designs, list) {
  const rows = new Map();
  designs.forEach((design, i) => {
    for (const { id, title, value, broken } of list(design.shown)) {
      if (!rows.has(id)) rows.set(id, { title, cells: designs.map(() => null) });
      rows.get(id).cells[i] = { value, broken };
    }
  });
  const same = ({ cells }) => cells.every((cell) => cell && plain(cell.value) === plain(cells[0]?.value));
  return [...rows.values()].filter((row) => !same(row));
}

const given = (shown) => shown.given.map(({ key, text }) => ({ id: key, title: [[key, "plain"]], value: [[text, "plain"]] }));
const results = (shown) =>
  [...shown.governing, ...shown.summary].map((line) => ({
    id: line.name,
    title: [...line.symbol, [", ", "plain"], ...line.text],
    value: line.value,
  }));
const checks = (shown) =>
  shown.requirements.map((check) => ({
    id: plain(check.sentence),
    title: check.sentence,
    value: [...check.verdict, [check.utilisation ? `, ${check.utilisation} %` : "", "plain"]],
    broken: !check.passed,
  }));

export function compare(host, designs, forget) {
  if (designs.length < 2) {
    host.replaceChildren(h("p", {}, word("page.nothing_kept")));
    return;
  }
  const column = ({ label }, i) =>
    h(
      "th",
      { scope: "col" },
      h("span", { class: `key line-${i + 1}`, "aria-hidden": "true" }, i ? "╌╌" : "━━"),
      " ",
      label,
      i ? h("button", { type: "button", class: "plain", "aria-label": word("page.forget", { name: label }), onclick: () => forget(i - 1) }, " ×") : null,
    );
  const part = (title, list) => {
    const rows = differing(designs, list);
    if (!rows.length) return [];
    const cells = (row) => row.cells.map((cell) => h("td", { class: cell?.broken ? "broken" : null }, cell ? script(cell.value) : "–"));
    return [
      h("tr", { class: "part" }, h("th", { colspan: designs.length + 1, scope: "colgroup" }, title)),
      ...rows.map((row) => h("tr", {}, h("th", { scope: "row" }, script(row.title)), ...cells(row))),
    ];
  };
  const body = [
    ...part(word("chapter.inputs"), given),
    ...part(word("caption.requirements"), checks),
    ...part(word("page.results"), results),
  ];
  const empty = body.length ? [] : [h("p", {}, word("page.no_difference"))];
  const table = h("table", {}, h("thead", {}, h("tr", {}, h("td", {}), ...designs.map(column))), h("tbody", {}, ...body));
  host.replaceChildren(table, ...empty);
}

