"""The Hamiltonian system on the nonlinear bracket (7.6) that the Chaplygin ball becomes.

With L = ρ(M + k), ρ = (det I_Q)^(−1/2), and the time dτ = ρ dt, the ball, with rotors k or
without, moves by dx/dτ = {H, x} with the energy H and the bracket

    {L_i, L_j} = ε_ijk u_k,   {L_i, γ_j} = ε_ijk γ_k,   {γ_i, γ_j} = 0,
    u = L − D det J (ρ² (L, γ) J⁻¹γ − ρ³ (γ, J⁻¹k) γ),

that is, L′ = u×∂H/∂L + γ×∂H/∂γ, γ′ = γ×∂H/∂L.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import ConformallyHamiltonian, Integral, PoissonStructure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
    zero,
)

from ...mechanics.rolling.body import check_mass
from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers
from ..e3 import lie_poisson

L, gamma, k, u = vectors("L gamma k u")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
m, R, rho = (real_symbol(name) for name in ("m", "R", "rho"))

D = m * R**2
J_1, J_2, J_3 = J.symbols
DET_J = J_1 * J_2 * J_3
#: det I_Q, written out in γ so that it can be differentiated.
DET_IQ = DET_J * (1 - D * dot(gamma, A * gamma))

TITLE = "Chaplygin ball as a Hamiltonian system"
SUMMARY = (
    "The Chaplygin ball in the time dτ = ρ dt and the momentum L = ρM: a Hamiltonian system with "
    "a nonlinear Poisson bracket."
)
SOURCE = "§7.2, (7.5)–(7.7)"

ROTORS_TITLE = "Chaplygin ball with rotors as a Hamiltonian system"
ROTORS_SUMMARY = (
    "The Chaplygin ball with rotors in the time dτ = ρ dt and the momentum L = ρ(M + k): a "
    "Hamiltonian system with a nonlinear Poisson bracket."
)

PARAMETERS = (
    Parameter(m, "mass", 1.0, "kg", (m > 0,)),
    *(
        Parameter(s, f"moment of inertia about body axis {i}", value, "kg m^2", (s > 0,))
        for i, (s, value) in enumerate(zip(I.symbols, (1.0, 1.5, 2.1), strict=True), 1)
    ),
    Parameter(R, "radius of the ball", 1.0, "m", (R > 0,)),
)
ROTORS = tuple(
    Parameter(s, f"gyrostatic momentum, body axis {i}", value, "kg m^2/s")
    for i, (s, value) in enumerate(zip(k.symbols, (0.3, -0.2, 0.5), strict=True), 1)
)
TENSORS = {J: I + D * identity, A: J**-1}


def energy(rotors: MatrixExpr) -> sp.Expr:
    """½(M, ω) with M = L/ρ − k and ω = I_Q⁻¹M, in L and γ: (7.7) for k = 0."""
    # without rotors ρ² cancels, and H is a polynomial in L as in (7.7)
    if rotors == zero:
        share = DET_IQ / DET_J * dot(L, A * L) + D * dot(A * L, gamma) ** 2
        return DET_J / 2 * share
    total = sp.sqrt(DET_IQ) * L - rotors
    share = D * dot(A * total, gamma) ** 2 / (1 - D * dot(gamma, A * gamma))
    return (dot(total, A * total) + share) / 2


def twisted_bracket(rotors: MatrixExpr) -> MatrixExpr:
    """u with {L_i, L_j} = ε_ijk u_k."""
    bend = rho**2 * dot(L, gamma) * (A * gamma)
    if rotors == zero:
        return L - D * DET_J * bend
    return L - D * DET_J * bend + D * DET_J * rho**3 * dot(gamma, A * rotors) * gamma


def _with_misprint(
    law: ConformallyHamiltonian, structure: PoissonStructure
) -> ConformallyHamiltonian:
    """The Hamiltonian form with rotors, beside the bracket that §7.4 prints."""
    bend = L - D * DET_J * (rho**2 * dot(L, gamma) - dot(gamma, A * k)) * gamma
    printed = PoissonStructure("bracket", lie_poisson(bend, gamma))
    return replace(
        law,
        as_printed=replace(law, structure=printed),
        misprint="the factors J_k⁻¹ and ρ³ are missing in the bracket",
    )


def hamiltonian_form(potential: sp.Expr, rotors: MatrixExpr = zero) -> System:
    """The Hamiltonian system on the bracket, for a potential U(γ) and rotors.

    Parameters
    ----------
    potential : sympy.Expr
        U in ``gamma_1``, ``gamma_2``, ``gamma_3``; unspecified functions are allowed.
    rotors : MatrixExpr
        Gyrostatic momentum: the vector ``k``, or zero.

    Returns
    -------
    System
        State L, γ; its time is τ.
    """
    hamiltonian = energy(rotors) + potential
    slope_L, slope_gamma = gradient(hamiltonian, L, "H"), gradient(hamiltonian, gamma, "H")
    structure = PoissonStructure(
        "bracket",
        lie_poisson(u, gamma),
        casimirs=(norm_squared(gamma), dot(L, gamma) / rho),
        rank=4,
        meaning="minus the bracket (7.6), so that dx/dτ = {x, H}",
        source="(7.6)" if rotors == zero else "§7.4",
    )
    # the paper has dx/dτ = {H, x} and this law dx/dτ = {x, H}: the bracket changes its sign
    form = ConformallyHamiltonian(
        "hamiltonian", sp.S.One, structure, hamiltonian, "Hamiltonian form", source="§7.2"
    )
    if rotors != zero:
        form = _with_misprint(replace(form, source="§7.4"), structure)
    return System(
        name="chaplygin-bracket" if rotors == zero else "chaplygin-bracket-gyrostat",
        title=TITLE if rotors == zero else ROTORS_TITLE,
        summary=SUMMARY if rotors == zero else ROTORS_SUMMARY,
        source=SOURCE if rotors == zero else "§7.4",
        parameters=PARAMETERS if rotors == zero else PARAMETERS + ROTORS,
        definitions={
            **TENSORS,
            rho: 1 / sp.sqrt(DET_IQ),
            u: twisted_bracket(rotors),
        },
        field={
            L: cross(u, slope_L) + cross(gamma, slope_gamma),
            gamma: cross(gamma, slope_L),
        },
        relations=(norm_squared(gamma) - 1,),
        laws=(
            Integral("energy", hamiltonian, "energy", source="(7.7)", unit="J"),
            Integral("area", dot(L, gamma) / rho, "area integral", source="(7.2)", unit="kg m^2/s"),
            structure,
            form,
        ),
    )


def with_numbers(system: System, p: Numbers) -> System:
    """The system with the given values as defaults, refused unless a ball can have them."""
    check_mass(p["m"])
    check_inertia((p["I_1"], p["I_2"], p["I_3"]))
    return replace(
        system,
        parameters=tuple(replace(item, default=p[str(item.symbol)]) for item in system.parameters),
    )


def general_system() -> System:
    """The ball in an arbitrary potential U(γ)."""
    return hamiltonian_form(sp.Function("U")(*gamma.symbols))


def unspecified_with_rotors() -> System:
    """The ball with rotors in an arbitrary potential U(γ)."""
    return hamiltonian_form(sp.Function("U")(*gamma.symbols), k)
