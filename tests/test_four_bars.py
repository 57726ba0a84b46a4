"""Four-bar linkages that drive joints, against closed forms, the oracle and the true loop; what users see of them."""

from functools import cache

import casadi as ca
import mpmath
import numpy as np
import pytest
import random_robots as rr
from bad_robot_files import GOOD, refusal, refused
from conftest import swept
from helpers import QUICK, Case, arm, drawn, link, model_of, quick, quick_batch, relative
from judges import compiled, derivatives, numpy_and_casadi, solved_densely
from oracle_drives import crank_angle

from screwgen import (
    PD,
    FourBar,
    Holding,
    LimitWarning,
    RobotFileError,
    SingularError,
    dump,
    equilibrium,
    load,
    natural_frequencies,
    rollout,
    simulate,
)
from screwgen.algorithms.transmissions import travels
from screwgen.backends.c.project import CProject
from screwgen.backends.latex import document as latex
from screwgen.plotting import plot
from screwgen.plugins import plugins
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.spec.four_bar import NUMBERS
from screwgen.spec.parameters import coordinate_units, force_units, parameters

SEEDS = (8300, *range(8302, 8308), 8309, *range(8311, 8316))
"""Of these robots each has a linkage."""


@cache
def drawn_with_linkages(seed: int) -> Case:
    more = {"second_order": 0.2} if seed % 3 == 1 else {}
    return drawn(seed, 1 + seed % 3, drives=0.5, cylinders=0.8, linkages=0.7, sliding=0.2, branching=0.3, **more)


@pytest.fixture(params=swept(SEEDS, 8304, 8305))
def case(request) -> Case:
    return drawn_with_linkages(request.param)


def test_both_forms_in_numpy_and_casadi_equal_the_oracle(case):
    assert case.model.chain.linked
    numpy_and_casadi(case)
    solved_densely(case)


def test_derivatives_equal_automatic_ones(case):
    derivatives(case)


@pytest.mark.parametrize("layout", ["fused", "modular"])
@pytest.mark.parametrize("seed", swept(SEEDS, 8305))
def test_the_c_equals_the_oracle_in_both_forms(seed, layout):
    compiled(drawn_with_linkages(seed), layout)


def test_linkages_take_the_place_of_cylinders_and_other_draws_stay():
    limits, found = {"drives": 0.5, "cylinders": 0.8}, 0
    for seed in range(5):
        with_linkages, without = (
            rr.random_robot(np.random.default_rng(seed), 3, **limits, linkages=share) for share in (0.7, 0.0)
        )
        for part, other in zip(with_linkages["links"], without["links"], strict=True):
            for one, two in zip(part["joint"].get("drives", []), other["joint"].get("drives", []), strict=True):
                found += "four_bar" in one.get("transmission", {})
                assert bool(one.pop("transmission", None)) == bool(two.pop("transmission", None))
        assert with_linkages == without
    assert found > 4


# -------- one linkage on a bending boom

LINKAGE = {"ground": 0.4, "crank": 0.22, "coupler": 0.47, "rocker": 0.25, "angle": 1.3, "branch": "open"}
FRICTION = {"coulomb": 4.0, "viscous": 3.0, "velocity": 0.1}


def digger(linkage=LINKAGE, friction=FRICTION, modes=None, gravity=(0.3, 0.0, -9.81), **joint) -> dict:
    """A boom on a cylinder, and a bucket on a linkage, both about y."""
    own = {"transmission": {"crank": 0.4, "base": 1.2, "angle": -1.5}, "ratio": 30.0, "rotor_inertia": 0.02}
    other = {"transmission": {"four_bar": linkage}, "ratio": 50.0, "rotor_inertia": 1e-3}
    other |= {"friction": friction} if friction else {}
    boom = link("boom", 2.0, "y", 5.0, modes, joint={"drives": [own]}, section={"EIy": 3e4})
    bucket = link("bucket", 0.8, "y", 3.0, joint={"drives": [other], **joint}, bodies=[{"at": "tip", "mass": 4.0}])
    return arm(boom, bucket, gravity=gravity)


@cache
def boom():
    return model_of(digger(modes={"bending_z": 1}))


