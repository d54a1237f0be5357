// A plane to draw in: coordinates with y upwards, layers, a grid, and points that are dragged by pointer or keys.

import { svg, path } from "./svg.js";

const WIDTH = 720;
const MARGIN = 36;

const SHAPES = {
  disc: "M5 0A5 5 0 1 1 -5 0A5 5 0 1 1 5 0Z",
  diamond: "M0 -6.5L6.5 0L0 6.5L-6.5 0Z",
  square: "M-5 -5H5V5H-5Z",
  triangle: "M0 -6L6 5H-6Z",
  cross: "M-5 -5L5 5M5 -5L-5 5",
};

// A mark by itself, for a legend.
export function symbol(shape, style) {
  return svg("svg", { viewBox: "-8 -8 16 16", width: 16, height: 16, "aria-hidden": "true" }, svg("path", { d: SHAPES[shape], class: style }));
}

export class Plane {
  constructor(host, { height = 520, label }) {
    this.height = height;
    this.element = svg("svg", { viewBox: `0 0 ${WIDTH} ${height}`, role: "group", "aria-label": label, class: "plane" });
    host.append(this.element);
    this.layers = new Map();
    this.view = { x: 0, y: 0, unit: 50 };
    this.layer("grid");
  }

  layer(name) {
    if (!this.layers.has(name)) {
      const made = svg("g", { class: name });
      this.layers.set(name, made);
      this.element.append(made);
    }
    return this.layers.get(name);
  }

  // Choose the view so that these points are inside; units of both axes are alike, and at most this large.
  fit(points, largest = 200) {
    const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const unit = Math.min(
      (WIDTH - 2 * MARGIN) / Math.max(right - left, 1e-9),
      (this.height - 2 * MARGIN) / Math.max(high - low, 1e-9),
    );
    this.view = { x: (left + right) / 2, y: (low + high) / 2, unit: Math.min(unit, largest) };
    this.#grid();
  }

  to([x, y]) {
    const { x: x0, y: y0, unit } = this.view;
    return [WIDTH / 2 + (x - x0) * unit, this.height / 2 - (y - y0) * unit];
  }

  from([x, y]) {
    const { x: x0, y: y0, unit } = this.view;
    return [x0 + (x - WIDTH / 2) / unit, y0 - (y - this.height / 2) / unit];
  }

  // The place of a pointer in the plane.
  place(event) {
    const box = this.element.getBoundingClientRect();
    const scale = WIDTH / box.width;
    return this.from([(event.clientX - box.left) * scale, (event.clientY - box.top) * scale]);
  }

  #grid() {
    const raw = 60 / this.view.unit;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= raw);
    const [left, high] = this.from([0, 0]);
    const [right, low] = this.from([WIDTH, this.height]);
    const lines = [];
    for (let x = Math.ceil(left / step) * step; x <= right; x += step) lines.push([[x, low], [x, high], x, 0]);
    for (let y = Math.ceil(low / step) * step; y <= high; y += step) lines.push([[left, y], [right, y], y, 1]);
    this.layer("grid").replaceChildren(
      ...lines.map(([a, b, value]) =>
        svg("path", { d: path([this.to(a), this.to(b)]), class: Math.abs(value) < step / 2 ? "axis" : "" }),
      ),
      ...lines.map(([a, b, value, across]) => {
        const [x, y] = across ? [4, this.to(a)[1] - 4] : [this.to(b)[0] + 4, this.height - 6];
        return svg("text", { x, y }, `${Number(value.toPrecision(6))}`);
      }),
    );
  }

  // Draw a line through points of the plane in a layer.
  line(layer, points, attributes = {}, joined) {
    this.layer(layer).append(svg("path", { d: path(points.map((p) => this.to(p)), joined), ...attributes }));
  }

  // A mark: a disc, diamond, square or cross, so that colour is never the only difference.
  mark(layer, point, shape, title, attributes = {}) {
    const [x, y] = this.to(point);
    const made = svg("path", { d: SHAPES[shape], transform: `translate(${x} ${y})`, class: `mark ${shape}`, ...attributes }, svg("title", {}, title));
    this.layer(layer).append(made);
    return made;
  }

  // A point that moves: `moved(place)` while it is dragged, `stepped(dx, dy)` by the arrow keys, `pressed(key)` by others.
  handle(layer, point, label, { moved, stepped, pressed, done = () => {} }) {
    const [x, y] = this.to(point);
    const made = svg("circle", { cx: x, cy: y, r: 9, class: "handle", tabindex: 0, role: "button", "aria-label": label });
    made.append(svg("title", {}, label));
    made.onpointerdown = (event) => {
      event.preventDefault();
      made.focus();
      made.setPointerCapture(event.pointerId);
      made.onpointermove = (e) => moved(this.place(e));
      made.onpointerup = made.onpointercancel = () => {
        made.onpointermove = made.onpointerup = made.onpointercancel = null;
        done();
      };
    };
    made.onkeydown = (event) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (step) stepped(...step);
      else if (!pressed?.(event.key)) return;
      event.preventDefault();
      done();
    };
    this.layer(layer).append(made);
    return made;
  }

  moveHandle(handle, point) {
    const [x, y] = this.to(point);
    handle.setAttribute("cx", x);
    handle.setAttribute("cy", y);
  }

  clear(...names) {
    for (const name of names) this.layer(name).replaceChildren();
  }
}
