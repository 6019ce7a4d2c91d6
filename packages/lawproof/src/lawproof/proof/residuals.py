"""Residuals of laws in any field; a law holds where all of them vanish.

Every function yields pairs (name, value).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import singledispatch
from itertools import combinations
from typing import TypeAlias

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.errors import NoVolumeError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.printing.formula import text
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Separation,
    Symmetry,
)
from flowlanes.system.named_formulas import scalars

from .fields.field import Field, FieldElement, dot
from .level.level_set import LevelSet
from .level.named_formulas import components, quantities_in_order
from .level.separability import separation_residuals

Row: TypeAlias = Sequence[FieldElement]
#: Words, or the condition whose rate is the residual.
Name: TypeAlias = str | sp.Expr
Residuals: TypeAlias = Iterator[tuple[Name, FieldElement]]


def in_words(name: Name) -> str:
    """Name of a residual in messages."""
    return name if isinstance(name, str) else f"invariance of {text(name)} = 0"


def bracket_with(formula: sp.Expr) -> str:
    """The name of the brackets of all variables with a presumed Casimir function."""
    return f"{{·, {formula}}}"


def derivative_of(formula: sp.Expr) -> str:
    """The name of the derivative of a condition along a symmetry field."""
    return f"u({formula})"


@singledispatch
def residuals(law: Law, level: LevelSet, field: Field) -> Residuals:
    """The residuals of `law` on `level`, evaluated in `field`."""
    raise InputError(f"a law of kind {type(law).__name__} cannot be proved")


def condition_rates(level: LevelSet, field: Field) -> Residuals:
    """Rates of the conditions, which vanish if phase space and level are invariant."""
    along = level.along(field)
    for condition in level.moving:
        yield condition, along.slope(condition)


# --- integrals, identities, reductions -----------------------------------------------------


@residuals.register
def _(law: Integral, level: LevelSet, field: Field) -> Residuals:
    yield "v(F)", level.along(field).slope(level.without_rates(law.scalar.value))


@residuals.register
def _(law: Identity, level: LevelSet, field: Field) -> Residuals:
    quantities = quantities_in_order(law, level)
    formulas = [level.without_second_rates(f, quantities) for f in scalars(law.value)]
    if not formulas:
        raise InputError(f"the law {law.name!r} states nothing: it has no formula")
    # rates need the vector field, which is evaluated only if they occur
    rated = any(f.has(Rate) for f in formulas)
    evaluate = (level.along(field) if rated else level.evaluator(field)).with_steps(quantities)
    for i, formula in enumerate(formulas, 1):
        yield f"component {i}", evaluate.value(formula)


@residuals.register
def _(law: Reduction, level: LevelSet, field: Field) -> Residuals:
    quantities = quantities_in_order(law, level)
    evaluate = level.along(field).with_steps(quantities)
    for i, equation in enumerate(law.scalar.equations, 1):
        formula = level.without_second_rates(equation, quantities)
        yield f"equation {i}", evaluate.value(formula)


@residuals.register
def _(law: Separation, level: LevelSet, field: Field) -> Residuals:
    yield from residuals.dispatch(Reduction)(law, level, field)
    evaluate = level.evaluator(field).with_steps(quantities_in_order(law, level))
    for what, formula in separation_residuals(law, level):
        yield what, evaluate.value(formula)


# --- invariant measure ---------------------------------------------------------------------


@residuals.register
def _(law: Measure, level: LevelSet, field: Field) -> Residuals:
    partial = level.partial(field)
    rates = [partial(rate) for rate in level.system.rates]
    # ρ = ∏ b^e satisfies div(ρ v)/ρ = div v + Σ e v(b)/b.
    total = field.zero
    for i, rate in enumerate(rates):
        total = total + _slope(field, rate, i)
    for base, exponent in law.scalar.density:
        inner, power = (
            partial(level.without_rates(base)),
            partial(sp.sympify(exponent)),
        )
        if power.slopes:
            raise InputError(
                f"the law {law.name!r}: the exponent {exponent} of a density must not depend on "
                "the state"
            )
        if field.vanishes(inner.value):
            # v(log ρ) is infinite where a base vanishes
            raise ZeroDivisionError
        total = total + power.value * _lie_derivative(field, inner, rates) / inner.value
    yield "div(ρv)/ρ", total - _transverse(level, field, partial, rates)


def _slope(field: Field, jet: Jet, direction: int) -> FieldElement:
    slope: FieldElement = jet.slopes.get(direction, field.zero)
    return slope


def _lie_derivative(field: Field, jet: Jet, rates: Sequence[Jet]) -> FieldElement:
    """The derivative v(f) = Σ v_i ∂f/∂x_i along a vector field."""
    total = field.zero
    for i, slope in jet.slopes.items():
        total = total + slope * rates[i].value
    return total


def _transverse(
    level: LevelSet, field: Field, partial: Evaluator, rates: Sequence[Jet]
) -> FieldElement:
    """The part of the divergence that is transverse to the phase space.

    With v(F_i) = Σ C_ij F_j for the conditions F, it is the trace of C. It depends on the
    conditions as stated; the equations of a component define another volume.
    """
    symbols = level.system.symbols
    normals, drifts = [], []
    for condition in level.volume_conditions:
        slopes = [partial(sp.diff(condition, s)) for s in symbols]
        drift = Jet(field.zero, {})
        for slope, rate in zip(slopes, rates, strict=True):
            drift = drift + slope * rate
        normals.append([slope.value for slope in slopes])
        drifts.append([_slope(field, drift, i) for i in range(len(symbols))])
    moving = [i for i, row in enumerate(drifts) if not all(field.vanishes(x) for x in row)]
    # On F = 0 the gradients satisfy ∇v(F_i) = Σ C_ij ∇F_j. Multiplication by the gradients gives G
    # C^T = R with the Gram matrix G, and only columns that are not zero are solved for.
    gram = [[dot(field.zero, a, b) for b in normals] for a in normals]
    right = [[dot(field.zero, drifts[i], normal) for i in moving] for normal in normals]
    # Solved even without columns: a zero pivot shows that no volume is defined.
    solution = _solution(field, gram, right)
    total = field.zero
    for column, i in enumerate(moving):
        total = total + solution[i][column]
    return total


def conditions_are_independent(level: LevelSet, field: Field) -> bool:
    """True if the gradients of the stated conditions are independent and define a volume."""
    partial = level.partial(field)
    normals = [
        [partial(sp.diff(condition, s)).value for s in level.system.symbols]
        for condition in level.volume_conditions
    ]
    gram = [[dot(field.zero, a, b) for b in normals] for a in normals]
    try:
        _solution(field, gram, [[] for _ in gram])
    except NoVolumeError:
        return False
    return True


def _solution(
    field: Field, matrix: Sequence[Row], right: Sequence[Row]
) -> list[list[FieldElement]]:
    """Solutions of a small linear system with a Gram matrix, by Gauss–Jordan elimination.

    The pivots of a Gram matrix, taken in order, are the squared distances of each vector from the
    span of the preceding ones, and are non-zero if the vectors are independent. No rows are
    therefore exchanged, and a zero pivot means that the gradients of the conditions are dependent,
    so that the conditions define no volume.
    """
    rows = [[*row, *values] for row, values in zip(matrix, right, strict=True)]
    for i in range(len(rows)):
        if field.vanishes(rows[i][i]):
            raise NoVolumeError
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for j in range(len(rows)):
            if j != i:
                factor = rows[j][i]
                rows[j] = [x - factor * y for x, y in zip(rows[j], rows[i], strict=True)]
    return [row[len(rows) :] for row in rows]


# --- symmetry fields -----------------------------------------------------------------------


@residuals.register
def _(law: Symmetry, level: LevelSet, field: Field) -> Residuals:
    given = components(law.field, level)
    symbols = level.system.symbols
    if strange := set(given) - set(symbols):
        raise InputError(
            f"the law {law.name!r} gives a component along {', '.join(sorted(map(str, strange)))}, "
            f"which is no state variable of {level.system.name}"
        )
    # Only the derivatives along the two fields are needed: for a shift of a variable that the
    # rates do not contain they vanish without any computation.
    along, across = level.along(field), level.along_field(field, given)
    for condition in level.moving:
        yield derivative_of(condition), across.slope(condition)
    for symbol, rate in zip(symbols, level.system.rates, strict=True):
        change = along.slope(given.get(symbol, sp.S.Zero))
        yield f"[u, v] in {symbol}", across.slope(rate) - change


# --- Poisson structures --------------------------------------------------------------------


@residuals.register
def _(law: PoissonStructure, level: LevelSet, field: Field) -> Residuals:
    partial = level.partial(field)
    size = len(level.system.symbols)
    if law.matrix.shape != (size, size):
        raise InputError(
            f"the law {law.name!r}: its matrix is {law.matrix.shape[0]}×{law.matrix.shape[1]}, "
            f"but the state has {size} variables"
        )
    entries = [
        [partial(level.without_rates(law.matrix[i, j])) for j in range(size)] for i in range(size)
    ]
    values = [[entry.value for entry in row] for row in entries]
    for i in range(size):
        for j in range(i, size):
            yield f"J[{i + 1},{j + 1}] + J[{j + 1},{i + 1}]", values[i][j] + values[j][i]
    for condition in level.moving:
        yield from _casimir(field, condition, partial(condition), values)
    for i, j, k in combinations(range(size), 3):
        total = field.zero
        for a, b, c in ((i, j, k), (j, k, i), (k, i, j)):
            for number, slope in entries[b][c].slopes.items():
                total = total + values[a][number] * slope
        yield f"Jacobi identity {i + 1}, {j + 1}, {k + 1}", total
    for casimir, scalar in zip(law.casimirs, law.scalar.casimirs, strict=True):
        function = partial(level.without_rates(scalar))
        yield from _casimir(field, casimir, function, values)
    if law.rank is not None:
        # A skew-symmetric matrix has rank ≤ r if all its principal Pfaffians of size r + 2 vanish.
        for rows in combinations(range(size), law.rank + 2):
            yield f"Pfaffian of {rows}", pfaffian(field, values, rows)


def _casimir(field: Field, formula: sp.Expr, function: Jet, values: Sequence[Row]) -> Residuals:
    for i, row in enumerate(values, 1):
        total = field.zero
        for j, slope in function.slopes.items():
            total = total + row[j] * slope
        yield f"{bracket_with(formula)}, component {i}", total


def pfaffian(field: Field, matrix: Sequence[Row], rows: tuple[int, ...]) -> FieldElement:
    """Pfaffian of a principal submatrix, by expansion along its first row."""
    if not rows:
        return field.one
    first, *others = rows
    total = field.zero
    for position, other in enumerate(others):
        remaining = tuple(r for r in others if r != other)
        part = matrix[first][other] * pfaffian(field, matrix, remaining)
        total = total + part if position % 2 == 0 else total - part
    return total


@residuals.register
def _(law: ConformallyHamiltonian, level: LevelSet, field: Field) -> Residuals:
    yield from residuals(law.structure, level, field)
    partial = level.partial(field)
    size = len(level.system.symbols)
    gradient = partial(level.without_rates(law.scalar.hamiltonian)).slopes
    multiplier = partial.value(law.scalar.multiplier)
    for i, rate in enumerate(level.system.rates):
        total = field.zero
        for j in range(size):
            if j in gradient:
                total = total + partial.value(law.structure.matrix[i, j]) * gradient[j]
        name = level.system.symbols[i]
        yield f"v − N J dH in {name}", partial.value(rate) - multiplier * total


# --- isomorphisms --------------------------------------------------------------------------


@residuals.register
def _(law: Isomorphism, level: LevelSet, field: Field) -> Residuals:
    along = level.along(field)
    target = law.target
    images = components(law.map, level)
    for symbol, formula in components(law.constants, level).items():
        yield f"rate of {symbol}", along.slope(formula)
    # The target is evaluated at a point only; its derivatives along the motion follow from the
    # map.
    given = {s: Jet(jet.value, {}) for s, jet in target_state(law, level, along).items()}
    there = Evaluator(field, given.get, dict(target.scalar_definitions))
    stated = zip(
        (*target.relations, *law.onto), (*target.scalar.relations, *law.scalar.onto), strict=True
    )
    for condition, scalar in stated:
        yield f"{condition} in {target.name}", there.value(scalar)
    speed = along.value(law.scalar.time)
    for symbol, rate in zip(target.symbols, target.rates, strict=True):
        yield f"rate of {symbol}", along.slope(images[symbol]) - speed * there.value(rate)


def target_state(law: Isomorphism, level: LevelSet, evaluate: Evaluator) -> dict[sp.Symbol, Jet]:
    """State and parameters of the target, and other symbols in `onto`, in terms of the source.

    Raises
    ------
    InputError
        If the law does not define one of them.
    """
    target = law.target
    images, constants = components(law.map, level), components(law.constants, level)
    missing = set(target.symbols) - set(images)
    if missing:
        raise InputError(
            f"the law {law.name!r} does not say what {', '.join(sorted(map(str, missing)))} of "
            f"{target.name} is"
        )
    own = {p.symbol for p in level.system.parameters}
    for parameter in target.parameters:
        symbol = parameter.symbol
        if symbol in constants:
            continue
        if symbol not in own:
            moving = symbol in level.system.symbols
            but = f", but {level.system.name} has a state variable of this name" if moving else ""
            raise InputError(
                f"the law {law.name!r} does not say what the parameter {symbol} of {target.name} "
                f"is{but}"
            )
        constants[symbol] = symbol
    theirs = {*images, *constants, *(s for s, _ in target.scalar_definitions)}
    state = set(level.system.symbols)
    beside = {s for condition in law.scalar.onto for s in condition.free_symbols} - theirs
    # The level of the target must be constant along the motion, or it would not be a level.
    if turning := {s for s in beside if level.expand(s).free_symbols & state}:
        raise InputError(
            f"the law {law.name!r}: its level of {target.name} uses "
            f"{', '.join(sorted(map(str, turning)))}, which depends on the state of "
            f"{level.system.name}; it may use what {target.name} has, and constants"
        )
    formulas = {**{s: s for s in beside}, **constants, **images}
    return {s: evaluate(formula) for s, formula in formulas.items()}
