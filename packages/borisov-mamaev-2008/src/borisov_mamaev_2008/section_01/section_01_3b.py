"""§1.3, from (1.17) on: equations of motion of a rubber body on a plane, and their reduction."""

from __future__ import annotations

from functools import cache
from itertools import product

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.angles import NORMAL, SPIN, in_angles, phi, phidot, theta, thetadot
from nonholonomic.catalogue.bodies.rubber_body import any_rubber_body
from nonholonomic.catalogue.vector_rates import rate
from nonholonomic.mechanics.lagrangian.structure_functions import lie_derivative

from ..claim import Case, Claim, Remark
from ..methods import unspecified_systems
from ..methods.arbitrary_motion import (
    any_motion,
    driven,
    newton_euler,
    reaction,
    reduced_equation,
    tensor,
)
from ..methods.derived_verdicts import computed_verdict
from ..methods.rigid_body_in_space import POTENTIAL, constrained, rotation_field, translation_field

alpha, beta, gamma, R, omega, v, r = vectors("alpha beta gamma R omega v r")
lambda_, X = vectors("lambda X")
I, K = Diagonal("I"), Symmetric("K")
m, lambda_0, psi = real_symbol("m"), real_symbol("lambda_0"), real_symbol("psi")
HALF = sp.Rational(1, 2)
THREE = range(3)
DIRECTIONS = (alpha, beta, gamma)
COUPLE = cross(gamma, gradient(POTENTIAL, gamma)) + cross(r, lambda_) + lambda_0 * gamma


@cache
def free_with_reactions() -> System:
    """The body of (1.17) with arbitrary reactions."""
    return constrained()


@cache
def touching() -> System:
    """A body in contact with arbitrary motion."""
    return any_motion()


# --- (1.17) --------------------------------------------------------------------------------


def newton() -> Case:
    """In space axes: m R̈ is the force, and the rate of the momentum Iω is the couple."""
    speed = [dot(direction, v) for direction in DIRECTIONS]
    residuals = [m * Rate(s) - dot(u, lambda_) for s, u in zip(speed, DIRECTIONS, strict=True)]
    residuals += [Rate(dot(u, I * omega)) - dot(u, COUPLE) for u in DIRECTIONS]
    work = Rate(POTENTIAL) + dot(cross(gamma, gradient(POTENTIAL, gamma)), omega)
    return free_with_reactions(), Identity("newton", (*residuals, work))


def _frame_terms(index: int, pairs: tuple[tuple[Vector, sp.ImmutableDenseMatrix], ...]) -> sp.Expr:
    """Σ c_ji^k (∂L/∂w_k) w_j, with c of (1.12), over pairs of velocities w and momenta."""
    return sp.Add(
        *(
            sp.LeviCivita(j, index, k) * momentum[k] * velocity.symbols[j]
            for velocity, momentum in pairs
            for j, k in product(THREE, repeat=2)
        )
    )


def suslov() -> Case:
    """(1.9) in the fields ξ, ζ with the constants of (1.12), for the constraints (1.14), (1.15)."""
    lagrangian = to_components(
        HALF * m * norm_squared(v) + HALF * dot(I * omega, omega) - POTENTIAL
    )
    slip, spin = to_components(v + cross(omega, r)), to_components(dot(omega, gamma))
    work = (to_components(lambda_).T * slip)[0] + lambda_0 * spin
    angular, linear = (constant([sp.diff(lagrangian, s) for s in u]) for u in (omega, v))
    residuals = []
    for i in THREE:
        turned = _frame_terms(i, ((omega, angular), (v, linear)))
        force = lie_derivative(rotation_field(i), lagrangian) + sp.diff(work, omega.symbols[i])
        residuals.append(Rate(angular[i]) - turned - force)
        turned = _frame_terms(i, ((omega, linear),))
        force = lie_derivative(translation_field(i), lagrangian) + sp.diff(work, v.symbols[i])
        residuals.append(Rate(linear[i]) - turned - force)
    return free_with_reactions(), Identity("suslov", tuple(residuals))


def rates() -> Case:
    """α̇ = α×ω, β̇ = β×ω, γ̇ = γ×ω and Ṙ."""
    residuals = [rate(u) - cross(u, omega) for u in DIRECTIONS]
    place = [Rate(s) - dot(u, v) for s, u in zip(R, DIRECTIONS, strict=True)]
    return free_with_reactions(), Identity("rates", (*residuals, *place))


# --- elimination of the multipliers --------------------------------------------------------


def _multiplier(sign: int) -> Case:
    """λ compared with ±(m ω̇×r + m ω×ṙ + m (r×ω)×ω)."""
    spin_rate, wander = rate(omega), rate(r)
    acceleration = cross(spin_rate, r) + cross(omega, wander) + cross(cross(r, omega), omega)
    return touching(), Identity("multiplier", reaction() - sign * m * acceleration)


