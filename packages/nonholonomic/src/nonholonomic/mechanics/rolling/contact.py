"""Kinematics of the contact: the rates of contact point and normal.

Without slip the material point at the contact is at rest, so that the contact point wanders over
the body (rate ṙ, body axes) as fast as over the surface.  On a sphere of signed radius a this
reads γ̇ + ω×γ = ṙ/a for every shape; a plane is the limit a → ∞.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import (
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    zero,
)

from ..shapes.implicit import IMPLICIT_GRADIENT, IMPLICIT_HESSIAN, IMPLICIT_POINT, Implicit
from ..shapes.shape_base import GaussMap, convexity
from ..shapes.shapes import Ball, Shape
from ..shapes.surfaces import Plane, Sphere, Surface

omega = Vector("omega")
gamma = Vector("gamma")
r = Vector("r")
rdot = Vector("rdot")
gammadot = Vector("gammadot")
a = real_symbol("a")


@dataclass(frozen=True)
class Contact:
    """The contact of a body with a surface, as formulas in ω and the position.

    Attributes
    ----------
    state : pairs
        The variables that describe the position, with their rates.
    relations : tuple of sympy.Expr
        Vanish for every position.
    parameters, definitions, guards
        As in a :class:`~flowlanes.system.system.System`.
    r, rdot, gammadot : MatrixExpr
        Contact vector and rates of contact point and normal (body axes).
    square : sympy.Expr
        (r, r), with γ² = 1 used where it shortens.
    height : sympy.Expr
        −(r, γ), the height of the centre of mass above the tangent plane.
    spread : callable
        u ↦ W u for a vector u of the tangent plane; ṙ = −W γ̇.
    pull : callable
        ∂U/∂γ ↦ the vector whose product γ× is the torque of a potential U(γ).
    """

    state: Pairs
    relations: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...]
    definitions: Pairs
    guards: tuple[Guard, ...]
    r: MatrixExpr
    rdot: MatrixExpr
    gammadot: MatrixExpr
    square: sp.Expr
    height: sp.Expr
    spread: Callable[[MatrixExpr], MatrixExpr]
    pull: Callable[[MatrixExpr], MatrixExpr]


def contact(
    shape: Shape, surface: Surface, slip: MatrixExpr = zero, radius: sp.Expr = a
) -> Contact:
    """The contact of `shape` with `surface`.

    Parameters
    ----------
    shape : Shape
    surface : Plane or Sphere
    slip : MatrixExpr
        Velocity of the touching particle of the body over a surface at rest, body axes; it is
        tangential, and zero without slip.
    radius : sympy.Expr
        Signed radius of the supporting sphere; that of a concentric sphere through the nearest
        point of the body if this is in flight.

    Raises
    ------
    InputError
        If a ball does not fit into the sphere, or a hollow one not around it.  For other
        shapes this depends on the point of contact, and a guard checks it.
    """
    # γ̇ without the curvature of the body: its rotation, and its way over the surface
    swing = cross(gamma, omega)
    if isinstance(surface, Sphere):
        swing = swing + slip / radius
    if isinstance(shape, Implicit):
        return _through_surface(shape, surface, swing, radius)
    if isinstance(shape, Ball):
        return _of_ball(shape, surface, swing, radius)
    return _through_gauss_map(shape, shape.gauss(), surface, swing, radius)


def _sphere_parameters(surface: Surface) -> tuple[Parameter, ...]:
    if isinstance(surface, Plane):
        return ()
    meaning = "radius of the supporting sphere, negative inside"
    return (Parameter(a, meaning, surface.signed_radius, "m", (sp.Ne(a, 0),)),)


def _fits(product: sp.Expr, total: sp.Expr) -> tuple[Guard, Guard]:
    """Product and sum of 1 + R₁/a and 1 + R₂/a, up to positive factors."""
    message = "the body does not fit into the sphere at the contact"
    return Guard("fits", product, message), Guard("fits", total, message)


def _check_ball(shape: Ball, surface: Surface) -> None:
    """Refuse a ball larger than its bowl, and a hollow one that goes around nothing."""
    around = surface.signed_radius if isinstance(surface, Sphere) else None
    if shape.hollow and (around is None or not 0 < around < shape.radius):
        raise InputError(
            f"hollow ball of radius {shape.radius:g}: it rolls around the outside of a sphere of "
            "positive, smaller radius"
        )
    if not shape.hollow and around is not None and -shape.radius <= around < 0:
        raise InputError(
            f"ball of radius {shape.radius:g} in a bowl of radius {-around:g}: the bowl must be "
            "the larger one"
        )


def _of_ball(shape: Ball, surface: Surface, swing: MatrixExpr, a: sp.Expr) -> Contact:
    """A ball: γ̇ = k γ×ω with k = a/(a + R), and ṙ a multiple of it."""
    _check_ball(shape, surface)
    ball = shape.gauss()
    c = shape.offset
    definitions: Pairs = ()
    rate, pull = swing, lambda force: force
    if isinstance(surface, Sphere):
        k = real_symbol("k")
        definitions = ((k, a / (a + ball.support)),)
        rate, pull = k * rate, lambda force: k * force
    reach, square = ball.reach, ball.determinant
    if any(shape.centre):
        definitions += ((r, c + ball.reach),)
        reach, square = r, norm_squared(r)
    return Contact(
        state=((gamma, rate),),
        relations=(norm_squared(gamma) - 1,),
        parameters=ball.parameters + shape.offset_parameters + _sphere_parameters(surface),
        definitions=definitions,
        guards=(),
        r=reach,
        rdot=-ball.spread(rate),
        gammadot=rate,
        square=square,
        height=ball.support - dot(c, gamma),
        spread=ball.spread,
        pull=pull,
    )


def _through_gauss_map(
    shape: Shape, body: GaussMap, surface: Surface, swing: MatrixExpr, a: sp.Expr
) -> Contact:
    """A shape with r(γ): γ̇ (E + W/a) = γ×ω on the tangent plane."""
    definitions = (*body.definitions, (r, shape.offset + body.reach))
    guards = body.guards
    if isinstance(surface, Plane):
        rate: MatrixExpr = swing
        pull = lambda force: force  # noqa: E731
    else:
        # inverse of a symmetric operator of the plane by Cayley and Hamilton
        area = real_symbol("A_a")
        definitions += ((area, a**2 + a * body.trace + body.determinant),)
        trace = real_symbol("tau")
        definitions += ((trace, body.trace),)

        def solve(vector: MatrixExpr) -> MatrixExpr:
            return ((a**2 + a * trace) / area) * vector - (a / area) * body.spread(vector)

        definitions += ((gammadot, solve(swing)),)
        rate, pull = gammadot, solve
        guards += _fits(area, 2 * a**2 + a * trace)
    definitions += ((rdot, -body.spread(rate)),)
    return Contact(
        state=((gamma, rate),),
        relations=(norm_squared(gamma) - 1,),
        parameters=body.parameters + shape.offset_parameters + _sphere_parameters(surface),
        definitions=definitions,
        guards=guards,
        r=r,
        rdot=rdot,
        gammadot=rate,
        square=norm_squared(r),
        height=body.support - dot(shape.offset, gamma),
        spread=body.spread,
        pull=pull,
    )


def _through_surface(shape: Implicit, surface: Surface, swing: MatrixExpr, a: sp.Expr) -> Contact:
    """A shape f(r − c) = 0 with the state r: (S + E/a) ṙ = −γ×ω, S of f."""
    x = IMPLICIT_POINT
    coordinates = dict(zip(shape.coordinates, x.symbols, strict=True))
    f = shape.surface.xreplace(coordinates)
    slope, ell = IMPLICIT_GRADIENT, real_symbol("ell")
    F, G = IMPLICIT_HESSIAN, Symmetric("G")
    hessian = constant(sp.hessian(f, x.symbols))
    mean, gauss = real_symbol("sigma"), real_symbol("kappa")
    trace = sp.Add(*(F.entries[i, i] for i in range(3)))
    definitions: Pairs = (
        (x, r - shape.offset),
        (slope, constant([sp.diff(f, s) for s in x.symbols])),
        (ell, sp.sqrt(norm_squared(slope))),
        (gamma, -slope / ell),
        (F, hessian),
        (G, constant(F.entries.adjugate())),
        (mean, (trace - dot(gamma, F * gamma)) / ell),
        (gauss, dot(gamma, G * gamma) / ell**2),
    )

    def shape_operator(vector: MatrixExpr) -> MatrixExpr:
        return (F * vector - dot(gamma, F * vector) * gamma) / ell

    if isinstance(surface, Plane):
        definitions += ((rdot, (shape_operator(swing) - mean * swing) / gauss),)
        rate: MatrixExpr = swing
        pull = lambda force: force  # noqa: E731
        guards: tuple[Guard, ...] = ()
    else:
        area = real_symbol("A_a")
        definitions += ((area, gauss + mean / a + 1 / a**2),)

        def solve(vector: MatrixExpr) -> MatrixExpr:
            """The inverse of S + E/a on tangent vectors."""
            return (1 / area) * ((mean + 1 / a) * vector - shape_operator(vector))

        definitions += ((rdot, -solve(swing)), (gammadot, swing + rdot / a))
        rate = gammadot
        pull = lambda force: force - solve(force - dot(gamma, force) * gamma) / a  # noqa: E731
        guards = _fits(area * a**2, mean + 2 / a)
    convex = convexity(gauss, mean)
    return Contact(
        state=((r, rdot),),
        relations=(_on_surface(f, x, shape),),
        parameters=shape.parameters + shape.offset_parameters + _sphere_parameters(surface),
        definitions=definitions,
        guards=(*convex, *guards),
        r=r,
        rdot=rdot,
        gammadot=rate,
        square=norm_squared(r),
        height=-dot(r, gamma),
        spread=lambda u: (mean * u - shape_operator(u)) / gauss,
        pull=pull,
    )


def _on_surface(f: sp.Expr, x: Vector, shape: Implicit) -> sp.Expr:
    """F as a function of the state r."""
    offset = shape.offset
    shift = (0, 0, 0) if not isinstance(offset, Vector) else offset.symbols
    return f.xreplace({s: t - d for s, t, d in zip(x.symbols, r.symbols, shift, strict=True)})
