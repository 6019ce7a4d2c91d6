"""§4.1: integration by symmetry fields and first integrals."""

from __future__ import annotations

import sympy as sp

from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
)
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.fixed_point.lagrange_top import I_1, I_3, p_phi, p_psi, phi, psi, theta

from ..claim import Case, Claim, Remark
from ..methods.catalogue_laws import law_named, laws_named
from ..methods.derived_verdicts import computed_verdict, contrary
from ..methods.tori import F_1, F_2, canonical_in, not_hamiltonian, theta_1, theta_2, theta_3
from ..methods.unspecified_systems import system, unspecified_functions
from ..obstructions.divergence_at_equilibria import excludes_measure

# --- Lie -----------------------------------------------------------------------------------


def _triangular() -> System:
    """ẏ₁ = v₁(y₁), ẏ₂ = v₂(y₁), ẏ₃ = v₃(y₁, y₂), with one integral F."""
    y = sp.symbols("y_1:4", real=True)
    F = sp.Symbol("F", real=True)
    rates = (
        *unspecified_functions("v1 v2", y[0], F),
        *unspecified_functions("v3", y[0], y[1], F),
        sp.S.Zero,
    )
    return system("triangular", "triangular form", dict(zip((*y, F), rates, strict=True)))


def triangular_measure() -> Case:
    """The density 1/v₁ where v₁ does not vanish."""
    dynamics = _triangular()
    return dynamics, Measure("measure", {dynamics.rates[0]: -sp.S.One})


def lie_measure() -> Verdict:
    """The velocities of the Chaplygin sleigh: n = 2 with one integral; no symmetry is needed."""
    dynamics = CATALOGUE["chaplygin-sleigh-reduced"].system()
    if not prove(dynamics, law_named(dynamics, "energy")):
        return Verdict("measure", "undecided", reason="the energy of the example is not proven")
    point = {p.symbol: exact_number(p.default) for p in dynamics.parameters}
    straight_on = dict(zip(dynamics.symbols, (sp.S.One, sp.S.Zero), strict=True))
    return contrary(excludes_measure(dynamics, {**point, **straight_on}))


# --- the Lagrange top ----------------------------------------------------------------------


def _top(angle: sp.Symbol, rate: sp.Expr) -> Case:
    law = Identity("quadrature", Rate(angle) - rate)
    return CATALOGUE["lagrange-top-angles"].system(), law


ACROSS = (p_psi - p_phi * sp.cos(theta)) / sp.sin(theta) ** 2
ALONG = (p_phi - p_psi * sp.cos(theta)) / sp.sin(theta) ** 2
DIFFERENCE = (1 / I_3 - 1 / I_1) * p_phi


def precession_printed() -> Case:
    """ψ̇ as printed."""
    return _top(psi, ACROSS)


def precession_corrected() -> Case:
    """ψ̇ with the factor 1/I₁."""
    return _top(psi, ACROSS / I_1)


def rotation_printed() -> Case:
    """φ̇ as printed."""
    return _top(phi, DIFFERENCE + ACROSS)


def rotation_corrected() -> Case:
    """φ̇ with p_φ and p_ψ exchanged and the factor 1/I₁."""
    return _top(phi, DIFFERENCE + ALONG / I_1)


def momenta_of_the_top() -> Case:
    """p_ψ and p_φ are constants of motion."""
    return laws_named(CATALOGUE["lagrange-top-angles"].system(), "area", "spin")


# --- reducibility --------------------------------------------------------------------------


def _uniform() -> System:
    """(4.2) for three angles and two integrals."""
    frequencies = unspecified_functions("omega1 omega2 omega3", F_1, F_2)
    field = dict(zip((theta_1, theta_2, theta_3), frequencies, strict=True))
    return system("uniform", "(4.2)", {**field, F_1: sp.S.Zero, F_2: sp.S.Zero})


def _with_uniform_angles(shifts: tuple[sp.Expr, sp.Expr]) -> tuple[System, Isomorphism]:
    """(4.1) with ζ_i = ω_i + ω₁ ∂Z_i/∂θ₁, and the change θ̃_i = θ_i − Z_i."""
    uniform = _uniform()
    omega = uniform.rates[:3]
    rates = [w + omega[0] * sp.diff(Z, theta_1) for w, Z in zip(omega[1:], shifts, strict=True)]
    field = {theta_1: omega[0], theta_2: rates[0], theta_3: rates[1]}
    dynamics = system("one_angle", "(4.1)", {**field, F_1: sp.S.Zero, F_2: sp.S.Zero})
    new = {
        theta_1: theta_1,
        theta_2: theta_2 - shifts[0],
        theta_3: theta_3 - shifts[1],
        F_1: F_1,
        F_2: F_2,
    }
    return dynamics, Isomorphism("straightened", uniform, new)


