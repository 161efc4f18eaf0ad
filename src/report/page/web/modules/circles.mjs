import { extent } from "./columns.mjs";
import { chooser, element } from "./dom.mjs";
import { bottomAxis, leftAxis, picture } from "./drawing.mjs";
import { numberText } from "./numbers.mjs";

const kViews = [
  { name: "From above", across: 0, up: 1, axes: ["X", "Y"] },
  { name: "From the front", across: 0, up: 2, axes: ["X", "Z"] },
  { name: "From the side", across: 1, up: 2, axes: ["Y", "Z"] },
];
const kHeadSteps = 72;

/// Points of the circle in the order in which the tip passes them, from angle 0 (mm).
export function circlePoints(test, steps = kHeadSteps) {
  const turn = test.direction === "cw" ? -1 : 1;
  return d3.range(steps + 1).map((i) => {
    const phi = turn * 2 * Math.PI * i / steps;
    const [x, y, z] = test.centre_mm;
    return [x + test.radius_mm * Math.cos(phi), y + test.radius_mm * Math.sin(phi), z];
  });
}

/// Where the ball on the table stands: below the centre by the height that bar and radius leave.
export function ballOf(test) {
  const bar = test.bar_mm ?? test.radius_mm;
  const [x, y, z] = test.centre_mm;
  return [x, y, z - Math.sqrt(Math.max(0, bar * bar - test.radius_mm * test.radius_mm))];
}

// One scale for both directions, so that a circle is round.
function scalesOf(points, view, width) {
  const [left, right, top, bottom] = [48, 20, 10, 40];
  const [x0, x1] = extent(points.map((p) => p[view.across]));
  const [y0, y1] = extent(points.map((p) => p[view.up]));
  const per = Math.max((x1 - x0) / (width - left - right), (y1 - y0) / 520) * 1.06;
  const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
  const height = Math.max(120, (y1 - y0) * 1.06 / per);
  const half = per * (width - left - right) / 2;
  return {
    x: d3.scaleLinear([middle[0] - half, middle[0] + half], [left, width - right]),
    y: d3.scaleLinear([middle[1] - per * height / 2, middle[1] + per * height / 2], [top + height, top]),
    bottom: top + height, left, height: top + height + bottom,
  };
}

function drawMachine(svg, machine, test, at) {
  const outline = (points) => `M${points.map(at).join("L")}Z`;
  svg.append("path").attr("class", "solid").attr("d", outline(machine.base_mm));
  svg.append("path").attr("class", "solid").attr("d", outline(test.platform_mm));
  svg.append("path").attr("class", "strut").attr("d", machine.base_mm.map((joint, j) => `M${at(joint)}L${at(test.platform_mm[j])}`).join(""));
  const middle = [0, 1, 2].map((k) => d3.mean(test.platform_mm, (point) => point[k]));
  svg.append("path").attr("class", "tool").attr("d", `M${at(middle)}L${at(test.start_mm)}`);
}

/// Two corners of the travel, as far as it is bounded.
export function travelCorners(limits) {
  const corner = (side) => ["x", "y", "z"].map((axis) => limits?.[axis]?.[side] ?? NaN);
  return [corner(0), corner(1)];
}

function drawTravel(svg, limits, view, scales) {
  const [x, y] = [limits?.["xyz"[view.across]], limits?.["xyz"[view.up]]];
  if (!x || !y) return;
  svg.append("rect").attr("class", "limit").attr("x", scales.x(x[0])).attr("width", scales.x(x[1]) - scales.x(x[0]))
    .attr("y", scales.y(y[1])).attr("height", scales.y(y[0]) - scales.y(y[1]));
}

function drawCircle(svg, test, at) {
  const points = circlePoints(test);
  svg.append("path").attr("class", "curve stroke-1").attr("stroke-width", 2.5).attr("d", d3.line()(points.map(at)));
  svg.append("path").attr("class", "curve stroke-2").attr("d", `M${at(ballOf(test))}L${at(test.start_mm)}`);
  const [bx, by] = at(ballOf(test));
  const [sx, sy] = at(test.start_mm);
  svg.append("circle").attr("class", "fill-2").attr("cx", bx).attr("cy", by).attr("r", 4);
  svg.append("circle").attr("class", "fill-1").attr("cx", sx).attr("cy", sy).attr("r", 4);
  const [from, to] = [at(points[8]), at(points[9])];
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]) * 180 / Math.PI;
  svg.append("path").attr("class", "fill-1").attr("d", "M-7,-5L7,0L-7,5Z").attr("transform", `translate(${to})rotate(${angle})`);
}