START = np.array([0.2, 0.4, 0.0])
GEOMETRIES = [
    LINKAGE,
    LINKAGE | {"angle": -1.3, "branch": "crossed"},
    LINKAGE | {"crank": 0.5, "coupler": 0.3, "angle": 1.9, "branch": "crossed"},
    LINKAGE | {"ground": 0.2, "rocker": 0.5, "crank": 0.45, "coupler": 0.4, "angle": 2.0},
    LINKAGE | {"ground": 0.2, "rocker": 0.5, "crank": 0.6, "coupler": 0.5, "angle": -2.0},
    LINKAGE | {"ground": 0.25, "crank": 0.3, "coupler": 0.3, "angle": 7.0},
    LINKAGE | {"crank": 0.25, "coupler": 0.4, "angle": 0.8},
]
"""Link or crank that go round or rock, a kite and a parallelogram."""


@pytest.mark.parametrize("linkage", GEOMETRIES)
def test_the_cranks_angle_and_its_derivatives_equal_the_cosine_rule(linkage):
    """In 40 digits, over the reach up to 1e-3 of its ends; the angle has no leaps, and the coupler keeps its length."""
    model = model_of(digger(linkage))
    least, most = (np.clip(x, -4, 4) for x in FourBar(**linkage).reach)
    assert least < -0.3 and most > 0.3
    exactly = {name: x if name == "branch" else mpmath.mpf(x) for name, x in linkage.items()}
    angle, found = lambda q: crank_angle(exactly, q, mpmath), []
    for q in map(float, np.linspace(least + 1e-3, most - 1e-3, 41)):
        found.append(travels(model.chain, [0.2, q], model.parameter_values)[:, 1])
        with mpmath.workdps(40):
            expected = [float(mpmath.diff(angle, mpmath.mpf(q), k)) for k in (1, 2)]
            direction = complex(mpmath.expj(angle(mpmath.mpf(q))))
        crank = np.exp(1j * found[-1][0])
        assert abs(crank - direction) < 1e-12
        assert np.all(np.abs(found[-1][1:] - expected) < 1e-12 * np.maximum(1, np.abs(expected)))
        rod = linkage["ground"] + linkage["crank"] * crank - linkage["rocker"] * np.exp(1j * (q + linkage["angle"]))
        assert abs(rod) == pytest.approx(linkage["coupler"], rel=1e-13)
    assert np.abs(np.diff([x[0] for x in found])).max() < 1.0


def test_reaches_are_those_at_which_crank_and_coupler_are_in_line():
    for linkage in GEOMETRIES:
        for end in FourBar(**linkage).reach:
            if np.isfinite(end):
                apart = abs(linkage["rocker"] * np.exp(1j * (end + linkage["angle"])) - linkage["ground"])
                c, k = linkage["crank"], linkage["coupler"]
                assert min(abs(apart - c - k), abs(apart - abs(c - k))) < 1e-8
    free = FourBar(**(LINKAGE | {"crank": 0.5, "coupler": 0.45}))
    assert free.reach == (-np.inf, np.inf)
    assert FourBar(**LINKAGE).left is False and FourBar(**(LINKAGE | {"branch": "crossed"})).left


# -------- the true loop


def looped(angle: float, branch: str) -> dict:
    """The linkage of `alone` as what it is: crank and coupler are links with mass, and a loop."""
    own = alone(angle, branch)
    drive = dict(own["links"][0]["joint"]["drives"][0])
    g = drive.pop("transmission")["four_bar"]["ground"]
    pivot = {"xyz": [float(g * np.cos(angle)), 0.0, float(g * np.sin(angle))]}
    body = own["links"][0] | {"joint": {"axes": ["y"]}}
    crank = link("crank", LINKAGE["crank"], "y", 5.0, joint={"mount": pivot, "drives": [drive]}, parent="world")
    coupler = link("coupler", LINKAGE["coupler"], "y", 3.0)
    return own | {
        "links": [body, crank, coupler],
        "loops": [{"between": ["arm.tip", "coupler.tip"], "joint": {"axes": ["x", "y", "z"]}}],
    }


def alone(angle: float, branch: str) -> dict:
    """A heavy link, whose pin is at its tip, driven through a linkage with rotor and friction."""
    linkage = LINKAGE | {"angle": angle, "branch": branch}
    drive = {"transmission": {"four_bar": linkage}, "ratio": 20.0, "rotor_inertia": 2e-3, "friction": FRICTION}
    mass = {"at": "tip", "mass": 6.0, "com": [0.3, 0.02, 0.1], "inertia": [0.2, 0.3, 0.4, 0.0, 0.0, 0.0]}
    return arm(
        link("arm", LINKAGE["rocker"], "y", 8.0, joint={"drives": [drive]}, bodies=[mass]), gravity=(2.0, 0.0, -9.0)
    )


