"""A new shape: a rounded die, the support function R + ε(ν₁⁴ + ν₂⁴ + ν₃⁴)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Diagonal, constant, dot, real_symbol
from nonholonomic.mechanics.shapes.gauss_map import GaussMap
from nonholonomic.mechanics.shapes.kinematics import gamma
from nonholonomic.mechanics.shapes.shape_base import (
    SupportShape,
    check_centre,
    convexity,
    length,
    require_positive,
)

R, eps, G = real_symbol("R"), real_symbol("epsilon"), Diagonal("G")


@dataclass(frozen=True)
class Die(SupportShape):
    """A rounded die; corners stand out where `corners` is negative."""

    radius: float
    corners: float = 0.0

    kind = "die"

    def __post_init__(self) -> None:
        require_positive("die", radius=self.radius)
        check_centre(self.centre)

    def gauss(self) -> GaussMap:
        """The gradient of the support function, of degree one, and its second derivative."""
        squares = [s**2 for s in gamma.symbols]
        fourth = sp.Add(*(s**2 for s in squares))
        even, uneven = R - 3 * eps * fourth, 12 * eps * (1 - fourth)
        product, total = (
            even**2 + even * uneven + 432 * eps**2 * sp.Mul(*squares),
            2 * even + uneven,
        )
        return GaussMap(
            parameters=(
                length(R, "size of the die", self.radius),
                Parameter(eps, "how far its faces stand out", self.corners, "m"),
            ),
            definitions=((G, constant(sp.diag(*squares))),),
            reach=-even * gamma - 4 * eps * (G * gamma),
            spread=lambda u: even * u + 12 * eps * (G * u) - (12 * eps * dot(G * gamma, u)) * gamma,
            trace=total,
            determinant=product,
            support=R + eps * fourth,
            guards=convexity(product, total),
        )
