"""Four-bar linkages that drive joints, against closed forms and the true loop; where their reach ends."""

import mpmath
import numpy as np
import pytest
from conftest import swept
from four_bar_robots import LINKAGE, START, alone, boom, digger, looped
from helpers import arm, link, model_of, quick
from oracle_drives import crank_angle
from transmitted import GAINS, gains_through_levers, held_posture, postures_under, power

from screwgen import PD, FourBar, Holding, LimitWarning, SingularError, equilibrium, natural_frequencies, simulate
from screwgen.backends.numpy.travel_numbers import travels
from screwgen.plotting import plot

# -------- one linkage on a bending boom

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
    power(model, START[:2], lambda t, q, v: (900.0, 25 + 10 * np.sin(9 * t)))


def test_an_equilibrium_states_the_torque_at_the_crank_and_finds_postures_under_it():
    assert abs(held_posture(boom(), START[:2])[1]) > 5
    postures_under(model_of(alone(1.3, "open")), 0.3, [0.33])


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
    law = PD(*GAINS, START[:2] + 0.2, gravity=Holding(model), tau_max=(9e3, 40.0), duration=0.3)
    gains_through_levers(model, START)
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
            with pytest.raises(SingularError, match=f"link 'bucket' is singular.*{BEYOND}|^a linkage does not reach"):
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
