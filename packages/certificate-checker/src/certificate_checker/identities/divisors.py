"""Divisors of a law as products of nonzero polynomials."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction

from ..claim.domain import GRAM
from ..claim.errors import CheckError
from ..claim.formulas import Formula
from ..claim.jets import Number
from ..claim.json_data import as_list, choice, field, mapping, only, rational, text
from ..claim.parsing import parse
from ..claim.polynomials import Powers, monic
from ..claim.residuals import gram_determinants
from .comparisons import Comparisons
from .generators import Generators
from .residues import UnknownRootError


@dataclass(frozen=True)
class Entry:
    """Formula as a product: content · ∏ factor^power.

    Attributes
    ----------
    formula : Formula or None
        None for the volume of the conditions.
    where : str
        Side of an isomorphism to which it belongs.
    """

    label: str
    content: Fraction
    powers: Powers
    formula: Formula | None
    where: str


def read_divisors(
    data: Mapping[str, object], generators: Generators, what: str
) -> tuple[Entry, ...]:
    """Divisors and radicands that a proof states as products."""
    entries = []
    ring = generators.ring
    for number, data_of_one in enumerate(as_list(field(data, "divisors", what), what)):
        label = f"divisor {number} of {what}"
        item = mapping(data_of_one, label)
        only(item, label, "formula", "content", "factors", "where")
        powers = ring.powers(field(item, "factors", label), label, negative=True)
        content = rational(field(item, "content", label), label)
        if not content:
            raise CheckError(f"{label} is zero")
        shown = text(field(item, "formula", label), label)
        where = choice(item.get("where", "own"), label, "own", "target")
        if where == "target" and generators.claim.law.target is None:
            raise CheckError(f"{label} belongs to a target, but the law has none")
        formula = None if shown == GRAM else parse(shown, label)
        entries.append(Entry(label, content, powers, formula, where))
    return tuple(entries)


class Matches:
    """Divisors and radicands of the law, matched with products stated in a proof.

    Formulas with roots can be compared once the signs of the factors of these roots are known;
    earlier matches remain valid.
    """

    def __init__(
        self, generators: Generators, entries: Sequence[Entry], comparisons: Comparisons
    ) -> None:
        self.generators, self.entries, self.comparisons = generators, entries, comparisons
        self._values = [comparisons.product(e.content, e.powers) for e in entries]
        for entry, values in zip(entries, self._values, strict=True):
            comparisons.add_product(values, entry.content, entry.powers)
        self._left = [*range(len(entries))]
        self._of_domain: dict[int, list[Number] | None] = {}
        #: Entries that are divisors or radicands of the law.
        self.of_law: list[Entry] = []

    @property
    def radicands(self) -> list[Entry]:
        """Entries that are radicands or arguments of logarithms, and therefore positive."""
        domain = self.generators.domain
        first, count = len(domain.nonzero), len(domain.positive) + len(domain.logarithms)
        places = range(first, first + count)
        positive = [self._of_domain[i] for i in places if i in self._of_domain]
        pairs = zip(self.entries, self._values, strict=True)
        return [entry for entry, values in pairs if entry in self.of_law and values in positive]

    def extend(self) -> bool:
        """Find more matches; True if there are any."""
        before = len(self._left), len(self._of_domain)
        for i, (where, formula) in enumerate(self.generators.domain.formulas):
            if i not in self._of_domain:
                with suppress(UnknownRootError):
                    self._of_domain[i] = self.comparisons.formula(formula, where)
        left, self._left = self._left, []
        for number in left:
            try:
                self._match(self.entries[number], self._values[number])
            except UnknownRootError:
                self._left.append(number)
        return (len(self._left), len(self._of_domain)) != before

    def require_all(self) -> None:
        """Raise CheckError unless every entry was matched."""
        for number in self._left:
            self._match(self.entries[number], self._values[number])

    def _match(self, entry: Entry, values: list[Number]) -> None:
        if entry.formula is not None:
            stated = self.comparisons.formula(entry.formula, entry.where)
            if stated is None:
                raise CheckError(f"{entry.label} is not defined")
            if stated != values:
                raise CheckError(f"{entry.label}: its factors do not make the formula")
        domain = self.generators.domain
        alike = values in self._of_domain.values() or (domain.gram and self._is_volume(values))
        if not alike and len(self._of_domain) < len(domain.formulas):
            raise UnknownRootError(f"{entry.label} is nothing by which the law is seen to divide")
        if not alike:
            raise CheckError(f"{entry.label} is nothing by which the law divides")
        self.of_law.append(entry)

    def _is_volume(self, values: list[Number]) -> bool:
        points = [s.point for s in self.comparisons.samples]
        rows = [gram_determinants(self.generators.claim, point) for point in points]
        return any(list(column) == values for column in zip(*rows, strict=True))


def nonzero_factors(
    generators: Generators, entries: Sequence[Entry], symbols: Iterable[str]
) -> frozenset[str]:
    """Keys of nonzero factors, given that symbols and factors of denominators are nonzero."""
    keys = {monic(generators.ring.generator(name))[0] for name in symbols}
    for names, _ in generators.inverses:
        # The inverse of a matrix is invertible, so its determinant is nonzero.
        a, b, c, d, e, f = (generators.ring.generator(word) for word in names)
        keys.add(monic(a * (d * f - e * e) + b * (c * e - b * f) + c * (b * e - c * d))[0])
    # A nonzero product with nonzero denominators has only nonzero factors; each result may
    # complete the denominators of other entries.
    changed = True
    while changed:
        changed = False
        for entry in entries:
            below = {monic(p)[0] for p, n in entry.powers if n < 0 and not p.is_constant()}
            above = {monic(p)[0] for p, n in entry.powers if n > 0 and not p.is_constant()}
            if below <= keys and not above <= keys:
                keys |= above
                changed = True
    return frozenset(keys)
