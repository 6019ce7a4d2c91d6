"""Theta series on the complexified torus, with bounds for the omitted terms.

The numerators of ν = N/|N| are N_i(v) = c_i θ[a_i, b_i](v), v = x + iy ∈ C², with

    θ[a, b](v) = Σ exp(−π mᵀY m + 2πi m·(v + b)),        m ∈ Z² + a,

with Y real and positive definite, a, b ∈ ½Z².  On a grid of x with equal steps the double sum is a
product of three matrices.  With μ_j = Y_jj (1 − |Y₁₂|/√(Y₁₁Y₂₂)), mᵀY m ≥ μ₁m₁² + μ₂m₂², so the
omitted terms are bounded by products of two one-dimensional sums.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from flint import acb, acb_mat, arb, ctx, fmpq

from flowlanes.formulas.balls import number
from flowlanes.system.arrays import ComplexArray, ObjectArray

from ..genus_two.torus import InvariantTorus
from .affine import ROUNDING, Affine

_DEGREES = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
#: Orders of derivatives covered by the bounds of the omitted terms.
_ORDER = 3


@dataclass(frozen=True)
class Line:
    """The numbers first + k·step, k = 0, …, count − 1, on one coordinate of the torus."""

    first: arb
    step: arb
    count: int

    def __getitem__(self, k: int) -> arb:
        return self.first + k * self.step


@dataclass(frozen=True)
class _Sum:
    """The summed indices of one coordinate, and bounds for the others.

    Attributes
    ----------
    outside, everything : arb
        Bounds of Σ (1 + 2π|m|)³ exp(−πμm² + 2π|y m|) over the other indices, and over all.
    """

    indices: list[fmpq]
    outside: arb
    everything: arb

    @classmethod
    def over(cls, decay: arb, height: arb, half: int) -> _Sum:
        """Sufficiently many elements of Z + half/2 for the working precision."""

        def term(index: fmpq) -> arb:
            m = arb(index)
            return (1 + 2 * arb.pi() * m) ** _ORDER * (
                -arb.pi() * m * (decay * m - 2 * abs(height))
            ).exp()

        goal = arb(2) ** (-ctx.prec)
        last, inside = fmpq(half, 2), 2 * term(fmpq(half, 2))
        while True:
            # Successive terms decrease at least by the ratio of the first two omitted ones.
            first = term(last + 1)
            ratio = term(last + 2) / first
            if ratio < 0.5:
                outside = (2 * first / (1 - ratio)).upper()
                if outside < goal * inside:
                    break
            last += 1
            inside += 2 * first
        count = int(2 * last) + 1
        return cls([-last + k for k in range(count)], outside, (inside + outside).upper())


class Numerators:
    """N_i and derivatives at points x + iy, y fixed, x on a grid.

    Parameters
    ----------
    heights : two numbers
        y.
    """

    def __init__(self, torus: InvariantTorus, heights: Sequence[float]) -> None:
        self._torus = torus
        self._y = tuple(arb(y) for y in heights)
        Y = torus.lattice.Y
        room = 1 - abs(Y[0, 1]) / (Y[0, 0] * Y[1, 1]).sqrt()
        decays = [(Y[j, j] * room).lower() for j in (0, 1)]
        self._sums = [
            [_Sum.over(decays[j], self._y[j], theta.characteristic[0][j]) for j in (0, 1)]
            for theta in torus.thetas
        ]

    def _left_out(self, i: int) -> arb:
        """A bound of all omitted terms of N_i, times (1 + 2π|m₁|)³(1 + 2π|m₂|)³."""
        one, two = self._sums[i]
        both = one.outside * two.everything + one.everything * two.outside
        return (abs(self._torus.factors[i]) * both).upper()

    def _amplitudes(self, i: int) -> list[list[arb]]:
        """c_i exp(−π mᵀY m − 2π m·y) for all summed m."""
        Y, (y_1, y_2) = self._torus.lattice.Y, self._y
        rows, columns = (part.indices for part in self._sums[i])

        def amplitude(m: fmpq, n: fmpq) -> arb:
            form = Y[0, 0] * m * m + 2 * Y[0, 1] * m * n + Y[1, 1] * n * n
            return self._torus.factors[i] * (-arb.pi() * (form + 2 * (m * y_1 + n * y_2))).exp()

        return [[amplitude(m, n) for n in columns] for m in rows]

    def _tables(
        self, i: int, lines: Sequence[Line], degrees: Sequence[tuple[int, int]]
    ) -> list[list[acb]]:
        """∂₁^p ∂₂^q N_i for (p, q) in `degrees`, as entries of the grid, row by row."""
        rows, columns = (part.indices for part in self._sums[i])
        shift = self._torus.thetas[i].characteristic[1]
        left = _waves(lines[0], rows, shift[0])
        right = _waves(lines[1], columns, shift[1]).transpose()
        amplitudes = self._amplitudes(i)
        turn = 2 * arb.pi() * acb(0, 1)
        doubt = arb(0, self._left_out(i))
        tables = []
        for p, q in degrees:
            first = [(turn * m) ** p for m in rows]
            second = [(turn * n) ** q for n in columns]
            terms = [
                [f * a * s for a, s in zip(row, second, strict=True)]
                for f, row in zip(first, amplitudes, strict=True)
            ]
            grid = left * acb_mat(terms) * right
            tables.append([x + acb(doubt, doubt) for x in grid.entries()])
        return tables

    def real(self, lines: Sequence[Line]) -> tuple[list[ObjectArray], list[ObjectArray]]:
        """N and N′ (arb) at every point of a grid of the real torus, as arrays like the grid."""
        counts = [line.count for line in lines]
        W = self._torus.along
        values, rates = [], []
        for i in range(3):
            plain, first, second = self._tables(i, lines, _DEGREES[:3])
            values.append(_grid([x.real for x in plain], counts))
            slopes = zip(first, second, strict=True)
            rates.append(_grid([W[0] * f.real + W[1] * s.real for f, s in slopes], counts))
        return values, rates

    def boxes(
        self, lines: Sequence[Line], half: tuple[float, float]
    ) -> tuple[list[Affine], list[Affine]]:
        """N and N′ on boxes |x_j − grid point| ≤ half_j ≤ ½ as affine functions, row by row."""
        W_1, W_2 = (number(x) for x in self._torus.along)
        N, rate = [], []
        for i in range(3):
            (x, x_1, x_2, x_11, x_12, x_22), bound = self._doubles(i, lines)
            # |W·∂| of a term is at most 2π(|m₁| + |m₂|)(|W₁| + |W₂|) times the term.
            rests = [float(r) for r in self._rests(i, half)]
            faults = (bound, bound * (abs(W_1) + abs(W_2)))
            plain, turned = (
                np.full(x.shape, remainder * (1 + ROUNDING) + fault)
                for remainder, fault in zip(rests, faults, strict=True)
            )
            N.append(Affine(x, np.array([x_1, x_2]), plain, half))
            slopes = np.array([W_1 * x_11 + W_2 * x_12, W_1 * x_12 + W_2 * x_22])
            rate.append(Affine(W_1 * x_1 + W_2 * x_2, slopes, turned, half))
        return N, rate

    def _doubles(self, i: int, lines: Sequence[Line]) -> tuple[list[ComplexArray], float]:
        """All derivatives up to the second on a grid in doubles, and a bound of their errors.

        The waves have modulus 1, so the error of a sum of n products is at most (n + 10)·1.1e-16
        times the sum of the moduli of the coefficients; n is below a thousand.
        """
        rows, columns = (part.indices for part in self._sums[i])
        shift = self._torus.thetas[i].characteristic[1]
        left = _array(_waves(lines[0], rows, shift[0]))
        right = _array(_waves(lines[1], columns, shift[1])).T
        amplitudes = np.array([[number(a) for a in row] for row in self._amplitudes(i)])
        first, second = (
            2j * np.pi * np.array([float(m) for m in part]) for part in (rows, columns)
        )
        tables, largest = [], 0.0
        for p, q in _DEGREES:
            terms = first[:, None] ** p * amplitudes * second**q
            largest = max(largest, float(np.abs(terms).sum()))
            tables.append((left @ terms @ right).ravel())
        return tables, 1e-12 * largest + 4 * float(self._left_out(i))

    def _rests(self, i: int, half: Sequence[float]) -> tuple[arb, arb]:
        """Bounds of ½ Σ |term| (2π(|m₁|h₁ + |m₂|h₂))², for N_i and for its derivative N_i′."""
        W = self._torus.along
        left_out = self._left_out(i)
        plain, turned = left_out, left_out * (abs(W[0]) + abs(W[1]))
        rows, columns = (part.indices for part in self._sums[i])
        for m, row in zip(rows, self._amplitudes(i), strict=True):
            for n, amplitude in zip(columns, row, strict=True):
                reach = 2 * arb.pi() * (abs(m) * arb(half[0]) + abs(n) * arb(half[1]))
                term = abs(amplitude) * reach * reach / 2
                plain += term
                turned += term * 2 * arb.pi() * abs(W[0] * m + W[1] * n)
        return plain.upper(), turned.upper()


def _array(matrix: acb_mat) -> ComplexArray:
    return np.array([[complex(x) for x in row] for row in matrix.tolist()])


def _waves(places: Line, indices: Sequence[fmpq], shift: int) -> acb_mat:
    """exp(2πi m (x + shift/2)): a row for every point x, a column for every index m."""
    twice = [2 * places[k] + shift for k in range(places.count)]
    return acb_mat([[acb(x * m).exp_pi_i() for m in indices] for x in twice])


def _grid(numbers: Sequence[arb], counts: Sequence[int]) -> ObjectArray:
    return np.array(numbers, dtype=object).reshape(counts)


def numerators_at(torus: InvariantTorus, tau: arb) -> tuple[list[arb], list[arb]]:
    """N and N′ at one τ (arb)."""
    return torus.numerators(
        [start + speed * tau for start, speed in zip(torus.v_0, torus.V, strict=True)]
    )
