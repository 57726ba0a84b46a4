"""The CasADi target: which functions are written, how large they are, and what its README says of them."""

import re

import casadi as ca
import numpy as np
import pytest
from helpers import ROOT, arm, equal_links, example, link, model_of

from screwgen.backends.casadi.functions import DEFAULT
from screwgen.cli.main import main
from screwgen.errors import TargetWarning, UsageError

LARGEST = 10e6


def written(files) -> set[str]:
    return {name.removesuffix(".casadi") for name in files if name.endswith(".casadi")}


def described(readme: str) -> set[str]:
    """The functions in the README's first table."""
    return set(re.findall(r"^\| `(\w+)` \| `", readme.partition("## Derivatives")[0], re.MULTILINE))


def test_functions_by_default_and_on_request():
    model = example("ella")
    every = {name for name in model.casadi() if not name.startswith("step_")}
    assert written(model.casadi_files()) == set(DEFAULT) < every
    assert written(model.casadi_files("all")) == every
    assert written(model.casadi_files(["bias", "step_rk4", "bias"])) == {"bias", "step_rk4"}
    assert written(model.casadi_files(["step_rk4", "all"])) == every | {"step_rk4"}
    assert written(model.casadi_files([])) == set()


@pytest.mark.parametrize("functions", [None, "all", ("ode",), ("mass_matrix", "z_form")])
def test_readme_describes_what_is_there(functions):
    """Each function is in the table or among those that can be asked for; paragraphs are about functions that exist."""
    model = example("ella")
    files = model.casadi_files(functions)
    readme = files["README.md"].decode()
    assert described(readme) == written(files)
    others = re.search(r"Also available.*?:\s((?:`\w+`(?:, )?)+)\.", readme, re.DOTALL)
    left_out = set(re.findall(r"`(\w+)`", others[1])) if others else set()
    assert left_out | written(files) == set(model.casadi()) and not left_out & written(files)
    assert ("right-hand sides for `casadi.integrator`" in readme) == bool({"ode", "dae"} & written(files))
    assert ("The Z-form of the paper" in readme) == ("z_form" in written(files))
    assert "\n\n\n" not in readme


def test_thirty_two_links_are_small(tmp_path):
    """All targets of a long chain; one line loads a function, whose value is that of the model's own."""
    model = model_of(equal_links(32))
    model.write(tmp_path / "out")
    assert sum(f.stat().st_size for f in (tmp_path / "out").rglob("*") if f.is_file()) < LARGEST
    q, v = np.full(model.nq, 0.01), np.full(model.nq, 0.02)
    loaded = ca.Function.load(str(tmp_path / "out" / "casadi" / "energy.casadi"))
    assert [float(x) for x in loaded(q, v, model.parameter_values)] == pytest.approx(
        model.numpy().energy(q, v), rel=1e-12
    )


def test_mass_matrix_is_symmetric_and_sparse():
    """Joints' entries and the modal inertia of links; modes of one link in different planes are not coupled."""
    model = example("ella")
    M = model.casadi()["mass_matrix"]
    assert M.sparsity_out(0).is_symmetric() and M.nnz_out(0) < model.nq**2
    value = M(np.full(model.nq, 0.01), model.parameter_values)
    assert float(ca.mmax(ca.fabs(value - value.T))) == 0.0


def test_a_floating_base_has_more_coordinates_than_rates():
    floating = model_of(arm(link("base", axes=[]), link("a", axes="y")) | {"base": "floating"})
    readme = floating.casadi_files("all")["README.md"].decode()
    rows = {row.split(" | ")[0]: row for row in readme.splitlines() if row.startswith(("| dq/dt", "| dv/dt"))}
    assert "of 64 |" in rows["| dq/dt"] and "of 56 |" in rows["| dq/dt"]  # 8 coordinates, 7 rates
    assert "of 49 |" in rows["| dv/dt"].replace("all 49 |", "of 49 |")


def test_of_all_functions_those_that_a_robot_lacks_are_said():
    """An elastic gear behind a transmission has no ``dae``; asked for by its name it is refused."""
    cylinder = {"crank": 0.3, "base": 0.7, "angle": 1.2}
    drive = {"transmission": cylinder, "ratio": 300.0, "rotor_inertia": 1e-3, "stiffness": 4e4}
    model = model_of(arm(link("a", axes="y", joint={"drives": [drive]})))
    with pytest.warns(TargetWarning, match="there is no CasADi function 'dae': robot 'arm' has an elastic gear"):
        files = model.casadi_files("all")
    assert "dae.casadi" not in files and {"assemble.casadi", "ode.casadi"} < files.keys()
    for named in ("dae", ["all", "dae"]):
        with pytest.raises(UsageError, match="elastic gear behind a transmission"):
            model.casadi_files(named)


def test_readme_says_which_casadi_loads_the_functions():
    readme = example("ella").casadi_files("energy")["README.md"].decode()
    assert f"of version {'.'.join(ca.__version__.split('.')[:2])}\nor later" in readme


def test_unknown_functions_are_refused(tmp_path):
    with pytest.raises(UsageError, match="there is no function 'mass_matirx'"):
        example("ella").write(tmp_path / "out", functions=["mass_matirx"])
    assert not list(tmp_path.iterdir())


def test_command_line(tmp_path, capsys):
    robot, out = str(ROOT / "examples" / "ella.toml"), str(tmp_path / "out")
    arguments = ["generate", robot, "-o", out, "--functions", "bias"]
    assert main([*arguments, "--target", "casadi", "--functions", "tip_pose"]) == 0
    assert written(p.name for p in (tmp_path / "out" / "casadi").iterdir()) == {"bias", "tip_pose"}
    capsys.readouterr()
    assert main([*arguments, "--target", "c"]) == 2
    assert "--functions adds to the CasADi files, which --target leaves out" in capsys.readouterr().err
    assert main(["generate", robot, "-o", out, "--functions", "mass"]) == 2
    assert "there is no function 'mass'" in capsys.readouterr().err
