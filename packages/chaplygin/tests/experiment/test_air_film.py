"""The drag of the air under a disk, as a file gives it."""

from __future__ import annotations

import pytest

import chaplygin as ch

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
