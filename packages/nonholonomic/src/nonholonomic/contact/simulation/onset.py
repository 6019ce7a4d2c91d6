"""The onset of sliding or rolling: motion from zero slip in a direction to be determined.

Friction in the direction of a polynomial in time gives a smooth motion.  The coefficients are
determined by collocation (`_collocation`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..friction.contensou import range_of
from ..friction.modes import Mode
from ..friction.prescribed_friction import (
    DEGREE,
    HEADING_COEFFICIENTS,
    LATITUDE_COEFFICIENTS,
    SIZE_COEFFICIENTS,
    PrescribedPower,
    PrescribedRolling,
    first_direction_values,
    prescribed_direction,
)
from .compiled import OMEGA, VELOCITY, CompiledContact
from .mode_integrator import ModeIntegrator, with_values
from .rolling_end import direction_of_couple

#: Chebyshev points on (0, 1], and points between them at which the direction is verified.
_POINTS = (1 - np.cos(np.pi * np.arange(1, DEGREE + 1) / DEGREE)) / 2
_TESTS = np.array([0.35, 0.65, 0.97])

#: Maximum number of steps of a trial, and the largest angle (rad) by which the direction may turn.
_MOST_STEPS, _LARGEST_TURN = 500, 3.0

#: Maximum number of corrections of the coefficients, and of divisions of the duration by four;
#: step of the difference quotients.
_MOST_CHANGES, _ATTEMPTS, _STEP = 20, 12, 1e-5

#: Relative velocity error below which the polynomial fit of the power law is accepted.
_NO_PUSH = 1e-13

#: Rounding error of the slip relative to the velocities, and the factor by which the slip must
#: exceed it at the end of the onset.
_NOISE, _GROWN = 4e-15, 1e5


@dataclass(frozen=True, eq=False)
class Onset:
    """A short interval of sliding that starts from zero slip.

    Attributes
    ----------
    integrator : ModeIntegrator
        Of the motion with prescribed direction; its state has the clock as last column.
    duration : float
    state : array (size,)
        At its end.
    """

    integrator: ModeIntegrator
    duration: float
    state: FloatArray

    def samples(self, time: float, state: FloatArray, moments: list[float]) -> FloatArray:
        """States at times within the onset; the last column is the clock."""
        if not moments:
            return np.empty((0, len(state) + 1))
        start = np.append(state, 0.0)
        return self.integrator.advance(time, start, moments, moments[-1]).samples


@dataclass(frozen=True, eq=False)
class _Trial:
    """A motion with prescribed friction direction, and the slip or rolling that results.

    Attributes
    ----------
    integrator : ModeIntegrator
    first : array (3,)
        The initial direction.
    latitude, patch : float
        Latitude of the direction and radius of the patch, for a coupled law.
    rolling : callable or None
        Function of states that returns the rolling (n, 3), if rolling begins; None for sliding.
    power : (float, float) or None
        ν over the mass, and the order, of a non-integer power of the slip.
    """

    integrator: ModeIntegrator
    first: FloatArray
    latitude: float = math.pi / 2
    patch: float = 0.0
    rolling: Callable[[FloatArray], FloatArray] | None = None
    power: tuple[float, float] | None = None

    @property
    def columns(self) -> slice:
        """The columns of the state whose rounding errors enter the slip or the rolling."""
        return VELOCITY if self.rolling is None else OMEGA

    def integrator_with(self, coefficients: FloatArray, duration: float) -> ModeIntegrator:
        values = self.integrator.values.copy()
        values[self.integrator.places["duration"]] = duration
        values[self._places] = coefficients
        return replace(self.integrator, values=values)

    @cached_property
    def _places(self) -> list[int]:
        symbols = HEADING_COEFFICIENTS + (LATITUDE_COEFFICIENTS if self.patch else ())
        return [self.integrator.places[str(symbol)] for symbol in symbols]

    def defects(
        self, integrator: ModeIntegrator, states: FloatArray, times: FloatArray, c: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Components of the slip (n, 1 or 2) across its prescribed direction, and along it (n,)."""
        powers = times[:, None] ** np.arange(1, DEGREE + 1)
        headings = (powers @ c[:DEGREE])[:, None]
        values = integrator.outputs(states)
        gamma = values["gamma"]
        slip = values["slip"] if self.rolling is None else self.rolling(states)
        across = self.first - (gamma @ self.first)[:, None] * gamma
        across /= np.linalg.norm(across, axis=1)[:, None]
        aside = _cross(gamma, across)
        n = np.cos(headings) * across + np.sin(headings) * aside
        m = np.cos(headings) * aside - np.sin(headings) * across
        along, beside = (slip * n).sum(axis=1), (slip * m).sum(axis=1)
        if not self.patch:
            return beside[:, None], along
        latitudes = self.latitude + powers @ c[DEGREE:]
        arm = self.patch * values["spin"]
        bent = along * np.cos(latitudes) - arm * np.sin(latitudes)
        forward = along * np.sin(latitudes) + arm * np.cos(latitudes)
        return np.stack([beside, bent], axis=1), forward


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    """Cross products (n, 3), four times as fast as `numpy.cross`."""
    x, y, z = a.T
    u, v, w = b.T
    return np.stack([y * w - z * v, z * u - x * w, x * v - y * u], axis=1)


