"""§4.3: Theorem 6 on generalised Chaplygin systems, its proof and its brackets."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, PoissonStructure, Rate, Reduction
from flowlanes.system.system import Guard, System
from nonholonomic.catalogue.chaplygin_ball import generalised_chaplygin as chaplygin
from nonholonomic.catalogue.chaplygin_ball.generalised_chaplygin import P_1, P_2, S, q_1, q_2

from ..claim import Case, Claim
from ..methods.catalogue_laws import laws_named
from ..methods.unspecified_systems import hamiltonian, system, unspecified_functions

q, P = (q_1, q_2), (P_1, P_2)
v = sp.symbols("v_1:3", real=True)
p = sp.symbols("p_1:3", real=True)
HALF = sp.Rational(1, 2)
A = unspecified_functions("A1 A2", *q)
B, N, rho = unspecified_functions("B N rho", *q)
LINEAR = A[0] * P_1 + A[1] * P_2 + B


def _any_linear() -> System:
    """(4.7) with a quadratic Lagrangian and S = A₁P₁ + A₂P₂ + B, all unspecified."""
    return chaplygin.form("linear", "(4.7)", chaplygin.quadratic_hamiltonian(), LINEAR)


def _density() -> System:
    """(4.7) with the measure ρ(q) dP dq."""
    return chaplygin.general()


# --- Legendre transformation ---------------------------------------------------------------


def _lagrangian() -> tuple[System, dict[sp.Symbol, sp.Expr], sp.Expr]:
    """(4.4) with L = ½(q̇, m q̇) + (l, q̇) − U and S = a₁q̇₁ + a₂q̇₂ + b, solved for q̈.

    The inverse of m, and l, U, a and b, are unspecified. Also returns the momenta and S.
    """
    names = ("m11", "m12", "m22", "l1", "l2", "U", "a1", "a2", "b")
    part = dict(zip(names, unspecified_functions(" ".join(names), *q), strict=True))
    inverse = sp.Matrix([[part["m11"], part["m12"]], [part["m12"], part["m22"]]])
    mass = inverse.adjugate() / inverse.det()
    velocity = sp.Matrix(v)
    offset = sp.Matrix([part["l1"], part["l2"]])
    kinetic = HALF * (velocity.T * mass * velocity)[0, 0]
    L = kinetic + (offset.T * velocity)[0, 0] - part["U"]
    momenta = mass * velocity + offset
    turning = part["a1"] * v[0] + part["a2"] * v[1] + part["b"]
    other = (v[1] * turning, -v[0] * turning)
    known = [
        sp.diff(L, q[i]) + other[i] - sp.Add(*(v[k] * sp.diff(momenta[i], q[k]) for k in (0, 1)))
        for i in (0, 1)
    ]
    accelerations = inverse * sp.Matrix(known)
    dynamics = system("lagrangian", "(4.4)", dict(zip((*q, *v), (*v, *accelerations), strict=True)))
    return dynamics, dict(zip(P, momenta, strict=True)), turning


def legendre() -> Case:
    """(4.7) from (4.4), with H the Legendre transform of L."""
    dynamics, momenta, turning = _lagrangian()
    H = chaplygin.quadratic_hamiltonian()
    by_q1, by_q2, by_P1, by_P2 = (sp.diff(H, s) for s in (*q, *P))
    equations = (
        Rate(q_1) - by_P1,
        Rate(q_2) - by_P2,
        Rate(P_1) + by_q1 - by_P2 * turning,
        Rate(P_2) + by_q2 + by_P1 * turning,
    )
    return dynamics, Reduction("legendre", momenta, equations)


def coefficients_of_s() -> Case:
    """The coefficients of (4.7): A_i = Σ_j a_j (m⁻¹)_ji, B = b − (A, l)."""
    dynamics, momenta, turning = _lagrangian()
    a_1, a_2, m11, m12, m22, l1, l2, b = unspecified_functions("a1 a2 m11 m12 m22 l1 l2 b", *q)
    first, second = a_1 * m11 + a_2 * m12, a_1 * m12 + a_2 * m22
    remainder = b - first * l1 - second * l2
    value = turning - first * P_1 - second * P_2 - remainder
    return dynamics, Identity("linear", value, quantities=momenta)


# --- Liouville equation --------------------------------------------------------------------


def _divergence(dynamics: System) -> sp.Expr:
    """div(ρv)/ρ of (4.7), written out."""
    gyroscopic = dict(dynamics.scalar_definitions)
    rates = [rate.xreplace(gyroscopic) for rate in dynamics.rates]
    states = (*q, *P)
    return sp.Add(*(sp.diff(rho * r, s) for r, s in zip(rates, states, strict=True))) / rho


def _brackets() -> tuple[sp.Expr, sp.Expr]:
    """The two brackets of the Liouville equation."""
    return sp.diff(rho, q_1) / rho - A[1], sp.diff(rho, q_2) / rho + A[0]


def liouville() -> Case:
    """div(ρv)/ρ = q̇₁(…) + q̇₂(…)."""
    dynamics = _any_linear()
    first, second = _brackets()
    value = Rate(q_1) * first + Rate(q_2) * second
    return dynamics, Identity("liouville", _divergence(dynamics) - value)


def brackets_vanish() -> Case:
    """The brackets are linear combinations of the derivatives of div(ρv)/ρ by P₁ and P₂.

    With D = div(ρv)/ρ, ∂D/∂P_i = Σ_j (m⁻¹)_ij (…)_j, and m⁻¹ is non-degenerate.
    """
    dynamics = _any_linear()
    by_P1, by_P2 = (sp.diff(_divergence(dynamics), s) for s in P)
    m11, m12, m22 = unspecified_functions("m11 m12 m22", *q)
    determinant = m11 * m22 - m12**2
    first, second = _brackets()
    return dynamics, Identity(
        "independent",
        (
            first - (m22 * by_P1 - m12 * by_P2) / determinant,
            second - (m11 * by_P2 - m12 * by_P1) / determinant,
        ),
    )


# --- Theorem 6 -----------------------------------------------------------------------------


def _bar(multiplier: sp.Expr, gyroscopic: sp.Expr) -> sp.Expr:
    """S̄ of (4.5), with ∂L̄/∂q′_i = N P_i."""
    slopes = (sp.diff(multiplier, s) for s in q)
    by_q1, by_q2 = slopes
    return multiplier * gyroscopic + by_q2 * P_1 - by_q1 * P_2


def _momenta_form(remainder: sp.Expr) -> Case:
    by_q1, by_q2 = (sp.diff(N, s) for s in q)
    value = (N * A[0] + by_q2) * P_1 + (N * A[1] - by_q1) * P_2 + remainder
    return _any_linear(), Identity("S_bar", _bar(N, S) - value)


def in_momenta_printed() -> Case:
    """With B(q) as the last term."""
    return _momenta_form(B)


def in_momenta_corrected() -> Case:
    """With N(q) B(q) as the last term."""
    return _momenta_form(N * B)


def bar_printed() -> Case:
    """S̄ = B for N = ρ."""
    return _density(), Identity("S_bar", _bar(rho, S) - B)


def bar_corrected() -> Case:
    """S̄ = ρB for N = ρ."""
    return _density(), Identity("S_bar", _bar(rho, S) - rho * B)


def _target() -> tuple[System, PoissonStructure]:
    """The Hamiltonian system with the bracket (4.6), S̄ = ρB and H̄(q, p) = H(q, p/ρ)."""
    H = chaplygin.quadratic_hamiltonian().xreplace({P_1: p[0] / rho, P_2: p[1] / rho})
    matrix = _magnetic(rho * B)
    dynamics = hamiltonian(matrix, H, (*q, *p))
    return dynamics, PoissonStructure("bracket", matrix, rank=4)


def _magnetic(turn: sp.Expr) -> sp.Matrix:
    """(4.6) in the order q₁, q₂, p₁, p₂."""
    corner = sp.Matrix([[0, turn], [-turn, 0]])
    top = sp.zeros(2).row_join(sp.eye(2))
    return top.col_join((-sp.eye(2)).row_join(corner))


def theorem_6() -> Case:
    """Both statements: S̄ = ρB depends only on q, and N = ρ leads to (4.6)."""
    target, structure = _target()
    map_ = {q_1: q_1, q_2: q_2, p[0]: rho * P_1, p[1]: rho * P_2}
    dynamics = _density()
    forward = replace(
        dynamics, guards=(Guard("density", rho, "the density of the measure vanishes"),)
    )
    return (
        (dynamics, Identity("S_bar", _bar(rho, S) - rho * B)),
        (forward, Isomorphism("new_time", target, map_, time=rho)),
        (target, structure),
    )


def bracket_4_6() -> Case:
    """(4.6) with any S̄(q)."""
    (turn,) = unspecified_functions("Sbar", *q)
    dynamics = hamiltonian(_magnetic(turn), unspecified_functions("H", *q, *p)[0], (*q, *p))
    return dynamics, PoissonStructure("bracket", _magnetic(turn), rank=4)


def in_the_old_time() -> Case:
    """N = ρ in the variables q, P and the time t."""
    return laws_named(_density(), "bracket", "form")


def ordinary() -> Case:
    """Without linear terms in L and without b, S̄ = 0 for N = ρ."""
    flat = (sp.diff(rho, q_1) * P_2 - sp.diff(rho, q_2) * P_1) / rho
    m11, m12, m22, U = unspecified_functions("m11 m12 m22 U", *q)
    H = HALF * (m11 * P_1**2 + m22 * P_2**2) + m12 * P_1 * P_2 + U
    dynamics = chaplygin.form("ordinary", "an ordinary Chaplygin system", H, flat)
    return dynamics, Identity("S_bar", _bar(rho, S))


CLAIMS = (
    Claim(
        "§4.3, ordinary Chaplygin systems with a measure",
        "For an ordinary Chaplygin system it is established that if there exists an invariant "
        "measure whose density is a function of coordinates only, one can choose "
        r"$\mathcal{N}(\mathbf{q})$ so that $\bar S = 0$",
        ordinary,
        where=("the kinetic energy is a homogeneous quadratic form",),
    ),
    Claim(
        "Theorem 6",
        r"If $\det\|\partial^2 L/\partial\dot q_i\partial\dot q_j\| \ne 0$ and (4.4) preserves a "
        "measure whose density depends only on coordinates, there is a change of time "
        r"$\mathcal{N}(\mathbf{q})\,dt = d\tau$ such that 1) $\bar S = \bar S(\mathbf{q})$; 2) "
        r"$\frac{dq_i}{d\tau} = \{q_i, \bar H\}$, $\frac{dp_i}{d\tau} = \{p_i, \bar H\}$ with the "
        r"bracket (4.6), $p_i = \partial\bar L/\partial q'_i$",
        theorem_6,
        note="for Lagrangians quadratic in the velocities, as assumed before the theorem; the "
        "density is that of dP₁ dP₂ dq₁ dq₂",
    ),
    Claim(
        "(4.6)",
        r"$\{q_i, p_j\} = \delta_{ij}$, $\{p_1, p_2\} = \bar S(\mathbf{q})$, $\{q_1, q_2\} = 0$ is "
        "a Poisson bracket",
        bracket_4_6,
    ),
    Claim(
        "(4.7)",
        r"$\dot q_i = \frac{\partial H}{\partial P_i}$, $\dot P_1 = -\frac{\partial H}"
        r"{\partial q_1} + \frac{\partial H}{\partial P_2}S$, $\dot P_2 = -\frac{\partial H}"
        r"{\partial q_2} - \frac{\partial H}{\partial P_1}S$",
        legendre,
        note="from (4.4), with unspecified coefficients",
    ),
    Claim(
        "(4.7), S",
        r"$S = a_1\dot q_1 + a_2\dot q_2 + b = A_1(\mathbf{q})P_1 + A_2(\mathbf{q})P_2 + "
        r"B(\mathbf{q})$",
        coefficients_of_s,
        note="A = m⁻¹a, B = b − (A, l)",
    ),
    Claim(
        "Theorem 6, Liouville's equation",
        r"$\dot q_1\left(\frac{1}{\rho}\frac{\partial\rho}{\partial q_1} - A_2\right) + "
        r"\dot q_2\left(\frac{1}{\rho}\frac{\partial\rho}{\partial q_2} + A_1\right) = 0$",
        liouville,
        note="the left side is div(ρv)/ρ for any ρ(q)",
    ),
    Claim(
        "Theorem 6, each bracket",
        r"Since $\rho$ is a function of coordinates only, each bracket must independently vanish",
        brackets_vanish,
    ),
    Claim(
        "Theorem 6, S̄ in the momenta",
        r"$\bar S = \left(\mathcal{N}A_1 + \frac{\partial\mathcal{N}}{\partial q_2}\right)P_1 + "
        r"\left(\mathcal{N}A_2 - \frac{\partial\mathcal{N}}{\partial q_1}\right)P_2 + B(q)$",
        in_momenta_printed,
        in_momenta_corrected,
        r"the last term is $\mathcal{N}(q)B(q)$",
        "the factor N of the last term is missing",
    ),
    Claim(
        "Theorem 6, S̄ for N = ρ",
        r"If we put $\mathcal{N}(\mathbf{q}) = \rho(\mathbf{q})$, then $\bar S = B(\mathbf{q})$",
        bar_printed,
        bar_corrected,
        r"$\bar S = \rho(\mathbf{q})B(\mathbf{q})$",
        "the factor N = ρ is missing, as in the preceding formula",
    ),
    Claim(
        "§4.3, original time",
        r"Hence in the original time $t$ generalized measure-preserving Chaplygin systems are "
        "conformally Hamiltonian",
        in_the_old_time,
        note="by Theorem 6",
        where=("the density of the measure depends on the coordinates alone",),
    ),
)
