"""Formulas evaluated with their derivatives, in any field of numbers or functions.

A jet is a value with some directional derivatives.  If the seeds of the state are unit vectors,
these are partial derivatives; if they are the vector field, these are time derivatives.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from ..parsing.exact_decimals import exact_number
from ..system.laws import Rate
from .errors import OutOfReachError, UnknownSymbolError
from .evaluation import Evaluation, with_absolute_values
from .number_fields import Element

#: Multiples of an angle whose sine is expanded in the sine and cosine of the angle.
MOST_MULTIPLES = 24

#: Index of the direction of the vector field of the system.
ALONG = -1


@dataclass(frozen=True)
class Jet:
    """A value and its derivatives in numbered directions; a missing derivative is zero."""

    value: Element
    slopes: Mapping[int, Element]

    def __add__(self, other: Jet) -> Jet:
        slopes = dict(self.slopes)
        for i, slope in other.slopes.items():
            slopes[i] = slopes[i] + slope if i in slopes else slope
        return Jet(self.value + other.value, slopes)

    def __mul__(self, other: Jet) -> Jet:
        slopes = {i: slope * other.value for i, slope in self.slopes.items()}
        for i, slope in other.slopes.items():
            part = self.value * slope
            slopes[i] = slopes[i] + part if i in slopes else part
        return Jet(self.value * other.value, slopes)

    def through(self, value: Element, derivative: Element) -> Jet:
        """Function of this jet, by the chain rule."""
        return Jet(value, {i: derivative * slope for i, slope in self.slopes.items()})


@dataclass(frozen=True)
class GeneratorSwap:
    """Definition ``name = factor·parameter + rest`` solved for the parameter.

    The name becomes a generator, which keeps denominators short: with J = I + m r² the computation
    uses J instead of I.
    """

    name: sp.Symbol
    parameter: sp.Symbol
    factor: sp.Rational
    rest: sp.Expr


@dataclass(frozen=True)
class Inversion:
    """Symmetric tensor A = J⁻¹ used as J = A⁻¹, where A is the generator.

    Both are given as six symbols 11, 12, 13, 22, 23, 33.
    """

    name: tuple[sp.Symbol, ...]
    of: tuple[sp.Symbol, ...]


#: Indices of the entries of a symmetric matrix in its list of six.
_SIX = ((0, 1, 2), (1, 3, 4), (2, 4, 5))


class Evaluator(Evaluation[Jet]):
    """Jets of the formulas of one system, in one field.

    Parameters
    ----------
    field
        A field of :mod:`flowlanes.formulas.number_fields`, or the function field of the prover.
    seed : callable
        Function for the jet of a generator (state, parameters); None for any other symbol.
    steps : mapping of Symbol to formula
        Definitions, evaluated on first use.
    swaps : sequence of GeneratorSwap
        Definitions that are generators instead of a parameter.
    zeros : collection of formulas
        Values of unspecified functions that are zero by the conditions.
    inversions : sequence of Inversion
        Inverses of tensors that are generators instead of the tensors.
    moving : bool
        True if the seeds have time derivatives, so that `Rate` can be evaluated.
    """

    def __init__(
        self,
        field: Any,
        seed: Callable[[sp.Symbol], Jet | None],
        steps: Mapping[sp.Symbol, sp.Expr],
        swaps: Sequence[GeneratorSwap] = (),
        zeros: Collection[sp.Expr] = (),
        inversions: Sequence[Inversion] = (),
        moving: bool = False,
    ) -> None:
        super().__init__({})
        self.field = field
        self.steps = dict(steps)
        self.swaps = tuple(swaps)
        self.zeros = tuple(zeros)
        self.inversions = tuple(inversions)
        self.moving = moving
        self._inverse = {s: (i, n) for i in inversions for n, s in enumerate(i.name)}
        self._inversions = {s: (i, n) for i in inversions for n, s in enumerate(i.of)}
        self._by_name = {e.name: e for e in swaps}
        self._by_parameter = {e.parameter: e for e in swaps}
        self.seed = seed

    def with_steps(self, steps: Mapping[sp.Symbol, sp.Expr]) -> Evaluator:
        """Evaluator with further definitions."""
        return Evaluator(
            self.field,
            self.seed,
            {**self.steps, **steps},
            self.swaps,
            self.zeros,
            self.inversions,
            self.moving,
        )

    def value(self, formula: sp.Expr) -> Element:
        """Value of a formula without derivatives."""
        return self(formula).value

    def slope(self, formula: sp.Expr, direction: int = ALONG) -> Element:
        """One derivative of a formula."""
        return self(formula).slopes.get(direction, self.field.zero)

    def __call__(self, formula: sp.Expr) -> Jet:
        """Jet of a formula."""
        return self._visit(sp.sympify(formula))

    def _constant(self, number: sp.Expr) -> Jet:
        return Jet(self.field.rational(exact_number(number)), {})

    def _symbol(self, symbol: sp.Symbol) -> Jet:
        if symbol in self._inverse:
            return self._of_inverse(*self._inverse[symbol])
        if symbol in self._inversions:
            return self._of_inverted(*self._inversions[symbol])
        # The name is the generator, so its derivatives are those of the rest.
        if symbol in self._by_name:
            remainder = self(self._by_name[symbol].rest)
            return Jet(self.field.generator(str(symbol)), remainder.slopes)
        if symbol in self._by_parameter:
            change = self._by_parameter[symbol]
            difference = self.value(change.name) - self.value(change.rest)
            return Jet(difference * self.field.rational(1 / change.factor), {})
        if symbol in self.steps:
            return self(self.steps[symbol])
        seeded = self.seed(symbol)
        if seeded is not None:
            return seeded
        raise UnknownSymbolError(str(symbol))

    def _function(self, formula: sp.Expr) -> Jet:
        if formula is sp.pi:
            return Jet(self.field.pi(), {})
        if formula is sp.E:
            return Jet(self.field.exponential(self.field.one), {})
        if isinstance(formula, sp.exp):
            return self._exponential(formula)
        if isinstance(formula, Rate):
            if not self.moving:
                raise OutOfReachError(f"the rate {formula} in a place where only values are known")
            inner = self(formula.args[0])
            return Jet(inner.slopes.get(ALONG, self.field.zero), {})
        if isinstance(formula, AppliedUndef | sp.Derivative | sp.Subs):
            return self._unspecified_function(formula)
        return self._elementary(formula)

    def _of_inverse(self, inversion: Inversion, number: int) -> Jet:
        """Entry of A: a generator, with the derivatives −A J̇ A."""
        A = [self.field.generator(str(s)) for s in inversion.name]
        remainders = [self(self._by_name[s].rest) for s in inversion.of]
        row, column = next((i, j) for i in range(3) for j in range(3) if _SIX[i][j] == number)
        # dA = −A dJ A for A = J⁻¹
        slopes = {}
        for direction in {d for remainder in remainders for d in remainder.slopes}:
            total = self.field.zero
            for i in range(3):
                for j in range(3):
                    slope = remainders[_SIX[i][j]].slopes.get(direction)
                    if slope is not None:
                        total = total - A[_SIX[row][i]] * slope * A[_SIX[j][column]]
            slopes[direction] = total
        return Jet(A[number], slopes)

    def _of_inverted(self, inversion: Inversion, number: int) -> Jet:
        """Entry of J = A⁻¹."""
        # Cofactors of the symmetric matrix (a b c; b d e; c e f).
        a, b, c, d, e, f = (self.field.generator(str(s)) for s in inversion.name)
        minors = (
            d * f - e * e,
            c * e - b * f,
            b * e - c * d,
            a * f - c * c,
            b * c - a * e,
            a * d - b * b,
        )
        determinant = a * minors[0] + b * minors[1] + c * minors[2]
        slopes = self(self._by_name[inversion.of[number]].rest).slopes
        return Jet(minors[number] / determinant, slopes)

    def _power(self, formula: sp.Pow) -> Jet:
        base, exponent = formula.args
        inner = self(base)
        field = self.field
        if exponent.is_Integer:
            n = int(exponent)
            if n < 0 and field.vanishes(inner.value):
                raise ZeroDivisionError
            if not inner.slopes:
                return Jet(inner.value**n, {})
            # (fⁿ)' = n fⁿ⁻¹ f'
            lower = inner.value ** (n - 1)
            return inner.through(lower * inner.value, field.rational(n) * lower)
        outer = self(exponent)
        if outer.slopes:
            raise OutOfReachError(f"the exponent {exponent} changes along the motion")
        raised = self._root_power(inner.value, exponent, outer.value)
        if not inner.slopes:
            return Jet(raised, {})
        return inner.through(raised, outer.value * raised / inner.value)

    def _root_power(self, base: Element, exponent: sp.Expr, value: Element) -> Element:
        """Power whose exponent is rational, becomes rational on the level, or is symbolic."""
        number = exponent if exponent.is_Rational else self.field.as_rational(value)
        if number is not None:
            return self.field.root(base, int(number.q)) ** int(number.p)
        terms = (term.as_coeff_Mul() for term in sp.Add.make_args(sp.expand(exponent)))
        return self.field.power(base, [(theta, number) for number, theta in terms], value)

    def _exponential(self, formula: sp.Expr) -> Jet:
        exponent = sp.expand(formula.args[0])
        # e^(x + y) = e^x e^y, so that each term has one generator.
        if exponent.is_Add:
            return reduce(operator.mul, (self(sp.exp(term)) for term in exponent.args))
        inner = self(exponent)
        value = self.field.exponential(inner.value)
        return inner.through(value, value)

    def _unspecified_function(self, formula: sp.Expr) -> Jet:
        """Value of an unspecified function, or of one of its derivatives."""
        function, orders, arguments = _function_and_orders(formula)
        inner = [self(argument) for argument in arguments]
        values = [jet.value for jet in inner]

        def partial_derivative(counts: tuple[int, ...]) -> Element:
            if self._is_zero(function, counts, values):
                return self.field.zero
            return self.field.unspecified_value(function, counts, values)

        slopes: dict[int, Element] = {}
        # Chain rule over the arguments of the function.
        for j, jet in enumerate(inner):
            if jet.slopes:
                raised = tuple(n + (i == j) for i, n in enumerate(orders))
                partial = partial_derivative(raised)
                for i, slope in jet.slopes.items():
                    part = partial * slope
                    slopes[i] = slopes[i] + part if i in slopes else part
        return Jet(partial_derivative(orders), slopes)

    def _is_zero(self, function: str, orders: tuple[int, ...], values: Sequence[Element]) -> bool:
        """True if a value of an unspecified function is zero by the conditions."""
        for zero in self.zeros:
            other, counts, arguments = _function_and_orders(zero)
            if (other, counts) == (function, orders):
                there = [self.value(argument) for argument in arguments]
                if self.field.same(there, values):
                    return True
        return False

    def _elementary(self, formula: sp.Expr) -> Jet:
        field = self.field
        if isinstance(formula, sp.sin | sp.cos):
            return self._circular(formula)
        if isinstance(formula, sp.tan | sp.cot | sp.sec | sp.csc):
            return self(_as_ratio(formula))
        if isinstance(formula, sp.sinh | sp.cosh | sp.tanh):
            return self(formula.rewrite(sp.exp))
        if isinstance(formula, sp.Max | sp.Min):
            return self(with_absolute_values(formula))
        if isinstance(formula, sp.acos):
            return self(sp.pi / 2 - sp.asin(formula.args[0]))
        if not (formula.args and formula.is_Function):
            raise OutOfReachError(f"{formula}, which is no real number or function of the state")
        inner = [self(part) for part in formula.args]
        values = [jet.value for jet in inner]
        one = field.one
        if isinstance(formula, sp.log):
            return inner[0].through(field.logarithm(values[0]), one / values[0])
        if isinstance(formula, sp.atan2):
            upper, lower = inner
            square = lower.value * lower.value + upper.value * upper.value
            angle = upper.through(field.function_value("atan2", values), lower.value / square)
            return angle + lower.through(field.zero, field.zero - upper.value / square)
        x = values[0]
        if isinstance(formula, sp.Abs | sp.sign):
            # |x| = √(x²) has the derivative x/|x|, the sign of x; zeros are excluded.
            size = field.root(x * x, 2)
            sign = x / size
            return inner[0].through(size, sign) if isinstance(formula, sp.Abs) else Jet(sign, {})
        if isinstance(formula, sp.atan):
            return inner[0].through(field.function_value("atan", values), one / (one + x * x))
        if isinstance(formula, sp.asin):
            root = field.root(one - x * x, 2)
            return inner[0].through(field.function_value("asin", values), one / root)
        raise OutOfReachError(
            f"the formula {formula} is of a kind ({type(formula).__name__}) unknown here"
        )

    def _circular(self, formula: sp.Expr) -> Jet:
        spread = _in_parts(formula, self.field.angle_parts)
        if spread != formula:
            return self(spread)
        inner = self(formula.args[0])
        sine, cosine = self.field.circle(inner.value)
        if isinstance(formula, sp.sin):
            return inner.through(sine, cosine)
        return inner.through(cosine, self.field.zero - sine)


def angle_terms(formula: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    """Terms of the angle of a sine or cosine: coefficients and base angles."""
    return [term.as_coeff_Mul() for term in sp.Add.make_args(sp.expand(formula.args[0]))]


def _in_parts(formula: sp.Expr, angle_parts: Mapping[sp.Expr, int]) -> sp.Expr:
    """Sine or cosine as a polynomial in those of parts of its angle, if that is short."""
    terms = [(number * angle_parts.get(t, 1), t) for number, t in angle_terms(formula)]
    if any(abs(number) > MOST_MULTIPLES for number, _ in terms):
        return formula
    parts = {t: sp.Dummy(real=True) for _, t in terms}
    spread = sp.expand_trig(formula.func(sp.Add(*(number * parts[t] for number, t in terms))))
    return spread.xreplace({part: t / angle_parts.get(t, 1) for t, part in parts.items()})


def _as_ratio(formula: sp.Expr) -> sp.Expr:
    angle = formula.args[0]
    sine, cosine = sp.sin(angle), sp.cos(angle)
    return {
        sp.tan: sine / cosine,
        sp.cot: cosine / sine,
        sp.sec: 1 / cosine,
        sp.csc: 1 / sine,
    }[type(formula)]


def _function_and_orders(formula: sp.Expr) -> tuple[str, tuple[int, ...], tuple[sp.Expr, ...]]:
    """Name of an unspecified function, orders of its derivatives, and its arguments."""
    points: dict[sp.Symbol, sp.Expr] = {}
    inner = formula
    while isinstance(inner, sp.Subs):
        points = {**dict(zip(inner.variables, inner.point, strict=True)), **points}
        inner = inner.expr
    counted: dict[sp.Symbol, int] = {}
    if isinstance(inner, sp.Derivative):
        for variable, count in inner.variable_count:
            counted[variable] = counted.get(variable, 0) + int(count)
        inner = inner.expr
    if not isinstance(inner, AppliedUndef):
        raise OutOfReachError(f"the derivative {formula} is not of a single unspecified function")
    for variable in counted:
        if inner.args.count(variable) != 1:
            raise OutOfReachError(f"the derivative {formula} is not by one place of its function")
    orders = tuple(counted.get(argument, 0) for argument in inner.args)
    return type(inner).__name__, orders, tuple(argument.xreplace(points) for argument in inner.args)
