"""§6.3, from (6.13): the isomorphism of the Veselova system with the Neumann system.

A Hamiltonian system on e(3) is read as in (6.11), see :mod:`section_06_3a`.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import ConformallyHamiltonian, Identity, Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, to_components
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import e3, from_catalogue
from nonholonomic.catalogue.e3 import Gamma, I, M
from nonholonomic.catalogue.fixed_point import veselova as catalogue, veselova_geodesic as geodesic
from nonholonomic.catalogue.fixed_point.clebsch import alpha, beta
from nonholonomic.catalogue.fixed_point.neumann import c
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim
from ..methods.derived_verdicts import computed_verdict
from .section_06_3a import DET, INVERSE_ROOT, MOMENTS, NUMBERS, S, flow, free_flow, off_level

I_1, I_2, I_3 = I.symbols
k = real_symbol("k")
HALF = sp.Rational(1, 2)

#: L of Proposition 6; s is shared with the inverse of (6.11).
L = INVERSE_ROOT * M


# --- (6.13), Proposition 6 -----------------------------------------------------------------


def both_terms() -> Case:
    """The two terms of (6.13)."""
    return (
        (flow(), Integral("first", geodesic.FIRST)),
        (flow(), Integral("second", geodesic.SECOND)),
    )


def kirchhoff(s: MatrixExpr, momentum: MatrixExpr) -> tuple[MatrixExpr, MatrixExpr]:
    """ṡ/k and L̇/k of (6.14), for L = `momentum`."""
    place = alpha * cross(s, momentum) + beta * cross(s, I * momentum)
    turning = cross(momentum, I * momentum) - c * DET * cross(s, I**-1 * s)
    return place, alpha * c * cross(s, I * s) + beta * turning


def kirchhoff_equations(sign: int) -> tuple[tuple[System, Integral], tuple[System, Identity]]:
    """(6.14) with k = `sign` √det I, along (6.13) with c = M²(Γ, IΓ)/det I."""
    level = norm_squared(M) * dot(Gamma, I * Gamma) / DET
    factor = sign * sp.sqrt(DET)
    place, turn = (to_components(v).subs(c, to_components(level)) for v in kirchhoff(S, L))
    system = flow()
    return (
        (system, Integral("level", level)),
        (system, Identity("kirchhoff", (rate(S) - factor * place, rate(L) - factor * turn))),
    )


def proposition() -> Case:
    """The map with k = √det I, also onto the Clebsch case in the catalogue."""
    target = from_catalogue("clebsch")
    return (*kirchhoff_equations(1), (flow(), geodesic.to_clebsch(target)))


def new_variables() -> Case:
    """s² = Γ² and (M, Γ) = 0 ⇔ (s, L) = 0."""
    share = dot(S, L) * geodesic.LENGTH - dot(M, Gamma)
    return off_level(), Identity("variables", (norm_squared(S) - norm_squared(Gamma), share))


def first_case_s(sign: int, share: int) -> Case:
    """ṡ for α = 1, β = 0 and any (M, Γ)."""
    along = dot(S, L) / dot(S, I**-1 * S)
    value = cross(S, L) + share * along * cross(S, I**-1 * S)
    return off_level(), Identity("s", rate(S) - sign * sp.sqrt(DET) * value)


def first_case_l(sign: int) -> Case:
    """L̇ for α = 1, β = 0 and any (M, Γ)."""
    value = dot(I * L, L) / (DET * dot(S, I**-1 * S)) * cross(S, I * S)
    return off_level(), Identity("L", rate(L) - sign * sp.sqrt(DET) * value)


def value_of_constant_6_13() -> Case:
    """Check the value of the constant of (6.13): (IL, L)/(s, I⁻¹s) = M²(Γ, IΓ)."""
    value = dot(I * L, L) / dot(S, I**-1 * S) - norm_squared(M) * dot(Gamma, I * Gamma)
    return off_level(), Identity("c", value)


# --- the Hamiltonians after Proposition 6 --------------------------------------------------


def quadratic(tensor: MatrixExpr) -> tuple[sp.Expr, sp.Expr]:
    """The factors of kα and kβ after (6.14), the last term with (Γ, `tensor` Γ)."""
    first = HALF * norm_squared(M) + c / 2 * dot(Gamma, I * Gamma)
    return first, HALF * dot(M, I * M) - c / 2 * DET * dot(Gamma, tensor * Gamma)


@cache
def field_6_14() -> System:
    """(6.14) with L and s named M and Γ, and any constant k."""
    place, turn = kirchhoff(Gamma, M)
    weights = [(c, 0.8), (alpha, 1.0), (beta, 0.7), (k, 1.0)]
    return System(
        name="kirchhoff",
        title="The equations (6.14)",
        parameters=(
            *e3.inertia_parameters(MOMENTS),
            *(Parameter(s, "constant of (6.14)", value) for s, value in weights),
        ),
        field={M: k * turn, Gamma: k * place},
        relations=(norm_squared(Gamma) - 1,),
    )


def quadratic_hamiltonian(tensor: MatrixExpr) -> Case:
    """(6.14) is generated on e(3) by kα(…) + kβ(…)."""
    first, other = quadratic(tensor)
    return field_6_14(), ConformallyHamiltonian(
        "hamiltonian", sp.S.One, e3.bracket(), k * alpha * first + k * beta * other
    )


def neumann_case() -> Case:
    """α = 1, β = 0, k = 1: the Neumann system."""
    first, _ = quadratic(I)
    (energy,) = (law for law in from_catalogue("neumann").integrals if law.name == "energy")
    system = from_catalogue("neumann")
    return (
        (system, Identity("H", first - energy.value)),
        (system, ConformallyHamiltonian("hamiltonian", sp.S.One, e3.bracket(), first)),
    )


def bruns_case() -> Case:
    """α = 0, β = 1: a body with the tensor of inertia I⁻¹ in the field ½ν(Γ, I⁻¹Γ)."""
    _, other = quadratic(I**-1)
    strength = -c * DET
    value = HALF * dot(M, I * M) + HALF * strength * dot(Gamma, I**-1 * Gamma)
    return field_6_14(), Identity("bruns", other - value)


def clebsch_case() -> Case:
    """Clebsch's condition Σ (C₂ − C₃)/A₁ = 0 for H = ½(M, AM) + ½(Γ, CΓ)."""
    A = [alpha + beta * s for s in I.symbols]
    C = [alpha * c * s - beta * c * DET / s for s in I.symbols]
    value = sp.Add(*((C[i - 2] - C[i - 1]) / A[i] for i in range(3)))
    return field_6_14(), Identity("clebsch", value)


