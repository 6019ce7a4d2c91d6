"""The Chaplygin ball together with its whole orientation (§7.2)."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import cross, dot, norm_squared, vectors, zero

from .chaplygin_bracket import DET_IQ, PARAMETERS, TENSORS, A, D

M, alpha, beta, gamma, omega = vectors("M alpha beta gamma omega")

TITLE = "Chaplygin ball with its orientation"
SUMMARY = (
    "The Chaplygin ball with all three axes of space as vectors in body axes: without a field the "
    "momentum about the contact point is constant in space."
)
SOURCE = "§7.2"

#: ω = I_Q⁻¹M.
SPIN = A * M + D * dot(A * gamma, M) / (1 - D * dot(gamma, A * gamma)) * (A * gamma)


def orientation(potential: sp.Expr) -> System:
    """The ball with α, β, γ, in a potential U(γ).

    α and β enter no other equation: the laws hold for any two vectors that are at rest in space,
    not only for two that are orthonormal with γ.
    """
    slope = gradient(potential, gamma)
    torque = zero if potential == 0 else cross(gamma, slope)
    laws = [
        Integral("energy", dot(M, omega) / 2 + potential, "energy", source="(7.2)", unit="J"),
        Integral("area", dot(M, gamma), "area integral", source="(7.2)", unit="kg m^2/s"),
        Measure("measure", {DET_IQ: -sp.Rational(1, 2)}, "invariant measure", source="(7.3)"),
    ]
    if potential == 0:
        laws += [
            Integral(
                name,
                dot(M, axis),
                f"momentum about the {place} axis of space",
                source="§7.2",
                unit="kg m^2/s",
            )
            for name, axis, place in (("along_x", alpha, "first"), ("along_y", beta, "second"))
        ]
    return System(
        name="chaplygin-ball-unreduced",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=PARAMETERS,
        definitions={**TENSORS, omega: SPIN},
        field={
            M: cross(M, omega) + torque,
            alpha: cross(alpha, omega),
            beta: cross(beta, omega),
            gamma: cross(gamma, omega),
        },
        relations=(norm_squared(gamma) - 1,),
        laws=tuple(laws),
    )


def general_system() -> System:
    """The ball in an arbitrary potential U(γ)."""
    return orientation(sp.Function("U")(*gamma.symbols))
