"""Kinematics of a contact: the quantities that shapes and surfaces exchange.

Without slip the material point at the contact is at rest, so that the contact point moves over the
body (rate ṙ, body axes) with the same velocity as over the surface. With the spread W of the body,
ṙ = −Wγ̇, and the operator K of the curvature of the surface, which takes a velocity of the contact
over the surface to the rate of its normal, this reads for every shape and surface

    γ̇ + ω×γ = K ṙ,      (E + KW) γ̇ = γ×ω + K u,

u the slip.  On a plane K = 0, on a sphere of signed radius a it is E/a.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector, real_symbol

Operator: TypeAlias = Callable[[MatrixExpr], MatrixExpr]

omega, gamma, zeta = Vector("omega"), Vector("gamma"), Vector("zeta")
r, rdot, gammadot = Vector("r"), Vector("rdot"), Vector("gammadot")
a = real_symbol("a")


@dataclass(frozen=True)
class Contact:
    """The contact of a body with a surface, as formulas in ω and the position.

    Attributes
    ----------
    state : pairs
        The variables that describe the position, with their rates.
    relations : tuple of sympy.Expr
        Expressions that vanish for every position.
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
    volume : tuple of sympy.Expr
        Position-dependent factors of the volume form in the position variables.
    start : pairs
        Initial values of the position variables other than γ and r, in terms of the attitude.
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
    spread: Operator
    pull: Operator
    volume: tuple[sp.Expr, ...] = ()
    start: Pairs = ()


@dataclass(frozen=True)
class NormalMotion:
    """The rate of the normal γ of a surface, as a body moves over it.

    Attributes
    ----------
    rate : MatrixExpr
        γ̇ in body axes: the solution of (E + KW) γ̇ = γ×ω + K u.
    pull : callable
        The transpose of the operator that takes γ×ω to γ̇; it takes ∂U/∂γ to the vector whose
        product γ× is the torque of a potential U(γ).
    definitions : pairs
        Named quantities used in `rate` and `pull`.
    guards : tuple of Guard
        Positive while the body fits the surface at the contact.
    volume : tuple of sympy.Expr
        Factors of the volume form in the position variables.
    state, relations, start
        Further position variables, such as a direction of the surface in body axes: their rates,
        expressions that vanish for every position, and their initial values by the attitude.
    """

    rate: MatrixExpr
    pull: Operator
    definitions: Pairs = ()
    guards: tuple[Guard, ...] = ()
    volume: tuple[sp.Expr, ...] = ()
    state: Pairs = ()
    relations: tuple[sp.Expr, ...] = ()
    start: Pairs = ()


@dataclass(frozen=True)
class LevelSurface:
    """The curvature S = W⁻¹ of a body f(r − c) = 0 at its contact.

    Attributes
    ----------
    shape_operator : callable
        u ↦ S u for a vector u of the tangent plane.
    mean, gauss : sympy.Expr
        Sum and product of its principal curvatures.
    slope : sympy.Expr
        Length of the gradient of f.
    """

    shape_operator: Operator
    mean: sp.Expr
    gauss: sp.Expr
    slope: sp.Expr

    def spread(self, vector: MatrixExpr) -> MatrixExpr:
        """W u, the inverse of S by Cayley and Hamilton."""
        return (self.mean * vector - self.shape_operator(vector)) / self.gauss


@dataclass(frozen=True)
class Placement:
    """The position of a body and its contact point in space, as formulas.

    Attributes
    ----------
    centre, point : MatrixExpr
        Centre of mass and contact point, space axes.
    field : pairs
        Position variables driven by the reduced motion, with their rates.
    relations : tuple of sympy.Expr
        Expressions that vanish for every attitude, beyond those of unit lengths and the vertical.
    """

    centre: MatrixExpr
    point: MatrixExpr
    field: Pairs = ()
    relations: tuple[sp.Expr, ...] = ()
