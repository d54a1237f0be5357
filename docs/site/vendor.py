"""What the pages need of others, from the package registries, into the site itself: no page asks another host."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

#: Packages of npm: name, version, the folder inside, and where it goes.
NPM = (
    ("pyodide", "314.0.7", "package", "pyodide"),
    ("katex", "0.16.22", "package/dist", "katex"),
    ("mathjax", "4.1.3", "package", "mathjax"),
    ("@mathjax/mathjax-newcm-font", "4.1.3", "package/svg/dynamic", "mathjax-font"),
)
#: What the written pages load of MathJax, and the signs beyond those that it brings along.
MATHJAX = ("tex-svg.js", "a11y/assistive-mml.js", "input/tex/extensions/boldsymbol.js")
SIGNS = (
    "arrows",
    "calligraphic",
    "double-struck",
    "fraktur",
    "marrows",
    "mshapes",
    "script",
    "shapes",
    "symbols",
    "variants",
)
#: The platform of that Pyodide, as pip names it.
PLATFORM = ("--platform", "pyemscripten_2026_0_wasm32", "--python-version", "314", "--implementation", "cp")
WHEELS = ("python-flint==0.9.0", "mpmath>=1.3", "lazy_loader>=0.6")
#: What of the packages no page reads.
SUPERFLUOUS = ("*.map", "*.d.ts", "console*.html", "README.md", "*.ttf", "*.woff", "contrib/*.js.map")


def vendor(cache: Path, target: Path, project: Path) -> None:
    """Everything into the folder `target`, downloads kept in `cache`; the wheel of the project is built anew."""
    cache.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    for name, version, inside, folder in NPM:
        _from_npm(
            f"{name.lstrip('@').replace('/', '-')}-{version}.tgz", f"{name}@{version}", inside, cache, target / folder
        )
    for pattern in SUPERFLUOUS:
        for file in target.rglob(pattern):
            file.unlink()
    wheels = cache / "wheels"
    if not wheels.exists():
        _pip("download", "--no-deps", "--only-binary=:all:", *PLATFORM, "--dest", str(wheels), *WHEELS)
    for file in wheels.glob("*.whl"):
        shutil.copy(file, target)
    _pip("wheel", "--no-deps", "--wheel-dir", str(target), str(project))
    script = Path(__file__).parent / "library.mjs"
    subprocess.run(["node", str(script), str(target / "pyodide"), str(target), str(target / "library.zip")], check=True)
    for file in target.glob("*.whl"):
        file.unlink()


def lay_out_mathjax(vendored: Path, target: Path) -> None:
    """What of MathJax is used, from where `vendor` put it into the folder of the written pages."""
    for name in MATHJAX:
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(vendored / "mathjax" / name, target / name)
    signs = target / "font" / "svg" / "dynamic"
    signs.mkdir(parents=True)
    for name in SIGNS:
        shutil.copy(vendored / "mathjax-font" / f"{name}.js", signs)
    for folder in ("mathjax", "mathjax-font"):
        shutil.rmtree(vendored / folder)


def _from_npm(file: str, package: str, inside: str, cache: Path, target: Path) -> None:
    archive = cache / file
    if not archive.exists():
        subprocess.run(["npm", "pack", "--silent", package], cwd=cache, check=True, stdout=subprocess.DEVNULL)
    unpacked = cache / archive.stem
    with tarfile.open(archive) as packed:
        packed.extractall(unpacked, filter="data")
    shutil.copytree(unpacked / inside, target)


def _pip(*arguments: str) -> None:
    command = [sys.executable, "-m", "pip", arguments[0], "--quiet", "--disable-pip-version-check", *arguments[1:]]
    subprocess.run(command, check=True)
