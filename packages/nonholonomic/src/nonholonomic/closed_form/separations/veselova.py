"""The Veselova system without a field, separated in sphero-conical coordinates.

The roots z₁, z₂ of Σ γᵢ²/(Iᵢ − z) = 0 give γᵢ² = (Iᵢ − z₁)(Iᵢ − z₂)/Πᵢ with Πᵢ = ∏_{j≠i}(Iᵢ − Iⱼ).
With dt = (γ, I⁻¹γ)^(1/2) dτ they move by

    zₖ′² (z₁ − z₂)² = 4 zₖ p(zₖ) (2hzₖ − F)/det I,        p(z) = ∏(Iᵢ − z),

where h is the energy and F the square of the horizontal momentum Iω×γ, which is fixed in space.  F
= 0 is rest: then Iω is parallel to γ, and therefore 2h = (Iω, ω) = 0.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared

from ...catalogue import from_catalogue
from ...catalogue.fixed_point.veselova import A, F, I, gamma, h, omega
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import with_laws


def veselova() -> SeparatedSystem:
    """The Veselova system with any three different principal moments."""
    return veselova_separation(
        "veselova", "Veselova system without a field", I, I.symbols, "Remark 16, (6.4)"
    )


def veselova_separation(
    name: str, title: str, tensor: Diagonal, moments: tuple[sp.Expr, ...], source: str
) -> SeparatedSystem:
    """The separation of a catalogue system that moves as the Veselova system.

    Parameters
    ----------
    name, title : str
        Name and title of the system; its state is ω, γ, and its definition A the inverse of
        `tensor`.
    tensor : Diagonal
        The tensor that takes the role of I, as the system names it.
    moments : three formulas
        Its diagonal, in the parameters.
    """
    clock = sp.sqrt(dot(nu, A * nu))
    return with_laws(
        SeparatedSystem(
            name=name,
            title=title,
            system=from_catalogue(name),
            constants=(
                (h, dot(tensor * omega, omega) / 2),
                (F, norm_squared(cross(tensor * omega, gamma))),
            ),
            direction=gamma,
            turning=sp.sqrt(dot(gamma, A * gamma)) * cross(gamma, omega),
            poles=moments,
            weights=tuple(1 / gap for gap in gaps(moments)),
            leading=-8 * h / sp.Mul(*moments),
            roots=(*moments, sp.S.Zero, F / (2 * h)),
            speeds=(sp.S.Zero, sp.S.One),
            time_rescaling=clock,
            state=((omega, cross(nuprime, nu) / clock), (gamma, nu)),
            fixed=(gamma, cross(tensor * omega, gamma)),
            source=source,
        )
    )