ASSEMBLIES = [(1.3, "open"), (1.3, "crossed"), (-1.3, "open"), (-1.3, "crossed")]


@pytest.mark.parametrize("assembly", swept(ASSEMBLIES, (1.3, "open"), (-1.3, "crossed")))
def test_a_linkage_equals_its_true_loop_where_crank_and_coupler_have_no_mass(assembly):
    """The difference falls in proportion to the masses; what is left is extrapolated to none."""
    angle, branch = assembly
    model, q, v, tau = model_of(alone(angle, branch)), np.array([0.25]), np.array([0.7]), np.array([6.0])
    expected = model.numpy().forward_dynamics(q, v, tau, None)[0]
    psi, slope, _ = travels(model.chain, q, model.parameter_values)[:, 0]
    pin = LINKAGE["rocker"] * np.exp(1j * (q[0] + angle))
    rod = pin - LINKAGE["ground"] - LINKAGE["crank"] * np.exp(1j * psi)
    rate = (1j * pin * v[0] - 1j * LINKAGE["crank"] * np.exp(1j * psi) * slope * v[0]) / rod
    angles = np.array([q[0], psi - angle, np.angle(rod) - psi])
    rates = np.array([v[0], slope * v[0], rate.imag - slope * v[0]])
    assert abs(rate.real) < 1e-12

    loop = model_of(looped(angle, branch))
    assert np.abs(loop.numpy().gaps(angles, rates)).max() < 1e-12
    masses = [loop.parameter_names.index(f"{name}.rhoA") for name in ("crank", "coupler")]

    def found(share: float) -> float:
        p = np.array(loop.parameter_values)
        p[masses] *= share
        return loop.numpy(p).forward_dynamics(angles, rates, [0.0, tau[0], 0.0], None)[0][0] / expected[0] - 1

    shares = [1e-2, 1e-3, 1e-4]
    errors = [found(share) for share in shares]
    assert errors[1] / errors[2] == pytest.approx(10, rel=1e-2) and abs(errors[2]) < 1e-4
    assert abs(np.linalg.solve(np.vander(shares, increasing=True), errors)[0]) < 1e-9


# -------- runs, equilibria, linear models


@pytest.mark.long
def test_the_power_of_a_crank_is_its_torque_times_its_rate():
    model = model_of(digger(friction=None))
    run = simulate(model, 0.4, 1e-4, q0=START[:2], controller=lambda t, q, v: (900.0, 25 + 10 * np.sin(9 * t)))
    turns = np.array([travels(model.chain, q, model.parameter_values)[0] for q in run.q])
    work = np.sum((run.tau[1:] + run.tau[:-1]) / 2 * np.diff(turns, axis=0))
    gained = run.energy.sum(axis=1)[-1] - run.energy.sum(axis=1)[0]
    assert abs(work) > 20 and work == pytest.approx(gained, rel=2e-4)


@pytest.mark.parametrize("integrator", swept(["rk4", "modal_midpoint"], "rk4"))
def test_forms_back_ends_and_batches_make_the_same_motion(integrator):
    model, tau = boom(), np.array([900.0, 15.0])
    given = dict(q0=START, integrator=integrator, controller=tau)
    joint, numpy = (simulate(model, 0.02, 1e-3, backend=x, **given) for x in ("c", "numpy"))
    assert np.allclose(joint.q, numpy.q, rtol=0, atol=1e-12)
    dae = simulate(model, 0.02, 1e-3, form="dae", **given)
    assert np.allclose(dae.q[-1], joint.q[-1], rtol=0, atol=1e-7)
    if integrator == "rk4":
        quick_batch(model)
        states, push = np.tile(np.r_[START, 0 * START], (2, 1)), np.tile(tau, (2, 20, 1))
        batch = rollout(model, states, push, step=1e-3, integrator=integrator)
        assert np.allclose(batch.q[1], joint.q, rtol=0, atol=1e-11)


