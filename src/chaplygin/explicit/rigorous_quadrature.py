"""∫ f dτ along a straight line on a torus, with a proven bound of the error, at any τ.

f is replaced by its trigonometric interpolant g on a grid of N₁×N₂ points.  With the Fourier
coefficients of f bounded by M exp(−2π(r₁|k₁| + r₂|k₂|)/p) on the strip where f is analytic,

    |f − g| ≤ 2 Σ |f_k|,   summed over |k₁| > N₁/2 or |k₂| > N₂/2,

everywhere on the real torus, and ∫ g dτ is a finite sum,

    g₀τ + Σ g_k exp(2πi k·v₀/p) τ exp(ix/2) sin(x/2)/(x/2),        x = 2π k·V τ/p,

without small denominators where x is small.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, log, pi, sqrt
from typing import Any

from flint import acb, acb_mat, arb, ctx

from ..errors import InputError
from .numbers import number
from .rigorous_formula import Branch, direction
from .rigorous_strip import least, lines_of, strip_bound
from .rigorous_theta import Numerators, numerators_at
from .torus import Torus

__all__ = ["RigorousQuadrature", "bits_for", "quadratures"]

#: Points of the grid beyond which the answer would take minutes.
_MOST = 1_500_000
#: Speeds |k·V| below this part of |V| are integrated without dividing by them.
_SLOW = 2.0**-20


def bits_for(digits: int, reach: float) -> int:
    """Working precision for so many decimal places after the point up to |τ| = reach."""
    return ceil(digits * log(10) / log(2) + log(1 + abs(reach)) / log(2)) + 80


@dataclass(frozen=True)
class RigorousQuadrature:
    """∫ f dτ from τ = 0.

    Attributes
    ----------
    torus : Torus
    branch : Branch
    place : int
        Which of the formulas of `branch` is f.
    period : int
        p.
    coefficients : acb_mat (N₁, N₂)
        g_k, k_j from −(N_j − 1)/2.
    doubt : arb
        A bound of |f − g|.
    bits : int
        Working precision.
    """

    torus: Torus
    branch: Branch
    place: int
    period: int
    coefficients: Any
    doubt: Any
    bits: int

    @property
    def _reach(self) -> tuple[int, int]:
        return (self.coefficients.nrows() - 1) // 2, (self.coefficients.ncols() - 1) // 2

    @property
    def mean(self) -> Any:
        """The mean of f on the torus (arb)."""
        one, two = self._reach
        return self.coefficients[one, two].real + arb(0, self.doubt)

    def rate(self, tau: Any) -> Any:
        """f at one τ (arb), from its formula."""
        with ctx.workprec(self.bits):
            return self.branch.at(*direction(*numerators_at(self.torus, tau)))[self.place]

    @cached_property
    def _divided(self) -> tuple[Any, list[tuple[Any, Any]]]:
        """g_k/(2πi k·V/p) as a matrix, and the slow terms (g_k exp(2πi k·v₀/p), π k·V/p)."""
        one, two = self._reach
        V, v_0, p = self.torus.V, self.torus.v_0, self.period
        limit = _SLOW * (abs(number(V[0])) + abs(number(V[1])))
        slow, rows = [], []
        for j in range(-one, one + 1):
            row = []
            for k in range(-two, two + 1):
                g = self.coefficients[j + one, k + two]
                speed = (j * V[0] + k * V[1]) / p
                if abs(number(speed)) > limit:
                    row.append(g / acb(0, 2 * arb.pi() * speed))
                    continue
                row.append(acb(0))
                if (j, k) != (0, 0):
                    phase = acb(2 * (j * v_0[0] + k * v_0[1]) / p).exp_pi_i()
                    slow.append((g * phase, arb.pi() * speed))
            rows.append(row)
        return acb_mat(rows), slow

    def _waved(self, tau: Any) -> Any:
        """Σ g_k/(2πi k·V/p) exp(2πi k·v/p) at v = v₀ + Vτ."""
        waves = []
        for start, speed, reach in zip(self.torus.v_0, self.torus.V, self._reach, strict=True):
            turn = 2 * (start + speed * tau) / self.period
            waves.append([acb(k * turn).exp_pi_i() for k in range(-reach, reach + 1)])
        table, _ = self._divided
        left = acb_mat([waves[0]])
        right = acb_mat([[x] for x in waves[1]])
        return (left * table * right)[0, 0].real

    @cached_property
    def _origin(self) -> Any:
        return self._waved(arb(0))

    def at(self, tau: Any) -> Any:
        """The integral from 0 to τ, as a ball that contains it.

        Parameters
        ----------
        tau : number or arb
        """
        with ctx.workprec(self.bits):
            tau = arb(tau)
            one, two = self._reach
            total = self.coefficients[one, two].real * tau + self._waved(tau) - self._origin
            for g, speed in self._divided[1]:
                x = speed * tau
                total += (g * tau * acb(0, x).exp() * x.sinc()).real
            return total + arb(0, (self.doubt * abs(tau)).upper())

    @cached_property
    def _least(self) -> Any:
        return least(self.torus, self.branch, self.period)

    def inverse(self, value: Any) -> Any:
        """The τ at which the integral of a positive f has a given value, as a ball.

        The middle is found by Newton's method; the radius is |at(middle) − value|/min f, which
        bounds the distance to the root by the mean value theorem.

        Parameters
        ----------
        value : number or arb
        """
        with ctx.workprec(self.bits):
            value, small = arb(value), self._least
            goal = (arb(2) ** (30 - self.bits)) * (1 + abs(value))
            tau = (value / self.mean).mid()
            miss = self.at(tau) - value
            for _ in range(100):
                step = (miss.mid() / self.rate(tau)).mid()
                if abs(step) < goal:
                    break
                # too long a step is halved: the integral grows with τ, so that it gets better
                while True:
                    following = (tau - step).mid()
                    left = self.at(following) - value
                    if abs(left.mid()) < abs(miss.mid()) or abs(step) < goal:
                        break
                    step = (step / 2).mid()
                tau, miss = following, left
            return tau + arb(0, (abs(miss) / small).upper())


def _sums(half: float, period: int, reach: int) -> tuple[Any, Any]:
    """Σ exp(−2πr|k|/p) over |k| > reach, and over all k."""
    q = (-2 * arb.pi() * arb(half) / period).exp()
    return 2 * q ** (reach + 1) / (1 - q), (1 + q) / (1 - q)


def quadratures(
    torus: Torus, branch: Branch, digits: int, reach: float
) -> tuple[RigorousQuadrature, ...]:
    """Integrals of formulas in ν and ν′ along a torus.

    Parameters
    ----------
    torus : Torus
        Known to `bits_for(digits, reach)` bits and some more.
    branch : Branch
    digits : int
        Decimal places after the point that are wanted.
    reach : float
        The largest |τ| at which they are wanted.

    Raises
    ------
    InputError
        If the strip is so narrow that the grid would be too fine.
    """
    bits = bits_for(digits, reach)
    with ctx.workprec(bits):
        branch.learn(*direction(*numerators_at(torus, 0)))
        period = 1 if branch.repeats([theta.characteristic for theta in torus.thetas]) else 2
        strip = strip_bound(torus, branch, period)
        wanted = digits * log(10) + log(1 + abs(reach)) + 3
        wanted += max(log(1 + number(bound)) for bound in strip.bounds)
        wanted += sum(max(0.0, log(period / (2 * pi * r))) for r in strip.half)
        halves = [ceil(wanted * period / (2 * pi * r)) for r in strip.half]
        counts = [2 * half + 1 for half in halves]
        if counts[0] * counts[1] > _MOST:
            most = int(digits * sqrt(_MOST / (counts[0] * counts[1])))
            raise InputError(f"digits: {digits} are too many so close to a separatrix; ask {most}")
        (out_1, all_1), (out_2, all_2) = (
            _sums(r, period, half) for r, half in zip(strip.half, halves, strict=True)
        )
        outside = out_1 * all_2 + all_1 * out_2
        points = Numerators(torus, (0, 0)).real(lines_of(counts, period))
        values = [branch.at(*direction(N, rate)) for N, rate in points]
        return tuple(
            RigorousQuadrature(
                torus,
                branch,
                place,
                period,
                _transformed([value[place] for value in values], counts),
                (2 * bound * outside).upper(),
                bits,
            )
            for place, bound in enumerate(strip.bounds)
        )


def _transformed(values: Sequence[Any], counts: Sequence[int]) -> Any:
    """Fourier coefficients of values on a grid, lowest wave numbers first."""
    n, m = counts
    rows = [acb.dft([acb(x) for x in values[j * m : (j + 1) * m]]) for j in range(n)]
    columns = [acb.dft([row[k] for row in rows]) for k in range(m)]
    size = n * m
    return acb_mat(
        [
            [columns[k % m][j % n] / size for k in range(-(m // 2), m // 2 + 1)]
            for j in range(-(n // 2), n // 2 + 1)
        ]
    )
