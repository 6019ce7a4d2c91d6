"""Periodic orbits for a page."""

from __future__ import annotations

from flowlanes.orbits.orbit_near import orbit_facts, orbit_near
from flowlanes.system.tolerance import TOLERANCE

from ..experiment.poincare import DIRECTIONS
from ..experiment.single_system import without_reconstruction
from ..experiment.study import Study
from .requests import PeriodicOrbit
from .workers import Message


def periodic_orbit(study: Study, request: PeriodicOrbit) -> Message:
    """The periodic orbit near the motion of a study.

    Raises
    ------
    InputError
        If the section or an integral cannot be used.
    RunError
        If none is found.
    """
    system = without_reconstruction(study)
    orbit, _ = orbit_near(
        system,
        [float(x) for x in study.start[: len(system.symbols)]],
        study.until,
        (request.on, request.value, DIRECTIONS[request.direction], False),
        (request.after, request.period, TOLERANCE["double"]),
        request.hold,
    )
    return orbit_facts(orbit)
