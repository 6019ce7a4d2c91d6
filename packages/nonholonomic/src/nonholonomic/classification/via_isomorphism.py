"""Results that proven isomorphisms transfer from their targets.

Integrals of the target are integrals of the system. A Hamiltonian form of the target is one of the
system, up to the change of time, if the map is a local diffeomorphism.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp

from flowlanes.formulas.errors import OutOfReachError
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Law, Measure, of_kind
from flowlanes.system.system import System
from lawproof.proof.level.named_formulas import components

from ..catalogue import CATALOGUE
from .applicable_laws import sorted_laws
from .conserved_covectors import AnnihilatingCovectors, pulled_back, sources
from .facts import Fact, ProofBudget
from .hamiltonian_forms import density, hamiltonian
from .ranks import Element, RankSample, View, rational_parameters
from .sign_test import sign
from .statements import Bracket, Density

#: Number of isomorphisms that are followed in succession.
DEPTH = 2


@dataclass(frozen=True)
class TargetResults:
    """Results from the targets of isomorphisms."""

    sources: tuple[AnnihilatingCovectors, ...] = ()
    brackets: tuple[Bracket, ...] = ()
    liouville: tuple[Fact, ...] = ()
    measures: tuple[Density, ...] = ()


def through_isomorphisms(
    sample: RankSample, laws: Sequence[Law], budget: ProofBudget, depth: int = DEPTH
) -> TargetResults:
    """Results from the targets of the isomorphisms among some proven laws.

    Parameters
    ----------
    sample : RankSample
    laws : sequence of Law
        Laws proven on it.
    budget : ProofBudget
        For the proofs of the laws of the targets.
    depth : int
        Number of isomorphisms that may follow one another.
    """
    results = TargetResults()
    for law in laws:
        if isinstance(law, Isomorphism) and depth:
            more = _through(sample, law, budget, depth)
            results = TargetResults(
                results.sources + more.sources,
                results.brackets + more.brackets,
                results.liouville or more.liouville,
                results.measures or more.measures,
            )
    return results


def _through(
    sample: RankSample, law: Isomorphism, budget: ProofBudget, depth: int
) -> TargetResults:
    values, moving = _constants(sample, law)
    target = _with_laws(law.target)
    there = RankSample(target, values=values)
    laws = sorted_laws(there, budget.verdicts(target)).general
    if moving:
        # A law at one value of a parameter need not hold at all values.
        laws = tuple(each for each in laws if not each.level)
    beyond = TargetResults() if moving else through_isomorphisms(there, laws, budget, depth - 1)
    constant = tuple(pulled_back(law, s) for s in (*sources(laws), *beyond.sources))
    if not _diffeomorphic(sample, there, law, moving):
        return TargetResults(constant)
    forms = hamiltonian(there, laws, budget)
    volumes = tuple(density(there, each) for each in of_kind(laws, Measure))
    brackets = forms.brackets + beyond.brackets
    return TargetResults(
        constant,
        tuple(_bracket(sample, law, b) for b in brackets[:1]),
        tuple(_fact(law, fact) for fact in forms.liouville or beyond.liouville),
        tuple(Density(_fact(law, m.law), "unknown") for m in volumes or beyond.measures),
    )


def _with_laws(target: System) -> System:
    """The target with the laws that the catalogue states for the same equations."""
    if target.laws or target.name not in CATALOGUE:
        return target
    known = CATALOGUE[target.name].system()
    same = all(
        getattr(known, part) == getattr(target, part)
        for part in ("field", "definitions", "relations")
    )
    return replace(target, laws=known.laws) if same else target


def _fact(law: Isomorphism, fact: Fact) -> Fact:
    return Fact(law.name, fact.words, fact.source, fact.system or law.target.title)


def _bracket(sample: RankSample, law: Isomorphism, bracket: Bracket) -> Bracket:
    """A Hamiltonian form of the target as one of the system itself."""
    timed = law.time != 1
    time_sign = sign(sample, [law.time]) if timed else "kept"
    both = bracket.sign if time_sign == "kept" else time_sign
    return replace(
        bracket,
        law=_fact(law, bracket.law),
        conformal=bracket.conformal or timed,
        sign=both,
    )


def _constants(
    sample: RankSample, law: Isomorphism
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Symbol]]:
    """Values of the parameters of the target, and those that depend on the state.

    For the latter the value is an example.
    """
    named = dict(components(law.constants, sample.level_set))
    state = set(sample.system.symbols)
    values = rational_parameters(law.target)
    moving = []
    for parameter in values:
        formula = sample.expand(named.get(parameter, parameter))
        if formula.free_symbols & state:
            moving.append(parameter)
        else:
            values[parameter] = formula
    return values, moving


def _diffeomorphic(
    sample: RankSample, there: RankSample, law: Isomorphism, moving: Sequence[sp.Symbol]
) -> bool:
    """Whether the map is a local diffeomorphism near almost every point.

    The constants are Casimir functions of the transferred bracket.
    """
    named = dict(components(law.constants, sample.level_set))
    images = list(components(law.map, sample.level_set).values())
    constants = [named[s] for s in moving]

    def rows(view: View) -> list[list[Element]]:
        return [*sample.bounds(view), *map(view.differential, (*images, *constants))]

    try:
        same = sample.dimension == there.dimension + len(moving)
        return same and sample.full(len(sample.system.symbols), rows)
    except OutOfReachError:
        return False
