import assert from "node:assert/strict";
import { test } from "node:test";

const modules = "../../../../src/report/page/web/modules/";
const { decoded, extent, nearest, thinned } = await import(`${modules}columns.mjs`);
const { countText, figure, numberText, timeText } = await import(`${modules}numbers.mjs`);
const { Selection } = await import(`${modules}selection.mjs`);
const { fitted, niceGain } = await import(`${modules}scene.mjs`);
const { extremePoints, PathLines, sampled, segments, simplified } = await import(`${modules}path_lines.mjs`);
const { valuesOfCuts } = await import(`${modules}program.mjs`);
const { Pace } = await import(`${modules}pace.mjs`);

test("packed numbers come back, missing ones as NaN", () => {
  // As tests/report/page/page_test.cpp packs 0, 1, -1, 0.25, nothing, too much by 0.25.
  const values = decoded({ quantum: 0.25, data: "AAAAAAQAAAD8////AQAAAAAAAIAAAACA" });
  assert.deepEqual([...values.slice(0, 4)], [0, 1, -1, 0.25]);
  assert.ok(Number.isNaN(values[4]) && Number.isNaN(values[5]));
  assert.equal(decoded({ quantum: 0.1, data: "AwAAAA==" })[0], 0.3);
  assert.equal(decoded({ quantum: 1, data: "" }).length, 0);
});

test("tools and ways have a colour each that cuts, in order", () => {
  const columns = { kind: { values: Float64Array.of(0, 3, 1, 2, 2) }, tool: { values: Float64Array.of(9, 2, 7, -1, 2) } };
  assert.deepEqual([...valuesOfCuts(columns, "kind")], [2, 3]);
  assert.deepEqual([...valuesOfCuts(columns, "tool")], [-1, 2]);
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
  assert.equal(countText(1234567), "1,234,567");
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

test("a coarse path keeps its corners and leaves out what lies between", () => {
  const count = 101;
  const x = Float64Array.from({ length: count }, (_, i) => Math.min(i, 50));
  const y = Float64Array.from({ length: count }, (_, i) => Math.max(0, i - 50));
  const places = { x, y, z: new Float64Array(count) };
  const pairs = segments(new Uint8Array(count).fill(2), () => true);
  const made = simplified(pairs, places, 1e-9, new Set([77]));
  const ends = new Set(made);
  assert.ok(made.length < pairs.length / 10);
  for (const corner of [0, 50, 77, 100]) assert.ok(ends.has(corner));
  for (let i = 2; i < made.length; i += 2) assert.equal(made[i], made[i - 1]);
  assert.deepEqual(simplified([0, 1, 1, 2, 5, 6], { x: [0, 1, 2, 3, 4, 5, 6], y: new Float64Array(7), z: new Float64Array(7) }, 1), [0, 2, 5, 6]);
  // A way there and back is no straight line.
  assert.deepEqual(simplified([0, 1, 1, 2], { x: [0, 9, 1], y: [0, 0, 0], z: [0, 0, 0] }, 0.5), [0, 1, 1, 2]);
});

test("a sample of segments is even and keeps the extremes", () => {
  const pairs = Array.from({ length: 2000 }, (_, i) => (i + 1) >> 1);
  const made = sampled(pairs, 100, new Set([333]));
  assert.ok(made.length / 2 >= 100 && made.length / 2 <= 101);
  assert.ok(made.some((to, i) => i % 2 === 1 && to === 333));
  assert.deepEqual(sampled(pairs, 5000), pairs);
  assert.deepEqual([...extremePoints([[3, NaN, 9, -1], [NaN]])].sort(), [2, 3]);
});

test("a pace finds how much takes a frame, and stays there", () => {
  const run = (pace, msOf, frames = 60) => {
    for (let i = 0; i < frames; ++i) pace.take(pace.count, msOf(pace.count));
    return pace.count;
  };
  const slow = run(new Pace(1000, 50), (count) => 5 + count / 20);
  assert.ok(5 + slow / 20 <= 30 && slow >= 100);
  assert.ok(run(new Pace(1000, 50), (count) => 1 + count / 100000) > 100000);
  assert.equal(run(new Pace(1000, 400), () => 200), 400);
  const once = new Pace(1000, 400);
  once.take(1000, 900);  // the first
  assert.equal(once.count, 1000);
  once.take(10, 1);  // too few to tell
  assert.equal(once.count, 1000);
});

test("a view holds all places, and one of them touches its margin", () => {
  const places = Array.from({ length: 200 }, (_, i) => [300 * Math.cos(i), 90 * Math.sin(2 * i) - 40, 500 + 20 * Math.sin(3 * i)]);
  for (const from of [[0.55, -0.75, 0.5], [1, 0, 0], [0, -1, 0], [0, -0.001, 1]]) {
    const { centre, away } = fitted(places, from, 0.5, 0.25);
    const back = from.map((part) => part / Math.hypot(...from));
    const right = [-back[1], back[0], 0].map((part) => part / Math.hypot(back[0], back[1]));
    const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0]];
    const along = (a, b) => a.reduce((sum, part, i) => sum + part * b[i], 0);
    const fills = places.map((place) => {
      const at = place.map((part, i) => part - centre[i]);
      const depth = away - along(at, back);
      return Math.max(Math.abs(along(at, right)) / depth / 0.5, Math.abs(along(at, up)) / depth / 0.25);
    });
    assert.ok(Math.max(...fills) < 1 && Math.max(...fills) > 0.7, `from ${from}: ${Math.max(...fills)}`);
  }
});

test("few lines in the colours of their points are wide and drawn at once, many are thin and drawn in parts", () => {
  class Geometry {
    setAttribute() {}
    setDrawRange(...range) { this.range = range; }
    setPositions(numbers) { this.positions = numbers; }
    setColors(numbers) { this.colours = numbers; }
  }
  const object = (wide) => class {
    constructor(geometry, material) { Object.assign(this, { geometry, material, isLineSegments2: wide }); }
  };
  globalThis.THREE = {
    BufferGeometry: Geometry, LineSegmentsGeometry: Geometry, BufferAttribute: class {}, VertexColors: 2,
    LineSegments: object(false), LineSegments2: object(true), LineBasicMaterial: class {},
    LineMaterial: class { resolution = { set: (...size) => { this.size = size; } }; }, Group: class { add() {} },
  };
  const few = new PathLines([0, 1, 1, 2], [0, 2], new Set(), { width: 3 });
  few.setSize(800, 600);
  few.place((point, numbers, at) => numbers.set([point, 0, 0], at));
  few.colour((point, numbers, at) => numbers.set([0, point, 0], at));
  few.drawWhole(0, 1);
  assert.ok(few.whole.visible);
  assert.deepEqual(few.whole.material.size, [800, 600]);
  assert.deepEqual([...few.whole.geometry.positions], [0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0]);
  assert.deepEqual([...few.whole.geometry.colours], [0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 2, 0]);
  few.drawWhole(1, 1);
  assert.ok(!few.whole.visible);
  const many = new PathLines(Array.from({ length: 20000 }, (_, i) => (i + 1) >> 1), [0, 1], new Set(), { width: 3 });
  many.drawWhole(100, 50);
  assert.ok(many.whole.visible);
  assert.deepEqual(many.whole.geometry.range, [200, 100]);
  delete globalThis.THREE;
});
