"""The density of a mechanism in closed form, by exact linear algebra at rational points."""

from __future__ import annotations

import random
from dataclasses import replace

import sympy as sp
from flint import fmpq, fmpq_mat

from flowlanes.formulas.taylor import IrrationalError, Rational
from flowlanes.system.laws import Identity
from flowlanes.system.named_formulas import expand
from flowlanes.system.system import System

from ..mechanics.constraints.distribution import Distribution
from ..mechanics.constraints.exact_points import NoPointError, random_point
from .lifted_fields import LiftedFields
from .parameter_conditions import Level, solved_parameters
from .positivity import Powers

SEED = 20080830
POINTS = 6
ATTEMPTS = 60
SIMPLE = 4000
"""Largest number of operations of a formula that is factored."""


def density_from_powers(
    lifted_fields: LiftedFields, jacobian: Powers, level: Level
) -> tuple[Powers, Powers] | None:
    """e^σ, and the density over coordinates and quasi-velocities, as products of powers.

    Parameters
    ----------
    jacobian : Powers
        Determinant of the map from quasi-velocities to momenta.
    level : Level
        Relations between parameters, which are solved and inserted.

    Returns
    -------
    pair of Powers, or None
        None if the density is not a product of powers of factors of the kinetic determinant and of
        the 1-form.
    """
    table = solved_parameters(level)
    steps = {s: f.xreplace(table) for s, f in lifted_fields.steps}
    factors: dict[sp.Expr, sp.Rational] = {}
    for base, exponent in jacobian:
        for factor, power in _factors(base.xreplace(table)):
            factors[factor] = factors.get(factor, sp.S.Zero) + power * exponent
    theta = [f.xreplace(table) for f in lifted_fields.theta]
    bases = [f for f in factors if _moves(f, lifted_fields)]
    exponents = _exponents(lifted_fields, level, theta, bases)
    if exponents is None:
        for f in theta:
            below = sp.denom(sp.together(expand(f, steps)))
            bases += [b for b, _ in _factors(below) if _moves(b, lifted_fields) and b not in bases]
        exponents = _exponents(lifted_fields, level, theta, bases)
    if exponents is None:
        return None
    total = {
        base: factors.get(base, sp.S.Zero) + exponent
        for base, exponent in zip(bases, exponents, strict=True)
    }
    sigma = zip(bases, exponents, strict=True)
    return (
        tuple((base, exponent) for base, exponent in sigma if exponent != 0),
        tuple((base, exponent) for base, exponent in total.items() if exponent != 0),
    )


def density_law(
    lifted_fields: LiftedFields, powers: Powers, level: Level
) -> tuple[System, Identity]:
    """The law that σ has the derivatives θ along the admissible fields.

    Parameters
    ----------
    powers : Powers
        e^σ.

    Returns
    -------
    System
        A system with the coordinates at rest and the definitions.
    Identity
    """
    known = {p.symbol: p for p in lifted_fields.parameters}
    system = System(
        name=lifted_fields.base.name,
        title=lifted_fields.base.name,
        field={x: sp.S.Zero for x in lifted_fields.base.coordinates},
        definitions=tuple((s, sp.expand_trig(f)) for s, f in lifted_fields.steps),
        parameters=tuple(known.values()),
        relations=lifted_fields.base.relations,
    )
    defects = []
    for field, share in zip(lifted_fields.base.frame, lifted_fields.theta, strict=True):
        slope = sp.Add(
            *(
                exponent * rate * sp.diff(base, x) / base
                for base, exponent in powers
                for x, rate in field.items()
            )
        )
        defects.append(sp.expand_trig(share - slope))
    law = Identity("integrated", tuple(defects), "the density has the derivatives required")
    return system, replace(law, level=level)


def _moves(factor: sp.Expr, lifted_fields: LiftedFields) -> bool:
    return bool(factor.free_symbols & set(lifted_fields.base.coordinates))


