"""The numbers of equations on the paper's pages; here an equation is called by its label in the paper's source.

The equation of the inertia has the label ``eq:27`` and is called (27); on the page it is number 10.
"""

LABELS = """
1 2 twist Ad 5 8 10 11 26 27 28 29 30 Iibi 32 33 34 35 36 37 38 39 46 47 45 43 48 49 50 accconst1 accconst1b
accconst2 accconst4 accconst5 58 59 60 61 62 63 65 66 67 68 69 70 71 twist_coords 72 73 74 75 76 77 78 79
vxi_modal vxidot_modal 81 82 83 84 zi_def 85 86 88 89 95 MsPsi HMs 97 98 100 jacobian 103 cross 2T Msys_diff
DAESOL 109 110 111 - phi_x phi_y phi_z - - stability 14 15 16 17 18 19 20 21 22 23 24 25 Vdot_coord dvi dvxi dvb
B1 B2 B3
""".split()
"""The labels in the order of the pages, from number 1; an equation without a label is a dash."""
NUMBERS = {label: number for number, label in enumerate(LABELS, 1) if label != "-"}


def on_page(label: str) -> str:
    """The number of an equation on the page; empty for one that has none there."""
    return str(NUMBERS.get(label, ""))
