"""The initial state of a homogeneous ball on a surface, from position and angular velocity.

As in :mod:`nonholonomic.mechanics.rolling.initial_state`, numbers are carried with 50 digits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mpmath
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.multiprecision import Multiprecision
from flowlanes.system.tuple_vectors import dot
from flowlanes.system.vectors import Vector

from ..rolling.initial_state import DIGITS, SLACK
from .ball import RollingBall

R, x = Vector("R"), Vector("x")

#: Maximum number of iterations in the search for the nearest point of a surface.
_STEPS = 400


@dataclass(frozen=True)
class _SurfacePoint:
    """f, its gradient and its second derivatives at a point."""

    value: mpmath.mpf
    slope: list[mpmath.mpf]
    hessian: list[list[mpmath.mpf]]

    @property
    def steepness(self) -> mpmath.mpf:
        return mpmath.sqrt(sum(s * s for s in self.slope))

    @property
    def normal(self) -> list[mpmath.mpf]:
        return [s / self.steepness for s in self.slope]

    def curvatures(self) -> tuple[mpmath.mpf, mpmath.mpf]:
        """The principal curvatures, positive where the surface falls away from the ball."""
        n, ell = self.normal, self.steepness
        across = [dot(row, n) for row in self.hessian]
        trace = sum(self.hessian[i][i] for i in range(3)) - dot(n, across)
        mean = trace / (2 * ell)
        product = dot(n, _adjugate_times(self.hessian, n)) / ell**2
        root = mpmath.sqrt(max(mean**2 - product, mpmath.mpf(0)))
        return mean - root, mean + root


@arguments_checked
def ball_state(
    ball: RollingBall, place: Sequence[float], omega: Sequence[float]
) -> tuple[mpmath.mpf, ...]:
    """The state, lifted to space, of a homogeneous ball; see :func:`nonholonomic.initial_state`.

    Parameters
    ----------
    ball : RollingBall
    place : 3 floats
        The contact point if the surface carries the ball, the centre if this moves on the surface.
    omega : 3 floats
        Angular velocity, space axes.

    Returns
    -------
    tuple of mpmath.mpf
        In flat order; body axes and space axes agree at the start.

    Raises
    ------
    InputError
        If the place is not on the surface or outside its domain, the surface has no normal there,
        the ball does not fit, or a rubber ball would spin about the normal.
    """
    name = "contact" if ball.carrier == "support" else "centre"
    with mpmath.workdps(DIGITS):
        surface = _Surface(ball)
        target = [_number(value, name) for value in place]
        point = _nearest_or_refused(surface, target, name)
        contact = surface.at(point, name)
        _check_domain(ball, point, name)
        _check_fit(ball, contact, name)
        spin = _without_spin(ball, [_number(value, "omega") for value in omega], contact.normal)
        start = point
        if ball.carrier == "support" and ball.kinematics.place == R:
            radius = _number(ball.radius, "radius")
            start = [p + radius * n for p, n in zip(point, contact.normal, strict=True)]
        attitude = [mpmath.mpf(int(i == 0)) for i in range(4)]
        return (*start, *spin, *attitude)


class _Surface:
    """f, ∇f and its second derivatives as functions of a point of space."""

    def __init__(self, ball: RollingBall) -> None:
        values = {p.symbol: _number(p.default, str(p.symbol)) for p in ball.surface.parameters}
        f, symbols = ball.carrying, x.symbols
        self._formulas = [f, *(f.diff(s) for s in symbols), *sp.hessian(f, symbols)]
        self._values = values

    def at(self, point: Sequence[mpmath.mpf], name: str) -> _SurfacePoint:
        """Value, gradient and Hessian at a point; InputError if there is no normal."""
        try:
            numbers = Multiprecision({**self._values, **dict(zip(x.symbols, point, strict=True))})
            values = [numbers(formula) for formula in self._formulas]
        except (ValueError, ZeroDivisionError):
            values = [mpmath.nan]
        if not all(isinstance(v, mpmath.mpf | int) and mpmath.isfinite(v) for v in values):
            raise InputError(
                f"{name}: the equation of the surface has no value at {_point_text(point)}"
            )
        slope = values[1:4]
        if not any(slope):
            raise InputError(
                f"{name}: the surface has no normal at {_point_text(point)}, since the "
                "gradient of its equation vanishes there; start at another point"
            )
        return _SurfacePoint(values[0], slope, [values[4:7], values[7:10], values[10:13]])


def _nearest_or_refused(surface: _Surface, point: list[mpmath.mpf], name: str) -> list[mpmath.mpf]:
    """The nearest point of the surface; InputError unless it is within rounding errors."""
    spot = surface.at(point, name)
    scale = 1 + max(abs(value) for value in point)
    distance = abs(spot.value) / spot.steepness
    near = _nearest(surface, point, name)
    if distance <= SLACK * scale and near is not None:
        return near
    message = f"{name}: {_point_text(point)} misses the surface by about {float(distance):.6g}"
    if near is not None:
        message += f"; the nearest point on it is {_point_text(near)}"
    raise InputError(message)


def _nearest(surface: _Surface, point: list[mpmath.mpf], name: str) -> list[mpmath.mpf] | None:
    """The foot of the perpendicular from a point to the surface, by iteration."""
    candidate = list(point)
    good = mpmath.mpf(10) ** (8 - DIGITS)
    for step in range(_STEPS):
        try:
            spot = surface.at(candidate, name)
        except InputError:
            return None
        fall = spot.value / spot.steepness
        away = [g - p for g, p in zip(point, candidate, strict=True)]
        sunk = dot(away, spot.normal)
        aside = [a - sunk * n for a, n in zip(away, spot.normal, strict=True)]
        drift = max(map(abs, aside))
        # the foot is needed to double precision only, but it must lie on the surface to all digits
        if abs(fall) < good and (drift < mpmath.mpf(10) ** -20 or step > _STEPS // 2):
            return candidate
        low, high = spot.curvatures()
        # Along the surface the gradient of half the squared distance is −aside, and its second
        # derivatives are 1 + sunk·κ; a step divided by a bound of these cannot overshoot.
        gentle = 1 / max(1 + abs(sunk * low), 1 + abs(sunk * high))
        if drift < mpmath.mpf(10) ** -20:
            gentle = mpmath.mpf(0)
        candidate = [
            p - fall * n + gentle * a for p, n, a in zip(candidate, spot.normal, aside, strict=True)
        ]
    return None


def _check_domain(ball: RollingBall, point: list[mpmath.mpf], name: str) -> None:
    for guard in ball.surface.domain(x.symbols):
        values = {p.symbol: mpmath.mpf(p.default) for p in ball.all_parameters}
        known = values | dict(zip(x.symbols, point, strict=True))
        if not Multiprecision(known)(guard.value) > 0:
            raise InputError(f"{name}: {_point_text(point)} is outside the domain; {guard.message}")


def _check_fit(ball: RollingBall, spot: _SurfacePoint, name: str) -> None:
    """Refuse a ball whose radius is not below the radius of curvature of a concave surface."""
    radius = mpmath.mpf(ball.radius)
    low, high = spot.curvatures()
    if ball.carrier == "support" and not 1 + radius * low > 0:
        raise InputError(
            f"{name}: a ball of radius {ball.radius:.15g} does not fit into the surface there, "
            f"whose radius of curvature is {float(-1 / low):.6g}; it must be smaller than that"
        )
    if ball.carrier == "centre" and not 1 - radius * high > 0:
        raise InputError(
            f"{name}: no surface can carry a ball of radius {ball.radius:.15g} there, since the "
            f"surface of its centre has the radius of curvature {float(1 / high):.6g}; the ball "
            "must be smaller than that"
        )


def _without_spin(
    ball: RollingBall, omega: list[mpmath.mpf], normal: list[mpmath.mpf]
) -> list[mpmath.mpf]:
    """ω without the spin of a rubber ball about the normal; refuse more than rounding errors."""
    if ball.contact == "marble":
        return omega
    excess = dot(omega, normal)
    nearest = [w - excess * n for w, n in zip(omega, normal, strict=True)]
    if abs(excess) > SLACK * max(map(abs, omega)):
        raise InputError(
            f"omega: (omega, n) = {float(excess):.6g}, and a rubber ball, which does not spin "
            f"about the normal, needs 0; the nearest admissible omega is {_point_text(nearest)}"
        )
    return nearest


def _number(value: float, name: str) -> mpmath.mpf:
    if not mpmath.isfinite(value):
        raise InputError(f"{name}: {value} is not a finite number")
    return mpmath.mpf(repr(float(value)))


def _adjugate_times(matrix: list[list[mpmath.mpf]], vector: list[mpmath.mpf]) -> list[mpmath.mpf]:
    rows = mpmath.matrix(matrix)
    cofactors = mpmath.matrix(3, 3)
    for i in range(3):
        for j in range(3):
            a, b = [k for k in range(3) if k != i]
            c, d = [k for k in range(3) if k != j]
            minor = rows[a, c] * rows[b, d] - rows[a, d] * rows[b, c]
            cofactors[i, j] = (-1) ** (i + j) * minor
    return [dot([cofactors[i, j] for j in range(3)], vector) for i in range(3)]


def _point_text(point: Sequence[mpmath.mpf]) -> str:
    return f"[{', '.join(repr(float(value)) for value in point)}]"
