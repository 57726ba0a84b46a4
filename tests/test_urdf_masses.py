"""URDFs that leave inertials out: masses from a side file, from shapes at a density, or of a total mass."""

import numpy as np
import pinocchio as pin
import pytest
import trimesh
from urdf_texts import BODY, joint, robot

from screwgen.cli.main import main
from screwgen.errors import RobotFileError, UsageError
from screwgen.interchange.load import import_urdf
from screwgen.interchange.tree import Options
from screwgen.model import derive

BARE = robot(joint("shoulder", "base", "upper"), joint("elbow", "upper", "fore", xyz="0 0.3 0.4")).replace(BODY, "")
AT, TURN = (0.1, -0.2, 0.3), (0.4, -0.3, 0.9)
SHAPES = {
    '<box size="0.25 0.125 0.5"/>': pin.Inertia.FromBox(1000 / 64, 0.25, 0.125, 0.5),
    '<cylinder radius="0.1" length="0.3"/>': pin.Inertia.FromCylinder(1000 * np.pi * 0.003, 0.1, 0.3),
    '<sphere radius="0.2"/>': pin.Inertia.FromSphere(1000 * 4 / 3 * np.pi * 0.008, 0.2),
    '<mesh filename="box.stl" scale="1 1 2"/>': pin.Inertia.FromBox(1000 / 64, 0.25, 0.125, 0.5),
}


def shape(inside: str, kind: str = "collision", xyz=AT, rpy=TURN) -> str:
    origin = f'<origin xyz="{" ".join(map(str, xyz))}" rpy="{" ".join(map(str, rpy))}"/>'
    return f"<{kind}>{origin}<geometry>{inside}</geometry></{kind}>"


def dressed(**links: str) -> str:
    """An arm without inertials whose links have these elements."""
    text = BARE
    for link, inside in links.items():
        text = text.replace(f'<link name="{link}">', f'<link name="{link}">{inside}')
    return text


@pytest.fixture
def bot(tmp_path):
    """Reads a URDF of a text, beside which a box of triangles lies."""
    trimesh.creation.box((0.25, 0.125, 0.25)).export(tmp_path / "box.stl")

    def read(text: str, side: str = "", **options):
        (tmp_path / "bot.urdf").write_text(text)
        (tmp_path / "side.toml").write_text(side)
        return import_urdf(tmp_path / "bot.urdf", tmp_path / "side.toml" if side else None, Options(**options))

    return read


@pytest.mark.parametrize("inside", SHAPES)
def test_a_shape_weighs_what_pinocchios_does(bot, inside):
    (body,) = bot(dressed(upper=shape(inside), fore=BODY), density=1000.0).robot.links[0].bodies
    expected = pin.SE3(pin.rpy.rpyToMatrix(*TURN), np.array(AT)).act(SHAPES[inside])
    J = expected.inertia
    assert body.mass == pytest.approx(expected.mass, rel=1e-9)
    assert body.com == pytest.approx(AT, abs=1e-9)
    entries = [J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]]
    assert body.inertia == pytest.approx(entries, rel=1e-6, abs=1e-9)


def test_collisions_go_before_visuals_and_a_total_is_that_of_all_links(bot):
    """A cube of 1 and one of 8 litres share what is left of 20 kg behind the 2 kg that a link states."""
    small, large = (shape(f'<box size="{a} {a} {a}"/>') for a in (0.1, 0.2))
    text = dressed(base=BODY, upper=small + shape('<sphere radius="3"/>', "visual"), fore=large)
    found = bot(text, total_mass=20.0)
    assert [link.bodies[0].mass for link in found.robot.links] == pytest.approx([2.0, 16.0])
    assert "masses from shapes of 2000 kg/m³, kg: upper 2, fore 16" in found.notes
    with pytest.raises(UsageError, match=r"total-mass: is 2; the links that state an inertial weigh 2 kg alone"):
        bot(text, total_mass=2.0)


BODIES = """
[[links]]
name = "{}"
bodies = [{{ at = "base", mass = 2.0, com = [0.1, 0.0, 0.0], inertia = [0.1, 0.1, 0.1, 0.0, 0.0, 0.0] }}]
"""


def test_bodies_of_a_side_file_are_as_good_as_inertials(bot):
    stated = bot(dressed(upper=BODY, fore=BODY)).robot
    found = bot(BARE, BODIES.format("upper") + BODIES.format("fore")).robot
    assert found == stated
    assert np.linalg.eigvalsh(derive(found).numpy().mass_matrix(np.array([0.3, -0.4]))).min() > 0
    mixed = bot(dressed(upper=shape('<box size="1 1 1"/>'), fore=BODY), BODIES.format("upper"), floating=False)
    assert mixed.robot == stated


@pytest.mark.parametrize(
    ("links", "options", "said"),
    [
        ({}, {}, "line 1: link 'upper': has no mass, nor has what it carries; give it an <inertial>"),
        ({}, {"floating": True}, "line 1: link 'base': has no mass, nor has what it carries"),
        ({}, {"density": 1.0}, "line 1: <robot>: has no link that lacks an inertial and has a shape"),
        ({"fore": shape('<mesh filename="none.stl"/>')}, {"density": 1.0}, "line 1: link 'fore': mesh: there is no"),
        ({"fore": shape('<box size="1 0 1"/>')}, {"density": 1.0}, "line 1: link 'fore': box size: is \"1 0 1\"; "),
    ],
)
def test_the_cause_is_named(bot, links, options, said):
    with pytest.raises(RobotFileError) as error:
        bot(dressed(**links), **options)
    assert f"bot.urdf: {said}" in str(error.value)


def test_an_inertia_that_no_body_has_is_that_of_its_own_link(bot):
    """Not of the link that a fixed joint makes it a part of; a heavy one hides it, which is said."""
    wrong = BODY.replace('izz="0.1"', 'izz="0.4"')
    text = dressed(upper=BODY, fore=BODY).replace("</robot>", "\n<link name='tool'>\n")
    text += f"{wrong}</link>{joint('hold', 'upper', 'tool', 'fixed', xyz='0 0 0')}</robot>"
    with pytest.raises(
        RobotFileError, match=r"line 3: link 'tool': inertia: is one that no body has, .* 0\.1, 0\.1, 0\.4"
    ):
        bot(text)
    said = "line 3: link 'tool': no body has its principal moments 0.1, 0.1, 0.4 kg·m²; "
    taken = bot(text, nearest_inertia=True)
    assert f"{said}the nearest that one has are 0.2, 0.2, 0.4 kg·m²" in taken.notes
    hidden = bot(text.replace('"0.1"', '"0.4"', 3))
    assert any(note.startswith(f"{said}what it is welded to hides that") for note in hidden.notes)


def test_the_command_line_takes_masses(bot, tmp_path, capsys):
    bot(dressed(upper=shape('<box size="1 1 1"/>'), fore=BODY))
    files = [str(tmp_path / "bot.urdf"), "-o", str(tmp_path / "bot.toml")]
    assert main(["import", *files, "--density", "7"]) == 0 and "mass = 7.0\n" in (tmp_path / "bot.toml").read_text()
    for wrong, said in (
        ("--density=0", "density: is 0.0; it must be > 0"),
        ("--density=1 --total-mass=1", "density: is"),
    ):
        assert main(["import", *files, *wrong.split()]) == 2 and said in capsys.readouterr().err
