"""The Chaplygin ball and the Veselova system in four dimensions (§12, problem 3; [112–114]).

The angular velocity ω, body axes, is a skew matrix, and γ a unit vector fixed in space: γ̇ = −ω γ.
The inertia takes ω_ij to I_ij ω_ij.

A ball of radius R that rolls on a hyperplane with normal γ has the velocity R ω γ of its centre, so
that its momentum about the contact point,

    k = I ω + m R² (ω Γ + Γ ω),    Γ = γ γᵀ,    k̇ = [k, ω],

is constant in space.  With u = ω γ, ω = I⁻¹(k − m R² (u γᵀ − γ uᵀ)) gives a linear equation for u.

A body about a fixed point that turns in planes through γ alone, ω = u γᵀ − γ uᵀ with (u, γ) = 0,
has the momentum p = (I ω) γ, which is constant in space but for the direction γ:

    ṗ = −ω p = (u, p) γ,    γ̇ = −u.
"""

from __future__ import annotations

from itertools import combinations

import sympy as sp

from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import Parameter, System, Theorem
from flowlanes.system.vectors import real_symbol

from ...mechanics.rolling.body import check_mass
from ..catalogue_entry import Numbers, entry_with

PAIRS = tuple(combinations(range(4), 2))
gamma, u, p, f = (
    sp.Matrix([real_symbol(f"{name}_{i}") for i in range(1, 5)])
    for name in ["gamma", "u", "p", "f"]
)
m, R, Delta = (real_symbol(name) for name in ("m", "R", "Delta"))
HALF = sp.Rational(1, 2)
SOURCE = "§12, problem 3"
UNIT = (gamma.T * gamma)[0] - 1


def skew(name: str) -> sp.Matrix:
    """A skew matrix with the entries name_12, …, name_34 above its diagonal."""
    matrix = sp.zeros(4)
    for i, j in PAIRS:
        entry = real_symbol(f"{name}_{i + 1}{j + 1}")
        matrix[i, j], matrix[j, i] = entry, -entry
    return matrix


def upper_entries(matrix: sp.Matrix) -> dict[tuple[int, int], sp.Expr]:
    """The entries above the diagonal."""
    return {(i, j): matrix[i, j] for i, j in PAIRS}


def moment(i: int, j: int) -> sp.Symbol:
    """I_ij, in either order of the indices."""
    return real_symbol(f"I_{min(i, j) + 1}{max(i, j) + 1}")


k, omega = skew("k"), skew("omega")


def _inertia(numbers: Numbers) -> tuple[Parameter, ...]:
    symbols = [moment(i, j) for i, j in PAIRS]
    return tuple(
        Parameter(
            s,
            f"moment of inertia in the plane of body axes {s.name[-2]} and {s.name[-1]}",
            numbers[s.name],
            "kg m^2",
            (s > 0,),
        )
        for s in symbols
    )


def _solution(matrix: sp.Matrix, right: sp.Matrix) -> dict[sp.Symbol, sp.Expr]:
    """B and its determinant, f, and u with B u = f, as definitions."""
    entries = {(i, j): matrix[i, j] for i in range(4) for j in range(i, 4)}
    names = {(i, j): real_symbol(f"B_{i + 1}{j + 1}") for i, j in entries}
    named = sp.Matrix(4, 4, lambda i, j: names[min(i, j), max(i, j)])
    return {
        **{names[place]: value for place, value in entries.items()},
        Delta: sp.expand(named.det(method="berkowitz")),
        **dict(zip(f, right, strict=True)),
        **dict(zip(u, named.adjugate() * f / Delta, strict=True)),
    }


#: B is positive definite: of the ball E and Σ mR²/I_ij (u∧γ)_ij², of Veselova's body γγᵀ and an
#: inertia.
_POSITIVE = Theorem((), "the matrix B is positive definite", tuple, (Delta,))


# --- the ball ------------------------------------------------------------------------------

BALL = "Chaplygin ball in four dimensions"
BALL_SUMMARY = (
    "A balanced, dynamically asymmetric ball in four-dimensional space rolls on a hyperplane "
    "without slipping; it has an invariant measure, but too few integrals for the Euler–Jacobi "
    "theorem."
)


