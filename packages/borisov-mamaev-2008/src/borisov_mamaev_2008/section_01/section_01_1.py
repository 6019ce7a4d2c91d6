"""§1.1: nonholonomic constraints and Ferrers' equations.

The computations use three coordinates and two constraints, with unspecified kinetic energy A(q),
constraints a(q), b(q), and forces Q(q, v). Each claim gives the argument that extends it to n
coordinates and m constraints.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import Symmetric, constant, cross, dot, real_symbol, vectors
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods import unspecified_systems
from ..methods.any_number import any_number

q, v, a_1, a_2, Q, slope, push, vdot = vectors("q v a_1 a_2 Q slope push vdot")
A, B = Symmetric("A"), Symmetric("B")
det = real_symbol("det")
b = (real_symbol("b_1"), real_symbol("b_2"))
multiplier = (real_symbol("lambda_1"), real_symbol("lambda_2"))
HALF = sp.Rational(1, 2)
CONSTRAINTS = (dot(a_1, v) + b[0], dot(a_2, v) + b[1])
NORMALS = (a_1, a_2)


def _unspecified_vector(name: str, *variables: sp.Symbol) -> sp.ImmutableDenseMatrix:
    """A vector with unspecified components."""
    return constant(
        unspecified_systems.unspecified_functions(
            " ".join(f"{name}{i}" for i in (1, 2, 3)), *variables
        )
    )


def _matrix(variables: Iterable[sp.Symbol]) -> sp.ImmutableDenseMatrix:
    """A symmetric matrix with unspecified entries."""
    arguments = tuple(variables)
    return constant(
        sp.Matrix(3, 3, lambda i, j: sp.Function(f"A_s{min(i, j)}{max(i, j)}")(*arguments))
    )


def _rate_along_velocity(formula: sp.Expr) -> sp.Expr:
    """Σ v_k ∂/∂q_k of a formula in q."""
    return sp.Add(*(w * sp.diff(formula, s) for s, w in zip(q, v, strict=True)))


MATRIX = _matrix(q)
SPEED = v.entries
#: Ȧ q̇ and ∂T/∂q for T = ½ (v, A(q) v).
DRIFT = constant(MATRIX.applyfunc(_rate_along_velocity) * SPEED)
SLOPE = constant([HALF * (SPEED.T * sp.diff(MATRIX, s) * SPEED)[0] for s in q])
ROWS = (_unspecified_vector("a_s1", *q), _unspecified_vector("a_s2", *q))
RESTS = unspecified_systems.unspecified_functions("b_s1 b_s2", *q)


@cache
def ferrers() -> System:
    """(1.3) solved for the accelerations, with arbitrary multipliers."""
    first, second = multiplier
    return unspecified_systems.system(
        "ferrers",
        "Ferrers' equations",
        {q: v, v: vdot},
        parameters=(
            Parameter(first, "first multiplier", 0.7),
            Parameter(second, "second multiplier", -0.4),
        ),
        definitions={
            A: MATRIX,
            **dict(zip(NORMALS, ROWS, strict=True)),
            **dict(zip(b, RESTS, strict=True)),
            Q: _unspecified_vector("Q_s", *q, *v),
            slope: SLOPE,
            push: Q + slope - DRIFT,
            det: A.entries.det(),
            B: constant(A.entries.adjugate() / det),
            vdot: B * (push + first * a_1 + second * a_2),
        },
    )


@cache
def constrained() -> System:
    """`ferrers` with the multipliers that solve (1.5)."""
    free = ferrers()
    (one, mixed), (_, two) = _gram()
    right = [_right(i) for i in (0, 1)]
    area = one * two - mixed**2
    *before, last = free.definitions
    return replace(
        free,
        parameters=(),
        definitions=(
            *before,
            (multiplier[0], (two * right[0] - mixed * right[1]) / area),
            (multiplier[1], (one * right[1] - mixed * right[0]) / area),
            last,
        ),
    )


def _gram() -> list[list[sp.Expr]]:
    """The matrix (∂f_μ/∂q̇, A⁻¹ ∂f_ν/∂q̇) of (1.5)."""
    return [[dot(first, B * second) for second in NORMALS] for first in NORMALS]


def _partial(index: int) -> sp.Expr:
    """(q̇, ∂f_μ/∂q)."""
    return _rate_along_velocity((ROWS[index].T * SPEED)[0] + RESTS[index])


def _right(index: int) -> sp.Expr:
    """The right side of (1.5)."""
    return dot(B * NORMALS[index], DRIFT - slope - Q) - _partial(index)


# --- the claims ----------------------------------------------------------------------------


def virtual_work() -> Case:
    """The reactions of (1.3) do no work on the virtual displacement a₁×a₂."""
    balance = rate(A * v) - slope - Q
    return ferrers(), Identity("virtual_work", dot(balance, cross(a_1, a_2)))


def kinetic_energy_degree_printed() -> Case:
    """T is homogeneous of degree two, with A(q̇)."""
    return _degree(_matrix(v))


def kinetic_energy_degree() -> Case:
    """T is homogeneous of degree two, with A(q)."""
    return _degree(MATRIX)


def _degree(matrix: sp.ImmutableDenseMatrix) -> Case:
    energy = HALF * (SPEED.T * matrix * SPEED)[0]
    euler = sp.Add(*(s * sp.diff(energy, s) for s in v)) - 2 * energy
    return ferrers(), Identity("degree", euler)


def multipliers() -> Case:
    """The rate of f_μ is left minus right side of (1.5), for all values of the multipliers."""
    first, second = multiplier
    residuals = (
        Rate(constraint) - row[0] * first - row[1] * second + _right(i)
        for i, (constraint, row) in enumerate(zip(CONSTRAINTS, _gram(), strict=True))
    )
    return ferrers(), Identity("multipliers", tuple(residuals))


def unique() -> Case:
    """det (∂f_μ/∂q̇, A⁻¹ ∂f_ν/∂q̇) = (n, A n)/det A with n = a₁×a₂."""
    (one, mixed), (_, two) = _gram()
    across = cross(a_1, a_2)
    value = one * two - mixed**2 - dot(across, A * across) / det
    return ferrers(), Identity("determinant", value)


def invariant() -> Case:
    """The closed system preserves f_μ."""
    return constrained(), Identity("invariant", tuple(Rate(f) for f in CONSTRAINTS))


def differentiated() -> Case:
    """Remark 1, with the accelerations of the closed system."""
    residuals = (_partial(i) + dot(normal, vdot) for i, normal in enumerate(NORMALS))
    return constrained(), Identity("differentiated", tuple(residuals))


def lagrange() -> Case:
    """Check that Lagrange's equations (1.6) follow from (1.3) with Q = −∂U/∂q."""
    potential = sp.Function("U")(*q.symbols)
    force = -gradient(potential, q)
    energy = HALF * (SPEED.T * MATRIX * SPEED)[0] - potential
    momentum = constant([sp.diff(energy, s) for s in v])
    left = rate(momentum) - constant([sp.diff(energy, s) for s in q])
    right = rate(A * v) - slope - force
    return ferrers(), Identity("lagrange", left - right)


