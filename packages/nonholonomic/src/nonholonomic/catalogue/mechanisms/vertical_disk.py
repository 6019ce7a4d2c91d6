"""A disk that rolls upright on an inclined plane, like a wheel on a light carriage (§2.1).

x points down the slope, θ is the heading, u and v the velocities of the contact along and across
the disk.  No slip says u = R ψ̇ and v = 0.  The disk turns uniformly and does not run away
downhill: it drifts sideways.
"""

from __future__ import annotations

import math

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol

from ...mechanics.lagrangian.mechanism import Frame, Mechanism
from ...mechanics.lagrangian.plan import Plan
from ...mechanics.lagrangian.poincare_suslov import equations
from ..catalogue_entry import Entry, Numbers, Start
from ..positive_numbers import positives

x, y, theta, psi = (real_symbol(name) for name in ("x", "y", "theta", "psi"))
u, v, spin, turn, c = (real_symbol(name) for name in ("u", "v", "psidot", "w", "c"))
m, I, J, R, g, slope = (real_symbol(name) for name in ("m", "I", "J", "R", "g", "alpha"))

HALF = sp.Rational(1, 2)
SOURCE = "§2.1; A. M. Bloch 2003, §1.4"
TITLE = "Vertical rolling disk"
SUMMARY = (
    "A disk rolls upright on an inclined plane; its heading turns uniformly, and on average it "
    "drifts horizontally, not downhill."
)


def disk(p: Numbers) -> Mechanism:
    """The disk in the velocities u, v, ψ̇, w = θ̇.

    Raises
    ------
    InputError
        If the mass, radius or a moment of inertia is not positive, or g or the slope not finite.
    """
    # what ψ̇ gains per radian of turning, times w
    gain = c * sp.sin(theta)
    level = spin * turn - gain
    return Mechanism(
        name="vertical-rolling-disk",
        frame=Frame(
            {
                x: u * sp.cos(theta) - v * sp.sin(theta),
                y: u * sp.sin(theta) + v * sp.cos(theta),
                theta: turn,
                psi: spin,
            },
            (u, v, spin, turn),
        ),
        lagrangian=HALF * m * (u**2 + v**2)
        + HALF * I * spin**2
        + HALF * J * turn**2
        + m * g * sp.sin(slope) * x,
        constraints=(u - R * spin, v),
        definitions={c: m * g * R * sp.sin(slope) / (I + m * R**2)},
        parameters=_parameters(p),
        laws=(
            Integral(
                "rolling",
                level,
                "part of ψ̇ that slope and turning leave alone",
                source=SOURCE,
                unit="1/s^2",
            ),
            Integral(
                "drift",
                turn**2 * y
                + R * level * sp.cos(theta)
                - R * c * (theta - sp.sin(theta) * sp.cos(theta)) / 2,
                "place across the slope, less the drift",
                source=SOURCE,
                unit="m/s^2",
            ),
            Measure("volume", {sp.S.One: sp.S.One}, "volume", source=SOURCE),
        ),
        title=TITLE,
        source=SOURCE,
        summary=SUMMARY,
    )


def _parameters(p: Numbers) -> tuple[Parameter, ...]:
    meanings = {
        m: ("mass", "kg"),
        I: ("moment of inertia about the axle", "kg m^2"),
        J: ("moment of inertia about the vertical diameter", "kg m^2"),
        R: ("radius", "m"),
    }
    parameters = [*positives(p, meanings)]
    for symbol, meaning, unit in ((g, "gravity", "m/s^2"), (slope, "angle of the slope", "rad")):
        if not math.isfinite(p[str(symbol)]):
            raise InputError(f"{meaning} {symbol} = {p[str(symbol)]}: it must be a finite number")
        parameters.append(Parameter(symbol, meaning, p[str(symbol)], unit))
    return tuple(parameters)


def vertical_disk(p: Numbers) -> System:
    """Place and heading, and the angular velocities."""
    return equations(disk(p))


DEFAULTS = {"m": 1.0, "I": 0.02, "J": 0.01, "R": 0.2, "g": 9.81, "alpha": 0.1}

ENTRIES = (
    Entry(
        name="vertical-rolling-disk",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=vertical_disk,
        plan=Plan((x, y), wheels=((x, y, theta),)),
        start=Start(
            state={"x": 0.0, "y": 3.0, "theta": 0.0, "psidot": 2.0, "w": 0.8},
            until=8.0,
        ),
        variables={
            "x": ("place down the slope", "m"),
            "y": ("place across the slope", "m"),
            "theta": ("heading", "rad"),
            "psidot": ("angular velocity of rolling", "rad/s"),
            "w": ("angular velocity of turning", "rad/s"),
        },
    ),
)
