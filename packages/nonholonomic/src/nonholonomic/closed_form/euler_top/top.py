"""A free rigid body with the values of its integrals, and the equation of its inclination.

With the momentum M of length G, m = M/G, and body axes in cyclic order such that m circles the
third one, u = m₃ is the cosine of the angle between that axis and M, which is fixed in space:

    m₁ = sin θ sin φ,    m₂ = sin θ cos φ,    u = m₃ = cos θ,
    u̇² = −G²(α₁ + a₁u²)(α₂ + a₂u²),    aᵢ = 1/Iᵢ − 1/I₃,    αᵢ = Σ mⱼ²(1/Iⱼ − 1/Iᵢ),
    ψ̇ = G(ε − u²/I₃)/(1 − u²),    φ̇ = Gu/I₃ − uψ̇,    ε = Σ mⱼ²/Iⱼ = 2h/G²,

where ψ is the angle of precession about M.  αᵢ is constant, as ε − 1/Iᵢ is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

from flint import acb, arb

from flowlanes.formulas.relative_zero import vanishes

from ..one_degree.divided_differences import Argument
from ..one_degree.uniformisation import Equation

Vector: TypeAlias = Sequence[arb]

AXES = 3


@dataclass(frozen=True)
class Top:
    """A body with the values of its integrals, axes in cyclic order; balls.

    Attributes
    ----------
    moments : three arb
        Different; the third one is the least or the greatest.
    direction : three arb
        m at time 0.
    G : arb
        Length of the momentum, positive.
    axis : int
        Number of the third axis among those of the body, from 0.
    separatrix : bool
        Whether 2h = G²/I for the moment I in the middle.
    """

    moments: Vector
    direction: Vector
    G: arb
    axis: int
    separatrix: bool

    @property
    def energy_ratio(self) -> arb:
        """ε = 2h/G²."""
        pairs = zip(self.direction, self.moments, strict=True)
        return sum((x * x / I for x, I in pairs), arb(0))

    @property
    def slopes(self) -> tuple[arb, arb]:
        """a₁ and a₂, which have the same sign."""
        first, second, third = self.moments
        return 1 / first - 1 / third, 1 / second - 1 / third

    @property
    def levels(self) -> tuple[arb, arb]:
        """α₁ and α₂; on a separatrix exactly zero for the middle moment."""
        first, second = (excess(self.direction, self.moments, i) for i in (0, 1))
        if self.separatrix:
            # The middle moment is the one closer to that of the axis.
            a, b = self.slopes
            return (arb(0), second) if abs(a) < abs(b) else (first, arb(0))
        return first, second

    @property
    def squares(self) -> tuple[arb, arb]:
        """The smallest and the largest value of u²."""
        first, second = (
            -level / slope for level, slope in zip(self.levels, self.slopes, strict=True)
        )
        return (first, second) if first < second else (second, first)

    @property
    def equation(self) -> Equation:
        """The equation of u."""
        (a, b), (first, second) = self.slopes, self.levels
        pace = 1 / (self.G * self.G)

        def numerator(u: Argument) -> Argument:
            return (first + a * u * u) * (-second - b * u * u)

        def denominator(u: Argument) -> arb:
            return pace

        return Equation(numerator, denominator, arb(-1), arb(1))

    @property
    def elliptic_parameters(self) -> tuple[arb, arb]:
        """k² and w in u = u₂ dn(wt, k), or in u = u₂ sech wt on a separatrix."""
        low, high = self.squares
        a, b = self.slopes
        return (high - low) / high, self.G * (a * b * high).sqrt()

    def rates(self, u: acb, rate: acb) -> list[acb]:
        """φ̇ and ψ̇."""
        square, third = u * u, self.moments[2]
        precession = self.G * (self.energy_ratio - square / third) / (1 - square)
        return [self.G * u / third - u * precession, precession]


def excess(direction: Vector, moments: Vector, i: int) -> arb:
    """αᵢ = 2h/G² − 1/Iᵢ, summed without cancellation if m is close to the axis i."""
    terms = (x * x * (1 / I - 1 / moments[i]) for x, I in zip(direction, moments, strict=True))
    return sum(terms, arb(0))


def top_of(moments: Vector, momentum: Vector, G: arb) -> Top:
    """The top with three different moments through a state that is not a rotation."""
    direction = [x / G for x in momentum]
    order = sorted(range(AXES), key=lambda i: moments[i].mid())
    middle = excess(direction, moments, order[1])
    size = 1 / moments[order[0]] - 1 / moments[order[2]]
    separatrix = vanishes(middle, size)
    axis = order[0] if middle > 0 and not separatrix else order[2]
    turned = [(axis + 1 + i) % AXES for i in range(AXES)]
    return Top([moments[i] for i in turned], [direction[i] for i in turned], G, axis, separatrix)
