"""The Lagrange top (§4.1): a heavy symmetric body about a fixed point on its axis.

In Euler angles γ = (sin θ sin φ, sin θ cos φ, cos θ): θ is the nutation, φ the intrinsic rotation
and ψ the precession.  On e(3) the momentum M and the vertical Γ are taken in body axes.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

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
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import constant, cross, dot, real_symbol, to_components

from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Entry, Numbers, Start
from ..e3 import Gamma, M, e3_system

I_1, I_3, P = sp.symbols("I_1 I_3 P", real=True)
theta, phi, psi = sp.symbols("theta phi psi", real=True)
p_theta, p_phi, p_psi = sp.symbols("p_theta p_phi p_psi", real=True)
M_1, M_2, M_3 = M.symbols
Gamma_1, Gamma_2, Gamma_3 = Gamma.symbols
#: Values of the energy and of the area integral.
h_0, c_0 = real_symbol("h_0"), real_symbol("c_0")

SOURCE = "§4.1"
ANGULAR = "kg m^2/s"


def _parameters(p: Numbers) -> tuple[Parameter, ...]:
    check_inertia((p["I_1"], p["I_1"], p["I_3"]))
    return (
        Parameter(I_1, "moment of inertia across the axis", p["I_1"], "kg m^2", (I_1 > 0,)),
        Parameter(I_3, "moment of inertia about the axis", p["I_3"], "kg m^2", (I_3 > 0,)),
        Parameter(
            P, "weight times distance of the centre of mass from the fixed point", p["P"], "N m"
        ),
    )


# --- on e(3) -------------------------------------------------------------------------------

TITLE = "Lagrange top"
SUMMARY = (
    "A heavy, dynamically symmetric body turns about a fixed point of its axis; the rates of "
    "precession and of intrinsic rotation depend on the nutation alone."
)


def on_e3(p: Numbers) -> System:
    """The top in the momentum M and the vertical Γ, body axes."""
    area = dot(M, Gamma)
    hamiltonian = (M_1**2 + M_2**2) / (2 * I_1) + M_3**2 / (2 * I_3) + P * Gamma_3
    turned = real_symbol("phi")
    return e3_system(
        "lagrange-top",
        TITLE,
        hamiltonian,
        _parameters(p),
        laws=(
            Integral("area", area, "area integral", source=SOURCE, unit=ANGULAR),
            Integral("spin", M_3, "momentum about the axis", source=SOURCE, unit=ANGULAR),
            Symmetry(
                "axis",
                {M: cross(unit_vector(3), M), Gamma: cross(unit_vector(3), Gamma)},
                "rotation of the body about its axis",
                source=SOURCE,
            ),
            Measure("volume", {sp.S.One: sp.S.One}, "volume of M and Γ", source="§3.3"),
            Reduction(
                "nutation",
                {h_0: hamiltonian, c_0: area},
                (
                    I_1 * Rate(Gamma_3) ** 2
                    - (2 * (h_0 - P * Gamma_3) - M_3**2 / I_3) * (1 - Gamma_3**2)
                    + (c_0 - M_3 * Gamma_3) ** 2 / I_1,
                    Rate(h_0),
                    Rate(c_0),
                    Rate(M_3),
                ),
                "equation for cos θ = Γ₃ alone, with the values of the integrals",
                source=SOURCE,
            ),
            Identity(
                "intrinsic_rotation",
                Rate(turned)
                - (1 / I_3 - 1 / I_1) * M_3
                - (M_3 - area * Gamma_3) / (I_1 * (1 - Gamma_3**2)),
                "rate of the angle of intrinsic rotation, by the nutation",
                {turned: sp.atan2(Gamma_1, Gamma_2)},
                source=SOURCE,
            ),
        ),
        source=SOURCE,
        summary=SUMMARY,
    )


# --- in Euler angles -----------------------------------------------------------------------

ANGLES = "Lagrange top in Euler angles"
ANGLES_SUMMARY = (
    "The Lagrange top in Euler angles and their momenta: two of the angles are cyclic, so that "
    "the motion is found by quadratures."
)
STATE = (theta, phi, psi, p_theta, p_phi, p_psi)


def canonical() -> PoissonStructure:
    """{q_i, p_j} = δ_ij in the order of the state."""
    one, nothing = sp.eye(3), sp.zeros(3)
    matrix = nothing.row_join(one).col_join((-one).row_join(nothing))
    return PoissonStructure("canonical", matrix, rank=6, meaning="canonical bracket", source=SOURCE)


def quadratures() -> Identity:
    """Precession and intrinsic rotation by the nutation."""
    across = (p_psi - p_phi * sp.cos(theta)) / sp.sin(theta) ** 2
    along = (p_phi - p_psi * sp.cos(theta)) / sp.sin(theta) ** 2
    difference = (1 / I_3 - 1 / I_1) * p_phi
    meaning = "rates of precession and of intrinsic rotation, by the nutation"
    return Identity(
        "quadratures",
        (Rate(psi) - across / I_1, Rate(phi) - difference - along / I_1),
        meaning,
        source=SOURCE,
        as_printed=Identity(
            "quadratures",
            (Rate(psi) - across, Rate(phi) - difference - across),
            meaning,
            source=SOURCE,
        ),
        misprint="the factor 1/I₁ is lost in both, and p_ψ and p_φ are exchanged in the second",
    )


def angles(p: Numbers) -> System:
    """The top in canonical variables."""
    s, c = sp.sin(theta), sp.cos(theta)
    across = (p_psi - p_phi * c) / s
    H = p_theta**2 / (2 * I_1) + across**2 / (2 * I_1) + p_phi**2 / (2 * I_3) + P * c
    structure = canonical()
    turning = (p_phi / I_3 - across * c / (I_1 * s), across / (I_1 * s))
    rates = (p_theta / I_1, *turning, -sp.diff(H, theta), sp.S.Zero, sp.S.Zero)
    sine, cosine = sp.sin(phi), sp.cos(phi)
    momentum = (p_theta * cosine + across * sine, across * cosine - p_theta * sine, p_phi)
    vertical = (s * sine, s * cosine, c)
    return System(
        name="lagrange-top-angles",
        title=ANGLES,
        summary=ANGLES_SUMMARY,
        source=SOURCE,
        parameters=_parameters(p),
        field=dict(zip(STATE, rates, strict=True)),
        laws=(
            Integral("energy", H, "Hamiltonian function", source=SOURCE, unit="J"),
            Integral("area", p_psi, "area integral", source=SOURCE, unit=ANGULAR),
            Integral("spin", p_phi, "momentum about the axis", source=SOURCE, unit=ANGULAR),
            *_cyclic(),
            structure,
            ConformallyHamiltonian(
                "hamiltonian", sp.S.One, structure, H, "canonical form", source=SOURCE
            ),
            Measure("volume", {sp.S.One: sp.S.One}, "phase volume", source="§3.3"),
            quadratures(),
            _body_axes(momentum, vertical),
        ),
    )


def _body_axes(momentum: tuple[sp.Expr, ...], vertical: tuple[sp.Expr, ...]) -> Reduction:
    """The reduction by the precession: equations on e(3)."""
    omega = constant([M_1 / I_1, M_2 / I_1, M_3 / I_3])
    rates = zip((*M, *Gamma), _e3_rates(omega), strict=True)
    return Reduction(
        "body_axes",
        {M: constant(momentum), Gamma: constant(vertical)},
        tuple(Rate(s) - rate for s, rate in rates),
        "momentum and vertical in body axes move as on e(3)",
        source=SOURCE,
    )


def _e3_rates(omega: MatrixExpr) -> tuple[sp.Expr, ...]:
    turning = to_components(cross(M, omega) + P * cross(Gamma, unit_vector(3)))
    return (*turning, *to_components(cross(Gamma, omega)))


def _cyclic() -> tuple[Law, ...]:
    return (
        Symmetry(
            "precession",
            {psi: sp.S.One},
            "rotation of space about the vertical",
            source=SOURCE,
        ),
        Symmetry(
            "axis",
            {phi: sp.S.One},
            "rotation of the body about its axis",
            source=SOURCE,
        ),
    )


DEFAULTS = {"I_1": 1.0, "I_3": 0.6, "P": 1.5}

ENTRIES = (
    Entry(
        name="lagrange-top",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=on_e3,
        start=Start(state={"M": (0.3, -0.2, 2.5), "Gamma": (2 / 7, -3 / 7, 6 / 7)}, until=60.0),
    ),
    Entry(
        name="lagrange-top-angles",
        title=ANGLES,
        summary=ANGLES_SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=angles,
        start=Start(
            state={
                "theta": 0.6,
                "phi": 0.3,
                "psi": 0.0,
                "p_theta": 0.2,
                "p_phi": 2.5,
                "p_psi": 2.3,
            },
            until=60.0,
        ),
    ),
)
