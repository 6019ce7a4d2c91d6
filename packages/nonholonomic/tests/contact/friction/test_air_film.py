"""Drag of the air under Euler's disk."""

from __future__ import annotations

import math

import numpy as np
import pytest

import chaplygin as ch
from nonholonomic.contact import (
    AirFilm,
    Coulomb,
    FrictionalContact,
    contact_motion,
    start_in_contact,
)

A, M, G = 0.0375, 0.44, 9.81
DISK = ch.Body(M, (M * A**2 / 4, M * A**2 / 4, M * A**2 / 2), ch.Disk(A))

FILE = """
[body]
mass = 0.44
inertia = [1.546875e-4, 1.546875e-4, 3.09375e-4]
shape = { kind = "disk", radius = 0.0375 }
[contact]
model = "friction"
mu = 0.3
air = 1.8e-5
[start]
gamma = [0.1, 0.0, 1.0]
omega = [10.0, 0.0, 0.0]
"""


@pytest.mark.parametrize("angle", [0.1, 0.01])
def test_a_whirling_disk_loses_what_moffatt_says(angle: float) -> None:
    eta = 1.8e-5
    contact = FrictionalContact(
        DISK, laws=(Coulomb(1.0), AirFilm(eta, A)), field=ch.Forces(gravity=G)
    )
    turn = 2 * math.sqrt(G * math.sin(angle) / A)
    gamma = [math.sin(angle), 0.0, math.cos(angle)]
    state = start_in_contact(contact, [turn, 0.0, 0.0], gamma)
    motion = contact_motion(contact, state, [0.0, 1e-9])
    lost = motion["power_lost"][0]
    np.testing.assert_allclose(lost, math.pi * eta * G * A**2 / math.tan(angle) ** 2, rtol=1e-12)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (
            'shape = { kind = "disk", radius = 0.0375 }',
            'shape = { kind = "ball", radius = 0.0375 }',
        ),
        ("[contact]", '[surface]\nkind = "sphere"\nradius = 1.0\n[contact]'),
    ],
)
def test_the_film_is_that_between_a_disk_and_a_plane(old: str, new: str) -> None:
    with pytest.raises(ch.InputError, match=r"air: .* between a disk and a plane; leave it out"):
        ch.Study.from_experiment(ch.parse_experiment(FILE.replace(old, new)))


def test_a_negative_viscosity_is_refused() -> None:
    with pytest.raises(
        ch.InputError, match=r"contact\.air: must be a finite number not below zero"
    ):
        ch.parse_experiment(FILE.replace("1.8e-5", "-1.8e-5"))
    with pytest.raises(ch.InputError, match=r"radius 0"):
        AirFilm(1e-5, 0.0)
