"""Which degenerate motion it is: roots that collide, and constants of the motion from its start."""

from __future__ import annotations

from itertools import pairwise, product
from typing import Any

import numpy as np
from flint import arb, arb_mat

from ...formulas.relative_zero import vanishes
from .elliptic_curve import Oval, oval_around
from .exact_start import Beginning
from .theta_motion import Asymptotic, Periodic, direction, direction_array

__all__ = ["double_roots", "motion_at_double_root"]

#: Step of difference quotients at the working precision.
STEP = arb(2) ** (-140)


def double_roots(beginning: Beginning) -> list[tuple[Any, list[Any]]]:
    """The double roots of the curve, each with the roots that are left without it.

    Poles come first in the list of roots, so that a collision with a pole is put at the pole.
    """
    found = []
    roots = beginning.roots
    for i, one in enumerate(roots):
        for j in range(i + 1, len(roots)):
            if vanishes((one - roots[j]).mid(), beginning.size):
                found.append((one, [r for k, r in enumerate(roots) if k not in (i, j)]))
    return found


def motion_at_double_root(
    beginning: Beginning, e: Any, others: list[Any]
) -> Periodic | Asymptotic | None:
    """The motion on the curve with the double root e.

    Returns
    -------
    Periodic, Asymptotic or None
        None when both variables move away from e, or the curve degenerates further.
    """
    ordered = sorted(others, key=lambda root: root.mid())
    if any(vanishes((y - x).mid(), beginning.size) for x, y in pairwise(ordered)):
        return None
    if _stays(beginning, e):
        z = beginning.total[0] - e
        oval = oval_around(beginning.leading, others, z)
        return None if oval is None else _one_frequency(beginning, e, z, oval)
    oval = oval_around(beginning.leading, others, e)
    apart, size = beginning.separating(e).mid(), beginning.size * beginning.size
    if oval is None or (apart > 0 and not vanishes(apart, size)):
        return None
    return _between(beginning, e, oval)


def _stays(beginning: Beginning, e: Any) -> bool:
    """Whether one of the variables stays at the double root.

    At a pole it does where the component and its rate vanish: both variables may pass it together.
    """
    parts = zip(beginning.poles, beginning.nu, beginning.nuprime, strict=True)
    speed = sum((abs(x.mid()) for x in beginning.nuprime), arb(0))
    for pole, nu, rate in parts:
        if vanishes((pole - e).mid(), beginning.size):
            return vanishes(nu.mid(), arb(1)) and vanishes(rate.mid(), speed)
    return vanishes(beginning.separating(e).mid(), beginning.size * beginning.size)


def _one_frequency(beginning: Beginning, e: Any, z: Any, oval: Oval) -> Periodic:
    speed, turn = ((b - a * e) / oval.scale for a, b in (beginning.speeds, beginning.along))
    phase = oval.phase(z, beginning.total[1] / turn)
    indices, amplitudes = [], []
    parts = zip(beginning.poles, beginning.weights, beginning.nu, beginning.nuprime, strict=True)
    for pole, weight, nu, rate in parts:
        index = oval.index(pole)
        if index is None:
            indices.append(1)
            amplitudes.append(arb(0))
            continue
        size = abs(weight * (pole - e) * oval.factor(pole)).sqrt()
        value, slope = oval.thetas.pair(index, phase)
        # the sign is read off the component, or off its rate where the component is small
        seen = nu * value if abs(nu) > abs(rate / turn) else rate * slope * turn
        indices.append(index)
        amplitudes.append(size if seen > 0 else -size)
    return Periodic(oval.thetas, tuple(indices), tuple(amplitudes), phase.mid(), speed, turn)


def _between(beginning: Beginning, e: Any, oval: Oval) -> Asymptotic:
    slope = oval.square(e).sqrt()
    s = oval.phase(e, slope * oval.scale)
    value, rate = oval.thetas.pair(1, s)
    constant = slope * oval.scale / (oval.ends[0] - e) + 2 * rate / value
    (speed, growth), turn = (
        (U, (a * slope - constant * U) / 2)
        for a, b in (beginning.speeds, beginning.along)
        for U in [(b - a * e) / oval.scale]
    )
    indices, amplitudes = [], []
    for pole, weight in zip(beginning.poles, beginning.weights, strict=True):
        index = oval.index(pole)
        root = abs(weight).sqrt()
        if index is None:
            indices.append(0)
            size = oval.simple_factor(e, s) * oval.thetas.value(1, 2 * s)
        else:
            indices.append(index)
            size = oval.factor(pole) * oval.thetas.value(index, s)
        amplitudes.append(root * abs(size))
    made = Asymptotic(
        oval.thetas, s, tuple(indices), tuple(amplitudes), arb(0), speed, arb(0), growth, turn
    )
    return _begun(made, beginning)


def _begun(made: Asymptotic, beginning: Beginning) -> Asymptotic:
    """The motion with the phases U, κ and the reflections that the start has."""
    target = np.array([[float(x) for x in beginning.nu], [float(x) for x in beginning.nuprime]])
    rate = max(abs(float(x)) for x in made.turn)
    unit = np.array([[1.0], [rate]]) * np.ones((2, 3))
    dying = made.indices.index(0)
    small = np.hypot(target[0, dying], target[1, dying] / unit[1, dying])
    unit[:, dying] *= small
    reach = 4 - np.log(small)
    U, kappa = np.meshgrid(
        np.linspace(0, 2 * np.pi, 121)[:-1], np.arange(-reach, reach, 0.1), indexing="ij"
    )
    phases = (U.ravel(), kappa.ravel())
    nu, rates = direction_array(*made.with_phases(*phases))
    guesses = []
    for signs in product((1, -1), repeat=3):
        turned = np.array(signs)[:, None]
        gap = (turned * nu - target[0][:, None]) / unit[0][:, None]
        rate_gap = (turned * rates - target[1][:, None]) / unit[1][:, None]
        miss = (gap**2 + rate_gap**2).sum(0)
        best = int(np.argmin(miss))
        guesses.append((miss[best], phases[0][best], phases[1][best], signs))
    _, phase, offset, signs = min(guesses)
    begun = made.begun(arb(phase), arb(offset), signs)
    wanted = [*beginning.nu, *beginning.nuprime]
    weights = [1 / arb(float(x)) for x in unit.ravel()]
    for _ in range(60):
        step = _gauss_newton(begun, wanted, weights)
        begun = begun.begun(
            (begun.phase + step[0]).mid(), (begun.offset + step[1]).mid(), (1, 1, 1)
        )
        if all(abs(x.mid()) < STEP**2 for x in step):
            return begun
    raise ArithmeticError("the phases of an asymptotic motion were not found")


def _gauss_newton(begun: Asymptotic, wanted: list[Any], weights: list[Any]) -> list[Any]:
    """The step in U and κ that brings the motion at τ = 0 nearest to the start."""

    def seen(phase: Any, offset: Any) -> list[Any]:
        nu, rate = direction(*begun.begun(phase, offset, (1, 1, 1)).at(arb(0)))
        return [w * x.mid() for w, x in zip(weights, [*nu, *rate], strict=True)]

    here = seen(begun.phase, begun.offset)
    missed = arb_mat([[w * x.mid() - h] for w, x, h in zip(weights, wanted, here, strict=True)])
    moved = (seen(begun.phase + STEP, begun.offset), seen(begun.phase, begun.offset + STEP))
    slope = arb_mat([[(m[i] - here[i]) / STEP for m in moved] for i in range(6)])
    slope = slope.mid()
    normal = slope.transpose() * slope
    step = normal.solve(slope.transpose() * missed.mid())
    return list(step.entries())
