// The triangle of de Boor: the parameter dragged along the curve, intermediate points drawn, fractions beside them.

import { Editor, copy, fromHash, toHash } from "./editor.js";
import { formula } from "./fractions.js";
import { Kernel } from "./kernel.js";
import { Plane } from "./plane.js";
import { preview, samples, segments } from "./preview.js";
import { double } from "./numbers.js";
import { data, element, embedded, reportHeight, statusLine } from "./site.js";
import { html } from "./svg.js";

const STEPS = 60;
const MOST_POINTS = 24;
const SHAPES = ["square", "diamond", "triangle", "disc"];

embedded();
reportHeight();
const say = statusLine(element("status"));
const kernel = new Kernel(say);
const plane = new Plane(element("plane"), { label: "a curve, its control points and de Boor's points", height: 460 });
for (const layer of ["polygon", "curve", "steps", "handles", "point"]) plane.layer(layer);
kernel.shows("triangle", plane.layer("steps"), ...["heading", "triangle", "told", "status"].map(element));
kernel.shows("product", ...["multiplied", "product", "diagonals"].map(element));
const slider = element("share");
const before = [];
let handle = null;
let shown = null;
const editor = new Editor(plane, changed);

const domain = () => {
  const { knots, degree } = editor.curve;
  return [double(knots[degree]), double(knots.at(-1 - degree))];
};
const parameter = (k) => {
  const [low, high] = domain();
  return low + ((high - low) * k) / STEPS;
};

function changed(why) {
  if (why === "selected") return;
  const drawn = samples(editor.curve).map((s) => s.point);
  if (why === "new") {
    plane.fit([...drawn, ...editor.curve.points.map((p) => p.map(double))]);
    editor.redraw();
  }
  plane.clear("curve");
  for (const segment of segments(editor.curve)) plane.line("curve", segment.map((s) => s.point));
  if (why === "done") history.replaceState(null, "", `#${toHash(editor.curve)}`);
  describe();
  move(Number(slider.value));
}

function describe() {
  const { degree, knots, points } = editor.curve;
  element("curve").textContent = `degree ${degree}, ${points.length} control points, knots ${knots.join(", ")}`;
  element("elevate").disabled = points.length >= MOST_POINTS;
  element("undo").disabled = before.length === 0;
}

// A point in doubles at once; the triangle follows from the library.
function move(k) {
  slider.value = Math.min(STEPS, Math.max(0, k));
  const { point } = preview(editor.curve)(parameter(Number(slider.value)));
  if (handle) plane.moveHandle(handle, point);
  else {
    handle = plane.handle("point", point, "the point of the curve", {
      moved: (place) => move(nearest(place)),
      stepped: (dx, dy) => move(Number(slider.value) + Math.sign(dx + dy)),
    });
    handle.classList.add("q");
  }
  kernel.latest("triangle", { curve: copy(editor.curve), share: `${slider.value}/${STEPS}` }, show, complain);
  element("insert").disabled = true;
  multiply();
}

function nearest(place) {
  const at = preview(editor.curve);
  const far = (k) => {
    const { point } = at(parameter(k));
    return Math.hypot(point[0] - place[0], point[1] - place[1]);
  };
  return Array.from({ length: STEPS + 1 }, (_, k) => k).reduce((a, b) => (far(b) < far(a) ? b : a));
}

function show({ answer, milliseconds }) {
  shown = answer;
  plane.clear("steps");
  answer.drawn.slice(1).forEach((column, i) => {
    const finite = column.filter((p) => p.every(Number.isFinite));
    plane.line("steps", finite, { class: `step${(i % 4) + 1}` });
    for (const p of finite) plane.mark("steps", p, SHAPES[i % 4], `step ${i + 1}`, { class: `mark step${(i % 4) + 1}` });
  });
  element("heading").replaceChildren("t = ", formula([answer.t]), ", between the knots ", formula([answer.span[0]]), " and ", formula([answer.span[1]]));
  element("triangle").replaceChildren(...table(answer));
  const weighted = "Entries are points times their weights, then the weight; divided by it the last one is the point ";
  const plain = "An entry is 1 − s times the entry above it in the previous column, plus s times the entry to its left. The point is ";
  element("told").replaceChildren(answer.weighted ? weighted : plain, formula(answer.tip, 60));
  element("insert").disabled = !answer.inside || editor.curve.points.length >= MOST_POINTS;
  if (milliseconds === undefined) return;
  document.body.dataset.answered = `${Number(document.body.dataset.answered ?? 0) + 1}`;
  document.body.dataset.triangle = JSON.stringify(answer);
  say(`computed in ${milliseconds.toFixed(0)} ms`);
}

