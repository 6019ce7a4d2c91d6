"""§1.4: the Chaplygin ball, the Veselova system, and a rubber body on a sphere."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient, outer
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
)
from nonholonomic.catalogue.bodies.rubber_body import any_rubber_body, general_on_sphere
from nonholonomic.catalogue.fixed_point.veselova_spinning import spinning_general
from nonholonomic.catalogue.vector_rates import rate
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.shapes import Ball, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Sphere

from ..claim import Case, Claim, Remark
from ..methods.arbitrary_motion import any_motion, driven, newton_euler, reduced_equation
from ..methods.rigid_body_in_space import POTENTIAL

M, omega, gamma, r, gammatilde, X = vectors("M omega gamma r gammatilde X")
rdot, gammadot, omegadot, torque = vectors("rdot gammadot omegadot torque")
I, A = Diagonal("I"), Diagonal("A")
m, R, a, kappa, nu, lambda_0 = (
    real_symbol(name) for name in ("m", "R", "a", "kappa", "nu", "lambda_0")
)
COUPLE = cross(gamma, gradient(POTENTIAL, gamma))
NUMBERS = (1.0, 1.5, 2.1)


@cache
def ball() -> System:
    """The Chaplygin ball in an unspecified potential, derived from mechanics."""
    return rolling_system(Body(1.0, NUMBERS, Ball(1.0)), field=Forces(potential=POTENTIAL))


@cache
def ball_on_sphere() -> System:
    """A rubber ball on a sphere in an unspecified potential, derived from mechanics."""
    body = Body(1.0, NUMBERS, Ball(1.0))
    return rolling_system(body, Sphere(3.0), "rubber", Forces(potential=POTENTIAL))


@cache
def ellipsoid_on_sphere() -> System:
    """A free rubber ellipsoid on a sphere, derived from mechanics."""
    body = Body(1.0, NUMBERS, Ellipsoid((1.0, 0.9, 0.8)))
    return rolling_system(body, Sphere(3.0), "rubber")


@cache
def over_sphere() -> System:
    """A body on a sphere in any motion: ω̇ and the rate of γ along the sphere are arbitrary."""
    system = any_motion()
    return replace(
        system,
        name="any-motion-over-sphere",
        field={omega: omegadot, gamma: gammadot, r: a * gammadot + a * cross(omega, gamma)},
        parameters=(
            *(p for p in system.parameters if p.symbol not in rdot.symbols),
            *(Parameter(s, "rate of the normal", 0.4 - i / 3) for i, s in enumerate(gammadot)),
            Parameter(a, "radius of the sphere", 3.0),
        ),
    )


# --- (1.20)–(1.22) -------------------------------------------------------------------------


def _ball_balance() -> sp.MatrixExpr:
    """The first equation (1.20), left minus right side; the radius is called R here."""
    lever = m * R**2
    right = COUPLE - lever * cross(gamma, cross(omega, rate(gamma)))

    def about_contact(vector: sp.MatrixExpr) -> sp.MatrixExpr:
        return I * vector + lever * vector - lever * dot(gamma, vector) * gamma

    return about_contact(rate(omega)) - cross(about_contact(omega), omega) - right


def chaplygin_ball() -> Case:
    """(1.20)."""
    return ball(), Identity("ball", (_ball_balance(), rate(gamma) - cross(gamma, omega)))


def contact_tensor() -> Case:
    """Ĩ of (1.20) maps ω to the momentum M about the contact point."""
    lever = m * R**2
    matrix = I + lever * identity - lever * outer(gamma, gamma)
    return ball(), Identity("tensor", matrix * omega - M)


def veselova() -> tuple[System, Identity]:
    """(1.21) with (1.22) preserves (ω, γ)."""
    right = cross(I * omega, omega) + COUPLE
    torque_0 = -dot(A * gamma, right) / dot(A * gamma, gamma)
    return spinning_general(), Identity(
        "veselova",
        (I * rate(omega) - right - torque_0 * gamma, Rate(dot(omega, gamma))),
    )


@cache
def bound(point: sp.MatrixExpr, torque_0: sp.Expr) -> System:
    """A body in arbitrary motion with a given contact point r and a given torque λ₀."""
    system = any_motion()
    return replace(
        system,
        name="any-motion-of-a-contact",
        definitions={r: point, lambda_0: torque_0},
        field=tuple(pair for pair in system.field if pair[0] != r),
        parameters=(
            *(p for p in system.parameters if p.symbol not in {lambda_0, *rdot.symbols}),
            Parameter(R, "radius of the ball", 0.8),
            Parameter(nu, "torque", 0.4),
        ),
        relations=(norm_squared(gamma) - 1,),
    )


def from_rolling() -> tuple[System, Identity]:
    """(1.17) for r = −Rγ, λ₀ = 0 is (1.20)."""
    return bound(-R * gamma, sp.S.Zero), Identity("ball", newton_euler() - _ball_balance())


def from_fixed_point() -> tuple[System, Identity]:
    """(1.17) for r = 0 is (1.21), for every λ₀."""
    right = cross(I * omega, omega) + COUPLE + nu * gamma
    left = I * rate(omega) - right
    return bound(constant([0, 0, 0]), nu), Identity("fixed_point", newton_euler() - left)


def from_unreduced() -> Case:
    """The ball is (1.17) with λ₀ = 0, the Veselova system (1.17) with r = 0 and (1.22)."""
    return from_rolling(), from_fixed_point(), veselova()


# --- (1.23) --------------------------------------------------------------------------------


def same_balance() -> Case:
    """Elimination of λ from (1.17) gives the form (1.18) on a sphere as well."""
    return over_sphere(), Identity("balance", newton_euler() - reduced_equation())


def kinematics() -> Case:
    """γ̇ + ω×γ = ṙ/a: the contact point moves over the body and the sphere at the same speed."""
    wander = rate(gamma) + cross(omega, gamma) - rate(r) / a
    return ellipsoid_on_sphere(), Identity("kinematics", wander)


def _ball_on_sphere(couple: sp.MatrixExpr) -> tuple[System, Identity]:
    """(1.23) for a ball on a sphere, multiplied by γ× so that λ₀ drops out."""
    point = -R * gamma
    inertia = I * rate(omega) + m * cross(point, cross(rate(omega), point))
    momentum = I * omega + m * cross(point, cross(omega, point))
    right = cross(momentum, omega) - m * cross(point, cross(omega, rate(point))) + couple
    return ball_on_sphere(), Identity("balance", cross(gamma, inertia - right))


def balance_printed() -> Case:
    """The couple γ×∂U/∂γ."""
    return _ball_on_sphere(COUPLE)


def balance() -> Case:
    """The couple γ×(E + W/a)⁻¹∂U/∂γ; W = RE for a ball. Energy is conserved for every shape."""
    system = general_on_sphere()
    (energy,) = system.integrals
    return _ball_on_sphere(a / (a + R) * COUPLE), (system, energy)


def spin_torque_printed() -> Case:
    """(1.19) as it stands, on a sphere."""
    system = ellipsoid_on_sphere()
    return system, Identity("spin_torque", lambda_0 + dot(gammatilde, X) / dot(gammatilde, gamma))


def spin_torque() -> Case:
    """(1.19) with (ω, γ̇) preserves the constraint for any tensor, bracket and γ̇."""
    system = driven(gammadot, dot(omega, gammadot))
    return system, Identity("spin", Rate(dot(omega, gamma)))


def plane_limit() -> Case:
    """For 1/a = 0 the equations are those on a plane, for every shape and potential."""
    flat = Identity(
        "plane",
        (gammadot - cross(gamma, omega), torque - COUPLE, dot(omega, gammadot)),
        level=(kappa,),
    )
    return any_rubber_body(kappa), flat


CLAIMS = (
    Claim(
        "§1.4, first sentences",
        "the equations of motion of the first two systems (the Chaplygin ball and the Veselova "
        "system) can be obtained as particular cases of system (1.18)",
        from_unreduced,
        note=r"the ball with $\lambda_0 = 0$ and $\mathbf r = -a\boldsymbol\gamma$, the Veselova "
        r"system with $\mathbf r = 0$. Of (1.18) with the λ₀ of (1.19), which keeps (ω, γ), the "
        "second alone is a case, since the ball may spin",
        erratum="(1.18) is printed for (1.17), which the next sentences name",
    ),
    Claim(
        "§1.4, before (1.20)",
        r"setting $\lambda_0=0$ and $\mathbf r=-a\boldsymbol\gamma$ in (1.17), where $a$ is the "
        "radius of the ball, we obtain the equations (1.20)",
        from_rolling,
    ),
    Claim(
        "(1.20)",
        r"$\tilde{\mathbf I}\dot{\boldsymbol\omega}=\tilde{\mathbf I}\boldsymbol\omega\times"
        r"\boldsymbol\omega-ma^2\boldsymbol\gamma\times(\boldsymbol\omega\times\dot{\boldsymbol"
        r"\gamma})+\boldsymbol\gamma\times\frac{\partial U}{\partial\boldsymbol\gamma}$, $\dot{"
        r"\boldsymbol\gamma}=\boldsymbol\gamma\times\boldsymbol\omega$",
        chaplygin_ball,
        note="checked with the mechanics of a rolling ball in an unspecified potential",
    ),
    Claim(
        "§1.4, after (1.20)",
        r"$\tilde{\mathbf I}=\mathbf I+ma^2\mathbf E-ma^2\boldsymbol\gamma\otimes\boldsymbol"
        r"\gamma$",
        contact_tensor,
    ),
    Claim(
        "(1.21)",
        r"setting $\mathbf r=0$ and $\boldsymbol\lambda=0$ in (1.17), we have $\mathbf I\dot{"
        r"\boldsymbol\omega}=\mathbf I\boldsymbol\omega\times\boldsymbol\omega+\boldsymbol\gamma"
        r"\times\frac{\partial U}{\partial\boldsymbol\gamma}+\lambda_0\boldsymbol\gamma$, $\dot{"
        r"\boldsymbol\gamma}=\boldsymbol\gamma\times\boldsymbol\omega$",
        from_fixed_point,
    ),
    Claim(
        "(1.22)",
        r"$\lambda_0=-\frac{(\mathbf I^{-1}\boldsymbol\gamma,\mathbf I\boldsymbol\omega\times"
        r"\boldsymbol\omega+\boldsymbol\gamma\times\frac{\partial U}{\partial\boldsymbol\gamma})}"
        r"{(\mathbf I^{-1}\boldsymbol\gamma,\boldsymbol\gamma)}$",
        veselova,
        note="with this λ₀ the motion preserves (ω, γ)",
    ),
    Claim(
        "§1.4, before (1.23)",
        r"if we denote by $\boldsymbol\gamma$ the normal of the sphere at the contact point, the "
        r"equations describing the evolution of the vector $\boldsymbol\omega$ remain the same as "
        "in system (1.18)",
        same_balance,
        note="as long as λ₀ and the couple of the forces are left open; what is printed for these "
        "is judged below",
    ),
    Claim(
        "(1.23), first equation",
        r"$\tilde{\mathbf I}\dot{\boldsymbol\omega}=\tilde{\mathbf I}\boldsymbol\omega\times"
        r"\boldsymbol\omega-m\mathbf r\times(\boldsymbol\omega\times\dot{\mathbf r})+\boldsymbol"
        r"\gamma\times\frac{\partial U}{\partial\boldsymbol\gamma}+\lambda_0\boldsymbol\gamma$",
        balance_printed,
        balance,
        r"$\tilde{\mathbf I}\dot{\boldsymbol\omega}=\tilde{\mathbf I}\boldsymbol\omega\times"
        r"\boldsymbol\omega-m\mathbf r\times(\boldsymbol\omega\times\dot{\mathbf r})+\boldsymbol"
        r"\gamma\times\left(\mathbf E+\frac1a\mathbf W\right)^{-1}\frac{\partial U}{\partial"
        r"\boldsymbol\gamma}+\lambda_0\boldsymbol\gamma$, where $\dot{\mathbf r}=-\mathbf W\dot{"
        r"\boldsymbol\gamma}$",
        "the couple of U(γ): since γ̇ = (E + W/a)⁻¹γ×ω, the printed one does not do the work of U; "
        "it is right only for U = 0 or a plane",
        argument="for every body: the couple of U is the one whose power is −(∂U/∂γ, γ̇) for every "
        "ω, and (E + W/a)⁻¹ is symmetric; computed are the ball and the energy of every shape",
    ),
    Claim(
        "(1.23), second equation",
        r"$\dot{\boldsymbol\gamma}+\boldsymbol\omega\times\boldsymbol\gamma=\frac1a\dot{"
        r"\mathbf r}$",
        kinematics,
        note="a > 0 outside the sphere; computed for an ellipsoid",
        argument="for every body: the contact wanders over the sphere with the velocity "
        "a(γ̇ + ω×γ), and over the body with ṙ, and without slip both are its velocity in space",
    ),
    Claim(
        "§1.4, after (1.23)",
        r"the undetermined multiplier $\lambda_0$ is defined by the same relations as on the plane",
        spin_torque_printed,
        spin_torque,
        r"$\lambda_0=-\frac{(\tilde{\mathbf I}^{-1}\boldsymbol\gamma,\dots)+(\boldsymbol\omega,"
        r"\dot{\boldsymbol\gamma})}{(\boldsymbol\gamma,\tilde{\mathbf I}^{-1}\boldsymbol\gamma)}$, "
        "with the bracket of (1.19) in place of the dots",
        "(1.19) lacks the term (ω, γ̇), which vanishes on a plane and for a ball, but not for "
        "another body on a sphere",
    ),
    Claim(
        "§1.4, limit",
        r"as $a\rightarrow\infty$, system (1.23) becomes system (1.18) on the plane",
        plane_limit,
        note="for every support function and potential, with (1.23) as corrected",
    ),
)

REMARKS = (
    Remark(
        "§1.4, after (1.23)",
        r"the tensor $\tilde{\mathbf I}$, the vector $(\boldsymbol\gamma)$",
        "read r(γ) for (γ)",
    ),
    Remark(
        "§1.4, after (1.20)",
        "one can assume that only forces depending on the normal of the plane act on the ball",
        "a choice of the problem",
    ),
    Remark(
        "§1.4, after (1.23)",
        r"Eqs. (1.23) constitute a closed system only in the case where the potential of external "
        r"forces depends only on the normal of the sphere $\boldsymbol\gamma$",
        "the meaning of closed: another potential introduces more variables, as gravity introduces "
        "the vertical",
    ),
)
