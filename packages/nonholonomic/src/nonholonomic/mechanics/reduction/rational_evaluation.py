"""Exact values at rational points, for formulas rational in coordinates, sines and cosines.

Every coordinate x has a rational value of its own, and sin x and cos x are a rational point of the
circle: a formula that vanishes at generic points of this kind vanishes as a function of x, sin x,
cos x.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Protocol

import sympy as sp
from flint import fmpq

from flowlanes.errors import InputError
from flowlanes.formulas.straight_line_program import FieldArithmetic, StraightLineProgram
from flowlanes.system.vectors import real_symbol

from .rational_functions import Value

Point = Mapping[sp.Symbol, Value]


def circle(angle: sp.Symbol) -> tuple[sp.Symbol, sp.Symbol]:
    """The names of sin x and cos x."""
    return real_symbol(f"sin_{angle}"), real_symbol(f"cos_{angle}")


def on_circles(formula: sp.Expr, owner: str = "") -> sp.Expr:
    """A formula with named sines and cosines.

    Raises
    ------
    InputError
        If the formula is not rational in coordinates, their sines and cosines.
    """
    formula = formula.rewrite([sp.tan, sp.cot, sp.sec, sp.csc], sp.cos).rewrite(sp.tan, sp.cos)
    if formula.has(sp.Function):
        formula = sp.expand_trig(formula)
    constants = sorted(map(str, formula.atoms(sp.NumberSymbol)))
    if constants:
        raise InputError(
            f"{owner}: {constants[0]} stands where the search for a multiplier needs rational "
            f"coefficients; give it a name, as a parameter with the value "
            f"{float(sp.sympify(constants[0])):.16g}"
        )
    names = {}
    for f in formula.atoms(sp.Function):
        if not (isinstance(f, sp.sin | sp.cos) and isinstance(f.args[0], sp.Symbol)):
            raise InputError(
                f"{owner}: {f} stands where the search for a multiplier needs coefficients that "
                "are rational in the coordinates, their sines and cosines"
            )
        names[f] = circle(f.args[0])[isinstance(f, sp.cos)]
    taken = sorted(map(str, formula.free_symbols & set(names.values())))
    if taken:
        raise InputError(
            f"{owner}: the name {taken[0]} is needed for a sine or cosine; rename what has it"
        )
    formula = formula.xreplace(names)
    if any(not p.exp.is_Integer for p in formula.atoms(sp.Pow)):
        raise InputError(
            f"{owner}: a root or power stands where the search for a multiplier needs "
            "coefficients that are rational in the coordinates, their sines and cosines"
        )
    return formula


def is_rational(formula: sp.Expr) -> bool:
    """Whether a formula is rational in coordinates, their sines and cosines."""
    try:
        on_circles(formula)
    except InputError:
        return False
    return True


class Evaluable(Protocol):
    """The interface of formulas that have values at points."""

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols that need a value."""

    def at(self, point: Point, like: Value) -> list[Value]:
        """The values; `like` is the number one of the field."""


class Formulas:
    """Formulas compiled for evaluation in any field.

    Parameters
    ----------
    formulas : sequence of Expr
    owner : str
        Name of the system, for error messages.
    """

    def __init__(self, formulas: Iterable[sp.Expr], owner: str = "") -> None:
        shared, parts = sp.cse([on_circles(sp.sympify(f), owner) for f in formulas], list=False)
        symbols = {s for f in (*dict(shared).values(), *parts) for s in f.free_symbols}
        self.symbols = tuple(sorted(symbols - dict(shared).keys(), key=str))
        self._program = StraightLineProgram(self.symbols, parts, tuple(shared))

    def at(self, point: Point, like: Value) -> list[Value]:
        """The values; `like` is the number one of the field."""
        values = self._program.run([point[s] for s in self.symbols], FieldArithmetic(like))
        return [like * value for value in values]


def plain_symbols(symbols: Iterable[sp.Symbol]) -> list[sp.Symbol]:
    """The symbols that do not name sines or cosines."""
    return [s for s in symbols if not str(s).startswith(("sin_", "cos_"))]


def random_rational(rng: random.Random) -> fmpq:
    """A random rational number."""
    sign = rng.choice((-1, 1))
    return fmpq(sign * rng.randint(2, 40), rng.randint(11, 30))


def rational_near(default: float, rng: random.Random) -> fmpq:
    """A rational number near a default; any number if the default is zero."""
    if default == 0:
        return random_rational(rng)
    exact = Fraction(repr(float(default))) * rng.randint(90, 115) / 100
    return fmpq(exact.numerator, exact.denominator)


def rational_point(
    symbols: Iterable[sp.Symbol], rng: random.Random, start: Point | None = None
) -> dict[sp.Symbol, Value]:
    """Random values of symbols, with independent sines and cosines of each."""
    values: dict[sp.Symbol, Value] = dict(start or {})
    for s in symbols:
        if s in values:
            continue
        values[s] = random_rational(rng)
        half = random_rational(rng)
        # tan ½x rational gives a rational point (2h, 1 − h²)/(1 + h²) of the circle.
        square = 1 + half * half
        sine, cosine = circle(s)
        values[sine], values[cosine] = 2 * half / square, (1 - half * half) / square
    return values