def onset_of_sliding(
    contact: CompiledContact,
    time: float,
    state: FloatArray,
    mode: Mode,
    direction: FloatArray,
    spin_sign: float,
    longest: float,
) -> Onset | None:
    """Slide from zero slip in a given initial direction; None if the slip stops at once.

    Parameters
    ----------
    contact : CompiledContact
    time : float
    state : array (size,)
        A state with zero slip.
    mode : Mode
        The sliding mode.
    direction : array (3,) or (4,)
        Initial direction of the slip, body axes; of slip and aΩ under Contensou's law.
    spin_sign : float
        Sign of the spin.
    longest : float
        First duration to try (s).
    """
    situation = contact.situation
    law = next((law for law in situation.laws if law.kinetic_mu is not None), None)
    if law is None or law.kinetic_mu is None:
        return None
    patch = law.patch_radius
    latitude = math.pi / 2
    values: dict[str, float] = {"mu": law.kinetic_mu, "spin_sign": spin_sign}
    if patch:
        flat = float(np.linalg.norm(direction[:3]))
        latitude = math.atan2(flat, float(direction[3]))
        mode = replace(mode, range=range_of(flat, float(direction[3]) / patch, patch))
        values |= {"patch": patch, "theta_0": latitude}
    first = direction[:3] / np.linalg.norm(direction[:3])
    values |= first_direction_values(first)
    stand_in = prescribed_direction(law, mode.range)
    laws = tuple(
        stand_in if item is law else PrescribedPower(item) if not item.is_smooth else item
        for item in situation.laws
    )
    integrator = with_values(contact.mode(mode, replace(situation, laws=laws)), values)
    powers = [item.power for item in situation.laws if not item.power[1].is_integer()]
    power = (powers[0][0] / situation.body.mass, powers[0][1]) if powers else None
    return _with_shortened_duration(
        _Trial(integrator, first, latitude, patch, power=power), time, state, longest
    )


def onset_of_rolling(
    contact: CompiledContact,
    time: float,
    state: FloatArray,
    mode: Mode,
    couple: FloatArray,
    run_values: Mapping[str, float],
    longest: float,
) -> Onset | None:
    """Roll from rest against the couple that held the body; None if rolling stops at once.

    Parameters
    ----------
    contact : CompiledContact
    time : float
    state : array (size,)
        A state without rolling.
    mode : Mode
        The mode with rolling.
    couple : array (3,)
        The couple in body axes, of which the tangential part is used.
    run_values : mapping of str to float
        Parameters set by the simulation, by name, such as the sign of the spin.
    longest : float
        First duration to try (s).
    """
    situation = contact.situation
    laws = tuple(PrescribedRolling(law) if law.holds_rolling else law for law in situation.laws)
    integrator = with_values(contact.mode(mode, replace(situation, laws=laws)), run_values)
    first = direction_of_couple(integrator, state, contact.numbers(state).mobility, couple)
    integrator = with_values(integrator, first_direction_values(first))

    def rolling(states: FloatArray) -> FloatArray:
        return np.array([contact.numbers(row[: contact.size]).rolling for row in states])

    return _with_shortened_duration(
        _Trial(integrator, first, rolling=rolling), time, state, longest
    )


def _with_shortened_duration(
    trial: _Trial, time: float, state: FloatArray, longest: float
) -> Onset | None:
    """The onset over `longest`, or over a shorter time on which the collocation succeeds."""
    duration = longest
    for _ in range(_ATTEMPTS):
        result = _with_power(trial, time, state, duration, longest)
        if result is not None:
            return result
        duration /= 4
    return None


def _with_power(
    trial: _Trial, time: float, state: FloatArray, duration: float, longest: float
) -> Onset | None:
    """The onset of given duration, with a non-integer power of the slip replaced by a polynomial.

    Fixed-point iteration: the polynomial is fitted to the slip of the previous iterate, on which
    the motion depends weakly.
    """
    if trial.power is None:
        return _collocation(trial, time, state, duration)
    coefficient, order = trial.power
    points = np.sort(np.concatenate([_POINTS, _TESTS]))
    size, last = np.zeros(len(points)), math.inf
    for _ in range(_MOST_CHANGES):
        fitted = np.linalg.solve(
            _POINTS[:, None] ** np.arange(1, DEGREE + 1), size[np.isin(points, _POINTS)]
        )
        names = {str(symbol): x for symbol, x in zip(SIZE_COEFFICIENTS, fitted, strict=True)}
        result = _collocation(
            replace(trial, integrator=with_values(trial.integrator, names)), time, state, duration
        )
        if result is None:
            return None
        moments = list(time + duration * points)
        states = result.integrator.advance(time, np.append(state, 0.0), moments, moments[-1])
        values = result.integrator.outputs(states.samples)
        slip = np.linalg.norm(values["slip"], axis=1)
        size = slip**order
        fast = float(np.abs(state[VELOCITY]).max() + slip[-1] * longest / duration)
        changed = points[:, None] ** np.arange(1, DEGREE + 1) @ fitted - size
        # The velocity caused by the friction that the fit omits or adds.
        push = coefficient * float((values["normal_force"] * np.abs(changed)).max()) * duration
        if push <= _NO_PUSH * fast:
            return result
        if push > 0.5 * last:
            return None
        last = push
    return None


