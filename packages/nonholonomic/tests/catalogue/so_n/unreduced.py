"""Bodies of n dimensions with all reactions: attitude, centre and Lagrange's multipliers.

A body has the attitude g in SO(n), ġ = g ω, and the centre x; its momentum M = ∫ v∧r dm, where
v = ω r, is I(ω) in body axes.  With z = (ω, ẋ) and ideal constraints A(g) z = 0 the principle of
d'Alembert gives

    I(ω̇) = [I(ω), ω] + (Aᵀλ)_ω,    m ẍ = (Aᵀλ)_x,    A ż = −Ȧ z,

linear equations for ż and λ, solved as they stand.  None of it is taken from the package.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from scipy.integrate import solve_ivp


def planes(n):
    return tuple(combinations(range(n), 2))


def skew(entries, n):
    matrix = np.zeros((n, n))
    for value, (i, j) in zip(entries, planes(n), strict=True):
        matrix[i, j], matrix[j, i] = value, -value
    return matrix


def above(matrix):
    return np.array([matrix[i, j] for i, j in planes(len(matrix))])


def operator_of_moments(moments, n):
    """I(ω)_ij = I_ij ω_ij as a matrix on the entries above the diagonal."""
    return np.diag(moments)


def operator_of_mass_tensor(tensor):
    """ω ↦ ∫ (ωr)∧r dm for masses along the principal axes of the tensor ∫ r rᵀ dm."""
    n = len(tensor)
    values, axes = np.linalg.eigh(tensor)
    columns = []
    for unit in np.eye(len(planes(n))):
        omega = skew(unit, n)
        momentum = np.zeros((n, n))
        for value, r in zip(values, axes.T, strict=True):
            v = omega @ r
            momentum += value * (np.outer(v, r) - np.outer(r, v))
        columns.append(above(momentum))
    return np.array(columns).T


@dataclass(frozen=True)
class Body:
    """A body with its constraints A(g) z = 0, given by their rows at an attitude."""

    n: int
    inertia: np.ndarray
    mass: float
    rows: Callable[[np.ndarray], np.ndarray]

    def rate(self, state):
        n, count = self.n, len(planes(self.n))
        g = state[: n * n].reshape(n, n)
        omega = skew(state[n * n : n * n + count], n)
        velocity = state[n * n + count + n :]
        momentum = skew(self.inertia @ above(omega), n)
        A = self.rows(g)
        size = count + n
        whole = np.zeros((size + len(A), size + len(A)))
        whole[:count, :count] = self.inertia
        whole[count:size, count:size] = self.mass * np.eye(n)
        whole[:size, size:], whole[size:, :size] = -A.T, A
        right = np.zeros(size + len(A))
        right[:count] = above(momentum @ omega - omega @ momentum)
        right[size:] = -self._rows_along(g, omega) @ np.concatenate([above(omega), velocity])
        change = np.linalg.solve(whole, right)[:size]
        return np.concatenate([(g @ omega).ravel(), change[:count], velocity, change[count:]])

    def _rows_along(self, g, omega):
        """Ȧ: the rows are of the second degree in g, so that a central difference is exact."""
        turned = g @ omega
        return (self.rows(g + turned) - self.rows(g - turned)) / 2

    def motion(self, g, omega, velocity, times):
        """Attitudes, ω and centres at some times; the centre starts at the origin."""
        n, count = self.n, len(planes(self.n))
        start = np.concatenate([g.ravel(), omega, np.zeros(n), velocity])
        found = solve_ivp(
            lambda _, state: self.rate(state),
            (0.0, times[-1]),
            start,
            method="DOP853",
            t_eval=times,
            rtol=2.3e-14,
            atol=1e-14,
        ).y.T
        return (
            found[:, : n * n].reshape(-1, n, n),
            found[:, n * n : n * n + count],
            found[:, n * n + count : n * n + count + n],
        )


def _in_space(g, unit):
    """The entry of g ω gᵀ that belongs to two space axes, as a row on ω."""
    i, j = unit
    n = len(g)
    return np.array([g[i, a] * g[j, b] - g[i, b] * g[j, a] for a, b in planes(n)])


def suslov(n, inertia):
    """No turning in planes without the last body axis."""
    chosen = [k for k, (i, j) in enumerate(planes(n)) if j < n - 1]
    rows = np.zeros((len(chosen), len(planes(n)) + n))
    rows[range(len(chosen)), chosen] = 1.0
    return Body(n, inertia, 1.0, lambda g: rows)


def _no_twist(g):
    """No turning in planes of space without the last axis."""
    n = len(g)
    return np.array([[*_in_space(g, pair), *np.zeros(n)] for pair in planes(n - 1)])


def veselova(n, inertia):
    return Body(n, inertia, 1.0, _no_twist)


def _no_slip(g, radius):
    """ẋ + (g ω gᵀ)(−R e_n) = 0: the point at the contact has no velocity."""
    n = len(g)
    columns = [-radius * _in_space(g, (i, n - 1)) for i in range(n - 1)]
    rows = [np.concatenate([column, np.eye(n)[i]]) for i, column in enumerate(columns)]
    rows.append(np.concatenate([np.zeros(len(planes(n))), np.eye(n)[n - 1]]))
    return np.array(rows)


def marble_ball(n, inertia, mass, radius):
    return Body(n, inertia, mass, lambda g: _no_slip(g, radius))


def rubber_ball(n, inertia, mass, radius):
    return Body(n, inertia, mass, lambda g: np.vstack([_no_slip(g, radius), _no_twist(g)]))
