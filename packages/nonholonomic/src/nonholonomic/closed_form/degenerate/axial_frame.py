"""States of a body with an axis of symmetry: its Euler angles and its position.

The angles are measured from k_r, one of the vectors fixed in space, chosen such that the axis e
stays away from it:

    φ̇ = ((e, ω) − e_r ω_r)/(1 − e_r²),        ψ̇ = (ω_r − e_r (e, ω))/(1 − e_r²).

u always oscillates.  For the Veselova system u̇² is quadratic in u.  For the Chaplygin ball e lies
on the unit sphere and, by the formula for M₃, on a conic cylinder about its centre whose quadratic
form has an eigenvalue below 1.  So if a vertex of the conic touches the sphere from inside, no
other point of the conic is inside, and e rests there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import sympy as sp
from flint import acb, arb

from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import cross, dot

from ...mechanics.rotations import quaternion_product
from ..base.solution import ClosedForm, NamedConstant
from ..one_degree import FAST, MotionSample, QuadratureMotion
from ..one_degree.frames import BodyFrame, Inclination, euler_quaternion
from ..one_degree.functions import BALLS, Count, Functions, T
from ..one_degree.solution import QuadratureSolution
from ..one_degree.uniformisation import Oscillating
from ..one_degree.vectors import conjugate, product
from .axisymmetric import Axial

#: Number of points of a period at which e is compared with the fixed vectors.
POINTS = 65


@dataclass(frozen=True)
class AxialStart:
    """A body with an axis of symmetry at the start of a motion.

    Attributes
    ----------
    system : System
        Lifted.
    parameters : mapping of Symbol to number
    title, source : str
    symmetry : int
        Number of the body axis that is e, from 0.
    attitude : four arb
        At the start.
    position : arbs
        At the start; empty for a body with a fixed point.
    """

    system: System
    parameters: Mapping[sp.Symbol, arb]
    title: str
    source: str
    symmetry: int
    attitude: Sequence[arb]
    position: Sequence[arb]

    def with_axis_last(self, vector: Sequence[arb]) -> list[arb]:
        """Components permuted such that e is the last axis."""
        i = self.symmetry
        return [vector[(i + 1) % 3], vector[(i + 2) % 3], vector[i]]

    def in_body_order(self, vector: Sequence[arb]) -> list[arb]:
        """Components in the order of the body axes, from the order in which e is last."""
        i = self.symmetry
        return [vector[(k - i - 1) % 3] for k in range(3)]


@dataclass(frozen=True)
class AxialFrame(BodyFrame):
    """The lifted state of a body with an axis of symmetry as a function of u and u̇.

    Attributes
    ----------
    axial : Axial
    reference : int
        r.
    symmetry : int
    position : two arb, or none
    attitude : four arb
        Q₀, such that ψ = 0 at time 0.
    """

    axial: Axial
    reference: int
    symmetry: int
    position: Sequence[arb]
    attitude: Sequence[arb] = ()

    def _half_angles(self, F: Functions[T], e: Sequence[T]) -> tuple[T, T]:
        """sin θ/2 and cos θ/2, both nonzero."""
        cosine = e[self.reference]
        return F.sqrt((1 - cosine) / 2), F.sqrt((1 + cosine) / 2)

    def inclination(
        self, F: Functions[T], motion: QuadratureMotion, sample: MotionSample[T, Count]
    ) -> Inclination[T]:
        """θ, and the vectors of the reduced state in the nodal frame."""
        u, rate = motion.point(F, sample)
        e = self.axial.axis(F, u, rate)
        sine, cosine = self._half_angles(F, e)
        length = 2 * sine * cosine
        unit = (float(k == self.reference) for k in range(3))
        across = [(x - e[self.reference] * y) / length for x, y in zip(unit, e, strict=True)]
        nodes = cross(across, e)
        vectors = self.axial.vectors(F, u, rate)
        parts = [(dot(v, nodes), dot(v, across), dot(v, e)) for v in vectors]
        return Inclination(sine, cosine, parts)

    def start_angles(self, motion: QuadratureMotion) -> tuple[arb, arb]:
        """φ and ψ at time 0."""
        vertical = self.axial.frame()[self.reference]
        return arb.atan2(vertical[0], vertical[1]), arb(0)

    def start_quaternion(self, motion: QuadratureMotion) -> list[arb]:
        """R₁(θ) R₃(φ) at time 0, the axis of symmetry being the last."""
        halves = self._half_angles(BALLS, self.axial.axis(BALLS, motion.x, motion.rate))
        return euler_quaternion(BALLS, *halves, *self.start_angles(motion))


def _reference(axial: Axial, chart: Oscillating) -> int:
    """The index of the fixed vector from which e keeps the largest distance."""
    largest = [0.0] * 3
    for sigma in np.linspace(-np.pi, np.pi, POINTS):
        u = chart.coordinate(BALLS, arb(sigma))
        rate = chart.slope(BALLS, arb(sigma)) / chart.clock(acb(sigma)).real
        for r, part in enumerate(axial.axis(BALLS, u, rate)):
            largest[r] = max(largest[r], abs(float(part.mid())))
    return int(np.argmin(largest))


def axial_solution(
    start: AxialStart, axial: Axial, chart: Oscillating, u: arb, rate: arb
) -> QuadratureSolution:
    """The motion with varying u, from u and u̇ at time 0."""
    r = _reference(axial, chart)
    # The fixed vectors in space axes.
    still = [product(start.attitude, start.in_body_order(k)) for k in axial.frame()]

    def rates(u: acb, rate: acb) -> list[acb]:
        e, omega = axial.axis(BALLS, u, rate), axial.omega(BALLS, u, rate)
        spin, square = dot(e, omega), 1 - e[r] * e[r]
        angles = [(spin - e[r] * omega[r]) / square, (omega[r] - e[r] * spin) / square]
        velocity = axial.velocity(BALLS, u, rate)
        if velocity is None:
            return angles
        return [*angles, *(dot(velocity, [acb(k[i]) for k in still]) for i in (0, 1))]

    length = float(axial.length.mid())
    motion = QuadratureMotion(chart, u, rate, rates, units=(1.0, 1.0, length, length))
    frame = AxialFrame(axial, r, start.symmetry, start.position)
    first, *vector = frame.start_quaternion(motion)
    inverse = conjugate([first, *start.in_body_order(vector)])
    frame = replace(frame, attitude=quaternion_product(start.attitude, inverse))
    return QuadratureSolution(
        start.system, start.parameters, motion, frame, lambda: _form(start, axial, motion)
    )


def _form(start: AxialStart, axial: Axial, motion: QuadratureMotion) -> ClosedForm:
    """The equation of u, its turning points, period and mean rates."""
    first, second = motion.chart.first.x, motion.chart.second.x
    low, high = sorted(float(x.mid()) for x in (first, second))
    period, turn, *_ = motion.advances(FAST)
    constants = (
        *(NamedConstant(*line) for line in axial.constants),
        NamedConstant("u_1", first, "turning point of u = (γ, e)"),
        NamedConstant("u_2", second, "turning point of u"),
        NamedConstant("T", period, "period of u", "s"),
        NamedConstant("phi", turn / period, "mean rate of the angle φ about e", "rad/s"),
    )
    return ClosedForm(
        title=start.title + ", two equal moments",
        motion="the axis of symmetry is periodic in space, the body turns about it",
        equations=axial.equations,
        constants=constants,
        ovals=((low, high),),
        source=start.source,
    )
