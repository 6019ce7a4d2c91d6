"""The place of a system in the hierarchy of dynamics (§3, §4).

Proven laws restrict the motions that a system can have.

A classification is based on verdicts alone.  Undecided or refuted laws do not count, and are named.
Laws that hold on a level count on that level; laws for special parameters count if the present ones
satisfy the condition exactly.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from dataclasses import asdict, dataclass

from flowlanes.system.overview import Overview, WithOverview

from .facts import HERE, Fact
from .statements import Bracket, Density, IgnoredLaw, IntegrabilityClass, Statement

WIDTH = 100
COLUMN = 16

_DENSITIES = {
    "kept": "density positive and finite everywhere",
    "changes": "density vanishes or is infinite somewhere",
    "unknown": "sign of the density not decided everywhere",
}
_MULTIPLIERS = {
    "kept": "multiplier without zeros",
    "changes": "multiplier vanishes or is infinite somewhere",
    "unknown": "sign of the multiplier not decided everywhere",
}


@dataclass(frozen=True, repr=False)
class Classification(WithOverview):
    """The place of a system, or of one of its levels, in the hierarchy of dynamics.

    Attributes
    ----------
    system : str
        Title of the system.
    level : str
        Description of the level; empty for the whole phase space.
    variables, conditions : int
        Number of state variables, and rank of the conditions between them.
    integrals : tuple of Fact
        Independent first integrals.
    count : int
        Number of independent integrals: a reduction to linear equations gives several.
    dependent : tuple of Fact
        Other integrals, which by rank are functions of the independent ones.
    measures : tuple of Density
    absence : str
        Reason why no measure has a density that depends on the configuration alone, if proven.
    brackets : tuple of Bracket
    symmetries : tuple of Fact
        Fields that commute with the flow and are independent of it and of one another.
    reversal : tuple of str
        Variables whose change of sign reverses the motion in time; determined only if no measure
        excludes attracting sets.
    reductions : tuple of Fact
        Further proven reductions, separations, isomorphisms.
    kinds : tuple of IntegrabilityClass
    dynamics : tuple of Statement
        The possible kinds of motion.
    ignored_laws : tuple of IgnoredLaw
    levels : tuple of Classification
        Levels on which more is proven.
    reason : str
        Reason why the system could not be classified; empty otherwise.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> place = nonholonomic.classify(pendulum)
    >>> place.variables, place.count
    (2, 0)
    """

    system: str
    level: str
    variables: int
    conditions: int
    integrals: tuple[Fact, ...] = ()
    count: int = 0
    dependent: tuple[Fact, ...] = ()
    measures: tuple[Density, ...] = ()
    absence: str = ""
    brackets: tuple[Bracket, ...] = ()
    symmetries: tuple[Fact, ...] = ()
    reversal: tuple[str, ...] = ()
    reductions: tuple[Fact, ...] = ()
    kinds: tuple[IntegrabilityClass, ...] = ()
    dynamics: tuple[Statement, ...] = ()
    ignored_laws: tuple[IgnoredLaw, ...] = ()
    levels: tuple[Classification, ...] = ()
    reason: str = ""

    @property
    def dimension(self) -> int:
        """Dimension of the phase space, or of the level."""
        return self.variables - self.conditions

    @property
    def remaining(self) -> int:
        """Dimension of a common level of the integrals."""
        return self.dimension - self.count

    @property
    def uncounted_by_reason(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Reasons why laws do not count, each with the names of the laws."""
        laws: dict[str, tuple[str, ...]] = {}
        for entry in self.ignored_laws:
            laws[entry.why] = (*laws.get(entry.why, ()), entry.law)
        return tuple(laws.items())

    @property
    def record(self) -> dict[str, object]:
        """All results as JSON-compatible data."""
        return record(self)

    def overview(self) -> Overview:
        """Laws and consequences, without the levels on which more is proven."""
        where = f", on {self.level}" if self.level else ""
        counted = (
            (label, "; ".join(one.text.removesuffix(".") for one in statements))
            for label, statements in rows(self)
        )
        return Overview(
            f"{self.system}{where}: place in the hierarchy of dynamics",
            (*counted, ("not counted", self.reason)),
        )

    def __str__(self) -> str:
        return to_text(self)


def listing(facts: Iterable[Fact]) -> str:
    """Facts by name and source, without duplicates."""
    return "; ".join(dict.fromkeys(map(str, facts)))


