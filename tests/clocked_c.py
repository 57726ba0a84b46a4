"""C of laws that a clock samples, compiled and loaded, for tests."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Mapping
from pathlib import Path

from conftest import require_tool

STRICT = "-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror -O2".split()


class ClockedLaw:
    """The functions `boom_<kind>_start` and `boom_<kind>_sample`; members of state and input by their sizes."""

    def __init__(
        self,
        files: Mapping[str, str],
        folder: Path,
        kind: str,
        state: Mapping[str, int],
        given: Mapping[str, int],
        compiler: str = "gcc",
        precision: str = "double",
    ):
        real = ctypes.c_float if precision == "float" else ctypes.c_double
        for name, text in files.items():
            (folder / name).write_text(text)
        defines = ["-DBOOM_REAL_FLOAT"] if precision == "float" else []
        done = subprocess.run(
            [require_tool(compiler), *STRICT, *defines, "-shared", "-fPIC", "-o", "law.so", f"boom_{kind}.c"],
            cwd=folder,
            capture_output=True,
            text=True,
        )
        assert (done.returncode, done.stderr) == (0, "")
        self.library, self.kind = ctypes.CDLL(str(folder / "law.so")), kind
        own = [(name, real * count) for name, count in state.items()]
        own += [("latest", ctypes.c_double), ("mark", ctypes.c_int)]
        self.state = type("State", (ctypes.Structure,), {"_fields_": own})()
        fields = [(name, real * count) for name, count in given.items()]
        self.input = type("Input", (ctypes.Structure,), {"_fields_": fields})()
        self.effort = (real * given["measured"])()
        self._sample = getattr(self.library, f"boom_{kind}_sample{'_float' * bool(defines)}")

    def put(self, *given):
        """The input's members in their order, numbers or as many as they hold."""
        for (name, _), x in zip(self.input._fields_, given, strict=True):
            member = getattr(self.input, name)
            for k in range(len(member)):
                member[k] = x if isinstance(x, float | int) else x[k]

    def sample_put(self, time):
        """The status of a sample of what was put."""
        return self._sample(ctypes.byref(self.state), ctypes.c_double(time), ctypes.byref(self.input), self.effort)

    def memory(self):
        """What a refused call may not change."""
        return bytes(self.state), bytes(self.effort)

    def of_nothing(self):
        """The status of a sample without state, input and place for efforts."""
        return self._sample(None, ctypes.c_double(0.0), None, None)
