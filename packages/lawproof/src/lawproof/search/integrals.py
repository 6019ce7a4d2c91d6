"""Search for first integrals."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import comb, gcd, lcm

import numpy as np
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Integral

from ..proof.prover import prove
from .ansatz import Ansatz, Exponents, Table, table
from .modular_jets import Integers, inverse, power, prime
from .modular_linalg import combination, independent_columns, nullspace, product, rank
from .phase_space import Sample
from .rational_reconstruction import Draw, Part, RationalLaw, Scalars, reconstructed_laws
from .result import Progress, SearchResult, SearchSpace, no_progress
from .scaling import Weight, weight_of, weights
from .vector_invariants import VectorInvariants, component_scalars

_SPARE = 24
_RESERVE = 1500  # points for products of known integrals
_SIMPLE = 1
_FEW, _MANY = 15_000, 60_000
_SEED = 20080830


@arguments_checked
def integrals(question: SearchSpace, progress: Progress = no_progress) -> Iterator[SearchResult]:
    """Iterate over first integrals P/Qˢ with a polynomial P and a divisor Q.

    An integral that is a polynomial in earlier ones, with coefficients in the parameters, is not
    repeated. Each result has the verdict of the prover.

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
        If the ansatz does not fit into memory or the vector field is not algebraic.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> question = lawproof.search.search_space(top)
    >>> [str(found.law.value) for found in lawproof.search.integrals(question)]
    ['4*a**2 + b**2', '3*a**2 - c**2']
    """
    families = (question.ansatz, *question.also)
    for family in families:
        family.check()
    search = _Search(question)
    steps: list[tuple[str, Iterator[SearchResult]]] = []
    for degree in range(question.ansatz.degree + 1):
        steps.append(("vector formulas", search.simple(degree)))
        steps += [
            ("polynomials", search.findings(_Shell(family, degree, divisor, exponent)))
            for divisor, exponent in _divisions(question)
            for family in families
        ]
    for number, (words, results) in enumerate(steps):
        progress(number / len(steps), words)
        yield from results
        if search.full:
            yield SearchResult(
                "integral",
                None,
                None,
                remark="more, perhaps; the products of those found are too many to tell",
            )
            return
    progress(1.0, "")


def _divisions(question: SearchSpace) -> list[tuple[sp.Expr, int]]:
    return [
        (sp.S.One, 0),
        *((d, s) for d in question.divisors for s in range(1, question.powers + 1)),
    ]


@dataclass(frozen=True)
class _Shell:
    """Polynomials up to a degree in the momenta of an ansatz, over a power of a divisor."""

    ansatz: Ansatz
    degree: int
    divisor: sp.Expr
    exponent: int


@dataclass
class _KnownIntegrals:
    """The integrals found so far, by their values at the points of the common sample."""

    values: list[tuple[int, Integers]] = field(default_factory=list)

    def products(self, degree: int, gamma_degree: int, points: int) -> Integers:
        """All products up to a degree in the momenta, 1 first; shape (products, points).

        Integrals of the coordinates alone occur in powers up to `gamma_degree`.
        """
        products = [(0, 0, np.ones(points, dtype=np.int64))]
        for own, value in self.values:
            row = list(products)
            while row:
                row = [
                    (total + own, places + (own == 0), product * value % prime())
                    for total, places, product in row
                    if total + own <= degree and places + (own == 0) <= gamma_degree
                ]
                products += row
        return np.array([value for *_, value in products])


class _Search:
    """One search: the common sample, the known integrals, and the vocabulary of formulas."""

    def __init__(self, question: SearchSpace) -> None:
        self.question = question
        self.space = question.stage
        self.points = max(a.size for a in (question.ansatz, *question.also)) + _RESERVE
        self.full = False
        self.sample = self.space.sample(self.points, _SEED, common=True)
        self.tables: dict[Ansatz, Table] = {}
        self.independent_monomials: dict[tuple[Ansatz, int], list[int]] = {}
        self.known_integrals = _KnownIntegrals()
        self.formulas: list[sp.Expr] = []
        self.weights: dict[sp.Symbol, Weight] = weights(self.space)
        self.vocabulary = VectorInvariants(self.space, question.ansatz, self.weights)

    # --- one shell -------------------------------------------------------------------------

    def simple(self, degree: int) -> Iterator[SearchResult]:
        """Integrals that are simple vector formulas, polynomial or not."""
        plain = _Shell(self.question.ansatz, degree, sp.S.One, 0)
        for size in range(min(_SIMPLE, self.question.parameter_degree) + 1):
            for law in self._new_laws(self._vectorial(plain, size, _FEW), degree):
                yield self._finding(law, degree)

    def findings(self, shell: _Shell) -> Iterator[SearchResult]:
        """Integrals of one shell that are independent of earlier ones."""
        exponents, value, rate = self._monomials(shell)
        over, change = _divisor_power(self.sample, shell)
        few = len(value) + _SPARE
        # v(P/Qˢ) = 0 is linear in the coefficients of P: v(P) − P · v(Qˢ)/Qˢ = 0 at all points. A
        # few more points than unknowns leave only true integrals, up to a negligible probability.
        kernel = nullspace((rate - value * change)[:, :few].T % prime())
        candidates = product(kernel, value) * over % prime()
        if not self._not_spanned(candidates, shell.degree):
            return
        for law in self._covariant(shell, candidates):
            yield self._finding(law, shell.degree)
        fresh = self._not_spanned(candidates, shell.degree)
        for law in self._componentwise(shell, [kernel[i] for i in fresh], exponents, candidates):
            yield self._finding(law, shell.degree)
        left = self._not_spanned(candidates, shell.degree)
        if left:
            self.known_integrals.values += [(shell.degree, candidates[i]) for i in left]
            yield SearchResult(
                "integral",
                None,
                None,
                remark=f"{len(left)} of degree {shell.degree} in the momenta, whose coefficients "
                f"have a degree above {self.question.parameter_degree} in the parameters",
            )

    def _monomials(self, shell: _Shell) -> tuple[list[Exponents], Integers, Integers]:
        """Monomials of a shell that are independent on the phase space."""
        monomials = self.tables.get(shell.ansatz)
        if monomials is None:
            monomials = self.tables[shell.ansatz] = table(shell.ansatz, self.sample)
        independent = self.independent_monomials.get((shell.ansatz, shell.degree))
        if independent is None:
            momenta = len(shell.ansatz.momenta)
            low = [i for i, e in enumerate(monomials.exponents) if sum(e[:momenta]) <= shell.degree]
            few = len(low) + _SPARE
            independent = [low[i] for i in independent_columns(monomials.value[low, :few].T)]
            self.independent_monomials[shell.ansatz, shell.degree] = independent
        return (
            [monomials.exponents[i] for i in independent],
            monomials.value[independent],
            monomials.rate[independent],
        )

    def _products(self, degree: int) -> Integers:
        return self.known_integrals.products(degree, self.question.ansatz.gamma_degree, self.points)

    def _not_spanned(self, functions: Integers, degree: int) -> list[int]:
        """Indices of functions that are not combinations of products of known integrals."""
        products = self._products(degree)
        self.full = self.full or len(products) + len(functions) + _SPARE > self.points
        # With fewer points than functions, every function would seem to be a combination.
        if self.full or not len(functions):
            return []
        stacked = np.concatenate([products, functions])
        first, few = len(products), len(stacked) + _SPARE
        return [i - first for i in independent_columns(stacked[:, :few].T) if i >= first]

    # --- formulas --------------------------------------------------------------------------

    def _covariant(self, shell: _Shell, functions: Integers) -> Iterator[sp.Expr]:
        """Vector formulas of increasing degree in the parameters, until no integral is missing."""
        plain = replace(shell, divisor=sp.S.One, exponent=0)
        for size in range(self.question.parameter_degree + 1):
            for way in dict.fromkeys((plain, shell)):
                yield from self._new_laws(self._vectorial(way, size, _MANY), shell.degree)
                if not self._not_spanned(functions, shell.degree):
                    return

    def _vectorial(self, shell: _Shell, size: int, most: int) -> list[sp.Expr]:
        """Vector formulas of one degree in the parameters, with a bounded number of unknowns."""
        scalars = self.vocabulary.scalars
        parts = self.vocabulary.parts(
            shell.degree,
            shell.ansatz.gamma_degree,
            most // comb(len(scalars.formulas) + size, size),
        )
        return self._laws_over_parameters(parts, scalars, size, shell)

    def _componentwise(
        self,
        shell: _Shell,
        kernel: Sequence[Integers],
        exponents: Sequence[Exponents],
        functions: Integers,
    ) -> Iterator[sp.Expr]:
        """Formulas in components, on the monomials that occur in the kernel."""
        symbols = (*shell.ansatz.momenta, *shell.ansatz.coordinates)
        scalars = component_scalars(self.space, self.weights)
        for vector in kernel:
            parts = []
            for entry, powers in zip(vector, exponents, strict=True):
                if entry:
                    formula = sp.Mul(*(s**e for s, e in zip(symbols, powers, strict=True)))
                    weight = weight_of(symbols, powers, self.weights)
                    parts.append(Part(formula, weight, sum(powers)))
            for size in range(self.question.parameter_degree + 1):
                before = len(self._not_spanned(functions, shell.degree))
                if len(parts) * comb(len(scalars.formulas) + size, size) > _MANY:
                    break
                laws = self._laws_over_parameters(parts, scalars, size, shell)
                yield from self._new_laws(laws, shell.degree)
                if len(self._not_spanned(functions, shell.degree)) < before:
                    break

    def _laws_over_parameters(
        self, parts: Sequence[Part], scalars: Scalars, size: int, shell: _Shell
    ) -> list[sp.Expr]:
        """Integrals with coefficients of one degree in the parameters, simplest first."""
        if not parts:
            return []

        def draw(points: int) -> Draw:
            sample = self.space.sample(points, _SEED + 1, common=False)
            jets = [sample(part.formula) for part in parts]
            value = np.array([jet.value for jet in jets])[:, None]
            rate = np.array([sample.along(jet) for jet in jets])[:, None]
            _, change = _divisor_power(sample, shell)
            return Draw(value, (rate - value * change) % prime(), sample.table(scalars.formulas))

        divisor = shell.divisor**shell.exponent
        solutions = reconstructed_laws(parts, scalars, size, draw)
        return [_formula(solution, parts, scalars) / divisor for solution in solutions]

    def _new_laws(self, laws: Sequence[sp.Expr], degree: int) -> Iterator[sp.Expr]:
        """The new laws, which are added to the known ones."""
        waiting = [(law, self.sample(law).value) for law in laws]
        while fresh := self._not_spanned(np.array([value for _, value in waiting]), degree):
            (law, value), *waiting = (waiting[i] for i in fresh)
            self.known_integrals.values.append((degree, value))
            if self._independent(law):
                self.formulas.append(law)
                yield law
            if not waiting:
                return

    def _independent(self, law: sp.Expr) -> bool:
        """True if the gradient of a law is independent of those of earlier ones."""
        formulas = [*self.space.relations, *self.formulas, law]
        gradients = np.array([self.sample(f).slope[:, 0] for f in formulas])
        return rank(gradients) > rank(gradients[:-1])

    # --- findings --------------------------------------------------------------------------

    def _finding(self, formula: sp.Expr, degree: int) -> SearchResult:
        name = f"F_{len(self.formulas)}"
        law = Integral(name, formula, level=self.space.on)
        verdict = prove(self.space.system, law, effort=self.question.effort)
        return SearchResult(
            "integral", law, verdict, catalogue_law=self._catalogue_name(formula, degree)
        )

    def _catalogue_name(self, formula: sp.Expr, degree: int) -> str:
        """The law of the catalogue equal to a formula modulo earlier integrals; empty if none."""
        products = self._products(max(degree, 2))
        value = self.sample(formula).value
        others = [row for row in products if (row != value).any()]
        for law in self.space.system.integrals:
            try:
                text = self.sample(law.value)
            except InputError:
                # Its functions are outside the scope of the search, so it does not count as found.
                continue
            if self.sample.along(text).any():
                continue
            coefficients = combination(np.array([*others, value]).T, text.value)
            if coefficients is not None and coefficients[-1]:
                return f"{law.name}, {law.source}" if law.source else law.name
        return ""


def _divisor_power(sample: Sample, shell: _Shell) -> tuple[Integers, Integers]:
    """Q⁻ˢ and the logarithmic rate of Qˢ at the points of a sample."""
    jet = sample(shell.divisor)
    below = inverse(jet.value)
    rate = sample.along(jet) * below % prime() * shell.exponent % prime()
    return power(below, shell.exponent), rate


def _formula(solution: RationalLaw, parts: Sequence[Part], scalars: Scalars) -> sp.Expr:
    """A solution scaled to coprime integer coefficients, with a positive simplest term."""
    numbers = [number for number, _, _ in solution.terms]
    simplest = min(
        solution.terms, key=lambda term: (scalars.effort(term[1]), parts[term[2]].effort)
    )[0]
    scale = Fraction(lcm(*(n.denominator for n in numbers)), gcd(*(n.numerator for n in numbers)))
    scale = scale if simplest > 0 else -scale
    return sp.Add(
        *(
            sp.Integer(int(number * scale))
            * sp.Mul(*(scalars.formulas[i] for i in chosen))
            * parts[index].formula
            for number, chosen, index in solution.terms
        )
    )
