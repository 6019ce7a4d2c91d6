"""Attitude and motion in space of a rolling body.

The attitude is a unit quaternion (w, x, y, z) that turns body axes into space axes.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.named_formulas import flat_pairs, scalars
from flowlanes.system.system import Observable, Reconstruction, System
from flowlanes.system.vectors import Vector, constant

from ..shapes.kinematics import Contact, gamma, omega
from ..shapes.surfaces import Surface

attitude = Vector("attitude", 4)

_HALF = sp.Rational(1, 2)


def quaternion_rate(omega: MatrixExpr) -> MatrixExpr:
    """dq/dt = ½ q (0, ω) for the angular velocity ω in body axes."""
    w, x, y, z = attitude.symbols
    a, b, c = scalars(omega)
    return constant(
        [
            -_HALF * (x * a + y * b + z * c),
            _HALF * (w * a + y * c - z * b),
            _HALF * (w * b + z * a - x * c),
            _HALF * (w * c + x * b - y * a),
        ]
    )


def rotation() -> sp.ImmutableDenseMatrix:
    """The matrix from body to space components, of a unit quaternion.

    Its rows are α, β, γ of (1.10).
    """
    w, x, y, z = attitude.symbols
    return constant(
        [
            [1 - 2 * (y**2 + z**2), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x**2 + z**2), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x**2 + y**2)],
        ]
    )


def unit_length() -> sp.Expr:
    """The expression |q|² − 1, which vanishes for a unit quaternion."""
    return sp.Add(*(s**2 for s in attitude.symbols)) - 1


def attitude_relations(vertical: MatrixExpr) -> tuple[sp.Expr, ...]:
    """Expressions that vanish when `vertical` is the third space axis in body axes."""
    row = rotation().row(2)
    return tuple(a - b for a, b in zip(row, scalars(vertical), strict=True))


def attitude_observable() -> Observable:
    """The observable that records the quaternion."""
    return Observable(
        "attitude",
        attitude,
        "attitude quaternion, body to space",
        frame="quaternion",
        source="(1.13)",
    )


def motion_in_space(contact: Contact, surface: Surface, tilting: bool) -> Reconstruction:
    """The equations of attitude and position of a rolling body, driven by the reduced motion.

    Parameters
    ----------
    contact : Contact
    surface : Surface
    tilting : bool
        Whether ζ, the vertical in body axes, is a state variable if it differs from γ.
    """
    placed = surface.placement(contact.r, contact.rdot, contact.height, rotation())
    relations = (unit_length(), *placed.relations)
    if tilting or surface.vertical == gamma:
        relations += attitude_relations(surface.vertical)
    return Reconstruction(
        field=((attitude, quaternion_rate(omega)), *placed.field),
        relations=relations,
        observables=(
            attitude_observable(),
            Observable("centre", placed.centre, "centre of mass", "m", "space", "(1.17)"),
            Observable("contact", placed.point, "contact point", "m", "space", "(1.14)"),
        ),
    )


def place_rates(system: System) -> list[sp.Expr]:
    """Rates of the variables of the motion in space, except the attitude."""
    motion = system.reconstruction
    pairs = () if motion is None else flat_pairs(motion.field)
    return [formula for name, formula in pairs if name not in attitude.symbols]
