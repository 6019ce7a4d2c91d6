"""The Chaplygin ball in Euler angles (§7.3, §7.4): the motion, and its Hamiltonian form.

The body stands at Rz(ψ) Rx(θ) Rz(φ), which gives (6.5); the momenta are
p_θ = ρ ∂T/∂θ̇ = ρ(M_1 cos φ − M_2 sin φ) and p_φ = ρ ∂T/∂φ̇ = ρM_3.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Identity, Integral, PoissonStructure
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import Guard, Observable, Parameter, System
from flowlanes.system.vectors import (
    Components,
    constant,
    cross,
    dot,
    real_symbol,
    to_components,
    vectors,
    zero,
)

from ..catalogue_entry import Numbers, entry_with
from .chaplygin_bracket import (
    DET_IQ,
    DET_J,
    PARAMETERS,
    ROTORS,
    TENSORS,
    A,
    D,
    I,
    J,
    L,
    R,
    energy,
    gamma,
    k,
    with_numbers,
)

M, omega, alpha, beta = vectors("M omega alpha beta")
theta, phi, psi, x, y = (real_symbol(name) for name in ("theta", "phi", "psi", "x", "y"))
thetadot, phidot, psidot = (real_symbol(f"{name}dot") for name in ("theta", "phi", "psi"))
p_theta, p_phi, c, N, Sbar = (real_symbol(s) for s in ("p_theta", "p_phi", "c", "N", "Sbar"))

#: The area constant, a parameter of the reduced system.
AREA = Parameter(c, "area constant (M, γ)", 0.8, "kg m^2/s")

SIN, COS, TURN, ACROSS = sp.sin(theta), sp.cos(theta), sp.sin(phi), sp.cos(phi)
UPRIGHT = Guard("upright", SIN, "the third axis stands vertical, where Euler angles fail")
#: γ of (6.5).
VERTICAL = constant([SIN * TURN, SIN * ACROSS, COS])
#: det I_Q in the angles.
DET_IQ_ANGLES = DET_J * (1 - D * dot(VERTICAL, A * VERTICAL))
#: L = ρM in the angles and their momenta.
MOMENTUM = constant(
    [
        p_theta * ACROSS - p_phi * COS * TURN / SIN + c * N * TURN / SIN,
        -p_theta * TURN - p_phi * COS * ACROSS / SIN + c * N * ACROSS / SIN,
        p_phi,
    ]
)

TITLE = "Chaplygin ball in Euler angles"
SUMMARY = "Nutation and proper rotation of the Chaplygin ball, with its momentum in body axes."
SOURCE = "§7.3, (7.8)–(7.11)"
REDUCED_TITLE = "Chaplygin ball as a generalised Chaplygin system"
REDUCED_SUMMARY = (
    "Nutation and proper rotation of the Chaplygin ball in the time dτ = ρ dt: a Hamiltonian "
    "system with a gyroscopic term."
)


# --- the motion ----------------------------------------------------------------------------


def ball_in_angles(rotors: MatrixExpr = zero) -> System:
    """θ, φ and the momentum M (body axes) of the ball without a potential.

    Parameters
    ----------
    rotors : MatrixExpr
        Gyrostatic momentum: the vector ``k``, or zero.
    """
    om1, om2, om3 = omega.symbols
    share = D * dot(A * gamma, M) / (1 - D * dot(gamma, A * gamma))
    return System(
        name="chaplygin-ball-angles",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=PARAMETERS if rotors == zero else PARAMETERS + ROTORS,
        definitions={
            **TENSORS,
            gamma: VERTICAL,
            omega: A * M + share * (A * gamma),
            c: dot(M + rotors, gamma),
            thetadot: om1 * ACROSS - om2 * TURN,
            psidot: (om1 * TURN + om2 * ACROSS) / SIN,
            phidot: om3 - psidot * COS,
        },
        field={theta: thetadot, phi: phidot, M: cross(M + rotors, omega)},
        laws=(
            Integral("energy", dot(M, omega) / 2, "energy", source="(7.2)", unit="J"),
            Integral("area", c, "area integral", source="(7.11)", unit="kg m^2/s"),
        ),
        observables=(
            Observable("omega", omega, "angular velocity", "rad/s", "body"),
            Observable("psidot", psidot, "rate of precession", "rad/s", source="(6.5)"),
        ),
        guards=(UPRIGHT,),
    )


def in_space(system: System) -> System:
    """A system with ψ and the position x, y of the centre, rolling without slipping.

    The axes of space are definitions ``alpha``, ``beta`` besides ``gamma``, body axes.
    """
    nodes = sp.Matrix([ACROSS, -TURN, 0])
    lean = sp.Matrix([COS * TURN, COS * ACROSS, -SIN])
    sine, cosine = sp.sin(psi), sp.cos(psi)
    velocity = cross(omega, R * gamma)
    return replace(
        system,
        field=(
            *system.field,
            (psi, psidot),
            (x, dot(alpha, velocity)),
            (y, dot(beta, velocity)),
        ),
        definitions=(
            *system.definitions,
            (alpha, constant(cosine * nodes - sine * lean)),
            (beta, constant(sine * nodes + cosine * lean)),
        ),
    )


# --- the Hamiltonian form ------------------------------------------------------------------


def gyroscopic(rotors: MatrixExpr) -> sp.Expr:
    """S̄ of (7.13), and of §7.4 for rotors, in the angles."""
    J_1, J_2, J_3 = J.symbols
    turning = c * J_3 * (J_1 * ACROSS**2 + J_2 * TURN**2)
    return N**3 * D * SIN * (turning - DET_J * dot(gamma, A * rotors))


def hamiltonian(rotors: MatrixExpr) -> sp.Expr:
    """The energy in θ, φ, p_θ, p_φ, with nothing left to differentiate but these."""
    # γ and N are definitions of the system; a derivative would take them for constants
    place = dict(zip(gamma.symbols, scalars(VERTICAL), strict=True))
    momentum = to_components(MOMENTUM).subs(N, 1 / sp.sqrt(to_components(DET_IQ_ANGLES)))
    motion = dict(zip(L.symbols, momentum, strict=True))
    value: sp.Expr = to_components(energy(rotors)).xreplace(place | motion)
    return value


def _theorem_9() -> Identity:
    """H of Theorem 9, as it is and as it is printed, against the energy."""
    I_1, I_2, I_3 = I.symbols
    one, two = I_1 * TURN**2 + I_2 * ACROSS**2, I_1 * ACROSS**2 + I_2 * TURN**2
    swing = D * dot(VERTICAL, I * VERTICAL)
    mixed = (I_1 - I_2) * TURN * ACROSS
    reach = I_3 + D * SIN**2
    agreed = -N * c * p_theta / SIN * mixed * reach
    right = (
        p_theta**2 * (I_3 * one + swing) / 2
        + p_phi**2 / SIN**2 * (I_1 * I_2 * SIN**2 + I_3 * two * COS**2 + swing) / 2
        + p_theta * p_phi / SIN * I_3 * mixed * COS
        - N * c * p_phi / SIN**2 * I_3 * (two + D) * COS
        + N**2 * c**2 / SIN**2 * reach * (two + D) / 2
    )
    printed = (
        p_theta**2 * (I_3 * one - swing) / 2
        + p_phi**2 / SIN**2 * (I_1 * I_2 * SIN**2 + I_3 * one * COS**2 - swing) / 2
        + p_theta * p_phi / SIN * I_3 * mixed * COS * SIN
        - N * c * p_phi / SIN**2 * I_3 * (two + D)
        + N**2 * c**2 / SIN**2 * reach * (two + D)
    )
    energy_here = hamiltonian(zero)
    law = Identity(
        "hamiltonian_in_angles",
        agreed + right - energy_here,
        meaning="the energy in θ, φ, p_θ, p_φ, term by term",
        source="Theorem 9",
    )
    return replace(
        law,
        as_printed=replace(law, value=agreed + printed - energy_here),
        misprint="signs of D, Ĩ₁₂ for Ĩ₂₁, factors sin θ, cos θ and ½",
    )


def gyroscopic_matrix(twist: sp.Expr) -> Components:
    """The bracket (7.14) in θ, φ, p_θ, p_φ, with {p_φ, p_θ} = `twist`."""
    return Components([[0, 0, 1, 0], [0, 0, 0, 1], [-1, 0, 0, -twist], [0, -1, twist, 0]])


def reduced_system(rotors: MatrixExpr, twist: sp.Expr) -> System:
    """θ, φ and their momenta in the time τ, at a given area constant; Theorem 9.

    Parameters
    ----------
    rotors : MatrixExpr
        Gyrostatic momentum: the vector ``k``, or zero.
    twist : sympy.Expr
        S̄ in the angles.
    """
    # {p_φ, p_θ} = S̄ adds −S̄ ∂H/∂p_φ to the rate of p_θ and S̄ ∂H/∂p_θ to that of p_φ
    energy_here = hamiltonian(rotors)
    slopes = [sp.diff(energy_here, s) for s in (theta, phi, p_theta, p_phi)]
    structure = PoissonStructure(
        "bracket",
        gyroscopic_matrix(Sbar),
        rank=4,
        meaning="canonical but for {p_φ, p_θ} = S̄(θ, φ)",
        source="(7.14)" if rotors == zero else "§7.4",
    )
    return System(
        guards=(UPRIGHT,),
        name="chaplygin-ball-reduced",
        title=REDUCED_TITLE,
        summary=REDUCED_SUMMARY,
        source="§7.3, (7.12)–(7.14), Theorem 9",
        parameters=(*PARAMETERS, AREA) if rotors == zero else (*PARAMETERS, *ROTORS, AREA),
        definitions={
            **TENSORS,
            gamma: VERTICAL,
            N: 1 / sp.sqrt(DET_IQ_ANGLES),
            Sbar: twist,
        },
        field={
            theta: slopes[2],
            phi: slopes[3],
            p_theta: -slopes[0] - Sbar * slopes[3],
            p_phi: -slopes[1] + Sbar * slopes[2],
        },
        laws=(
            Integral("energy", energy_here, "energy", source="Theorem 9", unit="J"),
            structure,
            ConformallyHamiltonian(
                "hamiltonian",
                sp.S.One,
                structure,
                energy_here,
                "Hamiltonian form",
                source="Theorem 9" if rotors == zero else "§7.4",
            ),
            *((_theorem_9(),) if rotors == zero else ()),
        ),
    )


def reduction(rotors: MatrixExpr = zero) -> Isomorphism:
    """From the ball in angles to its Hamiltonian form."""
    density = 1 / sp.sqrt(DET_IQ)
    total = M + rotors
    first, second, third = to_components(total)
    law = Isomorphism(
        "reduced",
        reduced_system(rotors, gyroscopic(rotors)),
        {
            theta: theta,
            phi: phi,
            p_theta: density * (first * ACROSS - second * TURN),
            p_phi: density * third,
        },
        density,
        constants={c: dot(total, gamma)},
        meaning="Hamiltonian form in Euler angles",
        source="Theorem 9" if rotors == zero else "§7.4",
    )
    if rotors == zero:
        return law
    return replace(
        law,
        as_printed=replace(law, target=reduced_system(rotors, gyroscopic(-rotors))),
        misprint="sign of the term with k in S̄",
    )


# --- the catalogue -------------------------------------------------------------------------


def build(p: Numbers) -> System:
    """The ball in angles."""
    return with_numbers(ball_in_angles().with_laws(reduction()), p)


def build_reduced(p: Numbers) -> System:
    """Its Hamiltonian form."""
    return with_numbers(reduced_system(zero, gyroscopic(zero)), p)


def general_with_rotors() -> System:
    """The ball with rotors in angles."""
    return ball_in_angles(k).with_laws(reduction(k))


ENTRIES = (
    entry_with(
        name="chaplygin-ball-angles",
        build=build,
        general=general_with_rotors,
    ),
    entry_with(
        name="chaplygin-ball-reduced",
        build=build_reduced,
    ),
)
