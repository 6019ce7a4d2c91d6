"""Bounds of the friction force and couple over a round patch, from the signs of series terms.

For the pressure (p + 1)N/(πa²) (1 − ρ²/a²)^p, with k = |u|/(a|Ω|), x = k² for k ≤ 1 and x = 1/k²
for k ≥ 1, the friction function φ(k) = ⟨|ke + γ×ρ/a|⟩ and the shares 𝓕 = φ′ and 𝓜 = φ − kφ′ are

    k ≤ 1:  φ = φ₀ F(−½, −p − 3/2; 1; x),    𝓕 = φ₀ (p + 3/2) k F(½, −p − ½; 2; x),
    k ≥ 1:  𝓕 = F(−½, ½; p + 2; x),          k𝓜 = F(½, ½; p + 3; x)/(2(p + 2)),

where F is the hypergeometric function and φ₀ = Γ(3/2)Γ(p + 2)/Γ(p + 5/2).  As a mean of norms φ is
convex, so that 𝓜 ≤ 𝓜(0) = φ₀.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

HALF = sp.Rational(1, 2)
#: Exponents of Hertz's pressure (a ball) and of uniform pressure (a disk on its face).
HERTZ, UNIFORM = HALF, sp.S.Zero


@dataclass(frozen=True)
class Series:
    """A hypergeometric series ₂F₁(a, b; c; x) with rational parameters, c > 0, on 0 ≤ x ≤ 1."""

    a: sp.Rational
    b: sp.Rational
    c: sp.Rational

    @property
    def sign_after_first(self) -> int:
        """The common sign of all terms after the first; zero if they all vanish.

        Raises
        ------
        ArithmeticError
            If later terms may change their sign.
        """
        if self.a + 1 < 0 or self.b + 1 < 0 or self.c <= 0:
            raise ArithmeticError("the ratio of two terms after the first may be negative")
        return int(sp.sign(self.a * self.b))

    def at_one(self) -> sp.Expr:
        """The sum at x = 1, by Gauss.

        Raises
        ------
        ArithmeticError
            If the series does not converge there.
        """
        excess = self.c - self.a - self.b
        if not excess > 0:
            raise ArithmeticError("the series does not converge at x = 1")
        above = sp.gamma(self.c) * sp.gamma(excess)
        value: sp.Expr = sp.simplify(above / sp.gamma(self.c - self.a) / sp.gamma(self.c - self.b))
        return value


def pure_spin(p: sp.Rational) -> sp.Expr:
    """φ₀ = 𝓜(0)."""
    value = sp.gamma(3 * HALF) * sp.gamma(p + 2) / sp.gamma(p + 5 * HALF)
    return sp.simplify(value)


def slope(p: sp.Rational) -> sp.Expr:
    """𝓕′(0) = φ₀(p + 3/2)."""
    return sp.simplify(pure_spin(p) * (p + 3 * HALF))


def force_within(p: sp.Rational) -> Series:
    """𝓕/(𝓕′(0) k) for k ≤ 1."""
    return Series(HALF, -p - HALF, sp.Integer(2))


def force_beyond(p: sp.Rational) -> Series:
    """𝓕 for k ≥ 1."""
    return Series(-HALF, HALF, p + 2)


def couple_beyond(p: sp.Rational) -> Series:
    """2(p + 2) k𝓜 for k ≥ 1."""
    return Series(HALF, HALF, p + 3)


def bounds(p: sp.Rational) -> tuple[sp.Expr, sp.Expr] | None:
    """Numbers C, D with 𝓕 ≤ C k and k𝓜 ≤ D for all k > 0; None if the signs prove none.

    For k ≤ 1 the terms of 𝓕/(C k) after the first are not positive, and for k ≥ 1, 𝓕 ≤ 1 ≤ C.
    Likewise k𝓜 ≤ 𝓜(0) for k ≤ 1, and for k ≥ 1 it is largest at k = 1.
    """
    C = slope(p)
    shown = force_within(p).sign_after_first <= 0 and force_beyond(p).sign_after_first <= 0
    if not (shown and C >= 1 and couple_beyond(p).sign_after_first >= 0):
        return None
    D = sp.Max(pure_spin(p), couple_beyond(p).at_one() / (2 * (p + 2)))
    return C, sp.simplify(D)


def least_friction(p: sp.Rational) -> sp.Expr | None:
    """A number E > 0 with 𝓕k + 𝓜 ≥ E max(1, k): a lower bound of the dissipated power.

    φ = 𝓕k + 𝓜 is convex and even in k, so that φ ≥ 𝓜(0); for k ≥ 1 it is k times a series of
    positive terms that begins with 1.
    """
    beyond = Series(-HALF, -HALF, p + 2)
    return sp.Min(pure_spin(p), 1) if beyond.sign_after_first >= 0 else None
