"""The separated equations of the hollow ball around a sphere, proven in its coordinates.

Written out in M and n the separated equations are too long to be reduced.  In the coordinates
u = ½T − z of `nonholonomic.catalogue.ball_on_sphere.ball_around_sphere_coordinates`, moving at
arbitrary rates v₁, v₂, they are short: every motion passes through such instants, n being a
function of u, and ω of n and ṅ.  There it is proven that

    (u₁ − u₂)² L(u₂) u̇₁² = 4u₂² p(u₁) S ((M, ω) z₁ L(u₁) − M² Q(u₁)),

and here that the right-hand side, times det I_Q/L(u₂), is (b − a z₂)² y²(z₁).
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Identity
from flowlanes.system.system import Parameter, System
from nonholonomic.catalogue.ball_on_sphere import ball_around_sphere_coordinates as instant
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem
from nonholonomic.closed_form.separations.ball_sphere import f, h


def in_coordinates(of: SeparatedSystem) -> System:
    """An instant of any motion in the coordinates, with the laws that make up the separation.

    Parameters
    ----------
    of : SeparatedSystem
        Of the ball by its tensor A and d; h and f stand for any numbers here.

    Returns
    -------
    System
        State u₁, u₂; the laws of `ball_around_sphere_coordinates.coordinates`, that n is
        the unit vector with the poles and weights of `of`, and that its curve is the right one.
    """
    system = instant.coordinates_around_sphere()
    constants = (
        Parameter(h, "energy", 1.0, "J"),
        Parameter(f, "square of the momentum", 3.0, "kg^2 m^4/s^2"),
    )
    return replace(
        system,
        parameters=(*system.parameters, *constants),
        laws=(*system.laws, _direction(of), _curve(of)),
    )


def _direction(of: SeparatedSystem) -> Identity:
    """n_i² S = weights_i (e_i − z₁)(e_i − z₂)."""
    first, second = (instant.tau - u for u in instant.u)
    squares = zip(instant.square.symbols, of.poles, of.weights, strict=True)
    return Identity(
        "direction",
        tuple(instant.S * s - weight * (e - first) * (e - second) for s, e, weight in squares),
        "the normal by its separated variables",
        source="§8.3",
    )


def _curve(of: SeparatedSystem) -> Identity:
    """The law that y² of the curve drives each coordinate."""
    a, b = of.speeds
    differences = []
    for here, there in (instant.u, instant.u[::-1]):
        z, other = instant.tau - here, instant.tau - there
        scale, ratio = instant.scale(here), instant.ratio_form(here)
        driven = 4 * there**2 * instant.cubic(here) * instant.S * (2 * h * z * scale - f * ratio)
        curve = of.leading * sp.Mul(*(z - root for root in of.roots))
        differences.append(
            instant.det * driven / instant.scale(there) - (b - a * other) ** 2 * curve
        )
    return Identity(
        "curve", tuple(differences), "the curve of the separated equations", source="§8.3"
    )
