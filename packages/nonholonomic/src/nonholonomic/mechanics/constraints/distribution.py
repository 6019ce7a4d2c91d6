"""The distribution of admissible velocities of a mechanism (§2.1).

Constraints Σ a_μi(q) w_i = 0, (2.1), leave at each point a linear space of velocities, spanned
by the fields η_s = Σ w_i^(s) E_i of (2.2). Affine and time-dependent constraints are treated in the
space of (t, q), with ṫ as an additional velocity.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import with_exact_decimals
from flowlanes.system.named_formulas import expand
from flowlanes.system.vectors import real_symbol

from ..lagrangian.mechanism import TIME, Mechanism
from ..lagrangian.structure_functions import Coefficients, VectorField, lie_derivative
from .exact_points import ConfigurationSpace, ParameterValue
from .reconstruction import whole_configuration


@dataclass(frozen=True)
class Distribution:
    """A linear space of velocities at each point of a configuration space.

    Attributes
    ----------
    name : str
    coordinates : tuple of Symbol
        Coordinates, which may be redundant.
    relations : tuple of formula
        Expressions that vanish on the configuration space, including position constraints.
    velocities : tuple of Symbol
    frame : tuple of mapping from Symbol to formula
        E_i of (1.7) by coordinate, one for each velocity.
    forms : tuple of tuple of formula
        a_μi of (2.1), a row for each constraint; empty if `frame` spans the distribution.
    structure : mapping, optional
        c_ij^k of (1.8) if the frame acts on fewer coordinates than it has fields; None if the
        coordinates describe the whole configuration.
    steps : pairs (Symbol, formula)
        Definitions used by the formulas.
    constants : pairs (Symbol, number)
        Parameters with their values.
    """

    name: str
    coordinates: tuple[sp.Symbol, ...]
    relations: tuple[sp.Expr, ...]
    velocities: tuple[sp.Symbol, ...]
    frame: tuple[VectorField, ...]
    forms: tuple[tuple[sp.Expr, ...], ...] = ()
    structure: Coefficients | None = None
    steps: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    constants: tuple[tuple[sp.Symbol, ParameterValue], ...] = ()

    @cached_property
    def formulas(self) -> tuple[sp.Expr, ...]:
        """All formulas that define the distribution."""
        return (
            *(value for field in self.frame for value in field.values()),
            *(entry for row in self.forms for entry in row),
            *(self.structure or {}).values(),
        )

    def space(
        self, free: Sequence[sp.Symbol] = (), zeros: Sequence[sp.Expr] = ()
    ) -> ConfigurationSpace:
        """The configuration space with its conditions; `free` parameters have no value."""
        return ConfigurationSpace(
            self.coordinates,
            self.relations,
            self.steps,
            (*self.formulas, *zeros),
            tuple((s, v) for s, v in self.constants if s not in free),
            tuple(free),
        )

    @cached_property
    def with_numbers(self) -> Distribution:
        """The distribution with parameters replaced by their values."""
        table = {s: with_exact_decimals(v) for s, v in self.constants}
        return replace(
            self,
            relations=tuple(f.xreplace(table) for f in self.relations),
            frame=tuple({s: v.xreplace(table) for s, v in field.items()} for field in self.frame),
            forms=tuple(tuple(entry.xreplace(table) for entry in row) for row in self.forms),
            structure=self.structure
            and {ijk: sp.sympify(v).xreplace(table) for ijk, v in self.structure.items()},
            steps=tuple((s, v.xreplace(table)) for s, v in self.steps),
            constants=(),
        )

    @cached_property
    def with_own_frame(self) -> Distribution:
        """The distribution with its admissible fields as the frame, and no forms."""
        names = tuple(real_symbol(f"u_{i}") for i, _ in enumerate(self.fields, 1))
        return replace(self, velocities=names, frame=self.fields, forms=())

    @cached_property
    def fields(self) -> tuple[VectorField, ...]:
        """η_s of (2.2) by coordinate, with the definitions as symbols.

        In each, one free velocity is 1 and the others are 0; it is singular where the constraints
        cannot be solved for the dependent ones.
        """
        fields = []
        for combination in _admissible(self.forms, len(self.velocities)):
            total: dict[sp.Symbol, sp.Expr] = {}
            for number, field in zip(combination, self.frame, strict=True):
                for symbol, value in field.items():
                    total[symbol] = total.get(symbol, sp.S.Zero) + number * value
            fields.append({s: value for s, value in total.items() if value != 0})
        return tuple(fields)


def _admissible(forms: Sequence[Sequence[sp.Expr]], width: int) -> list[list[sp.Expr]]:
    """A basis of the solutions of the constraints, with numbers as pivots if possible."""
    # Gauss–Jordan elimination.  A pivot that is a number vanishes nowhere, so the fields stay
    # regular; of the others the shortest keeps the formulas small.
    rows = [list(row) for row in forms]
    pivots: list[tuple[int, list[sp.Expr]]] = []
    while rows:
        row, column = min(
            ((r, c) for r in range(len(rows)) for c in range(width) if rows[r][c] != 0),
            key=lambda rc: (not rows[rc[0]][rc[1]].is_Number, sp.count_ops(rows[rc[0]][rc[1]])),
            default=(-1, -1),
        )
        if column < 0:
            break
        lead = rows[row][column]
        chosen = [sp.cancel(entry / lead) for entry in rows.pop(row)]
        pivots = [(c, _row_after_elimination(other, chosen, column)) for c, other in pivots]
        rows = [_row_after_elimination(other, chosen, column) for other in rows]
        pivots.append((column, chosen))
    pivot_columns = {c for c, _ in pivots}
    solutions = []
    for free in (c for c in range(width) if c not in pivot_columns):
        solution = [sp.S.One if c == free else sp.S.Zero for c in range(width)]
        for c, pivot in pivots:
            solution[c] = -pivot[free]
        solutions.append(solution)
    return solutions


def _row_after_elimination(row: list[sp.Expr], pivot: list[sp.Expr], column: int) -> list[sp.Expr]:
    factor = row[column]
    if factor == 0:
        return row
    return [sp.cancel(a - factor * b) for a, b in zip(row, pivot, strict=True)]


def distribution_spanned_by(
    name: str,
    fields: Sequence[VectorField],
    coordinates: Sequence[sp.Symbol],
    relations: Sequence[sp.Expr] = (),
    constants: Mapping[sp.Symbol, ParameterValue] | None = None,
) -> Distribution:
    """The distribution spanned by given fields."""
    return Distribution(
        name,
        tuple(coordinates),
        tuple(relations),
        tuple(real_symbol(f"u_{i}") for i, _ in enumerate(fields, 1)),
        tuple(fields),
        constants=tuple((constants or {}).items()),
    )


def distribution(mechanism: Mechanism) -> Distribution:
    """The distribution of admissible velocities of a mechanism.

    Parameters
    ----------
    mechanism : Mechanism
        A frame reduced by rotations or Euclidean motions is completed by direction cosines α, β, γ
        and the position R, so that integrals of the constraints can be written down.

    Raises
    ------
    InputError
        If a constraint is not linear in the velocities, or the frame does not span.
    """
    steps = {s: v for s, v in mechanism.steps}
    moving = _moving(mechanism)
    position_steps = tuple((s, v) for s, v in steps.items() if s not in moving)
    frame = mechanism.frame
    w = frame.w
    rows: list[list[sp.Expr]] = []
    inhomogeneous: list[sp.Expr] = []
    for f in mechanism.f:
        formula = expand(f, {s: steps[s] for s in moving})
        row = [sp.diff(formula, s) for s in w]
        if any(entry.free_symbols & set(w) for entry in row):
            raise InputError(
                f"{mechanism.name}: the constraint {f} = 0 is not linear in the velocities; "
                "whether constraints are holonomic can be told only of linear ones"
            )
        rows.append(row)
        inhomogeneous.append(formula.xreplace(dict.fromkeys(w, sp.S.Zero)))
    positions = [expand(F, position_steps) for F in mechanism.F]
    constants = {p.symbol: p.default for p in mechanism.parameters}
    entries = [*positions, *inhomogeneous, *(entry for row in rows for entry in row)]
    whole = whole_configuration(frame, entries, position_steps, constants)
    coordinates, fields = whole.coordinates, whole.fields
    # A position constraint F = 0 also constrains the velocities: Ḟ = 0.
    rows += [[lie_derivative(field, F) for field in fields] for F in positions]
    inhomogeneous += [sp.diff(F, TIME) for F in positions]
    if any(entry != 0 for entry in inhomogeneous) or _depend_on_time(rows, position_steps):
        # With the time as a coordinate of rate 1 the constraints become linear and homogeneous.
        coordinates, fields = (*coordinates, TIME), (*fields, {TIME: sp.S.One})
        w = (*w, real_symbol("tdot"))
        rows = [[*row, entry] for row, entry in zip(rows, inhomogeneous, strict=True)]
    admissible = Distribution(
        mechanism.name,
        coordinates,
        (*whole.relations, *positions),
        w,
        fields,
        tuple(tuple(row) for row in rows),
        whole.structure,
        position_steps,
        tuple(constants.items()),
    )
    return admissible.with_own_frame if whole.admissible else admissible


def _moving(mechanism: Mechanism) -> set[sp.Symbol]:
    """Definitions that depend on the velocities."""
    moving = set(mechanism.frame.w)
    for symbol, value in mechanism.steps:
        if value.free_symbols & moving:
            moving.add(symbol)
    return moving - set(mechanism.frame.w)


def _depend_on_time(
    rows: Sequence[Sequence[sp.Expr]], steps: Sequence[tuple[sp.Symbol, sp.Expr]]
) -> bool:
    return any(expand(entry, steps).has(TIME) for row in rows for entry in row)
