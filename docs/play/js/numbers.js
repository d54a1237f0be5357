// Exact numbers as text ("3/4", "0.1", "-2"): what a control point is; doubles only draw it.

const FORM = /^\s*([+-]?)(\d+)(?:\/(\d+)|\.(\d*))?\s*$/;

// The double next to a rational written as text; NaN for what is none.
export function double(text) {
  const found = FORM.exec(text);
  if (!found) return NaN;
  const [, sign, whole, below, decimals] = found;
  const size = below ? Number(whole) / Number(below) : Number(`${whole}.${decimals ?? "0"}`);
  return Number.isFinite(size) ? (sign === "-" ? -size : size) : NaN;
}

// A double brought to a multiple of 1/steps, as text in lowest terms.
export function snapped(value, steps) {
  let top = Math.round(value * steps);
  let bottom = steps;
  while (bottom % 2 === 0 && top % 2 === 0) [top, bottom] = [top / 2, bottom / 2];
  return bottom === 1 ? `${top}` : `${top}/${bottom}`;
}
