// Figures along the program: panels over one axis, linked to the chosen point.
import { seriesOf } from "./colours.mjs";
import { extent, nearest, thinned } from "./columns.mjs";
import { chooser, element } from "./dom.mjs";
import { figure, numberText } from "./numbers.mjs";
import { redrawForPrint } from "./paper.mjs";

const kHeight = 162;
const kMargin = { top: 8, right: 12, bottom: 34, left: 62 };

/// What the panels are drawn over: rising numbers, one a point.
function axes(columns) {
  return {
    time: { values: columns.time.values, name: "time of cutting, s (rapids take none)", title: "time, s" },
    point: { values: Float64Array.from(columns.time.values, (_, i) => i), name: "point of the path", title: "point" },
  };
}

class Panel {
  constructor(track, columns, selection) {
    this.track = track;
    this.columns = columns;
    this.selection = selection;
    this.curves = track.keys.filter((key) => key in columns).map((key, i) => ({ column: columns[key], series: seriesOf(i) }));
    this.readout = element("span", { class: "legend" });
    this.svg = d3.create("svg").attr("role", "img").attr("tabindex", 0)
      .attr("aria-label", `${track.title}, ${track.unit || "no unit"}; arrow keys choose a point`);
    this.node = element("figure", {}, element("h3", {}, track.unit ? `${track.title}, ${track.unit}` : track.title), this.readout);
    this.node.append(this.svg.node());
    selection.followKeys(this.svg.node());
    this.svg.on("click", () => this.chooseAt(d3.event.clientX));
  }

  chooseAt(clientX) {
    const left = this.svg.node().getBoundingClientRect().left;
    this.selection.choose(nearest(this.over.values, this.x.invert(clientX - left)));
  }

  draw(over, range, width) {
    this.over = over;
    const { values } = over;
    const from = d3.bisectLeft(values, range[0]);
    const to = Math.max(from + 1, d3.bisectRight(values, range[1]));
    const shown = this.curves.map((curve) => curve.column.values.subarray(from, to));
    const limits = this.track.limits ?? [];
    let [low, high] = extent(...shown);
    const span = high - low || Math.abs(high) || 1;
    for (const limit of limits) if (limit.value > low - 0.6 * span && limit.value < high + 0.6 * span) [low, high] = [Math.min(low, limit.value), Math.max(high, limit.value)];
    const logarithmic = this.track.logarithmic && low > 0 && high / low > 20;
    this.x = d3.scaleLinear().domain(range).range([kMargin.left, width - kMargin.right]);
    this.y = (logarithmic ? d3.scaleLog() : d3.scaleLinear()).domain(low === high ? [low - 1, high + 1] : [low, high]).nice().range([kHeight - kMargin.bottom, kMargin.top]);
    this.svg.attr("width", width).attr("height", kHeight).selectAll("*").remove();
    this.svg.append("title").text(this.track.title);
    this.svg.append("g").attr("class", "axis").attr("transform", `translate(0,${kHeight - kMargin.bottom})`).call(d3.axisBottom(this.x).ticks(Math.max(3, width / 110)));
    this.svg.append("g").attr("class", "axis").attr("transform", `translate(${kMargin.left},0)`).call(logarithmic ? d3.axisLeft(this.y).ticks(4, "~g") : d3.axisLeft(this.y).ticks(4));
    this.svg.append("text").attr("class", "soft").attr("x", width - kMargin.right).attr("y", kHeight - 4).attr("text-anchor", "end").text(over.title);
    this.drawLimits(limits, width);
    for (const { column, series } of this.curves) this.drawCurve(column.values, series, from, to, width);
    this.cursor = this.svg.append("line").attr("class", "chosen").attr("y1", kMargin.top).attr("y2", kHeight - kMargin.bottom);
    this.choose(this.selection.index);
  }

  drawLimits(limits, width) {
    for (const limit of limits) {
      const at = this.y(limit.value);
      if (!(at >= kMargin.top && at <= kHeight - kMargin.bottom)) continue;
      this.svg.append("line").attr("class", "limit").attr("x1", kMargin.left).attr("x2", width - kMargin.right).attr("y1", at).attr("y2", at);
      this.svg.append("text").attr("x", width - kMargin.right).attr("y", at - 3).attr("text-anchor", "end").text(limit.name);
    }
  }

