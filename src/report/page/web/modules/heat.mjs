import { decoded, extent } from "./columns.mjs";
import { chooser, element } from "./dom.mjs";
import { bottomAxis, picture, shortened, tickText } from "./drawing.mjs";
import { figure, numberText } from "./numbers.mjs";

const kNumbered = 900;  // cells: more have no numbers in them
const kHeat = { right: 14, top: 6, bottom: 42, legend: 54 };

/// The cells of a plane: values row by row, NaN where there is none.
export function cellsOf(plane) {
  return Array.isArray(plane.values) ? Float64Array.from(plane.values.flat(), (value) => value ?? NaN) : decoded(plane.values);
}

/// Why a cell has no value.
export function reasonOf(section, plane, cell) {
  const given = plane.reasons?.[cell];
  return given === undefined || given === null ? "not known" : section.reasons?.[given] ?? "not known";
}

/// Names of an axis' places: given, or its numbers with their unit.
export function placeNames(axis) {
  return axis.labels ?? axis.values.map((value) => `${axis.name} ${tickText(value)}${axis.unit ? ` ${axis.unit}` : ""}`);
}

/// What a cell says: "bar, order 2: 10.00 times the noise".
export function cellWords(section, one, plane, cells, cell) {
  const columns = placeNames(section.columns);
  const row = placeNames(section.rows)[Math.floor(cell / columns.length)];
  const value = Number.isFinite(cells[cell]) ? figure(cells[cell], one.unit, one.digits ?? 2) : reasonOf(section, plane, cell);
  return `${row}, ${columns[cell % columns.length]}: ${value}`;
}

/// Which places of an axis get a name when only `most` fit.
export function shownPlaces(count, most) {
  const step = Math.max(1, Math.ceil(count / Math.max(1, most)));
  return d3.range(0, count, step);
}

function colourScale(one, range) {
  const [low, high] = one.range ?? range;
  const ramp = d3.interpolateViridis;
  const scale = one.log ? d3.scaleSequentialLog([Math.max(low, high * 1e-6, 1e-12), high], ramp)
    : d3.scaleSequential([low, high === low ? low + 1 : high], ramp);
  return scale.clamp(true);
}

// L* of the grey from which black and white differ alike, by 4.6 to 1.
const kMiddleGrey = 49.5;

// In each cell its number, dark on light colours and light on dark ones.
function drawNumbers(svg, cells, box, columns, scale, one) {
  const shown = d3.range(cells.length).filter((i) => Number.isFinite(cells[i]));
  svg.append("g").selectAll("text").data(shown).enter().append("text").attr("text-anchor", "middle")
    .attr("x", (i) => box.x0 + ((i % columns) + 0.5) * box.wide)
    .attr("y", (i) => box.y0 + (Math.floor(i / columns) + 0.5) * box.high + 4)
    .style("fill", (i) => (d3.lab(scale(cells[i])).l > kMiddleGrey ? "#000" : "#fff"))
    .text((i) => numberText(cells[i], Math.min(one.digits ?? 2, 2)));
}

function axisName(axis) {
  return axis.unit && axis.values ? `${axis.name}, ${axis.unit}` : axis.name;
}

function shortNames(axis) {
  return axis.labels ?? axis.values.map(tickText);
}

function drawNames(svg, box, section) {
  const rows = shortNames(section.rows);
  const columns = shortNames(section.columns);
  for (const i of shownPlaces(rows.length, (box.y1 - box.y0) / 15)) {
    svg.append("text").attr("x", box.x0 - 6).attr("y", box.y0 + (i + 0.5) * box.high + 4).attr("text-anchor", "end")
      .text(shortened(rows[i], box.x0 - 8)).append("title").text(rows[i]);
  }
  const widest = 10 + 7 * Math.max(...columns.map((name) => name.length));
  for (const i of shownPlaces(columns.length, (box.x1 - box.x0) / widest)) {
    svg.append("text").attr("x", box.x0 + (i + 0.5) * box.wide).attr("y", box.y1 + 15).attr("text-anchor", "middle").text(columns[i]);
  }
  svg.append("text").attr("class", "soft").attr("x", box.x1).attr("y", box.y1 + 32).attr("text-anchor", "end").text(axisName(section.columns));
}

