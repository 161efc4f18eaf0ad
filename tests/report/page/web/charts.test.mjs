// What the pictures of measurements compute, without a browser. D3 is Debian's.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import test from "node:test";

globalThis.d3 = createRequire(import.meta.url)(process.env.PLUMBLINE_D3 ?? "/usr/share/nodejs/d3/dist/d3.min.js");

const modules = new URL("../../../../src/report/page/web/modules/", import.meta.url);
const from = (name) => import(new URL(`${name}.mjs`, modules));

function packed(values, quantum) {
  const whole = Int32Array.from(values, (value) => (Number.isFinite(value) ? Math.round(value / quantum) : -2147483648));
  return { quantum, data: Buffer.from(whole.buffer).toString("base64") };
}

test("rings beside a circle are steps of 1, 2 or 5", async () => {
  const { ringStep, ringText } = await from("polar");
  assert.equal(ringStep(4), 1);
  assert.equal(ringStep(7), 2);
  assert.ok(Math.abs(ringStep(0.13) - 0.05) < 1e-12);
  assert.equal(ringStep(8000), 2000);
  assert.equal(ringText(0.5, 0.5), "+0.5");
  assert.equal(ringText(-20, 10), "\u221220");
});

test("the largest deviation of all curves is what a circle is drawn for", async () => {
  const { reachOf } = await from("polar");
  assert.equal(reachOf([{ values: [1, -3, NaN] }, { values: [2] }]), 3);
  assert.equal(reachOf([{ values: [0, 0] }]), 1);
});

test("a panel's range holds its curves, bands and limits", async () => {
  const { readPanel, sharedRanges } = await from("curves");
  const x = Float64Array.of(0, 1, 2);
  const one = readPanel({ unit: "um", series: [{ values: packed([1, NaN, 4], 0.5) }], limits: [{ name: "l", value: 7 }] }, x);
  assert.deepEqual(one.range, [1, 7]);
  assert.ok(Number.isNaN(one.series[0].values[1]));
  assert.equal(one.series[0].x, x);
  const two = readPanel({ unit: "um", series: [{ values: [-2, null, 0] }], bands: [{ low: [-9, -9, -9], high: [0, 0, 0] }] }, x);
  assert.deepEqual(two.range, [-9, 0]);
  const zero = readPanel({ unit: "N", series: [{ values: [5, 6] }], from_zero: true }, x);
  assert.deepEqual(zero.range, [0, 6]);
  const shared = sharedRanges([one, two, zero]);
  assert.deepEqual(shared.map((panel) => panel.range), [[-9, 7], [-9, 7], [0, 6]]);
});

test("bars begin at zero and have room for their intervals", async () => {
  const { barRange, barWords } = await from("bars");
  const section = { rows: [{ bars: [{ value: 2, low: 1, high: 4 }] }, { bars: [{ value: null, why: "not measured" }] }] };
  const [low, high] = barRange(section);
  assert.equal(low, 0);
  assert.ok(high > 4 && high < 5);
  assert.ok(barRange({ rows: [{ bars: [{ value: -1 }] }], references: [{ value: 3 }] })[0] < -1);
  assert.equal(barWords({ value: 2, low: 1, high: 4 }, "um", 1), "2.0 um, 1.0 to 4.0");
  assert.equal(barWords({ value: -0.25 }, "N m", 2), "\u22120.25 N m");
  assert.equal(barWords({ value: null }, "um", 2), "none");
});

const map = {
  rows: { name: "Y", unit: "mm", values: [-100, 100] },
  columns: { name: "Motor", labels: ["1", "2"] },
  reasons: ["out of reach"],
};

test("a cell says where it is, what it holds or why it holds nothing", async () => {
  const { cellsOf, cellWords } = await from("heat");
  const plane = { values: packed([1, NaN, 3, 4], 0.5), reasons: { 1: 0 } };
  const cells = cellsOf(plane);
  const figure = { unit: "um", digits: 1 };
  assert.equal(cellWords(map, figure, plane, cells, 2), "Y 100 mm, 1: 3.0 um");
  assert.equal(cellWords(map, figure, plane, cells, 1), "Y \u2212100 mm, 2: out of reach");
  assert.equal(cellWords(map, figure, { values: plane.values }, cells, 1), "Y \u2212100 mm, 2: not known");
  assert.deepEqual([...cellsOf({ values: [[1, 2], [3, 4]] })], [1, 2, 3, 4]);
});

test("arrow keys move within a map and stay in it", async () => {
  const { steppedCell } = await from("heat");
  const steps = ["ArrowRight", "ArrowDown", "ArrowRight", "ArrowDown", "ArrowLeft", "ArrowUp", "ArrowUp", "Home", "End"];
  let cell = 0;
  const passed = steps.map((key) => (cell = steppedCell(cell, key, 2, 3)));
  assert.deepEqual(passed, [1, 4, 5, 5, 4, 1, 1, 0, 5]);
  assert.equal(steppedCell(0, "a", 2, 3), undefined);
});

test("a logarithmic legend has 1, 2, 5 and their tens", async () => {
  const { logTicks, shownPlaces } = await from("heat");
  assert.deepEqual(logTicks(1, 10), [1, 2, 5, 10]);
  assert.deepEqual(logTicks(15, 300), [20, 50, 100, 200]);
  assert.deepEqual(shownPlaces(10, 4), [0, 3, 6, 9]);
  assert.deepEqual(shownPlaces(3, 8), [0, 1, 2]);
});

test("a test's circle begins at angle 0 and goes the way that it says", async () => {
  const { ballOf, circlePoints, travelCorners } = await from("circles");
  const circle = { centre_mm: [10, 0, -5], radius_mm: 3, direction: "ccw" };
  const near = (a, b) => a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) < 1e-9, `${a} is not ${b}`));
  near(circlePoints(circle, 4)[0], [13, 0, -5]);
  near(circlePoints(circle, 4)[1], [10, 3, -5]);
  near(circlePoints({ ...circle, direction: "cw" }, 4)[1], [10, -3, -5]);
  near(ballOf({ ...circle, bar_mm: 5 }), [10, 0, -9]);
  near(ballOf(circle), [10, 0, -5]);
  assert.deepEqual(travelCorners({ x: [-1, 1], y: [-2, 2] }), [[-1, -2, NaN], [1, 2, NaN]]);
});

test("what a cursor says has names, units and what is not known", async () => {
  const { namedValues, roomy, tickText } = await from("drawing");
  assert.equal(namedValues([["measured", 1.25], ["after", NaN]], "um", 1), "measured 1.3 um, after not known");
  assert.equal(tickText(-0.30000000000000004), "\u22120.3");
  assert.deepEqual(roomy([0, 10], 0.1), [-1, 11]);
  assert.ok(roomy([2, 2])[0] < 2);
});

test("a name that is too long loses its middle, so that names of a list stay apart", async () => {
  const { shortened } = await import("../../../../src/report/page/web/modules/drawing.mjs");
  assert.equal(shortened("short", 100), "short");
  const one = shortened("joint-position platform_um strut 5 x", 110);
  const other = shortened("joint-position platform_um strut 5 y", 110);
  assert.ok(one.length <= 15 && one !== other && one.endsWith("strut 5 x") && one.startsWith("join"));
});
