// Interactive 3-D surfaces, with light: WebGL, nothing else. One camera for all scenes that stand side by side.
//
// A scene is plain data: {title, box: [low, high], ticks: [[…], […], […]],
//   surfaces: [{label, color, points: [[x, y, z], …], faces: [[i, j, k, …], …], parameters: [[u, v], …], letters: ["u", "v"]}],
//   lines:    [{label, color, width, runs: [[[x, y, z], …], …]}],
//   dots:     [{label, color, size, places: [[x, y, z], …], names: ["…", …] or none}]}

const START = { turn: -Math.PI / 3, tilt: 0.4, zoom: 1 };
const STEP = Math.PI / 36;

const SURFACE = [
  `attribute vec3 place, normal; uniform mat3 turned; uniform vec3 middle; uniform vec2 scale; uniform float depth;
   varying vec3 n;
   void main() { vec3 p = turned * (place - middle); n = turned * normal;
     gl_Position = vec4(p.xy * scale, -p.z * depth, 1.0); }`,
  `precision mediump float; uniform vec4 color; varying vec3 n;
   void main() { vec3 m = normalize(gl_FrontFacing ? n : -n); if (m.z < 0.0) m = -m;
     float light = 0.38 + 0.5 * max(0.0, dot(m, normalize(vec3(-0.5, 0.8, 1.0)))) + 0.2 * max(0.0, dot(m, normalize(vec3(0.9, -0.3, 0.5))));
     gl_FragColor = vec4(color.rgb * light * color.a, color.a); }`,
];
// a segment is a rectangle of this many pixels, a little nearer than it is so that its surface does not hide half of it
const LINE = [
  `attribute vec3 place, other; attribute float side; uniform mat3 turned; uniform vec3 middle;
   uniform vec2 scale, pixel; uniform float depth, width;
   void main() { vec3 p = turned * (place - middle); vec3 q = turned * (other - middle);
     vec2 along = (q.xy - p.xy) * scale / pixel; float l = length(along);
     vec2 across = l > 0.0 ? vec2(-along.y, along.x) / l : vec2(1.0, 0.0);
     vec2 tip = l > 0.0 ? -along / l * min(0.25, width) : vec2(0.0);
     gl_Position = vec4(p.xy * scale + (across * side * width + tip) * pixel, -p.z * depth - 0.004, 1.0); }`,
  `precision mediump float; uniform vec4 color; void main() { gl_FragColor = vec4(color.rgb * color.a, color.a); }`,
];
const DOT = [
  `attribute vec3 place; uniform mat3 turned; uniform vec3 middle; uniform vec2 scale; uniform float depth, width;
   void main() { vec3 p = turned * (place - middle);
     gl_Position = vec4(p.xy * scale, -p.z * depth - 0.006, 1.0); gl_PointSize = width; }`,
  `precision mediump float; uniform vec4 color; void main() { vec2 r = 2.0 * gl_PointCoord - 1.0; float q = dot(r, r);
     if (q > 1.0) discard; gl_FragColor = vec4(color.rgb * (0.55 + 0.45 * sqrt(1.0 - q)), 1.0); }`,
];

const minus = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const rgb = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255);
const isDark = (element) => Math.max(...getComputedStyle(element).backgroundColor.match(/[\d.]+/g).slice(0, 3)) < 128;

// Colours are chosen for white paper: on a dark ground dark ones are as light as they were dark, hues kept.
function onGround(text, dark) {
  const parts = rgb(text);
  const more = dark ? Math.max(0, 1 - Math.max(...parts) - Math.min(...parts)) : 0;
  return parts.map((x) => x + more);
}

function made(name, attributes = {}, ...children) {
  const element = Object.assign(document.createElement(name), attributes);
  element.append(...children);
  return element;
}

// Rows of the rotation: to the right, up, and towards the eye.
function rotation({ turn, tilt }) {
  const [c, s, a, b] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
  return [[-s, c, 0], [-b * c, -b * s, a], [a * c, a * s, b]];
}

function triangles({ points, faces }) {
  const corners = faces.flatMap((f) => f.slice(2).map((_, k) => [f[0], f[k + 1], f[k + 2]]));
  const normals = points.map(() => [0, 0, 0]);
  for (const [i, j, k] of corners) {
    // faces are not turned alike: what is added is on one side of what is there
    const n = cross(minus(points[j], points[i]), minus(points[k], points[i]));
    for (const m of [i, j, k].map((v) => normals[v])) {
      const sign = m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0 ? -1 : 1;
      m.forEach((_, axis) => (m[axis] += sign * n[axis]));
    }
  }
  return { corners, normals };
}

