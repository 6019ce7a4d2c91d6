"""The Hamiltonian system (6.13) on e(3), which contains the Veselova system (6.12)."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.system import System
from flowlanes.system.vectors import constant, dot, norm_squared, real_symbol, to_components

from ..e3 import Gamma, I, M, e3_system, inertia_parameters
from . import neumann
from .neumann import c

I_1, I_2, I_3 = I.symbols
HALF = sp.Rational(1, 2)

#: The two terms of (6.13); the first is (6.12) without a potential.
FIRST = HALF * norm_squared(M) * dot(Gamma, I * Gamma)
SECOND = HALF * (dot(M, I * M) * dot(Gamma, I * Gamma) - dot(M, I * Gamma) ** 2)

#: I^(1/2) and 1/ρ_ω = (Γ, IΓ)^(1/2).
ROOT = constant(sp.diag(*(sp.sqrt(s) for s in I.symbols)))
LENGTH = sp.sqrt(dot(Gamma, I * Gamma))


def in_potential(potential: sp.Expr, moments: tuple[float, float, float]) -> System:
    """(6.12): H = ½(Γ, IΓ)M² + U(γ), with γ = (Γ, IΓ)^(−1/2) I^(1/2) Γ.

    Parameters
    ----------
    potential : sympy.Expr
        U, as a formula in ``gamma_1``, ``gamma_2``, ``gamma_3`` (body axes).
    moments : 3 floats
        Defaults of the parameters I_1, I_2, I_3.
    """
    normal = to_components(ROOT * to_components(Gamma)) / to_components(LENGTH)
    names = [real_symbol(f"gamma_{i}") for i in (1, 2, 3)]
    here = potential.subs(dict(zip(names, normal, strict=True)), simultaneous=True)
    return e3_system(
        "veselova-on-e3",
        "Veselova system on e(3)",
        FIRST + here,
        inertia_parameters(moments),
        level=(dot(M, Gamma),),
        source="§6.3, (6.11), (6.12)",
        summary="The Veselova system in a potential, as a Hamiltonian system on e(3).",
    )


def to_clebsch(target: System, sign: int = 1) -> Isomorphism:
    """Proposition 6: L = I^(−1/2) M and s = (Γ, IΓ)^(−1/2) I^(1/2) Γ move as the Clebsch case.

    Their time is kτ with k = `sign` √det I.
    """
    inverse = constant(sp.diag(*(1 / sp.sqrt(s) for s in I.symbols)))
    return Isomorphism(
        "clebsch",
        target,
        {
            M: inverse * M,
            Gamma: ROOT * Gamma / LENGTH,
        },
        sign * sp.sqrt(I_1 * I_2 * I_3),
        {c: norm_squared(M) * dot(Gamma, I * Gamma) / (I_1 * I_2 * I_3)},
        "Clebsch case with c = M²(Γ, IΓ)/det I",
        onto=(dot(M, Gamma), neumann.SECOND),
        source="Proposition 6",
    )
