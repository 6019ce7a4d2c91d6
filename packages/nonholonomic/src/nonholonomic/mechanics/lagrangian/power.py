"""Data of the energy theorem: the equations that the accelerations of a mechanism solve.

They use the names of the finished system, in which short results are inlined and the others
numbered.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from flowlanes.formulas.tape import LARGEST
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.vectors import real_symbol
from lawproof.proof.power_theorem import PowerTheorem

from .accelerations import Accelerations
from .assembly import Balance
from .definitions import NamedDefinitions
from .generic_points import with_working_precision
from .ldl import product


def power_theorem(
    parts: Balance,
    solution: Accelerations,
    names: NamedDefinitions,
    relations: Sequence[sp.Expr],
) -> PowerTheorem | None:
    """The data of the energy theorem; None if a constraint is not homogeneous.

    Parameters
    ----------
    relations : sequence of Expr
        Relations of the frame and position constraints, as in the system.
    """
    solved = solution.equations
    velocities = tuple(parts.mechanism.frame.w[i] for i in parts.free)
    degrees = _degrees(parts, velocities, solved.slopes, solved.constraints)
    if degrees is None:
        return None
    data = [e for row in (*solved.mass, *solved.slopes) for e in row] + [
        *solved.force,
        *solved.drift,
    ]
    table, further = _final_names(parts, names, [*data, *solved.multipliers])

    def row(formulas: Iterable[sp.Expr]) -> tuple[sp.Expr, ...]:
        return tuple(f.xreplace(table) for f in formulas)

    opaque = [table[s] for s, _ in parts.tape.steps(data) if _stays_whole(parts, s)]
    return PowerTheorem(
        velocities=velocities,
        mass=tuple(map(row, solved.mass)),
        force=row(solved.force),
        drift=row(solved.drift),
        slopes=tuple(map(row, solved.slopes)),
        multipliers=row(solved.multipliers),
        constraints=tuple(names(f) for f in solved.constraints),
        degrees=degrees,
        positions=tuple(zip(relations, _rates_of_relations(parts, names), strict=True)),
        definitions=further,
        opaque=tuple(s for s in opaque if s.is_Symbol),
    )


@with_working_precision
def _degrees(
    parts: Balance,
    velocities: Iterable[sp.Symbol],
    slopes: Iterable[tuple[sp.Expr, ...]],
    constraints: Iterable[sp.Expr],
) -> tuple[sp.Integer, ...] | None:
    """The degrees of homogeneity of constraints in the velocities, from a generic point."""
    degrees = []
    for row, f in zip(slopes, constraints, strict=True):
        # By Euler's theorem Σ w_i ∂f/∂w_i = d f for a homogeneous f of degree d.
        euler = product(row, list(velocities))
        point = parts.at([f, euler])[0]
        if not point.value(f):
            return None
        degrees.append(sp.Integer(round(float(point.value(euler) / point.value(f)))))
    return tuple(degrees)


def _rates_of_relations(parts: Balance, names: NamedDefinitions) -> list[sp.Expr]:
    """The constraint equal to the rate of each relation and position constraint, or zero."""
    solved = set(parts.constraint_of.values())
    first = len(parts.mechanism.f)
    return [
        *(sp.S.Zero for _ in parts.mechanism.frame.relations),
        *(
            sp.S.Zero if first + i in solved else names(parts.constraints[first + i])
            for i in range(len(parts.mechanism.F))
        ),
    ]


def _final_names(
    parts: Balance, names: NamedDefinitions, formulas: Iterable[sp.Expr]
) -> tuple[Mapping[sp.Symbol, sp.Expr], tuple[tuple[sp.Symbol, sp.Expr], ...]]:
    """Names of the tape in terms of the finished system, and definitions it does not have."""
    kept = {s for s, _ in flat_pairs(names.definitions)}
    own = {s for s, _ in parts.mechanism.steps} | {*parts.constraint_of} | {*parts.multipliers}
    parameters = {p.symbol for p in parts.mechanism.parameters}
    used = {str(s) for s in kept | own | parameters | {*parts.mechanism.symbols}}
    table: dict[sp.Symbol, sp.Expr] = {}
    further: list[tuple[sp.Symbol, sp.Expr]] = []
    for symbol, value in parts.tape.steps(formulas):
        if symbol in names.table:
            table[symbol] = names.table[symbol]
        elif symbol in own and symbol in kept:
            table[symbol] = symbol
        else:
            fresh = _fresh(symbol, used)
            further.append((fresh, value.xreplace(table)))
            table[symbol] = fresh
    return table, tuple(further)


def _fresh(symbol: sp.Symbol, used: set[str]) -> sp.Symbol:
    """An unused name derived from that of a symbol."""
    name = f"{symbol}_"
    while name in used:
        name += "_"
    used.add(name)
    return real_symbol(name)


def _stays_whole(parts: Balance, symbol: sp.Symbol) -> bool:
    """Whether the tape never expands a name: it is a definition of the mechanism, or long.

    Only such names occur in the same form in the equations and in their solution.
    """
    tape = parts.tape
    inputs = {s for s, _ in parts.mechanism.steps}
    written = symbol
    while symbol not in inputs:
        inner = {s: v for s, v in tape.steps([written]) if s in written.free_symbols - inputs}
        if not inner:
            return False
        written = written.xreplace(inner)
        if sp.count_ops(written) > LARGEST:
            return True
    return True
