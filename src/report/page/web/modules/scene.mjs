// The path and the machine in space. Z of the machine is up.
import { Painter } from "./painter.mjs";
import { extremePoints, PathLines, segments, simplified } from "./path_lines.mjs";

const kKinds = { gap: 0, rapid: 1, line: 2, arc: 3 };

function vector(x, y, z) {
  return new THREE.Vector3(x, y, z);
}

/// A straight bar between two places.
class Bar {
  constructor(radius, material) {
    this.mesh = new THREE.Mesh(new THREE.CylinderBufferGeometry(radius, radius, 1, 12), material);
  }
  put(from, to) {
    const way = to.clone().sub(from);
    this.mesh.position.copy(from).addScaledVector(way, 0.5);
    this.mesh.visible = way.length() > 0;  // the tool of a machine whose tip is at its platform has no length
    if (!this.mesh.visible) return;
    this.mesh.scale.set(1, way.length(), 1);
    this.mesh.quaternion.setFromUnitVectors(vector(0, 1, 0), way.normalize());
  }
}

function plate(points, material) {
  const geometry = new THREE.BufferGeometry();
  const centre = points.reduce((sum, p) => sum.add(p), vector(0, 0, 0)).multiplyScalar(1 / points.length);
  const around = points.slice().sort((a, b) => Math.atan2(a.y - centre.y, a.x - centre.x) - Math.atan2(b.y - centre.y, b.x - centre.x));
  const corners = [];
  around.forEach((p, i) => {
    const q = around[(i + 1) % around.length];
    corners.push(centre.x, centre.y, centre.z, p.x, p.y, p.z, q.x, q.y, q.z);
  });
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(corners), 3));
  geometry.computeVertexNormals();
  return new THREE.Mesh(geometry, material);
}

/// Base, platform, six struts, spindle and tool.
class MachineDrawing {
  constructor(machine, reach) {
    this.group = new THREE.Group();
    const steel = new THREE.MeshLambertMaterial({ color: 0x7d8894 });
    const frame = new THREE.MeshLambertMaterial({ color: 0x9aa5b1, side: THREE.DoubleSide, transparent: true, opacity: 0.55 });
    this.base = machine.base.map((p) => vector(...p));
    this.platform = machine.platform.map((p) => vector(...p));
    this.tip = machine.tip;
    this.shortest = machine.shortest;
    this.longest = machine.longest;
    this.ends = [];
    this.group.add(plate(this.base, frame));
    this.body = plate(this.platform, frame);
    this.group.add(this.body);
    const radius = reach / 200;
    this.struts = this.base.map(() => new Bar(radius, steel.clone()));
    this.middle = this.platform.reduce((sum, p) => sum.add(p), vector(0, 0, 0)).multiplyScalar(1 / this.platform.length);
    this.spindle = new Bar(radius * 3, steel);
    this.tool = new Bar(radius * 1.4, new THREE.MeshLambertMaterial({ color: 0xd55e00 }));
    for (const bar of [...this.struts, this.spindle, this.tool]) this.group.add(bar.mesh);
  }
  /// `tip` in W, orientation as a quaternion, how far along Z of the platform the tip is.
  put(tip, turn, along) {
    const offset = vector(this.tip[0], this.tip[1], along).applyQuaternion(turn);
    const origin = tip.clone().sub(offset);
    this.body.position.copy(origin);
    this.body.quaternion.copy(turn);
    this.ends = this.platform.map((p) => p.clone().applyQuaternion(turn).add(origin));
    this.struts.forEach((bar, j) => {
      const end = this.ends[j];
      bar.put(this.base[j], end);
      const length = end.distanceTo(this.base[j]);
      const room = Math.min(length - this.shortest[j], this.longest[j] - length);
      const near = room < 0.02 * (this.longest[j] - this.shortest[j]);
      bar.mesh.material.color.set(near ? 0xa4133c : 0x7d8894);
    });
    const gauge = vector(this.tip[0], this.tip[1], 0).applyQuaternion(turn).add(origin);
    this.spindle.put(this.middle.clone().applyQuaternion(turn).add(origin), gauge);
    this.tool.put(gauge, tip);
  }
}

/// The largest shift that a gain makes visible: an eighth of the size of the path, as a round number.
export function niceGain(size, shiftUm) {
  if (!(shiftUm > 0) || !(size > 0)) return 1;
  const wanted = size / 8 / (shiftUm / 1000);
  const power = 10 ** Math.floor(Math.log10(wanted));
  const round = [5, 2, 1].find((of) => of * power <= wanted) ?? 1;
  return Math.max(1, round * power);
}