def theorem_4_printed() -> Verdict:
    """θ̇₁ = F, θ̇₂ = cos θ₁: the torus F = 0 contains points at rest and moving points.

    In (4.2) either all points of a torus are at rest or none.
    """
    field = {theta_1: F_1, theta_2: sp.cos(theta_1), F_1: sp.S.Zero}
    dynamics = system("stopping", "θ̇₁ = F, θ̇₂ = cos θ₁", field)
    at_rest = [rate.subs({theta_1: sp.pi / 2, F_1: 0}) for rate in dynamics.rates]
    moving = [rate.subs({theta_1: 0, F_1: 0}) for rate in dynamics.rates]
    broken = not any(at_rest) and any(moving)
    return computed_verdict(
        "reducibility",
        broken,
        "θ̇₁ = F, θ̇₂ = cos θ₁: on the torus F = 0 the point θ₁ = π/2 rests, θ₁ = 0 moves",
        "the example does not stop",
        decision="refuted",
        witness={"rate at θ₁ = π/2": str(at_rest), "rate at θ₁ = 0": str(moving)},
    )


def theorem_4_corrected() -> tuple[System, Isomorphism]:
    """The change of variables with Z_i(θ₁, F), the periodic primitive of (ζ_i − ω_i)/ω₁."""
    first, second = unspecified_functions("Z2 Z3", theta_1, F_1, F_2)
    return _with_uniform_angles((first, second))


def fourier() -> Case:
    """The series with three harmonics, in real form: a_m cos mθ₁ gives a_m/(m ω₁) sin mθ₁.

    For every ζ the change of variables is `theorem_4_corrected`, whose Z has this Fourier series
    by partial integration.
    """
    omega_1 = _uniform().rates[0]

    def shift(name: str) -> sp.Expr:
        terms = []
        for n in (1, 2, 3):
            a, b = unspecified_functions(f"{name}a{n} {name}b{n}", F_1, F_2)
            terms.append((a * sp.sin(n * theta_1) - b * sp.cos(n * theta_1)) / n)
        return sp.Add(*terms) / omega_1

    return _with_uniform_angles((shift("y"), shift("z"))), theorem_4_corrected()


def frequencies() -> Verdict:
    """(1/2π)∫ζ dθ₁ is the coefficient with m = 0, for five arbitrary harmonics."""
    orders = range(-5, 6)
    coefficients = {n: sp.Symbol(f"zeta_{n}") for n in orders}
    series = sp.Add(*(c * sp.exp(sp.I * n * theta_1) for n, c in coefficients.items()))
    mean = sp.integrate(sp.expand(series), (theta_1, 0, 2 * sp.pi)) / (2 * sp.pi)
    difference = sp.simplify(mean - coefficients[0])
    return Verdict(
        "frequencies",
        "proven" if difference == 0 else "refuted",
        finding="the mean over θ₁ is the coefficient with m = 0",
        witness=None if difference == 0 else {"difference": str(difference)},
    )


def corollary_1_corrected() -> Case:
    """Two angles, two integrals, independent frequencies, ω₁ ≠ 0: structures for (4.1).

    For any g_i the frequencies are used as the variables F_i.
    """
    omega_1, omega_2 = unspecified_functions("omega1 omega2", F_1, F_2)
    (Z,) = unspecified_functions("Z", theta_1, F_1, F_2)
    field = {
        theta_1: omega_1,
        theta_2: omega_2 + omega_1 * sp.diff(Z, theta_1),
        F_1: sp.S.Zero,
        F_2: sp.S.Zero,
    }
    dynamics = system("one_angle", "(4.1) with two angles", field)
    first = canonical_in((omega_1, omega_2), (sp.S.One, sp.S.One), Z)
    second = canonical_in((omega_1, omega_2), (omega_1, omega_2), Z)
    half = sp.Rational(1, 2)
    cases = ((first, half * (omega_1**2 + omega_2**2)), (second, omega_1 + omega_2))
    forms = []
    for i, (matrix, energy) in enumerate(cases, 1):
        structure = PoissonStructure(f"bracket_{i}", matrix, rank=4)
        form = ConformallyHamiltonian(f"form_{i}", sp.S.One, structure, energy)
        forms += [(dynamics, structure), (dynamics, form)]
    return (*forms, *_for_any_energy())


