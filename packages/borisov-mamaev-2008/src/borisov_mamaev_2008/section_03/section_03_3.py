"""§3.3: Poisson structure, Hamiltonian and conformally Hamiltonian form."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations, permutations

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Measure, PoissonStructure, Rate
from flowlanes.system.system import Guard, System
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict

from ..claim import Case, Claim, Remark
from ..methods.any_number import any_number
from ..methods.derived_verdicts import contrary
from ..methods.unspecified_systems import (
    bracket,
    gradient,
    hamiltonian,
    skew,
    system,
    unspecified_functions,
)
from ..obstructions.divergence_at_equilibria import excludes_measure

x = sp.symbols("x_1:4", real=True)
z = sp.symbols("z_1:5", real=True)
J = skew(x)
#: Four dimensions, for formulas whose terms have four different indices.
K = skew(z)
f, g, H, N = unspecified_functions("f g H N", *x)


def _jacobiator(matrix: sp.Matrix, i: int, j: int, k: int) -> sp.Expr:
    """Σ_l (J_il ∂J_jk/∂x_l + J_jl ∂J_ki/∂x_l + J_kl ∂J_ij/∂x_l)."""
    turns = ((i, j, k), (j, k, i), (k, i, j))
    return sp.Add(
        *(
            matrix[one, a] * sp.diff(matrix[two, three], s)
            for one, two, three in turns
            for a, s in enumerate(z)
        )
    )


def _cyclic_gradient(matrix: sp.Matrix, i: int, j: int, k: int) -> sp.Expr:
    """∂J_ij/∂x_k + ∂J_jk/∂x_i + ∂J_ki/∂x_j, the left side of (3.6)."""
    turns = ((i, j, k), (j, k, i), (k, i, j))
    return sp.Add(*(sp.diff(matrix[one, two], x[three]) for one, two, three in turns))


# --- Jacobi identity -----------------------------------------------------------------------


def jacobi_printed() -> Case:
    """The claim that (3.6) implies the Jacobi identity, refuted by the bracket of so(3)."""
    turning = sp.Matrix([[0, x[2], -x[1]], [-x[2], 0, x[0]], [x[1], -x[0], 0]])
    top = hamiltonian(turning, H, x)
    structure = PoissonStructure("so(3)", turning, rank=2)
    return (top, structure), (top, Identity("(3.6)", _cyclic_gradient(turning, 0, 1, 2)))


def jacobi_corrected() -> Case:
    """The nested brackets of any f, g, h are Σ f_i g_j h_k times the component ijk, for any J."""
    f, g, h, H = unspecified_functions("f g h H", *z)
    turns = ((f, g, h), (g, h, f), (h, f, g))
    nested = (bracket(K, one, bracket(K, two, three, z), z) for one, two, three in turns)
    slopes = [list(gradient(function, z)) for function in (f, g, h)]
    components = (
        slopes[0][i] * slopes[1][j] * slopes[2][k] * _jacobiator(K, i, j, k)
        for i, j, k in permutations(range(4), 3)
    )
    return hamiltonian(K, H, z), Identity("jacobi", sp.Add(*nested) - sp.Add(*components))


def bracket_of_functions() -> Case:
    """Check that ḟ = {f, H} holds along (3.5) for any function f."""
    return hamiltonian(J, H, x), Identity("rate", Rate(f) - bracket(J, f, H, x))


# --- what the form implies -----------------------------------------------------------------


def energy() -> Case:
    """Check that H is constant along (3.5) for any skew-symmetric J."""
    return hamiltonian(J, H, x), Integral("hamiltonian", H)


def conformal_energy() -> Case:
    """H along (3.7), with any skew-symmetric J."""
    return hamiltonian(J, H, x, N), Integral("hamiltonian", H)


def _book() -> tuple[System, PoissonStructure]:
    """{x₁, x₃} = x₁, {x₂, x₃} = x₂ with H = x₃: the bracket of a non-unimodular algebra."""
    matrix = sp.Matrix([[0, 0, x[0]], [0, 0, x[1]], [-x[0], -x[1], 0]])
    return hamiltonian(matrix, x[2], x), PoissonStructure("book", matrix, rank=2)


def measure_printed() -> Verdict:
    """A Hamiltonian system without a smooth invariant measure."""
    dynamics, structure = _book()
    if not prove(dynamics, structure):
        return Verdict("measure", "undecided", reason="the bracket of the example is not proven")
    return contrary(excludes_measure(dynamics, dict.fromkeys(x, sp.S.Zero)))


def _symplectic(multiplier: sp.Expr = sp.S.One) -> tuple[System, PoissonStructure]:
    """J inverse to an exact 2-form Ω = dA with unspecified A, in four dimensions.

    Its density is the Pfaffian Pf Ω = (det J)^(−1/2).
    """
    form = unspecified_functions("A1 A2 A3 A4", *z)
    omega = sp.Matrix(4, 4, lambda i, j: sp.diff(form[j], z[i]) - sp.diff(form[i], z[j]))
    entries = sp.symbols("Omega_12 Omega_13 Omega_14 Omega_23 Omega_24 Omega_34", real=True)
    w12, w13, w14, w23, w24, w34 = entries
    pfaffian = w12 * w34 - w13 * w24 + w14 * w23
    upper = {(0, 1): -w34, (0, 2): w24, (0, 3): -w23, (1, 2): -w14, (1, 3): w13, (2, 3): -w12}
    matrix = sp.zeros(4)
    for (i, j), value in upper.items():
        matrix[i, j], matrix[j, i] = value / PF, -value / PF
    (energy_function,) = unspecified_functions("H", *z)
    rates = multiplier * (matrix * gradient(energy_function, z))
    pairs = combinations(range(4), 2)
    definitions = {s: omega[i, j] for s, (i, j) in zip(entries, pairs, strict=True)}
    dynamics = system(
        "symplectic",
        "ẋ = N J ∇H with J non-degenerate",
        dict(zip(z, rates, strict=True)),
        definitions={**definitions, PF: pfaffian},
    )
    return dynamics, PoissonStructure("inverse", matrix, rank=4)


PF = sp.Symbol("Pf", real=True)


def measure_corrected() -> Case:
    """Pf Ω for a non-degenerate structure; in general Σ_i ∂(ρJ_ij)/∂x_i = 0 is required."""
    dynamics, structure = _symplectic()
    (rho,) = unspecified_functions("rho", *x)
    modular = [sp.Add(*(sp.diff(rho * J[i, j], x[i]) for i in range(3))) for j in range(3)]
    flow = hamiltonian(J, H, x)
    spread = sp.Add(*(sp.diff(rho * rate, s) for s, rate in flow.field))
    by_modular = sp.Add(*(part * sp.diff(H, s) for part, s in zip(modular, x, strict=True)))
    return (
        (dynamics, structure),
        (dynamics, Measure("liouville", {PF: sp.S.One})),
        (flow, Identity("modular", spread - by_modular)),
    )


def conformal_measure_printed() -> Verdict:
    """The system q̇ = q, ṗ = 0, with N = q and H = p in the canonical bracket."""
    canonical = sp.Matrix([[0, 1], [-1, 0]])
    dynamics = hamiltonian(canonical, x[1], x[:2], x[0])
    return contrary(excludes_measure(dynamics, dict.fromkeys(x[:2], sp.S.Zero)))


def conformal_measure_corrected() -> Case:
    """Pf Ω/N for a non-degenerate structure."""
    (multiplier,) = unspecified_functions("N", *z)
    dynamics, structure = _symplectic(multiplier)
    return (
        (dynamics, structure),
        (dynamics, Measure("liouville", {PF: sp.S.One, multiplier: -sp.S.One})),
    )


def change_of_time() -> Case:
    """N dt = dτ transforms (3.7) into (3.5)."""
    law = Isomorphism(
        "time", hamiltonian(J, H, x), {s: s for s in x}, time=N, meaning="change of time"
    )
    forward = Guard("time", N, "the new time stands still")
    return replace(hamiltonian(J, H, x, N), guards=(forward,)), law


# --- Remark 8 ------------------------------------------------------------------------------


def tensor_invariant() -> Case:
    """(L_v J)_ij is Σ_k H_k times the defect of the Jacobi identity, for any skew-symmetric J."""
    (H,) = unspecified_functions("H", *z)
    rates = list(K * gradient(H, z))

    def lie(i: int, j: int) -> sp.Expr:
        along = sp.Add(*(rate * sp.diff(K[i, j], s) for rate, s in zip(rates, z, strict=True)))
        turned = sp.Add(
            *(
                sp.diff(rates[i], s) * K[k, j] + sp.diff(rates[j], s) * K[i, k]
                for k, s in enumerate(z)
            )
        )
        return along - turned

    def defect(i: int, j: int) -> sp.Expr:
        return sp.Add(*(_jacobiator(K, i, j, k) * sp.diff(H, s) for k, s in enumerate(z)))

    residuals = tuple(lie(i, j) + defect(i, j) for i, j in combinations(range(4), 2))
    return hamiltonian(K, H, z), Identity("lie_derivative", residuals)


def refuted_no_conservation_law() -> Verdict:
    """Refute the absence of conservation laws: H is an integral for every skew-symmetric J."""
    return contrary(prove(hamiltonian(J, H, x), Integral("hamiltonian", H)))


def one_conservation_law() -> Case:
    """H is an integral also without the Jacobi identity."""
    return energy()


LIOUVILLE = (
    "for any number of variables: the condition with Σ ∂(ρJ_ij)/∂x_i has two different indices in "
    "a term, and for a non-degenerate J it holds in the coordinates of Theorem 2, in which ρ is "
    "constant; computed is the density in any coordinates, n = 4"
)

CLAIMS = (
    Claim(
        "(3.6)",
        r"The components of a Poisson structure satisfy the Jacobi identity "
        r"$\frac{\partial J_{ij}}{\partial x_k} + \frac{\partial J_{jk}}{\partial x_i} + "
        r"\frac{\partial J_{ki}}{\partial x_j} = 0$",
        jacobi_printed,
        jacobi_corrected,
        r"$\sum_l\left(J_{il}\frac{\partial J_{jk}}{\partial x_l} + "
        r"J_{jl}\frac{\partial J_{ki}}{\partial x_l} + "
        r"J_{kl}\frac{\partial J_{ij}}{\partial x_l}\right) = 0$",
        "(3.6) states that a 2-form is closed; the Lie–Poisson bracket of so(3) breaks it",
        argument=any_number(4),
    ),
    Claim(
        "§3.3, Poisson bracket",
        r"$\{f, g\} = \sum_{i,j} J_{ij}\frac{\partial f}{\partial x_i}"
        r"\frac{\partial g}{\partial x_j}$",
        bracket_of_functions,
        note="with it ḟ = {f, H} along (3.5)",
        argument=any_number(2),
    ),
    Claim(
        "(3.5)",
        r"The Hamiltonian system (3.5) has $H(\mathbf{x})$ as an integral of motion",
        energy,
        argument=any_number(2),
    ),
    Claim(
        "§3.3, Liouville's theorem",
        "The Hamiltonian system (3.5) preserves measure by Liouville's theorem",
        measure_printed,
        measure_corrected,
        r"(3.5) preserves the measure $\rho\,d^n\mathbf{x}$, $\rho = (\det\mathbf{J})^{-1/2}$, "
        r"where $\mathbf{J}$ is non-degenerate, and any measure with "
        r"$\sum_i \partial(\rho J_{ij})/\partial x_i = 0$ for all $j$; a degenerate structure need "
        r"not have one near a point where its rank falls",
        "the hypothesis is missing: {x₁, x₃} = x₁, {x₂, x₃} = x₂, H = x₃ preserves no smooth "
        "measure",
        argument=LIOUVILLE,
    ),
    Claim(
        "Remark 8, tensor invariant",
        r"$\mathbf{J}(\mathbf{x})$ is a tensor invariant of (3.5), "
        r"$\mathcal{L}_{\mathbf{v}}\mathbf{J} = 0$, due to Jacobi's identity",
        tensor_invariant,
        note="the Lie derivative is the contraction of the Jacobi identity (corrected) with ∇H",
        argument=any_number(4),
    ),
    Claim(
        "Remark 8, no conservation laws",
        r"The form (3.5) with a skew-symmetric $\mathbf{J}$ that does not obey Jacobi's identity "
        "implies no conservation laws",
        refuted_no_conservation_law,
        one_conservation_law,
        "It implies the conservation of $H$, by skew symmetry alone",
        "H is conserved for every skew-symmetric J",
        argument=any_number(2),
    ),
    Claim(
        "§3.3, measure of (3.7)",
        "Conformally Hamiltonian systems also preserve measure",
        conformal_measure_printed,
        conformal_measure_corrected,
        r"(3.7) preserves $\rho\mathcal{N}^{-1} d^n\mathbf{x}$ where $\mathcal{N} \ne 0$ and (3.5) "
        r"preserves $\rho\,d^n\mathbf{x}$, as for non-degenerate $\mathbf{J}$",
        "fails where N vanishes (q̇ = q, ṗ = 0), and where (3.5) preserves no measure",
        argument=LIOUVILLE,
    ),
    Claim(
        "§3.3, Hamiltonian function of (3.7)",
        "Conformally Hamiltonian systems have the Hamiltonian as a constant of motion",
        conformal_energy,
        argument=any_number(2),
    ),
    Claim(
        "(3.7)",
        r"If the sign $\mathcal{N}(\mathbf{x})$ is fixed, then, upon the change of time "
        r"$\mathcal{N}(\mathbf{x})\,dt = d\tau$, the system (3.7) is reduced to a Hamiltonian form",
        change_of_time,
        argument=any_number(2),
    ),
)

REMARKS = (
    Remark(
        "§3.3, zeros of the multiplier",
        "Where N vanishes, the change of time gives a Hamiltonian system with, on occasion, "
        "intriguing topological features [30]",
        "literature; the velocities of the Chaplygin sleigh are such a system",
    ),
    Remark(
        "§3.3, end",
        "Most nonholonomic systems can be represented in the conformally Hamiltonian form",
        "opinion; the cases are claims of §§5–10",
    ),
    Remark(
        "§3.3, before Remark 8",
        "Hamiltonian systems are the class of dynamical systems most extensively studied; whether "
        "equations of nonholonomic mechanics are Hamiltonian is a very important issue",
        "judgement",
    ),
    Remark(
        "§3.3, before (3.7)",
        "Conformally Hamiltonian systems are practically indistinguishable from Hamiltonian "
        "systems",
        "opinion; that they preserve $H$, and when they preserve a measure, are claims",
    ),
)
