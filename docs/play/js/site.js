// What all pages have: the status line, the data, a place in a page of others.

// Within a page of others: no side bar; tell it how high this one is, so that its frame grows with what is shown.
export function embedded() {
  if (new URLSearchParams(location.search).has("embed")) document.body.classList.add("embedded");
}

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
