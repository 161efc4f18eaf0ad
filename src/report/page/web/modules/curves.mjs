import { decoded, extent, nearest, thinned } from "./columns.mjs";
import { chooser, element } from "./dom.mjs";
import { asCursor, bottomAxis, gridLines, leftAxis, legendOf, lineClass, namedValues, picture, roomy } from "./drawing.mjs";
import { figure, numberText } from "./numbers.mjs";
import { Selection } from "./selection.mjs";

const kCurves = { height: 190, left: 56, right: 18, top: 8, bottom: 38 };

// A column as it came: packed, or a list with null for what is missing.
function columnOf(given) {
  return Array.isArray(given) ? Float64Array.from(given, (value) => value ?? NaN) : decoded(given);
}

/// A panel of `group` made ready: its columns as numbers, the range that its values take.
export function readPanel(panel, x) {
  const series = panel.series.map((one) => ({ ...one, x: one.x ? columnOf(one.x) : x, values: columnOf(one.values) }));
  const bands = (panel.bands ?? []).map((one) => ({ ...one, low: columnOf(one.low), high: columnOf(one.high) }));
  const limits = panel.limits ?? [];
  const range = extent(...series.map((one) => one.values), ...bands.flatMap((one) => [one.low, one.high]),
    limits.map((limit) => limit.value), panel.from_zero ? [0] : []);
  return { ...panel, series, bands, limits, range };
}

/// Panels of one unit that are to be compared get one range.
export function sharedRanges(panels) {
  const of = {};
  for (const { unit, range } of panels) of[unit] = extent(of[unit] ?? [], range);
  return panels.map((panel) => ({ ...panel, range: of[panel.unit] }));
}

function drawCurve(svg, one, scaleX, scaleY, width) {
  const kept = thinned(one.values, 0, one.values.length, Math.max(2, Math.floor(width)));
  const line = d3.line().defined((i) => Number.isFinite(one.values[i])).x((i) => scaleX(one.x[i])).y((i) => scaleY(one.values[i]));
  svg.append("path").attr("class", lineClass(one)).attr("d", line(kept));
  if (one.points) {
    svg.append("g").selectAll("circle").data(kept.filter((i) => Number.isFinite(one.values[i]))).enter().append("circle")
      .attr("class", `fill-${one.style}`).attr("r", 3).attr("cx", (i) => scaleX(one.x[i])).attr("cy", (i) => scaleY(one.values[i]));
  }
}

// Of an axis that is a whole turn: quarters, or eighths where they fit; of one that counts: whole numbers.
function givenTicks(axis, domain, width) {
  if (!axis.names && axis.digits === 0 && axis.unit !== "deg") {
    return d3.ticks(...domain, Math.max(2, Math.floor(width / 70))).filter(Number.isInteger);
  }
  if (axis.unit !== "deg" || !axis.range || axis.range[1] - axis.range[0] !== 360) return null;
  return d3.range(axis.range[0], axis.range[1] + 1, width < 400 ? 90 : 45);
}

function drawPanel(svg, width, panel, axis, x, hidden) {
  const { height, left, right, top, bottom } = kCurves;
  const scaleX = d3.scaleLinear(axis.range ?? extent(x), [left, width - right]);
  const scaleY = d3.scaleLinear(roomy(panel.range), [height - bottom, top]);
  gridLines(svg, scaleY, 5, left, width - right);
  leftAxis(svg, scaleY, left, 5);
  const names = axis.names;
  const format = names ? (value) => (Number.isInteger(value) ? names[value] ?? "" : "") : undefined;
  const ticks = Math.max(2, Math.floor((width - left) / (names ? 90 : 70)));
  bottomAxis(svg, scaleX, height - bottom, names ? Math.min(ticks, names.length) : ticks, format, givenTicks(axis, scaleX.domain(), width - left));
  svg.append("text").attr("class", "soft").attr("x", width - right).attr("y", height - 5).attr("text-anchor", "end")
    .text(axis.unit ? `${axis.name}, ${axis.unit}` : axis.name);
  for (const band of panel.bands) {
    const area = d3.area().x((_, i) => scaleX(x[i])).y0((value) => scaleY(value)).y1((_, i) => scaleY(band.high[i]));
    svg.append("path").attr("class", `band fill-${band.style}`).attr("d", area(band.low));
  }
  for (const limit of panel.limits) {
    svg.append("line").attr("class", "limit").attr("x1", left).attr("x2", width - right)
      .attr("y1", scaleY(limit.value)).attr("y2", scaleY(limit.value));
    svg.append("text").attr("x", width - right).attr("y", scaleY(limit.value) - 4).attr("text-anchor", "end").text(limit.name);
  }
  for (const one of panel.series.filter(({ name }) => !hidden.has(name))) drawCurve(svg, one, scaleX, scaleY, width - left - right);
  const mark = svg.append("line").attr("class", "chosen").attr("y1", top).attr("y2", height - bottom);
  return { scaleX, mark, height };
}

