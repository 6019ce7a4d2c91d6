"""Bodies with the symmetry SO(r)×SO(n − r) that do not twist: quasi-periodic in the time itself.

Let the moments be A for planes of the first r axes, B for those of the last n − r and C between
(with m R² added for the rubber ball), γ = (γ′, γ″) and s = γ′².  The bivectors

    L′ = √φ′ u′∧γ′,    φ′ = A s + C (1 − s),    L″ = √φ″ u″∧γ″,    φ″ = B (1 − s) + C s

are constant in the body (docs/open-problems.md), so that γ′ and γ″ stay in two planes, and the
energy is

    2E s(1 − s) = L′² (1 − s) + L″² s + C ṡ²/4.

Hence s = mid − amp cos θ with θ̇ = 2√(2E/C), and the angles in the planes grow at the rates
|L′|/(s √φ′) and |L″|/((1 − s) √φ″), functions of θ.  Where L′ = 0, γ′ moves on a line through the
origin, γ′ = √(2 amp) sin ½θ e′, and likewise γ″ = √(2 amp) cos ½θ e″.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import acb, arb, ctx

from ...arguments import NumberOrText, arguments_checked
from ...core.arrays import FloatArray
from ...core.system import System
from ...formulas.balls import ball, number
from ...formulas.relative_zero import ROUNDING, vanishes
from ..base.problem import Problem
from ..base.solution import ClosedForm, NamedConstant, finite_times
from ..genus_two.curve import DegenerateError
from ..genus_two.phases import phase_at
from ..one_degree.phase_reduction import pair
from .separation import dot
from .solution import BITS, WaveSolution, in_state

Balls = Sequence[arb]

#: Steps of half a period for the angles, at first and at most.
_STEPS = (64, 1 << 15)
#: Fourier coefficients of the highest waves of a rate, relative to the first.
_LEVEL = 1e-16


@dataclass(frozen=True)
class Blocks:
    """The moments of a body with two blocks of axes.

    Attributes
    ----------
    first, second : tuple of int
        The axes of the blocks.
    A, B, C : Fraction
        Moments in the first block, in the second, and between.
    """

    first: tuple[int, ...]
    second: tuple[int, ...]
    A: Fraction
    B: Fraction
    C: Fraction


def blocks_of(n: int, K: Mapping[tuple[int, int], Fraction]) -> Blocks | None:
    """Two blocks of at least two axes, of moments K_ij; None if there are none."""
    for size in range(2, n // 2 + 1):
        for first in combinations(range(n), size):
            second = tuple(i for i in range(n) if i not in first)
            own, other = ({K[pair] for pair in combinations(block, 2)} for block in (first, second))
            between = {K[i, j] for i in first for j in second}
            if len(own) == len(other) == len(between) == 1:
                return Blocks(first, second, own.pop(), other.pop(), between.pop())
    return None


@dataclass(frozen=True)
class Half:
    """The motion of one part of γ, of length √x with x = mid ∓ amp cos θ.

    Attributes
    ----------
    axes : tuple of int
    basis : tuple of two lists of arb
        An orthonormal basis of its plane; where L vanishes the second is zero.
    L : arb
        |L|, zero where the part moves on a line.
    own, between : arb
        Moments: φ = own x + between (1 − x).
    sign : int
        −1 where x is mid − amp cos θ, 1 where it is mid + amp cos θ.
    middle, low : arb
        Of x.
    """

    axes: tuple[int, ...]
    basis: tuple[tuple[arb, ...], tuple[arb, ...]]
    L: arb
    own: arb
    between: arb
    sign: int
    middle: arb
    low: arb

    def _smooth(self, x: FloatArray) -> FloatArray:
        """The rate of the angle less L/(x √C), without a denominator that may be small."""
        own, C = number(self.own), number(self.between)
        root = np.sqrt(own * x + C * (1 - x))
        smooth: FloatArray = -number(self.L) * (own - C) / (np.sqrt(C) * root * (root + np.sqrt(C)))
        return smooth

    def mean(self, amplitude: arb, speed: arb) -> arb:
        """The mean rate of the angle: L/(x √C) has the mean ½ θ̇."""

        def form(theta: acb, analytic: bool) -> acb:
            x = self.middle + self.sign * amplitude * theta.cos()
            phi = self.own * x + self.between * (1 - x)
            root, base = phi.sqrt(analytic=analytic), self.between.sqrt()
            smooth: acb = self.L * (self.between - self.own) / (base * root * (root + base))
            return smooth

        return speed / 2 + acb.integral(form, acb(0), acb(arb.pi())).real / arb.pi()

    def rate(self, x: FloatArray) -> FloatArray:
        """The rate of the angle."""
        rate: FloatArray = number(self.L) / (np.sqrt(number(self.between)) * x) + self._smooth(x)
        return rate

    def swing(self, wave: FloatArray, other: FloatArray, stretch: float) -> FloatArray:
        """The part of period 2π in θ of the integral of L/(x √C).

        Parameters
        ----------
        wave, other : arrays (N,)
            √((x − low)/width) and √((high − x)/width), with signs.
        stretch : float
            √(high/low).
        """
        swing: FloatArray = -self.sign * np.arctan2(
            (stretch - 1) * wave * other, other**2 + stretch * wave**2
        )
        return swing

    def waves(self, width: float) -> FloatArray:
        """Coefficients c_m of cos mθ, m ≥ 1, in the smooth part of the rate."""
        low = number(self.low)
        steps = _STEPS[0]
        while steps <= _STEPS[1]:
            theta = np.pi * np.arange(steps + 1) / steps
            share = np.sin(theta / 2) ** 2 if self.sign < 0 else np.cos(theta / 2) ** 2
            values = self._smooth(low + width * share)
            whole = np.concatenate([values, values[-2:0:-1]])
            heights: FloatArray = np.fft.rfft(whole).real[: steps // 2] / steps
            size = _LEVEL * np.abs(values).max()
            if np.abs(heights[steps // 4 :]).max() <= 10 * size:
                large = np.abs(heights[1:]) > size
                return heights[1 : 2 + int(np.flatnonzero(large).max(initial=0))]
            steps *= 2
        raise DegenerateError


@dataclass(frozen=True, repr=False, eq=False)
class TwoBlockSolution(WaveSolution):
    """A motion with two or three frequencies.

    Attributes
    ----------
    system : System
        Not lifted.
    amplitude, speed, phase : arb
        amp, θ̇ and θ at t = 0.
    halves : (Half, Half)
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    moments: FloatArray
    amplitude: arb
    speed: arb
    phase: arb
    halves: tuple[Half, Half]

    @property
    def _turning(self) -> list[Half]:
        return [half for half in self.halves if not half.L.is_zero()]

    @cached_property
    def _rates(self) -> tuple[arb, ...]:
        """Turns in a unit of time: of θ and of the angles."""
        with ctx.workprec(BITS):
            whole = 2 * arb.pi()
            means = [half.mean(self.amplitude, self.speed) / whole for half in self._turning]
            return (self.speed / whole, *means)

    @cached_property
    def _waves(self) -> list[FloatArray]:
        width = 2 * number(self.amplitude)
        return [half.waves(width) for half in self._turning]

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """States at `times` (N,), as an array (N, size), in double precision."""
        moments = finite_times(times)
        begin, speed = number(self.phase), number(self.speed)
        turn, *angles = (2 * np.pi * phase_at(pair(rate), moments, 2.0) for rate in self._rates)
        theta = turn + begin
        n = len(self.moments)
        gamma, velocity = np.zeros((n, len(moments))), np.zeros((n, len(moments)))
        width = 2 * number(self.amplitude)
        phases = iter(zip(angles, self._waves, strict=True))
        for half in self.halves:
            trigonometric = (np.sin, np.cos) if half.sign < 0 else (np.cos, np.sin)
            wave, other = (f(theta / 2) for f in trigonometric)
            first, second = (np.array([number(x) for x in axis])[:, None] for axis in half.basis)
            rows = list(half.axes)
            if half.L.is_zero():
                gamma[rows] = np.sqrt(width) * wave * first
                velocity[rows] = -half.sign * np.sqrt(width) * other * speed / 2 * first
                continue
            x = number(half.low) + width * wave**2
            angle, heights = next(phases)
            order = np.arange(1, len(heights) + 1)
            swing = np.sin(np.multiply.outer(theta, order)) - np.sin(begin * order)
            angle = angle + swing @ (heights / order) / speed
            stretch = np.sqrt(number(half.middle + self.amplitude) / number(half.low))
            angle = angle + half.swing(wave, other, stretch)
            first_wave, first_other = (np.array(f(begin / 2)) for f in trigonometric)
            angle = angle - half.swing(first_wave, first_other, stretch)
            radius = np.sqrt(x)
            growth = -half.sign * width * wave * other * speed / (2 * x)
            along = np.cos(angle) * first + np.sin(angle) * second
            across = np.cos(angle) * second - np.sin(angle) * first
            gamma[rows] = radius * along
            velocity[rows] = radius * (growth * along + half.rate(x) * across)
        return in_state(self.system, _momentum(self.moments, gamma, -velocity), gamma)

    @property
    def pace(self) -> float:
        """The rate at which the phases grow with time, in turns."""
        return sum(abs(number(x)) for x in self._rates)

    @cached_property
    def form(self) -> ClosedForm:
        """s, its frequency, and those of the angles."""
        s, middle, amplitude, theta = sp.symbols("s s_0 s_1 theta")
        first = self.halves[0]
        names = ["Omega", *(f"Omega_{i}" for i in range(1, len(self._rates)))]
        count = len(self._rates)
        return ClosedForm(
            title="Body with the symmetry SO(r)×SO(n − r)",
            motion=f"quasi-periodic, {count} frequencies" if count > 1 else "periodic",
            equations=((s, middle - amplitude * sp.cos(theta)),),
            constants=(
                NamedConstant("s_0", first.middle, "mean of s = γ′²"),
                NamedConstant("s_1", self.amplitude, "amplitude of s"),
                NamedConstant("L_1", first.L, "momentum of γ′ in its plane"),
                NamedConstant("L_2", self.halves[1].L, "momentum of γ″ in its plane"),
                *(
                    NamedConstant(
                        name,
                        rate,
                        "frequency of s" if i == 0 else "mean frequency of an angle",
                        "turns/s",
                    )
                    for i, (name, rate) in enumerate(zip(names, self._rates, strict=True))
                ),
            ),
            source="docs/open-problems.md",
        )


