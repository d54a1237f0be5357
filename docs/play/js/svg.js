// Small helpers for SVG and HTML elements.

export function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

export function html(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made[key] = value;
    else if (value !== false) made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

// A path through points, broken where `joined` says that two neighbours do not belong together.
export function path(points, joined = () => true) {
  let text = "";
  points.forEach((p, i) => {
    if (!p.every(Number.isFinite)) return;
    const pen = i && joined(points[i - 1], p) ? "L" : "M";
    text += `${pen}${p[0].toFixed(2)} ${p[1].toFixed(2)}`;
  });
  return text;
}
