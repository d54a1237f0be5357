// The trimmed bisector of a point and a plane curve.

import { Editor, copy } from "./editor.js";
import { Kernel } from "./kernel.js";
import { Plane } from "./plane.js";
import { samples, segments } from "./preview.js";
import { double, snapped } from "./numbers.js";
import { data, element, statusLine } from "./site.js";
import { html } from "./svg.js";

const COLOURS = ["--blue", "--orange", "--green", "--purple", "--gold", "--sky"].map((name) => `var(${name})`);
const STEPS = 4;

const say = statusLine(element("status"));
const kernel = new Kernel(say);
const plane = new Plane(element("plane"), { label: "a curve, the point Q and their bisector" });
for (const layer of ["polygon", "curve", "bisector", "walk", "handles", "point"]) plane.layer(layer);
kernel.shows("bisector", plane.layer("bisector"), plane.layer("walk"), ...["pieces", "told", "status"].map(element));
let q = ["7/4", "3/2"];
let pieces = [];
const editor = new Editor(plane, changed);
let handle = null;

function changed(why) {
  if (why === "selected") return;
  kernel.stale("bisector");
  const drawn = samples(editor.curve).map((s) => s.point);
  if (why === "new") {
    plane.fit([...drawn, ...editor.curve.points.map((p) => p.map(double)), q.map(double)].flatMap(([x, y]) => [[x - 1, y - 1], [x + 1, y + 1]]));
    editor.redraw();
    placeHandle();
  }
  plane.clear("curve");
  for (const segment of segments(editor.curve)) plane.line("curve", segment.map((s) => s.point));
  if (why === "new" || why === "done" || why === "typed") ask();
}

function placeHandle() {
  plane.clear("point");
  handle = plane.handle("point", q.map(double), "the point Q", {
    moved: (place) => move(place.map((v) => snapped(v, STEPS))),
    stepped: (dx, dy) => move([snapped(double(q[0]) + dx / STEPS, STEPS), snapped(double(q[1]) + dy / STEPS, STEPS)]),
    done: ask,
  });
  handle.classList.add("q");
}

function move(point) {
  q = point;
  plane.moveHandle(handle, q.map(double));
  ask();
}

function ask() {
  kernel.latest("bisector", { curve: copy(editor.curve), point: q }, show, (problem) => {
    pieces = [];
    plane.clear("bisector", "walk");
    element("pieces").replaceChildren();
    say(problem.message, true);
  });
}

function show({ answer, milliseconds }) {
  pieces = answer.pieces;
  plane.clear("bisector");
  const near = 400 / plane.view.unit;
  pieces.forEach((p, i) => {
    const joined = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < near * plane.view.unit;
    plane.line("bisector", p.drawn.map(([b]) => b), { style: `stroke:${COLOURS[i % COLOURS.length]}` }, joined);
  });
  const head = ["piece", "degree", "from t to t"].map((name) => html("th", { scope: "col" }, name));
  const rows = pieces.map((p, i) => html("tr", {}, html("td", { style: `color:${COLOURS[i % COLOURS.length]}` }, p.kind), html("td", {}, `${p.degree}`), html("td", { class: "number" }, p.ends[0], html("br"), p.ends[1])));
  element("pieces").replaceChildren(html("thead", {}, html("tr", {}, ...head)), html("tbody", {}, ...rows));
  walk();
  if (milliseconds === undefined) return;
  say([`Q = (${q.join(", ")}) · certified in ${milliseconds.toFixed(0)} ms`, ...answer.missing].join(" · "));
  document.body.dataset.pieces = JSON.stringify(pieces.map((p) => p.kind));
}

function walk() {
  plane.clear("walk");
  const points = pieces.flatMap((p) => p.drawn);
  const chosen = points[Math.round(((points.length - 1) * Number(element("walk").value)) / 1000)];
  if (!chosen) return;
  const [b, foot] = chosen;
  const to = q.map(double);
  const distance = Math.hypot(b[0] - foot[0], b[1] - foot[1]);
  plane.line("walk", [to, b, foot]);
  const turn = (k) => [b[0] + distance * Math.cos(k), b[1] + distance * Math.sin(k)];
  if (distance * plane.view.unit < 3000) plane.line("walk", Array.from({ length: 121 }, (_, k) => turn((k * Math.PI) / 60)));
  element("told").textContent = `both distances: ${distance.toPrecision(9)}`;
}

element("walk").oninput = walk;
const examples = (await data("curves")).filter((curve) => curve.knots.length < 12);
element("examples").append(...examples.map(({ name }, i) => html("option", { value: i }, name.replaceAll("_", " "))));
element("examples").onchange = () => editor.set(examples[element("examples").value]);
const first = await data("first");
editor.set(examples[0]);
show({ answer: first.bisector }); // as computed when the site was built, until the library has started here
kernel.current("bisector");
