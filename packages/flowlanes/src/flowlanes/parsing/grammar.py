"""The vocabulary of the formula language and its size limits."""

from __future__ import annotations

import sympy

from .. import formula_words

OF_TWO = frozenset({"atan2", "max", "min"})

FUNCTIONS, CONSTANTS = formula_words.FUNCTIONS, formula_words.CONSTANTS

RESERVED_WORDS = formula_words.RESERVED_WORDS

PRODUCTS = frozenset({"dot", "cross", "outer", "gradient", "diagonal", "identity", "Rate"})
"""Further functions of formulas with vectors: products, gradients, tensors, time derivatives."""

DECIMALS = 6
MAX_LENGTH = 10_000
MAX_EXPONENT = 100
MAX_DEPTH = 60
MAX_ROOT = 10**DECIMALS
MAX_DIGITS = 300
MAX_BITS = 1024
MAX_CONSTANT = sympy.Float("1e100")
