"""What documents say of brakes; what they do stands in the algorithms, for it is no force that a state has."""

LETTERS = {"inertia": "J_b", "time": "T_b"}
"""The letters of the keys of a brake in formulas."""
INPUT = "u_b"
"""That of its input."""

SYMBOLS = (
    (r"J_b, T_b", "inertia and time of a brake, of slides the inertia in kg", "kg*m^2, s", False),
    (r"u_b, \sigma_b", "input of a brake, and the share that it leaves of the balance of its axis", "-", True),
    (r"j_b", "inertia with which a brake holds its axis, of slides in kg", "kg*m^2", True),
    (r"\ddot{q}_b", "acceleration with which a brake stops its axis, of slides in m/s²", "rad/s^2", True),
)
"""Symbol, meaning, unit of what documents name, and whether it is a state."""
ROTOR_SYMBOLS = (
    (r"\ddot{\vartheta}_b", "acceleration with which a brake stops a rotor", "rad/s^2", True),
    (r"\ddot{\vartheta}_o", "acceleration of a rotor without its brake", "rad/s^2", True),
)
"""Those of brakes on rotors."""

EQUATIONS = (
    r"""
A brake whose input is $u_b$, 0 where it is open and 1 where it is closed, leaves a share $\sigma_b$ of the balance of
its axis, and a flywheel of inertia $j_b$ with the acceleration $\ddot{q}_b$, which stops the axis, takes the rest:

$$
\sigma_b &= \left( 1 - u_b \right)^{2}, & \quad j_b &= J_b\,\left( 1 - \sigma_b \right), & \quad"""
    r""" \ddot{q}_b &= -\frac{u_b\,\dot{q}}{T_b}
$$

These are the entries of $\boldsymbol{\sigma}_{b,i}$, $\mathbf{j}_{b,i}$ and $\ddot{\mathbf{q}}_{b,i}$, which are 1, 0
and 0 of an axis without a brake.
"""
)

ROTOR = (
    r"""
The brake of an elastic drive acts on its rotor, whose acceleration would be $\ddot{\vartheta}_o$ without it:

$$
\ddot{\vartheta} &= \frac{\sigma_b\,J_r\,\ddot{\vartheta}_o + j_b\,\ddot{\vartheta}_b}{\sigma_b\,J_r + j_b}, & \quad"""
    r""" \ddot{\vartheta}_b &= -\frac{u_b\,\dot{\vartheta}}{T_b}
$$
"""
)
