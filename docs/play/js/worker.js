// The library in the page: Python compiled to WebAssembly runs the very wheels that are tested and proved elsewhere.
// A module worker, since browsers refuse to compile a module this large on the main thread.
import { loadPyodide } from "../vendor/pyodide/pyodide.mjs";

const ROOT = new URL("../", import.meta.url);
const STEPS = ["starting Python", "unpacking the library", "first import"];

const tell = (step) => postMessage({ step, steps: STEPS.length, doing: STEPS[step] ?? "ready" });

async function fetched(path) {
  const response = await fetch(new URL(path, ROOT));
  if (!response.ok) throw new Error(`${path} could not be loaded (${response.status})`);
  return response;
}

async function start() {
  tell(0);
  const library = fetched("vendor/library.zip").then((response) => response.arrayBuffer());
  const scripts = ["gmpy2.py", "page.py"].map(async (name) => [name, await (await fetched(`python/${name}`)).text()]);
  const python = await loadPyodide({
    indexURL: new URL("vendor/pyodide/", ROOT).href,
    env: { MPMATH_NOGMPY: "1", HOME: "/home/pyodide" },
  });
  tell(1);
  python.unpackArchive(await library, "zip");
  for (const [name, text] of await Promise.all(scripts)) python.FS.writeFile(`/home/pyodide/${name}`, text);
  python.runPython("import sys; sys.path.insert(0, '/home/pyodide')");
  tell(2);
  const { answer } = python.pyimport("page");
  tell(3);
  return answer;
}

const ready = start();
ready.catch((problem) => postMessage({ broken: problem.message }));

onmessage = async ({ data: { id, question, data } }) => {
  const answer = await ready;
  const begun = performance.now();
  const told = JSON.parse(answer(question, JSON.stringify(data)));
  postMessage({ id, ...told, milliseconds: performance.now() - begun });
};
