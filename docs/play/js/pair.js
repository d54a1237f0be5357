// Two plane curves: their common points, in the plane and in the rectangle of both parameters.

import { Editor, copy } from "./editor.js";
import { Kernel } from "./kernel.js";
import { Plane } from "./plane.js";
import { preview, samples, segments } from "./preview.js";
import { double } from "./numbers.js";
import { data, element, statusLine } from "./site.js";
import { html } from "./svg.js";

const MARKS = { crossing: "disc", touching: "diamond", end: "square", knot: "square" };

const say = statusLine(element("status"));
const kernel = new Kernel(say);
const plane = new Plane(element("plane"), { label: "two curves with their control points" });
for (const layer of ["polygon", "polygon second", "bisector", "curve", "curve second", "walk", "marks", "handles", "handles second"]) plane.layer(layer);
const rectangle = new Plane(element("rectangle"), { label: "the rectangle of both parameters" });
for (const layer of ["frame", "across", "up", "bisector", "walk", "marks"]) rectangle.layer(layer);
const drawn = [plane.layer("marks"), plane.layer("bisector"), ...["across", "up", "bisector", "marks"].map((name) => rectangle.layer(name))];
kernel.shows("pair", ...drawn, element("points"), element("status"));
const editors = [new Editor(plane, changed), new Editor(plane, changed, " second")];
let domains = [];

const span = ({ knots, degree }) => [double(knots[degree]), double(knots[knots.length - 1 - degree])];
const curves = () => editors.map((editor) => editor.curve);

function changed(why) {
  if (why === "selected" || curves().some((curve) => !curve)) return;
  if (why === "new") fit();
  ["curve", "curve second"].forEach((layer, k) => {
    plane.clear(layer);
    for (const segment of segments(curves()[k])) plane.line(layer, segment.map((s) => s.point));
  });
  walk();
  ask();
}

function fit() {
  plane.fit(curves().flatMap((curve) => [...samples(curve, 16).map((s) => s.point), ...curve.points.map((p) => p.map(double))]));
  editors.forEach((editor) => editor.redraw());
  domains = curves().map(span);
  const [[a, b], [c, d]] = domains;
  rectangle.fit([[a, c], [b, d]], 2000);
  rectangle.clear("frame");
  rectangle.line("frame", [[a, c], [b, c], [b, d], [a, d], [a, c]]);
}

function ask() {
  const [first, second] = curves().map(copy);
  const asked = { first, second, bisector: element("bisector").checked };
  kernel.latest("pair", asked, show, (problem) => {
    plane.clear("marks", "bisector");
    rectangle.clear("marks", "across", "up", "bisector");
    element("points").replaceChildren();
    say(problem.message, true);
  });
}

function show({ answer, milliseconds }) {
  plane.clear("marks", "bisector");
  rectangle.clear("marks", "across", "up", "bisector");
  for (const name of ["across", "up", "bisector"]) for (const run of answer[name]) rectangle.line(name, run);
  const joined = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < 160;
  for (const run of answer.bisector) plane.line("bisector", run.map(middle), {}, joined);
  const rows = answer.points.map((p) => {
    const title = `${p.kind} at s = ${p.s}, t = ${p.t}`;
    for (const [where, place] of [[plane, p.point], [rectangle, p.place]]) where.mark("marks", place, MARKS[p.kind] ?? "disc", title, { class: "mark inflection" });
    return html("tr", {}, html("td", {}, p.kind), html("td", { class: "number" }, p.s), html("td", { class: "number" }, p.t), html("td", {}, p.multiplicity ?? "–"));
  });
  for (const arc of answer.arcs) rows.push(html("tr", {}, html("td", { colspan: 4 }, arc)));
  if (!rows.length) rows.push(html("tr", {}, html("td", { colspan: 4 }, "the curves do not meet")));
  const head = ["kind", "s", "t", "multiplicity"].map((name) => html("th", { scope: "col" }, name));
  element("points").replaceChildren(html("thead", {}, html("tr", {}, ...head)), html("tbody", {}, ...rows));
  if (milliseconds === undefined) return;
  say([`${answer.points.length} common point${answer.points.length === 1 ? "" : "s"}, certified in ${milliseconds.toFixed(0)} ms`, ...answer.undecided].join(" · "));
  document.body.dataset.points = JSON.stringify(answer.points.map((p) => [p.kind, p.s, p.t]));
}

// Where the normals of a pair meet; not finite where they are parallel.
function middle(place) {
  const [p, q] = curves().map((curve, k) => preview(curve)(Math.min(place[k], domains[k][1] - 1e-9)));
  const [a, b] = [p.first, q.first];
  const along = (b[0] * (q.point[0] - p.point[0]) + b[1] * (q.point[1] - p.point[1])) / (a[0] * b[1] - a[1] * b[0]);
  return [p.point[0] - along * a[1], p.point[1] + along * a[0]];
}

function walk() {
  const place = ["s", "t"].map((name, k) => domains[k][0] + ((domains[k][1] - domains[k][0]) * Number(element(name).value)) / 1000);
  const points = curves().map((curve, k) => preview(curve)(Math.min(place[k], domains[k][1] - 1e-9)).point);
  plane.clear("walk");
  rectangle.clear("walk");
  plane.line("walk", points);
  for (const point of points) plane.mark("walk", point, "disc", "a point of the pair", { class: "mark pairing" });
  const [[a, b], [c, d]] = domains;
  rectangle.line("walk", [[place[0], c], [place[0], d]]);
  rectangle.line("walk", [[a, place[1]], [b, place[1]]]);
}

rectangle.element.addEventListener("pointermove", (event) => {
  rectangle.place(event).forEach((value, k) => {
    const [low, high] = domains[k];
    element(["s", "t"][k]).value = Math.round((1000 * (value - low)) / (high - low));
  });
  walk();
});
for (const name of ["s", "t"]) element(name).oninput = walk;
element("bisector").onchange = ask;

const pairs = await data("pairs");
const start = ({ first, second }) => {
  editors[0].curve = copy(first);
  editors[1].curve = copy(second);
  editors[0].set(first);
  editors[1].set(second);
};
element("examples").append(...pairs.map(({ name }, i) => html("option", { value: i }, name)));
element("examples").onchange = () => start(pairs[element("examples").value]);
start(pairs[0]);
show({ answer: pairs[0].answer }); // as computed when the site was built, until the library has started here
kernel.current("pair");
