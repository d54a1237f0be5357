// Each cell of a table knows its heading: on a telephone it stands before the cell.
addEventListener("DOMContentLoaded", () => {
  for (const table of document.querySelectorAll("article table")) {
    const names = [...table.querySelectorAll("thead th")].map((head) => head.textContent.trim());
    if (names.length < 2) continue;
    table.classList.add("labelled");
    for (const row of table.tBodies[0]?.rows ?? []) [...row.cells].forEach((cell, i) => names[i] && (cell.dataset.name = names[i]));
  }
});

// Formulas are broken into lines anew when the page has another width.
let width = innerWidth;
addEventListener("resize", () => {
  if (innerWidth === width || !window.MathJax?.startup?.document) return;
  width = innerWidth;
  MathJax.startup.promise = MathJax.startup.promise.then(() => MathJax.startup.document.rerenderPromise(MathJax._.core.MathItem.STATE.COMPILED));
});
