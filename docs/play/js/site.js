// The links between the pages, and the status line that all of them have.

import { html } from "./svg.js";

const PAGES = [
  ["../index.html", "exactspline"],
  ["curve.html", "curve"],
  ["reduce.html", "reduce"],
  ["claims.html", "claims"],
  ["de-boor.html", "de Boor"],
  ["bisector.html", "bisector"],
  ["surface.html", "surfaces"],
  ["degrees.html", "degrees"],
];

export function navigation() {
  const here = location.pathname.split("/").at(-1);
  document.querySelector("header nav").append(
    ...PAGES.map(([href, name]) => html("a", { href, "aria-current": href === here ? "page" : false }, name)),
  );
  if (new URLSearchParams(location.search).has("embed")) document.body.classList.add("embedded");
}

export function statusLine(element) {
  return (text, problem = false) => {
    element.textContent = text;
    element.classList.toggle("problem", problem);
  };
}

export const element = (id) => document.getElementById(id);

export async function data(name) {
  const response = await fetch(new URL(`../data/${name}.json`, import.meta.url));
  return response.json();
}
