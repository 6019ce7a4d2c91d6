"""The Chaplygin sleigh (§4.3): a body on a plane, with a blade that cannot slip sideways.

(x, y) is the point of contact of the blade, φ its direction and v its velocity along itself.  In
axes along and across the blade, with the contact as origin, the centre of mass is (a, b), and
u = v − bΩ is its velocity along the blade.
"""

from __future__ import annotations

import math

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.system import Parameter, System

from ...mechanics.rolling.body import check_mass
from ..catalogue_entry import Numbers
from ..chaplygin_ball import generalised_chaplygin as chaplygin

x, y, phi, v, u, Omega = sp.symbols("x y phi v u Omega", real=True)
m, I, a, b, J = sp.symbols("m I a b J", real=True)

SOURCE = "§4.3"
HALF = sp.Rational(1, 2)


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


# --- velocities alone ----------------------------------------------------------------------


# --- the form (4.4) ------------------------------------------------------------------------


def _momenta_to_velocities() -> tuple[sp.Expr, sp.Expr]:
    """u and Ω by q₁ = φ, q₂ = x and the momenta P₁, P₂."""
    along = sp.cos(chaplygin.q_1) * chaplygin.P_2 / m
    return along, (chaplygin.P_1 + m * b * along) / (I + m * a**2)


def _gyroscopic_coefficient(along: sp.Expr, turning: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """S by the velocities: −∂T/∂ẏ · ∂(tan φ)/∂φ."""
    sine, cosine = sp.sin(angle), sp.cos(angle)
    return -m * (along * sine + a * turning * cosine) / cosine**2


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


DEFAULTS = {"m": 1.0, "I": 0.7, "a": 0.3, "b": 0.1}
