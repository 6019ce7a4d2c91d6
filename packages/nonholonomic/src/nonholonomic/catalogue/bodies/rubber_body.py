"""A rubber body of any convex shape on a plane and on a sphere (§1.3, §1.4)."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors

from ..vector_rates import rate
from .any_shape import (
    INERTIA,
    POTENTIAL,
    SHAPE,
    contact_kinematics,
    energy,
    inverse,
    kinematics,
    momentum,
    on_sphere,
)

omega, gamma, r, rdot = vectors("omega gamma r rdot")
M, X, q, torque = vectors("M X q torque")
m, a, lambda_0 = real_symbol("m"), real_symbol("a"), real_symbol("lambda_0")


def any_rubber_body(curvature: sp.Expr = sp.S.Zero) -> System:
    """A rubber body of arbitrary support function h and potential U on a plane or a sphere.

    Parameters
    ----------
    curvature : sympy.Expr
        1/a of the supporting sphere in a symbol, which becomes a parameter; zero for a plane.

    Returns
    -------
    System
        State ω, γ (body axes): (1.18) or (1.23), the latter as corrected.
    """
    contact = contact_kinematics(curvature)
    return System(
        name=f"any-rubber-body-on-{contact.where}",
        title=f"Rubber body of any shape on a {contact.where}",
        field={omega: inverse(X) + lambda_0 * q, gamma: contact.gammadot},
        definitions=(
            *SHAPE,
            *INERTIA,
            *contact.definitions,
            (M, momentum(omega)),
            (X, cross(M, omega) - m * cross(r, cross(omega, rdot)) + torque),
            (q, inverse(gamma)),
            (lambda_0, -(dot(q, X) + dot(omega, contact.gammadot)) / dot(q, gamma)),
        ),
        parameters=contact.parameters,
        relations=(norm_squared(gamma) - 1, dot(omega, gamma)),
        source="(1.18), (1.19)" if curvature == 0 else "(1.23)",
    )


def general() -> System:
    """Any shape and potential on a plane."""
    return any_rubber_body().with_laws(
        Identity(
            "couple",
            Rate(POTENTIAL) + dot(torque, omega),
            "the couple does the work of the potential",
            source="(1.17)",
        ),
        Identity(
            "contact",
            (rdot - rate(r), dot(gamma, rdot)),
            "rate of the contact point, which stays in the tangent plane",
            source="§1.3",
        ),
        energy(),
    )


def general_on_sphere() -> System:
    """Any shape and potential on a sphere of radius a."""
    return any_rubber_body(1 / a).with_laws(
        kinematics(1 / a),
        energy(),
    )


ENTRIES = (on_sphere("rubber", general_on_sphere),)
