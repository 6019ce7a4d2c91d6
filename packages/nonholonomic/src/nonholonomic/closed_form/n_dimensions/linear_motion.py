"""Linear equations along a known motion: attitude and path of a body in n dimensions.

    Y′ = Y A(x),    X′ = Y b(x),    Y = 1 and X = 0 at x = 0,

with a skew-symmetric A, by Gauss collocation on panels of equal length.  It preserves Y Yᵀ = 1.
All panels are computed at once, since the solution on one panel does not depend on the others; they
are multiplied afterwards.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np

from flowlanes.system.arrays import FloatArray

#: A and b at parameters (N,), as arrays (N, n, n) and (N, n).
Rates = Callable[[FloatArray], tuple[FloatArray, FloatArray]]

#: Number of nodes per panel.
_NODES = 12
#: Maximum number of panels, and number of panels computed at once.
MOST, _BLOCK = 100_000, 512
#: Number of panels on which the length is tested, error allowed on one of them, and maximum number
#: of halvings.
_TRIED, _ERROR, _HALVINGS = 64, 2e-15, 12
#: An error that can be due to rounding.
_SMALL = 1e-9


@cache
def _gauss() -> tuple[FloatArray, FloatArray, FloatArray]:
    """Nodes c and weights w on [0, 1], and the integrals a_ij of the Lagrange basis up to c_i."""
    x, w = np.polynomial.legendre.leggauss(_NODES)
    # ∫ P_k is (P_{k+1} − P_{k−1})/(2k + 1); the basis is Σ_k (k + ½) w_j P_k(x_j) P_k(x).
    values = np.polynomial.legendre.legvander(x, _NODES)
    degree = np.arange(_NODES)
    before = np.concatenate([-np.ones((_NODES, 1)), values[:, : _NODES - 1]], axis=1)
    integrals = (values[:, 1:] - before) / (2 * degree + 1)
    integrals[:, 0] = x + 1
    a = (integrals * (degree + 0.5)) @ (values[:, :_NODES] * w[:, None]).T / 2
    return (x + 1) / 2, w / 2, a


@dataclass(frozen=True)
class LinearMotion:
    """Y and X along a motion.

    Attributes
    ----------
    rates : callable
    size : int
        n.
    """

    rates: Rates
    size: int

    def at(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Y (N, n, n) and X (N, n) at parameters (N,); NaN where these are out of reach."""
        turns = np.full((len(x), self.size, self.size), np.nan)
        paths = np.full((len(x), self.size), np.nan)
        for sign in (-1.0, 1.0):
            (chosen,) = np.nonzero(x > 0 if sign > 0 else x <= 0)
            if not len(chosen):
                continue
            ends, places = np.unique(np.abs(x[chosen]), return_inverse=True)
            step = self._panel_length(sign * float(ends[-1]))
            ends = ends[ends <= step * MOST]
            if not len(ends):
                continue
            here = places < len(ends)
            for all_, own in zip((turns, paths), self._at_ends(sign, ends, step), strict=True):
                all_[chosen[here]] = own[places[here]]
        return turns, paths

    def _at_ends(self, sign: float, ends: FloatArray, step: float) -> tuple[FloatArray, FloatArray]:
        """Y and X at ascending |x|, on panels no longer than a step."""
        gaps = np.diff(ends, prepend=0.0)
        counts = np.maximum(np.ceil(gaps / step).astype(int), 1)
        last = np.cumsum(counts) - 1
        widths = np.repeat(gaps / counts, counts)
        order = np.arange(len(widths)) - np.repeat(last + 1 - counts, counts)
        lefts = np.repeat(ends - gaps, counts) + order * widths
        turns, paths = self._panels(sign * lefts, sign * widths)
        for k in range(1, len(turns)):
            paths[k] = paths[k - 1] + turns[k - 1] @ paths[k]
            turns[k] = turns[k - 1] @ turns[k]
        return turns[last], paths[last]

    def _panels(self, lefts: FloatArray, widths: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Y (N, n, n) and X (N, n) over each panel alone."""
        turns = np.empty((len(lefts), self.size, self.size))
        paths = np.empty((len(lefts), self.size))
        for first in range(0, len(lefts), _BLOCK):
            block = slice(first, first + _BLOCK)
            turns[block], paths[block] = self._on_panels(lefts[block], widths[block])
        return turns, paths

    def _on_panels(self, lefts: FloatArray, widths: FloatArray) -> tuple[FloatArray, FloatArray]:
        # Gauss collocation with s = 12 nodes has order 24 and conserves quadratic invariants such
        # as Y Yᵀ (Hairer, Lubich & Wanner, Geometric Numerical Integration, section IV.2).  As the
        # equation is linear, its stages follow from one linear system instead of an iteration.
        c, w, a = _gauss()
        n, count = self.size, len(lefts)
        A, b = self.rates((lefts[:, None] + widths[:, None] * c).ravel())
        A = widths[:, None, None, None] * A.reshape(count, _NODES, n, n)
        b = widths[:, None, None] * b.reshape(count, _NODES, n)
        # The slopes satisfy K_i = (1 + Σ a_ij K_j) A_i; these are the equations of their
        # transposes.
        across = A.transpose(0, 1, 3, 2)
        matrix = np.einsum("ij,piab->piajb", -a, across).reshape(count, _NODES * n, _NODES * n)
        matrix += np.eye(_NODES * n)
        slopes = np.linalg.solve(matrix, across.reshape(count, _NODES * n, n))
        slopes = slopes.reshape(count, _NODES, n, n).transpose(0, 1, 3, 2)
        inside = np.eye(n) + np.einsum("ij,pjab->piab", a, slopes)
        return (
            np.eye(n) + np.einsum("j,pjab->pab", w, slopes),
            np.einsum("j,pjab,pjb->pa", w, inside, b),
        )

    def _panel_length(self, end: float) -> float:
        """A panel length for which panels between 0 and `end` are accurate to rounding."""
        if not end:
            return 1.0
        lefts = end * np.arange(_TRIED) / _TRIED
        A, _ = self.rates(lefts)
        fastest = float(np.abs(A).max())
        step = min(abs(end), 1 / fastest) if fastest else abs(end)
        before = np.inf
        for _ in range(_HALVINGS):
            width = np.copysign(step, end)
            whole, path = self._panels(lefts, np.full(_TRIED, width))
            turns, paths = self._panels(
                np.concatenate([lefts, lefts + width / 2]), np.full(2 * _TRIED, width / 2)
            )
            first, second = turns[:_TRIED], turns[_TRIED:]
            moved = paths[:_TRIED] + np.einsum("pab,pb->pa", first, paths[_TRIED:])
            error = max(
                np.abs(whole - first @ second).max(),
                np.abs(path - moved).max() / (1 + np.abs(moved).max()),
            )
            if error < _ERROR:
                break
            if before < _SMALL and error > before / 8:
                # Halving no longer helps: only rounding remains.
                return 2 * step
            before, step = error, step / 2
        return step
