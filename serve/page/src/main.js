// The page: a text, what it gives at every keystroke, and what can be done with it.

import "uplot/dist/uPlot.min.css";
import "./page.css";

import { Refused, ask, newest, told } from "./ask.js";
import { Book } from "./book.js";
import { compare } from "./comparison.js";
import { Curves } from "./curves.js";
import { byId, h, plain, script } from "./dom.js";
import { Drawing } from "./drawing.js";
import { Editor } from "./editor.js";
import { Forces } from "./forces.js";
import { Gallery } from "./gallery.js";
import { Handles } from "./handles.js";
import { Player } from "./player.js";
import { Runs } from "./runs.js";
import { Scenes } from "./scenes.js";
import { Table, expecting, verdict } from "./tables.js";
import { Tabs } from "./tabs.js";
import { current, measured, speak, word } from "./words.js";
import { Work } from "./work.js";

// Curves that are shown until others are chosen, and designs beside the one that is edited.
const CURVES = 3;
const KEPT = 4;

const page = crypto.getRandomValues(new Uint32Array(1))[0];
let edit = 0;
let shown = null;
// The last one with its runs in time.
let ended = null;
let chosen = null;
let kept = [];
// The run that is in view, if one is.
let seen = null;

// A screen reader reads what has changed.
const say = (text) => {
  if (byId("notice").textContent !== text) byId("notice").textContent = text;
};

const table = new Table(byId("table"));
const player = new Player(at);
const curves = new Curves(byId("charts"), (row) => player.set(row));
const book = new Book(byId("pages"));
const tabs = new Tabs(byId("tabs"), refresh);
const editor = new Editor(byId("editor"), () => {
  handles.release();
  book.note();
  scenes.changed(editor.text);
  answer();
});
const handles = new Handles(editor);
const drawing = new Drawing(byId("drawing"), handles, new Forces(), () => at(player.row));
const runs = new Runs(view, (error) => failed(error));
const scenes = new Scenes(editor, say, () => answer());
const gallery = new Gallery((id) => scenes.show(id).catch(failed));

const failed = (error) => say(error.message);
new Work(design, beside, failed);

// What a text gives, unless a newer one is there: that is asked for next.
async function found(asked, then) {
  try {
    const answer = await told("answer", { language: current(), page, ...asked });
    if (asked.text === editor.text && asked.edit === edit) then(answer);
  } catch (error) {
    if (!(error instanceof Refused && error.status === 409)) failed(error);
  }
}

// At once all but runs in time, then these.
const answer = newest(async () => {
  edit += 1;
  const asked = { text: editor.text, edit };
  await found({ ...asked, at_rest: true }, (first) => {
    tell(first);
    if (first.shown?.awaits_runs) whole(asked);
  });
});
const whole = newest((asked) => found(asked, complete));

function tell({ diagnostics, shown: next }) {
  byId("stale").hidden = Boolean(next);
  byId("stage").classList.toggle("old", !next);
  byId("verdict").classList.toggle("old", !next);
  if (next) show(next);
  editor.mark(diagnostics);
  mistakes(diagnostics);
}

function mistakes(list) {
  const item = (mistake) => {
    const { fix, message, help, line, utf16 } = mistake;
    const go = h("button", { type: "button", class: "plain", onclick: () => editor.go(utf16[0]) }, `${word("head.line")} ${line}: ${message}`);
    const mend = fix && h("button", { type: "button", class: "fix", onclick: () => editor.apply(fix) }, word("page.fix", { text: fix.text }));
    return h("li", {}, go, help ? h("span", { class: "quiet" }, " ", help) : null, mend ? " " : null, mend || null);
  };
  const state = list.length ? word("page.mistakes", { count: list.length }) : word("page.no_mistakes");
  byId("mistakes").replaceChildren(h("p", { class: list.length ? "broken" : "kept" }, state), h("ul", {}, ...list.map(item)));
}

function show(next) {
  const before = shown;
  shown = next;
  if (!shown.awaits_runs) ended = shown;
  byId("title").textContent = shown.title;
  document.title = `${shown.title} – Lemnis`;
  verdict(byId("verdict"), expecting(shown, ended), { curve: choose, formula });
  if (!before || before.name !== shown.name || !chosen?.size) chosen = new Set(usual());
  if (byId("choice").open) choice();
  runs.of(editor.text, shown.runs);
  view(before);
}

// With runs in time what stands in view stays.
function complete({ shown: next }) {
  if (!next) return;
  const before = shown;
  shown = ended = next;
  for (const design of kept) if (design.shown === before) design.shown = shown;
  verdict(byId("verdict"), shown, { curve: choose, formula });
  if (shown.runs !== before.runs) runs.of(editor.text, shown.runs);
  if (tabs.current === "comparison") refresh();
}

// The working range, or a run that was chosen.
function view(before = shown) {
  const { run } = runs;
  if (run) {
    drawing.play(run.drawing, run.hangs);
    const frames = run.time.texts.length;
    player.range(frames, seen === run.name ? null : 0, frames * run.step);
  } else {
    drawing.show(shown.drawing, shown.columns);
    const rows = shown.columns[0].values.length;
    player.range(rows, before && !seen ? null : Math.floor(rows / 2));
  }
  seen = run && run.name;
  refresh();
}

