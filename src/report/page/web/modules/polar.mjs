import { decoded, extent, nearest } from "./columns.mjs";
import { chooser, element, slider } from "./dom.mjs";
import { asCursor, legendOf, lineClass, namedValues, picture } from "./drawing.mjs";
import { countText, numberText } from "./numbers.mjs";
import { Selection } from "./selection.mjs";

const kTurn = 2 * Math.PI;
const kNominalShare = 0.58;  // of the plot's radius: where the nominal circle lies
const kWidest = 720;         // px

/// The rings beside the nominal circle: steps of 1, 2 or 5 so that a few of them fit into `reach` (same unit).
export function ringStep(reach, most = 4) {
  const rough = reach / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((times) => times * power).find((step) => step >= rough * (1 - 1e-9)) ?? 10 * power;
}

/// "+5", "−0.2": a deviation that a ring stands for.
export function ringText(value, step) {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return (value > 0 ? "+" : "") + numberText(value, digits);
}

/// Largest deviation of a group's curves.
export function reachOf(curves) {
  const [low, high] = extent(...curves.map((curve) => curve.values));
  return Math.max(Math.abs(low), Math.abs(high)) || 1;
}

function readPolar(group) {
  return { ...group, curves: group.curves.map((curve) => ({ ...curve, angle: decoded(curve.angle), values: decoded(curve.values) })) };
}

// Whether the samples go all the way round: the gap from the last to the first is no more than a few of those between.
function isClosed(angle) {
  const count = angle.length;
  return count > 8 && 360 - (angle[count - 1] - angle[0]) < 3.5 * (angle[count - 1] - angle[0]) / (count - 1);
}

function drawPolarCurves(svg, group, centre, place, hidden = new Set()) {
  for (const curve of group.curves.filter(({ name }) => !hidden.has(name))) {
    const line = d3.lineRadial().defined((i) => Number.isFinite(curve.values[i]))
      .angle((i) => (90 - curve.angle[i]) * kTurn / 360).radius((i) => Math.max(0, place(curve.values[i])));
    const points = d3.range(curve.values.length);
    if (isClosed(curve.angle)) points.push(0);
    svg.append("path").attr("class", lineClass(curve))
      .attr("transform", `translate(${centre})`).attr("d", line(points));
  }
}

function drawRings(svg, [cx, cy], radius, reach, place, unit) {
  const step = ringStep(reach * (1 - kNominalShare) / kNominalShare);
  const rings = [];
  for (let k = -8; k <= 8; ++k) if (place(k * step) > 0.08 * radius && place(k * step) <= radius * 1.001) rings.push(k * step);
  for (const value of rings) {
    svg.append("circle").attr("class", value === 0 ? "ring nominal" : "ring").attr("cx", cx).attr("cy", cy).attr("r", place(value));
  }
  const words = svg.append("g");
  for (const value of rings) {
    words.append("text").attr("class", "halo").attr("x", cx + 4 + Math.cos(1.18) * place(value)).attr("y", cy - Math.sin(1.18) * place(value))
      .text(value === 0 ? "nominal" : `${ringText(value, step)} ${unit}`);
  }
  return words;
}

function drawDirections(svg, [cx, cy], radius) {
  for (let deg = 0; deg < 360; deg += 30) {
    const [x, y] = [Math.cos(deg * kTurn / 360), -Math.sin(deg * kTurn / 360)];
    svg.append("line").attr("class", "ring spoke").attr("x1", cx).attr("y1", cy).attr("x2", cx + radius * x).attr("y2", cy + radius * y);
    const name = { 0: "+X 0\u00b0", 90: "+Y 90\u00b0", 180: "180\u00b0", 270: "270\u00b0" }[deg];
    if (!name) continue;
    svg.append("text").attr("class", "soft").attr("x", cx + (radius + 6) * x).attr("y", cy + (radius + 10) * y + 4)
      .attr("text-anchor", deg === 0 ? "start" : deg === 180 ? "end" : "middle").text(name);
  }
}

// Small, to choose from: the nominal circle and the curves.
function thumbnail(group, reach, unit, choose) {
  const size = 132;
  const label = `${group.name}: show; largest deviation ${numberText(reachOf(group.curves), 1)} ${unit}`;
  const button = element("button", { class: "thumbnail", "aria-label": label, onclick: choose });
  const svg = d3.select(button).append("svg").attr("width", size).attr("height", size).attr("aria-hidden", "true")
    .attr("viewBox", `0 0 ${size} ${size}`);
  const nominal = 0.5 * size * kNominalShare;
  const place = (value) => nominal + value / reach * (0.5 * size - nominal - 2);
  svg.append("circle").attr("class", "ring nominal").attr("cx", size / 2).attr("cy", size / 2).attr("r", nominal);
  drawPolarCurves(svg, group, [size / 2, size / 2], place);
  button.append(element("span", {}, group.name));
  return button;
}

