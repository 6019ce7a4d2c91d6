"""The Neumann system on its curve of genus two (§6.3, Theorem 8).

In sphero-conical coordinates z₁, z₂, the roots of Σ Γᵢ²/(Iᵢ − z) = 0, a motion with the integrals
2h = M² + c(Γ, IΓ) and 2f = (M, IM) − c det I (Γ, I⁻¹Γ) has

    Σ dz/y = 0,   Σ z dz/y = dt,   y² = −4 ∏(z − Iᵢ) (cz² + (2h − c tr I) z − 2f).

One root of the quadratic lies between z₁ and z₂, so both are real.  Without a potential (c = 0)
the point goes around a great circle and the curve has genus one.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.vectors import cross

from ...catalogue import from_catalogue
from ...catalogue.e3 import Gamma, I, M
from ...catalogue.fixed_point import clebsch, neumann
from ...catalogue.fixed_point.neumann import c, f, h
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import with_laws


def quadratic(first: sp.Expr, second: sp.Expr, third: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The two roots of first z² + second z + third."""
    root = sp.sqrt(second**2 - 4 * first * third)
    return (-second - root) / (2 * first), (-second + root) / (2 * first)


def neumann_system() -> SeparatedSystem:
    """The Neumann system with any three different I and c ≠ 0; τ = t and ν = Γ."""
    return with_laws(
        SeparatedSystem(
            name="neumann",
            title="Neumann system",
            system=from_catalogue("neumann"),
            constants=((h, clebsch.FIRST), (f, neumann.SECOND)),
            direction=Gamma,
            turning=cross(Gamma, M),
            poles=I.symbols,
            weights=tuple(1 / gap for gap in gaps(I.symbols)),
            leading=-4 * c,
            roots=(*I.symbols, *quadratic(c, 2 * h - c * sp.Add(*I.symbols), -2 * f)),
            speeds=(sp.S.Zero, sp.S.One),
            time_rescaling=sp.S.One,
            state=((M, cross(nuprime, nu)), (Gamma, nu)),
            source="Remark 16",
        )
    )
