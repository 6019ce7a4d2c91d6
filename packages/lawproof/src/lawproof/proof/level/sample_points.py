"""Points of a phase space: rational if possible, else balls around real numbers."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from flint import arb, fmpq, fmpq_poly

from flowlanes.formulas.errors import NotExactError
from flowlanes.formulas.number_fields import exact_root

from .triangular_set import Terms


def number_near_default(
    default: float | None, generator: random.Random, both_signs: bool = False
) -> fmpq:
    """A random rational number near the default of a parameter; never 1."""
    if default is None or default == 0:
        reach = generator.choice([17, 17, 60])
        sign, above = generator.choice([-1, 1]), generator.randint(3, reach)
        below = generator.randint(11, 19)
        return fmpq(sign * above, below + (above == below))
    value = Fraction(repr(float(default))) * Fraction(generator.randint(90, 115), 100)
    return fmpq(value.numerator, value.denominator)


def moderate_number(
    default: float | None, generator: random.Random, both_signs: bool = False
) -> fmpq:
    """A random rational number of moderate size, sometimes a small integer.

    The sign is random unless it is known; then it is that of the default.
    """
    if default and generator.random() < (0.5 if both_signs else 0.2):
        return number_near_default(default, generator)
    if not default and generator.random() < 0.3:
        return fmpq(generator.choice([-3, -2, -1, 1, 2, 3]))
    scale = Fraction(repr(float(default or 1.0)))
    value = scale * Fraction(generator.randint(1, 24), generator.randint(4, 9))
    if not both_signs:
        value *= generator.choice([-1, 1])
    return fmpq(value.numerator, value.denominator)


def small_number(default: float | None, generator: random.Random, both_signs: bool = False) -> fmpq:
    """A random multiple of 1/2, in units of 1 or of a power of ten near the default.

    For a parameter in an exponent this often gives an integer, so that bases may be negative. The
    sign is chosen as in `moderate_number`.
    """
    sign = -1 if default and default < 0 else 1
    if not both_signs:
        sign = generator.choice([-1, 1])
    power = generator.choice([0, round(math.log10(abs(default)))]) if default else 0
    return fmpq(sign * generator.randint(1, 6), 2) * fmpq(10) ** power


def number_of_any_magnitude(
    default: float | None, generator: random.Random, both_signs: bool = False
) -> fmpq:
    """A random rational number of any order of magnitude, for quantities in any units."""
    value = moderate_number(default, generator, both_signs)
    power = generator.randint(-13, 13)
    return value * fmpq(10) ** power if default is None else value


def point_on_sphere(
    main: str, terms: Terms, fixed: set[str], generator: random.Random
) -> dict[str, fmpq] | None:
    """A rational point of x² + y² + … = c, if the relation has this form and c is a square."""
    members, constant, scale = [], fmpq(0), None
    for named, number in terms.items():
        present = [(n, p) for n, p in named if p]
        if not present:
            constant = number
        elif len(present) == 1 and present[0][1] == 2 and scale in (None, number):
            members.append(present[0][0])
            scale = number
        else:
            return None
    if scale is None or len(members) < 2 or fixed & set(members):
        return None
    try:
        radius = exact_root(-constant / scale, 2)
    except NotExactError:
        return None
    # Inverse stereographic projection maps rational points to rational points of the sphere.
    shares = [fmpq(generator.randint(-9, 9), generator.randint(7, 13)) for _ in members[1:]]
    square = sum((s * s for s in shares), fmpq(0))
    point = [2 * s / (1 + square) for s in shares] + [(square - 1) / (1 + square)]
    # A zero coordinate is too special: a residual may vanish there only by accident.
    if any(x == 0 for x in point):
        raise ZeroDivisionError
    return {n: radius * x for n, x in zip(sorted(members), point, strict=True)}


def real_root(
    main: str, terms: Terms, values: Mapping[str, fmpq | arb], generator: random.Random
) -> fmpq | arb:
    """A real value of the main variable, given the values of the other variables."""
    coefficients: dict[int, fmpq | arb] = {}
    for named, number in terms.items():
        total: fmpq | arb = number
        degree = 0
        for name, power in named:
            if name == main:
                degree = power
            elif power:
                total = values[name] ** power * total
        coefficients[degree] = coefficients.get(degree, fmpq(0)) + total
    top = max(coefficients)
    c = [coefficients.get(i, fmpq(0)) for i in range(top + 1)]
    if top == 1:
        return _quotient(-c[0], c[1])
    if top == 2:
        square = c[1] * c[1] - 4 * c[0] * c[2]
        if not square > 0:
            raise ZeroDivisionError
        sign = generator.choice([-1, 1])
        try:
            if not isinstance(square, fmpq):
                raise NotExactError
            root: fmpq | arb = exact_root(square, 2)
        except NotExactError:
            root = arb(square).sqrt()
        return _quotient(sign * root - c[1], 2 * c[2])
    rational = [x for x in c if isinstance(x, fmpq)]
    if len(rational) == len(c):
        # Roots of higher degree are found as balls, and only if all coefficients are exact.
        roots: Any = fmpq_poly(rational).complex_roots()
        real: list[arb] = [z.real for z, _ in roots if z.imag == 0]
        if real:
            return generator.choice(real)
    raise ZeroDivisionError


def number_text(value: fmpq | arb) -> str:
    """Text of a number."""
    return str(value) if isinstance(value, fmpq) else str(value.str(20))


def _quotient(above: fmpq | arb, below: fmpq | arb) -> fmpq | arb:
    if below == 0 or (not isinstance(below, fmpq) and 0 in below):
        raise ZeroDivisionError
    return above / below