def multiplier_printed() -> Case:
    """With the sign as printed."""
    return _multiplier(1)


def multiplier() -> Case:
    """With the opposite sign."""
    return _multiplier(-1)


def reduction() -> Case:
    """(1.18) is the second equation (1.17) with λ from the first, for all ω̇, ṙ and λ₀."""
    return touching(), Identity("reduction", newton_euler() - reduced_equation())


def contact_tensor() -> Case:
    """Ĩω = Iω + m r×(ω×r)."""
    value = tensor(omega) - I * omega - m * cross(r, cross(omega, r))
    return touching(), Identity("tensor", value)


def spin_torque() -> Case:
    """(1.18) with (1.19) preserves (ω, γ) for every symmetric tensor and bracket."""
    system = driven(cross(gamma, omega), sp.S.Zero)
    return system, Identity("spin", Rate(dot(omega, gamma)))


# --- angles and quadratures ----------------------------------------------------------------


@cache
def in_euler_angles() -> System:
    """An arbitrary motion with (ω, γ) = 0 in Euler angles."""
    nutation, rotation = real_symbol("s_1"), real_symbol("s_2")
    return unspecified_systems.system(
        "euler-angles",
        "Euler angles of a rubber body",
        {
            theta: thetadot,
            phi: phidot,
            psi: -sp.cos(theta) * phidot,
            thetadot: nutation,
            phidot: rotation,
        },
        parameters=(Parameter(nutation, "θ̈", 0.3), Parameter(rotation, "φ̈", -0.4)),
        definitions={omega: SPIN, gamma: NORMAL},
    )


def quadratures() -> Case:
    """ψ̇ is a function of θ, φ and their rates; α and β follow from ψ."""
    (sin_t, cos_t), (sin_f, cos_f), (sin_p, cos_p) = (
        (sp.sin(angle), sp.cos(angle)) for angle in (theta, phi, psi)
    )
    first = constant(
        [
            cos_f * cos_p - cos_t * sin_p * sin_f,
            -sin_f * cos_p - cos_t * sin_p * cos_f,
            sin_t * sin_p,
        ]
    )
    second = first.xreplace({psi: psi - sp.pi / 2}).applyfunc(sp.expand_trig)
    residuals = [rate(u) - cross(u, omega) for u in (first, second, gamma)]
    return in_euler_angles(), Identity(
        "quadratures", (*residuals, dot(omega, gamma), dot(first, second), dot(first, gamma))
    )


def evolution() -> Case:
    """(1.18) is a closed system in θ, φ and their rates."""
    system = in_angles(any_rubber_body())
    return system, system.laws[0]


def not_of_reactions() -> Verdict:
    """λ₀ is not a function of ω and λ: a rubber ball at rest, m = b = 1, in two attitudes.

    For ω = 0 the first equation of (1.17) is λ = ω̇×γ, so that ω̇ = γ×λ, and (1.18) is
    Ĩω̇ = τ + λ₀γ with Ĩ = I + E − γ⊗γ and a couple τ across γ, which a potential can have at
    both attitudes.
    """
    inertia, force = sp.diag(1, 2, 3), sp.Matrix([1, 0, 0])
    found = []
    for normal in (sp.Matrix([0, 0, 1]), sp.Matrix([0, 3, 4]) / 5):
        spin = normal.cross(force)
        turned = (inertia + sp.eye(3) - normal * normal.T) * spin
        multiplier = normal.dot(turned)
        assert spin.cross(normal) == force and normal.dot(turned - multiplier * normal) == 0
        found.append(multiplier)
    return computed_verdict(
        "arguments of λ₀",
        found[0] != found[1],
        f"ω = 0 and λ = (1, 0, 0) with λ₀ = {found[0]} at γ = (0, 0, 1), {found[1]} at (0, 3, 4)/5",
        "the multiplier is the same at both attitudes",
        decision="refuted",
        witness={"lambda_0": [str(value) for value in found]},
    )


