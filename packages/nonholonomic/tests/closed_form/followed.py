"""What every separable system must show: its claims proven, its equations along a motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import mpmath

from closed_form.along import abel_sums, at, located, restored, states
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem
from nonholonomic.closed_form.genus_two.separation_laws import separation_laws


def refused(separable: SeparatedSystem, law: str, **changes: Any) -> str:
    """The decision on one law of the system with some of its formulas changed."""
    (wrong,) = (each for each in separation_laws(replace(separable, **changes)) if each.name == law)
    return prove(separable.system, wrong).decision


def follow(separable: SeparatedSystem, start: Sequence[Any], parameters: Mapping[str, str]) -> None:
    """Both sums, the constants, the state and the clock along a motion with 34 digits."""
    with mpmath.workdps(34):
        motion = states(separable.system, start, parameters)
        begin = located(separable, motion[0])
        speeds = [at(speed, begin) for speed in separable.speeds]
        for values in motion:
            known = located(separable, values)
            assert all(
                abs(found - speed) < 1e-25
                for found, speed in zip(abel_sums(separable, known), speeds, strict=True)
            )
            assert all(abs(known[s] - begin[s]) < 1e-26 for s, _ in separable.constants)
            assert all(
                abs(value - known[s]) < 1e-26 for s, value in restored(separable, known).items()
            )
            assert at(separable.time_rescaling, known) > 0
