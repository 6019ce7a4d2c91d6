"""§1.2: the Poincaré–Suslov equations.

The computations use three coordinates, an unspecified frame G(q), an unspecified Lagrangian L(q,
q̇) and an unspecified constraint f(q, q̇); the motion is arbitrary: q̇ = G w, ẇ = s with any s.

(1.9) for n coordinates: with v = G w, L̂(q, w) = L(q, G w) and L_a = ∂L/∂q̇_a,

    d/dt ∂L̂/∂w_i − E_i(L̂) = Σ_a G_ai (d/dt L_a − ∂L/∂q_a) + Σ_a L_a Σ_j w_j [E_j, E_i]_a,

since G_ai has the rate Σ_j w_j E_j(G_ai) and E_i(L̂) contains Σ_aj L_a E_i(G_aj) w_j. The last sum
is Σ_jk c_ji^k w_j ∂L̂/∂w_k, by (1.8) and Σ_a G_ak L_a = ∂L̂/∂w_k.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import product

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import constant, real_symbol, vectors

from ..claim import Case, Claim, Remark
from ..methods import unspecified_systems
from ..methods.any_number import any_number

q, w, v, s = vectors("q w v s")
lambda_0, det = real_symbol("lambda_0"), real_symbol("det")
THREE = range(3)

LAGRANGE = sp.Function("L")(*q, *v)
CONSTRAINT = sp.Function("f_s")(*q, *v)
SYMBOLS, SPEEDS, WEIGHTS = q.symbols, v.symbols, w.symbols


@cache
def frame() -> sp.ImmutableDenseMatrix:
    """The matrix G_ij(q), whose column j contains the components of E_j."""
    return constant(sp.Matrix(3, 3, lambda i, j: sp.Function(f"G_s{i + 1}{j + 1}")(*q)))


@cache
def motion() -> System:
    """A system that moves along any curve, with arbitrary velocity components w in the frame."""
    return _motion(frame())


def _motion(matrix: sp.ImmutableDenseMatrix) -> System:
    return unspecified_systems.system(
        "any-motion",
        "Any motion in a frame",
        {q: v, w: s},
        parameters=(
            *(Parameter(x, "acceleration in the frame", 0.3 + i / 7) for i, x in enumerate(s)),
            Parameter(lambda_0, "multiplier", 0.6),
        ),
        definitions={v: constant(matrix * sp.Matrix(WEIGHTS))},
    )


def derivative(matrix: sp.ImmutableDenseMatrix, index: int, function: sp.Expr) -> sp.Expr:
    """The derivative of a function of q along E_i, as in (1.9): Σ_j G_ji ∂/∂q_j."""
    return sp.Add(*(matrix[j, index] * sp.diff(function, SYMBOLS[j]) for j in THREE))


def structure(matrix: sp.ImmutableDenseMatrix) -> dict[tuple[int, int, int], sp.Expr]:
    """c_ij^k of (1.8): [E_i, E_j] = Σ_k c_ij^k E_k."""
    inverse = matrix.adjugate() / matrix.det(method="berkowitz")
    coefficients: dict[tuple[int, int, int], sp.Expr] = {}
    for i, j in product(THREE, repeat=2):
        bracket = sp.Matrix(
            [
                derivative(matrix, i, matrix[a, j]) - derivative(matrix, j, matrix[a, i])
                for a in THREE
            ]
        )
        coefficients |= {(i, j, k): value for k, value in enumerate(inverse * bracket)}
    return coefficients


def _momenta(matrix: sp.ImmutableDenseMatrix, function: sp.Expr) -> list[sp.Expr]:
    """∂/∂w_i of a function of q and q̇ = G w."""
    return [sp.Add(*(matrix[a, i] * sp.diff(function, SPEEDS[a]) for a in THREE)) for i in THREE]


def _force(matrix: sp.ImmutableDenseMatrix, index: int) -> sp.Expr:
    """E_i(L̂), where L̂(q, w) = L(q, G w)."""
    velocity = matrix * sp.Matrix(WEIGHTS)
    through = (derivative(matrix, index, velocity[a]) * sp.diff(LAGRANGE, SPEEDS[a]) for a in THREE)
    return derivative(matrix, index, LAGRANGE) + sp.Add(*through)


def _lagrange(matrix: sp.ImmutableDenseMatrix, index: int) -> sp.Expr:
    """Left minus right side of (1.6), along the displacement E_i."""
    residuals = (
        Rate(sp.diff(LAGRANGE, SPEEDS[a]))
        - sp.diff(LAGRANGE, SYMBOLS[a])
        - lambda_0 * sp.diff(CONSTRAINT, SPEEDS[a])
        for a in THREE
    )
    return sp.Add(*(matrix[a, index] * value for a, value in enumerate(residuals)))


# --- the claims ----------------------------------------------------------------------------


def velocity() -> Case:
    """The rate of any function is Σ w_i E_i applied to it."""
    function = sp.Function("h_s")(*q)
    matrix = frame()
    total = sp.Add(*(WEIGHTS[i] * derivative(matrix, i, function) for i in THREE))
    return motion(), Identity("velocity", Rate(function) - total)


def commutators() -> Case:
    """The commutator of two frame fields, applied to any function, is Σ c_ij^k E_k."""
    function = sp.Function("h_s")(*q)
    matrix, constants = frame(), structure(frame())
    first = [derivative(matrix, i, function) for i in THREE]
    residuals = [
        derivative(matrix, i, first[j])
        - derivative(matrix, j, first[i])
        - sp.Add(*(constants[i, j, k] * first[k] for k in THREE))
        for i, j in ((0, 1), (1, 2), (2, 0))
    ]
    return motion(), Identity("commutators", tuple(residuals))


def suslov() -> Case:
    """(1.9), summed over j and k, is (1.6) along E_i for any motion and multiplier."""
    matrix, constants = frame(), structure(frame())
    momenta, pushes = _momenta(matrix, LAGRANGE), _momenta(matrix, CONSTRAINT)
    residuals = []
    for i in THREE:
        turned = sp.Add(
            *(constants[j, i, k] * momenta[k] * WEIGHTS[j] for j, k in product(THREE, repeat=2))
        )
        left = Rate(momenta[i]) - turned - _force(matrix, i) - lambda_0 * pushes[i]
        residuals.append(left - _lagrange(matrix, i))
    return motion(), Identity("poincare_suslov", tuple(residuals))


def suslov_printed() -> Case:
    """(1.9) summed over i and k, as printed: j is free, so equation i must hold for all j."""
    matrix, constants = frame(), structure(frame())
    momenta, pushes = _momenta(matrix, LAGRANGE), _momenta(matrix, CONSTRAINT)
    residuals = []
    for i, j in product(THREE, repeat=2):
        turned = sp.Add(
            *(constants[j, a, k] * momenta[k] * WEIGHTS[j] for a, k in product(THREE, repeat=2))
        )
        left = Rate(momenta[i]) - turned - _force(matrix, i) - lambda_0 * pushes[i]
        residuals.append(left - _lagrange(matrix, i))
    return motion(), Identity("poincare_suslov", tuple(residuals))


def argument_printed() -> Case:
    """The claim that G_ij of any frame depends on q_i alone."""
    matrix = frame()
    residuals = tuple(
        sp.diff(matrix[i, j], SYMBOLS[k]) for i, j, k in product(THREE, repeat=3) if k != i
    )
    return motion(), Identity("argument", residuals)


def coordinates() -> Case:
    """For G_ij = δ_ij, (1.9) is literally (1.6)."""
    matrix = constant(sp.eye(3))
    constants = structure(matrix)
    momenta, pushes = _momenta(matrix, LAGRANGE), _momenta(matrix, CONSTRAINT)
    residuals = [
        Rate(momenta[i]) - _force(matrix, i) - lambda_0 * pushes[i] - _lagrange(matrix, i)
        for i in THREE
    ]
    return replace(_motion(matrix), name="coordinates"), Identity(
        "coordinates", (*residuals, *constants.values())
    )


CLAIMS = (
    Claim(
        "(1.7)",
        r"$\mathbf E_i=\sum_jG_{ji}(\mathbf q)\mathbf e_j$, $\mathbf e_i=\frac{\partial}{\partial"
        r"\mathbf q_i}$; using (1.7), $\dot{\mathbf q}_i=\sum_jG_{ij}(\mathbf q)w_j$, where "
        r"$\mathbf w$ are the components of the velocity in the basis $\mathbf E_1,\dots,"
        r"\mathbf E_n$",
        velocity,
        note="for an unspecified frame",
        argument=any_number(2),
    ),
    Claim(
        "(1.8)",
        r"$[\mathbf E_i,\mathbf E_j]=\sum_kc_{ij}^k(\mathbf q)\mathbf E_k$",
        commutators,
        note="for an unspecified frame; it fixes the sign of c",
        argument="the commutators of the fields of any basis are combinations of them",
    ),
    Claim(
        "(1.9), Proposition 1",
        r"$\frac{d}{dt}\left(\frac{\partial\hat L}{\partial w_i}\right)-\sum_{i,k}c_{ji}^k"
        r"(\mathbf q)\frac{\partial\hat L}{\partial w_k}w_j-\mathbf E_i(\hat L)=\sum_\mu"
        r"\hat\lambda_\mu\frac{\partial f_\mu}{\partial w_i}$ is equivalent to (1.6)",
        suslov_printed,
        suslov,
        r"$\frac{d}{dt}\left(\frac{\partial\hat L}{\partial w_i}\right)-\sum_{j,k}c_{ji}^k"
        r"(\mathbf q)\frac{\partial\hat L}{\partial w_k}w_j-\mathbf E_i(\hat L)=\sum_\mu"
        r"\hat\lambda_\mu\frac{\partial\hat f_\mu}{\partial w_i}$",
        "the sum runs over j and k, not over i and k (as printed, j is free: read as required for "
        "every j), and the constraint on the right is f̂; L(q, q̇), the frame and the constraint "
        "unspecified, λ̂ = λ",
        argument=r"for any number of coordinates and constraints: $\frac{d}{dt}\frac{\partial"
        r"\hat L}{\partial w_i} - \mathbf E_i(\hat L)$ is the left side of (1.6) along "
        r"$\mathbf E_i$ and $\sum_jw_j\,(\partial L/\partial\dot{\mathbf q}, [\mathbf E_j, "
        r"\mathbf E_i])$, the sum with $c_{ji}^k$; constraints add up",
    ),
    Claim(
        "(1.9), second equation",
        r"$\dot{\mathbf q}_i=\sum_jG_{ij}(\mathbf q_i)w_j$",
        argument_printed,
        velocity,
        r"$\dot q_i=\sum_jG_{ij}(\mathbf q)w_j$",
        "G_ij depends on all coordinates, not on q_i alone",
        argument=any_number(2),
    ),
    Claim(
        "Remark 3",
        r"if we set $G_{ij}=\delta_{ij}$ in (1.7) we obtain usual Eqs. (1.6)",
        coordinates,
        argument=any_number(2),
    ),
)

REMARKS = (
    Remark(
        "Remark 3",
        "Equations (1.9) are the most general form of the d'Alembert–Lagrange equations of the "
        "second kind",
        "judgement",
    ),
    Remark("§1.2, after Proposition 1", "the proof can be found in [12]", "literature"),
)
