r"""The theorem on energy, as identities between the formulas of a system.

The rates of velocities u solve linear equations A u̇ = h + Cᵀλ, C u̇ = b.  Let F be a function of
the state, and F' and f' the derivatives of F and of conditions f along the field in which u̇ is
replaced by free symbols a.  If

    F' = uᵀ(A a − h),    C u = κ f,    f' = C a − b,

and for the rates u̇ of the system A u̇ − h − Cᵀλ = 0 and C u̇ − b = 0, identically, then
Ḟ = uᵀCᵀλ = Σ κ_μ λ_μ f_μ and ḟ = 0: F is constant where the conditions f hold, and they are kept.
The first line says that F is the energy u ∂L/∂u − L of a Lagrangian without time, and that the
constraints are homogeneous in the velocities: Theorem 1 (§3.1).  The second holds whatever A, h, C
and b are, so that their definitions need not be written out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.system import System, Theorem

Row = tuple[sp.Expr, ...]


@dataclass(frozen=True)
class PowerTheorem(Theorem):
    """The linear equations of the rates of a system, by which its energy is constant.

    Attributes
    ----------
    velocities : tuple of Symbol
        u, in the state.
    mass, slopes : tuple of rows
        A, and C, a row for each multiplier.
    force, drift, multipliers : tuple of Expr
        h, b and λ.
    constraints : tuple of Expr
        f, among the relations of the system.
    degrees : tuple of Integer
        κ, the degree in the velocities of each.
    positions : tuple of (Expr, Expr)
        The other relations of the system, and their rates: one of f, or zero.
    definitions : tuple of (Symbol, Expr)
        Of names beside those of the system that A, h, C, b and λ use.
    opaque : tuple of Symbol
        Names of definitions that the identities of the rates take as independent variables.
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
