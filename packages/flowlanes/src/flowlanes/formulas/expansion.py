"""Exact Taylor series of formulas about a point.

Angles occur in sines and cosines, for which rational numbers are chosen; e^x is represented by a
separate number.  At an angle that is a nonzero rational number, its sine is transcendental, and a
polynomial relation with rational coefficients that holds there holds everywhere
(Lindemann–Weierstrass theorem).  So any point of the circle can represent it.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations_with_replacement
from math import factorial, lcm

import sympy as sp
from sympy.core.function import AppliedUndef

from ..errors import InputError
from ..parsing.exact_decimals import exact_number
from ..system.named_formulas import expand
from .evaluation import Evaluation
from .taylor import Number, Numbers, Series

Steps = Mapping[sp.Symbol, sp.Expr]
#: Angles α whose sines and cosines are used, with n if those of α/n are needed.
Angles = Mapping[sp.Expr, int]

_CIRCULAR = (sp.sin, sp.cos, sp.tan)
#: Functions whose value at a point is represented by a separate number.
_OPAQUE = (sp.log, sp.atan, sp.asin, sp.acos)


def combination(argument: sp.Expr, steps: Steps) -> dict[sp.Expr, sp.Rational]:
    """Argument as a sum of rational multiples of angles; sp.pi stands for a half turn."""
    multiples = sp.expand(expand(argument, steps)).as_coefficients_dict()
    return {core: sp.Rational(factor) for core, factor in multiples.items()}


def angles(
    formulas: Iterable[sp.Expr], steps: Steps, kinds: Sequence[type[sp.Expr]] = _CIRCULAR
) -> Angles:
    """Angles in formulas; with ``kinds=(sp.exp,)`` the exponents."""
    divisors: dict[sp.Expr, int] = {}
    for formula in (*formulas, *steps.values()):
        for node in formula.atoms(*kinds):
            for core, factor in combination(node.args[0], steps).items():
                divisors[core] = lcm(divisors.get(core, 1), int(factor.q))
    return divisors


class TaylorExpansion(Evaluation[Series]):
    """Taylor series of formulas about one point.

    Parameters
    ----------
    numbers : Numbers
    variables : sequence of Symbol
        Variables of the series.
    values : mapping of Symbol to number
        Values of the variables and of all other constants.
    circles : mapping of formula to (number, number)
        Sine and cosine of every angle divided by its n from `angles`.
    units : Angles
        Value of n for each angle.
    steps : mapping of Symbol to formula
        Definitions.
    order : int
        Order up to which the series are known.
    seed : int
        Seed of the numbers that represent transcendental values; one seed for each point.
    """

    def __init__(
        self,
        numbers: Numbers,
        variables: Sequence[sp.Symbol],
        values: Mapping[sp.Symbol, Number],
        circles: Mapping[sp.Expr, tuple[Number, Number]],
        units: Angles,
        steps: Steps,
        order: int,
        seed: int = 0,
    ) -> None:
        super().__init__({}, steps)
        self.numbers, self.order, self.steps = numbers, order, dict(steps)
        self.values, self.circles, self.units = dict(values), dict(circles), dict(units)
        self.variables = tuple(variables)
        self.ring = numbers.ring([f"x{i}" for i, _ in enumerate(self.variables)])
        self._formal: dict[sp.Expr, Number] = {}
        self._seed = seed

    def constant(self, value: Number) -> Series:
        """Series of a number."""
        return Series.constant(self.numbers, self.ring, value, self.order)

    def series(self, formula: sp.Expr) -> Series:
        """Series of a formula.

        Raises
        ------
        ZeroDivisionError
            If it is singular at the point.
        IrrationalError
            If a root that occurs is not in the number field.
        InputError
            If an unknown function occurs.
        """
        return self(formula)

    def _constant(self, number: sp.Expr) -> Series:
        return self.constant(self.numbers.number(exact_number(number)))

    def _power(self, formula: sp.Pow) -> Series:
        base, exponent = formula.args
        if not exponent.is_Rational:
            return self._function(formula)
        return self(base).power(int(exponent.p), int(exponent.q))

    def _function(self, formula: sp.Expr) -> Series:
        if isinstance(formula, _CIRCULAR):
            return self._circular(formula)
        if isinstance(formula, sp.exp):
            return self._exponential(formula)
        if isinstance(formula, _OPAQUE):
            argument = self(formula.args[0])
            return argument.primitive(self._formal_value(formula), self(formula.fdiff()))
        if formula.is_number:
            # π, e, π^e: represented by separate numbers.
            return self.constant(self._formal_value(formula))
        if isinstance(formula, (AppliedUndef, sp.Derivative)):
            return self._unspecified_function(formula)
        raise InputError(
            f"{formula}: its derivatives at a point cannot be computed exactly; known are sums, "
            "products, powers with rational exponents, sin, cos, tan, exp, log, asin, acos, atan"
        )

    def _symbol(self, symbol: sp.Symbol) -> Series:
        if symbol not in self.values:
            raise InputError(f"no value is given for {symbol}")
        series = self.constant(self.values[symbol])
        if symbol in self.variables and self.order:
            # a variable is its value plus the generator of the ring
            series.parts[1] = self.ring.gens()[self.variables.index(symbol)]
        return series

    def _circular(self, formula: sp.Expr) -> Series:
        one, zero = self.numbers.number(1), self.numbers.number(0)
        total = (zero, one)
        for core, factor in combination(formula.args[0], self.steps).items():
            unit = self.circles[core]
            # The angle is a multiple of the unit α/n, whose sine and cosine are given.
            total = add_angle(total, unit, int(factor * self.units[core]), (zero, one))
        s, c = self(formula.args[0]).circle(*total)
        return s if isinstance(formula, sp.sin) else c if isinstance(formula, sp.cos) else s / c

    def _exponential(self, formula: sp.Expr) -> Series:
        units = angles([formula], self.steps, (sp.exp,))
        value = self.numbers.number(1)
        for core, factor in combination(formula.args[0], self.steps).items():
            # One number for e^(core/60), so that e^(x/2), e^(x/3), … of one point agree.
            multiple = factor * 60 * units[core]
            whole = int(factor * 60) if multiple.is_Integer and 60 % units[core] == 0 else None
            if whole is None:
                raise InputError(f"{formula}: exponents may have denominators 1 to 6 only")
            value = value * self._formal_value(sp.exp(core / 60)) ** whole
        return self(formula.args[0]).exponential(value)

    def _formal_value(self, formula: sp.Expr) -> Number:
        """Separate number that represents a transcendental value."""
        if formula not in self._formal:
            self._formal[formula] = self.numbers.random_number(
                random.Random(f"{self._seed} {formula}")
            )
        return self._formal[formula]

    def _unspecified_function(self, formula: sp.Expr) -> Series:
        """Unspecified function of some variables, or a derivative of it."""
        function = formula.expr if isinstance(formula, sp.Derivative) else formula
        orders = dict(formula.variable_count) if isinstance(formula, sp.Derivative) else {}
        indices = [self.variables.index(s) for s in function.args if s in self.variables]
        if not isinstance(function, AppliedUndef) or len(indices) != len(function.args):
            raise InputError(f"{formula}: an unspecified function may depend on coordinates only")
        gens = self.ring.gens()
        parts = []
        for degree in range(self.order + 1):
            total = self.ring.constant(0)
            # Every partial derivative at the point is a free number; divided by the factorials it
            # is a Taylor coefficient.
            for chosen in combinations_with_replacement(range(len(indices)), degree):
                powers = [chosen.count(i) for i, _ in enumerate(indices)]
                raised = [
                    p + int(orders.get(s, 0)) for p, s in zip(powers, function.args, strict=True)
                ]
                value = self._formal_value(sp.Tuple(function, *raised))
                for power in powers:
                    value = value / factorial(power)
                term = self.constant(value).parts[0]
                for i in chosen:
                    term = term * gens[indices[i]]
                total = total + term
            parts.append(total)
        return Series(self.numbers, self.ring, parts)


def add_angle(
    start: tuple[Number, Number],
    unit: tuple[Number, Number],
    times: int,
    none: tuple[Number, Number],
) -> tuple[Number, Number]:
    """Sine and cosine of an angle increased by a multiple of the unit."""
    s, c = unit if times >= 0 else (none[0] - unit[0], unit[1])
    sine, cosine = start
    for _ in range(abs(times)):
        sine, cosine = sine * c + cosine * s, cosine * c - sine * s
    return sine, cosine
