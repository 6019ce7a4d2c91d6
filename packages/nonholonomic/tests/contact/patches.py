"""Friction over a patch from its definition: integrals over the patch, by other means."""

from __future__ import annotations

import mpmath as mp
import numpy as np

HALF = mp.mpf(1) / 2


def double_exponential(step=0.02, far=3.9):
    """Nodes x on (0, 1), 1 − x and weights; endpoint singularities do no harm."""
    t = np.arange(-far, far + step / 2, step)
    argument = np.pi * np.sinh(t)
    x, complement = 1 / (1 + np.exp(-argument)), 1 / (1 + np.exp(argument))
    return x, complement, step * np.pi * np.cosh(t) * x * complement


def defined_factors(density, k):
    """φ, F and M of a round patch of radius 1: ∫ p |u + Ω γ×ρ| dA and what follows from it.

    `density(r, 1 − r)` is p for N = 1.  The distance from the point that does not slide is
    √((k − r)² + 4kr sin²(ψ/2)), with ψ the angle between both; the disk is cut at r = k.
    """
    t, rest, weight = double_exponential()
    half_angles = np.pi / 2 * t
    total = np.zeros(3)
    edge = min(k, 1.0)
    pieces = [(edge * t, (k - edge) + edge * rest, (1 - edge) + edge * rest, edge)]
    if k < 1:
        pieces.append((k + (1 - k) * t, -(1 - k) * t, (1 - k) * rest, 1 - k))
    for *columns, width in pieces:
        r, excess, from_edge = (column[:, None] for column in columns)
        lean = 2 * np.sin(half_angles) ** 2
        distance = np.sqrt(excess**2 + 2 * k * r * lean)
        area = 2 * np.pi * r * density(r, from_edge) * np.outer(width * weight, weight)
        total += [
            (area * distance).sum(),
            (area * (excess + r * lean) / distance).sum(),
            (area * r * (k * lean - excess) / distance).sum(),
        ]
    return total


def potential(n, k):
    """φ(k) under the pressure ~ (1 − ρ²/a²)ⁿ, n > −1, or of the ring, n = −1; multiprecision."""
    if k <= 1:
        at_rest = mp.gamma(3 * HALF) * mp.gamma(n + 2) / mp.gamma(n + 5 * HALF)
        return at_rest * mp.hyp2f1(-HALF, -n - 3 * HALF, 1, k**2)
    return k * mp.hyp2f1(-HALF, -HALF, n + 2, k**-2)


def exact_factors(n, k):
    """F and M from the derivative of φ's series, in multiprecision."""
    n, k = mp.mpf(n), mp.mpf(k)
    if k <= 1:
        at_rest = mp.gamma(3 * HALF) * mp.gamma(n + 2) / mp.gamma(n + 5 * HALF)
        slope = at_rest * (2 * n + 3)
        force = slope * k / 2 * mp.hyp2f1(HALF, -n - HALF, 2, k**2)
        zero_th = mp.hyp2f1(HALF, -n - 3 * HALF, 1, k**2)
        return force, at_rest * zero_th
    far = mp.hyp2f1(HALF, HALF, n + 3, k**-2)
    return mp.hyp2f1(-HALF, HALF, n + 2, k**-2), far / (2 * (n + 2) * k)


def relative_error(values, exact):
    """The greatest relative error of numbers."""
    return max(float(abs(mp.mpf(float(v)) / e - 1)) for v, e in zip(values, exact, strict=True))
