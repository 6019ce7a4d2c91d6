"""§3.4: global and local Casimir functions, the bracket of Suslov's problem."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import PoissonStructure
from flowlanes.system.system import System
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.fixed_point import suslov_bracket
from nonholonomic.catalogue.fixed_point.suslov_bracket import d, gamma_1, gamma_2, gamma_3, p_1, p_2

from ..claim import Case, Claim
from ..methods.catalogue_laws import law_named, printed_form
from ..methods.derived_verdicts import computed_verdict
from ..methods.unspecified_systems import system

# --- global and local Casimir functions ----------------------------------------------------


def _five() -> System:
    return CATALOGUE["suslov-bracket"].system()


def _kernel() -> int:
    return int(5 - suslov_bracket.bracket().matrix.rank())


def kernel_printed() -> Verdict:
    """The printed claim dim Ker J = m = 2 for (3.8)."""
    return Verdict(
        "kernel",
        "proven" if _kernel() == 2 else "refuted",
        finding=f"dim Ker J = {_kernel()} for the bracket of (3.8), which has m = 2",
        witness={"dim Ker J": _kernel(), "m": 2},
    )


def kernel_corrected() -> Verdict:
    """The corrected claim dim Ker J > m."""
    return Verdict(
        "kernel",
        "proven" if _kernel() > 2 else "refuted",
        finding=f"dim Ker J = {_kernel()} > m = 2 for the bracket of (3.8)",
    )


# --- the bracket of Suslov's problem -------------------------------------------------------


def in_suslovs_problem() -> Case:
    """Suslov's problem in the potential ½(γ, Cγ), with a principal axis, in new variables."""
    dynamics = CATALOGUE["suslov-quadratic"].system()
    return dynamics, law_named(dynamics, "bracket")


def solvable() -> Verdict:
    """The algebra is solvable: all brackets lie in the abelian span of p and γ₁, γ₂."""
    matrix = suslov_bracket.bracket().matrix
    order = suslov_bracket.ORDER
    derived = {s for entry in matrix for s in entry.free_symbols} - {d}
    abelian = all(matrix[order.index(a), order.index(b)] == 0 for a in derived for b in derived)
    linear = all(sp.Poly(entry, *order).is_homogeneous for entry in matrix if entry != 0)
    holds = abelian and linear and gamma_3 not in derived
    span = ", ".join(sorted(map(str, derived)))
    return Verdict(
        "solvable",
        "proven" if holds else "refuted",
        finding=f"the derived algebra, spanned by {span}, is abelian",
    )


def bracket_printed() -> Case:
    """(3.8) with {γ₁, γ₂} = p₁."""
    return _five(), printed_form(law_named(_five(), "bracket"))


def bracket_corrected() -> Case:
    """(3.8) with {γ₁, γ₃} = p₁."""
    return _five(), law_named(_five(), "bracket")


def hamiltonian_form() -> Case:
    """ẋ = {x, H} with H = ½γ², in the corrected bracket."""
    return _five(), law_named(_five(), "form")


def rank_two() -> Case:
    """The rank at a generic point."""
    return _five(), PoissonStructure("rank", suslov_bracket.bracket().matrix, rank=2)


def two_casimirs() -> Case:
    """p₁² + γ₁² and p₂² + γ₂²."""
    matrix = suslov_bracket.bracket().matrix
    casimirs = (p_1**2 + gamma_1**2, p_2**2 + gamma_2**2)
    return _five(), PoissonStructure("casimirs", matrix, casimirs=casimirs)