def brackets_change() -> Verdict:
    """{L₁, s₁} is non-zero, so the map does not preserve the bracket up to a factor."""
    variables = (*M.symbols, *Gamma.symbols)
    first, place = (to_components(to_components(v)[0]) for v in (L, S))
    slopes = [sp.Matrix([sp.diff(f, x) for x in variables]) for f in (first, place)]
    value = (slopes[0].T * sp.Matrix(e3.lie_poisson(M, Gamma)) * slopes[1])[0]
    verdict = prove(free_flow(), Identity("bracket", value))
    changed = verdict.decision == "refuted"
    return computed_verdict(
        "brackets change",
        changed,
        "{L₁, s₁} is not zero at a point",
        verdict.reason,
        witness=verdict.witness,
    )


def theorem_8() -> Case:
    """ρ_ω ω and γ in the time dτ = dt/ρ_ω."""
    return from_catalogue("veselova"), catalogue.onto_neumann(NUMBERS)


K_SIGN = (
    r"$\dot{s} = k(\alpha s \times L + \beta s \times IL)$, "
    r"$\dot{L} = k(\alpha c s \times Is + \beta(L \times IL - c(\det I)s \times I^{-1}s))$, "
)
SIGN_NOTE = "wrong sign of the whole, with the equations (6.11)"

