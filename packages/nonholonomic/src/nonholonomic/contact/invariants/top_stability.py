"""Stability of a tippe top that spins about its vertical axis, with viscous friction (§11.3).

The top spins with the angular velocity n about its axis of symmetry e, which is vertical; c is the
distance of the centre of the sphere from the centre of mass, positive where it lies above it.  Let
η be the horizontal part of e and V that of the velocity of the centre of mass, as complex numbers.
To first order the slip is u = V + (c − R) η̇ + iRnη and the friction −κu, with κ = νmg for a force
−νN u; and

    m V̇ = −κ u,      I₁ η̈ − i I₃ n η̇ + mgc η + (c − R) κ u = 0.

Solutions e^{λt} obey P(λ) = 0,

    P(λ) = (mλ + κ)(I₁λ² − i I₃ n λ + mgc) + (c − R) κ m λ ((c − R)λ + iRn).

All roots have negative real parts exactly if the Hermitian form of P is positive definite; with
b = R − c its minors are 2 κ m I₁ (I₁ + mb²), 4 κ² m³ I₁ [(I₁ + mb²) T + n² (I₁R − I₃b)²] and
8 κ³ m⁷ I₁ c² g² b² T, where

    T = mgcb² − n² R (I₁R − I₃b),

so that the rotation is stable for T > 0 and unstable for T < 0, for every κ > 0.  With α = c/R and
Jellett's integral J = I₃ n b this is J² (I₁/I₃ − 1 + α) < mgR³ I₃ α (1 − α)⁴.
"""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol

from .sliding_top import I_1, I_3, R, c, g, gamma, m, nu, omega, v

n, kappa, rate = real_symbol("n"), real_symbol("kappa"), sp.Symbol("lambda")
#: The components that rotate about the vertical: 1 and 2 of v, ω and γ.
ACROSS = tuple(s for vector in (v, omega, gamma) for s in vector.symbols[:2])


def characteristic_polynomial(root: sp.Expr = rate, unit: sp.Expr = sp.I) -> sp.Expr:
    """P(λ); with −i for the imaginary unit, that with conjugate coefficients."""
    swing = I_1 * root**2 - unit * I_3 * n * root + m * g * c
    slide = (c - R) * kappa * m * root * ((c - R) * root + unit * R * n)
    return (m * root + kappa) * swing + slide


def stability_margin() -> sp.Expr:
    """T = mgc(R − c)² − n²R(I₁R − I₃(R − c)), positive where the rotation is stable."""
    return m * g * c * (R - c) ** 2 - n**2 * R * (I_1 * R - I_3 * (R - c))


@lru_cache(maxsize=1)
def hermitian_minors() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The leading principal minors of the Hermitian form of P, starting with the highest power.

    The form has the coefficients of [P(x)P̄(y) − P̄(−x)P(−y)]/(x + y).
    """
    x, y = sp.symbols("x y")
    product = characteristic_polynomial(x) * characteristic_polynomial(y, -sp.I)
    mirrored = characteristic_polynomial(-x, -sp.I) * characteristic_polynomial(-y)
    quotient, rest = sp.div(sp.Poly(sp.expand(product - mirrored), x), sp.Poly(x + y, x))
    if sp.expand(rest.as_expr()) != 0:
        raise ArithmeticError("the polynomial of the Hermitian form is not divisible by x + y")
    form = sp.Poly(sp.expand(quotient.as_expr()), x, y)
    matrix = sp.Matrix(3, 3, lambda j, k: form.coeff_monomial(x**j * y**k))
    first, second, third = (sp.expand(matrix[j:, j:].det()) for j in (2, 1, 0))
    return first, second, third


def expected_minors() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The minors as products; they show that the form is positive exactly if T is."""
    b, margin = R - c, stability_margin()
    carried = I_1 + m * b**2
    return (
        2 * kappa * m * I_1 * carried,
        4 * kappa**2 * m**3 * I_1 * (carried * margin + n**2 * (I_1 * R - I_3 * b) ** 2),
        8 * kappa**3 * m**7 * I_1 * c**2 * g**2 * b**2 * margin,
    )


def linearisation(system: System) -> sp.ImmutableMatrix:
    """The matrix (3, 3) of a sliding top's equations about the vertical rotation.

    Parameters
    ----------
    system : System
        A sliding top whose friction vanishes with the slip, of first order in it.

    Returns
    -------
    sympy.ImmutableMatrix
        For v₁ + iv₂, ω₁ + iω₂ and γ₁ + iγ₂ in the axes of the body, which turn with n.

    Raises
    ------
    ArithmeticError
        If the equations are not symmetric about the axis, or the rotation is no steady motion.
    """
    steady = dict.fromkeys(system.symbols, sp.S.Zero)
    steady |= {omega.symbols[2]: n, gamma.symbols[2]: sp.S.One}
    rates = dict(zip(system.symbols, system.rates, strict=True))
    slope = sp.Matrix(6, 6, lambda j, k: 0)
    needed, epsilon = _required_definitions(system), sp.Symbol("epsilon")
    for column, symbol in enumerate(ACROSS):
        nearby = {s: value + (epsilon if s == symbol else 0) for s, value in steady.items()}
        known = dict(nearby)
        for name, formula in system.scalar_definitions:
            if name in needed:
                known[name] = sp.together(formula.subs(known))
        for row, other in enumerate(ACROSS):
            rate = rates[other].subs(known)
            if sp.simplify(rate.subs(epsilon, 0)) != 0:
                raise ArithmeticError(f"the rate of {other} does not vanish in the rotation")
            slope[row, column] = sp.simplify(sp.diff(rate, epsilon).subs(epsilon, 0))
    return _complex(slope)


def _required_definitions(system: System) -> set[sp.Symbol]:
    """The definitions on which the rates depend."""
    return {name for name, _ in system.required_definitions(system.rates)}


def _complex(slope: sp.Matrix) -> sp.ImmutableMatrix:
    """A real matrix (6, 6) of blocks [[a, −b], [b, a]] as a complex one of a + ib."""
    entries = []
    for j in range(3):
        for k in range(3):
            block = slope[2 * j : 2 * j + 2, 2 * k : 2 * k + 2]
            if sp.simplify(block[0, 0] - block[1, 1]) != 0 or sp.simplify(
                block[0, 1] + block[1, 0]
            ):
                raise ArithmeticError("the equations are not symmetric about the axis")
            entries.append(block[0, 0] + sp.I * block[1, 0])
    return sp.ImmutableMatrix(3, 3, entries)


def characteristic_difference(system: System) -> sp.Expr:
    """det(λ − in − M) m I₁ less P(λ), for the linearised equations M with κ = νmg; zero."""
    matrix = linearisation(system)
    determinant = ((rate - sp.I * n) * sp.eye(3) - matrix).det() * m * I_1
    polynomial = characteristic_polynomial().subs(kappa, nu * m * g)
    return sp.simplify(sp.expand(determinant - polynomial))
