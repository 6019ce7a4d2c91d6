"""§9.1 and §9.2: the rubber ball on a sphere, its equations, measure and integrals."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Rate
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient
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
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.ball_on_sphere import rubber_ball_ratio as ratio
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Sphere

from ..claim import Case, Claim, Remark
from ..methods.independence import independent, rational_point
from ..methods.tensor_of_a_body import with_tensor_of_a_body

omega, gamma, n = vectors("omega gamma n")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
m, R, a, k = (real_symbol(name) for name in ("m", "R", "a", "k"))

POTENTIAL = sp.Function("U")(*gamma.symbols)
#: M_Q: the couple of the potential, with γ in place of n.
COUPLE = k * cross(gamma, gradient(POTENTIAL, gamma))
OMEGA_RATE = constant([Rate(s) for s in omega.symbols])
GAMMA_RATE = constant([Rate(s) for s in gamma.symbols])


def rolled() -> System:
    """The ball derived from mechanics, in an arbitrary potential of the normal."""
    body = Body(1.0, (1.0, 1.5, 2.1), Ball(1.0))
    return RollingBody(body, Sphere(2.0), "rubber", Forces(0.0, POTENTIAL)).system()


def dynamics() -> Case:
    """Jω̇ − Jω×ω − M_Q is along the normal."""
    excess = J * OMEGA_RATE - cross(J * omega, omega) - COUPLE
    law = Identity("balance", cross(gamma, excess), "balance of momentum across the normal")
    return rolled(), law


def kinematics() -> Case:
    """ṅ = k n×ω with k = a/(a + b)."""
    law = Identity("normal", GAMMA_RATE - a / (a + R) * cross(gamma, omega), "motion of the normal")
    return rolled(), law


def tensor() -> Case:
    """J = I + mb²E with the radius b of the ball."""
    return rolled(), Identity("tensor", J - I - m * R**2 * identity, "tensor J")


def spin_torque(weights: Diagonal) -> Case:
    """The claim that (ω, n) stays zero with λ in which M_Q is weighted by J or by J⁻¹."""
    share = dot(A * n, cross(J * omega, omega)) + dot(ratio.torque, weights * n)
    system = ratio.rolling(ratio.any_couple(), -share / ratio.RHO_SQUARED)
    return system, ratio.CONSTRAINT


def measure_alone() -> Case:
    """(9.3) without a couple."""
    return ratio.rolling(), ratio.MEASURE


def measure_in_couple() -> Case:
    """(9.3) with any couple M_Q(n)."""
    return ratio.rolling(ratio.any_couple()), ratio.MEASURE


def energy() -> Case:
    """The energy and the length of n."""
    length = Integral("length", norm_squared(n), "length of the normal")
    return (ratio.rolling(), ratio.ENERGY), (ratio.rolling(), length)


def constraint() -> Case:
    """(ω, n) as an integral."""
    return ratio.rolling(), ratio.CONSTRAINT


def on_plane() -> Case:
    """k = 1: |Jω×n|²."""
    return ratio.rolling(), ratio.ON_PLANE


def as_veselova() -> Case:
    """k = 1: the Veselova system with J for I."""
    target = from_catalogue("veselova")
    law = Isomorphism(
        "veselova",
        target,
        {omega: omega, gamma: n},
        constants=dict(zip(I.symbols, J.symbols, strict=True)),
        level=(k - 1,),
    )
    return with_tensor_of_a_body(ratio.rolling(), J.symbols), law


def radii() -> Case:
    """k = a/(a + b) is −1 for b = −2a: for the hollow ball, whose inner radius is R = −b."""
    body = Body(1.0, (1.0, 1.5, 2.1), Ball(2.0, hollow=True))
    system = RollingBody(body, Sphere(1.0), "rubber").system()
    return system, Identity("ratio", k + 1, "ratio k of a hollow ball", level=(R - 2 * a,))


def eq_9_4_integral() -> Case:
    """(9.4), the integral at k = −1."""
    return ratio.rolling(), ratio.AROUND


def complete(extra: Integral, value: int) -> Verdict:
    """The verdict that n², (ω, n), H and F are independent, so that levels have dimension two."""
    system = ratio.rolling()
    functions = (norm_squared(n), dot(omega, n), ratio.ENERGY.value, extra.value)
    state: dict[str, object] = {"n_1": "2/7", "n_2": "-3/7", "n_3": "6/7", "k": value}
    state |= {"omega_1": 9, "omega_2": -5, "omega_3": "-11/2"}
    return independent(system, functions, rational_point(system, state))


CLAIMS = (
    Claim(
        "(9.2), first equation",
        r"$\mathbf J\dot{\boldsymbol\omega} = \mathbf J\boldsymbol\omega\times\boldsymbol\omega + "
        r"\lambda\mathbf n + \mathbf M_Q$ under the constraint (9.1), "
        r"$(\boldsymbol\omega,\mathbf n) = 0$.",
        dynamics,
        note="checked with the Newton–Euler equations, $\\mathbf M_Q$ from any potential of n",
    ),
    Claim(
        "(9.2), second equation",
        r"$\dot{\mathbf n} = k\,\mathbf n\times\boldsymbol\omega$.",
        kinematics,
        note="k = a/(a + b) with the radius b of the ball and a of the surface, as J and b = −2a "
        "of §9 need it; the words of §8.1 have a and b exchanged, which is judged there",
    ),
    Claim(
        "(9.2), third equation",
        r"$\mathbf J = \mathbf I + mb^2\mathbf E$.",
        tensor,
        note="b is the radius of the ball",
    ),
    Claim(
        "§9.1, λ after (9.2)",
        r"$\lambda = -\frac{(\mathbf J\boldsymbol\omega\times\boldsymbol\omega,\mathbf J^{-1}"
        r"\mathbf n) + (\mathbf M_Q,\mathbf J\mathbf n)}{(\mathbf n,\mathbf J^{-1}\mathbf n)}$.",
        lambda: spin_torque(J),
        lambda: spin_torque(A),
        r"$\lambda = -\frac{(\mathbf J\boldsymbol\omega\times\boldsymbol\omega + \mathbf M_Q,"
        r"\mathbf J^{-1}\mathbf n)}{(\mathbf n,\mathbf J^{-1}\mathbf n)}$",
        "the couple is weighted by J instead of its inverse, so that (ω, n) = 0 is not preserved",
    ),
    Claim(
        "(9.3)",
        r"The system (9.2) preserves measure $(\mathbf n,\mathbf J^{-1}\mathbf n)^{\frac{1}{2k}}"
        r"\,d\boldsymbol\omega\,d\mathbf n$.",
        measure_alone,
    ),
    Claim(
        "§9.2, after (9.3)",
        r"The measure (9.3) is preserved as well when $\mathbf M_Q$ depends only on $\mathbf n$ "
        r"and is independent of $\boldsymbol\omega$.",
        measure_in_couple,
        note="all three components of the couple are unspecified functions",
    ),
    Claim(
        "§9.2, energy and geometric integral",
        r"$H = \frac12(\mathbf J\boldsymbol\omega,\boldsymbol\omega)$, $(\mathbf n,\mathbf n) = 1$ "
        r"are integrals of (9.2).",
        energy,
        note="for M_Q = 0",
    ),
    Claim(
        "§9.2, the constraint as an integral",
        r"The constraint (9.1) can be considered as additional partial integral.",
        constraint,
        note="(ω, n) is an integral on all levels, not only on zero",
    ),
    Claim(
        "§9.2, 1) integral",
        r"For $k=1$ the system has the integral $F = (\mathbf J\boldsymbol\omega\times\mathbf n,"
        r"\mathbf J\boldsymbol\omega\times\mathbf n)$.",
        on_plane,
    ),
    Claim(
        "§9.2, 1) one more integral is enough",
        r"For $k=1$, $\mathbf n^2$, $(\boldsymbol\omega,\mathbf n)$, $H$ and $F$ are four "
        r"independent integrals in six variables, as the Euler–Jacobi theorem needs.",
        lambda: complete(ratio.ON_PLANE, 1),
    ),
    Claim(
        "§9.2, 1) Veselova",
        r"For $k=1$ ($a=\infty$) the system is equivalent to Veselova's system.",
        as_veselova,
        note="with J in place of I",
    ),
    Claim(
        "§9.2, 2) radii",
        r"$k=-1$ ($b=-2a$): a hollow sphere rolls over a fixed ball that touches it from the "
        r"inside.",
        radii,
        note="for a hollow ball b is minus its inner radius, which is twice that of the fixed ball",
    ),
    Claim(
        "(9.4)",
        r"For $k=-1$ the additional integral is $F = \frac{(\mathbf J\boldsymbol\omega,"
        r"\mathbf J\boldsymbol\omega)\mathbf n^2 + \det\mathbf J(\boldsymbol\omega,"
        r"\mathbf J\boldsymbol\omega)(\mathbf J^{-1}\mathbf n,\mathbf J^{-1}\mathbf n)}"
        r"{(\mathbf n,\mathbf J^{-1}\mathbf n)}$.",
        eq_9_4_integral,
    ),
    Claim(
        "§9.2, 2) one more integral is enough",
        r"For $k=-1$, $\mathbf n^2$, $(\boldsymbol\omega,\mathbf n)$, $H$ and $F$ are four "
        r"independent integrals in six variables, as the Euler–Jacobi theorem needs.",
        lambda: complete(ratio.AROUND, -1),
    ),
)

REMARKS = (
    Remark("§9.2", "The measure (9.3) was found in [14].", "literature"),
    Remark(
        "§9.2, after (9.4)",
        "The integral (9.4) was found by the analogy with a particle on a sphere.",
        "history; the analogy itself is proved with §9.4",
    ),
)
