"""Creep: slow sliding in which the friction force determines the slip.

If friction grows with the slip, a slip far below the typical speeds of a motion follows from the
force f that would hold the contact.  With the friction N (μ + ν|u|ᵖ) against the slip u,

    u = −((|f|/N − μ)/ν)^{1/p} f/|f|,    and zero where |f| < μN.

The differential equations are stiff as equations for u, but not as equations for f.  So f/N is
represented by a polynomial in time, and its coefficients are determined by collocation: at the
points of Radau's method, the slip that results from f must agree with the formula above.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial.legendre import legroots

from flowlanes.system.arrays import FloatArray

from ..equations.situation import FrictionalContact
from ..friction.friction_law import FrictionLaw
from ..friction.modes import Mode
from ..friction.prescribed_friction import (
    DEGREE,
    FORCE_COEFFICIENTS,
    PrescribedForce,
    first_direction_values,
)
from .compiled import VELOCITY, CompiledContact
from .mode_integrator import ModeIntegrator, with_values
from .onset import Onset

#: Number of coefficients of each force component.
_COUNT = DEGREE + 1

#: Right Radau points on (0, 1], whose last point is the end, and points between them at which the
#: result is verified.
_POINTS = (1 + legroots([0.0] * DEGREE + [-1.0, 1.0])) / 2
_TESTS = np.array([0.07, 0.35, 0.65, 0.97])

#: Limits on the number of integration steps and of Newton corrections.
_MOST_STEPS, _MOST_CHANGES = 200, 12

#: Relative step of the difference quotients, and the largest relative defect of the slip that is
#: accepted, measured against the velocities.
_STEP, _NONE = 1e-4, 1e-13

#: Maximum number of times the step is divided by four.
_ATTEMPTS = 12


@dataclass(frozen=True)
class CreepLaw:
    """Slip speed as a function of the friction force, for the laws N (μ + ν|u|ᵖ) and μN + c|u|.

    Attributes
    ----------
    mu, coefficient, order : float
        μ, and ν with p, or c with p = 1.
    law : FrictionLaw
        The law with ν or c.
    dry : FrictionLaw or None
        The law with μ, if there is one.
    """

    mu: float
    coefficient: float
    order: float
    law: FrictionLaw
    dry: FrictionLaw | None

    @property
    def is_viscous(self) -> bool:
        """Whether the slip-dependent part of the force is independent of the normal force."""
        return self.law.slip_viscosity > 0

    @property
    def is_smooth(self) -> bool:
        """Whether the slip-dependent part of the force is a smooth function of the slip."""
        return self.law.is_smooth

    def speed(self, force: FloatArray, N: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Slip speed (n,) and its derivative with respect to the force per normal force (n,)."""
        coefficient = self.coefficient / N if self.is_viscous else self.coefficient
        excess = np.maximum(force - self.mu, 0.0) / coefficient
        speed = excess ** (1 / self.order)
        slope = excess ** (1 / self.order - 1) / (self.order * coefficient)
        return speed, np.where(excess > 0, slope, 0.0)

    def force(self, speed: float, N: float) -> float:
        """Force per normal force at a slip speed."""
        coefficient = self.coefficient / N if self.is_viscous else self.coefficient
        return float(self.mu + coefficient * speed**self.order)


def creep_law(situation: FrictionalContact) -> CreepLaw | None:
    """The creep law of a contact; None if no law applies, or its force cannot be inverted."""
    dry = [law for law in situation.laws if law.static_mu is not None]
    if not all(law.has_constant_force for law in dry):
        return None
    mu = float(dry[0].static_mu or 0.0) if dry else 0.0
    if not np.isfinite(mu):
        return None
    for law in situation.laws:
        coefficient, order = law.power
        if coefficient:
            return CreepLaw(mu, coefficient, order, law, dry[0] if dry else None)
    for law in situation.laws:
        if law.slip_viscosity:
            return CreepLaw(mu, law.slip_viscosity, 1.0, law, dry[0] if dry else None)
    return None


@dataclass(frozen=True, eq=False)
class Creep:
    """An interval of a motion during which the contact creeps.

    Attributes
    ----------
    piece : Onset
    force : array (3,)
        Friction per normal force at the end, body axes.
    stops : bool
        Whether the slip ends there.
    """

    piece: Onset
    force: FloatArray
    stops: bool


def creep(
    contact: CompiledContact,
    time: float,
    state: FloatArray,
    mode: Mode,
    force: FloatArray,
    law: CreepLaw,
    values: Mapping[str, float],
    longest: float,
) -> Creep | None:
    """Creep for some time, or until the slip ends; None if the motion does not creep.

    Parameters
    ----------
    contact : CompiledContact
    time : float
    state : array (size,)
    mode : Mode
        The sliding mode.
    force : array (3,)
        Estimate of the initial friction per normal force, body axes, not zero.
    law : CreepLaw
    values : mapping of str to float
        Values of parameters.
    longest : float
        Duration to begin with (s).
    """
    trial = _trial(contact, mode, force, law, values)
    duration = longest
    for _ in range(_ATTEMPTS):
        result = trial.collocation(time, state, duration)
        if result is not None:
            return result
        duration /= 4
    return None


