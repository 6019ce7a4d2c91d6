"""Systems with unspecified functions, for the proof of general statements."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from flowlanes.arguments import NamedFormulas
from flowlanes.system.system import System


def unspecified_functions(names: str, *variables: sp.Symbol) -> tuple[sp.Expr, ...]:
    """Unspecified functions of the given variables, by name."""
    return tuple(sp.Function(name)(*variables) for name in names.split())


def gradient(function: sp.Expr, variables: Sequence[sp.Symbol]) -> sp.Matrix:
    """The column of partial derivatives."""
    return sp.Matrix([sp.diff(function, s) for s in variables])


def skew(variables: Sequence[sp.Symbol], name: str = "J") -> sp.Matrix:
    """A skew-symmetric matrix whose entries above the diagonal are unspecified functions."""
    size = len(variables)
    matrix = sp.zeros(size)
    for i in range(size):
        for j in range(i + 1, size):
            entry = sp.Function(f"{name}{i + 1}{j + 1}")(*variables)
            matrix[i, j], matrix[j, i] = entry, -entry
    return matrix


def fields(names: str, variables: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """A vector field with unspecified components; each name belongs to one variable."""
    return dict(zip(variables, unspecified_functions(names, *variables), strict=True))


def system(name: str, title: str, field: NamedFormulas, **more: Any) -> System:
    """A System that serves only for a proof."""
    return System(name=name, title=title, field=field, **more)


def bracket(matrix: sp.Matrix, f: sp.Expr, g: sp.Expr, variables: Sequence[sp.Symbol]) -> sp.Expr:
    """The bracket Σ J_ij ∂f/∂x_i ∂g/∂x_j."""
    return (gradient(f, variables).T * matrix * gradient(g, variables))[0, 0]


def hamiltonian(
    matrix: sp.Matrix,
    function: sp.Expr,
    variables: Sequence[sp.Symbol],
    multiplier: sp.Expr = sp.S.One,
) -> System:
    """The system ẋ = N J ∇H."""
    rates = multiplier * (matrix * gradient(function, variables))
    return system("hamiltonian", "ẋ = N J ∇H", dict(zip(variables, rates, strict=True)))
