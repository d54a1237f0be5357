// The ledger: searched and opened; a refuted claim shows the curve on which it fails.

import { data, element } from "./site.js";
import { html } from "./svg.js";

const claims = await data("claims");
const plain = (text) => text.toLowerCase();
const haystacks = claims.map((c) => plain([c.id, c.source, c.statement, c.words, c.key, ...c.sides.map((s) => `${s.name} ${s.text}`)].join(" ")));
const SHOWN = 60;

function formula(latex) {
  const made = html("div", { class: "formula" });
  katex.render(latex, made, { throwOnError: false });
  return made;
}

function quoted(parts) {
  return parts.map(([isFormula, text]) => {
    const made = html("span", {}, isFormula ? "" : text);
    if (isFormula) katex.render(text, made, { throwOnError: false });
    return made;
  });
}

function row(name, ...content) {
  return content.every((c) => c === "" || c === null) ? "" : html("p", {}, html("b", {}, `${name}: `), ...content);
}

function opened(c) {
  const sides = c.sides.map((s) => html("div", {}, html("p", {}, html("b", {}, `${s.role}: `), s.source, s.rational ? ` · degree ${s.rational}` : "", s.polynomial && s.polynomial !== s.rational ? ` (polynomial: ${s.polynomial})` : ""), formula(`\\displaystyle ${s.latex}`)));
  return html(
    "div",
    { class: "opened" },
    c.latex ? formula(`\\displaystyle ${c.latex}`) : "",
    c.words ? row("words", "“", ...quoted(c.quoted), "”", c.place ? ` (${c.place})` : "") : "",
    ...sides,
    row("assumes", c.assumes),
    row("found", c.computed === c.claimed ? "" : c.computed),
    row("witness", c.witness, c.curve ? " " : "", c.curve ? html("a", { href: `curve.html#${c.curve}` }, "open the curve") : ""),
    row("note", c.note),
  );
}

function entry(c) {
  const made = html("details", { class: "card" }, html("summary", {}, html("span", { class: `verdict ${c.verdict}` }, c.verdict), ` ${c.id}, ${c.source}: ${c.statement}`));
  made.ontoggle = () => made.children.length === 1 && made.append(opened(c));
  return made;
}

function show() {
  const words = plain(element("search").value).split(/\s+/).filter(Boolean);
  const [paper, verdict] = [element("paper").value, element("verdict").value];
  const found = claims.filter((c, i) => (!paper || c.paper === paper) && (!verdict || c.verdict === verdict) && words.every((w) => haystacks[i].includes(w)));
  element("count").textContent = `${found.length} of ${claims.length}${found.length > SHOWN ? `, the first ${SHOWN} shown` : ""}`;
  element("claims").replaceChildren(...found.slice(0, SHOWN).map(entry));
}

const papers = new Map(claims.map((c) => [c.paper, c.title]));
element("paper").append(html("option", { value: "" }, "all"), ...[...papers].map(([value, title]) => html("option", { value }, title)));
for (const id of ["search", "paper", "verdict"]) element(id).oninput = show;

// claims.html?KEY is one claim, opened, and claims.html?SOURCE are those of a source
function asked() {
  const name = decodeURIComponent((location.search || location.hash).slice(1));
  const one = claims.filter((c) => c.key === name);
  if (papers.has(name)) element("paper").value = name;
  show();
  if (!one.length) return;
  element("claims").replaceChildren(...one.map(entry));
  element("count").textContent = `${one.length} of ${claims.length}`;
  for (const made of element("claims").children) made.open = true;
}
window.addEventListener("hashchange", asked);
asked();
