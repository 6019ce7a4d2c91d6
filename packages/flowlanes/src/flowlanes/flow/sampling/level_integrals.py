"""Integrals that can define a level, and the invariant measures on it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp

from ...errors import InputError
from ...system.arrays import FloatArray
from ...system.laws import Measure
from ...system.system import System

#: Tolerance of a condition on parameters, relative to the size of its terms.
_ROUNDING = 1e-12


def validate_level(system: System, level: Mapping[str, float], values: FloatArray) -> None:
    """Raise an error for integrals that are unknown or not valid for these parameters.

    Raises
    ------
    InputError
    """
    known = {law.name: law for law in system.integrals}
    for name, value in level.items():
        if name not in known:
            raise InputError(
                f"{system.name} has no integral {name!r}; it has {', '.join(known) or 'none'}"
            )
        if not np.isfinite(float(value)):
            raise InputError(f"{system.name}: {name} = {value}: a finite number is needed")
        for condition in known[name].scalar.level:
            if not _vanishes(system, condition, level, values):
                raise InputError(
                    f"{system.name}: {name} is an integral only where {condition} "
                    "= 0, which does not hold here"
                )


def _vanishes(
    system: System, formula: sp.Expr, level: Mapping[str, float], values: FloatArray
) -> bool:
    """True if a formula vanishes for these parameters, or is an integral with value zero."""
    written = system.expand(formula)
    parameters = [p.symbol for p in system.parameters]
    if written.free_symbols <= set(parameters):
        point = dict(zip(parameters, map(float, values), strict=True))
        size = sum(abs(float(term.subs(point))) for term in sp.Add.make_args(sp.expand(written)))
        return abs(float(written.subs(point))) <= _ROUNDING * size
    return any(
        level.get(law.name) == 0 and sp.expand(system.expand(law.value) - written) == 0
        for law in system.integrals
    )


def measures(system: System, level: Mapping[str, float], values: FloatArray) -> list[Measure]:
    """Invariant measures of a system whose conditions are satisfied."""
    return [
        law
        for law in system.laws_of(Measure)
        if all(_vanishes(system, condition, level, values) for condition in law.level)
    ]


def measure_label(law: Measure | None) -> str:
    """Description of a measure, with its source."""
    if law is None:
        return "surface measure"
    name = "invariant measure"
    meaning = law.meaning if law.meaning.startswith(name) else f"{name}: {law.meaning}"
    return f"{meaning.removesuffix(': ')} {law.source}".strip()


def level_label(level: Mapping[str, float]) -> str:
    """Values of the integrals on a level, as text."""
    return " and ".join(f"{name} = {value:.6g}" for name, value in level.items())