def ball(numbers: Numbers) -> System:
    """The equations reduced by the translations, in k and γ."""
    check_mass(numbers["m"])
    heavier = m * R**2
    matrix = sp.eye(4)
    for i, j in PAIRS:
        share = heavier / moment(i, j)
        matrix[i, i] += share * gamma[j] ** 2
        matrix[j, j] += share * gamma[i] ** 2
        matrix[i, j] = matrix[j, i] = -share * gamma[i] * gamma[j]
    free = sp.Matrix(4, 4, lambda i, j: k[i, j] / moment(i, j) if i != j else 0)
    turned = u * gamma.T - gamma * u.T
    spin = {omega[i, j]: (k[i, j] - heavier * turned[i, j]) / moment(i, j) for i, j in PAIRS}
    lever = k * gamma
    pfaffian = k[0, 1] * k[2, 3] - k[0, 2] * k[1, 3] + k[0, 3] * k[1, 2]
    rates = upper_entries(k * omega - omega * k)
    return System(
        name="chaplygin-ball-4d",
        title=BALL,
        summary=BALL_SUMMARY,
        source=SOURCE,
        parameters=(
            *_inertia(numbers),
            Parameter(m, "mass", numbers["m"], "kg", (m > 0,)),
            Parameter(R, "radius of the ball", numbers["R"], "m", (R > 0,)),
        ),
        definitions={**_solution(matrix, free * gamma), **spin},
        field={
            **{k[i, j]: rates[i, j] for i, j in PAIRS},
            **dict(zip(gamma, -omega * gamma, strict=True)),
        },
        relations=(UNIT,),
        laws=(
            Integral(
                "energy",
                HALF * sp.Add(*(k[i, j] * omega[i, j] for i, j in PAIRS)),
                "energy",
                source=SOURCE,
                unit="J",
            ),
            Integral(
                "square",
                sp.Add(*(s**2 for s in upper_entries(k).values())),
                "square of the momentum",
                source=SOURCE,
                unit="kg^2 m^4/s^2",
            ),
            Integral(
                "pfaffian",
                pfaffian,
                "Pfaffian of the momentum",
                source=SOURCE,
                unit="kg^2 m^4/s^2",
            ),
            Integral(
                "lever",
                (lever.T * lever)[0],
                "square of the momentum in planes through γ",
                source=SOURCE,
                unit="kg^2 m^4/s^2",
            ),
            Measure("measure", {Delta: -HALF}, "invariant measure", source=SOURCE),
        ),
        theorems=(_POSITIVE,),
    )


# --- the Veselova system -------------------------------------------------------------------

VESELOVA = "Veselova system in four dimensions"
VESELOVA_SUMMARY = (
    "A rigid body in four-dimensional space turns about a fixed point, only in planes that contain "
    "a direction fixed in space; it has an invariant measure, and the square of a momentum is an "
    "integral."
)


def veselova(numbers: Numbers) -> System:
    """The equations on the cotangent bundle of the three-dimensional sphere, in p and γ."""
    matrix = gamma * gamma.T
    for i, j in PAIRS:
        matrix[i, i] += moment(i, j) * gamma[j] ** 2
        matrix[j, j] += moment(i, j) * gamma[i] ** 2
        matrix[i, j] -= moment(i, j) * gamma[i] * gamma[j]
        matrix[j, i] = matrix[i, j]
    power = (u.T * p)[0]
    return System(
        name="veselova-4d",
        title=VESELOVA,
        summary=VESELOVA_SUMMARY,
        source=SOURCE,
        parameters=_inertia(numbers),
        definitions=_solution(matrix, p),
        field={
            **dict(zip(p, power * gamma, strict=True)),
            **dict(zip(gamma, -u, strict=True)),
        },
        relations=(UNIT, (p.T * gamma)[0]),
        laws=(
            Integral("energy", HALF * power, "energy", source=SOURCE, unit="J"),
            Integral(
                "momentum",
                (p.T * p)[0],
                "square of the momentum",
                source=SOURCE,
                unit="kg^2 m^4/s^2",
            ),
            Measure("measure", {Delta: -HALF}, "invariant measure", source=SOURCE),
        ),
        theorems=(_POSITIVE,),
    )


ENTRIES = (
    entry_with(
        name="chaplygin-ball-4d",
        build=ball,
    ),
    entry_with(
        name="veselova-4d",
        build=veselova,
    ),
)
