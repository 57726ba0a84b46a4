"""A good robot file, what can be wrong in it, and how it must be refused."""

import pytest

from screwgen.errors import RobotFileError
from screwgen.spec import load

GOOD = """\
name = "bot"
gravity = [0.0, 0.0, -9.81]
section_rotation = true

[[links]]
name = "upper"
length = 0.5
frame_at = 0.1
section = { rhoA = 1.0, EA = 1e7, EIy = 1e3, EIz = 1e3, GJ = 1e3, rhoIp = 1e-3 }
modes = { basis = "clamped_free", axial = 1, bending_y = 2, bending_z = 2, torsion = 1 }
damping = { ratio = 0.01 }
bodies = [ { at = "tip", mass = 2.0, com = [0.0, 0.0, 0.1], inertia = [1.0, 2.0, 2.5, 0.0, 0.0, 0.0] } ]

[links.joint]
axes = ["y", [0.0, 0.0, 1.0]]
mount = { xyz = [0.0, 0.0, 0.1], rpy = [0.0, 0.0, 0.2] }
armature = [0.1, 0.2]
damping = [0.0, 0.0]
stiffness = [0.0, 1.0]

[[links]]
name = "fore"
length = 0.4
section = { density = 7800.0, area = 1e-4, E = 2e11, Iy = 1e-8, Iz = 1e-8, G = 8e10, J = 2e-8 }
joint = { axes = ["z"] }
"""

FORCES = """
[[forces]]
name = "spring"
between = ["upper.tip", "fore.tip"]
line = { stiffness = 40.0, rest = 0.3 }

[[forces]]
name = "finger"
between = ["fore.tip", "world"]
contact = { radius = 0.1, stiffness = 1e4, width = 1e-4, normal = [0.0, 0.0, 1.0] }

[[pushes]]
name = "hand"
at = "fore.tip"
axes = "marker"
"""
"""What may stand behind it: forces between frames."""

MATERIAL = "{ density = 7800.0, area = 1e-4, E = 2e11, Iy = 1e-8, Iz = 1e-8, G = 8e10, J = 2e-8 }"
LINE = "{ rhoA = 1.0, EA = 1e7, EIy = 1e3, EIz = 1e3, GJ = 1e3, rhoIp = 1e-3 }"
MODES = '{ basis = "clamped_free", axial = 1, bending_y = 2, bending_z = 2, torsion = 1 }'
BODY = '{ at = "tip", mass = 2.0, com = [0.0, 0.0, 0.1], inertia = [1.0, 2.0, 2.5, 0.0, 0.0, 0.0] }'
INERTIA = "inertia = [1.0, 2.0, 2.5, 0.0, 0.0, 0.0]"
UPPER_NAME, FORE_NAME = 'name = "upper"', 'name = "fore"'
FREE = 'axes = ["z"]'
SCREW = 'axes = [{ screw = "z", pitch = 0.1 }]'
PLANE = 'axes = [{ slide = "x" }, { slide = "y" }, { slide = [1, 1, 0] }]'
AXES = 'axes = ["y", [0.0, 0.0, 1.0]]'
UPPER, FORE = "links[0]", "links[1]"
AXIS = f"{FORE}.joint.axes[0]"