def _for_any_energy() -> tuple[tuple[System, Law], ...]:
    """{θ̃_i, ω_j} = δ_ij ω_i/g_i′(ω_i) and H = g₁(ω₁) + g₂(ω₂), with ω_i = F_i."""
    (Z,), energies = (
        unspecified_functions("Z", theta_1, F_1, F_2),
        (unspecified_functions("g1", F_1)[0], unspecified_functions("g2", F_2)[0]),
    )
    field = {
        theta_1: F_1,
        theta_2: F_2 + F_1 * sp.diff(Z, theta_1),
        F_1: sp.S.Zero,
        F_2: sp.S.Zero,
    }
    dynamics = system("by_frequencies", "(4.1) in its frequencies", field)
    weights = (F_1 / sp.diff(energies[0], F_1), F_2 / sp.diff(energies[1], F_2))
    structure = PoissonStructure("bracket", canonical_in((F_1, F_2), weights, Z), rank=4)
    form = ConformallyHamiltonian("form", sp.S.One, structure, sp.Add(*energies))
    return (dynamics, structure), (dynamics, form)


def remark_11() -> Case:
    """θ̇₁ = θ̇₂ = 1, θ̇₃ = cos(θ₁ − θ₂): the mean rate of θ₃ varies on one torus."""
    field = {theta_1: sp.S.One, theta_2: sp.S.One, theta_3: sp.cos(theta_1 - theta_2)}
    dynamics = system("resonant", "a resonant triangular field", field)
    mean = Integral("mean", sp.cos(theta_1 - theta_2))
    return (dynamics, mean), (dynamics, Identity("rate", Rate(theta_3) - mean.value))


def corollary_1_printed() -> Verdict:
    """θ̇₁ = 1, θ̇₂ = F on T² × ℝ: two frequencies and one integral."""
    return contrary(not_hamiltonian())


EACH_ANGLE = "each of any number of angles is changed by itself, with the integrals as parameters"

CLAIMS = (
    Claim(
        "§4.1, Lie-integrable systems",
        "Lie-integrable systems preserve measure",
        lie_measure,
        triangular_measure,
        r"They preserve the measure $\tilde v_1(y_1)^{-1}\,dF\,dy$ in the coordinates of the "
        r"triangular form, where $\tilde v_1 \ne 0$",
        "fails at rest points: the velocities of the Chaplygin sleigh (n = 2, one integral) "
        "preserve no smooth measure, nor do those of Suslov's problem, which §3.2 names",
        argument="for any number of variables: ρ = 1/ṽ₁ depends on y₁ and F alone, and each rate "
        "ṽ_i, i > 1, does not depend on y_i",
    ),
    Claim(
        "§4.1, precession of the Lagrange top",
        r"$\dot\psi = \frac{p_\psi - p_\varphi\cos\theta}{\sin^2\theta}$",
        precession_printed,
        precession_corrected,
        r"$\dot\psi = \frac{p_\psi - p_\varphi\cos\theta}{I_1\sin^2\theta}$",
        "the factor 1/I₁ is missing, though the formula for φ̇ contains I₁",
    ),
    Claim(
        "§4.1, intrinsic rotation of the Lagrange top",
        r"$\dot\varphi = (I_3^{-1} - I_1^{-1})p_\varphi + "
        r"\frac{p_\psi - p_\varphi\cos\theta}{\sin^2\theta}$",
        rotation_printed,
        rotation_corrected,
        r"$\dot\varphi = (I_3^{-1} - I_1^{-1})p_\varphi + "
        r"\frac{p_\varphi - p_\psi\cos\theta}{I_1\sin^2\theta}$",
        "p_ψ and p_φ are exchanged and the factor 1/I₁ is missing",
    ),
    Claim(
        "§4.1, momenta of the Lagrange top",
        r"$p_\psi$, $p_\varphi$ are constants of motion",
        momenta_of_the_top,
    ),
    Claim(
        "Theorem 4",
        "Suppose that in a neighborhood of a torus, the common level surface of the first "
        "integrals, there are angular coordinates such that the vector field takes the form "
        r"$\dot\theta_1 = \omega_1(\mathbf{F})$, $\dot\theta_i = \zeta_i(\theta_1, \mathbf{F})$ "
        "(4.1). Then there exists a differentiable (analytic) change of variables that reduces "
        r"the system (4.1) to the form $\dot\theta_i = \omega_i(\mathbf{F})$ (4.2)",
        theorem_4_printed,
        theorem_4_corrected,
        r"the same, where $\omega_1(\mathbf{F}) \ne 0$",
        "the hypothesis ω₁ ≠ 0 is missing; the change divides by ω₁",
        argument=EACH_ANGLE,
    ),
    Claim(
        "Theorem 4, change of variables from (4.1) to (4.2)",
        r"$\tilde\theta_i = \theta_i - \frac{1}{\omega_1(\mathbf{F})}\sum_{m \ne 0}"
        r"\frac{\zeta_i^{(m)}(\mathbf{F})}{im}e^{im\theta_1}$",
        fourier,
        note="with ω₁ ≠ 0, by which it divides",
        argument=f"{EACH_ANGLE}; by partial integration the sum is the Fourier series of the "
        "primitive Z_i of (ζ_i − ω_i)/ω₁, which is periodic and the sum of its series; computed "
        "are any Z_i, and a sum of three harmonics",
    ),
    Claim(
        "Theorem 4, frequencies",
        r"$\omega_i(\mathbf{F}) = \zeta_i(\mathbf{F}) = "
        r"\frac{1}{2\pi}\int_0^{2\pi}\zeta_i(\theta_1, \mathbf{F})\,d\theta_1$",
        frequencies,
        erratum="ζ_i(F): read ζ_i^(0)(F), the coefficient of the series",
        argument="the coefficient with m = 0 is the mean, and the mean of the other terms, of "
        "which five are computed, is zero",
    ),
    Claim(
        "Corollary 1",
        "If an integrable system can be written in the form (4.1), then this system is Hamiltonian "
        "(and even multi-Hamiltonian)",
        corollary_1_printed,
        corollary_1_corrected,
        r"It is, near a torus with $\omega_1 \ne 0$ on which the frequencies "
        r"$\omega_1, \dots, \omega_{n-k}$ are functionally independent (so that $k \ge n - k$): "
        r"$\{\tilde\theta_i, \omega_j\} = \delta_{ij} g_i'(\omega_i)^{-1}\omega_i$, "
        r"$H = \sum g_i(\omega_i)$ for any $g_i$ with $g_i' \ne 0$",
        "the hypotheses are missing: θ̇₁ = 1, θ̇₂ = F, Ḟ = 0 has no Poisson structure. Weaker: an "
        "integral F₁ on which "
        "the ratios of the frequencies do not depend is enough, with {θ̃_i, F₁} = ω_i and H = F₁, "
        "as Proposition 5 shows for two angles",
        argument="for any number of angles the bracket is a sum of those of the pairs θ̃_i, ω_i, "
        "and further integrals are parameters; computed are two angles",
    ),
    Claim(
        "Remark 11",
        r"For $\dot\theta_3 = \zeta_3(\theta_1, \theta_2)$, when $n - k > 2$, the form (4.2) "
        "can be impossible, whereas the solution itself can be expressed in quadratures",
        remark_11,
        note="θ̇₁ = θ̇₂ = 1, θ̇₃ = cos(θ₁ − θ₂): θ₃ turns at a rate that is constant along each "
        "motion and differs along one torus",
    ),
)

