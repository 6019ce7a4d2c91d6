"""The lifted state of a rubber body of revolution from its angles, in balls and in arrays.

    γ = (sin θ sin φ, sin θ cos φ, cos θ)                  Q = R₃(ψ) R₁(θ) R₃(φ)
    ω = θ̇ (cos φ, −sin φ, 0) + ω₃ (−ctg θ sin φ, −ctg θ cos φ, 1),   (5.2)

so that (ω, γ) = 0 says ψ̇ = −φ̇ cos θ.  The centre of mass moves with

    ẋ + iẏ = −p(K/A + iθ̇ sin θ) e^{iψ}/sin θ.

Where the axis passes the vertical (K = 0) sin θ/2 or cos θ/2 changes its sign, and φ and ψ do not
jump.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import acb, arb

from ...errors import InputError
from ...formulas.relative_zero import GIVEN, vanishes
from ..one_degree.uniformisation import BALLS, Heteroclinic, Oscillating, Uniformisation
from .body import AxisymmetricBody, Level, level_of

__all__ = [
    "Begin",
    "angles_of",
    "assembled",
    "begin_of",
    "path_rates",
    "path_speed",
    "turning_rates",
]


@dataclass(frozen=True)
class Begin:
    """A state at time 0, brought onto the phase space; all of it balls.

    Attributes
    ----------
    omega, normal : 3 arb
    attitude : 4 arb
    place : 2 arb
    """

    omega: tuple[Any, ...]
    normal: tuple[Any, ...]
    attitude: tuple[Any, ...]
    place: tuple[Any, ...]

    @property
    def rate(self) -> Any:
        """The rate of γ₃."""
        return self.normal[0] * self.omega[1] - self.normal[1] * self.omega[0]

    def level(self, body: AxisymmetricBody) -> Level:
        """The integrals."""
        return level_of(body, self.omega, self.normal)


def begin_of(state: Sequence[Any]) -> Begin:
    """The start nearest to a state given in exact numbers (arb): ω, γ, attitude, place.

    Raises
    ------
    InputError
        If the state is off the phase space by more than rounding.
    """
    omega, normal, attitude, place = state[:3], state[3:6], state[6:10], state[10:12]
    length = sum((x * x for x in normal), arb(0)).sqrt()
    size = sum((q * q for q in attitude), arb(0)).sqrt()
    spin = sum((w * x for w, x in zip(omega, normal, strict=True)), arb(0))
    rate = sum((abs(w) for w in omega), arb(0))
    w, x, y, z = attitude
    row = (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))
    apart = sum((abs(a - b) for a, b in zip(row, normal, strict=True)), arb(0))
    for defect, scale, name in (
        (length - 1, arb(1), "|gamma| = 1"),
        (spin, rate, "(omega, gamma) = 0"),
        (size - 1, arb(1), "|attitude| = 1"),
        (apart, arb(1), "gamma = the vertical of the attitude"),
    ):
        if not vanishes(defect, scale, GIVEN):
            missed = float(abs(defect / scale).mid())
            raise InputError(f"start: it misses {name} by {missed:.3g}, and must satisfy it")
    normal = tuple(x / length for x in normal)
    spin = spin / length
    omega = tuple(w - spin * x for w, x in zip(omega, normal, strict=True))
    return Begin(omega, normal, tuple(q / size for q in attitude), tuple(place))


def angles_of(begin: Begin, halves: tuple[Any, Any], lean: Any) -> tuple[Any, Any]:
    """φ and ψ of a start (arb), sin θ/2 and cos θ/2 being `halves` with their signs.

    `lean` is the rate of θ, which tells φ where the axis is vertical.
    """
    sine, cosine = halves
    across = 2 * sine * cosine
    if across > 0 or across < 0:
        phi = arb.atan2(begin.normal[0] / across, begin.normal[1] / across)
    elif lean > 0 or lean < 0:
        phi = arb.atan2(-begin.omega[1] / lean, begin.omega[0] / lean)
    else:
        phi = arb(0)
    w, x, y, z = begin.attitude
    if abs(cosine) > arb("0.5"):
        psi = 2 * arb.atan2(z / cosine, w / cosine) - phi
    else:
        psi = 2 * arb.atan2(y / sine, x / sine) + phi
    return phi, psi


def turning_rates(level: Level) -> Any:
    """(u, u̇) ↦ φ̇ and ψ̇ in complex balls."""

    def rates(u: Any, rate: Any) -> list[Any]:
        if level.K == 0:
            return [acb(0), acb(0)]
        own = level.K / (level.body.A(u) * (1 - u * u))
        return [own, -u * own]

    return rates


def path_rates(level: Level) -> Any:
    """(chart, σ, derivatives of t, φ, ψ, their values) ↦ derivatives by σ of the place."""

    def rates(
        chart: Uniformisation, sigma: Any, slopes: Sequence[Any], totals: Sequence[Any]
    ) -> list[Any]:
        p = level.body.p(chart.place(BALLS, sigma))
        sideways = p * chart.lean(BALLS, sigma)
        if level.K == 0:
            return [acb(0), sideways]
        low, high = chart.roots(BALLS, sigma)
        along = -p * slopes[1] * low * high
        sin, cos = totals[2].sin_cos()
        return [cos * along - sin * sideways, sin * along + cos * sideways]

    return rates


def path_parities(chart: Uniformisation) -> tuple[int, ...]:
    """Parities of t, φ, ψ, x and y as functions of σ; none for a motion without a turning point.

    Where a turning point lies on the vertical, the axis passes it and goes on to the other side.
    """
    if isinstance(chart, Heteroclinic):
        return ()
    turning = chart.second if isinstance(chart, Oscillating) else chart.first
    return (-1, -1, -1, -1, -1 if turning.edge else 1)


def assembled(
    F: Any, halves: tuple[Any, Any], rates: tuple[Any, Any], angles: tuple[Any, Any], place: Any
) -> list[Any]:
    """The twelve components of the state.

    Parameters
    ----------
    F : BALLS or DOUBLES
    halves : sin θ/2 and cos θ/2
    rates : θ̇ and ω₃/sin θ
    angles : φ and ψ
    place : x + iy
    """
    (sine, cosine), (lean, spin), (phi, psi) = halves, rates, angles
    across, along = 2 * sine * cosine, cosine * cosine - sine * sine
    sin, cos = F.sin(phi), F.cos(phi)
    plus, minus = (psi + phi) / 2, (psi - phi) / 2
    return [
        lean * cos - spin * along * sin,
        -lean * sin - spin * along * cos,
        spin * across,
        across * sin,
        across * cos,
        along,
        cosine * F.cos(plus),
        sine * F.cos(minus),
        sine * F.sin(minus),
        cosine * F.sin(plus),
        place.real,
        place.imag,
    ]


def path_speed(level: Level, u: Any) -> Any:
    """(ẋ + iẏ) e^{−iψ} where θ rests (arb)."""
    if level.K == 0:
        return arb(0)
    across = (1 - u * u).sqrt()
    return (-level.body.p(u) * level.K / (level.body.A(u) * across)).real
