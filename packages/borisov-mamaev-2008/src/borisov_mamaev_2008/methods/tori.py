"""Motion on tori: brackets on T² × ℝ and T² × ℝ² (§4.1, §4.2)."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Identity, Law, PoissonStructure
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict

from .unspecified_systems import system, unspecified_functions

theta_1, theta_2, theta_3, F_1, F_2 = sp.symbols("theta_1:4 F_1:3", real=True)


def canonical_in(
    frequencies: tuple[sp.Expr, sp.Expr],
    weights: tuple[sp.Expr, sp.Expr],
    shift: sp.Expr = sp.S.Zero,
) -> sp.Matrix:
    """The bracket {θ̃_i, ω_j} = δ_ij w_i in the variables θ₁, θ₂, F₁, F₂.

    Parameters
    ----------
    frequencies : 2 sympy.Expr
        Independent functions ω_i(F).
    weights : 2 sympy.Expr
        Functions w_i of ω_i.
    shift : sympy.Expr
        Z(θ₁, F), where θ̃₁ = θ₁ and θ̃₂ = θ₂ − Z.
    """
    slopes = sp.Matrix(2, 2, lambda j, k: sp.diff(frequencies[j], (F_1, F_2)[k]))
    determinant = slopes[0, 0] * slopes[1, 1] - slopes[0, 1] * slopes[1, 0]
    # {θ̃_i, F_k} is the transposed inverse of ∂ω_j/∂F_k, with row i times w_i.
    mixed = sp.diag(*weights) * slopes.adjugate().T / determinant
    mixed[1, :] += sp.diff(shift, theta_1) * mixed[0, :]
    turn = sp.Add(*(sp.diff(shift, F) * mixed[0, k] for k, F in enumerate((F_1, F_2))))
    angles = sp.Matrix([[0, turn], [-turn, 0]])
    return angles.row_join(mixed).col_join((-mixed.T).row_join(sp.zeros(2)))


def of_rank_two() -> tuple[tuple[System, Law], ...]:
    """v = (f, r f, 0, 0) with f(θ, F), r(F₂) is Hamiltonian in the bracket v∧∂/∂F₁.

    If r does not depend on F₁, [v, ∂/∂F₁] is along v, which is the Jacobi identity of v∧∂/∂F₁; no
    change of time is needed. (4.3) with two or more integrals has this form, with f = λ₁/Φ and r =
    λ₂/λ₁, near every torus where the rotation number r has a non-zero differential, with F₂ = r,
    and where r is constant.
    """
    (speed,), (rotation,) = (
        unspecified_functions("f", theta_1, theta_2, F_1, F_2),
        unspecified_functions("r", F_2),
    )
    rates = (speed, rotation * speed)
    still = dict.fromkeys((F_1, F_2), sp.S.Zero)
    dynamics = system(
        "flow_on_tori", "(4.3)", {**dict(zip((theta_1, theta_2), rates, strict=True)), **still}
    )
    matrix = sp.zeros(4)
    for i, rate in enumerate(rates):
        matrix[i, 2], matrix[2, i] = rate, -rate
    structure = PoissonStructure("bracket", matrix, casimirs=(F_2,), rank=2)
    form = ConformallyHamiltonian("form", sp.S.One, structure, F_1)
    return (dynamics, structure), (dynamics, form)


@cache
def not_hamiltonian() -> Verdict:
    """The verdict that θ̇ = λ(F)/Φ, Ḟ = 0 on T² × ℝ is not N J ∇H if λ₁/λ₂ varies.

    On tori with irrational λ₁/λ₂, which are dense, an integral H is constant; hence H = H(F). Then
    J₁₃ = μλ₁, J₂₃ = μλ₂ with μ = 1/(N H′ Φ), and J₁₂ = μa with an unknown a(θ, F). Up to sign the
    Jacobi identity is μ²(λ₁λ₂′ − λ₂λ₁′ − λ₁∂a/∂θ₁ − λ₂∂a/∂θ₂) = 0. The mean of the last two terms
    over the torus is zero, whereas the first two are constant on it.

    Returns
    -------
    Verdict
        Proven; undecided if the identity is not reduced.
    """
    state = (theta_1, theta_2, F_1)
    (lambda_1, lambda_2), (mu, a) = (
        unspecified_functions("lambda1 lambda2", F_1),
        unspecified_functions("mu a", *state),
    )
    entries = {(0, 1): mu * a, (0, 2): mu * lambda_1, (1, 2): mu * lambda_2}
    matrix = sp.zeros(3)
    for (i, j), value in entries.items():
        matrix[i, j], matrix[j, i] = value, -value
    defect = sp.Add(
        *(
            matrix[i, k] * sp.diff(matrix[j, m], s)
            for i, j, m in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
            for k, s in enumerate(state)
        )
    )
    twist = lambda_1 * sp.diff(lambda_2, F_1) - lambda_2 * sp.diff(lambda_1, F_1)
    along = lambda_1 * sp.diff(a, theta_1) + lambda_2 * sp.diff(a, theta_2)
    dynamics = system("torus", "T² × ℝ", dict.fromkeys(state, sp.S.Zero))
    verdict = prove(dynamics, Identity("jacobi", defect - mu**2 * (twist - along)))
    if not verdict:
        return Verdict("tori", "undecided", reason="the Jacobi identity could not be reduced")
    return Verdict(
        "tori",
        "proven",
        finding="λ = (1, F) on T² × ℝ: the Jacobi identity demands that a mean over the torus, "
        "λ₁λ₂′ − λ₂λ₁′ = 1, vanishes",
        terms=verdict.terms,
        seconds=verdict.seconds,
    )