class View {
  constructor(scene, camera, shown) {
    Object.assign(this, { scene, camera, shown });
    this.canvas = made("canvas", { tabIndex: 0 });
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `${scene.title}: drag or arrow keys turn it, + and − change its size, 0 brings it back`);
    this.labels = made("div", { className: "ticks" });
    this.tip = made("output", { className: "tip", hidden: true });
    this.element = made("figure", { className: "turning" }, made("figcaption", { textContent: scene.title }), made("div", {}, this.canvas, this.labels, this.tip));
    const gl = (this.gl = this.canvas.getContext("webgl", { alpha: true, antialias: true, premultipliedAlpha: true }));
    if (!gl) throw new Error("this browser shows no WebGL");
    this.programs = [SURFACE, LINE, DOT].map((sources) => this.#program(sources));
    const [low, high] = scene.box;
    this.middle = low.map((x, i) => (x + high[i]) / 2);
    this.radius = Math.hypot(...minus(high, low)) / 2;
    this.surfaces = scene.surfaces.map((s) => this.#surface(s));
    this.lines = [...this.#frame(), ...scene.lines].map((l) => ({ ...l, ...this.#segments(l.runs) }));
    this.dots = scene.dots.map((d) => ({ ...d, count: d.places.length, buffer: this.#buffer(d.places.flat()) }));
  }

  #program(sources) {
    const gl = this.gl;
    const program = gl.createProgram();
    sources.forEach((text, i) => {
      const shader = gl.createShader(i ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    });
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  #buffer(numbers) {
    const gl = this.gl;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    return buffer;
  }

  #surface(surface) {
    const { corners, normals } = triangles(surface);
    const middles = corners.map((c) => [0, 1, 2].map((k) => (surface.points[c[0]][k] + surface.points[c[1]][k] + surface.points[c[2]][k]) / 3));
    return { ...surface, corners, middles, places: this.#buffer(surface.points.flat()), normals: this.#buffer(normals.flat()), indices: this.gl.createBuffer() };
  }

  #segments(runs) {
    const numbers = [];
    for (const run of runs)
      for (let i = 0; i + 1 < run.length; i += 1) {
        const [a, b] = [run[i], run[i + 1]];
        const [a1, a2, b1, b2] = [[...a, ...b, 1], [...a, ...b, -1], [...b, ...a, -1], [...b, ...a, 1]];
        numbers.push(...a1, ...a2, ...b1, ...b1, ...a2, ...b2);
      }
    return { buffer: this.#buffer(numbers), count: numbers.length / 7 };
  }

  // The edges of the box and the ticks on three of them.
  #frame() {
    const { box, ticks } = this.scene;
    const corner = (...ends) => ends.map((end, i) => box[end][i]);
    const edges = [];
    for (let axis = 0; axis < 3; axis += 1)
      for (const [p, q] of [[0, 0], [0, 1], [1, 0], [1, 1]]) {
        const ends = [0, 1].map((end) => corner(...[0, 1, 2].map((i) => (i === axis ? end : (i + 3 - axis) % 3 === 1 ? p : q))));
        edges.push(ends);
      }
    this.ticks = ticks.flatMap((values, axis) => values.map((value) => ({ axis, value })));
    return [{ label: "", color: "#9aa3ae", width: 1, runs: edges }];
  }

  draw() {
    const { gl, canvas, camera } = this;
    this.dark = isDark(canvas.parentElement);
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((x) => Math.max(1, Math.round(x * ratio)));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const rows = (this.rows = rotation(camera));
    // beside the box there is room for the numbers at its edges
    const size = (camera.zoom * Math.min(width - 70 * ratio, height)) / (2.1 * this.radius);
    this.scale = [(2 * size) / width, (2 * size) / height];
    const common = { turned: rows[0].flatMap((_, i) => rows.map((row) => row[i])), pixel: [1 / width, 1 / height], ratio };
    for (const line of this.lines) if (this.#isShown(line)) this.#drawLine(line, common);
    for (const dot of this.dots) if (this.#isShown(dot)) this.#drawDots(dot, common);
    gl.depthMask(false);
    for (const surface of this.surfaces) if (this.#isShown(surface)) this.#drawSurface(surface, common);
    this.#write(ratio);
  }

  #isShown({ label }) {
    return !label || this.shown.get(label) !== false;
  }

  #use(program, common, more) {
    const gl = this.gl;
    gl.useProgram(program);
    const at = (name) => gl.getUniformLocation(program, name);
    gl.uniformMatrix3fv(at("turned"), false, common.turned);
    gl.uniform3fv(at("middle"), this.middle);
    gl.uniform2fv(at("scale"), this.scale);
    gl.uniform1f(at("depth"), 0.45 / this.radius);
    gl.uniform2fv(at("pixel"), common.pixel);
    if (more.width) gl.uniform1f(at("width"), more.width);
    gl.uniform4fv(at("color"), more.color);
  }

  #attribute(program, name, buffer, size, stride = 0, offset = 0) {
    const gl = this.gl;
    const at = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, gl.FLOAT, false, stride, offset);
  }

  #drawLine(line, common) {
    const program = this.programs[1];
    this.#use(program, common, { width: line.width * common.ratio, color: [...onGround(line.color, this.dark), 1] });
    this.#attribute(program, "place", line.buffer, 3, 28, 0);
    this.#attribute(program, "other", line.buffer, 3, 28, 12);
    this.#attribute(program, "side", line.buffer, 1, 28, 24);
    this.gl.drawArrays(this.gl.TRIANGLES, 0, line.count);
  }

  #drawDots(dot, common) {
    const program = this.programs[2];
    this.#use(program, common, { width: dot.size * common.ratio, color: [...onGround(dot.color, this.dark), 1] });
    this.#attribute(program, "place", dot.buffer, 3);
    this.gl.drawArrays(this.gl.POINTS, 0, dot.count);
  }

  // What is translucent is drawn from back to front, triangle by triangle.
  #drawSurface(surface, common) {
    const [gl, program] = [this.gl, this.programs[0]];
    const eye = this.rows[2];
    const far = surface.middles.map((m) => m[0] * eye[0] + m[1] * eye[1] + m[2] * eye[2]);
    const order = far.map((_, i) => i).sort((a, b) => far[a] - far[b]);
    const indices = new Uint16Array(order.flatMap((i) => surface.corners[i]));
    this.#use(program, common, { color: [...onGround(surface.color, this.dark), this.camera.opacity] });
    this.#attribute(program, "place", surface.places, 3);
    this.#attribute(program, "normal", surface.normals, 3);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, surface.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.DYNAMIC_DRAW);
    gl.drawElements(gl.TRIANGLES, indices.length, gl.UNSIGNED_SHORT, 0);
  }

