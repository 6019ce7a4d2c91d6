"""From x, x′ and the angles of a motion in one degree of freedom to its state.

The axis of a body is inclined by θ to a direction fixed in space; φ is the angle about the axis and
ψ the precession,

    Q = Q₀ R₃(ψ) R₁(θ) R₃(φ).

Every vector of the reduced state has components in the nodal frame (along the line of nodes,
perpendicular to it, along the axis) that depend only on x and x′, so its components in the body
follow from φ.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Generic

from flint import acb, arb

from ...mechanics.rotations import quaternion_product
from . import MotionSample, QuadratureMotion
from .functions import Count, Functions, T


@dataclass(frozen=True)
class Inclination(Generic[T]):
    """The inclination θ of the axis of a body, with the vectors of its reduced state.

    Attributes
    ----------
    sine, cosine : arb or array
        Of θ/2.
    vectors : sequence of three arb or arrays
        Components along the line of nodes, across it and along the axis.
    """

    sine: T
    cosine: T
    vectors: Sequence[Sequence[T]]


class MotionFrame(ABC):
    """The state of a motion as a function of x, x′ and its angles.

    Attributes
    ----------
    angles : int
        The number of quadratures that are angles: of a body φ, or φ and ψ for a motion in space.
    position : two arb, or none
        At time 0, if the path is among the quadratures.
    turning_path : bool
        Whether the path turns with ψ, and is integrated as if ψ = 0 at the turning point.
    """

    angles: int = 2
    position: Sequence[arb] = ()
    turning_path: bool = False

    @abstractmethod
    def state(
        self,
        F: Functions[T],
        motion: QuadratureMotion,
        sample: MotionSample[T, Count],
        angles: Sequence[T],
    ) -> list[T]:
        """The state without the position."""

    @abstractmethod
    def start_angles(self, motion: QuadratureMotion) -> Sequence[arb]:
        """The angles at time 0."""

    def path_speed(self, x: acb) -> acb:
        """(ẋ + iẏ) e^{−iψ} of the path in the tail of an asymptotic motion.

        To be overridden by frames whose motions may have a path and be asymptotic.
        """
        raise NotImplementedError


class BodyFrame(MotionFrame):
    """The state of a body in space, from the inclination of its axis.

    Attributes
    ----------
    symmetry : int
        Number of the body axis from which θ is counted, from 0.
    attitude : four arb, or none
        Q₀; the unit quaternion if there are none.
    """

    symmetry: int = 2
    attitude: Sequence[arb] = ()

    @abstractmethod
    def inclination(
        self, F: Functions[T], motion: QuadratureMotion, sample: MotionSample[T, Count]
    ) -> Inclination[T]:
        """θ, and the vectors of the reduced state in the nodal frame."""

    def state(
        self,
        F: Functions[T],
        motion: QuadratureMotion,
        sample: MotionSample[T, Count],
        angles: Sequence[T],
    ) -> list[T]:
        """The vectors of the reduced state, and the attitude of a motion in space."""
        inclination = self.inclination(F, motion, sample)
        # The position of each body axis in the order in which the axis of symmetry is last.
        order = [(k - self.symmetry - 1) % 3 for k in range(3)]
        phi = angles[0]
        sin, cos = F.sin(phi), F.cos(phi)
        state: list[T] = []
        for along, across, axial in inclination.vectors:
            body = [along * cos + across * sin, across * cos - along * sin, axial]
            state += [body[k] for k in order]
        if self.angles == 2:
            euler = euler_quaternion(F, inclination.sine, inclination.cosine, phi, angles[1])
            turn = [euler[0]] + [euler[k + 1] for k in order]
            constant = [F.number(q) for q in self.attitude]
            state += quaternion_product(constant, turn) if constant else turn
        return state


def euler_quaternion(F: Functions[T], sine: T, cosine: T, phi: T, psi: T) -> list[T]:
    """R₃(ψ) R₁(θ) R₃(φ), from sin θ/2 and cos θ/2."""
    plus, minus = (psi + phi) / 2, (psi - phi) / 2
    return [cosine * F.cos(plus), sine * F.cos(minus), sine * F.sin(minus), cosine * F.sin(plus)]


def intrinsic_angle(
    sine: arb, cosine: arb, lean: arb, vertical: Sequence[arb], turning: Sequence[arb]
) -> arb:
    """φ at a start, from the vertical or, if the axis is vertical, from the rotation.

    Parameters
    ----------
    sine, cosine : arb
        Of θ/2, with their signs.
    lean : arb
        θ̇, or a number with its sign.
    vertical, turning : three arb
        γ, and ω or the angular momentum; body axes, the axis of symmetry last.
    """
    across = 2 * sine * cosine
    if across > 0 or across < 0:
        return arb.atan2(vertical[0] / across, vertical[1] / across)
    if lean > 0 or lean < 0:
        return arb.atan2(-turning[1] / lean, turning[0] / lean)
    return arb(0)
