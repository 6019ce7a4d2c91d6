"""Motion in space over a motion on a torus: attitude, and positions by quadrature."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import sympy as sp

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.balls import components, number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.vectors import vectors

from ...mechanics.rolling.attitude import attitude, place_rates
from .attitude import Cover, Triad, cover
from .attitude_one_axis import farthest_from_axis, references, spin_rate
from .floquet_attitude import FloquetReduction, reduction
from .phases import phase_grid
from .quadrature import Quadrature, quadrature, series
from .separated_motion import SeparatedMotion, on_arrays
from .third_frequency import Turning, turning
from .time_map import TimeMap, TorusPoint

#: Number of points per phase at which the directions of two vectors are compared.
_COARSE = 24


@dataclass(frozen=True)
class Lift(ABC):
    """The motion in space over a motion on a torus.

    Attributes
    ----------
    start : array (4 + places,)
        Attitude (w, x, y, z) and places at t = 0.
    """

    separated_motion: SeparatedMotion
    clock: TimeMap
    start: FloatArray

    @abstractmethod
    def in_space(self, moment: TorusPoint) -> FloatArray:
        """Attitude and places, (4 + places, n)."""

    @cached_property
    def _origin(self) -> FloatArray:
        return self.clock.v_0[None, :]

    def _torus(self, v: FloatArray) -> tuple[FloatArray, FloatArray]:
        return self.separated_motion.torus.values(v)

    @cached_property
    def _clock_rate(self) -> Callable[..., FloatArray]:
        return on_arrays(
            self.separated_motion, components(self.separated_motion.separable.time_rescaling)
        )

    @cached_property
    def _places(self) -> Callable[..., FloatArray]:
        """Rates, per unit of t, of the spatial variables other than the attitude."""
        system = self.separated_motion.separable.system
        return on_arrays(self.separated_motion, place_rates(system), attitude.symbols)

    def _quadrature(self, function: Callable[[FloatArray], FloatArray]) -> tuple[Quadrature, ...]:
        torus = self.separated_motion.torus
        return tuple(quadrature(f, torus.V, self.clock.v_0) for f in series(function))


def spinning_pair(motion: SeparatedMotion) -> tuple[sp.MatrixExpr, sp.MatrixExpr, sp.Expr]:
    """The single fixed vector, a reference away from it, and its rate of turning in t."""
    of = motion.separable
    at_grid = motion.torus.values(phase_grid([_COARSE, _COARSE]))
    fixed = on_arrays(motion, components(of.fixed[0]))(*at_grid)
    choice = references(of)
    directions = [on_arrays(motion, components(e.vector))(*at_grid) for e in choice]
    best = choice[farthest_from_axis(fixed, directions)]
    return of.fixed[0], best.vector, spin_rate(of, best)


@dataclass(frozen=True)
class _AttitudeFromVectors(Lift):
    """The attitude on the torus from two vectors of the body."""

    @property
    @abstractmethod
    def _vectors(self) -> Callable[..., FloatArray]:
        """Both vectors, body axes, as a function of ν and ν′: (6, n)."""

    @cached_property
    def _triad(self) -> Triad:
        six = self._vectors(*self._torus(self._origin))
        return Triad.through(six[:3, 0], six[3:, 0], self.start[:4])

    def _attitude(self, direction: FloatArray, turning: FloatArray) -> FloatArray:
        six = self._vectors(direction, turning)
        return self._triad.attitude(six[:3], six[3:])

    @cached_property
    def _cover(self) -> Cover:
        return cover(lambda v: self._attitude(*self._torus(v)), self.clock.flow.whole.grid)

    @cached_property
    def _sign(self) -> float:
        """The sign for which the covered quaternion agrees with that of the start."""
        turns = self._attitude(*self._torus(self._origin))
        at_start = self._cover.with_signs(self._origin, turns)
        return 1.0 if float(at_start[0] @ self.start[:4]) > 0 else -1.0


@dataclass(frozen=True)
class TwoFixedVectors(_AttitudeFromVectors):
    """The attitude from two vectors that are fixed in space."""

    @cached_property
    def _vectors(self) -> Callable[..., FloatArray]:
        fixed = self.separated_motion.separable.fixed
        return on_arrays(
            self.separated_motion, [c for vector in fixed[:2] for c in components(vector)]
        )

    @cached_property
    def _flows(self) -> tuple[Quadrature, ...]:
        if len(self.start) == 4:
            return ()

        def rates(v: FloatArray) -> FloatArray:
            there = self._torus(v)
            return self._clock_rate(*there) * self._places(*there, *self._attitude(*there).T)

        return self._quadrature(rates)

    def in_space(self, moment: TorusPoint) -> FloatArray:
        """Attitude and places, (4 + places, n)."""
        there = self._torus(moment.v)
        turns = self._sign * self._cover.with_signs(moment.v, self._attitude(*there))
        places = [
            start + flow.mean * moment.tau + flow.quasi(moment.v, moment.tau)[0]
            for start, flow in zip(self.start[4:], self._flows, strict=True)
        ]
        return np.concatenate([turns.T, np.reshape(places, (len(places), len(moment.tau)))])


@dataclass(frozen=True)
class OneFixedVector(_AttitudeFromVectors):
    """The attitude from one vector fixed in space and the angle of rotation about it.

    The attitude is a rotation by ψ about the fixed vector, after an attitude on the torus; ψ grows
    linearly plus a quasi-periodic part.  Velocities in space turn with ψ: a third frequency.
    """

    @cached_property
    def _pair(self) -> tuple[Callable[..., FloatArray], sp.Expr]:
        """The fixed vector and a reference vector that stays away from it; the rate of ψ."""
        fixed, reference, rate = spinning_pair(self.separated_motion)
        return on_arrays(self.separated_motion, [*components(fixed), *components(reference)]), rate

    @property
    def _vectors(self) -> Callable[..., FloatArray]:
        return self._pair[0]

    @cached_property
    def _angle(self) -> Quadrature:
        """∫ (dψ/dτ) dτ."""
        rate = on_arrays(self.separated_motion, [self._pair[1]])

        def rates(v: FloatArray) -> FloatArray:
            there = self._torus(v)
            return self._clock_rate(*there) * rate(*there)

        return self._quadrature(rates)[0]

    @cached_property
    def _flows(self) -> tuple[tuple[Quadrature, Turning], ...]:
        """The part of each position that does not turn with ψ, and the part that does."""
        if len(self.start) == 4:
            return ()
        axis = self._triad.axes[0]
        angle = self._angle

        def parts(v: FloatArray) -> FloatArray:
            there = self._torus(v)
            turns = self._attitude(*there).T
            clock = self._clock_rate(*there)
            # Rates are quadratic in the quaternion, hence of the form s + a cos ψ + b sin ψ: the
            # values at ψ = 0, ½π and π give s and a − ib.  The quasi-periodic part of ψ is a
            # function on the torus and is taken into the Fourier series; its linear part remains.
            zero, quarter, half = (
                clock
                * self._places(*there, *_after_turn(axis, np.full(turns.shape[1], psi), turns))
                for psi in (0.0, np.pi / 2, np.pi)
            )
            still = (zero + half) / 2
            phase = np.exp(1j * angle.whole(v))
            moving = ((zero - still) - 1j * (quarter - still)) * phase
            return np.concatenate([still, moving.real, moving.imag])

        count = len(self.start) - 4
        fourier = series(parts)
        V, v_0 = self.separated_motion.torus.V, self.clock.v_0
        if len(angle.slow):
            raise InputError(
                "the frequencies are so near a resonance that the path in space is not resolved"
            )
        return tuple(
            (
                quadrature(fourier[i], V, v_0),
                turning(
                    fourier[count + i], fourier[2 * count + i], V, v_0, angle.mean, -angle.origin
                ),
            )
            for i in range(count)
        )

    def in_space(self, moment: TorusPoint) -> FloatArray:
        """Attitude and places, (4 + places, n)."""
        there = self._torus(moment.v)
        psi = self._angle.mean * moment.tau + self._angle.quasi(moment.v, moment.tau)[0]
        turns = self._sign * self._cover.with_signs(moment.v, self._attitude(*there))
        places = [
            start
            + still.mean * moment.tau
            + still.quasi(moment.v, moment.tau)[0]
            + moving.values(moment.v, moment.tau)
            for start, (still, moving) in zip(self.start[4:], self._flows, strict=True)
        ]
        whole = _after_turn(self._triad.axes[0], psi, turns.T)
        return np.concatenate([whole, np.reshape(places, (len(places), len(moment.tau)))])


@dataclass(frozen=True)
class NoFixedVector(Lift):
    """The attitude if no fixed vector is known: reduced numerically to a uniform rotation."""

    @cached_property
    def _reduction(self) -> FloquetReduction:
        omega = on_arrays(self.separated_motion, vectors("omega")[0].symbols)

        def turning(v: FloatArray) -> FloatArray:
            there = self._torus(v)
            return self._clock_rate(*there) * omega(*there)

        V = [number(x) for x in self.separated_motion.torus.V]
        return reduction(turning, V, self.clock.v_0, self.start[:4])

    def in_space(self, moment: TorusPoint) -> FloatArray:
        """The attitude, (4, n)."""
        return self._reduction.attitude(moment.v, moment.tau).T


def _after_turn(axis: FloatArray, psi: FloatArray, turns: FloatArray) -> FloatArray:
    """Quaternions (4, n) after an additional rotation by ψ (n,) about an axis in space."""
    w, vector = np.cos(psi / 2), np.sin(psi / 2) * np.asarray(axis)[:, None]
    return np.concatenate(
        [
            (w * turns[0] - np.sum(vector * turns[1:], axis=0))[None],
            w * turns[1:] + vector * turns[0] + np.cross(vector, turns[1:], axis=0),
        ]
    )


def lift(motion: SeparatedMotion, clock: TimeMap, start: Sequence[NumberOrText]) -> Lift | None:
    """The motion in space, or None if the system has none.

    Raises
    ------
    InputError
        If the system has places in space and no direction that stays there.
    """
    of = motion.separable
    if of.system.reconstruction is None:
        return None
    numbers = np.array([float(x) for x in start])
    if not of.fixed and len(numbers) > 4:
        raise InputError(
            f"{of.title}: no direction is known that stays in space, so that the path has no "
            "closed form; solve the reduced system alone"
        )
    kinds: dict[int, type[Lift]] = {0: NoFixedVector, 1: OneFixedVector}
    return kinds.get(len(of.fixed), TwoFixedVectors)(motion, clock, numbers)