CLAIMS = (
    Claim(
        "(1.17), equations of motion",
        r"$m\dot{\mathbf v}=m\mathbf v\times\boldsymbol\omega+\boldsymbol\lambda$, $\mathbf I"
        r"\dot{\boldsymbol\omega}=\mathbf I\boldsymbol\omega\times\boldsymbol\omega-\frac{"
        r"\partial U}{\partial\boldsymbol\gamma}\times\boldsymbol\gamma+\mathbf r\times"
        r"\boldsymbol\lambda+\lambda_0\boldsymbol\gamma$",
        newton,
        note="checked with the Newton–Euler equations in space axes, in an unspecified potential",
    ),
    Claim(
        "(1.17), from (1.9)",
        "writing Eqs. (1.9) taking (1.12) and (1.13) into account, we obtain the system (1.17)",
        suslov,
        note="with (1.9) and (1.11) as corrected",
    ),
    Claim(
        "(1.17), kinematics",
        r"$\dot{\boldsymbol\alpha}=\boldsymbol\alpha\times\boldsymbol\omega$, $\dot{\boldsymbol"
        r"\beta}=\boldsymbol\beta\times\boldsymbol\omega$, $\dot{\boldsymbol\gamma}=\boldsymbol"
        r"\gamma\times\boldsymbol\omega$, $\dot R_1=(\boldsymbol\alpha,\mathbf v)$, $\dot R_2="
        r"(\boldsymbol\beta,\mathbf v)$, $\dot R_3=(\boldsymbol\gamma,\mathbf v)$",
        rates,
    ),
    Claim(
        "§1.3, before (1.18)",
        r"$\boldsymbol\lambda=m\dot{\boldsymbol\omega}\times\mathbf r+m\boldsymbol\omega\times"
        r"\dot{\mathbf r}+m(\mathbf r\times\boldsymbol\omega)\times\boldsymbol\omega$",
        multiplier_printed,
        multiplier,
        r"$\boldsymbol\lambda=-m\dot{\boldsymbol\omega}\times\mathbf r-m\boldsymbol\omega\times"
        r"\dot{\mathbf r}-m(\mathbf r\times\boldsymbol\omega)\times\boldsymbol\omega$",
        "the sign of the whole right side",
    ),
    Claim(
        "(1.18)",
        r"$\tilde{\mathbf I}\dot{\boldsymbol\omega}=\tilde{\mathbf I}\boldsymbol\omega\times"
        r"\boldsymbol\omega-m\mathbf r\times(\boldsymbol\omega\times\dot{\mathbf r})+\boldsymbol"
        r"\gamma\times\frac{\partial U}{\partial\boldsymbol\gamma}+\lambda_0\boldsymbol\gamma$, "
        r"$\tilde{\mathbf I}=\mathbf I+m\mathbf r^2\mathbf E-m\mathbf r\otimes\mathbf r$",
        reduction,
        note="for every contact point r that moves in any way and an unspecified potential: "
        "equivalent to (1.17)",
    ),
    Claim(
        "§1.3, after (1.18)",
        r"$\tilde{\mathbf I}\boldsymbol\omega=\mathbf I\boldsymbol\omega+m\mathbf r\times"
        r"(\boldsymbol\omega\times\mathbf r)$",
        contact_tensor,
    ),
    Claim(
        "§1.3, before (1.19)",
        r"the undetermined multiplier $\lambda_0=\lambda_0(\boldsymbol\omega,\boldsymbol\lambda)$ "
        "can be found from the constraint equation (1.15)",
        not_of_reactions,
        spin_torque,
        r"$\lambda_0=\lambda_0(\boldsymbol\omega,\boldsymbol\gamma)$",
        "λ for γ: (1.19) is a function of ω and γ",
    ),
    Claim(
        "(1.19)",
        r"$\lambda_0=-\frac{(\tilde{\mathbf I}^{-1}\boldsymbol\gamma,\tilde{\mathbf I}\boldsymbol"
        r"\omega\times\boldsymbol\omega-m\mathbf r\times(\boldsymbol\omega\times\dot{\mathbf r})+"
        r"\boldsymbol\gamma\times\frac{\partial U}{\partial\boldsymbol\gamma})}{(\boldsymbol\gamma,"
        r"\tilde{\mathbf I}^{-1}\boldsymbol\gamma)}$ can be found from the constraint equation "
        "(1.15)",
        spin_torque,
        note="on a plane, where γ̇ = γ×ω; on a sphere see (1.23)",
    ),
    Claim(
        "§1.3, after (1.19)",
        r"for given $\boldsymbol\omega$ and $\boldsymbol\gamma$ we can find $\boldsymbol\alpha,"
        r"\boldsymbol\beta$, and $\mathbf R$ from (1.17) by quadratures",
        quadratures,
        note="the quadrature is ψ̇ = −cos θ φ̇; then Ṙ is a known function of time by (1.17)",
    ),
    Claim(
        "§1.3, Euler angles",
        r"Eqs. (1.18) describe only the evolution of the angles $\theta$ and $\varphi$",
        evolution,
        note="for every support function and potential: (1.18) is a closed system of second order "
        "for θ, φ, equivalent to the one for ω, γ",
    ),
)

REMARKS = (
    Remark(
        "(1.17)",
        r"$\dot{\mathbf R}_1$, $\dot{\mathbf R}_2$, $\dot{\mathbf R}_3$",
        "the components are scalars: bold type is a slip",
    ),
)
