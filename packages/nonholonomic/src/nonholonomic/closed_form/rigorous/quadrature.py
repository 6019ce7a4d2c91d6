"""∫ f dτ along a straight line on a torus, with a proven error bound, at any τ.

f is replaced by its trigonometric interpolant g on a grid of N₁×N₂ points.  With the Fourier
coefficients of f bounded by M exp(−2π(r₁|k₁| + r₂|k₂|)/p) on the strip where f is analytic,

    |f − g| ≤ 2 Σ |f_k|,   summed over |k₁| > N₁/2 or |k₂| > N₂/2,

everywhere on the real torus, and ∫ g dτ is a finite sum,

    g₀τ + Σ g_κ exp(2πi κ·v₀) τ exp(ix/2) sin(x/2)/(x/2),        x = 2π κ·V τ,   κ_j = k_j/p_j,

without small denominators where x is small.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, log, pi, sqrt

import numpy as np
from flint import acb, acb_mat, arb, ctx, fmpq

from flowlanes.errors import InputError
from flowlanes.formulas.balls import number
from flowlanes.system.arrays import ObjectArray

from ..genus_two.torus import InvariantTorus
from .analyticity_strip import least, lines_of, strip_bound
from .branch_formula import Branch, direction
from .theta import Line, Numerators, numerators_at

#: Number of grid points beyond which the computation would take minutes.
_MOST = 1_500_000
#: Relative speed |k·V|/|V| below which a wave is integrated without division.
_SLOW = 2.0**-20


def speed_of(torus: InvariantTorus) -> float:
    """The rate at which the phases grow with τ, in turns."""
    return abs(number(torus.V[0])) + abs(number(torus.V[1]))


def bits_for(digits: int, turns: float) -> int:
    """Working precision for a number of digits after a number of turns of the phases."""
    return ceil(digits * log(10) / log(2) + log(1 + turns) / log(2)) + 80


@dataclass(frozen=True)
class RigorousQuadrature:
    """∫ f dτ from τ = 0.

    Attributes
    ----------
    place : int
        The index of f among the formulas of `branch`.
    periods : two of 1, 2
        p_j: f, up to its sign, has this period in v_j.
    shift : two of 0, 1
        1 where f changes its sign with the period: there wave numbers are (k_j + ½)/p_j.
    coefficients : acb_mat (N₁, N₂)
        g_k, k_j from −(N_j − 1)/2.
    doubt : arb
        A bound of |f − g|.
    bits : int
        Working precision.
    """

    torus: InvariantTorus
    branch: Branch
    place: int
    periods: tuple[int, int]
    shift: tuple[int, int]
    coefficients: acb_mat
    doubt: arb
    bits: int

    @property
    def _reach(self) -> tuple[int, int]:
        return (self.coefficients.nrows() - 1) // 2, (self.coefficients.ncols() - 1) // 2

    @property
    def mean(self) -> arb:
        """The mean of f on the torus (arb)."""
        with ctx.workprec(self.bits):
            return self._level + arb(0, self.doubt)

    @property
    def _level(self) -> arb:
        one, two = self._reach
        return arb(0) if any(self.shift) else self.coefficients[one, two].real

    def rate(self, tau: arb) -> arb:
        """f at one τ (arb), from its formula."""
        with ctx.workprec(self.bits):
            values: list[arb] = self.branch.at(*direction(*numerators_at(self.torus, tau)))
            return values[self.place]

    def _numbers(self, axis: int) -> list[fmpq]:
        """The wave numbers in one phase."""
        reach, shift = self._reach[axis], self.shift[axis]
        return [fmpq(2 * k + shift, 2 * self.periods[axis]) for k in range(-reach, reach + 1)]

    @cached_property
    def _integrated_terms(self) -> tuple[acb_mat, list[tuple[acb, arb]]]:
        """g_κ/(2πi κ·V) as a matrix, and the slow terms (g_κ exp(2πi κ·v₀), π κ·V)."""
        V, v_0 = self.torus.V, self.torus.v_0
        limit = _SLOW * speed_of(self.torus)
        slow, rows = [], []
        for j, one in enumerate(self._numbers(0)):
            row = []
            for k, two in enumerate(self._numbers(1)):
                g = self.coefficients[j, k]
                speed = one * V[0] + two * V[1]
                if abs(number(speed)) > limit:
                    row.append(g / acb(0, 2 * arb.pi() * speed))
                    continue
                row.append(acb(0))
                if one != 0 or two != 0:
                    phase = acb(2 * (one * v_0[0] + two * v_0[1])).exp_pi_i()
                    slow.append((g * phase, arb.pi() * speed))
            rows.append(row)
        return acb_mat(rows), slow

    def _wave_sum(self, tau: arb) -> arb:
        """Σ g_κ/(2πi κ·V) exp(2πi κ·v) at v = v₀ + Vτ."""
        v = [start + speed * tau for start, speed in zip(self.torus.v_0, self.torus.V, strict=True)]
        left, right = (
            [acb(2 * kappa * x).exp_pi_i() for kappa in self._numbers(axis)]
            for axis, x in enumerate(v)
        )
        table, _ = self._integrated_terms
        return (acb_mat([left]) * table * acb_mat([[x] for x in right]))[0, 0].real

    @cached_property
    def _origin(self) -> arb:
        return self._wave_sum(arb(0))

    def integral(self, tau: arb | float) -> arb:
        """The integral from 0 to τ, as a ball that contains it."""
        with ctx.workprec(self.bits):
            tau = arb(tau)
            total = self._level * tau + self._wave_sum(tau) - self._origin
            for g, speed in self._integrated_terms[1]:
                x = speed * tau
                total += (g * tau * acb(0, x).exp() * x.sinc()).real
            return total + arb(0, (self.doubt * abs(tau)).upper())

    @cached_property
    def _least(self) -> float:
        return least(self.torus, self.branch, self.periods)

    def inverse(self, value: arb | float) -> arb:
        """The τ at which the integral of a positive f has a given value, as a ball.

        The midpoint is found by Newton's method; by the mean value theorem the radius
        |integral(middle) − value|/min f bounds the distance to the root.
        """
        with ctx.workprec(self.bits):
            value, small = arb(value), self._least
            tau = (value / self.mean).mid()
            goal = (arb(2) ** (30 - self.bits)) * (1 / arb(speed_of(self.torus)) + abs(tau))
            miss = self.integral(tau) - value
            for _ in range(100):
                step = (miss.mid() / self.rate(tau)).mid()
                if abs(step) < goal:
                    break
                # Halve a step that is too long: since the integral increases with τ, this improves
                # it.
                while True:
                    following = (tau - step).mid()
                    left = self.integral(following) - value
                    if abs(left.mid()) < abs(miss.mid()) or abs(step) < goal:
                        break
                    step = (step / 2).mid()
                tau, miss = following, left
            return tau + arb(0, (abs(miss) / small).upper())


def _sums(half: float, period: int, reach: int) -> tuple[arb, arb]:
    """Bounds of Σ exp(−2πr|κ|) over the wave numbers beyond k = ±reach, and over all."""
    # The first omitted wave number is at least (reach + ½)/p, both for whole and for half-integer
    # numbers: a geometric series on either side.
    q = (-2 * arb.pi() * arb(half) / period).exp()
    return 2 * q**reach * q.sqrt() / (1 - q), 2 / (1 - q)


def _symmetry(
    torus: InvariantTorus, branch: Branch
) -> tuple[tuple[int, int], list[tuple[int, int]]]:
    """Periods in both phases, and for every formula whether it changes sign with them.

    When v_j grows by 1, N_i and N_i′ change their sign where a_i has the j-th entry ½.
    """
    halves = [theta.characteristic[0] for theta in torus.thetas]
    parities = [branch.parities([1 - 2 * (a[axis] % 2) for a in halves]) for axis in (0, 1)]
    periods = [1 if all(kinds) else 2 for kinds in parities]
    shifts = [
        [1 if period == 1 and kind == -1 else 0 for kind in kinds]
        for period, kinds in zip(periods, parities, strict=True)
    ]
    return (periods[0], periods[1]), list(zip(*shifts, strict=True))


def quadratures(
    torus: InvariantTorus, branch: Branch, digits: int, reach: float
) -> tuple[RigorousQuadrature, ...]:
    """Integrals of formulas in ν and ν′ along a motion on a torus.

    Parameters
    ----------
    torus : InvariantTorus
        Known to `bits_for` so many digits and turns, and some more.
    digits : int
        Requested digits of the gain of a formula in a turn of the phases.
    reach : float
        The largest |τ| at which they are requested.

    Raises
    ------
    InputError
        If the strip is so narrow that the grid would be too fine.
    """
    turns = abs(reach) * speed_of(torus)
    bits = bits_for(digits, turns)
    with ctx.workprec(bits):
        branch.learn(*direction(*numerators_at(torus, arb(0))))
        periods, shifts = _symmetry(torus, branch)
        strip = strip_bound(torus, branch, periods)
        rates = [2 * pi * r / p for r, p in zip(strip.half, periods, strict=True)]
        steepest = max(m / size for m, size in zip(strip.bounds, strip.sizes, strict=True))
        wanted = digits * log(10) + log(1 + turns) + log(1 + steepest) + 7
        wanted -= sum(min(0.0, log(rate)) for rate in rates)
        halves = [ceil(wanted / rate) for rate in rates]
        counts = [2 * half + 1 for half in halves]
        if counts[0] * counts[1] > _MOST:
            most = int(digits * sqrt(_MOST / (counts[0] * counts[1])))
            raise InputError(f"digits: {digits} are too many so close to a separatrix; ask {most}")
        (out_1, all_1), (out_2, all_2) = (
            _sums(r, p, half) for r, p, half in zip(strip.half, periods, halves, strict=True)
        )
        outside = out_1 * all_2 + all_1 * out_2
        lines = lines_of(counts, periods)
        values = _values_on_grid(torus, branch, lines, shifts)
        return tuple(
            RigorousQuadrature(
                torus,
                branch,
                place,
                periods,
                shift,
                _fourier_coefficients(values[place], lines, shift),
                # Omitted waves count twice: they are missing, and the grid adds each to a wave that
                # is kept.
                (2 * arb(bound) * outside).upper(),
                bits,
            )
            for place, (bound, shift) in enumerate(zip(strip.bounds, shifts, strict=True))
        )


def _reflection(torus: InvariantTorus, branch: Branch) -> list[int]:
    """Signs by which the formulas change from v to −v; 0 if their form shows none.

    θ[a, b](−v) = exp(4πi a·b) θ[a, b](v), so N_i is even or odd, and N_i′ has the opposite parity.
    """
    characteristics = [theta.characteristic for theta in torus.thetas]
    flips = [1 - 2 * ((a[0] * b[0] + a[1] * b[1]) % 2) for a, b in characteristics]
    return branch.parities(flips, [-flip for flip in flips])


def _values_on_grid(
    torus: InvariantTorus,
    branch: Branch,
    lines: tuple[Line, Line],
    shifts: Sequence[Sequence[int]],
) -> list[ObjectArray]:
    """Values (arb) of the formulas on a grid through v = 0 with an odd number of rows.

    If every formula is even or odd, half of the rows are computed.  Between −v and the equivalent
    grid point a formula changes sign once for each phase in which it does so over a period.
    """
    signs = _reflection(torus, branch)
    first, second = lines
    rows = first.count // 2 + 1 if all(signs) else first.count
    N, rate = Numerators(torus, (0, 0)).real((Line(first.first, first.step, rows), second))
    parts = [branch.at(*direction([x[j] for x in N], [x[j] for x in rate])) for j in range(rows)]
    grids = []
    for place, (sign, shift) in enumerate(zip(signs, shifts, strict=True)):
        # A constant is a function on the torus too.
        grid = np.empty((first.count, second.count), dtype=object)
        for j, part in enumerate(parts):
            grid[j] = part[place]
        if rows < first.count:
            mirrored = np.roll(grid[rows - 1 : 0 : -1, ::-1], 1, axis=1) * (sign * (-1) ** shift[0])
            mirrored[:, 1:] *= (-1) ** shift[1]
            grid[rows:] = mirrored
        grids.append(grid)
    return grids


def _fourier_coefficients(
    values: ObjectArray, lines: tuple[Line, Line], shift: Sequence[int]
) -> acb_mat:
    """Fourier coefficients of values on a grid, lowest wave numbers first."""
    n, m = lines[0].count, lines[1].count
    turns = [
        [acb(-arb(half * k) / line.count).exp_pi_i() for k in range(line.count)]
        for line, half in zip(lines, shift, strict=True)
    ]
    rows = [acb.dft([turns[0][j] * turns[1][k] * values[j, k] for k in range(m)]) for j in range(n)]
    # The values are real: opposite wave numbers (k_j + shift_j/2)/p_j have conjugate coefficients.
    columns = [acb.dft([row[k] for row in rows]) for k in range(m // 2 + 1)]
    opposite = [columns[(-k - shift[1]) % m] for k in range(m // 2 + 1, m)]
    columns += [[own[(-j - shift[0]) % n].conjugate() for j in range(n)] for own in opposite]
    size = n * m
    return acb_mat(
        [
            [columns[k % m][j % n] / size for k in range(-(m // 2), m // 2 + 1)]
            for j in range(-(n // 2), n // 2 + 1)
        ]
    )
