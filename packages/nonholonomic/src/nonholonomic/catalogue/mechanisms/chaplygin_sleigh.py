"""The Chaplygin sleigh (§4.3): a body on a plane, with a blade that cannot slip sideways.

(x, y) is the point of contact of the blade, φ its direction and v its velocity along itself.  In
axes along and across the blade, with the contact as origin, the centre of mass is (a, b), and
u = v − bΩ is its velocity along the blade.
"""

from __future__ import annotations

import math

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Symmetry,
)
from flowlanes.system.system import Observable, Parameter, System

from ...mechanics.lagrangian.plan import Plan
from ...mechanics.rolling.body import check_mass
from ..catalogue_entry import Entry, Numbers, Start
from ..chaplygin_ball import generalised_chaplygin as chaplygin

x, y, phi, v, u, Omega = sp.symbols("x y phi v u Omega", real=True)
m, I, a, b, J = sp.symbols("m I a b J", real=True)

SOURCE = "§4.3"
HALF = sp.Rational(1, 2)
ALONG = "velocity of the centre of mass along the blade"
#: For the place and the velocities, and for the velocities alone.
SINGULAR = Measure(
    "measure",
    {Omega: -sp.S.One},
    "measure, singular where the sleigh goes straight on",
    source=SOURCE,
)


def _parameters(p: Numbers) -> tuple[Parameter, ...]:
    check_mass(p["m"])
    if not (math.isfinite(p["I"]) and p["I"] > 0):
        raise InputError(f"moment of inertia {p['I']}: it must be a positive finite number")
    return (
        Parameter(m, "mass", p["m"], "kg", (m > 0,)),
        Parameter(I, "moment of inertia about the centre of mass", p["I"], "kg m^2", (I > 0,)),
        Parameter(a, "distance of the centre of mass ahead of the contact", p["a"], "m"),
    )


def _lateral_offset(p: Numbers) -> Parameter:
    return Parameter(b, "distance of the centre of mass to the left of the blade", p["b"], "m")


# --- in the plane --------------------------------------------------------------------------

TITLE = "Chaplygin sleigh"
SUMMARY = (
    "A rigid body slides on a horizontal plane on two smooth feet and a blade that cannot slip "
    "sideways; unless the line from the contact to its centre of mass is perpendicular to the "
    "blade, it tends to straight motion."
)


def sleigh(p: Numbers) -> System:
    """Place and direction of the blade, its velocity and the angular velocity."""
    along = v - b * Omega
    return System(
        name="chaplygin-sleigh",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(*_parameters(p), _lateral_offset(p)),
        definitions={J: I + m * a**2, u: along},
        field={
            x: v * sp.cos(phi),
            y: v * sp.sin(phi),
            phi: Omega,
            v: a * Omega**2 - m * a * b * u * Omega / J,
            Omega: -m * a * u * Omega / J,
        },
        laws=(
            Integral(
                "energy",
                HALF * (m * u**2 + J * Omega**2),
                "kinetic energy",
                source="Theorem 1",
                unit="J",
            ),
            SINGULAR,
            Measure(
                "volume",
                {sp.S.One: sp.S.One},
                "volume, when the centre of mass lies beside the contact",
                on=(a,),
                source=SOURCE,
            ),
            *_motions_of_the_plane(),
            Reduction(
                "velocities",
                {},
                (Rate(u) - a * Omega**2, Rate(Omega) + m * a * u * Omega / J),
                "the velocities move by themselves",
                source=SOURCE,
            ),
            _chaplygin_form_identity(),
        ),
        observables=(Observable("u", u, ALONG, "m/s"),),
    )


def _motions_of_the_plane() -> tuple[Law, ...]:
    turning = {x: -y, y: x, phi: sp.S.One}
    return (
        Symmetry("shift_x", {x: sp.S.One}, "shift along x", source=SOURCE),
        Symmetry("shift_y", {y: sp.S.One}, "shift along y", source=SOURCE),
        Symmetry("turning", turning, "rotation of the plane about its origin", source=SOURCE),
    )


# --- velocities alone ----------------------------------------------------------------------

REDUCED_TITLE = "Velocities of the Chaplygin sleigh"
REDUCED_SUMMARY = (
    "The velocities of the Chaplygin sleigh: a conformally Hamiltonian system whose multiplier "
    "vanishes where the sleigh goes straight on, so that motions tend to equilibria."
)


