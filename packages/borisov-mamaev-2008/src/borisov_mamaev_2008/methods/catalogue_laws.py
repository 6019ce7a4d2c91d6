"""Laws of systems by name, and their printed forms."""

from __future__ import annotations

from flowlanes.system.laws import Law
from flowlanes.system.system import System


def law_named(system: System, name: str) -> Law:
    """The law of a system with a given name.

    Raises
    ------
    KeyError
        If the system has no such law.
    """
    for law in system.laws:
        if law.name == name:
            return law
    raise KeyError(f"{system.name} has no law {name!r}")


def laws_named(system: System, *names: str) -> tuple[tuple[System, Law], ...]:
    """A system paired with each of several of its laws."""
    return tuple((system, law_named(system, name)) for name in names)


def printed_form(law: Law) -> Law:
    """The misprinted form of a law.

    Raises
    ------
    ValueError
        If the law is printed correctly.
    """
    if law.as_printed is None:
        raise ValueError("the paper prints this law as it is")
    return law.as_printed
