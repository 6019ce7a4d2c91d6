"""The lifted state of a rubber body of revolution from its angles, in balls and arrays.

    γ = (sin θ sin φ, sin θ cos φ, cos θ)                  Q = R₃(ψ) R₁(θ) R₃(φ)
    ω = θ̇ (cos φ, −sin φ, 0) + ω₃ (−ctg θ sin φ, −ctg θ cos φ, 1),   (5.2)

so that (ω, γ) = 0 says ψ̇ = −φ̇ cos θ.  The centre of mass moves with

    ẋ + iẏ = −p(K/A + iθ̇ sin θ) e^{iψ}/sin θ.

If the axis passes through the vertical (K = 0), sin θ/2 or cos θ/2 changes its sign, while φ and ψ
do not jump.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np
from flint import acb, arb

from flowlanes.errors import InputError
from flowlanes.formulas.balls import array_function
from flowlanes.formulas.relative_zero import START_TOLERANCE, vanishes
from flowlanes.system.arrays import FloatArray

from ..one_degree import MotionSample, NestedRates, QuadratureMotion, Rates
from ..one_degree.frames import BodyFrame, Inclination, intrinsic_angle
from ..one_degree.functions import BALLS, Count, Functions, T
from ..one_degree.uniformisation import Heteroclinic, Oscillating, Uniformisation
from .body import AxisymmetricBody, Level, level_of, u

Vector: TypeAlias = Sequence[arb]


@dataclass(frozen=True)
class StartState:
    """A state at time 0, projected onto the phase space, in balls.

    Attributes
    ----------
    omega, normal : 3 arb
    attitude : 4 arb
    position : 2 arb
    """

    omega: Vector
    normal: Vector
    attitude: Vector
    position: Vector

    @property
    def rate(self) -> arb:
        """The rate of γ₃."""
        return self.normal[0] * self.omega[1] - self.normal[1] * self.omega[0]

    def level(self, body: AxisymmetricBody) -> Level:
        """The integrals."""
        return level_of(body, self.omega, self.normal)


def start_state(state: Vector) -> StartState:
    """The state of the phase space nearest to exact numbers: ω, γ, attitude, position.

    Raises
    ------
    InputError
        If the state is off the phase space by more than rounding.
    """
    omega, normal, attitude, position = state[:3], state[3:6], state[6:10], state[10:12]
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
        if not vanishes(defect, scale, START_TOLERANCE):
            missed = float(abs(defect / scale).mid())
            raise InputError(f"start: it misses {name} by {missed:.3g}, and must satisfy it")
    normal = [x / length for x in normal]
    spin = spin / length
    omega = [w - spin * x for w, x in zip(omega, normal, strict=True)]
    return StartState(omega, normal, [q / size for q in attitude], position)


def start_angles(start: StartState, sine: arb, cosine: arb, lean: arb) -> tuple[arb, arb]:
    """φ and ψ of a start; see :func:`intrinsic_angle`."""
    phi = intrinsic_angle(sine, cosine, lean, start.normal, start.omega)
    w, x, y, z = start.attitude
    # The quaternion of R₃(ψ) R₁(θ) R₃(φ) has (w, z) = cos ½θ · (cos, sin) ½(ψ + φ) and (x, y) = sin
    # ½θ · (cos, sin) ½(ψ − φ): take the pair that is not small.
    if abs(cosine) > arb("0.5"):
        return phi, 2 * arb.atan2(z / cosine, w / cosine) - phi
    return phi, 2 * arb.atan2(y / sine, x / sine) + phi


def turning_rates(level: Level) -> Rates:
    """(u, u̇) ↦ φ̇ and ψ̇."""

    def rates(u: acb, rate: acb) -> list[acb]:
        if level.K == 0:
            return [acb(0), acb(0)]
        own = level.K / (level.body.A(u) * (1 - u * u))
        return [own, -u * own]

    return rates


def path_rates(level: Level) -> NestedRates:
    """(chart, σ, derivatives of t, φ, ψ, their values) ↦ derivatives by σ of the position."""

    def rates(
        chart: Uniformisation, sigma: acb, slopes: Sequence[acb], totals: Sequence[acb]
    ) -> list[acb]:
        # ẋ + iẏ = −p(K/A + iθ̇ sin θ) e^{iψ}/sin θ, where K/A = φ̇ sin² θ, θ̇ sin θ = −u̇ and sin θ
        # is the product of both roots.
        p = level.body.p(chart.coordinate(BALLS, sigma))
        sideways = p * chart.arc_slope(BALLS, sigma)
        if level.K == 0:
            return [acb(0), sideways]
        low, high = chart.roots(BALLS, sigma)
        along = -p * slopes[1] * low * high
        sin, cos = totals[2].sin_cos()
        return [cos * along - sin * sideways, sin * along + cos * sideways]

    return rates


def path_parities(chart: Uniformisation) -> tuple[int, ...]:
    """Parities of t, φ, ψ, x and y as functions of σ; empty for a motion without a turning point.

    At a turning point on the vertical the axis passes to the other side.
    """
    if isinstance(chart, Heteroclinic):
        return ()
    turning = chart.second if isinstance(chart, Oscillating) else chart.first
    return (-1, -1, -1, -1, -1 if turning.edge else 1)


def path_speed(level: Level, u: acb) -> acb:
    """(ẋ + iẏ) e^{−iψ}, which is real, for a motion with constant θ."""
    if level.K == 0:
        return acb(0)
    across = (1 - u * u).sqrt()
    return acb((-level.body.p(u) * level.K / (level.body.A(u) * across)).real)


@dataclass(frozen=True)
class RevolutionFrame(BodyFrame):
    """The lifted state of a body of revolution from θ.

    Attributes
    ----------
    level : Level
    start : StartState
    position : two arb
    """

    level: Level
    start: StartState
    position: Vector
    turning_path = True

    def path_speed(self, x: acb) -> acb:
        """(ẋ + iẏ) e^{−iψ} where θ is constant."""
        return path_speed(self.level, x)

    def start_angles(self, motion: QuadratureMotion) -> tuple[arb, arb]:
        """φ and ψ at time 0."""
        return start_angles(self.start, *motion.half_angles(BALLS, motion.start))

    @cached_property
    def _square(self) -> Callable[[FloatArray], FloatArray]:
        """A² in double precision."""
        body = self.level.body
        function = array_function((u, *body.values), (body.square,))
        numbers = [float(x) for x in body.values.values()]
        return lambda cosine: function(cosine, *numbers)[0]

    def _spin(self, cosine: T, sine: T) -> T:
        """ω₃/sin θ."""
        K = self.level.K
        if K == 0:
            return 0 * cosine
        if isinstance(cosine, arb):
            return K / (self.level.body.A(acb(cosine)).real * sine)
        return float(K) / (np.sqrt(self._square(cosine)) * sine)

    def inclination(
        self, F: Functions[T], motion: QuadratureMotion, sample: MotionSample[T, Count]
    ) -> Inclination[T]:
        """θ, and ω and γ in the nodal frame."""
        sine, cosine, rate = motion.half_angles(F, sample)
        across, along = 2 * sine * cosine, cosine * cosine - sine * sine
        spin = self._spin(along, across)
        omega = (rate, -spin * along, spin * across)
        return Inclination(sine, cosine, (omega, (0 * along, across, along)))
