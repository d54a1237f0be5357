// The page of one plane curve: the picture in doubles at once, the answers of the library behind it.

import { chart } from "./chart.js";
import { Editor, copy, fromHash, toHash } from "./editor.js";
import { Kernel } from "./kernel.js";
import { Plane, symbol } from "./plane.js";
import { preview, samples, segments } from "./preview.js";
import { double } from "./numbers.js";
import { data, element, embedded, reportHeight, statusLine } from "./site.js";
import { html } from "./svg.js";

const FORMS = [
  ["squaring", "the textbook's: the numerator of (κ²)′"],
  ["paper", "the paper's: what is left when powers of w are cancelled"],
  ["minimal", "the lowest: as a determinant of lifted curves"],
];
const SHAPES = { inflection: "square", maximum: "triangle", minimum: "diamond", singular: "cross" };

embedded();
reportHeight();
const say = statusLine(element("status"));
const kernel = new Kernel(say);
const plane = new Plane(element("plane"), { label: "the curve with its control points" });
for (const layer of ["comb", "evolute", "osculating", "polygon", "curve", "marks", "handles"]) plane.layer(layer);
kernel.shows("features", plane.layer("marks"), element("features"), element("status"));
kernel.shows("forms", element("forms"));
const editor = new Editor(plane, changed);
const hint = element("digits").textContent;
let at = null;
let idle = 0;

const style = (f) => (f.group === "extremum" ? f.kind : f.group);

function changed(why) {
  if (why === "selected") return showPoint();
  at = preview(editor.curve);
  element("digits").textContent = hint;
  draw();
  showPoint(why === "typed");
  if (why === "done") history.replaceState(null, "", `#${toHash(editor.curve)}`);
  if (why === "new") fit();
  const { answers, ...asked } = editor.curve;
  const known = why === "new" && answers; // as computed when the site was built, until the library has started here
  editor.curve = asked;
  kernel.latest("features", copy(asked), showFeatures, complain);
  kernel.stale("forms");
  if (known) {
    showFeatures({ answer: known.features });
    showForms(known.forms);
    kernel.current("features");
    kernel.current("forms");
  }
  clearTimeout(idle);
  idle = setTimeout(() => askForms(known), 350);
}

function fit() {
  const drawn = samples(editor.curve, 16).map((s) => s.point);
  plane.fit([...drawn, ...editor.curve.points.map((p) => p.map(double))]);
  editor.redraw();
  draw();
}

function draw() {
  const drawn = segments(editor.curve);
  plane.clear("curve", "comb", "evolute", "osculating");
  for (const segment of drawn) plane.line("curve", segment.map((s) => s.point));
  const size = Math.max(...drawn.flat().map((s) => Math.abs(s.curvature)).filter(Number.isFinite), 1e-9);
  if (element("comb").checked) {
    const tip = (s) => s.point.map((v, k) => v - (s.normal[k] * s.curvature * 70) / size / plane.view.unit);
    for (const segment of drawn) {
      for (const s of segment.filter((_, i) => i % 2 === 0)) plane.line("comb", [s.point, tip(s)]);
      plane.line("comb", segment.map(tip));
    }
  }
  if (element("evolute").checked) {
    const near = 3000 / plane.view.unit;
    const joined = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < near;
    for (const segment of drawn) plane.line("evolute", segment.map((s) => s.centre), {}, joined);
  }
}

function showFeatures({ answer, milliseconds }) {
  plane.clear("marks");
  for (const f of answer.features) plane.mark("marks", f.point, SHAPES[style(f)] ?? "disc", `${f.kind} at t = ${f.t}`, { class: `mark ${SHAPES[style(f)] ?? "disc"} ${style(f)}` });
  for (const j of answer.joints) plane.mark("marks", j.point, "disc", `${j.kind} at t = ${j.t}`, { class: "mark singular" });
  const counts = { inflection: 0, extremum: 0, singular: 0 };
  const rows = answer.features.map((f) => {
    const index = counts[f.group]++;
    const more = html("button", { type: "button", title: "more digits", onclick: () => askDigits(f.group, index) }, f.t);
    const curvature = f.curvature === undefined ? "–" : f.curvature ? f.curvature.toPrecision(6) : "0";
    return html("tr", {}, html("td", { class: style(f) }, f.kind), html("td", { class: "number" }, more), html("td", { class: "number" }, curvature));
  });
  for (const j of answer.joints) rows.push(html("tr", {}, html("td", { class: "singular" }, j.kind), html("td", { class: "number" }, j.t), html("td", {}, "–")));
  for (const p of answer.pieces) rows.push(html("tr", {}, html("td", {}, p.kind), html("td", { class: "number", colspan: 2 }, p.where)));
  if (!rows.length) rows.push(html("tr", {}, html("td", { colspan: 3 }, "no inflection, no extremum of curvature, no singular point")));
  const head = html("tr", {}, ...["feature", "parameter t", "curvature"].map((name) => html("th", { scope: "col" }, name)));
  element("features").replaceChildren(html("thead", {}, head), html("tbody", {}, ...rows));
  if (milliseconds === undefined) return;
  document.body.dataset.answered = `${Number(document.body.dataset.answered ?? 0) + 1}`;
  document.body.dataset.first ??= performance.now().toFixed(0);
  document.body.dataset.features = JSON.stringify(answer.features);
  say(`certified in ${milliseconds.toFixed(0)} ms · ${answer.polynomial ? "polynomial" : "rational"}, degree ${answer.degree}, segments: ${answer.segments}`);
}

