"""Simulation of a motion in contact: smooth intervals separated by events."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from flowlanes.errors import InputError, RunError
from flowlanes.system.arrays import FloatArray

from ..friction.contensou import held_range_of
from ..friction.modes import FLIGHT, Mode, Range
from ..impact.impact import Impact
from ..slip.stopping import WEAK, finish_stop
from .compiled import WORK
from .course_state import NO_SLIP, SLIP_FLOOR
from .creep_transitions import CreepTransitions
from .dynamic_jam import normal_response, state_after_jam
from .end_reasons import NO_RETURN, SINGULAR, EndError
from .events import EventKind
from .mode_integrator import PAUSE
from .near_rest import departure, first_direction, frozen_slip, state_after_stop, sudden_direction
from .onset import onset_of_sliding
from .paradox import paradox_words

#: Relative size below which gaps, normal velocities and normal accelerations count as zero.
_LEVEL = 1e-9

#: Smallest factors of the slip floor when a slip passes close to zero (a slip of 1e-14 of the
#: typical speed, which is rounding error), and when a slip decays slowly.
_LOWEST, _WEAK_FLOOR = 1e-6, 1e-3


class Course(CreepTransitions):
    """The simulation of a motion, with the arguments of `CourseState`."""

    # --- driving ---------------------------------------------------------------------------

    def run(self, progress: Callable[[float], None] | None = None) -> None:
        """Advance the motion through its sample times, or until it ends early."""
        end = float(self.moments[-1])
        try:
            self._enter()
            self._begin_to_roll()
            while self.time < end or self._next_moment < len(self.moments):
                guard = PAUSE if self._creep() else self._integrate()
                if progress is not None:
                    progress(self.time)
                if not guard:
                    break
                if guard != PAUSE:
                    self._handle(guard)
        except EndError as stop:
            self._end(stop.ending, str(stop))
        except RunError as error:
            self._end("failure", str(error.args[0]))
        except np.linalg.LinAlgError:
            self._end("singular", SINGULAR)

    # --- modes -----------------------------------------------------------------------------

    def _enter(self) -> None:
        """Choose the initial mode."""
        known = self._numbers()
        normal = float(known.mobility.gamma @ known.contact_velocity)
        # A final state of another motion, or a decimal in a file, may miss the contact by
        # rounding.
        slow = abs(normal) <= _LEVEL * self._speed
        if known.gap > (_LEVEL if slow else 1e-12) * self._length:
            self.mode, self._height = FLIGHT, known.gap
        elif slow:
            self._keep_contact(None, self.state)
        elif normal > 0:
            self._take_off()
        else:
            self._land()

    def _settle(self, kind: EventKind | None, before: FloatArray, *impacts: Impact) -> None:
        """Choose the mode of a contact without normal velocity, and record the event."""
        known = self._numbers()
        slip = float(np.linalg.norm(known.slip))
        arm = (self._dry.patch or self._length) * abs(known.spin)
        threshold = NO_SLIP * self._speed
        spin_at_rest = bool(self._dry.spin_arm) and arm <= threshold
        resting = slip <= threshold and not (self._dry.patch and arm > threshold)
        if self._dry.mu and resting:
            self._project(self._mode_at_rest(spin_at_rest))
            self._leave_rest(kind, before, *impacts, spin_at_rest=spin_at_rest)
            return
        if spin_at_rest:
            self._decide_on_spin(sliding=True)
        else:
            self._spin_sign = math.copysign(1.0, known.spin)
            self._slide()
        if kind:
            self._record(kind, before, *impacts)
        self._require_pressure()

    def _slide(self) -> None:
        """Continue sliding, in the friction range of the current state."""
        known = self._numbers()
        slip = float(np.linalg.norm(known.slip))
        self.mode = replace(self.mode, touching=True, sliding=True)
        self.mode = replace(self.mode, range=self._range_of(known))
        # A slide may already start slower than the usual slip floor.
        size = math.hypot(slip, self._dry.patch * known.spin)
        floor = SLIP_FLOOR * self._speed * self._floor_factor
        if self._dry.mu and 0 < size < 10 * floor:
            self._floor_factor *= 0.01 * size / floor

    def _require_pressure(self) -> None:
        """Lift off, or detect a paradox, if a sliding contact has no positive normal force."""
        if not self.mode.sliding or not self.mode.touching:
            return
        if self.mode.rolling and self._rolling_is_zero:
            # The resistance to rolling is decided later.
            return
        integrator = self._integrator(self.mode)
        N = float(integrator.outputs(self.state)["normal_force"])
        names = [guard.name for guard in integrator.system.guards]
        values = integrator.guard_values(self.state)
        paradox = "paradox" in names and values[names.index("paradox")] <= 0
        if N > 0 and not paradox:
            return
        if paradox and self._numbers().unheld_rise < 0:
            self._paradox()
        else:
            self._lift_off()

    def _leave_rest(
        self,
        kind: EventKind | None,
        before: FloatArray,
        *impacts: Impact,
        spin_at_rest: bool,
    ) -> None:
        """Hold a contact without slip if friction can, or else let it begin to slide."""
        known = self._numbers()
        sign = 0.0 if spin_at_rest else math.copysign(1.0, known.spin)
        choice = departure(known, self._dry, sign)
        if choice is None or choice.normal_force <= 0:
            self._leave_support(kind, before, *impacts)
            return
        if choice.holds:
            self._hold(choice)
            if kind == "spin stop" and self.mode.spinning:
                kind = "spin reversal"
            if kind:
                self._record(kind, before, *impacts, unique=choice.unique)
            return
        if kind in ("stick", "spin stop"):
            kind = "direct restart"
        self._spin_sign = choice.spin_sign or self._spin_sign
        spinning = bool(self._dry.patch or choice.spin_sign or not spin_at_rest)
        self.mode = Mode(spinning=spinning, rolling=self.mode.rolling)
        if kind:
            self._record(kind, before, *impacts, unique=choice.unique)
        self._begin(choice.direction)

    def _leave_support(self, kind: EventKind | None, before: FloatArray, *impacts: Impact) -> None:
        """Leave a support that no longer presses on a contact without slip."""
        strength = float(np.linalg.norm(self._numbers().free_acceleration))
        if self._numbers().unheld_rise < -_LEVEL * strength:
            if self._dry.never_slips:
                raise EndError(
                    "pulled",
                    "the support would have to pull the rolling body, which left alone would be "
                    "pressed into it: neither rolling nor leaving is possible",
                )
            if self._numbers().normal_rate >= 0:
                raise EndError("lifted", NO_RETURN)
            raise EndError("neither", "the contact can neither be held nor slide in any direction")
        if kind and kind != "stick":
            self.mode = FLIGHT
            self._record(kind, before, *impacts)
        self._take_off()

    def _begin(self, direction: FloatArray) -> None:
        """Start sliding from zero slip in a direction (of slip and spin for a patch)."""
        known = self._numbers()
        if self.mode.rolling and self._resists_rolling and not known.rolling.any():
            raise EndError(
                "no beginning",
                "sliding begins while the body does not roll, where resistance to rolling has no "
                "direction: start it with some rolling",
            )
        if self._dry.patch and direction[3]:
            self._spin_sign = math.copysign(1.0, direction[3])
        if self._begins_to_creep(direction):
            return
        slide = onset_of_sliding(
            self.contact,
            self.time,
            self.state,
            self.mode,
            direction,
            self._spin_sign,
            0.02 / self._turning_rate,
        )
        if slide is None:
            raise EndError(
                "no beginning", "sliding begins, but no motion with a growing slip was found"
            )
        self._take_onset(slide)
        self._floor_factor = 1.0
        self._slide()

    # --- events ----------------------------------------------------------------------------

    def _handle(self, guard: str) -> None:
        handlers: dict[str, Callable[[], None]] = {
            "lift-off": self._lift_off,
            "landing": self._land,
            "stick": self._stick,
            "stop": self._stick,
            "slip": self._slip,
            "spin stop": self._spin_stop,
            "spin start": self._spin_start,
            "rolling stop": self._rolling_stop,
            "rolling start": self._rolling_start,
            "range": self._change_range,
            "paradox": self._paradox,
        }
        if guard == "creep" and self._creep_law is not None:
            return
        if guard not in handlers:
            messages = {g.name: g.message for g in self._integrator(self.mode).system.guards}
            raise EndError("guard", messages.get(guard) or guard)
        self._rolling_factor = 1.0
        handlers[guard]()
        if self.mode.touching and not self.mode.rolling:
            self._decide_on_rolling()

    def _lift_off(self) -> None:
        if not self.mode.sliding:
            self._leave_support(None, self.state)
            return
        strength = float(np.linalg.norm(self._numbers().free_acceleration))
        if self._numbers().unheld_rise < -_LEVEL * strength:
            raise EndError("lifted", NO_RETURN)
        self._take_off()

    def _take_off(self) -> None:
        before = self.state
        self.mode = FLIGHT
        self._project(FLIGHT)
        self._record("lift-off", before)
        if self.rules.on_liftoff == "stop":
            raise EndError("lift-off", "the body leaves the support")
        self._rise()

    def _land(self) -> None:
        """Apply the impact of a landing, after which the body rebounds or stays."""
        before = self.state
        known = self._numbers()
        normal = float(known.mobility.gamma @ known.contact_velocity)
        if normal > -NO_SLIP * self._speed:
            # a grazing contact
            self._keep_contact("landing", before)
            return
        self._rebound("landing", before, self._collide(self.rules.restitution))

    def _rebound(self, kind: EventKind, before: FloatArray, result: Impact) -> None:
        """Fly off or stay in contact after an impact."""
        known = self._numbers()
        rebound = float(known.mobility.gamma @ result.contact_velocity)
        approach = -float(known.mobility.gamma @ self.contact.numbers(before).contact_velocity)
        ratio = rebound / approach if approach > 0 else math.inf
        # A rebound velocity of rounding size must not decide if friction may press the body down.
        none = NO_SLIP * self._speed
        if rebound > self._least_rebound(ratio) or (rebound > none and known.unheld_rise >= 0):
            self.mode = FLIGHT
            self._rise()
            self._record(kind, before, result)
            return
        if rebound <= none:
            self._keep_contact(kind, before, result)
            return
        self._pass_bounces(rebound, ratio)
        self._keep_contact(kind, before, result, self._collide(0.0))

    def _keep_contact(self, kind: EventKind | None, before: FloatArray, *impacts: Impact) -> None:
        """Continue in contact with zero normal velocity."""
        known = self._numbers()
        # With infinite μ there are no equations of sliding, and an impact stops any slip.
        if not self._dry.never_slips:
            self._project(Mode(range=self._range_of(known)))
        elif float(np.linalg.norm(known.slip)) <= NO_SLIP * self._speed:
            self._project(Mode(sliding=False))
        else:
            raise InputError("state: with mu = inf the contact cannot slip; its slip must be zero")
        self._settle(kind, before, *impacts)
        self._decide_on_rolling()

    def _stick(self) -> None:
        """Finish a stop; then hold the contact or let it slide off in another direction."""
        before, known, balance = self.state, self._numbers(), self._balance()
        spin_at_rest = not self.mode.spinning
        dry = self._dry.near_stop(float(np.linalg.norm(known.slip)))
        slip = frozen_slip(known, dry, 0.0 if spin_at_rest else self._spin_sign)
        x = known.mobility.tangents @ known.slip
        if self._dry.patch:
            x = np.append(x, self._dry.patch * known.spin)
        try:
            stop = finish_stop(slip, x, float(np.linalg.norm(x)))
        except RunError:
            # The slip passes close to zero without reaching it.
            if self._creep():
                return
            self._floor_factor *= 1e-2
            if self._floor_factor < _LOWEST:
                raise EndError(
                    "no end", "the slip stays at rounding size without coming to an end"
                ) from None
            return
        weak = -stop.growth < WEAK * stop.greatest_rate
        if weak and not self._dry.patch and self._floor_factor > _WEAK_FLOOR:
            # The stop takes so long that the rest of the state changes: integrate further first.
            self._floor_factor *= 1e-2
            return
        self._floor_factor = 1.0
        self.state = state_after_stop(known, self._dry, self.state, stop)
        self.time += stop.duration
        self._project(self._mode_at_rest(spin_at_rest))
        column = self.contact.work_column(self._dry.law)
        self.state[column] += balance - self._balance()
        self._leave_rest("stick", before, spin_at_rest=spin_at_rest)

    def _slip(self) -> None:
        """Start sliding: the friction of a contact at rest has reached its limit."""
        before = self.state
        values = self._integrator(self.mode).outputs(self.state)
        N, couple = self._normal_force_and_couple(self.mode)
        direction = first_direction(self._dry, N, values["friction_force"], couple)
        if not self._dry.patch:
            sign = self._spin_sign if self.mode.spinning else 0.0
            sudden = sudden_direction(self._numbers(), self._dry, sign, direction)
            if sudden is None:
                self._leave_support(None, before)
                return
            direction = sudden
        spinning = self.mode.spinning or bool(self._dry.patch)
        self.mode = Mode(spinning=spinning, rolling=self.mode.rolling)
        self._record("slip", before)
        self._begin(direction)

    def _change_range(self) -> None:
        if self.mode.sliding:
            known = self._numbers()
            span = self._range_of(known)
            self._spin_sign = math.copysign(1.0, known.spin)
        else:
            N, couple = self._normal_force_and_couple(self.mode)
            span = held_range_of(couple / self._dry.patch, self._dry.mu * N)
            self._spin_sign = math.copysign(1.0, couple)
        if span == self.mode.range:
            # The event lies exactly on the border: move to the neighbouring range.
            neighbours: dict[Range, Range] = {
                "inner": "middle",
                "outer": "middle",
                "below": "above",
                "above": "below",
            }
            span = neighbours.get(span, span)
        self.mode = replace(self.mode, range=span)

    def _paradox(self) -> None:
        """Handle a state without a motion in contact: end, or apply an impact without collision."""
        part = 1.0 if self.rules.on_paradox == "stop" else 2.0
        jam = state_after_jam(
            self._integrator(self.mode), self._numbers(), self.state, self._speed, part
        )
        if jam is not None:
            balance = self._balance()
            column = WORK + int(np.abs(jam[0][WORK:] - self.state[WORK:]).argmax())
            self.state = jam[0]
            self.time += jam[1]
            self._project(self.mode)
            # The work of so large a force varies with the slip it stops: restore the balance.
            self.state[column] += balance - self._balance()
        known = self._numbers()
        response = normal_response(self._integrator(self.mode), known, self.state)
        words = paradox_words(self.time, known, self.state, response, jam is not None)
        if self.rules.on_paradox == "stop":
            raise EndError("paradox", words)
        before = self.state
        self.mode = replace(self.mode, rolling=True)
        result = self._collide(self.rules.restitution)
        if result.normal_impulse <= 0:
            raise EndError("paradox", words)
        self._rebound("impact without collision", before, result)