def without_force(
    contact: CompiledContact,
    time: float,
    state: FloatArray,
    mode: Mode,
    law: CreepLaw,
    values: Mapping[str, float],
    duration: float,
) -> Onset:
    """Slide without the friction of `law` for some time, or until the mode ends.

    Parameters
    ----------
    contact, time, state, mode, law, values
        As of `creep`.
    duration : float
    """
    axis = contact.numbers(state).mobility.tangents[0]
    trial = _trial(contact, mode, axis, law, values)
    integrator = trial.integrator_with(np.zeros((2, _COUNT)), duration)
    outcome = integrator.advance(time, np.append(state, 0.0), [], time + duration)
    return Onset(integrator, outcome.time - time, outcome.state[:-1])


def _trial(
    contact: CompiledContact,
    mode: Mode,
    force: FloatArray,
    law: CreepLaw,
    values: Mapping[str, float],
) -> _Trial:
    beside_dry = law.dry is not None
    stand_ins = {law.law: PrescribedForce(law.law.name, False, beside_dry)}
    if law.dry is not None:
        stand_ins[law.dry] = PrescribedForce(law.dry.name, True, beside_dry)
    laws = tuple(stand_ins.get(item, item) for item in contact.situation.laws)
    size = float(np.linalg.norm(force))
    values = {**values, "mu": law.mu, **first_direction_values(force / size)}
    integrator = contact.mode(mode, replace(contact.situation, laws=laws))
    return _Trial(with_values(integrator, values), law, size)


