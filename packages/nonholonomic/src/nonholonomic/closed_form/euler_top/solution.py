"""The free rigid body at any time, with its attitude.

The body turns about its momentum M, which is fixed in space; every other direction fixed in space,
such as the vertical γ, follows from the attitude.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.relative_zero import START_TOLERANCE, vanishes
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import dot

from ...mechanics.rotations import quaternion_product
from ..base.solution import Solution
from ..one_degree import Equilibrium, MotionSample, QuadratureMotion, motion_chart
from ..one_degree.frames import BodyFrame, Inclination, euler_quaternion, intrinsic_angle
from ..one_degree.functions import BALLS, Count, Functions, T
from ..one_degree.solution import QuadratureSolution
from ..one_degree.uniform import Rotation, UniformSolution
from ..one_degree.vectors import conjugate, product
from ..one_degree.working_precision import exact_time
from ..revolution.body import BITS
from .closed_form import form_of, steady_form
from .top import AXES, Top, Vector, top_of

#: The identity quaternion.
IDENTITY = (1, 0, 0, 0)


def solve_free_body(
    system: System,
    start: Sequence[NumberOrText],
    parameters: Mapping[sp.Symbol, NumberOrText],
    moments: Sequence[NumberOrText],
) -> Solution:
    """Solve the motion of a free rigid body.

    Parameters
    ----------
    system : System
        Of the catalogue entry ``free-body``, not lifted.
    start : sequence of 6 or 10 numbers
        M and γ, and the attitude of a motion in space, at time 0; read to fifty digits.
    parameters : mapping of Symbol to number
    moments : three numbers
        The principal moments about the body axes.

    Raises
    ------
    InputError
        If γ is not a unit vector, or not the vertical of the attitude.
    """
    lifted = system.lifted() if system.reconstruction else system
    with ctx.workprec(BITS):
        numbers = [exact_time(x) for x in start]
        momentum = numbers[:AXES]
        in_space = system.reconstruction is not None
        turn = numbers[2 * AXES :] if in_space else [arb(x) for x in IDENTITY]
        vertical, attitude = _on_phase_space(numbers[AXES : 2 * AXES], turn, in_space)
        fixed = product(attitude, vertical)
        inertia = [exact_time(x) for x in moments]
        G = dot(momentum, momentum).sqrt()
        uniform = _uniform_rotations(inertia, momentum)
        if uniform is not None:
            spin, precession = uniform
            return UniformRotation(
                lifted,
                parameters,
                vectors=(momentum,),
                spin=spin,
                precession=precession,
                closed_form=steady_form(inertia, momentum, spin, precession),
                attitude=attitude,
                fixed=fixed,
                in_space=in_space,
            )
        top = top_of(inertia, momentum, G)
        first, second, u = top.direction
        rate = G * first * second * (1 / top.moments[1] - 1 / top.moments[0])
        chart = motion_chart(top.equation, u, rate)
        if isinstance(chart, Equilibrium):
            raise InputError("start: the rotation is too near to one about a principal axis")
        motion = QuadratureMotion(chart, u, rate, top.rates, units=(1.0, 1.0))
        frame = FreeBodyFrame(top, attitude, motion, fixed, in_space)
        return QuadratureSolution(lifted, parameters, motion, frame, lambda: form_of(top, motion))


def _on_phase_space(vertical: Vector, attitude: Vector, in_space: bool) -> tuple[Vector, Vector]:
    """A unit vector γ and a unit quaternion such that γ is the vertical of the attitude."""
    length, size = (dot(x, x).sqrt() for x in (vertical, attitude))
    w, x, y, z = attitude
    row = (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))
    apart = sum((abs(a - b) for a, b in zip(row, vertical, strict=True)), arb(0))
    for defect, name in (
        (length - 1, "|gamma| = 1"),
        (size - 1, "|attitude| = 1"),
        (apart if in_space else arb(0), "gamma = the vertical of the attitude"),
    ):
        if not vanishes(defect, arb(1), START_TOLERANCE):
            missed = float(abs(defect).mid())
            raise InputError(f"start: it misses {name} by {missed:.3g}, and must satisfy it")
    attitude = [q / size for q in attitude]
    if in_space:
        up = [arb(0), arb(0), arb(1)]
        return product(conjugate(attitude), up), attitude
    return [x / length for x in vertical], attitude


def _uniform_rotations(moments: Vector, momentum: Vector) -> tuple[Rotation, Rotation] | None:
    """The spin and the precession for rest, permanent rotations and equal moments."""
    size = max((abs(x) for x in momentum), key=float)
    equal = [vanishes(moments[i - 2] - moments[i - 1], moments[i - 2]) for i in range(AXES)]
    if not any(equal):
        along = [i for i in range(AXES) if not vanishes(momentum[i], size)]
        if len(along) > 1:
            return None
        omega = [momentum[i] / moments[i] if i in along else arb(0) for i in range(AXES)]
        return Rotation.from_vector([arb(0)] * AXES), Rotation.from_vector(omega)
    axis = equal.index(True)
    across = moments[axis - 1]
    unit = [arb(int(i == axis)) for i in range(AXES)]
    # For three equal moments their difference is exactly zero.
    rate = arb(0) if all(equal) else (1 / moments[axis] - 1 / across) * momentum[axis]
    return Rotation(unit, rate), Rotation.from_vector([x / across for x in momentum])


def _with_fixed_direction(
    F: Functions[T], state: Sequence[T], fixed: Vector, in_space: bool
) -> list[T]:
    """M, the direction fixed in space, and the attitude, from M and the attitude."""
    momentum, attitude = list(state[:AXES]), list(state[AXES:])
    vertical = product(conjugate(attitude), [F.number(x) for x in fixed])
    return momentum + vertical + (attitude if in_space else [])


@dataclass(frozen=True, repr=False)
class UniformRotation(UniformSolution):
    """A free body at rest, in permanent rotation or in regular precession.

    Attributes
    ----------
    fixed : three arb
        The direction γ in space.
    in_space : bool
        Whether the attitude is part of the state.
    """

    fixed: Vector = ()
    in_space: bool = True

    def _state(self, F: Functions[T], time: T, angles: tuple[T, T], sums: tuple[T, T]) -> list[T]:
        state = super()._state(F, time, angles, sums)
        return _with_fixed_direction(F, state, self.fixed, self.in_space)


class FreeBodyFrame(BodyFrame):
    """M, γ and the attitude of a free body from the angle between an axis and M.

    Parameters
    ----------
    top : Top
    attitude : four arb
        At time 0.
    motion : QuadratureMotion
    fixed : three arb
        The direction γ in space.
    in_space : bool
        Whether the attitude is part of the state.
    """

    def __init__(
        self,
        top: Top,
        attitude: Vector,
        motion: QuadratureMotion,
        fixed: Vector,
        in_space: bool,
    ) -> None:
        self.top, self.symmetry = top, top.axis
        self.fixed, self.in_space = fixed, in_space
        halves = motion.half_angles(BALLS, motion.start)
        self._phi = intrinsic_angle(*halves, top.direction, top.direction)
        euler = euler_quaternion(BALLS, *halves[:2], self._phi, arb(0))
        order = [(k - top.axis - 1) % AXES for k in range(AXES)]
        turn = [euler[0]] + [euler[k + 1] for k in order]
        self.attitude = quaternion_product(attitude, conjugate(turn))

    def state(
        self,
        F: Functions[T],
        motion: QuadratureMotion,
        sample: MotionSample[T, Count],
        angles: Sequence[T],
    ) -> list[T]:
        """M, γ and the attitude."""
        state = super().state(F, motion, sample, angles)
        return _with_fixed_direction(F, state, self.fixed, self.in_space)

    def start_angles(self, motion: QuadratureMotion) -> list[arb]:
        """φ at time 0, and ψ measured from there."""
        return [self._phi, arb(0)]

    def inclination(
        self, F: Functions[T], motion: QuadratureMotion, sample: MotionSample[T, Count]
    ) -> Inclination[T]:
        """θ, and M in the nodal frame."""
        sine, cosine, _ = motion.half_angles(F, sample)
        across, u = 2 * sine * cosine, cosine * cosine - sine * sine
        G = F.number(self.top.G)
        return Inclination(sine, cosine, ((0 * u, G * across, G * u),))
