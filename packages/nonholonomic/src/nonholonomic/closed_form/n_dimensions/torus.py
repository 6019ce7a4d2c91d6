"""The Abelian map of a separated motion, and its inverse.

On its interval from l to r a coordinate is z = l + (r − l) sin² s/2, and dz/√Y(z) is ds/√C(s) with
an analytic C > 0, the cofactor.  So the phases

    φ_i = Σ_k ψ_ik(s_k),    ψ_ik(s) = ∫₀ˢ q_i(z_k)/√C_k ds = δ_ik s + periodic,

grow linearly, where the polynomials q_i of degree n − 2 are chosen such that the means are δ_ik.
The Jacobian matrix is a Vandermonde matrix times a diagonal one, never singular since the intervals
are disjoint; Newton's method inverts the map.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from flint import arb, arb_mat

from flowlanes.formulas.balls import number
from flowlanes.system.arrays import FloatArray

from ..genus_two.curve import DegenerateError
from ..genus_two.periods import abelian_integral
from .separation import SeparatedVector, coordinate_polynomial, polynomial, real_roots

#: Initial and maximum number of steps of half a turn.
_GRID = (64, 4096)
#: Relative size below which Fourier coefficients are omitted.
_LEVEL = 5e-17
#: Maximum number of Newton steps, and of halvings of a step.
_STEPS, _HALVINGS = 60, 30
#: Minimum number of table points per wave, and degree of the local polynomials.
_PLACES, _DEGREE = 16, 9
#: Largest error of phases, in radians, at which an inversion ends.
_CLOSE = 4e-15


def periods(separation: SeparatedVector) -> arb_mat:
    """The matrix of the means of z_k^i/√C_k over the intervals."""
    curve = separation.curve
    size = len(separation.ovals)
    entries = [
        [abelian_integral(curve, left, power) / arb.pi() for left in separation.ovals]
        for power in range(size)
    ]
    return arb_mat(entries)


@dataclass(frozen=True, eq=False)
class Sines:
    """ψ_ik(s) = δ_ik s + Σ_m S_ikm sin ms.

    Attributes
    ----------
    waves : array (g, g, M)
        S_ikm for i, k and m = 1, …, M.
    steps : int
        Steps of half a turn with which they were computed.
    """

    waves: FloatArray
    steps: int

    @property
    def genus(self) -> int:
        """The number of phases."""
        return len(self.waves)

    @cached_property
    def _table(self) -> FloatArray:
        """Taylor coefficients of ψ_ik − δ_ik s at the grid points, (k, places, i, degree).

        In powers of the distance from the grid point over half the spacing.
        """
        order = np.arange(self.waves.shape[2] + 1)
        places = _PLACES * 2 ** int(np.ceil(np.log2(len(order))))
        half = np.pi / places
        table = np.empty((self.genus, places, self.genus, _DEGREE + 1))
        spectrum = np.zeros((self.genus, self.genus, places), dtype=complex)
        # ψ − s is Im Σ S_m exp(ims), so its Taylor coefficients have the Fourier coefficients S_m
        # (imh)^d/d!, h half the spacing; a zero-padded FFT evaluates them at all grid points.  As
        # mh < π/16 for all waves, the remainder after the ninth power is below (π/16)^10/10! ≈
        # 2e-14 of the highest ones, which are at rounding level themselves.
        scaled = np.concatenate([np.zeros((self.genus, self.genus, 1)), self.waves], axis=2) + 0j
        for degree in range(_DEGREE + 1):
            spectrum[:, :, : len(order)] = scaled
            table[..., degree] = places * np.fft.ifft(spectrum).imag.transpose(1, 2, 0)
            scaled = scaled * (1j * half * order / (degree + 1))
        return table

    def phases_and_slopes(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """φ (n, g) in radians, and dψ_ik/ds as (n, i, k), at angles s (n, g)."""
        places = self._table.shape[1]
        half = np.pi / places
        near = np.rint(s / (2 * half))
        x = (s - near * (2 * half)) / half
        cells = near.astype(int) % places
        phases, slopes = s.copy(), np.empty((len(s), self.genus, self.genus))
        for k in range(self.genus):
            terms = self._table[k, cells[:, k]]
            own = x[:, k, None]
            value, slope = terms[..., -1], np.zeros((len(s), self.genus))
            for degree in range(_DEGREE - 1, -1, -1):
                slope = slope * own + value
                value = value * own + terms[..., degree]
            phases += value
            slopes[:, :, k] = slope / half
            slopes[:, k, k] += 1
        return phases, slopes

    def own_angles(self, x: FloatArray) -> FloatArray:
        """The angles s_k (g, N) in [0, π] at which the increasing ψ_kk have the values x (N,)."""
        own = np.array([self.waves[k, k] for k in range(self.genus)])
        order = np.arange(1, own.shape[1] + 1)
        low, high = np.zeros((self.genus, len(x))), np.full((self.genus, len(x)), np.pi)
        s = np.broadcast_to(x, low.shape)
        for _ in range(_STEPS):
            turned = s[:, :, None] * order
            miss = s + np.einsum("km,kjm->kj", own, np.sin(turned)) - x
            slope = 1 + np.einsum("km,kjm->kj", own * order, np.cos(turned))
            low, high = np.where(miss < 0, s, low), np.where(miss > 0, s, high)
            # ψ_kk increases, so the root stays bracketed; a Newton step that leaves the bracket is
            # replaced by bisection.
            following = s - miss / slope
            outside = (following < low) | (following > high)
            following = np.where(outside, (low + high) / 2, following)
            settled = np.abs(following - s).max() < _CLOSE
            s = following
            if settled:
                break
        return s

    def angles(self, phases: FloatArray) -> FloatArray:
        """The angles s (n, g) at which the phases have given values (n, g).

        Newton's method with step halving: the residual decreases, and no point is singular.
        """
        s = phases.copy()
        reached, slopes = self.phases_and_slopes(s)
        miss = reached - phases
        scale = np.maximum(1.0, np.abs(phases).max(axis=1))
        for _ in range(_STEPS):
            worst = np.abs(miss).max(axis=1)
            (open_,) = np.nonzero(worst > _CLOSE * scale)
            if not len(open_):
                break
            step = np.linalg.solve(slopes[open_], miss[open_][:, :, None])[:, :, 0]
            share = np.ones(len(open_))
            for _ in range(_HALVINGS):
                tried = s[open_] - share[:, None] * step
                reached, turned = self.phases_and_slopes(tried)
                left = reached - phases[open_]
                # Sufficient decrease: to first order the step reduces the residual by `share` of
                # it, and a quarter of that is required.
                worse = np.abs(left).max(axis=1) > worst[open_] * (1 - share / 4)
                # At rounding level no step helps.
                worse &= worst[open_] > 16 * _CLOSE * scale[open_]
                if not worse.any():
                    break
                share[worse] /= 2
            s[open_], miss[open_], slopes[open_] = tried, left, turned
        return s


def sines(separation: SeparatedVector, means: arb_mat) -> Sines:
    """The Fourier coefficients of the map.

    Raises
    ------
    DegenerateError
        If they fall too slowly: roots of the curve nearly coincide.
    """
    inverse, genus = means.inv(), len(separation.ovals)
    steps = _GRID[0]
    while steps <= _GRID[1]:
        places = [arb.pi() * j / steps for j in range(steps + 1)]
        # The densities are even, periodic and analytic in s, so the trapezoidal rule converges
        # geometrically (Trefethen & Weideman, SIAM Review 56, 2014).
        cosines = cosine_coefficients(densities(separation, inverse, [places] * genus))
        high = np.abs(cosines[:, :, steps // 2 :]).max()
        if high < 10 * _LEVEL * np.abs(cosines).max():
            kept = np.abs(cosines).max(axis=(0, 1)) > _LEVEL
            count = int(np.flatnonzero(kept).max()) if kept[1:].any() else 1
            count = max(count, 1)
            return Sines(cosines[:, :, 1 : count + 1] / np.arange(1, count + 1), steps)
        steps *= 2
    raise DegenerateError


def densities(
    separation: SeparatedVector, inverse: arb_mat, places: Sequence[Sequence[arb]]
) -> FloatArray:
    """dψ_ik/ds at given s of each z_k, (g, g, N)."""
    curve, size = separation.curve, len(separation.ovals)
    values = np.empty((size, size, len(places[0])))
    for k, left in enumerate(separation.ovals):
        low, high = curve.ends(left)
        for j, s in enumerate(places[k]):
            z = low + (high - low) * (s / 2).sin() ** 2
            root = curve.cofactor(left, s).sqrt()
            powers = arb_mat([[z**i / root] for i in range(size)])
            column = inverse * powers
            values[:, k, j] = [number(column[i, 0]) for i in range(size)]
    return values


def cosine_coefficients(values: FloatArray) -> FloatArray:
    """Coefficients c_m of Σ c_m cos ms from values on the grid of half a turn, in the last axis."""
    steps = values.shape[-1] - 1
    whole = np.concatenate([values, values[..., -2:0:-1]], axis=-1)
    coefficients: FloatArray = np.fft.rfft(whole).real / steps
    coefficients[..., 0] /= 2
    coefficients[..., -1] /= 2
    return coefficients


def start_angles(separation: SeparatedVector) -> tuple[arb, ...]:
    """The angles s_k at the start, with the direction in which z_k moves."""
    poles, y, rate = separation.poles, separation.vector, separation.rate
    z = _ordered_roots(separation)
    weights = motion_weights(separation, z)
    found = []
    for k, left in enumerate(separation.ovals):
        low, high = separation.curve.ends(left)
        # ∏ (z − z_k) = Σ y_i² ∏_{j≠i} (z − c_j), differentiated by τ at z = z_k, is −z_k′ ∏_{l≠k}
        # (z_k − z_l) = Σ 2 y_i y_i′ ∏_{j≠i} (z_k − c_j).
        change = arb(0)
        for i, (own, turning) in enumerate(zip(y, rate, strict=True)):
            others = arb(1)
            for j, c in enumerate(poles):
                if j != i:
                    others *= z[k] - c
            change -= 2 * own * turning * others
        for other, place in enumerate(z):
            if other != k:
                change /= z[k] - place
        half = ((z[k] - low) / (high - low)).mid()
        half = max(min(half, arb(1)), arb(0)).sqrt().asin()
        forward = (change * weights[k]).mid() >= 0
        found.append(2 * half if forward else -2 * half)
    return tuple(found)


def _ordered_roots(separation: SeparatedVector) -> list[arb]:
    poly = coordinate_polynomial(separation.poles, separation.vector)
    # If a component of y vanishes, a coordinate is at a pole.
    still = [c for c, y in zip(separation.poles, separation.vector, strict=True) if y == 0]
    for c in still:
        poly = poly // polynomial([c])
    return sorted([*still, *real_roots(poly)], key=lambda x: x.mid())


def motion_weights(separation: SeparatedVector, z: Sequence[arb]) -> list[arb]:
    """s_k′/√C_k at given coordinates."""
    weights = []
    for k, own in enumerate(z):
        # The Vandermonde matrix z_k^i is inverted by the coefficients of the Lagrange polynomials
        # ∏_{l≠k} (z − z_l)/(z_k − z_l).  Only v_0 and v_{n−2} differ from zero, so only their
        # constant and leading coefficients occur.
        product, apart = arb(1), arb(1)
        for other, place in enumerate(z):
            if other != k:
                product *= place
                apart *= own - place
        weights.append((separation.speed + separation.product_speed * product) / apart)
    return weights


def start_phases(separation: SeparatedVector, means: arb_mat, angles: Sequence[arb]) -> list[arb]:
    """φ at the start, in radians."""
    inverse, curve = means.inv(), separation.curve
    size = len(separation.ovals)
    total = [arb(0)] * size
    for left, s in zip(separation.ovals, angles, strict=True):
        for power in range(size):
            total[power] += abelian_integral(curve, left, power, s)
    column = inverse * arb_mat([[x] for x in total])
    return [column[i, 0] for i in range(size)]
