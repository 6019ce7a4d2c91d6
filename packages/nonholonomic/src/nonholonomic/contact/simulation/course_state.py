"""The state of a simulated motion in contact, and its elementary changes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flowlanes.flow.cost import TooMuchError
from flowlanes.flow.validation import overflow_reason
from flowlanes.system.arrays import FloatArray

from ..friction.contensou import held_range_of, range_of
from ..friction.modes import FLIGHT, Mode, Range
from ..impact.impact import Impact, impact
from .compiled import ATTITUDE, OMEGA, POSITION, VELOCITY, WORK, CompiledContact, ContactNumbers
from .dynamic_jam import ends_in_jam
from .end_reasons import SINGULAR, EndError, EndReason
from .event_rules import EventRules
from .events import ContactEvent, EventKind
from .mode_integrator import PAUSE, ModeIntegrator, with_values
from .near_rest import Departure, dry_friction

#: Slip speeds relative to the typical speed of a motion: at SLIP_FLOOR integration switches to
#: logarithmic time; below NO_SLIP the slip counts as zero.  NO_SLIP lies above the rounding error
#: of a velocity, and SLIP_FLOOR well above the square root of that.
SLIP_FLOOR, NO_SLIP = 1e-8, 1e-12

#: The same for the angular velocity of rolling, in units of typical speed over body size, below
#: which rolling is taken straight to its end.
ROLLING_FLOOR = 1e-10

#: The same for a bounce that is treated as the last one when later bounces would not be lower.
LAST_BOUNCE = 1e-7

#: Other bounces are summed to their limit once a body in free fall would sink, within the time of
#: one bounce, by less than this fraction of its size.
_LEAST_DEPTH = 1e-14

#: Initial height at lift-off, as a fraction of the hop or of the body size.  It must be positive,
#: so that the flight does not count as a landing, and hides the rounding of the velocity.
_FIRST_RISE = 1e-20

#: Length of the first step of a flight, in hops, so that a landing is not at the start of a step.
_HOPS = 4

#: Smallest fraction of the remaining time that one stretch of steps must cover.
_LEAST_PROGRESS = 1e-12

#: A motion that ends within this fraction of its time is reported as failing at its start.
_SOON = 1e-6

#: Largest number of successive events at the same time.
_MOST_AT_ONE_INSTANT = 60

#: Number of steps after which control returns to Python, to report progress and to act on Ctrl-C.
_STRETCH = 2000


@dataclass(frozen=True, eq=False)
class Piece:
    """A part of a motion in which the mode does not change.

    Attributes
    ----------
    mode : Mode
    integrator : ModeIntegrator
    begin, end : float
        Times.
    times : array (n,)
        Sample times within.
    states : array (n, columns)
        States of the integrator's system, whose first columns are common to all modes.
    """

    mode: Mode
    integrator: ModeIntegrator
    begin: float
    end: float
    times: FloatArray
    states: FloatArray


class CourseState:
    """The state of a simulation, with the data and operations common to all transitions.

    Parameters
    ----------
    contact : CompiledContact
    state : array (size,)
        State at the first of the moments.
    moments : array (n,)
        Sample times, increasing.
    rules : EventRules
    """

    def __init__(
        self, contact: CompiledContact, state: FloatArray, moments: FloatArray, rules: EventRules
    ) -> None:
        self.contact, self.rules, self.moments = contact, rules, moments
        self.time, self.state = float(moments[0]), state
        self.mode = Mode()
        self.pieces: list[Piece] = []
        self.events: list[ContactEvent] = []
        self.steps, self.reason = 0, ""
        self.ending: EndReason = ""
        self._height, self._hop = 0.0, math.inf
        self._dry = dry_friction(contact.situation)
        self._spin_sign = 1.0
        self._next_moment = self._idle = 0
        self._floor_factor = self._rolling_factor = 1.0
        known = contact.numbers(state)
        body = contact.situation.body
        # A body may touch its support at its centre of mass.
        gyration = math.sqrt(float(np.trace(body.tensor)) / (2 * body.mass))
        self._length = float(np.linalg.norm(known.r)) or gyration
        fall = math.sqrt(1e-6 * float(np.linalg.norm(known.free_acceleration)) * self._length)
        turning = float(np.linalg.norm(state[OMEGA])) * self._length
        slip = float(np.linalg.norm(known.slip))
        self._speed = max(fall, turning, slip, float(np.linalg.norm(state[VELOCITY])))

    def _end(self, ending: EndReason, reason: str) -> None:
        """End the motion early; the state reached becomes the last sample."""
        self.ending, self.reason = ending, reason
        if not self.pieces:
            self._add_piece(self._integrator(self.mode), self.time, self.state[None])
            return
        last = self.pieces[-1]
        if not any(self.time in piece.times for piece in self.pieces[-2:]):
            columns = last.integrator.state_of_system(self.state)
            sample = np.array([self.time])
            self.pieces.append(replace(last, begin=self.time, times=sample, states=columns[None]))

    def _integrate(self) -> str:
        """Integrate in the current mode to the next event or pause, and return its guard."""
        integrator = self._integrator(self.mode)
        last = float(self.moments[-1])
        end = min(last, self.time + _HOPS * self._hop)
        state, wanted = self._with_height(self.state), self._moments_until(end)
        outcome = integrator.advance(self.time, state, wanted, end, _STRETCH)
        self._hop = math.inf
        self._add_piece(integrator, outcome.time, outcome.samples)
        # Near a singularity the steps tend to zero.
        least = _LEAST_PROGRESS * max(abs(self.time), min(last - self.time, self._typical_time))
        progress = outcome.time - self.time
        stalls = outcome.guard == PAUSE and progress <= least
        self.steps += outcome.steps
        self._idle = 0 if outcome.time > self.time else self._idle + 1
        self.time, self.state = outcome.time, outcome.state[: len(self.state)]
        if not self.mode.touching:
            self._height = float(outcome.state[-1])
        if outcome.guard == "failure" or stalls:
            if ends_in_jam(integrator, self._numbers(), self.state):
                return "paradox"
            self._require_smooth(integrator)
            raise EndError("singular", "; ".join(filter(None, (SINGULAR, self._extremes()))))
        if self._idle > _MOST_AT_ONE_INSTANT:
            raise EndError("many events", f"more and more events at t = {self.time:.9g}")
        rates = [float(np.linalg.norm(self.state[part])) for part in (OMEGA, VELOCITY)]
        times = float(self.moments[0]), self.time, last
        self.rules.require_few(len(self.events), self.steps, *times, *rates)
        if outcome.guard == PAUSE and progress <= _LEAST_PROGRESS * (last - self.time):
            raise TooMuchError(
                f"to follow a motion for {last - float(self.moments[0]):g} s would take more than "
                f"{_STRETCH / _LEAST_PROGRESS:.0e} steps"
            )
        return outcome.guard or (PAUSE if self.time < last else "")

    def _require_smooth(self, integrator: ModeIntegrator) -> None:
        """End the motion if a friction law is not smooth at this state, and say why."""
        values = integrator.guard_values(self.state)
        for guard, value in zip(integrator.system.guards, values, strict=True):
            if guard.name == "creep" and value <= 0:
                raise EndError("guard", guard.message)

    @property
    def _typical_time(self) -> float:
        """A typical time of the motion: the body size divided by its speed."""
        return self._length / self._speed if self._speed else math.inf

    def _extremes(self) -> str:
        """Name the extreme numbers that prevent a step; empty if the motion is under way."""
        if (passed := self.time - self.moments[0]) > _SOON * np.ptp(self.moments):
            return ""
        integrator, state = self._integrator(self.mode), self._with_height(self.state)
        if passed:
            numbers = zip(integrator.places, integrator.values, strict=True)
            place, value = max(numbers, key=lambda pair: abs(math.log10(abs(pair[1] or 1.0))))
            return f"of the numbers given, {place} = {value:g} is the farthest from 1"
        size = len(state)
        names = [*map(str, integrator.system.symbols), *integrator.places]

        def finite(numbers: Sequence[float]) -> bool:
            return integrator.has_step(np.array(numbers[:size]), np.array(numbers[size:]))

        return overflow_reason(names, [*state, *integrator.values], finite)

    def _moments_until(self, end: float) -> list[float]:
        """The remaining sample times up to `end`."""
        count = int(np.searchsorted(self.moments, end, side="right"))
        return list(self.moments[self._next_moment : count])

    def _with_height(self, state: FloatArray) -> FloatArray:
        """A state (size,) extended by the height in flight."""
        return state if self.mode.touching else np.append(state, self._height)

    def _add_piece(self, integrator: ModeIntegrator, end: float, states: FloatArray) -> None:
        times = self.moments[self._next_moment : self._next_moment + len(states)]
        self.pieces.append(Piece(self.mode, integrator, self.time, end, times, states))
        self._next_moment += len(states)

    def _integrator(self, mode: Mode) -> ModeIntegrator:
        return with_values(self.contact.mode(mode), self._run_values)

    @property
    def _run_values(self) -> dict[str, float]:
        """Values of the parameters that the simulation sets, by name."""
        floor = SLIP_FLOOR * self._speed * self._floor_factor
        return {
            "spin_sign": self._spin_sign,
            "slip_floor": floor,
            "rolling_floor": self._rolling_floor,
        }

    @property
    def _rolling_floor(self) -> float:
        """Angular velocity of rolling below which rolling is taken to its end."""
        return ROLLING_FLOOR * self._speed / self._length * self._rolling_factor

    def _numbers(self) -> ContactNumbers:
        known = self.contact.numbers(self.state)
        if self.mode.touching and not self.mode.rolling:
            return self.contact.without_rolling(known)
        return known

    def _balance(self) -> float:
        """The energy plus all dissipated work; it is constant."""
        return self._numbers().energy + float(self.state[WORK:].sum())

    def _project(self, mode: Mode) -> None:
        self.state = self._integrator(mode).project(self.state)

    def _record(
        self,
        kind: EventKind,
        before: FloatArray,
        *impacts: Impact,
        unique: bool = True,
    ) -> None:
        impulse = sum((item.impulse for item in impacts), np.zeros(3))
        couple = sum(item.couple_impulse for item in impacts)
        self.events.append(
            ContactEvent(
                self.time,
                kind,
                self.mode.name,
                before.copy(),
                self.state.copy(),
                impulse,
                couple,
                unique,
            )
        )

    def _correct_event(self, time: float) -> None:
        """Correct the mode and the state that follow an event once they have been decided.

        The state after the event is kept if the motion has continued since.
        """
        if not self.events or self.events[-1].time != time:
            return
        last, kind = self.events[-1], self.events[-1].kind
        after = self.state.copy() if self.time == time else last.after
        if kind in ("stick", "rolling stop") and self.mode.name == "rest":
            kind = "rest"
        self.events[-1] = replace(last, kind=kind, mode=self.mode.name, after=after)

    def _range_of(self, numbers: ContactNumbers) -> Range:
        if not self._dry.patch:
            return ""
        return range_of(float(np.linalg.norm(numbers.slip)), numbers.spin, self._dry.patch)

    def _mode_at_rest(self, spin_at_rest: bool) -> Mode:
        if self._dry.patch:
            return self._mode_without_slip(spinning=False, span="above")
        return self._mode_without_slip(spinning=not spin_at_rest)

    def _mode_without_slip(self, spinning: bool, span: Range = "") -> Mode:
        return Mode(sliding=False, spinning=spinning, rolling=self.mode.rolling, range=span)

    def _normal_force_and_couple(self, mode: Mode) -> tuple[float, float]:
        """Normal force, and the couple about the normal without that of the rolling resistance."""
        values = self._integrator(mode).outputs(self.state)
        N = float(values["normal_force"])
        return N, float(values["gamma"] @ (values["friction_couple"] - N * self._numbers().q))

    def _least_rebound(self, ratio: float) -> float:
        """Rebound velocity below which a bounce is summed together with all later ones.

        Parameters
        ----------
        ratio : float
            Ratio of the normal velocities after and before the present bounce.
        """
        if not ratio < 1:
            return LAST_BOUNCE * self._speed
        depth = _LEAST_DEPTH * self._length * abs(self._numbers().unheld_rise)
        return max((1 - ratio) * math.sqrt(depth), NO_SLIP * self._speed)

    def _pass_bounces(self, rebound: float, ratio: float) -> None:
        """Replace infinitely many bounces, which converge geometrically to rest, by one free fall.

        The impact at the end of the fall applies the impulses of all bounces together.  Bounces
        that do not become lower count as a single one.
        """
        fall = -self._numbers().unheld_rise
        end = self.time + 2 * rebound / (fall * (1 - ratio if ratio < 1 else 1))
        flight = self._integrator(FLIGHT)
        state, wanted = flight.state_of_system(self.state), self._moments_until(end)
        outcome = flight.advance(self.time, state, wanted, end)
        self.mode = FLIGHT
        self._add_piece(flight, end, outcome.samples)
        self.time, self.state = end, outcome.state[: len(self.state)]

    def _rise(self) -> None:
        """Begin a flight, from a height of almost zero unless the body is above the support."""
        known = self._numbers()
        if known.gap > 1e-14 * (self._length + float(np.abs(self.state[POSITION]).max())):
            self._height = known.gap
            return
        from scipy.spatial.transform import Rotation

        up = Rotation.from_quat(self.state[ATTITUDE], scalar_first=True).apply(known.mobility.gamma)
        self.state = self.state.copy()
        self.state[POSITION] -= known.gap * up
        rising = float(known.mobility.gamma @ known.contact_velocity)
        if rising > NO_SLIP * self._speed and known.unheld_rise < 0:
            self._hop = -2 * rising / known.unheld_rise
            self._height = _FIRST_RISE * rising * self._hop
        else:
            # Where the normal force falls to zero the height grows only like t³.
            self._height = _FIRST_RISE * self._length

    def _collide(self, restitution: float) -> Impact:
        known = self._numbers()
        if self._dry.unknown_in_impacts:
            raise EndError(
                "impact",
                f"the friction of an impact is not known: {self._dry.unknown_in_impacts}, and "
                "impacts follow formulas in slip_speed alone, with a constant couple",
            )
        receding = float(known.mobility.gamma @ known.slip)
        result = impact(
            known.mobility,
            known.slip - max(receding, 0.0) * known.mobility.gamma,
            known.spin if self._dry.spin_arm else 0.0,
            mu=self._dry.mu,
            spin_arm=self._dry.spin_arm,
            viscous=self._dry.viscous,
            order=self._dry.order,
            force=self._dry.force,
            restitution=restitution,
            law=self.rules.impact_law,
        )
        self._push(result.impulse, result.couple_impulse)
        return result

    def _push(self, impulse: FloatArray, couple_impulse: float) -> None:
        """Change the velocities by an impulse; the energy lost counts as work of the impact."""
        known, state = self._numbers(), self.state.copy()
        mobility = known.mobility
        state[VELOCITY] += mobility.velocity_jump(impulse)
        state[OMEGA] += mobility.angular_velocity_jump(impulse, couple_impulse)
        state[WORK] += known.energy - self.contact.numbers(state).energy
        self.state = state

    def _hold(self, choice: Departure) -> None:
        if self._dry.patch:
            span = held_range_of(
                choice.couple / self._dry.patch, self._dry.mu * choice.normal_force
            )
            self.mode = self._mode_without_slip(spinning=False, span=span)
            self._spin_sign = math.copysign(1.0, choice.couple)
            return
        spinning = bool(choice.spin_sign) or not self._dry.spin_arm
        self.mode = self._mode_without_slip(spinning)
        self._spin_sign = choice.spin_sign or self._spin_sign
