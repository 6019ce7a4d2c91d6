"""§9.4 and §9.5: trajectory isomorphism; separation of variables for k = −1."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import constant, cross, dot, norm_squared, real_symbol, vectors, zero
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.ball_on_sphere import (
    power_potential_on_sphere as point,
    rubber_ball_on_e3 as e3,
    rubber_ball_ratio as ratio,
    rubber_ball_separated as separated,
)
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_on_e3 import KINETIC, STIFFNESS
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_ratio import DET_J, RHO_SQUARED, A, J, k
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_separated import (
    LEVER,
    SPREAD,
    TRACE,
    WITH_DENSITY,
    rho,
    roots,
    u,
    v,
)
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_sphero_conical import cubic

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import contrary
from ..methods.quadratic_integrals import no_quadratic_integral
from ..obstructions.normal_variational_equations import no_second_integral
from .section_09_3 import with_point, z

omega, n, M, gamma = vectors("omega n M gamma")
h = real_symbol("h")

M_RATE, GAMMA_RATE = (constant([Rate(s) for s in vector.symbols]) for vector in (M, gamma))

# --- §9.4 ----------------------------------------------------------------------------------

ANY_F, ANY_G = sp.Function("F")(*M.symbols), sp.Function("G")(*gamma.symbols)
#: H̃ of (9.16), with a separate symbol h for the value of the energy.
REGULAR = ANY_F - h / ANY_G


def on_level() -> System:
    """The Hamiltonian system of H = GF, with the value of the energy called h."""
    return replace(e3.product(ANY_G, ANY_F), definitions={h: ANY_G * ANY_F})


def factors() -> Case:
    """(9.14) is a product of a function of γ and one of M."""
    system = e3.hamiltonian_form()
    energy = system.integrals[0]
    return system, Identity("product", energy.value - STIFFNESS * KINETIC, "energy as a product")


def product_equations() -> Case:
    """(9.15)."""
    slope = gradient(ANY_F, M, "F")
    inverse = gradient(1 / ANY_G, gamma, "1/G")
    values = (
        M_RATE - ANY_G * (cross(M, slope) - ANY_F * ANY_G * cross(gamma, inverse)),
        GAMMA_RATE - ANY_G * cross(gamma, slope),
    )
    return e3.any_product(), Identity("equations", values, "equations of motion of H = GF")


def regular_momentum() -> Case:
    """(9.16), the first equation."""
    turning = cross(M, gradient(REGULAR, M, "H")) + cross(gamma, gradient(REGULAR, gamma, "H"))
    return on_level(), Identity("momentum", M_RATE / ANY_G - turning, "rate of M in the time s")


def regular_direction(as_printed: bool) -> Case:
    """(9.16), the second equation; ∂H̃/∂s as printed is zero."""
    swing = zero if as_printed else cross(gamma, gradient(REGULAR, M, "H"))
    return on_level(), Identity("direction", GAMMA_RATE / ANY_G - swing, "rate of γ in the time s")


def zero_level() -> Case:
    """H̃ = 0 on FG = h."""
    return on_level(), Identity("level", REGULAR, "H̃ on the level of the energy")


def onto_point() -> Case:
    """The map from (9.14), in the time G dt = ds, to (9.17) with h = (det J / k²) 𝓗."""
    energy = STIFFNESS * KINETIC
    law = Isomorphism(
        "regularisation",
        point.moving(),
        {M: M, gamma: gamma},
        time=STIFFNESS,
        constants={h: DET_J / k**2 * energy},
        onto=(point.HAMILTONIAN,),
    )
    return e3.hamiltonian_form(), law


def from_ball() -> Case:
    """The map from (9.2) to (9.17)."""
    return ratio.rolling(), ratio.to_sphere()


def potential() -> Case:
    """V of (9.17), with −h for h."""
    stretch = dot(gamma, J * gamma)
    excess = point.HAMILTONIAN - norm_squared(M) / 2 + h * stretch ** (-1 / k)
    return point.moving(), Identity("potential", excess, "potential energy of the point")


def geodesic_part() -> Case:
    """M² = γ′²: the kinetic energy is that of a unit mass on a unit sphere."""
    return point.moving(), Identity(
        "kinetic", norm_squared(M) - norm_squared(GAMMA_RATE), "velocity of the point"
    )


# --- §9.5 ----------------------------------------------------------------------------------

COORDINATES = {rho: sp.sqrt(RHO_SQUARED), **roots(u, v, *WITH_DENSITY)}


def in_coordinates(name: str, equations: Sequence[sp.Expr], *levels: sp.Expr) -> Case:
    """Equations that u, v satisfy on the phase space of (9.2)."""
    return with_point(), Identity(name, tuple(equations), quantities=COORDINATES, level=levels)


def conics(factor: sp.Expr) -> Case:
    """g(z) as a product."""
    partial = sp.Add(
        *(s**2 * a / (j - z) for s, a, j in zip(n.symbols, A.symbols, J.symbols, strict=True))
    )
    return in_coordinates("conics", [partial - factor * (z - u) * (z - v) / cubic(z)])


def squares() -> Case:
    """nᵢ² in u and v."""
    equations = []
    for s, own in zip(n.symbols, J.symbols, strict=True):
        others = sp.Mul(*(own - j for j in J.symbols if j != own))
        equations.append(s**2 - RHO_SQUARED * own * (own - u) * (own - v) / others)
    return in_coordinates("squares", equations)


def radius() -> Case:
    """ρ² in u and v."""
    return in_coordinates("radius", [RHO_SQUARED - SPREAD])


def kinetic() -> Case:
    """T in u and v, with u̇ = N u′."""
    share = Rate(u) ** 2 / cubic(u) - Rate(v) ** 2 / cubic(v)
    printed = DET_J * SPREAD**2 * (u - v) / 8 * share / rho**6
    excess = dot(omega, J * omega) / 2 - printed
    return separated.canonical_form(), Identity("kinetic", excess, "kinetic energy")


def multiplier(exponent: sp.Rational) -> Case:
    """N of (9.9) in u and v, for k = −1."""
    excess = ratio.REDUCING - (TRACE - u - v) ** exponent
    return in_coordinates("multiplier", [excess], k + 1)


def momenta() -> Case:
    """p = N ∂T/∂q̇ for the canonical equations of H."""
    system = separated.canonical_form()
    factor = LEVER / rho**6
    p_u, p_v = separated.p_u, separated.p_v
    values = (
        p_u - factor * Rate(u) / cubic(u),
        p_v + factor * Rate(v) / cubic(v),
        separated.H - separated.HAMILTONIAN,
    )
    return system, Identity("momenta", values, "momenta of u and v")


def canonical() -> Case:
    """The canonical equations of H, mapped to (9.2)."""
    return separated.canonical_form(), separated.to_ball()


def separable() -> Case:
    """The separated equations, in the canonical variables and on (9.2) itself."""
    system = separated.canonical_form()
    return (
        (system, separated.separation_law()),
        (system, separated.momenta()),
        (system, separated.CONSTANT),
        (ratio.rolling(), separated.separation()),
    )


HALVES = sp.Rational(3, 2)


def integrable() -> Verdict:
    """The statement refuted by `no_second_integral`."""
    return contrary(no_second_integral())


CLAIMS = (
    Claim(
        "§9.4, product",
        r"The Hamiltonian (9.14) is the product of two functions, one of which depends on "
        r"$\mathbf M$ and the other on $\boldsymbol\gamma$: $\mathcal H = "
        r"G(\boldsymbol\gamma)F(\mathbf M)$.",
        factors,
    ),
    Claim(
        "(9.15)",
        r"$\dot{\mathbf M} = G\left(\mathbf M\times\frac{\partial F}{\partial\mathbf M} - "
        r"FG\,\boldsymbol\gamma\times\frac{\partial G^{-1}}{\partial\boldsymbol\gamma}\right)$, "
        r"$\dot{\boldsymbol\gamma} = G\,\boldsymbol\gamma\times"
        r"\frac{\partial F}{\partial\mathbf M}$.",
        product_equations,
        note="for unspecified functions F and G",
    ),
    Claim(
        "(9.16), first equation",
        r"With $G\,dt = ds$, $FG = h$: $\frac{d\mathbf M}{ds} = \mathbf M\times"
        r"\frac{\partial\tilde{\mathcal H}}{\partial\mathbf M} + \boldsymbol\gamma\times"
        r"\frac{\partial\tilde{\mathcal H}}{\partial\boldsymbol\gamma}$, $\tilde{\mathcal H} = "
        r"F(\mathbf M) - \frac{h}{G(\boldsymbol\gamma)}$.",
        regular_momentum,
    ),
    Claim(
        "(9.16), second equation",
        r"$\frac{d\boldsymbol\gamma}{ds} = \boldsymbol\gamma\times"
        r"\frac{\partial\tilde{\mathcal H}}{\partial\mathbf s}$.",
        lambda: regular_direction(True),
        lambda: regular_direction(False),
        r"$\frac{d\boldsymbol\gamma}{ds} = \boldsymbol\gamma\times"
        r"\frac{\partial\tilde{\mathcal H}}{\partial\mathbf M}$",
        "the derivative is by M; H̃ does not depend on s, so that as printed γ would stand still",
    ),
    Claim(
        "§9.4, after (9.16)",
        r"On a fixed level $\mathcal H = h$ the system (9.15) is trajectory-equivalent to the "
        r"system (9.16) with $\tilde{\mathcal H} = 0$.",
        zero_level,
        note="that H̃ = 0 is the level FG = h; the equivalence is (9.16)",
    ),
    Claim(
        "(9.17)",
        r"For the Hamiltonian (9.14) we have $\tilde{\mathcal H} = \frac12\mathbf M^2 - "
        r"h(\boldsymbol\gamma,\mathbf J\boldsymbol\gamma)^{-1/k}$, $h = \text{const}$.",
        onto_point,
        note="the constant h is det J / k² times the one of (9.16), the value of 𝓗",
        erratum="one letter for two constants, the h of (9.16) and the h of (9.17)",
    ),
    Claim(
        "§9.4, isomorphism",
        r"The system (9.2) is trajectory-equivalent to the motion of a point on a sphere, (9.17).",
        from_ball,
        note="from ω, n and t directly; h is (det J / k²) times the energy",
    ),
    Claim(
        "§9.4, after (9.17)",
        r"The Hamiltonian (9.17) describes the motion of a material point on a sphere (under the "
        r"condition $(\mathbf M,\boldsymbol\gamma) = 0$).",
        geodesic_part,
        note="shown: |γ′|² = M² on (M, γ) = 0, besides the equations (9.16)",
    ),
    Claim(
        "§9.4, potential",
        r"(9.17) describes the motion in a potential field with potential "
        r"$V = h(\boldsymbol\gamma,\mathbf J\boldsymbol\gamma)^{-1/k}$.",
        potential,
        note="with any constant h",
        erratum="h of (9.17) with the opposite sign",
    ),
    Claim(
        "§9.4, Braden",
        r"Integrable potentials correspond to $k = 1$ (Braden's system).",
        lambda: (point.moving(), point.BRADEN),
        note="V = −h/(γ, Jγ); the integral is ½(M, J⁻¹M) − h (tr J⁻¹ − (γ, J⁻¹γ))/(γ, Jγ)",
    ),
    Claim(
        "§9.4, Neumann",
        r"Integrable potentials correspond to $k = -1$ (Neumann's system).",
        lambda: (point.moving(), point.NEUMANN),
        note="V = −h(γ, Jγ); the integral is ½(M, JM) + h det J (γ, J⁻¹γ)",
    ),
    Claim(
        "§9.4, other k",
        r"In the other cases an additional integral quadratic in $\mathbf M$ does not exist.",
        no_quadratic_integral,
        note="for every k with k² ≠ 1 and integrals on all levels of the energy; with two equal "
        "eigenvalues the square of a component of M is one",
        where=("J has three different eigenvalues",),
    ),
    Claim(
        "§9.4, integrability for other k",
        "In the other cases the Hamiltonian system (9.17) is likely integrable.",
        integrable,
        no_second_integral,
        r"Not in all other cases: for $k = -\frac12$ and a $\mathbf J$ with three different "
        r"eigenvalues there is no second integral that is meromorphic in $\mathbf M$ and "
        r"$\boldsymbol\gamma$.",
        "“not” is missing, as the next sentences show; by the theorem of Morales and Ramis, from "
        "the variations of a motion along a great circle. In particular no integral is a "
        "polynomial in M of any degree with coefficients rational in γ. Other k are not decided",
    ),
    Claim(
        "§9.5, g(z)",
        r"$g(z) = \sum_{i=1}^3\frac{n_i^2}{J_i(J_i-z)} = \frac{(z-u)(z-v)}{(\det\mathbf J)A(z)}$.",
        lambda: conics(1 / DET_J),
        lambda: conics(RHO_SQUARED),
        r"$g(z) = \rho^2\frac{(z-u)(z-v)}{A(z)}$, $\rho^2 = (\mathbf n,\mathbf J^{-1}\mathbf n)$",
        "the factor is ρ² and not 1/det J, as z → ∞ shows",
    ),
    Claim(
        "§9.5, nᵢ²",
        r"$n_1^2 = \rho^2\frac{J_1(J_1-u)(J_1-v)}{(J_1-J_2)(J_1-J_3)}$ and so on in turn.",
        squares,
        note="J₁ < u < J₂ < v < J₃ follows as in §9.3",
    ),
    Claim(
        "§9.5, ρ²",
        r"$\rho^2 = (\mathbf n,\mathbf J^{-1}\mathbf n) = \left(\sum_iJ_i-u-v\right)^{-1}$.",
        radius,
    ),
    Claim(
        "§9.5, T",
        r"$T = \frac{\det\mathbf J\,\rho^4(u-v)}{8}\left(\frac{\dot u^2}{A(u)} - "
        r"\frac{\dot v^2}{A(v)}\right)$.",
        kinetic,
    ),
    Claim(
        "§9.5, N",
        r"$\mathcal N = \left(\sum_iJ_i-u-v\right)^{-3/2}$.",
        lambda: multiplier(-HALVES),
        lambda: multiplier(HALVES),
        r"$\mathcal N = \left(\sum_iJ_i-u-v\right)^{3/2}$",
        "the sign of the exponent: for k = −1 (9.9) gives N = ρ⁻³",
    ),
    Claim(
        "§9.5, momenta",
        r"$p_u = \mathcal N\frac{\partial T}{\partial\dot u}$, $p_v = \mathcal N"
        r"\frac{\partial T}{\partial\dot v}$.",
        momenta,
        note="shown as p = N² ∂T/∂q′ with q′ = dq/dτ, for the H that follows and the N corrected",
    ),
    Claim(
        "§9.5, 𝓗",
        r"After $\mathcal N dt = d\tau$ we obtain the canonical equations of $\mathcal H = "
        r"\frac{2}{\det\mathbf J\left(\sum_iJ_i-u-v\right)(u-v)}(A(u)p_u^2 - A(v)p_v^2)$.",
        canonical,
        note="with the exponent of N corrected",
    ),
    Claim(
        "§9.5, separation",
        r"The coordinates $u$ and $v$ are separable.",
        separable,
        note="A(z)p_z² = ½ det J (𝓗z(tr J − z) − C) for z = u, v; on (9.2) itself "
        "y² = A(z)(2hz(tr J − z) − F) with y = ½ (det J)^(1/2) ρ (u − v) ż and F of (9.4), F = 2C",
    ),
)

REMARKS = (
    Remark(
        "§9.4, after (9.16)",
        "In celestial mechanics this procedure is known as regularization and traces back to "
        "Bolin and Levi-Civita.",
        "history",
    ),
    Remark(
        "§9.4, after (9.17)",
        "Integrals of higher degree in momenta still may exist.",
        "not decided but for $k = -\\frac12$, see above",
    ),
)
