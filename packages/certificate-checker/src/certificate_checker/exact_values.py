"""Exact values at a point with algebraic and other coordinates.

Every root of a number and every other function value is a separate generator: a root satisfies its
equation, sines and cosines of arc tangents are rational, and those of quarter turns are numbers.
A value that is zero by these rules is zero at the point; the converse need not hold.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import chain

from flint import arb, fmpq

from .claim.errors import UndefinedError
from .claim.evaluate import exact_value
from .claim.formulas import CONSTANTS, Formula, call, number
from .claim.functions import HALF
from .claim.polynomials import Poly, Ring
from .claim.quotients import Quotient, quotient

#: Maximum number of roots and function values in the conditions at one point.
MOST = 40

#: Largest multiple of an angle whose sine is computed from that of the angle.
MULTIPLES = 24


#: Numerator and denominator of a circular function by position in the pair (sine, cosine).
_CIRCULAR: dict[str, tuple[int | None, int | None]] = {
    "sin": (0, None),
    "cos": (1, None),
    "tan": (0, 1),
    "cot": (1, 0),
    "sec": (None, 1),
    "csc": (None, 0),
}


class ExactValues:
    """Formulas at a point as quotients of polynomials in its coordinates and in function values.

    Parameters
    ----------
    symbols : sequence of str
    rationals : mapping of name to number
        Rational coordinates.
    algebraic : sequence of (name, Poly)
        Coordinates that are roots of polynomials in earlier ones, with these polynomials over
        `symbols`.
    formulas : mapping of name to formula
        Definitions, and coordinates given by formulas.
    value : callable
        Ball of a formula.
    balls : mapping of str to ball
        Balls of all coordinates.
    zeros : sequence of formulas
        Values of unspecified functions that are zero at the point.
    """

    def __init__(
        self,
        symbols: Sequence[str],
        rationals: Mapping[str, Fraction],
        algebraic: Sequence[tuple[str, Mapping[tuple[int, ...], fmpq]]],
        formulas: Mapping[str, Formula],
        value: Callable[[Formula], arb],
        balls: Mapping[str, arb],
        zeros: Sequence[Formula],
    ) -> None:
        self._symbols = tuple(symbols)
        self.ring = Ring([*symbols, *(f"#{i}" for i in range(MOST))])
        self._rationals, self._value, self._zeros = rationals, value, zeros
        self._formulas = {**formulas, **{w: number(v) for w, v in rationals.items()}}
        self._balls: dict[str, arb] = dict(balls)
        self._values: list[tuple[str, object, tuple[Quotient, ...], Quotient]] = []
        #: Generators with the polynomials of which they are roots, in order.
        self._chain: list[tuple[str, Poly]] = []
        for word, terms in algebraic:
            self._chain.append((word, self._polynomial(terms)))
        self._algebraic = {word for word, _ in algebraic}
        self._count = 0

    def _polynomial(self, terms: Mapping[tuple[int, ...], fmpq]) -> Poly:
        """Polynomial over the symbols, with the rational coordinates inserted."""
        spread = {(*exponents, *[0] * MOST): c for exponents, c in terms.items()}
        poly = self.ring.context.from_dict(spread)
        for word, value in self._rationals.items():
            images = [self.ring.generator(n) for n in self.ring.names]
            images[self.ring.index[word]] = self.ring.constant(value)
            if poly.degrees()[self.ring.index[word]] > 0:
                poly = poly.compose(*images)
        return poly

    def vanishes(self, formula: Formula) -> bool:
        """True if the rules imply that a formula is zero at the point.

        Raises
        ------
        UndefinedError
            If the formula has no value there.
        """
        above, below = self._quotient(formula)
        if not self._ball(below) != 0:
            raise UndefinedError("a formula has no certain value at the point")
        return self._is_zero(above)

    def _quotient(self, formula: Formula) -> Quotient:
        return quotient(
            formula, self.ring, self._symbol_value, self._formulas, self._function_value
        )

    def _symbol_value(self, word: str) -> Quotient | None:
        one = self.ring.constant(1)
        if word in self._rationals:
            return self.ring.constant(self._rationals[word]), one
        if word in self._algebraic:
            return self.ring.generator(word), one
        return self._new("constant", word, (), number(0)) if word in CONSTANTS else None

    # --- roots and functions ---------------------------------------------------------------------

    def _function_value(self, node: Formula, value_of: Callable[[Formula], Quotient]) -> Quotient:
        one = self.ring.constant(1)
        if node.kind == "power":
            exponent = exact_value(node.parts[1], self._formulas)
            if exponent is None or exponent.denominator == 1:
                raise UndefinedError("the exponent is not a number")
            return self._root(value_of(node.parts[0]), exponent)
        if node.kind == "function":
            arguments = tuple(map(value_of, node.parts))
            for zero in self._zeros:
                # Functions that vanish by a condition have the value zero instead of a generator.
                theirs = [self._quotient(part) for part in zero.parts]
                if zero.word == node.word and all(map(self._same, arguments, theirs)):
                    return self.ring.constant(0), one
            return self._new("function", node.word, arguments, node)
        word = node.word
        if word == "sqrt":
            return self._root(value_of(node.parts[0]), HALF)
        if word in _CIRCULAR:
            return self._ratio(_CIRCULAR[word], self._circle(node.parts[0], value_of))
        if word in ("sinh", "cosh", "tanh"):
            return self._ratio(_CIRCULAR[word[:-1]], self._hyperbola(node.parts[0], value_of))
        arguments = tuple(map(value_of, node.parts))
        if word in ("Abs", "sign"):
            ball = self._value(node.parts[0])
            if not ball != 0:
                raise UndefinedError("an absolute value at zero")
            side = self.ring.constant(1 if ball > 0 else -1)
            above, below = arguments[0] if word == "Abs" else (one, one)
            return side * above, below
        if word == "exp":
            return self._exponential(node.parts[0], value_of)
        if word == "Rate":
            raise UndefinedError("a rate is no value at a point")
        return self._new(word, None, arguments, node)

    def _new(
        self, word: str, more: object, arguments: tuple[Quotient, ...], node: Formula
    ) -> Quotient:
        """Generator for a function value, the same for equal arguments."""
        for function, other, theirs, value in self._values:
            if (function, other) == (word, more) and all(map(self._same, arguments, theirs)):
                return value
        value = self._generator(node if word != "constant" else None)
        self._values.append((word, more, arguments, value))
        return value

    def _generator(self, node: Formula | None) -> Quotient:
        if self._count == MOST:
            raise UndefinedError("there are too many functions at the point")
        name = f"#{self._count}"
        self._count += 1
        self._balls[name] = arb.pi() if node is None else self._value(node)
        return self.ring.generator(name), self.ring.constant(1)

    def _root(self, of: Quotient, exponent: Fraction) -> Quotient:
        degree = exponent.denominator
        key = "root", degree
        found = [
            value
            for word, other, theirs, value in self._values
            if (word, other) == key and self._same(of, theirs[0])
        ]
        if found:
            value = found[0]
        else:
            value = self._generator(None)
            name = f"#{self._count - 1}"
            self._balls[name] = (self._ball(of[0]) / self._ball(of[1])).root(degree)
            self._chain.append((name, value[0] ** degree * of[1] - of[0]))
            self._values.append((*key, (of,), value))
        power = value[0] ** abs(exponent.numerator)
        one = self.ring.constant(1)
        return (power, one) if exponent > 0 else (one, power)

    def _ratio(
        self, places: tuple[int | None, int | None], pair: tuple[Quotient, Quotient]
    ) -> Quotient:
        """Quotient of the members of a pair, where None stands for 1."""
        one = self.ring.constant(1)
        above, below = ((one, one) if place is None else pair[place] for place in places)
        if self._is_zero(below[0]):
            raise UndefinedError("a division by zero")
        return above[0] * below[1], above[1] * below[0]

    def _hyperbola(
        self, exponent: Formula, value_of: Callable[[Formula], Quotient]
    ) -> tuple[Quotient, Quotient]:
        """Hyperbolic sine and cosine, as quotients."""
        above, below = self._exponential(exponent, value_of)
        double = 2 * above * below
        return (above**2 - below**2, double), (above**2 + below**2, double)

    def _exponential(self, exponent: Formula, value_of: Callable[[Formula], Quotient]) -> Quotient:
        """Exponential of a sum of multiples of logarithms and of earlier exponents."""
        exponent = self._without_names(exponent)
        one = self.ring.constant(1)
        if exponent.kind == "sum":
            result: Quotient = (one, one)
            for part in exponent.parts:
                result = _product(result, self._exponential(part, value_of))
            return result
        argument = value_of(exponent)
        if self._is_zero(argument[0]):
            return one, one
        for function, _, inner, own in list(self._values):
            if function in ("log", "exp"):
                base, power = (inner[0], own) if function == "log" else (own, inner[0])
                times = self._multiple(argument, power, Fraction(1))
                if times is not None:
                    above, below = base if times > 0 else (base[1], base[0])
                    return above ** abs(times), below ** abs(times)
        return self._new("exp", None, (argument,), call("exp", [exponent]))

    def _without_names(self, formula: Formula) -> Formula:
        """Formula of a name by its definition; any other formula unchanged."""
        while formula.kind == "name" and formula.word in self._formulas:
            formula = self._formulas[formula.word]
        return formula

    def _circle(
        self, angle: Formula, value_of: Callable[[Formula], Quotient]
    ) -> tuple[Quotient, Quotient]:
        """Sine and cosine from addition theorems, arc tangents and quarter turns."""
        angle = self._without_names(angle)
        zero, one = self.ring.constant(0), self.ring.constant(1)
        if angle.kind == "sum":
            sine: Quotient = (zero, one)
            cosine: Quotient = (one, one)
            for part in angle.parts:
                sine, cosine = _sum_of_angles(sine, cosine, *self._circle(part, value_of))
            return sine, cosine
        argument = value_of(angle)
        if self._is_zero(argument[0]):
            return (zero, one), (one, one)
        for word, _, inner, value in list(self._values):
            if word == "constant":
                pieces, share = ((one, one), (zero, one)), HALF
            elif word in ("atan2", "asin", "acos", "atan"):
                pieces, share = self._of_inverse(word, inner), Fraction(1)
            else:
                continue
            times = self._multiple(argument, value, share)
            if times:
                return _multiple_angle(pieces[0], pieces[1], times, (zero, one), (one, one))
        sine = self._new("sin", None, (argument,), call("sin", [angle]))
        cosine = self._new("cos", None, (argument,), call("cos", [angle]))
        return sine, cosine

    def _of_inverse(self, word: str, inner: tuple[Quotient, ...]) -> tuple[Quotient, Quotient]:
        """Sine and cosine of an inverse function."""
        one: Quotient = (self.ring.constant(1), self.ring.constant(1))
        u = inner[0]
        square = _product(u, u)
        if word in ("asin", "acos"):
            other = self._root(_sum(one, (-square[0], square[1])), HALF)
            return (u, other) if word == "asin" else (other, u)
        x = inner[1] if word == "atan2" else one
        whole = _sum(square, _product(x, x))
        below = one if self._same(whole, one) else self._root(whole, -HALF)
        return _product(u, below), _product(x, below)

    def _multiple(self, argument: Quotient, value: Quotient, share: Fraction) -> int | None:
        for times in chain.from_iterable((n, -n) for n in range(1, MULTIPLES + 1)):
            factor = self.ring.constant(times * share)
            if self._same(argument, (factor * value[0], value[1])):
                return times
        return None

    # --- equality ------------------------------------------------------------------------------

    def _same(self, first: Quotient, second: Quotient) -> bool:
        return self._is_zero(first[0] * second[1] - second[0] * first[1])

    def _is_zero(self, poly: Poly) -> bool:
        # Pseudo-division from the last generator to the first; the leading coefficients are
        # nonzero at the point, so a remainder of zero means that the polynomial is zero there.
        for word, own in reversed(self._chain):
            poly = self._remainder(poly, own, word)
        return bool(poly.is_zero())

    def _ball(self, poly: Poly) -> arb:
        total = arb(0)
        for exponents, coefficient in poly.to_dict().items():
            term = arb(coefficient)
            for name, exponent in zip(self.ring.names, exponents, strict=True):
                if exponent:
                    term = term * self._balls[name] ** int(exponent)
            total = total + term
        return total

    def _remainder(self, poly: Poly, divisor: Poly, word: str) -> Poly:
        """Remainder of a division in one variable, times powers of the leading coefficient."""
        position = self.ring.index[word]
        degree = _degree(divisor, position)
        lead = _coefficient(self.ring, divisor, position, degree)
        if degree < 1 or not self._ball(lead) != 0:
            raise UndefinedError(f"the polynomial with the root {word} has no certain degree")
        variable = self.ring.generator(word)
        while not poly.is_zero() and (height := _degree(poly, position)) >= degree:
            top = _coefficient(self.ring, poly, position, height)
            poly = lead * poly - top * variable ** (height - degree) * divisor
        return poly


def _product(first: Quotient, second: Quotient) -> Quotient:
    return first[0] * second[0], first[1] * second[1]


def _sum(first: Quotient, second: Quotient) -> Quotient:
    return first[0] * second[1] + second[0] * first[1], first[1] * second[1]


def _sum_of_angles(
    sine: Quotient, cosine: Quotient, s: Quotient, c: Quotient
) -> tuple[Quotient, Quotient]:
    minus = (-s[0], s[1])
    return (
        _sum(_product(sine, c), _product(cosine, s)),
        _sum(_product(cosine, c), _product(sine, minus)),
    )


def _multiple_angle(
    s: Quotient, c: Quotient, times: int, sine: Quotient, cosine: Quotient
) -> tuple[Quotient, Quotient]:
    turn = s if times > 0 else (-s[0], s[1])
    for _ in range(abs(times)):
        sine, cosine = _sum_of_angles(sine, cosine, turn, c)
    return sine, cosine


def _degree(poly: Poly, position: int) -> int:
    return int(poly.degrees()[position]) if not poly.is_zero() else -1


def _coefficient(ring: Ring, poly: Poly, position: int, degree: int) -> Poly:
    terms = {}
    for exponents, coefficient in poly.to_dict().items():
        if exponents[position] == degree:
            lower = list(map(int, exponents))
            lower[position] = 0
            terms[tuple(lower)] = coefficient
    return ring.context.from_dict(terms)