def only_two() -> Verdict:
    """Monomials in z₁ = p₁ + iγ₁, z₂ = p₂ + iγ₂ and their conjugates are weight vectors of {·, γ₃}.

    z₁^a z̄₁^b z₂^c z̄₂^e has the weight i((a − b) + d(c − e)). For irrational d it vanishes only
    if a = b and c = e, so that a Casimir function, which cannot depend on γ₃, is a series in Φ₁
    and Φ₂.
    """
    matrix = suslov_bracket.bracket().matrix
    order = suslov_bracket.ORDER
    place = order.index(gamma_3)

    def bracket_with_gamma_3(function: sp.Expr) -> sp.Expr:
        return sp.Add(*(matrix[i, place] * sp.diff(function, s) for i, s in enumerate(order)))

    first, second = p_1 + sp.I * gamma_1, p_2 + sp.I * gamma_2
    weights = {first: 1, p_1 - sp.I * gamma_1: -1, second: d, p_2 - sp.I * gamma_2: -d}
    holds = all(
        sp.expand(bracket_with_gamma_3(function) - sp.I * weight * function) == 0
        for function, weight in weights.items()
    )
    return computed_verdict(
        "casimirs",
        holds,
        "{z, γ₃} = iwz with w = 1, −1, d, −d; for irrational d only powers of |z₁|² and "
        "|z₂|² have weight zero",
        "the weights are not as expected",
    )


def no_leaf() -> Verdict:
    """The leaf {Φ₁ = 0, Φ₂ = 1} is a level surface: p₁ = γ₁ = 0 is invariant, of rank two."""
    matrix = suslov_bracket.bracket().matrix
    order = suslov_bracket.ORDER
    there = matrix.subs({p_1: 0, gamma_1: 0})
    still = all(entry == 0 for s in (p_1, gamma_1) for entry in there.row(order.index(s)))
    rank = there.subs({p_2: sp.Rational(3, 5), gamma_2: sp.Rational(4, 5)}).rank()
    level = 3 - sp.Matrix([sp.diff(p_2**2 + gamma_2**2, s) for s in (p_2, gamma_2, gamma_3)]).rank()
    refuted = still and rank == level
    return computed_verdict(
        "leaves",
        refuted,
        "the leaf of p₁ = γ₁ = 0, p₂² + γ₂² = 1 is the level surface Φ₁ = 0, Φ₂ = 1",
        "the leaf tried is no level surface",
        decision="refuted",
        witness={"rank of the bracket": rank, "dimension of the level surface": level},
    )


def _polar() -> System:
    rho_1, rho_2, phi_1, phi_2 = sp.symbols("rho_1 rho_2 phi_1 phi_2", real=True)
    energy = ((rho_1 * sp.sin(phi_1)) ** 2 + (rho_2 * sp.sin(phi_2)) ** 2 + gamma_3**2) / 2
    slope = -sp.diff(energy, phi_1) - d * sp.diff(energy, phi_2)
    field = {
        rho_1: sp.S.Zero,
        rho_2: sp.S.Zero,
        phi_1: gamma_3,
        phi_2: d * gamma_3,
        gamma_3: slope,
    }
    return system("polar", "(3.8) in polar coordinates", field, parameters=_five().parameters)


def leaves() -> Case:
    """In p_i = ρ_i cos φ_i, γ_i = ρ_i sin φ_i: {φ₁, γ₃} = 1, {φ₂, γ₃} = d, all others zero.

    A leaf is a line of slope d on the torus (φ₁, φ₂) times the γ₃-axis. For irrational d it is
    dense in the three-dimensional level of ρ₁ and ρ₂, on which a continuous function that is
    constant on the leaf must therefore be constant.
    """
    dynamics = _polar()
    rho_1, rho_2, phi_1, phi_2, _ = dynamics.symbols
    matrix = sp.zeros(5)
    for place, value in ((2, sp.S.One), (3, d)):
        matrix[place, 4], matrix[4, place] = value, -value
    casimirs = (rho_1, rho_2, d * phi_1 - phi_2)
    old = {
        p_1: rho_1 * sp.cos(phi_1),
        p_2: rho_2 * sp.cos(phi_2),
        suslov_bracket.gamma: sp.ImmutableDenseMatrix(
            [rho_1 * sp.sin(phi_1), rho_2 * sp.sin(phi_2), gamma_3]
        ),
    }
    return (
        (dynamics, PoissonStructure("leaves", matrix, casimirs=casimirs, rank=2)),
        (dynamics, Isomorphism("polar", _five(), old)),
    )


