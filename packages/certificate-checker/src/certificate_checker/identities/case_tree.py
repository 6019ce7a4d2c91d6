"""Case tree that shows that residuals vanish, or divides a level into parts.

A node represents the points at which some polynomials E vanish and those of a set H do not.  Every
step is a polynomial identity, which is verified.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from flint import fmpq

from ..claim.errors import CheckError
from ..claim.json_data import as_list, field, integer, items, mapping, only, rational
from ..claim.polynomials import Poly, Ring, monic

DEPTH = 200

#: Function for a leaf that is left open, or a part with a proof: its node, data and label.
Leaf: TypeAlias = Callable[["Node", Mapping[str, object], str], None]


class Signs:
    """Polynomials with known signs, up to constant factors."""

    def __init__(self) -> None:
        self._signs: dict[str, tuple[int, bool]] = {}
        #: Nonnegative polynomials, by key and sign.
        self._not_negative: set[tuple[str, int]] = set()

    def copy(self) -> Signs:
        """Independent copy."""
        signs = Signs()
        signs._signs = dict(self._signs)
        signs._not_negative = set(self._not_negative)
        return signs

    @property
    def count(self) -> tuple[int, int]:
        """Number of known signs, and of strict ones."""
        return len(self._not_negative), sum(strict for _, strict in self._signs.values())

    def learn(self, poly: Poly, sign: int, strict: bool = True) -> None:
        """Record that sign · poly is positive, or nonnegative."""
        key, lead = monic(poly)
        self._not_negative.add((key, sign * lead))
        known = self._signs.get(key)
        if known is not None and known[0] != sign * lead and known[1] and strict:
            raise CheckError(
                f"the signs of positive quantities contradict each other at {_short_text(poly)}"
            )
        if known is None or strict:
            self._signs[key] = (sign * lead, strict)

    def of(self, poly: Poly) -> int:
        """Strict sign of a polynomial; 0 if unknown."""
        if poly.is_constant():
            return 0 if poly.is_zero() else monic(poly)[1]
        key, lead = monic(poly)
        sign, strict = self._signs.get(key, (0, False))
        return sign * lead if strict else 0

    def is_not_negative(self, poly: Poly) -> bool:
        """True if a polynomial is known to be nonnegative."""
        if poly.is_constant():
            return poly.is_zero() or self.of(poly) > 0
        return monic(poly) in self._not_negative

    def weak(self, poly: Poly) -> int:
        """Sign of a polynomial that may also be zero; 0 if unknown."""
        if poly.is_constant():
            return self.of(poly)
        key, lead = monic(poly)
        return self._signs.get(key, (0, False))[0] * lead


@dataclass(frozen=True)
class Node:
    """Points of a case.

    Attributes
    ----------
    equations : tuple of Poly
        Polynomials that vanish there.
    nonzero : frozenset of str
        Keys of polynomials that are nonzero there.
    numerators : sequence of Poly, or None
        Numerators of the residuals; None if the tree does not concern residuals.
    leaf : callable
        Function for a leaf that is neither empty nor shown to be zero.
    """

    ring: Ring
    equations: tuple[Poly, ...]
    nonzero: frozenset[str]
    signs: Signs
    numerators: Sequence[Poly] | None
    leaf: Leaf

    def with_equations(self, *more: Poly) -> Node:
        """Case with further equations."""
        return replace(self, equations=(*self.equations, *more))

    def is_nonzero(self, poly: Poly) -> bool:
        """True if a polynomial is known to be nonzero."""
        if poly.is_constant():
            return not poly.is_zero()
        return monic(poly)[0] in self.nonzero or bool(self.signs.of(poly))

    def strict_sign(self, poly: Poly) -> int:
        """Sign of a polynomial where it is certain; otherwise 0."""
        sign = self.signs.of(poly)
        if sign or poly.is_zero():
            return sign
        return self.signs.weak(poly) if self.is_nonzero(poly) else 0


def _short_text(poly: Poly) -> str:
    words = str(poly)
    return words if len(words) < 60 else words[:57] + "..."


def check_tree(node: Node, data: object, where: str = "the tree", depth: int = 0) -> None:
    """Check a case tree; CheckError if it fails."""
    if depth > DEPTH:
        raise CheckError(f"the tree is deeper than {DEPTH}")
    data = mapping(data, where)
    case = field(data, "case", where)
    if case == "zero":
        _zero(node, data, where)
    # A case is empty if 1 lies in the ideal of the equations, up to factors that are nonzero
    # there.
    elif case == "empty":
        only(data, where, "case", "factors", "constant", "quotients")
        _check_membership(node, node.ring.constant(1), data, where)
    elif case == "split":
        _split(node, data, where, depth)
    elif case == "vanishing":
        _vanishing(node, data, where, depth)
    elif case == "squares":
        _squares(node, data, where, depth)
    elif case in ("unproven", "proof"):
        node.leaf(node, data, where)
    else:
        raise CheckError(f"{where} has a case {case!r}, which is unknown")


def _constant(data: object, what: str) -> fmpq:
    number = rational(data, what)
    if not number:
        raise CheckError(f"{what} is zero")
    return fmpq(number.numerator, number.denominator)


def _multiplier(node: Node, data: object, where: str) -> Poly:
    powers = node.ring.powers(data, f"the factors in {where}")
    for poly, _ in powers:
        if not node.is_nonzero(poly):
            raise CheckError(f"{where} multiplies by {_short_text(poly)}, which may vanish")
    return node.ring.expanded_product(powers)


def _combination(node: Node, data: object, where: str) -> Poly:
    """Sum of quotients times equations."""
    quotients = items(data, len(node.equations), f"the quotients in {where}")
    total = node.ring.constant(0)
    for quotient, equation in zip(quotients, node.equations, strict=True):
        total = total + node.ring.read(quotient, f"a quotient in {where}") * equation
    return total


def _check_membership(node: Node, poly: Poly, data: Mapping[str, object], where: str) -> None:
    """Check constant · ∏ factors · poly = Σ quotient · equation."""
    constant = _constant(field(data, "constant", where), f"the constant in {where}")
    multiplier = _multiplier(node, field(data, "factors", where), where)
    combined = _combination(node, field(data, "quotients", where), where)
    if constant * multiplier * poly != combined:
        raise CheckError(f"{where}: an identity of polynomials does not hold")


def _zero(node: Node, data: Mapping[str, object], where: str) -> None:
    only(data, where, "case", "identities")
    if node.numerators is None:
        raise CheckError(f"{where} has a case 'zero', which is not allowed there")
    numbers = set()
    for item in as_list(field(data, "identities", where), where):
        identity = mapping(item, where)
        only(identity, where, "residual", "factors", "constant", "quotients")
        last = len(node.numerators) - 1
        number = integer(field(identity, "residual", where), f"a residual in {where}", 0, last)
        if number in numbers:
            raise CheckError(f"{where} has residual {number} twice")
        numbers.add(number)
        _check_membership(node, node.numerators[number], identity, f"{where}, residual {number}")
    missing = set(range(len(node.numerators))) - numbers
    if missing:
        raise CheckError(f"{where} does not show that residual {min(missing)} vanishes")


def _membership(node: Node, data: Mapping[str, object], where: str) -> Poly:
    """Polynomial P that vanishes by ∏ by · P = Σ quotient · equation."""
    poly = node.ring.read(field(data, "polynomial", where), f"the polynomial of {where}")
    by = _multiplier(node, field(data, "by", where), where)
    if by * poly != _combination(node, field(data, "quotients", where), where):
        raise CheckError(f"{where}: the polynomial is not shown to vanish")
    return poly


def _split(node: Node, data: Mapping[str, object], where: str, depth: int) -> None:
    names = ("polynomial", "factors", "constant", "by", "quotients", "children")
    only(data, where, "case", *names)
    poly = _membership(node, data, where)
    factors = node.ring.powers(field(data, "factors", where), f"the factors of {where}")
    constant = _constant(field(data, "constant", where), f"the constant of {where}")
    if poly != constant * node.ring.expanded_product(factors):
        raise CheckError(f"{where}: the factors do not make the polynomial")
    # A product is zero only where a factor is; the factors that cannot vanish need no case.
    vanishing = [factor for factor, _ in factors if not node.is_nonzero(factor)]
    children = items(field(data, "children", where), len(vanishing), f"the children of {where}")
    for number, (factor, child) in enumerate(zip(vanishing, children, strict=True), 1):
        check_tree(node.with_equations(factor), child, f"{where}.{number}", depth + 1)


def _vanishing(node: Node, data: Mapping[str, object], where: str, depth: int) -> None:
    only(data, where, "case", "polynomial", "nonzero", "zero")
    poly = node.ring.read(field(data, "polynomial", where), f"the polynomial of {where}")
    if poly.is_zero():
        raise CheckError(f"{where} has a case 'vanishing' for the polynomial 0")
    other = replace(node, nonzero=node.nonzero | {monic(poly)[0]})
    check_tree(other, field(data, "nonzero", where), f"{where}.nonzero", depth + 1)
    zero = node.with_equations(poly)
    check_tree(zero, field(data, "zero", where), f"{where}.zero", depth + 1)


def _squares(node: Node, data: Mapping[str, object], where: str, depth: int) -> None:
    only(data, where, "case", "polynomial", "by", "quotients", "terms", "child")
    poly = _membership(node, data, where)
    # A sum of squares with positive weights is zero only where every base is zero, so the bases
    # become equations.
    total = node.ring.constant(0)
    bases = []
    for term in as_list(field(data, "terms", where), f"the terms of {where}"):
        weight, constant, base = items(term, 3, f"a term of {where}")
        powers = node.ring.powers(weight, f"a weight of {where}")
        number = _constant(constant, f"a constant of {where}")
        (inner,) = items(base, 1, f"a base of {where}")
        inner_base = node.ring.read(inner, f"a base of {where}")
        if number < 0:
            raise CheckError(f"{where} has a negative square")
        for part, power in powers:
            certain = node.is_nonzero(part) if power % 2 == 0 else node.strict_sign(part) > 0
            if not certain:
                raise CheckError(
                    f"{where} has a weight {_short_text(part)} that may not be positive"
                )
        total = total + number * node.ring.expanded_product(powers) * inner_base**2
        bases.append(inner_base)
    if total != poly:
        raise CheckError(f"{where}: the squares do not make the polynomial")
    check_tree(node.with_equations(*bases), field(data, "child", where), where + ".1", depth + 1)
