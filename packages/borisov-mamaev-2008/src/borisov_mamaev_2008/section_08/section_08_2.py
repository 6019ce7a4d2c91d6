"""§8.2: the ball around a sphere, k = −1, F₂ = 0: Chaplygin system and Hamiltonian form."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Integral, PoissonStructure
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, dot, identity, norm_squared
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.ball_on_sphere import (
    ball_around_sphere_chaplygin as chart,
    ball_around_sphere_hamiltonian as e3,
    ball_on_sphere_equations as ball,
)
from nonholonomic.catalogue.e3 import Gamma, lie_poisson
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.catalogue_laws import laws_named
from ..methods.derived_verdicts import conclusion_verdict, contrary
from ..methods.two_quadratures import both_hyperelliptic, quadratures_differ

M, n, J, A, d, k = ball.M, ball.n, ball.J, ball.A, ball.d, ball.k
u, v = chart.u, chart.v
NUMBERS = e3.ENTRIES[0].defaults


def velocity() -> Case:
    """(8.4) with A as printed in (8.3) and with the correct A, for every (AM, n)."""
    system = ball.equations_on_sphere()
    laws = []
    for shift in (sp.S.Zero, d):
        tensor = (sp.Add(*ball.I.symbols) + shift) / 2 * identity - ball.I
        drawn = ball.contact_inertia(tensor * n)
        excess = dot(n, drawn) * ball.omega - cross(drawn, rate(n)) - dot(tensor * M, n) * n
        meaning = "angular velocity from n and its rate"
        laws.append((system, Identity("velocity", excess, meaning, level=(k + 1,))))
    return tuple(laws)


def coordinates() -> Case:
    """(8.5): on the sphere, and the roots of Σ n_i²/(J_i − z) = 0."""
    moments = chart.J.symbols
    squares = [chart.square(i) for i in range(3)]
    law = Identity(
        "coordinates",
        (
            sp.Add(*squares) - 1,
            *(
                sp.Add(*(s / (j - z) for s, j in zip(squares, moments, strict=True)))
                for z in (u, v)
            ),
        ),
        "sphero-conical coordinates",
    )
    return chart.reduced_system(), law


def as_printed() -> Case:
    """The energy along the printed right-hand sides of (8.6), for unspecified a_u and a_v."""
    du, dv = chart.rates()
    push = sp.Function("a_u")(u, v) * du + sp.Function("a_v")(u, v) * dv
    system = chart.chaplygin_system(du * push, -dv * push)
    return system, Integral("energy", chart.energy(), "energy")


def equations() -> Case:
    """(8.6) with Φ from the reducing multiplier is the ball."""
    return laws_named(chart.reduced_system(), "energy", "second", "ball")


def measure() -> Case:
    """The correct 𝒩 as a density."""
    return chart.reduced_system(), chart.density(chart.numerator())


def lagrangian() -> Case:
    """S̄ of (4.5) for the motion of the ball in u, v and the correct 𝒩."""
    top = chart.numerator()
    density = top / chart.form() / sp.sqrt(chart.area())
    bent = sp.diff(density, v) * chart.P_u - sp.diff(density, u) * chart.P_v
    system = chart.reduced_system()
    law = Identity("S", density * chart.force(top) + bent, "gyroscopic term in the time τ")
    return (system, law), *laws_named(system, "energy", "ball")


def multiplier(sign: int) -> Case:
    """The formula of 𝒩, up to the common factor −1."""
    return chart.reduced_system(), chart.sums(chart.numerator(sign))


def reduced() -> System:
    """The system on e(3) with the correct Hamiltonian."""
    return e3.build(NUMBERS)


def hamiltonian(power: int) -> Case:
    """H of (8.7), with Ā to a given power in δ, is ½ (M, ω) of the ball."""
    excess = e3.energy(e3.delta(power)) - dot(e3.momentum(), e3.velocity()) / 2
    return reduced(), Identity("energy", excess, "the ball's energy")


def second() -> Case:
    """det J F₂ of (8.7) is M² of the ball."""
    excess = sp.Mul(*e3.J.symbols) * e3.second(e3.delta()) - norm_squared(e3.momentum())
    return reduced(), Identity("second", excess, "square of the ball's momentum")


def second_integral_as_printed() -> Case:
    """Check the printed formula, which is F₂ of (8.3), as zero on this orbit."""
    return reduced(), Identity("second", e3.second(e3.delta()), "linear integral of the ball")


def bracket() -> Case:
    """{m_i, m_j} = ε_ijk m_k, {m_i, γ_j} = ε_ijk γ_k, {γ_i, γ_j} = 0, with its Casimirs."""
    matrix = lie_poisson(-1 * M, -1 * Gamma)
    casimirs = (norm_squared(Gamma), dot(M, Gamma))
    return reduced(), PoissonStructure("bracket", matrix, casimirs, 4, "bracket of e(3)")


def with_area() -> Case:
    """For every F₂ = c: ω in terms of n and ṅ, and an energy without a part linear in ṅ.

    A system with two degrees of freedom, with accelerations quadratic in the velocities and an
    integral E = L₂ − L₀ (parts of degree 2 and 0), is (4.4) with the Lagrangian L₂ + L₀: the
    residual of Lagrange's equations is quadratic and orthogonal to the velocity.
    """
    half = (sp.Add(*ball.I.symbols) + d) / 2
    tensor = half * identity - ball.I
    drawn = ball.contact_inertia(tensor * n)
    form, area = dot(n, drawn), dot(tensor * M, n)
    swing, spin = cross(drawn, rate(n)), area * n

    def energy(turning: sp.MatrixExpr) -> sp.Expr:
        shared = ball.contact_inertia(turning)
        return half * dot(shared, turning) - norm_squared(shared)

    law = Identity(
        "gyroscopic form",
        (
            form * ball.omega - swing - spin,
            form**2 * (half * dot(M, ball.omega) - norm_squared(M)) - energy(swing) - energy(spin),
        ),
        "(ΣI + d)/2 (M, ω) − M² has no part linear in the velocities",
        level=(k + 1,),
    )
    return ball.equations_on_sphere(), law


def as_chaplygins_problem() -> Verdict:
    """The statement refuted by `quadratures_differ`."""
    return contrary(quadratures_differ())


def like_chaplygins_problem() -> Verdict:
    """A Chaplygin system with b = 0, Hamiltonian on e(3), separated on a curve of genus two."""
    reducing = laws_named(chart.reduced_system(), "energy", "ball")
    return conclusion_verdict(
        "alike",
        "(8.6) with the right Φ is linear in the velocities; reduced to e(3) and separated",
        (*reducing, (reduced(), e3.to_ball()), both_hyperelliptic()),
    )


CLAIMS = (
    Claim(
        "§8.2, first paragraph",
        "For $k = -1$ and $F_2 = 0$ the problem is identical to the integration of the equations "
        "of motion in Chaplygin's problem (a ball on a plane) with zero integral of areas.",
        as_chaplygins_problem,
        like_chaplygins_problem,
        "It is similar: a Chaplygin system (4.4) with $b = 0$, which the reducing multiplier makes "
        "Hamiltonian on the zero orbit of $e(3)$, and whose trajectories are $\\frac{dw_1}"
        "{\\sqrt{R(w_1)}} \\pm \\frac{dw_2}{\\sqrt{R(w_2)}} = 0$ with a polynomial $R$ of degree "
        "six. Two of its roots depend on the level $F_1/H$, in Chaplygin's problem one.",
        "read as: the same quadratures, for all levels, up to affine substitutions, which alone "
        "keep this form; as a comparison of methods it is right",
    ),
    Claim(
        "(8.4)",
        r"Using $F_2 = 0$: $\boldsymbol{\omega} = \frac{\mathbf{B}\mathbf{n} \times "
        r"\dot{\mathbf{n}}}{(\mathbf{n}, \mathbf{B}\mathbf{n})}$, $\mathbf{B} = (\mathbf{I} + d - "
        r"d\mathbf{n} \otimes \mathbf{n})\mathbf{A}$, with $\mathbf{A}$ of (8.3).",
        velocity,
        note="with A as printed in (8.3) and with the correct A: for every diagonal A "
        "(n, Bn)ω = Bn×ṅ + (AM, n)n",
    ),
    Claim(
        "(8.5)",
        r"Sphero-conical coordinates: $n_i^2 = \frac{(J_i - u)(J_i - v)}{(J_i - J_j)(J_i - J_k)}$, "
        "$J_i = I_i + d$.",
        coordinates,
    ),
    Claim(
        "(8.6)",
        r"$\frac{d}{dt} \frac{\partial T}{\partial \dot{u}} - \frac{\partial T}{\partial u} = "
        r"\dot{u}\Phi$, $\frac{d}{dt} \frac{\partial T}{\partial \dot{v}} - \frac{\partial "
        r"T}{\partial v} = -\dot{v}\Phi$, where $T$ is the integral of energy and $\Phi = "
        r"(a_u\dot{u} + a_v\dot{v})$.",
        as_printed,
        equations,
        r"$\frac{d}{dt} \frac{\partial T}{\partial \dot{u}} - \frac{\partial T}{\partial u} = "
        r"\dot{v}\Phi$, $\frac{d}{dt} \frac{\partial T}{\partial \dot{v}} - \frac{\partial "
        r"T}{\partial v} = -\dot{u}\Phi$, $\Phi = (P_v \partial_u\mathcal{N} - P_u "
        r"\partial_v\mathcal{N})/\mathcal{N}$",
        "the velocities are exchanged: as printed T is not an integral for unspecified a_u, a_v; "
        "the corrected form, with Φ from the reducing multiplier, is the ball's motion",
    ),
    Claim(
        "§8.2, Lagrangian form",
        r"After the change of time $\mathcal{N}(u, v)dt = d\tau$: $\frac{d}{d\tau} "
        r"\frac{\partial T}{\partial u'} - \frac{\partial T}{\partial u} = 0$, $\frac{d}{d\tau} "
        r"\frac{\partial T}{\partial v'} - \frac{\partial T}{\partial v} = 0$.",
        lagrangian,
        note="S̄ of (4.5) vanishes with the correct 𝒩; (4.5) is proved for every T",
    ),
    Claim(
        "§8.2, 𝒩 as a density",
        r"$\mathcal{N}$ is equal to the density of the invariant measure $\mathcal{N} du dv dP_u "
        r"dP_v$, $P_u = \frac{\partial T}{\partial \dot{u}}$, $P_v = \frac{\partial T}{\partial "
        r"\dot{v}}$.",
        measure,
        note="with the correct 𝒩, see the next claim",
    ),
    Claim(
        "§8.2, 𝒩",
        r"$\mathcal{N} = \frac{2uv + (u + v)(2d + \alpha_1) + \alpha_2 - d\alpha_1}{\sqrt{"
        r"\det(\mathbf{I} + d - d\mathbf{n} \otimes \mathbf{n})}} (4\alpha_3 + 2\alpha_1\alpha_2 - "
        r"\alpha_1^3 - d\alpha_1^2 + (\alpha_1^2 - 2\alpha_2 + 4d\alpha_1)(u + v) - "
        r"4d(u + v)^2)^{-1}$, $\alpha_1 = \sum J_i$, $\alpha_2 = \sum J_i^2$, $\alpha_3 = J_1 J_2 "
        "J_3$.",
        lambda: multiplier(1),
        lambda: multiplier(-1),
        r"the same with $(u + v)(2d - \alpha_1)$ in the numerator; up to sign $\mathcal{N} = "
        r"\frac{(\mathbf{n}, \mathbf{B}\mathbf{n})}{2(\mathbf{A}\mathbf{n}, \mathbf{B}\mathbf{n})"
        r"\sqrt{\det(\mathbf{J} - d\mathbf{n} \otimes \mathbf{n})}}$",
        "the sign of α₁ in the numerator",
    ),
    Claim(
        "§8.2, before (8.7)",
        r"After the change of time $\mathcal{N}dt = d\tau$ we get a Hamiltonian system on the "
        "two-dimensional sphere, represented on the zero orbit of the co-algebra $e(3)$.",
        lambda: (reduced(), e3.to_ball()),
        note="proved with the correct 𝒩 and H; a Hamiltonian system on that orbit, quadratic in "
        "the momenta, is a Lagrangian one on the sphere",
    ),
    Claim(
        "(8.7), δ",
        r"$\delta = (\gamma, \mathbf{J}\bar{\mathbf{A}}\gamma) - d(\gamma, "
        r"\bar{\mathbf{A}}\gamma)^2$, $\bar{\mathbf{A}} = 2\mathbf{A}$.",
        lambda: hamiltonian(1),
        lambda: hamiltonian(2),
        r"$\delta = (\gamma, \mathbf{J}\bar{\mathbf{A}}^2\gamma) - d(\gamma, "
        r"\bar{\mathbf{A}}\gamma)^2$",
        "the first Ā lacks its square; checked with H = ½ (M, ω) and the correct A",
    ),
    Claim(
        "(8.7), H",
        r"$H = \frac{\delta \det \mathbf{J}}{8(\gamma, \mathbf{B}\gamma)^2} \sum_{i=1}^3 c_i "
        r"m_i^2$, $c_i = \frac{\rho^2 \delta}{J_i} - 4 \prod_{k \neq i} (J_i - J_k) \gamma_i^2 "
        r"\left(\rho^2 - \frac{d\delta}{4J_i \det \mathbf{J}} \right)$.",
        lambda: hamiltonian(2),
        note="read with the correct δ and A",
    ),
    Claim(
        "(8.7), F₂",
        r"$F_2 = \frac{\rho^2}{4(\gamma, \mathbf{B}\gamma)^2} (\delta^2 \mathbf{m}^2 - 4 "
        r"\sum_{i=1}^3 d_i m_i^2)$, $d_i = \prod_{k \neq i} (J_i - J_k) \gamma_i^2 (\delta(J_i + "
        r"d) - (\gamma, \mathbf{J}(\mathbf{J} + d)\bar{\mathbf{A}}^2\gamma) + 2d(\gamma, "
        r"\mathbf{J}\bar{\mathbf{A}}\gamma)(\gamma, \bar{\mathbf{A}}\gamma))$.",
        second_integral_as_printed,
        second,
        r"the formula is that of $F_1/\det\mathbf{J}$, $F_1 = (\mathbf{M}, \mathbf{M})$",
        "F₂ is the linear integral (8.3), which is zero here; read with the correct δ and A",
    ),
    Claim(
        "§8.2, after (8.7)",
        r"$\{m_i, m_j\} = \varepsilon_{ijk} m_k$, $\{m_i, \gamma_j\} = \varepsilon_{ijk} "
        r"\gamma_k$, $\{\gamma_i, \gamma_j\} = 0$; the orbit is $\gamma^2 = 1$, "
        r"$(\mathbf{m}, \gamma) = 0$.",
        bracket,
        note="the Jacobi identity and both Casimir functions; m = 𝒩 (M − Bn (n, M)/(n, Bn))",
    ),
    Claim(
        "Remark 22",
        r"For $k = -1$ and $F_2 \neq 0$ the equations of motion correspond to the generalized "
        "Chaplygin system (4.4); thus, using Theorem 6, they can be represented as Hamiltonian "
        "equations with gyroscopic forces.",
        with_area,
        note="the Lagrangian is not that of the energy, which has a part linear in the velocities, "
        "but that of the integral ½ (ΣI + d)(M, ω) − (M, M), which has none; the measure is that "
        "of §8.1",
    ),
)

REMARKS = (
    Remark(
        "§8.2, after (8.6)",
        "The expressions of $T$ and $\\Phi$ are too bulky to be given.",
        "opinion; both are short in the momenta and are given with (8.6) in the catalogue",
    ),
)
