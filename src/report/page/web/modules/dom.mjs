// Elements whose text is text: nothing that comes from a file is ever read as markup.

/// An element with attributes ("class", "for", ...), listeners ("on...": a function) and children (strings are text).
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (typeof value === "function") made.addEventListener(key.slice(2), value);
    else made.setAttribute(key, value === true ? "" : String(value));
  }
  made.append(...children.flat().filter((child) => child !== undefined && child !== null));
  return made;
}

let names = 0;
/// A name that no other element of the page has.
export function freshId(prefix) {
  names += 1;
  return `${prefix}-${names}`;
}

/// A slider with its label and what it stands at, in words.
export function slider({ label, min, max, step, value, words, change, long }) {
  const shown = element("output", {}, words(value));
  const input = element("input", {
    type: "range", min, max, step, value, "aria-label": label, "aria-valuetext": words(value),
    oninput: () => tell(Number(input.value)),
  });
  function show(now) {
    input.value = String(now);
    shown.textContent = words(now);
    input.setAttribute("aria-valuetext", words(now));
  }
  function tell(now) {
    show(now);
    change(now);
  }
  return { node: element("label", { class: long ? "long" : undefined }, label, input, shown), show, input };
}

/// A list to choose one of; `options` are [value, text].
export function chooser({ label, options, value, change }) {
  const select = element("select", { "aria-label": label, onchange: () => change(select.value) },
    options.map(([of, text]) => element("option", { value: of, selected: of === value }, text)));
  return element("label", {}, label, select);
}
