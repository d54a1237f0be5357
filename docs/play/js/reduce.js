// A formula that is typed, and what the library finds in it.

import { Kernel } from "./kernel.js";
import { data, element, statusLine } from "./site.js";
import { html } from "./svg.js";

const first = await data("first");
const SAMPLES = [
  ["curvature's numerator", 2, first.sample],
  ["torsion's numerator", 3, "from exactspline.language import triple\n\n\ndef numerator(c):\n    return triple(c.gamma.d(1), c.gamma.d(2), c.gamma.d(3))\n"],
  ["extrema of curvature", 2, "from exactspline.language import det, dot, norm2\n\n\ndef extrema(c):\n    v, a, j = c.gamma.d(1), c.gamma.d(2), c.gamma.d(3)\n    return det(v, j) * norm2(v) - 3 * det(v, a) * dot(v, a)\n"],
  ["evolute", 2, "from exactspline.language import det, norm2, perp\n\n\ndef evolute(c):\n    v = c.gamma.d(1)\n    return c.gamma + perp(v) * norm2(v) / det(v, c.gamma.d(2))\n"],
];

const say = statusLine(element("status"));
const kernel = new Kernel(say);
kernel.shows("reduce", element("found"));

function part(p) {
  const line = (name, value) => value && html("tr", {}, html("th", { scope: "row" }, name), html("td", { class: "number" }, value));
  const rows = [
    line("naive degree", p.naive),
    line("factors cancelled", p.cancelled),
    line("remaining factor", p.reduced),
    line("its degree", p.nominal),
    line("true degree", p.true),
    line("in lowest terms", p["lowest terms"]),
    ...Object.entries(p.meaning).map(([name, meaning]) => line(name, meaning)),
    ...Object.entries(p.lower).map(([d, n]) => line(`at d = ${d}`, n < 0 ? "it vanishes on every curve" : `the true degree is ${n}`)),
  ];
  return html("div", { class: "card" }, html("h2", {}, p.part), html("div", { class: "scroll" }, html("table", {}, ...rows.filter(Boolean))));
}

function show(answer) {
  const read = html("p", {}, html("code", {}, `${answer.name} = ${answer.text}`));
  element("found").replaceChildren(html("div", { class: "card" }, html("h2", {}, "As the library reads it"), read), ...answer.parts.map(part));
}

function go() {
  const asked = { text: element("text").value, dimension: Number(element("dimension").value), polynomial: element("polynomial").checked };
  const told = ({ answer, milliseconds }) => {
    show(answer);
    document.body.dataset.reduced = JSON.stringify(answer.parts);
    say(`verified by multiplication, ${milliseconds.toFixed(0)} ms`);
  };
  kernel.latest("reduce", asked, told, (problem) => {
    element("found").replaceChildren();
    say(problem.message, true);
  });
  say("reducing …");
}

function changed() {
  kernel.stale("reduce");
  say("");
}

element("samples").append(...SAMPLES.map(([name], i) => html("option", { value: i }, name)));
element("samples").onchange = () => {
  const [, dimension, text] = SAMPLES[element("samples").value];
  element("text").value = text;
  element("dimension").value = dimension;
  go();
};
element("go").onclick = go;
for (const id of ["text", "dimension", "polynomial"]) element(id).oninput = changed;
element("text").onkeydown = (event) => event.key === "Enter" && (event.ctrlKey || event.metaKey) && go();
show(first.reduce); // as computed when the site was built, until the library has started here
element("samples").onchange();
kernel.current("reduce");
