"""Motions of bodies with the symmetry SO(r)×SO(n − r) at any time, with error bounds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, ctx, fmpq

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.formulas.balls import ball, number
from flowlanes.formulas.relative_zero import ROUNDING, vanishes
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import dot

from ..base.problem import Problem
from ..base.solution import ClosedForm, NamedConstant, Solution, finite_times
from ..one_degree import FAST, Equilibrium, MotionSample, QuadratureMotion, motion_chart
from ..one_degree.angles import LinearPhase
from ..one_degree.chebyshev_integrals import working_bits
from ..one_degree.divided_differences import power
from ..one_degree.frames import MotionFrame
from ..one_degree.functions import BALLS, DOUBLES, Count, Functions, T
from ..one_degree.solution import QuadratureSolution
from ..one_degree.uniformisation import Heteroclinic
from ..one_degree.working_precision import exact_time, working_digits
from .separation import Balls, unit, wedge
from .two_blocks import Blocks, Half, Level

#: Working precision of the set-up, in bits.
BITS = 700
#: Basis of a part of γ: its direction at t = 0, and the direction towards which it turns.
Basis = tuple[Balls, Balls]


@dataclass(frozen=True)
class Planes(MotionFrame):
    """p and γ from the lengths of both parts and their angles in two planes.

    Attributes
    ----------
    level : Level
    bases : (Basis, Basis)
    """

    level: Level
    bases: tuple[Basis, Basis]

    @property
    def angles(self) -> int:  # type: ignore[override]
        """The number of parts that turn."""
        return self.level.turning

    def start_angles(self, motion: QuadratureMotion) -> Sequence[arb]:
        """Zeros: the bases are those of the start."""
        return [arb(0)] * self.angles

    def state(
        self,
        F: Functions[T],
        motion: QuadratureMotion,
        sample: MotionSample[T, Count],
        angles: Sequence[T],
    ) -> list[T]:
        """p and γ."""
        return self.at(F, *lengths_of(F, motion, sample), angles)

    def at(
        self, F: Functions[T], lengths: Sequence[T], growths: Sequence[T], angles: Sequence[T]
    ) -> list[T]:
        """p and γ from the lengths of the parts, their rates, and the angles."""
        level = self.level
        zero = 0 * lengths[0]
        places = range(sum(len(half.axes) for half in level.halves))
        p: list[T] = [zero for _ in places]
        gamma: list[T] = [zero for _ in places]
        epsilon, C = F.number(ball(level.epsilon)), F.number(level.C)
        sigma = -lengths[0] * growths[0] / epsilon
        turned = iter(angles)
        for i, half in enumerate(level.halves):
            square = F.square(lengths[i])
            phi = F.number(half.own) * square + C * (1 - square)
            first, second = ([F.number(x) for x in vector] for vector in self.bases[i])
            angle = next(turned) if half.turns else zero
            cosine, sine = F.cos(angle), F.sin(angle)
            turn = self._turn(F, half, phi) / lengths[i] if half.turns else zero
            for place, a, b in zip(half.axes, first, second, strict=True):
                along, across = cosine * a + sine * b, cosine * b - sine * a
                gamma[place] = lengths[i] * along
                rate = growths[i] * along + turn * across
                shift = F.number((half.own - level.C) * (-1) ** i) * sigma
                p[place] = -phi * rate / epsilon - shift * gamma[place]
        return p + gamma

    def _turn(self, F: Functions[T], half: Half, phi: T) -> T:
        """The rate of the angle times the squared length."""
        exponent = -self.level.exponent
        size = F.number(ball(abs(self.level.epsilon)) * half.L)
        if isinstance(phi, np.ndarray):
            return size * phi ** (int(exponent.p) / int(exponent.q))
        return size * power(phi, exponent)


def lengths_of(
    F: Functions[T], motion: QuadratureMotion, sample: MotionSample[T, Count]
) -> tuple[list[T], list[T]]:
    """|γ′| and |γ″| with their rates; they change sign when a part passes the origin."""
    low, high = motion.chart.roots(F, sample.phase)
    speed = motion.chart.arc_slope(F, sample.phase) * sample.rate / 2
    lengths, growths = [low, high], [high * speed, -low * speed]
    if isinstance(sample.tail, arb) and sample.tail != 0:
        end = motion.end_of_tail(future=sample.tail > 0)
        limits = (end.x.sqrt(), (1 - end.x).sqrt())
        lengths = [x.union(y * x.sgn()) for x, y in zip(lengths, limits, strict=True)]
        growths = [x.union(arb(0)) for x in growths]
    for i, passed in enumerate(motion.passed_edges):
        if passed:
            lengths[i] = F.alternating(sample.periods, lengths[i])
            growths[i] = F.alternating(sample.periods, growths[i])
    return lengths, growths


@dataclass(frozen=True, repr=False, eq=False)
class SteadyTurning(Solution):
    """Both parts of γ turn uniformly, or one does and the other vanishes."""

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    frame: Planes
    lengths: tuple[arb, arb]
    equilibrium: Equilibrium

    @property
    def rates(self) -> list[arb]:
        """The rates of the angles."""
        halves = zip(self.frame.level.halves, self.lengths, strict=True)
        found = []
        for half, length in halves:
            if half.turns:
                square = length * length
                phi = half.own * square + self.frame.level.C * (1 - square)
                found.append(self.frame._turn(BALLS, half, phi) / square)
        return found

    @property
    def phase_rate(self) -> float:
        """The fastest rate of turning."""
        return max((number(x) for x in self.rates), default=0.0)

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """States at `times` (N,), as an array (N, size), in double precision."""
        t = finite_times(times)
        with ctx.workprec(BITS):
            angles = [LinearPhase.from_balls(rate)(t) for rate in self.rates]
            lengths = [np.full(t.shape, number(x)) for x in self.lengths]
            state = self.frame.at(DOUBLES, lengths, [0 * t, 0 * t], angles)
        return np.stack([np.broadcast_to(x, t.shape) for x in state], axis=1)

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The state at one time as balls that contain the exact one."""
        with ctx.workprec(working_bits(working_digits(time, digits, 1, self.phase_rate))):
            angles = [rate * exact_time(time) for rate in self.rates]
            return tuple(self.frame.at(BALLS, self.lengths, [arb(0)] * 2, angles))

    @property
    def form(self) -> ClosedForm:
        """The rates of turning."""
        with ctx.workprec(BITS):
            constants = [
                *_constants(self.frame.level),
                NamedConstant("s", self.lengths[0] ** 2, "γ′²"),
                *_mean_rates(self.frame.level, self.rates),
            ]
        words = self.equilibrium.description("uniform turning in two fixed planes")
        return _form(words, constants, ())


