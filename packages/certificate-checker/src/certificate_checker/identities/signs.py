"""Check that proofs with assumed signs together cover all signs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any, TypeAlias

from flint import fmpq

from ..claim.errors import CheckError
from ..claim.polynomials import Poly
from .basis import Basis
from .generators import Generators
from .proof import Condition, same

#: Polynomial by its terms, independent of the ring.
Key: TypeAlias = tuple[object, ...]

#: Maximum number of polynomials whose signs may be assumed together.
MANY = 14


def covers(proofs: Sequence[Basis], conditions: Sequence[Condition]) -> bool:
    """True if at every point where the law is defined one of the proofs applies.

    The claims must be identical; only points with `conditions` are considered.
    """
    assumed = [dict(_assumed_signs(basis)) for basis in proofs]
    keys = sorted({key for signs in assumed for key in signs}, key=repr)
    if len(keys) > MANY:
        raise CheckError(f"the proofs assume the signs of more than {MANY} polynomials")
    known, products = _certain_signs(proofs, conditions, set(keys))
    excluded = _contradictions(keys)
    # Every combination of signs must be impossible or covered by a proof.
    for pattern in product((1, -1), repeat=len(keys)):
        signs = dict(zip(keys, pattern, strict=True))
        if any(signs[key] != sign for key, sign in known):
            continue
        if any(_sign(content, factors, signs) < 0 for content, factors in products):
            continue
        if any(signs[one] == s and signs[other] == t for one, s, other, t in excluded):
            continue
        if not any(all(signs[k] == s for k, s in some.items()) for some in assumed):
            return False
    return True


def _sign(content: int, factors: Sequence[Key], signs: Mapping[Key, int]) -> int:
    for key in factors:
        content *= signs[key]
    return content


def _contradictions(keys: Sequence[Key]) -> list[tuple[Key, int, Key, int]]:
    """Pairs of mutually exclusive signs.

    They are found where the sum of the two signed polynomials, one of them with a positive factor,
    has only even powers with negative coefficients.
    """
    terms = [dict(_terms_of(key)) for key in keys]
    pairs = []
    for i, first in enumerate(terms):
        for j in range(i):
            for s, t in product((1, -1), repeat=2):
                if _contradict(first, s, terms[j], t):
                    pairs.append((keys[i], s, keys[j], t))
    return pairs


def _terms_of(key: Any) -> Iterator[tuple[object, fmpq]]:
    for powers, number in key:
        yield powers, fmpq(*map(int, number.split("/")))


def _contradict(
    first: Mapping[object, fmpq], s: int, second: Mapping[object, fmpq], t: int
) -> bool:
    # A factor is tried only if it cancels a common term.
    for powers in first.keys() & second.keys():
        ratio = -s * first[powers] / (t * second[powers])
        if not ratio > 0:
            continue
        total = {
            p: s * first.get(p, fmpq(0)) + t * ratio * second.get(p, fmpq(0))
            for p in first.keys() | second.keys()
        }
        if all(c == 0 or (c < 0 and _is_even(p)) for p, c in total.items()):
            return True
    return False


def _is_even(powers: Any) -> bool:
    return all(exponent % 2 == 0 for _, exponent in powers)


def _assumed_signs(basis: Basis) -> Iterator[tuple[Key, int]]:
    for poly, sign in basis.generators.signs:
        key, lead = _key(basis.generators, poly)
        yield key, sign * lead


def _certain_signs(
    proofs: Sequence[Basis], conditions: Sequence[Condition], keys: set[Key]
) -> tuple[list[tuple[Key, int]], list[tuple[int, list[Key]]]]:
    """Signs that are certain or required, and products of signs that are positive."""
    known: list[tuple[Key, int]] = []
    products: list[tuple[int, list[Key]]] = []
    for basis in proofs:
        generators = basis.generators
        for poly, _ in generators.signs:
            key, lead = _key(generators, poly)
            certain = basis.certain.of(poly)
            if certain:
                known.append((key, certain * lead))
            for condition in conditions:
                if condition.positive:
                    sign = same(basis, poly, condition.formula)
                    if sign:
                        known.append((key, sign * lead))
        for entry in basis.radicands:
            content, factors = 1 if entry.content > 0 else -1, []
            for poly, power in entry.powers:
                if power % 2 == 0:
                    continue
                key, lead = _key(generators, poly)
                certain = basis.certain.of(poly)
                if certain:
                    content *= certain
                else:
                    content *= lead
                    factors.append(key)
            if set(factors) <= keys:
                products.append((content, factors))
    return known, products


def _key(generators: Generators, poly: Poly) -> tuple[Key, int]:
    """Key independent of the ring, and the sign of the leading coefficient."""
    names: dict[str, Key] = {name: (name,) for name in generators.plain}
    for auxiliary in generators.auxiliary:
        names[auxiliary.name] = (
            auxiliary.kind,
            auxiliary.word,
            auxiliary.number,
            auxiliary.orders,
            repr(auxiliary.exponent),
            tuple(
                (
                    _terms(generators, above, names),
                    tuple((_terms(generators, p, names), n) for p, n in below),
                )
                for above, below in auxiliary.of
            ),
        )
    terms = _terms(generators, poly, names)
    lead = terms[0][1]
    return tuple((powers, str(number / lead)) for powers, number in terms), 1 if lead > 0 else -1


def _terms(
    generators: Generators, poly: Poly, names: Mapping[str, Key]
) -> tuple[tuple[object, fmpq], ...]:
    """Terms in an order independent of the ring."""
    terms = []
    for exponents, number in poly.to_dict().items():
        powers = [(names[generators.ring.names[i]], int(n)) for i, n in enumerate(exponents) if n]
        terms.append((tuple(sorted(powers, key=repr)), number))
    return tuple(sorted(terms, key=lambda term: repr(term[0])))
