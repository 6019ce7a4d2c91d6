"""Uniform motions of a body: rest, permanent rotation, steady precession.

The vectors of the reduced state rotate rigidly in the body, x(t) = e^{−tΩ×} x(0), with a constant
Ω.  With ω at the start,

    Q(t) = Q(0) e^{t(ω − Ω)×} e^{tΩ×},

and a point of the body with the velocity V in body axes moves along a helix about ω − Ω.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import acb, arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import cross, dot

from ...mechanics.rotations import quaternion_product
from ..base.solution import ClosedForm, Solution, finite_times
from .angles import LinearPhase, circular_path, circular_paths
from .chebyshev_integrals import working_bits
from .functions import BALLS, DOUBLES, Functions, T
from .vectors import product
from .working_precision import exact_time, working_digits

Vector = Sequence[arb]

#: Digits used for the phases in double precision.
DIGITS = 40


@dataclass(frozen=True)
class Rotation:
    """A constant angular velocity.

    Attributes
    ----------
    axis : three arb
        A unit vector, or zero.
    rate : arb
    """

    axis: Vector
    rate: arb

    @classmethod
    def from_vector(cls, vector: Vector) -> Rotation:
        """The rotation with an angular velocity in exact numbers."""
        rate = dot(vector, vector).sqrt()
        return cls([x / rate if rate > 0 else arb(0) for x in vector], rate)


@dataclass(frozen=True, repr=False)
class UniformSolution(Solution):
    """A uniform motion.

    Attributes
    ----------
    system : System
        Lifted to space if it has a motion there.
    parameters : mapping of Symbol to number
    vectors : tuple of vectors (three arb each)
        The reduced state at t = 0.
    spin, precession : Rotation
        Ω and ω − Ω; body axes, as of all these vectors.
    closed_form : ClosedForm
    attitude : four arb, or none
        At t = 0.
    velocity : three arb, or none
        V.
    position : two arb, or none
        At t = 0.
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    vectors: Sequence[Vector]
    spin: Rotation
    precession: Rotation
    closed_form: ClosedForm
    attitude: Sequence[arb] = ()
    velocity: Sequence[arb] = ()
    position: Sequence[arb] = ()

    @property
    def form(self) -> ClosedForm:
        """The rates of both rotations."""
        return self.closed_form

    @property
    def phase_rate(self) -> float:
        """The faster of the two rotations."""
        return max(abs(float(turn.rate)) for turn in (self.spin, self.precession))

    def _state(self, F: Functions[T], time: T, angles: tuple[T, T], sums: tuple[T, T]) -> list[T]:
        """The state, from the angles of both rotations and ∫ cos, ∫ sin of the precession angle."""
        own = [F.number(x) for x in self.spin.axis]
        axis = [F.number(x) for x in self.precession.axis]
        state: list[T] = []
        for vector in self.vectors:
            state += _rotated_vector(F, [F.number(x) for x in vector], own, -angles[0])
        if self.attitude:
            attitude = [F.number(x) for x in self.attitude]
            turns = (_quaternion(F, axis, angles[1]), _quaternion(F, own, angles[0]))
            state += quaternion_product(attitude, quaternion_product(*turns))
            if self.velocity:
                velocity = [F.number(x) for x in self.velocity]
                # In balls, since in doubles the rounding error would grow with time.
                pitch = F.number(dot(self.precession.axis, self.velocity))
                along = [a * pitch for a in axis]
                side = cross(axis, velocity)
                path = [
                    along[k] * time + (velocity[k] - along[k]) * sums[0] + side[k] * sums[1]
                    for k in range(3)
                ]
                in_space = product(attitude, path)
                state += [F.number(x) + in_space[k] for k, x in enumerate(self.position)]
        return state

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls that contain the exact one."""
        with ctx.workprec(working_bits(working_digits(time, digits, 1, self.phase_rate))):
            t = exact_time(time)
            angles = (self.spin.rate * t, self.precession.rate * t)
            circle = circular_path(t, self.precession.rate, acb(1))
            return tuple(self._state(BALLS, t, angles, (circle.real, circle.imag)))

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states at `times` (n,), in double precision."""
        t = finite_times(times)
        # Constants are rounded to doubles once.
        with ctx.workprec(working_bits(DIGITS)):
            spin, precession = (
                LinearPhase.from_balls(x.rate) for x in (self.spin, self.precession)
            )
            circle = circular_paths(t, self.precession.rate, acb(1))
            sums = (circle.real, circle.imag)
            state = self._state(DOUBLES, t, (spin(t), precession(t)), sums)
        return np.stack([np.broadcast_to(x, t.shape) for x in state], axis=1)


def _rotated_vector(F: Functions[T], vector: Sequence[T], axis: Sequence[T], angle: T) -> list[T]:
    """A vector rotated about a unit axis, or not at all."""
    sine, cosine = F.sin(angle), F.cos(angle)
    along = [a * dot(axis, vector) for a in axis]
    side = cross(axis, vector)
    return [along[k] + (cosine * (vector[k] - along[k]) + sine * side[k]) for k in range(3)]


def _quaternion(F: Functions[T], axis: Sequence[T], angle: T) -> list[T]:
    """The rotation about a unit axis."""
    sine = F.sin(angle / 2)
    return [F.cos(angle / 2)] + [sine * a for a in axis]
