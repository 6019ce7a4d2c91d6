"""Formulas with vectors: sums, products with scalars and tensors, dot and cross products.

The type of each part is determined from the text alone, before any evaluation; scalars are parsed
by :class:`~flowlanes.parsing.scalar.Scalars`.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Literal, TypeAlias

import sympy
from sympy.matrices.expressions import MatrixExpr

from ..errors import InputError
from ..system.laws import Rate
from ..system.vector_operators import gradient, outer
from ..system.vectors import Diagonal, Symmetric, Vector, constant, cross, dot, identity
from .grammar import MAX_DEPTH
from .scalar import Scalars
from .syntax import TOO_DEEP, Source, chain

NamedQuantity: TypeAlias = sympy.Symbol | Vector | Diagonal | Symmetric
Formula: TypeAlias = sympy.Expr | MatrixExpr

#: Type of a part of a formula that is not a number.
Kind: TypeAlias = Literal["vector", "tensor"]

_CALLS: Mapping[str, Kind] = MappingProxyType(
    {
        "cross": "vector",
        "gradient": "vector",
        "diagonal": "tensor",
        "identity": "tensor",
        "outer": "tensor",
    }
)
_PRODUCTS = MappingProxyType({"cross": "vector product", "outer": "dyadic product"})
_SPACE = 3
_SIZES = (2, 3, 4)


@dataclass(frozen=True)
class Vectors:
    """Converter from the syntax tree of one formula to a scalar or a vector.

    Parameters
    ----------
    source : Source
    symbols : mapping of str to Symbol
        The scalars that the formula may contain, including components of vectors.
    names : mapping of str to Symbol, Vector or Diagonal
        All named quantities.
    definitions : mapping of str to formula
        Named formulas, of which a gradient may be taken.
    """

    source: Source
    symbols: Mapping[str, sympy.Expr]
    names: Mapping[str, NamedQuantity]

    definitions: Mapping[str, sympy.Basic] = field(default_factory=dict)

    @cached_property
    def scalars(self) -> Scalars:
        """The reader for scalar parts."""
        vectors = {n for n, value in self.names.items() if not isinstance(value, sympy.Symbol)}
        products = {"dot": self.dot, "Rate": self.rate}
        return Scalars(self.source, self.symbols, vectors, products)

    def error(self, message: str, node: ast.expr) -> InputError:
        """An error message that points at the first character of `node`."""
        return self.source.at(message, node)

    def read(self, node: ast.expr, depth: int) -> Formula:
        """The value of `node`."""
        if depth > MAX_DEPTH:
            raise self.error(TOO_DEEP, node)
        if isinstance(node, ast.Name) or self.kind(node) is None:
            # A bare tensor is most likely meant as a number; the scalar parser reports it.
            return (
                self.vector(node, depth) if self.is_vector(node) else self.scalars.read(node, depth)
            )
        return self.vector(node, depth) if self.is_vector(node) else self.tensor(node, depth)

    def kind(self, node: ast.expr) -> Kind | None:
        """Type of `node` by its syntax, valid or not; None for a number."""
        match node:
            case ast.Name(id=name):
                named = self.names.get(name)
                if isinstance(named, Vector):
                    return "vector"
                return "tensor" if named is not None and named.is_Matrix else None
            case ast.List(elts=elements):
                rows = any(isinstance(part, ast.List) for part in elements)
                return "tensor" if rows else "vector"
            case ast.Call(func=ast.Name(id=name)):
                return _CALLS.get(name)
            case ast.UnaryOp(operand=operand):
                return self.kind(operand)
            case ast.BinOp(left=base, op=ast.Pow()):
                return "tensor" if self.kind(base) == "tensor" else None
            case ast.BinOp(op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div()):
                sums = (ast.Add, ast.Sub)
                operators = sums if isinstance(node.op, sums) else (ast.Mult, ast.Div)
                kinds = {self.kind(operand) for _, operand in chain(node, operators)}
                return "vector" if "vector" in kinds else "tensor" if "tensor" in kinds else None
            case _:
                return None

    def is_vector(self, node: ast.expr) -> bool:
        """True if `node` is a vector by its syntax, valid or not."""
        return self.kind(node) == "vector"

    def vector(self, node: ast.expr, depth: int) -> MatrixExpr:
        """The value of a vector `node`."""
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
            case ast.BinOp(op=ast.Mult() | ast.Div()):
                return self.product(node, depth)
            case ast.Call(func=ast.Name(id="gradient")):
                return self.gradient(node, depth)
            case ast.Call():
                return cross(*self.pair(node, depth, "cross"))
            case _:
                raise self.error("this is not part of a formula", node)

    def tensor(self, node: ast.expr, depth: int) -> MatrixExpr:
        """The value of a tensor `node`."""
        if depth > MAX_DEPTH:
            raise self.error(TOO_DEEP, node)
        match node:
            case ast.Name():
                return self.names[node.id]
            case ast.List(elts=rows):
                lists = [row.elts for row in rows if isinstance(row, ast.List)]
                if len(lists) < len(rows) or len(set(map(len, lists))) > 1:
                    raise self.error("the rows of a tensor have one length", node)
                return constant(
                    [[self.scalars.read(part, depth + 1) for part in row] for row in lists]
                )
            case ast.UnaryOp(op=op, operand=operand):
                value = self.tensor(operand, depth + 1)
                return value if isinstance(op, ast.UAdd) else -value
            case ast.BinOp(left=base, op=ast.Pow(), right=exponent):
                if not _is_minus_one(exponent):
                    raise self.error("the only power of a tensor is its inverse, **-1", exponent)
                return self.tensor(base, depth + 1) ** -1
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return self.sum(node, depth)
            case ast.BinOp():
                return self.product(node, depth)
            case ast.Call(func=ast.Name(id="identity"), args=[]):
                return identity
            case ast.Call(func=ast.Name(id="diagonal"), args=[_, _, _]):
                entries = [self.scalars.read(part, depth + 1) for part in node.args]
                return constant(sympy.diag(*entries))
            case ast.Call(func=ast.Name(id="outer")):
                return outer(*self.pair(node, depth, "outer"))
            case _:
                raise self.error("this is not part of a formula", node)

    def sum(self, node: ast.BinOp, depth: int) -> MatrixExpr:
        """The value of a chain of vectors or of tensors, ``u + v - w``."""
        kind = self.kind(node)
        read = self.vector if kind == "vector" else self.tensor
        total: MatrixExpr | None = None
        for operator, operand in chain(node, (ast.Add, ast.Sub)):
            other = self.kind(operand)
            if other != kind:
                raise self.error(f"a {other or 'number'} cannot be added to a {kind}", operand)
            value = read(operand, depth + 1)
            signed = -value if isinstance(operator, ast.Sub) else value
            if total is not None and total.shape != signed.shape:
                raise self.error(f"{kind}s of different sizes cannot be added", operand)
            total = signed if total is None else total + signed
        return total

    def product(self, node: ast.BinOp, depth: int) -> MatrixExpr:
        """A chain of numbers, tensors and at most one vector, ``2*I*u/m``."""
        number, tensors, vector = sympy.S.One, list[MatrixExpr](), None
        for operator, operand in chain(node, (ast.Mult, ast.Div)):
            divides = isinstance(operator, ast.Div)
            kind = self.kind(operand)
            if divides and kind is not None:
                raise self.error("nothing can be divided by a vector or a tensor", operand)
            if kind == "tensor":
                if vector is not None:
                    raise self.error("a tensor stands before the vector it multiplies", operand)
                tensors.append(self.tensor(operand, depth + 1))
            elif kind == "vector":
                if vector is not None:
                    raise self.error("two vectors are multiplied by dot or cross", operand)
                vector = self.vector(operand, depth + 1)
            else:
                value = self.scalars.read(operand, depth + 1)
                if divides and value.is_zero:
                    raise self.error("division by zero", operand)
                number = number / value if divides else number * value
        # Tensors are applied from the right, so that each acts on a vector if there is one.
        whole = tensors.pop() if vector is None else vector
        for tensor in reversed(tensors):
            if tensor.shape[1] != whole.shape[0]:
                raise self.error("a tensor multiplies vectors of 3 components", node)
            whole = tensor * whole
        return number * whole

    def gradient(self, node: ast.Call, depth: int) -> MatrixExpr:
        """The gradient of a formula, or of a named definition, with respect to a vector."""
        if len(node.args) != 2 or node.keywords:
            raise self.error("gradient takes a formula and a vector", node)
        value, variable = node.args
        name = variable.id if isinstance(variable, ast.Name) else ""
        if not isinstance(vector := self.names.get(name), Vector):
            raise self.error("gradient is taken by a vector, and this is no name of one", variable)
        if isinstance(value, ast.Name) and value.id in self.definitions:
            return gradient(self.definitions[value.id], vector, value.id)
        return gradient(self.scalars.read(value, depth + 1), vector)

    def rate(self, node: ast.Call, depth: int) -> sympy.Expr:
        """The time derivative of a formula."""
        if len(node.args) != 1 or node.keywords:
            raise self.error("Rate takes 1 argument", node)
        return Rate(self.scalars.read(node.args[0], depth + 1))

    def dot(self, node: ast.Call, depth: int) -> sympy.Expr:
        """The value of a call of ``dot``."""
        return dot(*self.pair(node, depth, "dot"))

    def pair(self, node: ast.Call, depth: int, name: str) -> tuple[MatrixExpr, MatrixExpr]:
        """The two vector arguments of a product."""
        if len(node.args) != 2 or node.keywords:
            raise self.error(f"{name} takes 2 vectors", node)
        for part in node.args:
            if not self.is_vector(part):
                raise self.error(f"{name} multiplies vectors, and this is none", part)
        left, right = (self.vector(part, depth + 1) for part in node.args)
        if left.shape != right.shape:
            raise self.error("vectors of different sizes cannot be multiplied", node)
        if name != "dot" and left.shape[0] != _SPACE:
            raise self.error(f"only vectors of 3 components have a {_PRODUCTS[name]}", node)
        return left, right


def _is_minus_one(node: ast.expr) -> bool:
    match node:
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=1)):
            return True
        case _:
            return False
