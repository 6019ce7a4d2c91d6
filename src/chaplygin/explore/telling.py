"""A place in the hierarchy of dynamics, for a reader and for another program."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from .proofs import Fact

if TYPE_CHECKING:
    from .hierarchy import Density, Place

__all__ = ["listed", "record", "rows", "told", "words_of_density"]

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


def words_of_density(density: Density) -> str:
    """What is known of the sign of a density."""
    return _DENSITIES[density.sign]


def listed(facts: Iterable[Fact]) -> str:
    """Facts by name and source, each once."""
    return "; ".join(dict.fromkeys(map(str, facts)))


def rows(place: Place) -> list[tuple[str, list[str]]]:
    """What is counted, as headings with entries."""
    relations = "condition" if place.conditions == 1 else "conditions"
    space = f"{place.dimension}-dimensional: {place.variables} variables"
    if place.conditions:
        space += f", {place.conditions} independent {relations}"
    count = f"{place.count} independent" if place.count else "none proven"
    found: list[tuple[str, list[str]]] = [
        ("phase space", [space]),
        (
            "integrals",
            [
                f"{count}: {listed(place.integrals)} — common levels of dimension {place.remaining}"
                if place.count
                else count
            ],
        ),
        (
            "measure",
            [f"{d.law}: {words_of_density(d)}" for d in place.measures]
            or ["that of the Hamiltonian form (§3.3)" if place.brackets else "none proven"],
        ),
    ]
    if place.dependent:
        found[1][1].append(f"functions of these: {listed(place.dependent)}")
    found.append(
        ("Poisson", [_bracket(b) for b in place.brackets] or ["no Hamiltonian form proven"])
    )
    found.append(("symmetry", [listed(place.symmetries) or "no field proven"]))
    if place.reductions:
        found.append(("equivalent", [f"{f}: {f.words}" for f in place.reductions]))
    return found


def _bracket(bracket: Any) -> str:
    form = "conformally Hamiltonian" if bracket.conformal else "Hamiltonian"
    told = f"{bracket.law}: {form}, rank {bracket.rank}"
    if bracket.casimirs:
        told += f", Casimir functions {', '.join(bracket.casimirs)}"
    return f"{told}; {_MULTIPLIERS[bracket.sign]}" if bracket.conformal else told


def told(place: Place) -> str:
    """The place as text, lines of at most 100 characters."""
    lines = ["Place in the hierarchy of dynamics"]
    lines += _lines(place)
    for part in place.levels:
        lines += ["", f"  {part.level}".rstrip(), *_lines(part)]
    if place.uncounted:
        lines += [""]
        entries = [f"{u.law}: {u.why}" for u in place.uncounted]
        lines += _entry("not counted", entries)
    return "\n".join(lines)


def _lines(place: Place) -> list[str]:
    lines: list[str] = []
    for name, entries in rows(place):
        lines += _entry(name, entries)
    lines += _entry("class", [_with(kind.text, kind.by) for kind in place.kinds])
    lines += _entry("motions", [_with(s.text, s.by) for s in place.dynamics])
    return lines


def _with(text: str, by: tuple[Fact, ...]) -> str:
    names = ", ".join(dict.fromkeys(fact.law for fact in by))
    return f"{text} [{names}]" if names else text


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
