"""The roller-racer (§2.1): two bodies on axles, joined by a pivot; the rider swings the second.

(x, y) is the middle of the first axle, θ its heading.  The pivot is d_1 ahead of it, and the
second axle d_2 ahead of the pivot, turned by φ.  In the axes of the first body its velocity is
(u, v) and its angular velocity Ω; no slip across the axles says v = 0 and

    (d_1 cos φ + d_2) Ω = u sin φ − v cos φ − d_2 φ̇.

The mass of the second body is neglected, not so its moment of inertia.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import real_symbol

from ...mechanics.lagrangian.mechanism import Frame, Mechanism
from ...mechanics.lagrangian.plan import Plan
from ...mechanics.lagrangian.poincare_suslov import equations
from ..catalogue_entry import Entry, Numbers, Start
from ..positive_numbers import positives

x, y, theta, phi = (real_symbol(name) for name in ("x", "y", "theta", "phi"))
u, v, turn, swing, D = (real_symbol(name) for name in ("u", "v", "Omega", "phidot", "D"))
m, I_1, I_2, d_1, d_2 = (real_symbol(name) for name in ("m", "I_1", "I_2", "d_1", "d_2"))

HALF = sp.Rational(1, 2)
SOURCE = "§2.1; P. S. Krishnaprasad, D. P. Tsakiris 2001"
TITLE = "Roller-racer"
SUMMARY = (
    "Two bodies on axles, joined by a pivot: swinging one against the other drives both forward, "
    "although neither axle is driven."
)


def racer(p: Numbers) -> Mechanism:
    """The racer in the velocities u, v, Ω, φ̇.

    Raises
    ------
    InputError
        If the mass, a moment of inertia or a distance is not positive.
    """
    return Mechanism(
        name="roller-racer",
        frame=Frame(
            {
                x: u * sp.cos(theta) - v * sp.sin(theta),
                y: u * sp.sin(theta) + v * sp.cos(theta),
                theta: turn,
                phi: swing,
            },
            (u, v, turn, swing),
        ),
        lagrangian=HALF * m * (u**2 + v**2)
        + HALF * I_1 * turn**2
        + HALF * I_2 * (turn + swing) ** 2,
        constraints=(v, turn - (u * sp.sin(phi) - d_2 * swing) / D),
        definitions={D: d_1 * sp.cos(phi) + d_2},
        parameters=_parameters(p),
        guards=(Guard("folded", D, "the second axle lies sideways of the first"),),
        title=TITLE,
        source=SOURCE,
        summary=SUMMARY,
    )


def _parameters(p: Numbers) -> tuple[Parameter, ...]:
    meanings = {
        m: ("mass of the first body", "kg"),
        I_1: ("moment of inertia of the first body", "kg m^2"),
        I_2: ("moment of inertia of the second body", "kg m^2"),
        d_1: ("distance of the pivot ahead of the first axle", "m"),
        d_2: ("distance of the second axle ahead of the pivot", "m"),
    }
    return positives(p, meanings)


def roller_racer(p: Numbers) -> System:
    """The angle at the pivot, its rate and the velocity of the first body."""
    return equations(racer(p))


#: The pivot and the middle of the second axle.
_PIVOT = (x + d_1 * sp.cos(theta), y + d_1 * sp.sin(theta))
_SECOND = (_PIVOT[0] + d_2 * sp.cos(theta + phi), _PIVOT[1] + d_2 * sp.sin(theta + phi))
PLAN = Plan(
    (x, y),
    links=((x, y, *_PIVOT), (*_PIVOT, *_SECOND)),
    axles=((x, y, theta), (*_SECOND, theta + phi)),
    points=(_PIVOT,),
)

DEFAULTS = {"m": 1.0, "I_1": 0.3, "I_2": 0.1, "d_1": 0.4, "d_2": 0.6}

ENTRIES = (
    Entry(
        name="roller-racer",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=roller_racer,
        plan=PLAN,
        start=Start(state={"phi": 0.5, "u": 0.3, "phidot": 0.4}, until=10.0),
        variables={
            "phi": ("angle of the second body against the first", "rad"),
            "u": ("velocity of the first body along itself", "m/s"),
            "phidot": ("rate of the angle at the pivot", "rad/s"),
            "x": ("middle of the first axle", "m"),
            "y": ("middle of the first axle", "m"),
            "theta": ("heading of the first body", "rad"),
        },
    ),
)
