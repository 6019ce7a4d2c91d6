"""§8.3: Darboux coordinates of e(3) and the separation of variables."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import combinations_with_replacement, product

import sympy as sp

from flowlanes.system.laws import Identity, Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, real_symbol
from nonholonomic.catalogue.ball_on_sphere import (
    ball_around_sphere_coordinates as chart,
    ball_around_sphere_hamiltonian as e3,
    ball_on_sphere_equations as ball,
)
from nonholonomic.catalogue.e3 import Gamma, M
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark

x, y, p_1, p_2 = (real_symbol(name) for name in ("x", "y", "p_1", "p_2"))
s_1, s_2, P_1, P_2 = (real_symbol(name) for name in ("s_1", "s_2", "P_1", "P_2"))


# --- Darboux coordinates -------------------------------------------------------------------


@dataclass(frozen=True)
class Turned:
    """The number i^turns times a real formula."""

    turns: int
    real: sp.Expr


def darboux_plane() -> System:
    """The coordinates x, y, p₁, p₂ at rest; only their brackets matter."""
    return System(
        name="darboux",
        title="Darboux coordinates",
        field={z: sp.S.Zero for z in (x, y, p_1, p_2)},
    )


def momenta(turns: int, factor: sp.Expr) -> list[Turned]:
    """m of (8.8), times i^turns and a real factor."""
    return [
        Turned(turns, factor * (p_1 * (x**2 - 1) + p_2 * (y**2 - 1))),
        Turned(turns + 1, factor * (p_1 * (x**2 + 1) + p_2 * (y**2 + 1))),
        Turned(turns, factor * (2 * p_1 * x + 2 * p_2 * y)),
    ]


def normals(sign: int) -> list[Turned]:
    """γ of (8.8), with γ₂ = i (xy + sign)/(x − y)."""
    return [
        Turned(0, (x * y - 1) / (x - y)),
        Turned(1, (x * y + sign) / (x - y)),
        Turned(0, (x + y) / (x - y)),
    ]


def bracket(f: sp.Expr, g: sp.Expr) -> sp.Expr:
    """{f, g} with {x, p₁} = {y, p₂} = 1."""
    pairs = ((x, p_1), (y, p_2))
    return sp.Add(*(f.diff(q) * g.diff(p) - f.diff(p) * g.diff(q) for q, p in pairs))


def difference(first: Turned, second: Turned) -> tuple[sp.Expr, ...]:
    """The difference of two numbers: a real formula, or real and imaginary part."""
    gap = (first.turns - second.turns) % 4
    if gap % 2:
        return first.real, second.real
    return (first.real - (1 - gap) * second.real,)


def leaf(sign: int) -> Case:
    """γ² = 1 and (m, γ) = 0."""

    def scalar_product(left: list[Turned], right: list[Turned]) -> sp.Expr:
        signs = (1, -1, 1)
        terms = zip(signs, left, right, strict=True)
        return sp.Add(*(s * a.real * b.real for s, a, b in terms))

    normal = normals(sign)
    square, area = scalar_product(normal, normal), scalar_product(momenta(0, sp.S.One), normal)
    return darboux_plane(), Identity("leaf", (square - 1, area), "γ² = 1, (m, γ) = 0")


def algebra(turns: int, factor: sp.Expr) -> Case:
    """The brackets of e(3), for m of (8.8) times a complex factor."""
    m, normal = momenta(turns, factor), normals(1)
    differences: list[sp.Expr] = []
    for left, right in combinations_with_replacement((m, normal), 2):
        if left is normal:
            continue
        for i, j in product(range(3), repeat=2):
            entry = Turned(left[i].turns + right[j].turns, bracket(left[i].real, right[j].real))
            sign = int(sp.LeviCivita(i, j, 3 - i - j)) if i != j else 0
            third = right[3 - i - j] if i != j else Turned(entry.turns, sp.S.Zero)
            differences += difference(entry, Turned(third.turns, sign * third.real))
    return darboux_plane(), Identity("algebra", tuple(differences), "brackets of e(3)")


def _square(part: Turned) -> sp.Expr:
    """The square of i^turns times a real formula, which is real."""
    return (-1) ** part.turns * part.real**2


def quadratic_in_momenta() -> Case:
    """H and F₂ of (8.7) by (8.8), for both signs in γ₂: ½ (p, Gp) with a matrix G(x, y).

    m_i and γ_i occur only as squares, which are real.
    """
    differences: list[sp.Expr] = []
    for sign in (1, -1):
        pairs = zip((*M, *Gamma), (*momenta(0, sp.S.One), *normals(sign)), strict=True)
        squares = {letter**2: _square(part) for letter, part in pairs}
        for value in (e3.energy(e3.delta()), e3.second(e3.delta())):
            written = value.xreplace(squares)
            first, mixed, last = (
                sp.diff(written, p, q) for p, q in ((p_1, p_1), (p_1, p_2), (p_2, p_2))
            )
            differences.append(
                written - (first * p_1**2 / 2 + mixed * p_1 * p_2 + last * p_2**2 / 2)
            )
            differences += [sp.diff(entry, p) for entry in (first, mixed, last) for p in (p_1, p_2)]
    system = replace(darboux_plane(), parameters=e3.parameters(e3.ENTRIES[0].defaults))
    return system, Identity("quadratic", tuple(differences), "quadratic forms of p₁ and p₂")


# --- Liouville's form ----------------------------------------------------------------------


def coefficients() -> tuple[tuple[sp.Expr, sp.Expr], tuple[sp.Expr, sp.Expr]]:
    """The coefficients of P₁² and P₂² in H and F of (8.11), for unspecified S₁ and S₂."""
    first, second = sp.Function("S_1")(s_1), sp.Function("S_2")(s_2)
    gap = s_1 - s_2
    return (first / gap, -second / gap), (s_2 * first / gap, -s_1 * second / gap)


def liouville_system() -> System:
    """The motion with the Hamiltonian H of (8.11)."""
    energy = value(0)
    return System(
        name="liouville",
        title="A system in Liouville's form",
        field={
            s_1: energy.diff(P_1),
            s_2: energy.diff(P_2),
            P_1: -energy.diff(s_1),
            P_2: -energy.diff(s_2),
        },
    )


def value(which: int) -> sp.Expr:
    """H or F."""
    first, second = coefficients()[which]
    return first * P_1**2 + second * P_2**2


def roots() -> Case:
    """s₁ and s₂ solve (8.10) in any linear momenta: P = G p with an arbitrary matrix G."""
    G = [sp.Function(f"G_{i}")(s_1, s_2) for i in range(4)]

    def spread(squares: tuple[sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        first, second = squares
        return (
            first * G[0] ** 2 + second * G[2] ** 2,
            first * G[0] * G[1] + second * G[2] * G[3],
            first * G[1] ** 2 + second * G[3] ** 2,
        )

    (a, b, c), (A, B, C) = (spread(form) for form in coefficients())
    left = tuple((B - b * s) ** 2 - (A - a * s) * (C - c * s) for s in (s_1, s_2))
    return liouville_system(), Identity("roots", left, "roots of (8.10)")


def liouville_form() -> Case:
    """H and F are in involution, and S_i P_i² = s_i H − F."""
    system = liouville_system()
    first, second = sp.Function("S_1")(s_1), sp.Function("S_2")(s_2)
    separated = (
        first * P_1**2 - s_1 * value(0) + value(1),
        second * P_2**2 - s_2 * value(0) + value(1),
    )
    return (
        (system, Integral("second", value(1), "second integral")),
        (system, Identity("separated", separated, "separated equations")),
    )


# --- the function S ------------------------------------------------------------------------


def letters() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """β, γ and ε."""
    J_1, J_2, J_3 = chart.J.symbols
    beta = J_1**2 + J_2**2 + J_3**2 - 2 * (J_1 * J_2 + J_2 * J_3 + J_3 * J_1)
    return beta, J_1 * J_2 * J_3, J_1 + J_2 + J_3


def delta(alpha: sp.Expr) -> sp.Expr:
    """Δ at x(u₁), with a given α."""
    beta, gamma, epsilon = letters()
    d, z = chart.d, chart.variable(chart.u[0])
    middle = 4 * beta * gamma + d * beta**2 - 2 * d * alpha * epsilon + 4 * alpha * d**2
    return z**2 * (beta**2 + 8 * alpha * d) + 2 * z * middle + (4 * gamma + d * beta) ** 2


def printed_alpha() -> sp.Expr:
    """(J₂ + J₁ − J₃)(−J₂ + J₂ − J₃)(−J₂ + J₂ + J₃), with the last misprinted term read as J₃."""
    J_1, J_2, J_3 = chart.J.symbols
    return (J_2 + J_1 - J_3) * (-J_2 + J_2 - J_3) * (-J_2 + J_2 + J_3)


def right_alpha() -> sp.Expr:
    """α with J₁ in place of the second J₂ in the last two factors."""
    J_1, J_2, J_3 = chart.J.symbols
    return (J_2 + J_1 - J_3) * (-J_2 + J_1 - J_3) * (-J_2 + J_1 + J_3)


def root() -> sp.Expr:
    """√Δ = −4Q dx/dζ, with the sign that belongs to the motion."""
    z = chart.u[0]
    return 4 * chart.ratio_form(z) * sp.diff(chart.variable(z), z)


def discriminant(alpha: sp.Expr) -> Case:
    """Δ is 16 times the discriminant of ζL − xQ in ζ."""
    law = Identity("discriminant", delta(alpha) - root() ** 2, "discriminant Δ")
    return chart.coordinates_around_sphere(), law


def function(square: sp.Expr, factor: sp.Expr) -> Identity:
    """(8.12) with a given value of 2ε²β and a factor, compared with Liouville's form."""
    beta, gamma, epsilon = letters()
    z, d = chart.variable(chart.u[0]), chart.d
    cubic = 8 * z**3 + 8 * (d - epsilon) * z**2 + (square - 4 * d * epsilon) * z
    top = 2 * (cubic - 4 * gamma - d * beta + root())
    value = factor * top / (gamma * (2 * z - epsilon + 2 * d) ** 2)
    return Identity("S", value + 8 * chart.function(chart.u[0]) / gamma, "function S of (8.12)")


