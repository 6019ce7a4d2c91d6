"""Decimal numbers as exact rationals."""

from __future__ import annotations

import math
import operator
from contextlib import suppress
from fractions import Fraction
from typing import SupportsFloat, SupportsIndex

import mpmath
import sympy
from mpmath import libmp

from ..errors import InputError

_DOUBLE = 53
"""Precision of a double, in bits; its shortest decimal identifies it."""


def exact_number(number: object) -> sympy.Rational:
    """The rational number represented by a decimal number.

    For a double this is the shortest decimal that reads back as the same double: 0.1 is 1/10, and
    0.333333333333333 is not 1/3.  For other precisions it is the decimal with as many digits as the
    precision carries.

    Parameters
    ----------
    number : int, float, Fraction, sympy.Rational, sympy.Float or mpmath number

    Returns
    -------
    sympy.Rational

    Raises
    ------
    InputError
        If it is not a finite number, or has another type.
    """
    if isinstance(number, sympy.Rational):
        return number
    if isinstance(number, Fraction):
        return sympy.Rational(number.numerator, number.denominator)
    if isinstance(number, sympy.Float):
        return _decimal(number._mpf_, number._prec)
    if isinstance(number, mpmath.mpf):
        return _decimal(number._mpf_, number.context.prec)
    if isinstance(number, float):
        return _shortest(float(number))
    if isinstance(number, SupportsIndex):
        with suppress(TypeError):
            return sympy.Integer(operator.index(number))
    if not isinstance(number, SupportsFloat) or isinstance(number, sympy.Basic):
        raise InputError(f"{number} is no number that has an exact value as a decimal")
    return _shortest(float(number))


def with_exact_decimals(formula: object) -> sympy.Basic:
    """A formula in which every decimal number is replaced by the rational number it represents.

    Parameters
    ----------
    formula : sympy.Basic, or a number as of `exact_number`

    Raises
    ------
    InputError
        If a number is not finite.
    """
    if not isinstance(formula, sympy.Basic | sympy.MatrixBase):
        return exact_number(formula)
    decimals = formula.atoms(sympy.Float)
    return formula.xreplace({x: exact_number(x) for x in decimals}) if decimals else formula


def _shortest(number: float) -> sympy.Rational:
    if not math.isfinite(number):
        raise InputError(f"{number} is not a finite number")
    fraction = Fraction(repr(number))
    return sympy.Rational(fraction.numerator, fraction.denominator)


def _decimal(number: tuple[int, int, int, int], bits: int) -> sympy.Rational:
    """An mpmath number as a decimal with as many digits as its precision carries."""
    if number in (libmp.finf, libmp.fninf, libmp.fnan):
        raise InputError(f"{libmp.to_str(number, 5)} is not a finite number")
    if bits == _DOUBLE:
        return _shortest(float(libmp.to_float(number)))
    fraction = Fraction(libmp.to_str(number, libmp.prec_to_dps(bits)))
    return sympy.Rational(fraction.numerator, fraction.denominator)
