"""§4.2: Euler–Jacobi integrability."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Symmetry,
)
from flowlanes.system.system import Parameter, System
from lawproof.proof.verdict import Verdict

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import conclusion_verdict, contrary
from ..methods.tori import F_1, F_2, canonical_in, not_hamiltonian, of_rank_two, theta_1, theta_2
from ..methods.unspecified_systems import system, unspecified_functions

ANGLES = (theta_1, theta_2)
STATE = (theta_1, theta_2, F_1, F_2)
HALF = sp.Rational(1, 2)


def _kolmogorov() -> System:
    """(4.3) with two integrals."""
    rates = [value / PHI for value in LAMBDA]
    field = dict(zip(ANGLES, rates, strict=True))
    return system("kolmogorov", "(4.3)", {**field, F_1: sp.S.Zero, F_2: sp.S.Zero})


LAMBDA = unspecified_functions("lambda1 lambda2", F_1, F_2)
(PHI,) = unspecified_functions("Phi", *STATE)


def quadratures() -> Case:
    """On the level surface ρv = (∂ψ/∂x₂, −∂ψ/∂x₁), with ψ = ∫ρ(v₁ dx₂ − v₂ dx₁) an integral.

    div(ρv) = 0 is equivalent to the local existence of ψ; the time is a quadrature along ψ =
    const.
    """
    x = sp.symbols("x_1:3", real=True)
    psi, rho = unspecified_functions("psi rho", *x)
    rates = (sp.diff(psi, x[1]) / rho, -sp.diff(psi, x[0]) / rho)
    dynamics = system("surface", "the level surface", dict(zip(x, rates, strict=True)))
    return (dynamics, Measure("measure", {rho: sp.S.One})), (
        dynamics,
        Integral("trajectories", psi),
    )


def measure_of_kolmogorov() -> Case:
    """Φ dθ₁ dθ₂ dF."""
    return _kolmogorov(), Measure("measure", {PHI: sp.S.One})


def corollary_2_printed() -> Verdict:
    """θ̇₁ = 1/Φ, θ̇₂ = F/Φ on T² × ℝ: n = 3 with the measure Φ and one integral."""
    return contrary(not_hamiltonian())


def corollary_2_corrected() -> Case:
    """Two angles and two integrals, independent λ_i: N = 1/Φ and {θ_i, λ_j} = δ_ij."""
    dynamics = _kolmogorov()
    matrix = canonical_in(LAMBDA, (sp.S.One, sp.S.One))
    structure = PoissonStructure("bracket", matrix, rank=4)
    energy = HALF * sp.Add(*(value**2 for value in LAMBDA))
    form = ConformallyHamiltonian("form", 1 / PHI, structure, energy)
    return (dynamics, structure), (dynamics, form), *_constant_ratio()


def _constant_ratio() -> tuple[tuple[System, Law], ...]:
    """n = 3 with a constant rotation number: {θ_i, F} = c_i, H = F, N = Λ/Φ."""
    (speed,), (spread,) = (
        unspecified_functions("Lambda", F_1),
        unspecified_functions("Phi", *ANGLES, F_1),
    )
    ratio = sp.symbols("c_1:3", real=True)
    rates = [c * speed / spread for c in ratio]
    dynamics = system(
        "constant_ratio",
        "(4.3)",
        dict(zip((*ANGLES, F_1), (*rates, sp.S.Zero), strict=True)),
        parameters=tuple(Parameter(c, "frequency", 2.0 + i) for i, c in enumerate(ratio)),
    )
    matrix = sp.Matrix([[0, 0, ratio[0]], [0, 0, ratio[1]], [-ratio[0], -ratio[1], 0]])
    structure = PoissonStructure("bracket", matrix, rank=2)
    return (
        (dynamics, structure),
        (dynamics, ConformallyHamiltonian("form", speed / spread, structure, F_1)),
    )


def never_hamiltonian() -> Verdict:
    """For n = 3 a varying rotation number excludes a Hamiltonian form, for n = 4 it does not."""
    none = not_hamiltonian()
    return conclusion_verdict("reduction", none.finding, (none, *of_rank_two()))


def different_periods() -> Case:
    """λ₁ = λ₂ = 1, Φ = 2 + cos(θ₁ − θ₂): the period 2πΦ is constant only on each trajectory."""
    spread = 2 + sp.cos(theta_1 - theta_2)
    dynamics = system("resonant", "a resonant torus", dict.fromkeys(ANGLES, 1 / spread))
    return (
        (dynamics, Measure("measure", {spread: sp.S.One})),
        (dynamics, Integral("period", spread)),
        (dynamics, Identity("rates", tuple(Rate(s) * spread - 1 for s in ANGLES))),
    )


def equal_periods() -> tuple[tuple[System, Law], ...]:
    """In action–angle variables the translations of the angles commute with the motion.

    They map any trajectory of a torus to any other one, with the same period.
    """
    (energy,) = unspecified_functions("H", F_1, F_2)
    field = dict(zip(ANGLES, (sp.diff(energy, F) for F in (F_1, F_2)), strict=True))
    dynamics = system(
        "actions", "angle–action variables", {**field, F_1: sp.S.Zero, F_2: sp.S.Zero}
    )
    return tuple((dynamics, Symmetry(f"shift of {s}", {s: sp.S.One})) for s in ANGLES)


PARAMETERS = (
    "for any number of integrals: those beyond the ones computed are parameters, and Casimir "
    "functions of a bracket"
)

CLAIMS = (
    Claim(
        "Theorem 5, quadratures",
        r"A system that preserves measure and has $n - 2$ first integrals: the solutions that lie "
        r"on $\mathcal{M}_c$ can be expressed in terms of quadratures",
        quadratures,
        note="the measure makes the equation of the trajectories on the level surface a total "
        "differential",
        argument="with the n − 2 integrals among the coordinates they are parameters, and the "
        "surface has a measure of its own; computed is the surface",
    ),
    Claim(
        "(4.3)",
        r"$\dot\theta_1 = \lambda_1(\mathbf{F})/\Phi(\theta_1, \theta_2, \mathbf{F})$, "
        r"$\dot\theta_2 = \lambda_2(\mathbf{F})/\Phi(\theta_1, \theta_2, \mathbf{F})$ is a form of "
        "a flow that preserves measure",
        measure_of_kolmogorov,
        note="the measure Φ dθ₁ dθ₂ dF; that every such flow has this form is Kolmogorov's theorem",
        argument=PARAMETERS,
    ),
    Claim(
        "Corollary 2",
        "At least in the vicinity of invariant tori, all Euler–Jacobi integrable systems are "
        "conformally Hamiltonian",
        corollary_2_printed,
        corollary_2_corrected,
        r"They are for $n \ge 4$ near tori where $\lambda_1, \lambda_2$ of (4.3), after "
        r"multiplication of both and of $\Phi$ by a function of $\mathbf{F}$, are independent, "
        "that is, where the rotation number has a differential that is not zero; and for $n = 3$ "
        "when the rotation number is constant",
        "the hypotheses are missing: for n = 3 with a varying rotation number (4.3) is not N J ∇H",
        argument=PARAMETERS,
    ),
    Claim(
        "§4.2, after Corollary 2",
        "A Euler–Jacobi integrable system cannot generally (without resort to changes of time) be "
        "reduced to the Hamiltonian form",
        never_hamiltonian,
        note="not all can: with one integral a varying rotation number excludes it. For n ≥ 4 "
        "every such system has a Hamiltonian form of rank two, v∧∂/∂F₁, near a torus where the "
        "rotation number has a differential that is not zero, or is constant; what different "
        "periods exclude is one in which the integrals commute",
    ),
    Claim(
        "§4.2, resonant tori",
        "Consider a resonant torus of (4.3), which is foliated into periodic trajectories. In the "
        r"general case, since $\Phi(\theta_1, \theta_2, \mathbf{F})$ depends on $\theta_i$, the "
        "periods of motion along these trajectories are different",
        different_periods,
        note="a Φ that depends only on θ₁ does not suffice on a torus with λ₁ ≠ 0",
        argument="the period is the mean of Φ over the trajectory, up to a factor; as a function "
        "of the trajectory it has the Fourier coefficients Φ_m with (m, λ) = 0, and those with "
        "m ≠ 0 vanish for special Φ only; computed is an example",
    ),
    Claim(
        "Proposition 4",
        "In an integrable Hamiltonian system with two-dimensional invariant tori the periods of "
        "the solutions that belong to one and the same resonant torus are equal",
        equal_periods,
        note="near a non-singular torus, which has angle–action variables",
    ),
)

REMARKS = (
    Remark(
        "Theorem 5, tori",
        "A connected compact component of the level surface without rest points is a torus, with "
        "angular coordinates in which (4.3) holds",
        "a quoted theorem of topology, and Kolmogorov's; the phase space must be orientable",
    ),
    Remark(
        "§4.2, mixing",
        "Different periods result in mixing on resonant tori, which prevents nonholonomic systems "
        "from being Hamiltonian [47]",
        "literature; mixing is meant along the torus, each trajectory of which is closed",
    ),
    Remark(
        "§4.2, after (4.3)",
        "The theorem extends the statement from [28]; Kolmogorov's proof can be easily extended to "
        "a flow on a torus that depends on parameters",
        "literature; a proof is not given",
    ),
    Remark(
        "§4.2, before Proposition 4",
        "Lagrange–Liouville integrable systems",
        "an erratum: read Lagrange–Lie, the name given in §4.1",
    ),
)
