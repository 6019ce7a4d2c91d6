"""The identities behind the quadratic integrals of a rigid body, for every dimension at once.

Let J be the mass tensor, R = (λ − J)⁻¹, I(ω) = Jω + ωJ + Dω and K(ω) = RωR.  All products of such
operators that are applied to vectors x∧y end in the numbers (x, Rᵃy), a = −1, 0, 1.  As identities
in these numbers, which are independent for large n, two facts hold for every n, every symmetric J
and every λ.  With W_I x = (I(x∧γ))γ, W_K x = (K(x∧γ))γ for x across γ, γ² = 1:

* (W_I u, W_K q) = (W_K u, W_I q): these operators across γ commute;
* (p, W_K′u) = (W_K u, W_I′u), where p = W_I u and W′ is the change of W along γ̇ = −u, so that
  (x, W_K′u) = −(u, K(x∧u) γ).

By ∇p = 0, which is W_I ∇u = −W_I′u, they give Ḟ = 0 for F = (p, W_K u) = Σ ω_ij k_ij/((λ − c_i)(λ
− c_j)): see docs/quadratic-integrals.md, §2.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.laws import Identity
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol

lam, D = real_symbol("lambda"), real_symbol("D")
SOURCE = "docs/quadratic-integrals.md, §2"

#: A vector as a sum of Rᵃx: (letter x, power a) ↦ coefficient.
Sum = Mapping[tuple[str, int], sp.Expr]
#: The letter of γ, which is of length one and orthogonal to the others.
ALONG = "y"


def _of(letter: str) -> Sum:
    return {(letter, 0): sp.S.One}


def _plus(first: Sum, second: Sum, factor: sp.Expr = sp.S.One) -> Sum:
    total = dict(first)
    for key, value in second.items():
        total[key] = total.get(key, sp.S.Zero) + factor * value
    return total


def _times(vector: Sum, power: int) -> Sum:
    """Rᵃ applied to a vector."""
    return {(letter, a + power): value for (letter, a), value in vector.items()}


def _number(x: str, y: str, power: int) -> sp.Expr:
    """(x, Rᵃy) as an independent number, unless γ and the vectors across it determine it."""
    first, second = sorted((x, y))
    if power == 0 and ALONG in (x, y):
        return sp.Integer(int(x == y))
    sign = {-1: "m", 0: "o", 1: "p"}[power]
    return real_symbol(f"{first}{sign}{second}")


def _product(first: Sum, second: Sum) -> sp.Expr:
    return sp.Add(
        *(
            s * t * _number(x, y, a + b)
            for (x, a), s in first.items()
            for (y, b), t in second.items()
        )
    )


def _with_names(name: str, vector: Sum) -> tuple[Sum, Pairs]:
    """A vector with names for its coefficients, and the values of these names."""
    names = {key: real_symbol(f"{name}_{i}") for i, key in enumerate(vector, 1)}
    return names, tuple((names[key], value) for key, value in vector.items())


@dataclass(frozen=True)
class _Plane:
    """The skew matrix x∧y = xyᵀ − yxᵀ, between powers of R, applied to vectors."""

    x: Sum
    y: Sum

    def image(self, vector: Sum, left: int = 0, right: int = 0) -> Sum:
        """Rᵃ(x∧y)Rᵇ of a vector."""
        turned = _times(vector, right)
        first, second = _product(self.y, turned), _product(self.x, turned)
        along = {key: first * value for key, value in _times(self.x, left).items()}
        return _plus(along, _times(self.y, left), -second)

    def inertia(self, vector: Sum) -> Sum:
        """J(x∧y) + (x∧y)J + D x∧y of a vector, J = λ − R⁻¹."""
        whole: Sum = {key: (2 * lam + D) * value for key, value in self.image(vector).items()}
        whole = _plus(whole, self.image(vector, left=-1), sp.S.NegativeOne)
        return _plus(whole, self.image(vector, right=-1), sp.S.NegativeOne)

    def pencil(self, vector: Sum) -> Sum:
        """R(x∧y)R of a vector."""
        return self.image(vector, 1, 1)


def rate_of_pencil(sign: int = 1) -> System:
    """Both identities, as laws of a system without motion.

    Parameters
    ----------
    sign : int
        1 in the identities that hold; −1 for a slip in the second one.

    Examples
    --------
    >>> import lawproof
    >>> [verdict.decision for verdict in lawproof.prove_all(rate_of_pencil())]
    ['proven', 'proven']
    """
    u, q, y = _of("u"), _of("q"), _of(ALONG)
    p, of_p = _with_names("p", _Plane(u, y).inertia(y))
    w, of_w = _with_names("w", _Plane(u, y).pencil(y))
    commute = _product(p, _Plane(q, y).pencil(y)) - _product(w, _Plane(q, y).inertia(y))
    rate = _product(u, _Plane(p, u).pencil(y)) - sign * _product(u, _Plane(w, u).inertia(y))
    definitions = (*of_p, *of_w)
    used = {s for f in (commute, rate, *(f for _, f in definitions)) for s in f.free_symbols}
    numbers = used - {lam, D, *(s for s, _ in definitions)}
    return System(
        name="quadratic-integrals",
        title="Quadratic integrals of rigid bodies in every dimension",
        field=dict.fromkeys(sorted(numbers, key=str), sp.S.Zero),
        definitions=definitions,
        parameters=(Parameter(lam, "λ", 3.0), Parameter(D, "m R²", 1.0)),
        laws=(
            Identity("commute", commute, "W_I and W_K commute", source=SOURCE),
            Identity("rate", rate, "the rate of F is zero", source=SOURCE),
        ),
    )
