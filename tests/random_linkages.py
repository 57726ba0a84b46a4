"""Four-bar linkages in place of cylinders of random joints, from streams of their own: other draws stay."""

import numpy as np


def replace_cylinders(joint: dict, probability: float) -> None:
    """Some cylinders become four-bar linkages whose links can go round; the numbers of a cylinder seed the draw."""
    for drive in joint.get("drives", []):
        cylinder = drive.get("transmission", {})
        rng = np.random.default_rng([int(abs(x) * 2**40) for x in cylinder.values()])
        if cylinder and rng.random() < probability:
            drive["transmission"] = {"four_bar": linkage(rng, cylinder["base"], cylinder["crank"], cylinder["angle"])}


def linkage(rng, ground: float, rocker: float, angle: float) -> dict:
    """Coupler and crank that reach the rocker's pin in every posture."""
    apart, total = rng.uniform(0.0, 0.8) * abs(ground - rocker), rng.uniform(1.2, 2.0) * (ground + rocker)
    crank, coupler = map(float, rng.permutation([(total - apart) / 2, (total + apart) / 2]))
    lengths = {"ground": ground, "crank": crank, "coupler": coupler, "rocker": rocker}
    return lengths | {"angle": angle, "branch": str(rng.choice(["open", "crossed"]))}