def eq_8_12_printed() -> Case:
    """(8.12) as printed, with the sign of the root that belongs to the motion."""
    beta, _, epsilon = letters()
    return chart.coordinates_around_sphere(), function(2 * epsilon**2 * beta, sp.S.One)


def eq_8_12_corrected() -> Case:
    """The separation of the ball, and (8.12) as the function of its Liouville form."""
    system = chart.coordinates_around_sphere()
    beta, _, epsilon = letters()
    laws = (*system.laws, function(2 * epsilon**2 - beta, delta(right_alpha())))
    return ((ball.vanishing_area(), chart.of_ball()), *((system, law) for law in laws))


def eq_8_12_without_mass() -> Case:
    """The function (8.12) for d = 0."""
    beta, gamma, epsilon = letters()
    z = chart.variable(chart.u[0])
    first = 16 * sp.Mul(*(z - j for j in chart.J.symbols)) / (gamma * (2 * z - epsilon) ** 2)
    value = first * (z * beta + 4 * gamma) ** 2
    law = Identity(
        "S",
        value + 8 * chart.function(chart.u[0]) / gamma,
        "function S for d = 0",
        level=(chart.TRACE - chart.tau,),
    )
    return chart.coordinates_around_sphere(), law


def euler() -> Case:
    """d = 0: the momentum obeys Euler's equations."""
    law = Identity(
        "euler",
        rate(ball.M) - cross(ball.M, ball.I**-1 * ball.M),
        "Euler's equations",
        level=(ball.d,),
    )
    return ball.equations_on_sphere(), law


