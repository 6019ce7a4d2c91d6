"""The Veselova system (§6): a body about a fixed point that must not turn about the vertical."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Separation,
)
from flowlanes.system.system import Observable, Parameter, Reconstruction, System
from flowlanes.system.vector_operators import gradient, hat
from flowlanes.system.vectors import (
    Components,
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
    zero,
)

from ...mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    unit_length,
)
from ...mechanics.rolling.inertia import check_inertia
from .. import e3
from ..catalogue_entry import Numbers
from . import neumann
from .neumann import cubic, sphero_conical_coordinates, u, v
from .veselova_geodesic import in_potential

omega, gamma, omegadot, X = vectors("omega gamma omegadot X")
I, A = Diagonal("I"), Diagonal("A")
I_1, I_2, I_3 = I.symbols
lambda_0, U, K = real_symbol("lambda_0"), real_symbol("U"), real_symbol("K")
#: The values of energy and momentum integral.
h, F = real_symbol("h"), real_symbol("F")

HALF = sp.Rational(1, 2)
DET_I = I_1 * I_2 * I_3
KINETIC = HALF * dot(I * omega, omega)
#: ρ_ω of (6.3).
DENSITY = sp.sqrt(dot(gamma, I**-1 * gamma))
ANY = sp.Function("U")(*gamma.symbols)
FREE = sp.S.Zero

SOURCE = "§6.1, (6.1)–(6.4)"
MOMENTUM_UNIT = "kg^2 m^4/s^2"


def turning(
    name: str,
    title: str,
    summary: str,
    source: str,
    parameters: tuple[Parameter, ...],
    potential: sp.Expr,
    constraint: tuple[sp.Expr, ...],
    laws: tuple[Law, ...],
    rotors: MatrixExpr = zero,
) -> System:
    """(6.1) in a potential, with the sign of λ₀ that keeps (ω, γ) constant.

    Parameters
    ----------
    name, title, summary, source : str
    parameters : tuple of Parameter
    potential : sympy.Expr
        U in ``gamma_1``, ``gamma_2``, ``gamma_3`` (body axes); zero for none.
    constraint : tuple of sympy.Expr
        What vanishes besides γ² − 1: (ω, γ), or nothing.
    laws : tuple of Law
    rotors : vector
        Constant momentum of rotors, body axes.
    """
    torque = (
        cross(I * omega, omega) + cross(rotors, omega) + cross(gamma, gradient(potential, gamma))
    )
    return System(
        name=name,
        title=title,
        summary=summary,
        source=source,
        parameters=parameters,
        definitions={
            A: I**-1,
            **({U: potential} if potential != 0 else {}),
            X: torque,
            lambda_0: -dot(A * gamma, X) / dot(A * gamma, gamma),
            omegadot: A * (X + lambda_0 * gamma),
        },
        field={omega: omegadot, gamma: cross(gamma, omega)},
        relations=(norm_squared(gamma) - 1, *constraint),
        laws=laws,
        observables=(
            Observable("spin_torque", lambda_0, "torque about the vertical", "N m", source="(6.1)"),
        ),
        reconstruction=Reconstruction(
            field={attitude: quaternion_rate(omega)},
            relations=(unit_length(), *attitude_relations(gamma)),
            observables=(attitude_observable(),),
        ),
    )


def moments(p: Numbers) -> tuple[float, float, float]:
    """The principal moments, refused unless a rigid body can have them."""
    values = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(values)
    return values


# --- laws ----------------------------------------------------------------------------------


def measure() -> Measure:
    """(6.3)."""
    return Measure(
        "measure",
        {dot(gamma, I**-1 * gamma): HALF},
        "invariant measure ρ d³ω d³γ",
        source="(6.3)",
    )


def bracket() -> PoissonStructure:
    """The canonical bracket of (6.10) in the variables ω, γ, on (ω, γ) = 0."""
    spin = hat(to_components(I * omega + cross(omega, cross(gamma, I * gamma))))
    normal = constant(gamma.symbols)
    corner = hat(gamma) * I.entries * (sp.eye(3) - normal * normal.T)
    top = spin.row_join(corner)
    whole = top.col_join((-corner.T).row_join(Components.zeros(3, 3)))
    return PoissonStructure(
        "bracket",
        whole / (to_components(DENSITY) * DET_I),
        casimirs=(norm_squared(gamma), dot(omega, gamma)),
        rank=4,
        meaning="canonical bracket of T*S² in the variables ω, γ",
        source="§6.2, (6.10)",
    )


def conformally_hamiltonian(potential: sp.Expr) -> tuple[Law, ...]:
    """Theorem 7 without coordinates: the bracket and v = ρ_ω⁻¹ J dH."""
    structure = bracket()
    return (
        structure,
        ConformallyHamiltonian(
            "hamiltonian",
            1 / DENSITY,
            structure,
            KINETIC + potential,
            "conformally Hamiltonian form",
            source="Theorem 7",
        ),
    )


def onto_e3(potential: sp.Expr, numbers: tuple[float, float, float]) -> Isomorphism:
    """(6.11), (6.12)."""
    roots = [sp.sqrt(s) for s in I.symbols]
    return Isomorphism(
        "e3",
        in_potential(potential, numbers),
        {
            e3.M: DENSITY * constant(sp.diag(*roots)) * omega,
            e3.Gamma: constant(sp.diag(*(1 / s for s in roots))) * gamma / DENSITY,
        },
        1 / (DENSITY * sp.sqrt(DET_I)),
        meaning="Hamiltonian system on e(3)",
        source="(6.11), (6.12)",
    )


def onto_neumann(p: Numbers) -> Isomorphism:
    """Theorem 8: ρ_ω ω and γ move as the Neumann system, whose c is 2h/det I."""
    return Isomorphism(
        "neumann",
        neumann.build({**p, "c": 1.0}),
        {e3.M: DENSITY * omega, e3.Gamma: gamma},
        1 / DENSITY,
        {neumann.c: 2 * KINETIC / DET_I},
        "Neumann system on a level of the energy",
        onto=(neumann.SECOND,),
        source="Theorem 8",
    )


def separation() -> Separation:
    """uv (u − v)² ż² = 4z A(z)(2hz − F) for z = u, v, without a field."""
    return Separation(
        "separation",
        {**sphero_conical_coordinates(gamma), h: KINETIC, F: norm_squared(cross(I * omega, gamma))},
        (
            *(
                u * v * (u - v) ** 2 * Rate(z) ** 2 - 4 * z * cubic(z) * (2 * h * z - F)
                for z in (u, v)
            ),
            Rate(h),
            Rate(F),
        ),
        "separated equations in sphero-conical coordinates",
        source="Remark 16",
    )


def energy(potential: sp.Expr) -> Integral:
    """(6.2)."""
    value = KINETIC + U if potential != 0 else KINETIC
    return Integral("energy", value, "energy", source="(6.2)", unit="J")


def momentum() -> Integral:
    """(6.4)."""
    return Integral(
        "momentum",
        norm_squared(cross(I * omega, gamma)),
        "square of the horizontal momentum",
        source="(6.4)",
        unit=MOMENTUM_UNIT,
    )


def momentum_in_bruns_field() -> Integral:
    """(6.4) in the field U = ½K(γ, Iγ)."""
    return Integral(
        "momentum",
        norm_squared(cross(I * omega, gamma)) - K * DET_I * dot(gamma, A * gamma),
        "square of the horizontal momentum, Bruns field",
        source="Remark 15",
        unit=MOMENTUM_UNIT,
    )


# --- systems -------------------------------------------------------------------------------


TITLE = "Veselova system"
SUMMARY = (
    "A rigid body turns about a fixed point, its centre of mass, under the constraint that its "
    "angular velocity has no vertical component."
)


def general() -> System:
    """In an unspecified potential."""
    numbers = moments(NUMBERS)
    return turning(
        "veselova",
        TITLE,
        SUMMARY,
        SOURCE,
        e3.inertia_parameters(numbers),
        ANY,
        (dot(omega, gamma),),
        (
            energy(ANY),
            measure(),
            *conformally_hamiltonian(ANY),
            onto_e3(ANY, numbers),
        ),
    )


NUMBERS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1}
