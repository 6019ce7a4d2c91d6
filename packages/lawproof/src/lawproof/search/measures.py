"""Search for invariant measures whose density is a product of powers.

With ρ = ∏ bᵢ^eᵢ the equation div(ρv) = 0 reads Σ eᵢ v(bᵢ)/bᵢ = −div v, which is linear in the
exponents. The divergence is that on the phase space defined by the relations.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, product

import numpy as np
import sympy as sp
from flint import nmod_mat

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Measure

from ..proof.prover import prove
from .modular_jets import Integers, inverse, prime
from .modular_linalg import combination, rational
from .phase_space import RestrictedSystem, Sample
from .result import Progress, SearchResult, SearchSpace, no_progress

_POINTS = 40
_SETS = 6
_MOST_BASES = 4
_SEED = 20080830


@arguments_checked
def measures(question: SearchSpace, progress: Progress = no_progress) -> Iterator[SearchResult]:
    """Iterate over invariant measures whose density is a product of powers of given bases.

    Few factors are tried first; the search ends with the smallest number that succeeds.

    Parameters
    ----------
    question : SearchSpace
    progress : callable, optional
        Called with the completed fraction and a description of the next step.

    Returns
    -------
    iterator of SearchResult

    Raises
    ------
    InputError
        If the vector field is not algebraic.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> question = lawproof.search.search_space(top)
    >>> [found.verdict.decision for found in lawproof.search.measures(question)][:1]
    ['proven']
    """
    space = question.stage
    samples = [space.sample(_POINTS, _SEED + i, common=True) for i in range(_SETS)]
    targets = [-_divergence(space, sample) % prime() for sample in samples]
    if not any(target.any() for target in targets):
        yield _finding(question, ())
        return
    rates = [[_logarithmic(sample, base) for base in question.bases] for sample in samples]
    choices = [
        chosen
        for size in range(1, _MOST_BASES + 1)
        for chosen in combinations(range(len(question.bases)), size)
    ]
    found_size = _MOST_BASES + 1
    for number, chosen in enumerate(choices):
        if len(chosen) > found_size:
            break
        progress(number / len(choices), f"{len(chosen)} factors")
        # The exponents are found separately for several values of the parameters, since they may
        # be functions of them.
        residues = [
            combination(np.array([rate[i] for i in chosen]).T, target)
            for rate, target in zip(rates, targets, strict=True)
        ]
        solved = [r for r in residues if r is not None]
        if len(solved) < len(residues):
            continue
        exponents = [_exponent(space, samples, [r[i] for r in solved]) for i in range(len(chosen))]
        bases = [question.bases[i] for i in chosen]
        found_size = len(chosen)
        if any(e is None for e in exponents):
            yield _without_formula(bases)
        else:
            yield _finding(question, tuple(zip(bases, exponents, strict=True)))
    progress(1.0, "")


def _without_formula(bases: Sequence[sp.Expr]) -> SearchResult:
    shown = " and ".join(map(str, bases))
    return SearchResult(
        "measure",
        None,
        None,
        remark=f"powers of {shown}, whose exponents are no simple functions of the parameters",
    )


def _finding(question: SearchSpace, density: tuple[tuple[sp.Expr, sp.Expr], ...]) -> SearchResult:
    space = question.stage
    law = Measure("density", density, level=space.on)
    verdict = prove(space.system, law, effort=question.effort)
    return SearchResult("measure", law, verdict, catalogue_law=_catalogue_name(space, law))


def _catalogue_name(space: RestrictedSystem, law: Measure) -> str:
    """The measure of the catalogue whose density has the same logarithmic rate; empty if none."""
    sample = space.sample(_POINTS, _SEED + _SETS, common=False)
    target = _divergence(space, sample)
    for other in space.system.laws_of(Measure):
        if not set(other.level) - set(space.on):
            total = target
            try:
                for base, exponent in other.density:
                    rate = _logarithmic(sample, base)
                    total = (total + rate * sample(sp.sympify(exponent)).value) % prime()
            except InputError:
                # Its functions are outside the scope of the search, so it does not count as found.
                continue
            if not total.any():
                return f"{other.name}, {other.source}" if other.source else other.name
    return ""


def _logarithmic(sample: Sample, base: sp.Expr) -> Integers:
    jet = sample(base)
    return sample.along(jet) * inverse(jet.value) % prime()


def _divergence(space: RestrictedSystem, sample: Sample) -> Integers:
    """The divergence for the volume on the phase space, at the points of a sample.

    On the phase space v(Rᵢ) = Σ Cᵢⱼ Rⱼ, and the induced volume has the divergence div v − tr C.
    """
    total = np.zeros_like(sample.field[0])
    for index, rate in enumerate(sample.rates):
        total = (total + rate.slope[index]) % prime()
    relations = [relation for relation, _ in space.order]
    rates = [sample(_rate(space, relation)).slope for relation in relations]
    if not any(rate.any() for rate in rates):
        return total
    symbols = space.system.symbols
    columns = [symbols.index(variable) for _, variable in space.order]
    slopes = [sample(relation).slope for relation in relations]
    # On R = 0 the gradients satisfy ∇v(R) = C ∇R. Restricted to the columns of the solved
    # variables, ∇R is invertible, so that C = ∇v(R) (∇R)⁻¹.
    for point in range(len(total)):
        h = [[int(rate[c, point]) for c in columns] for rate in rates]
        g = [[int(slope[c, point]) for c in columns] for slope in slopes]
        c_matrix = nmod_mat(h, prime()) * nmod_mat(g, prime()).inv()
        trace = sum(int(c_matrix[i, i]) for i in range(len(columns)))
        total[point] = (total[point] - trace) % prime()
    return total


def _rate(space: RestrictedSystem, relation: sp.Expr) -> sp.Expr:
    """v(R) as a formula, with definitions inside R substituted."""
    system = space.system
    formula = system.expand(relation)
    return sp.Add(
        *(sp.diff(formula, s) * r for s, r in zip(system.symbols, system.rates, strict=True))
    )


def _exponent(
    space: RestrictedSystem, samples: Sequence[Sample], residues: Sequence[int]
) -> sp.Expr | None:
    """The number, or simple function of the parameters, with given residues at the samples.

    Candidates are q, and q₀ + q₁ f where f is s, 1/s or s/t with parameters or constants s, t.
    """
    first = rational(residues[0], prime())
    if first is not None and all(rational(r, prime()) == first for r in residues):
        return sp.Rational(first.numerator, first.denominator)
    numbers = [s for s in (*space.constants, *space.free) if s not in space.system.symbols]
    candidates = [s / t for s, t in product((sp.S.One, *numbers), (sp.S.One, *numbers)) if s != t]
    for candidate in sorted(candidates, key=lambda c: (sp.count_ops(c), -len(str(c)))):
        at = [int(sample(candidate).value[0]) for sample in samples]
        fit = _line(at, residues)
        if fit is not None:
            return sp.Add(
                sp.Rational(fit[0].numerator, fit[0].denominator),
                sp.Rational(fit[1].numerator, fit[1].denominator) * candidate,
            )
    return None


def _line(at: Sequence[int], residues: Sequence[int]) -> tuple[Fraction, Fraction] | None:
    """Rational q₀, q₁ with q₀ + q₁ f = e at all samples."""
    steps = (at[1] - at[0]) % prime()
    if not steps:
        return None
    slope = (residues[1] - residues[0]) * pow(steps, -1, prime()) % prime()
    offset = (residues[0] - slope * at[0]) % prime()
    if any((offset + slope * f - e) % prime() for f, e in zip(at, residues, strict=True)):
        return None
    q_0, q_1 = rational(offset, prime()), rational(slope, prime())
    return None if q_0 is None or q_1 is None else (q_0, q_1)
