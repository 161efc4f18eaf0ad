// The path of a program: in space, along the program, its worst places; one chosen point for all of them.
import { decoded, extent } from "./columns.mjs";
import { colourOfSeries, lineRamp } from "./colours.mjs";
import { chooser, element, slider } from "./dom.mjs";
import { countText, figure, numberText } from "./numbers.mjs";
import { niceGain, Scene } from "./scene.mjs";
import { Selection } from "./selection.mjs";
import { tracks } from "./tracks.mjs";

const kWays = ["start", "rapid", "straight", "arc"];
const kFirstCut = 2;  // of these

/// Columns whose numbers stand for something: its name.
const kNames = { kind: (way) => kWays[way], tool: (number) => (number < 0 ? "tool not known" : `T${number}`) };

/// Those of the first two curves are the lines' that lie beside the path.
const colourOfNamed = (index) => colourOfSeries(index + 2);

function columnsOf(section) {
  return Object.fromEntries(Object.entries(section.columns).map(([key, column]) => [key, { ...column, values: decoded(column) }]));
}

/// A ramp of colours with its numbers.
function colourBar(column, from, to) {
  const width = 220;
  const svg = d3.create("svg").attr("width", width + 20).attr("height", 36).attr("role", "img")
    .attr("aria-label", `colours: ${column.name} from ${figure(from, column.unit, column.digits)} to ${figure(to, column.unit, column.digits)}`);
  const colourOf = lineRamp(0, 1);
  for (let i = 0; i < 44; ++i) svg.append("rect").attr("x", 10 + i * 5).attr("y", 0).attr("width", 5.5).attr("height", 12).attr("fill", colourOf((i + 0.5) / 44));
  const scale = d3.scaleLinear().domain([from, to]).range([10, width + 10]);
  svg.append("g").attr("class", "axis").attr("transform", "translate(0,12)").call(d3.axisBottom(scale).ticks(4).tickSize(4));
  return element("span", { class: "key" }, svg.node(), column.unit ? `${column.name}, ${column.unit}` : column.name);
}

/// "12", "12 of sub.ngc": where a point stands in the text.
function lineText(section, columns, index) {
  const [line, , , , file] = section.blocks[columns.text.values[index]];
  return file ? `${line} of ${file}` : String(line);
}

/// The chosen point in words: where it stands in the text, what the machine does there.
function inspector(section, columns, selection) {
  const box = element("div", { class: "point", "aria-live": "polite" });
  const show = (key, index) => figure(columns[key].values[index], columns[key].unit, columns[key].digits);
  selection.onChange((index) => {
    const [, text, after, bytes] = section.blocks[columns.text.values[index]];
    const tool = columns.tool.values[index];
    const figures = ["shift", "left", "error", "force", "room", "condition", "feed", "block"].filter((key) => key in columns)
      .map((key) => element("div", {}, element("dt", {}, columns[key].name), element("dd", {}, show(key, index))));
    const replaced = after === "" ? [] : [
      element("div", { class: "soft" }, bytes > after.length ? `${section.replaced} (its first lines; ${countText(bytes)} bytes in all)` : section.replaced),
      element("pre", {}, after.replace(/\s+$/, "")),
    ];
    box.replaceChildren(
      element("p", {}, element("strong", {}, `Line ${lineText(section, columns, index)}`), ` · ${kWays[columns.kind.values[index]]}` +
        (tool >= 0 ? ` · tool T${tool}` : "") + ` · point ${countText(index + 1)} of ${countText(section.points)}`),
      element("pre", {}, text),
      ...replaced,
      element("p", { class: "soft" }, ["x", "y", "z", "a", "b", "c"].map((key) => `${columns[key].name} ${show(key, index)}`).join("   ") + "   (machine coordinates, as programmed)"),
      element("dl", { class: "facts" }, figures));
  });
  return box;
}

function worstTable(section, columns, selection, toScene) {
  const rows = section.worst.map((place) => element("tr", {},
    element("td", {}, element("button", { type: "button", class: "link", onclick: () => { selection.choose(place.point); toScene(); } }, place.what)),
    element("td", { class: "number" }, figure(place.value, place.unit, place.digits)),
    element("td", { class: "number" }, lineText(section, columns, place.point)),
    element("td", {}, section.blocks[columns.text.values[place.point]][1])));
  return element("div", {}, element("h3", {}, "The worst places"),
    element("div", { class: "wide" }, element("table", {},
      element("thead", {}, element("tr", {}, ["what", "value", "line", "block"].map((head, i) => element("th", { scope: "col", class: i === 1 || i === 2 ? "number" : undefined }, head)))),
      element("tbody", {}, rows))));
}

