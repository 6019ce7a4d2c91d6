"""Convex shapes as functions of the normal: contact vector and spread, for the 1-form.

Every formula of the 1-form is made of the contact vector r, the spread W (ṙ = −Wγ̇) and, on a
sphere of radius a, K = (E + W/a)⁻¹, which maps γ×ω to γ̇.  This module provides them for every
shape as operators on all vectors that annihilate γ.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import (
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
)

from ..mechanics.shapes.kinematics import Operator, a, gamma, r
from ..mechanics.shapes.shape_base import Shape
from ..mechanics.shapes.surfaces import Surface

_X = Vector("x")


@dataclass(frozen=True)
class Geometry:
    """Contact of a body with a plane or a sphere, as formulas in the normal γ (or in r).

    Attributes
    ----------
    state : Vector
        γ, or r for a shape given by an equation.
    relations : tuple of sympy.Expr
        Expressions that vanish for every position.
    r : MatrixExpr
        From the centre of mass to the contact point, body axes.
    spread, contract : callable
        W and K as operators on all vectors, with Wγ = Kγ = 0; on a plane K is the projection.
    stretch : callable
        K⁻¹ = E + W/a on vectors of the tangent plane.
    trace : sympy.Expr
        The sum of the eigenvalues of K.
    flow : callable
        Θ ↦ the field on the sphere of normals (or on the surface of the body) whose divergence
        vanishes if and only if the 1-form (Θ, dγ) is closed.
    """

    state: Vector
    relations: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...]
    definitions: Pairs
    r: MatrixExpr
    spread: Operator
    contract: Operator
    stretch: Operator
    trace: sp.Expr
    flow: Operator


def tangent(vector: MatrixExpr) -> MatrixExpr:
    """The tangential component of a vector."""
    return vector - dot(gamma, vector) * gamma


def geometry(shape: Shape, surface: Surface) -> Geometry:
    """The contact geometry of a shape on a plane or a sphere."""
    if not surface.is_even:
        raise InputError(
            f"surface: invariant measures are known of bodies on planes and spheres, not on "
            f"{surface.words}"
        )
    f = shape.level(_X)
    if f is not None:
        return _through_surface(shape, f, surface)
    gauss = shape.gauss()

    def spread(vector: MatrixExpr) -> MatrixExpr:
        return gauss.spread(tangent(vector))

    return _with_sphere(
        surface,
        state=gamma,
        relations=(norm_squared(gamma) - 1,),
        parameters=gauss.parameters + shape.offset_parameters,
        definitions=(*gauss.definitions, (r, shape.offset + gauss.reach)),
        spread=spread,
        invariants=(gauss.trace, gauss.determinant),
        flow=lambda form: cross(gamma, form),
    )


def _with_sphere(
    surface: Surface,
    *,
    state: Vector,
    relations: tuple[sp.Expr, ...],
    parameters: tuple[Parameter, ...],
    definitions: Pairs,
    spread: Operator,
    invariants: tuple[sp.Expr, sp.Expr],
    flow: Operator,
) -> Geometry:
    """K = (E + W/a)⁻¹ by the Cayley–Hamilton theorem; the projection on a plane."""
    contract, stretch, trace = tangent, tangent, sp.Integer(2)
    parameters += surface.parameters
    if not surface.is_flat:
        tau, area = real_symbol("tau"), real_symbol("A_a")
        definitions += ((tau, invariants[0]), (area, a**2 + a * tau + invariants[1]))
        trace = (2 * a**2 + a * tau) / area

        def contract(vector: MatrixExpr) -> MatrixExpr:
            return ((a**2 + a * tau) / area) * tangent(vector) - (a / area) * spread(vector)

        def stretch(vector: MatrixExpr) -> MatrixExpr:
            return tangent(vector) + spread(vector) / a

    return Geometry(
        state, relations, parameters, definitions, r, spread, contract, stretch, trace, flow
    )


def _through_surface(shape: Shape, f: sp.Expr, surface: Surface) -> Geometry:
    """A shape f(r − c) = 0 with r as state: W is the inverse of its shape operator S."""
    x, slope, ell = _X, Vector("nu"), real_symbol("ell")
    F, G = Symmetric("F"), Symmetric("G")
    mean, gauss = real_symbol("sigma"), real_symbol("kappa")
    hessian = constant(sp.hessian(f, x.symbols))
    definitions: Pairs = (
        (x, r - shape.offset),
        (slope, constant([sp.diff(f, s) for s in x.symbols])),
        (ell, sp.sqrt(norm_squared(slope))),
        (gamma, -slope / ell),
        (F, hessian),
        (G, constant(F.entries.adjugate())),
        (mean, (sp.Add(*(F.entries[i, i] for i in range(3))) - dot(gamma, F * gamma)) / ell),
        (gauss, dot(gamma, G * gamma) / ell**2),
    )

    def shape_operator(vector: MatrixExpr) -> MatrixExpr:
        return tangent(F * tangent(vector)) / ell

    def spread(vector: MatrixExpr) -> MatrixExpr:
        return (mean * tangent(vector) - shape_operator(vector)) / gauss

    offset = shape.offset
    shift = offset.symbols if isinstance(offset, Vector) else (0, 0, 0)
    moved = {s: t - d for s, t, d in zip(x.symbols, r.symbols, shift, strict=True)}
    return _with_sphere(
        surface,
        state=r,
        relations=(f.xreplace(moved),),
        parameters=shape.parameters + shape.offset_parameters,
        definitions=definitions,
        spread=spread,
        invariants=(mean / gauss, 1 / gauss),
        # (Θ, dγ) = −(SΘ, dr); the factor ℓ = |∂f| makes the divergence in space that on the surface
        flow=lambda form: ell * cross(gamma, shape_operator(form)),
    )
