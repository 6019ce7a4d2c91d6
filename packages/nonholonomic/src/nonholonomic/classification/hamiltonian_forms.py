"""Hamiltonian forms and invariant measures, with the signs of multipliers and densities."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, of_kind
from lawproof.proof.rank import rank

from .conserved_covectors import casimirs
from .facts import HERE, Fact, ProofBudget, fact_of
from .ranks import Element, RankSample, View, conditions_on_parameters
from .sign_test import sign
from .statements import Bracket, Density


@dataclass(frozen=True)
class Forms:
    """The Hamiltonian forms of a system.

    `liouville` holds the facts that make a form of rank above four integrable; up to rank four it
    suffices to count integrals, as all of them are in involution with H.
    """

    brackets: tuple[Bracket, ...] = ()
    liouville: tuple[Fact, ...] = ()


def density(sample: RankSample, law: Measure) -> Density:
    """An invariant measure with the known sign of its density."""
    bases = [base for base, exponent in law.density if exponent != 0 and base != 1]
    return Density(fact_of(law), sign(sample, bases))


def measures(sample: RankSample, laws: Sequence[Law], budget: ProofBudget) -> tuple[Density, ...]:
    """The proven measures; if there are none, the volume if it is proven invariant."""
    densities = tuple(density(sample, law) for law in of_kind(laws, Measure))
    if densities:
        return densities
    on = (*conditions_on_parameters(sample, laws), *sample.level)
    volume = Measure("volume", {sp.S.One: 1}, "volume of the state", level=on, source=HERE)
    proven = budget.verdict(sample.system, volume)
    return (density(sample, volume),) if proven else ()


def hamiltonian(sample: RankSample, laws: Sequence[Law], budget: ProofBudget) -> Forms:
    """The proven Hamiltonian forms, and complete integrals in involution, if any.

    Parameters
    ----------
    sample : RankSample
    laws : sequence of Law
        Laws proven on it.
    budget : ProofBudget
        For the proofs that integrals are in involution.
    """
    brackets = []
    complete: tuple[Fact, ...] = ()
    integrals = of_kind(laws, Integral)
    for law in of_kind(laws, ConformallyHamiltonian):
        bracket = _bracket(sample, law)
        brackets.append(bracket)
        chosen = None
        if bracket.closed and bracket.rank > 4:
            chosen = _involution(sample, law, integrals, bracket.rank // 2, budget)
        if chosen is not None and not complete:
            complete = (fact_of(law), *map(fact_of, chosen))
    return Forms(tuple(brackets), complete)


def _bracket(sample: RankSample, law: ConformallyHamiltonian) -> Bracket:
    values = casimirs(law)
    independent, _ = sample.independent([partial(_differential, c) for c in values])
    conformal = law.multiplier != 1
    # The differentials of Casimir functions are in the kernel of J, so at most dimension − rank of
    # them are independent; with so many the list is complete.
    size = max(sample.at_points(lambda view: rank(view.field, _entries(view, law))))
    return Bracket(
        fact_of(law),
        size,
        tuple(text(values[i]) for i in independent),
        len(independent) == sample.dimension - size,
        conformal,
        sign(sample, [law.multiplier]) if conformal else "kept",
    )


def _entries(view: View, law: ConformallyHamiltonian) -> list[list[Element]]:
    """The Poisson structure at a point."""
    matrix = law.structure.scalar.matrix
    places = range(matrix.shape[0])
    return [[view.jet(matrix[i, j]).value for j in places] for i in places]


def _involution(
    sample: RankSample,
    law: ConformallyHamiltonian,
    integrals: Sequence[Integral],
    dimension: int,
    budget: ProofBudget,
) -> tuple[Integral, ...] | None:
    """Integrals in involution whose fields, with that of H, span `dimension` dimensions.

    An integral is in involution with H, since it is constant along the field of H.
    """
    chosen: tuple[Integral, ...] = ()
    for candidate in integrals:
        if len(chosen) + 1 == dimension:
            break
        values = [law.hamiltonian, *(i.value for i in chosen), candidate.value]
        spans = sample.full(len(values), partial(_fields, law, values))
        if spans and all(_commute(sample, law, candidate, i, budget) for i in chosen):
            chosen = (*chosen, candidate)
    return chosen if len(chosen) + 1 == dimension else None


def _differential(formula: sp.Expr, view: View) -> list[list[Element]]:
    return [view.differential(formula)]


def _fields(
    law: ConformallyHamiltonian, values: Sequence[sp.Expr], view: View
) -> list[list[Element]]:
    """The vectors J dF of some functions, at a point."""
    matrix = _entries(view, law)
    rows = []
    for value in values:
        slopes = view.differential(value)
        row = []
        for line in matrix:
            total = view.field.zero
            for entry, slope in zip(line, slopes, strict=True):
                total = total + entry * slope
            row.append(total)
        rows.append(row)
    return rows


def _commute(
    sample: RankSample,
    law: ConformallyHamiltonian,
    one: Integral,
    other: Integral,
    budget: ProofBudget,
) -> bool:
    """Whether two integrals are proven to be in involution."""
    system = sample.level_set.system
    # {F, G} is the derivative of G along the field J dF: it vanishes if G is an integral of that
    # field.
    formula = sample.expand(one.scalar.value)
    gradient = sp.Matrix([sp.diff(formula, s) for s in system.symbols])
    field = dict(zip(system.symbols, law.structure.scalar.matrix * gradient, strict=True))
    named = f"{other.name} along {one.name}"
    return bool(budget.verdict(replace(system, field=field), Integral(named, other.value)))