def test_an_equilibrium_states_the_torque_at_the_crank_and_finds_postures_under_it():
    model = boom()
    held = equilibrium(model, START[:2], hold=True)
    assert relative(model.numpy().forward_dynamics(held.q, 0 * held.q, held.tau, None)[0], 0 * held.q) < 1e-9
    torques = model.numpy().inverse_dynamics(held.q, None, None, None)[:2]
    assert np.allclose(held.tau * model.numpy().levers(held.q), torques) and abs(held.tau[1]) > 5
    linkage = alone(1.3, "open")
    model = model_of(linkage)
    force = equilibrium(model, [0.3], hold=True).tau
    free = equilibrium(model, [0.33], tau=force)
    assert abs(model.numpy().forward_dynamics(free.q, [0], force, None)[0][0]) < 1e-8


def test_free_joints_vibrate_on_the_torque_that_holds_them():
    """A torque at the crank that stays the same while ψ' grows or falls is a spring of the joint."""
    model = model_of(alone(1.3, "open") | {"gravity": [9.0, 0.0, -3.0]})
    held = equilibrium(model, [0.5], hold=True)
    slope = (
        np.diff([model.numpy().forward_dynamics([0.5 + d], [0], held.tau, None)[0][0] for d in (-1e-5, 1e-5)])[0] / 2e-5
    )
    found = natural_frequencies(model, [0.5], joints="free", loaded=True)
    assert found[0] ** 2 == pytest.approx(max(-slope, 0) / (2 * np.pi) ** 2, rel=1e-6, abs=1e-9)


def test_a_law_gives_the_crank_the_torque_of_its_gains():
    model = boom()
    law = PD((4e3, 1e3), (4e2, 90.0), START[:2] + 0.2, gravity=Holding(model), tau_max=(9e3, 40.0), duration=0.3)
    q = START + np.array([0.02, -0.01, 0.0])
    free = PD((4e3, 1e3), (4e2, 90.0), START[:2]).through(model.chain, model.parameter_values)
    expected = np.array([-4e3 * 0.02, 1e3 * 0.01]) / model.numpy().levers(q)
    assert np.allclose(free(0.0, q, 0 * q), expected)
    run = simulate(model, 0.6, 2e-3, q0=START, controller=law)
    assert np.abs(run.tau[:, 1]).max() == 40.0 and np.isfinite(run.q).all()
    titles = [axes.get_title(loc="left") for axes in plot.figure(run, model, law).axes]
    assert {"Forces of drives", "Torques"} <= set(titles)


# -------- where a linkage ends


BEYOND = "out of the reach of its four-bar linkage"


def test_postures_out_of_reach_are_errors_of_every_back_end():
    model, still = boom(), np.zeros(3)
    least, most = model.chain.reach[1]
    library = {layout: quick(model, layout=layout, derivatives=True) for layout in ("fused", "modular")}
    numeric, w, p = model.numpy(), np.zeros((2, 6)), model.parameter_values
    asked = [
        lambda q: numeric.forward_dynamics(q, still, None, None),
        lambda q: numeric.dae_forward_dynamics(q, still, None, None),
        lambda q: numeric.levers(q),
        lambda q: numeric.derivatives(q, still, None, None),
        lambda q: travels(model.chain, q[:2], p),
        lambda q: simulate(model, 0.01, 1e-3, q0=q),
        *(lambda q, x=x: x.forward_dynamics(q, still, [1.0, 1.0], w) for x in library.values()),
        *(lambda q, x=x: x.forward_dynamics(q, still, [1.0, 1.0], w, form="dae") for x in library.values()),
        lambda q: library["fused"].linearise(q, still, [1.0, 1.0], w),
        lambda q: library["modular"].inverse_dynamics(q, still, still, w),
    ]
    for q in ([0.2, most + 1e-3, 0.0], [0.2, least - 0.2, 0.0], [0.2, most, 0.0]):
        for ask in asked:
            with pytest.raises(SingularError, match=f"the joint of link 'bucket' is singular.*{BEYOND}"):
                ask(q)


def test_runs_that_leave_the_reach_end_and_those_that_fold_flat_warn():
    model = boom()
    with pytest.raises(SingularError, match=BEYOND):
        simulate(model, 1.2, 1e-3, q0=START, controller=(900.0, -200.0), integrator="modal_midpoint")
    flat = model_of(digger(LINKAGE | {"crank": 0.25, "coupler": 0.4, "angle": 2.8}, None, gravity=(0.0, 0.0, 0.0)))
    with pytest.warns(LimitWarning, match=r"bucket\.joint\[0\] past its upper limit"):
        simulate(flat, 0.6, 1e-3, q0=[0.0, 0.0], v0=[0.0, 1.0])


