"""Segments of an impact with constant friction, as polynomials in the normal impulse."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from flowlanes.system.arrays import FloatArray

from .friction_response import FrictionResponse

#: Turning below this multiple of the machine precision counts as zero.
ROUNDING = 8 * np.finfo(float).eps


@dataclass(frozen=True, eq=False)
class Segment:
    """A segment of an impact: polynomials in a parameter θ, lowest order first.

    Attributes
    ----------
    length : float
        Value of θ at which the segment ends; infinite if it does not end by itself.
    clock : (n,) array
        The normal impulse since the start, or, where friction is infinite and there is none, the
        length of the path of the friction impulse.
    impulse : (n,) array
        Normal impulse since the start.
    friction : (2, n) array
        Impulse of friction since the start.
    couple : (n,) array
        Couple impulse since the start.
    slip : (2, n) array
        Tangential velocity.
    speed : (n,) array
        Component of the slip along the direction of sliding; None if there is no sliding friction.
    direction : (2, n) array
        Direction of sliding; None if there is no sliding friction.
    spin, normal : (n,) array
        Spin, and normal velocity.
    work : (n,) array
        Work of the normal force since the start, ∫ u_n d(clock).
    """

    length: float
    clock: FloatArray
    impulse: FloatArray
    friction: FloatArray
    couple: FloatArray
    slip: FloatArray
    speed: FloatArray | None
    direction: FloatArray | None
    spin: FloatArray
    normal: FloatArray
    work: FloatArray


def _with_constant(first: float, rest: FloatArray) -> FloatArray:
    series = rest.copy()
    series[0] += first
    return series


def _integral(series: FloatArray) -> FloatArray:
    """The antiderivative of a polynomial that vanishes at 0."""
    return np.concatenate(([0.0], series / np.arange(1, len(series) + 1)))


def _segment(
    response: FrictionResponse,
    weight: float,
    clock: FloatArray,
    friction: FloatArray,
    slip: FloatArray,
    start: tuple[float, float],
    sliding: tuple[FloatArray, FloatArray] | tuple[None, None],
    length: float,
) -> Segment:
    """Complete a segment from its friction impulse."""
    impulse = weight * clock
    spin, normal = (
        _with_constant(first, rate[0] * impulse + rate[1] @ friction)
        for first, rate in zip(start, (response.spin, response.normal), strict=True)
    )
    couple = response.couple[0] * impulse + response.couple[1] @ friction
    derivative = clock[1:] * np.arange(1, len(clock))
    work = _integral(np.convolve(normal, derivative))
    return Segment(
        length=length,
        clock=clock,
        impulse=impulse,
        friction=friction,
        couple=couple,
        slip=slip,
        speed=sliding[0],
        direction=sliding[1],
        spin=spin,
        normal=normal,
        work=work,
    )


def constant_friction(
    response: FrictionResponse,
    weight: float,
    force: FloatArray,
    slip: FloatArray,
    spin: float,
    normal: float,
    direction: FloatArray | None,
) -> Segment:
    """Motion under a constant friction force: everything is linear in the normal impulse.

    Parameters
    ----------
    response : FrictionResponse
    weight : float
        1, or 0 where friction acts in the limit of no normal impulse.
    force : (2,) array
        Friction per unit of normal impulse.
    slip : (2,) array
        The tangential velocity at the start.
    spin, normal : float
        Spin and normal velocity at the start.
    direction : (2,) array or None
        Direction of sliding, if friction ends together with it.
    """
    beta, A = response.tangential
    rate = weight * beta + A @ force
    speed = None if direction is None else np.array([slip @ direction, rate @ direction])
    return _segment(
        response,
        weight,
        np.array([0.0, 1.0]),
        np.stack([np.zeros(2), force], axis=1),
        np.stack([slip, rate], axis=1),
        (spin, normal),
        (None, None) if speed is None or direction is None else (speed, direction[:, None]),
        np.inf,
    )


def turning_rate(
    response: FrictionResponse, weight: float, mu: float, direction: FloatArray
) -> tuple[float, float, bool]:
    """H and G for a direction of sliding, and whether G is zero up to rounding."""
    beta, A = response.tangential
    friction = mu * (A @ direction)
    rate = weight * beta - friction
    along = float(rate @ direction)
    across = float(direction[0] * rate[1] - direction[1] * rate[0])
    scale = float(np.hypot(*(weight * beta)) + np.hypot(*friction))
    return along, across, bool(abs(across) <= ROUNDING * scale)