def rows(place: Classification) -> list[tuple[str, list[Statement]]]:
    """Headings with the statements below them."""
    if place.reason:
        return [("class", [Statement(kind.text, kind.by) for kind in place.kinds])]
    return [
        ("phase space", [Statement(_space(place))]),
        ("integrals", _integrals(place)),
        ("measure", _measures(place)),
        ("Poisson", [_bracket(b) for b in place.brackets] or [_NO_FORM]),
        ("symmetry", [_symmetry(place)]),
        ("equivalent", [Statement(f.words, (f,)) for f in place.reductions]),
        ("class", [Statement(kind.text, kind.by) for kind in place.kinds]),
        ("motions", list(place.dynamics)),
    ]


_NO_FORM = Statement("no Hamiltonian form proven")


def _space(place: Classification) -> str:
    sentence = f"{place.dimension}-dimensional: {place.variables} variables"
    if place.conditions:
        what = "condition" if place.conditions == 1 else "conditions"
        sentence += f", {place.conditions} independent {what}"
    return sentence


def _integrals(place: Classification) -> list[Statement]:
    if not place.count:
        return [Statement("none proven")]
    sentence = f"{place.count} independent, common levels of dimension {place.remaining}"
    statements = [Statement(sentence, place.integrals)]
    if place.dependent:
        statements.append(
            Statement("not independent of these at the points tested", place.dependent)
        )
    return statements


def _measures(place: Classification) -> list[Statement]:
    if place.measures:
        return [Statement(_measure(d), (d.law,)) for d in place.measures]
    if place.brackets:
        return [Statement("that of the Hamiltonian form, on its symplectic leaves (§3.3)")]
    if place.absence:
        sentence = "none whose density depends on the configuration alone exists"
        return [Statement(f"{sentence}: {place.absence}")]
    return [Statement("none proven")]


def _measure(density: Density) -> str:
    known = _DENSITIES[density.sign]
    return f"{density.law.words}; {known}" if density.law.source == HERE else known


def _bracket(bracket: Bracket) -> Statement:
    form = "conformally Hamiltonian" if bracket.conformal else "Hamiltonian"
    sentence = f"{form}, rank {bracket.rank}"
    if bracket.casimirs:
        sentence += f", Casimir functions {', '.join(bracket.casimirs)}"
    if bracket.conformal:
        sentence += f"; {_MULTIPLIERS[bracket.sign]}"
    return Statement(sentence, (bracket.law,))


def _symmetry(place: Classification) -> Statement:
    count = len(place.symmetries)
    if not count:
        return Statement("no field proven")
    sentence = "one field" if count == 1 else f"{count} independent fields"
    return Statement(f"{sentence} besides the flow itself", place.symmetries)


def to_text(place: Classification) -> str:
    """The classification as text, in lines of at most 100 characters."""
    lines = ["Place in the hierarchy of dynamics"]
    lines += _lines(place)
    for part in place.levels:
        lines += ["", f"  {part.level}".rstrip(), *_lines(part)]
    if place.ignored_laws:
        lines += [""]
        entries = [f"{', '.join(laws)}: {why}" for why, laws in place.uncounted_by_reason]
        lines += _entry("not counted", entries)
    return "\n".join(lines)


def _lines(place: Classification) -> list[str]:
    lines: list[str] = []
    for name, entries in rows(place):
        write = _names_of if name in ("class", "motions") else _text_with_source
        lines += _entry(name, map(write, entries))
    return lines


def _text_with_source(statement: Statement) -> str:
    return f"{statement.text} [{listing(statement.by)}]" if statement.by else statement.text


def _names_of(statement: Statement) -> str:
    names = ", ".join(dict.fromkeys(fact.law for fact in statement.by))
    return f"{statement.text} [{names}]" if names else statement.text


def _entry(name: str, entries: Iterable[str]) -> list[str]:
    lines: list[str] = []
    for number, text in enumerate(entries):
        head = f"    {name if number == 0 else '':<{COLUMN - 4}}"
        lines += textwrap.wrap(
            text, WIDTH, initial_indent=head, subsequent_indent=" " * (COLUMN + 2)
        )
    return lines


def record(place: Classification) -> dict[str, object]:
    """The classification as plain lists and mappings."""
    levels = [record(part) for part in place.levels]
    return {
        **asdict(place),
        "dimension": place.dimension,
        "remaining": place.remaining,
        "levels": levels,
    }
