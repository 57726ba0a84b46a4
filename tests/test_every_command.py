"""What came of a command: it did its work, was refused in a line, or died."""

from every_command import DIED, REFUSED, called


def test_what_a_command_says_is_told_from_what_it_raises(monkeypatch):
    """One line is a refusal, whatever is raised has died."""
    assert called(["assemble", "examples/ella.toml"]).said == REFUSED
    monkeypatch.setattr("screwgen.cli.commands.run_evaluate", lambda *_: [][1])
    died = called(["evaluate", "examples/ella.toml"])
    assert died.said == DIED and died.why.startswith("IndexError in test_every_command.py")
