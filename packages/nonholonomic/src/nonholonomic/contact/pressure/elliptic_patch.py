r"""Coulomb's friction over an elliptic patch under Hertz's pressure, sliding and spinning at once.

A patch with semi-axes a and b that slides with u and spins with Ω turns about the point

    d = γ×u/Ω,

which does not slide (from its centre, along its axes).  The power lost is μ N |Ω| ψ(d), the force
μ N sgn Ω γ×∇ψ, which in general is not against u, and the couple −μ N sgn Ω (ψ − d·∇ψ), where

    ψ(d) = (1/N) ∫ p |ρ − d| dA,        p = (3N/2πab) √(1 − ρ₁²/a² − ρ₂²/b²).

In polar coordinates about d the integral along a chord is elementary.  With D = (d₁/a, d₂/b),
chords in the direction (a cos φ, b sin φ), and

    β = a² cos²φ + b² sin²φ,    s = D₁ cos φ + D₂ sin φ,    x = D₁ sin φ − D₂ cos φ,    T² = 1 − x²,

there remain

    ψ       = ¾ ∫ √β (T² s² + T⁴/4) dφ
    ∇ψ      = ¾ ∫ T² s (a cos φ, b sin φ)/√β dφ
    ψ−d·∇ψ  = ¾ ∫ [√β T⁴/4 − T² s x (a² − b²) sin φ cos φ/√β] dφ

over half a turn of chords, those with T² > 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

#: Smallest ratio of the semi-axes.
SLENDEREST = 0.01
#: The quadrature rules are accurate to exp(−_EXPONENT).
_EXPONENT = 37.0
#: Number of integrand values computed at once; it bounds memory use.
_CHUNK = 2**20

PointFunction: TypeAlias = Callable[[FloatArray], FloatArray]


@dataclass(frozen=True)
class EllipticHertz:
    """An elliptic patch of contact with semi-axes a and b under Hertz's pressure.

    The integrands are analytic in φ but for the zeros of β, at the distance artanh(b/a) from the
    real axis if b < a.  Inside the patch every chord counts, the integrands have the period π, and
    the trapezoidal rule converges geometrically; outside, between the two tangents, Fejér's does
    (as Gauss's, whose weights are less accurate in floating-point numbers, would with half the
    nodes).

    Parameters
    ----------
    a, b : float
        Semi-axes (m), neither more than 100 times the other.

    Raises
    ------
    InputError
        If a semi-axis is not positive, or the patch is too slender.

    Examples
    --------
    >>> from nonholonomic.contact.pressure import EllipticHertz
    >>> patch = EllipticHertz(2.0, 1.0)
    >>> patch.potential([[0.0, 0.0], [3.0, 1.0]])
    array([0.90829202, 3.20597823])
    """

    a: float
    b: float

    def __post_init__(self) -> None:
        if not (0 < self.a < math.inf and 0 < self.b < math.inf):
            raise InputError(
                f"semi-axes {self.a} and {self.b} of the patch: they must be positive and finite"
            )
        if min(self.a, self.b) < SLENDEREST * max(self.a, self.b):
            raise InputError(
                f"semi-axes {self.a} and {self.b} of the patch: neither may be more than "
                f"{1 / SLENDEREST:g} times the other"
            )

    def potential(self, d: npt.ArrayLike) -> FloatArray:
        """The mean distance ψ (m) of the pressure from points d, shape (..., 2) (m)."""
        return self._integral(d, self._potential_inside, self._potential_outside)[..., 0]

    def gradient(self, d: npt.ArrayLike) -> FloatArray:
        """The gradient of ψ at points d, shape (..., 2)."""
        return self._integral(d, self._gradient_inside, self._gradient_outside)

    def couple(self, d: npt.ArrayLike) -> FloatArray:
        """ψ − d·∇ψ (m), the couple in units of μN; without cancellation for distant d."""
        return self._integral(d, self._couple_inside, self._couple_outside)[..., 0]

    def _integral(
        self, d: npt.ArrayLike, inside: PointFunction, outside: PointFunction
    ) -> FloatArray:
        """Values at points: one quadrature inside the patch and another one outside."""
        points = np.asarray(d, dtype=float)
        if points.shape[-1:] != (2,) or not np.all(np.isfinite(points)):
            raise InputError("points d of the patch: they must be finite, of shape (..., 2)")
        scaled = (points / [self.a, self.b]).reshape(-1, 2)
        within = np.hypot(*scaled.T) <= 1
        values: dict[bool, FloatArray] = {}
        for where, integral, nodes in (
            (True, inside, self._half_turn_nodes.size),
            (False, outside, self._fejer[0].size),
        ):
            chosen = scaled[within == where]
            pieces = np.array_split(chosen, len(chosen) * nodes // _CHUNK + 1)
            values[where] = np.concatenate([integral(piece) for piece in pieces])
        total = np.empty((len(scaled), values[True].shape[-1]))
        total[within], total[~within] = values[True], values[False]
        return total.reshape(*points.shape[:-1], -1)

    @cached_property
    def _strip_half_width(self) -> float:
        """Distance of the zeros of β from the real axis, capped where it no longer matters."""
        ratio = min(self.a, self.b) / max(self.a, self.b)
        return math.atanh(min(ratio, 0.99))

    @cached_property
    def _half_turn_nodes(self) -> FloatArray:
        """Nodes φ of the trapezoidal rule on half a turn."""
        number = math.ceil(_EXPONENT / (2 * self._strip_half_width)) + 6
        nodes: FloatArray = math.pi / number * np.arange(number, dtype=float)
        return nodes

    @cached_property
    def _fejer(self) -> tuple[FloatArray, FloatArray]:
        """Positive nodes and the weights of Fejér's rule on −1 ≤ t ≤ 1."""
        height = self._strip_half_width / (math.pi / 2)
        half = math.ceil(_EXPONENT / (2 * math.asinh(height))) + 10
        angles = math.pi * (np.arange(half) + 0.5) / (2 * half)
        orders = np.arange(1, half)
        series = (np.cos(2 * np.outer(angles, orders)) / (4 * orders**2 - 1)).sum(axis=1)
        return np.cos(angles), (1 - 2 * series) / half

    def _root(self, phi: FloatArray) -> FloatArray:
        root: FloatArray = np.hypot(self.a * np.cos(phi), self.b * np.sin(phi))
        return root

    def _chords_inside(self, D: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """s, x and T² at points (rows) for the chords of the trapezoidal rule (columns)."""
        cos, sin = np.cos(self._half_turn_nodes), np.sin(self._half_turn_nodes)
        s = D[:, :1] * cos + D[:, 1:] * sin
        x = D[:, :1] * sin - D[:, 1:] * cos
        return s, x, (1 - x) * (1 + x)

    def _mean(self, integrand: FloatArray) -> FloatArray:
        total: FloatArray = 0.75 * math.pi / self._half_turn_nodes.size * integrand.sum(axis=1)
        return total

    def _potential_inside(self, D: FloatArray) -> FloatArray:
        s, _, T = self._chords_inside(D)
        return self._mean(self._root(self._half_turn_nodes) * T * (s**2 + T / 4))[:, None]

    def _gradient_inside(self, D: FloatArray) -> FloatArray:
        s, _, T = self._chords_inside(D)
        along = T * s / self._root(self._half_turn_nodes)
        both = [self.a * np.cos(self._half_turn_nodes), self.b * np.sin(self._half_turn_nodes)]
        return np.stack([self._mean(along * component) for component in both], axis=1)

    def _couple_inside(self, D: FloatArray) -> FloatArray:
        s, x, T = self._chords_inside(D)
        root = self._root(self._half_turn_nodes)
        difference = (self.a - self.b) * (self.a + self.b)
        product = difference * np.sin(2 * self._half_turn_nodes) / 2
        return self._mean(T * (root * T / 4 - s * x * product / root))[:, None]

    def _chords_outside(self, D: FloatArray) -> tuple[FloatArray, ...]:
        """Direction φ₀ of each point, angle χ > 0 from it, s, x, T² there, and the weights."""
        distance = np.hypot(*D.T)[:, None]
        nodes, weights = self._fejer
        half = np.arcsin(np.minimum(1 / distance, 1))
        chi = half * nodes
        x = distance * np.sin(chi)
        towards = np.arctan2(D[:, 1:], D[:, :1])
        return (
            towards,
            chi,
            distance * np.cos(chi),
            x,
            np.maximum((1 - x) * (1 + x), 0),
            0.75 * half * weights,
        )

    def _potential_outside(self, D: FloatArray) -> FloatArray:
        towards, chi, s, _, T, weights = self._chords_outside(D)
        roots = self._root(towards + chi) + self._root(towards - chi)
        # T² s² is kept apart from T⁴/4, which is far smaller for distant points.
        total: FloatArray = (weights * roots * T * (s**2 + T / 4)).sum(axis=1)
        return total[:, None]

    def _gradient_outside(self, D: FloatArray) -> FloatArray:
        towards, chi, s, _, T, weights = self._chords_outside(D)
        components = []
        for axis, function in ((self.a, np.cos), (self.b, np.sin)):
            pair = sum(function(phi) / self._root(phi) for phi in (towards + chi, towards - chi))
            components.append(axis * (weights * T * s * pair).sum(axis=1))
        return np.stack(components, axis=1)

    def _couple_outside(self, D: FloatArray) -> FloatArray:
        towards, chi, s, x, T, weights = self._chords_outside(D)
        plus, minus = self._root(towards + chi), self._root(towards - chi)
        difference = (self.a - self.b) * (self.a + self.b)
        # x is odd in χ, so only the odd part of sin φ cos φ/√β contributes; it is computed exactly.
        sines = np.sin(2 * towards) * np.cos(2 * chi)
        cosines = np.cos(2 * towards) * np.sin(2 * chi)
        roots = difference * np.sin(2 * towards) * np.sin(2 * chi) / (plus + minus)
        odd = (cosines * (1 / plus + 1 / minus) + sines * roots / (plus * minus)) / 2
        total: FloatArray = (weights * T * (T * (plus + minus) / 4 - difference * s * x * odd)).sum(
            axis=1
        )
        return total[:, None]
