"""A heavy disk on smooth ice (§11.3; Kozlov and Kolesnikov [99]).

The disk does not bite the ice, but its sharp edge keeps the velocity of the contact point parallel
to the horizontal diameter ξ: the disk may slip and turn about its axis freely.  With the axis e₃,
the direction y up the disk and ξ = y×e₃, so that γ = s y + γ₃ e₃, the contact point is r = −R y,

    v = V ξ + R ω_ξ e₃,

and the reaction N, in the plane of y and e₃, is perpendicular to ξ.  The torque r×N is τ ξ with
τ = −R (N, e₃), and Newton's equation gives both V̇ = −R ω_ξ ω_y and (N, e₃).
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Integral, Law, Measure, Rate, Reduction, Symmetry
from flowlanes.system.system import Guard, Observable, Parameter, Reconstruction, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import (
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)

from ...mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    rotation,
    unit_length,
)
from ...mechanics.rolling.body import check_mass
from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Entry, Numbers, Start

omega, gamma, xi, y, N, v, L = vectors("omega gamma xi y N v L")
place = Vector("place", 2)
m, R, g, I_1, I_3, V, s, omega_xi, omega_y, N_e = (
    real_symbol(name)
    for name in ["m", "R", "g", "I_1", "I_3", "V", "s", "omega_xi", "omega_y", "N_e"]
)
HALF = sp.Rational(1, 2)
AXIS = unit_vector(3)
gamma_3, omega_3 = gamma.symbols[2], omega.symbols[2]
INERTIA = constant(sp.diag(I_1, I_1, I_3))
MOMENTUM = "kg m^2/s"
SOURCE = "§11.3"

#: s = sin of the inclination, and the axes ξ, y of the disk that go with the vertical.
PARTS: dict[sp.Basic, sp.Basic] = {
    s: sp.sqrt(1 - gamma_3**2),
    xi: cross(gamma, AXIS) / s,
    y: (gamma - gamma_3 * AXIS) / s,
    omega_xi: dot(omega, xi),
    omega_y: dot(omega, y),
    L: INERTIA * omega,
}


def disk_parameters(p: Numbers) -> tuple[Parameter, ...]:
    """Mass, radius, moments of inertia across and about the axis, gravity."""
    check_mass(p["m"])
    check_inertia((p["I_1"], p["I_1"], p["I_3"]))
    return (
        Parameter(m, "mass", p["m"], "kg", (m > 0,)),
        Parameter(R, "radius of the disk", p["R"], "m", (R > 0,)),
        Parameter(I_1, "moment of inertia across the axis", p["I_1"], "kg m^2", (I_1 > 0,)),
        Parameter(I_3, "moment of inertia about the axis", p["I_3"], "kg m^2", (I_3 > 0,)),
        Parameter(g, "acceleration of gravity", p["g"], "m/s^2", (g >= 0,)),
    )


def not_flat() -> Guard:
    """The domain: a disk that does not lie flat."""
    return Guard("flat", 1 - gamma_3**2, "the disk lies flat")


def lift_off(force: sp.Expr) -> Guard:
    """The contact, which ends when the normal force changes sign."""
    return Guard("contact", force, "the normal force changes sign", lift_off=True)


def in_space(velocity: MatrixExpr) -> Reconstruction:
    """Attitude, centre and contact point of a disk whose centre has a velocity (body axes)."""
    turn = rotation()
    first, second = place.symbols
    horizontal = list(turn * to_components(velocity))[:2]
    reach = turn * to_components(-R * y)
    return Reconstruction(
        field={attitude: quaternion_rate(omega), place: constant(horizontal)},
        relations=(unit_length(), *attitude_relations(gamma)),
        observables=(
            attitude_observable(),
            Observable("centre", constant([first, second, R * s]), "centre of mass", "m", "space"),
            Observable(
                "contact",
                constant([first + reach[0], second + reach[1], 0]),
                "contact point",
                "m",
                "space",
            ),
        ),
    )


# --- the disk on ice -----------------------------------------------------------------------

TITLE = "Disk on smooth ice"
SUMMARY = (
    "A heavy disk whose sharp edge glides on ice: the velocity of the contact point is parallel to "
    "the horizontal diameter, and the disk may turn about its axis freely; the motion is "
    "integrable by quadratures."
)

#: d(ω, ξ)/dt, from the equation of moments about ξ.
TIPPING = (
    I_1 * gamma_3 / s * omega_y**2
    - I_3 * omega_3 * omega_y
    + m * R * V * omega_y
    - m * g * R * gamma_3
) / (I_1 + m * R**2)

AREA = dot(L, gamma)
ENERGY = HALF * m * (V**2 + R**2 * omega_xi**2) + HALF * dot(L, omega) + m * g * R * s


def _gain(area: sp.Expr, spin: sp.Expr) -> sp.Expr:
    """The difference of V from its constant, for given (Iω, γ) and ω₃."""
    across = sp.log((1 - gamma_3) / (1 + gamma_3))
    return R / (2 * I_1) * (area * across - I_3 * spin * sp.log(1 - gamma_3**2))


def _nutation() -> Reduction:
    """The quadrature: γ₃ alone, with the values h, c, w, f of the four integrals."""
    h, c, w, f, V_f = (real_symbol(name) for name in ("h", "c", "w", "f", "V_f"))
    return Reduction(
        "nutation",
        {
            h: ENERGY,
            c: AREA,
            w: omega_3,
            f: V + _gain(AREA, omega_3),
            V_f: f - _gain(c, w),
        },
        (
            (I_1 + m * R**2) * Rate(gamma_3) ** 2
            - (1 - gamma_3**2) * (2 * h - I_3 * w**2 - m * V_f**2 - 2 * m * g * R * s)
            + (c - I_3 * w * gamma_3) ** 2 / I_1,
            V - V_f,
            *map(Rate, (h, c, w, f)),
        ),
        "quadrature for γ₃, the cosine of the nutation, with the values of the integrals",
        source="§11.3, [99]",
    )


def laws() -> tuple[Law, ...]:
    """Four integrals, a measure, a symmetry and the quadrature."""
    return (
        Integral("energy", ENERGY, "energy", source=SOURCE, unit="J"),
        Integral("spin", omega_3, "angular velocity about the axis", source=SOURCE, unit="rad/s"),
        Integral("area", AREA, "vertical momentum", source=SOURCE, unit=MOMENTUM),
        Integral(
            "glide",
            V + _gain(AREA, omega_3),
            "velocity along the horizontal diameter less what the nutation gives",
            source="§11.3, [99]",
            unit="m/s",
        ),
        Measure("measure", {sp.S.One: sp.S.One}, "volume of ω, γ, V", source=SOURCE),
        Symmetry(
            "axis",
            {omega: cross(AXIS, omega), gamma: cross(AXIS, gamma)},
            "rotation of the disk about its axis",
            source=SOURCE,
        ),
        _nutation(),
    )


def build(p: Numbers) -> System:
    """Newton's and Euler's equations with the reaction eliminated."""
    return System(
        name="disk-on-ice",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=disk_parameters(p),
        definitions={
            **PARTS,
            v: V * xi + R * omega_xi * AXIS,
            N_e: m * (R * TIPPING - V * omega_y + g * gamma_3),
            N: N_e * AXIS + m * (gamma_3 / s * omega_y * V - R * omega_xi**2 + g * s) * y,
        },
        field={
            omega: INERTIA**-1 * (cross(L, omega) - R * N_e * xi),
            gamma: cross(gamma, omega),
            V: -R * omega_xi * omega_y,
        },
        relations=(norm_squared(gamma) - 1,),
        laws=laws(),
        observables=(
            Observable("normal_force", dot(N, gamma), "normal force", "N"),
            Observable("edge_force", dot(N, cross(xi, gamma)), "force across the edge", "N"),
        ),
        guards=(not_flat(), lift_off(dot(N, gamma))),
        reconstruction=in_space(v),
    )


ENTRIES = (
    Entry(
        name="disk-on-ice",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        # a uniform thin disk
        defaults={"m": 1.0, "I_1": 0.25, "I_3": 0.5, "R": 1.0, "g": 9.81},
        build=build,
        start=Start(
            state={"omega": (0.3, 0.4, 6.0), "gamma": (0.8, 0.2, 0.5656854249492381), "V": -2.0},
            until=12.0,
        ),
        variables={
            "omega": ("angular velocity", "rad/s"),
            "gamma": ("vertical, body axes", "1"),
            "V": ("velocity of the centre along the horizontal diameter", "m/s"),
        },
    ),
)
