"""Formulas with vectors: sums, products with scalars and tensors, dot, cross.

Vectors are recognised from the text alone, before anything is computed; scalars are read by
:class:`~flowlanes.parsing.scalar.Scalars`.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import sympy
from sympy.matrices.expressions import MatrixExpr

from ..errors import InputError
from ..system.vectors import Diagonal, Vector, constant, cross, dot
from .grammar import MAX_DEPTH
from .scalar import Scalars
from .syntax import TOO_DEEP, Source, chain

NamedQuantity: TypeAlias = sympy.Symbol | Vector | Diagonal
Formula: TypeAlias = sympy.Expr | MatrixExpr

_SPACE = 3
_SIZES = (2, 3, 4)


@dataclass(frozen=True)
class Vectors:
    """Turns the syntax tree of one formula into a scalar or a vector.

    Parameters
    ----------
    source : Source
    symbols : mapping of str to Symbol
        The scalars that it may contain, components of vectors among them.
    names : mapping of str to Symbol, Vector or Diagonal
        Everything that has a name.
    """

    source: Source
    symbols: Mapping[str, sympy.Expr]
    names: Mapping[str, NamedQuantity]

    @cached_property
    def scalars(self) -> Scalars:
        """The reader of what is no vector."""
        vectors = {n for n, value in self.names.items() if not isinstance(value, sympy.Symbol)}
        return Scalars(self.source, self.symbols, vectors, {"dot": self.dot})

    def error(self, message: str, node: ast.expr) -> InputError:
        """Point at the first character of `node`."""
        return self.source.at(message, node)

    def read(self, node: ast.expr, depth: int) -> Formula:
        """The value of `node`."""
        if depth > MAX_DEPTH:
            raise self.error(TOO_DEEP, node)
        return self.vector(node, depth) if self.is_vector(node) else self.scalars.read(node, depth)

    def is_vector(self, node: ast.expr) -> bool:
        """Whether `node` is to be a vector, right or wrong."""
        match node:
            case ast.Name(id=name):
                return isinstance(self.names.get(name), Vector)
            case ast.List() | ast.Call(func=ast.Name(id="cross")):
                return True
            case ast.UnaryOp(operand=operand):
                return self.is_vector(operand)
            case ast.BinOp(op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div()):
                sums = (ast.Add, ast.Sub)
                kind = sums if isinstance(node.op, sums) else (ast.Mult, ast.Div)
                return any(self.is_vector(operand) for _, operand in chain(node, kind))
            case _:
                return False

    def vector(self, node: ast.expr, depth: int) -> MatrixExpr:
        """The value of a `node` that is to be a vector."""
        if depth > MAX_DEPTH:
            raise self.error(TOO_DEEP, node)
        match node:
            case ast.Name():
                return self.names[node.id]
            case ast.List():
                if len(node.elts) not in _SIZES:
                    raise self.error("a vector has 2, 3 or 4 components", node)
                return constant([self.scalars.read(part, depth + 1) for part in node.elts])
            case ast.UnaryOp(op=op, operand=operand):
                value = self.vector(operand, depth + 1)
                return value if isinstance(op, ast.UAdd) else -value
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return self.sum(node, depth)
            case ast.BinOp():
                return self.product(node, depth)
            case ast.Call():
                return cross(*self.pair(node, depth, "cross"))
            case _:
                raise self.error("this is not part of a formula", node)

    def sum(self, node: ast.BinOp, depth: int) -> MatrixExpr:
        """A chain of vectors ``u + v - w``."""
        total: MatrixExpr | None = None
        for operator, operand in chain(node, (ast.Add, ast.Sub)):
            if not self.is_vector(operand):
                raise self.error("a number cannot be added to a vector", operand)
            value = self.vector(operand, depth + 1)
            signed = -value if isinstance(operator, ast.Sub) else value
            if total is not None and total.shape != signed.shape:
                raise self.error("vectors of different sizes cannot be added", operand)
            total = signed if total is None else total + signed
        return total

    def product(self, node: ast.BinOp, depth: int) -> MatrixExpr:
        """A chain of numbers, tensors and one vector, ``2*I*omega/m``."""
        number, tensors, vector = sympy.S.One, list[MatrixExpr](), None
        for operator, operand in chain(node, (ast.Mult, ast.Div)):
            divides = isinstance(operator, ast.Div)
            tensor = self.tensor(operand)
            if divides and (tensor is not None or self.is_vector(operand)):
                raise self.error("nothing can be divided by a vector or a tensor", operand)
            if tensor is not None:
                if vector is not None:
                    raise self.error("a tensor stands before the vector it multiplies", operand)
                tensors.append(tensor)
            elif self.is_vector(operand):
                if vector is not None:
                    raise self.error("two vectors are multiplied by dot or cross", operand)
                vector = self.vector(operand, depth + 1)
            else:
                value = self.scalars.read(operand, depth + 1)
                if divides and value.is_zero:
                    raise self.error("division by zero", operand)
                number = number / value if divides else number * value
        for tensor in reversed(tensors):
            vector = tensor * vector
        return number * vector

    def tensor(self, node: ast.expr) -> MatrixExpr | None:
        """A named tensor, perhaps with a sign; None for anything else."""
        match node:
            case ast.UnaryOp(op=ast.USub() | ast.UAdd() as op, operand=operand):
                value = self.tensor(operand)
                return -value if value is not None and isinstance(op, ast.USub) else value
            case ast.Name(id=name) if isinstance(self.names.get(name), Diagonal):
                return self.names[name]
            case _:
                return None

    def dot(self, node: ast.Call, depth: int) -> sympy.Expr:
        """The scalar product that a call means."""
        return dot(*self.pair(node, depth, "dot"))

    def pair(self, node: ast.Call, depth: int, name: str) -> tuple[MatrixExpr, MatrixExpr]:
        """The two vectors that a product multiplies."""
        if len(node.args) != 2 or node.keywords:
            raise self.error(f"{name} takes 2 vectors", node)
        for part in node.args:
            if not self.is_vector(part):
                raise self.error(f"{name} multiplies vectors, and this is none", part)
        left, right = (self.vector(part, depth + 1) for part in node.args)
        if left.shape != right.shape:
            raise self.error("vectors of different sizes cannot be multiplied", node)
        if name == "cross" and left.shape[0] != _SPACE:
            raise self.error("only vectors of 3 components have a vector product", node)
        return left, right
