"""Poisson brackets in print notation, with indices if the components follow a pattern."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product
from typing import TypeAlias

import sympy as sp

from ..system.laws import PoissonStructure
from ..system.named_formulas import flat
from ..system.system import Name, System
from ..system.vectors import Vector, real_symbol
from .formula import latex, text
from .notation import LATEX, UNICODE, Notation

#: A formatted left side, and a formula or formatted right side.
Side: TypeAlias = tuple[str, sp.Basic | str]

#: The alternating tensor and the unit tensor in index notation.
_TENSORS = {UNICODE: ("εᵢⱼₖ", "δᵢⱼ"), LATEX: (r"\varepsilon_{ijk}", r"\delta_{ij}")}

#: Maximum number of operations of an entry that is expanded for comparison.
_MOST_OPERATIONS = 400


def curly_brackets(inner: str, notation: Notation) -> str:
    """{inner}, in curly brackets of a notation."""
    return f"{{{inner}}}" if notation is UNICODE else rf"\left\{{{inner}\right\}}"


def bracket_sides(law: PoissonStructure, system: System, notation: Notation) -> list[Side]:
    """The non-zero brackets, then the Casimir functions and the rank."""
    write = text if notation is UNICODE else latex
    matrix = law.scalar.matrix
    lines: list[Side] = []
    for index, (one, rows) in enumerate(system.slices):
        for other, columns in system.slices[index:]:
            block = matrix[rows, columns]
            if any(entry != 0 for entry in block):
                lines += _block(one, other, block, system, notation)
    words = []
    if law.casimirs:
        words.append(f"Casimir functions {', '.join(map(write, law.casimirs))}")
    if law.rank is not None:
        words.append(f"rank {law.rank}")
    if words and notation is UNICODE:
        lines.append(("", "; ".join(words)))
    elif words:
        listed = r",\; ".join(map(write, law.casimirs))
        lines.append(("", rf"\text{{Casimir functions: }} {listed}" if law.casimirs else ""))
        if law.rank is not None:
            lines[-1] = ("", rf"{lines[-1][1]}{',' if listed else ''}\; \text{{rank }} {law.rank}")
    return lines


def _block(
    one: Name, other: Name, block: sp.MatrixBase, system: System, notation: Notation
) -> list[Side]:
    """The brackets of two variables, with indices if they follow a pattern."""
    write = text if notation is UNICODE else latex
    epsilon, delta = _TENSORS[notation]
    indexed = curly_brackets(
        f"{_component(one, 'i', write)}, {_component(other, 'j', write)}", notation
    )
    if block.shape == (3, 3) and _skew(block):
        common, twist = _common_factor((block[1, 2], block[2, 0], block[0, 1]))
        head = epsilon if common == 1 else f"{_bracketed_sum(common, notation)} {epsilon}"
        sums = _combination(twist, system)
        if sums is None:
            vector = sp.ImmutableDenseMatrix(twist)
            return [(indexed, f"{head} {write(real_symbol('w_k'))}"), (write(Vector("w")), vector)]
        shown, minus = _bracketed_sum(sums("k"), notation), notation.minus
        sign = minus if shown.startswith(minus) else ""
        return [(indexed, f"{sign}{head} {shown.removeprefix(minus)}")]
    if block.shape == (3, 3) and block.is_diagonal() and len(set(block.diagonal())) == 1:
        factor = block[0, 0]
        return [(indexed, delta if factor == 1 else f"{delta} {_bracketed_sum(factor, notation)}")]
    if block.shape in ((1, 3), (3, 1)):
        sums = _combination(tuple(block), system)
        if sums is not None:
            index = "j" if block.shape == (1, 3) else "i"
            return [(indexed, sums(index))]
    if block.shape == (3, 3) and one != other:
        common, entries = _common_factor(tuple(block))
        body = "B_{ij}" if notation is LATEX else "Bᵢⱼ"
        head = body if common == 1 else f"{_bracketed_sum(common, notation)} {body}"
        return [(indexed, head), (write(Vector("B")), sp.ImmutableDenseMatrix(3, 3, entries))]
    return _entries(one, other, block, notation)


def _bracketed_sum(factor: sp.Expr, notation: Notation) -> str:
    """A factor, in brackets if it is a sum."""
    written = (text if notation is UNICODE else latex)(factor)
    return notation.brackets(written) if isinstance(factor, sp.Add) else written


def _common_factor(entries: tuple[sp.Expr, ...]) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
    """The common factor of the nonzero entries, and the entries over it."""
    present = [entry for entry in entries if entry != 0]
    shared = [
        factor
        for factor in sp.Mul.make_args(present[0])
        if factor != -1 and all(factor in sp.Mul.make_args(other) for other in present[1:])
    ]
    common = sp.Mul(*shared)
    return common, tuple(entry / common for entry in entries)


def _component(name: Name, index: str, write: Callable[[sp.Basic], str]) -> str:
    return write(name) if isinstance(name, sp.Symbol) else write(real_symbol(f"{name}_{index}"))


def _entries(one: Name, other: Name, block: sp.MatrixBase, notation: Notation) -> list[Side]:
    write = text if notation is UNICODE else latex
    lines: list[Side] = []
    for (i, left), (j, right) in product(enumerate(flat([one])), enumerate(flat([other]))):
        if block[i, j] != 0 and (one != other or i < j):
            lines.append((curly_brackets(f"{write(left)}, {write(right)}", notation), block[i, j]))
    return lines


def _vanishes(formula: sp.Expr) -> bool:
    if formula == 0:
        return True
    return bool(sp.count_ops(formula) < _MOST_OPERATIONS and sp.expand(formula) == 0)


def _skew(block: sp.MatrixBase) -> bool:
    return all(_vanishes(block[i, j] + block[j, i]) for i in range(3) for j in range(i, 3))


def _combination(triple: tuple[sp.Expr, ...], system: System) -> Callable[[str], sp.Expr] | None:
    """The combination of state vectors with these components, by its index; or None."""
    vectors = [v for v in system.state if isinstance(v, Vector) and len(v.symbols) == 3]
    choices = [list(_taken_out(term, vectors)) for term in _terms(triple[0])]
    for choice in product(*choices):
        values = [sp.Add(*(c * v.symbols[k] for c, v in choice)) for k in range(3)]
        if all(_vanishes(x - y) for x, y in zip(triple, values, strict=True)):

            def component(
                index: str, combination: tuple[tuple[sp.Expr, Vector], ...] = choice
            ) -> sp.Expr:
                return sp.Add(*(c * real_symbol(f"{v}_{index}") for c, v in combination))

            return component
    return None


def _terms(formula: sp.Expr) -> list[sp.Expr]:
    """The terms of a sum, or of the only sum among the factors of a product."""
    sums = [factor for factor in sp.Mul.make_args(formula) if isinstance(factor, sp.Add)]
    if len(sums) != 1:
        return list(sp.Add.make_args(formula))
    cofactor = formula / sums[0]
    return [cofactor * term for term in sums[0].args]


def _taken_out(term: sp.Expr, vectors: list[Vector]) -> Iterator[tuple[sp.Expr, Vector]]:
    """All ways to write a term as a multiple of the first component of a vector."""
    for vector in vectors:
        if vector.symbols[0] in sp.Mul.make_args(term):
            yield term / vector.symbols[0], vector
