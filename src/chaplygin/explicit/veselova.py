"""The Veselova system without a field, separated in sphero-conical coordinates.

The roots z₁, z₂ of Σ γᵢ²/(Iᵢ − z) = 0 give γᵢ² = (Iᵢ − z₁)(Iᵢ − z₂)/Πᵢ with Πᵢ = ∏_{j≠i}(Iᵢ − Iⱼ).
With dt = (γ, I⁻¹γ)^(1/2) dτ they move by

    zₖ′² (z₁ − z₂)² = 4 zₖ p(zₖ) (2hzₖ − F)/det I,        p(z) = ∏(Iᵢ − z),

where h is the energy and F the square of the horizontal momentum Iω×γ, which stays in space.
F = 0 is rest: then Iω is parallel to γ, and 2h = (Iω, ω) = 0 with it.
"""

from __future__ import annotations

import sympy as sp

from ..systems import from_catalogue
from ..systems.veselova import DENSITY, DET_I, KINETIC, A, F, I, gamma, h, omega
from ..vectors import cross, dot, normed
from .poles import gaps
from .separable import Separable, nu, nuprime
from .stated import with_laws

__all__ = ["veselova"]


def veselova() -> Separable:
    """The Veselova system with any three different principal moments."""
    clock = sp.sqrt(dot(nu, A * nu))
    return with_laws(
        Separable(
            name="veselova",
            title="Veselova system without a field",
            system=from_catalogue("veselova"),
            constants=((h, KINETIC), (F, normed(cross(I * omega, gamma)))),
            direction=gamma,
            turning=DENSITY * cross(gamma, omega),
            poles=I.symbols,
            weights=tuple(1 / gap for gap in gaps(I.symbols)),
            leading=-8 * h / DET_I,
            roots=(*I.symbols, sp.S.Zero, F / (2 * h)),
            speeds=(sp.S.Zero, sp.S.One),
            clock=clock,
            state=((omega, cross(nuprime, nu) / clock), (gamma, nu)),
            fixed=(gamma, cross(I * omega, gamma)),
            source="Remark 16, (6.4)",
        )
    )
