"""§1.3, from (1.10) to (1.16): configuration space, kinematics, constraints and energies."""

from __future__ import annotations

from functools import cache
from itertools import product

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    to_components,
    vectors,
)
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.bodies.any_shape import SUPPORT
from nonholonomic.catalogue.bodies.rubber_body import any_rubber_body
from nonholonomic.catalogue.vector_rates import rate
from nonholonomic.mechanics.lagrangian.structure_functions import VectorField, lie_derivative
from nonholonomic.mechanics.rolling.attitude import rotation

from ..claim import Case, Claim, Remark
from ..methods import unspecified_systems
from ..methods.derived_verdicts import computed_verdict
from ..methods.rigid_body_in_space import (
    COORDINATES,
    bracket,
    moving,
    rotation_field,
    translation_field,
)

alpha, beta, gamma, R, omega, v, r, c = vectors("alpha beta gamma R omega v r c")
velocity = Vector("velocity")
THREE = range(3)
HALF = sp.Rational(1, 2)
DIRECTIONS = (alpha, beta, gamma)
#: Q of (1.10), with the columns α, β, γ.
Q = sp.ImmutableDenseMatrix.hstack(*(to_components(u) for u in DIRECTIONS))


@cache
def body() -> System:
    """A body in space that moves with arbitrary ω and v."""
    return moving()


@cache
def rubber() -> System:
    """A rubber body of any shape on a plane."""
    return any_rubber_body()


def _same(first: VectorField, second: VectorField) -> list[sp.Expr]:
    return [first.get(s, sp.S.Zero) - second.get(s, sp.S.Zero) for s in COORDINATES]


def _multiple(field: VectorField, number: sp.Expr) -> VectorField:
    return {symbol: number * value for symbol, value in field.items()}


# --- (1.10)–(1.13) -------------------------------------------------------------------------


def orthogonal() -> Case:
    """Q has orthonormal columns and a constant determinant along the motion."""
    return body(), Identity("orthogonal", (Q * Q.T - sp.eye(3), Q.det() - 1))


def redundant() -> Verdict:
    """The rank of the six relations between the nine direction cosines, at a rational rotation."""
    relations = [
        dot(first, second) for i, first in enumerate(DIRECTIONS) for second in DIRECTIONS[: i + 1]
    ]
    symbols = COORDINATES[:9]
    point = dict(zip(symbols, rational_rotation().flat(), strict=True))
    rows = [[sp.diff(to_components(f), s).xreplace(point) for s in symbols] for f in relations]
    rank = sp.Matrix(rows).rank()
    return computed_verdict(
        "redundant",
        0 < rank == len(relations),
        f"nine coordinates with {rank} independent relations: three are free",
    )


def rational_rotation() -> sp.ImmutableDenseMatrix:
    """A rotation with rational entries, rows α, β, γ."""
    quaternion = (sp.Rational(1, 5), sp.Rational(2, 5), sp.Rational(-2, 5), sp.Rational(4, 5))
    symbols = tuple(moving().symbols[:4])
    return constant(rotation().xreplace(dict(zip(symbols, quaternion, strict=True))))


def turning() -> Case:
    """Check that the rate of any function of the attitude is Σ ω_k ξ_k applied to it.

    The ξ_k are the rotation fields.
    """
    function = sp.Function("h_f")(*COORDINATES[:9])
    total = sp.Add(*(w * lie_derivative(rotation_field(k), function) for k, w in enumerate(omega)))
    return body(), Identity("turning", Rate(function) - total)


def shifting_printed() -> Case:
    """ζ_k with the index i, summed over as in ξ_k, so that it does not depend on k."""
    total = [sp.Add(*v.symbols) * sp.Add(*direction.symbols) for direction in DIRECTIONS]
    return body(), Identity("shifting", rate(R) - constant(total))


def shifting() -> Case:
    """The rate of any function of R is Σ v_k ζ_k applied to it."""
    fields = [_multiple(translation_field(k), w) for k, w in enumerate(v)]
    total = [sp.Add(*(field[symbol] for field in fields)) for symbol in R]
    return body(), Identity("shifting", rate(R) - constant(total))


def commutators() -> Case:
    """The commutators of ξ and ζ, component by component."""
    residuals: list[sp.Expr] = []
    for i, j in product(THREE, repeat=2):
        k = next((n for n in THREE if sp.LeviCivita(i, j, n) != 0), 0)
        sign = sp.LeviCivita(i, j, k)
        residuals += _same(
            bracket(rotation_field(i), rotation_field(j)), _multiple(rotation_field(k), sign)
        )
        residuals += _same(
            bracket(rotation_field(i), translation_field(j)), _multiple(translation_field(k), sign)
        )
        residuals += _same(bracket(translation_field(i), translation_field(j)), {})
    return body(), Identity("commutators", tuple(residuals))


