"""A quadratic integral preserved by rotors and by Bruns' field, but not by both together.

For the Chaplygin ball, F = |M + k|² − K det J (γ, J⁻¹γ) is an integral for K = 0 (Markeev) and for
k = 0 (Kozlov). In general its rate is 2K(k, γ×Iγ): this is proven as an identity, and F is refuted
at a point. The same holds for the Veselova system and for the ball around a sphere, whose rate has
the ratio of the radii as a factor.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from nonholonomic.catalogue import from_catalogue

M, omega, gamma, k = vectors("M omega gamma k")
I, J = Diagonal("I"), Diagonal("J")
K, ratio = real_symbol("K"), real_symbol("k")


def field_part(tensor: Diagonal) -> sp.Expr:
    """K det J (γ, J⁻¹γ) without an inverse."""
    a, b, c = tensor.symbols
    x, y, z = gamma.symbols
    return K * (b * c * x**2 + a * c * y**2 + a * b * z**2)


def cases() -> dict[str, tuple[System, sp.Expr, sp.Expr]]:
    """Systems with the lost integral and its rate."""
    torque = 2 * K * to_components(dot(k, cross(gamma, I * gamma)))
    total = I * omega + k
    return {
        "Chaplygin ball": (
            from_catalogue("chaplygin-ball-gyrostat-bruns"),
            to_components(norm_squared(M + k)) - field_part(J),
            torque,
        ),
        "Veselova system": (
            from_catalogue("veselova-gyrostat-bruns"),
            to_components(norm_squared(cross(total, gamma))) - field_part(I),
            torque,
        ),
        "ball around a sphere": (
            from_catalogue("ball-around-sphere-gyrostat-bruns"),
            to_components(norm_squared(M + k)) - field_part(J),
            ratio * torque,
        ),
    }


def integral_of(name: str) -> tuple[System, Integral]:
    """The lost integral of one of the `cases`, with its system."""
    system, value, _ = cases()[name]
    return system, Integral("lost", value)