// Results that govern somewhere, before others.
function usual() {
  const known = new Set(shown.columns.slice(1).map(({ name }) => name));
  const wanted = [...shown.requirements, ...shown.governing].map(({ of }) => of);
  return [...new Set([...wanted, ...known])].filter((name) => known.has(name)).slice(0, CURVES);
}

function choice() {
  const box = (column) => {
    const change = (event) => {
      if (event.target.checked) chosen.add(column.name);
      else chosen.delete(column.name);
      refresh();
    };
    const input = h("input", { type: "checkbox", value: column.name, onchange: change });
    input.checked = chosen.has(column.name);
    return h("label", {}, input, " ", script(column.symbol), " ", h("span", { class: "quiet" }, script(column.text)));
  };
  const boxes = shown.columns.slice(1).map(box);
  const find = (event) => {
    const wanted = event.target.value.toLowerCase();
    boxes.forEach((box) => {
      box.hidden = !box.textContent.toLowerCase().includes(wanted);
    });
  };
  byId("choice").lastElementChild.replaceChildren(
    h("input", { type: "search", "aria-label": word("page.search"), placeholder: word("page.search"), oninput: find }),
    ...boxes,
  );
}

// The curve of a result that someone points at.
function choose(name) {
  if (!shown.columns.some((column) => column.name === name)) return;
  chosen = new Set([name, ...chosen]);
  tabs.select("curves");
}

// The page of the book with a result's formula.
function formula(label) {
  tabs.select("book");
  book.open(label);
}

const designs = () => [{ label: word("page.this_design"), shown }, ...kept];

// What only the tab in view needs.
function refresh() {
  if (!shown) return;
  if (tabs.current === "curves") curves.show(designs(), chosen);
  if (tabs.current === "table") table.show(shown);
  if (tabs.current === "book") book.want(editor.text, byId("level").value);
  if (tabs.current === "comparison") compare(byId("comparison"), designs(), forget);
  at(player.row);
}

function at(row) {
  if (!shown) return;
  const { run } = runs;
  const places = run ? [run.time, run.coordinate] : [shown.columns[0]];
  const told = places.map(({ symbol, unit, texts }) => [symbol, ` = ${measured(texts[row], unit)}`]);
  const place = told.map(([symbol, value]) => plain(symbol) + value).join(", ");
  byId("place").replaceChildren(...told.flatMap(([symbol, value], i) => [i ? ", " : "", script(symbol), value]));
  byId("position").setAttribute("aria-valuetext", place);
  drawing.at(row, `${shown.title}, ${place}`);
  runs.at(row);
  if (run) return;
  if (tabs.current === "curves") curves.at(row);
  if (tabs.current === "table") table.at(row);
}

function design() {
  return { text: editor.text, shown };
}

function keep(one) {
  if (!one.shown) return;
  kept = [...kept, { label: `${one.shown.title} (${kept.length + 1})`, ...one }].slice(-KEPT);
  say(word("page.kept"));
  refresh();
}

// A scene that was found, with the one that it came of beside it.
function beside(text, origin) {
  keep(origin);
  scenes.add(text).then(() => say(word("page.found"))).catch(failed);
}

function forget(place) {
  kept = kept.filter((_, i) => i !== place);
  refresh();
}

async function make(what) {
  byId("downloads").open = false;
  const name = `${shown?.name ?? "scene"}.${what}`;
  say(word("page.making"));
  const text = scenes.text();
  const bytes = what === "toml" ? new Blob([text]) : await (await ask("make", { text, what, language: current() })).blob();
  const link = h("a", { href: URL.createObjectURL(bytes), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60e3);
  say(word("page.made", { name }));
}

async function talk(languages, code) {
  speak(languages.find((language) => language.code === code));
  editor.speak();
  player.speak();
  const level = byId("level").value;
  const levels = ["", "summary", "standard", "full"];
  byId("level").replaceChildren(...levels.map((id) => h("option", { value: id }, id ? word(`level.${id}`) : word("page.as_scene"))));
  byId("level").value = level;
  gallery.speak();
  const anew = kept.map(async (design) => ({ ...design, shown: (await told("answer", { text: design.text, language: code })).shown }));
  kept = await Promise.all(anew);
}

async function start() {
  const { languages, language, files, first } = await told("start");
  const select = byId("language");
  select.replaceChildren(...languages.map(({ code, words }) => h("option", { value: code, lang: code }, words.page.own_name)));
  select.value = language;
  select.addEventListener("change", () => talk(languages, select.value).then(answer).catch(failed));
  await talk(languages, language);
  byId("open-gallery").addEventListener("click", () => gallery.open().catch(failed));
  byId("keep").addEventListener("click", () => keep(design()));
  byId("forces").addEventListener("change", () => at(player.row));
  byId("level").addEventListener("change", refresh);
  byId("choice").addEventListener("toggle", () => byId("choice").open && shown && choice());
  for (const button of document.querySelectorAll("[data-make]")) {
    button.addEventListener("click", () => make(button.dataset.make).catch(failed));
  }
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", refresh);
  tabs.select("curves");
  scenes.list(files);
  await scenes.show(first);
}

start().catch(failed);