  drawCurve(values, series, from, to, width) {
    const places = thinned(values, from, to, Math.max(50, width - kMargin.left - kMargin.right));
    const line = d3.line().defined((i) => Number.isFinite(values[i])).x((i) => this.x(this.over.values[i])).y((i) => this.y(values[i]));
    this.svg.append("path").attr("class", `curve stroke-${series} dash-${this.curves.length > 1 ? series : 1}`).attr("d", line(places));
    const short = (this.track.limits ?? []).find((limit) => limit.below);
    if (!short) return;
    const marked = places.filter((i) => values[i] < short.value * (1 - 1e-6));
    this.svg.append("g").selectAll("circle").data(marked.slice(0, 400)).join("circle").attr("class", "fill-2").attr("r", 2).attr("cx", (i) => this.x(this.over.values[i])).attr("cy", (i) => this.y(values[i]));
  }

  choose(index) {
    if (!this.x) return;
    const at = this.x(this.over.values[index]);
    const inside = at >= this.x.range()[0] - 1 && at <= this.x.range()[1] + 1;
    this.cursor.attr("x1", at).attr("x2", at).attr("visibility", inside ? "visible" : "hidden");
    this.readout.replaceChildren(...this.curves.map(({ column, series }) => {
      const key = d3.create("svg").attr("width", 26).attr("height", 10).attr("aria-hidden", "true");
      key.append("line").attr("class", `curve stroke-${series} dash-${this.curves.length > 1 ? series : 1}`).attr("x1", 0).attr("x2", 26).attr("y1", 5).attr("y2", 5);
      return element("span", { class: "key" }, key.node(), `${column.name} ${figure(column.values[index], column.unit, column.digits)}`);
    }));
  }
}

/// Panels of all tracks. `columns`: {key: {name, unit, digits, values}}.
export function tracks(section, columns, selection) {
  const over = axes(columns);
  let chosen = "time";
  let range;
  const panels = section.tracks.map((track) => new Panel(track, columns, selection));
  const grid = element("div", { class: "panels" }, panels.map((panel) => panel.node));
  const words = element("span", { class: "soft" });

  function whole() {
    const { values } = over[chosen];
    range = [values[0], values[values.length - 1]];
    if (range[0] === range[1]) range = [range[0], range[0] + 1];
  }
  function draw(scale = 1) {
    const width = Math.max(240, Math.floor(scale * (panels[0].node.clientWidth || 420)));
    words.textContent = `from ${numberText(range[0], 3)} to ${numberText(range[1], 3)}: ${over[chosen].name}`;
    for (const panel of panels) panel.draw(over[chosen], range, width);
  }
  function zoom(factor) {
    const { values } = over[chosen];
    const centre = values[selection.index];
    const half = ((range[1] - range[0]) / 2) * factor;
    const ends = [values[0], values[values.length - 1]];
    const from = Math.max(ends[0], Math.min(centre - half, ends[1] - 2 * half));
    range = [from, Math.min(ends[1], from + 2 * half)];
    if (!(range[1] > range[0])) whole();
    draw();
  }
  const controls = element("div", { class: "controls" },
    chooser({ label: "Over", options: [["time", "time"], ["point", "points"]], value: chosen, change: (of) => { chosen = of; whole(); draw(); } }),
    element("button", { type: "button", onclick: () => zoom(0.4) }, "Closer, around the chosen point"),
    element("button", { type: "button", onclick: () => zoom(2.5) }, "Wider"),
    element("button", { type: "button", onclick: () => { whole(); draw(); } }, "All"), words);
  whole();
  selection.onChange((index) => panels.forEach((panel) => panel.choose(index)));
  new ResizeObserver(() => draw()).observe(grid);
  redrawForPrint(draw);
  return element("div", { class: "tracks" }, element("h3", {}, "Along the program"), controls, grid);
}
