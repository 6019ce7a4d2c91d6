"""§8.1: the Chaplygin ball on a sphere, its equations, measure and integrals."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
    zero,
)
from nonholonomic.catalogue.ball_on_sphere import (
    ball_on_sphere_equations as ball,
    rubber_ball_ratio as rubber,
)
from nonholonomic.catalogue.vector_rates import rate
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import rolling_system
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere, Surface

from ..claim import Case, Claim, Remark
from ..methods import unspecified_systems

M, omega, gamma, n = vectors("M omega gamma n")
I = Diagonal("I")
#: Mass, radius of the body, signed radius of the supporting sphere, as `roll` names them.
m, R, a = real_symbol("m"), real_symbol("R"), real_symbol("a")
d, k = ball.d, ball.k
kappa = real_symbol("kappa")
HALF = sp.S.Half


def rolled(surface: Surface, *, hollow: bool = False) -> System:
    """The ball derived from mechanics; γ is n."""
    radius = 2.0 if hollow else 1.0
    return rolling_system(Body(1.0, (1.0, 1.5, 2.1), Ball(radius, hollow=hollow)), surface)


def dynamics() -> Case:
    """Ṁ = M×ω outside and around, with M the momentum about the contact point."""
    law = Identity("dynamics", rate(M) - cross(M, omega), "balance of momentum")
    return (rolled(Sphere(2.0)), law), (rolled(Sphere(1.0), hollow=True), law)


def kinematics(ratio: sp.Expr) -> tuple[System, Identity]:
    """ṅ = k n×ω with a given ratio k."""
    law = Identity("kinematics", rate(gamma) - ratio * cross(gamma, omega), "motion of the normal")
    return rolled(Sphere(2.0)), law


def momentum(sign: int, moment: sp.Expr) -> Case:
    """M = Iω ± d n×(n×ω) with a given d."""
    right_side = I * omega + sign * moment * cross(gamma, cross(gamma, omega))
    return rolled(Sphere(2.0)), Identity("momentum", M - right_side, "momentum about the contact")


def with_ratio(ratio: sp.Expr) -> System:
    """ṅ = `ratio` n×ω with arbitrary ω."""
    return unspecified_systems.system(
        "ratio",
        "a ball of the ratio given",
        {gamma: ratio * cross(gamma, omega), omega: zero},
        parameters=(
            Parameter(kappa, "a curvature", 0.0),
            Parameter(R, "radius of the body", 0.8),
            Parameter(a, "radius of the surface", 2.0),
        ),
    )


def flattened(ratio: sp.Expr) -> tuple[System, Identity]:
    """ṅ = n×ω if the curvature κ vanishes."""
    law = Identity("kinematics", rate(gamma) - cross(gamma, omega), "a plane", level=(kappa,))
    return with_ratio(ratio), law


def large_surface() -> Case:
    """The limit of a large radius, k = a/(a + R) with a = 1/κ, is the ball on a plane."""
    return kinematics(a / (a + R)), flattened(1 / (1 + R * kappa)), *on_plane()


def on_plane() -> tuple[tuple[System, Identity], ...]:
    """k = 1 is the ball on a plane."""
    law = Identity("kinematics", rate(gamma) - cross(gamma, omega), "motion of the normal")
    return (rolled(Plane()), law), (
        rolled(Plane()),
        Identity("dynamics", rate(M) - cross(M, omega), "balance of momentum"),
    )


def integrals() -> Case:
    """n², the energy and M², for every k."""
    system = ball.equations_on_sphere()
    return tuple(
        (system, Integral(name, value, name))
        for name, value in (
            ("length", norm_squared(n)),
            ("energy", HALF * dot(M, ball.omega)),
            ("momentum", norm_squared(M)),
        )
    )


def measure() -> Case:
    """ρ dω dn, for every k."""
    density = norm_squared(n) - d * dot(n, (I + d * identity) ** -1 * n)
    return ball.equations_in_omega(), Measure("measure", {density: HALF}, "invariant measure")


def radii(body: sp.Expr) -> Case:
    """k = a/(a − b) of a ball of radius a inside a hollow body is −1 for the given b."""
    ratio = a / (a - R)
    inside = rolled(Sphere(1.0), hollow=True)
    law = Identity("kinematics", rate(gamma) - ratio * cross(gamma, omega), "motion of the normal")
    turned = rate(gamma) + cross(gamma, omega)
    return (inside, law), (
        with_ratio(ratio),
        Identity("radii", turned, "motion of the normal for k = −1", level=(R - body,)),
    )


def linear_integral(shift: sp.Expr) -> Case:
    """The integral (AM, n) with A_i = ½ (ΣI + shift) − I_i, at k = −1."""
    tensor = (sp.Add(*I.symbols) + shift) / 2 * identity - I
    law = Integral("linear", dot(tensor * M, n), "linear integral", level=(k + 1,))
    return ball.equations_on_sphere(), law


def without_spin() -> Case:
    """The rubber ball with k = −1 has a further integral."""
    return rubber.rolling(), rubber.AROUND


CLAIMS = (
    Claim(
        "(8.1), M",
        r"The momentum about the point of contact obeys $\dot{\mathbf{M}} = \mathbf{M} \times "
        r"\boldsymbol{\omega}$.",
        dynamics,
        note="judged for a ball outside the sphere and for a hollow ball around it",
    ),
    Claim(
        "(8.1), n",
        r"$\dot{\mathbf{n}} = k\mathbf{n} \times \boldsymbol{\omega}$, $k = \frac{a}{a+b}$, where "
        "$a$ is the radius of the body and $b$ is the radius of the surface.",
        lambda: kinematics(R / (R + a)),
        lambda: kinematics(a / (a + R)),
        r"$k = \frac{a}{a+b}$, where $a$ is the radius of the surface and $b$ of the body; $a$ "
        "is negative for a ball inside, $b$ for a hollow ball around the sphere",
        "the two radii are exchanged in the text",
    ),
    Claim(
        "§8.1, M",
        r"$\mathbf{M} = \mathbf{I}\boldsymbol{\omega} + d\mathbf{n} \times (\mathbf{n} \times "
        r"\boldsymbol{\omega})$.",
        lambda: momentum(1, m * R**2),
        lambda: momentum(-1, m * R**2),
        r"$\mathbf{M} = \mathbf{I}\boldsymbol{\omega} + d\mathbf{n} \times (\boldsymbol{\omega} "
        r"\times \mathbf{n})$",
        "the sign of the second term, as in (7.1); as printed, d n(n×ω), it lacks the first ×",
    ),
    Claim(
        "§8.1, d",
        "$d = mb^2$, here $m$ is the mass of the body.",
        lambda: momentum(-1, m * R**2),
        note="with (8.1) corrected: b is the radius of the body, and the sign of the momentum",
    ),
    Claim(
        "§8.1, k = 1",
        r"The case $k = 1$ corresponds to $a \rightarrow \infty$, i.e. a ball is rolling over a "
        "plane.",
        large_surface,
        note="with (8.1) corrected: a is the radius of the surface",
    ),
    Claim(
        "(8.2)",
        r"For an arbitrary $k$ the system has the integrals $F_0 = (\mathbf{n}, \mathbf{n}) = 1$, "
        r"$H = \frac{1}{2}(\mathbf{M}, \boldsymbol{\omega})$, $F_1 = (\mathbf{M}, \mathbf{M})$.",
        integrals,
    ),
    Claim(
        "§8.1, after (8.2)",
        r"The measure $\rho d\boldsymbol{\omega} d\mathbf{n}$ is preserved, $\rho^2 = (\mathbf{n}, "
        r"\mathbf{n}) - d(\mathbf{n}, (\mathbf{I} + d)^{-1}\mathbf{n})$.",
        measure,
        note="judged on (n, n) = 1, for every k",
    ),
    Claim(
        "§8.1, before (8.3)",
        r"For $k = -1$ the radii of the body and the ball are connected by the equation "
        r"$\frac{b}{a} = \frac{1}{2}$.",
        lambda: radii(a / 2),
        lambda: radii(2 * a),
        r"$\frac{b}{a} = 2$ without the signs, $b = -2a$ with them, as in §9.2",
        "the two radii are exchanged once more: with a and b corrected in (8.1) b is that of the "
        "body, and the ball inside it is the smaller one",
    ),
    Claim(
        "(8.3)",
        r"For $k = -1$ there is the integral $F_2 = (\mathbf{A}\mathbf{M}, \mathbf{n})$ with "
        r"$\mathbf{A} = \text{diag}(\frac{1}{2}(-I_1 + I_2 + I_3), \frac{1}{2}(I_1 - I_2 + I_3), "
        r"\frac{1}{2}(I_1 + I_2 - I_3))$.",
        lambda: linear_integral(sp.S.Zero),
        lambda: linear_integral(d),
        r"$\mathbf{A} = \text{diag}(\frac{1}{2}(-J_1 + J_2 + J_3), \frac{1}{2}(J_1 - J_2 + J_3), "
        r"\frac{1}{2}(J_1 + J_2 - J_3))$, $J_i = I_i + d$",
        "I stands for J = I + d",
    ),
    Claim(
        "§8.1, after (8.3)",
        r"With the additional constraint $(\boldsymbol{\omega}, \mathbf{n}) = 0$ the system is "
        "also integrable for $k = -1$.",
        without_spin,
        note="what is proved is the further integral (9.4); with the measure "
        "(9.3) it makes the system integrable by the Euler–Jacobi theorem",
    ),
)

REMARKS = (
    Remark(
        "§8.1, after (8.1)",
        "A strategy for gyroscopes with a spherical rolling bearing was suggested by Contensou.",
        "history",
    ),
    Remark(
        "§8.1, after (8.1)",
        "The case $k = 1$ is known to be integrable and studied in many works.",
        "literature; its integrals are claims of §7",
    ),
)
