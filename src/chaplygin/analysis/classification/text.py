"""A place in the hierarchy of dynamics, for a reader and for another program."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from .facts import HERE, Fact
from .place import Bracket, Density, Statement

if TYPE_CHECKING:
    from .place import Place

__all__ = ["listed", "record", "rows", "told"]

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


def listed(facts: Iterable[Fact]) -> str:
    """Facts by name and source, each once."""
    return "; ".join(dict.fromkeys(map(str, facts)))


def rows(place: Place) -> list[tuple[str, list[Statement]]]:
    """What is counted: headings with statements."""
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


def _space(place: Place) -> str:
    told = f"{place.dimension}-dimensional: {place.variables} variables"
    if place.conditions:
        what = "condition" if place.conditions == 1 else "conditions"
        told += f", {place.conditions} independent {what}"
    return told


def _integrals(place: Place) -> list[Statement]:
    if not place.count:
        return [Statement("none proven")]
    told = f"{place.count} independent, common levels of dimension {place.remaining}"
    found = [Statement(told, place.integrals)]
    if place.dependent:
        found.append(Statement("not independent of these where it was tried", place.dependent))
    return found


def _measures(place: Place) -> list[Statement]:
    if place.measures:
        return [Statement(_measure(d), (d.law,)) for d in place.measures]
    if place.brackets:
        return [Statement("that of the Hamiltonian form, on its symplectic leaves (§3.3)")]
    if place.absence:
        told = "none whose density depends on the configuration alone exists"
        return [Statement(f"{told}: {place.absence}")]
    return [Statement("none proven")]


def _measure(density: Density) -> str:
    known = _DENSITIES[density.sign]
    return f"{density.law.words}; {known}" if density.law.source == HERE else known


def _bracket(bracket: Bracket) -> Statement:
    form = "conformally Hamiltonian" if bracket.conformal else "Hamiltonian"
    told = f"{form}, rank {bracket.rank}"
    if bracket.casimirs:
        told += f", Casimir functions {', '.join(bracket.casimirs)}"
    return Statement(
        f"{told}; {_MULTIPLIERS[bracket.sign]}" if bracket.conformal else told, (bracket.law,)
    )


def _symmetry(place: Place) -> Statement:
    count = len(place.symmetries)
    if not count:
        return Statement("no field proven")
    told = "one field" if count == 1 else f"{count} independent fields"
    return Statement(f"{told} besides the motion itself", place.symmetries)


def told(place: Place) -> str:
    """The place as text, lines of at most 100 characters."""
    lines = ["Place in the hierarchy of dynamics"]
    lines += _lines(place)
    for part in place.levels:
        lines += ["", f"  {part.level}".rstrip(), *_lines(part)]
    if place.uncounted:
        lines += [""]
        entries = [f"{', '.join(laws)}: {why}" for why, laws in place.uncounted_by_reason]
        lines += _entry("not counted", entries)
    return "\n".join(lines)


def _lines(place: Place) -> list[str]:
    lines: list[str] = []
    for name, entries in rows(place):
        write = _named if name in ("class", "motions") else _sourced
        lines += _entry(name, map(write, entries))
    return lines


def _sourced(statement: Statement) -> str:
    return f"{statement.text} [{listed(statement.by)}]" if statement.by else statement.text


def _named(statement: Statement) -> str:
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


def record(place: Place) -> dict[str, Any]:
    """The place for another program: plain lists and mappings."""
    levels = [record(part) for part in place.levels]
    return {
        **asdict(place),
        "dimension": place.dimension,
        "remaining": place.remaining,
        "levels": levels,
    }
