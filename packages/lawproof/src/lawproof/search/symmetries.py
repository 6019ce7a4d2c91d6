"""Search for symmetry fields with polynomial components."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.system.laws import Integral, Symmetry, of_kind
from flowlanes.system.vectors import constant

from ..proof.prover import prove
from .ansatz import Exponents, Table, table
from .integrals import integrals
from .modular_jets import Integers, prime
from .modular_linalg import independent_columns, nullspace, product
from .phase_space import Sample
from .rational_reconstruction import Draw, Part, RationalLaw, Scalars, reconstructed_laws
from .result import Progress, SearchResult, SearchSpace, no_progress
from .scaling import Weight, weight_of, weights
from .vector_invariants import component_scalars

_SPARE = 24
_SEED = 20080830


@arguments_checked
def symmetries(question: SearchSpace, progress: Progress = no_progress) -> Iterator[SearchResult]:
    """Iterate over polynomial vector fields u with [u, v] = 0, tangent to the phase space.

    v itself, and products of known symmetries with integrals, are omitted.

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
    >>> x, y, u, v = sp.symbols("x y u v", real=True)
    >>> oscillator = flowlanes.System("oscillator", "Plane oscillator", {x: u, y: v, u: -x, v: -y})
    >>> question = lawproof.search.search_space(oscillator, degree=1, gamma_degree=1)
    >>> [found.verdict.decision for found in lawproof.search.symmetries(question)][:1]
    ['proven']
    """
    question.ansatz.check(len(question.stage.system.symbols))
    progress(0.0, "integrals")
    laws = list(of_kind((f.law for f in integrals(question) if f.law is not None), Integral))
    progress(0.3, "fields")
    search = _Search(question, [law.value for law in laws])
    yield from search.findings(progress)
    progress(1.0, "")


class _Search:
    """One search: all vector fields of the ansatz at the points of one sample."""

    def __init__(self, question: SearchSpace, formulas: Sequence[sp.Expr]) -> None:
        self.question = question
        self.space = question.stage
        self.symbols = question.stage.system.symbols
        self.weights: dict[sp.Symbol, Weight] = weights(self.space)
        self.sample = self.space.sample(question.ansatz.size + _SPARE, _SEED, common=True)
        factors = [np.ones_like(self.sample.field[0])]
        factors += [self.sample(f).value for f in formulas]
        # Products of two integrals are included, because a symmetry times such a product is a
        # symmetry.
        factors += [a * b % prime() for i, a in enumerate(factors[1:]) for b in factors[i + 1 :]]
        self.factors = factors
        self.span_rows: list[Integers] = []
        # The vector field itself is a known symmetry.
        self._span(np.array(self.sample.field))
        self.count = 0

    def _span(self, field: Integers) -> None:
        """Record a symmetry by its components at the points, shape (n, N)."""
        self.span_rows += [(field * factor % prime()).ravel() for factor in self.factors]

    def findings(self, progress: Progress) -> Iterator[SearchResult]:
        """All symmetries of the ansatz, simplest first."""
        monomials: Table = table(self.question.ansatz, self.sample)
        # On the level some monomials are combinations of others.
        independent = independent_columns(monomials.value.T)
        exponents = [monomials.exponents[i] for i in independent]
        value, condition = _fields(
            self.space.relations,
            self.sample,
            monomials.value[independent],
            monomials.rate[independent],
        )
        kernel = nullspace(condition.reshape(len(condition), -1).T)
        values = product(kernel, value.reshape(len(value), -1))
        # Fields with few terms come first, so that later ones are compared with them.
        vectors = sorted(
            zip(kernel, values, strict=True), key=lambda pair: np.count_nonzero(pair[0])
        )
        for number, (vector, field) in enumerate(vectors):
            progress(0.5 + 0.5 * number / len(vectors), "fields")
            if not self._fresh(field):
                continue
            yield self._over_parameters(vector, exponents)
            self._span(field.reshape(len(self.symbols), -1))

    def _fresh(self, field: Integers) -> bool:
        # A field is new if it is not a combination of known symmetries times integrals.
        stacked = np.array([*self.span_rows, field]).T
        return independent_columns(stacked)[-1] == len(self.span_rows)

    def _over_parameters(self, vector: Integers, exponents: Sequence[Exponents]) -> SearchResult:
        """The symmetry as a formula, on the monomials that occur, with unknown coefficients."""
        variables = (*self.question.ansatz.momenta, *self.question.ansatz.coordinates)
        parts = []
        for index in np.flatnonzero(vector):
            component, monomial = divmod(int(index), len(exponents))
            powers = exponents[monomial]
            formula = sp.Mul(*(s**e for s, e in zip(variables, powers, strict=True)))
            own = self.symbols[component]
            weight = weight_of((*variables, own), (*powers, -1), self.weights)
            parts.append(Part(((str(self.symbols[component]), formula),), weight, sum(powers)))
        scalars = component_scalars(self.space, self.weights)
        for size in range(self.question.parameter_degree + 1):
            solution = self._simplest(parts, scalars, size)
            if solution is not None:
                return self._finding(solution, parts, scalars)
        return SearchResult(
            "symmetry",
            None,
            None,
            remark=f"a field of {len(parts)} terms, whose coefficients have a degree above "
            f"{self.question.parameter_degree} in the parameters",
        )

    def _simplest(self, parts: Sequence[Part], scalars: Scalars, size: int) -> RationalLaw | None:
        """The simplest symmetry with coefficients up to a degree in the parameters, or None."""
        names = [str(s) for s in self.symbols]
        places = []
        formulas = []
        for part in parts:
            ((name, formula),) = part.formula
            places.append(names.index(name))
            formulas.append(formula)

        def draw(points: int) -> Draw:
            sample = self.space.sample(points, _SEED + 1, common=False)
            jets = [sample(formula) for formula in formulas]
            value = np.array([jet.value for jet in jets])
            rate = np.array([sample.along(jet) for jet in jets])
            values, conditions = _fields(self.space.relations, sample, value, rate)
            chosen = [place * len(parts) + i for i, place in enumerate(places)]
            return Draw(values[chosen], conditions[chosen], sample.table(scalars.formulas))

        solutions = reconstructed_laws(parts, scalars, size, draw)
        return solutions[0] if solutions else None

    def _finding(
        self, solution: RationalLaw, parts: Sequence[Part], scalars: Scalars
    ) -> SearchResult:
        components = {s: sp.S.Zero for s in self.symbols}
        names = {str(s): s for s in self.symbols}
        for number, chosen, index in solution.terms:
            ((name, formula),) = parts[index].formula
            factor = sp.Mul(*(scalars.formulas[i] for i in chosen))
            components[names[name]] += (
                sp.Rational(number.numerator, number.denominator) * factor * formula
            )
        field = []
        for name in self.space.system.state:
            if isinstance(name, sp.Symbol):
                field.append((name, components[name]))
            else:
                field.append((name, constant([components[s] for s in name.symbols])))
        self.count += 1
        law = Symmetry(f"u_{self.count}", tuple(field), level=self.space.on)
        return SearchResult(
            "symmetry", law, prove(self.space.system, law, effort=self.question.effort)
        )


def _fields(
    relations: Sequence[sp.Expr], sample: Sample, value: Integers, rate: Integers
) -> tuple[Integers, Integers]:
    """All vector fields with one monomial in one component, and the expressions that must vanish.

    Returns
    -------
    values : array of int64, shape (n · monomials, n, points)
    conditions : array of int64, shape (n · monomials, n + relations, points)
        The components of [u, v] and the rates u(R).
    """
    n, (many, points) = len(sample.field), value.shape
    values = np.zeros((n, many, n, points), dtype=np.int64)
    conditions = np.zeros((n, many, n + len(relations), points), dtype=np.int64)
    # For u = m ∂_c: [u, v] = m ∂v/∂x_c − v(m) ∂_c, and u(R) = m ∂R/∂x_c.
    slopes = [*(r.slope for r in sample.rates), *(sample(r).slope for r in relations)]
    for component in range(n):
        values[component, :, component] = value
        for row, slope in enumerate(slopes):
            conditions[component, :, row] = value * slope[component] % prime()
        conditions[component, :, component] -= rate
    shape = (n * many, -1, points)
    return values.reshape(shape), conditions.reshape(shape) % prime()