function table({ columns, ratios, first }) {
  const height = columns[0].length;
  const name = (r) => html("th", { scope: "col", class: r ? `step${((r - 1) % 4) + 1}` : "" }, r ? `step ${r}` : "given");
  const head = html("tr", {}, html("th", {}), ...columns.map((_, r) => name(r)));
  const rows = columns[0].map((_, i) => {
    const cells = columns.map((column, r) => {
      const k = i - (height - column.length);
      if (k < 0) return html("td", {});
      const share = r ? html("small", {}, " s = ", formula([ratios[r - 1][k]])) : "";
      return html("td", {}, formula(column[k]), html("br"), share);
    });
    return html("tr", {}, html("th", { scope: "row" }, `d${first + i}`), ...cells);
  });
  return [html("thead", {}, head), html("tbody", {}, ...rows)];
}

// In Bézier points times binomial coefficients a product of functions is one of polynomials.
function multiply() {
  const factors = [element("left").value, element("right").value];
  const asked = { curve: copy(editor.curve), share: `${slider.value}/${STEPS}`, factors };
  kernel.latest("product", asked, (told) => showProduct(told, factors), complain);
}

function showProduct({ answer, milliseconds }, [first, second]) {
  const between = ["on the segment from ", formula([answer.span[0]]), " to ", formula([answer.span[1]])];
  element("multiplied").replaceChildren(
    ...[`The Bézier points of ${first} and ${second} `, ...between, ", times their binomial coefficients, multiplied. "],
    "Sums along the diagonals, divided by the binomial coefficients of the product's degree, are its Bézier points",
    answer.same ? ": decided exactly." : ".",
  );
  const head = (text) => html("th", { scope: "col" }, text);
  const heads = answer.right.map((x) => html("th", { scope: "col" }, "· ", formula([x])));
  const rows = answer.table.map((row, i) =>
    html("tr", {}, html("th", { scope: "row" }, formula([answer.left[i]])), ...row.map((x) => html("td", {}, formula([x])))),
  );
  element("product").replaceChildren(html("thead", {}, html("tr", {}, html("th", {}), ...heads)), html("tbody", {}, ...rows));
  const sums = answer.sums.map((x, m) =>
    html("tr", {}, html("th", { scope: "row" }, `${m}`), html("td", {}, formula([x])), html("td", {}, formula([answer.points[m]]))),
  );
  const names = ["diagonal", "sum", "Bézier point"].map(head);
  element("diagonals").replaceChildren(html("thead", {}, html("tr", {}, ...names)), html("tbody", {}, ...sums));
  if (milliseconds !== undefined) document.body.dataset.product = JSON.stringify(answer);
}

function complain(problem) {
  plane.clear("steps");
  element("triangle").replaceChildren();
  say(problem.message, true);
}

async function refine(how) {
  const old = copy(editor.curve);
  try {
    const { answer } = await kernel.ask("refined", { curve: old, ...how });
    if (toHash(editor.curve) !== toHash(old)) return; // it has changed meanwhile
    before.push(old);
    editor.set(answer.curve);
    document.body.dataset.same = `${answer.same}`;
    if (answer.same) say("the same curve by other control points: decided exactly");
  } catch (problem) {
    say(problem.message, true);
  }
}

element("insert").onclick = () => refine({ knot: shown.t });
element("elevate").onclick = () => refine({});
element("undo").onclick = () => before.length && editor.set(before.pop());
slider.oninput = () => move(Number(slider.value));

for (const [id, chosen] of [["left", "x"], ["right", "y"]]) {
  element(id).append(...["x", "y", "w"].map((name) => html("option", { value: name, selected: name === chosen }, name)));
  element(id).onchange = multiply;
}
const examples = await data("curves");
element("examples").append(...examples.map(({ name }, i) => html("option", { value: i }, name.replaceAll("_", " "))));
element("examples").onchange = () => {
  before.length = 0;
  editor.set(examples[element("examples").value]);
};
element("insert").disabled = true;
const linked = location.hash && fromHash(location.hash);
const cubic = examples.findIndex(({ name }) => name === "cubic_s");
if (!linked) element("examples").value = Math.max(cubic, 0);
const first = linked || (await data("first"));
editor.set(linked || examples[Math.max(cubic, 0)]);
if (!linked) {
  // as computed when the site was built, until the library has started here
  show({ answer: first.triangle });
  showProduct({ answer: first.product }, ["x", "y"]);
  kernel.current("triangle");
  kernel.current("product");
}
