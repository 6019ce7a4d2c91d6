"""Polynomials of a certificate: reading, comparison, evaluation.

A polynomial is a list of terms ``[coefficient, [generator, exponent, …]]``; a fraction has a
polynomial as numerator and a list of ``[polynomial, power]`` as denominator.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TypeAlias

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from .errors import CheckError
from .functions import Functions
from .jets import Number, inverse
from .json_data import as_list, field, integer, items, mapping, only, rational

Poly: TypeAlias = fmpq_mpoly
#: A product of powers of polynomials.
Powers: TypeAlias = list[tuple[Poly, int]]

#: Limits on generators of a ring, exponents in a polynomial, and powers of factors.
GENERATORS = 2_000
HIGHEST = 100_000
#: Limit on the number of terms of an expanded power of a polynomial.
TERMS = 20_000_000


class Ring:
    """Polynomials with rational coefficients in named generators."""

    def __init__(self, names: Sequence[str]) -> None:
        if len(names) > GENERATORS:
            raise CheckError(f"a ring has more than {GENERATORS} generators")
        self.names = tuple(names)
        # FLINT requires at least one generator.
        self.context = fmpq_mpoly_ctx.get(self.names or ("_",), Ordering.degrevlex)
        self.index = {name: i for i, name in enumerate(self.names)}

    def generator(self, name: str) -> Poly:
        """Generator as a polynomial."""
        return self.context.gens()[self.index[name]]

    def constant(self, value: Fraction | int) -> Poly:
        """Number as a polynomial."""
        value = Fraction(value)
        return self.context.constant(fmpq(value.numerator, value.denominator))

    def read(self, data: object, what: str) -> Poly:
        """Polynomial from its list of terms."""
        terms: dict[tuple[int, ...], fmpq] = {}
        size = len(self.names)
        for term in as_list(data, what):
            coefficient, powers = items(term, 2, f"a term of {what}")
            number = rational(coefficient, f"a coefficient of {what}")
            powers = as_list(powers, f"a term of {what}")
            if not number or len(powers) % 2:
                raise CheckError(f"a term of {what} is zero or lacks an exponent")
            exponents = [0] * max(size, 1)
            for at in range(0, len(powers), 2):
                i = integer(powers[at], f"a generator in {what}", 0, size - 1)
                if exponents[i]:
                    raise CheckError(f"a term of {what} has a generator twice")
                exponents[i] = integer(powers[at + 1], f"an exponent in {what}", 1, HIGHEST)
            key = tuple(exponents)
            if key in terms:
                raise CheckError(f"{what} has a term twice")
            terms[key] = fmpq(number.numerator, number.denominator)
        return self.context.from_dict(terms)

    def powers(self, data: object, what: str, negative: bool = False) -> Powers:
        """List of nonzero polynomials with their powers."""
        powers = []
        for pair in as_list(data, what):
            poly, power = items(pair, 2, what)
            factor = self.read(poly, what)
            if factor.is_zero():
                raise CheckError(f"a factor of {what} is zero")
            lowest = -HIGHEST if negative else 1
            number = integer(power, f"a power of {what}", lowest, HIGHEST)
            if not number:
                raise CheckError(f"a power of {what} is zero")
            powers.append((factor, number))
        return powers

    def fraction(self, data: object, what: str) -> tuple[Poly, Powers]:
        """Numerator of a fraction and factors of its denominator."""
        data = mapping(data, what)
        only(data, what, "numerator", "denominator", "what")
        above = self.read(field(data, "numerator", what), f"the numerator of {what}")
        below = self.powers(field(data, "denominator", what), f"the denominator of {what}")
        return above, below

    def expanded_product(self, powers: Powers) -> Poly:
        """Expanded product of powers."""
        result = self.constant(1)
        for poly, power in powers:
            if len(poly) > 1 and len(poly) ** power * len(result) > TERMS:
                raise CheckError("a product of factors would be too large")
            result = result * poly**power
        return result

    def value(self, poly: Poly, values: Sequence[Number], functions: Functions) -> Number:
        """Value of a polynomial at numbers, one for each generator."""
        return self.values(poly, [(values, functions)])[0]

    def values(
        self, poly: Poly, points: Sequence[tuple[Sequence[Number], Functions]]
    ) -> list[Number]:
        """Values of a polynomial at several points."""
        terms = [
            (coefficient, [(i, int(n)) for i, n in enumerate(exponents) if n])
            for exponents, coefficient in poly.to_dict().items()
        ]
        # With a common denominator all coefficients are integers, which are cheap to multiply
        # with.
        below = math.lcm(1, *{int(coefficient.q) for coefficient, _ in terms})
        whole = [(int(c.p) * (below // int(c.q)), powers) for c, powers in terms]
        return [_value(whole, below, values, functions) for values, functions in points]

    def value_of_powers(
        self, powers: Powers, values: Sequence[Number], functions: Functions
    ) -> Number:
        """Value of a product of powers."""
        result = functions.number(Fraction(1))
        for poly, power in powers:
            base = self.value(poly, values, functions)
            result = result * (base**power if power > 0 else inverse(base) ** -power)
        return result


def _value(
    terms: Sequence[tuple[int, list[tuple[int, int]]]],
    below: int,
    values: Sequence[Number],
    functions: Functions,
) -> Number:
    """Sum of coefficient · ∏ valueᵢ^power over the terms, divided by a number."""
    known: dict[tuple[int, int], Number] = {}
    one = functions.number(Fraction(1))
    total = functions.number(Fraction(0))
    for number, powers in terms:
        term = one
        for key in powers:
            if key not in known:
                known[key] = values[key[0]] ** key[1]
            term = term * known[key]
        total = total + number * term
    return total if below == 1 else total / functions.number(Fraction(below))


def monic(poly: Poly) -> tuple[str, int]:
    """Key that a polynomial shares with its multiples, and the sign of its leading coefficient."""
    lead = poly.leading_coefficient()
    return str(poly / lead), 1 if lead > 0 else -1
