"""Random robots of all features through every command; `python tests/every_command.py 0 300` runs more of them."""

import pytest
from every_command import DONE, REFUSED, alike, called, results, table

FEW = (6, 10, 26, 42, 45, 51)
"""A drive, a body from a file, a floating base, a loop, cylinders and stops, a linkage."""
QUICK = frozenset("generate c,generate latex,simulate joint,simulate dae,modes free,evaluate numpy dae".split(","))
SWEEP = [*(seed for seed in range(46) if seed not in FEW), 139, 211]
REASONS = (
    "has a floating base, ",
    "stays open by",
    "no posture found balances its load",
    "the search leaves what a model of small deflections can say",
    "the links find no steady deflection",
    "its mass matrix is no longer positive definite",
    "has opened by",
    "about which steps are not linearised; give states in which it rests",
)
"""What a robot may be refused for: what there is not of floating bases, loads that it does not bear, steps too long."""


def judge(found) -> None:
    """Every command does its work, or says for one of REASONS why not."""
    for command, (said, why) in found.items():
        assert said == DONE or (said == REFUSED and any(x in why for x in REASONS)), f"{command}: {said}, {why}"


@pytest.mark.parametrize("seed", FEW)
def test_a_random_robot_passes_the_commands(seed):
    judge(results(seed, QUICK)[1])


@pytest.mark.examples
@pytest.mark.parametrize("seed", SWEEP)
def test_sweep_of_random_robots_through_every_command(seed):
    """A quarter of them through all commands, the others through those that take seconds."""
    judge(results(seed, QUICK if seed % 4 else None)[1])


def test_what_a_command_says_is_told_from_what_it_raises(monkeypatch):
    """One line is a refusal, whatever is raised has died, and reasons that differ in numbers and names are alike."""
    assert called(["assemble", "examples/ella.toml"]).said == REFUSED
    monkeypatch.setattr("screwgen.cli.commands.run_evaluate", lambda *_: [][1])
    died = called(["evaluate", "examples/ella.toml"])
    assert died.said == "died" and died.why.startswith("IndexError in test_every_command.py")
    assert alike("link 'a' bends by 3.2e-5") == alike("link 'boom' bends by 17")
    assert "evaluate                             0             0             1" in table(
        [{"seed": 0, "results": {"evaluate": died}}]
    )
