"""Units and meanings of the parameters of axes that do not turn, by their fields."""

SLIDING = {
    "joint.armature": ("kg", "drive's inertia seen along the joint axis"),
    "joint.damping": ("N·s/m", "viscous damping along the joint axis"),
    "joint.stiffness": ("N/m", "stiffness along the joint axis"),
    "joint.drives.ratio": ("rad/m", "turn of the rotor per travel of the joint"),
    "joint.drives.rotor_inertia": ("kg", "mass that moves with the drive"),
    "joint.drives.stiffness": ("N/m", "stiffness of the gear at the joint"),
    "joint.drives.damping": ("N·s/m", "damping of the gear at the joint"),
    "joint.drives.friction.coulomb": ("N", "dry friction"),
    "joint.drives.friction.viscous": ("N·s/m", "viscous friction"),
    "joint.drives.friction.velocity": ("m/s", "rate over which dry friction changes its sign"),
    "joint.limits.lower": ("m", "least coordinate of the joint"),
    "joint.limits.upper": ("m", "largest coordinate of the joint"),
    "joint.limits.stiffness": ("N/m", "stiffness of the stops at the limits"),
    "joint.limits.damping": ("N·s/m", "damping of the stops at the limits"),
}
"""Unit and meaning of a slide's parameters, in place of those of a joint that turns; friction on a rotor has
those, and so has a rotor's inertia where a ratio is stated."""