def test_a_dead_centre_of_the_crank_needs_an_infinite_torque_and_says_so():
    """Rocker and coupler in line: the crank stands, and the link goes on."""
    linkage = LINKAGE | {"ground": 0.5, "crank": 0.2, "coupler": 0.3, "rocker": 0.25, "angle": 0.6}
    model = model_of(arm(link("arm", 1.0, "y", 4.0, joint={"drives": [{"transmission": {"four_bar": linkage}}]})))
    slopes = lambda q: travels(model.chain, [q], model.parameter_values)[1, 0]  # noqa: E731
    inside = np.linspace(*(0.98 * np.array(model.chain.reach[0])), 400)
    sign = np.sign([slopes(q) for q in inside])
    k = int(np.flatnonzero(np.diff(sign))[0])
    low, high = inside[k], inside[k + 1]
    for _ in range(80):
        low, high = (low, (low + high) / 2) if slopes((low + high) / 2) * slopes(low) <= 0 else ((low + high) / 2, high)
    with pytest.raises(
        SingularError, match=r"^arm\.joint\[0\]: its four-bar linkage is in a dead centre, where no torque"
    ):
        equilibrium(model, [low], hold=True)
    assert np.isfinite(model.numpy().forward_dynamics([low], [0.3], [1e2], None)[0]).all()


# -------- what users see

FINE = 'four_bar = { ground = 0.4, crank = 0.22, coupler = 0.47, rocker = 0.25, angle = 1.3, branch = "open" }'
UPPER = "links[0].joint.drives"
KEY = f"{UPPER}[0].transmission"


def changed(**keys: str) -> str:
    """The table of `FINE` with other words for some keys; none: the key is left out."""
    given = {"ground": "0.4", "crank": "0.22", "coupler": "0.47", "rocker": "0.25", "angle": "1.3", "branch": '"open"'}
    text = ", ".join(f"{k} = {x}" for k, x in (given | keys).items() if x)
    return f"transmission = {{ four_bar = {{ {text} }} }}"


WRONG = [
    (changed(ground=""), f"{KEY}.four_bar.ground", "is missing"),
    (changed(branch=""), f"{KEY}.four_bar.branch", "is missing"),
    (changed(coupler="0.0"), f"{KEY}.four_bar.coupler", "is 0.0; it must be > 0"),
    (changed(rocker="1e9"), f"{KEY}.four_bar.rocker", "it must be from 1e-06 to 1e+06 m"),
    (changed(crank='"long"'), f"{KEY}.four_bar.crank", 'is "long"'),
    (changed(angle="inf"), f"{KEY}.four_bar.angle", "is inf"),
    (changed(branch='"left"'), f"{KEY}.four_bar.branch", 'it must be "open" or "crossed"'),
    (changed(branch="true"), f"{KEY}.four_bar.branch", 'is true; it must be "open" or "crossed"'),
    (changed(angel="1.0"), f"{KEY}.four_bar.angel", "did you mean angle?"),
    (changed(angle="0.0"), f"{KEY}.four_bar.angle", "the rocker lies along the ground line"),
    (changed(coupler="0.05"), f"{KEY}.four_bar", "cannot be assembled at q = 0: coupler and crank join points 0.17 m"),
    ("transmission = { four_bar = 0.4 }", f"{KEY}.four_bar", "must be a table of ground, crank, coupler, rocker"),
    (f"transmission = {{ base = 0.4, {FINE} }}", f"{KEY}.base", "is stated beside four_bar"),
    (f"transmission = {{ {FINE} }}, ratio = 3.0", f"{UPPER}[0].ratio", "is stated without rotor_inertia"),
    (
        f"transmission = {{ {FINE} }}, rotor_inertia = 1.0, stiffness = 1e6",
        f"{UPPER}[0].stiffness",
        "is stated beside transmission, whose gear is rigid; leave it out, or model the linkage by links and a loop",
    ),
]


@pytest.mark.parametrize(("table", "where", "fragment"), WRONG)
def test_wrong_linkages_are_refused_in_one_line(tmp_path, table, where, fragment):
    refused(tmp_path, GOOD.replace("armature = [0.1, 0.2]", f"drives = [ {{ {table} }}, {{}} ]"), where, fragment)