  // A point of space in pixels of the page.
  #onPage(point) {
    const [x, y] = this.rows.map((row) => row.reduce((sum, r, i) => sum + r * (point[i] - this.middle[i]), 0));
    const { clientWidth, clientHeight } = this.canvas;
    return [(clientWidth * (1 + x * this.scale[0])) / 2, (clientHeight * (1 - y * this.scale[1])) / 2];
  }

  // Say what is under the pointer: a dot by its name, otherwise the parameters of the nearest point of a surface.
  point(event) {
    const [x, y] = [event.offsetX, event.offsetY];
    const eye = this.rows[2];
    let best = { rank: Infinity };
    const offer = (place, text, reach, ahead) => {
      const [px, py] = this.#onPage(place);
      const far = Math.hypot(px - x, py - y);
      // of points at one place the one in front
      const rank = far - (8 * eye.reduce((sum, e, i) => sum + e * place[i], 0)) / this.radius - ahead;
      if (far < reach && rank < best.rank) best = { rank, text, px, py };
    };
    for (const dot of this.dots) if (this.#isShown(dot)) dot.places.forEach((p, i) => offer(p, dot.names?.[i], dot.names ? 10 : 0, 100));
    for (const s of this.surfaces) if (this.#isShown(s)) s.parameters.forEach((values, i) => offer(s.points[i], values.map((x, k) => `${s.letters[k]} ≈ ${x}`).join(", "), 14, 0));
    this.tip.hidden = !best.text;
    if (!best.text) return;
    this.tip.textContent = best.text;
    Object.assign(this.tip.style, { left: `${best.px}px`, top: `${best.py}px` });
  }

  // The numbers stand along the edges of the box that lie outermost.
  #write() {
    const { box } = this.scene;
    const eye = this.rows[2];
    const near = eye.map((x) => (x > 0 ? 1 : 0));
    const beside = (axis) => {
      if (axis < 2) return [0, 1, 2].map((i) => (i === 2 ? (eye[2] > 0 ? 0 : 1) : near[i]));
      const turns = [[near[0], 1 - near[1]], [1 - near[0], near[1]]];
      const [left] = turns.map((t) => [this.#onPage([box[t[0]][0], box[t[1]][1], box[0][2]])[0], t]).sort((a, b) => a[0] - b[0]);
      return [...left[1], 0];
    };
    const middle = this.#onPage(this.middle);
    const spans = this.ticks.map(({ axis, value }) => {
      const ends = beside(axis);
      const place = [0, 1, 2].map((i) => (i === axis ? value : box[ends[i]][i]));
      const out = [0, 1, 2].map((i) => (i === axis ? this.middle[i] : box[ends[i]][i]));
      const [[x, y], [ox, oy]] = [this.#onPage(place), this.#onPage(out)];
      const away = Math.hypot(ox - middle[0], oy - middle[1]) || 1;
      const span = made("span", { textContent: `${"xyz"[axis]} ${value}`.replace("-", "−") });
      span.style.left = `${x + (18 * (ox - middle[0])) / away}px`;
      span.style.top = `${y + (14 * (oy - middle[1])) / away}px`;
      return span;
    });
    this.labels.replaceChildren(...spans);
  }
}

// Fill an element with scenes; what they show can be switched on and off by its label.
export function turning(element, scenes) {
  const camera = { ...START, opacity: 0.72 };
  const shown = new Map();
  const samples = new Map();
  let asked = 0;
  const views = scenes.map((scene) => new View(scene, camera, shown));
  const draw = () => {
    asked = asked || requestAnimationFrame(() => {
      asked = 0;
      if (!element.contains(views[0].canvas)) return forget(); // other scenes have taken the place
      views.forEach((view) => view.draw());
      samples.forEach((color, sample) => (sample.style.background = `rgb(${onGround(color, views[0].dark).map((x) => 255 * x)})`));
    });
  };
  const night = matchMedia("(prefers-color-scheme: dark)");
  const theme = new MutationObserver(draw);
  const forget = () => {
    theme.disconnect();
    night.removeEventListener("change", draw);
  };
  const turn = (dx, dy) => {
    camera.turn -= dx;
    camera.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, camera.tilt + dy));
    draw();
  };
  const enlarge = (factor) => {
    camera.zoom = Math.max(0.2, Math.min(20, camera.zoom * factor));
    draw();
  };
  const keys = {
    ArrowLeft: () => turn(-STEP, 0),
    ArrowRight: () => turn(STEP, 0),
    ArrowUp: () => turn(0, -STEP),
    ArrowDown: () => turn(0, STEP),
    "+": () => enlarge(1.1),
    "-": () => enlarge(1 / 1.1),
    0: () => draw(Object.assign(camera, START)),
  };
  for (const view of views) {
    const { canvas } = view;
    const held = new Map();
    canvas.onpointerleave = () => (view.tip.hidden = true);
    canvas.onpointerdown = (event) => {
      held.set(event.pointerId, event);
      canvas.setPointerCapture(event.pointerId);
    };
    canvas.onpointermove = (event) => {
      const before = held.get(event.pointerId);
      if (!before) return view.point(event);
      view.tip.hidden = true;
      held.set(event.pointerId, event);
      if (held.size === 1) turn((event.clientX - before.clientX) / 120, (event.clientY - before.clientY) / 120);
      else {
        const other = [...held.values()].find((e) => e.pointerId !== event.pointerId);
        const apart = (e) => Math.hypot(e.clientX - other.clientX, e.clientY - other.clientY) || 1;
        enlarge(apart(event) / apart(before));
      }
    };
    canvas.onpointerup = canvas.onpointercancel = (event) => held.delete(event.pointerId);
    canvas.onwheel = (event) => {
      // without a key the wheel scrolls the page
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      enlarge(Math.exp(-event.deltaY / 500));
    };
    canvas.onkeydown = (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
      event.preventDefault();
      keys[event.key]();
    };
    new ResizeObserver(draw).observe(canvas);
  }
  const named = new Map(scenes.flatMap((s) => [...s.surfaces, ...s.lines, ...s.dots]).map((x) => [x.label, x.color]));
  const switches = [...named].map(([label, color]) => {
    const box = made("input", { type: "checkbox", checked: true, onchange: () => draw(shown.set(label, box.checked)) });
    const sample = made("i");
    samples.set(sample, color);
    return made("label", {}, box, sample, label);
  });
  const opacity = made("input", { type: "range", min: 0.2, max: 1, step: 0.01, value: camera.opacity, oninput: () => draw((camera.opacity = Number(opacity.value))) });
  const back = made("button", { type: "button", textContent: "Turn back", onclick: keys[0] });
  element.replaceChildren(
    made("div", { className: "views" }, ...views.map((v) => v.element)),
    made("div", { className: "switches" }, ...switches, made("label", {}, "opacity", opacity), back),
  );
  theme.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  night.addEventListener("change", draw);
  draw();
  return { camera, draw, views };
}
