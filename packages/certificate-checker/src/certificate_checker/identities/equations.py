"""Equations of a proof: each comes from a condition, a root, a circle or equal values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..claim.errors import CheckError
from ..claim.formulas import Formula
from ..claim.json_data import as_list, field, integer, items, mapping, only, text
from ..claim.parsing import parse
from ..claim.polynomials import Poly, Powers, Ring, monic
from .case_tree import Signs
from .comparisons import Comparisons
from .generator_functions import Auxiliary
from .generators import Generators
from .residues import UnknownRootError

#: Known injective functions.
ONE_TO_ONE = ("exp", "log", "asin", "acos", "atan")


class Equations:
    """Polynomials that vanish on the level, each with its origin."""

    def __init__(self, data: Mapping[str, object], comparisons: Comparisons, what: str) -> None:
        self.comparisons = comparisons
        self.polys: list[Poly] = []
        self._items: list[tuple[Mapping[str, object], str, list[str], str]] = []
        for number, data_of_one in enumerate(as_list(field(data, "equations", what), what)):
            label = f"equation {number} of {what}"
            item = mapping(data_of_one, label)
            only(item, label, "poly", "from", "denominator", "quotients", "equation", "quotient")
            self.polys.append(comparisons.generators.ring.read(field(item, "poly", label), label))
            source = text(field(item, "from", label), label)
            self._items.append((item, source, source.split(" "), label))

    def usable(self, signs: Signs) -> set[int]:
        """Indices of equations that hold independent of all assumptions of a proof."""
        ring = self.comparisons.generators.ring
        numbers = set()
        for number, (_, source, words, label) in enumerate(self._items):
            if words[0] in ("one", "same", "argument"):
                continue
            if words[0] == "root" and len(words) == 2:
                known = words[1] in ring.index and bool(signs.of(ring.generator(words[1])))
            elif words[0] == "circle" and len(words) == 3:
                known = True
            else:
                known = self._is_known(parse(source, label))
            if known:
                numbers.add(number)
        return numbers

    def _is_known(self, formula: Formula) -> bool:
        try:
            return self.comparisons.formula(formula) is not None
        except UnknownRootError:
            return False

    def verify(self, nonzero: frozenset[str], signs: Signs) -> tuple[Poly, ...]:
        """Polynomials of the equations; CheckError if one does not have its stated origin."""
        generators = self.comparisons.generators
        ring = generators.ring
        for number, (item, source, words, label) in enumerate(self._items):
            poly = self.polys[number]
            if words[0] == "root" and len(words) == 2:
                _check_root(poly, words[1], generators, label)
            elif words[0] in ("one", "same") and len(words) == 3 - (words[0] == "one"):
                quotients = field(item, "quotients", label)
                known = self.polys[:number]
                _check_equal_values(poly, words[1:], quotients, known, generators, label)
            elif words[0] == "argument" and len(words) in (2, 3):
                known = self.polys[:number]
                _check_equal_arguments(poly, words[1:], item, known, generators, label)
            elif words[0] == "circle" and len(words) == 3:
                _check_circle(poly, words[1:], generators, label)
            else:
                powers = ring.powers(item.get("denominator", []), label, negative=True)
                for factor, _ in powers:
                    key = None if factor.is_constant() else monic(factor)[0]
                    if key is not None and key not in nonzero and not signs.of(factor):
                        raise CheckError(f"{label} multiplies by something that may vanish")
                _check_condition(poly, powers, parse(source, label), self.comparisons, label)
        return tuple(self.polys)


def _check_condition(
    poly: Poly, powers: Powers, formula: Formula, comparisons: Comparisons, label: str
) -> None:
    if formula not in comparisons.generators.claim.conditions:
        raise CheckError(f"{label} comes from no condition")
    stated = comparisons.formula(formula)
    if stated is None:
        raise CheckError(f"{label} is not defined")
    if stated != comparisons.fraction(poly, powers):
        raise CheckError(f"{label} is not the condition from which it comes")


def _check_root(poly: Poly, word: str, generators: Generators, label: str) -> None:
    for auxiliary in generators.auxiliary:
        if auxiliary.name == word and auxiliary.kind in ("root", "formal root"):
            root = generators.ring.generator(word) ** auxiliary.number - auxiliary.of[0][0]
            if not poly.is_zero() and monic(poly)[0] == monic(root)[0]:
                return
    raise CheckError(f"{label} is not that of a root")


def _check_equal_values(
    poly: Poly,
    words: Sequence[str],
    quotients: object,
    equations: Sequence[Poly],
    generators: Generators,
    label: str,
) -> None:
    """Check that two values, or a value and 1, are equal because their arguments are."""
    ring = generators.ring
    known = {a.name: a for a in generators.auxiliary}
    if not set(words) <= set(known):
        raise CheckError(f"{label} refers to an unknown symbol")
    first = known[words[0]]
    value = ring.generator(first.name)
    one: tuple[Poly, Powers] = (ring.constant(1), [])
    if len(words) == 2:
        second = known[words[1]]
        others, value = second.of, value - ring.generator(second.name)
        alike = _function(first) == _function(second) and first.kind != "formal root"
    else:
        others, value = (one,), value - 1
        alike = first.kind in ("root", "power")
    texts = items(quotients, len(first.of), label)
    if not alike or not first.of or poly != value or len(others) != len(first.of):
        raise CheckError(f"{label} does not say that values are equal")
    for mine, theirs, listed_of_one in zip(first.of, others, texts, strict=True):
        parts = items(listed_of_one, len(equations), label)
        total = ring.constant(0)
        for part, equation in zip(parts, equations, strict=True):
            total = total + ring.read(part, label) * equation
        left = mine[0] * ring.expanded_product(theirs[1]) - theirs[0] * ring.expanded_product(
            mine[1]
        )
        if left != total:
            raise CheckError(f"{label}: the arguments are not equal on the level")


def _check_equal_arguments(
    poly: Poly,
    words: Sequence[str],
    item: Mapping[str, object],
    equations: Sequence[Poly],
    generators: Generators,
    label: str,
) -> None:
    """Check q · (a − b) = 0 from q · (f(a) − f(b)) = 0 with injective f, or from exp a = 1."""
    ring = generators.ring
    known = {a.name: a for a in generators.auxiliary if a.word in ONE_TO_ONE}
    if not set(words) <= set(known):
        raise CheckError(f"{label} is not one of a one-to-one function")
    first = known[words[0]]
    theirs: tuple[Poly, Powers] = (ring.constant(0), [])
    other = ring.constant(1)
    alike = first.word == "exp"
    if len(words) == 2:
        second = known[words[1]]
        theirs, other = second.of[0], ring.generator(second.name)
        alike = _function(first) == _function(second)
    last = len(equations) - 1
    equation = equations[integer(field(item, "equation", label), label, 0, last)]
    quotient = ring.read(field(item, "quotient", label), label)
    if not alike or equation != quotient * (ring.generator(first.name) - other):
        raise CheckError(f"{label} does not say that values are equal")
    mine = first.of[0]
    left = mine[0] * ring.expanded_product(theirs[1]) - theirs[0] * ring.expanded_product(mine[1])
    left = quotient * left
    if poly.is_zero() or left.is_zero() or monic(poly)[0] != monic(left)[0]:
        raise CheckError(f"{label} does not say that the arguments are equal")


def _function(auxiliary: Auxiliary) -> tuple[object, ...]:
    """Kind, name, degree, orders and exponent of an auxiliary symbol, without its arguments."""
    return (auxiliary.kind, auxiliary.word, auxiliary.number, auxiliary.orders, auxiliary.exponent)


def _check_circle(poly: Poly, words: Sequence[str], generators: Generators, label: str) -> None:
    known = {a.name: a for a in generators.auxiliary if a.kind in ("sin", "cos")}
    if len(set(words)) == 2 and set(words) <= set(known):
        first, second = (known[word] for word in words)
        ring = generators.ring
        circle = ring.generator(words[0]) ** 2 + ring.generator(words[1]) ** 2 - 1
        same = _same_fraction(first.of[0], second.of[0], ring)
        both = {first.kind, second.kind} == {"sin", "cos"} and not poly.is_zero()
        if both and same and monic(poly)[0] == monic(circle)[0]:
            return
    raise CheckError(f"{label} is not that of a circle")


def _same_fraction(first: tuple[Poly, Powers], second: tuple[Poly, Powers], ring: Ring) -> bool:
    left = first[0] * ring.expanded_product(second[1])
    return bool(left == second[0] * ring.expanded_product(first[1]))
