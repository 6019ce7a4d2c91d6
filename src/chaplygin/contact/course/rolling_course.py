"""The end of rolling under its resistance, in the course of a motion."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

from ...core.arrays import FloatArray
from ..friction.friction_law import FrictionLaw
from ..friction.modes import Mode
from ..impact.impact import Impact
from .compiled import (
    OMEGA,
    VELOCITY,
)
from .course_state import SLIP_FLOOR, CourseState
from .endings import EndError
from .events import EventKind
from .rolling_end import rolling_restart, state_with_rolling

_ROLLING_HELD = (
    "the resistance to rolling holds the rolling while the body still {}: a motion that is not "
    "computed"
)


class RollingCourse(CourseState, ABC):
    """A motion whose rolling may end, turn back or begin."""

    @abstractmethod
    def _leave_rest(
        self,
        kind: EventKind | None,
        before: FloatArray,
        *impacts: Impact,
        spin_at_rest: bool,
    ) -> None:
        """Hold a contact without slip if friction can, or begin to slide."""

    def _begin_to_roll(self) -> None:
        """Decide on rolling that a resistance holds at zero, at the start or after an impact."""
        if not self._resists_rolling:
            return
        known = self._known()
        size = SLIP_FLOOR * self._speed / self._length
        if not self.mode.touching or float(np.linalg.norm(known.rolling)) > 1e-4 * size:
            return
        integrator = self._integrator(self.mode)
        restart = rolling_restart(integrator, known, self.state, size, self.mode.sliding)
        if restart is not None:
            self._roll_back(*restart)
            if not self.mode.sliding:
                # the resistance changes the friction that holds the contact
                self._leave_rest(None, self.state, spin_at_rest=not self.mode.spinning)
        elif self.mode.sliding or abs(known.spin) * self._length > 1e-7 * self._speed:
            raise EndError("rolling held", _ROLLING_HELD.format("slides or spins about the normal"))
        else:
            self._rest()

    def _rolling_stop(self) -> None:
        """Rolling comes to its end under resistance: the body rests, or rolls back."""
        before, known = self.state, self._known()
        mode, integrator = self.mode, self._integrator(self.mode)
        rolling = known.rolling
        size = float(np.linalg.norm(rolling))
        rate = integrator.rates(self.state)[OMEGA]
        loss = -float(rate @ rolling) / size
        if loss <= 0:
            raise EndError("no end", "rolling comes close to its end and does not reach it")
        remaining = size / loss
        state = self.state + 0.5 * remaining * known.rates_of_place
        self.state = state_with_rolling(known, state, np.zeros(3), mode.sliding)
        self.time += remaining
        self._project(mode)
        column = self.contact.work_column(self._law_of_rolling().name)
        self.state[column] += known.energy - self._known().energy
        restart = rolling_restart(integrator, self._known(), self.state, size, mode.sliding)
        if restart is not None:
            self._roll_back(*restart)
            self._record("rolling reversal", before)
            return
        if mode.sliding or abs(known.spin) * self._length > 1e-7 * self._speed:
            what = "slides" if mode.sliding else "spins about the normal"
            raise EndError("rolling held", _ROLLING_HELD.format(what))
        self._rest()
        self._record("rest", before)

    def _roll_back(self, direction: FloatArray, rate: float) -> None:
        """Roll on from rest, along a direction that rolling keeps while it grows."""
        known = self._known()
        size = 2 * SLIP_FLOOR * self._speed / self._length
        lasting = size / rate
        state = self.state + 0.5 * lasting * known.rates_of_place
        self.state = state_with_rolling(known, state, size * direction, self.mode.sliding)
        self.time += lasting
        self._project(self.mode)

    def _rest(self) -> None:
        energy, law = self._known().energy, self._law_of_rolling()
        self.state[VELOCITY] = self.state[OMEGA] = 0.0
        self.state[self.contact.work_column(law.name)] += energy - self._known().energy
        self.mode = Mode(sliding=False, spinning=False, rolling=False)

    @property
    def _resists_rolling(self) -> bool:
        return any(law.holds_rolling for law in self.contact.situation.laws)

    def _law_of_rolling(self) -> FrictionLaw:
        return next(law for law in self.contact.situation.laws if law.holds_rolling)
