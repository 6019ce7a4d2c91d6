"""Rolling that its resistance cannot hold: it begins where a direction keeps itself."""

from __future__ import annotations

from typing import Any

import numpy as np

from contact.reference import placed, simulate
from contact.reference_bodies import rotation
from contact.reference_cases import PLANE
from contact.situations import situation, start
from nonholonomic.contact import contact_motion

#: A loaded ball that spins about the vertical without slip and rolling.
BODY = {
    "mass": 1.075,
    "inertia": [[0.1528, -0.0161, 0.0343], [-0.0161, 0.186, 0.0138], [0.0343, 0.0138, 0.1495]],
    "shape": {"kind": "ball", "radius": 1.0, "centre": [0.182, -0.21, 0.161]},
}
ATTITUDE = (0.5091348, -0.31879313, -0.67782661, 0.42391484)


def case(**laws: float) -> dict[str, Any]:
    still = placed(BODY, PLANE, ATTITUDE, [0.0, 0.0, 0.0])
    omega = (-0.5681717 * np.array(rotation(still["attitude"])[2])).tolist()
    return {
        "body": BODY,
        "surface": PLANE,
        "contact": laws,
        "gravity": 9.81,
        "start": placed(BODY, PLANE, ATTITUDE, omega),
    }


def test_rolling_that_begins_slowly_against_a_strong_resistance() -> None:
    """Its rate is a tenth of the resistance: a simple iteration for its direction diverges."""
    given = case(mu=0.311, slip=0.023, rolling=0.182)
    contact = situation(given)
    motion = contact_motion(contact, start(given, contact), [0.0, 0.05])
    assert (motion.reason, motion.intervals[0].mode) == ("", "rolling")
    events, final = simulate(BODY, PLANE, given["contact"], given["start"], 0.05, given["gravity"])
    assert events == list(motion.events) == []
    np.testing.assert_allclose(motion.end_state[10:13], final["omega"], rtol=0, atol=1e-10)


def test_a_stronger_resistance_holds_the_rolling() -> None:
    """Rolling needs 1.166 times the first resistance."""
    for share, mode in ((1.1, "rolling"), (1.167, "spinning")):
        given = case(mu=0.311, slip=0.023, rolling=0.182 * share)
        contact = situation(given)
        motion = contact_motion(contact, start(given, contact), [0.0, 0.01])
        assert motion.intervals[0].mode == mode


def test_the_event_before_a_rolling_that_begins_leads_to_rolling() -> None:
    """Where the slip ends while the rolling is held, rolling begins a moment later."""
    given = case(mu=0.311, slip=0.023, rolling=0.182)
    given["start"]["velocity"][0] += 1e-3
    contact = situation(given)
    motion = contact_motion(contact, start(given, contact), [0.0, 0.01])
    assert [(e.kind, e.mode) for e in motion.events][:1] == [("stick", "rolling")]
