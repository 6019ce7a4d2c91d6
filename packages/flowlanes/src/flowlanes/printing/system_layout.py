"""The layout of the page of a system: equations and definitions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import sympy as sp

from ..system.named_formulas import Pairs, flat
from ..system.system import System
from ..system.vector_operators import Gradient
from ..system.vectors import Diagonal, Symmetric, Vector, to_components


@dataclass(frozen=True)
class Layout:
    """The formulas of a system in reading order.

    Attributes
    ----------
    field : pairs
        State and rates; a rate that is only a name (ẋ) is replaced by its definition, and left
        out if it belongs to the state itself.
    where : pairs
        Tensors and vectors of parameters in components, then the definitions that the vector field
        needs, in order.
    further : pairs
        The same for additional definitions of laws and relations.
    """

    field: Pairs
    where: Pairs
    further: Pairs


def layout(system: System) -> Layout:
    """The formulas of a system, each once, in reading order.

    Quantities defined as zero are omitted from the equations of motion.
    """
    page = _page_of(system)
    zeros = {
        name: sp.S.Zero for name, value in page.where if isinstance(name, sp.Symbol) and value == 0
    }

    def short(pairs: Pairs) -> Pairs:
        return tuple((name, _without(zeros, value)) for name, value in pairs)

    return replace(page, field=short(page.field), where=short(page.where))


def _without(zeros: dict[sp.Symbol, sp.Basic], value: sp.Basic) -> sp.Basic:
    """A scalar formula with `zeros` substituted; formulas with vectors are unchanged."""
    plain = isinstance(value, sp.Expr) and not value.atoms(Vector, Diagonal, Symmetric)
    return value.xreplace(zeros) if plain and value.free_symbols & zeros.keys() else value


def _page_of(system: System) -> Layout:
    field, spelt_out = _with_rates_spelt_out(system, system.field)
    if system.printed_definitions:
        # A rate that is only a name has its equation among the printed definitions.
        stated = tuple(pair for pair in field if str(pair[1]) != f"{pair[0]}dot")
        return Layout(stated, system.printed_definitions, ())
    needed = _needed_definitions(system, [formula for _, formula in system.field])
    where = tuple(pair for pair in needed if pair[0] not in spelt_out)
    claims = [formula for law in system.laws for formula in law.formulas]
    claims += system.relations
    extra = tuple(pair for pair in _needed_definitions(system, claims) if pair not in needed)
    tensors = _parameter_tensors(system, [formula for _, formula in (*field, *where)])
    further_tensors = _parameter_tensors(system, [*claims, *(formula for _, formula in extra)])
    return Layout(
        field=field,
        where=tensors + where,
        further=tuple(pair for pair in further_tensors if pair not in tensors) + extra,
    )


def reconstruction_layout(system: System) -> Layout:
    """The equations of the lift to space, with their additional definitions."""
    field, spelt_out = _with_rates_spelt_out(
        system, system.reconstruction.field if system.reconstruction else ()
    )
    page = layout(system)
    shown = set(flat([*spelt_out, *(name for name, _ in (*page.where, *page.further))]))
    steps = system.required_definitions(formula for _, formula in field)
    return Layout(field, tuple(pair for pair in steps if pair[0] not in shown), ())


def _with_rates_spelt_out(system: System, field: Pairs) -> tuple[Pairs, set[sp.Basic]]:
    """Rates with mere names replaced or omitted, and the set of replaced names."""
    definitions = dict(system.definitions)
    pairs, names = [], set()
    for name, formula in field:
        named = str(formula) == f"{name}dot"
        if named and formula in system.state:
            continue
        trivial = named and formula in definitions
        pairs.append((name, definitions[formula] if trivial else formula))
        if trivial:
            names.add(formula)
    return tuple(pairs), names


def _mentioned_symbols(formula: sp.Basic) -> set[sp.Symbol]:
    """Symbols on which a formula depends or whose name it shows, as ∂U/∂u shows U."""
    shown: set[sp.Symbol] = {gradient.args[2] for gradient in formula.atoms(Gradient)}
    return shown.union(to_components(formula).free_symbols)


def _needed_definitions(system: System, formulas: Iterable[sp.Basic]) -> Pairs:
    """The definitions on which formulas depend, in order."""
    wanted = set().union(*map(_mentioned_symbols, formulas))
    chosen = []
    for name, formula in reversed(system.definitions):
        if not wanted.isdisjoint(flat([name])):
            chosen.append((name, formula))
            wanted |= _mentioned_symbols(formula)
    return tuple(reversed(chosen))


def _parameter_tensors(system: System, formulas: Iterable[sp.Basic]) -> Pairs:
    """Tensors and vectors of parameters, in components."""
    known = {name for name, _ in system.field} | {name for name, _ in system.definitions}
    atoms = set().union(*(formula.atoms(Vector, Diagonal, Symmetric) for formula in formulas))
    components = []
    for name in sorted(atoms - known, key=str):
        entries = to_components(name) if isinstance(name, Vector) else name.entries
        components.append((name, entries))
    return tuple(components)