def rates_of_attitude() -> Case:
    """Q̇ = ω̃Q with ω̃_ij = ε_ijk ω_k."""
    tilde = sp.Matrix(
        3, 3, lambda i, j: sum(sp.LeviCivita(i, j, k) * w for k, w in enumerate(omega))
    )
    change = sp.ImmutableDenseMatrix.hstack(*(to_components(rate(u)) for u in DIRECTIONS))
    return body(), Identity("attitude", change - constant(tilde) * Q)


def rates_of_place() -> Case:
    """Ṙ = Q⁻¹v, in the form QṘ = v."""
    return body(), Identity("place", Q * to_components(rate(R)) - to_components(v))


# --- constraints ---------------------------------------------------------------------------


def no_slip() -> Case:
    """The velocity of the point r of the body is v + ω×r."""
    point = constant([x + dot(u, r) for x, u in zip(R, DIRECTIONS, strict=True)])
    slip = to_components(v + cross(omega, r))
    return body(), Identity("no_slip", rate(point) - constant(Q.T * slip))


def inward_normal() -> Case:
    """γ = −∇f/|∇f| for any f: a unit normal to f = 0 in the direction of decreasing f."""
    surface = sp.Function("f_s")(*r.symbols)
    slope = gradient(surface, r)
    length = sp.sqrt(norm_squared(slope))
    normal = -slope / length
    wandering = unspecified_systems.system(
        "wandering",
        "A point on a surface",
        {r: velocity},
        parameters=tuple(
            Parameter(s, "velocity", 0.3 + i / 5) for i, s in enumerate(velocity.symbols)
        ),
    )
    across = Rate(surface) + length * dot(normal, velocity)
    falling = dot(slope, normal) + length
    return wandering, Identity("normal", (norm_squared(normal) - 1, across, falling))


def no_spin() -> Case:
    """(ω, γ) is the third component of the angular velocity in space."""
    return body(), Identity("no_spin", (rotation() * to_components(omega))[2] - dot(omega, gamma))


# --- energies ------------------------------------------------------------------------------


def kinetic() -> Case:
    """The energy of a unit mass at r: the part linear in r, and (ω, (r² − r⊗r)ω)."""
    turned = norm_squared(r) * norm_squared(omega) - dot(r, omega) ** 2
    split = HALF * norm_squared(v) + dot(cross(v, omega), r) + HALF * turned
    return body(), Identity("kinetic", HALF * norm_squared(v + cross(omega, r)) - split)


def height() -> Case:
    """−(r, γ) increases with the height of the centre of mass: its rate is (v, γ) with v = r×ω."""
    return rubber(), Identity("height", Rate(dot(r, gamma)) + dot(gamma, cross(r, omega)))


def weight() -> Case:
    """∂(r, γ)/∂γ × γ = r×γ: the couple of U = −mg(r, γ) is that of the reaction mgγ at r."""
    slope = gradient(SUPPORT, gamma, "h")
    lever = dot(c, gamma) + (dot(gamma, slope) - SUPPORT) * norm_squared(gamma) - dot(gamma, slope)
    arm = constant([sp.diff(to_components(lever), s) for s in gamma])
    return rubber(), Identity("weight", cross(arm, gamma) - cross(r, gamma))