REMARKS = (
    Remark(
        "§4, beginning",
        "Three mechanisms of explicit integration: Lie's theorem, the Euler–Jacobi theorem, the "
        "conformally Hamiltonian form with Liouville's theorem",
        "a classification",
    ),
    Remark(
        "Theorem 3",
        "k first integrals and n − k − 1 symmetry fields that form a solvable Lie algebra give "
        "quadratures, in triangular coordinates",
        "a quoted theorem; the fields must be independent of each other and of v",
    ),
    Remark(
        "§4.1, divergence of the triangular form",
        "For the proof it is sufficient to find the divergence of the vector field in the "
        "coordinates of the integrals and y",
        "a hint; the divergence is ṽ₁′(y₁), which leads to the density 1/ṽ₁ of the claim above",
    ),
    Remark(
        "§4.1, body of revolution",
        "The motion of an axisymmetric body on a plane was integrated by Chaplygin and Gallop",
        "history",
    ),
    Remark(
        "Remark 11, end",
        "Nevertheless, the system can be non-Hamiltonian",
        "no example is given; that of Corollary 1 is one already for two angles",
    ),
    Remark(
        "Remark 12",
        "In the whole phase space the reduction may turn out to be impossible [42, 43]",
        "literature",
    ),
    Remark(
        "§4.1, before Theorem 4",
        "A similar result is valid for the averaging procedure in one-frequency systems [12].",
        "literature, of which no statement is given: averaging is a change of variables close to "
        "the identity in systems with a small parameter, and removes the angle to a given order of "
        "it alone, while that of Theorem 4 is exact",
    ),
    Remark(
        "§4.1, Lagrange–Lie integrable systems",
        "There is a coordinate on the invariant surface by which all others are quadratures; the "
        "dynamics is practically identical to that of integrable Hamiltonian systems",
        "a definition, and opinion; the formulas of the Lagrange top are claims",
    ),
)
