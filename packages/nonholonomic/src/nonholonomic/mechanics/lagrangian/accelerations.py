"""Accelerations ẇ and multipliers λ, the solution of linear equations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from graphlib import TopologicalSorter

import mpmath
import sympy as sp

from flowlanes.errors import InputError

from .assembly import Balance
from .generic_points import regular_minor, with_working_precision
from .ldl import Factorisation, product


@dataclass(frozen=True)
class LinearEquations:
    """The linear equations A u̇ = h + Cᵀλ, C u̇ = b of the free velocities u.

    Attributes
    ----------
    mass, slopes : tuple of rows
        A, and C of the constraints that are not solved for a velocity.
    force, drift, multipliers : tuple of Expr
        h, b and λ.
    constraints : tuple of Expr
        The left sides of these constraints.
    """

    mass: tuple[tuple[sp.Expr, ...], ...]
    force: tuple[sp.Expr, ...]
    drift: tuple[sp.Expr, ...]
    slopes: tuple[tuple[sp.Expr, ...], ...]
    multipliers: tuple[sp.Expr, ...]
    constraints: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Accelerations:
    """Accelerations and multipliers.

    Attributes
    ----------
    rates : mapping of velocity to Expr
        ẇ of the free velocities.
    multipliers : tuple of (Symbol, Expr)
        λ_μ in the order of the constraints, position constraints last.
    equations : LinearEquations
        The equations solved by the rates.
    """

    rates: Mapping[sp.Symbol, sp.Expr]
    multipliers: tuple[tuple[sp.Symbol, sp.Expr], ...]
    equations: LinearEquations


@with_working_precision
def accelerations(parts: Balance) -> Accelerations:
    """Solve the equations of motion for accelerations and multipliers.

    Raises
    ------
    InputError
        If the mass matrix is singular on the velocities that the constraints allow.
    """
    tape, w = parts.tape, parts.mechanism.frame.w
    size = len(w)
    # Velocities solved for are definitions, so that derivatives by u include them: ẇ = Z u̇ + …,
    # and the dots are part of the rate of p at fixed u. Virtual displacements δw = Z δu satisfy the
    # solved constraints; projected by Zᵀ, the equations are free of their multipliers.
    Z = [[tape.along(parts.by_velocity(s), w[i]) for s in parts.free] for i in range(size)]
    h = [
        tape.name(tape.short(push - tape.along(parts.time, p)))
        for push, p in zip(parts.push, parts.momenta, strict=True)
    ]
    AZ = [
        [product(parts.mass[i], [row[s] for row in Z]) for s in range(len(parts.free))]
        for i in range(size)
    ]
    AZ = [[tape.name(tape.short(e)) for e in row] for row in AZ]

    def projection(column: Sequence[sp.Expr], s: int) -> sp.Expr:
        return tape.name(tape.short(product([row[s] for row in Z], column)))

    count = range(len(parts.free))
    mass = [
        [projection([row[s] for row in AZ], r) if r <= s else sp.S.Zero for s in count]
        for r in count
    ]
    mass = [[mass[min(r, s)][max(r, s)] for s in count] for r in count]
    force = [projection(h, r) for r in count]
    left = [i for i in range(len(parts.constraints)) if i not in parts.constraint_of.values()]
    C = [
        [
            tape.name(tape.short(tape.along(parts.by_velocity(s), parts.constraints[i])))
            for s in parts.free
        ]
        for i in left
    ]
    b = [tape.name(tape.short(-tape.along(parts.time, parts.constraints[i]))) for i in left]
    rates, lambdas = _with_multipliers(parts, mass, force, C, b)
    solved = LinearEquations(
        tuple(map(tuple, mass)),
        tuple(force),
        tuple(b),
        tuple(map(tuple, C)),
        tuple(lambdas),
        tuple(parts.constraints[i] for i in left),
    )
    return Accelerations(
        {w[s]: rate for s, rate in zip(parts.free, rates, strict=True)},
        _all_multipliers(parts, rates, dict(zip(left, lambdas, strict=True)), AZ, h),
        solved,
    )


def _with_multipliers(
    parts: Balance,
    mass: list[list[sp.Expr]],
    force: list[sp.Expr],
    C: list[list[sp.Expr]],
    b: list[sp.Expr],
) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """u̇ and λ from A u̇ = h + Cᵀλ, C u̇ = b."""
    tape = parts.tape
    if _deficient(parts, mass):
        # Cᵀ(C u̇ − b) = 0 may be added to the equations without a change of the multipliers; A +
        # CᵀC is regular if A is regular on the kernel of C.
        count = range(len(force))
        mass = [
            [
                tape.name(tape.short(mass[r][s] + sp.Add(*(row[r] * row[s] for row in C))))
                for s in count
            ]
            for r in count
        ]
        force = [
            force[r] + sp.Add(*(row[r] * v for row, v in zip(C, b, strict=True))) for r in count
        ]
        _refuse_singular(parts, mass)
    try:
        solver = Factorisation(tape, mass)
    except ZeroDivisionError:
        raise InputError(
            f"{parts.mechanism.name}: the mass matrix is not definite: a motion has no kinetic "
            "energy, or a negative one"
        ) from None
    _refuse_negative(parts, solver)
    bare = solver.solve(force)
    if not C:
        return bare, []
    # u̇ = A⁻¹h + A⁻¹Cᵀλ in C u̇ = b gives (C A⁻¹ Cᵀ) λ = b − C A⁻¹h, with a positive definite
    # matrix
    columns = [solver.solve(row) for row in C]
    gram = [[tape.name(tape.short(product(row, x))) for x in columns] for row in C]
    defect = [tape.name(tape.short(v - product(row, bare))) for v, row in zip(b, C, strict=True)]
    lambdas = [tape.name(x) for x in Factorisation(tape, gram).solve(defect)]
    total = [
        tape.short(x + product(lambdas, [column[r] for column in columns]))
        for r, x in enumerate(bare)
    ]
    return total, lambdas


def _numbers(parts: Balance, matrix: Sequence[Sequence[sp.Expr]]) -> list[list[mpmath.mpf]]:
    """A matrix at a generic configuration, with the default parameters."""
    point = parts.typical([e for row in matrix for e in row])
    return [[point.value(e) for e in row] for row in matrix]


def _deficient(parts: Balance, mass: Sequence[Sequence[sp.Expr]]) -> bool:
    return bool(mass) and len(regular_minor(_numbers(parts, mass))[0]) < len(mass)


def _refuse_negative(parts: Balance, solver: Factorisation) -> None:
    """Refuse a kinetic energy that is negative for some velocity."""
    point = parts.typical(solver.pivots)
    if any(point.value(pivot) < 0 for pivot in solver.pivots):
        raise InputError(
            f"{parts.mechanism.name}: the kinetic energy is negative for some motions that the "
            "constraints allow; masses and moments of inertia must be positive"
        )


def _refuse_singular(parts: Balance, mass: Sequence[Sequence[sp.Expr]]) -> None:
    chosen, _ = regular_minor(_numbers(parts, mass))
    w = parts.mechanism.frame.w
    idle = [str(w[s]) for r, s in enumerate(parts.free) if r not in chosen]
    if idle:
        raise InputError(
            f"{parts.mechanism.name}: the mass matrix is singular: the Lagrangian gives no inertia "
            f"to {', '.join(idle)}, which no constraint decides"
        )


def _all_multipliers(
    parts: Balance,
    rates: Sequence[sp.Expr],
    names: Mapping[int, sp.Expr],
    inertia: Sequence[Sequence[sp.Expr]],
    force: Sequence[sp.Expr],
) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The multipliers of all constraints, including those solved for a velocity."""
    tape, w = parts.tape, parts.mechanism.frame.w
    symbols = parts.multipliers
    values = dict(names)
    place = {index: w.index(s) for s, index in parts.constraint_of.items()}
    # the equation of a solved velocity contains the multipliers of all constraints with that
    # velocity
    needs = {
        index: {other for other in place if other != index and parts.slopes[other][i] != 0}
        for index, i in place.items()
    }
    # a cycle cannot occur: a velocity is solved for after those in its own constraint
    for index in TopologicalSorter(needs).static_order():
        i = place[index]
        others = [parts.slopes[other][i] * symbols[other] for other in (*names, *needs[index])]
        total = product(inertia[i], rates) - force[i] - sp.Add(*others)
        values[index] = tape.short(total / parts.slopes[index][i])
    return tuple((symbols[i], values[i]) for i in sorted(values))
