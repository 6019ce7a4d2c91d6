"""Attitude and motion in space of a rolling body.

The attitude is a unit quaternion (w, x, y, z) that turns body axes into space axes.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Observable, Reconstruction, System, flat_pairs
from flowlanes.system.vectors import Vector, constant, cross, real_symbol, to_components

from ..shapes.surfaces import Plane, Surface
from .contact import Contact

attitude, place = Vector("attitude", 4), Vector("place", 2)
omega, gamma, zeta = (Vector(name) for name in ("omega", "gamma", "zeta"))
a = real_symbol("a")

_HALF = sp.Rational(1, 2)


def quaternion_rate(omega: MatrixExpr) -> MatrixExpr:
    """dq/dt = ½ q (0, ω) for the angular velocity ω in body axes."""
    w, x, y, z = attitude.symbols
    a, b, c = to_components(omega)
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
    """Vanishes for a unit quaternion."""
    return sp.Add(*(s**2 for s in attitude.symbols)) - 1


def attitude_relations(vertical: MatrixExpr) -> tuple[sp.Expr, ...]:
    """Vanish when `vertical` (body axes) is the third space axis seen from the body."""
    row = rotation().row(2)
    return tuple(a - b for a, b in zip(row, to_components(vertical), strict=True))


def attitude_observable() -> Observable:
    """The quaternion itself, as it is recorded."""
    return Observable(
        "attitude",
        attitude,
        "attitude quaternion, body to space",
        frame="quaternion",
        source="(1.13)",
    )


def motion_in_space(contact: Contact, surface: Surface, tilting: bool) -> Reconstruction:
    """The equations for attitude and place of a rolling body, driven by its reduced motion.

    Parameters
    ----------
    contact : Contact
    surface : Plane or Sphere
    tilting : bool
        Whether ζ, the vertical in body axes, belongs to the state on a sphere.
    """
    turn = rotation()
    reach = turn * to_components(contact.r)
    if isinstance(surface, Plane):
        # the centre's velocity is r×ω in body axes; its height follows from the position
        velocity = turn * to_components(cross(contact.r, omega))
        x, y = place.symbols
        centre = constant([x, y, contact.height])
        point = constant([x + reach[0], y + reach[1], 0])
        field: Pairs = (
            (attitude, quaternion_rate(omega)),
            (place, constant(velocity[:2])),
        )
        relations = (unit_length(), *attitude_relations(gamma))
    else:
        point = a * turn * to_components(gamma)
        centre = point - reach
        field = ((attitude, quaternion_rate(omega)),)
        relations = (unit_length(),)
        if tilting:
            relations += attitude_relations(zeta)
    return Reconstruction(
        field=field,
        relations=relations,
        observables=(
            attitude_observable(),
            Observable("centre", centre, "centre of mass", "m", "space", "(1.17)"),
            Observable("contact", point, "contact point", "m", "space", "(1.14)"),
        ),
    )


def place_rates(system: System) -> list[sp.Expr]:
    """Rates of the variables of the motion in space, the attitude left out."""
    motion = system.reconstruction
    pairs = () if motion is None else flat_pairs(motion.field)
    return [formula for name, formula in pairs if name not in attitude.symbols]
