"""Densities as real positive functions: signs and zeros of their factors."""

from __future__ import annotations

import random
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import sympy as sp

#: Bases with exponents.
Powers = tuple[tuple[sp.Expr, sp.Expr], ...]

SEED = 20080830
SAMPLES = 24


@dataclass(frozen=True)
class Signs:
    """Known signs of factors.

    Attributes
    ----------
    positive : frozenset of Symbol
        Parameters that are positive.
    relations : tuple of formula
        Expressions that vanish on the configuration space.
    positive_products : tuple of formula
        Products known to be positive for another reason.
    numbers : pairs (Symbol, number)
        Values of the parameters at which signs are sampled.
    """

    positive: frozenset[sp.Symbol]
    relations: tuple[sp.Expr, ...] = ()
    positive_products: tuple[sp.Expr, ...] = ()
    numbers: tuple[tuple[sp.Symbol, float], ...] = ()


def positive(powers: Powers, signs: Signs) -> tuple[Powers, tuple[sp.Basic, ...]]:
    """The density up to a constant factor, with positive bases where possible.

    Parameters
    ----------
    powers : Powers
        Bases with rational exponents.

    Returns
    -------
    Powers
    tuple of relations
        Where these hold, the density is proven positive and smooth; elsewhere its absolute value is
        a density except at the zeros of its bases.
    """
    total: dict[sp.Expr, sp.Expr] = {}
    for base, exponent in powers:
        turned = _with_positive_sign(base, signs)
        total[turned] = total.get(turned, sp.S.Zero) + exponent
    total = _without_squares_of_sines(total)
    density = tuple((base, exponent) for base, exponent in total.items() if exponent != 0)
    proven = _positive_bases([base for base, _ in density], signs)
    return density, tuple(
        sp.Ne(base, 0) if (exponent / 2).is_Integer else base > 0
        for base, exponent in density
        if base not in proven
    )


def definite(factor: sp.Expr, positive: Collection[sp.Symbol]) -> bool:
    """Whether a polynomial has one sign for positive parameters and all values of the others."""
    if not factor.free_symbols:
        return True
    poly = sp.Poly(factor, *sorted(factor.free_symbols, key=str))
    if len({bool(c > 0) for c in poly.coeffs()}) > 1:
        return False
    named = [
        [(s, p) for s, p in zip(poly.gens, powers, strict=True) if p] for powers in poly.monoms()
    ]
    even = all(p % 2 == 0 or s in positive for term in named for s, p in term)
    # even powers may vanish together, so that one term must consist of positive parameters only
    return even and any(all(s in positive for s, _ in term) for term in named)


def _with_positive_sign(base: sp.Expr, signs: Signs) -> sp.Expr:
    """A base, or its negative if all sampled signs are negative."""
    values = [v for v in (_value(base, signs, seed) for seed in range(SAMPLES)) if v]
    return sp.expand(-base) if values and max(values) < 0 else base


def _value(base: sp.Expr, signs: Signs, seed: int) -> sp.Expr | None:
    """The sign of a base at a random configuration; None if it has no real value there."""
    rng = random.Random(SEED + seed)
    symbols = base.free_symbols.union(*(r.free_symbols for r in signs.relations))
    place = {s: sp.Float(rng.uniform(-4, 4)) for s in sorted(symbols, key=str)}
    for relation in signs.relations:
        own, square = _sphere(relation, signs)
        if square is not None:
            length = sp.sqrt(square / sp.Add(*(place[s] ** 2 for s in own)))
            place |= {s: place[s] * length for s in own}
    place |= {s: sp.sympify(v) for s, v in signs.numbers}
    value = sp.N(base.xreplace(place), 20)
    return sp.sign(value) if value.is_real else None


def _without_squares_of_sines(total: dict[sp.Expr, sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Powers rewritten so that sin x, 1 − cos x and 1 + cos x do not occur together.

    |sin x| is the square root of (1 − cos x)(1 + cos x).
    """
    powers = dict(total)
    arguments = {f.args[0] for base in total for f in base.atoms(sp.sin, sp.cos)}
    for x in sorted(arguments, key=str):
        sine, pair = sp.sin(x), (1 - sp.cos(x), 1 + sp.cos(x))
        if not powers.keys() & {sine, *pair}:
            continue
        half = powers.pop(sine, sp.S.Zero) / 2
        first, second = (powers.pop(factor, sp.S.Zero) + half for factor in pair)
        if first == second:
            powers[sine] = 2 * first
        else:
            powers |= dict(zip(pair, (first, second), strict=True))
    return powers


def _positive_bases(bases: Sequence[sp.Expr], signs: Signs) -> set[sp.Expr]:
    """The bases that are positive on the whole configuration space."""
    proven = {base for base in bases if _is_positive(base, signs)}
    for product in signs.positive_products:
        factors = [f.as_base_exp() for f in sp.Mul.make_args(sp.factor(product))]
        open_ = [(f, n) for f, n in factors if not f.is_number and not _is_positive(f, signs)]
        if len(open_) == 1 and open_[0][1] % 2:
            proven |= {base for base in bases if sp.expand(base - open_[0][0]) == 0}
    return proven


def _is_positive(base: sp.Expr, signs: Signs) -> bool:
    """Whether a base is a sum of nonnegative terms that cannot vanish together."""
    functions = {f: sp.Dummy(real=True) for f in base.atoms(sp.Function)}
    plain = sp.expand(base.xreplace(functions))
    if not plain.is_polynomial(*plain.free_symbols):
        return False
    return definite(plain, signs.positive) or any(
        _positive_on(plain, relation, signs) for relation in signs.relations
    )


def _sphere(relation: sp.Expr, signs: Signs) -> tuple[list[sp.Symbol], sp.Expr | None]:
    """The coordinates of a sphere, and the square of its radius, if a relation describes one."""
    own = sorted(relation.free_symbols - signs.positive, key=str)
    remainder = sp.expand(relation - sp.Add(*(s**2 for s in own)))
    return own, (-remainder if own and remainder.is_number and remainder < 0 else None)


def _positive_on(plain: sp.Expr, relation: sp.Expr, signs: Signs) -> bool:
    """Whether a sum of squares vanishes nowhere on a sphere described by a relation."""
    own, square = _sphere(relation, signs)
    if square is None or not definite(plain + sp.S.One, signs.positive):
        return False
    poly = sp.Poly(plain, *own)
    return all(
        any(sum(powers) == powers[i] and powers[i] for powers in poly.monoms())
        and all(
            definite(c, signs.positive)
            for powers, c in poly.terms()
            if sum(powers) == powers[i] and powers[i]
        )
        for i in range(len(own))
    )
