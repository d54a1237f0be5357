// A curve as the pages hold it (every number is text), edited by its control points, and kept in the address.

import { double, snapped } from "./numbers.js";

export const STEPS = 16;

export const copy = (curve) => structuredClone(curve);

export function toHash(state) {
  const text = new TextEncoder().encode(JSON.stringify(state));
  return btoa(String.fromCharCode(...text)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export function fromHash(hash) {
  try {
    const text = atob(hash.replace(/^#/, "").replaceAll("-", "+").replaceAll("_", "/"));
    return JSON.parse(new TextDecoder().decode(Uint8Array.from(text, (c) => c.charCodeAt(0))));
  } catch {
    return null;
  }
}

export class Editor {
  #handles = [];

  // Several in one plane have layers with different ends of their names.
  constructor(plane, changed, layer = "") {
    Object.assign(this, { plane, changed, selected: 0, polygon: `polygon${layer}`, handles: `handles${layer}` });
    plane.layer(this.polygon);
  }

  set(curve) {
    this.curve = copy(curve);
    this.selected = 0;
    this.#rebuild();
    this.changed("new");
  }

  // Another view: the handles stay where the points are.
  redraw() {
    this.#draw();
  }

  setPoint(i, axis, text) {
    if (!Number.isFinite(double(text))) return false;
    this.curve.points[i][axis] = text;
    this.#draw();
    this.changed("typed");
    return true;
  }

  setWeight(i, text) {
    if (!(double(text) > 0)) return false;
    this.curve.weights[i] = text;
    this.#draw();
    this.changed("typed");
    return true;
  }

  #rebuild() {
    this.plane.clear(this.handles);
    this.#handles = this.curve.points.map((p, i) => {
      const handle = this.plane.handle(this.handles, p.map(double), `control point ${i}`, {
        moved: (place) => this.#move(i, place.map((v) => snapped(v, STEPS))),
        stepped: (dx, dy) => this.#move(i, this.curve.points[i].map((v, k) => snapped(double(v) + [dx, dy][k] / STEPS, STEPS))),
        pressed: (key) => this.#weigh(i, key),
        done: () => this.changed("done"),
      });
      handle.onfocus = () => {
        this.selected = i;
        this.changed("selected");
      };
      return handle;
    });
    this.#draw();
  }

  #move(i, point) {
    this.curve.points[i] = point;
    this.#draw();
    this.changed("moved");
  }

  #weigh(i, key) {
    const step = { "+": 1, "=": 1, "-": -1 }[key];
    if (!step) return false;
    const weight = double(this.curve.weights[i]) + step / 4;
    return weight > 0 && this.setWeight(i, snapped(weight, 4));
  }

  #draw() {
    const points = this.curve.points.map((p) => p.map(double));
    this.plane.clear(this.polygon);
    this.plane.line(this.polygon, points);
    this.#handles.forEach((handle, i) => this.plane.moveHandle(handle, points[i]));
  }
}