def _first_jacobian(responses: list[FloatArray]) -> FloatArray:
    """Approximate derivatives by all coefficients, from those by the first ones.

    The slip responds to the integral of a change of the direction.  With constant mobility and
    normal force, the term tᵏ therefore has the effect of t times 2 tᵏ⁻¹/(k + 1).

    Parameters
    ----------
    responses : list of array (n, kinds)
        Derivatives at the collocation points by the first coefficient of each kind.
    """
    columns = [
        (response * (2 / (k + 1) * _POINTS[:, None] ** (k - 1))).ravel()
        for response in responses
        for k in range(1, DEGREE + 1)
    ]
    return np.array(columns).T


def _collocation(trial: _Trial, time: float, state: FloatArray, duration: float) -> Onset | None:
    """The onset of given duration; None if there is no such motion.

    With the friction direction n(s) prescribed by angles φ(s) = Σ_k c_k sᵏ, k = 1, …, DEGREE (for
    a patch also the latitudes θ(s) of slip and spin), s the time in units of the duration, the
    motion has a slip u(s; c).  At Chebyshev points s_i, with n⊥ ⊥ n and a typical slip |u|, solve

        g_i(c) = (u(s_i; c) · n⊥(s_i))/(|u| s_i²) = 0

    where s_i² makes the equations comparable: φ − φ(0) and the slip grow at least like s.  The
    Jacobian starts from `_first_jacobian`, is updated by Broyden's method (Dennis and Schnabel,
    Numerical Methods for Unconstrained Optimization and Nonlinear Equations, chapter 8), and is
    recomputed by differences when the steps do not halve.  The result is accepted only if the slip
    along n grows from zero to well above its rounding error, with the prescribed direction at
    _TESTS too; otherwise `_with_shortened_duration` tries a shorter duration.
    """
    start = np.append(state, 0.0)
    count = DEGREE * (2 if trial.patch else 1)
    coefficients = np.zeros(count)
    points = np.sort(np.concatenate([_POINTS, _TESTS]))
    at_points = np.isin(points, _POINTS)

    def course(c: FloatArray) -> tuple[ModeIntegrator, FloatArray]:
        integrator = trial.integrator_with(c, duration)
        moments = list(time + duration * points)
        outcome = integrator.advance(time, start, moments, moments[-1], _MOST_STEPS)
        return integrator, outcome.samples

    def defects(c: FloatArray) -> tuple[FloatArray, FloatArray]:
        integrator, states = course(c)
        if len(states) < len(points):
            return np.full((len(points), count // DEGREE), np.nan), np.full(len(points), np.nan)
        return trial.defects(integrator, states, points, c)

    # The components of the slip are almost linear in the coefficients, unlike its direction.
    across, along = defects(coefficients)
    size = float(np.hypot(np.abs(along).max(), np.abs(across).max()))
    weights = 1 / (size * points[at_points, None] ** 2)
    value, last = (weights * across[at_points]).ravel(), math.inf
    jacobian = _first_jacobian(
        [
            (weights * (defects(_STEP * e)[0][at_points] - across[at_points])) / _STEP
            for e in np.eye(count)[::DEGREE]
        ]
    )
    for _ in range(_MOST_CHANGES):
        if not len(jacobian):
            columns = [
                (weights * defects(coefficients + _STEP * e)[0][at_points]).ravel() - value
                for e in np.eye(count)
            ]
            jacobian = np.array(columns).T / _STEP
        if not (np.isfinite(jacobian).all() and np.isfinite(value).all()):
            return None
        try:
            change = np.linalg.solve(jacobian, -value)
        except np.linalg.LinAlgError:
            return None
        coefficients = coefficients + change
        if np.abs(coefficients).max() > _LARGEST_TURN:
            return None
        across, along = defects(coefficients)
        value, size = (weights * across[at_points]).ravel(), float(np.abs(change).max())
        # Rounding at the first points limits the convergence.
        if size < 1e-10 or (size < 1e-6 and size > 0.5 * last):
            break
        # Broyden's update; recompute by differences if the convergence is too slow.
        jacobian = jacobian + np.outer(value, change) / (change @ change)
        if size > 0.5 * last:
            jacobian = np.empty((0, 0))
        last = size
    # The slip is a difference of velocities, whose rounding errors dominate at the first points.
    noise = _NOISE * float(np.abs(state[trial.columns]).max() + np.abs(across).max())
    grows = bool(np.all(np.diff(np.concatenate([[0.0], along])) > -noise))
    aside = np.abs(across) > 1e-7 * along[:, None] + noise
    if not grows or along[-1] < _GROWN * noise or aside.any():
        return None
    integrator, states = course(coefficients)
    return Onset(integrator, float(duration), states[-1, :-1])
