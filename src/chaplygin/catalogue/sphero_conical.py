"""Sphero-conical coordinates: the roots u > v of Σ Γᵢ²/(Iᵢ − z) = 0 on the sphere Γ² = 1."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from ..core.vectors import Diagonal, dot, real_symbol

I = Diagonal("I")
u, v, Delta = (real_symbol(s) for s in ("u", "v", "Delta"))


def sphero_conical_coordinates(normal: MatrixExpr) -> dict[sp.Symbol, sp.Expr]:
    """u and v, and before them their distance, for a unit vector in body axes."""
    total = sp.Add(*I.symbols) - dot(normal, I * normal)
    product = sp.Mul(*I.symbols) * dot(normal, I**-1 * normal)
    return {
        Delta: sp.sqrt(total**2 - 4 * product),
        u: (total + Delta) / 2,
        v: (total - Delta) / 2,
    }


def cubic(z: sp.Expr) -> sp.Expr:
    """A(z) = (I₁ − z)(I₂ − z)(I₃ − z)."""
    return sp.Mul(*(s - z for s in I.symbols))
