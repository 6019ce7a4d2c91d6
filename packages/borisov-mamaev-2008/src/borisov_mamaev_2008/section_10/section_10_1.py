"""§10.1: the unbalanced marble ball on a plane."""

from __future__ import annotations

from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, dot, norm_squared, zero
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Sphere

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import conclusion_verdict
from ..methods.independence import independent, rational_point
from ..methods.measure_theorems import has_no_measure
from ..methods.unbalanced_ball_symbols import (
    M_RATE,
    NORMAL,
    OFFSET,
    R_RATE,
    M,
    R,
    about_contact,
    c,
    gamma,
    m,
    omega,
    r,
)


def marble() -> System:
    """The unbalanced ball of the catalogue, derived from mechanics."""
    return from_catalogue("unbalanced-ball")


def momentum() -> Case:
    """The first and third equations of (10.1)."""
    balance = M_RATE - cross(M, omega) - m * cross(R_RATE, cross(omega, r))
    system = marble()
    return (
        (system, Identity("balance", balance, "rate of the momentum")),
        (system, Identity("momentum", M - about_contact(omega), "momentum about the contact")),
    )


def offset(vector: MatrixExpr) -> Case:
    """r = −Rγ − a for a given a."""
    return marble(), Identity("contact", r + R * gamma + vector, "place of the contact")


def contact_rate(vector: MatrixExpr) -> Case:
    """ṙ = (r + vector)×ω."""
    return marble(), Identity("rate", R_RATE - cross(r + vector, omega), "rate of the contact")


def invariants() -> tuple[tuple[System, Integral], ...]:
    """(10.2)."""
    system = marble()
    return (
        (system, Integral("length", norm_squared(gamma), "length of the normal")),
        (system, Integral("energy", dot(M, omega) / 2, "energy")),
    )


QUADRATIC = Integral(
    "quadratic",
    norm_squared(M) - m * norm_squared(r) * dot(M, omega),
    "quadratic integral",
    source="(10.3)",
)


def balanced() -> Case:
    """(10.3) for a = 0 is M² plus a multiple of the energy."""
    system = from_catalogue("chaplygin-ball")
    reach = -R * gamma + zero
    value = norm_squared(M) - m * norm_squared(reach) * dot(M, omega)
    excess = value - (norm_squared(M) - 2 * m * R**2 * dot(M, omega) / 2)
    return (system, Identity("balanced", excess, "(10.3) for a = 0")), (
        system,
        Integral("momentum", norm_squared(M), "square of the momentum"),
    )


def on_sphere() -> Case:
    """(10.3) on a sphere, outside, inside and around."""
    body = Body(1.3, (1.0, 1.5, 2.1), Ball(2.0, centre=(0.1, -0.2, 0.3), hollow=True))
    around = RollingBody(body, Sphere(0.75)).system()
    places = (from_catalogue("unbalanced-ball-on-sphere", a=value) for value in (2.0, -3.0))
    return tuple((system, QUADRATIC) for system in (*places, around))


def rank_of_marble() -> Verdict:
    """γ², H and F₂ are independent, so that their levels have dimension three."""
    system = marble()
    state: dict[str, object] = {"M_1": 2, "M_2": "-1/3", "M_3": "5/4"}
    functions = (norm_squared(gamma), dot(M, omega), QUADRATIC.value)
    return independent(system, functions, rational_point(system, state | NORMAL))


def no_measure_for_marble() -> Verdict:
    """The verdict by a theorem on all balls: no measure unless the ball is symmetric."""
    ball = Ball(2.0, centre=(0.1, -0.2, 0.3))
    return has_no_measure(RollingBody(Body(1.3, (1.0, 1.5, 2.1), ball)), "unbalanced ball")


def surface() -> Verdict:
    """Three independent functions are constant along a motion in six variables."""
    return conclusion_verdict(
        "surface",
        "the points of one motion on a section lie on a level of H and F₂ in it, a surface",
        (rank_of_marble(), *invariants(), (marble(), QUADRATIC)),
    )


