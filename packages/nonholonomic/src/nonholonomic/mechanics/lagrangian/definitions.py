"""Definitions in readable form: few, numbered in order, vectors kept as vectors."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter

import sympy as sp

from flowlanes.formulas.tape import Step
from flowlanes.system.named_formulas import Pairs, flat, scalars
from flowlanes.system.system import Name
from flowlanes.system.vectors import Vector, constant, real_symbol, to_components

from .assembly import Balance

SHORT = 12
"""Largest number of operations of a value that is inlined if it is used only once."""


@dataclass(frozen=True)
class NamedDefinitions:
    """Definitions in order, with the replacements of names that were dropped.

    Attributes
    ----------
    definitions : pairs
    table : mapping of Symbol to Expr
        Replacements of dropped names.
    """

    definitions: Pairs
    table: Mapping[sp.Symbol, sp.Expr]

    def __call__(self, formula: sp.Basic) -> sp.Basic:
        """The formula in the remaining names."""
        value = to_components(formula)
        return formula if not value.free_symbols & self.table.keys() else value.xreplace(self.table)


def name_definitions(parts: Balance, formulas: Sequence[sp.Expr]) -> NamedDefinitions:
    """The definitions on which formulas depend.

    Short intermediate results used once are inlined; the others are numbered in order. Vectors keep
    their original form where possible.
    """
    wanted = scalars(tuple(formulas))
    steps = parts.tape.steps(wanted)
    uses: Counter[sp.Symbol] = Counter()
    for value in (*wanted, *(v for _, v in steps)):
        uses.update(n for n in sp.preorder_traversal(value) if n.is_Symbol)
    own = _own(parts)
    table: dict[sp.Symbol, sp.Expr] = {}
    remaining: list[Step] = []
    for symbol, value in steps:
        written = value.xreplace(table)
        if symbol not in own and uses[symbol] < 2 and sp.count_ops(written) <= SHORT:
            table[symbol] = written
        else:
            remaining.append((symbol, written))
    numbered = _numbered_names(parts, [s for s, _ in remaining if s not in own])
    definitions = [(numbered.get(s, s), value.xreplace(numbered)) for s, value in remaining]
    gone = {s: value.xreplace(numbered) for s, value in table.items()}
    return NamedDefinitions(_vector_definitions(parts, definitions), {**gone, **numbered})


def _own(parts: Balance) -> set[sp.Symbol]:
    """Names given by the user: of the mechanism, solved velocities and multipliers."""
    defined = {s for s, _ in parts.mechanism.steps}
    return defined | {*parts.constraint_of} | {*parts.multipliers}


def _numbered_names(parts: Balance, symbols: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Symbol]:
    """New names z_1, z_2, … in order, skipping names used by the mechanism."""
    own = {s for s in symbols if str(s).startswith("z_")}
    mechanism = parts.mechanism
    parameters = {p.symbol for p in mechanism.parameters}
    used = parameters | {*mechanism.symbols} | _own(parts)
    names: dict[sp.Symbol, sp.Symbol] = {}
    number = 0
    for symbol in symbols:
        if symbol in own:
            number += 1
            while real_symbol(f"z_{number}") in used:
                number += 1
            names[symbol] = real_symbol(f"z_{number}")
    return names


def _vector_definitions(parts: Balance, steps: Sequence[Step]) -> Pairs:
    """Scalar steps with components joined to vectors, if their dependences allow it."""
    mechanism = parts.mechanism
    values = dict(steps)
    groups: dict[Name, sp.Basic] = {
        name: formula
        for name, formula in mechanism.definitions
        if not isinstance(name, sp.Symbol) and any(s in values for s in name.symbols)
    }
    for name in mechanism.frame.velocities:
        if not isinstance(name, sp.Symbol) and all(s in values for s in name.symbols):
            components = constant([values[s] for s in name.symbols])
            groups[name] = _as_written(mechanism.constraints, name, components)
    home: dict[sp.Symbol, Name] = {s: name for name in groups for s in flat((name,))}
    graph: dict[Name, list[Name]] = {}
    for node in dict.fromkeys(home.get(s, s) for s, _ in steps):
        formula = to_components(groups[node]) if node in groups else values[node]
        needs = dict.fromkeys(
            home.get(s, s) for s in sorted(formula.free_symbols, key=str) if s in home | values
        )
        graph[node] = [n for n in needs if n != node]
    try:
        order = list(TopologicalSorter(graph).static_order())
    except CycleError:
        return tuple(steps)
    return tuple((node, groups[node] if node in groups else values[node]) for node in order)


def _as_written(constraints: Sequence[sp.Basic], name: Vector, components: sp.Matrix) -> sp.Basic:
    """A vector constraint u + … = 0 solved for u, if it gives these components."""
    for formula in constraints:
        if not getattr(formula, "is_Matrix", False) or name not in formula.atoms(type(name)):
            continue
        for sign in (-1, 1):
            solution = (sign * formula + name).doit()
            same = to_components(solution) - components
            if all(sp.expand(e) == 0 for e in same):
                return solution
    return components
