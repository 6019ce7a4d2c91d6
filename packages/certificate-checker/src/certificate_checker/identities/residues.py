r"""Formulas evaluated modulo a prime, with generators of a proof for roots and functions.

Let x be the symbols of a claim and all free values: values of functions, symbolic powers, and one
parameter t for every sine and cosine, (2t, 1 − t²)/(1 + t²).  The roots of a proof generate the
algebra A = ℚ(x)[r₁, …, r_k]/(rᵢ^nᵢ − uᵢ), a free module over ℚ(x) with the monomials r^e, e < n,
as its basis.  Every formula of the claim has a value in A by these rules:

- √U = ∏ |f|^p/2 where U = ∏ f^p is an identity in A, with |f|^1/2 a root of the proof whose
  radicand is ±f, and |f| = ±f only where the sign of f is known; so for other exponents, (f²)^a is
  |f|^2a;
- two values of a function are the same symbol where their arguments are equal in A; sine and
  cosine of a sum of whole multiples of angles follow from those of the angles, exponentials alike;
- derivatives follow the rules of :mod:`certificate_checker.claim.functions`.

All of them are valid for real numbers wherever the law is defined, whatever other relations exist
between these functions; so an identity in A is an identity of real functions.  It is tested at one
random x modulo one random prime p ≡ 1 modulo the degrees, such that all uᵢ have roots there: then
A becomes a product of fields 𝔽_p, one for each choice of the roots, and two elements are equal
only if they are equal for all choices.  Where A is a field, one choice suffices.  The error
probability of this test is bounded in :mod:`.error_bound`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from flint import fmpz, fmpz_mod

from ..claim.errors import CheckError
from ..claim.functions import HALF
from ..claim.jets import Number, inverse
from ..claim.polynomials import Poly, Powers, Ring, monic
from ..modular.prime_field import PrimeField
from ..modular.small_relations import relation
from .case_tree import Signs
from .generator_functions import Auxiliary, GeneratorFunctions

#: A product of powers with a positive coefficient.
Product = tuple[Fraction, Powers]


class UnknownRootError(CheckError):
    """Raised if a root or a power of the law cannot be expressed by the generators of a proof."""


class Residues(GeneratorFunctions):
    """Functions at a random point modulo a prime, for one choice of the roots.

    Parameters
    ----------
    field : PrimeField
    ring : Ring
        Ring of the proof.
    draw : str
        Name of the point; the same name gives the same point.
    choice : sequence of int
        Index of the chosen value of each root, in their order.
    """

    def __init__(self, field: PrimeField, ring: Ring, draw: str, choice: Sequence[int]) -> None:
        self.field, self.ring = field, ring
        #: Values of the generators.
        self.values: list[fmpz_mod] = [field.number(Fraction(0))] * len(ring.names)
        #: Known signs of polynomials, replaced by those of the proof when they are known.
        self.signs = Signs()
        #: Products of powers, by their values.
        self.products: dict[fmpz_mod, list[Product]] = {}
        #: Symbols that are logarithms of numbers.
        self.logarithms_of_numbers: list[Auxiliary] = []
        #: True for radicands that are squares, if no roots of them are needed.
        self.characters: list[bool] | None = None
        self._draw, self._choice = draw, iter(choice)
        self._symbols: dict[tuple[object, ...], fmpz_mod] = {}
        self._angles: list[tuple[fmpz_mod, fmpz_mod, fmpz_mod]] = []
        self._exponentials: list[tuple[fmpz_mod, fmpz_mod]] = []
        self._formal: list[tuple[fmpz_mod, int, fmpz_mod]] = []
        self._roots: list[tuple[Auxiliary, fmpz_mod]] = []
        self._powers: list[tuple[Auxiliary, fmpz_mod, Callable[[], Number], fmpz_mod]] = []

    # --- numbers and generators -----------------------------------------------------------------

    def number(self, value: Fraction) -> Number:
        """Rational number as a residue; UndefinedError if the prime divides its denominator."""
        return self.field.number(value)

    def free(self, word: str) -> Number:
        """Random value."""
        return self.field.random(f"{self._draw} {word}")

    def constant(self, word: str) -> Number:
        """Random value that represents the number π."""
        return self._fixed((word,))

    def is_nonzero(self, a: Number) -> bool:
        """True if a residue is nonzero."""
        return bool(a != 0)

    def settle(
        self, word: str, orders: Sequence[int], arguments: Sequence[Number], value: Number
    ) -> None:
        """Set a value of an unspecified function that is determined by others."""
        self._symbols["unspecified", word, tuple(orders), tuple(arguments)] = value

    def new_root(self, symbol: Auxiliary, radicand: Number, whole: Number) -> Number:
        """Root of an element that is a power; otherwise UndefinedError."""
        if self.characters is not None:
            self.characters.append(self.field.is_square(radicand))
            return self.free(f"root {symbol.name}")
        root = self.field.root(radicand, symbol.number, next(self._choice))
        if symbol.kind == "formal root":
            self._formal.append((radicand * whole**symbol.number, symbol.number, root * whole))
        else:
            self._roots.append((symbol, root))
        return root

    def new_power(self, symbol: Auxiliary, base: Number, exponent: Callable[[], Number]) -> Number:
        """Random value that represents a symbolic power."""
        value = self.free(f"power {symbol.name}")
        self._powers.append((symbol, base, exponent, value))
        return value

    def _fixed(self, key: tuple[object, ...]) -> Number:
        """Random value, the same for the same key."""
        if key not in self._symbols:
            self._symbols[key] = self.free(f"value {len(self._symbols)}")
        return self._symbols[key]

    # --- functions ------------------------------------------------------------------------------

    def plain_unspecified(
        self, word: str, orders: tuple[int, ...], arguments: tuple[Number, ...]
    ) -> Number:
        """Value of a derivative of an unspecified function."""
        return self._fixed(("unspecified", word, orders, arguments))

    def plain_value(self, word: str, arguments: tuple[Number, ...]) -> Number:
        """Value of a known function."""
        a = arguments[0]
        if word in ("sin", "cos"):
            return self._circle(a)[word == "cos"]
        if word == "exp":
            return self._exponential(a)
        if word == "log":
            return self._logarithm(a)
        if word == "acos":
            # asin a + acos a = π/2, so both share one symbol.
            return self.constant("pi") / 2 - self._fixed(("asin", arguments))
        if word in ("sinh", "cosh"):
            value = self._exponential(a)
            other = inverse(value)
            return (value - other if word == "sinh" else value + other) / 2
        if word == "Abs":
            return self.plain_root(a * a, HALF)
        if word == "sign":
            return self.plain_root(a * a, HALF) * inverse(a)
        return self._fixed((word, arguments))

    def _circle(self, angle: Number) -> tuple[Number, Number]:
        """Sine and cosine of an angle: of a sum of multiples of known angles, or new ones."""
        zero, one = self.number(Fraction(0)), self.number(Fraction(1))
        angles = [*self._angles, (self.constant("pi") / 2, one, zero)]
        multiples = relation(angle, [a for a, _, _ in angles], self.field.modulus)
        if multiples is None:
            # A rational point of the circle satisfies s² + c² = 1 without an equation.
            t = self.free(f"angle {len(self._angles)}")
            below = inverse(1 + t * t)
            self._angles.append((angle, 2 * t * below, (1 - t * t) * below))
            return self._angles[-1][1:]
        sine, cosine = zero, one
        for number, (_, s, c) in zip(multiples, angles, strict=True):
            for _ in range(abs(number)):
                turn = s if number > 0 else -s
                sine, cosine = sine * c + cosine * turn, cosine * c - sine * turn
        return sine, cosine

    def _exponential(self, a: Number) -> Number:
        known = [*self._exponentials, *self._roots_of_exponentials()]
        multiples = relation(a, [b for b, _ in known], self.field.modulus)
        if multiples is None:
            self._exponentials.append((a, self.free(f"exp {len(self._exponentials)}")))
            return self._exponentials[-1][1]
        result = self.number(Fraction(1))
        for number, (_, value) in zip(multiples, known, strict=True):
            result = result * value**number
        return result

    def _roots_of_exponentials(self) -> Iterator[tuple[Number, Number]]:
        for symbol, root in self._roots:
            radicand = self._value(symbol.of[0][0])
            for a, value in self._exponentials:
                if value == radicand:
                    yield a / symbol.number, root

    def _logarithm(self, a: Number) -> Number:
        """log ∏ f^p = Σ p log |f|, from the logarithms of the proof, or a new symbol."""
        key = "log", (a,)
        for content, powers in () if a == 1 or key in self._symbols else self.products.get(a, ()):
            try:
                result = self._logarithm_of_factor(self.ring.constant(content))
                for poly, power in powers:
                    result = result + power * self._logarithm_of_factor(poly)
            except UnknownRootError:
                continue
            return result
        return self.number(Fraction(0)) if a == 1 else self._fixed(key)

    def _logarithm_of_factor(self, poly: Poly) -> Number:
        """log |f|, where ±f is the argument of a logarithm, an exponential or a root."""
        value = self._value(poly)
        if value in (1, -1):
            return self.number(Fraction(0))
        for argument in (value, -value):
            if ("log", (argument,)) in self._symbols:
                return self._symbols["log", (argument,)]
        for exponent, known in self._exponentials:
            if known == value:
                return exponent
        for symbol, root in self._roots:
            if root == value:
                return self._logarithm_of_factor(symbol.of[0][0]) / symbol.number
        if poly.is_constant():
            return self._logarithm_of_number(abs(_constant(poly)))
        raise UnknownRootError("a logarithm of the law is none of the proof")

    def _logarithm_of_number(self, number: Fraction) -> Number:
        result = self.number(Fraction(0))
        for auxiliary in self.logarithms_of_numbers:
            base = _constant(auxiliary.of[0][0])
            if times := _valuation(number, base):
                result = result + times * self._symbols["log", (self.number(base),)]
                number /= base**times
        if number != 1:
            raise UnknownRootError("a logarithm of a number is none of the proof")
        return result

    # --- roots and powers -----------------------------------------------------------------------

    def _value(self, poly: Poly) -> Number:
        return self.ring.value(poly, self.values, self)

    def plain_root(self, a: Number, exponent: Fraction) -> Number:
        """Power of a positive number, from the roots of the proof."""
        for radicand, degree, root in self._formal:
            if radicand == a and degree % exponent.denominator == 0:
                return root ** int(degree * exponent)
        for content, powers in self.products.get(a, ()):
            try:
                result = self._constant_power(content, exponent)
                for poly, power in powers:
                    result = result * self._factor_power(poly, power * exponent)
            except UnknownRootError:
                continue
            return result
        raise UnknownRootError("a root of the law is none of factors with known signs and roots")

    def _factor_power(self, poly: Poly, exponent: Fraction) -> Number:
        """|f|^exponent as a residue."""
        if poly.is_constant():
            return self._constant_power(_constant(poly), exponent)
        if exponent.denominator == 1:
            value = self._value(poly) ** int(exponent)
            if exponent % 2 == 0:
                return value
            sign = self.signs.of(poly)
            if not sign:
                raise UnknownRootError("the sign of a factor under a root is not known")
            return value * sign
        for symbol, root in self._roots:
            if symbol.number % exponent.denominator == 0:
                ratio = _ratio(symbol.of[0][0], poly)
                if ratio is not None:
                    power = root ** int(symbol.number * exponent)
                    return power * self._constant_power(1 / abs(ratio), exponent)
        for symbol, _ in self._roots:
            if poly == self.ring.generator(symbol.name):
                return self._factor_power(symbol.of[0][0], exponent / symbol.number)
        raise UnknownRootError("a root of the law is none of the proof")

    def _constant_power(self, value: Fraction, exponent: Fraction) -> Number:
        """|number|^exponent, from roots of numbers if it is irrational."""
        value = abs(value)
        result = self.number(Fraction(1))
        for symbol, root in self._roots:
            base = symbol.of[0][0]
            if base.is_constant() and (times := _valuation(value, _constant(base))):
                power = symbol.number * exponent * times
                if power.denominator == 1:
                    result = result * root ** int(power)
                    value /= _constant(base) ** times
        whole = value**exponent.numerator
        above, below = (
            _whole_root(n, exponent.denominator) for n in (whole.numerator, whole.denominator)
        )
        if above is None or below is None:
            raise UnknownRootError("a root of a number is none of the proof")
        return result * self.number(Fraction(above, below))

    def plain_power(self, a: Number, exponent: Number) -> Number:
        """Power of a positive number with a symbolic exponent."""
        for symbol, base, _, _ in self._powers:
            if base == a:
                return self._symbolic_power(symbol.of[0][0], exponent)
        for content, powers in self.products.get(a, ()):
            try:
                if self._sign(content, powers) <= 0:
                    continue
                result = self._symbolic_power(self.ring.constant(content), exponent)
                for poly, power in powers:
                    result = result * self._symbolic_power(poly, exponent * power)
            except UnknownRootError:
                continue
            return result
        raise UnknownRootError("a power of the law is none of factors with known signs")

    def _sign(self, content: Fraction, powers: Powers) -> int:
        """Sign of a product; factors may be ±those under a root or a power of the proof."""
        sign = 1 if content > 0 else -1
        for poly, power in powers:
            sign *= self._sign_of_factor(poly) ** (power % 2)
        return sign

    def _sign_of_factor(self, poly: Poly) -> int:
        for symbol in (*(s for s, *_ in self._powers), *(s for s, _ in self._roots)):
            ratio = _ratio(symbol.of[0][0], poly)
            if ratio is not None:
                return 1 if ratio > 0 else -1
        return self.signs.of(poly)

    def _symbolic_power(self, poly: Poly, exponent: Number) -> Number:
        """|f|^exponent as a product of powers of |f| that occur in the proof."""
        if poly.is_constant():
            return self._symbolic_power_of_number(abs(_constant(poly)), exponent)
        return self._from_basis(poly, exponent)

    def _symbolic_power_of_number(self, number: Fraction, exponent: Number) -> Number:
        result = self.number(Fraction(1))
        for symbol, *_ in self._powers:
            base = symbol.of[0][0]
            if base.is_constant() and (times := _valuation(number, _constant(base))):
                result = result * self._from_basis(base, exponent * times)
                number /= _constant(base) ** times
        if number != 1:
            raise UnknownRootError("a symbolic power of a number is none of the proof")
        return result

    def _from_basis(self, poly: Poly, exponent: Number) -> Number:
        # The powers |f|^e of the proof, including |f| itself; `exponent` must be an integer
        # combination of their exponents.
        basis = []
        for symbol, base, raised, value in self._powers:
            if _ratio(symbol.of[0][0], poly) in (1, -1):
                basis += [(raised() / symbol.number, value), (self.number(Fraction(1)), base)]
        for symbol, root in self._roots:
            if _ratio(symbol.of[0][0], poly) in (1, -1):
                basis.append((self.number(Fraction(1, symbol.number)), root))
            if poly == self.ring.generator(symbol.name):
                return self._symbolic_power(symbol.of[0][0], exponent / symbol.number)
        if not basis and self.signs.of(poly):
            basis = [(self.number(Fraction(1)), self._factor_power(poly, Fraction(1)))]
        numbers = relation(exponent, [share for share, _ in basis], self.field.modulus)
        if numbers is None:
            raise UnknownRootError("a symbolic power of the law is none of the proof")
        result = self.number(Fraction(1))
        for number, (_, value) in zip(numbers, basis, strict=True):
            result = result * (value**number if number >= 0 else inverse(value) ** -number)
        return result


def _constant(poly: Poly) -> Fraction:
    if poly.is_zero():
        return Fraction(0)
    number = poly.leading_coefficient()
    return Fraction(int(number.p), int(number.q))


def _ratio(first: Poly, second: Poly) -> Fraction | None:
    """Constant ratio of two polynomials, or None."""
    if first.is_zero() or second.is_zero() or monic(first)[0] != monic(second)[0]:
        return None
    ratio = first.leading_coefficient() / second.leading_coefficient()
    return Fraction(int(ratio.p), int(ratio.q))


def _valuation(value: Fraction, base: Fraction) -> int:
    """Multiplicity of an integer greater than one as a divisor."""
    if base.denominator != 1 or base <= 1 or not value:
        return 0
    times = 0
    above, below, q = value.numerator, value.denominator, base.numerator
    while above % q == 0:
        above, times = above // q, times + 1
    while below % q == 0:
        below, times = below // q, times - 1
    return times


def _whole_root(value: int, degree: int) -> int | None:
    root = int(fmpz(value).root(degree))
    return root if root**degree == value else None