def solve_two_blocks(
    problem: Problem,
    blocks: Blocks,
    epsilon: Fraction,
    p: Balls,
    gamma: Balls,
) -> Solution:
    """Solve a body with two blocks of axes.

    Parameters
    ----------
    problem : Problem
        The reduced problem, without the motion in space.
    blocks : Blocks
        Moments, with m R² added for a ball.
    epsilon : Fraction
        γ̇ = −εu.
    p, gamma : sequence of n arb
        The start, p other than zero.
    """
    C = ball(blocks.C)
    energy, halves, parts, sigmas = arb(0), [], [], []
    half = 1 / (2 * epsilon)
    lost = fmpq(half.numerator, half.denominator)
    for axes, own in ((blocks.first, ball(blocks.A)), (blocks.second, ball(blocks.B))):
        y, momentum = [gamma[i] for i in axes], [p[i] for i in axes]
        square = dot(y, y)
        phi = own * square + C * (1 - square)
        sigma = dot(momentum, y) / C
        u = [(a + (own - C) * sigma * b) / phi for a, b in zip(momentum, y, strict=True)]
        energy += dot(momentum, u)
        area = sum((x * x for x in wedge(u, y).values()), arb(0)).sqrt()
        if vanishes(area, (dot(u, u) * square).sqrt(), ROUNDING):
            area = arb(0)
        halves.append(Half(axes, own, power(phi, lost) * area))
        parts.append((y, [-ball(epsilon) * x for x in u]))
        sigmas.append(sigma)
    level = Level(C, epsilon, energy, (halves[0], halves[1]))
    x = dot(parts[0][0], parts[0][0])
    chart = motion_chart(level.equation, x, -2 * ball(epsilon) * sigmas[0])
    system, values = problem.system, problem.parameters
    if isinstance(chart, Equilibrium):
        lengths = [dot(y, y).sqrt() for y, _ in parts]
        frame = Planes(level, _bases(level, parts, lengths, [arb(0)] * 2, arb(1)))
        return SteadyTurning(system, values, frame, (lengths[0], lengths[1]), chart)
    parities = () if isinstance(chart, Heteroclinic) else (-1,) * (1 + level.turning)
    motion = QuadratureMotion(
        chart,
        x,
        -2 * ball(epsilon) * sigmas[0],
        level.rates,
        parities=parities,
        units=(1.0,) * level.turning,
    )
    lengths, growths = lengths_of(BALLS, motion, motion.start)
    scale = arb(motion.time_scale) ** 2
    frame = Planes(level, _bases(level, parts, lengths, growths, scale))
    return QuadratureSolution(system, values, motion, frame, lambda: _form_of(level, motion))


