// A spline function with its control polygon and its zeros, jumps dotted; what is far above the usual values leaves the picture.

import { svg, path } from "./svg.js";
import { values } from "./preview.js";

const [WIDTH, HEIGHT, PAD] = [420, 120, 8];
// The picture ends at this many times the median of the absolute values.
const TRIMMED = 6;

export function chart(form) {
  const [low, high] = [form.knots[form.degree], form.knots.at(-1 - form.degree)];
  const drawn = values(form);
  const heights = drawn.flat().map(([, y]) => Math.abs(y)).sort((a, b) => a - b);
  const top = Math.min(heights.at(-1), TRIMMED * heights[heights.length >> 1]) || 1;
  const to = ([t, y]) => [PAD + ((WIDTH - 2 * PAD) * (t - low)) / (high - low), HEIGHT / 2 - ((HEIGHT / 2 - PAD) * y) / top];
  const polygon = form.abscissae.map((t, i) => to([t, form.ordinates[i]]));
  // where a form jumps, two of its control points stand above each other
  const joined = (a, b) => b[0] - a[0] > 1e-6;
  const radius = form.controls > 60 ? 1.3 : 2.6;
  return svg(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "chart", role: "img", "aria-label": `function of degree ${form.degree}` },
    svg("path", { d: path([to([low, 0]), to([high, 0])]), class: "zero" }),
    svg("path", { d: path(polygon, joined), class: "polygon" }),
    ...polygon.map(([cx, cy]) => svg("circle", { cx, cy, r: radius })),
    ...drawn.map((segment) => svg("path", { d: path(segment.map(to)), class: "function" })),
    ...drawn.slice(1).map((segment, i) => svg("path", { d: path([to(drawn[i].at(-1)), to(segment[0])]), class: "jump" })),
    ...form.zeros.map((t) => {
      const [cx, cy] = to([t, 0]);
      return svg("circle", { cx, cy, r: 4, class: "root" });
    }),
  );
}