@pytest.mark.parametrize(("limits", "name"), [("lower = -1.0, upper = 0.5", "lower"), ("upper = 4.5", "upper")])
def test_limits_that_a_linkage_does_not_reach_are_refused(tmp_path, limits, name):
    text = f"drives = [ {{ transmission = {{ {FINE} }} }}, {{}} ]\nlimits = [ {{ {limits} }}, {{}} ]"
    where, fragment = (
        f"links[0].joint.limits[0].{name}",
        "which the linkage of drives[0] does not reach; it must be between",
    )
    refused(tmp_path, GOOD.replace("armature = [0.1, 0.2]", text), where, fragment)


@pytest.mark.parametrize("axis", ['{ slide = "y" }', '{ screw = "y", pitch = 0.1 }'])
def test_linkages_of_axes_that_slide_are_refused(tmp_path, axis):
    path = tmp_path / "bot.toml"
    drive = f"drives = {{ transmission = {{ {FINE} }} }} }}"
    path.write_text(GOOD.replace('axes = ["z"] }', f"axes = [{axis}], {drive}"), "utf-8")
    assert "and a linkage turns a link; leave it out" in refusal(path)


def test_parts_made_in_python_are_refused_alike():
    with pytest.raises(RobotFileError, match=r"^FourBar: cannot be assembled at q = 0"):
        FourBar(**(LINKAGE | {"coupler": 2.0}))


def test_names_units_parameters_and_round_trips(tmp_path):
    model = boom()
    assert model.tau_names == ["boom.force[0]", "bucket.torque[0]"] and force_units(model.robot) == ["N", "N·m"]
    assert coordinate_units(model.robot)[:2] == ["rad", "rad"]
    of, drive = {x.name: x for x in parameters(model.robot)}, "bucket.joint.drives[0]"
    assert [of[f"{drive}.transmission.four_bar.{x}"].unit for x in NUMBERS] == ["m", "m", "m", "m", "rad"]
    assert of[f"{drive}.ratio"].unit == "1" and of[f"{drive}.friction.viscous"].unit == "N·m·s/rad"
    moved = {f"{drive}.transmission.four_bar.angle": 1.1, f"{drive}.transmission.four_bar.crank": 0.3}
    other = model_of(digger(LINKAGE | {"angle": 1.1, "crank": 0.3}, modes={"bending_z": 1}))
    given = START, START, [500.0, 20.0], None
    assert np.allclose(model.numpy(moved).forward_dynamics(*given)[0], other.numpy().forward_dynamics(*given)[0])
    (tmp_path / "again.toml").write_text(dump(model.robot), "utf-8")
    assert load(tmp_path / "again.toml") == model.robot
    linear = model.linearise(START)
    assert linear.input_names[:2] == ("boom.force[0]", "bucket.torque[0]") and linear.input_units[:2] == ("N", "N·m")


def test_acados_has_torques_of_cranks():
    export, model = boom().acados(), boom()
    f = ca.Function("f", [export.x, export.xdot, export.u, export.p], [export.f_impl_expr, export.f_expl_expr])
    x, u = np.linspace(-0.1, 0.1, 2 * model.nq), [800.0, 20.0]
    rates = f(x, 0 * x, u, model.parameter_values)[1]
    assert export.u_labels == ("boom.force[0]", "bucket.torque[0]")
    assert np.abs(f(x, rates, u, model.parameter_values)[0].full()).max() < 1e-9


@pytest.mark.long
def test_the_estimator_finds_a_posture_under_torques_of_cranks():
    model, push = boom(), np.array([900.0, 12.0])
    truth = simulate(model, 0.3, 1e-3, q0=START, controller=push)
    estimator = CompiledEstimator(model, flags=QUICK)
    noise = Noise(np.r_[1.0, 1.0, 0.1], 1e-12, encoder=1e-4, strain=2e-6, fibre=0.03)
    estimator.start(START + 0.02, np.zeros(3), np.full(3, 0.05), np.full(3, 0.05), noise)
    for q in truth.q[1:]:
        estimator.predict(push, np.zeros((2, 6)), 1e-3)
        estimator.update(push, np.zeros((2, 6)), encoder=q[:2])
    assert np.allclose(estimator.state[0], truth.q[-1], atol=2e-4)


def test_documents_and_headers_say_what_a_torque_does():
    text = latex.tex(latex.content(boom().robot, plugins()))
    assert r"J_r\,N^2\,\psi'\,\psi''\,\dot{q}^2" in text and "torque at the crank" in text
    header = CProject(boom().chain, "1").files()["arm.h"]
    assert "; at the crank where a linkage" in header and "arm_status arm_levers(" in header
