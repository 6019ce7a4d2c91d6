"""Powers of the slip, formulas of the user and the film of air, against the reference."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from contact.reference import placed, simulate
from contact.reference_cases import LOADED, PEBBLE, PLANE
from contact.situations import rules, situation, start
from contact.test_motion import OUR_NAMES, assert_same_state
from nonholonomic.contact import contact_motion

DISK = {
    "mass": 1.2,
    "inertia": [[0.3, 0.02, 0.01], [0.02, 0.25, -0.01], [0.01, -0.01, 0.4]],
    "shape": {"kind": "disk", "radius": 1.0, "centre": [0.05, -0.1, 0.04]},
}
TURNING = {"kind": "plane", "turntable": -0.8}
STRIBECK = "mu*(1 + 0.4*exp(-slip_speed/v))"
VALUES = {"mu": 0.1, "v": 0.2}

#: Body, support, law, attitude, slip, kinds of some events.
MOTIONS: dict[str, tuple[Any, ...]] = {
    "power 1/2": (LOADED, PLANE, {"slip": 0.3, "slip_order": 0.5}, (1, 0.2, 0.3, -0.4), 1.0, ()),
    "dry and a square": (
        LOADED,
        PLANE,
        {"mu": 0.06, "slip": 0.3, "slip_order": 2.0},
        (1, 0.2, 0.3, -0.4),
        0.0,
        ("slip",),
    ),
    "dry and a power, gently": (
        LOADED,
        PLANE,
        {"mu": 0.06, "slip": 0.3, "slip_order": 1.5},
        (1, 0.2, 0.3, -0.4),
        0.0,
        ("slip",),
    ),
    "dry and a power, from rest": (
        LOADED,
        PLANE,
        {"mu": 0.01, "slip": 0.3, "slip_order": 0.7},
        (1, 0.2, 0.3, -0.4),
        0.0,
        (),
    ),
    "dry and a power": (
        LOADED,
        PLANE,
        {"mu": 0.5, "slip": 0.2, "slip_order": 1.5},
        (1, 0.2, 0.3, -0.4),
        0.4,
        ("stick",),
    ),
    "Stribeck": (
        LOADED,
        PLANE,
        {"force": STRIBECK, "values": VALUES, "mu_static": 0.18},
        (1, 0.2, 0.3, -0.4),
        0.05,
        ("stick", "slip"),
    ),
    "normal force in the formula": (
        LOADED,
        PLANE,
        {"force": "0.2 + slip_speed/(1 + normal_force/10)"},
        (1, 0.2, 0.3, -0.4),
        0.5,
        ("stick",),
    ),
    "couple": (
        PEBBLE,
        TURNING,
        {"force": STRIBECK, "values": VALUES, "couple": "0.05*(1 + spin/5)"},
        (1, 0.2, 0.3, -0.4),
        1.0,
        (),
    ),
    "film of air": (DISK, PLANE, {"mu": 0.5, "air": 0.05}, (0.9, 0.35, -0.1, 0.3), 0.3, ()),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", MOTIONS)
def test_motion_agrees_with_the_reference(name: str) -> None:
    body, surface, law, attitude, slip, kinds = MOTIONS[name]
    begin = placed(body, surface, attitude, [1.0, -2.0, 0.5], [slip, 0.4 * slip, 0.0])
    given = {"body": body, "surface": surface, "contact": law, "gravity": 9.81, "start": begin}
    contact = situation(given)
    motion = contact_motion(contact, start(given, contact), np.array([0.0, 0.7]), rules(given))
    assert motion.reason == ""
    expected, final = simulate(body, surface, law, begin, 0.7)
    events = [event for event in motion.events if event.kind != "spin reversal"]
    names = [OUR_NAMES.get(event["kind"], event["kind"]) for event in expected]
    assert [event.kind for event in events] == names
    assert set(kinds) <= set(names)
    for event, reference in zip(events, expected, strict=True):
        assert event.time == pytest.approx(reference["time"], abs=1e-10)
        assert_same_state(event.after, reference)
    assert_same_state(motion.end_state, final)
