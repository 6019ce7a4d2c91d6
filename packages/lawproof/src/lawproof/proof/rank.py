"""Ranks and dimensions that laws claim.

A map onto another system must be a local diffeomorphism, a bracket must have its rank, and
equations must determine their rates. If a rank is attained at a point (exact rationals or balls),
it is attained at almost every point; if not, the point may be special. Evaluated symbolically
(`FunctionField`), where only elements that vanish modulo the relations count as zero, the rank is
the generic one, and a deficiency holds everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import singledispatch

import sympy as sp

from flowlanes.formulas.errors import OutOfReachError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Law,
    PoissonStructure,
    Reduction,
    Separation,
)

from .fields.field import Field, FieldElement
from .level.alternatives import alternatives
from .level.closedness import rows_of_equations_and_identities, up_to_time
from .level.level_set import LevelSet
from .level.named_formulas import components
from .level.separability import separation_gradients
from .residuals import Row, target_state

DIMENSION = "the dimension of the level"
"""A deficiency that is certain at a point where all conditions are independent."""


def rank(field: Field, matrix: Sequence[Row]) -> int:
    """Rank of a matrix over a field; with balls, a certain lower bound."""
    rows = [list(row) for row in matrix]
    count = 0
    for column in range(len(rows[0]) if rows else 0):
        candidates = [i for i in range(count, len(rows)) if not field.vanishes(rows[i][column])]
        if not candidates:
            continue
        rows[count], rows[candidates[0]] = rows[candidates[0]], rows[count]
        head = rows[count]
        for i in range(count + 1, len(rows)):
            factor = rows[i][column] / head[column]
            rows[i] = [x - factor * y for x, y in zip(rows[i], head, strict=True)]
        count += 1
    return count


@singledispatch
def rank_defect(law: Law, level: LevelSet, field: Field) -> tuple[str, str] | None:
    """The rank deficiency of a law, or None.

    Parameters
    ----------
    field
        Numbers at a point: None holds for almost every point of the level, a deficiency is a hint.
        Fractions: a deficiency holds everywhere.

    Returns
    -------
    (str, Any) or None
        Name of the deficient rank, and its value.

    Raises
    ------
    OutOfReachError
        If balls leave the rank undecided.
    """
    return None


def _entries(law: PoissonStructure, level: LevelSet, field: Field) -> list[list[FieldElement]]:
    plain = level.evaluator(field)
    size = len(level.system.symbols)
    return [
        [plain.value(level.without_rates(law.matrix[i, j])) for j in range(size)]
        for i in range(size)
    ]


@rank_defect.register
def _(law: PoissonStructure, level: LevelSet, field: Field) -> tuple[str, str] | None:
    if not law.rank:
        return None
    found = rank(field, _entries(law, level, field))
    return _lacking("the rank of the bracket", found, law.rank, field)


@rank_defect.register
def _(law: ConformallyHamiltonian, level: LevelSet, field: Field) -> tuple[str, str] | None:
    multiplier = level.evaluator(field).value(law.scalar.multiplier)
    if field.vanishes(multiplier):
        if not field.exact:
            raise OutOfReachError("with balls it is not certain that the multiplier is not zero")
        return "the multiplier", "0"
    return rank_defect(law.structure, level, field)


@rank_defect.register
def _(law: Isomorphism, level: LevelSet, field: Field) -> tuple[str, str] | None:
    """The map must be a local diffeomorphism from the level to the phase space of the target.

    The level is where the conditions hold and the constants have fixed values; the phase space is
    defined by the relations of the target and by `onto`, with the constants substituted.
    """
    # A row of slopes that is empty belongs to a formula without derivatives and has no rank.
    partial = level.partial(field)
    size = len(level.system.symbols)

    def rows(formulas: Sequence[sp.Expr]) -> list[Row]:
        slopes_of = [partial(formula).slopes for formula in formulas]
        return [[slopes.get(i, field.zero) for i in range(size)] for slopes in slopes_of if slopes]

    constants = rows(list(components(law.constants, level).values()))
    bounds = [*rows(level.moving), *constants]
    images = rows(list(components(law.map, level).values()))
    total = rank(field, [*bounds, *images])
    lacking = _lacking("the rank of the map with the conditions", total, size, field)
    if lacking is not None:
        return lacking
    return _too_large(law, level, field, size, bounds)


def _too_large(
    law: Isomorphism, level: LevelSet, field: Field, size: int, bounds: list[Row]
) -> tuple[str, str] | None:
    """Deficiency if the target has more dimensions than the level."""
    target = law.target
    number = {s: i for i, s in enumerate(target.symbols)}
    values = {s: jet.value for s, jet in target_state(law, level, level.evaluator(field)).items()}

    def seed(symbol: sp.Symbol) -> Jet | None:
        if symbol not in values:
            return None
        return Jet(values[symbol], {number[symbol]: field.one} if symbol in number else {})

    there = Evaluator(field, seed, dict(target.scalar_definitions))

    def normals(conditions: Sequence[sp.Expr]) -> list[Row]:
        slopes = [there(c).slopes for c in conditions]
        return [[s.get(i, field.zero) for i in range(len(number))] for s in slopes if s]

    bound = rank(field, bounds)
    here = size - bound
    relations = normals(LevelSet(target, law.onto).conditions)
    cut = rank(field, relations)
    if here != len(number) - cut:
        # A condition may be a product, whose differential vanishes where two factors do.
        relations = normals(_component_equations(law, field, there))
        cut = rank(field, relations)
    beyond = len(number) - cut
    if here == beyond:
        # Ranks with balls are lower bounds: the conditions may remove more dimensions than they
        # seem to, but at most one each.
        if field.exact or bound == len(bounds):
            return None
        raise OutOfReachError("with balls the dimension of the level is not certain")
    if not field.exact and (bound < len(bounds) or cut < len(relations)):
        raise OutOfReachError("with balls the dimensions of level and target are not certain")
    regular = bound == len(bounds) and cut == len(relations)
    return DIMENSION if regular else "the dimension found", f"{here} instead of {beyond}"


def _component_equations(law: Isomorphism, field: Field, there: Evaluator) -> tuple[sp.Expr, ...]:
    """The equations of the component of the target's phase space that contains the image.

    Raises
    ------
    OutOfReachError
        If the component is not found.
    """
    whole = Identity("phase space", sp.S.Zero, level=law.onto)
    for alternative in alternatives(law.target, whole):
        for part in LevelSet(alternative.system, alternative.law.level).components:
            if not part.parent and all(field.vanishes(there.value(c)) for c in part.conditions):
                return part.conditions
    raise OutOfReachError("the component of the target to which the map leads is not known")


@rank_defect.register
def _(law: Reduction, level: LevelSet, field: Field) -> tuple[str, str] | None:
    """The equations must determine all rates, or the ratios of at least two independent ones."""
    stated, known, unknowns = rows_of_equations_and_identities(law, level, field)
    wanted = unknowns
    if up_to_time(law, level):
        tied = rank(field, known)
        if not field.exact and tied < len(known):
            raise OutOfReachError("with balls it is not certain how many variables are independent")
        wanted -= unknowns - tied > 1
    found = rank(field, [*stated, *known])
    return _lacking("the rank of the equations in the rates", found, wanted, field)


@rank_defect.register
def _(law: Separation, level: LevelSet, field: Field) -> tuple[str, str] | None:
    """The separated quantities must be independent on a level of the constants."""
    bounds, quantities = separation_gradients(law, level, field)
    found = rank(field, [*bounds, *quantities]) - rank(field, bounds)
    return _lacking("the number of independent quantities", found, len(quantities), field)


def _lacking(what: str, rank: int, least: int, field: Field) -> tuple[str, str] | None:
    if rank >= least:
        return None
    if not field.exact:
        raise OutOfReachError(f"{what} is at least {rank}, but {least} is not certain with balls")
    return what, f"{rank} instead of {least}"