def _factors(formula: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    """Factors with exponents; a single factor if factoring would be slow."""
    if sp.count_ops(formula) > SIMPLE:
        return [(formula, sp.S.One)]
    if formula.has(sp.sin, sp.cos):
        formula = _in_cosines(sp.together(sp.expand_trig(formula)))
    above, below = sp.fraction(sp.factor(sp.together(formula)))
    return [
        (base, sign * power)
        for part, sign in ((above, 1), (below, -1))
        for base, power in (factor.as_base_exp() for factor in sp.Mul.make_args(part))
        if not base.is_number
    ]


def _in_cosines(formula: sp.Expr) -> sp.Expr:
    """A fraction of polynomials in sines and cosines, without even powers of sines."""
    for sine in sorted(formula.atoms(sp.sin), key=str):
        square = 1 - sp.cos(sine.args[0]) ** 2
        parts = []
        for part in sp.fraction(sp.together(formula)):
            terms = sp.Poly(sp.expand(part), sine).terms() if part.has(sine) else [((0,), part)]
            parts.append(sp.Add(*(c * sine ** (p % 2) * square ** (p // 2) for (p,), c in terms)))
        formula = parts[0] / parts[1]
    return formula


def _exponents(
    lifted_fields: LiftedFields, level: Level, theta: list[sp.Expr], bases: list[sp.Expr]
) -> list[sp.Rational] | None:
    """Rational exponents with Σ e η_β(log b) = θ_β at several points; None if there are none."""
    rows: list[list[fmpq]] = []
    right: list[fmpq] = []
    rng = random.Random(SEED)
    home = _at_level(lifted_fields, level)
    for _ in range(ATTEMPTS):
        if len(right) >= POINTS * len(theta):
            break
        try:
            at_point = _rows(home, theta, bases, rng)
        except (NoPointError, IrrationalError, ZeroDivisionError):
            continue
        for row, value in at_point:
            rows.append(row)
            right.append(value)
    if not right:
        return None
    width = len(bases)
    # The exponents are constants, so each point gives linear equations for them.  A pivot in the
    # last column is a contradiction; a solution is only a candidate, which `density_law` states as
    # a law to be proven.
    entries = [e for row, v in zip(rows, right, strict=True) for e in (*row, v)]
    reduced, rank = fmpq_mat(len(rows), width + 1, entries).rref()
    solution = [fmpq(0)] * width
    for i in range(rank):
        pivot = next(j for j in range(width + 1) if reduced[i, j] != 0)
        if pivot == width:
            return None
        solution[pivot] = reduced[i, width]
    return [sp.Rational(int(x.p), int(x.q)) for x in solution]


def _at_level(lifted_fields: LiftedFields, level: Level) -> Distribution:
    """The admissible fields with the parameters determined by the level inserted."""
    table = solved_parameters(level)
    return replace(
        lifted_fields.base,
        frame=tuple(
            {s: f.xreplace(table) for s, f in field.items()} for field in lifted_fields.base.frame
        ),
        steps=tuple((s, f.xreplace(table)) for s, f in lifted_fields.steps),
        constants=tuple((s, v) for s, v in lifted_fields.base.constants if s not in table),
    )


def _rows(
    home: Distribution, theta: list[sp.Expr], bases: list[sp.Expr], rng: random.Random
) -> list[tuple[list[fmpq], fmpq]]:
    """One equation for each admissible field at a random point, with random parameters."""
    free = tuple(s for s, _ in home.constants)
    space = home.space(free, (*theta, *bases))
    germs = random_point(space, Rational(), rng).germs(space, 1)
    rows = []
    logs = []
    for base in bases:
        series = germs.series(base)
        value = series.value
        logs.append([series.derivative(i).value / value for i, _ in enumerate(home.coordinates)])
    for field, share in zip(home.frame, theta, strict=True):
        rates = [germs.series(field.get(x, sp.S.Zero)).value for x in home.coordinates]
        row = [sum((a * b for a, b in zip(rates, log, strict=True)), fmpq(0)) for log in logs]
        rows.append((row, germs.series(share).value))
    return rows
