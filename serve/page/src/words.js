// The words of the page's language, and its numbers.

let words = {};
let language = "en";
let decimal = ".";

export const current = () => language;

export function word(id, named = {}) {
  const [group, name] = id.split(".");
  const text = words[group]?.[name] ?? id;
  return text.replace(/#(\w+)/g, (mark, name) => named[name] ?? mark);
}

// The number as the book of the language has it.
export const number = (value) => String(value).replace(".", decimal).replace("-", "−");

// A value with its unit; degrees stand close.
export const measured = (text, unit) => (!unit || unit === "°" ? `${text}${unit}` : `${text}\u202f${unit}`);

// Puts the words into everything that names one.
export function speak(spoken) {
  ({ words, code: language } = spoken);
  decimal = new Intl.NumberFormat(language).format(0.5)[1];
  document.documentElement.lang = language;
  for (const element of document.querySelectorAll("[data-word]")) element.textContent = word(element.dataset.word);
  for (const element of document.querySelectorAll("[data-label]")) {
    element.setAttribute("aria-label", word(element.dataset.label));
  }
}
