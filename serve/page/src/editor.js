// The scene's text: colours, completion, hover, and what is wrong at its place with its help.

import { acceptCompletion, autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, bracketMatching, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { diagnosticCount, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, hoverTooltip, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";

import { told } from "./ask.js";
import { h, script } from "./dom.js";
import { current, word } from "./words.js";

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--quiet)", fontStyle: "italic" },
  { tag: [tags.propertyName, tags.atom], color: "var(--key)" },
  { tag: tags.string, color: "var(--string)" },
  { tag: [tags.number, tags.bool], color: "var(--number)" },
  { tag: [tags.bracket, tags.heading, tags.typeName], color: "var(--accent)" },
]);

const look = (dark) =>
  EditorView.theme(
    {
      "&": { height: "100%", color: "var(--text)", backgroundColor: "var(--paper)", fontSize: "13px" },
      "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
      ".cm-scroller": { fontFamily: "ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, monospace", lineHeight: "1.45" },
      ".cm-content": { caretColor: "var(--text)" },
      ".cm-gutters": { backgroundColor: "var(--ground)", color: "var(--quiet)", borderRight: "1px solid var(--rule)" },
      ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--band)" },
      ".cm-tooltip": { backgroundColor: "var(--paper)", color: "var(--text)", border: "1px solid var(--rule)", maxWidth: "34em" },
      ".cm-tooltip .about": { padding: "6px 10px", maxWidth: "30em" },
      ".cm-tooltip .about p": { margin: "2px 0" },
      ".cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--paper)" },
      // Without the pictures of its own that the policy does not let through.
      ".cm-lintRange-error": { backgroundImage: "none", textDecoration: "underline wavy var(--bad)", textUnderlineOffset: "3px" },
      ".cm-panels": { backgroundColor: "var(--ground)", color: "var(--text)" },
      ".cm-diagnosticAction": { backgroundColor: "var(--accent)", color: "var(--paper)", borderRadius: "3px" },
      ".help": { color: "var(--quiet)" },
    },
    { dark },
  );

// What a key is, for a person.
function about(found) {
  const line = (label, ...parts) => h("p", {}, h("span", { class: "help" }, `${label}: `), ...parts);
  const range = found.range && `${found.range.join(" … ")} ${found.unit ?? ""}`;
  return h(
    "div",
    { class: "about" },
    found.path && h("p", {}, h("code", {}, found.path)),
    h("p", {}, found.symbol && script(found.symbol), found.symbol && ", ", found.text),
    found.required ? h("p", { class: "help" }, word("page.required")) : null,
    found.unit ? line(word("head.unit"), found.unit) : null,
    range ? line(word("page.range"), range) : null,
    found.usual ? line(word("page.usual"), `${found.usual} ${found.unit ?? ""}`) : null,
    found.choices.length ? line(word("page.choices"), found.choices.join(", ")) : null,
    found.source ? line(word("head.source"), found.source) : null,
  );
}

function option(offer, context) {
  const { from, to } = { from: offer.change.utf16[0], to: offer.change.utf16[1] };
  // What follows the caret and goes too, such as a closing quote.
  const behind = Math.max(0, to - context.pos);
  return {
    label: offer.label,
    detail: offer.unit ?? "",
    info: () => about(offer),
    apply: (view, _, start, end) => {
      view.dispatch({
        changes: { from: start, to: Math.min(end + behind, view.state.doc.length), insert: offer.change.text },
        selection: { anchor: start + offer.change.caret },
        userEvent: "input.complete",
      });
    },
    from,
  };
}

async function complete(context) {
  const line = context.state.doc.lineAt(context.pos);
  const before = line.text.slice(0, context.pos - line.from);
  if (!context.explicit && !/[\w.[="]\s?$/.test(before)) return null;
  const asked = { text: context.state.doc.toString(), at: context.pos, language: current() };
  const offers = await told("complete", asked).catch(() => []);
  if (context.aborted || !offers.length) return null;
  const options = offers.map((offer) => option(offer, context));
  return { from: options[0].from, options, validFor: /^["'\w. -]*$/ };
}

async function hover(view, at) {
  const asked = { text: view.state.doc.toString(), at, language: current() };
  const found = await told("hover", asked).catch(() => null);
  if (!found) return null;
  const [pos, end] = found.place.utf16;
  return { pos, end, above: true, create: () => ({ dom: about(found) }) };
}

export class Editor {
  // In a tree of its own, whose style sheets the page's policy lets through without a word in its HTML.
  constructor(host, changed) {
    this.changed = changed;
    this.theme = new Compartment();
    this.labels = new Compartment();
    const root = host.attachShadow({ mode: "open" });
    this.view = new EditorView({ root, parent: root });
    this.dark = matchMedia("(prefers-color-scheme: dark)");
    this.dark.addEventListener("change", () => {
      this.view.dispatch({ effects: this.theme.reconfigure(look(this.dark.matches)) });
    });
  }

  get text() {
    return this.view.state.doc.toString();
  }

  // Another scene, with a history of its own.
  open(text) {
    const told = EditorView.updateListener.of((update) => update.docChanged && this.changed());
    const extensions = [
      lineNumbers(),
      history(),
      drawSelection(),
      EditorState.allowMultipleSelections.of(true),
      bracketMatching(),
      closeBrackets(),
      highlightActiveLine(),
      highlightSelectionMatches(),
      StreamLanguage.define(toml),
      syntaxHighlighting(colours),
      autocompletion({ override: [complete] }),
      hoverTooltip(hover),
      search({ top: true }),
      keymap.of([
        { key: "Tab", run: acceptCompletion },
        ...closeBracketsKeymap,
        ...defaultKeymap,
        ...searchKeymap,
        ...historyKeymap,
        ...completionKeymap,
        ...lintKeymap,
      ]),
      this.theme.of(look(this.dark.matches)),
      this.labels.of(this.label()),
      told,
    ];
    this.view.setState(EditorState.create({ doc: text, extensions }));
  }

  label() {
    return EditorView.contentAttributes.of({ "aria-label": word("page.editor") });
  }

  speak() {
    this.view.dispatch({ effects: this.labels.reconfigure(this.label()) });
  }

  mark(mistakes) {
    if (!mistakes.length && !diagnosticCount(this.view.state)) return;
    const length = this.view.state.doc.length;
    const marks = mistakes.map((mistake) => ({
      from: Math.min(mistake.utf16[0], length),
      to: Math.min(mistake.utf16[1], length),
      severity: "error",
      message: mistake.message,
      renderMessage: () =>
        h("div", {}, h("div", {}, mistake.message), mistake.help ? h("div", { class: "help" }, mistake.help) : null),
      actions: mistake.fix ? [{ name: word("page.fix", { text: mistake.fix.text }), apply: () => this.apply(mistake.fix) }] : [],
    }));
    this.view.dispatch(setDiagnostics(this.view.state, marks));
  }

  apply({ utf16: [from, to], text, caret }) {
    this.view.dispatch({ changes: { from, to, insert: text }, selection: { anchor: from + caret }, scrollIntoView: true });
    this.view.focus();
  }

  // What is written elsewhere than in the text: it stays where it is seen.
  change(changes) {
    this.view.dispatch({ changes, userEvent: "input.drag" });
  }

  go(at) {
    const place = Math.min(at, this.view.state.doc.length);
    this.view.dispatch({ selection: { anchor: place }, effects: EditorView.scrollIntoView(place, { y: "center" }) });
    this.view.focus();
  }
}
