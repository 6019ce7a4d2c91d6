"""Limit directions: how a sliding contact comes to rest, and how a resting one begins to slide.

After Antali and Stépán.  A slip direction n is a limit direction if it is invariant, G(n) = 0: an
entry where the slip decays (H < 0), an exit where it grows (H > 0).
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ...mechanics.shapes.rays import directions as spread_directions
from ..impact.impact_segments import ROUNDING
from .frozen_slip import CoupledSlip, FrozenSlip, PointSlip, growth_and_turning

#: Numbers of start directions for a coupled law: the later ones are used if zeros are missing.
STARTS = (24, 150, 1000)
#: Directions closer than this count as equal.
SAME = 1e-7
#: Tolerance for G(n) = 0, relative to the largest rate.
RESIDUAL = 1e-11
#: Determinant of the derivative of G, relative to the rates, that counts as zero.
DEGENERATE = 1e-8


@dataclass(frozen=True, eq=False)
class LimitDirection:
    """A slip direction that does not change while the slip decays to zero or grows from it.

    Attributes
    ----------
    direction : (2,) or (3,) array
        Unit vector along the tangents of the mobility; of (u₁, u₂, aΩ) for a coupled law.
    growth : float
        H, the rate of the slip's size: negative for an entry, positive for an exit.
    attracts : bool
        Whether slips in nearby directions turn towards it.
    normal_force : float
    """

    direction: FloatArray
    growth: float
    attracts: bool
    normal_force: float


def limit_directions(slip: PointSlip) -> tuple[LimitDirection, ...]:
    """All limit directions of sliding under Coulomb friction, at most four, by angle.

    G times the determinant of the normal condition is a trigonometric polynomial of degree 2 in
    the angle; its roots are those of a quartic, polished by Newton's method.  Directions in which
    no positive normal force lets the contact last are left out.

    Parameters
    ----------
    slip : PointSlip

    Returns
    -------
    tuple of LimitDirection

    Raises
    ------
    InputError
        If every direction is a limit direction, as for a homogeneous ball without forces.
    """
    series, scale = _turning_polynomial(slip)
    if np.abs(series).max() <= 8 * np.finfo(float).eps * scale:
        raise InputError("limit directions: every direction of sliding is one")
    candidates = np.polynomial.polynomial.polyroots(series)
    order, coefficients = range(-2, 3), series.tolist()

    def turning(angle: float) -> tuple[float, float]:
        waves = [c * cmath.exp(1j * j * angle) for j, c in zip(order, coefficients, strict=True)]
        slopes = [-j * wave.imag for j, wave in zip(order, waves, strict=True)]
        return sum(wave.real for wave in waves), float(sum(slopes))

    angles: list[float] = []
    for guess in np.angle(candidates).tolist():
        angle = guess
        for _ in range(50):
            size, slope = turning(angle)
            step = size / slope if slope else 0.0
            angle -= min(max(step, -0.3), 0.3)
            if abs(step) <= 2 * np.finfo(float).eps:
                break
        new = all(abs(np.exp(1j * angle) - np.exp(1j * other)) > SAME for other in angles)
        if abs(turning(angle)[0]) <= 1e-13 * np.abs(series).sum() and new:
            angles.append(float(np.angle(np.exp(1j * angle))))
    result = []
    for angle in sorted(angles):
        n = np.array([np.cos(angle), np.sin(angle)])
        pressure = slip.force(n)[0]
        if pressure > 0:
            # N = −b_n/B > 0, so that B has the sign of −b_n
            slope = turning(angle)[1] * (1 if slip.normal < 0 else -1)
            growth, _ = growth_and_turning(slip, n)
            result.append(LimitDirection(n, growth, slope < 0, pressure))
    return tuple(result)


def _turning_polynomial(slip: PointSlip) -> tuple[FloatArray, float]:
    """Coefficients c_j of G·B = Σ c_j e^{ijφ}, j = −2…2, and a scale of its terms.

    The coefficients follow from eight samples by the discrete Fourier transform.
    """
    beta, A = slip.response.tangential
    constant, slope = slip.response.normal
    angles = 2 * np.pi * np.arange(8) / 8
    n = np.array([np.cos(angles), np.sin(angles)])
    lift = constant - slip.mu * (slope @ n)
    free = slip.tangential[:, None] * lift
    contact = -slip.normal * (beta[:, None] - slip.mu * (A @ n))
    rate = free + contact
    across = n[0] * rate[1] - n[1] * rate[0]
    waves = np.fft.fft(across) / 8
    scale = float(np.abs(free).max() + np.abs(contact).max())
    return waves[np.array([-2, -1, 0, 1, 2])], scale


def limit_directions_of_coupled_slip(slip: CoupledSlip) -> tuple[LimitDirection, ...]:
    """All limit directions of coupled sliding and spinning, from many starting points.

    Newton's method on the sphere from evenly distributed directions.  By the Poincaré–Hopf theorem
    the indices of all zeros of G, the signs of det DG, add up to 2, the Euler characteristic of the
    sphere; if those found do not, the search continues from more starting points.  Two zeros with
    opposite indices that are missed together go unnoticed.  Directions with a negative normal force
    are removed at the end.

    Parameters
    ----------
    slip : CoupledSlip

    Returns
    -------
    tuple of LimitDirection

    Raises
    ------
    InputError
        If directions are not isolated, as for a homogeneous ball without tangential forces, or
        some are missing after all starts.
    """
    fixed: list[tuple[FloatArray, FloatArray]] = []
    for count in STARTS:
        scale = 0.0
        for start in np.concatenate([np.eye(3), -np.eye(3), spread_directions(count)]):
            scale = max(scale, float(np.linalg.norm(slip.rate(start))))
            n = _newton_on_sphere(slip, start)
            _, turning = growth_and_turning(slip, n)
            new = all(np.linalg.norm(n - other) > SAME for other, _ in fixed)
            if new and np.linalg.norm(turning) <= RESIDUAL * scale:
                slope = _turning_derivative(slip, n)
                if abs(np.linalg.det(slope)) <= DEGENERATE * scale**2:
                    raise InputError("limit directions: they are not isolated")
                fixed.append((n, slope))
        if sum(np.sign(np.linalg.det(slope)) for _, slope in fixed) == 2:
            break
    else:
        raise InputError("limit directions: some are too close to each other to be found")
    directions = []
    for n, slope in fixed:
        pressure = slip.force(n)[0]
        if pressure > 0:
            growth, _ = growth_and_turning(slip, n)
            attracts = bool(np.linalg.eigvals(slope).real.max() < 0)
            directions.append(LimitDirection(n, growth, attracts, pressure))
    return tuple(sorted(directions, key=lambda item: tuple(item.direction)))


def _frame(n: FloatArray) -> FloatArray:
    """Two unit vectors (2, 3) orthogonal to n."""
    first = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(n, first)])


def _turning_derivative(slip: FrozenSlip, n: FloatArray, step: float = 1e-5) -> FloatArray:
    """Derivative (2, 2) of G along the sphere, by central differences."""
    frame = _frame(n)
    columns = []
    for tangent in frame:
        ends = [n + side * step * tangent for side in (1, -1)]
        ahead, behind = (growth_and_turning(slip, end / np.linalg.norm(end))[1] for end in ends)
        columns.append(frame @ (ahead - behind) / (2 * step))
    return np.array(columns).T


def _newton_on_sphere(slip: FrozenSlip, n: FloatArray) -> FloatArray:
    for _ in range(25):
        frame = _frame(n)
        _, turning = growth_and_turning(slip, n)
        slope = _turning_derivative(slip, n)
        try:
            move = -np.linalg.solve(slope, frame @ turning)
        except np.linalg.LinAlgError:
            return n
        size = float(np.linalg.norm(move))
        if size > 0.5:
            move *= 0.5 / size
        n = n + move @ frame
        n = n / np.linalg.norm(n)
        if size <= 1e-14:
            break
    return n


@dataclass(frozen=True, eq=False)
class Rest:
    """The possible motions of a contact without slip.

    Attributes
    ----------
    normal_force : float
        Normal force if the contact is held.
    sticking_force : (2,) array
        Friction that would hold it, along the tangents of the mobility.
    holding_couple : float
        Couple that would hold the spin; 0 if the law does not hold it.
    holds : bool
        Whether these are within the limits of friction.
    exits : tuple of LimitDirection
        Directions in which it could begin to slip, the attracting ones with the greatest growth
        first.
    """

    normal_force: float
    sticking_force: FloatArray
    holding_couple: float
    holds: bool
    exits: tuple[LimitDirection, ...]

    @property
    def unique(self) -> bool:
        """Whether exactly one motion is possible."""
        return int(self.holds) + len(self.exits) == 1

    @property
    def exit(self) -> LimitDirection | None:
        """The direction in which slip begins; None if the contact is held or has no exit."""
        return self.exits[0] if self.exits and not self.holds else None


def _exits(directions: Sequence[LimitDirection]) -> tuple[LimitDirection, ...]:
    exits = [direction for direction in directions if direction.growth > 0]
    return tuple(sorted(exits, key=lambda d: (not d.attracts, -d.growth)))


def rest_of_point(slip: PointSlip, static_mu: float | None = None) -> Rest:
    """The possible motions of a contact without slip under Coulomb friction: sticking if |f| ≤ μN.

    If the normal force does not depend on friction, a held contact has no exit, since the rate of
    the slip is then a monotone function of it; in general both may be possible.

    Parameters
    ----------
    slip : PointSlip
    static_mu : float, optional
        Coefficient of static friction, if it exceeds that of sliding.
    """
    limit = slip.mu if static_mu is None else static_mu
    beta, A = slip.response.tangential
    constant, slope = slip.response.normal
    matrix = np.block([[A, beta[:, None]], [slope, np.array([constant])]])
    *force, pressure = np.linalg.solve(matrix, -np.append(slip.tangential, slip.normal))
    holding = np.array(force)
    holds = bool(pressure > 0 and np.hypot(*holding) <= limit * pressure)
    couple = slip.response.couple[0] * pressure + float(slip.response.couple[1] @ holding)
    # Unlimited friction lets no slip begin.
    is_held = np.isinf(slip.mu) or (holds and slip.mu * np.abs(slope).max() <= ROUNDING * constant)
    exits = () if is_held else _exits(limit_directions(slip))
    return Rest(float(pressure), holding, float(couple) + slip.couple, holds, exits)


def rest_of_patch(slip: CoupledSlip, inside: Callable[[float, float], bool]) -> Rest:
    """The possible motions of a contact without slip or spin under a coupled law, as for a point.

    Parameters
    ----------
    slip : CoupledSlip
    inside : callable
        Whether (|f|/μN, |τ|/μNa) lies under the curve (𝓕(k), 𝓜(k)), 0 ≤ k ≤ ∞.
    """
    *force, pressure, couple = np.linalg.solve(slip.matrix, -slip.free)
    holding = np.array(force)
    holds = bool(
        pressure > 0
        and inside(
            float(np.hypot(*holding)) / (slip.mu * pressure),
            abs(couple) / (slip.mu * pressure * slip.patch),
        )
    )
    row = np.abs(slip.matrix[2])
    monotone = slip.mu * (row[:2].max() + slip.patch * row[3]) <= ROUNDING * row[2]
    exits = () if holds and monotone else _exits(limit_directions_of_coupled_slip(slip))
    return Rest(float(pressure), holding, float(couple), holds, exits)
