"""Compiles the optional extension beside its source, where there is a compiler, for a wheel and for an editable
installation (hatchling); ``python hatch_build.py`` does it in a checkout. Without a compiler it is absent.
"""

import os
import shlex
import subprocess
import sys
import sysconfig
from pathlib import Path

SOURCE = Path(__file__).parent / "exactspline" / "programs" / "filter.c"
LIBRARY = SOURCE.with_name("filter.lib")
#: Every operation rounds its own result: no contraction, no other order of operations.
FLAGS = ("-std=c11", "-O2", "-shared", "-fPIC", "-ffp-contract=off", "-fno-fast-math", "-Wall", "-Wextra", "-Werror")


def compiled(target: Path = LIBRARY, *more: str) -> bool:
    """Compile the extension; False, and the reason on standard error, where that is not possible."""
    compiler = shlex.split(os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc")[:1]
    try:
        command = [*compiler, *FLAGS, *more, SOURCE.name, "-o", str(target), "-lm"]
        done = subprocess.run(command, cwd=SOURCE.parent, capture_output=True, text=True, check=False)
    except OSError as error:
        print(f"no extension: {error}", file=sys.stderr)
        return False
    if done.returncode:
        print(f"no extension: {done.stderr}", file=sys.stderr)
    return done.returncode == 0


try:
    from hatchling.builders.hooks.plugin.interface import BuildHookInterface
except ImportError:  # run as a program
    BuildHookInterface = None
else:

    class Extension(BuildHookInterface):
        """The build hook: a wheel with the extension is one for a platform, but for every version of Python 3."""

        def initialize(self, version, build_data):
            """Compile before the files are collected."""
            LIBRARY.unlink(missing_ok=True)
            if compiled():
                build_data["artifacts"].append(LIBRARY.relative_to(self.root).as_posix())
                if version != "editable":
                    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
                    build_data["pure_python"], build_data["tag"] = False, f"py3-none-{platform}"


if __name__ == "__main__":
    sys.exit(0 if compiled() else 1)
