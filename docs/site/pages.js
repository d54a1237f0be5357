// Each cell of a table knows its heading: on a telephone it stands before the cell.
addEventListener("DOMContentLoaded", () => {
  for (const table of document.querySelectorAll("article table")) {
    const names = [...table.querySelectorAll("thead th")].map((head) => head.textContent.trim());
    if (names.length < 2) continue;
    table.classList.add("labelled");
    for (const row of table.tBodies[0]?.rows ?? []) {
      [...row.cells].forEach((cell, i) => {
        if (!cell.innerHTML.replace(/<\/?p>/g, "").trim()) cell.classList.add("nothing");
        else if (names[i]) cell.dataset.name = names[i];
      });
    }
  }
});

// Long words may be broken in a table after a sign, or after this many letters without one (as in exactspline.display.tables).
const PIECES = /\S{4,23}?[_.(,:/=]|\S{1,24}|\s+/g;
const SHORT = 14;
addEventListener("DOMContentLoaded", () => {
  for (const cell of document.querySelectorAll("article td :not(script), article td")) {
    for (const node of [...cell.childNodes].filter((each) => each.nodeType === Node.TEXT_NODE)) {
      const parts = node.data.split(/(\s+)/).flatMap((word) => (word.length > SHORT ? word.match(PIECES) : [word])).filter(Boolean);
      if (parts.length > 1 && !node.data.includes("$")) node.replaceWith(...parts.flatMap((part, i) => (i ? [document.createElement("wbr"), part] : [part])));
    }
  }
});

// On a telephone the words of a picture are small: it leads to itself alone, where it can be enlarged.
addEventListener("load", () => {
  for (const picture of document.querySelectorAll("article img")) {
    if (picture.closest("a") || picture.src.startsWith("data:") || picture.naturalWidth <= 1.2 * picture.clientWidth || !picture.clientWidth) continue;
    const link = Object.assign(document.createElement("a"), { href: picture.currentSrc, className: "alone", title: "the picture alone, to enlarge it" });
    const whole = picture.closest("picture") ?? picture;
    whole.replaceWith(link);
    link.append(whole);
  }
});

// Formulas are broken into lines anew when the page has another width.
let width = innerWidth;
addEventListener("resize", () => {
  if (innerWidth === width || !window.MathJax?.startup?.document) return;
  width = innerWidth;
  MathJax.startup.promise = MathJax.startup.promise.then(() => MathJax.startup.document.rerenderPromise(MathJax._.core.MathItem.STATE.COMPILED));
});
