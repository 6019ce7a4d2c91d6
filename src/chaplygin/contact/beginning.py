"""The beginning of sliding, where the slip is zero and its direction must be found.

With the direction of friction prescribed as a polynomial of the time, the motion is smooth; the
coefficients follow from the demand that the slip has this direction at Chebyshev points.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from ..core.arrays import FloatArray
from .compiled import CompiledContact, ModeIntegrator, with_values
from .contensou import range_of
from .friction import ContensouErismann, Coulomb
from .modes import Mode
from .prescribed import (
    DEGREE,
    HEADING_COEFFICIENTS,
    LATITUDE_COEFFICIENTS,
    PrescribedDirection,
)

#: Chebyshev points of (0, 1], the last one at the end.
_POINTS = (1 - np.cos(np.pi * np.arange(1, DEGREE + 1) / DEGREE)) / 2

#: Points between them, at which the direction is tested.
_TESTS = np.array([0.35, 0.65, 0.97])

#: Steps of a trial, and radians by which the direction may turn, at most.
_MOST_STEPS, _LARGEST_TURN = 500, 3.0

#: The length of a beginning is divided by four at most so many times.
_ATTEMPTS = 12


@dataclass(frozen=True, eq=False)
class Beginning:
    """Sliding over a short time from zero slip.

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
        """States at moments within the beginning."""
        if not moments:
            return np.empty((0, len(state)))
        start = np.append(state, 0.0)
        return self.integrator.advance(time, start, moments, moments[-1]).samples[:, :-1]


@dataclass(frozen=True, eq=False)
class _Trial:
    """A prescribed direction, and the slip that follows."""

    integrator: ModeIntegrator
    first: FloatArray
    latitude: float
    patch: float

    def integrator_with(self, coefficients: FloatArray, duration: float) -> ModeIntegrator:
        values = {"duration": duration}
        values |= {f"n_0_{i + 1}": float(x) for i, x in enumerate(self.first)}
        symbols = HEADING_COEFFICIENTS + (LATITUDE_COEFFICIENTS if self.patch else ())
        values |= dict(zip(map(str, symbols), map(float, coefficients), strict=True))
        if self.patch:
            values["theta_0"] = self.latitude
        return with_values(self.integrator, values)

    def defects(
        self, integrator: ModeIntegrator, states: FloatArray, times: FloatArray, c: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Angles between the slip and its prescribed direction, and the speeds of slip."""
        powers = times[:, None] ** np.arange(1, DEGREE + 1)
        headings = powers @ c[:DEGREE]
        latitudes = np.full(len(times), math.pi / 2)
        if self.patch:
            latitudes = self.latitude + powers @ c[DEGREE:]
        angles, speeds = [], []
        for state, heading, latitude in zip(states, headings, latitudes, strict=True):
            values = integrator.outputs(state)
            gamma, slip, spin = values["gamma"], values["slip"], values["spin"]
            across = self.first - (gamma @ self.first) * gamma
            across /= np.linalg.norm(across)
            aside = np.cross(gamma, across)
            n = math.cos(heading) * across + math.sin(heading) * aside
            m = math.cos(heading) * aside - math.sin(heading) * across
            along = float(slip @ n)
            arm = self.patch * float(spin)
            size = math.hypot(along, arm)
            angles.append(float(slip @ m) / (along if along else math.nan))
            if self.patch:
                bent = along * math.cos(latitude) - arm * math.sin(latitude)
                angles.append(bent / (size if size else math.nan))
            forward = along * math.sin(latitude) + arm * math.cos(latitude)
            speeds.append(math.copysign(size, forward))
        return np.array(angles), np.array(speeds)


def beginning(
    contact: CompiledContact,
    time: float,
    state: FloatArray,
    mode: Mode,
    direction: FloatArray,
    spin_sign: float,
    longest: float,
) -> Beginning | None:
    """Sliding from zero slip along a first direction; None if it stops again at once.

    Parameters
    ----------
    contact : CompiledContact
    time : float
    state : array (size,)
        With zero slip.
    mode : Mode
        The sliding mode.
    direction : array (3,) or (4,)
        Of the slip at first, body axes; under Contensou's law of slip and aΩ.
    spin_sign : float
        Sign of the spin.
    longest : float
        Duration to begin with (s).
    """
    situation = contact.situation
    law = situation.law(ContensouErismann) or situation.law(Coulomb)
    if law is None:
        return None
    patch = law.patch if isinstance(law, ContensouErismann) else 0.0
    latitude = math.pi / 2
    values: dict[str, float] = {"mu": law.mu, "spin_sign": spin_sign}  # type: ignore[attr-defined]
    if patch:
        flat = float(np.linalg.norm(direction[:3]))
        latitude = math.atan2(flat, float(direction[3]))
        mode = replace(mode, range=range_of(flat, float(direction[3]) / patch, patch))
        values["patch"] = patch
    first = direction[:3] / np.linalg.norm(direction[:3])
    stand_in = PrescribedDirection(law.name, mode.range)
    laws = tuple(stand_in if item is law else item for item in situation.laws)
    prescribed = contact.mode(mode, replace(situation, laws=laws))
    integrator = with_values(prescribed, values)
    trial = _Trial(integrator, first, latitude, patch)
    duration = longest
    for _ in range(_ATTEMPTS):
        result = _collocated(trial, time, state, duration)
        if result is not None:
            return result
        duration /= 4
    return None


def _collocated(trial: _Trial, time: float, state: FloatArray, duration: float) -> Beginning | None:
    """The beginning of a duration; None if there is no such motion."""
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

    def defects(c: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        integrator, states = course(c)
        if len(states) < len(points):
            return np.full(count, np.nan), np.full(len(points), np.nan), np.array([np.nan])
        angles, speeds = trial.defects(integrator, states, points, c)
        width = 2 if trial.patch else 1
        rows = angles.reshape(len(points), width)
        return rows[at_points].ravel(), speeds, rows[~at_points].ravel()

    value, speeds, between = defects(coefficients)
    for _ in range(8):
        if not np.all(np.isfinite(value)):
            return None
        h = 1e-5
        jacobian = np.array(
            [(defects(coefficients + h * e)[0] - value) / h for e in np.eye(count)]
        ).T
        if not np.all(np.isfinite(jacobian)):
            return None
        change = np.linalg.solve(jacobian, -value)
        coefficients = coefficients + change
        if np.abs(coefficients).max() > _LARGEST_TURN:
            return None
        value, speeds, between = defects(coefficients)
        if not np.all(np.isfinite(value)):
            return None
        if np.abs(value).max() < 1e-9 or np.abs(change).max() < 1e-11:
            break
    grows = bool(np.all(np.diff(np.concatenate([[0.0], speeds])) > 0))
    if not grows or np.abs(between).max() > 1e-7 or np.abs(value).max() > 1e-6:
        return None
    integrator, states = course(coefficients)
    return Beginning(integrator, float(duration), states[-1, :-1])
