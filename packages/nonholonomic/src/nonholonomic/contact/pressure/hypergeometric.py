"""Gauss's hypergeometric function ₂F₁(a, ½; c; z) for 0 ≤ z ≤ 1, relatively accurate."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from flowlanes.system.arrays import FloatArray

#: Step and limits of the trapezoidal rule.
_STEP, _FAR = 0.25, 80.0
#: Number of z values evaluated at once; each needs one number per node.
_CHUNK = 4096


def series_coefficients(a: Fraction, b: Fraction, c: Fraction, number: int) -> list[Fraction]:
    """The first coefficients of ₂F₁(a, b; c; z) = Σ (a)ₙ(b)ₙ/((c)ₙ n!) zⁿ, exactly."""
    coefficients = [Fraction(1)]
    for n in range(number - 1):
        coefficients.append(coefficients[-1] * (a + n) * (b + n) / ((c + n) * (n + 1)))
    return coefficients


def _rule(c: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Logarithms of t and 1 − t at the nodes, and weights for t^(−1/2) (1 − t)^(c−3/2)."""
    v = np.arange(-_FAR, _FAR + _STEP / 2, _STEP)
    log_t, log_tau = -np.logaddexp(0.0, v), -np.logaddexp(0.0, -v)
    return log_t, log_tau, _STEP * np.exp(0.5 * log_t + (c - 0.5) * log_tau)


def half_beta(b: float) -> float:
    """Euler's beta function B(½, b) for b ≥ ½, where b may be large."""
    return float(_rule(b + 0.5)[2].sum())


def half_hypergeometric(a: float, c: float, z: FloatArray, complement: FloatArray) -> FloatArray:
    """₂F₁(a, ½; c; z) for c > ½, as a sum of positive terms.

    Euler's integral ∫ t^(−1/2) (1 − t)^(c−3/2) (1 − zt)^(−a) dt over 0 < t < 1, divided by its
    value at z = 0.  With t = 1/(1 + eᵛ) all singularities have Im v = ±π for every z, so the
    trapezoidal rule converges geometrically, uniformly up to z = 1.

    Parameters
    ----------
    a, c : float
        With c − a ≥ 1; above ½ the function is finite at z = 1.
    z, complement : arrays of one shape
        0 ≤ z ≤ 1, and 1 − z without cancellation.
    """
    log_t, log_tau, weights = _rule(c)
    # The power lies between 1 and its value at z = 1.
    near = weights * (1 + np.exp(-a * log_tau))
    used = near > 1e-22 * near.max()
    nodes = np.exp(log_t[used]), np.exp(log_tau[used])
    pairs = np.stack([z.ravel(), complement.ravel()], axis=1)
    parts = [
        (_power(a, part[:, :1], part[:, 1:], *nodes) * weights[used]).sum(axis=1)
        for part in np.array_split(pairs, len(pairs) // _CHUNK + 1)
    ]
    total: FloatArray = np.concatenate(parts).reshape(z.shape) / weights[used].sum()
    return total


def _power(
    a: float, z: FloatArray, complement: FloatArray, t: FloatArray, tau: FloatArray
) -> FloatArray:
    """(1 − zt)^(−a) with τ = 1 − t, accurate where zt is close to 0 and where it is close to 1."""
    product = z * t
    logarithm = np.where(
        product < 0.5,
        np.log1p(-np.minimum(product, 0.5)),
        np.log(np.maximum(complement + z * tau, 1e-300)),
    )
    power: FloatArray = np.exp(-a * logarithm)
    return power
