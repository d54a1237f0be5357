// Reads a pack of vectors: node reader.mjs near.json
import { readFileSync } from "node:fs";

// a C99 hexadecimal double such as -0x1.8p+3
function number(text) {
  const [, sign, lead, digits, exponent] = /^(-?)0x([01])\.?([0-9a-f]*)p([+-]\d+)$/.exec(text);
  let value = Number(lead);
  let power = 1;
  for (const digit of digits) value += parseInt(digit, 16) * (power /= 16);
  const e = Number(exponent);
  const half = Math.trunc(e / 2);
  return (sign ? -1 : 1) * value * 2 ** half * 2 ** (e - half);
}

const TABLE = Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
});

function crc32(text) {
  let crc = -1;
  for (let i = 0; i < text.length; i++) crc = (crc >>> 8) ^ TABLE[(crc ^ text.charCodeAt(i)) & 255];
  return ((crc ^ -1) >>> 0).toString(16).padStart(8, "0");
}

// the homogeneous point at t, in doubles
function deBoor(degree, knots, rows, t) {
  let j = degree;
  for (let k = degree; k < knots.length - degree - 1; k++) if (knots[k] < knots[k + 1] && knots[k] <= t) j = k;
  const d = [];
  for (let i = 0; i <= degree; i++) d.push(rows[j - degree + i].slice());
  for (let r = 1; r <= degree; r++)
    for (let i = degree; i >= r; i--) {
      const s = (t - knots[j - degree + i]) / (knots[j + 1 + i - r] - knots[j - degree + i]);
      d[i] = d[i].map((q, k) => (1 - s) * d[i - 1][k] + s * q);
    }
  return d[degree];
}

const homogeneous = ({ points, weights }) =>
  points.map((p, i) => [...p.map((x) => number(x) * number(weights[i])), number(weights[i])]);

const counts = { cases: 0, damaged: 0, none: 0, these: 0, all: 0, undefined: 0, inexact: 0, meetings: 0, apart: 0 };
const text = readFileSync(process.argv[2], "latin1");
for (const line of text.split("\n")) {
  // one case per line, as written: its digest is of the text between "case": and the last brace
  const match = /^\{"digest":"([0-9a-f]{8})","case":(.*)\},?$/.exec(line);
  if (!match) continue;
  const data = JSON.parse(match[2]);
  counts.cases++;
  if (crc32(match[2]) !== match[1]) counts.damaged++;
  for (const answer of Object.values(data.answers)) counts[answer.answer]++;
  const [rows, partner] = [data.doubles, data.partner.doubles].map(homogeneous);
  const knots = data.doubles.knots.map(number);
  const point = deBoor(data.degree, knots, rows, number(data.parameter.double));
  const truth = data.answers.value.items[0];
  const w = point.pop();
  if (point.some((x, i) => x / w !== number(truth["xyz"[i]][1]))) counts.inexact++;
  const size = Math.max(...rows.flat().map(Math.abs));
  // the points that a curve and its partner have in common; apart: that differ by more than 2⁻⁴⁰ of the size
  for (const item of data.answers.intersections.items ?? []) {
    if (!item.parameter) continue;
    counts.meetings++;
    const p = deBoor(data.degree, knots, rows, number(item.parameter[1]));
    const q = deBoor(data.degree, knots, partner, number(item["other parameter"][1]));
    const [v, w] = [p.pop(), q.pop()];
    if (p.some((x, i) => Math.abs(x / v - q[i] / w) > 2 ** -40 * size)) counts.apart++;
  }
}
console.log(Object.entries(counts).map(([name, count]) => `${name} ${count}`).join(" "));
