"""Writes generated/: the committed output of the example robots. Usage: regenerate.py [FOLDER].

C, LaTeX and READMEs are kept in full. Of CasADi's functions, without those of sensors, and of the HTML, which is large,
digests are kept: in each robot's MANIFEST.sha256, and with sizes, signatures and values in left_out.json.
"""

import hashlib
import json
import sys
from importlib.metadata import version
from pathlib import Path

import casadi as ca
import numpy as np

import screwgen
from screwgen.backends.casadi.functions import chosen, signature
from screwgen.simulation.measured import is_measured

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES = ("ella", "six_link")
LEFT_OUT = (".casadi", ".html")


def main(folder: Path) -> None:
    left_out = {}
    for name in EXAMPLES:
        model = screwgen.derive(screwgen.load(ROOT / "examples" / f"{name}.toml"))
        files = model.write(folder / name, functions=[x for x in chosen("all", model.casadi()) if not is_measured(x)])
        for path in (Path(name) / file for file in files):
            if path.suffix in LEFT_OUT:
                left_out[path.as_posix()] = described(folder / path, model.parameter_values)
                (folder / path).unlink()
        print(f"{folder / name}: {len(files)} files")
    versions = {"casadi": version("casadi")}  # on which the bytes of its functions depend
    text = json.dumps({"versions": versions, "files": left_out}, indent=1)
    (folder / "left_out.json").write_text(text + "\n")


def described(path: Path, parameters: list[float]) -> dict:
    """Digest and size of a file; of a function also its signature, and the norms of its outputs at one place."""
    data = path.read_bytes()
    out = {"sha256": hashlib.sha256(data).hexdigest(), "bytes": len(data)}
    if path.suffix == ".casadi":
        f = ca.Function.load(str(path))
        out |= {"inputs": signature(f, "in"), "outputs": signature(f, "out"), "norms": norms(f, parameters)}
    return out


def norms(f: ca.Function, parameters: list[float]) -> list[float]:
    """The Euclidean norm of every output, where the entries of the inputs but the parameters are small numbers."""
    sizes = {name: f.size_in(name) for name in f.name_in()}
    small = {name: 0.01 * np.cos(np.arange(np.prod(size))).reshape(size, order="F") for name, size in sizes.items()}
    values = f.call([parameters if name == "p" else small[name] for name in f.name_in()])
    return [float(f"{np.linalg.norm(np.array(value)):.9e}") for value in values]


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "generated")
