"""Formulas evaluated at many points at once in the integers modulo a large prime.

A `Jet` contains the values of a formula at N points and its derivatives there. Arithmetic modulo a
prime below 2³¹ is exact and fits into 64-bit integers, so that NumPy processes all points at once.
An equation that holds at random points of such a large field holds identically, except with a
probability of about one in a million (Schwartz–Zippel lemma).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.evaluation import Evaluation
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.named_formulas import expand, scalars
from flowlanes.system.vectors import Dot

PRIMES = (2_147_483_647, 2_147_483_587, 2_147_483_579, 2_147_483_563)
"""Moduli congruent to 3 modulo 4, for which square roots are powers."""

_MODULUS = ContextVar("modulus", default=PRIMES[0])
_SIMPLE = 1000
"""Maximum number of operations of an argument of a logarithm that is factored."""
_WILD = 1_234_567  # coprime to the order of the multiplicative group

Integers: TypeAlias = npt.NDArray[np.int64]
Truths: TypeAlias = npt.NDArray[np.bool_]


def prime() -> int:
    """The current modulus."""
    return _MODULUS.get()


@contextmanager
def modulo(number: int) -> Iterator[None]:
    """Use another prime within a context."""
    token = _MODULUS.set(number)
    try:
        yield
    finally:
        _MODULUS.reset(token)


def power(base: Integers, exponent: int) -> Integers:
    """base^exponent modulo the prime, for an exponent ≥ 0, elementwise."""
    result = np.ones_like(base)
    while exponent:
        if exponent & 1:
            result = result * base % prime()
        base = base * base % prime()
        exponent >>= 1
    return result


def inverse(values: Integers) -> Integers:
    """The reciprocals modulo the prime; 0 is mapped to 0."""
    # Fermat: a^(p−1) = 1, so that a^(p−2) is the inverse of a ≠ 0.
    return power(values, prime() - 2)


def square_root(values: Integers) -> tuple[Integers, Truths]:
    """A square root modulo the prime, and a mask where it exists."""
    # For p ≡ 3 (mod 4), a^((p+1)/4) is a square root of every square a.
    root = power(values, (prime() + 1) // 4)
    return root, root * root % prime() == values


@dataclass(frozen=True)
class Jet:
    """Values at N points and derivatives in D directions, all reduced modulo the prime.

    Attributes
    ----------
    value : array of int64, shape (N,)
    slope : array of int64, shape (D, N)
    """

    value: Integers
    slope: Integers

    def __add__(self, other: Jet) -> Jet:
        return Jet((self.value + other.value) % prime(), (self.slope + other.slope) % prime())

    def __sub__(self, other: Jet) -> Jet:
        return Jet((self.value - other.value) % prime(), (self.slope - other.slope) % prime())

    def __mul__(self, other: Jet) -> Jet:
        slope = (self.slope * other.value % prime() + other.slope * self.value) % prime()
        return Jet(self.value * other.value % prime(), slope)

    def compose(self, value: Integers, derivative: Integers) -> Jet:
        """f(self), given f and f′ at the values."""
        return Jet(value, self.slope * derivative % prime())

    def along(self, direction: Iterable[Integers]) -> Integers:
        """The derivative in a direction with the given components, shape (N,)."""
        total = np.zeros_like(self.value)
        for part, component in zip(self.slope, direction, strict=True):
            total = (total + part * component) % prime()
        return total


def _factors(formula: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """Prime factors with exponents, ignoring the sign."""
    if sp.count_ops(formula) <= _SIMPLE:
        formula = sp.factor(formula)
    powers: dict[sp.Expr, sp.Expr] = {}
    for base, exponent in formula.as_powers_dict().items():
        if base.is_Rational and base != 0:
            primes = sp.factorint(abs(base))
            parts = {sp.Integer(p): exponent * k for p, k in primes.items()}
        else:
            parts = {base: exponent}
        for part, power_ in parts.items():
            powers[part] = powers.get(part, sp.S.Zero) + power_
    return powers


class Evaluator(Evaluation[Jet]):
    """Formulas in given symbols, each evaluated once.

    Parameters
    ----------
    points, directions : int
        The shape of all jets.
    definitions : mapping of Symbol to sympy.Expr
        Further symbols, each evaluated on first use.

    Attributes
    ----------
    good : array of bool, shape (N,)
        Mask of points without divisions by zero and roots of non-squares.
    """

    def __init__(
        self,
        jets: Mapping[sp.Symbol, Jet],
        points: int,
        directions: int,
        definitions: Mapping[sp.Symbol, sp.Expr],
    ) -> None:
        super().__init__(jets, definitions)
        self._points = points
        self._directions = directions
        self.good: Truths = np.ones(points, dtype=bool)

    def constant(self, number: int) -> Jet:
        """The jet of an integer."""
        return Jet(
            np.full(self._points, number % prime(), dtype=np.int64),
            np.zeros((self._directions, self._points), dtype=np.int64),
        )

    def __call__(self, formula: sp.Expr) -> Jet:
        """The jet of a scalar formula.

        Raises
        ------
        InputError
            If it is not algebraic in its symbols.
        """
        return self._visit(formula)

    def _constant(self, number: sp.Expr) -> Jet:
        exact = exact_number(number)
        return self.constant(int(exact.p) * pow(int(exact.q), -1, prime()))

    def _symbol(self, symbol: sp.Symbol) -> Jet:
        return self._function(symbol)

    def _power(self, formula: sp.Pow) -> Jet:
        base, exponent = formula.args
        if exponent.is_Integer:
            return self._integer_power(self(base), int(exponent))
        if not exponent.is_Rational:
            return self._symbolic_power(base, exponent)
        if exponent.q.bit_count() != 1:
            return self._function(formula)
        root = self(base)
        for _ in range(exponent.q.bit_length() - 1):
            root = self._root(root)
        return self._integer_power(root, int(exponent.p))

    def _function(self, formula: sp.Expr) -> Jet:
        match formula:
            case Dot():
                return self(formula.explicit())
            case sp.NumberSymbol():
                # Transcendental: any element with roots can represent it, so an even power is
                # taken.
                return self.constant(pow(int(1000 * sp.N(formula)), 2 * _WILD, prime()))
            case sp.exp():
                # exp is represented by the power map a ↦ a^w, which satisfies f′ = f by
                # construction; an identity that holds for such a function holds for every function
                # with this derivative.
                inner = self(formula.args[0])
                value = power(inner.value, _WILD)
                return inner.compose(value, value)
            case sp.log():
                return self._logarithm(formula.args[0])
            case sp.sin() | sp.cos():
                return self._circular(formula)
            case sp.tan():
                return self(sp.sin(formula.args[0]) / sp.cos(formula.args[0]))
            case sp.cot():
                return self(sp.cos(formula.args[0]) / sp.sin(formula.args[0]))
        raise InputError(
            "the search needs formulas of +, −, ×, /, powers, square roots, exp, log, sines and "
            "cosines; "
            f"{formula} is not one"
        )

    def _logarithm(self, argument: sp.Expr) -> Jet:
        """log|f| as a sum over the factors of f of pseudo-random functions with derivative 1/f."""
        total = self.constant(0)
        for base, exponent in _factors(expand(scalars(argument)[0], self._definitions)).items():
            jet = self(base)
            self.good &= jet.value != 0
            # Even, since a factor is known only up to its sign.
            value = power(jet.value * jet.value % prime(), _WILD)
            total = total + self(exponent) * jet.compose(value, inverse(jet.value))
        return total

    def _circular(self, formula: sp.Expr) -> Jet:
        """Sine or cosine of an angle, as coordinates of a pseudo-random point on the circle."""
        expanded = sp.expand_trig(formula)
        if expanded != formula:
            return self(expanded)
        angle = self(formula.args[0])
        half = power(angle.value, _WILD)
        square = half * half % prime()
        self.good &= square != prime() - 1
        # Rational parametrisation of the circle: (2t, 1 − t²)/(1 + t²), with 1 + t² ≠ 0.
        below = inverse((1 + square) % prime())
        sine, cosine = 2 * half * below % prime(), (1 - square) * below % prime()
        if isinstance(formula, sp.sin):
            return angle.compose(sine, cosine)
        return angle.compose(cosine, -sine % prime())

    def _symbolic_power(self, base: sp.Expr, exponent: sp.Expr) -> Jet:
        """Powers with exponents such as 2 − 1/k: pseudo-random functions of base and exponent."""
        product = self.constant(1)
        for term in sp.Add.make_args(sp.expand(exponent)):
            number, letters = term.as_coeff_Mul()
            if letters == 1:
                product = product * self(base**number)
                continue
            inner, theta = self(base), self(letters / number.q)
            wild = power((inner.value + theta.value) % prime(), _WILD)
            # d(b^θ) = θ b^(θ−1) db.
            slope = theta.value * wild % prime() * inverse(inner.value) % prime()
            product = product * self._integer_power(inner.compose(wild, slope), int(number.p))
        return product

    def _integer_power(self, base: Jet, exponent: int) -> Jet:
        if exponent < 0:
            return self._integer_power(self._reciprocal(base), -exponent)
        below = power(base.value, max(exponent - 1, 0))
        return base.compose(below * base.value % prime(), below * exponent % prime())

    def _reciprocal(self, jet: Jet) -> Jet:
        self.good &= jet.value != 0
        value = inverse(jet.value)
        return jet.compose(value, (prime() - value) * value % prime())

    def _root(self, jet: Jet) -> Jet:
        root, exists = square_root(jet.value)
        self.good &= exists & (root != 0)
        return jet.compose(root, inverse(2 * root % prime()))
