// Answers questions about Bezier segments, one JSON object a line: {question, points, t, other, point} in, {answer} or {raised} out.
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const { Bezier } = await import(pathToFileURL(`${process.argv[2]}/src/bezier.js`).href);
const rows = (curve) => curve.points.map((p) => [p.x, p.y]);
const pair = (p) => [p.x, p.y];

const made = (points) => new Bezier(points.map(([x, y]) => ({ x, y })));
// the size to which parts are halved, by default 1/2 for curves of hundreds of pixels
const THRESHOLD = 1e-5;

const answers = {
  value: (b, t) => pair(b.get(t)),
  first: (b, t) => pair(b.derivative(t)),
  second: (b, t) => pair(b.dderivative(t)),
  curvature: (b, t) => [Math.abs(b.curvature(t).k)],
  // the normal turned back by a right angle
  tangent: (b, t) => { const n = b.normal(t); return [n.y, -n.x]; },
  box: (b) => { const { x, y } = b.bbox(); return [x.min, x.max, y.min, y.max]; },
  turns: (b) => ["x", "y"].map((d) =>
    Bezier.getUtils().droots(b.dpoints[0].map((p) => p[d])).filter((t) => t >= 0 && t <= 1)),
  roots: (b) => {
    const xs = b.points.map((p) => p.x);
    const line = { p1: { x: Math.min(...xs) - 1, y: 0 }, p2: { x: Math.max(...xs) + 1, y: 0 } };
    return [b.lineIntersects(line)];
  },
  inflections: (b) => [b.inflections()],
  // documented as numerical: a part of 1/100 is taken for right
  length: (b) => [b.length(), b.length() / 100],
  split: (b, t) => { const parts = b.split(t); return [...rows(parts.left), ...rows(parts.right)]; },
  elevate: (b) => rows(b.raise()),
  // a search in steps of 1/1000 of the domain: the way of the point in one is taken for right
  nearest: (b, t, { point }) => {
    const legs = b.points.slice(1).map((p, i) => Math.hypot(p.x - b.points[i].x, p.y - b.points[i].y));
    return [b.project({ x: point[0], y: point[1] }).d, (b.order * Math.max(...legs)) / 1000];
  },
  meetings: (b, t, { other }) =>
    b.intersects(made(other), THRESHOLD).map((pair) => pair.split("/").map(Number)),
};

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  let reply;
  try {
    const answer = answers[asked.question](made(asked.points), asked.t, asked);
    // JSON has no NaN
    reply = JSON.stringify({ answer }, (_, v) => (typeof v === "number" && !Number.isFinite(v) ? String(v) : v));
  } catch (error) {
    reply = JSON.stringify({ raised: String(error) });
  }
  process.stdout.write(reply + "\n");
}
