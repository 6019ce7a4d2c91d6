"""Cyclic variables, on which nothing else in a system depends: they follow by a quadrature."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from flowlanes.system.laws import Law, Measure, Symmetry, of_kind
from flowlanes.system.system import System
from lawproof.proof.level.named_formulas import components

from .conserved_covectors import AnnihilatingCovectors
from .facts import Fact, fact_of
from .ranks import RankSample


def symmetries_of_ignorable_variables(
    sample: RankSample,
    sources: Sequence[AnnihilatingCovectors],
    symmetries: Sequence[Symmetry],
    laws: Sequence[Law],
    volume: str,
) -> tuple[Fact, ...]:
    """Symmetries that shift one variable on which equations, integrals and measure do not depend.

    Without these variables the remaining system is closed, has the same integrals, and its measure
    has the same density: dx is a factor of the volume.

    Parameters
    ----------
    sample : RankSample
    sources : sequence of AnnihilatingCovectors
        The independent integrals.
    symmetries : sequence of Symmetry
        Proven.
    laws : sequence of Law
        Proven.
    volume : str
        The name of the measure.
    """
    system = sample.level_set.system
    measure = next((x for x in of_kind(laws, Measure) if x.name == volume), None)
    if measure is None or not all(source.functions for source in sources):
        return ()
    formulas = [
        *system.rates,
        *system.scalar.relations,
        *(base for base, _ in measure.scalar.density),
        *(formula for source in sources for formula in source.functions),
    ]
    used = _symbols(system, formulas)
    found = []
    for law in symmetries:
        field = {s: f for s, f in components(law.field, sample.level_set).items() if f != 0}
        if len(field) == 1:
            ((variable, rate),) = field.items()
            if variable not in used and not rate.free_symbols & set(system.symbols):
                found.append(fact_of(law))
    return tuple(found)


def _symbols(system: System, formulas: Iterable[sp.Expr]) -> set[sp.Symbol]:
    """The symbols in formulas and in the definitions that they use."""
    plain = [system.scalar.of(formula) for formula in formulas]
    parts = [*plain, *(formula for _, formula in system.required_definitions(plain))]
    return {s for part in parts for s in sp.sympify(part).free_symbols}
