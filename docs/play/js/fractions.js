// Exact numbers and points as formulas that browsers draw.

const NAMESPACE = "http://www.w3.org/1998/Math/MathML";

function element(name, ...children) {
  const made = document.createElementNS(NAMESPACE, name);
  made.append(...children);
  return made;
}

function number(text) {
  const [top, bottom] = text.replace("-", "").split("/");
  const size = bottom ? element("mfrac", element("mn", top), element("mn", bottom)) : element("mn", top);
  if (!text.startsWith("-")) return [size];
  const minus = element("mo", "−");
  minus.setAttribute("form", "prefix");
  return [minus, size];
}

// One number, or a point between parentheses; what is longer than this many characters is cut to decimals.
export function formula(numbers, longest = 40) {
  const long = numbers.join("").length > longest;
  const shown = numbers.map((text) => (long && text.includes("/") ? rounded(text) : text));
  const parts = shown.flatMap((text, i) => [...(i ? [element("mo", ",")] : []), ...number(text)]);
  const made = element("math", ...(numbers.length > 1 ? [element("mo", "("), ...parts, element("mo", ")")] : parts));
  made.setAttribute("title", numbers.join(", "));
  return made;
}

function rounded(text) {
  const [top, bottom] = text.split("/");
  return `${(Number(top) / Number(bottom)).toFixed(6)}…`;
}
