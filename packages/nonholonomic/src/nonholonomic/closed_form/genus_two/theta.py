"""Riemann's theta function of genus two for real arguments and period matrix iY.

    θ[a, b](v) = Σ exp(−π (m, Ym)) cos 2π(m, v + b),       m ∈ ℤ² + a,

with half-integer characteristics a, b.  It changes at most its sign if v moves by an integer
vector.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from math import ceil, pi, sqrt

import numpy as np
from flint import arb, arb_mat, ctx

from flowlanes.formulas.balls import number
from flowlanes.system.arrays import FloatArray

#: Number of points computed at once.
_BLOCK = 16384

Characteristic = tuple[tuple[int, int], tuple[int, int]]


@dataclass(frozen=True)
class Theta:
    """θ[a, b] for one period matrix.

    Attributes
    ----------
    Y : arb_mat (2, 2)
        Symmetric, positive definite.
    characteristic : (a, b)
        In units of one half.
    """

    Y: arb_mat
    characteristic: Characteristic

    @cached_property
    def _least(self) -> arb:
        """A lower bound of the eigenvalues of Y."""
        trace, det = self.Y[0, 0] + self.Y[1, 1], self.Y.det()
        # The smaller eigenvalue, in a form without the cancellation in trace − √(…).
        return 2 * det / (trace + (trace**2 - 4 * det).sqrt())

    def terms(self, bits: int) -> tuple[tuple[tuple[int, int], arb], ...]:
        """2m and exp(−π (m, Ym)) for all significant m at a given number of bits."""
        # m and −m share one term with twice the weight.
        reach = (bits + 10) * 0.6931471805599453 / pi
        size = ceil(sqrt(reach / number(self._least.lower()))) + 1
        a = self.characteristic[0]
        terms = []
        for m in product(range(-size, size + 1), repeat=2):
            p = (2 * m[0] + a[0], 2 * m[1] + a[1])
            if p < (0, 0):
                continue
            power = self._form(p)
            if number(power) < reach:
                weight = (-arb.pi() * power).exp()
                terms.append((p, weight if p == (0, 0) else 2 * weight))
        return tuple(terms)

    def _form(self, p: tuple[int, int]) -> arb:
        Y = self.Y
        return (p[0] ** 2 * Y[0, 0] + 2 * p[0] * p[1] * Y[0, 1] + p[1] ** 2 * Y[1, 1]) / 4

    def tail(self, bits: int) -> arb:
        """A bound of the sum of |2πm|^j exp(−π (m, Ym)), j = 0 or 1, over all omitted terms.

        The omitted terms have (m, Ym) ≥ ρ, where ρ is the reach of :meth:`terms`.  There exp(−π (m,
        Ym)) ≤ exp(−πρ/2) exp(−π (m, Ym)/2), and the sum of the latter over the whole lattice is
        bounded by a product of two one-dimensional sums.
        """
        reach = arb(bits) * arb(2).log() / arb.pi()
        least = arb(self._least.lower())
        # Σ over ℤ + a of (1 + 2π|m|) exp(−πλ m²/4) for the sum, with |m| ≤ |m₁| + |m₂|
        quarter = (-arb.pi() * least / 8).exp()
        line = arb(0)
        for k in range(200):
            line += 2 * (1 + arb.pi() * (k + 1)) * quarter ** (k * k)
            if quarter ** (k * k) * (k + 1) < arb(2) ** -20:
                break
        line = line * (1 + arb(2) ** -8) / (1 - quarter)
        return (-arb.pi() * reach / 2).exp() * line**2

    def ball(self, v: Sequence[arb], V: Sequence[arb]) -> tuple[arb, arb]:
        """θ and its derivative along V at v, as balls."""
        value, slope = arb(0), arb(0)
        b = self.characteristic[1]
        bits = ctx.prec
        at = [x + arb(half) / 2 for x, half in zip(v, b, strict=True)]
        for p, weight in self.terms(2 * bits):
            # cos_pi keeps its accuracy for large arguments.
            phase = p[0] * at[0] + p[1] * at[1]
            value += weight * phase.cos_pi()
            slope -= arb.pi() * (p[0] * V[0] + p[1] * V[1]) * weight * phase.sin_pi()
        tail = self.tail(2 * bits)
        reach = 1 + abs(V[0]) + abs(V[1])
        return value + arb(0, tail), slope + arb(0, tail * reach)

    def arrays(self) -> tuple[FloatArray, FloatArray]:
        """2m (terms, 2) and weights of the significant terms in double precision."""
        terms = self.terms(60)
        return np.array([p for p, _ in terms], dtype=float), np.array([number(w) for _, w in terms])

    def values(self, v: FloatArray, V: FloatArray) -> tuple[FloatArray, FloatArray]:
        """θ and its derivative along V at v (n, 2), as arrays (n,)."""
        p, weights = self._arrays
        rates = pi * (p @ np.asarray(V, dtype=float))
        both = np.empty((2, len(v)))
        # In blocks, which bounds memory use.
        for first in range(0, len(v), _BLOCK):
            block = slice(first, first + _BLOCK)
            phases = pi * (v[block] + np.array(self.characteristic[1]) / 2) @ p.T
            both[0, block] = np.cos(phases) @ weights
            both[1, block] = -np.sin(phases) @ (weights * rates)
        return both[0], both[1]

    @cached_property
    def _arrays(self) -> tuple[FloatArray, FloatArray]:
        return self.arrays()
