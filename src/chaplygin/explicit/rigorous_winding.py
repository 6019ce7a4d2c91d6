"""A motion on a torus in the coordinates in which its theta series converge fastest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb

from .numbers import number
from .theta import Characteristic, Theta
from .torus import Torus

__all__ = ["Winding", "complex_numerators"]

_Pair = tuple[Any, Any]
_Whole = tuple[tuple[int, int], tuple[int, int]]


@dataclass(frozen=True)
class Winding:
    """ν = N/|N|, N_i = c_i θ[a_i, b_i](v), along v = v₀ + Vτ.

    Attributes
    ----------
    Y : arb_mat (2, 2)
        The period matrix is iY; reduced: |2Y₁₂| ≤ Y₁₁ ≤ Y₂₂ but for rounding.
    characteristics : three pairs (a, b)
        In units of one half.
    factors : three arb
        c_i.
    V, v_0, along : (arb, arb)
        As in :class:`chaplygin.explicit.torus.Torus`.
    """

    Y: Any
    characteristics: tuple[Characteristic, ...]
    factors: tuple[Any, Any, Any]
    V: _Pair
    v_0: _Pair
    along: _Pair

    @classmethod
    def of(cls, torus: Torus) -> Winding:
        """The motion of a torus, v replaced by A⁻¹v with a whole matrix A of determinant 1."""
        Y = torus.lattice.Y
        (p, q), (r, s) = _shortest(Y)
        # with v = A w the index m becomes Aᵀm, and A = [[s, −q], [−r, p]]
        A = ((s, -q), (-r, p))

        def moved(v: Sequence[Any]) -> _Pair:
            return p * v[0] + q * v[1], r * v[0] + s * v[1]

        def characteristic(theta: Theta) -> Characteristic:
            a, b = theta.characteristic
            turned = tuple((A[0][j] * a[0] + A[1][j] * a[1]) % 2 for j in (0, 1))
            return (turned[0], turned[1]), moved(b)

        columns = [moved([Y[0, j], Y[1, j]]) for j in (0, 1)]
        rows = [moved([columns[0][i], columns[1][i]]) for i in (0, 1)]
        return cls(
            type(Y)([list(row) for row in rows]),
            tuple(characteristic(theta) for theta in torus.thetas),
            torus.factors,
            moved(torus.V),
            moved(torus.v_0),
            moved(torus.along),
        )

    def at(self, tau: Any) -> tuple[list[Any], list[Any]]:
        """N and N′ at one τ (arb)."""
        v = [start + speed * arb(tau) for start, speed in zip(self.v_0, self.V, strict=True)]
        pairs = [Theta(self.Y, own).ball(v, self.along) for own in self.characteristics]
        N = [c * value for c, (value, _) in zip(self.factors, pairs, strict=True)]
        return N, [c * rate for c, (_, rate) in zip(self.factors, pairs, strict=True)]


def complex_numerators(winding: Winding, v: Any) -> tuple[Any, Any]:
    """N and N′ at complex phases v (2, n), as arrays (3, n), in double precision."""
    Y = np.array([[number(winding.Y[i, j]) for j in (0, 1)] for i in (0, 1)])
    along = np.array([number(x) for x in winding.along])
    reach = np.ceil(np.sqrt(13 / np.diag(Y - abs(Y[0, 1]) * np.eye(2))) + 1 + np.abs(v.imag).max())
    N, rate = [], []
    for c, (a, b) in zip(winding.factors, winding.characteristics, strict=True):
        lines = [np.arange(-r, r + 1) + half / 2 for r, half in zip(reach, a, strict=True)]
        m = np.array(np.meshgrid(*lines)).reshape(2, -1)
        turned = 2j * np.pi * (m.T @ (v + np.array(b)[:, None] / 2))
        terms = number(c) * np.exp(turned - np.pi * np.sum(m * (Y @ m), axis=0)[:, None])
        N.append(terms.sum(axis=0))
        rate.append((2j * np.pi * (along @ m)) @ terms)
    return np.array(N), np.array(rate)


def _shortest(Y: Any) -> _Whole:
    """A⁻¹ for which A⁻¹ Y A⁻ᵀ is reduced (Gauss)."""
    one, two = (1, 0), (0, 1)

    def form(m: _Pair, n: _Pair) -> float:
        return sum(m[i] * n[j] * number(Y[i, j]) for i in (0, 1) for j in (0, 1))

    while True:
        turns = round(form(one, two) / form(one, one))
        two = (two[0] - turns * one[0], two[1] - turns * one[1])
        if form(two, two) >= form(one, one):
            return one, two
        one, two = two, (-one[0], -one[1])
