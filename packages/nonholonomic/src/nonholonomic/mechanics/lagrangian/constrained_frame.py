"""A mechanism restricted to its distribution of admissible velocities.

If the constraints are linear and homogeneous, admissible velocities are w = Z(q) y, and the
fields η_s = Z_is E_i of (2.2) span the distribution.  With the kinetic form g = ZᵀAZ and momenta
P = g y the equations of motion become

    q̇ = ρ(q) y,      Ṗ_s = C^t_rs P_t y_r + η_s(L),      ρ = G Z,

where C^t_rs η_t is the orthogonal projection of [η_r, η_s] onto the distribution (orthogonal in the
kinetic energy).  The brackets satisfy no Jacobi identity unless the constraints are integrable.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.tape import Derivation, Step
from flowlanes.system.named_formulas import expand

from .assembly import Balance, balance
from .generic_points import is_numerically_zero, regular_minor, with_working_precision
from .ldl import Factorisation, product
from .mechanism import TIME, Mechanism

Rows = tuple[tuple[sp.Expr, ...], ...]


@dataclass(frozen=True)
class Restriction:
    """The distribution of a mechanism with its kinetic metric.

    Attributes
    ----------
    mechanism : Mechanism
    velocities : tuple of Symbol
        The independent quasi-velocities y.
    basis : rows of Expr
        Z: the quasi-velocities w_i (rows) in the velocities y_s (columns).
    anchor : rows of Expr
        ρ = G Z: coordinates (rows) by y_s (columns).
    kinetic : rows of Expr
        g_rs.
    brackets : mapping of (r, s) to tuple of Expr
        [η_r, η_s] in the full frame E_k, for r < s.
    structure : mapping of (r, s) to tuple of Expr
        C^t_rs over t, for r < s.
    definitions : tuple of (Symbol, Expr)
        The named quantities in these formulas, in order.
    nonzero : tuple of Expr
        Denominators of the basis; it is valid where they do not vanish.
    """

    mechanism: Mechanism
    velocities: tuple[sp.Symbol, ...]
    basis: Rows
    anchor: Rows
    kinetic: Rows
    brackets: Mapping[tuple[int, int], tuple[sp.Expr, ...]]
    structure: Mapping[tuple[int, int], tuple[sp.Expr, ...]]
    definitions: tuple[Step, ...]
    nonzero: tuple[sp.Expr, ...]


@with_working_precision
def constraint_distribution(mechanism: Mechanism) -> Restriction:
    """The distribution of a mechanism whose constraints are linear and homogeneous.

    Raises
    ------
    InputError
        If time enters, a constraint is not linear and homogeneous in the velocities, or the
        kinetic energy is not a quadratic form of them; and as
        :func:`~nonholonomic.mechanics.lagrangian.assembly.balance`.
    """
    parts = balance(mechanism)
    _check(parts)
    tape, w = parts.tape, mechanism.frame.w
    free = {i: w[i] for i in parts.free}
    Z = {i: {s: tape.along(parts.by_velocity(s), w[i]) for s in free} for i in range(len(w))}
    rows = [
        {s: tape.along(parts.by_velocity(s), f) for s in free}
        for index, f in enumerate(parts.constraints)
        if index not in parts.constraint_of.values()
    ]
    # Gaussian elimination of the constraints not yet solved: one velocity y_p = −Σ (c_s/c_p) y_s
    # each, put into the columns of Z and into the constraints that follow.
    nonzero: list[sp.Expr] = []
    for place in range(len(rows)):
        row = {s: tape.short(c) for s, c in rows[place].items()}
        pivot = _pivot(parts, row)
        value = row.pop(pivot)
        if not value.is_number:
            nonzero.append(value)
        dependent = {s: tape.name(tape.short(-c / value)) for s, c in row.items()}
        for table in (*Z.values(), *rows[place + 1 :]):
            share = table.pop(pivot, sp.S.Zero)
            if share != 0:
                for s, c in dependent.items():
                    table[s] = tape.name(tape.short(table[s] + share * c))
        del free[pivot]
    left = list(free)
    basis = tuple(tuple(Z[i][s] for s in left) for i in range(len(w)))
    count = range(len(left))
    fields = [_field(parts, [row[s] for row in basis]) for s in count]
    anchor = tuple(
        tuple(fields[s].table.get(q, sp.S.Zero) for s in count) for q in mechanism.frame.coordinates
    )
    AZ = [
        [tape.name(tape.short(product(line, [row[s] for row in basis]))) for s in count]
        for line in parts.mass
    ]
    kinetic = tuple(
        tuple(
            tape.name(tape.short(product([row[r] for row in basis], [row[s] for row in AZ])))
            for s in count
        )
        for r in count
    )
    brackets = {(r, s): _bracket(parts, basis, fields, r, s) for r in count for s in count if r < s}
    try:
        solver = Factorisation(tape, kinetic)
    except ZeroDivisionError:
        raise InputError(
            f"{mechanism.name}: the mass matrix is singular on the velocities that the "
            "constraints allow"
        ) from None
    # C^t_rs η_t is the projection of [η_r, η_s] in the metric A: g C = Zᵀ A [η_r, η_s]
    structure = {
        pair: tuple(solver.solve([product([row[t] for row in AZ], value) for t in count]))
        for pair, value in brackets.items()
    }
    everything = [
        *(e for row in (*basis, *anchor, *kinetic) for e in row),
        *(e for value in (*brackets.values(), *structure.values()) for e in value),
        *nonzero,
        mechanism.L,
    ]
    steps = tape.steps(everything)
    return Restriction(
        mechanism=mechanism,
        velocities=tuple(free.values()),
        basis=basis,
        anchor=anchor,
        kinetic=kinetic,
        brackets=brackets,
        structure=structure,
        definitions=steps,
        nonzero=tuple(nonzero),
    )


def _check(parts: Balance) -> None:
    mechanism = parts.mechanism
    w = mechanism.frame.w
    values = (mechanism.L, *mechanism.f, *mechanism.F)
    if any(TIME in f.free_symbols for f in (*values, *(v for _, v in mechanism.steps))):
        raise InputError(f"{mechanism.name}: time enters; the system must be autonomous")
    for index, (f, row) in enumerate(zip(parts.constraints, parts.slopes, strict=True)):
        defect = product(row, w) - f
        moving = [e for e in row if parts.moves(e)]
        if moving or not is_numerically_zero(defect, parts.at_any([defect])):
            raise InputError(
                f"{mechanism.name}: the constraint {index + 1}, {f} = 0, is not linear and "
                "homogeneous in the velocities"
            )
    if any(parts.moves(e) for row in parts.mass for e in row):
        raise InputError(
            f"{mechanism.name}: the Lagrangian is not quadratic in the velocities; this needs a "
            "kinetic energy whose matrix depends on the coordinates alone"
        )


def _pivot(parts: Balance, row: Mapping[int, sp.Expr]) -> int:
    """The velocity for which a constraint is solved, with the simplest coefficient.

    A coefficient without parameters is preferred, since no choice of their values makes it vanish.
    """
    entries = [c for c in row.values() if c != 0]
    points = parts.at(entries)
    regular = [s for s, c in row.items() if c != 0 and regular_minor([[points[0].value(c)]])[0]]
    steps = parts.tape.steps(entries)
    parameters = {p.symbol for p in parts.mechanism.parameters}

    def effort(s: int) -> tuple[bool, bool, int, int]:
        fixed = not expand(row[s], steps).free_symbols & parameters
        return (not row[s].is_number, not fixed, sp.count_ops(row[s]), -s)

    return min(regular, key=effort)


def _field(parts: Balance, column: Sequence[sp.Expr]) -> Derivation:
    """η_s as a derivation of functions of the coordinates."""
    frame = parts.mechanism.frame
    tape = parts.tape
    rates = [
        (q, tape.name(tape.short(product(frame.matrix.row(i), column))))
        for i, q in enumerate(frame.coordinates)
    ]
    return Derivation(tuple((q, rate) for q, rate in rates if rate != 0))


def _bracket(
    parts: Balance,
    basis: Sequence[Sequence[sp.Expr]],
    fields: Sequence[Derivation],
    r: int,
    s: int,
) -> tuple[sp.Expr, ...]:
    """[η_r, η_s] = (η_r(Z_ks) − η_s(Z_kr) + Z_ir Z_js c_ij^k) E_k."""
    tape = parts.tape
    total = [tape.along(fields[r], row[s]) - tape.along(fields[s], row[r]) for row in basis]
    for (i, j, k), c in parts.coefficients.items():
        total[k] += c * (basis[i][r] * basis[j][s] - basis[j][r] * basis[i][s])
    return tuple(tape.name(tape.short(e)) for e in total)
