"""The Clebsch case at zero area constant on Neumann's curve (§6.3, (6.14)).

Its Hamiltonian α H₁ + β H₂ combines two functions in involution, those of the Neumann system
(H₁ = h) and of the Bruns problem (H₂ = f).  Both have the separated momenta y/(4A(z)), whose
derivatives by h and f give

    Σ dz/y = −β dt,   Σ z dz/y = α dt

on one and the same curve.  So every such flow stays on the tori of the Neumann system, and M
follows from the derivative of Γ along Neumann's own flow there: Γ×M.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.vectors import dot, real_symbol

from ...catalogue import from_catalogue
from ...catalogue.e3 import Gamma, I, M
from ...catalogue.fixed_point.clebsch import alpha, beta
from ..genus_two.separation import SeparatedSystem, nu, nuprime
from ..genus_two.separation_laws import separation_laws
from .neumann import neumann_system

#: z₁ + z₂, z₁z₂ and their derivatives along Neumann's flow.
total, product, total_slope, product_slope = (
    real_symbol(f"separation_{s}") for s in ("S", "P", "Sprime", "Pprime")
)


def clebsch_case() -> SeparatedSystem:
    """The Clebsch case (6.14) at (M, Γ) = 0 with any α, β; α = 0 is the Bruns problem.

    τ = t and ν = Γ; ν′ is the derivative along Neumann's flow.
    """
    neumann = neumann_system()
    separable = replace(
        neumann,
        name="clebsch",
        title="Clebsch case at zero area constant",
        system=from_catalogue("clebsch"),
        level=(dot(M, Gamma),),
        speeds=(-beta, alpha),
        along=neumann.speeds,
        source="Proposition 6",
    )
    on_curve = separation_laws(replace(separable, speeds=neumann.speeds))
    laws = tuple(law for law in on_curve if law.name != "direction")
    return replace(separable, laws=(_flow(separable), *laws))


def _flow(separable: SeparatedSystem) -> Identity:
    """żₖ (b′ − a′z) = zₖ′ (b − az), where z is the other coordinate, for (a′, b′) = (0, 1)."""
    a, b = separable.speeds
    inverse = sp.Mul(*I.symbols) * I**-1
    return Identity(
        "flow",
        (
            dot(nu, nu) - 1,
            Rate(total) - b * total_slope + a * product_slope,
            Rate(product) - b * product_slope + a * (total * product_slope - product * total_slope),
        ),
        "both flows on one torus",
        {
            nu: separable.direction,
            nuprime: separable.turning,
            total: sp.Add(*I.symbols) - dot(nu, I * nu),
            product: dot(nu, inverse * nu),
            total_slope: -2 * dot(nu, I * nuprime),
            product_slope: 2 * dot(nu, inverse * nuprime),
        },
        level=separable.level,
        source=separable.source,
    )
