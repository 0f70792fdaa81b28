// Elements of the page. Whatever comes from a scene is put in as text, never as HTML.

const SVG = "http://www.w3.org/2000/svg";

function filled(element, properties, children) {
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value != null) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child != null));
  return element;
}

export const h = (tag, properties = {}, ...children) => filled(document.createElement(tag), properties, children);
export const s = (tag, properties = {}, ...children) => filled(document.createElementNS(SVG, tag), properties, children);
export const byId = (id) => document.getElementById(id);

const TAGS = { italic: "i", sub: "sub", sup: "sup" };

// Pieces of text with letters below and above the line.
export function script(pieces) {
  const all = document.createDocumentFragment();
  for (const [text, style] of pieces ?? []) all.append(TAGS[style] ? h(TAGS[style], {}, text) : text);
  return all;
}

export const plain = (pieces) => (pieces ?? []).map(([text]) => text).join("");

// The same in a drawing, where what stands below or above is moved by hand.
export function label(pieces, properties) {
  const text = s("text", properties);
  let level = 0;
  for (const [piece, style] of pieces) {
    const next = style === "sub" ? 4 : style === "sup" ? -5 : 0;
    text.append(s("tspan", { class: style, dy: next - level || null }, piece));
    level = next;
  }
  return text;
}
