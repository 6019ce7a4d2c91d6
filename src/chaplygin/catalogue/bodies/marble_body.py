"""A marble body of any convex shape on a plane and on a sphere (§1.3): it may spin."""

from __future__ import annotations

import sympy as sp

from ...core.system import System
from ...core.vectors import cross, norm_squared, real_symbol, vectors
from ...mechanics.rolling.equations import Forces, Rolling
from ...mechanics.rolling.surfaces import Sphere
from ..entry import Entry, Numbers, Start
from .any_shape import ELLIPSOID, INERTIA, SHAPE, ellipsoid, energy, inverse, kinematics, touch

__all__ = ["ENTRIES", "any_marble_body", "general", "general_on_sphere"]

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
    contact = touch(curvature)
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


def build(p: Numbers) -> Rolling:
    """A heavy ellipsoid with three different axes and its centre of mass away from its centre."""
    return Rolling(ellipsoid(p), field=Forces(p["g"]))


def build_on_sphere(p: Numbers) -> Rolling:
    """The same body on a sphere, without gravity."""
    return Rolling(ellipsoid(p), Sphere.of_signed_radius(p["a"]))


def general() -> System:
    """Any shape and potential on a plane."""
    return any_marble_body()


def general_on_sphere() -> System:
    """Any shape and potential on a sphere of radius a."""
    return any_marble_body(1 / a).with_laws(kinematics(1 / a))


_START = Start(omega=(0.7, 0.4, 1.1), gamma=(0.2, -0.3, 0.93), until=30.0)

ENTRIES = (
    Entry(
        name="marble-body",
        title="Marble body on a plane",
        summary="A heavy body of any convex shape, here an ellipsoid, rolls on a horizontal plane "
        "without slipping; it may spin about the vertical.",
        source="§1.3, (1.17) with λ₀ = 0",
        defaults={**ELLIPSOID, "g": 9.81},
        build=build,
        start=_START,
        general=general,
    ),
    Entry(
        name="marble-body-on-sphere",
        title="Marble body on a sphere",
        summary="A body of any convex shape, here an ellipsoid, rolls without slipping on a fixed "
        "sphere of radius a, outside (a > 0) or inside (a < 0); it may spin about the normal.",
        source="§1.3, (1.17) with λ₀ = 0; (1.23)",
        defaults={**ELLIPSOID, "a": 5.0},
        build=build_on_sphere,
        start=_START,
        general=general_on_sphere,
    ),
)