def reduced_system(p: Numbers) -> System:
    """u̇ = aΩ², Ω̇ = −(m a/J) uΩ."""
    energy = HALF * (m * u**2 + J * Omega**2)
    structure = PoissonStructure(
        "bracket", [[0, 1], [-1, 0]], rank=2, meaning="bracket of the velocities", source=SOURCE
    )
    return System(
        name="chaplygin-sleigh-reduced",
        title=REDUCED_TITLE,
        summary=REDUCED_SUMMARY,
        source=SOURCE,
        parameters=_parameters(p),
        definitions={J: I + m * a**2},
        field={u: a * Omega**2, Omega: -m * a * u * Omega / J},
        laws=(
            Integral("energy", energy, "kinetic energy", source="Theorem 1", unit="J"),
            SINGULAR,
            structure,
            ConformallyHamiltonian(
                "form",
                a * Omega / J,
                structure,
                energy,
                "conformally Hamiltonian form; its multiplier vanishes at Ω = 0",
                source="(3.7)",
            ),
        ),
    )


# --- the form (4.4) ------------------------------------------------------------------------


def _momenta_to_velocities() -> tuple[sp.Expr, sp.Expr]:
    """u and Ω by q₁ = φ, q₂ = x and the momenta P₁, P₂."""
    along = sp.cos(chaplygin.q_1) * chaplygin.P_2 / m
    return along, (chaplygin.P_1 + m * b * along) / (I + m * a**2)


def _gyroscopic_coefficient(along: sp.Expr, turning: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """S by the velocities: −∂T/∂ẏ · ∂(tan φ)/∂φ."""
    sine, cosine = sp.sin(angle), sp.cos(angle)
    return -m * (along * sine + a * turning * cosine) / cosine**2


def _chaplygin_form_identity() -> Identity:
    """The equations (4.7) for q₁ = φ, q₂ = x; y follows from ẏ = ẋ tan φ."""
    P_1, P_2 = chaplygin.P_1, chaplygin.P_2
    S = chaplygin.S
    # ∂H/∂φ at fixed momenta is −∂L/∂φ with L = ½m(ẋ/cos φ − bφ̇)² + ½J φ̇²
    by_angle = -m * u * v * sp.tan(phi)
    return Identity(
        "chaplygin_form",
        (
            Rate(P_1) + by_angle - Rate(x) * S,
            Rate(P_2) + Rate(phi) * S,
            Rate(y) - Rate(x) * sp.tan(phi),
        ),
        "the form (4.4) with b(q) = 0, in q₁ = φ and q₂ = x",
        {
            P_1: J * Omega - m * b * u,
            P_2: m * u / sp.cos(phi),
            S: _gyroscopic_coefficient(u, Omega, phi),
        },
        source="§4.3, after (4.4)",
    )


def sleigh_in_chaplygin_form() -> System:
    """The sleigh in the form (4.7), in q₁ = φ and q₂ = x; singular where cos φ = 0.

    Theorem 6 applies when the centre of mass lies beside the contact, a = 0; for a ≠ 0 no measure
    has a density that depends on the coordinates alone.
    """
    along, turning = _momenta_to_velocities()
    return chaplygin.form(
        "chaplygin-sleigh-form",
        TITLE,
        HALF * m * along**2 + HALF * (I + m * a**2) * turning**2,
        _gyroscopic_coefficient(along, turning, chaplygin.q_1),
        (*_parameters(DEFAULTS), _lateral_offset(DEFAULTS)),
        multiplier=sp.cos(chaplygin.q_1),
        on=(a,),
        source=SOURCE,
        summary=SUMMARY,
        unit="J",
    )


#: From the contact to the centre of mass, (a, b) in axes along and across the blade.
_AHEAD = (a * sp.cos(phi) - b * sp.sin(phi), a * sp.sin(phi) + b * sp.cos(phi))
PLAN = Plan(
    (x, y),
    links=((x, y, x + _AHEAD[0], y + _AHEAD[1]),),
    blades=((x, y, phi),),
    points=((x + _AHEAD[0], y + _AHEAD[1]),),
)

DEFAULTS = {"m": 1.0, "I": 0.7, "a": 0.3, "b": 0.1}

ENTRIES = (
    Entry(
        name="chaplygin-sleigh",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=sleigh,
        plan=PLAN,
        start=Start(state={"x": 0.0, "y": 0.0, "phi": 0.4, "v": -1.0, "Omega": 0.05}, until=30.0),
        general=sleigh_in_chaplygin_form,
        variables={
            "x": ("contact of the blade", "m"),
            "y": ("contact of the blade", "m"),
            "phi": ("direction of the blade", "rad"),
            "v": ("velocity of the contact along the blade", "m/s"),
            "Omega": ("angular velocity", "rad/s"),
        },
    ),
    Entry(
        name="chaplygin-sleigh-reduced",
        title=REDUCED_TITLE,
        summary=REDUCED_SUMMARY,
        source=SOURCE,
        defaults={name: value for name, value in DEFAULTS.items() if name != "b"},
        build=reduced_system,
        start=Start(state={"u": -1.0, "Omega": 0.05}, until=30.0),
    ),
)
