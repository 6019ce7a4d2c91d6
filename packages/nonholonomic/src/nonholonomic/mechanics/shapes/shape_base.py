"""The inverse Gauss map of a convex shape, and checks that all shapes share.

A shape is described by its support function h(ν), the distance of the tangent plane with outward
normal ν from the geometric centre.  The contact point with ν = −γ is ∇h, and its derivative,
the *spread* W = ∂²h, is a symmetric operator on the tangent plane whose eigenvalues are the
principal radii of curvature.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector, real_symbol, zero

c = Vector("c")


@dataclass(frozen=True)
class GaussMap:
    """A shape seen through its inverse Gauss map, as formulas in γ.

    Attributes
    ----------
    parameters : tuple of Parameter
    definitions : pairs
        Named intermediate quantities used below.
    reach : MatrixExpr
        From the geometric centre to the contact point (body axes).
    spread : callable
        u ↦ W u for a vector u of the tangent plane; the rate of `reach` is −W γ̇.
    trace, determinant : sympy.Expr
        Sum and product of the principal radii of curvature at the contact.
    support : sympy.Expr
        Height of the geometric centre above the tangent plane.
    guards : tuple of Guard
    """

    parameters: tuple[Parameter, ...]
    definitions: Pairs
    reach: MatrixExpr
    spread: Callable[[MatrixExpr], MatrixExpr]
    trace: sp.Expr
    determinant: sp.Expr
    support: sp.Expr
    guards: tuple[Guard, ...] = ()


def convexity(product: sp.Expr, total: sp.Expr) -> tuple[Guard, Guard]:
    """Guards on product and sum of the principal curvatures, both positive."""
    message = "the contact leaves the convex part of the body"
    return Guard("convex", product, message), Guard("convex", total, message)


def length(symbol: sp.Symbol, meaning: str, value: float) -> Parameter:
    """A positive length as a parameter."""
    return Parameter(symbol, meaning, value, "m", (symbol > 0,))


def require_positive(shape: str, **lengths: float) -> None:
    """Raise InputError unless all lengths are positive."""
    for name, value in lengths.items():
        if not (math.isfinite(value) and value > 0):
            raise InputError(f"{name} {value} of the {shape}: it must be a positive finite number")


def real_values(
    values: Iterable[tuple[sp.Symbol, float]] | Mapping[sp.Symbol, float],
) -> tuple[tuple[sp.Symbol, float], ...]:
    """Values by real symbols, whatever else was assumed of these."""
    return tuple((real_symbol(str(symbol)), value) for symbol, value in dict(values).items())


def check_values(values: tuple[tuple[sp.Symbol, float], ...]) -> None:
    """Raise InputError unless every parameter of a formula has a finite value."""
    for symbol, value in values:
        if not math.isfinite(value):
            raise InputError(f"parameter {symbol} = {value}: it must be a finite number")


def require_symbols(
    what: str, used: set[sp.Symbol], symbols: set[sp.Symbol], variables: str
) -> None:
    """Raise InputError if a formula uses a symbol that is not known."""
    unknown = sorted(map(str, used - symbols))
    if unknown:
        raise InputError(
            f"{what}: {', '.join(unknown)} is not known; it may use {variables} and the "
            "parameters of the shape"
        )


def check_centre(centre: tuple[float, float, float]) -> None:
    """Raise InputError unless a centre is three finite numbers."""
    if len(centre) != 3 or not all(math.isfinite(x) for x in centre):
        raise InputError(f"centre {centre}: it must be three finite numbers")


@dataclass(frozen=True)
class CentredShape:
    """Common to all shapes: `centre` is the geometric centre minus the centre of mass."""

    centre: tuple[float, float, float] = field(default=(0.0, 0.0, 0.0), kw_only=True)

    @property
    def offset(self) -> MatrixExpr:
        """The vector c from the centre of mass to the geometric centre, or zero."""
        return c if any(self.centre) else zero

    @property
    def offset_parameters(self) -> tuple[Parameter, ...]:
        """The components of c, if it is not zero."""
        if not any(self.centre):
            return ()
        return tuple(
            Parameter(s, f"geometric centre minus centre of mass, body axis {i}", x, "m")
            for i, (s, x) in enumerate(zip(c.symbols, self.centre, strict=True), 1)
        )