function polarPicture(group, unit, selection, times, hidden) {
  const longest = group.curves.reduce((a, b) => (b.angle.length > a.angle.length ? b : a));
  let drawn;
  const shown = picture({
    label: `${group.name}: radial deviation around the circle, ${group.curves.map((curve) => curve.name).join(", ")}`,
    draw(svg, width) {
      const size = Math.min(width, kWidest);
      const centre = [width / 2, size / 2];
      const radius = size / 2 - 54;
      const reach = reachOf(group.curves) * 1.25 / times();
      const nominal = kNominalShare * radius;
      const place = (value) => nominal + value / reach * (radius - nominal);
      drawDirections(svg, centre, radius);
      const words = drawRings(svg, centre, radius, reach * kNominalShare / (1 - kNominalShare), place, unit);
      drawPolarCurves(svg, group, centre, place, hidden);
      words.raise();
      const mark = svg.append("line").attr("class", "chosen");
      drawn = { mark, centre, radius };
      const choose = () => {
        const [x, y] = d3.mouse(svg.node());
        const deg = (Math.atan2(centre[1] - y, x - centre[0]) * 360 / kTurn + 360) % 360;
        selection.choose(nearest(longest.angle, deg));
      };
      svg.on("click", choose).on("mousemove", choose);
      move(selection.index);
      return size;
    },
  });
  function move(index) {
    if (!drawn) return;
    const deg = longest.angle[index] * kTurn / 360;
    drawn.mark.attr("x1", drawn.centre[0]).attr("y1", drawn.centre[1])
      .attr("x2", drawn.centre[0] + drawn.radius * Math.cos(deg)).attr("y2", drawn.centre[1] - drawn.radius * Math.sin(deg));
  }
  selection.onChange(move);
  return { ...shown, longest };
}

// The magnification as metrologists know it: how much longer than the circle's own scale a deviation is drawn.
function magnificationText(times, group, unit) {
  const shareOfRadius = kNominalShare / (1 - kNominalShare) * reachOf(group.curves) * 1.25 / times;
  if (unit !== "um" || !group.radius_mm) return `${times.toFixed(1)} \u00d7`;
  return `${countText(Number((group.radius_mm * 1000 / shareOfRadius).toPrecision(2)))} : 1`;
}

function factsOf(group) {
  return element("table", {}, element("tbody", {}, (group.facts ?? []).map((fact) => element("tr", {},
    element("th", { scope: "row" }, fact.name),
    element("td", { class: "number" }, `${numberText(fact.value, fact.digits ?? 2)} ${fact.unit ?? ""}`)))));
}

/// {unit, digits, choose, groups: [{name, note, radius_mm, curves: [{name, style, dash, angle, values}], facts: [{name, value,
/// unit, digits}]}]}: deviation from the nominal circle, magnified; a group at a time, the one that
/// deviates most first, all of them small below.
/// Angles in deg from +X towards +Y, rising; columns packed.
export function polar(section) {
  const groups = section.groups.map(readPolar);
  const { unit } = section;
  const digits = section.digits ?? 2;
  const where = element("p", { class: "note", "aria-live": "polite" });
  const box = element("div");
  const facts = element("div");
  const legend = element("div");
  const hidden = new Set();
  let magnify = 1;
  let shown;
  let [now] = groups;
  const gain = slider({ label: "Magnification", min: -3, max: 3, step: 0.1, value: 0, long: true,
    words: (power) => magnificationText(2 ** power, now, unit),
    change(power) {
      magnify = 2 ** power;
      shown.redraw();
    } });
  function show(index) {
    now = groups[index];
    const longest = now.curves.reduce((a, b) => (b.angle.length > a.angle.length ? b : a));
    const selection = new Selection(longest.angle.length);
    shown = polarPicture(now, unit, selection, () => magnify, hidden);
    const words = (at) => `${numberText(longest.angle[at], 1)}\u00b0: ${namedValues(now.curves.map((curve) =>
      [curve.name, curve.values[nearest(curve.angle, longest.angle[at])]]), unit, digits)}`;
    selection.onChange((at) => { where.textContent = words(at); });
    asCursor(shown.node, `${now.name}: angle on the circle`, selection, longest.angle.length, words);
    box.replaceChildren(element("h3", {}, now.name), shown.node);
    facts.replaceChildren(factsOf(now), element("p", { class: "note" }, now.note ?? ""));
    legend.replaceChildren(legendOf(now.curves, hidden, () => shown.redraw()));
    gain.show(Math.log2(magnify));
    for (const [i, button] of [...small.children].entries()) button.setAttribute("aria-pressed", String(i === index));
    if (choice) choice.querySelector("select").value = String(index);
  }
  const worst = groups.reduce((most, group, i) => (reachOf(group.curves) > reachOf(groups[most].curves) ? i : most), 0);
  const reach = Math.max(...groups.map((group) => reachOf(group.curves)));
  const small = element("div", { class: "thumbnails" },
    groups.length > 1 ? groups.map((group, i) => thumbnail(group, reach, unit, () => show(i))) : []);
  const choice = groups.length > 1
    ? chooser({ label: section.choose ?? "Show", options: groups.map((group, i) => [String(i), group.name]), value: String(worst),
      change: (value) => show(Number(value)) }) : null;
  show(worst);
  return element("div", {}, element("div", { class: "controls" }, choice, gain.node), legend,
    element("div", { class: "beside" }, box, element("div", {}, facts, where)), small,
    groups.length > 1 ? element("p", { class: "note" }, "Small circles: all at one magnification.") : null);
}
