// Pictures by D3: drawn anew for the width that there is, so that their text keeps its size; what they share.
import { element } from "./dom.mjs";
import { numberText } from "./numbers.mjs";
import { redrawForPrint } from "./paper.mjs";

/// A picture in an element of its own. `label` says what it shows; `draw(svg, width)` fills an empty D3 selection and
/// returns the height. `redraw` draws it again.
export function picture({ label, draw }) {
  const node = element("div", { class: "picture" });
  let drawn = 0;
  function redraw(scale = 1) {
    const width = Math.floor(scale * node.clientWidth);
    if (width < 40) return;
    drawn = width;
    node.querySelector("svg")?.remove();
    const svg = d3.select(node).append("svg").attr("role", "img").attr("aria-label", label);
    svg.append("title").text(label);
    const height = Math.ceil(draw(svg, width));
    svg.attr("width", width).attr("height", height).attr("viewBox", `0 0 ${width} ${height}`);
  }
  new ResizeObserver(() => {
    if (Math.floor(node.clientWidth) !== drawn) redraw();
  }).observe(node);
  redrawForPrint((scale) => { if (node.isConnected) redraw(scale); });
  return { node, redraw: () => redraw() };
}

/// A number on an axis: a true minus, no digits that say nothing.
export function tickText(value) {
  return String(Number(value.toPrecision(10))).replace("-", "\u2212");
}

/// An axis along the bottom; `format` writes its ticks, which are about `count` or those given.
export function bottomAxis(svg, scale, y, count, format = tickText, given = null) {
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${y})`)
    .call(d3.axisBottom(scale).ticks(count).tickValues(given).tickFormat(format).tickSizeOuter(0));
}

export function leftAxis(svg, scale, x, count, format = tickText) {
  svg.append("g").attr("class", "axis").attr("transform", `translate(${x},0)`)
    .call(d3.axisLeft(scale).ticks(count).tickFormat(format).tickSizeOuter(0));
}

/// Lines across at an axis' ticks.
export function gridLines(svg, scale, count, from, to) {
  svg.append("g").attr("class", "axis").selectAll("line").data(scale.ticks(count)).enter().append("line")
    .attr("x1", from).attr("x2", to).attr("y1", (value) => scale(value)).attr("y2", (value) => scale(value))
    .attr("opacity", 0.5);
}

/// Colour and pattern of a line: those of its style, the pattern of another one if it says so (`dash`).
export function lineClass({ style, dash }) {
  return `curve stroke-${style} dash-${dash ?? style}`;
}

/// What the lines of a picture are: [{name, style, dash}], each a button that hides it and shows it again. `hidden` is a
/// set of names, `change` draws the picture anew.
export function legendOf(series, hidden, change) {
  return element("div", { class: "legend", role: "group", "aria-label": "Lines that are shown" }, series.map((one) => {
    const key = element("button", { class: "key", "aria-pressed": String(!hidden.has(one.name)), onclick() {
      if (!hidden.delete(one.name)) hidden.add(one.name);
      key.setAttribute("aria-pressed", String(!hidden.has(one.name)));
      change();
    } });
    const svg = d3.select(key).append("svg").attr("width", 30).attr("height", 10).attr("aria-hidden", "true");
    svg.append("line").attr("x1", 0).attr("x2", 30).attr("y1", 5).attr("y2", 5).attr("class", lineClass(one)).attr("stroke-width", 2.5);
    key.append(one.name);
    return key;
  }));
}

/// [low, high] with some room; never of no height.
export function roomy([low, high], share = 0.06) {
  const height = high - low || Math.abs(high) || 1;
  return [low - share * height, high + share * height];
}

/// A cursor that keys move over an element: `words(index)` is what a reader hears of where it stands.
export function asCursor(node, label, selection, count, words) {
  for (const [name, value] of Object.entries({ tabindex: 0, role: "slider", "aria-label": label, "aria-valuemin": 0,
    "aria-valuemax": Math.max(0, count - 1) })) node.setAttribute(name, String(value));
  selection.followKeys(node);
  selection.onChange((index) => {
    node.setAttribute("aria-valuenow", String(index));
    node.setAttribute("aria-valuetext", words(index));
  });
}

/// "measured 3.20 um, simulated 3.10 um" of [[name, value]].
export function namedValues(pairs, unit, digits) {
  return pairs.map(([name, value]) => {
    const text = numberText(value, digits);
    return text === "none" ? `${name} not known` : `${name} ${text}${unit ? ` ${unit}` : ""}`;
  }).join(", ");
}

/// A name that fits into so many pixels, its middle left out if need be: names of a list often begin alike.
export function shortened(name, pixels) {
  const most = Math.max(4, Math.floor(pixels / 7));
  if (name.length <= most) return name;
  const head = Math.max(1, Math.floor((most - 1) / 3));
  return `${name.slice(0, head)}\u2026${name.slice(name.length - (most - 1 - head))}`;
}
