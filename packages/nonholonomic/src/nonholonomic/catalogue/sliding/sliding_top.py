"""A tippe top that slides on a plane (§11.3; Jellett 1872), with its laws."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.system import Parameter, System

from ...contact.invariants import sliding_top as top
from ...contact.invariants.free_contact import free_contact, jellett
from ...mechanics.rolling.body import Body, check_mass
from ...mechanics.shapes.shapes import Ball
from ..catalogue_entry import Numbers, entry_with
from ..positive_numbers import positive

TITLE = "Tippe top that slides"
SUMMARY = (
    "A spherical body of revolution whose centre of mass is not that of the sphere, on a plane on "
    "which it slides with friction in proportion to slip and normal force."
)
#: The top of Leine and Glocker (2003).
DEFAULTS = {
    "m": 0.006,
    "I_1": 8e-7,
    "I_3": 7e-7,
    "R": 0.015,
    "c": 0.003,
    "g": 9.81,
    "nu": 0.3,
}


def build(p: Numbers) -> System:
    """The top with friction −νN u."""
    check_mass(p["m"])
    parameters = (
        *top.body_parameters(p["m"], p["I_1"], p["I_3"]),
        *top.sphere_parameters(p["R"], p["c"], p["g"]),
        positive(top.nu, "friction in proportion to slip and normal force", p["nu"], "s/m"),
    )
    system = top.sliding_top(top.NORMAL_VISCOUS, _with_positive_numbers(parameters))
    return replace(system, title=TITLE, summary=SUMMARY, laws=top.laws())


def _with_positive_numbers(parameters: tuple[Parameter, ...]) -> tuple[Parameter, ...]:
    """The parameters, after checking those that must be positive."""
    free = (top.c, top.g)
    return tuple(
        p if p.symbol in free else positive(p.symbol, p.meaning, p.default, p.unit)
        for p in parameters
    )


def under_any_force() -> System:
    """The top under any force at its point of contact."""
    ball = Ball(DEFAULTS["R"], centre=(0.0, 0.0, DEFAULTS["c"]))
    moments = (DEFAULTS["I_1"], DEFAULTS["I_1"], DEFAULTS["I_3"])
    body = Body(DEFAULTS["m"], moments, ball)
    return replace(
        free_contact(body, DEFAULTS["g"]),
        name="sliding-top-any-force",
        title=TITLE,
        summary="A tippe top on a plane that acts on it by any force at the point of contact.",
        laws=(jellett(body),),
    )


ENTRIES = (
    entry_with(
        name="sliding-top",
        build=build,
        general=under_any_force,
    ),
)