function sceneBox(section, columns, selection) {
  const box = element("div", { class: "scene", tabindex: 0, role: "application", "aria-label": "The path in space: drag to turn, wheel to come closer, arrow keys choose a point" });
  const bare = Object.fromEntries(Object.entries(columns).map(([key, column]) => [key, column.values]));
  let scene;
  try {
    scene = new Scene(box, bare, section);
  } catch (error) {
    return element("p", { class: "note" }, "This browser draws nothing in space (WebGL is off or missing): the figures along the program below say the same.");
  }
  const colourKey = element("div", { class: "legend" });
  const colourBy = (key) => {
    const { values } = columns[key];
    if (key in kNames) {
      const there = valuesOfCuts(columns, key);
      scene.colour(values, (value) => colourOfNamed(Math.max(0, there.indexOf(value))));
      colourKey.replaceChildren(...there.map((value, i) => lineKey(colourOfNamed(i), false, kNames[key](value))), ...lineKeys(section));
      return;
    }
    const [from, to] = extent(values);
    scene.colour(values, lineRamp(from, to));
    colourKey.replaceChildren(colourBar(columns[key], from, to), ...lineKeys(section));
  };
  const shifts = columns.shift ?? columns.error;
  const gain = niceGain(scene.size, extent(shifts.values)[1]);
  const exponent = (of) => Math.round(20 * Math.log10(of));
  const gainSlider = slider({
    label: "Shift drawn", min: 0, max: exponent(Math.max(10, gain * 20)), step: 1, value: exponent(gain), long: true,
    words: (of) => `${countText(Math.round(10 ** (of / 20)))} times`, change: (of) => scene.exaggerate(10 ** (of / 20)),
  });
  const place = slider({
    label: "Along the path", min: 0, max: section.points - 1, step: 1, value: 0, long: true,
    words: (of) => `line ${lineText(section, columns, of)}`, change: (of) => selection.choose(of),
  });
  selection.onChange((index) => {
    place.show(index);
    scene.choose(index);
  });
  selection.followKeys(box);
  followClicks(box, scene, selection);
  const tick = (name, label, on) => element("label", {}, element("input", { type: "checkbox", checked: on, onchange: (event) => scene.show(name, event.target.checked) }), label);
  // What is larger than the path is shown whole: it would lie outside of the picture.
  const large = { machine: section.machine ? tick("machine", "machine", false) : null, travel: scene.travel ? tick("travel", "limits of travel", false) : null };
  const lookAt = (at) => {
    if (large[at]) {
      large[at].querySelector("input").checked = true;
      scene.show(at, true);
    }
    scene.look(at);
  };
  const looks = [["path", "path"], ...(large.machine ? [["machine", "whole machine"]] : []), ...(large.travel ? [["travel", "limits of travel"]] : []),
    ["z", "from above"], ["y", "from the front"], ["x", "from the side"]];
  const view = chooser({ label: "View", options: looks, value: "path", change: lookAt });
  for (const [name, node] of Object.entries(large)) {
    node?.addEventListener("change", (event) => {
      if (!event.target.checked) return;
      view.querySelector("select").value = name;
      scene.look(name);
    });
  }
  const first = section.colours[0];
  colourBy(first);
  scene.exaggerate(gain);
  scene.show("machine", false);
  scene.show("travel", false);
  scene.show("told", !columns.error);
  return element("div", {}, box, colourKey,
    element("div", { class: "controls" }, place.node, gainSlider.node),
    element("div", { class: "controls" },
      chooser({ label: "Colour", options: section.colours.map((key) => [key, columns[key].name]), value: first, change: colourBy }),
      view, large.machine, tick("rapids", "rapids", true),
      section.corrected ? tick("told", section.told, !columns.error) : null,
      columns.error ? tick("sagging", sagging(section), true) : null,
      large.travel));
}

function sagging(section) {
  return section.corrected ? "the tip without correction" : "where the tip goes";
}

/// The values of such a column that cuts have, in order.
export function valuesOfCuts(columns, key) {
  const { values } = columns[key];
  const cuts = values.filter((_, i) => columns.kind.values[i] >= kFirstCut);
  return [...new Set(cuts)].sort((a, b) => a - b);
}

/// A line of the picture, and what it is.
function lineKey(colour, dashed, name) {
  const svg = d3.create("svg").attr("width", 30).attr("height", 10).attr("aria-hidden", "true");
  svg.append("line").attr("x1", 0).attr("x2", 30).attr("y1", 5).attr("y2", 5).attr("stroke", colour).attr("stroke-width", 2).attr("stroke-dasharray", dashed ? "5 4" : null);
  return element("span", { class: "key" }, svg.node(), name);
}

/// What the lines of the picture are.
function lineKeys(section) {
  return [lineKey("#8a8f96", true, "rapid"), section.corrected ? lineKey("#0072b2", false, `${section.told}, exaggerated`) : null,
    section.machine ? lineKey("#d55e00", false, `${sagging(section)}, exaggerated`) : null].filter((of) => of);
}

/// A click that did not turn the picture chooses the point under it.
function followClicks(box, scene, selection) {
  let down;
  box.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
  box.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 5) return;
    const point = scene.pointAt(event.clientX, event.clientY);
    if (point >= 0) selection.choose(point);
  });
}

/// {points, of_points, columns, blocks, machine, tracks, colours, worst, corrected}
export function program(section) {
  if (section.points === 0) return element("p", {}, "The program makes no move that the model can follow.");
  const columns = columnsOf(section);
  const selection = new Selection(section.points);
  const drawn = section.of_points > section.points
    ? `Drawn from ${countText(section.points)} of ${countText(section.of_points)} points: of each stretch the first and all extremes.`
    : `All ${countText(section.points)} points are drawn.`;
  const space = sceneBox(section, columns, selection);
  const worst = worstTable(section, columns, selection, () => space.scrollIntoView({ block: "nearest" }));
  if (section.worst.length > 0) selection.choose(section.worst[0].point);
  return element("div", {}, space, inspector(section, columns, selection), worst, tracks(section, columns, selection),
    element("p", { class: "note" }, `${drawn} ${numberText(columns.time.values[columns.time.values.length - 1], 1)} s of cutting.`));
}
