"""Which integrals may be held, and which measures hold."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.sampling.level_integrals import (
    level_label,
    measure_label,
    measures,
    validate_level,
)
from flowlanes.formulas.array_evaluation import parameter_rows
from flowlanes.system.system import System
from nonholonomic.catalogue import from_catalogue


def values(system: System, **given: float) -> np.ndarray:
    return np.asarray(parameter_rows(system, given, 1)[0])


def test_an_integral_with_a_condition() -> None:
    system = from_catalogue("chaplygin-ball-gyrostat")
    validate_level(system, {"area": 0.3}, values(system))
    disk = from_catalogue("rubber-disk")
    validate_level(disk, {"spin": 0.3}, values(disk))
    with pytest.raises(InputError, match="spin is an integral only where I_1 - I_2 = 0"):
        validate_level(disk, {"spin": 0.3}, values(disk, I_1=0.3, I_2=0.31, I_3=0.5))


def test_a_measure_with_a_condition() -> None:
    disk = from_catalogue("rubber-disk")
    assert len(measures(disk, {}, values(disk))) == 1
    assert measures(disk, {}, values(disk, I_1=0.3, I_2=0.31, I_3=0.5)) == []


def test_words() -> None:
    (law,) = measures(from_catalogue("veselova"), {}, np.array([1.0, 1.5, 2.1]))
    assert measure_label(law) == "invariant measure ρ d³ω d³γ (6.3)"
    (law,) = measures(from_catalogue("lagrange-top"), {}, np.ones(3))
    assert measure_label(law) == "invariant measure: volume of M and Γ §3.3"
    assert measure_label(None) == "surface measure"
    assert level_label({"energy": 1.0, "area": 0.3}) == "energy = 1 and area = 0.3"
