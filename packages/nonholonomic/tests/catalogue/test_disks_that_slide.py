"""Disks on ice against Newton's and Euler's laws, read off their motion in space."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from catalogue import built
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import entry

STEP = 2e-3
#: Weights of the eighth-order central difference of a first derivative.
WEIGHTS = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])


def slope(values: Any) -> Any:
    """Time derivatives at all samples but four at each end."""
    count = len(values) - 8
    return sum(w * values[i : i + count] for i, w in enumerate(WEIGHTS)) / STEP


def turns(attitude: Any) -> Any:
    """Rotations, body to space, of quaternions (w, x, y, z)."""
    w, x, y, z = attitude.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(rows).transpose(2, 0, 1)


@dataclass(frozen=True)
class Seen:
    """What can be seen of a motion in space, and the forces it tells of; space axes."""

    diameter: Any
    slip: Any
    force: Any
    torque: Any
    reported: Any


def seen(name: str) -> Seen:
    """Follow a disk of the catalogue for a short time."""
    made = built.example(name)
    numbers = entry(name).defaults
    motion = integrate(made.system, made.start, np.arange(0, 1.0, STEP))
    turn = turns(motion["attitude"])
    spin = np.einsum("nij,nj->ni", turn, motion["omega"])
    moments = np.array([numbers["I_1"], numbers["I_1"], numbers["I_3"]])
    momentum = np.einsum("nij,nj->ni", turn, moments * motion["omega"])
    centre, contact = motion["centre"], motion["contact"]
    velocity = slope(centre)
    arm = contact - centre
    slip = velocity + np.cross(spin, arm)[4:-4]
    force = numbers["m"] * (slope(velocity) + np.array([0, 0, numbers["g"]]))
    diameter = np.cross([0, 0, 1.0], turn[:, :, 2])
    diameter /= np.linalg.norm(diameter, axis=1)[:, None]
    excess = slope(momentum)[4:-4] - np.cross(arm[8:-8], force)
    return Seen(diameter[8:-8], slip[4:-4], force, excess, motion["normal_force"][8:-8])


@pytest.mark.parametrize("name", ["disk-on-ice", "smooth-disk"])
def test_reactions_act_at_the_contact_point(name: str) -> None:
    found = seen(name)
    assert np.abs(found.force).max() > 1.0
    assert np.abs(found.torque).max() < 2e-8
    assert found.reported == pytest.approx(found.force[:, 2], abs=1e-8)
    assert np.abs(found.slip[:, 2]).max() < 1e-11


def test_ice_lets_the_disk_slip_along_its_diameter_alone() -> None:
    found = seen("disk-on-ice")
    across = np.cross([0, 0, 1.0], found.diameter)
    along = np.einsum("ni,ni->n", found.slip, found.diameter)
    assert np.abs(np.einsum("ni,ni->n", found.slip, across)).max() < 1e-11
    assert np.ptp(along) > 0.1
    assert np.abs(np.einsum("ni,ni->n", found.force, found.diameter)).max() < 1e-8


def test_a_smooth_plane_presses_vertically() -> None:
    found = seen("smooth-disk")
    assert np.abs(found.force[:, :2]).max() < 1e-8
    assert np.ptp(found.force[:, 2]) > 0.1
