import { element } from "./dom.mjs";

/// {paragraphs: [text]}
export function text(section) {
  return element("div", {}, section.paragraphs.map((paragraph) => element("p", {}, paragraph)));
}

/// {items: [text]}: what the reader must know before using the result.
export function warnings(section) {
  return element("ul", { class: "warnings" }, section.items.map((item) => element("li", {}, item)));
}

/// {text}: a program, as a control reads it.
export function listing(section) {
  return element("div", { class: "block" }, element("pre", { tabindex: 0, "aria-label": section.title }, section.text));
}
