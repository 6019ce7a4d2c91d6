"""Uniform motions: rest, permanent rotations, steady precession, bodies with three equal moments.

The vectors of the reduced state turn rigidly in the body, x(t) = e^{−tΩ×} x(0), with a constant Ω:
zero for an equilibrium of the reduced system, along the axis of symmetry of a body of revolution, ω
itself for a permanent rotation (about a principal axis, or about any axis when all moments are
equal).  The first two follow from the rates at the start by symmetry; the third is checked along
the turn.  Then, with ω at the start,

    Q(t) = Q(0) e^{t(ω − Ω)×} e^{tΩ×},

and a point of the body that has the velocity V in body axes runs along a helix about ω − Ω.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import arb, ctx

from ...arguments import Numbers, Written, arguments_checked
from ...core.system import System, flat_pairs
from ...core.vectors import Vector, to_components
from ...formulas.balls import evaluated, exact
from ...formulas.relative_zero import Sized, measured, sized, vanishes
from ...mechanics.rolling.attitude import attitude
from ..base.exact_start import on_phase_space
from ..base.solution import ClosedForm, NamedConstant, Solution
from ..one_degree.chebyshev_integrals import working_bits
from ..revolution import balls_of, needed
from ..revolution.angles import LinearPhase
from .exact_start import PRECISION, exact_ball
from .quaternion import cross, dot, product, times, times_array

__all__ = ["UniformSolution", "resting", "uniform"]

#: Places along a turn about ω at which the field is compared with that turn.
ANGLES = 7

_OMEGA = Vector("omega").symbols


@dataclass(frozen=True, repr=False)
class UniformSolution(Solution):
    """A uniform motion.

    Attributes
    ----------
    system : System
        Lifted to space where it has a motion.
    parameters : mapping of Symbol to arb
    vectors : tuple of vectors (three arb each)
        The reduced state at t = 0.
    turning : three arb
        Ω.
    omega : three arb
        ω at t = 0; body axes, as all of these.
    attitude : four arb, or none
    velocity : three arb, or none
        V.
    place : arbs
        At t = 0.
    """

    system: System
    parameters: Mapping[sp.Symbol, Any]
    vectors: tuple[Sequence[Any], ...]
    turning: Sequence[Any]
    omega: Sequence[Any]
    attitude: tuple[Any, ...]
    velocity: tuple[Any, ...]
    place: tuple[Any, ...]

    @property
    def _apart(self) -> list[Any]:
        """ω − Ω."""
        return [w - x for w, x in zip(self.omega, self.turning, strict=True)]

    @property
    def pace(self) -> float:
        """The faster one of the two rotations."""
        return max(float(_length(x).mid()) for x in (self.turning, self._apart))

    # --- in balls --------------------------------------------------------------------------

    @arguments_checked
    def rigorous(self, time: Written, digits: int = 30) -> tuple[Any, ...]:
        """The lifted state at one time as balls that contain the exact one."""
        with ctx.workprec(working_bits(needed(time, digits, 1, self.pace))):
            t = balls_of(time)
            back = _turn([-x for x in self.turning], t)
            state = [x for vector in self.vectors for x in product(back, vector)]
            if not self.attitude:
                return tuple(state)
            turn = times(self.attitude, times(_turn(self._apart, t), _turn(self.turning, t)))
            if not self.velocity:
                return (*state, *turn)
            path = product(self.attitude, _helix(self._apart, self.velocity, t))
            return (*state, *turn, *(x + y for x, y in zip(self.place, path[:2], strict=True)))

    # --- in double precision ---------------------------------------------------------------

    @cached_property
    def _rates(self) -> tuple[tuple[Any, LinearPhase, float], ...]:
        """Of Ω and ω − Ω: the direction, the angle as a function of time, the length."""
        with ctx.workprec(working_bits(40)):
            found = []
            for vector in (self.turning, self._apart):
                length = dot(vector, vector).sqrt()
                axis = [x / length if length > 0 else arb(0) for x in vector]
                found.append((_doubles(axis), LinearPhase.of(length), float(length.mid())))
            return tuple(found)

    @arguments_checked
    def states(self, times: Numbers) -> Any:
        """Lifted states at `times` (n,), in double precision."""
        t = np.asarray(times, dtype=float)
        (own, own_turn, _), (axis, turn, speed) = self._rates
        own_angle, angle = own_turn(t), turn(t)
        columns = [_rotated(_doubles(x), own, -own_angle) for x in self.vectors]
        if self.attitude:
            start = _doubles(self.attitude)[None, :]
            first, second = _quaternions(axis, angle), _quaternions(own, own_angle)
            columns.append(times_array(start, times_array(first, second)))
        if self.velocity:
            V = _doubles(self.velocity)
            along = axis * (axis @ V)
            across = V - along
            path = np.multiply.outer(t, along if speed else V)
            if speed:
                path = path + np.multiply.outer(np.sin(angle) / speed, across)
                path = path + np.multiply.outer((1 - np.cos(angle)) / speed, np.cross(axis, V))
            turned = _doubles(self.attitude)
            path = path + 2 * np.cross(turned[1:], np.cross(turned[1:], path) + turned[0] * path)
            columns.append(path[:, :2] + _doubles(self.place))
        return np.concatenate(columns, axis=1)

    @property
    def form(self) -> ClosedForm:
        """What it looks like."""
        moving = any(not x.contains(0) for x in self.omega)
        lengths = [dot(x, x).sqrt() for x in (self.turning, self._apart)]
        return ClosedForm(
            title=self.system.title,
            motion="uniform rotation" if moving else "rest",
            equations=((sp.Symbol("x"), sp.Symbol("exp(-t*Omega)") * sp.Symbol("x_0")),),
            figures=(
                NamedConstant(
                    "Omega", lengths[0], "rate at which vectors turn in the body", "rad/s"
                ),
                NamedConstant(
                    "omega_0", lengths[1], "rate at which that frame turns in space", "rad/s"
                ),
            ),
        )


def _doubles(balls: Sequence[Any]) -> Any:
    return np.array([float(x.mid()) for x in balls])


def _rotated(vector: Any, axis: Any, angle: Any) -> Any:
    """A vector turned about a unit axis (or none) by angles (n,): (n, 3)."""
    along = axis * (axis @ vector)
    sine, cosine = np.sin(angle), np.cos(angle)
    across = np.multiply.outer(cosine, vector - along) + np.multiply.outer(
        sine, np.cross(axis, vector)
    )
    return along + across


def _quaternions(axis: Any, angle: Any) -> Any:
    return np.column_stack([np.cos(angle / 2), np.multiply.outer(np.sin(angle / 2), axis)])


def _turn(vector: Sequence[Any], t: Any) -> tuple[Any, ...]:
    """The quaternion of a turn by the vector times t, in balls."""
    half = dot(vector, vector).sqrt() * t / 2
    sine = half.sinc() * t / 2
    return (half.cos(), *(sine * x for x in vector))


def _helix(axis: Sequence[Any], velocity: Sequence[Any], t: Any) -> list[Any]:
    """∫ e^{t axis×} velocity dt from 0."""
    half = dot(axis, axis).sqrt() * t / 2
    # sin x/x and (1 − cos x)/x² at x = |axis| t, and what they leave of the part along the axis
    first, second = (2 * half).sinc() * t, half.sinc() * half.sinc() * t * t / 2
    once = cross(axis, velocity)
    square = dot(axis, axis)
    if square.contains(0):
        return [v * t for v in velocity]
    along = [a * dot(axis, velocity) / square for a in axis]
    return [
        a * t + first * (v - a) + second * c for a, v, c in zip(along, velocity, once, strict=True)
    ]


def uniform(
    system: System,
    values: Mapping[sp.Symbol, Any],
    start: Sequence[Any],
    moments: Sequence[Any],
) -> UniformSolution | None:
    """The uniform motion through a start, if it is one.

    Parameters
    ----------
    system : System
        Whose field commutes with the rotations that keep the moments; not lifted.
    values : mapping of Symbol to arb
        Its parameters.
    start : sequence of arb
        The lifted state, on the phase space.
    moments : three arb
        The principal moments, which tell the symmetry.
    """
    size = len(system.symbols)
    known = {**values, **dict(zip(system.symbols, start, strict=False))}
    for symbol, formula in system.steps:
        (known[symbol],) = evaluated([formula], known)
    rates = evaluated(system.rates, known)
    vectors = [start[k : k + 3] for k in range(0, size, 3)]
    changes = [rates[k : k + 3] for k in range(0, size, 3)]
    omega = [known[symbol] for symbol in _OMEGA]
    for turning in (*_allowed(vectors, changes, moments), omega):
        angles = [arb(0)] if turning is not omega else [arb(k) for k in range(ANGLES)]
        if all(
            _turns(system, values, _turned(vectors, turning, angle), turning, _length(omega))
            for angle in angles
        ):
            return _made(system, values, start, vectors, turning, omega)
    return None


def resting(
    system: System, values: Mapping[sp.Symbol, Any], start: Sequence[Any]
) -> UniformSolution | None:
    """The motion on which the reduced state rests, if the start is an equilibrium of it.

    Parameters
    ----------
    system : System
        Of two vectors, whatever its field; not lifted.
    values : mapping of Symbol to number
        Its parameters.
    start : sequence of numbers
        The state, reduced or lifted.

    Raises
    ------
    InputError
        If the start is off the phase space.
    """
    with ctx.workprec(PRECISION):
        known = {symbol: exact_ball(value) for symbol, value in values.items()}
        size = len(system.symbols)
        given = [exact_ball(x) for x in start]
        state = on_phase_space(system, (), given[:size], known)
        numbers = measured(system.state, system.symbols, [exact(x) for x in state])
        fixed = {s: Sized(exact(x), abs(exact(x))) for s, x in known.items()}
        rates = [to_components(rate) for rate in system.rates]
        if not all(x.vanishes() for x in sized(rates, {**fixed, **numbers}, system.steps)):
            return None
        found = {**known, **dict(zip(system.symbols, state, strict=True))}
        for symbol, formula in system.steps:
            (found[symbol],) = evaluated([formula], found)
        zero = [arb(0)] * 3
        vectors = [state[k : k + 3] for k in range(0, size, 3)]
        omega = [found.get(symbol, arb(0)) for symbol in _OMEGA]
        return _made(system, known, (*state, *given[size:]), vectors, zero, omega)


def _turned(vectors: Sequence[Any], turning: Sequence[Any], angle: Any) -> list[Any]:
    """The reduced state after a turn by e^{−angle·Ω×/|Ω|}."""
    length = dot(turning, turning).sqrt()
    if angle == 0:
        return list(vectors)
    back = _turn([-x / length for x in turning], angle)
    return [product(back, vector) for vector in vectors]


def _turns(
    system: System,
    values: Mapping[sp.Symbol, Any],
    vectors: Sequence[Any],
    turning: Sequence[Any],
    speed: Any,
) -> bool:
    """Whether the rates of all vectors x are −Ω×x at a state, relative to |ω||x|."""
    known = {**values, **dict(zip(system.symbols, _flat(vectors), strict=True))}
    for symbol, formula in system.steps:
        (known[symbol],) = evaluated([formula], known)
    rates = evaluated(system.rates, known)
    sides = [cross(turning, vector) for vector in vectors]
    return all(
        vanishes((x + y).mid(), speed * _length(vector))
        for number, (vector, side) in enumerate(zip(vectors, sides, strict=True))
        for x, y in zip(rates[3 * number : 3 * number + 3], side, strict=True)
    )


def _length(vector: Sequence[Any]) -> Any:
    return dot(vector, vector).sqrt()


def _flat(vectors: Sequence[Any]) -> list[Any]:
    return [x.mid() for vector in vectors for x in vector]


def _allowed(
    vectors: Sequence[Any], changes: Sequence[Any], moments: Sequence[Any]
) -> list[list[Any]]:
    """Ω along an axis of symmetry, or zero."""
    size = max(abs(moment) for moment in moments)
    found = [[arb(0)] * 3]
    equal = [vanishes((moments[(i + 1) % 3] - moments[(i + 2) % 3]).mid(), size) for i in range(3)]
    for i in (i for i in range(3) if equal[i]):
        axis = [arb(int(k == i)) for k in range(3)]
        for vector, change in zip(vectors, changes, strict=True):
            # every vector across the axis turns at the same rate, if the motion is uniform
            side = cross(axis, vector)
            if not vanishes(_length(side).mid(), _length(vector)):
                share = dot(change, side) / dot(side, side)
                found.append([-share * x for x in axis])
                break
    return found


def _made(
    system: System,
    values: Mapping[sp.Symbol, Any],
    start: Sequence[Any],
    vectors: Sequence[Any],
    turning: Sequence[Any],
    omega: Sequence[Any],
) -> UniformSolution:
    size = len(system.symbols)
    turn: tuple[Any, ...] = ()
    velocity: tuple[Any, ...] = ()
    if system.motion is not None:
        length = sum((q * q for q in start[size : size + 4]), arb(0)).sqrt()
        turn = tuple(q / length for q in start[size : size + 4])
        velocity = _velocity(system, values, start)
    lifted = system.lifted() if system.motion is not None else system
    return UniformSolution(
        lifted,
        values,
        tuple(tuple(v) for v in vectors),
        # exact numbers: their radii, near 1e-120, would hide that a difference is zero
        tuple(x.mid() for x in turning),
        tuple(x.mid() for x in omega),
        turn,
        velocity,
        tuple(start[size + 4 :]),
    )


def _velocity(
    system: System, values: Mapping[sp.Symbol, Any], start: Sequence[Any]
) -> tuple[Any, ...]:
    """The velocity in body axes, read off the rates of the place at two attitudes."""
    assert system.motion is not None
    rates = [f for name, f in flat_pairs(system.motion.field) if name not in attitude.symbols]
    if not rates:
        return ()
    known = {**values, **dict(zip(system.symbols, start, strict=False))}
    for symbol, formula in system.steps:
        (known[symbol],) = evaluated([formula], known)
    half = arb("0.5")
    upright = dict(zip(attitude.symbols, (arb(1), arb(0), arb(0), arb(0)), strict=True))
    # this attitude takes the third body axis to the first one of space
    turned = dict.fromkeys(attitude.symbols, half)
    first, second = evaluated(rates, {**known, **upright})
    third, _ = evaluated(rates, {**known, **turned})
    return (first, second, third)
