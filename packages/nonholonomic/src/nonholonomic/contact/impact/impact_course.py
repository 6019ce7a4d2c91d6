"""Simulation of an impact: phases of sliding and sticking, from one event to the next."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from flowlanes.errors import RunError
from flowlanes.system.arrays import FloatArray

from .friction_response import (
    FrictionResponse,
    least_motion,
    least_motion_force,
    response_while_spinning,
    response_with_spin_at_rest,
    sticking_force,
)
from .impact_segments import ROUNDING, Segment, constant_friction, turning_rate
from .impact_slide import Ends, Linear, SlidingFriction, slide, slide_integrator
from .mobility import Mobility
from .polynomial_events import first_rise, value

Mode = Literal["sliding", "sliding, spin held", "sticking", "sticking, spin held"]
Event = Literal[
    "compressed", "approaching again", "returned", "stopped", "spin stopped", "spin starts"
]
#: A slip reduced by this factor within a phase is taken straight to zero.
STOP = float(np.exp(-40.0))
#: Initial spin, relative to the velocities of the impact, when spinning begins.
_FIRST_SPIN = 1e-17
#: Maximum number of segments of an impact.
STRETCHES = 10_000


@dataclass(frozen=True)
class ImpactPhase:
    """A phase of an impact, during which the contact keeps its mode.

    Attributes
    ----------
    mode : str
        "sliding", "sliding, spin held", "sticking" or "sticking, spin held".
    end : float
        The normal impulse at which it ends.
    """

    mode: Mode
    end: float


class ImpactCourse:
    """An impact under construction, in the tangent plane of the contact.

    Parameters
    ----------
    mobility : Mobility
    friction : SlidingFriction
    spin_arm : float
    slip : (2,) array
        Tangential velocity, along the tangents of the mobility.
    spin, normal : float
    restitution : float
    law : str
    """

    def __init__(
        self,
        mobility: Mobility,
        friction: SlidingFriction,
        spin_arm: float,
        slip: FloatArray,
        spin: float,
        normal: float,
        restitution: float,
        law: str,
    ) -> None:
        self.mobility, self.mu, self.spin_arm = mobility, friction.mu, spin_arm
        self._law, self._size = friction, float(np.hypot(np.hypot(*slip), normal))
        self.slip, self.spin, self.normal = slip, spin, normal
        self.restitution, self.law, self.approach = restitution, law, normal
        self.normal_impulse = self.compression_impulse = self.couple_impulse = 0.0
        #: Work and impulse of the normal force, in compression and in restitution.
        self._work, self._clock = [0.0, 0.0], [0.0, 0.0]
        self.friction = np.zeros(2)
        self.phases: list[ImpactPhase] = []
        self.compressing = True
        #: Sign of the spin (−1, 0 or 1), or None while it is held.
        self._turning: float | None = 0.0
        self._sticks = False
        #: Constant friction force of a slide that started from rest along a straight line.
        self._straight: FloatArray | None = None
        self._first_speed = 0.0
        self._at_rest = response_with_spin_at_rest(mobility)
        self._spinning: dict[float, FrictionResponse] = {}
        self._integrator = slide_integrator(friction)
        self._decide_at_rest()

    def run(self) -> None:
        """Advance the impact to its end.

        Raises
        ------
        RunError
            If it takes more than `STRETCHES` segments.
        """
        for _ in range(STRETCHES):
            segment = self._segment()
            if segment is None:
                event = self._slide()
            else:
                x, event = self._next_event(segment)
                self._advance(segment, x)
            if event is not None and self._ends_with(event):
                return
        raise RunError("the impact does not end", self.normal_impulse)

    # --- mode of the contact ------------------------------------------------------------------

    @property
    def _weight(self) -> float:
        """0 while an infinite friction stops the slip before any normal impulse acts, else 1."""
        return 0.0 if np.isinf(self.mu) and not self._sticks else 1.0

    @property
    def _friction(self) -> float:
        """Sliding friction per unit of the parameter, at the current speed."""
        return 1.0 if self._weight == 0 else self._law.at(float(np.hypot(*self.slip)))

    def _response(self) -> FrictionResponse:
        if self._turning is None and self._weight:
            return self._at_rest
        sign = 0.0 if self._turning is None else self._turning
        couple = -self.spin_arm * sign * self._weight
        if couple not in self._spinning:
            self._spinning[couple] = response_while_spinning(self.mobility, couple)
        return self._spinning[couple]

    def _mode(self) -> Mode:
        if self._sticks:
            return "sticking, spin held" if self._turning is None else "sticking"
        return "sliding, spin held" if self._turning is None else "sliding"

    def _decide_at_rest(self) -> None:
        """Decide whether a contact whose slip or spin has just become zero keeps it at zero."""
        self._straight, self._sticks = None, False
        self._first_speed = float(np.hypot(*self.slip))
        rests, spins = not self.slip.any(), self.spin != 0
        if not self.spin_arm:
            self._turning = 0.0
        elif spins:
            self._turning = float(np.sign(self.spin))
        elif rests:
            _, couple = least_motion(self.mobility, self.mu, self.spin_arm)
            held = abs(couple) < self.spin_arm * (1 - ROUNDING)
            self._turning = None if held else -float(np.sign(couple))
        else:
            self._turning = self._start_of_spin()
        if rests:
            self._sticks = True
            response = self._response()
            if np.hypot(*sticking_force(response)) > self.mu:
                beta, A = response.tangential
                self._sticks = False
                self._straight = least_motion_force(A, beta, self.mu)
                if self._law.varies and self._weight:
                    self._start_against_viscosity(beta)

    def _start_against_viscosity(self, beta: FloatArray) -> None:
        """Begin to slide under speed-dependent friction, at a speed above rounding."""
        assert self._straight is not None
        direction = -self._straight if self.mu else beta
        size = float(np.hypot(*direction))
        if size > ROUNDING * float(np.abs(self.mobility.A).max()):
            self.slip = STOP * self._size / size * direction
            self._straight, self._first_speed = None, STOP * self._size
        else:
            self._sticks = True

    def _start_of_spin(self) -> float | None:
        """The sign that the spin takes while the contact slides; None if it stays zero."""
        direction = self.slip / np.hypot(*self.slip)
        constant, slope = self._at_rest.couple
        couple = self._weight * constant - self._friction * float(slope @ direction)
        if abs(couple) <= self.spin_arm * self._weight * (1 + ROUNDING):
            return None
        return -float(np.sign(couple))

    def _segment(self) -> Segment | None:
        """The next segment with constant friction; None for a slip that turns."""
        response, weight = self._response(), self._weight
        force: FloatArray
        direction: FloatArray | None
        if self._sticks:
            force, direction = sticking_force(response), None
        elif self.mu == 0 and not self._law.varies:
            force, direction = np.zeros(2), None
        elif self._straight is not None:
            force, direction = self._straight, -self._straight / np.hypot(*self._straight)
        else:
            speed = float(np.hypot(*self.slip))
            direction = self.slip / speed
            along, across, straight = turning_rate(response, weight, self._friction, direction)
            # Going straight from here misplaces the end by the remaining turning of the slide.
            missed = speed * min(1.0, abs(across / along)) if along < 0 else np.inf
            if self._law.varies and weight:
                straight, missed = False, speed if along < 0 else np.inf
            if not straight and missed >= STOP * self._first_speed:
                return None
            force = -self._friction * direction
        return constant_friction(
            response, weight, force, self.slip, self.spin, self.normal, direction
        )

    def _slide(self) -> Event | None:
        """Follow a slip that turns, up to an event or to a much smaller speed."""
        response, weight = self._response(), self._weight
        beta, A = response.tangential
        normal = Linear(self.normal, weight * response.normal[0], response.normal[1])
        speed = float(np.hypot(*self.slip))
        force = -self._friction * self.slip / speed
        rising = normal.normal + float(normal.friction @ force) > 0
        if self.compressing and rising and abs(self.normal) <= ROUNDING * speed:
            return "compressed"
        spin = Linear(self.spin, weight * response.spin[0], response.spin[1])
        couple = None
        if self._turning is None and weight:
            constant, slope = self._at_rest.couple
            couple = np.array([constant, *(-self._friction * slope)]) / self.spin_arm
        # factors of work, clock and normal velocity in the quantity whose growth ends the
        # restitution
        missing = {
            "stronge": (1.0, 0.0, 0.0),
            "poisson": (0.0, 1.0, 0.0),
            "newton": (0.0, 0.0, 1.0),
        }
        ends = Ends(
            self.compressing,
            *((0.0, 0.0, 0.0) if self.compressing else missing[self.law]),
            offset=-1.0 if self.compressing else -self._restitution_left(),
            spin=spin.times(self._turning) if self._turning and weight else None,
            couple=couple,
        )
        law = self._law if weight else SlidingFriction(self._friction)
        end = slide(self._integrator, weight * beta, A, law, self.slip, normal, ends)
        impulse = weight * end.clock
        self.normal_impulse += impulse
        self.compression_impulse += impulse if self.compressing else 0.0
        part = 0 if self.compressing else 1
        self._work[part] += end.work
        self._clock[part] += end.clock
        self.couple_impulse += response.couple[0] * impulse + float(
            response.couple[1] @ end.friction
        )
        self.friction = self.friction + end.friction
        self.slip = end.speed * end.direction
        if self._turning is not None or not weight:
            self.spin = spin.at(end.clock, end.friction)
        self.normal = normal.at(end.clock, end.friction)
        return end.event

    # --- events -------------------------------------------------------------------------------

    def _next_event(self, segment: Segment) -> tuple[float, Event | None]:
        rises: list[tuple[float, Event]] = []
        for event, series in self._events(segment):
            x = first_rise(series, segment.length)
            if x is not None:
                rises.append((x, event))
        return min(rises, default=(segment.length, None), key=lambda pair: pair[0])

    def _events(self, segment: Segment) -> list[tuple[Event, FloatArray]]:
        events: list[tuple[Event, FloatArray]] = []
        if self.compressing:
            events.append(("compressed", segment.normal))
        else:
            events.append(("returned", self._restitution_end(segment)))
            events.append(("approaching again", -segment.normal))
        if segment.speed is not None and np.isinf(segment.length):
            events.append(("stopped", -segment.speed))
        if self._turning and self._weight:
            events.append(("spin stopped", -self._turning * segment.spin))
        if self._turning is None and self._weight and segment.direction is not None:
            constant, slope = self._at_rest.couple
            couple = -self.mu * (slope @ segment.direction)
            couple[0] += constant
            for sign in (1, -1):
                series = sign * couple
                series[0] -= self.spin_arm
                events.append(("spin starts", series))
        return events

    def _restitution_end(self, segment: Segment) -> FloatArray:
        """A polynomial that becomes positive where the restitution ends."""
        series = {"stronge": segment.work, "poisson": segment.clock, "newton": segment.normal}
        result = series[self.law].copy()
        result[0] -= self._restitution_left()
        return result

    def _restitution_left(self) -> float:
        """Growth of work, impulse or normal velocity that is left until the restitution ends."""
        e = self.restitution
        if self.law == "stronge":
            # the work of compression is negative; restitution ends when the fraction e² of it is
            # given back
            return -e * e * self._work[0] - self._work[1]
        if self.law == "poisson":
            return e * self._clock[0] - self._clock[1]
        return -e * self.approach

    def _advance(self, segment: Segment, x: float) -> None:
        impulse = value(segment.impulse, x)
        self.normal_impulse += impulse
        self.compression_impulse += impulse if self.compressing else 0.0
        part = 0 if self.compressing else 1
        self._work[part] += value(segment.work, x)
        self._clock[part] += value(segment.clock, x)
        self.couple_impulse += value(segment.couple, x)
        self.friction = self.friction + [value(part, x) for part in segment.friction]
        if not self._sticks:
            self.slip = np.array([value(part, x) for part in segment.slip])
        if self._turning is not None or not self._weight:
            self.spin = value(segment.spin, x)
        self.normal = value(segment.normal, x)

    def _ends_with(self, event: Event) -> bool:
        """Process an event; return whether it ends the impact."""
        if event == "compressed":
            self.compressing, self.normal = False, 0.0
            # Without stored work or impulse there is no restitution.
            stored = {"stronge": self._work[0], "poisson": self._clock[0], "newton": self.approach}
            done = self.restitution * stored[self.law] == 0
        else:
            done = event == "returned"
        if event == "approaching again":
            self.compressing, self.normal = True, 0.0
        if event == "stopped" and not self._weight:
            # The energy stored while infinite friction stops the slip is negligible.
            done = not self.compressing and self.law != "newton"
            self._work, self._clock = [0.0, 0.0], [0.0, 0.0]
        if done:
            self._end_of_phase()
        elif event in ("stopped", "spin stopped", "spin starts"):
            self._end_of_phase()
            self._change_mode(event)
        return bool(done)

    def _change_mode(self, event: Event) -> None:
        if event == "spin starts":
            direction = self.slip / np.hypot(*self.slip)
            constant, slope = self._at_rest.couple
            self._turning = -float(np.sign(constant - self._friction * float(slope @ direction)))
            # The spin grows like the square of the impulse, and must not end at once by rounding.
            unit = float(np.linalg.norm(self.mobility.spin_force) / self.mobility.A.max())
            self.spin = self._turning * _FIRST_SPIN * self._size * unit
            self._straight, self._first_speed = None, float(np.hypot(*self.slip))
            return
        if event == "stopped":
            self.slip = np.zeros(2)
        else:
            self.spin = 0.0
        self._decide_at_rest()

    def _end_of_phase(self) -> None:
        self.phases.append(ImpactPhase(self._mode(), self.normal_impulse))
