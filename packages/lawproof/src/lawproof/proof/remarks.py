"""Remarks on laws that hold, for example that they are trivial."""

from __future__ import annotations

from functools import singledispatch

from flowlanes.system.laws import Integral, Law, Reduction, Symmetry

from .fields.field import Field
from .level.closedness import up_to_time
from .level.level_set import LevelSet
from .level.named_formulas import components
from .rank import rank


@singledispatch
def remark(law: Law, level: LevelSet, field: Field) -> str:
    """A remark on a law that holds; empty if there is none.

    Parameters
    ----------
    field
        Numbers at a point: an empty result is final. Fractions: any result is final.
    """
    return ""


@remark.register
def _(law: Integral, level: LevelSet, field: Field) -> str:
    """True if the function is constant on the level and so distinguishes no motions."""
    partial = level.partial(field)
    size = len(level.system.symbols)
    formulas = [*level.moving, level.without_rates(law.scalar.value)]
    slopes = [partial(formula).slopes for formula in formulas]
    rows = [[s.get(i, field.zero) for i in range(size)] for s in slopes]
    same = rank(field, rows) == rank(field, rows[:-1])
    return "a constant on the whole level" if same else ""


@remark.register
def _(law: Symmetry, level: LevelSet, field: Field) -> str:
    """True if the symmetry field is zero."""
    evaluate = level.evaluator(field)
    values = [evaluate.value(formula) for formula in components(law.field, level).values()]
    return "the zero field" if all(map(field.vanishes, values)) else ""


@remark.register
def _(law: Reduction, level: LevelSet, field: Field) -> str:
    """True if the equations determine paths only, not time."""
    return "up to the time" if up_to_time(law, level) else ""
