"""The lowest versions that pyproject.toml allows: what a constraints file says of them, and a round of all commands.

python tests/minima.py --list       name==version of every dependency
python tests/minima.py              the round, in the environment that has them (`make minima`)
"""

import os
import re
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ROBOT = str(ROOT / "examples" / "ella_paper.toml")
COMMANDS = (
    "--help",
    "simulate --help",
    "paper --help",
    f"modes {ROBOT} --joints free --plot modes.png",
    f"equilibrium {ROBOT} --q 0.1,0.2,0.3 --hold --json",
    f"evaluate {ROBOT} --backend numpy",
    f"evaluate {ROBOT} --backend casadi",
    f"evaluate {ROBOT} --backend c",
    f"simulate {ROBOT} --duration 0.02 --step 1e-3 -o run.csv --plot run.png",
    f"simulate {ROBOT} --duration 0.005 --step 1e-3 -o run.npz --form dae",
    "view run.npz -o run.html --frames run.gif --size 64x64",
    f"identify {ROBOT} run.csv -o identified.toml --report report.html --free *.bodies*.mass",
    f"gains {ROBOT} -o gains.toml --at 0.1,0.2,0.3",
    f"plan {ROBOT} plan.toml -o plan.npz",
    f"analyse {ROBOT} --samples 1 --plot structure.png",
    f"generate {ROBOT} -o out --batch --derivatives --estimator",
    f"latex {ROBOT} -o equations.html",
    "paper -o paper.tex",
)
PLAN = "start = [0.0, 0.2, 0.3]\ngoal = [0.1, 0.3, 0.2]\ntime = 1.0\n"


def minima() -> list[str]:
    """The dependencies pinned to what pyproject.toml asks for at least; raises SystemExit where it asks for nothing."""
    stated = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["dependencies"]
    found = [re.fullmatch(r"([A-Za-z0-9_-]+)>=([0-9.]+)", text) for text in stated]
    if not all(found):
        raise SystemExit(f"minima: a dependency has no lowest version, `name>=version`: {stated}")
    return [f"{name}=={version}" for name, version in (m.groups() for m in found)]


def check_versions() -> None:
    """That the environment has the lowest versions, and no others."""
    from importlib.metadata import version

    for pinned in minima():
        name, lowest = pinned.split("==")
        if (have := version(name)) != lowest and not re.fullmatch(rf"{re.escape(lowest)}(\.0)*", have):
            raise SystemExit(f"minima: {name} is {have}, not {lowest}: run `make minima`")


def check_python() -> None:
    """What the package computes in Python, each back end and rollouts."""
    import numpy as np

    import screwgen

    model = screwgen.derive(screwgen.load(ROBOT))
    q, v, tau, w_ext = (np.full(n, 0.01) for n in (model.nq, model.nq, model.n_joints, (model.n_links, 6)))
    expected = model.numpy().forward_dynamics(q, v, tau, w_ext)[0]
    by_casadi = np.array(model.casadi()["forward_dynamics"](q, v, tau, w_ext.T, model.parameter_values)[0])[:, 0]
    for found in (by_casadi, model.compile().forward_dynamics(q, v, tau, w_ext)[0]):
        if not np.allclose(found, expected, rtol=1e-10, atol=0):
            raise SystemExit(f"minima: the back ends differ: {found} and {expected}")
    if not screwgen.rollout(model, np.zeros(2 * model.nq), step=1e-3, steps=3, threads=2).ok.all():
        raise SystemExit("minima: the rollout failed")
    model.linearise(q).scipy()
    model._repr_markdown_()


def check_bytes() -> None:
    """Equations have the bytes that the newest versions give: documents of the examples, scalars of textbook robots."""
    sys.path.insert(0, str(ROOT / "tests"))
    from textbook_robots import DIGESTS, digests

    import screwgen

    for name in ("ella", "six_link"):
        kept = (ROOT / "generated" / name / "MANIFEST.sha256").read_text(encoding="utf-8").splitlines()
        with tempfile.TemporaryDirectory() as folder:
            model = screwgen.derive(screwgen.load(ROOT / "examples" / f"{name}.toml"))
            model.write(folder, targets=["latex"])
            found = (Path(folder) / "MANIFEST.sha256").read_text(encoding="utf-8").splitlines()
        if found != [line for line in kept if "  latex/" in line]:
            raise SystemExit(f"minima: the documents of {name} have other bytes than those of the newest versions")
    if digests() != DIGESTS.read_text(encoding="utf-8"):
        raise SystemExit("minima: equations in scalars are other ones than with the newest versions")


def check_commands() -> None:
    """All commands, in a folder of their own."""
    from screwgen.cli.main import main

    here = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("plan.toml").write_text(PLAN, encoding="utf-8")
        try:
            for command in COMMANDS:
                print(f"screwgen {command}".replace(str(ROOT), "."), file=sys.stderr, flush=True)
                if status := main(command.split()):
                    raise SystemExit(f"minima: `screwgen {command}` ends with status {status}")
        finally:
            os.chdir(here)


if __name__ == "__main__":
    if "--list" in sys.argv:
        print("\n".join(minima()))
    else:
        check_versions()
        check_python()
        check_bytes()
        check_commands()
