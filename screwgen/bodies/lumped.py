"""Rigid bodies fixed to a section of a link, summed to one mass, first and second moment."""

from __future__ import annotations

from ..algebra.expression import Expression, Symbol, Trace, add, block, identity, zeros
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import LinkClass


def lumped(b: Block, key: LinkClass, section: str, tag: str) -> tuple[Expression, ...]:
    """Mass, first moment, second moment ``J`` and inertia ``I = tr(J) 1 - J`` of the bodies at a section.

    Base bodies are taken about the joint point in F_i axes, tip bodies about the tip point in tip-frame
    axes.  All are zero if the section carries no body.
    """
    parts = [_body(b, key, number) for number in key.bodies_at(section)] or [(zeros(1), zeros(3), zeros(3, 3))]
    m, S, J = (add(*column) for column in zip(*parts, strict=True))
    mass, first = b.step(f"m_{tag}", m), b.step(f"S_{tag}", S)
    second = b.step(f"J_{tag}", J, symmetric=True)
    return mass, first, second, b.step(f"I_{tag}", Trace(second) @ identity(3) - second, symmetric=True)


def _body(b: Block, key: LinkClass, number: int) -> tuple[Expression, Expression, Expression]:
    """One body: ``m``, ``m c`` and ``m c c^T + tr(I_c)/2 1 - I_c``."""
    body, tag = key.bodies[number], f"{number + 1}"
    assert body is not None
    m = b.parameter(f"body{number}_mass", (1, 1), rf"m_{{b{tag}}}", "kg", "-", f"mass of body {tag}")
    first: Expression = zeros(3)
    second: Expression = zeros(3, 3)
    if body.com:
        shown, meaning = rf"\mathbf{{c}}_{{b{tag}}}", f"centre of mass of body {tag}"
        com = b.parameter(f"body{number}_com", (3, 1), shown, "m", "section", meaning)
        first, second = m @ com, m @ (com @ com.T)
    if body.inertia:
        words = {"unit": "kg*m^2", "frame": "section", "meaning": f"inertia of body {tag} about its centre of mass"}
        column = {**words, "meaning": f"{words['meaning']}: xx, yy, zz, xy, xz, yz"}
        entries = b.parameter(f"body{number}_inertia", (6, 1), rf"\mathbf{{i}}_{{b{tag}}}", **column)
        xx, yy, zz, xy, xz, yz = b.entries(entries)
        matrix = block([xx, xy, xz], [xy, yy, yz], [xz, yz, zz])
        inertia = b.step(f"I_b{tag}", matrix, rf"\mathbf{{I}}_{{b{tag}}}", symmetric=True, **words)
        second = second + _second_moment(inertia)
    return m, first, second


def _second_moment(inertia: Symbol) -> Expression:
    return sp.Rational(1, 2) * (Trace(inertia) @ identity(3)) - inertia
