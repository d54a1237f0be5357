// The links between the pages, and the status line that all of them have.

import { html } from "./svg.js";

const SECTIONS = [
  ["../index.html", "exactspline"],
  ["../learn.html", "Learn"],
  ["../papers.html", "Check a paper"],
  ["../compute.html", "Compute"],
  ["../mathematics.html", "Mathematics"],
  ["../reference.html", "Reference"],
];
const PAGES = [
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
  const row = (pages) => html("div", {}, ...pages.map(([href, name]) => html("a", { href, "aria-current": href === here ? "page" : false }, name)));
  document.querySelector("header nav").append(row(SECTIONS), row(PAGES));
  if (new URLSearchParams(location.search).has("embed")) document.body.classList.add("embedded");
}

// Within a page of others: tell it how high this one is, so that its frame grows with what is shown.
export function reportHeight() {
  if (window.parent === window) return;
  new ResizeObserver(() => parent.postMessage({ exactspline: document.body.offsetHeight }, "*")).observe(document.body);
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