WRONG = [  # what stands in GOOD, what replaces it, the key path of the message, a fragment of it
    # the robot
    ('name = "bot"\n', "", "name", "is missing; state the robot's name"),
    ('name = "bot"', "name = 3", "name", "is 3; it must be a string"),
    ('name = "bot"', 'name = ""', "name", "C identifier"),
    ('name = "bot"', 'name = "my-bot"', "name", '"my-bot"; it must be a C identifier'),
    ('name = "bot"', 'name = "2bot"', "name", "C identifier"),
    ('name = "bot"', 'name = "_bot"', "name", "C identifier"),
    ('name = "bot"', 'name = "bôt"', "name", r'"b\u00f4t"'),
    ('name = "bot"', r'name = "bot\n"', "name", r'"bot\n"'),
    ('name = "bot"', 'name = "while"', "name", "a C keyword"),
    ('name = "bot"', 'name = "restrict"', "name", "a C keyword"),
    ('name = "bot"', 'name = "math"', "name", "something of that name"),
    ('name = "bot"', 'name = "Main"', "name", "something of that name"),
    *(
        ('name = "bot"', f'name = "{name}"', "name", "something of that name already; choose another name")
        for name in ("features", "edit_cache", "rebuild_cache", "preinstall", "ALL_BUILD", "ZERO_CHECK", "RUN_TESTS")
    ),
    ('name = "bot"', 'name = "Makefile"', "name", "something of that name"),
    ('name = "bot"', f'name = "{"b" * 41}"', "name", "at most 40"),
    ("gravity = [0.0, 0.0, -9.81]\n", "", "gravity", "is missing; state acceleration of free fall, inertial"),
    ("-9.81]", "-9.81, 0]", "gravity", "has length 4; it must be an array of 3 numbers"),
    ("[0.0, 0.0, -9.81]", "9.81", "gravity", "is 9.81; it must be an array of 3 numbers"),
    ("-9.81", "nan", "gravity[2]", "is nan; it must be a finite number"),
    ("-9.81", "-inf", "gravity[2]", "is -inf; it must be a finite number"),
    ("-9.81", "1e999", "gravity[2]", "is inf; it must be a finite number"),
    ("-9.81", f"0x{'f' * 300}", "gravity[2]", "a whole number over 1e40; it must be a finite number"),
    ("-9.81", '"-9.81"', "gravity[2]", 'is "-9.81"; it must be a number'),
    ("-9.81", "true", "gravity[2]", "is true; it must be a number"),
    ("-9.81", "2024-02-29", "gravity[2]", "is a date or time; it must be a number"),
    ("section_rotation = true", "section_rotation = 1", "section_rotation", "is 1; it must be true or false"),
    ("section_rotation", "section_rotatoin", "section_rotatoin", "did you mean section_rotation?"),
    ("section_rotation", '"a\\nb"', r'"a\nb"', "order, base, base_acceleration, links"),
    ("section_rotation", "Gravity", "Gravity", "did you mean gravity?"),
    # the links
    (GOOD[GOOD.index("[[links]]") :], "", "links", "is missing; state at least one [[links]] table"),
    (GOOD[GOOD.index("[[links]]") :], "links = []", "links", "is empty; state at least one [[links]] table"),
    (GOOD[GOOD.index("[[links]]") :], "links = [3]", "links[0]", "is 3; it must be a table of name, length"),
    (GOOD[GOOD.index("[[links]]") :], "[links]", "links", "is a table; it must be an array of tables"),
    ('name = "upper"\n', "", f"{UPPER}.name", "is missing; state the link's name"),
    ('name = "upper"', 'name = "int"', f"{UPPER}.name", "a C keyword"),
    ('name = "upper"', 'name = "_x"', f"{UPPER}.name", "C identifier"),
    ('name = "fore"', 'name = "upper"', f"{FORE}.name (link upper)", "the name of links[0]; every link"),
    ('name = "fore"', 'name = "Upper"', f"{FORE}.name (link Upper)", "but for the case of its letters"),
    ("length = 0.4\n", "", f"{FORE}.length (link fore)", "is missing; state the length of the centreline, m"),
    ("length = 0.4", "length = 0", f"{FORE}.length (link fore)", "is 0; it must be > 0"),
    ("length = 0.4", "length = -0.4", f"{FORE}.length", "is -0.4; it must be > 0"),
    ("length = 0.4", "lenght = 0.4", f"{FORE}.lenght (link fore)", "did you mean length?"),
    ("frame_at = 0.1", "frame_at = -0.1", f"{UPPER}.frame_at", "is -0.1; it must be >= 0"),
    ("frame_at = 0.1", "segments = 0", f"{UPPER}.segments", "is 0; it must be from 1 to 64"),
    ("frame_at = 0.1", "segments = 65", f"{UPPER}.segments", "is 65; it must be from 1 to 64"),
    ("frame_at = 0.1", "segments = 2.0", f"{UPPER}.segments", "is 2.0; it must be a whole number from 1 to 64"),
    ("frame_at = 0.1", "segments = true", f"{UPPER}.segments", "is true; it must be a whole number"),
    ("frame_at = 0.1", "frame_at = 0.1\nsegments = 2", f"{UPPER}.frame_at", "beside segments = 2, of which each has"),
    ("length = 0.4", "length = 0.4\nsegments = 2", f"{FORE}.segments", "is stated for a rigid link; state modes"),
    ("frame_at = 0.1", "frame_at = 0.6", f"{UPPER}.frame_at", "is 0.6, beyond the tip; it must be from 0 to"),
    ("damping = { ratio = 0.01 }", "damping = 0.01", f"{UPPER}.damping", "it must be a table of ratio"),
    ("damping = { ratio = 0.01 }", "damping = {}", f"{UPPER}.damping (link upper)", "states nothing; state ratio"),
    ("ratio = 0.01", "ratio = -0.01", f"{UPPER}.damping.ratio", "is -0.01; it must be >= 0"),
    ("ratio = 0.01", "time = -0.01", f"{UPPER}.damping.time", "is -0.01; it must be >= 0"),
    ("ratio = 0.01", "tme = 0.01", f"{UPPER}.damping.tme", "did you mean time? known here: ratio, time"),
    # the section
    (f"section = {LINE}\n", "", f"{UPPER}.section", "is missing; state the section, at least { rhoA"),
    (LINE, "1.0", f"{UPPER}.section", "it must be a table of rhoA, EA"),
    ("rhoA = 1.0, ", "", f"{UPPER}.section.rhoA", "is missing; state mass per length, kg/m, > 0 (or density"),
    ("rhoA = 1.0", "rhoA = 0.0", f"{UPPER}.section.rhoA", "is 0.0; it must be > 0"),
    ("rhoA = 1.0", "rhoa = 1.0", f"{UPPER}.section.rhoa", "did you mean rhoA?"),
    ("EA = 1e7, ", "", f"{UPPER}.section.EA", "is missing, but modes.axial needs it"),
    ("EA = 1e7", "EA = 0.0", f"{UPPER}.section.EA", "is zero, but modes.axial needs it; it must be > 0"),
    ("EA = 1e7", "EA = -1e7", f"{UPPER}.section.EA", "is -10000000.0; it must be >= 0"),
    ("EIy = 1e3, ", "", f"{UPPER}.section.EIy", "is missing, but modes.bending_z needs it"),
    ("EIz = 1e3, ", "", f"{UPPER}.section.EIz", "is missing, but modes.bending_y needs it"),
    ("GJ = 1e3, ", "", f"{UPPER}.section.GJ", 'it must be > 0 (in the material spelling: "G" and "J")'),
    (", rhoIp = 1e-3", "", f"{UPPER}.section.rhoIp", "is missing, but modes.torsion needs it"),
    ("rhoIp = 1e-3", "rhoIp = -1e-3", f"{UPPER}.section.rhoIp", "is -0.001; it must be >= 0"),
    ("E = 2e11", "E = 0.0", f"{FORE}.section.E", "is 0.0; it must be > 0"),
    ("E = 2e11", "E = -2e11", f"{FORE}.section.E", "is -200000000000.0; it must be > 0"),
    ("E = 2e11", 'E = "2e11"', f"{FORE}.section.E", 'is "2e11"; it must be a number'),
    ("Iy = 1e-8", "Iy = -1e-8", f"{FORE}.section.Iy", "is -1e-08; it must be >= 0"),
    ("area = 1e-4, ", "", f"{FORE}.section.rhoA", "is missing"),
    ("density = 7800.0, ", "", f"{FORE}.section.rhoA", "is missing; state mass per length"),
    ("G = 8e10, ", "", f"{FORE}.section.J", 'has no effect alone; state "G" with it'),
    ("E = 2e11, Iy = 1e-8, Iz = 1e-8, ", "Iy = 1e-8, ", f"{FORE}.section.Iy", 'state "E" with it'),
    (MATERIAL, "{ rhoA = 1.0, density = 7800.0 }", f"{FORE}.section.density", 'state "area" with it'),
    ("density = 7800.0", "rhoA = 1.0, density = 7800.0", f"{FORE}.section.rhoA", 'here and by "density"'),
    ("E = 2e11", "EIz = 1.0, E = 2e11", f"{FORE}.section.EIz", 'is stated twice, here and by "E" and "Iz"'),
    ("density = 7800.0", "Density = 7800.0", f"{FORE}.section.Density", "did you mean density?"),
    ("area = 1e-4, E = 2e11", "area = 1e200, E = 1e200", f"{FORE}.section.area", "it must be from 1e-14 to 1e+09 m²"),
    # the modes
    (MODES, "3", f"{UPPER}.modes", "is 3; it must be a table of basis, axial"),
    ('"clamped_free"', '"clamped"', f"{UPPER}.modes.basis", 'it must be "polynomial" or "clamped_free"'),
    ("axial = 1", "axial = -1", f"{UPPER}.modes.axial", "is -1; it must be from 0 to 32"),
    ("axial = 1", "axial = 33", f"{UPPER}.modes.axial", "is 33; it must be from 0 to 32"),
    ("axial = 1", "axial = 1.5", f"{UPPER}.modes.axial", "is 1.5; it must be a whole number from 0 to 32"),
    ("axial = 1", "axial = true", f"{UPPER}.modes.axial", "is true; it must be a whole number"),
    ("axial = 1", 'axial = "1"', f"{UPPER}.modes.axial", 'is "1"; it must be a whole number'),
    ("axial = 1", "bending = 1", f"{UPPER}.modes.bending", "did you mean bending_"),
    # the joint
    ('joint = { axes = ["z"] }\n', "", f"{FORE}.joint (link fore)", "is missing; state the joint"),
    ('{ axes = ["z"] }', "{}", f"{FORE}.joint.axes", "is missing; state the axes in order"),
    ('{ axes = ["z"] }', "[]", f"{FORE}.joint", "is an array of 0; it must be a table of axes, mount"),
    ('axes = ["z"]', 'axes = "z"', f"{FORE}.joint.axes", 'is "z"; it must be an array of axes'),
    ('axes = ["z"]', 'axes = ["Z"]', f"{FORE}.joint.axes[0]", 'it must be "x", "y", "z", an array of 3 numbers, {'),
    ('axes = ["z"]', 'axes = ["x", "y", "z", "x"]', f"{FORE}.joint.axes", "has 4 axes; at most 3"),
    ('axes = ["z"]', "axes = [[0, 0, 0]]", f"{FORE}.joint.axes[0] (link fore)", "is the zero vector"),
    ('axes = ["z"]', "axes = [[0, 1]]", f"{FORE}.joint.axes[0]", "has length 2"),
    ('axes = ["z"]', "axes = [0, 0, 1]", f"{FORE}.joint.axes[0]", "is 0; it must be an array of 3 numbers"),
    ('axes = ["z"]', "axes = [[0, 0, nan]]", f"{FORE}.joint.axes[0][2]", "it must be a finite number"),
    (AXES, 'axes = ["z", [0.0, 0.0, 1.0]]', f"{UPPER}.joint.axes[1]", "is parallel to the axis before it"),
    (AXES, 'axes = ["z", [0.0, 0.0, -2.0]]', f"{UPPER}.joint.axes[1]", "is parallel to the axis before it"),
    (AXES, "axes = [[1, 1, 1], [0.577, 0.577, 0.577]]", f"{UPPER}.joint.axes[1]", "is parallel"),
    # the tree
    (FORE_NAME, f'{FORE_NAME}\nparent = "Upper"', f"{FORE}.parent", 'is "Upper", which is no link; a link comes after'),
    (FORE_NAME, f'{FORE_NAME}\nparent = "fore"', f"{FORE}.parent", 'is "fore", which is the link itself; a link comes'),
    (UPPER_NAME, f'{UPPER_NAME}\nparent = "fore"', f"{UPPER}.parent", 'is "fore", which comes later; a link'),
    (FORE_NAME, f"{FORE_NAME}\nparent = 1", f"{FORE}.parent", "is 1; it must be a string"),
    (FORE_NAME, f'{FORE_NAME}\nparent = ""', f"{FORE}.parent", 'is ""; it must be a C identifier'),
    (FORE_NAME, f'{FORE_NAME}\nparents = "upper"', f"{FORE}.parents", "did you mean parent?"),
    (FORE_NAME, f'{FORE_NAME}\nparent = "World"', f"{FORE}.parent", 'is "World", which is no link; a link comes after'),
    (FORE_NAME, f'{FORE_NAME}\nparent = "base"', f"{FORE}.parent", 'after the one that carries it: "upper" or "world"'),
    (UPPER_NAME, 'name = "world"', f"{UPPER}.name", 'is "world", which as a parent is the inertial frame'),
    (FORE_NAME, f'{FORE_NAME}\nparent = "upper "', f"{FORE}.parent", 'is "upper "; it must be a C identifier'),
    (FORE_NAME, f'{FORE_NAME}\nchildren = ["hand"]', f"{FORE}.children", "is an unknown key; known here: name, length"),
    (FORE_NAME, f'{FORE_NAME}\nParent = "upper"', f"{FORE}.Parent", "is an unknown key; did you mean parent?"),
    # keys of a table below
    (FORE_NAME, f"{FORE_NAME}\ndrives = [{{}}]", f"{FORE}.drives", "is an unknown key here; it belongs in joint"),
    (FORE_NAME, f"{FORE_NAME}\nmass = 2.0", f"{FORE}.mass", "is an unknown key here; it belongs in bodies; known here"),
    ('name = "bot"', 'name = "bot"\nparent = "world"', "parent", "is an unknown key here; it belongs in links; known"),
    # slides and screws
    (FREE, 'axes = [{ slid = "z" }]', f"{AXIS}.slid", "did you mean slide? known here: slide, screw, pitch"),
    (FREE, "axes = [{}]", AXIS, 'is neither a slide nor a screw; write { slide = "x" } or { screw = "x", pitch ='),
    (FREE, "axes = [{ pitch = 0.1 }]", AXIS, "is neither a slide nor a screw; write"),
    (FREE, SCREW.replace("screw", 'slide = "y", screw'), AXIS, "is a slide and a screw at once; write"),
    (FREE, SCREW.replace("screw", "slide"), f"{AXIS}.pitch", "is stated of a slide, which does not turn; leave it"),
    (FREE, 'axes = [{ screw = "z" }]', f"{AXIS}.pitch", "is missing; state how far the link moves along the axis"),
    (FREE, SCREW.replace("0.1", "0"), f"{AXIS}.pitch", "is 0; an axis about which the link turns alone is written"),
    (FREE, SCREW.replace("0.1", '"0.1"'), f"{AXIS}.pitch", 'is "0.1"; it must be a number'),
    (FREE, SCREW.replace("0.1", "inf"), f"{AXIS}.pitch", "it must be a finite number"),
    (FREE, "axes = [{ slide = [0, 0, 0] }]", f"{AXIS}.slide", "is the zero vector; an axis needs a direction"),
    (FREE, 'axes = [{ slide = "xy" }]', f"{AXIS}.slide", 'is "xy"; it must be "x", "y", "z" or an array of 3'),
    (FREE, 'axes = [{ screw = { slide = "x" }, pitch = 1 }]', f"{AXIS}.screw", "is a table; it must be an array of 3"),
    (AXES, 'axes = [{ slide = "x" }, { slide = [-1, 0, 0] }]', f"{UPPER}.joint.axes[1]", "is parallel to the axis"),
    (AXES, 'axes = [{ slide = "x" }, "x", { slide = "x" }]', f"{UPPER}.joint.axes[2]", "adds no motion to the axes"),
    (FREE, 'axes = { slide = "z" }', f"{FORE}.joint.axes", "is a table; it must be an array of axes"),
    (FREE, 'axes = [["slide", "z"]]', AXIS, "has length 2; it must be an array of 3 numbers"),
    (FREE, f"{FREE}, bodies = []", f"{FORE}.joint.bodies", "here; it belongs in links[1], above its table joint;"),
    (FREE, f"{FREE}, gravity = []", f"{FORE}.joint.gravity", "here; it belongs at the top, above links; known"),
    (FREE, 'axes = [{ revolute = "z" }]', f"{AXIS}.revolute", "is an unknown key; known here: slide, screw, pitch"),
    (FREE, 'axes = [{ slide = "X" }]', f"{AXIS}.slide", 'is "X"; it must be "x", "y", "z" or an array of 3'),
    (FREE, 'axes = [{ slide = ["z"] }]', f"{AXIS}.slide", "has length 1; it must be an array of 3 numbers"),
    (FREE, "axes = [{ slide = [0, 0, inf] }]", f"{AXIS}.slide[2]", "is inf; it must be a finite number"),
    (FREE, "axes = [{ slide = true }]", f"{AXIS}.slide", "is true; it must be an array of 3 numbers"),
    (FREE, SCREW.replace("0.1", "1e30"), f"{AXIS}.pitch", "is 1e+30; it must be from -1000 to 1000 m/rad"),
    (FREE, SCREW.replace("pitch", "lead"), f"{AXIS}.lead", "is an unknown key; known here: slide, screw, pitch"),
    (FREE, SCREW.replace('screw = "z"', 'slide = "z"'), f"{AXIS}.pitch", "or write screw for slide"),
    (AXES, PLANE, f"{UPPER}.joint.axes[2]", "adds no motion to the axes before it, in any posture; leave it out"),
    ("armature = [0.1, 0.2]", "armature = [0.1]", f"{UPPER}.joint.armature", "must hold one number per axis"),
    ("armature = [0.1, 0.2]", "armature = 0.1", f"{UPPER}.joint.armature", "it must be an array of numbers"),
    ("armature = [0.1, 0.2]", "armature = [0.1, -0.2]", f"{UPPER}.joint.armature[1]", "it must be >= 0"),
    ("damping = [0.0, 0.0]", "damping = [-1, 0.0]", f"{UPPER}.joint.damping[0]", "is -1; it must be >= 0"),
    ("damping = [0.0, 0.0]", "damping = []", f"{UPPER}.joint.damping", "one number per axis"),
    ("stiffness = [0.0, 1.0]", "stiffness = [0.0, -1.0]", f"{UPPER}.joint.stiffness[1]", "it must be >= 0"),
    ("stiffness = [0.0", "stifness = [0.0", f"{UPPER}.joint.stifness", "did you mean stiffness?"),
    ("xyz = [0.0", "xyz = [inf", f"{UPPER}.joint.mount.xyz[0]", "it must be a finite number"),
    ("rpy = [0.0, 0.0, 0.2]", "rpy = [0.2]", f"{UPPER}.joint.mount.rpy", "has length 1"),
    ("rpy = ", "quaternion = ", f"{UPPER}.joint.mount.quaternion", "known here: xyz, rpy"),
    # the bodies
    (f"[ {BODY} ]", BODY, f"{UPPER}.bodies", "is a table; it must be an array of tables"),
    (BODY, "2.0", f"{UPPER}.bodies[0]", "is 2.0; it must be a table of at, mass, com, inertia"),
    ('at = "tip", ', "", f"{UPPER}.bodies[0].at", 'is missing; state where the body sits, "base" or "tip"'),
    ('at = "tip"', 'at = "middle"', f"{UPPER}.bodies[0].at", 'is "middle"; it must be "base" or "tip"'),
    ("mass = 2.0, ", "", f"{UPPER}.bodies[0].mass (link upper)", "is missing; state mass of the body, kg"),
    ("mass = 2.0", "mass = -2.0", f"{UPPER}.bodies[0].mass", "is -2.0; it must be >= 0"),
    ("com = [0.0, 0.0, 0.1]", "com = 0.1", f"{UPPER}.bodies[0].com", "it must be an array of 3 numbers"),
    (INERTIA, "inertia = [1, 1, 1]", f"{UPPER}.bodies[0].inertia", "has length 3; it must be an array of 6"),
    (INERTIA, "inertia = [-1, 1, 1, 0, 0, 0]", f"{UPPER}.bodies[0].inertia", "an inertia that no body has"),
    (INERTIA, "inertia = [1, 1, 2.1, 0, 0, 0]", f"{UPPER}.bodies[0].inertia", "nor exceed the sum"),
    (INERTIA, "inertia = [1, 1, 1, 1.1, 0, 0]", f"{UPPER}.bodies[0].inertia", "an inertia that no body has"),
    (INERTIA, "inertia = [0, 0, 0, 0, 0, 1]", f"{UPPER}.bodies[0].inertia", "an inertia that no body has"),
    (INERTIA, "inertia = [-1, -1, -1, 0, 0, 0]", f"{UPPER}.bodies[0].inertia", "an inertia that no body has"),
    # the text
    ("-9.81]", "-9.81", "line 3", "is not valid TOML (unclosed array); see https://toml.io"),
    ('name = "bot"', 'name = "bot', "line 1", "is not valid TOML"),
    ('name = "bot"', 'name = "bot"\nname = "bot"', "line 2", "cannot overwrite a value"),
    ("section_rotation = true", "section_rotation = True", "line 3", "is not valid TOML"),
    ("section_rotation = true", "section_rotation: true", "line 3", "is not valid TOML (expected '='"),
    ("-9.81", f"1{'0' * 5000}", "a value cannot be read", "use TOML 1.0"),
    ("-9.81", "2023-02-29", "line 2", "is not valid TOML"),
    ("section_rotation = true", f"x = {'[' * 5000}", "is nested too deeply", "needs five levels"),
    ("section_rotation = true", f"{'x.' * 100000}y = 1", "is nested too deeply", "five levels"),
    ("section_rotation = true", f"{'x.' * 20}y = 1", "x", "is an unknown key"),
]  # fmt: skip