#: ḟ_μ for n coordinates and m constraints, with the accelerations of (1.3).
RATE_OF_CONSTRAINT = (
    r"for any number of coordinates and constraints: with $\ddot{\mathbf q} = \mathbf A^{-1}"
    r"(\mathbf p + \sum_\nu\lambda_\nu\mathbf a_\nu)$, $\mathbf p = \mathbf Q + \partial T/"
    r"\partial\mathbf q - \dot{\mathbf A}\dot{\mathbf q}$, the rate of $f_\mu$ is $\sum_\nu"
    r"(\mathbf a_\mu, \mathbf A^{-1}\mathbf a_\nu)\lambda_\nu + (\mathbf A^{-1}\mathbf a_\mu, "
    r"\mathbf p) + (\dot{\mathbf q}, \partial f_\mu/\partial\mathbf q)$, since $\mathbf A$ is "
    "symmetric"
)
#: Conditions under which (1.5) has a unique solution.
REGULAR = ("the constraints are independent and T is positive definite",)

CLAIMS = (
    Claim(
        "(1.3)",
        r"$\frac{d}{dt}\left(\frac{\partial T}{\partial\dot{\mathbf q}}\right)-\frac{\partial T}"
        r"{\partial\mathbf q}=\mathbf Q+\sum_\mu\lambda_\mu\frac{\partial f_\mu}{\partial\dot"
        r"{\mathbf q}}$: the reactions do no work on displacements that the constraints allow",
        virtual_work,
        note="read as d'Alembert's principle, with T, Q and the constraints unspecified",
        argument="for any number of coordinates and constraints: the work on a displacement δq is "
        "Σ λ_μ (∂f_μ/∂q̇, δq), and each term is zero for a δq that the constraints allow",
    ),
    Claim(
        "§1.1, after (1.3)",
        r"the undetermined multipliers $\lambda_\mu$ can be uniquely found from the constraint "
        "conditions (1.2)",
        unique,
        note="the determinant of the linear system (1.5) is (n, An)/det A with n = a₁×a₂; "
        "for two equal constraints it is zero",
        argument="for any number of coordinates and constraints the matrix of (1.5) is the Gram "
        "matrix of the vectors ∂f_μ/∂q̇ in the metric A⁻¹, which is positive definite",
        where=REGULAR,
    ),
    Claim(
        "(1.4)",
        r"the kinetic energy $T=\frac12(\dot{\mathbf q},\mathbf A(\mathbf q)\dot{\mathbf q})$ is a "
        r"homogeneous quadratic form of generalized velocities, where $\mathbf A(\dot{\mathbf q})$ "
        "is a symmetric matrix",
        kinetic_energy_degree_printed,
        kinetic_energy_degree,
        r"where $\mathbf A(\mathbf q)$ is a symmetric matrix",
        "A must not depend on the velocities: otherwise T is not a quadratic form (Euler's "
        "identity fails)",
        argument=any_number(2),
    ),
    Claim(
        "(1.5)",
        r"$\sum_\nu\left(\frac{\partial f_\mu}{\partial\dot{\mathbf q}},\mathbf A^{-1}\frac{"
        r"\partial f_\nu}{\partial\dot{\mathbf q}}\right)\lambda_\nu=\left(\mathbf A^{-1}\frac{"
        r"\partial f_\mu}{\partial\dot{\mathbf q}},\dot{\mathbf A}\dot{\mathbf q}-\frac{\partial T}"
        r"{\partial\mathbf q}-\mathbf Q\right)-\left(\dot{\mathbf q},\frac{\partial f_\mu}"
        r"{\partial\mathbf q}\right)$",
        multipliers,
        note="for all unspecified A(q), a(q), b(q), Q(q, q̇): the difference of both sides is the "
        "rate of f_μ",
        argument=RATE_OF_CONSTRAINT,
    ),
    Claim(
        "§1.1, after (1.5)",
        "substituting these multipliers in Eqs. (1.3), we obtain a closed system; moreover, "
        "Eqs. (1.2) define an invariant variety of this system",
        invariant,
        note="with all functions unspecified; every level of f_μ is invariant",
        argument=RATE_OF_CONSTRAINT,
        where=REGULAR,
    ),
    Claim(
        "Remark 1",
        r"$\left(\frac{\partial f_\mu}{\partial\mathbf q},\dot{\mathbf q}\right)+\left(\frac{"
        r"\partial f_\mu}{\partial\dot{\mathbf q}},\ddot{\mathbf q}\right)=0$, and (1.5) follows "
        r"with the accelerations $\ddot{\mathbf q}$ from Eqs. (1.3)",
        differentiated,
        argument=RATE_OF_CONSTRAINT,
    ),
    Claim(
        "(1.6)",
        r"if the forces are potential, Eqs. (1.3) can be represented in the form $\left(\frac{"
        r"\partial L}{\partial\dot{\mathbf q}}\right)'-\frac{\partial L}{\partial\mathbf q}="
        r"\sum_\mu\lambda_\mu\frac{\partial f_\mu}{\partial\dot{\mathbf q}}$, $L=T-U$",
        lagrange,
        argument=any_number(3),
    ),
)

REMARKS = (
    Remark(
        "(1.1), (1.2)",
        r"$f_\mu(\mathbf q,\dot{\mathbf q},t)=0$, $\mu=1,\dots,m<n$; $f_\mu=\sum_k a_{\mu k}"
        r"(\mathbf q)\dot q_k+b_\mu(\mathbf q)=0$",
        "definitions; (1.2) is used in the proofs of (1.3)–(1.6)",
    ),
    Remark(
        "§1.1, after (1.1)",
        "nonholonomic constraints cannot be represented in the integral form "
        r"$F_\mu(\mathbf q,t)=0$",
        "a definition; the criterion is decided in §2.1",
    ),
    Remark(
        "§1.1",
        "Ferrers (1872), Appell and Hamel, the other forms of the equations and how often they are "
        "used; Remark 2 on Chaplygin and Voronets",
        "history and opinion",
    ),
    Remark(
        "§1.1, after (1.2)",
        "Exactly these constraints are realized in substantial problems.",
        "judgement",
    ),
)
