"""What names mean."""

from __future__ import annotations

from flowlanes.scans.system_quantities import meaning, quantities_by_name
from nonholonomic.catalogue import entry

BALL = entry("ball-on-sphere").system()
VECTORS = {"omega": ("angular velocity", "rad/s"), "z": ("height", "m")}


def test_scalars_by_name() -> None:
    names = quantities_by_name(BALL)
    assert {"energy", "momentum", "normal_force"} <= names.keys()
    # a vector has no value of its own
    assert "omega" not in names


def test_meanings_and_units() -> None:
    assert meaning(BALL, "a", {}) == (
        "radius of the supporting sphere, negative inside",
        "m",
    )
    assert meaning(BALL, "energy", {}) == ("energy", "J")
    assert meaning(BALL, "omega_2", VECTORS) == ("angular velocity, component 2", "rad/s")
    assert meaning(BALL, "z", VECTORS) == ("height", "m")
    assert meaning(BALL, "theta", VECTORS) == ("", "")
