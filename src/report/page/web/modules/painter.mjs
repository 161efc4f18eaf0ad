// Draws a scene again and again: what moves is drawn as finely as a frame allows; at rest follows the whole picture,
// smooth, in parts that are a frame long each.
import { Pace } from "./pace.mjs";

const kRestMs = 150;
const kSamples = 4;

/// A picture with smooth edges which parts are added to; `show` puts it on the canvas.
class SmoothPicture {
  constructor(renderer) {
    this.renderer = renderer;
    this.target = new THREE.WebGLMultisampleRenderTarget(1, 1, { stencilBuffer: true, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
    this.target.samples = kSamples;
    this.flat = new THREE.Scene();
    this.flat.add(new THREE.Mesh(new THREE.PlaneBufferGeometry(2, 2),
      new THREE.MeshBasicMaterial({ map: this.target.texture, blending: THREE.NoBlending, depthTest: false, depthWrite: false })));
    this.front = new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1);
  }
  add(scene, camera, first) {
    const { width, height } = this.renderer.domElement;
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    this.renderer.setRenderTarget(this.target);
    this.renderer.autoClear = first;
    this.renderer.render(scene, camera);
    this.renderer.autoClear = true;
    this.renderer.setRenderTarget(null);
  }
  show() {
    this.renderer.render(this.flat, this.front);
  }
}

function linesOf(layers) {
  return layers.reduce((sum, layer) => sum + layer.count, 0);
}

/// Of the lines of all layers, counted through, only those from one up to another one.
function showOnly(layers, from, to) {
  let begin = 0;
  for (const layer of layers) {
    const first = Math.max(from, begin);
    const count = Math.min(to, begin + layer.count) - first;
    layer.group.visible = count > 0;
    if (count > 0) layer.drawWhole(first - begin, count);
    begin += layer.count;
  }
}

/// Tells how long what was given to the graphics processor took, some milliseconds after it is done.
class Stopwatch {
  constructor(context) {
    this.context = context;
    this.running = 0;
  }
  /// `tell(ms)` after all that was drawn up to now.
  ask(begin, tell) {
    const gl = this.context;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    this.running += 1;
    const look = () => {
      if (!gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
        setTimeout(look, 1);
        return;
      }
      gl.deleteSync(fence);
      this.running -= 1;
      tell(performance.now() - begin);
    };
    setTimeout(look, 1);
  }
}

export class Painter {
  #waiting = false;
  #rest;
  #parts;

  /// Throws where there is no WebGL 2.
  constructor(box, scene, camera) {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { alpha: true, antialias: false, stencil: false, preserveDrawingBuffer: true });
    if (!context) throw new Error("no WebGL 2");
    this.renderer = new THREE.WebGLRenderer({ canvas, context, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    box.append(canvas);
    Object.assign(this, { box, scene, camera, layers: [], others: [] });
    this.smooth = new SmoothPicture(this.renderer);
    this.stopwatch = new Stopwatch(context);
    this.quickPace = new Pace(1000, 400);
    this.smoothPace = new Pace(2000, 500);
    window.addEventListener("beforeprint", () => this.drawWhole());
  }

  get canvas() {
    return this.renderer.domElement;
  }

  /// Lines of the path, which may be drawn coarse or in parts, and all else that is in the scene.
  setContent(layers, others) {
    this.layers = layers;
    this.others = others;
  }

  setSize(width, height) {
    this.renderer.setSize(width, height, false);
  }

  /// In the next frame.
  draw() {
    clearTimeout(this.#rest);
    this.#parts = undefined;
    this.#ask(() => this.#quick());
  }

  /// At once and all of it.
  drawWhole() {
    clearTimeout(this.#rest);
    this.#parts = undefined;
    for (const layer of this.#shown()) layer.drawWhole();
    this.smooth.add(this.scene, this.camera, true);
    this.smooth.show();
    this.#tellDrawn("whole");
  }

  #tellDrawn(how) {
    this.box.dataset.drawn = how;
  }

  /// Not before the frame before the last is done: what is asked for meanwhile is drawn once.
  #ask(paint) {
    this.paint = paint;
    if (this.#waiting) return;
    this.#waiting = true;
    const when = () => {
      if (this.stopwatch.running > 1) {
        requestAnimationFrame(when);
        return;
      }
      this.#waiting = false;
      this.paint();
    };
    requestAnimationFrame(when);
  }

  #shown() {
    return this.layers.filter((layer) => layer.group.visible && layer.count > 0);
  }

  #quick() {
    const shown = this.#shown();
    const all = linesOf(shown);
    const begin = performance.now();
    if (all <= this.smoothPace.count) {
      this.drawWhole();
      this.stopwatch.ask(begin, (ms) => this.smoothPace.take(all, ms));
      return;
    }
    const share = Math.min(1, this.quickPace.count / all);
    const drawn = shown.reduce((sum, layer) => sum + layer.drawCoarse(Math.ceil(share * layer.count)), 0);
    this.renderer.render(this.scene, this.camera);
    this.#tellDrawn("quick");
    this.stopwatch.ask(begin, (ms) => this.quickPace.take(drawn, ms));
    this.#rest = setTimeout(() => this.#beginWhole(), kRestMs);
  }

  /// The whole picture in parts: layer after layer, what is no path with the last part.
  #beginWhole() {
    const layers = this.#shown();
    this.#parts = { layers, all: linesOf(layers), from: 0 };
    this.#ask(() => this.#addPart());
  }

  #addPart() {
    const at = this.#parts;
    if (!at) return;
    const { from } = at;
    const to = Math.min(at.all, from + this.smoothPace.count);
    const last = to === at.all;
    const shown = this.others.filter((one) => one.visible);
    for (const one of shown) one.visible = last;
    showOnly(at.layers, from, to);
    const begin = performance.now();
    this.smooth.add(this.scene, this.camera, from === 0);
    for (const one of [...shown, ...at.layers.map((layer) => layer.group)]) one.visible = true;
    at.from = to;
    this.stopwatch.ask(begin, (ms) => {
      this.smoothPace.take(to - from, ms);
      if (this.#parts !== at) return;
      if (!last) {
        this.#ask(() => this.#addPart());
        return;
      }
      this.#parts = undefined;
      this.smooth.show();
      this.#tellDrawn("whole");
    });
  }
}