CLAIMS = (
    Claim(
        "(1.10)",
        r"$\mathbf Q$ with the columns $\boldsymbol\alpha,\boldsymbol\beta,\boldsymbol\gamma$, the "
        r"projections of the orths of the immovable space on the movable axes, is an orthogonal "
        r"matrix, $\mathbf Q\in SO(3)$",
        orthogonal,
        note="with a unit quaternion as attitude; every attitude has one",
    ),
    Claim(
        "Remark 4",
        r"$\alpha_i,\beta_i,\gamma_i$ define redundant coordinates on $SO(3)$",
        redundant,
    ),
    Claim(
        "(1.11), first line",
        r"$\boldsymbol\omega=\sum_k\omega_k\boldsymbol\xi_k$, $\boldsymbol\xi_k=-\sum_{i,j}"
        r"\varepsilon_{kij}\left(\alpha_i\frac\partial{\partial\alpha_j}+\beta_i\frac\partial{"
        r"\partial\beta_j}+\gamma_i\frac\partial{\partial\gamma_j}\right)$",
        turning,
        note="checked with the rate ½q(0, ω) of the quaternion",
    ),
    Claim(
        "(1.11), second line",
        r"$\mathbf v=\sum_kv_k\boldsymbol\zeta_k$, $\boldsymbol\zeta_k=\alpha_i\frac\partial{"
        r"\partial R_1}+\beta_i\frac\partial{\partial R_2}+\gamma_i\frac\partial{\partial R_3}$",
        shifting_printed,
        shifting,
        r"$\boldsymbol\zeta_k=\alpha_k\frac\partial{\partial R_1}+\beta_k\frac\partial{\partial "
        r"R_2}+\gamma_k\frac\partial{\partial R_3}$",
        "the index of α, β, γ is k; as printed, i is free (read as summed over, as in ξ_k)",
    ),
    Claim(
        "(1.12)",
        r"$[\boldsymbol\xi_i,\boldsymbol\xi_j]=\varepsilon_{ijk}\boldsymbol\xi_k$, $[\boldsymbol"
        r"\xi_i,\boldsymbol\zeta_j]=\varepsilon_{ijk}\boldsymbol\zeta_k$, $[\boldsymbol\zeta_i,"
        r"\boldsymbol\zeta_j]=0$",
        commutators,
        note="with [u, w] = uw − wu and ζ_k as corrected",
    ),
    Claim(
        "(1.13), first equation",
        r"$\dot{\mathbf Q}=\tilde{\boldsymbol\omega}\mathbf Q$ with $\tilde\omega_{ij}="
        r"\varepsilon_{ijk}\omega_k$",
        rates_of_attitude,
        note="this ω̃ is minus the matrix of u ↦ ω×u, as it must be for α̇ = α×ω",
    ),
    Claim(
        "(1.13), second equation",
        r"$\dot{\mathbf R}=\mathbf Q^{-1}\mathbf v$",
        rates_of_place,
    ),
    Claim(
        "(1.14)",
        r"the velocity of the contact point vanishes: $\mathbf v+\boldsymbol\omega\times\mathbf "
        "r=0$",
        no_slip,
    ),
    Claim(
        "§1.3, before (1.15)",
        r"if $f(\mathbf r)=0$ is the equation of the surface, $\boldsymbol\gamma=-\frac{\nabla "
        r"f(\mathbf r)}{|\nabla f(\mathbf r)|}$",
        inward_normal,
        note="for every f: this is the unit vector across the surface along which f falls; the "
        "normals of body and plane are opposite to each other",
        where=("f < 0 inside the body",),
    ),
    Claim(
        "(1.15)",
        r"the projection of the angular velocity on the normal of the plane vanishes: $(\boldsymbol"
        r"\omega,\boldsymbol\gamma)=0$",
        no_spin,
    ),
    Claim(
        "§1.3, before (1.16)",
        r"$T=\frac12m\mathbf v^2+\frac12(\boldsymbol\omega,\mathbf I\boldsymbol\omega)$",
        kinetic,
        note="v is the velocity of the centre of mass",
        argument="summed over the masses of any body: Σ m r = 0 about the centre of mass, and "
        "Σ m (r²E − r⊗r) is I",
    ),
    Claim(
        "(1.16)",
        r"$U=mgh=-mg(\mathbf r,\boldsymbol\gamma)$",
        height,
        note="for an unspecified support function: −(r, γ) changes as the height of the centre of "
        "mass",
    ),
    Claim(
        "§1.3, after (1.16)",
        r"since $\mathbf r=\mathbf r(\boldsymbol\gamma)$, the potential depends only on "
        r"$\boldsymbol\gamma$, $U=U(\boldsymbol\gamma)$",
        weight,
        note="decided as: the couple −∂U/∂γ×γ of (1.17) is that of the weight and of its support, "
        "for an unspecified support function",
    ),
)

REMARKS = (
    Remark(
        "§1.3",
        r"the pair $(\mathbf R,\mathbf Q)\in\mathbb R^3\otimes SO(3)$ uniquely determines the "
        "position of the body",
        "definition of the configuration space",
    ),
    Remark(
        "§1.3, before (1.11)",
        "projections on the movable axes $Oxyz$",
        "the movable axes are called $Cxyz$ everywhere else",
    ),
    Remark(
        "§1.3, before (1.15)",
        r"if the body is elsewhere convex, $\mathbf r$ can be uniquely expressed through "
        r"$\boldsymbol\gamma$",
        "the Gauss map of a closed strictly convex surface is one to one: a theorem of geometry; "
        "read 'everywhere' for 'elsewhere'",
    ),
    Remark(
        "§1.3, after (1.15)",
        "in the Euler angles the constraints have a cumbersome form",
        "judgement",
    ),
    Remark("§1.3", "mechanical realizations of the constraints; names of the systems", "history"),
)