FOUND = f"{UPPER}.modes.frequencies"
PAIR = "{ bending_y = [20.0, 130.0] }"
NO_EIZ = "rhoA = 1.0, EA = 1e7, EIy = 1e3, GJ = 1e3, rhoIp = 1e-3"
TWO = "bending_y = 2"

WRONG_FREQUENCIES = [  # frequencies, section and modes in y of the upper link, then as in WRONG
    # the table and its arrays
    ("[20.0, 130.0]", NO_EIZ, TWO, FOUND, "is an array of 2; it must be a table of axial, bending_y"),
    ("20.0", NO_EIZ, TWO, FOUND, "is 20.0; it must be a table of axial"),
    ("{ bending = [20.0, 130.0] }", NO_EIZ, TWO, f"{FOUND}.bending", "is an unknown key; did you mean bending_"),
    ("{ spin = [20.0] }", NO_EIZ, TWO, f"{FOUND}.spin", "known here: axial, bending_y, bending_z, torsion"),
    ("{ bending_y = 20.0 }", NO_EIZ, TWO, f"{FOUND}.bending_y", "it must be an array of numbers, one for each mode"),
    ('{ bending_y = "20 Hz" }', NO_EIZ, TWO, f"{FOUND}.bending_y", 'is "20 Hz"; it must be an array of numbers'),
    # one number per mode
    ("{ bending_y = [20.0] }", NO_EIZ, TWO, f"{FOUND}.bending_y (link upper)", "has length 1; it must hold one"),
    ("{ bending_y = [1, 2, 3] }", NO_EIZ, TWO, f"{FOUND}.bending_y", "has length 3; it must hold one frequency"),
    ("{ bending_y = [] }", NO_EIZ, TWO, f"{FOUND}.bending_y", "one frequency per mode, modes.bending_y = 2"),
    (PAIR, NO_EIZ, "bending_y = 0", f"{FOUND}.bending_y", "one frequency per mode, modes.bending_y = 0"),
    (PAIR, NO_EIZ, "", f"{FOUND}.bending_y", "one frequency per mode, modes.bending_y = 0"),
    # each a number that a measurement can give, in ascending order
    ("{ bending_y = [20.0, 0.0] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "is 0.0; it must be > 0"),
    ("{ bending_y = [-20.0, 130.0] }", NO_EIZ, TWO, f"{FOUND}.bending_y[0]", "is -20.0; it must be > 0"),
    ("{ bending_y = [20.0, 1e200] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "is 1e+200; it must be from 1e-06"),
    ("{ bending_y = [1e-200, 20.0] }", NO_EIZ, TWO, f"{FOUND}.bending_y[0]", "is 1e-200; it must be from 1e-06"),
    ("{ bending_y = [20.0, nan] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "is nan; it must be a finite number"),
    ("{ bending_y = [20.0, inf] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "is inf; it must be a finite number"),
    ('{ bending_y = [20.0, "130"] }', NO_EIZ, TWO, f"{FOUND}.bending_y[1]", 'is "130"; it must be a number'),
    ("{ bending_y = [20.0, true] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "is true; it must be a number"),
    ("{ bending_y = [20.0, [130]] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "is an array of 1; it must be a number"),
    ("{ bending_y = [130.0, 20.0] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "is 20.0; it must be greater than the"),
    ("{ bending_y = [20, 20] }", NO_EIZ, TWO, f"{FOUND}.bending_y[1]", "greater than the frequency before it, 20.0"),
    # natural modes only
    (PAIR, NO_EIZ, f'basis = "polynomial", {TWO}', f"{FOUND}.bending_y", 'basis "polynomial", whose shapes are not'),
    (PAIR, NO_EIZ, f'basis = "polynomial", {TWO}', f"{FOUND}.bending_y", "or state EIz in the section"),
    # beside a stiffness, be it zero or said by the material
    (PAIR, LINE[2:-2], TWO, f"{FOUND}.bending_y (link upper)", "beside section.EIz (in the material spelling"),
    (PAIR, LINE[2:-2], TWO, f"{FOUND}.bending_y", '"Iz"), but either gives the stiffness; leave one of them out'),
    (PAIR, f"{NO_EIZ}, EIz = 0.0", TWO, f"{FOUND}.bending_y", "is stated beside section.EIz"),
    (PAIR, MATERIAL[2:-2], TWO, f"{FOUND}.bending_y", "is stated beside section.EIz"),
    ("{ bending_z = [1, 2] }", NO_EIZ, TWO, f"{FOUND}.bending_z", "is stated beside section.EIy"),
    ("{ axial = [900.0] }", NO_EIZ, TWO, f"{FOUND}.axial", 'beside section.EA (in the material spelling: "E" and'),
    ("{ torsion = [300.0] }", NO_EIZ, TWO, f"{FOUND}.torsion", "is stated beside section.GJ"),
    # neither frequencies nor stiffness, or no inertia
    ("{}", NO_EIZ, TWO, f"{UPPER}.section.EIz", "is missing, but modes.bending_y needs it"),
    ("{ axial = [9.0] }", "rhoA = 1.0, EIy = 1e3, GJ = 1e3", TWO, f"{UPPER}.section.EIz", "is missing, but modes"),
    ("{ axial = [9.0], torsion = [3.0] }", "rhoA = 1.0, EIy = 1, EIz = 1", TWO, f"{UPPER}.section.rhoIp", "is missing"),
]  # fmt: skip


def refusal(path):
    """The message with which `load` refuses the file, below the file's name."""
    with pytest.raises(RobotFileError) as caught:
        load(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: ") and message.isprintable(), message
    assert not any(jargon in message for jargon in ("pydantic", "type=", "input_", "Input should")), message
    return message.removeprefix(f"{path}: ")


def refused(tmp_path, text: str, where: str, fragment: str) -> None:
    """The file of this text is refused in one line that names the key and says what is wrong."""
    path = tmp_path / "bot.toml"
    path.write_text(text, encoding="utf-8")
    message = refusal(path)
    assert message.startswith(where) and fragment in message, message