/// 1, 2, 5 and their tens between two numbers.
export function logTicks(low, high) {
  const ticks = [];
  for (let power = 10 ** Math.floor(Math.log10(low)); power <= high; power *= 10) {
    for (const times of [1, 2, 5]) if (times * power >= low * 0.999 && times * power <= high * 1.001) ticks.push(times * power);
  }
  return ticks;
}

function drawLegend(svg, scale, one, x0, x1, y) {
  const [low, high] = scale.domain();
  const across = (one.log ? d3.scaleLog : d3.scaleLinear)([low, high], [x0, x1]);
  const steps = 60;
  for (let i = 0; i < steps; ++i) {
    const from = x0 + (x1 - x0) * i / steps;
    svg.append("rect").attr("x", from).attr("y", y).attr("width", (x1 - x0) / steps + 0.6).attr("height", 10)
      .attr("fill", scale(across.invert(from + (x1 - x0) / steps / 2)));
  }
  bottomAxis(svg, across, y + 10, 5, tickText, one.log ? logTicks(low, high) : null);
  svg.append("text").attr("class", "soft").attr("x", x1).attr("y", y + 42).attr("text-anchor", "end")
    .text(one.unit ? `${one.name}, ${one.unit}` : one.name);
}

function drawHeat(svg, width, section, one, plane, cells) {
  const rows = section.rows.labels?.length ?? section.rows.values.length;
  const columns = section.columns.labels?.length ?? section.columns.values.length;
  const left = Math.min(0.3 * width, 14 + 7.5 * Math.max(...shortNames(section.rows).map((name) => name.length)));
  const room = width - left - kHeat.right;
  const wide = (section.square ? Math.min(room, 640 * columns / rows) : room) / columns;
  const high = section.square ? wide : Math.max(13, Math.min(26, wide * 1.2, 420 / rows));
  const box = { x0: left, x1: left + wide * columns, y0: kHeat.top, y1: kHeat.top + high * rows, wide, high };
  const scale = colourScale(one, plane.range);
  const gap = cells.length <= kNumbered ? 1 : 0;
  const drawn = svg.append("g").selectAll("rect").data(cells).enter().append("rect")
    .attr("x", (_, i) => box.x0 + (i % columns) * wide).attr("y", (_, i) => box.y0 + Math.floor(i / columns) * high)
    .attr("width", wide + (gap > 0 ? -gap : 0.3)).attr("height", high + (gap > 0 ? -gap : 0.3))
    .attr("fill", (value) => (Number.isFinite(value) ? scale(value) : "none"));
  drawn.filter((value) => !Number.isFinite(value)).attr("class", "missing");
  if (wide >= 38 && high >= 13 && cells.length <= kNumbered) drawNumbers(svg, cells, box, columns, scale, one);
  drawNames(svg, box, section);
  drawLegend(svg, scale, one, box.x0, box.x1, box.y1 + kHeat.bottom);
  const mark = svg.append("rect").attr("class", "chosen").attr("width", wide).attr("height", high).attr("visibility", "hidden");
  const cellAt = ([x, y]) => {
    const [column, row] = [Math.floor((x - box.x0) / wide), Math.floor((y - box.y0) / high)];
    return column >= 0 && column < columns && row >= 0 && row < rows ? row * columns + column : -1;
  };
  const move = (cell) => mark.attr("visibility", "visible").attr("x", box.x0 + (cell % columns) * wide)
    .attr("y", box.y0 + Math.floor(cell / columns) * high);
  return { cellAt, move, height: box.y1 + kHeat.bottom + kHeat.legend };
}

/// The cell that a key leads to from another one; the same where there is none in that direction.
export function steppedCell(cell, key, rows, columns) {
  const row = Math.floor(cell / columns);
  const column = cell % columns;
  if (key === "ArrowLeft") return column > 0 ? cell - 1 : cell;
  if (key === "ArrowRight") return column + 1 < columns ? cell + 1 : cell;
  if (key === "ArrowUp") return row > 0 ? cell - columns : cell;
  if (key === "ArrowDown") return row + 1 < rows ? cell + columns : cell;
  if (key === "Home") return 0;
  if (key === "End") return rows * columns - 1;
  return undefined;
}