CLAIMS = (
    Claim(
        "(6.13)",
        r"Both terms of $H = \alpha\frac{1}{2}M^2(\Gamma, I\Gamma) + "
        r"\beta\frac{1}{2}((M, IM)(\Gamma, I\Gamma) - (M, I\Gamma)^2)$ are first integrals of the "
        r"system on $(M, \Gamma) = 0$.",
        both_terms,
    ),
    Claim(
        "Proposition 6, (6.14)",
        r"On $\frac{M^2(\Gamma, I\Gamma)}{\det I} = c$, $(M, \Gamma) = 0$ the field of (6.13) is "
        "isomorphic to that of the Clebsch case, "
        + K_SIGN
        + r"$k = -\sqrt{\det I}$, with $L = I^{-1/2}M$, "
        r"$s = (\Gamma, I\Gamma)^{-1/2}I^{1/2}\Gamma$.",
        lambda: kirchhoff_equations(-1),
        proposition,
        r"$k = \sqrt{\det I}$",
        "wrong sign of k with the equations (6.11); it agrees with the printed bracket, which has "
        "the wrong sign itself",
    ),
    Claim(
        "Proposition 6, proof, relations",
        r"$s^2 = \Gamma^2 = 1$, $(M, \Gamma) = (s, L) = 0$",
        new_variables,
        note="the two products vanish together",
    ),
    Claim(
        "Proposition 6, proof, ṡ",
        r"For $\alpha = 1$, $\beta = 0$: $\dot{s} = -\sqrt{\det I}\left(s \times L + "
        r"(s, L)\frac{s \times I^{-1}s}{(s, I^{-1}s)}\right)$",
        lambda: first_case_s(-1, 1),
        lambda: first_case_s(1, -1),
        r"$\dot{s} = \sqrt{\det I}\left(s \times L - "
        r"(s, L)\frac{s \times I^{-1}s}{(s, I^{-1}s)}\right)$",
        "wrong sign of the second term against the first; " + SIGN_NOTE,
    ),
    Claim(
        "Proposition 6, proof, L̇",
        r"For $\alpha = 1$, $\beta = 0$: $\dot{L} = -\sqrt{\det I}\frac{(IL, L)}"
        r"{\det I(s, I^{-1}s)}s \times Is$",
        lambda: first_case_l(-1),
        lambda: first_case_l(1),
        r"$\dot{L} = \sqrt{\det I}\frac{(IL, L)}{\det I(s, I^{-1}s)}s \times Is$",
        SIGN_NOTE,
    ),
    Claim(
        "Proposition 6, proof, c",
        r"$\frac{(IL, L)}{(s, I^{-1}s)} = M^2(\Gamma, I\Gamma) = c\det I$",
        value_of_constant_6_13,
    ),
    Claim(
        "§6.3, before (6.13)",
        "The transformation does not conserve the Poisson brackets.",
        brackets_change,
    ),
    Claim(
        "§6.3, after Proposition 6, Hamiltonian",
        r"With constant c, (6.14) is generated on e(3) by "
        r"$H = k\alpha(\frac{1}{2}M^2 + \frac{c}{2}(\Gamma, I\Gamma)) + "
        r"k\beta(\frac{1}{2}(M, IM) - \frac{c}{2}\det I(\Gamma, I\Gamma))$.",
        lambda: quadratic_hamiltonian(I),
        lambda: quadratic_hamiltonian(I**-1),
        r"$H = k\alpha(\frac{1}{2}M^2 + \frac{c}{2}(\Gamma, I\Gamma)) + "
        r"k\beta(\frac{1}{2}(M, IM) - \frac{c}{2}\det I(\Gamma, I^{-1}\Gamma))$",
        "missing inverse in the last term",
    ),
    Claim(
        "§6.3, α = 1, β = 0",
        r"If $\alpha = 1$, $\beta = 0$, this is the Hamiltonian of the Neumann case.",
        neumann_case,
    ),
    Claim(
        "§6.3, α = 0, β = 1",
        r"At $\alpha = 0$, $\beta = 1$ this is the Hamiltonian of the Bruns problem.",
        bruns_case,
        note="with the corrected Hamiltonian, "
        r"$\frac{1}{2}(M, IM) - \frac{c}{2}\det I(\Gamma, I^{-1}\Gamma)$, for a body with the "
        r"tensor of inertia $I^{-1}$",
    ),
    Claim(
        "§6.3, any α, β",
        r"With arbitrary $\alpha$, $\beta$, this Hamiltonian corresponds to the general Clebsch "
        "case in the Kirchhoff equations.",
        clebsch_case,
        note="with the corrected Hamiltonian; decided by Clebsch's condition "
        "Σ (C₂ − C₃)/A₁ = 0 for H = ½(M, AM) + ½(Γ, CΓ)",
    ),
    Claim(
        "Theorem 8",
        r"After time substitution, the vector field of the Veselova problem with $U = 0$ on the "
        r"level $H = h$ becomes isomorphic to that of the Neumann problem.",
        theorem_8,
        note="with the variables ρ_ω ω and γ, the time dτ = dt/ρ_ω and c = 2h/det I",
    ),
)
