"""Quadratic integrals in the potentials (γ, Jγ)^(−s) on a sphere.

An integral of ½M² + V on the sphere that is quadratic in M has the form ½(M, CM) + W(γ) with a
constant symmetric C, since the Killing tensors of the sphere are symmetric products of rotation
fields. It is conserved if (∇W×γ) + C(γ×∇V) has no tangential part. The divergence of ∇W×γ on the
sphere is zero, so that the divergence of C(γ×∇V) must vanish as well: a linear condition on C,
which is satisfied trivially by C = E (the energy). If V is extended as a homogeneous function of
degree zero, it reads

    div (C(γ×∇V)) = 2 (γ, C(γ×∇V)) / γ².
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.named_formulas import scalars
from flowlanes.system.vectors import Diagonal, real_symbol, vectors
from lawproof.proof.verdict import Verdict

from .derived_verdicts import computed_verdict

J = Diagonal("J")
(gamma,) = vectors("gamma")
s = real_symbol("s")
C_11, C_22, C_12, C_13, C_23 = sp.symbols("C_11 C_22 C_12 C_13 C_23", real=True)


def conditions() -> list[sp.Expr]:
    """The linear conditions on C (with C_33 = 0) for V = (γ, Jγ)^(−s), divided by s."""
    place = sp.Matrix(gamma.symbols)
    form = sp.Add(*(j * x**2 for j, x in zip(J.symbols, place, strict=True)))
    square = sp.Add(*(x**2 for x in place))
    # ∇V/V for V = (form/square)^(−s), which is homogeneous of degree zero.
    slope = sp.Matrix(
        [-2 * s * x * (j / form - 1 / square) for j, x in zip(J.symbols, place, strict=True)]
    )
    tensor = sp.Matrix([[C_11, C_12, C_13], [C_12, C_22, C_23], [C_13, C_23, 0]])
    turned = tensor * sp.Matrix(scalars(place)).cross(slope)
    divergence = sp.Add(*(sp.diff(turned[i], place[i]) for i in range(3))) + slope.dot(turned)
    excess = divergence - 2 * place.dot(turned) / square
    numerator = sp.numer(sp.together(excess / s))
    coefficients: list[sp.Expr] = sp.Poly(sp.expand(numerator), *place).coeffs()
    return coefficients


def no_quadratic_integral() -> Verdict:
    """The verdict that C is a multiple of E unless s² = 1, for J with distinct eigenvalues.

    Returns
    -------
    Verdict
        Proven if each off-diagonal entry of C occurs alone in some condition, with a factor that
        vanishes only for equal J, and if two conditions on C₁₁ and C₂₂ have the determinant (s² −
        1) times such a factor.
    """
    equations = conditions()
    J_1, J_2, J_3 = J.symbols
    differences = {
        C_23: J_1 * (J_2 - J_3),
        C_13: J_2 * (J_1 - J_3),
        C_12: J_3 * (J_1 - J_2),
    }
    single = all(
        any(sp.expand(c - factor * entry * sign) == 0 for c in equations for sign in (2, -2))
        for entry, factor in differences.items()
    )
    diagonal = [c for c in equations if c.free_symbols & {C_11, C_22}]
    wanted = (s**2 - 1) * (J_1 - J_2) ** 2 * (J_2 - J_3) * (J_1 - J_3)
    regular = any(
        sp.simplify(_determinant(a, b) / wanted).is_number
        for i, a in enumerate(diagonal)
        for b in diagonal[:i]
        if sp.expand(_determinant(a, b)) != 0
    )
    proven = single and regular
    return computed_verdict(
        "no quadratic integral",
        proven,
        "the conditions on C have only C ~ E as solution unless s² = 1 or two J are equal",
        "the conditions do not have the expected form",
    )


def _determinant(first: sp.Expr, second: sp.Expr) -> sp.Expr:
    """Determinant of two linear forms in C₁₁ and C₂₂."""
    return sp.diff(first, C_11) * sp.diff(second, C_22) - sp.diff(first, C_22) * sp.diff(
        second, C_11
    )
