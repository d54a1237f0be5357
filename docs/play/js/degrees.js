// Bars of degrees over the degree of the curve; the numbers are those of the library, made when the site was built.

import { data, element } from "./site.js";
import { html } from "./svg.js";

const COLUMNS = [
  ["naive", "naive", "var(--orange)"],
  ["paper", "in the paper", "var(--sky)"],
  ["true", "lowest", "var(--green)"],
];

const tables = await data("degrees");

function show() {
  const d = Number(element("d").value);
  element("shown").textContent = d;
  const rows = tables[element("polynomial").checked ? "polynomial" : "rational"];
  const largest = Math.max(...rows.map((row) => row.naive.values[d] ?? 0));
  const bar = (row, [key, , colour]) => {
    const value = row[key].values[d];
    if (value === undefined) return html("div", { class: "bar none" }, "–");
    const width = `${Math.max((100 * value) / largest, 0.4)}%`;
    return html("div", { class: "bar" }, html("span", { style: `width:${width};background:${colour}` }), `${value}`, html("small", {}, row[key].text));
  };
  element("key").replaceChildren(...COLUMNS.map(([, name, colour]) => html("span", {}, html("span", { class: "key", style: `background:${colour}` }), name)));
  element("bars").replaceChildren(
    html("thead", {}, html("tr", {}, html("th", {}, "construction"), ...COLUMNS.map(([, name, colour]) => html("th", { class: "formula" }, html("span", { class: "key", style: `background:${colour}` }), name)), html("th", { class: "wide" }, `at d = ${d}`))),
    html(
      "tbody",
      {},
      ...rows.map((row) =>
        html("tr", {}, html("th", { scope: "row" }, row.object), ...COLUMNS.map(([key]) => html("td", { class: "number" }, row[key].text)), html("td", { class: "wide" }, ...COLUMNS.map((column) => bar(row, column)))),
      ),
    ),
  );
}

element("d").oninput = element("polynomial").onchange = show;
show();
