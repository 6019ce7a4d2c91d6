r"""The energy theorem as identities between the formulas of a system.

The accelerations u̇ solve linear equations A u̇ = h + Cᵀλ, C u̇ = b. Let F be a function of the
state, and let F' and f' be the derivatives of F and of the constraints f along the vector field in
which u̇ is replaced by free symbols a. If

    F' = uᵀ(A a − h),    C u = κ f,    f' = C a − b,

and if A u̇ − h − Cᵀλ = 0 and C u̇ − b = 0 identically for the accelerations u̇ of the system, then
Ḟ = uᵀCᵀλ = Σ κ_μ λ_μ f_μ and ḟ = 0: F is constant where f = 0, and the constraints are preserved.
The first line states that F is the energy u ∂L/∂u − L of a time-independent Lagrangian and that
the constraints are homogeneous in the velocities: Theorem 1 (§3.1). The second line holds for any
A, h, C and b, so that their definitions need not be expanded.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.system import System, Theorem

Row = tuple[sp.Expr, ...]


@dataclass(frozen=True)
class PowerTheorem(Theorem):
    """The linear equations of the accelerations that imply conservation of energy.

    Attributes
    ----------
    velocities : tuple of Symbol
        The velocities u, part of the state.
    mass, slopes : tuple of rows
        The matrices A and C; C has one row for each multiplier.
    force, drift, multipliers : tuple of Expr
        h, b and λ.
    constraints : tuple of Expr
        The constraints f, which are relations of the system.
    degrees : tuple of Integer
        The degrees κ of the constraints in the velocities.
    positions : tuple of (Expr, Expr)
        The other relations of the system with their rates: a constraint, or zero.
    definitions : tuple of (Symbol, Expr)
        Additional definitions used in A, h, C, b and λ.
    opaque : tuple of Symbol
        Defined names that the identities of the accelerations treat as independent variables.
    """

    laws: tuple[str, ...] = ()
    words: str = "Theorem 1, from the equations that the rates solve (docs/proofs.md)"
    identities: Callable[[], tuple[System, ...]] = tuple
    velocities: tuple[sp.Symbol, ...] = ()
    mass: tuple[Row, ...] = ()
    force: Row = ()
    drift: Row = ()
    slopes: tuple[Row, ...] = ()
    multipliers: Row = ()
    constraints: Row = ()
    degrees: tuple[sp.Integer, ...] = ()
    positions: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    definitions: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    opaque: tuple[sp.Symbol, ...] = ()
