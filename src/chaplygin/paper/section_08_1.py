"""§8.1: the Chaplygin ball on a sphere, its equations, measure and integrals."""

from __future__ import annotations

import sympy as sp

from ..mechanics.body import Body
from ..mechanics.rolling import roll
from ..mechanics.shapes import Ball
from ..mechanics.surfaces import Plane, Sphere, Surface
from ..statements import Identity, Integral, Measure
from ..system import System
from ..systems import ball_on_sphere_equations as ball
from ..systems import rubber_ball_ratio as rubber
from ..systems.rates import rate
from ..vectors import Diagonal, cross, dot, identity, normed, scalar, vectors
from .claim import Case, Claim, Remark

M, omega, gamma, n = vectors("M omega gamma n")
I = Diagonal("I")
#: Mass, radius of the body, signed radius of the supporting sphere, as `roll` names them.
m, R, a = scalar("m"), scalar("R"), scalar("a")
d, k = ball.d, ball.k
HALF = sp.S.Half


def rolled(surface: Surface, *, hollow: bool = False) -> System:
    """The ball as it follows from mechanics; γ is n."""
    radius = 2.0 if hollow else 1.0
    return roll(Body(1.0, (1.0, 1.5, 2.1), Ball(radius, hollow=hollow)), surface)


def dynamics() -> Case:
    """Ṁ = M×ω outside and around, with M the momentum about the contact."""
    law = Identity("dynamics", rate(M) - cross(M, omega), "balance of momentum")
    return (rolled(Sphere(2.0)), law), (rolled(Sphere(1.0), hollow=True), law)


def kinematics(ratio: sp.Expr) -> Case:
    """ṅ = k n×ω with the ratio given."""
    law = Identity("kinematics", rate(gamma) - ratio * cross(gamma, omega), "motion of the normal")
    return rolled(Sphere(2.0)), law


def momentum(sign: int, moment: sp.Expr) -> Case:
    """M = Iω ± d n×(n×ω) with d given."""
    made = I * omega + sign * moment * cross(gamma, cross(gamma, omega))
    return rolled(Sphere(2.0)), Identity("momentum", M - made, "momentum about the contact")


def on_plane() -> Case:
    """k = 1 is a ball on a plane."""
    law = Identity("kinematics", rate(gamma) - cross(gamma, omega), "motion of the normal")
    return (rolled(Plane()), law), (
        rolled(Plane()),
        Identity("dynamics", rate(M) - cross(M, omega), "balance of momentum"),
    )


def integrals() -> Case:
    """n², the energy and M², for every k."""
    made = ball.equations()
    return tuple(
        (made, Integral(name, value, name))
        for name, value in (
            ("length", normed(n)),
            ("energy", HALF * dot(M, ball.omega)),
            ("momentum", normed(M)),
        )
    )


def measure() -> Case:
    """ρ dω dn, for every k."""
    density = normed(n) - d * dot(n, (I + d * identity) ** -1 * n)
    return ball.equations_in_omega(), Measure("measure", {density: HALF}, "invariant measure")


def radii() -> Case:
    """A body of radius 2 with its inner surface on a ball of radius 1: ṅ = −n×ω."""
    law = Identity(
        "kinematics",
        rate(gamma) + cross(gamma, omega),
        "motion of the normal for k = −1",
        on=(R - 2 * a,),
    )
    return rolled(Sphere(1.0), hollow=True), law


def linear(shift: sp.Expr) -> Case:
    """(AM, n) with A_i = ½ (ΣI + shift) − I_i, at k = −1."""
    tensor = (sp.Add(*I.symbols) + shift) / 2 * identity - I
    law = Integral("linear", dot(tensor * M, n), "linear integral", on=(k + 1,))
    return ball.equations(), law


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
        "$d = mb^2$, where $b$ is the radius of the surface.",
        lambda: momentum(-1, m * a**2),
        lambda: momentum(-1, m * R**2),
        "$d = mb^2$ with $b$ the radius of the body",
        "the radii are exchanged in the text; read with the right sign of the momentum",
    ),
    Claim(
        "§8.1, k = 1",
        r"The case $k = 1$ corresponds to $a \rightarrow \infty$, i.e. a ball is rolling over a "
        "plane.",
        on_plane,
        note="here a is the radius of the surface, at odds with the words after (8.1)",
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
        "For $k = -1$ the radii of the body, $a$, and of the fixed ball, $b$, are connected by "
        r"$\frac{b}{a} = \frac{1}{2}$.",
        radii,
        note="true of the words; the letters are those after (8.1), not those of k = a/(a + b), "
        "in which b = −2a",
    ),
    Claim(
        "(8.3)",
        r"For $k = -1$ there is the integral $F_2 = (\mathbf{A}\mathbf{M}, \mathbf{n})$ with "
        r"$\mathbf{A} = \text{diag}(\frac{1}{2}(-I_1 + I_2 + I_3), \frac{1}{2}(I_1 - I_2 + I_3), "
        r"\frac{1}{2}(I_1 + I_2 - I_3))$.",
        lambda: linear(sp.S.Zero),
        lambda: linear(d),
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
