// The lines of a path in space: all of them, and fewer that can be drawn again in every frame.

/// Ends of the segments that belong to `wanted(kind)`: pairs of point numbers.
export function segments(kinds, wanted) {
  const pairs = [];
  for (let i = 1; i < kinds.length; ++i) if (wanted(kinds[i])) pairs.push(i - 1, i);
  return pairs;
}

const kMostMerged = 32;

/// How far the points between two others are at most from the straight line through these.
function awayFromChord({ x, y, z }, from, to) {
  const way = [x[to] - x[from], y[to] - y[from], z[to] - z[from]];
  const square = way[0] ** 2 + way[1] ** 2 + way[2] ** 2;
  let most = 0;
  for (let i = from + 1; i < to; ++i) {
    const at = [x[i] - x[from], y[i] - y[from], z[i] - z[from]];
    const share = square > 0 ? Math.max(0, Math.min(1, (at[0] * way[0] + at[1] * way[1] + at[2] * way[2]) / square)) : 0;
    most = Math.max(most, Math.hypot(at[0] - share * way[0], at[1] - share * way[1], at[2] - share * way[2]));
  }
  return most;
}

/// Fewer segments that look the same: those in a row are made one where no point between is farther off than
/// `tolerance`. Points of `kept` stay ends of segments.
export function simplified(pairs, places, tolerance, kept = new Set()) {
  const made = [];
  for (let i = 0; i < pairs.length; i += 2) {
    const last = made.length - 2;
    const [from, to] = [pairs[i], pairs[i + 1]];
    const joins = last >= 0 && made[last + 1] === from && !kept.has(from) && to - made[last] <= kMostMerged;
    if (joins && awayFromChord(places, made[last], to) <= tolerance) made[last + 1] = to;
    else made.push(from, to);
  }
  return made;
}

/// About `most` of the segments, evenly, and all that end at a point of `kept`.
export function sampled(pairs, most, kept = new Set()) {
  const every = Math.max(1, Math.ceil(pairs.length / 2 / most));
  const made = [];
  for (let i = 0; i < pairs.length; i += 2) {
    if ((i / 2) % every === 0 || kept.has(pairs[i + 1])) made.push(pairs[i], pairs[i + 1]);
  }
  return made;
}

/// Points where one of the columns is least or largest.
export function extremePoints(columns) {
  const found = new Set();
  for (const values of columns) {
    let least = -1;
    let largest = -1;
    for (let i = 0; i < values.length; ++i) {
      if (Number.isNaN(values[i])) continue;
      if (least < 0 || values[i] < values[least]) least = i;
      if (largest < 0 || values[i] > values[largest]) largest = i;
    }
    if (least >= 0) found.add(least).add(largest);
  }
  return found;
}

const kMostWide = 8000;  // wide lines are rectangles: four times the work without a graphics card

/// Lines of one pixel, which is all that a graphics card draws as lines.
function thinLines({ color, opacity, dash, gap }) {
  const look = color === undefined ? { vertexColors: THREE.VertexColors } : { color };
  if (opacity !== undefined) Object.assign(look, { transparent: true, opacity });
  return new THREE.LineSegments(new THREE.BufferGeometry(),
    dash === undefined ? new THREE.LineBasicMaterial(look) : new THREE.LineDashedMaterial({ ...look, dashSize: dash, gapSize: gap }));
}

/// Lines of `width` pixels, in the colours of their points.
function wideLines({ width }) {
  return new THREE.LineSegments2(new THREE.LineSegmentsGeometry(),
    new THREE.LineMaterial({ vertexColors: THREE.VertexColors, linewidth: width }));
}

/// Lines between places of points: all of them, or a coarse picture of as few as are wanted. What is not drawn is not
/// computed.
export class PathLines {
  #writers = {};

  /// `draft` is what a coarse picture is made of: segments that look like all of them; `kept` are never left out.
  /// `stroke`: `color` (without one each point has its own), `opacity`, `dash` and `gap`, `width` in pixels, which
  /// counts where the lines are not too many and have the colours of their points.
  constructor(pairs, draft, kept, stroke) {
    Object.assign(this, { pairs, draft, kept });
    this.wide = stroke.width !== undefined && pairs.length > 0 && pairs.length / 2 <= kMostWide;
    this.whole = this.#prepared(this.wide ? wideLines(stroke) : thinLines(stroke), pairs);
    this.coarse = this.#prepared(thinLines(stroke), []);
    this.coarse.visible = false;
    this.group = new THREE.Group();
    this.group.add(this.whole, this.coarse);
  }

  get count() {
    return this.pairs.length / 2;
  }

  /// The size of the picture, which the width of lines counts in.
  setSize(width, height) {
    if (this.wide) this.whole.material.resolution.set(width, height);
  }

  #prepared(object, pairs) {
    object.frustumCulled = false;
    object.userData = { pairs, done: {} };
    return object;
  }

  /// `write(point, numbers, at)` writes the place of a point.
  place(write) {
    this.#writers.position = { write, end: 0 };
  }

  /// The same for red, green and blue: a segment has the colour of its end.
  colour(write) {
    this.#writers.color = { write, end: 1 };
  }

  #fill(object) {
    const { pairs, done } = object.userData;
    for (const [name, writer] of Object.entries(this.#writers)) {
      if (done[name] === writer) continue;
      const numbers = new Float32Array(3 * pairs.length);
      for (let i = 0; i < pairs.length; ++i) writer.write(pairs[i | writer.end], numbers, 3 * i);
      if (object.isLineSegments2) object.geometry[name === "position" ? "setPositions" : "setColors"](numbers);
      else object.geometry.setAttribute(name, new THREE.BufferAttribute(numbers, 3));
      if (name === "position" && object.material.isLineDashedMaterial) object.computeLineDistances();
      done[name] = writer;
    }
  }

  /// From now on about `most` segments are drawn; how many they are.
  drawCoarse(most) {
    if (most >= this.count) {
      this.drawWhole();
      return this.count;
    }
    if (this.most !== most) this.coarse.userData = { pairs: sampled(this.draft, most, this.kept), done: {} };
    this.most = most;
    this.#fill(this.coarse);
    this.whole.visible = false;
    this.coarse.visible = true;
    return this.coarse.userData.pairs.length / 2;
  }

  /// From now on all segments are drawn, or so many from one on; wide ones at once, with the first.
  drawWhole(from = 0, count = Infinity) {
    this.#fill(this.whole);
    this.whole.visible = true;
    this.coarse.visible = false;
    if (this.wide) this.whole.visible = from === 0;
    else this.whole.geometry.setDrawRange(2 * from, 2 * count);
  }
}
