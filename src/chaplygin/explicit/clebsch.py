"""The Clebsch case at zero area constant on the curve of the Neumann system (§6.3, (6.14)).

Its Hamiltonian α H₁ + β H₂ combines two functions in involution, those of the Neumann system
(H₁ = h) and of the Bruns problem (H₂ = f).  Both have the separated momenta y/(4A(z)), whose
derivatives by h and f give

    Σ dz/y = −β dt,   Σ z dz/y = α dt

on one and the same curve.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ..systems import from_catalogue
from ..systems.clebsch import alpha, beta
from ..systems.e3 import Gamma, I, M
from ..vectors import constant, cross, dot
from .neumann import neumann_system
from .separable import Separable, nu, nuprime
from .stated import with_laws

__all__ = ["clebsch_case"]

_widths = tuple(alpha + beta * s for s in I.symbols)
#: B = α + βI, with Γ̇ = Γ×BM, and its adjugate.
B = constant(sp.diag(*_widths))
ADJUGATE = constant(sp.diag(*(sp.Mul(*_widths[:i], *_widths[i + 1 :]) for i in range(3))))


def clebsch_case() -> Separable:
    """The Clebsch case (6.14) at (M, Γ) = 0, with τ = t and ν = Γ; α = 0 is the Bruns problem.

    M = Bν′×ν/(ν, adj(B) ν); the denominator is (α + βz₁)(α + βz₂), without zeros where B is
    definite.
    """
    return with_laws(
        replace(
            neumann_system(),
            name="clebsch",
            title="Clebsch case at zero area constant",
            system=from_catalogue("clebsch"),
            level=(dot(M, Gamma),),
            turning=cross(Gamma, B * M),
            speeds=(-beta, alpha),
            state=((M, cross(B * nuprime, nu) / dot(nu, ADJUGATE * nu)), (Gamma, nu)),
            source="Proposition 6",
        )
    )
