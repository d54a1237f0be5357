// What all pages have: the status line, the data, a place in a page of others.

// Within a page of others: no side bar; tell it how high this one is, so that its frame grows with what is shown.
export function embedded() {
  const view = new URLSearchParams(location.search).get("embed");
  if (view !== null) document.body.classList.add("embedded");
  if (view === "short") document.body.classList.add("short");
}

export function reportHeight() {
  if (window.parent === window) return;
  new ResizeObserver(() => parent.postMessage({ exactspline: document.body.offsetHeight }, "*")).observe(document.body);
}

export function statusLine(element) {
  return (text, problem = false) => {
    element.textContent = text;
    element.removeAttribute("aria-busy"); // what is said is said now
    element.classList.toggle("problem", problem);
  };
}

export const element = (id) => document.getElementById(id);

export async function data(name) {
  const response = await fetch(new URL(`../data/${name}.json`, import.meta.url));
  return response.json();
}
