"""A marble body of any convex shape on a plane and on a sphere (§1.3): it may spin."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.system import System
from flowlanes.system.vectors import cross, norm_squared, real_symbol, vectors

from .any_shape import (
    INERTIA,
    SHAPE,
    contact_kinematics,
    energy,
    inverse,
    kinematics,
    on_sphere,
)

omega, gamma, M, r, rdot, torque = vectors("omega gamma M r rdot torque")
m, a = real_symbol("m"), real_symbol("a")


def any_marble_body(curvature: sp.Expr = sp.S.Zero) -> System:
    """A marble body of arbitrary support function h and potential U on a plane or a sphere.

    Parameters
    ----------
    curvature : sympy.Expr
        1/a of the supporting sphere in a symbol, which becomes a parameter; zero for a plane.

    Returns
    -------
    System
        State M = Ĩω, γ (body axes), with Ṁ = M×ω + m ṙ×(ω×r) and the couple of U.
    """
    contact = contact_kinematics(curvature)
    return System(
        name=f"any-marble-body-on-{contact.where}",
        title=f"Marble body of any shape on a {contact.where}",
        field={
            M: cross(M, omega) + m * cross(rdot, cross(omega, r)) + torque,
            gamma: contact.gammadot,
        },
        definitions=(*SHAPE, *INERTIA, (omega, inverse(M)), *contact.definitions),
        parameters=contact.parameters,
        relations=(norm_squared(gamma) - 1,),
        laws=(energy(),),
        source="(1.17) with λ₀ = 0",
    )


def general() -> System:
    """Any shape and potential on a plane."""
    return any_marble_body()


def general_on_sphere() -> System:
    """Any shape and potential on a sphere of radius a."""
    return any_marble_body(1 / a).with_laws(kinematics(1 / a))


ENTRIES = (on_sphere("marble", general_on_sphere),)
