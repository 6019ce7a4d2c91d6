"""The words of the formula language and the sizes that it allows."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import sympy

FUNCTIONS: Mapping[str, Callable[..., sympy.Expr]] = MappingProxyType(
    {
        "sqrt": sympy.sqrt,
        "sin": sympy.sin,
        "cos": sympy.cos,
        "tan": sympy.tan,
        "asin": sympy.asin,
        "acos": sympy.acos,
        "atan": sympy.atan,
        "atan2": sympy.atan2,
        "sinh": sympy.sinh,
        "cosh": sympy.cosh,
        "tanh": sympy.tanh,
        "exp": sympy.exp,
        "log": sympy.log,
        "abs": sympy.Abs,
        "sign": sympy.sign,
        "max": sympy.Max,
        "min": sympy.Min,
    }
)
"""Functions that a formula may call; each takes one argument, those of `OF_TWO` take two."""

OF_TWO = frozenset({"atan2", "max", "min"})

CONSTANTS: Mapping[str, sympy.Expr] = MappingProxyType({"pi": sympy.pi})
"""Names that mean a number in every formula."""

RESERVED_WORDS = frozenset(FUNCTIONS) | frozenset(CONSTANTS)
"""Names that no symbol of a formula can bear."""

PRODUCTS = frozenset({"dot", "cross"})
"""Products of vectors, which a formula with vectors may call besides."""

DECIMALS = 6
MAX_LENGTH = 10_000
MAX_EXPONENT = 100
MAX_DEPTH = 60
MAX_ROOT = 10**DECIMALS
MAX_DIGITS = 300
MAX_BITS = 1024
MAX_CONSTANT = sympy.Float("1e100")
