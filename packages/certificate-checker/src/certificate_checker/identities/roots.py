"""Roots and function values in a proof: whether they belong to the law and are real."""

from __future__ import annotations

from collections.abc import Sequence

from ..claim.errors import CheckError
from ..claim.polynomials import Poly, Powers, monic
from .case_tree import Signs
from .comparisons import Comparisons
from .divisors import Entry
from .generator_functions import Auxiliary
from .generators import Generators


def check_roots(
    generators: Generators,
    signs: Signs,
    nonzero: frozenset[str],
    radicands: Sequence[Entry],
    what: str,
) -> None:
    """Check that the radicands of the proof, or of the law, are positive."""
    for auxiliary in generators.auxiliary:
        if auxiliary.kind == "formal root":
            if not is_radicand(auxiliary, radicands):
                raise CheckError(f"{what}: {auxiliary.name} is no root of the law")
            for poly, _ in auxiliary.whole:
                if monic(poly)[0] not in nonzero and not signs.of(poly):
                    raise CheckError(f"{what}: what is taken out of {auxiliary.name} may vanish")
            continue
        if auxiliary.kind in ("root", "power") and signs.of(auxiliary.of[0][0]) <= 0:
            raise CheckError(f"{what}: what stands under the root {auxiliary.name} may be negative")


def check_functions(
    comparisons: Comparisons, nonzero: frozenset[str], signs: Signs, what: str
) -> None:
    """Check that auxiliary function values are defined wherever the law is."""
    domain = comparisons.generators.domain
    lists = {
        "log": domain.logarithms,
        "atan2": domain.nonzero,
        "asin": [(where, formula) for where, formula, _ in domain.positive],
    }
    for auxiliary in comparisons.generators.auxiliary:
        label = f"{what}: the argument of {auxiliary.name}"
        for _, below in auxiliary.of:
            for poly, _ in below:
                if monic(poly)[0] not in nonzero and not signs.of(poly):
                    raise CheckError(f"{label} has a denominator that may vanish")
        if auxiliary.kind != "known" or auxiliary.word in ("exp", "atan"):
            continue
        arguments = [comparisons.fraction(above, below) for above, below in auxiliary.of]
        if auxiliary.word == "log":
            if _sign_of_fraction(*auxiliary.of[0], signs) > 0:
                continue
            stated = arguments[0]
        elif auxiliary.word == "atan2":
            stated = [y * y + x * x for y, x in zip(*arguments, strict=True)]
        else:
            stated = [1 - x * x for x in arguments[0]]
        known = lists.get(auxiliary.word, lists["asin"])
        if not any(comparisons.formula(formula, where) == stated for where, formula in known):
            raise CheckError(f"{label} is none of the law")


def _sign_of_fraction(above: Poly, below: Powers, signs: Signs) -> int:
    sign = signs.of(above)
    for poly, power in below:
        sign *= signs.of(poly) if power % 2 else abs(signs.of(poly))
    return sign


def is_radicand(auxiliary: Auxiliary, radicands: Sequence[Entry]) -> bool:
    """True if the radicand of a formal root has the sign of a radicand of the law."""
    inner, whole = auxiliary.radicand
    mine = _odd(_factors(inner) + [(p, n) for p, n in whole])
    return any(_odd([*entry.powers], 1 if entry.content > 0 else -1) == mine for entry in radicands)


def _factors(poly: Poly) -> Powers:
    """Irreducible factors of a polynomial, with its content."""
    content, parts = poly.factor()
    constant = poly.context().constant(content)
    return [(constant, 1), *((part, int(power)) for part, power in parts)]


def _odd(powers: Powers, content: int = 1) -> tuple[int, frozenset[str]]:
    """Sign of the constant factor of a product, and its factors with odd powers."""
    odd: set[str] = set()
    for poly, power in powers:
        if power % 2 == 0:
            continue
        key, lead = monic(poly)
        content *= lead
        if not poly.is_constant():
            odd ^= {key}
    return content, frozenset(odd)