def _momentum(K: FloatArray, gamma: FloatArray, u: FloatArray) -> FloatArray:
    """p_i = Σ_j K_ij (u_i γ_j − γ_i u_j) γ_j."""
    p: FloatArray = u * (K @ (gamma * gamma)) - gamma * (K @ (u * gamma))
    return p


def solve_two_blocks(
    problem: Problem,
    K: Mapping[tuple[int, int], Fraction],
    blocks: Blocks,
    p: Balls,
    gamma: Balls,
) -> TwoBlockSolution:
    """The motion of a body with two blocks of axes.

    Parameters
    ----------
    problem : Problem
        Not lifted.
    K : mapping
        The moments, with m R² added for a ball.
    p, gamma : sequence of n arb
        The start, p other than zero.
    """
    n = len(gamma)
    C = ball(blocks.C)
    parts = []
    energy = arb(0)
    for axes, own in ((blocks.first, ball(blocks.A)), (blocks.second, ball(blocks.B))):
        y, momentum = [gamma[i] for i in axes], [p[i] for i in axes]
        x = dot(y, y)
        phi = own * x + C * (1 - x)
        sigma = dot(momentum, y) / C
        u = [(a + (own - C) * sigma * b) / phi for a, b in zip(momentum, y, strict=True)]
        energy += dot(momentum, u)
        # of a middle: a ball around zero has no root
        square = max((dot(u, u) * x - dot(u, y) * dot(u, y)).mid(), arb(0))
        if vanishes(square.sqrt(), (dot(u, u) * x).sqrt(), ROUNDING):
            square = arb(0)
        L = (phi * square).sqrt()
        parts.append((axes, own, y, u, x, L.mid(), sigma))
    s, first, second = parts[0][4], parts[0][5], parts[1][5]
    # 2E s(1 − s) − L′²(1 − s) − L″² s = −2E (s − mid)² + 2E amp²
    middle = ((energy + first * first - second * second) / (2 * energy)).mid()
    amplitude = (middle * middle - first * first / energy).mid()
    amplitude = max(amplitude, arb(0)).sqrt().mid()
    speed = (2 * (energy / C).sqrt()).mid()
    # θ̇ amp sin θ = ṡ = −2σ
    phase = arb(0)
    sine, cosine = (-2 * parts[0][6] / speed).mid(), (middle - s).mid()
    if not (sine.is_zero() and cosine.is_zero()):
        phase = arb.atan2(sine, cosine) if cosine > 0 else arb.pi() - arb.atan2(sine, -cosine)
    halves = []
    for (axes, own, y, u, _, L, _), sign in zip(parts, (-1, 1), strict=True):
        basis = _line(y, u, phase, sign) if L.is_zero() else _plane(y, u)
        centre = middle if sign < 0 else 1 - middle
        # the product of the ends of x is L²/2E
        low = (L * L / energy / (centre + amplitude)).mid() if not L.is_zero() else arb(0)
        halves.append(Half(axes, basis, L, own, C, sign, centre, low))
    moments = np.array([[number(K[i, j]) if i != j else 0.0 for j in range(n)] for i in range(n)])
    return TwoBlockSolution(
        problem.system,
        problem.parameters,
        moments,
        amplitude,
        speed,
        phase.mid(),
        (halves[0], halves[1]),
    )


def _plane(y: Balls, u: Balls) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
    """γ at t = 0, and the direction in which it turns."""
    first = _unit(y)
    share = dot(first, u)
    return tuple(first), tuple(_unit([share * a - b for a, b in zip(first, u, strict=True)]))


def _line(y: Balls, u: Balls, phase: arb, sign: int) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
    """The direction of the line on which a part of γ moves, with its sign."""
    none = tuple(arb(0) for _ in y)
    half = phase / 2
    wave, slope = (half.sin(), half.cos()) if sign < 0 else (half.cos(), -half.sin())
    # the longer of the part and its rate shows the direction best
    if abs(wave.mid()) > abs(slope.mid()):
        vector, factor = list(y), wave
    else:
        vector, factor = [-x for x in u], slope
    if all(x.mid().is_zero() for x in vector):
        return none, none
    turn = 1 if factor.mid() > 0 else -1
    return tuple(turn * x for x in _unit(vector)), none


def _unit(vector: Balls) -> list[arb]:
    length = dot(vector, vector).sqrt()
    return [x / length for x in vector]
