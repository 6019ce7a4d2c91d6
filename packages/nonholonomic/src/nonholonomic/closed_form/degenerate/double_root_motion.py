"""Motions at a double root of the curve, with constants determined by the start."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np
from flint import arb, arb_mat

from flowlanes.formulas.relative_zero import vanishes

from ..one_degree.functions import BALLS, DOUBLES
from .elliptic_curve import Oval, oval_around
from .exact_start import ExactStart
from .theta_motion import Asymptotic, Periodic, direction

#: Step of difference quotients at the working precision.
STEP = arb(2) ** (-140)


def motion_at_double_root(
    start: ExactStart, e: arb, others: list[arb]
) -> Periodic | Asymptotic | None:
    """The motion on the curve with the double root e.

    Returns
    -------
    Periodic, Asymptotic or None
        None when both variables move away from e, or the curve degenerates further.
    """
    ordered = sorted(others, key=lambda root: root.mid())
    if any(vanishes((y - x).mid(), start.size) for x, y in pairwise(ordered)):
        return None
    if _stays(start, e):
        z = start.total[0] - e
        oval = oval_around(start.leading, others, z)
        return None if oval is None else _periodic_motion(start, e, z, oval)
    oval = oval_around(start.leading, others, e)
    apart, size = start.separating(e).mid(), start.size * start.size
    if oval is None or (apart > 0 and not vanishes(apart, size)):
        return None
    return _asymptotic_motion(start, e, oval)


def _stays(start: ExactStart, e: arb) -> bool:
    """Whether one of the variables stays at the double root.

    At a pole this holds if the component and its rate vanish: both variables may pass it together.
    """
    parts = zip(start.poles, start.nu, start.nuprime, strict=True)
    speed = sum((abs(x.mid()) for x in start.nuprime), arb(0))
    for pole, nu, rate in parts:
        if vanishes((pole - e).mid(), start.size):
            return vanishes(nu.mid(), arb(1)) and vanishes(rate.mid(), speed)
    return vanishes(start.separating(e).mid(), start.size * start.size)


def _periodic_motion(start: ExactStart, e: arb, z: arb, oval: Oval) -> Periodic:
    speed, turn = ((b - a * e) / oval.scale for a, b in (start.speeds, start.along))
    phase = oval.phase(z, start.total[1] / turn)
    indices, amplitudes = [], []
    parts = zip(start.poles, start.weights, start.nu, start.nuprime, strict=True)
    for pole, weight, nu, rate in parts:
        index = oval.index(pole)
        if index is None:
            indices.append(1)
            amplitudes.append(arb(0))
            continue
        size = abs(weight * (pole - e) * oval.factor(pole)).sqrt()
        value, slope = oval.thetas.pair(index, phase)
        # The sign follows from the component, or from its rate where the component is small.
        seen = nu * value if abs(nu) > abs(rate / turn) else rate * slope * turn
        indices.append(index)
        amplitudes.append(size if seen > 0 else -size)
    return Periodic(oval.thetas, tuple(indices), tuple(amplitudes), phase.mid(), speed, turn)


def _asymptotic_motion(start: ExactStart, e: arb, oval: Oval) -> Asymptotic:
    slope = oval.square(e).sqrt()
    s = oval.phase(e, slope * oval.scale)
    value, rate = oval.thetas.pair(1, s)
    constant = slope * oval.scale / (oval.ends[0] - e) + 2 * rate / value
    (speed, growth), turn = (
        (U, (a * slope - constant * U) / 2)
        for a, b in (start.speeds, start.along)
        for U in [(b - a * e) / oval.scale]
    )
    indices, amplitudes = [], []
    for pole, weight in zip(start.poles, start.weights, strict=True):
        index = oval.index(pole)
        root = abs(weight).sqrt()
        if index is None:
            indices.append(0)
            size = oval.simple_factor(e, s) * oval.thetas.value(1, 2 * s)
        else:
            indices.append(index)
            size = oval.factor(pole) * oval.thetas.value(index, s)
        amplitudes.append(root * abs(size))
    motion = Asymptotic(
        oval.thetas, s, tuple(indices), tuple(amplitudes), arb(0), speed, arb(0), growth, turn
    )
    return _through(motion, start)


def _through(motion: Asymptotic, start: ExactStart) -> Asymptotic:
    """The motion through the start, with its phases U, κ and its reflections."""
    target = np.array([[float(x) for x in start.nu], [float(x) for x in start.nuprime]])
    rate = max(abs(float(x)) for x in motion.turn)
    unit = np.array([[1.0], [rate]]) * np.ones((2, 3))
    dying = motion.indices.index(0)
    small = np.hypot(target[0, dying], target[1, dying] / unit[1, dying])
    unit[:, dying] *= small
    reach = 4 - np.log(small)
    U, kappa = np.meshgrid(
        np.linspace(0, 2 * np.pi, 121)[:-1], np.arange(-reach, reach, 0.1), indexing="ij"
    )
    phases = (U.ravel(), kappa.ravel())
    nu, rates = (np.array(x) for x in direction(DOUBLES, *motion.with_phases(*phases)))
    guesses = []
    for signs in product((1, -1), repeat=3):
        reflection = np.array(signs)[:, None]
        gap = (reflection * nu - target[0][:, None]) / unit[0][:, None]
        rate_gap = (reflection * rates - target[1][:, None]) / unit[1][:, None]
        miss = (gap**2 + rate_gap**2).sum(0)
        best = int(np.argmin(miss))
        guesses.append((miss[best], phases[0][best], phases[1][best], signs))
    _, phase, offset, signs = min(guesses)
    motion = motion.with_start(arb(phase), arb(offset), signs)
    wanted = [*start.nu, *start.nuprime]
    weights = [1 / arb(float(x)) for x in unit.ravel()]
    for _ in range(60):
        step = _gauss_newton(motion, wanted, weights)
        motion = motion.with_start((motion.phase + step[0]).mid(), (motion.offset + step[1]).mid())
        if all(abs(x.mid()) < STEP**2 for x in step):
            return motion
    raise ArithmeticError("the phases of an asymptotic motion were not found")


def _gauss_newton(motion: Asymptotic, goals: list[arb], weights: list[arb]) -> list[arb]:
    """The Gauss–Newton step in U and κ that brings the motion at τ = 0 closest to the start."""

    def weighted_components(phase: arb, offset: arb) -> list[arb]:
        nu, rate = direction(BALLS, *motion.with_start(phase, offset).balls(arb(0)))
        return [w * x.mid() for w, x in zip(weights, [*nu, *rate], strict=True)]

    here = weighted_components(motion.phase, motion.offset)
    missed = arb_mat([[w * x.mid() - h] for w, x, h in zip(weights, goals, here, strict=True)])
    moved = (
        weighted_components(motion.phase + STEP, motion.offset),
        weighted_components(motion.phase, motion.offset + STEP),
    )
    slope = arb_mat([[(m[i] - here[i]) / STEP for m in moved] for i in range(6)])
    slope = slope.mid()
    normal = slope.transpose() * slope
    step = normal.solve(slope.transpose() * missed.mid())
    return list(step.entries())