function viewPicture(section, test, view) {
  const [horizontal, vertical] = view.axes;
  const shown = picture({
    label: `${test.name}, ${view.name.toLowerCase()}: the circle in the machine, with the platform where the turn begins`,
    draw(svg, width) {
      const limits = section.machine.limits_mm;
      const all = [...section.machine.base_mm, ...test.platform_mm, ...circlePoints(test), ballOf(test), ...travelCorners(limits)];
      const scales = scalesOf(all, view, width);
      const at = (point) => [scales.x(point[view.across]), scales.y(point[view.up])];
      bottomAxis(svg, scales.x, scales.bottom, Math.floor(width / 80));
      leftAxis(svg, scales.y, scales.left, 6);
      drawTravel(svg, limits, view, scales);
      drawMachine(svg, section.machine, test, at);
      drawCircle(svg, test, at);
      svg.append("text").attr("class", "soft").attr("x", width - 12).attr("y", scales.bottom + 36).attr("text-anchor", "end")
        .text(`${horizontal} to the right, ${vertical} upwards, mm`);
      return scales.height + 4;
    },
  });
  return element("figure", {}, element("h3", {}, view.name), shown.node);
}

function testFacts(test) {
  const [a, b, c] = test.tilt_deg.map((deg) => numberText(deg, 1));
  const rows = [
    ["Centre", `${test.centre_mm.map((mm) => numberText(mm, 1)).join(", ")} mm`],
    ["Radius", `${numberText(test.radius_mm, 1)} mm`],
    ["Bar", test.bar_mm ? `${numberText(test.bar_mm, 1)} mm` : "in the plane of the circle"],
    ["Plane", "horizontal (XY), the platform tilted"],
    ["Tilt", `A ${a}\u00b0, B ${b}\u00b0, C ${c}\u00b0`],
    ["Direction", test.direction === "cw" ? "clockwise" : "counterclockwise"],
    ["Feed", `${numberText(test.feed_mm_min, 0)} mm/min`],
    ["Mass at the tip", test.payload_kg > 0 ? `${numberText(test.payload_kg, 1)} kg` : "none"],
  ];
  return element("table", {}, element("tbody", {}, rows.map(([name, value]) =>
    element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, value)))));
}

/// {choose, machine: {base_mm, limits_mm: {x, y, z}}, tests: [{name, note, centre_mm, radius_mm, bar_mm, tilt_deg, direction,
/// feed_mm_min, payload_kg, start_mm, platform_mm, program}]}: circular tests drawn in the machine, one at a time.
export function circles(section) {
  const views = element("div", { class: "panels" });
  const words = element("div");
  const legend = element("p", { class: "note" },
    "Blue: the circle, with the dot where the turn begins and the arrow the way it goes. Orange: the bar and the ball on the table. " +
    "Grey: base, struts, platform and tool. Dashed: the travel that the machine allows.");
  function show(index) {
    const test = section.tests[index];
    views.replaceChildren(element("div", {}, element("h3", {}, test.name), testFacts(test), element("p", {}, test.note ?? "")),
      ...kViews.map((view) => viewPicture(section, test, view)));
    words.replaceChildren(...(test.program ? [element("details", { open: section.tests.length === 1 },
      element("summary", {}, `NC program: ${test.name}`),
      element("div", { class: "block" }, element("pre", { tabindex: 0, "aria-label": `NC program of ${test.name}` }, test.program)))] : []));
  }
  show(0);
  const choice = section.tests.length > 1
    ? chooser({ label: section.choose ?? "Test", options: section.tests.map((test, i) => [String(i), test.name]), value: "0",
      change: (value) => show(Number(value)) }) : null;
  return element("div", {}, element("div", { class: "controls" }, choice), views, legend, words);
}
