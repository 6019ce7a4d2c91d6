"""The growth vector of a distribution, computed exactly.

Fields are Taylor series about a point. Fields found before, multiplied by functions, are subtracted
from a commutator, which does not change the span of later steps. A remainder that does not vanish
at the point is a new direction; one that vanishes only there is kept for further commutators.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import comb

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.taylor import PRIMES, IrrationalError, Modular, Numbers, Rational

from ..lagrangian.structure_functions import VectorField
from .distribution import Distribution, distribution_spanned_by
from .exact_points import (
    ConfigurationSpace,
    ExactPoint,
    FieldElement,
    NoPointError,
    ParameterValue,
    point_at,
    random_point,
)
from .vector_field_series import Bundle, Section, SingularError, Span

SEED = 20080830
RATIONAL_ATTEMPTS = 4
ATTEMPTS = 40
TERMS = 10000
"""Maximum number of terms of a series; it bounds the number of steps at a singular point."""
START = 3


@dataclass(frozen=True)
class Filtration:
    """Dimensions spanned at a point by the fields and their iterated commutators.

    Attributes
    ----------
    growth : tuple of int
        Dimensions, up to the step at which they stop growing.
    dimension : int
        Dimension of the configuration space.
    words : tuple of tuple of str
        The commutators added by each step, such as ``[η1, [η1, η2]]``.
    point : mapping of Symbol to formula
        The point; empty for a point modulo a prime, which represents a generic one.
    exact : bool
        Whether the dimensions were computed with rational numbers at that point; otherwise each is
        a lower bound, and too small only with a probability below 10⁻¹⁰.
    is_final : bool
        Whether no further commutator can add a dimension; at a singular point this may be
        undecided.
    """

    growth: tuple[int, ...]
    dimension: int
    words: tuple[tuple[str, ...], ...]
    point: Mapping[sp.Symbol, sp.Expr]
    exact: bool
    is_final: bool

    @property
    def rank(self) -> int:
        """Rank of the distribution itself."""
        return self.growth[0]

    @property
    def final(self) -> int:
        """Dimension reached by all commutators."""
        return self.growth[-1]


def pivots_at(distribution: Distribution, place: ExactPoint) -> tuple[FieldElement, ...]:
    """Pivots of the elimination, one of which vanishes if the growth at the point is smaller.

    Raises
    ------
    SingularError, ZeroDivisionError, IrrationalError
        If the constraints are dependent or singular, or contain an irrational root.
    """
    order = START
    while True:
        span = Span(place.numbers)
        bundle = Bundle(distribution, place.germs(distribution.space(), order))
        if _filtration_of_span(distribution, place, bundle, span)[1] or order == _highest(
            len(distribution.coordinates)
        ):
            return (*bundle.leads, *span.leads)
        order = min(2 * order, _highest(len(distribution.coordinates)))


def _filtration_and_sufficiency(
    distribution: Distribution, place: ExactPoint, order: int
) -> tuple[Filtration, bool]:
    """The filtration by series of given order, and whether the order sufficed."""
    bundle = Bundle(distribution, place.germs(distribution.space(), order))
    return _filtration_of_span(distribution, place, bundle, Span(place.numbers))


def _filtration_of_span(
    distribution: Distribution, place: ExactPoint, bundle: Bundle, span: Span
) -> tuple[Filtration, bool]:
    """The filtration, and whether the series are long enough; `span` is filled."""
    basis = bundle.admissible()
    fields = [bundle.section(section) for section in basis]
    dimension = _dimension(distribution, bundle)
    names = [f"η{i}" for i in range(1, len(fields) + 1)]
    last: list[tuple[str, Section]] = []
    words: list[tuple[str, ...]] = [()]
    for name, field in zip(names, fields, strict=True):
        added = span.add(field)
        if added is not None:
            last.append((name, added[0]))
            words[0] += (name,) if added[1] else ()
    counts = [len(span.pivots)]
    generators = [section for _, section in last]
    letters = [name for name, _ in last]
    while last and counts[-1] < dimension:
        # each bracket costs one order of the series: with order 0 no further bracket is known
        if last[0][1][0].order == 0:
            return _filtration(distribution, place, counts, dimension, words, False), False
        next_sections: list[tuple[str, Section]] = []
        directions: tuple[str, ...] = ()
        # By the Jacobi identity all iterated commutators are combinations of [η_i, W] with the
        # fields η_i themselves and words W of the step before.
        for i, (letter, field) in enumerate(zip(letters, generators, strict=True)):
            for j, (word, other) in enumerate(last):
                # in the first step [η_i, η_j] = −[η_j, η_i]
                if len(counts) == 1 and j <= i:
                    continue
                added = span.add(bundle.bracket(field, other))
                if added is not None:
                    name = f"[{letter}, {word}]"
                    next_sections.append((name, added[0]))
                    directions += (name,) if added[1] else ()
        last = next_sections
        if last:
            counts.append(len(span.pivots))
            words.append(directions)
    return _filtration(distribution, place, counts, dimension, words, True), True


def _filtration(
    distribution: Distribution,
    place: ExactPoint,
    counts: Sequence[int],
    dimension: int,
    words: Sequence[tuple[str, ...]],
    is_final: bool,
) -> Filtration:
    return Filtration(
        tuple(counts),
        dimension,
        tuple(words),
        {s: v for s, v in place.formulas.items() if s in distribution.coordinates},
        place.numbers.exact and not place.formal,
        is_final,
    )


def _dimension(distribution: Distribution, bundle: Bundle) -> int:
    """Dimension of the configuration space at the point."""
    germs = bundle.germs
    if germs.order == 0:
        return len(distribution.coordinates)
    slopes = []
    for relation in distribution.relations:
        series = germs.series(relation)
        row = [series.derivative(q).value for q, _ in enumerate(distribution.coordinates)]
        if bundle.constants is not None:
            row = [
                sum((value.value * row[q] for q, value in field.items()), germs.numbers.number(0))
                for field in bundle.anchor
            ]
        slopes.append(row)
    width = bundle.size
    used = int(germs.numbers.matrix(slopes, width).rank()) if slopes else 0
    return width - used


def filtration(distribution: Distribution, point: Mapping[sp.Symbol, ParameterValue]) -> Filtration:
    """The growth of a distribution at a point.

    Parameters
    ----------
    distribution : Distribution
    point : mapping of Symbol to exact number
        Rational numbers, roots of them, and multiples of π for angles; coordinates not given are
        chosen at random. Parameters may be given, too.

    Raises
    ------
    InputError
        If the point does not lie on the relations, or the constraints become dependent there.
    """
    rng = random.Random(SEED)
    final = generic(distribution).final

    def there(numbers: Numbers) -> Filtration | None:
        try:
            place = point_at(distribution.space(), point, numbers, rng)
            return (
                None
                if numbers.exact and place.formal
                else _filtration_reaching(distribution, place, final)
            )
        except (NoPointError, IrrationalError):
            return None
        except (SingularError, ZeroDivisionError):
            raise InputError(
                f"{distribution.name}: the constraints are dependent or singular at this point, so "
                "that the admissible velocities have no constant dimension about it"
            ) from None

    result = _first_confirmed(there)
    if result is None:
        raise InputError(
            f"{distribution.name}: the point has roots that cannot be computed with exactly"
        )
    return result


def _first_confirmed(trial: Callable[[Numbers], Filtration | None]) -> Filtration | None:
    """A result modulo a prime, or the result with rational numbers if both agree."""
    result: Filtration | None = None
    for prime in PRIMES:
        result = result or trial(Modular(prime))
    for _ in range(RATIONAL_ATTEMPTS):
        exact = trial(Rational()) if result else None
        if result and exact and exact.growth == result.growth:
            return exact
    return result


def _filtration_reaching(
    distribution: Distribution, place: ExactPoint, final: int = 0
) -> Filtration:
    """The filtration by series of sufficient order to reach a dimension.

    At a singular point a section that vanishes up to some order may contribute at a higher one.
    """
    order, highest = START, _highest(len(distribution.coordinates))
    while True:
        result, enough = _filtration_and_sufficiency(distribution, place, order)
        if enough and result.final >= final:
            return result
        if order == highest:
            return replace(result, is_final=False)
        order = min(2 * order, highest)


def _highest(variables: int) -> int:
    """The largest order at which series have at most `TERMS` terms."""
    order = START
    while variables and comb(order + 1 + variables, variables) <= TERMS:
        order += 1
    return order


def generic(distribution: Distribution, free: Sequence[sp.Symbol] = ()) -> Filtration:
    """The growth at a generic point, which is rational if one with this growth is found.

    Parameters
    ----------
    distribution : Distribution
    free : sequence of Symbol
        Parameters that get random values instead of their own.

    Raises
    ------
    InputError
        If no point was found.
    """
    rng = random.Random(SEED)
    space = distribution.space(free)
    result = _first_confirmed(lambda numbers: _at_random_point(distribution, space, numbers, rng))
    if result is None:
        raise InputError(
            f"{distribution.name}: no point was found at which the relations and position "
            "constraints hold and the constraints are independent"
        )
    return result


def _at_random_point(
    distribution: Distribution, space: ConfigurationSpace, numbers: Numbers, rng: random.Random
) -> Filtration | None:
    for _ in range(RATIONAL_ATTEMPTS if numbers.exact else ATTEMPTS):
        try:
            return _filtration_reaching(distribution, random_point(space, numbers, rng))
        except NoPointError:
            return None
        except (IrrationalError, SingularError, ZeroDivisionError):
            continue
    return None


def growth(
    fields: Sequence[VectorField],
    coordinates: Sequence[sp.Symbol],
    point: Mapping[sp.Symbol, ParameterValue],
) -> tuple[int, ...]:
    """Dimensions of the spans of fields and of their iterated commutators.

    Parameters
    ----------
    fields : sequence of mapping from coordinate to component
    coordinates : sequence of Symbol
        They may be redundant; the fields are then tangent to the relations between them.
    point : mapping of Symbol to exact number
        Values of coordinates and constants.

    Returns
    -------
    tuple of int
        Dimensions, up to the step at which they stop growing.
    """
    own = set(coordinates)
    constants = {s: v for s, v in point.items() if s not in own}
    distribution = distribution_spanned_by("fields", fields, coordinates, constants=constants)
    return filtration(distribution, {s: v for s, v in point.items() if s in own}).growth
