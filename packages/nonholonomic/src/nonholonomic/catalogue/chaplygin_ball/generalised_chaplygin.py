"""Generalised Chaplygin systems with two degrees of freedom (§4.3, (4.4)–(4.7)).

In the momenta P_i = ∂L/∂q̇_i and with H(q, P) the equations (4.4) are

    q̇_i = ∂H/∂P_i,   Ṗ₁ = −∂H/∂q₁ + ∂H/∂P₂ S,   Ṗ₂ = −∂H/∂q₂ − ∂H/∂P₁ S,

and for a Lagrangian that is quadratic in the velocities S = A₁(q) P₁ + A₂(q) P₂ + B(q).
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral, Law
from flowlanes.system.system import Observable, Parameter, System

from ...mechanics.reduction.reduced_system import N, theorem_6

q_1, q_2, P_1, P_2, S = sp.symbols("q_1 q_2 P_1 P_2 S", real=True)
STATE = (q_1, q_2, P_1, P_2)
HALF = sp.Rational(1, 2)

TITLE = "Generalised Chaplygin system"
SUMMARY = (
    "A point of the plane in a quadratic potential under a gyroscopic force that is linear in the "
    "velocity: a generalised Chaplygin system with an invariant measure."
)
SOURCE = "§4.3, (4.4)–(4.7)"


def form(
    name: str,
    title: str,
    hamiltonian: sp.Expr,
    gyroscopic: sp.Expr,
    parameters: tuple[Parameter, ...] = (),
    *,
    multiplier: sp.Expr | None = None,
    on: tuple[sp.Expr, ...] = (),
    laws: tuple[Law, ...] = (),
    source: str = "",
    summary: str = "",
    unit: str = "",
) -> System:
    """The equations (4.7).

    Parameters
    ----------
    name, title, source, summary : str
    hamiltonian : sympy.Expr
        H, in q_1, q_2, P_1, P_2.
    gyroscopic : sympy.Expr
        S, in the same variables.
    parameters : tuple of Parameter
    multiplier : sympy.Expr, optional
        N(q), the density of an invariant measure; it becomes the definition `N`.
    on : tuple of sympy.Expr
        Level on which Theorem 6 holds.
    laws : tuple of Law
        Laws besides the conservation of energy and, with a multiplier, Theorem 6.
    unit : str
        SI unit of H.
    """
    by_q1, by_q2, by_P1, by_P2 = (sp.diff(hamiltonian, s) for s in STATE)
    return System(
        name=name,
        title=title,
        source=source,
        summary=summary,
        parameters=parameters,
        definitions={**({} if multiplier is None else {N: multiplier}), S: gyroscopic},
        field={q_1: by_P1, q_2: by_P2, P_1: -by_q1 + by_P2 * S, P_2: -by_q2 - by_P1 * S},
        laws=(
            Integral("energy", hamiltonian, "energy", source="Theorem 1", unit=unit),
            *(() if multiplier is None else theorem_6(hamiltonian, on=on)),
            *laws,
        ),
        observables=(Observable("gyroscopic", S, "coefficient S of the gyroscopic forces"),),
    )


def quadratic_hamiltonian() -> sp.Expr:
    """H of any Lagrangian ½(q̇, m q̇) + (l, q̇) − U, with the inverse of m and l, U unspecified."""
    of_q = {name: sp.Function(name)(q_1, q_2) for name in ("m11", "m12", "m22", "l1", "l2", "U")}
    first, second = P_1 - of_q["l1"], P_2 - of_q["l2"]
    square = of_q["m11"] * first**2 + of_q["m22"] * second**2
    return HALF * square + of_q["m12"] * first * second + of_q["U"]


def general() -> System:
    """Every such system that preserves a measure ρ(q) dP₁ dP₂ dq₁ dq₂, for any ρ(q) and B(q)."""
    rho, B = (sp.Function(name)(q_1, q_2) for name in ("rho", "B"))
    H = quadratic_hamiltonian()
    return form(
        "generalised-chaplygin",
        TITLE,
        H,
        (sp.diff(rho, q_1) * P_2 - sp.diff(rho, q_2) * P_1) / rho + B,
        multiplier=rho,
        source=SOURCE,
        summary=SUMMARY,
    )
