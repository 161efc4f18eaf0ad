import assert from "node:assert/strict";
import { test } from "node:test";

const modules = "../../../../src/report/page/web/modules/";
const { decoded, extent, nearest, thinned } = await import(`${modules}columns.mjs`);
const { countText, figure, numberText, timeText } = await import(`${modules}numbers.mjs`);
const { Selection } = await import(`${modules}selection.mjs`);
const { niceGain, segments } = await import(`${modules}scene.mjs`);

test("packed numbers come back, missing ones as NaN", () => {
  // As tests/report/page/page_test.cpp packs 0, 1, -1, 0.25, nothing, too much by 0.25.
  const values = decoded({ quantum: 0.25, data: "AAAAAAQAAAD8////AQAAAAAAAIAAAACA" });
  assert.deepEqual([...values.slice(0, 4)], [0, 1, -1, 0.25]);
  assert.ok(Number.isNaN(values[4]) && Number.isNaN(values[5]));
  assert.equal(decoded({ quantum: 0.1, data: "AwAAAA==" })[0], 0.3);
  assert.equal(decoded({ quantum: 1, data: "" }).length, 0);
});

test("an extent leaves out what is missing", () => {
  assert.deepEqual(extent([3, NaN, -2], [7]), [-2, 7]);
  assert.deepEqual(extent([NaN]), [0, 1]);
});

test("the nearest of rising numbers", () => {
  const rising = [0, 1, 4, 9];
  assert.deepEqual([-5, 0.4, 0.6, 2.4, 2.6, 99].map((at) => nearest(rising, at)), [0, 0, 1, 1, 2, 3]);
  assert.equal(nearest([5], 7), 0);
});

test("thinned values keep the extremes of each column of pixels, in order", () => {
  const values = Float64Array.from({ length: 10000 }, (_, i) => Math.sin(i / 300));
  values[1234] = 9;
  values[8765] = -9;
  const kept = thinned(values, 0, values.length, 100);
  assert.ok(kept.includes(1234) && kept.includes(8765) && kept.includes(0) && kept.includes(9999));
  assert.ok(kept.length <= 400);
  assert.ok(kept.every((place, i) => i === 0 || place > kept[i - 1]));
  assert.deepEqual(thinned(values, 3, 6, 100), [3, 4, 5]);
});

test("numbers have their unit, a true minus, and no sign at zero", () => {
  assert.equal(figure(-1.25, "um", 1), "\u22121.3 um");
  assert.equal(numberText(-0.0001, 2), "0.00");
  assert.equal(figure(NaN, "um"), "none");
  assert.equal(figure(3, "", 0), "3");
  assert.equal(countText(1234567), "1\u202f234\u202f567");
});

test("times are read as a machinist reads them", () => {
  assert.equal(timeText(0.4121), "0.412 s");
  assert.equal(timeText(187.24), "3 min 07.2 s");
  assert.equal(timeText(7503), "2 h 05 min 03 s");
  assert.equal(timeText(59.9999 + 60), "2 min 00.0 s");
});

test("one point is chosen for all, and stays within the path", () => {
  const selection = new Selection(10);
  const told = [];
  selection.onChange((index) => told.push(index));
  selection.choose(4);
  selection.choose(99);
  selection.choose(-3);
  selection.choose(NaN);
  assert.deepEqual(told, [0, 4, 9, 0]);
});

test("keys choose a point", () => {
  const selection = new Selection(100);
  let listener;
  selection.followKeys({ addEventListener: (_, of) => { listener = of; } });
  const press = (key) => {
    let taken = false;
    listener({ key, preventDefault: () => { taken = true; } });
    return [selection.index, taken];
  };
  assert.deepEqual(press("ArrowRight"), [1, true]);
  assert.deepEqual(press("PageUp"), [6, true]);
  assert.deepEqual(press("End"), [99, true]);
  assert.deepEqual(press("ArrowLeft"), [98, true]);
  assert.deepEqual(press("Home"), [0, true]);
  assert.deepEqual(press("x"), [0, false]);
});

test("the first gain shows the shift as an eighth of the path, in round numbers", () => {
  assert.equal(niceGain(400, 100), 500);
  assert.equal(niceGain(400, 26), 1000);
  assert.equal(niceGain(1, 1e6), 1);
  assert.equal(niceGain(400, 0), 1);
});

test("segments of a kind lead from the point before", () => {
  assert.deepEqual(segments([0, 1, 2, 2, 0, 2], (kind) => kind === 2), [1, 2, 2, 3, 4, 5]);
});