@dataclass(frozen=True, eq=False)
class _Trial:
    """Collocation with a prescribed friction force; `size` estimates the initial force."""

    integrator: ModeIntegrator
    law: CreepLaw
    size: float

    def integrator_with(self, c: FloatArray, duration: float) -> ModeIntegrator:
        names = {
            str(symbol): float(value)
            for symbols, row in zip(FORCE_COEFFICIENTS, c, strict=True)
            for symbol, value in zip(symbols, row, strict=True)
        }
        return with_values(self.integrator, {**names, "duration": duration})

    def forces(self, c: FloatArray, t: FloatArray) -> FloatArray:
        """Force components (n, 2) per normal force at times (n,) in units of the duration."""
        result: FloatArray = t[:, None] ** np.arange(_COUNT) @ c.T
        return result

    def frame(self, integrator: ModeIntegrator, gamma: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Tangential unit vectors (n, 3) to which the force components refer."""
        first = np.array([integrator.values[integrator.places[f"n_0_{i}"]] for i in (1, 2, 3)])
        along = first - (gamma @ first)[:, None] * gamma
        along /= np.linalg.norm(along, axis=1)[:, None]
        return along, np.cross(gamma, along)

    # Unknown: the components f_j(s) = Σ_k c_jk sᵏ of the friction force per normal force, with
    # s = (t − time)/duration in [0, 1], along two tangential axes that move with the body.
    # With this force prescribed, the equations of motion are smooth and give the slip u(s; c) and
    # the normal force N(s; c).  The coefficients solve the collocation equations
    #
    #     d(s_i) = u(s_i; c) + U(|f(s_i)|, N) f/|f| = 0
    #
    # at the right Radau points s_i, the zeros of P_{m+1} − P_m with m = DEGREE; U is
    # `CreepLaw.speed`.  Since the last point is the end, the law holds exactly at the end of the
    # piece, as in a stiffly accurate Radau IIA method (Hairer and Wanner, Solving Ordinary
    # Differential Equations II, section IV.5): the decay of u towards U, which limits the step of
    # an explicit method, is not resolved at all.
    #
    # Newton's method uses an approximate Jacobian (`_jacobian`): two difference quotients give the
    # response of u to a constant change of f, and sᵏ has the effect of a constant times sᵏ/(k + 1)
    # if mobility and normal force do not vary.  Each equation is divided by s_i, since the slip
    # grows like s.  Convergence is linear with a factor of the order of the variation of mobility
    # and normal force over the piece; it fails for long pieces, and `creep` then shortens them.
    # The iteration ends when the coefficients change by less than rounding, or stop contracting at
    # rounding level.  The result is accepted only if d vanishes at _TESTS too, between the
    # collocation points, where a polynomial of too low a degree would show.
    def collocation(self, time: float, state: FloatArray, duration: float) -> Creep | None:
        start, c = np.append(state, 0.0), np.zeros((2, _COUNT))
        c[0, 0] = self.size
        points = np.sort(np.concatenate([_POINTS, _TESTS]))
        at_points = np.isin(points, _POINTS)
        speed = float(np.abs(state[VELOCITY]).max())

        def slips(c: FloatArray) -> tuple[FloatArray, FloatArray] | None:
            """Components (n, 2) of the resulting slip, and the normal force (n,)."""
            integrator, moments = self.integrator_with(c, duration), time + duration * points
            outcome = integrator.advance(time, start, list(moments), moments[-1], _MOST_STEPS)
            if len(outcome.samples) < len(points):
                return None
            known = integrator.outputs(outcome.samples)
            along, aside = self.frame(integrator, known["gamma"])
            slip = known["slip"]
            pair = np.stack([(slip * along).sum(axis=1), (slip * aside).sum(axis=1)], axis=1)
            return pair, known["normal_force"]

        found = slips(c)
        if found is None:
            return None
        columns = []
        step = _STEP * max(self.size, 1e-3)
        for row in range(2):
            changed = c.copy()
            changed[row, 0] += step
            moved = slips(changed)
            if moved is None:
                return None
            columns.append((moved[0] - found[0])[at_points] / step)
        response = np.stack(columns, axis=2)
        last = np.inf
        for _ in range(_MOST_CHANGES):
            slip, N = found
            defect, slope = self._defect(c, points, slip, N)
            jacobian = _jacobian(response, slope[at_points])
            weights = 1 / _POINTS[:, None]
            try:
                change = np.linalg.solve(
                    (weights[:, :, None] * jacobian.reshape(_COUNT, 2, -1)).reshape(2 * _COUNT, -1),
                    -(weights * defect[at_points]).ravel(),
                )
            except np.linalg.LinAlgError:
                return None
            c = c + change.reshape(2, _COUNT)
            found = slips(c)
            if found is None or not np.isfinite(c).all():
                return None
            size = float(np.abs(change).max())
            if size < 1e-13 or (size < 1e-9 and size > 0.3 * last) or size > 1e3:
                break
            last = size
        defect, _ = self._defect(c, points, *found)
        if not np.abs(defect).max() <= _NONE * max(speed, float(np.abs(found[0]).max())):
            return None
        return self._result(c, time, start, duration)

    def _defect(
        self, c: FloatArray, t: FloatArray, slip: FloatArray, N: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """The slip minus that of the law (n, 2), and the derivative of the latter (n, 2, 2)."""
        force = self.forces(c, t)
        size = np.linalg.norm(force, axis=1)
        speed, rate = self.law.speed(size, N)
        n = force / np.where(size > 0, size, 1.0)[:, None]
        ratio = speed / np.where(size > 0, size, 1.0)
        along = n[:, :, None] * n[:, None, :]
        slope = -ratio[:, None, None] * (np.eye(2) - along) - rate[:, None, None] * along
        return slip + speed[:, None] * n, slope

    def _result(
        self, c: FloatArray, time: float, start: FloatArray, duration: float
    ) -> Creep | None:
        end = _end(self.forces(c, np.linspace(0, 1, 65)), self.law.mu)
        if end < 1:
            end = self._root(c, end)
            if end < 1e-8 and self.size <= self.law.mu * (1 + 1e-12):
                # the slip should begin, but does not
                return None
        integrator = self.integrator_with(c, duration)
        lasting = float(end * duration)
        after = integrator.advance(time, start, [], time + lasting).state
        along, aside = self.frame(integrator, integrator.outputs(after[None])["gamma"])
        x, y = self.forces(c, np.array([end]))[0]
        piece = Onset(integrator, lasting, after[:-1])
        return Creep(piece, x * along[0] + y * aside[0], bool(end < 1))

    def _root(self, c: FloatArray, near: float) -> float:
        """The time close to `near` at which the force falls to its limit μ."""
        from scipy.optimize import brentq

        def excess(t: float) -> float:
            return float(np.linalg.norm(self.forces(c, np.array([t]))[0])) - self.law.mu

        low = max(near - 1 / 64, 1e-9)
        return float(brentq(excess, low, near, xtol=1e-16)) if excess(low) > 0 else low


def _end(forces: FloatArray, mu: float) -> float:
    """The first of evenly spaced times in (0, 1] at which the force is below its limit, else 1."""
    if not mu:
        return 1.0
    below = np.flatnonzero(np.linalg.norm(forces[1:], axis=1) < mu)
    return float((below[0] + 1) / (len(forces) - 1)) if len(below) else 1.0


def _jacobian(response: FloatArray, slope: FloatArray) -> FloatArray:
    """Approximate derivatives of the defects (points × 2) by the coefficients (2 × count).

    The slip responds to the integral of a change of the force.  With constant mobility and normal
    force, the term tᵏ therefore has the effect of a constant times tᵏ/(k + 1).
    """
    columns = []
    for row in range(2):
        for k in range(_COUNT):
            change = response[:, :, row] / (k + 1) - slope[:, :, row]
            columns.append((change * _POINTS[:, None] ** k).ravel())
    return np.array(columns).T
