// Engines of npm, one in a process: node engines.mjs NAME NODE_MODULES. A line of JSON with two paths and an operation
// in, a line with the path that the engine made, or the exception, out; every number in full.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const [name, folder] = process.argv.slice(2);
const require = createRequire(`${folder}/`);
const version = JSON.parse(readFileSync(`${folder}/${name}/package.json`, "utf8")).version;
const text = (letter, numbers) => letter + numbers.map(String).join(" ");

function paper() {
  const library = require(`${folder}/paper/dist/paper-core.js`);
  library.setup(new library.Size(100, 100));
  const calls = { union: "unite", intersection: "intersect", difference: "subtract", xor: "exclude" };
  return (first, second, operation) => {
    const [a, b] = [first, second].map((data) => new library.CompoundPath(data));
    for (const path of [a, b]) path.fillRule = "nonzero";
    const made = a[calls[operation]](b, { insert: false });
    const parts = made.children ?? [made];
    const data = parts.filter((part) => part.curves.length).map((part) => {
      const curves = part.curves.map((c) => text("C", [c.point1.x + c.handle1.x, c.point1.y + c.handle1.y,
        c.point2.x + c.handle2.x, c.point2.y + c.handle2.y, c.point2.x, c.point2.y]));
      return text("M", [part.curves[0].point1.x, part.curves[0].point1.y]) + curves.join("") + "Z";
    });
    return { path: data.join(""), rule: made.fillRule === "evenodd" ? "even-odd" : "nonzero" };
  };
}

async function pathkit() {
  const start = require("pathkit-wasm");
  const library = await start({ wasmBinary: readFileSync(`${folder}/pathkit-wasm/bin/pathkit.wasm`) });
  const kinds = { union: "UNION", intersection: "INTERSECT", difference: "DIFFERENCE", xor: "XOR" };
  const letters = ["M", "L", "Q", null, "C", "Z"];
  return (first, second, operation) => {
    const [a, b] = [first, second].map((data) => library.FromSVGString(data));
    if (!a.op(b, library.PathOp[kinds[operation]])) throw new Error("op returned false");
    const commands = a.toCmds();
    const rule = a.getFillType() === library.FillType.EVENODD ? "even-odd" : "nonzero";
    for (const path of [a, b]) path.delete();
    return { path: commands.map(([verb, ...numbers]) => text(letters[verb], numbers)).join(""), rule };
  };
}

async function pathBool() {
  const library = await import(pathToFileURL(`${folder}/path-bool/dist/path-bool.js`).href);
  const kinds = { union: "Union", intersection: "Intersection", difference: "Difference", xor: "Exclusion" };
  return (first, second, operation) => {
    const [a, b] = [first, second].map(library.pathFromPathData);
    const rule = library.FillRule.NonZero;
    const both = new library.PathBoolean([a, b].map((path) => ({ path, fillRule: rule })));
    const made = both.get(library.PathBooleanOperation[kinds[operation]]);
    // the ends of its segments meet within 10⁻⁴ alone; its own conversion joins them
    const data = made.map((path) => [...library.pathToCommands(path)].map(([letter, ...points]) =>
      text(letter, points.flatMap((p) => [...p]))).join("") + "Z");
    return { path: data.join(""), rule: "nonzero" };
  };
}

const combine = await { paper, "pathkit-wasm": pathkit, "path-bool": pathBool }[name]();
console.log(JSON.stringify({ version }));
for await (const line of createInterface({ input: process.stdin })) {
  const { first, second, operation } = JSON.parse(line);
  let reply;
  try {
    reply = combine(first, second, operation);
  } catch (error) {
    reply = { raised: `${error.name}: ${error.message}`.slice(0, 300) };
  }
  console.log(JSON.stringify(reply));
}
