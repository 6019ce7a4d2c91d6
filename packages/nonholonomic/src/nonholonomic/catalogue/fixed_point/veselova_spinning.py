"""The Veselova system whose vertical angular velocity is constant and not zero (Remark 18)."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import dot

from .. import e3
from ..catalogue_entry import Numbers
from .veselova import (
    ANY,
    FREE,
    KINETIC,
    NUMBERS,
    I,
    U,
    gamma,
    measure,
    moments,
    momentum,
    omega,
    turning,
)


def energy_of_spinning(potential: sp.Expr) -> Integral:
    """Energy less (ω, γ)(Iω, γ), to which the torque of the constraint adds as much."""
    value = KINETIC - dot(omega, gamma) * dot(I * omega, gamma)
    return Integral(
        "energy",
        value + U if potential != 0 else value,
        "energy less (ω, γ) times the vertical momentum",
        source="Remark 18",
        unit="J",
    )


def spin() -> Integral:
    """The constraint (ω, γ) = d of Remark 18."""
    return Integral(
        "spin", dot(omega, gamma), "vertical angular velocity", source="Remark 18", unit="rad/s"
    )


SPINNING_TITLE = "Generalised Veselova system"


SPINNING_SUMMARY = (
    "A rigid body turns about a fixed point, its centre of mass, under the constraint that the "
    "vertical component of its angular velocity is constant."
)


def spinning(p: Numbers) -> System:
    """(ω, γ) = d with any d, without a field."""
    return _spinning(moments(p), FREE, momentum())


def spinning_general() -> System:
    """(ω, γ) = d with any d, in an unspecified potential."""
    return _spinning(moments(NUMBERS), ANY)


def _spinning(
    numbers: tuple[float, float, float], potential: sp.Expr, *further: Integral
) -> System:
    return turning(
        "veselova-spinning",
        SPINNING_TITLE,
        SPINNING_SUMMARY,
        "§6.1, Remark 18",
        e3.inertia_parameters(numbers),
        potential,
        (),
        (spin(), energy_of_spinning(potential), *further, measure()),
    )
