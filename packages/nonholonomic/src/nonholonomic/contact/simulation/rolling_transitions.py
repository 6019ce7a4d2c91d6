"""Transitions of rolling under its resistance: end, reversal and beginning."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import replace

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..friction.friction_law import FrictionLaw
from .compiled import OMEGA, WORK
from .course_state import NO_SLIP, SLIP_FLOOR
from .end_reasons import EndError
from .onset import Onset, onset_of_rolling
from .rolling_end import rolling_rate, rolling_restart, state_with_rolling
from .spin_transitions import SpinTransitions

_NEITHER = "rolling can neither be held nor begin: the resistance to it has no direction here"


class RollingTransitions(SpinTransitions, ABC):
    """A simulation in which rolling may end, reverse or begin."""

    @abstractmethod
    def _lift_off(self) -> None:
        """Lift off, or detect a paradox, when the normal force has fallen to zero."""

    @abstractmethod
    def _require_pressure(self) -> None:
        """Lift off, or detect a paradox, if a sliding contact has no positive normal force."""

    def _decide_on_rolling(self) -> None:
        """After a transition, hold a rolling velocity of zero or let rolling begin."""
        before, time = self.mode, self.time
        self._begin_to_roll()
        if self.mode != before:
            self._correct_event(time)

    def _begin_to_roll(self) -> None:
        """Hold a rolling velocity of zero, or let rolling begin."""
        size = SLIP_FLOOR * self._speed / self._length
        if not (self.mode.touching and self._rolling_is_zero) or self._hold_rolling():
            return
        self.mode = replace(self.mode, rolling=True)
        restart = rolling_restart(
            self._integrator(self.mode), self._numbers(), self.state, size, self.mode.sliding
        )
        if restart is None:
            raise EndError("rolling held", _NEITHER)
        if self.mode.sliding and self._normal_force_with_rolling(size * restart[0]) <= 0:
            self._lift_off()
            return
        self._roll_back(*restart)
        if self.mode.sliding:
            self._require_pressure()
        else:
            # The resistance changes the friction that holds the contact.
            self._leave_rest(None, self.state, spin_at_rest=not self.mode.spinning)

    def _normal_force_with_rolling(self, rolling: FloatArray) -> float:
        """The normal force with a small rolling velocity (3,) while the contact slides."""
        there = state_with_rolling(self._numbers(), self.state, rolling, slips=True)
        return float(self._integrator(self.mode).outputs(there)["normal_force"])

    def _rolling_stop(self) -> None:
        """Handle the end of rolling under resistance: it is held, or the body rolls back."""
        before, known = self.state, self._numbers()
        mode, integrator = self.mode, self._integrator(self.mode)
        size = float(np.linalg.norm(known.rolling))
        rates = integrator.rates(self.state)
        loss = -float(known.rolling @ rolling_rate(known, rates[OMEGA])) / size
        if loss <= 0:
            raise EndError("no end", "rolling comes close to its end and does not reach it")
        self._advance_evenly(rates, size / loss, np.zeros(3))
        self.time += size / loss
        if self._hold_rolling():
            self._record("rest" if self.mode.name == "rest" else "rolling stop", before)
            return
        restart = rolling_restart(integrator, self._numbers(), self.state, size, mode.sliding)
        if restart is None:
            raise EndError("rolling held", _NEITHER)
        self._roll_back(*restart)
        self._record("rolling reversal", before)

    def _rolling_start(self) -> None:
        """Start rolling when the resistance has reached its limit; it grows like t²."""
        held = self._integrator(self.mode)
        couple = held.outputs(self.state)["friction_couple"]
        self.mode = replace(self.mode, rolling=True)
        self._record("rolling start", self.state)
        roll = onset_of_rolling(
            self.contact,
            self.time,
            self.state,
            self.mode,
            couple,
            self._run_values,
            0.02 / self._turning_rate,
        )
        if roll is None:
            raise EndError(
                "no beginning", "rolling begins, but no motion with a growing rolling was found"
            )
        self._take_onset(roll)
        reached = float(np.linalg.norm(self._numbers().rolling))
        self._rolling_factor = min(1.0, 0.25 * reached / self._rolling_floor)

    def _take_onset(self, start: Onset) -> None:
        """Continue from the end of an onset."""
        end = self.time + start.duration
        samples = start.samples(self.time, self.state, self._moments_until(end))
        self._add_piece(start.integrator, end, samples)
        self.time, self.state = end, start.state

    @property
    def _turning_rate(self) -> float:
        """A typical rate (1/s) of the motion."""
        speed = float(np.linalg.norm(self.state[OMEGA]))
        strength = float(np.linalg.norm(self._numbers().free_acceleration))
        return max(speed, math.sqrt(strength / self._length))

    def _roll_back(self, direction: FloatArray, rate: float) -> None:
        """Continue rolling from rest in a direction that is invariant while rolling grows."""
        usual = self._turning_rate**2
        # The slower rolling grows, the shorter the time over which its growth may count as
        # uniform.
        self._rolling_factor = min(1.0, max(rate / usual, 1e-6))
        rolling = 2 * self._rolling_floor * direction
        there = state_with_rolling(self._numbers(), self.state, rolling, self.mode.sliding)
        lasting = float(np.linalg.norm(rolling)) / rate
        self._advance_evenly(self._integrator(self.mode).rates(there), lasting, rolling)
        self.time += lasting

    def _advance_evenly(self, rates: FloatArray, lasting: float, rolling: FloatArray) -> None:
        """Advance through a short time at constant rates, to a given rolling velocity (3,)."""
        known = self._numbers()
        total = known.energy + float(self.state[WORK:].sum())
        self.state = self.state + lasting * rates
        self.state = state_with_rolling(self._numbers(), self.state, rolling, self.mode.sliding)
        self._project(self.mode)
        column = self.contact.work_column(self._law_of_rolling().name)
        self.state[column] += total - self._numbers().energy - float(self.state[WORK:].sum())

    def _hold_rolling(self) -> bool:
        """Hold a rolling velocity of zero if the resistance can; return whether it does."""
        situation = self.contact.situation
        if situation.body.shape.edge_radius is not None and self._law_of_rolling().is_along_contour:
            # The contact of a disk moves only along its edge.
            return False
        spins = self.mode.spinning and not self._spin_stays_zero()
        held = replace(self.mode, rolling=False, spinning=spins)
        integrator = self._integrator(held)
        state = integrator.project(self.state)
        names = [guard.name for guard in integrator.system.guards]
        margins = dict(zip(names, integrator.guard_values(state).tolist(), strict=True))
        if margins["rolling start"] < 0 or margins["lift-off"] <= 0:
            return False
        lost = self._numbers().energy
        self.mode, self.state = held, state
        column = self.contact.work_column(self._law_of_rolling().name)
        self.state[column] += lost - self._numbers().energy
        if margins.get("slip", 1.0) < 0:
            # The resistance changes the friction that holds the contact.
            self._leave_rest(None, self.state, spin_at_rest=not spins)
        return True

    def _spin_stays_zero(self) -> bool:
        """Whether a body that neither slides nor rolls has no spin and receives none."""
        known = self._numbers()
        if self.mode.sliding or abs(known.spin) * self._length > NO_SLIP * self._speed:
            return False
        if self.contact.situation.surface.is_flat:
            # No force has a moment about the vertical through the contact.
            return True
        held = replace(self.mode, rolling=False)
        rates = self._integrator(held).rates(self._integrator(held).project(self.state))
        change = float(known.gamma @ rolling_rate(known, rates[OMEGA]))
        strength = float(np.linalg.norm(known.free_acceleration))
        return abs(change) * self._length <= 1e-9 * strength

    @property
    def _rolling_is_zero(self) -> bool:
        """Whether the rolling velocity is zero, so that resistance to rolling has no direction."""
        rolling = float(np.linalg.norm(self.contact.numbers(self.state).rolling))
        least = 1e-4 * SLIP_FLOOR * self._speed / self._length
        return self._resists_rolling and rolling <= least

    @property
    def _resists_rolling(self) -> bool:
        return any(law.holds_rolling for law in self.contact.situation.laws)

    def _law_of_rolling(self) -> FrictionLaw:
        return next(law for law in self.contact.situation.laws if law.holds_rolling)
