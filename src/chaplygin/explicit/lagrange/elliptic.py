"""u̇² = a cubic polynomial: u as an elliptic function of the time.

With roots u₁ < u₂ < u₃ and a positive leading coefficient λ, between u₁ and u₂,

    u = u₁ + (u₂ − u₁) sn²(wt, k),    w = ½√(λ(u₃ − u₁)),    k² = (u₂ − u₁)/(u₃ − u₁),

t = 0 being at u₁.  The functions are computed in balls by theta functions of the nome, so that no
integral is inverted.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import acb

__all__ = ["Elliptic"]


@dataclass(frozen=True)
class Elliptic:
    """The oscillation between the two lower roots of a cubic.

    Attributes
    ----------
    lead : flint.arb
        λ.
    first, second, third : arb
        u₁ < u₂ < u₃.
    """

    lead: Any
    first: Any
    second: Any
    third: Any

    @property
    def modulus(self) -> Any:
        """k²."""
        return (self.second - self.first) / (self.third - self.first)

    @property
    def frequency(self) -> Any:
        """w."""
        return (self.lead * (self.third - self.first)).sqrt() / 2

    @cached_property
    def quarter(self) -> Any:
        """K(k)."""
        return acb(self.modulus).elliptic_k().real

    @property
    def period(self) -> Any:
        """2K/w."""
        return 2 * self.quarter / self.frequency

    @cached_property
    def tau(self) -> Any:
        """iK′/K."""
        other = acb((self.third - self.second) / (self.third - self.first)).elliptic_k().real
        return acb(0, other / self.quarter)

    def at(self, time: Any) -> Any:
        """u at a time (arb) counted from u₁: sn = (θ₃/θ₂)(θ₁(v)/θ₄(v)), v = wt/2K."""
        _, second, third, _ = acb.modular_theta(acb(0), self.tau)
        place = self.frequency * time / (2 * self.quarter)
        whole = place.mid().floor()
        first, _, _, fourth = acb.modular_theta(acb(place - whole), self.tau)
        ratio = (third * first / (second * fourth)).real
        return self.first + (self.second - self.first) * ratio * ratio
