"""Roots and values of functions in a proof: that they are those of the law, and real."""

from __future__ import annotations

from collections.abc import Sequence

from ..claim.errors import CheckError
from ..claim.polynomials import Poly, Powers, monic
from .accuracy import agree
from .case_tree import Signs
from .divisors import Entry
from .generators import Auxiliary, Generators, Sample


def has_formal_roots(generators: Generators) -> bool:
    """Whether a root is used of which nothing but its power is known."""
    return any(auxiliary.kind == "formal root" for auxiliary in generators.auxiliary)


def check_roots(
    generators: Generators,
    signs: Signs,
    nonzero: frozenset[str],
    entries: Sequence[Entry],
    matches: Sequence[int | None],
    what: str,
) -> None:
    """Check that what stands under the roots of a proof is positive, or that of a law's root."""
    for auxiliary in generators.auxiliary:
        if auxiliary.kind == "formal root":
            if not _is_radicand(auxiliary, [entries[i] for i in matches if i is not None]):
                raise CheckError(f"{what}: {auxiliary.name} is no root of the law")
            for poly, _ in auxiliary.whole:
                if monic(poly)[0] not in nonzero and not signs.of(poly):
                    raise CheckError(f"{what}: what is taken out of {auxiliary.name} may vanish")
            continue
        if auxiliary.kind in ("root", "power") and signs.of(auxiliary.of[0][0]) <= 0:
            raise CheckError(f"{what}: what stands under the root {auxiliary.name} may be negative")


def check_functions(
    generators: Generators, samples: list[Sample], nonzero: frozenset[str], signs: Signs, what: str
) -> None:
    """Auxiliary function values are defined wherever the law is."""
    for auxiliary in generators.auxiliary:
        label = f"{what}: the argument of {auxiliary.name}"
        for _, below in auxiliary.of:
            for poly, _ in below:
                if monic(poly)[0] not in nonzero and not signs.of(poly):
                    raise CheckError(f"{label} has a denominator that may vanish")
        if auxiliary.kind != "known" or auxiliary.word in ("exp", "atan"):
            continue
        ring = generators.ring
        arguments = [
            [ring.value(above, s.values) / ring.value_of_powers(below, s.values) for s in samples]
            for above, below in auxiliary.of
        ]
        if auxiliary.word == "log":
            if _sign_of_fraction(*auxiliary.of[0], signs) > 0:
                continue
            known, stated = "logarithms", arguments[0]
        elif auxiliary.word == "atan2":
            known = "nonzero"
            stated = [y * y + x * x for y, x in zip(*arguments, strict=True)]
        else:
            known, stated = "positive", [1 - x * x for x in arguments[0]]
        lists = zip(*(getattr(s, known) for s in samples), strict=True)
        if not any(agree(stated, values) for values in lists):
            raise CheckError(f"{label} is none of the law")


def _sign_of_fraction(above: Poly, below: Powers, signs: Signs) -> int:
    sign = signs.of(above)
    for poly, power in below:
        sign *= signs.of(poly) if power % 2 else abs(signs.of(poly))
    return sign


def _is_radicand(auxiliary: Auxiliary, radicands: Sequence[Entry]) -> bool:
    """Whether what stands under a formal root has the sign of a radicand of the law."""
    inner, whole = auxiliary.radicand
    mine = _odd(_factors(inner) + [(p, n) for p, n in whole])
    return any(_odd([*entry.powers], entry.content) == mine for entry in radicands)


def _factors(poly: Poly) -> Powers:
    """The irreducible factors of a polynomial, with its content."""
    content, parts = poly.factor()
    constant = poly.context().constant(content)
    return [(constant, 1), *((part, int(power)) for part, power in parts)]


def _odd(powers: Powers, content: int = 1) -> tuple[int, frozenset[str]]:
    """The sign of a product and its factors with odd powers, which decide its sign."""
    odd: set[str] = set()
    for poly, power in powers:
        if power % 2 == 0:
            continue
        key, lead = monic(poly)
        content *= lead
        if not poly.is_constant():
            odd ^= {key}
    return content, frozenset(odd)


def check_radicands(
    generators: Generators,
    signs: Signs,
    entries: Sequence[Entry],
    matches: Sequence[int | None],
    what: str,
) -> None:
    """Every root of the law is a product of roots of factors with known signs."""
    formal = [a for a in generators.auxiliary if a.kind == "formal root"]
    for (_, _, exponent), number in zip(generators.domain.positive, matches, strict=False):
        if number is None:
            raise CheckError(f"{what} does not say of what factors a root of the law is taken")
        if any(
            exponent.denominator == a.number and _is_radicand(a, [entries[number]]) for a in formal
        ):
            continue
        for poly, power in entries[number].powers:
            share = exponent * power
            even = share.denominator == 1 and share % 2 == 0
            if not even and not signs.of(poly):
                raise CheckError(f"{what} leaves open the sign of a factor under a root")


def check_bases(
    signs: Signs, entries: Sequence[Entry], matches: Sequence[int | None], what: str
) -> None:
    """Every base with a symbolic exponent is positive, being a product of factors of known signs.

    (f g)^a = f^a g^a asks for f > 0 and g > 0, (f²)^a = f^(2a) for f > 0.
    """
    for number in matches:
        if number is None:
            raise CheckError(f"{what} does not say of what factors a power of the law is taken")
        entry = entries[number]
        sign = entry.content
        for poly, power in entry.powers:
            own = signs.of(poly)
            if not own:
                raise CheckError(f"{what} leaves open the sign of a factor of a power's base")
            sign *= own if power % 2 else 1
        if sign <= 0:
            raise CheckError(f"{what}: the base of a power with a symbolic exponent is negative")
