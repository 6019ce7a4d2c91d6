"""§2.1: holonomic and nonholonomic constraints, by Frobenius and by the rubber ball on a plane."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import constant, cross, dot, norm_squared, real_symbol, vectors
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.bodies.rubber_body import any_rubber_body
from nonholonomic.mechanics.lagrangian.structure_functions import VectorField

from ..claim import Case, Claim, Remark
from ..methods import unspecified_systems
from ..methods.derived_verdicts import computed_verdict
from ..methods.growth_vector import growth, holonomic_count_verdict
from ..methods.rigid_body_in_space import COORDINATES, rotation_field, translation_field
from ..section_01.section_01_3a import rational_rotation

omega, gamma, r, R = vectors("omega gamma r R")
b, height = real_symbol("b"), real_symbol("R_3")
x, y, z = (real_symbol(name) for name in "xyz")
g_1, g_2, g_3 = gamma.symbols

#: The coefficients of ξ (angular velocity) and ζ (velocity), body axes.
Coefficients = tuple[sp.ImmutableDenseMatrix, sp.ImmutableDenseMatrix]

#: (2.3) as printed.
PRINTED: tuple[Coefficients, ...] = (
    (
        constant([1, 0, 0]),
        constant([-b * g_1 * g_2 / g_3, b * (g_1**2 + g_3**2) / g_3, -b * g_2]),
    ),
    (
        constant([0, 1, 0]),
        constant([-b * (g_2**2 + g_3**2) / g_3, b * g_1 * g_2 / g_3, b * g_1]),
    ),
)
#: (2.3) as it follows from (1.14) and (1.15).
ADMISSIBLE: tuple[Coefficients, ...] = (
    (
        constant([1, 0, -g_1 / g_3]),
        constant([b * g_1 * g_2 / g_3, -b * (g_1**2 + g_3**2) / g_3, b * g_2]),
    ),
    (
        constant([0, 1, -g_2 / g_3]),
        constant([b * (g_2**2 + g_3**2) / g_3, -b * g_1 * g_2 / g_3, -b * g_1]),
    ),
)


@cache
def directions() -> System:
    """A ball of radius b in some attitude, at rest."""
    return unspecified_systems.system(
        "directions",
        "Ball in an attitude",
        {gamma: constant([0, 0, 0])},
        parameters=(Parameter(b, "radius of the ball", 0.8),),
        relations=(norm_squared(gamma) - 1,),
    )


def fields(pairs: tuple[Coefficients, ...]) -> tuple[VectorField, ...]:
    """γ₃η₁ and γ₃η₂."""
    return tuple(field_of(coefficients) for coefficients in pairs)


def field_of(coefficients: Coefficients) -> VectorField:
    """γ₃ Σ (ω_k ξ_k + v_k ζ_k) on the redundant coordinates α, β, γ, R.

    The factor γ₃ makes the components polynomials; it does not change the span.
    """
    total: dict[sp.Symbol, sp.Expr] = {}
    for numbers, basis in zip(coefficients, (rotation_field, translation_field), strict=True):
        for axis, number in enumerate(numbers):
            for symbol, value in basis(axis).items():
                total[symbol] = total.get(symbol, sp.S.Zero) + g_3 * number * value
    return {symbol: sp.expand(value) for symbol, value in total.items()}


@cache
def ball_growth(pairs: tuple[Coefficients, ...] = ADMISSIBLE) -> tuple[int, ...]:
    """Growth of the span of (2.3), at a rational attitude."""
    place = (sp.Rational(1, 2), sp.Rational(-1, 3), sp.Rational(3, 7))
    point = dict(zip(COORDINATES, (*rational_rotation().flat(), *place), strict=True))
    return growth(fields(pairs), COORDINATES, point | {b: place[2]})


# --- the three possibilities ---------------------------------------------------------------

#: ż = xẏ, whose commutators span the space, and d(z − xy) = 0, a holonomic constraint.
CONTACT: tuple[VectorField, ...] = ({x: sp.S.One}, {y: sp.S.One, z: x})
FLAT: tuple[VectorField, ...] = ({x: sp.S.One, z: y}, {y: sp.S.One, z: x})
POINT = {x: sp.Rational(2, 3), y: sp.Rational(-1, 5), z: sp.S.Zero}


def _example(fields: tuple[VectorField, ...], claimed: int) -> Verdict:
    return holonomic_count_verdict(claimed, growth(fields, (x, y, z), POINT), 3)


def full_printed() -> Verdict:
    """The claim that a completely holonomic system has m = 1 holonomic constraint."""
    return _example(CONTACT, 1)


def full() -> Verdict:
    """A completely nonholonomic system has no holonomic constraint."""
    return _example(CONTACT, 0)


def least_printed() -> Verdict:
    """F_1, …, F_k with k = 2."""
    return _example(FLAT, 2)


def least() -> Verdict:
    """F_1, …, F_m with m = n − k = 1."""
    return _example(FLAT, 1)


def _of_ball(claimed: int) -> Verdict:
    return holonomic_count_verdict(claimed, ball_growth(), 6)


def between_printed() -> Verdict:
    """F_1, …, F_k with k = 2, for the rubber ball."""
    return _of_ball(2)


def between() -> Verdict:
    """The number of functions is dim M − dim L = 1."""
    return _of_ball(1)


# --- the ball ------------------------------------------------------------------------------


def _constraints(spin: sp.ImmutableDenseMatrix, velocity: sp.ImmutableDenseMatrix) -> Identity:
    """(1.14) with r = −bγ, and (1.15)."""
    return Identity("constraints", (velocity + cross(spin, -b * gamma), dot(spin, gamma)))


def first_printed() -> Case:
    """η₁ as printed."""
    return directions(), _constraints(*PRINTED[0])


def first() -> Case:
    """η₁ as corrected."""
    return directions(), _constraints(*ADMISSIBLE[0])


def second_printed() -> Case:
    """η₂ as printed."""
    return directions(), _constraints(*PRINTED[1])


def second() -> Case:
    """η₂ as corrected."""
    return directions(), _constraints(*ADMISSIBLE[1])


def dimension() -> Verdict:
    """dim L = 5: at most, since every field preserves R_3; at least, at a rational attitude."""
    both = (PRINTED, ADMISSIBLE)
    counts = [ball_growth(pairs) for pairs in both]
    level_rates = [sp.expand((gamma.entries.T * u)[0]) for pairs in both for _, u in pairs]
    reached = all(n[-1] == 5 for n in counts) and all(
        sp.cancel(value) == 0 for value in level_rates
    )
    shown = "; ".join(", ".join(map(str, n)) for n in counts)
    return computed_verdict(
        "dimension",
        reached,
        f"the span grows as {shown}, and every field keeps R_3",
        "another dimension at the attitude tried",
    )


def level() -> Case:
    """The rate of R_3 along both fields is zero."""
    return directions(), Identity("height", tuple(dot(gamma, v) for _, v in ADMISSIBLE))


def any_level() -> Case:
    """R_3 + (γ, r) is constant for every motion of a rubber body and support function."""
    system = any_rubber_body()
    lifted = replace(system, field=(*system.field, (height, dot(gamma, cross(r, omega)))))
    return lifted, Integral("level", height + dot(gamma, r))


SPAN = (
    "a function that is constant along the fields is so along their commutators, and hence along "
    "all of L; computed is the example"
)
FROBENIUS = f"{SPAN}. Conversely, Frobenius' theorem gives dim M − dim L such functions"

CLAIMS = (
    Claim(
        "§2.1, first possibility",
        r"if $\dim\mathcal L=\dim\mathcal M$, then the system of constraints (2.1) is completely "
        "holonomic",
        full_printed,
        full,
        r"if $\dim\mathcal L=\dim\mathcal M$, then the system of constraints (2.1) is completely "
        "nonholonomic",
        "'nonholonomic' is meant: no function is constant along all admissible paths; refuted by "
        "the constraint ż = xẏ",
        argument=SPAN,
    ),
    Claim(
        "§2.1, second possibility",
        r"if $\dim\mathcal L=k$, then the constraints can be represented in the form "
        r"$F_1(\mathbf q)=0,\dots,F_k(\mathbf q)=0$",
        least_printed,
        least,
        r"near every point, $F_1(\mathbf q)=0,\dots,F_m(\mathbf q)=0$ with $m=n-k$",
        "k is the dimension of the distribution; there are m = n − k constraints, each equal to "
        "a constant; refuted by ż = yẋ + xẏ, that is, z − xy = const",
        argument=FROBENIUS,
    ),
    Claim(
        "§2.1, third possibility",
        r"if $k<\dim\mathcal L<\dim\mathcal M$, there exist $\bar k=\dim\mathcal M-\dim\mathcal L$ "
        r"holonomic constraints that define the submanifold $\overline{\mathcal M}=\{\mathbf q|F_1"
        r"(\mathbf q)=0,\dots,F_k(\mathbf q)=0\}$",
        between_printed,
        between,
        r"$\overline{\mathcal M}=\{\mathbf q|F_1(\mathbf q)=0,\dots,F_{\bar k}(\mathbf q)=0\}$, "
        r"near a point about which $\dim\mathcal L$ is constant",
        "k̄ functions, not k; the rubber ball on a plane has k = 2, dim L = 5, k̄ = 1",
        argument=FROBENIUS,
    ),
    Claim(
        "(2.3), first field",
        r"$\boldsymbol\eta_1=\boldsymbol\xi_1-b\frac{\gamma_1\gamma_2}{\gamma_3}\boldsymbol\zeta_1+"
        r"b\frac{\gamma_1^2+\gamma_3^2}{\gamma_3}\boldsymbol\zeta_2-b\gamma_2\boldsymbol\zeta_3$",
        first_printed,
        first,
        r"$\boldsymbol\eta_1=\boldsymbol\xi_1-\frac{\gamma_1}{\gamma_3}\boldsymbol\xi_3+b\frac{"
        r"\gamma_1\gamma_2}{\gamma_3}\boldsymbol\zeta_1-b\frac{\gamma_1^2+\gamma_3^2}{\gamma_3}"
        r"\boldsymbol\zeta_2+b\gamma_2\boldsymbol\zeta_3$",
        "the term −(γ₁/γ₃)ξ₃ is missing, so that (ω, γ) ≠ 0, and the sign of b belongs to r = +bγ",
    ),
    Claim(
        "(2.3), second field",
        r"$\boldsymbol\eta_2=\boldsymbol\xi_2-b\frac{\gamma_2^2+\gamma_3^2}{\gamma_3}\boldsymbol"
        r"\zeta_1+b\frac{\gamma_1\gamma_2}{\gamma_3}\boldsymbol\zeta_2+b\gamma_1\boldsymbol\zeta_3$",
        second_printed,
        second,
        r"$\boldsymbol\eta_2=\boldsymbol\xi_2-\frac{\gamma_2}{\gamma_3}\boldsymbol\xi_3+b\frac{"
        r"\gamma_2^2+\gamma_3^2}{\gamma_3}\boldsymbol\zeta_1-b\frac{\gamma_1\gamma_2}{\gamma_3}"
        r"\boldsymbol\zeta_2-b\gamma_1\boldsymbol\zeta_3$",
        "the term −(γ₂/γ₃)ξ₃ is missing, so that (ω, γ) ≠ 0, and the sign of b belongs to r = +bγ",
    ),
    Claim(
        "§2.1, after (2.3)",
        r"the dimension of the linear span $\mathcal L$ of fields (2.3) and their commutators is "
        r"$\dim\mathcal L=5$",
        dimension,
        note="for (2.3) as printed and as corrected: the span grows as 2, 3, 5",
    ),
    Claim(
        "§2.1, before (2.4)",
        "the system of constraints (1.14), (1.15) is nonholonomic and admits a unique holonomic "
        "constraint",
        between,
    ),
    Claim(
        "(2.4)",
        r"the holonomic constraint has the form $R_3=b=\mathrm{const}$",
        level,
    ),
    Claim(
        "Remark 5",
        r"in the general case of an arbitrary (convex) body, the holonomic constraint is $R_3+"
        r"(\boldsymbol\gamma,\mathbf r(\boldsymbol\gamma))=0$",
        any_level,
        note="for every support function; its rate vanishes and its value is the height of the "
        "contact point",
    ),
)

REMARKS = (
    Remark(
        "(2.1), (2.2)",
        r"$\sum_i\hat a_{\mu i}(\mathbf q)w_i=0$, $\boldsymbol\eta_s=\sum_iw_i^{(s)}\mathbf E_i$",
        "definitions",
    ),
    Remark(
        "§2.1, first possibility",
        r"by the Rashevsky–Chow theorem, for any pair of points in $\mathcal M$ there exists an "
        "admissible path joining these points",
        "a theorem quoted with its proof; it needs a connected configuration space and the full "
        "dimension at every point",
    ),
    Remark(
        "§2.1, third possibility",
        "the restriction to this manifold is a completely nonholonomic system",
        "the definition of the span, restricted to the level of the functions that it keeps",
    ),
    Remark(
        "§2.1, after (2.3)",
        r"the coefficients of the vector fields $\boldsymbol\xi_i,\boldsymbol\eta_i$ are linearly "
        "independent solutions of system (1.14), (1.15)",
        r"read $\boldsymbol\zeta_i$ for $\boldsymbol\eta_i$; decided with (2.3)",
    ),
    Remark("§2.1, after Remark 5", "a geometric study can be found in [19, 20]", "literature"),
)
