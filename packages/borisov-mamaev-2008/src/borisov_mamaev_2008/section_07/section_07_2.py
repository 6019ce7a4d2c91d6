"""§7.2: the conformally Hamiltonian representation of the Chaplygin ball."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Integral, PoissonStructure
from flowlanes.system.system import System
from flowlanes.system.vectors import Components, constant, cross, dot, to_components, vectors
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball import DENSITY, general_system
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_unreduced import orientation
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import (
    DET_J,
    A,
    D,
    J,
    L,
    gamma,
    hamiltonian_form,
)
from nonholonomic.catalogue.e3 import lie_poisson
from nonholonomic.catalogue.vector_rates import rate
from nonholonomic.mechanics.rolling.attitude import attitude, quaternion_rate, rotation, unit_length

from ..claim import Case, Claim, Remark
from ..methods.independence import independent, rational_point
from .section_07_1 import MOVED, free_ball

M, omega, alpha, beta = vectors("M omega alpha beta")
J_1, J_2, J_3 = J.symbols
g1, g2, g3 = gamma.symbols
U = sp.Function("U")(*gamma.symbols)
VARIABLES = (*L, *gamma)

#: (7.7).
ENERGY = (
    DET_J / 2 * ((1 - D * dot(gamma, A * gamma)) * dot(L, A * L) + D * dot(A * L, gamma) ** 2) + U
)
#: (7.6): u with {L_i, L_j} = ε_ijk u_k.
TWISTED = L - D * dot(L, gamma) * DENSITY**2 * constant(
    [J_2 * J_3 * g1, J_3 * J_1 * g2, J_1 * J_2 * g3]
)


def printed_bracket() -> Components:
    """The matrix {x_i, x_j} of (7.6) for x = (L, γ)."""
    return Components(-lie_poisson(TWISTED, gamma))


def hamilton(value: sp.Basic) -> Components:
    """{H, f} by (7.6) and (7.7) for the components f of a vector in L and γ."""
    slope = sp.Matrix([sp.diff(to_components(ENERGY), s) for s in VARIABLES])
    jacobian = sp.Matrix(to_components(value)).jacobian(VARIABLES)
    return Components(jacobian * sp.Matrix(to_components(printed_bracket())).T * slope)


@cache
def ball() -> System:
    """The rolling ball in an unspecified potential, with L = ρM."""
    system = general_system()
    return replace(system, definitions=(*system.definitions, (L, DENSITY * M)), laws=())


def kinematics() -> Case:
    """The rates of α and β, the first rows of the rotation matrix from body to space axes."""
    dynamics = free_ball()
    system = replace(
        dynamics,
        field=(*dynamics.field, (attitude, quaternion_rate(omega))),
        relations=(*dynamics.relations, unit_length()),
        reconstruction=None,
    )
    first, second = (sp.ImmutableDenseMatrix(rotation()[i, :].T) for i in range(2))
    return system, Identity(
        "axes", (rate(first) - cross(first, omega), rate(second) - cross(second, omega))
    )


def _orientation_brackets(potential: sp.Expr) -> Case:
    system = orientation(potential)
    return tuple(
        (system, Integral(name, dot(M, axis))) for name, axis in (("x", alpha), ("y", beta))
    )


def along_in_a_field() -> Case:
    """(M, α), (M, β) along (7.1)."""
    return _orientation_brackets(U)


def along_without_field() -> Case:
    """(M, α), (M, β) without a field."""
    return _orientation_brackets(sp.S.Zero)


def superintegrable() -> Case:
    """Six conditions on α, β, γ and four integrals are independent in twelve variables."""
    system = orientation(sp.S.Zero)
    axes = (alpha, beta, gamma)
    conditions = [dot(a, b) for i, a in enumerate(axes) for b in axes[i:]]
    integrals = [dot(M, omega), *(dot(M, axis) for axis in axes)]
    third, unit = sp.Rational(1, 3), sp.eye(3)
    frame = 2 * third * sp.ones(3, 3) - unit
    values = dict(zip(system.symbols, (3, -1, 2, *frame), strict=True))
    point = rational_point(system, {str(s): value for s, value in values.items()})
    return independent(system, conditions + integrals, point)


def poisson() -> Case:
    """(7.6) is a Poisson bracket."""
    system = hamiltonian_form(U)
    return system, PoissonStructure("bracket", printed_bracket())


def energy() -> Case:
    """(7.7)."""
    return ball(), Identity("energy", dot(M, omega) / 2 + U - ENERGY)


def hamilton_equations(momentum: MatrixExpr) -> Identity:
    """Left minus right sides of Hamilton's equations."""
    return Identity(
        "hamilton",
        (
            rate(momentum) / DENSITY - hamilton(momentum.xreplace({M: L / DENSITY})),
            rate(gamma) / DENSITY - hamilton(gamma),
        ),
    )


def equations() -> Case:
    """Hamilton's equations along (7.1), for M and γ as printed, and for L."""
    system = ball()
    return (system, hamilton_equations(M)), (system, hamilton_equations(L))


CLAIMS = (
    Claim(
        "§7.2, first display",
        r"$\dot{\alpha} = \alpha \times \omega$, $\dot{\beta} = \beta \times \omega$",
        kinematics,
        note="α, β are the first rows of the rotation from body to space",
    ),
    Claim(
        "§7.2, second display",
        r"(7.1) with the equations for α, β admits two additional integrals linear in velocities, "
        r"$(M, \alpha) = $ const, $(M, \beta) = $ const.",
        along_in_a_field,
        along_without_field,
        r"For $U = 0$, (7.1) with the equations for α, β admits the integrals "
        r"$(M, \alpha) = $ const, $(M, \beta) = $ const.",
        "U = 0 is needed; the next sentences alone say it",
    ),
    Claim(
        "§7.2, superintegrable",
        "With U = 0 the integral manifolds of the extended system are two-dimensional: three "
        "degrees of freedom, two-dimensional tori.",
        superintegrable,
    ),
    Claim(
        "(7.5) and Hamilton's equations",
        r"With $\rho_\mu dt = d\tau$, $L = \rho_\mu M$ the equations of motion (6.1) take the "
        r"Hamiltonian form $\frac{dM_k}{d\tau} = \{H, M_k\}$, "
        r"$\frac{d\gamma_k}{d\tau} = \{H, \gamma_k\}$ with (7.6) and (7.7), for an arbitrary "
        "potential.",
        equations,
        note="for M_k as printed and for L_k, as any function of L and γ obeys the same equation; "
        "the order {H, x} of the bracket is opposite to that of (3.5) and Theorem 9",
        erratum=MOVED,
    ),
    Claim(
        "(7.6)",
        r"$\{L_i, L_j\} = \varepsilon_{ijk} (L_k - D(L, \gamma) \rho_\mu^2 J_i J_j \gamma_k)$, "
        r"$\{L_i, \gamma_j\} = \varepsilon_{ijk} \gamma_k$, $\{\gamma_i, \gamma_j\} = 0$ is a "
        "Poisson bracket.",
        poisson,
    ),
    Claim(
        "(7.7)",
        r"The energy is $H = \frac{\det J}{2} ((1 - D(\gamma, J^{-1} \gamma)) (L, J^{-1} L) + "
        r"D(J^{-1} L, \gamma)^2) + U(\gamma)$.",
        energy,
    ),
)

REMARKS = (
    Remark(
        "§7.2",
        "The Chaplygin ball is a nonholonomic analogue of the Euler–Poinsot top.",
        "a comparison; the dimension of the tori is computed above",
    ),
)
