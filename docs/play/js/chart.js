// A spline function with its control polygon and its zeros, scaled to the largest ordinate.

import { svg, path } from "./svg.js";
import { values } from "./preview.js";

const [WIDTH, HEIGHT, PAD] = [420, 120, 8];

export function chart(form) {
  const [low, high] = [form.knots[form.degree], form.knots.at(-1 - form.degree)];
  const to = ([t, y]) => [PAD + ((WIDTH - 2 * PAD) * (t - low)) / (high - low), HEIGHT / 2 - (HEIGHT / 2 - PAD) * y];
  const polygon = form.abscissae.map((t, i) => to([t, form.ordinates[i]]));
  const radius = form.controls > 60 ? 1.3 : 2.6;
  return svg(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "chart", role: "img", "aria-label": `function of degree ${form.degree}` },
    svg("path", { d: path([to([low, 0]), to([high, 0])]), class: "zero" }),
    svg("path", { d: path(polygon), class: "polygon" }),
    ...polygon.map(([cx, cy]) => svg("circle", { cx, cy, r: radius })),
    svg("path", { d: path(values(form).map(to)), class: "function" }),
    ...form.zeros.map((t) => {
      const [cx, cy] = to([t, 0]);
      return svg("circle", { cx, cy, r: 4, class: "root" });
    }),
  );
}
