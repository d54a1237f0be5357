// A picture of a NURBS curve in doubles, at once; every number that is shown comes from the library instead.

import { double } from "./numbers.js";

const combine = (a, x, b, y) => x.map((v, i) => a * v + b * y[i]);

function segmentOf(knots, degree, count, t) {
  let low = degree;
  while (low + 1 < count && knots[low + 1] <= t) low += 1;
  return low;
}

function deBoor(knots, degree, points, t) {
  const at = segmentOf(knots, degree, points.length, t);
  const row = points.slice(at - degree, at + 1);
  for (let level = 1; level <= degree; level += 1)
    for (let j = degree; j >= level; j -= 1) {
      const i = at - degree + j;
      const width = knots[i + degree + 1 - level] - knots[i];
      const share = width ? (t - knots[i]) / width : 0;
      row[j] = combine(1 - share, row[j - 1], share, row[j]);
    }
  return row[degree];
}

function derivative({ knots, degree, points }) {
  if (degree === 0) return { knots, degree, points: points.map((p) => p.map(() => 0)) };
  const slopes = points.slice(1).map((p, i) => {
    const width = knots[i + 1 + degree] - knots[i + 1];
    const factor = width ? degree / width : 0;
    return combine(factor, p, -factor, points[i]);
  });
  return { knots: knots.slice(1, -1), degree: degree - 1, points: slopes };
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
const times = (c, a) => [c * a[0], c * a[1]];
const det = (a, b) => a[0] * b[1] - a[1] * b[0];

// The values of a spline function at this many parameters of each segment: at both ends its own, so that jumps are seen.
export function values({ knots, degree, ordinates }, count = 60) {
  const points = ordinates.map((y) => [y]);
  return overSegments(knots, degree, count, (t) => [t, deBoor(knots, degree, points, t)[0]]);
}

// Just inside the segment at its end: the last sample belongs to it, not to the next one.
function overSegments(knots, degree, count, at) {
  const breaks = [...new Set(knots.slice(degree, knots.length - degree))];
  return breaks.slice(1).map((high, i) =>
    Array.from({ length: count + 1 }, (_, k) => at(breaks[i] + ((high - breaks[i]) * Math.min(k, count - 1e-9)) / count)),
  );
}

// A function t ↦ {point, tangent, curvature, centre} of a curve as the pages hold it.
export function preview(curve) {
  const knots = curve.knots.map(double);
  const weights = curve.weights.map(double);
  const points = curve.points.map((p, i) => [double(p[0]) * weights[i], double(p[1]) * weights[i], weights[i]]);
  const forms = [{ knots, degree: curve.degree, points }];
  forms.push(derivative(forms[0]), derivative(derivative(forms[0])));
  return (t) => {
    const [p, p1, p2] = forms.map((f) => deBoor(f.knots, f.degree, f.points, t));
    const point = times(1 / p[2], p);
    const first = times(1 / p[2], minus(p1, times(p1[2], point)));
    const second = times(1 / p[2], minus(minus(p2, times(2 * p1[2], first)), times(p2[2], point)));
    const speed = Math.hypot(...first);
    const curvature = det(first, second) / speed ** 3;
    const normal = [-first[1] / speed, first[0] / speed];
    const centre = [point[0] + normal[0] / curvature, point[1] + normal[1] / curvature];
    return { t, point, first, normal, curvature, centre };
  };
}

// The segments of a curve, each as this many samples and its end: what jumps at a knot has two values there.
export function segments(curve, count = 96) {
  const at = preview(curve);
  const knots = curve.knots.map(double);
  return overSegments(knots, curve.degree, count, at);
}

export const samples = (curve, count) => segments(curve, count).flat();
