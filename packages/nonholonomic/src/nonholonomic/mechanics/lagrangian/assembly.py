"""Momenta, mass matrix, forces and constraints of a mechanism."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.tape import Derivation, Tape

from .generic_points import (
    GenericPoint,
    default_parameters,
    generic_points,
    is_numerically_zero,
    with_working_precision,
)
from .independence import check_constraints, check_velocities
from .mechanism import TIME, Mechanism
from .structure_functions import Coefficients, structure, written_frame


@dataclass(frozen=True)
class Balance:
    """The parts of the equations of motion, as formulas in the names of a tape.

    Attributes
    ----------
    mechanism : Mechanism
    tape : Tape
    points : tuple of GenericPoint
        Generic points of the configuration space.
    coefficients : Coefficients
        Structure functions.
    constraints : tuple of Expr
        All constraints on velocities; the derivatives Ḟ = 0 of position constraints come last.
    constraint_of : mapping of velocity to index
        The velocities that are solved for, each with the index of its constraint.
    free : tuple of int
        Indices of the other velocities u.
    momenta : tuple of Expr
        p_i = ∂L/∂w_i.
    mass : tuple of tuple of Expr
        A_ij = ∂²L/∂w_i∂w_j.
    slopes : tuple of tuple of Expr
        ∂f_μ/∂w_i.
    push : tuple of Expr
        c_ji^k p_k w_j + E_i(L) + Q_i.
    """

    mechanism: Mechanism
    tape: Tape
    points: tuple[GenericPoint, ...]
    coefficients: Coefficients
    constraints: tuple[sp.Expr, ...]
    constraint_of: Mapping[sp.Symbol, int]
    free: tuple[int, ...]
    momenta: tuple[sp.Expr, ...]
    mass: tuple[tuple[sp.Expr, ...], ...]
    slopes: tuple[tuple[sp.Expr, ...], ...]
    push: tuple[sp.Expr, ...]

    @cached_property
    def multipliers(self) -> tuple[sp.Symbol, ...]:
        """λ_μ, one for each constraint."""
        return tuple(self.tape.fresh(f"lambda_{i + 1}") for i in range(len(self.constraints)))

    @property
    def time(self) -> Derivation:
        """The rate of change along the motion at fixed free velocities."""
        frame = self.mechanism.frame
        return Derivation((*zip(frame.coordinates, frame.qdot, strict=True), (TIME, sp.S.One)))

    def by_velocity(self, index: int) -> Derivation:
        """∂/∂u by a free velocity; the solved ones depend on it."""
        return Derivation(((self.mechanism.frame.w[index], sp.S.One),))

    def moves(self, formula: sp.Expr) -> bool:
        """Whether a formula depends on velocities, solved or free."""
        w = set(self.mechanism.frame.w)
        values = (formula, *(v for _, v in self.tape.steps([formula])))
        return any(value.free_symbols & w for value in values)

    def at(self, formulas: Sequence[sp.Expr]) -> tuple[GenericPoint, ...]:
        """The generic points, with the solved velocities determined by the constraints."""
        steps = self.tape.steps(formulas)
        free = [
            {s: v for s, v in p.point.items() if s not in self.constraint_of} for p in self.points
        ]
        return tuple(GenericPoint(point, steps) for point in free)

    def typical(self, formulas: Sequence[sp.Expr]) -> GenericPoint:
        """A generic configuration with the default parameters."""
        mechanism = self.mechanism
        values = default_parameters(mechanism)
        point = generic_points(mechanism.name, mechanism.frame, mechanism, values, many=1)[0].point
        steps = self.tape.steps(formulas)
        return GenericPoint({s: v for s, v in point.items() if s not in self.constraint_of}, steps)

    def at_any(self, formulas: Sequence[sp.Expr]) -> tuple[GenericPoint, ...]:
        """The generic points with independent velocities, which violate the constraints."""
        steps = self.tape.steps(formulas)
        definitions = [(s, v) for s, v in steps if s not in self.constraint_of]
        return tuple(GenericPoint(point.point, definitions) for point in self.points)


@with_working_precision
def balance(mechanism: Mechanism) -> Balance:
    """Momenta, mass matrix and forces of a mechanism.

    Raises
    ------
    InputError
        If the frame does not span, or the constraints are dependent or contradictory.
    """
    frame, name = mechanism.frame, mechanism.name
    w = frame.w
    parameters = [p.symbol for p in mechanism.parameters]
    tape = Tape(mechanism.steps, (*mechanism.symbols, *parameters, TIME))
    points = generic_points(name, frame, mechanism)
    coefficients = structure(written_frame(mechanism), name)
    _check_tangent(mechanism, tape, points)
    here = Derivation((*zip(frame.coordinates, frame.qdot, strict=True), (TIME, sp.S.One)))
    constraints = (*mechanism.f, *(tape.short(tape.along(here, F)) for F in mechanism.F))
    along_w = [_only(w, i) for i in range(len(w))]
    slopes = tuple(
        tuple(tape.name(tape.short(tape.along(d, f))) for d in along_w) for f in constraints
    )
    check_constraints(mechanism, tape, points, constraints, slopes)
    check_velocities(mechanism, tape, points, constraints, slopes)
    momenta = tuple(
        tape.name(tape.short(tape.along(d, mechanism.L)), f"p_{i}")
        for i, d in enumerate(along_w, 1)
    )
    mass = _symmetric(tape, [[tape.along(d, p) for d in along_w] for p in momenta])
    push = tuple(
        sp.Add(
            _turning(coefficients, momenta, w, i),
            tape.along(_along_field(mechanism, i), mechanism.L),
            mechanism.Q.get(s, sp.S.Zero),
        )
        for i, s in enumerate(w)
    )
    solved = _solve_velocities(mechanism, tape, constraints, slopes)
    return Balance(
        mechanism=mechanism,
        tape=tape,
        points=points,
        coefficients=coefficients,
        constraints=constraints,
        constraint_of=solved,
        free=tuple(i for i, s in enumerate(w) if s not in solved),
        momenta=momenta,
        mass=mass,
        slopes=slopes,
        push=push,
    )


def _check_tangent(mechanism: Mechanism, tape: Tape, points: Sequence[GenericPoint]) -> None:
    for relation in mechanism.frame.relations:
        for i, s in enumerate(mechanism.frame.w):
            change = tape.along(_along_field(mechanism, i), relation)
            steps = tape.steps([change])
            if not is_numerically_zero(change, [point.further(steps) for point in points]):
                raise InputError(
                    f"{mechanism.name}: the field of {s} is not tangent to the relation "
                    f"{relation} = 0; a relation that moves with the velocities is a position "
                    "constraint"
                )


def _only(w: Sequence[sp.Symbol], index: int) -> Derivation:
    """∂/∂w_i with all other velocities held, solved ones included."""
    return Derivation(tuple((s, sp.Integer(int(i == index))) for i, s in enumerate(w)))


def _along_field(mechanism: Mechanism, index: int) -> Derivation:
    """The field E_i, at fixed velocities."""
    frame = mechanism.frame
    constant = tuple((s, sp.S.Zero) for s in frame.w)
    return Derivation((*frame.field(index).items(), *constant))


def _symmetric(tape: Tape, rows: list[list[sp.Expr]]) -> tuple[tuple[sp.Expr, ...], ...]:
    size = len(rows)
    matrix = [[sp.S.Zero] * size for _ in rows]
    for i in range(size):
        for j in range(i, size):
            label = f"A_{i + 1}{j + 1}" if size < 10 else f"A_{i + 1}_{j + 1}"
            matrix[i][j] = matrix[j][i] = tape.name(tape.short(rows[i][j]), label)
    return tuple(map(tuple, matrix))


def _turning(
    coefficients: Coefficients, p: Sequence[sp.Expr], w: Sequence[sp.Symbol], index: int
) -> sp.Expr:
    """c_ji^k p_k w_j summed over j and k."""
    terms = []
    for (i, j, k), value in coefficients.items():
        if j == index:
            terms.append(value * p[k] * w[i])
        if i == index:
            terms.append(-value * p[k] * w[j])
    return sp.Add(*terms)


def _solve_velocities(
    mechanism: Mechanism,
    tape: Tape,
    constraints: Sequence[sp.Expr],
    slopes: Sequence[Sequence[sp.Expr]],
) -> dict[sp.Symbol, int]:
    """Solve constraints for velocities, which become definitions; their constraints by index."""
    w = mechanism.frame.w
    solved: dict[sp.Symbol, int] = {}
    for index, f in enumerate(constraints):
        for s, slope in zip(w, slopes[index], strict=True):
            if s in solved or not slope.is_Number or slope == 0:
                continue
            remainder = f.xreplace({s: sp.S.Zero})
            # the velocity must occur in the formula itself, not through a definition, and the
            # remainder must not depend on it through definitions
            if sp.diff(f, s) != slope or s in _uses(tape, remainder):
                continue
            tape.define(s, tape.short(-remainder / slope))
            solved[s] = index
            break
    return solved


def _uses(tape: Tape, value: sp.Expr) -> set[sp.Symbol]:
    """All symbols on which a formula depends, also through definitions."""
    symbols = set(value.free_symbols)
    for symbol, inner in tape.steps([value]):
        symbols |= {symbol} | inner.free_symbols
    return symbols
