"""Compiles the optional extension beside its source, where there is a compiler, for a wheel and for an editable
installation (hatchling); ``python hatch_build.py`` does it in a checkout. Without a compiler it is absent.

Beside it goes the digest of its source and of its bytes, by which it is known again before it is loaded
(`exactspline.numbers.extension`).
"""

import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tomllib
from hashlib import sha256
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory

SOURCE = Path(__file__).parent / "exactspline" / "programs" / "filter.c"
LIBRARY = SOURCE.with_name("filter.lib")
#: Every operation rounds its own result: no contraction, no other order of operations, also where CC asks for that.
EXACT = (
    "-ffp-contract=off",
    "-fno-fast-math",
    "-fno-associative-math",
    "-fno-reciprocal-math",
    "-fno-finite-math-only",
)
FLAGS = ("-std=c11", "-O2", "-shared", "-fPIC")
WARNINGS = ("-Wall", "-Wextra")
#: What a distribution asks of every compiler; what would change a result is taken back by `EXACT`, which comes later.
ASKED = ("ARCHFLAGS", "CPPFLAGS", "CFLAGS", "LDFLAGS")


def tag() -> str:
    """The tag of a wheel with the extension: of the platform for which it was compiled, which on macOS goes with the
    architectures in ARCHFLAGS; for every version of Python 3, since the extension knows nothing of Python.
    """
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    words = shlex.split(os.environ.get("ARCHFLAGS", ""))
    architectures = {word for flag, word in pairwise(words) if flag == "-arch"}
    if platform.startswith("macosx_") and architectures:
        _, major, minor, *_ = platform.split("_")
        platform = f"macosx_{major}_{minor}_{'universal2' if len(architectures) > 1 else min(architectures)}"
    return f"py3-none-{platform}"


def page_for_an_index(text: str, repository: str) -> str:
    """The README with addresses that work elsewhere: those of the repository; without one, pictures are left out and
    links are their words.
    """
    if not repository:
        text = re.sub(r"!\[[^]]*\]\((?!https?:)[^)]*\)\n*", "", text)
        return re.sub(r"\[([^]]*)\]\((?!https?:)[^)]*\)", r"\1", text)
    text = re.sub(r"(!\[[^]]*\]\()(?!https?:)", rf"\1{repository}/raw/main/", text)
    return re.sub(r"((?<!!)\[[^]]*\]\()(?!https?:)(?=[^)]*\))", rf"\1{repository}/blob/main/", text)


def digest_of(library: Path) -> Path:
    """Where the digest of a library is."""
    return library.with_name(f"{library.name}.sha256")


def compiled(target: Path = LIBRARY, *more: str) -> bool:
    """Compile the extension; False, and the reason on standard error, where that is not possible."""
    compiler = shlex.split(os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc")
    asked = [flag for name in ASKED for flag in shlex.split(os.environ.get(name, ""))]
    # in a room of its own: nobody may load half a library, and who has loaded the former one keeps it
    with TemporaryDirectory(dir=target.parent) as room:
        made = Path(room) / target.name
        command = [*compiler, *FLAGS, *asked, *EXACT, *WARNINGS, *more, SOURCE.name, "-o", str(made), "-lm"]
        try:
            done = subprocess.run(command, cwd=SOURCE.parent, capture_output=True, text=True, check=False)
        except OSError as error:
            print(f"no extension: {error}", file=sys.stderr)
            return False
        if done.returncode:
            print(f"no extension: {done.stderr}", file=sys.stderr)
            return False
        digest = sha256(SOURCE.read_bytes() + made.read_bytes()).hexdigest()
        digest_of(made).write_text(f"{digest}\n", encoding="ascii")
        for file in (made, digest_of(made)):
            file.replace(target.with_name(file.name))
    return True


try:
    from hatchling.builders.hooks.plugin.interface import BuildHookInterface
    from hatchling.metadata.plugin.interface import MetadataHookInterface
except ImportError:  # run as a program
    BuildHookInterface = None
else:

    class Addresses(MetadataHookInterface):
        """The metadata hook: the README for an index page, and where the project is to be found."""

        def update(self, metadata):
            """Set what the table `project` names as dynamic."""
            root = Path(self.root)
            address = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["exactspline"]
            repository = address["repository"].rstrip("/")
            text = page_for_an_index((root / "README.md").read_text(encoding="utf-8"), repository)
            metadata["readme"] = {"content-type": "text/markdown", "text": text}
            metadata["urls"] = (
                repository
                and {
                    "Repository": repository,
                    "Documentation": f"{repository}/tree/main/docs",
                    "Changelog": f"{repository}/blob/main/CHANGELOG.md",
                    "Issues": f"{repository}/issues",
                }
            ) or {}

        def get_known_classifiers(self):
            """None of our own."""
            return []

    class Extension(BuildHookInterface):
        """The build hook: a wheel with the extension is one for a platform, but for every version of Python 3."""

        def initialize(self, version, build_data):
            """Compile before the files are collected."""
            LIBRARY.unlink(missing_ok=True)
            if compiled():
                files = (LIBRARY, digest_of(LIBRARY))
                build_data["artifacts"] += [file.relative_to(self.root).as_posix() for file in files]
                if version != "editable":
                    build_data["pure_python"], build_data["tag"] = False, tag()
            else:
                self.app.display_warning(
                    "no compiler: without the extension answers are the same, and many curves take longer"
                )


if __name__ == "__main__":
    sys.exit(0 if compiled() else 1)
