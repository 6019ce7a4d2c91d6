"""Transitions to and from creep, and slips that pass through zero."""

from __future__ import annotations

import math
from abc import ABC
from dataclasses import replace
from functools import cached_property

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..slip.frozen_slip import PointSlip
from ..slip.limit_directions import rest_of_point
from .course_state import NO_SLIP, SLIP_FLOOR
from .creep import CreepLaw, creep, creep_law, without_force
from .end_reasons import EndError
from .near_rest import frozen_slip
from .rolling_transitions import RollingTransitions

#: A slip is small if friction alone would change it within this fraction of a typical time. It
#: counts as constant if its acceleration is below the second fraction of the typical ones.
_STIFF, _EVEN = 5e-5, 1e-3

#: Largest velocity change, relative to a typical velocity, by which friction may be neglected.
_NEGLIGIBLE = 1e-14

#: Smallest factor applied to the slip floor.
_LOWEST = 1e-6


class CreepTransitions(RollingTransitions, ABC):
    """A simulation in which the contact may creep."""

    #: End time of the last creep interval, the force (3,) per normal force there, and the next
    #: duration to try.
    _last_creep: tuple[float, FloatArray, float] | None = None

    @cached_property
    def _creep_law(self) -> CreepLaw | None:
        return creep_law(self.contact.situation)

    def _creep(self) -> bool:
        """Simulate an interval of creep if the contact creeps; return whether it does."""
        law = self._creep_law
        if law is None or not (self.mode.touching and self.mode.sliding):
            return False
        slip = float(np.linalg.norm(self._numbers().slip))
        floor = SLIP_FLOOR * self._speed * self._floor_factor
        if not law.mu and not law.is_smooth and slip <= 1.001 * floor:
            self._pass_zero(law, floor)
            return True
        force = self._force_of_creep(law) if law.order <= 1 else None
        return force is not None and self._creep_on(law, force)

    def _creep_on(self, law: CreepLaw, force: FloatArray) -> bool:
        """Simulate creep from a force (3,) per normal force; return whether that succeeded."""
        longest = min(0.02 / self._turning_rate, float(self.moments[-1]) - self.time)
        if self._has_crept and self._last_creep is not None:
            longest = min(longest, self._last_creep[2])
        if longest <= 0:
            return False
        result = creep(
            self.contact, self.time, self.state, self.mode, force, law, self._run_values, longest
        )
        if result is None:
            return False
        self._take_onset(result.piece)
        self._last_creep = self.time, result.force, 4 * result.piece.duration
        if result.stops:
            self._end_creep()
        return True

    @property
    def _has_crept(self) -> bool:
        """Whether an interval of creep ended at the current time."""
        return self._last_creep is not None and self._last_creep[0] == self.time

    def _force_of_creep(self, law: CreepLaw) -> FloatArray | None:
        """Friction force (3,) per normal force if the contact creeps, else None."""
        known = self._numbers()
        speed = float(np.linalg.norm(known.slip))
        strength = float(np.linalg.norm(known.free_acceleration))
        if not 0 < speed * self._turning_rate < _STIFF * strength:
            return None
        if self._has_crept and self._last_creep is not None:
            # At a very small slip this force is more accurate than one computed from the rounded
            # slip.
            return self._last_creep[1]
        tangents = known.mobility.tangents
        n = tangents @ known.slip / speed
        size, N = law.mu, 0.0
        for _ in range(50 if law.is_viscous else 1):
            N = self._frozen_slip(size).force(n)[0]
            if N <= 0:
                return None
            size = law.force(speed, N)
        if float(np.linalg.norm(self._frozen_slip(size).rate(n))) > _EVEN * strength:
            return None
        result: FloatArray = -size * n @ tangents
        return result

    def _frozen_slip(self, mu: float) -> PointSlip:
        """The rates of a small slip under a friction of given size per normal force."""
        sign = self._spin_sign if self.mode.spinning else 0.0
        slip = frozen_slip(self._numbers(), replace(self._dry, mu=mu), sign)
        assert isinstance(slip, PointSlip)
        return slip

    def _begins_to_creep(self, direction: FloatArray) -> bool:
        """Start sliding by creep if the slip grows slowly; return whether it did.

        Laws with an order above 1 never need this, and linear laws only if they are strong:
        otherwise a slip that grows like t² soon becomes fast enough to be integrated directly.
        """
        law = self._creep_law
        if law is None or law.order > 1:
            return False
        slip, known = self._frozen_slip(law.mu), self._numbers()
        tangents = known.mobility.tangents
        n = tangents @ direction
        strength = float(np.linalg.norm(known.free_acceleration))
        held = rest_of_point(self._frozen_slip(math.inf))
        N = held.normal_force
        if N <= 0:
            return False
        force = -law.mu * direction
        if float(n @ slip.rate(n)) > 1e-6 * strength:
            # The slip starts at once; treat it as creep only if it is too small to be told from
            # zero.
            force = held.sticking_force @ tangents / N
            sizes = np.array([np.linalg.norm(force)]), np.array([N])
            if law.speed(*sizes)[0][0] > NO_SLIP * self._speed:
                return False
        elif law.order == 1:
            decay = (law.force(1.0, N) - law.mu) * N / known.mobility.mass
            if decay * _STIFF < self._turning_rate:
                return False
        return self._creep_on(law, force)

    def _end_creep(self) -> None:
        """Hold the contact after creep, from the time when the sticking force is at its limit."""
        before = self.state
        self.mode = self._mode_at_rest(spin_at_rest=not self.mode.spinning)
        self._project(self.mode)
        integrator = self._integrator(self.mode)
        place = [guard.name for guard in integrator.system.guards].index("slip")
        rates, short = integrator.rates(self.state), 1e-6 / self._turning_rate
        margin, later = (
            float(integrator.guard_values(state)[place])
            for state in (self.state, self.state + short * rates)
        )
        # The slip itself is too small to determine this time as accurately.
        delay = -margin * short / (later - margin) if later > margin else 0.0
        if abs(delay) < short:
            self.state = self.state + delay * rates
            self.time += delay
            self._project(self.mode)
        self._record("stick", before)
        if not self.mode.rolling:
            self._decide_on_rolling()

    def _pass_zero(self, law: CreepLaw, floor: float) -> None:
        """Simulate a slip at or near zero, where a law without threshold is not smooth."""
        known = self._numbers()
        slip = self._frozen_slip(0.0)
        free = float(np.linalg.norm(slip.rate(np.array([1.0, 0.0]))))
        held = rest_of_point(self._frozen_slip(math.inf))
        N = held.normal_force
        friction = law.force(floor, N) * N / known.mobility.mass
        if law.order < 1 and free < 10 * friction:
            force = held.sticking_force @ known.mobility.tangents / N
            if not force.any():
                force = 1e-300 * known.mobility.tangents[0]
            if not self._creep_on(law, force):
                raise EndError("no end", "the slip stays close to zero, where it is not followed")
            return
        lasting = min(4 * floor / free if free else math.inf, 0.02 / self._turning_rate)
        if friction * lasting > _NEGLIGIBLE * self._speed and self._floor_factor > _LOWEST:
            self._floor_factor *= 1e-2
            return
        lasting = min(lasting, float(self.moments[-1]) - self.time)
        piece = without_force(
            self.contact, self.time, self.state, self.mode, law, self._run_values, lasting
        )
        self._take_onset(piece)
