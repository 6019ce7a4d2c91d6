"""Decide whether a formula keeps its sign on a phase space: by ball arithmetic, or by points.

An invariant measure excludes attracting sets only where its density is positive and finite; a
reducing multiplier defines a new time only where it does not vanish.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, TypeAlias

import sympy as sp
from flint import arb

from flowlanes.formulas.errors import NotExactError, OutOfReachError
from flowlanes.formulas.number_fields import ball_precision

from .ranks import RankSample

#: Intervals of the variables.
Box: TypeAlias = tuple[tuple[sp.Expr, sp.Expr], ...]

Sign = Literal["kept", "changes", "unknown"]

#: Number of boxes tested before the sign is left unknown.
BOXES = 3000

#: Radius of a box, relative to its bound, below which it is not divided: a zero is near.
SMALLEST = 1e-9


def sign(sample: RankSample, formulas: Sequence[sp.Expr]) -> Sign:
    """Whether none of some formulas vanishes or becomes infinite on a phase space.

    Parameters
    ----------
    sample : RankSample
    formulas : sequence of sympy.Expr
        Formulas in state, definitions and parameters.

    Returns
    -------
    ``"kept"``, ``"changes"`` or ``"unknown"``
        Kept: proven at every point, by ball arithmetic on a cover of the bounded variables on which
        the formulas depend; changes: one of them takes both signs at sampled points.
    """
    signs = [_sign_of(sample, formula) for formula in formulas]
    if "changes" in signs:
        return "changes"
    return "unknown" if "unknown" in signs else "kept"


def _sign_of(sample: RankSample, formula: sp.Expr) -> Sign:
    formula = sample.system.scalar.of(formula)
    expanded = sample.expand(formula)
    known = {positive for theorem in sample.system.theorems for positive in theorem.positive}
    if (
        expanded.is_positive
        or expanded.is_negative
        or formula in known
        or _divides(sample, formula)
    ):
        return "kept"
    try:
        if len(sample.signs(formula)) == 2:
            return "changes"
        return "kept" if _is_covered(sample, formula, expanded) else "unknown"
    except OutOfReachError:
        return "unknown"


def _divides(sample: RankSample, formula: sp.Expr) -> bool:
    """Whether a formula is a square root by which the equations divide, hence positive."""
    steps = dict(sample.system.scalar_definitions)
    inner = steps.get(formula, formula)
    if not (inner.is_Pow and inner.exp == sp.Rational(1, 2)):
        return False
    used = (*steps.values(), *sample.system.rates)
    powers = {power for f in used for power in f.atoms(sp.Pow) if power.exp.is_negative}
    return any(power.base == formula for power in powers)


def _bounds(sample: RankSample, names: set[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """Bounds of variables from relations Σ wᵢ xᵢ² = const with positive weights."""
    bounds: dict[sp.Symbol, sp.Expr] = {}
    for condition in sample.level_set.moving:
        group = sorted(condition.free_symbols, key=str)
        weights = [sp.diff(condition, s, 2) / 2 for s in group]
        remainder = condition.xreplace(dict.fromkeys(group, sp.S.Zero))
        squares = sp.Add(remainder, *(w * s**2 for w, s in zip(weights, group, strict=True)))
        plain = all(number.is_number for number in (remainder, *weights))
        if not names & set(group) or not plain or sp.expand(condition - squares) != 0:
            continue
        if all((w * remainder).is_negative for w in weights):
            bounds |= {s: sp.sqrt(-remainder / w) for s, w in zip(group, weights, strict=True)}
    return bounds


def _is_covered(sample: RankSample, formula: sp.Expr, expansion: sp.Expr) -> bool:
    """Whether the formula is nonzero on every box of a cover of the bounded variables."""
    names = expansion.free_symbols & set(sample.system.symbols)
    bounds = _bounds(sample, names)
    if not names <= set(bounds):
        return False
    # A variable whose coefficient is zero for these numbers still occurs in the formula.
    formula = formula if _variables(sample, formula) <= set(bounds) else expansion
    order = sorted(bounds, key=str)
    conditions = [c for c in sample.level_set.moving if c.free_symbols <= set(bounds)]
    # Slightly wider than the bound itself, which need not be a binary fraction.
    waiting = [tuple((arb(0), arb(float(bounds[s])) * arb("1.0001")) for s in order)]
    smallest = [SMALLEST * radius for _, radius in waiting[0]]
    with ball_precision():
        for _ in range(BOXES):
            if not waiting:
                return True
            box = waiting.pop()
            values = {str(s): arb(m, r) for s, (m, r) in zip(order, box, strict=True)}
            if any(_is_nonzero_on(sample, c, values) for c in conditions):
                continue
            if not _is_nonzero_on(sample, formula, values):
                if all(r < s for (_, r), s in zip(box, smallest, strict=True)):
                    return False
                waiting += _halves(box)
    return False


def _variables(sample: RankSample, formula: sp.Expr) -> set[sp.Basic]:
    """The variables of the state that a formula, or a definition used by it, contains."""
    steps = dict(sample.system.scalar_definitions)
    waiting, visited = set(formula.free_symbols), set[sp.Basic]()
    while waiting:
        symbol = waiting.pop()
        visited.add(symbol)
        waiting |= sp.sympify(steps.get(symbol, sp.S.Zero)).free_symbols - visited
    return visited & set(sample.system.symbols)


def _is_nonzero_on(sample: RankSample, formula: sp.Expr, values: Mapping[str, arb]) -> bool:
    """Whether a formula is certainly nonzero, and finite, on a box."""
    field = sample.level_set.numbers(values, False)
    try:
        value = sample.level_set.evaluator(field).value(formula)
    except (ZeroDivisionError, NotExactError):
        return False
    return bool(value.is_finite()) and 0 not in value


def _halves(box: Box) -> list[Box]:
    """A box divided in two along its longest side."""
    index = max(range(len(box)), key=lambda i: float(box[i][1]))
    middle, radius = box[index]
    half = radius / 2
    return [(*box[:index], (middle + s * half, half), *box[index + 1 :]) for s in (-1, 1)]