/// Where to look at, and from how far in the direction `from`, so that all `places` lie in a picture whose sides rise
/// by `wide` and `high` a unit of depth. Z is up.
export function fitted(places, from, wide, high) {
  const length = Math.hypot(...from);
  const back = from.map((part) => part / length);
  const across = Math.hypot(back[0], back[1]);
  const right = [-back[1] / across, back[0] / across, 0];
  const up = [-back[2] * right[1], back[2] * right[0], back[0] * right[1] - back[1] * right[0]];
  const along = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const frame = [right, up, back];
  const seen = Array.from(places, (place) => frame.map((axis) => along(place, axis)));
  const middle = frame.map((_, axis) => {
    let [least, most] = [Infinity, -Infinity];
    for (const place of seen) [least, most] = [Math.min(least, place[axis]), Math.max(most, place[axis])];
    return (least + most) / 2;
  });
  let away = 1;
  for (const [r, u, b] of seen) {
    away = Math.max(away, Math.max(Math.abs(r - middle[0]) / wide, Math.abs(u - middle[1]) / high) + b - middle[2]);
  }
  return { centre: [0, 1, 2].map((i) => along(middle, frame.map((axis) => axis[i]))), away: 1.1 * away };
}

export class Scene {
  constructor(box, columns, section) {
    this.columns = columns;
    this.section = section;
    this.box = box;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1, 1, 100000);
    this.camera.up.set(0, 0, 1);
    this.painter = new Painter(box, this.scene, this.camera);
    this.orbit = new THREE.OrbitControls(this.camera, this.painter.canvas);
    this.orbit.enableKeys = false;
    this.orbit.addEventListener("change", () => this.draw());
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x666666, 1));
    this.addPath();
    this.addMachine();
    this.painter.setContent(this.layers(), this.others);
    this.looked = "path";
    new ResizeObserver(() => this.resize()).observe(box);
    this.look(this.looked);
  }

  layers() {
    return [this.path, this.rapids, this.told, this.sagging];
  }

  place(point) {
    const { x, y, z } = this.columns;
    return [x[point], y[point], z[point]];
  }

  addPath() {
    const { kind, x, y, z } = this.columns;
    const cuts = segments(kind, (of) => of >= kKinds.line);
    const kept = extremePoints([x, y, z]);
    for (const { point } of this.section.worst) kept.add(point);
    const bounds = new THREE.Box3();
    for (let i = 0; i < x.length; ++i) bounds.expandByPoint(vector(x[i], y[i], z[i]));
    this.size = Math.max(1, bounds.getSize(vector(0, 0, 0)).length());
    const draft = simplified(cuts, this.columns, this.size / 500, kept);
    this.path = new PathLines(cuts, draft, kept, { width: 3 });
    const rapids = segments(kind, (of) => of === kKinds.rapid);
    this.rapids = new PathLines(rapids, rapids, kept, { color: 0x8a8f96, dash: this.size / 120, gap: this.size / 160 });
    const shifted = (column, color) => new PathLines(column ? cuts : [], column ? draft : [], kept, { color, opacity: 0.6 });
    this.told = shifted(this.columns.cx, 0x0072b2);
    this.sagging = shifted(this.columns.ex, 0xd55e00);
    const asked = (point, numbers, at) => {
      numbers[at] = x[point];
      numbers[at + 1] = y[point];
      numbers[at + 2] = z[point];
    };
    for (const layer of this.layers()) {
      layer.place(asked);
      this.scene.add(layer.group);
    }
    this.marker = new THREE.Mesh(new THREE.SphereBufferGeometry(this.size / 110, 16, 12), new THREE.MeshBasicMaterial({ color: 0xd1006c }));
    this.others = [this.marker];
    this.scene.add(this.marker);
  }

  addMachine() {
    this.reach = this.size;
    const axes = new THREE.AxesHelper(this.size / 6);
    this.scene.add(axes);
    this.others.push(axes);
    if (!this.section.machine) return;
    const box = new THREE.Box3();
    for (const p of this.section.machine.base) box.expandByPoint(vector(...p));
    this.reach = Math.max(this.size, box.getSize(vector(0, 0, 0)).length());
    this.machine = new MachineDrawing(this.section.machine, this.reach);
    this.scene.add(this.machine.group);
    this.others.push(this.machine.group);
    const travel = this.section.machine.travel;
    if (travel.every((range) => range.every((value) => value !== null))) {
      const space = new THREE.Box3(vector(...travel.map((range) => range[0])), vector(...travel.map((range) => range[1])));
      this.travel = new THREE.Box3Helper(space, 0x8a8f96);
      this.scene.add(this.travel);
      this.others.push(this.travel);
    }
  }

  /// What a view must hold: the path with what is drawn of its shift, the machine or its travel.
  *placesOf(at) {
    for (let i = 0; i < this.columns.x.length; ++i) {
      yield this.place(i);
      for (const [layer, shifted] of this.shifts ?? []) if (layer.group.visible) yield shifted(i);
    }
    if (at === "machine" && this.machine) yield* [...this.section.machine.base, ...this.machine.ends.map((p) => p.toArray())];
    if (at === "travel" && this.travel) {
      const { min, max } = this.travel.box;
      for (let i = 0; i < 8; ++i) yield [i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z];
    }
  }

  /// "path", "machine", "travel", or from "x", "y", "z".
  look(at) {
    this.looked = at;
    const from = { x: [1, 0, 0], y: [0, -1, 0], z: [0, -0.001, 1] }[at] ?? [0.55, -0.75, 0.5];
    const slope = Math.tan((this.camera.fov / 2) * (Math.PI / 180));
    const { centre, away } = fitted(this.placesOf(at), from, slope * this.camera.aspect, slope);
    this.orbit.target.set(...centre);
    this.camera.position.set(...centre).addScaledVector(vector(...from).normalize(), away);
    this.camera.near = away / 500;
    this.camera.far = away * 60;
    this.camera.updateProjectionMatrix();
    this.orbit.update();
    this.draw();
  }

  /// Colours the path by a column: `colourOf` of a value is a colour in words.
  colour(values, colourOf) {
    const read = new Map();  // words are read once: a ramp has some hundred
    const partsOf = (word) => {
      if (!read.has(word)) read.set(word, new THREE.Color(word).toArray());
      return read.get(word);
    };
    this.path.colour((point, numbers, at) => numbers.set(partsOf(colourOf(values[point])), at));
    this.draw();
  }

  /// Draws what the control is told and where the tip would go without it, their distances from the path times `gain`.
  exaggerate(gain) {
    const { x, y, z, cx, cy, cz, ex, ey, ez } = this.columns;
    const by = gain / 1000;
    const shifted = (dx, dy, dz) => (point) => [x[point] + by * (dx[point] || 0), y[point] + by * (dy[point] || 0), z[point] + by * (dz[point] || 0)];
    this.shifts = [];
    if (cx) this.shifts.push([this.told, shifted(cx, cy, cz)]);
    if (ex) this.shifts.push([this.sagging, shifted(ex, ey, ez)]);
    for (const [layer, place] of this.shifts) layer.place((point, numbers, at) => numbers.set(place(point), at));
    this.draw();
  }

  show(name, visible) {
    const parts = { machine: this.machine?.group, rapids: this.rapids.group, told: this.told.group, sagging: this.sagging.group, travel: this.travel };
    if (parts[name]) parts[name].visible = visible;
    this.draw();
  }

  choose(point) {
    const { px, py, pz, qx, qy, qz, qw, tip } = this.columns;
    this.marker.position.set(...this.place(point));
    if (this.machine) this.machine.put(vector(px[point], py[point], pz[point]), new THREE.Quaternion(qx[point], qy[point], qz[point], qw[point]), tip[point]);
    this.draw();
  }

  /// The point of the path that is drawn nearest to a place of the picture; -1 where none is within 24 pixels.
  pointAt(clientX, clientY) {
    const rect = this.painter.canvas.getBoundingClientRect();
    let best = -1;
    let least = 24 ** 2;
    const place = vector(0, 0, 0);
    for (let i = 0; i < this.columns.x.length; ++i) {
      place.set(...this.place(i)).project(this.camera);
      if (place.z > 1) continue;
      const dx = rect.left + ((place.x + 1) / 2) * rect.width - clientX;
      const dy = rect.top + ((1 - place.y) / 2) * rect.height - clientY;
      const distance = dx * dx + dy * dy;
      if (distance < least) {
        least = distance;
        best = i;
      }
    }
    return best;
  }

  resize() {
    const { clientWidth, clientHeight } = this.box;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.painter.setSize(clientWidth, clientHeight);
    for (const layer of this.layers()) layer.setSize(clientWidth, clientHeight);
    const turned = this.camera.aspect !== clientWidth / clientHeight;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (turned) this.look(this.looked);
    this.draw();
  }

  draw() {
    this.painter.draw();
  }
}