CLAIMS = (
    Claim(
        "(8.8), orbit",
        r"$m_1 = p_1(x^2 - 1) + p_2(y^2 - 1)$, $m_2 = ip_1(x^2 + 1) + ip_2(y^2 + 1)$, $m_3 = 2p_1x "
        r"+ 2p_2y$, $\gamma_1 = \frac{xy - 1}{x - y}$, $\gamma_2 = i\frac{xy - 1}{x - y}$, "
        r"$\gamma_3 = \frac{x + y}{x - y}$ parametrize the orbit $\gamma^2 = 1$, $(\mathbf{m}, "
        r"\gamma) = 0$.",
        lambda: leaf(-1),
        lambda: leaf(1),
        r"$\gamma_2 = i\frac{xy + 1}{x - y}$",
        "the sign in the numerator of γ₂",
    ),
    Claim(
        "(8.8), brackets",
        "The coordinates are canonical (Darboux coordinates) for the algebra $e(3)$.",
        lambda: algebra(0, sp.S.One),
        lambda: algebra(-1, sp.S.Half),
        r"$\mathbf{m}$ is the printed one divided by $2i$: $m_1 = -\frac{i}{2}(p_1(x^2 - 1) + "
        r"p_2(y^2 - 1))$, and so on; or $\{x, p_1\} = \{y, p_2\} = -\frac{i}{2}$",
        "a factor 2i: the printed m obey {m_i, m_j} = 2iε_ijk m_k; read with {x, p₁} = {y, p₂} = 1 "
        "and the correct γ₂",
    ),
    Claim(
        "(8.9)",
        r"Using (8.8), the pair $(H, F_2)$ has the form $H = a(x, y)p_1^2 + 2b(x, y)p_1p_2 + c(x, "
        r"y)p_2^2$, $F_2 = A(x, y)p_1^2 + 2B(x, y)p_1p_2 + C(x, y)p_2^2$.",
        quadratic_in_momenta,
        note="for (8.8) as printed and as corrected; with the correct δ and A",
    ),
    Claim(
        "(8.10)",
        "To get separable variables it is sufficient to solve the equation $(B - bs)^2 = (A - "
        "as)(C - cs)$.",
        roots,
        note="s₁, s₂ of Liouville's form are its roots, for arbitrary S₁, S₂ and momenta P = Gp",
    ),
    Claim(
        "(8.11)",
        r"In the new coordinates $H = \frac{S_1(s_1)}{s_1 - s_2} P_1^2 - \frac{S_2(s_2)}{s_1 - "
        r"s_2} P_2^2$, $F = \frac{s_2 S_1(s_1)}{s_1 - s_2} P_1^2 - \frac{s_1 S_2(s_2)}{s_1 - s_2} "
        "P_2^2$.",
        liouville_form,
        note="both are in involution for arbitrary S₁ and S₂, and S_i P_i² = s_i H − F; that the "
        "ball takes this form is part of the next claims",
    ),
    Claim(
        "(8.12), Δ",
        r"$\Delta = x^2(\beta^2 + 8\alpha d) + 2x(4\beta\gamma + d\beta^2 - 2d\alpha\epsilon + "
        r"4\alpha d^2) + (4\gamma + d\beta)^2$ with $\alpha = (J_2 + J_1 - J_3)(-J_2 + J_2 - "
        "J_3)(-J_2 + J_2 + J_3)$.",
        lambda: discriminant(printed_alpha()),
        lambda: discriminant(right_alpha()),
        r"the same with $\alpha = (J_2 + J_1 - J_3)(-J_2 + J_1 - J_3)(-J_2 + J_1 + J_3)$",
        "J₂ stands for J₁ in two factors of α (the last J₃ is printed J − 3); judged as the "
        "discriminant of the equation that gives ζ for a value of x",
    ),
    Claim(
        "(8.12)",
        r"$S(x) = \frac{2(8x^3 + 8(d - \epsilon)x^2 + (2\epsilon^2\beta - 4d\epsilon)x - 4\gamma - "
        r"d\beta + \sqrt{\Delta})}{\gamma(2x - \epsilon + 2d)^2}$.",
        eq_8_12_printed,
        eq_8_12_corrected,
        r"$S(x) = \frac{2\Delta(8x^3 + 8(d - \epsilon)x^2 + (2\epsilon^2 - \beta - 4d\epsilon)x - "
        r"4\gamma - d\beta + \sqrt{\Delta})}{\gamma(2x - \epsilon + 2d)^2}$ with the branch "
        r"$\sqrt{\Delta} = -4Q\frac{dx}{d\zeta}$",
        "the factor Δ is missing, and ε²β stands for ε² − β/2; the normalisation is that of the "
        "printed (8.8), with F = M²/γ and H = (M, ω)/γ: for canonical momenta and H = ½ (M, ω), "
        "F = ½ M² the function is −γ/8 times as large",
    ),
    Claim(
        "§8.3, S for d = 0",
        r"If $d = 0$, $S(x) = 16 \frac{(x - J_1)(x - J_2)(x - J_3)}{J_1J_2J_3(2x - J_1 - J_2 - "
        r"J_3)^2} (x(J_1^2 + J_2^2 + J_3^2 - 2J_1J_2 - 2J_2J_3 - 2J_3J_1) + 4J_1J_2J_3)^2$.",
        eq_8_12_without_mass,
        note="with the normalisation of (8.12)",
    ),
    Claim(
        "§8.3, d = 0",
        "The case of $d = 0$ corresponds to the classical Euler–Poinsot problem.",
        euler,
    ),
)

REMARKS = (
    Remark(
        "Remark 22, end",
        "The equations for $F_2 \\neq 0$ are enormously huge, and general methods of integration "
        "in quadratures are not yet sufficiently elaborated.",
        "judgement; with the integral ½ (ΣI + d)(M, ω) − (M, M) in place of the energy the "
        "multiplier and the form are short, and in the catalogue "
        "(nonholonomic/docs/reduction.md). Quadratures for $F_2 \\neq 0$ are not known here either",
    ),
    Remark(
        "§8.3, after (8.12)",
        "For $d = 0$ the method differs from the classical ones, although these approaches are "
        "connected with a linear-fractional function.",
        "a comparison of methods",
    ),
)
