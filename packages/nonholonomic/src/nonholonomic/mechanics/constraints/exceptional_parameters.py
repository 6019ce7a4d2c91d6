"""Parameter values at which the growth vector of a distribution is smaller than usual.

At a fixed point, modulo a prime, the pivots of the elimination that determines the growth are
rational functions of the parameter, found by interpolation. At a value with smaller growth one of
them vanishes at every point. Every rational zero common to several points is then tested.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import Any

import sympy as sp
from flint import nmod, nmod_poly

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.taylor import PRIMES, IrrationalError, Modular
from flowlanes.system.named_formulas import expand
from flowlanes.system.parameters import require_parameters

from ..lagrangian.mechanism import Mechanism
from .distribution import Distribution, distribution
from .exact_points import ExactPoint, NoPointError, random_point
from .growth import SEED, Filtration, generic, pivots_at
from .vector_field_series import SingularError

POINTS = 3
SAMPLES = 240
"""Largest number of samples for the interpolation of a pivot."""


@dataclass(frozen=True)
class ExceptionalValue:
    """A parameter value and the growth vector there.

    Attributes
    ----------
    parameter : Symbol
    value : Rational
    growth : tuple of int
        Growth vector at this value, at a generic point.
    usual : tuple of int
        Growth vector at almost all values.
    dimension : int
        Dimension of the configuration space.
    """

    parameter: sp.Symbol
    value: sp.Rational
    growth: tuple[int, ...]
    usual: tuple[int, ...]
    dimension: int


@arguments_checked
def exceptional_values(
    mechanism: Mechanism | Distribution, parameter: sp.Symbol
) -> tuple[ExceptionalValue, ...]:
    """Nonzero rational values of a parameter with an unusual growth.

    The other parameters keep their values.

    Parameters
    ----------
    mechanism : Mechanism or Distribution
    parameter : sympy.Symbol

    Returns
    -------
    tuple of ExceptionalValue
        The exceptional values, each with its growth vector.

    Raises
    ------
    InputError
        If there is no such parameter, if the configuration space depends on it, or if the
        constraints are not rational in it.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0))
    >>> mechanism = nonholonomic.rolling_mechanism(
    ...     nonholonomic.RollingBody(ball, nonholonomic.Sphere(3.0), "rubber")
    ... )
    >>> [
    ...     str(item.value)
    ...     for item in nonholonomic.mechanics.constraints.exceptional_values(
    ...         mechanism, flowlanes.system.real_symbol("a")
    ...     )
    ... ]
    ['1']
    """
    admissible = mechanism if isinstance(mechanism, Distribution) else distribution(mechanism)
    names = [s for s, _ in admissible.constants]
    require_parameters(admissible.name, names, [parameter])
    if any(parameter in expand(r, admissible.steps).free_symbols for r in admissible.relations):
        raise InputError(
            f"{admissible.name}: the configuration space itself depends on {parameter}"
        )
    usual = generic(admissible, [parameter])
    exceptions = []
    for value in _candidates(admissible, parameter):
        there = _growth_at_value(admissible, parameter, value)
        if there is not None and there.growth != usual.growth:
            exceptions.append(
                ExceptionalValue(parameter, value, there.growth, usual.growth, usual.dimension)
            )
    return tuple(sorted(exceptions, key=lambda e: e.value))


def _growth_at_value(
    admissible: Distribution, parameter: sp.Symbol, value: sp.Rational
) -> Filtration | None:
    """The growth at a value of a parameter; None if the constraints become dependent."""
    constants = tuple((s, value if s == parameter else v) for s, v in admissible.constants)
    try:
        return generic(replace(admissible, constants=constants))
    except InputError:
        return None


def _candidates(admissible: Distribution, parameter: sp.Symbol) -> list[sp.Rational]:
    """Rational zeros common to the pivots at several points."""
    numbers = Modular(PRIMES[0])
    rng = random.Random(SEED)
    products = (_vanishing(admissible, parameter, numbers, rng) for _ in range(POINTS))
    common = reduce(lambda left, right: left.gcd(right), products)
    zeros = [-f[0] / f[1] for f, _ in common.factor()[1] if f.degree() == 1]
    fractions = [numbers.fraction(zero) for zero in zeros]
    return [sp.Rational(f.numerator, f.denominator) for f in fractions if f]


def _vanishing(
    admissible: Distribution, parameter: sp.Symbol, numbers: Modular, rng: random.Random
) -> nmod_poly:
    """The product of the numerators of the pivots at a random point."""
    place = _random_point_of(admissible, parameter, numbers, rng)
    samples: list[tuple[nmod, tuple[Any, ...]]] = []
    wanted = 8
    while wanted <= SAMPLES:
        while len(samples) < wanted:
            value = numbers.random_number(rng)
            samples.append((value, _pivots(admissible, place, parameter, value)))
        numerators = [
            _numerator([(p, row[i]) for p, row in samples], numbers.prime)
            for i in range(len(samples[0][1]))
        ]
        known = [numerator for numerator in numerators if numerator is not None]
        if len(known) == len(numerators):
            product = nmod_poly([1], numbers.prime)
            for numerator in known:
                product = product * numerator
            return product
        wanted *= 2
    raise InputError(f"{admissible.name}: {parameter} does not enter the constraints rationally")


def _random_point_of(
    admissible: Distribution, parameter: sp.Symbol, numbers: Modular, rng: random.Random
) -> ExactPoint:
    try:
        return random_point(admissible.space([parameter]), numbers, rng)
    except NoPointError:
        raise InputError(
            f"{admissible.name}: no point of its configuration space was found"
        ) from None


def _pivots(
    admissible: Distribution, place: ExactPoint, parameter: sp.Symbol, value: nmod
) -> tuple[Any, ...]:
    there = replace(place, values={**place.values, parameter: value})
    try:
        return pivots_at(admissible, there)
    except (IrrationalError, SingularError, ZeroDivisionError):
        raise InputError(
            f"{admissible.name}: {parameter} does not enter the constraints rationally"
        ) from None


def _numerator(samples: Sequence[tuple[nmod, nmod]], prime: int) -> nmod_poly | None:
    """The numerator of the rational function through samples; None if not determined."""
    # Cauchy interpolation (J. von zur Gathen, J. Gerhard, Modern Computer Algebra, §5.8): Newton's
    # polynomial through all samples, then the extended Euclidean algorithm with Π (x − x_i); each
    # remainder over its cofactor takes the sampled values.
    modulus, through = nmod_poly([1], prime), nmod_poly([0], prime)
    for place, value in samples:
        step = (value - through(place)) / modulus(place)
        through = through + modulus * step
        modulus = modulus * nmod_poly([-place, 1], prime)
    before, last = modulus, through
    factors = nmod_poly([0], prime), nmod_poly([1], prime)
    # the Euclidean scheme is stopped halfway; the fraction is accepted only if a surplus of samples
    # over coefficients confirms it
    while last.degree() > len(samples) // 2 - 2:
        quotient, remainder = divmod(before, last)
        before, last = last, remainder
        factors = factors[1], factors[0] - quotient * factors[1]
    if last.degree() + factors[1].degree() > len(samples) - 4:
        return None
    return last