def third_casimir() -> Case:
    """Modulus squared and argument of Φ₃."""
    modulus = (p_1**2 + gamma_1**2) ** d / (p_2**2 + gamma_2**2)
    casimirs = (modulus, suslov_bracket.third_casimir())
    return _five(), PoissonStructure("third", suslov_bracket.bracket().matrix, casimirs=casimirs)


CLAIMS = (
    Claim(
        "§3.4, second situation",
        r"The number of globally defined Casimir functions is less than the number of locally "
        r"defined Casimir functions (i.e. $\dim(\operatorname{Ker}\mathbf{J}) = m$)",
        kernel_printed,
        kernel_corrected,
        r"$\dim(\operatorname{Ker}\mathbf{J}) > m$",
        "the equality of the first situation is repeated",
        argument="by Remark 9 the local Casimir functions are as many as dim Ker J has it; "
        "computed is (3.8)",
    ),
    Claim(
        "§3.4, solvable algebra",
        "The Poisson structure (3.8) is given by a solvable five-dimensional Lie algebra",
        solvable,
        note="for the corrected bracket",
    ),
    Claim(
        "§3.4, Suslov's problem",
        "The structure (3.8) occurs in Suslov's problem",
        in_suslovs_problem,
        note="derived: potential ½(γ, Cγ), a principal axis; p₁ = −ω₂/√κ, p₂ = ω₁/√μ, "
        "κ = (C₁ − C₃)/I₂, μ = (C₂ − C₃)/I₁, d = √(μ/κ), dτ = √κ dt",
    ),
    Claim(
        "(3.8)",
        r"$\{\gamma_1, \gamma_2\} = p_1$, $\{\gamma_2, \gamma_3\} = d p_2$, "
        r"$\{p_1, \gamma_3\} = -\gamma_1$, $\{p_2, \gamma_3\} = -d\gamma_2$ (the unwritten "
        "brackets are zero) is a Poisson structure",
        bracket_printed,
        bracket_corrected,
        r"$\{\gamma_1, \gamma_3\} = p_1$, the others as printed",
        "an index of the first bracket; as printed the Jacobi identity fails",
    ),
    Claim(
        "§3.4, before (3.8)",
        r"$\dot\gamma_i = \{\gamma_i, H\}$, $\dot p_j = \{p_j, H\}$, "
        r"$H = \frac12(\gamma_1^2 + \gamma_2^2 + \gamma_3^2)$",
        hamiltonian_form,
        note="with the corrected bracket: the equations of Suslov's problem",
    ),
    Claim(
        "§3.4, rank of (3.8)",
        "The rank of the bracket (3.8) is two",
        rank_two,
        note="with the corrected bracket",
    ),
    Claim(
        "§3.4, Casimir functions of (3.8)",
        r"$\Phi_1 = p_1^2 + \gamma_1^2$, $\Phi_2 = p_2^2 + \gamma_2^2$",
        two_casimirs,
        note="with the corrected bracket",
    ),
    Claim(
        "§3.4, irrational d",
        "In the case of irrational $d$ the Poisson structure has only two independent globally "
        "defined Casimir functions",
        only_two,
        argument="for every differentiable function: the flow of γ₃ turns p₁ + iγ₁ and p₂ + iγ₂ "
        "at the rates 1 and d, so that for irrational d its orbits are dense in the tori of "
        "constant Φ₁, Φ₂, and {p₁, γ₃} = −γ₁ excludes γ₃; computed are the rates",
    ),
    Claim(
        "§3.4, symplectic leaves of (3.8)",
        "For irrational $d$ none of the symplectic leaves of the bracket (3.8) can be represented "
        "as a level surface of a set of analytical functions",
        no_leaf,
        leaves,
        r"None of the leaves with $\Phi_1\Phi_2 \ne 0$ can",
        "the leaves with Φ₁ = 0 or Φ₂ = 0 are level surfaces",
    ),
    Claim(
        "Remark 10",
        r"The third Casimir function in complex form is "
        r"$\Phi_3 = (p_1 + i\gamma_1)^d/(p_2 + i\gamma_2)$",
        third_casimir,
        note="decided in real form, by modulus and argument; with the corrected bracket",
    ),
)
