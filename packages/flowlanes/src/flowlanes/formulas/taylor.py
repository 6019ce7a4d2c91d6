"""Truncated Taylor series in several variables, over the rationals or modulo a prime.

A series is stored by its homogeneous parts.  Euler's operator multiplies a part by its degree, so
quotients, roots and elementary functions follow from recurrences between the parts.

Modulo a prime a generic point can be used even if roots are irrational at all rational points: a
minor that is nonzero there is not identically zero.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from math import isqrt
from typing import Any, TypeAlias

import sympy as sp
from flint import (
    Ordering,
    fmpq,
    fmpq_mat,
    fmpq_mpoly_ctx,
    fmpq_poly,
    nmod,
    nmod_mat,
    nmod_mpoly_ctx,
    nmod_poly,
)

#: Primes p with (p − 1)/2 prime: every number has roots of odd degree, and every second one a
#: square root; 2 and 3 have square roots.
PRIMES = (4611686018427376319, 4611686018427375743, 4611686018427369527)
#: A rational number (fmpq) or a residue (nmod); no static type covers both.
Number: TypeAlias = Any
#: Polynomial with such coefficients.
Polynomial: TypeAlias = Any
#: Matrix of such numbers.
Matrix: TypeAlias = Any
Fractional: TypeAlias = int | Fraction | fmpq | sp.Rational

#: Largest numerators and denominators of random coordinates.
HEIGHT = 5


class IrrationalError(ArithmeticError):
    """Raised if the numbers in use do not contain a required root."""


class Rational:
    """Field of the rational numbers."""

    exact = True

    def number(self, value: Fractional) -> Number:
        """Integer or fraction as a number of this kind."""
        fraction = _fraction(value)
        return fmpq(fraction.numerator, fraction.denominator)

    def random_number(self, rng: random.Random) -> Number:
        """Small nonzero random number."""
        return fmpq(rng.choice((-1, 1)) * rng.randint(1, HEIGHT), rng.randint(1, HEIGHT))

    def root(self, value: Number, degree: int) -> Number:
        """Positive root.

        Raises
        ------
        IrrationalError
            If it is not rational.
        """
        top, bottom = (_whole_root(int(part), degree) for part in (value.p, value.q))
        return fmpq(top, bottom)

    def zero_of(self, coefficients: Sequence[Number]) -> Number:
        """Zero of the polynomial with these coefficients, constant first.

        Raises
        ------
        IrrationalError
            If no zero is of this kind.
        """
        return _linear_zero(fmpq_poly(list(coefficients)))

    def ring(self, names: Sequence[str]) -> fmpq_mpoly_ctx:
        """Ring of polynomials in given variables."""
        return fmpq_mpoly_ctx.get(list(names), Ordering.lex)

    def matrix(self, rows: Sequence[Sequence[Number]], width: int) -> Matrix:
        """Matrix with exact elimination."""
        return fmpq_mat(len(rows), width, [entry for row in rows for entry in row])


class Modular:
    """Field of the integers modulo a prime."""

    exact = False

    def __init__(self, prime: int = PRIMES[0]) -> None:
        self.prime = prime

    def number(self, value: Fractional) -> Number:
        """Integer or fraction as a number of this kind."""
        if isinstance(value, int):
            return nmod(value, self.prime)
        fraction = _fraction(value)
        above = nmod(fraction.numerator % self.prime, self.prime)
        return above / nmod(fraction.denominator, self.prime)

    def random_number(self, rng: random.Random) -> Number:
        """Nonzero random number."""
        return nmod(rng.randrange(1, self.prime), self.prime)

    def root(self, value: Number, degree: int) -> Number:
        """Root; for a fraction with a rational root, the positive one.

        Raises
        ------
        IrrationalError
            If there is no root modulo this prime.
        """
        # A fraction with a rational root gets its positive root, as over the rationals.
        fraction = self.fraction(value)
        if fraction is not None and fraction > 0:
            try:
                return self.number(
                    Fraction(
                        _whole_root(fraction.numerator, degree),
                        _whole_root(fraction.denominator, degree),
                    )
                )
            except IrrationalError:
                pass
        whole = int(value)
        # p ≡ 3 mod 4, so the power is the square root that is itself a square, and further square
        # roots exist if any does.
        while degree % 2 == 0:
            half = pow(whole, (self.prime + 1) // 4, self.prime)
            if half * half % self.prime != whole:
                raise IrrationalError
            whole, degree = half, degree // 2
        return nmod(pow(whole, pow(degree, -1, self.prime - 1), self.prime), self.prime)

    def fraction(self, value: nmod) -> Fraction | None:
        """Fraction with small numerator and denominator that represents a residue, or None."""
        # Rational reconstruction by Euclid's algorithm: every remainder is a multiple of the
        # residue modulo p, and the first small one gives the fraction.
        bound = isqrt(self.prime // 2)
        before, last = (self.prime, 0), (int(value), 1)
        while last[0] > bound:
            step = before[0] // last[0]
            before, last = last, (before[0] - step * last[0], before[1] - step * last[1])
        if last[1] == 0 or abs(last[1]) > bound:
            return None
        return Fraction(last[0], last[1])

    def zero_of(self, coefficients: Sequence[Number]) -> Number:
        """Zero of the polynomial with these coefficients, constant first.

        Raises
        ------
        IrrationalError
            If no zero is of this kind.
        """
        return _linear_zero(nmod_poly([int(c) for c in coefficients], self.prime))

    def ring(self, names: Sequence[str]) -> nmod_mpoly_ctx:
        """Ring of polynomials in given variables."""
        return nmod_mpoly_ctx.get(list(names), modulus=self.prime, ordering=Ordering.lex)

    def matrix(self, rows: Sequence[Sequence[Number]], width: int) -> Matrix:
        """Matrix with exact elimination."""
        return nmod_mat(len(rows), width, [int(e) for row in rows for e in row], self.prime)


Numbers: TypeAlias = Rational | Modular
Ring: TypeAlias = fmpq_mpoly_ctx | nmod_mpoly_ctx


def _linear_zero(polynomial: Polynomial) -> Number:
    """Zero of a linear factor; the last one, which is positive for a root."""
    for factor, _ in reversed(polynomial.factor()[1]):
        if factor.degree() == 1:
            return -factor[0] / factor[1]
    raise IrrationalError


def _fraction(value: Fractional) -> Fraction:
    if isinstance(value, fmpq | sp.Rational):
        return Fraction(int(value.p), int(value.q))
    return Fraction(value)


def _whole_root(value: int, degree: int) -> int:
    if value < 0:
        raise IrrationalError
    guess = isqrt(value) if degree == 2 else round(value ** (1.0 / degree))
    # the root in doubles may differ by one
    for near in (guess - 1, guess, guess + 1):
        if near**degree == value:
            return near
    raise IrrationalError


class Series:
    """Power series about the origin, known up to an order.

    Parameters
    ----------
    numbers : Numbers
    ring
        Polynomials in the variables, as from ``numbers.ring``.
    parts : list of polynomial
        Homogeneous parts of degree 0, 1, …; the series is known up to the last of them.
    """

    __slots__ = ("numbers", "parts", "ring")

    def __init__(self, numbers: Numbers, ring: Ring, parts: list[Polynomial]) -> None:
        self.numbers, self.ring, self.parts = numbers, ring, parts

    @classmethod
    def constant(cls, numbers: Numbers, ring: Ring, value: Number, order: int) -> Series:
        """Constant series."""
        none = ring.constant(0)
        whole = int(value) if isinstance(value, nmod) else value
        return cls(numbers, ring, [ring.constant(whole), *[none] * order])

    @property
    def order(self) -> int:
        """Degree up to which the series is known."""
        return len(self.parts) - 1

    @property
    def value(self) -> Number:
        """Value at the origin."""
        first = self.parts[0]
        if first.is_zero():
            return self.numbers.number(0)
        coefficient = first.coeffs()[0]
        return coefficient if self.numbers.exact else self.numbers.number(coefficient)

    @property
    def is_zero(self) -> bool:
        """True if all known parts are zero."""
        return all(part.is_zero() for part in self.parts)

    @property
    def is_constant(self) -> bool:
        """True if all known parts except the value are zero."""
        return all(part.is_zero() for part in self.parts[1:])

    def _with_parts(self, parts: list[Polynomial]) -> Series:
        return Series(self.numbers, self.ring, parts)

    def _like(self, value: Number) -> Series:
        return Series.constant(self.numbers, self.ring, value, self.order)

    def __add__(self, other: Series) -> Series:
        return self._with_parts([a + b for a, b in zip(self.parts, other.parts, strict=False)])

    def __sub__(self, other: Series) -> Series:
        return self._with_parts([a - b for a, b in zip(self.parts, other.parts, strict=False)])

    def __neg__(self) -> Series:
        return self._with_parts([-a for a in self.parts])

    def __mul__(self, other: Series) -> Series:
        order = min(self.order, other.order)
        left = [(i, a) for i, a in enumerate(self.parts[: order + 1]) if not a.is_zero()]
        right = [(i, b) for i, b in enumerate(other.parts[: order + 1]) if not b.is_zero()]
        parts = [self.ring.constant(0)] * (order + 1)
        for i, a in left:
            for j, b in right:
                if i + j > order:
                    break
                parts[i + j] = parts[i + j] + a * b
        return self._with_parts(parts)

    def __truediv__(self, other: Series) -> Series:
        return self * other.power(-1, 1)

    def multiple(self, factor: Number) -> Series:
        """Series times a number."""
        whole = factor if self.numbers.exact else int(factor)
        return self._with_parts([part * whole for part in self.parts])

    def truncation(self, order: int) -> Series:
        """Series truncated at a lower order."""
        return self._with_parts(self.parts[: order + 1])

    def derivative(self, variable: int) -> Series:
        """Partial derivative, known to one order less."""
        return self._with_parts([part.derivative(variable) for part in self.parts[1:]])

    def power(self, top: int, bottom: int) -> Series:
        """Power with exponent top/bottom.

        Raises
        ------
        ZeroDivisionError
            If the value is zero and the exponent is not a natural number.
        IrrationalError
            If the value has no such root.
        """
        if bottom == 1 and top >= 0:
            product, base = self._like(1), self
            while top:
                if top & 1:
                    product = product * base
                base, top = base * base, top >> 1
            return product
        value = self.value
        if value == 0:
            raise ZeroDivisionError
        root = value if bottom == 1 else self.numbers.root(value, bottom)
        parts = [self._like(root**top).parts[0]]
        # Euler's operator E multiplies part k by k.  For g = f^(top/bottom), bottom · f E(g) = top
        # · g E(f) gives bottom k f₀ g_k = Σ_i (top i − bottom (k − i)) f_i g_{k−i}.
        for k in range(1, self.order + 1):
            total = self.ring.constant(0)
            for i in range(1, k + 1):
                factor = top * i - bottom * (k - i)
                if factor and not self.parts[i].is_zero():
                    total = total + self.parts[i] * parts[k - i] * factor
            parts.append(self._quotient(total, value * bottom * k))
        return self._with_parts(parts)

    def _quotient(self, part: Polynomial, number: Number) -> Polynomial:
        inverse = 1 / number
        return part * (inverse if self.numbers.exact else int(inverse))

    def primitive(self, value: Number, slope: Series) -> Series:
        """Function of this series, from its value at the origin and its derivative."""
        parts = [self._like(value).parts[0]]
        # E(g) = g'(f) E(f), so k g_k = Σ i f_i slope_{k−i}.
        for k in range(1, self.order + 1):
            total = self.ring.constant(0)
            for i in range(1, k + 1):
                total = total + self.parts[i] * slope.parts[k - i] * i
            parts.append(self._quotient(total, self.numbers.number(k)))
        return self._with_parts(parts)

    def exponential(self, value: Number) -> Series:
        """Exponential, from its value at the origin."""
        series = self._like(value).truncation(0)
        # The exponential is its own derivative, so part k needs only earlier parts.
        for k in range(1, self.order + 1):
            slope = self._with_parts([*series.parts, self.ring.constant(0)])
            series = self.truncation(k).primitive(value, slope)
        return series

    def circle(self, sine: Number, cosine: Number) -> tuple[Series, Series]:
        """Sine and cosine, from their values at the origin."""
        zero = self.ring.constant(0)
        s, c = self._like(sine).truncation(0), self._like(cosine).truncation(0)
        for k in range(1, self.order + 1):
            here = self.truncation(k)
            turned = -self._with_parts([*s.parts, zero])
            s, c = (
                here.primitive(sine, self._with_parts([*c.parts, zero])),
                here.primitive(cosine, turned),
            )
        return s, c