function complain(problem) {
  plane.clear("marks");
  element("features").replaceChildren();
  say(problem.message, true);
}

async function askDigits(group, index, digits = 50) {
  if (element("features").ariaBusy) return; // a feature of the former curve
  const note = element("digits");
  try {
    const { curve } = editor;
    const { answer } = await kernel.ask("digits", { curve, group, index, digits });
    if (editor.curve !== curve) return; // it has changed meanwhile
    const exact = answer.exact ? `t = ${answer.exact} exactly. ` : `a root of ${answer.polynomial} (coefficients from the lowest). `;
    const again = html("button", { type: "button", onclick: () => askDigits(group, index, digits * 2) }, `${digits * 2} digits`);
    note.replaceChildren(html("code", {}, answer.decimal), html("br"), exact, again);
  } catch (problem) {
    note.textContent = problem.message;
  }
}

function askForms(known) {
  const variants = FORMS.map(([variant]) => variant);
  kernel.latest("forms", { curve: copy(editor.curve), variants }, ({ answer }) => {
    showForms(answer);
    document.body.dataset.degrees = JSON.stringify(answer.map((form) => form.degree));
  }, () => element("forms").replaceChildren());
  if (known) kernel.current("forms");
}

function showForms(answer) {
  element("forms").replaceChildren(
    ...answer.map((form, i) =>
      html("figure", { style: "margin:0 0 12px" }, html("figcaption", {}, html("b", {}, `degree ${form.degree}`), ` · ${form.controls} control points · ${FORMS[i][1]}`), chart(form)),
    ),
  );
}

function showPoint(keep = false) {
  const i = editor.selected;
  element("which").textContent = `${i} of ${editor.curve.points.length - 1}`;
  if (keep) return;
  const field = (label, value, set) => {
    const input = html("input", { type: "text", value, "aria-label": label, inputmode: "text" });
    input.onchange = () => input.classList.toggle("wrong", !set(input.value.trim()));
    return html("label", {}, `${label} `, input);
  };
  const [x, y] = editor.curve.points[i];
  element("point").replaceChildren(
    field("x", x, (text) => editor.setPoint(i, 0, text)),
    field("y", y, (text) => editor.setPoint(i, 1, text)),
    field("weight", editor.curve.weights[i], (text) => editor.setWeight(i, text)),
  );
}

function osculate(event) {
  const place = plane.place(event);
  const far = (s) => Math.hypot(s.point[0] - place[0], s.point[1] - place[1]);
  const nearest = samples(editor.curve, 48).reduce((a, b) => (far(a) < far(b) ? a : b));
  plane.clear("osculating");
  if (far(nearest) * plane.view.unit > 40 || !Number.isFinite(nearest.centre[0])) return;
  const radius = 1 / Math.abs(nearest.curvature);
  const turn = (k) => [nearest.centre[0] + radius * Math.cos(k), nearest.centre[1] + radius * Math.sin(k)];
  if (radius * plane.view.unit < 4000) plane.line("osculating", Array.from({ length: 121 }, (_, k) => turn((k * Math.PI) / 60)));
}

const LEGEND = [
  ["square", "inflection", "inflection"],
  ["triangle", "maximum", "largest curvature"],
  ["diamond", "minimum", "smallest curvature"],
  ["cross", "singular", "singular point or corner"],
];
element("legend").append(...LEGEND.map(([shape, kind, name]) => html("span", {}, symbol(shape, `mark ${shape} ${kind}`), name)));
for (const id of ["comb", "evolute"]) element(id).onchange = draw;
plane.element.addEventListener("pointermove", osculate);
plane.element.addEventListener("pointerleave", () => plane.clear("osculating"));
element("link").onclick = async () => {
  history.replaceState(null, "", `#${toHash(editor.curve)}`);
  try {
    await navigator.clipboard.writeText(location.href);
    element("link").textContent = "Copied";
  } catch {
    element("link").textContent = "The link is in the address bar";
  }
};

const examples = await data("curves");
element("examples").append(...examples.map(({ name }, i) => html("option", { value: i }, name.replaceAll("_", " "))));
element("examples").onchange = () => editor.set(examples[element("examples").value]);
const linked = location.hash && fromHash(location.hash);
editor.set(linked || examples[0]);
