"""Drag of the air under Euler's disk."""

from __future__ import annotations

import math

import numpy as np
import pytest

import flowlanes
import nonholonomic
from nonholonomic.contact import (
    AirFilm,
    Coulomb,
    FrictionalContact,
    contact_motion,
)
from nonholonomic.starts import initial_state

A, M, G = 0.0375, 0.44, 9.81
DISK = nonholonomic.Body(M, (M * A**2 / 4, M * A**2 / 4, M * A**2 / 2), nonholonomic.Disk(A))


@pytest.mark.parametrize("angle", [0.1, 0.01])
def test_a_whirling_disk_loses_what_moffatt_says(angle: float) -> None:
    eta = 1.8e-5
    contact = FrictionalContact(
        DISK, laws=(Coulomb(1.0), AirFilm(eta, A)), field=nonholonomic.Forces(gravity=G)
    )
    turn = 2 * math.sqrt(G * math.sin(angle) / A)
    gamma = [math.sin(angle), 0.0, math.cos(angle)]
    state = initial_state(contact, [turn, 0.0, 0.0], gamma)
    motion = contact_motion(contact, state, [0.0, 1e-9])
    lost = motion["power_lost"][0]
    np.testing.assert_allclose(lost, math.pi * eta * G * A**2 / math.tan(angle) ** 2, rtol=1e-12)


def test_a_film_has_a_radius() -> None:
    with pytest.raises(flowlanes.InputError, match=r"radius 0"):
        AirFilm(1e-5, 0.0)
