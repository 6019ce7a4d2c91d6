"""Conversion of numbers and names to SymPy expressions, checked at every step."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

import sympy

from ..errors import InputError
from .grammar import (
    DECIMALS,
    FUNCTIONS,
    MAX_BITS,
    MAX_CONSTANT,
    MAX_DEPTH,
    MAX_DIGITS,
    MAX_EXPONENT,
    MAX_ROOT,
    OF_TWO,
)
from .syntax import TOO_DEEP, Source, chain

# SymPy computes constants while it builds an expression, and fails in these ways if that is beyond
# its means (among them PrecisionExhausted, an ArithmeticError).
_SYMPY_FAILURES = (ArithmeticError, AttributeError, RecursionError, TypeError, ValueError)


@dataclass(frozen=True)
class Scalars:
    """Converter from the syntax tree of one formula to SymPy.

    Parameters
    ----------
    source : Source
    names : mapping of str to Symbol
        The scalars that the formula may contain.
    vectors : collection of str
        Names of vectors and tensors, which may occur only in calls of `products`.
    products : mapping of str to callable
        Further functions that parse their own arguments: (call, depth) ↦ value.
    """

    source: Source
    names: Mapping[str, sympy.Expr]
    vectors: Collection[str] = ()
    products: Mapping[str, Callable[[ast.Call, int], sympy.Expr]] = field(default_factory=dict)

    def error(self, message: str, node: ast.expr) -> InputError:
        """An error message that points at the first character of `node`."""
        return self.source.at(message, node)

    def read(self, node: ast.expr, depth: int) -> sympy.Expr:
        """The value of `node`, checked to be real, finite and of a reasonable size."""
        if depth > MAX_DEPTH:
            raise self.error(TOO_DEEP, node)
        try:
            value = self.build(node, depth)
            self.check(value, node)
        except InputError:
            raise
        except _SYMPY_FAILURES:
            raise self.error(
                "this is beyond exact computation; use simpler numbers", node
            ) from None
        return value

    def build(self, node: ast.expr, depth: int) -> sympy.Expr:
        """The value of `node`, unchecked."""
        match node:
            case ast.Constant():
                return self.number(node)
            case ast.Name():
                return self.name(node)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.read(operand, depth + 1)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return -self.read(operand, depth + 1)
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return self.sum(node, depth)
            case ast.BinOp(op=ast.Mult() | ast.Div()):
                return self.product(node, depth)
            case ast.BinOp(op=ast.Pow()):
                return self.power(node, depth)
            case ast.BinOp():
                raise self.error("of two slashes one is too many; division is written /", node)
            case ast.Call():
                return self.call(node, depth)
            case _:
                raise self.error("this is not part of a formula", node)

    def number(self, node: ast.Constant) -> sympy.Expr:
        """The exact value of a decimal number."""
        text = self.source.text[node.col_offset - 1 : (node.end_col_offset or 0) - 1]
        power_of_ten = re.search(r"[eE][+-]?(\d+)$", text)
        if power_of_ten and int(power_of_ten.group(1)) > MAX_DIGITS:
            raise self.error("the power of ten of this number is too large", node)
        fraction = Fraction(text)
        return sympy.Rational(fraction.numerator, fraction.denominator)

    def name(self, node: ast.Name) -> sympy.Expr:
        """The symbol or constant for a name."""
        if node.id in self.vectors:
            message = f"a number is wanted here, and '{node.id}' is none"
            raise self.error(f"{message}; of a vector write a component or dot(u, v)", node)
        if node.id not in self.names:
            raise self.error(f"'{node.id}' is a function; write {node.id}(...)", node)
        return self.names[node.id]

    def sum(self, node: ast.BinOp, depth: int) -> sympy.Expr:
        """A chain ``a + b - c`` in one call; SymPy would sort the terms after every addition."""
        terms = []
        for operator, operand in chain(node, (ast.Add, ast.Sub)):
            value = self.read(operand, depth + 1)
            terms.append(-value if isinstance(operator, ast.Sub) else value)
        return sympy.Add(*terms)

    def product(self, node: ast.BinOp, depth: int) -> sympy.Expr:
        """A chain ``a * b / c`` in one call."""
        factors = []
        for operator, operand in chain(node, (ast.Mult, ast.Div)):
            value = self.read(operand, depth + 1)
            if isinstance(operator, ast.Div):
                self.check_divisor(value, operand)
                value = 1 / value
            factors.append(value)
        return sympy.Mul(*factors)

    def power(self, node: ast.BinOp, depth: int) -> sympy.Expr:
        """A power whose exponent contains only numbers within bounds."""
        exponent = self.read(node.right, depth + 1)
        self.check_exponent(exponent, node.right)
        value = sympy.Pow(self.read(node.left, depth + 1), exponent)
        for power in value.atoms(sympy.Pow):  # (x**100)**100 has become x**10000
            self.check_exponent(power.exp, node.right)
        return value

    def call(self, node: ast.Call, depth: int) -> sympy.Expr:
        """The value of a function."""
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name in self.products:
            return self.products[name](node, depth)
        if name not in FUNCTIONS or name in self.names:
            raise self.error("only functions can be called", node)
        wanted = 2 if name in OF_TWO else 1
        if len(node.args) != wanted or node.keywords:
            raise self.error(f"{name} takes {wanted} argument{'s' * (wanted - 1)}", node)
        arguments = [self.read(argument, depth + 1) for argument in node.args]
        if name == "exp":
            self.check_exponent(arguments[0], node)
        return FUNCTIONS[name](*arguments)

    def check_divisor(self, value: sympy.Expr, node: ast.expr) -> None:
        """Reject zero, and constants that cannot be distinguished from zero numerically."""
        zero = value.is_zero
        if zero is None and not value.free_symbols:
            zero = value.equals(0)
            if zero is None and abs(sympy.N(value)) * MAX_CONSTANT < 1:
                raise self.error("division by a number that cannot be told from zero", node)
        if zero:
            raise self.error("division by zero", node)

    def check_exponent(self, exponent: sympy.Expr, node: ast.expr) -> None:
        """Reject numbers that would become astronomically large in exact arithmetic."""
        for number in exponent.atoms(sympy.Rational):
            if abs(number) > MAX_EXPONENT:
                message = f"this exponent is too large; up to {MAX_EXPONENT} is allowed"
                raise self.error(message, node)
            if number.q > MAX_ROOT:
                raise self.error(f"this exponent has more than {DECIMALS} decimals", node)

    def check(self, value: sympy.Expr, node: ast.expr) -> None:
        """Reject a constant that is not real, or too large to be evaluated by SymPy."""
        if value.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
            raise self.error("this has no finite value", node)
        if value.is_Rational:
            if max(value.p.bit_length(), value.q.bit_length()) > MAX_BITS:
                raise self.error("this number is too large", node)
        elif not value.free_symbols:
            approximation = sympy.N(value)
            if not approximation.is_real:
                raise self.error("this is not a real number", node)
            if abs(approximation) > MAX_CONSTANT:
                raise self.error(f"this number is larger than {MAX_CONSTANT:.0e}", node)
