"""Words with a meaning in every formula: functions and numbers."""

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
"""Functions that a formula may call; each takes one argument, some take two."""

CONSTANTS: Mapping[str, sympy.Expr] = MappingProxyType({"pi": sympy.pi})
"""Names that mean a number in every formula."""

RESERVED_WORDS = frozenset(FUNCTIONS) | frozenset(CONSTANTS)
"""Names that no symbol of a formula can bear."""
