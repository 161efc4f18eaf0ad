import { element } from "./dom.mjs";
import { bottomAxis, picture, roomy, shortened } from "./drawing.mjs";
import { extent } from "./columns.mjs";
import { figure, numberText } from "./numbers.mjs";

const kRight = 78;
// Many rows are laid closer.
const spaceOf = (rows) => (rows > 12 ? { row: 13, gap: 7 } : { row: 15, gap: 12 });

/// [low, high] that holds zero, all bars, their intervals and the reference lines.
export function barRange(section) {
  const all = section.rows.flatMap((row) => row.bars.flatMap((bar) => [bar.value, bar.low ?? bar.value, bar.high ?? bar.value]));
  const [low, high] = extent(all.filter((value) => value !== null), [0], (section.references ?? []).map((line) => line.value));
  const [, room] = roomy([low, high], 0.03);
  return [low < 0 ? roomy([low, high], 0.03)[0] : 0, room];
}

/// "2.10 um, 1.90 to 2.30"
export function barWords(bar, unit, digits) {
  const text = figure(bar.value, unit, digits);
  const isInterval = Number.isFinite(bar.low) && Number.isFinite(bar.high) && bar.low < bar.high;
  return isInterval ? `${text}, ${numberText(bar.low, digits)} to ${numberText(bar.high, digits)}` : text;
}

function drawBar(svg, bar, y, scale, section, space) {
  if (!Number.isFinite(bar.value)) {
    svg.append("text").attr("class", "soft").attr("x", scale(0) + 4).attr("y", y + space.row - 3).text(bar.why ?? "none");
    return;
  }
  const [from, to] = [Math.min(0, bar.value), Math.max(0, bar.value)].map((value) => scale(value));
  svg.append("rect").attr("class", `fill-${bar.style ?? 1}`).attr("x", from).attr("width", Math.max(1, to - from)).attr("y", y)
    .attr("height", space.row - 3).append("title").text(barWords(bar, section.unit, section.digits ?? 2));
  if (Number.isFinite(bar.low) && Number.isFinite(bar.high)) {
    const middle = y + (space.row - 3) / 2;
    svg.append("path").attr("class", "whisker")
      .attr("d", `M${scale(bar.low)} ${middle}H${scale(bar.high)}M${scale(bar.low)} ${middle - 4}v8M${scale(bar.high)} ${middle - 4}v8`);
  }
  const end = Math.max(to, scale(Math.max(bar.value, bar.high ?? bar.value)));
  svg.append("text").attr("class", "halo").attr("x", end + 5).attr("y", y + space.row - 4)
    .text(numberText(bar.value, section.digits ?? 2));
}

function drawBars(svg, width, section) {
  const space = spaceOf(section.rows.length);
  const left = Math.min(width * 0.42, 16 + 7.2 * Math.max(...section.rows.map((row) => row.name.length)));
  const scale = d3.scaleLinear(barRange(section), [left, width - kRight]);
  const top = (section.references ?? []).length > 0 ? 20 : 4;
  let y = top;
  const words = svg.append("g");
  for (const row of section.rows) {
    const name = words.append("text").attr("x", left - 8).attr("y", y + (row.bars.length * space.row + 6) / 2).attr("text-anchor", "end");
    name.text(shortened(row.name, left - 12)).append("title").text(row.name);
    for (const bar of row.bars) {
      drawBar(svg, bar, y, scale, section, space);
      y += space.row;
    }
    y += space.gap;
  }
  for (const line of section.references ?? []) {
    svg.append("line").attr("class", "limit").attr("x1", scale(line.value)).attr("x2", scale(line.value)).attr("y1", top - 4).attr("y2", y);
    const isRight = scale(line.value) > width - 10 - 7 * line.name.length;
    svg.append("text").attr("class", "halo").attr("x", scale(line.value) + (isRight ? -4 : 4)).attr("y", 12)
      .attr("text-anchor", isRight ? "end" : "start").text(line.name);
  }
  svg.selectAll("text.halo").raise();  // a number is not struck out by a line of reference
  svg.append("line").attr("class", "zero").attr("x1", scale(0)).attr("x2", scale(0)).attr("y1", top - 4).attr("y2", y);
  bottomAxis(svg, scale, y, Math.max(2, Math.floor((width - left) / 90)));
  svg.append("text").attr("class", "soft").attr("x", width - 4).attr("y", y + 34).attr("text-anchor", "end").text(section.unit);
  return y + 40;
}

function swatches(series) {
  return element("div", { class: "legend" }, series.map(({ name, style }) => {
    const key = element("span", { class: "key" });
    d3.select(key).append("svg").attr("width", 14).attr("height", 12).attr("aria-hidden", "true").append("rect")
      .attr("class", `fill-${style}`).attr("width", 14).attr("height", 12);
    key.append(name);
    return key;
  }));
}

function barTable(section) {
  return element("details", { class: "screen-only" }, element("summary", {}, "The same as a table"),
    element("div", { class: "wide", tabindex: 0, role: "region", "aria-label": `${section.title}, table` },
      element("table", {}, element("thead", {}, element("tr", {}, element("th", { scope: "col" }, ""),
        section.series.map((one) => element("th", { scope: "col", class: "number" }, one.name)))),
      element("tbody", {}, section.rows.map((row) => element("tr", {}, element("th", { scope: "row" }, row.name),
        row.bars.map((bar) => element("td", { class: "number" },
          Number.isFinite(bar.value) ? barWords(bar, section.unit, section.digits ?? 2) : bar.why ?? "none"))))))));
}

/// {unit, digits, series: [{name, style}], references: [{name, value}], rows: [{name, bars: [{value, low, high, style, why}]}]}:
/// values with intervals, side by side; a row has a bar of each of the series. `why` says why there is no value.
export function bars(section) {
  const shown = picture({
    label: `${section.title}: ${section.rows.map((row) => `${row.name} ${row.bars.map((bar) =>
      barWords(bar, section.unit, section.digits ?? 2)).join("; ")}`).join(". ")}`,
    draw: (svg, width) => drawBars(svg, width, section),
  });
  return element("figure", {}, section.series.length > 1 ? swatches(section.series) : null, shown.node, barTable(section));
}
