// Answers questions about Bezier segments, one JSON object a line: {question, points, t} in, {answer} or {raised} out.
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const { Bezier } = await import(pathToFileURL(`${process.argv[2]}/src/bezier.js`).href);
const rows = (curve) => curve.points.map((p) => [p.x, p.y]);
const pair = (p) => [p.x, p.y];

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
};

for await (const line of createInterface({ input: process.stdin })) {
  const { question, points, t } = JSON.parse(line);
  let reply;
  try {
    const answer = answers[question](new Bezier(points.map(([x, y]) => ({ x, y }))), t);
    // JSON has no NaN
    reply = JSON.stringify({ answer }, (_, v) => (typeof v === "number" && !Number.isFinite(v) ? String(v) : v));
  } catch (error) {
    reply = JSON.stringify({ raised: String(error) });
  }
  process.stdout.write(reply + "\n");
}
