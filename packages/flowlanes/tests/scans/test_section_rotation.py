"""Rotation numbers of many motions, where they are known."""

from __future__ import annotations

import numpy as np
import sympy as sp

from flowlanes.scans.quantity_names import quantity_from_text
from flowlanes.system.system import Parameter, System

x, y, u, v, c = sp.symbols("x y u v c", real=True)

#: Two oscillators; the second makes c turns while the first makes one.
PAIR = System(
    name="pair",
    title="Pair",
    field={x: -y, y: x, u: -c * v, v: c * u},
    parameters=(Parameter(c, "ratio of the frequencies", 1.0),),
)


def test_the_ratio_of_two_oscillators() -> None:
    number = quantity_from_text(PAIR, "rotation: atan2(v, u) on y", 4000.0)
    assert number.title == "rotation number of atan2(v, u) on y"
    ratios = np.array([0.5 * (5**0.5 - 1), 0.25, 2**0.5, 0.1])
    starts = np.tile([1.0, 0.0, 0.7, 0.1], (4, 1))
    found = number.rule(starts, {c: ratios})
    assert np.abs((found["value"] - ratios + 0.5) % 1.0 - 0.5).max() < 1e-11
    assert np.all(found["error"] < 1e-10)


def test_motions_that_do_not_return_say_why() -> None:
    rule = quantity_from_text(PAIR, "rotation: atan2(v, u) on y", 50.0).rule
    found = rule(np.array([[1.0, 0.0, 0.7, 0.1]]), {})
    assert found["outcome"][0] > 0
    assert np.isnan(found["value"][0])
