"""Direct collocation: a motion and its inputs as the solution of algebraic equations.

The period is divided into equal intervals.  On each the state is a polynomial that satisfies the
equations at the s Radau nodes (order 2s − 1 at the ends of intervals; Hairer and Wanner, Solving
Ordinary Differential Equations II, section IV.5), the inputs are polynomials of degree s − 1, and
the output lies on the path at each node.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix
from scipy.special import roots_jacobi

from flowlanes.system.arrays import FloatArray

from .compiled_equations import CompiledEquations
from .path import PlanePath


@lru_cache(maxsize=16)
def radau(stages: int) -> tuple[FloatArray, FloatArray]:
    """Nodes c and matrix a of the Radau IIA method on [0, 1]; its weights are the last row of a."""
    # the inner Radau points are the zeros of the Jacobi polynomial P^(1,0); row i of a integrates
    # the Lagrange polynomials exactly from 0 to c_i
    inner = roots_jacobi(stages - 1, 1, 0)[0] if stages > 1 else np.empty(0)
    c = np.append((inner + 1) / 2, 1.0)
    powers = np.arange(stages)
    vandermonde = c[:, None] ** powers
    integrals = c[:, None] ** (powers + 1) / (powers + 1)
    a = np.asarray(np.linalg.solve(vandermonde.T, integrals.T).T, dtype=np.float64)
    return c.astype(np.float64), a


@dataclass(frozen=True, eq=False)
class Transcription:
    """The equations of a motion along a path, for a number of intervals.

    The unknowns are the initial state and, for each node of each interval, state and inputs.

    Attributes
    ----------
    equations : CompiledEquations
    path : PlanePath
    output : list of int
        Indices of x and y in the state.
    intervals, stages : int
    start : mapping of int to float
        Given components of the state at the start; the others are free.
    """

    equations: CompiledEquations
    path: PlanePath
    output: list[int]
    intervals: int
    stages: int
    start: Mapping[int, float]

    @property
    def width(self) -> int:
        """Number of states and inputs at a node."""
        return self.equations.size + self.equations.inputs

    @property
    def step(self) -> float:
        """Length of an interval (s)."""
        return self.path.period / self.intervals

    @cached_property
    def times(self) -> FloatArray:
        """Times of the nodes (intervals · stages,)."""
        c, _ = radau(self.stages)
        return (self.step * (np.arange(self.intervals)[:, None] + c)).ravel()

    @cached_property
    def weights(self) -> FloatArray:
        """Quadrature weights of the nodes over the period."""
        _, a = radau(self.stages)
        return np.tile(self.step * a[-1], self.intervals)

    @cached_property
    def _target(self) -> FloatArray:
        return self.path.places(self.times)

    def unknowns_of(self, start: FloatArray, states: FloatArray, inputs: FloatArray) -> FloatArray:
        """The vector of unknowns of a start (n,), states (k, n) and inputs (k, m) at the nodes."""
        return np.concatenate([start, np.hstack([states, inputs]).ravel()])

    def start_and_nodes(self, unknowns: FloatArray) -> tuple[FloatArray, FloatArray]:
        """The start (n,), and states with inputs at the nodes (k, n + m)."""
        n = self.equations.size
        return unknowns[:n], unknowns[n:].reshape(-1, self.width)

    def residuals(self, unknowns: FloatArray) -> FloatArray:
        """Residuals of the start conditions, the collocation equations and the path."""
        _, a = radau(self.stages)
        n, s, e = self.equations.size, self.stages, self.intervals
        start, points = self.start_and_nodes(unknowns)
        states = points[:, :n].reshape(e, s, n)
        before = np.concatenate([start[None], states[:-1, -1]])
        rates = self.equations.rates(points).reshape(e, s, n)
        defects = states - before[:, None] - self.step * np.einsum("ij,ejn->ein", a, rates)
        off = points[:, self.output] - self._target
        given = np.array([start[i] - value for i, value in self.start.items()])
        free = self._conditions(start)
        return np.concatenate([given, free, defects.ravel(), off.ravel()])

    def _start_row(self, start: FloatArray) -> FloatArray:
        return np.append(start, np.zeros(self.equations.inputs))[None]

    @cached_property
    def _open(self) -> list[int]:
        """Indices of the relations that involve free components of the start."""
        # structural zeros are recognised at one irrational point
        slopes = self.equations.normals(np.ones((1, self.width)) * np.sqrt(0.7))[0]
        return [
            r
            for r in range(self.equations.relations)
            if any(slopes[r, j] != 0 and j not in self.start for j in range(self.equations.size))
        ]

    def _conditions(self, start: FloatArray) -> FloatArray:
        return self.equations.conditions(self._start_row(start))[0, self._open]

    def jacobian(self, unknowns: FloatArray) -> csr_matrix:
        """The sparse Jacobian of the residuals."""
        _, a = radau(self.stages)
        n, s, e, w = self.equations.size, self.stages, self.intervals, self.width
        start, points = self.start_and_nodes(unknowns)
        slopes = self.equations.slopes(points).reshape(e, s, n, w)
        # d(z_i − z_before − h Σ_j a_ij f_j): dense blocks in each interval, −1 by the end of the
        # one before
        blocks = -self.step * np.einsum("ij,ejnk->einjk", a, slopes)
        stage, entry = np.arange(s), np.arange(n)
        blocks[:, stage[:, None], entry, stage[:, None], entry] += 1.0
        normals = self.equations.normals(self._start_row(start))[0, self._open, :n]
        rows, columns = self._places
        values = np.concatenate(
            [
                np.ones(len(self.start)),
                normals.ravel(),
                blocks.ravel(),
                -np.ones(e * s * n),
                np.ones(2 * e * s),
            ]
        )
        shape = (len(self.start) + len(self._open) + e * s * (n + 2), len(unknowns))
        return coo_matrix((values, (rows, columns)), shape=shape).tocsr()

    @cached_property
    def effort(self) -> csr_matrix:
        """H of the effort ½(w, Hw) = ½ ∫ (|u|² + δ²|u̇|²) dt / T in the unknowns w.

        The second term, where δ is the mean time between nodes, prevents the inputs from
        oscillating between nodes; a jump between two intervals counts as a change over the time δ.
        """
        c, a = radau(self.stages)
        s, e, m = self.stages, self.intervals, self.equations.inputs
        powers = np.arange(s)
        inverse = np.linalg.inv(c[:, None] ** powers)
        slope = (powers * c[:, None] ** np.maximum(powers - 1, 0)) @ inverse
        inner = np.diag(a[-1]) + slope.T @ np.diag(a[-1]) @ slope / s**2
        grid = np.kron(np.eye(e), self.step * inner)
        jump = np.zeros((e - 1, e * s))
        for k in range(1, e):
            jump[k - 1, k * s : (k + 1) * s] = inverse[0]
            jump[k - 1, k * s - 1] -= 1.0
        total = coo_matrix((grid + self.step / s * jump.T @ jump) / self.path.period)
        node, which = np.divmod(np.arange(len(total.data) * m), m)
        n, w = self.equations.size, self.width
        rows, columns = (n + index[node] * w + n + which for index in (total.row, total.col))
        size = n + e * s * w
        return coo_matrix((total.data[node], (rows, columns)), shape=(size, size)).tocsr()

    @cached_property
    def _places(self) -> tuple[FloatArray, FloatArray]:
        """Rows and columns of the entries of the Jacobian, in the order of its values."""
        n, s, e, w = self.equations.size, self.stages, self.intervals, self.width
        first = len(self.start) + len(self._open)
        rows, columns = [np.arange(len(self.start))], [np.array(list(self.start), dtype=int)]
        grid = np.indices((len(self._open), n))
        rows.append(len(self.start) + grid[0].ravel())
        columns.append(grid[1].ravel())
        interval, i, row, j, column = np.indices((e, s, n, s, w))
        rows.append((first + (interval * s + i) * n + row).ravel())
        columns.append((n + (interval * s + j) * w + column).ravel())
        interval, i, row = np.indices((e, s, n))
        rows.append((first + (interval * s + i) * n + row).ravel())
        previous = np.where(interval == 0, row, n + (interval * s - 1) * w + row)
        columns.append(previous.ravel())
        node, which = np.indices((e * s, 2))
        rows.append((first + e * s * n + 2 * node + which).ravel())
        columns.append((n + node * w + np.array(self.output)[which]).ravel())
        return np.concatenate(rows), np.concatenate(columns)
