"""Small Gröbner bases with the cofactors of every element in the equations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from flint import Ordering, fmpq_mpoly_ctx

from ..fields.budget import Budget
from ..fields.quotient_ring import Poly

#: Polynomials by the index of the equation that they multiply.
Multiples = dict[int, Poly]

MOST_ELEMENTS = 90
MOST_TERMS = 300


@dataclass(frozen=True)
class _Element:
    """A basis element Σ by_i · equation_i with the exponents of its leading monomial."""

    poly: Poly
    by: Multiples
    lead: tuple[int, ...]


class Basis:
    """A Gröbner basis by Buchberger's algorithm, extended only as far as a division needs."""

    def __init__(self, ring: fmpq_mpoly_ctx, equations: Sequence[Poly], budget: Budget) -> None:
        self._input_ring = ring
        self._ring = fmpq_mpoly_ctx.get(ring.names(), Ordering.degrevlex)
        self._budget = budget
        self._elements: list[_Element] = []
        for i, equation in enumerate(equations):
            self._add(self._inside(equation), {i: self._ring.constant(1)})
        self._waiting = list(combinations(range(len(self._elements)), 2))

    def _grow(self, size: int) -> None:
        """Add elements until the basis has `size` elements or is complete."""
        waiting = self._waiting
        while waiting and len(self._elements) < size:
            # Normal selection: the pair with the least degree of lcm(lm f, lm g) first.
            waiting.sort(key=self._degree, reverse=True)
            first, second = waiting.pop()
            # Buchberger's criteria: coprime leading monomials, and pairs covered by a third
            # element.
            if self._apart(first, second) or self._is_superfluous(first, second, waiting):
                continue
            remainder, by = self._reduction(*self._difference(first, second))
            # Remainders that are too long are dropped: the result may be an incomplete basis, but
            # every element still lies in the ideal.
            if remainder and len(remainder) <= MOST_TERMS:
                self._add(remainder, by)
                last = len(self._elements) - 1
                waiting += [(i, last) for i in range(last)]

    def quotients(self, poly: Poly) -> Multiples | None:
        """Quotients q_i with poly = Σ q_i · equation_i; None if the basis does not provide them."""
        remainder, by = self._reduction(self._inside(poly), {})
        while remainder and self._waiting and len(self._elements) < MOST_ELEMENTS:
            self._grow(len(self._elements) + 10)
            remainder, by = self._reduction(remainder, by)
        if remainder:
            return None
        # The reduction subtracts multiples of basis elements, hence the minus sign.
        return {i: -self._input_ring.from_dict(part.to_dict()) for i, part in by.items() if part}

    def _inside(self, poly: Poly) -> Poly:
        return self._ring.from_dict(poly.to_dict())

    def _add(self, poly: Poly, by: Multiples) -> None:
        if poly:
            lead = tuple(map(int, poly.monoms()[0]))
            self._elements.append(_Element(poly, by, lead))

    def _degree(self, pair: tuple[int, int]) -> int:
        return sum(self._common(*pair))

    def _common(self, first: int, second: int) -> tuple[int, ...]:
        a, b = self._elements[first].lead, self._elements[second].lead
        return tuple(map(max, a, b))

    def _apart(self, first: int, second: int) -> bool:
        a, b = self._elements[first].lead, self._elements[second].lead
        return not any(x and y for x, y in zip(a, b, strict=True))

    def _is_superfluous(self, first: int, second: int, waiting: Sequence[tuple[int, int]]) -> bool:
        """Buchberger's second criterion: a third element covers the pair."""
        common, left = self._common(first, second), set(waiting)
        return any(
            k not in (first, second)
            and all(n <= c for n, c in zip(element.lead, common, strict=True))
            and (min(first, k), max(first, k)) not in left
            and (min(second, k), max(second, k)) not in left
            for k, element in enumerate(self._elements)
        )

    def _difference(self, first: int, second: int) -> tuple[Poly, Multiples]:
        """The S-polynomial of two elements, with its cofactors."""
        common = self._common(first, second)
        total: Poly = self._ring.constant(0)
        by: Multiples = {}
        for number, sign in ((first, 1), (second, -1)):
            element = self._elements[number]
            shift = tuple(c - n for c, n in zip(common, element.lead, strict=True))
            factor = self._ring.from_dict({shift: sign / element.poly.leading_coefficient()})
            total = total + factor * element.poly
            self._gather(by, element.by, factor)
        return total, by

    def _gather(self, by: Multiples, more: Mapping[int, Poly], factor: Poly) -> None:
        for i, part in more.items():
            self._budget.foresee(factor, part)
            product = factor * part
            by[i] = by[i] + product if i in by else product

    def _reduction(self, poly: Poly, by: Multiples) -> tuple[Poly, Multiples]:
        """The remainder on division by the basis, with the cofactors updated."""
        by = dict(by)
        while poly:
            before = poly
            for element in self._elements:
                quotient, remainder = divmod(poly, element.poly)
                if quotient:
                    self._budget.foresee(quotient, element.poly)
                    self._gather(by, element.by, -quotient)
                    poly = remainder
                if not poly:
                    break
            if poly == before:
                break
        return poly, by