function heatTable(section, one, plane, cells) {
  const columns = shortNames(section.columns);
  return element("table", {}, element("caption", {}, `${one.name}${one.unit ? `, ${one.unit}` : ""}${plane.name ? `; ${plane.name}` : ""}`),
    element("thead", {}, element("tr", {}, element("th", { scope: "col" }, axisName(section.rows)),
      columns.map((name) => element("th", { scope: "col", class: "number" }, name)))),
    element("tbody", {}, shortNames(section.rows).map((name, row) => element("tr", {}, element("th", { scope: "row" }, name),
      columns.map((_, column) => {
        const cell = row * columns.length + column;
        return element("td", { class: "number" }, Number.isFinite(cells[cell]) ? numberText(cells[cell], one.digits ?? 2)
          : reasonOf(section, plane, cell));
      })))));
}

/// {rows: {name, unit, labels | values}, columns: alike, square, choose_plane, reasons: [text], figures: [{name, unit, digits,
/// log, range, planes: [{name, values, reasons: {cell: index}}]}]}: a colour for each cell. `values` are packed row by
/// row, or lists of lists with null; `range` bounds the colours, else all planes of a figure share one.
export function heat(section) {
  const state = { figure: 0, plane: 0, cell: 0 };
  const rows = placeNames(section.rows).length;
  const columns = placeNames(section.columns).length;
  const words = element("p", { class: "note", "aria-live": "polite" });
  const table = element("div", { class: "wide", tabindex: 0, role: "region", "aria-label": `${section.title}, table` });
  let drawn;
  const current = () => {
    const one = section.figures[state.figure];
    const all = one.planes.map(cellsOf);
    const plane = { ...one.planes[state.plane], range: extent(...all) };
    return { one, plane, cells: all[state.plane] };
  };
  const shown = picture({
    label: `${section.title}: a colour for each of ${rows} by ${columns} cells`,
    draw(svg, width) {
      const { one, plane, cells } = current();
      drawn = drawHeat(svg, width, section, one, plane, cells);
      const choose = () => tell(drawn.cellAt(d3.mouse(svg.node())));
      svg.on("click", choose).on("mousemove", choose);
      return drawn.height;
    },
  });
  function tell(cell) {
    if (cell < 0 || cell === undefined) return;
    const { one, plane, cells } = current();
    state.cell = cell;
    drawn?.move(cell);
    words.textContent = cellWords(section, one, plane, cells, cell);
    shown.node.setAttribute("aria-valuenow", String(cell));
    shown.node.setAttribute("aria-valuetext", words.textContent);
  }
  function show() {
    const { one, plane, cells } = current();
    if (drawn) shown.redraw();
    table.replaceChildren(heatTable(section, one, plane, cells));
    words.textContent = "";
  }
  for (const [name, value] of Object.entries({ tabindex: "0", role: "slider", "aria-label": `${section.title}: cell; arrow keys move`,
    "aria-valuemin": "0", "aria-valuemax": String(rows * columns - 1), "aria-valuenow": "0" })) shown.node.setAttribute(name, value);
  shown.node.addEventListener("keydown", (event) => {
    const to = steppedCell(state.cell, event.key, rows, columns);
    if (to === undefined) return;
    event.preventDefault();
    tell(to);
  });
  const pick = (label, of, names) => (names.length < 2 ? null : chooser({ label, value: "0",
    options: names.map((name, i) => [String(i), name]), change(value) {
      state[of] = Number(value);
      show();
    } }));
  show();
  return element("figure", {}, element("div", { class: "controls" },
    pick("Figure", "figure", section.figures.map((one) => one.name)),
    pick(section.choose_plane ?? "Plane", "plane", section.figures[0].planes.map((plane) => plane.name))),
  element("p", { class: "soft" }, `${axisName(section.rows)} downwards, ${axisName(section.columns)} across.`), shown.node, words,
  element("details", { class: "screen-only" }, element("summary", {}, "The same as a table"), table));
}