CLAIMS = (
    Claim(
        "(10.1), M",
        r"$\dot{\mathbf M} = \mathbf M\times\boldsymbol\omega + m\dot{\mathbf r}\times"
        r"(\boldsymbol\omega\times\mathbf r)$, $\mathbf M = \mathbf I\boldsymbol\omega + "
        r"m\mathbf r\times(\boldsymbol\omega\times\mathbf r)$.",
        momentum,
        note="checked with the Newton–Euler equations",
    ),
    Claim(
        "§10.1, a",
        r"$\mathbf a$ is the vector from the center of mass to the geometric center, $\mathbf r = "
        r"-R\boldsymbol\gamma - \mathbf a$.",
        lambda: offset(c),
        lambda: offset(OFFSET),
        r"$\mathbf a$ is the vector from the geometric center to the center of mass, $\mathbf r = "
        r"-R\boldsymbol\gamma - \mathbf a$",
        "the direction of a is reversed; r = −Rγ − a and (10.5) need this one",
    ),
    Claim(
        "(10.1), r",
        r"$\dot{\mathbf r} = (\mathbf r - \mathbf a)\times\boldsymbol\omega$.",
        lambda: contact_rate(-OFFSET),
        lambda: contact_rate(OFFSET),
        r"$\dot{\mathbf r} = (\mathbf r + \mathbf a)\times\boldsymbol\omega$",
        "the sign of a: r + a = −Rγ is fixed in space; as printed it would be right with a "
        "towards the geometric centre, but then r = −Rγ + a",
    ),
    Claim(
        "(10.2)",
        r"$F_1 = \boldsymbol\gamma^2 = 1$, $H = \frac12(\mathbf M,\boldsymbol\omega)$ are "
        r"integrals.",
        invariants,
    ),
    Claim(
        "(10.3)",
        r"$F_2 = (\mathbf M,\mathbf M) - m(\mathbf r,\mathbf r)(\mathbf M,\boldsymbol\omega)$ is "
        r"an integral.",
        lambda: (marble(), QUADRATIC),
    ),
    Claim(
        "§10.1, after (10.3)",
        r"This integral is a generalization of the integral $\mathbf M^2 = \text{const}$ in the "
        r"problem of motion of a Chaplygin ball.",
        balanced,
        note="for a = 0 they differ by 2mR²H",
    ),
    Claim(
        "§10.1, integrability",
        r"To achieve integrability by the Euler–Jacobi theorem an additional integral and "
        r"invariant measure are needed.",
        rank_of_marble,
        note="shown: F₁, H, F₂ are independent; of six variables the theorem asks four integrals",
    ),
    Claim(
        "§10.1, missing invariants: the measure",
        "Simulations show that in the generic cases the required invariants are missing.",
        no_measure_for_marble,
        note="meant is a measure with a density that is smooth and positive up to rest; the "
        "additional integral is a matter of numerical evidence",
        argument="nonholonomic/docs/measures.md, result 1, for every ball: only "
        "balanced ones and those with their centre on an axis of dynamical symmetry have such a "
        "measure",
    ),
    Claim(
        "Fig. 8, caption",
        "One of the trajectories from the problem of motion of an unbalanced ball on a plane. It "
        "is seen that all the points lie on the same surface.",
        surface,
        note="with $\\gamma^2 = 1$, $H$ and $F_2$ fixed three variables are left, and two on a "
        "section",
    ),
    Claim(
        "§10.1, ball on a sphere",
        r"The integral (10.3) can be generalized to the general case of rolling motion of a ball "
        r"on a sphere.",
        on_sphere,
        note="it holds there word for word, for every radius, outside, inside and around: all it "
        "needs is (ṙ, ω) = 0",
    ),
)

REMARKS = (
    Remark(
        "§10.1, Fig. 8",
        "Simulations show that in the generic cases an additional integral is missing.",
        "numerical evidence, not a statement that algebra decides",
    ),
    Remark(
        "Fig. 8, caption",
        "Condensation spots indicate the approach to periodic solutions. The trajectory emanates "
        "from the top and approaches the three points at the bottom.",
        "numerical evidence. Observed with a body found by search, since the paper gives neither "
        "body nor level: 63 % of the motions that cross the section come to an attracting cycle of "
        "three points, whose mirror image under M → −M, t → −t repels, and a motion leads from one "
        "to the other; not every motion does (`examples/figure_8.py`, flowlanes/docs/sections.md)",
    ),
)