function curvePanel(panel, axis, x, selection, hidden) {
  const at = (index) => namedValues(panel.series.map((one) => [one.name, one.values[nearest(one.x, x[index])]]),
    panel.unit, panel.digits ?? 3);
  let drawn;
  const shown = picture({
    label: `${panel.name}: ${panel.series.map((one) => one.name).join(", ")} over ${axis.name}`,
    draw(svg, width) {
      drawn = drawPanel(svg, width, panel, axis, x, hidden);
      const choose = () => selection.choose(nearest(x, drawn.scaleX.invert(d3.mouse(svg.node())[0])));
      svg.on("click", choose).on("mousemove", choose);
      move(selection.index);
      return drawn.height;
    },
  });
  function move(index) {
    drawn?.mark.attr("x1", drawn.scaleX(x[index])).attr("x2", drawn.scaleX(x[index]));
  }
  const values = element("p", { class: "note" });
  selection.onChange((index) => {
    move(index);
    values.textContent = at(index);
  });
  asCursor(shown.node, `${panel.name} over ${axis.name}`, selection, x.length, at);
  const name = panel.unit ? `${panel.name}, ${panel.unit}` : panel.name;
  return { node: element("figure", {}, element("h3", {}, name), shown.node, values), redraw: shown.redraw };
}

/// {axis: {name, unit, digits, names, range}, choose, same_scale, groups: [{name, note, x, panels: [{name, unit, digits,
/// series: [{name, style, dash, values, x, points}], bands: [{style, low, high}], limits: [{name, value}]}]}]}: curves over an
/// axis, a group of panels at a time. Columns are packed or lists; `x` rises; `names` are those of whole x.
export function curves(section) {
  const { axis, groups } = section;
  const hidden = new Set();
  const where = element("output", {});
  const panels = element("div", { class: "panels" });
  const legend = element("div");
  const note = element("p", { class: "note" });
  function show(index) {
    const group = groups[index];
    const x = columnOf(group.x);
    const read = group.panels.map((panel) => readPanel(panel, x));
    const ready = section.same_scale ? sharedRanges(read) : read;
    const selection = new Selection(x.length);
    const styles = new Map(ready.flatMap((panel) => panel.series.map((one) => [`${one.style} ${one.name}`, one])));
    const made = ready.map((panel) => curvePanel(panel, axis, x, selection, hidden));
    legend.replaceChildren(styles.size > 1 ? legendOf([...styles.values()], hidden, () => made.forEach((panel) => panel.redraw())) : "");
    panels.replaceChildren(...made.map((panel) => panel.node));
    selection.onChange((at) => {
      where.textContent = axis.names ? `${axis.name} ${axis.names[Math.round(x[at])]}`
        : `${axis.name} ${figure(x[at], axis.unit, axis.digits ?? 1)}`;
    });
    note.textContent = [groups.length > 1 ? `${group.name}.` : "", group.note ?? ""].join(" ").trim();
  }
  const choice = groups.length > 1
    ? chooser({ label: section.choose ?? "Show", options: groups.map((group, i) => [String(i), group.name]), value: "0",
      change: (value) => show(Number(value)) }) : null;
  show(0);
  return element("div", {}, element("div", { class: "controls" }, choice, element("label", {}, "At ", where)),
    legend, panels, note);
}
