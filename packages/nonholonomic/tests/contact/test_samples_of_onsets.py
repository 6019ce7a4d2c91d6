"""Samples in the first moments of sliding, where the direction of friction is prescribed."""

from __future__ import annotations

import numpy as np
import pytest

import nonholonomic
from nonholonomic.contact import Coulomb, FrictionalContact, contact_motion
from nonholonomic.contact.starts import state_in_space

MU = 0.3


@pytest.mark.slow
def test_samples_where_sliding_begins_have_all_observables() -> None:
    body = nonholonomic.Body(
        1.0,
        ((0.0002, -0.00002, 0.0), (-0.00002, 0.0016, 0.0), (0.0, 0.0, 0.0017)),
        nonholonomic.Ellipsoid((0.2, 0.03, 0.02), centre=(0.0, 0.0, 0.01)),
    )
    contact = FrictionalContact(body, laws=(Coulomb(MU),), field=nonholonomic.Forces(gravity=9.81))
    # a rattleback that rolls at first
    state = state_in_space(
        contact,
        (-0.017298908816466407, 0.0003039371269596072, 0.010076953455617245),
        (0.9999809617133206, 0.004363350819910759, 0.004363184676881591, 0.0),
        (0.001959254367286094, 0.08692762503171986, 0.0007415366236724414),
        (0.0, 0.0, -5.0),
    )
    begin = contact_motion(contact, state, [0.0, 0.01]).events[0]
    assert begin.kind == "slip"
    times = np.concatenate([[0.0], begin.time + np.geomspace(1e-6, 1e-3, 40)])
    motion = contact_motion(contact, state, times)
    seen = motion
    assert all(len(seen[name]) == len(times) for name in seen)
    speed = np.linalg.norm(seen["slip"][1:], axis=1)
    assert np.all(np.diff(speed) > 0)
    friction = np.linalg.norm(seen["friction_force"][1:], axis=1)
    assert np.allclose(friction, MU * seen["normal_force"][1:], rtol=1e-9)