def _bases(
    level: Level,
    parts: Sequence[tuple[Balls, Balls]],
    lengths: Balls,
    growths: Balls,
    scale: arb,
) -> tuple[Basis, Basis]:
    """The bases of both parts, from γ and γ̇ at the start."""
    first, second = (
        _plane(y, rate) if half.turns else _line(y, rate, length, growth * scale)
        for half, (y, rate), length, growth in zip(
            level.halves, parts, lengths, growths, strict=True
        )
    )
    return first, second


def _plane(y: Balls, rate: Balls) -> Basis:
    """γ at t = 0, and the direction in which it turns."""
    first = unit(y)
    share = dot(first, rate)
    return first, unit([b - share * a for a, b in zip(first, rate, strict=True)])


def _line(y: Balls, rate: Balls, length: arb, growth: arb) -> Basis:
    """The direction of the line on which a part of γ moves, for a signed length."""
    vector = [length * a + growth * b for a, b in zip(y, rate, strict=True)]
    none = [arb(0)] * len(y)
    return (none if dot(vector, vector).contains(0) else unit(vector)), none


# --- words and formulas --------------------------------------------------------------------


def _form_of(level: Level, motion: QuadratureMotion) -> ClosedForm:
    low, high = sorted((motion.chart.first.x, motion.chart.second.x), key=number)
    constants = [
        *_constants(level),
        NamedConstant("s_1", low, "least γ′²"),
        NamedConstant("s_2", high, "greatest γ′²"),
    ]
    ends = (number(low), number(high))
    if not motion.periodic:
        words = "asymptotic to a uniform turning, in the past and in the future (separatrix)"
        return _form(words, constants, (ends,))
    period, *gains = motion.advances(FAST)
    constants.append(NamedConstant("Omega", 1 / period, "frequency of s", "turns/s"))
    constants += _mean_rates(level, [gain / period for gain in gains])
    count = 1 + level.turning
    words = f"quasi-periodic, {count} frequencies" if count > 1 else "periodic"
    return _form(words, constants, (ends,))


def _constants(level: Level) -> list[NamedConstant]:
    first, second = level.halves
    return [
        NamedConstant("E", level.energy / 2, "energy", "J"),
        NamedConstant("L_1", first.L, "constant of γ′ in its plane"),
        NamedConstant("L_2", second.L, "constant of γ″ in its plane"),
    ]


def _mean_rates(level: Level, rates: Balls) -> list[NamedConstant]:
    names = [i for i, half in enumerate(level.halves, 1) if half.turns]
    parts = {1: "γ′", 2: "γ″"}
    return [
        NamedConstant(
            f"Omega_{i}",
            rate / (2 * arb.pi()),
            f"mean frequency of {parts[i]} in its plane",
            "turns/s",
        )
        for i, rate in zip(names, rates, strict=True)
    ]


def _form(
    motion: str, constants: Sequence[NamedConstant], ovals: tuple[tuple[float, float], ...]
) -> ClosedForm:
    s, rate, E, C, epsilon, first, second, a, b = sp.symbols(
        "s ds/dt E C epsilon L_1 L_2 phi_1 phi_2"
    )
    q = 1 - 1 / epsilon
    kinetic = 2 * E * s * (1 - s) - first**2 * (1 - s) * a**q - second**2 * s * b**q
    return ClosedForm(
        title="Body with the symmetry SO(r)×SO(n − r)",
        motion=motion,
        equations=((C * rate**2 / (4 * epsilon**2), kinetic),),
        constants=tuple(constants),
        ovals=ovals,
        source="borisov-mamaev-2008/docs/open-problems.md",
    )
