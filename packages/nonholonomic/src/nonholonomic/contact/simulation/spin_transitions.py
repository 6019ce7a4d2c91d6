"""Transitions of the spin of a motion in contact: end, reversal and beginning."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import replace

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..friction.modes import Mode
from ..impact.impact import Impact
from .compiled import OMEGA, VELOCITY
from .course_state import CourseState
from .events import EventKind


class SpinTransitions(CourseState, ABC):
    """A simulation in which the spin may end, change sign or begin."""

    @abstractmethod
    def _leave_rest(
        self,
        kind: EventKind | None,
        before: FloatArray,
        *impacts: Impact,
        spin_at_rest: bool,
    ) -> None:
        """Hold a contact without slip if friction can, or begin to slide."""

    def _decide_on_spin(self, sliding: bool) -> bool:
        """Hold a spin of zero or let it begin; return whether it is held."""
        mode = Mode(sliding=sliding, spinning=False, rolling=self.mode.rolling)
        self._project(mode)
        N, couple = self._normal_force_and_couple(mode)
        spins = abs(couple) > self._dry.spin_arm * N
        if spins:
            self._spin_sign = -math.copysign(1.0, couple)
        self.mode = replace(mode, spinning=spins)
        return not spins

    def _spin_stop(self) -> None:
        """Handle a spin that has reached zero: hold it, or let it change sign."""
        before, sliding = self.state, self.mode.sliding
        if not self._dry.spin_arm:
            # The formulas of friction in |Ω| do not hold the spin.
            mode = self.mode
            self._decide_on_spin(sliding)
            self.mode = mode
            self._record("spin reversal", before)
            return
        if not sliding:
            self._project(replace(self.mode, spinning=False))
            self._leave_rest("spin stop", before, spin_at_rest=True)
            return
        stopped = self._decide_on_spin(sliding=True)
        self._record("spin stop" if stopped else "spin reversal", before)

    def _spin_start(self) -> None:
        before = self.state
        _, couple = self._normal_force_and_couple(self.mode)
        self._spin_sign = -math.copysign(1.0, couple)
        self.mode = replace(self.mode, spinning=True)
        self._record("spin start", before)
        # The spin grows like the square of time, and must not end at once by rounding.
        known = self._numbers()
        fastest = max(self._speed / self._length, float(np.abs(self.state[OMEGA]).max()))
        size = 4 * float(np.finfo(float).eps) * fastest
        turn = self._spin_sign * size * known.gamma
        self.state = self.state.copy()
        self.state[OMEGA] += turn
        self.state[VELOCITY] -= np.cross(turn, known.r)
