// Compile ahead, by the very Python that runs in the pages, what that Python would compile at every visit:
// its own library in place, and the library of the pages into one archive. node library.mjs PYODIDE WHEELS ARCHIVE
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [pyodide, wheels, archive] = process.argv.slice(2).map((path) => resolve(path));
const standard = join(pyodide, "python_stdlib.zip");
const { loadPyodide } = await import(pathToFileURL(join(pyodide, "pyodide.mjs")));
const python = await loadPyodide({ indexURL: `${pyodide}/` });
const unpack = (file, folder) => python.unpackArchive(new Uint8Array(readFileSync(file)), "zip", { extractDir: folder });
for (const name of readdirSync(wheels).filter((file) => file.endsWith(".whl"))) unpack(join(wheels, name), "/library");
unpack(standard, "/standard");
python.runPython(`
import compileall, pathlib, py_compile, shutil, zipfile

def packed(folder, file, keep_sources):
    folder = pathlib.Path(folder)
    for tests in [f for f in folder.rglob("test*") if f.is_dir()]:
        shutil.rmtree(tests)
    # times of files change when they are unpacked: what was compiled is believed
    mode = py_compile.PycInvalidationMode.UNCHECKED_HASH
    assert compileall.compile_dir(folder, quiet=1, invalidation_mode=mode, stripdir=folder, legacy=not keep_sources)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for f in sorted(f for f in folder.rglob("*") if f.is_file() and (keep_sources or f.suffix != ".py")):
            archive.write(f, f.relative_to(folder))

packed("/library", "/library.zip", True)
packed("/standard", "/standard.zip", False)
`);
writeFileSync(archive, python.FS.readFile("/library.zip"));
writeFileSync(standard, python.FS.readFile("/standard.zip"));
