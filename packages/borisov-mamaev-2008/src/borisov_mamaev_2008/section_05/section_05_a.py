"""§5, up to the quadratures (5.2): a heavy rubber body of revolution on a plane.

The support function p(γ₃) of the profile and the potential U(γ₃) are unspecified, so that every
claim is decided for all bodies at once.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Rate, Reduction, Symmetry
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
    zero,
)
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.angles import in_angles, phi, theta
from nonholonomic.catalogue.bodies import rubber_body_of_revolution as catalogue
from nonholonomic.catalogue.bodies.rubber_profile import (
    HEIGHT,
    POTENTIAL,
    A,
    B,
    chi_1,
    chi_2,
    from_support,
    n,
)
from nonholonomic.catalogue.fixed_point.veselova_spinning import spinning_general

from ..claim import Case, Claim
from ..methods.derived_verdicts import computed_verdict
from ..methods.independence import independent, rational_point
from ..methods.marble_bodies_of_revolution import curvatures, height, lens, linear_integral, slope
from ..methods.tensor_of_a_body import with_tensor_of_a_body
from ..methods.unspecified_systems import system

M, omega, gamma, r = vectors("M omega gamma r")
I = Diagonal("I")
m, g = real_symbol("m"), real_symbol("g")
I_1, I_2, _ = I.symbols
g_1, g_2, g_3 = gamma.symbols
w_1, w_2, w_3 = omega.symbols
HALF = sp.Rational(1, 2)
LEAN = 1 - g_3**2


@cache
def body() -> System:
    """A body with any profile in any potential."""
    return catalogue.general_system()


@cache
def body_in_angles() -> System:
    """The body in the angles θ, φ, which provably map to ω, γ."""
    return in_angles(body())


def spin() -> tuple[System, Integral]:
    """(5.1)."""
    return body(), catalogue.spin(dot(r, gamma), ())


def rotation() -> tuple[System, Symmetry]:
    """The symmetry field of rotation about the axis."""
    return body(), catalogue.rotation()


def constants() -> tuple[sp.Expr, sp.Expr]:
    """The values h and k of the integrals."""
    return HALF * dot(M, omega) + POTENTIAL, sp.sqrt(A) * w_3


# --- up to (5.1) ---------------------------------------------------------------------------


def equations() -> Case:
    """(1.18) with I_1 = I_2, in the form used for all proofs here."""
    return with_tensor_of_a_body(body(), (I_1, I_1, I.symbols[2])), catalogue.onto_rolled()


def contact_vector() -> Case:
    """r of the mechanics: the contact point is the point with the normal −γ."""
    dynamics = catalogue.rolling_equations()
    first, second = from_support(HEIGHT)
    return dynamics, Identity("contact", r - constant([first * g_1, first * g_2, second]))


def tie() -> Case:
    """r₁² + r₂² = χ₁²(1 − γ₃²), r₃ = χ₂: χ₁ and χ₂ are related by f = 0, and by the normal."""
    first, second = from_support(HEIGHT)
    r_1, r_2, r_3 = r.symbols
    normal = -g_3 * first + LEAN * first.diff(g_3) + g_3 * second.diff(g_3)
    return body(), Identity("tie", (r_1**2 + r_2**2 - chi_1**2 * LEAN, r_3 - chi_2, normal))


def potential() -> Case:
    """The contribution of the weight to the energy."""
    dynamics = catalogue.rolling_equations(gravity=9.81)
    first, second = from_support(HEIGHT)
    (energy,) = (item.value for item in dynamics.integrals)
    weight = energy - HALF * dot(M, omega) - POTENTIAL
    return dynamics, Identity("potential", weight + m * g * (first * LEAN + second * g_3))


def geometric() -> Case:
    """γ² and (ω, γ)."""
    dynamics = catalogue.rolling_equations()
    return (
        (dynamics, Integral("geometric", norm_squared(gamma))),
        (dynamics, Integral("constraint", dot(omega, gamma))),
    )


def energy_printed() -> Case:
    """½(ω, Iω) + U."""
    return body(), Integral("energy", HALF * dot(omega, I * omega) + POTENTIAL)


def energy() -> Case:
    """½(ω, Ĩω) + U, Ĩω = M."""
    return body(), Integral("energy", HALF * dot(omega, M) + POTENTIAL)


def only_spheres() -> Verdict:
    """A convex body other than a sphere with an elementary integral although it may spin."""
    verdict = prove(lens(), linear_integral())
    along, across = curvatures()
    place = {g_3: (4, 5), height: (1, 1), slope: (0, 1), m: (1, 1), I.symbols[2]: (1, 5)}
    at = {symbol: sp.Rational(*value) for symbol, value in place.items()}
    radii = [formula.xreplace(at) for formula in (along, across)]
    contradicts = bool(verdict) and min(radii) > 0 and radii[0] != radii[1]
    return computed_verdict(
        "only spheres",
        contradicts,
        f"a body with the radii of curvature {radii[0]}, {radii[1]} has such an integral",
        verdict.reason or "the radii tried do not decide it",
        decision="refuted",
        witness={str(symbol): str(value) for symbol, value in at.items()},
    )


def edge() -> tuple[System, Identity]:
    """At γ₃ = 0 the left side of the condition on a lens is (I₃ + mp²)p².

    There r₁² + r₂² = p² and ρ₂ = p for every support function p. A smooth closed strictly convex
    body of revolution touches the plane with every normal, and p > 0 at γ₃ = 0, where p is the
    distance between the tangent plane and the axis, which are parallel.
    """
    first, second = from_support(HEIGHT)
    across = HEIGHT - g_3 * HEIGHT.diff(g_3)
    along = across + LEAN * HEIGHT.diff(g_3, 2)
    third, reach = I.symbols[2], first**2 * LEAN
    left = third * g_3 * second * along + (third + m * reach) * HEIGHT * across
    dynamics = system(
        "contact", "a contact point, at rest", {gamma: zero}, relations=(norm_squared(gamma) - 1,)
    )
    dynamics = replace(
        dynamics, parameters=(Parameter(m, "mass", 1.3), Parameter(third, "moment", 0.2))
    )
    return dynamics, Identity("edge", left - (third + m * HEIGHT**2) * HEIGHT**2, level=(g_3,))


def other_bodies() -> Case:
    """M₃/√(I₃ + m(r₁² + r₂²)) for a lens, and that only a body with an edge is a lens."""
    return (lens(), linear_integral()), edge()


def lie() -> Case:
    """Two integrals in addition to the relations, and a symmetry field tangent to their level."""
    dynamics = body()
    turning = replace(
        dynamics, field={v: cross(unit_vector(3), v) for v in (omega, gamma)}, laws=()
    )
    h, k = constants()
    levels = (Integral("energy", h), Integral("spin", k))
    return (
        rotation(),
        *((dynamics, integral) for integral in levels),
        *((turning, integral) for integral in levels),
    )


def lie_independent() -> Case:
    """γ², (ω, γ), energy and K² of Routh's sphere have independent differentials."""
    dynamics = CATALOGUE["rubber-routh-sphere"].system()
    (energy,) = (item.value for item in dynamics.integrals if item.name == "energy")
    square = I_1 * g_3**2 + I.symbols[2] * LEAN + m * dot(r, gamma) ** 2
    state = dict(
        zip(map(str, dynamics.symbols), ("3", "0", "-1", "2/7", "3/7", "6/7"), strict=True)
    )
    return independent(
        dynamics,
        (norm_squared(gamma), dot(omega, gamma), energy, square * w_3**2),
        rational_point(dynamics, state),
    )


# --- (5.2) ---------------------------------------------------------------------------------


def angles() -> Case:
    """The angles map to γ and ω, and every γ is covered."""
    dynamics = body_in_angles()
    return dynamics, dynamics.laws[0]


def nutation() -> Case:
    """The first equation (5.2)."""
    h, k = constants()
    lean = sp.sin(theta) ** 2
    value = HALF * B * Rate(theta) ** 2 + k**2 / (2 * lean) + POTENTIAL - h
    return body_in_angles(), Identity("nutation", value)


def own_rotation() -> Case:
    """φ̇ = ω₃/sin²θ."""
    return body_in_angles(), Identity("phi", Rate(phi) - w_3 / sp.sin(theta) ** 2)


def omega_1() -> Case:
    """ω₁ by θ̇ and ω₃."""
    value = Rate(theta) * sp.cos(phi) - w_3 * sp.cot(theta) * sp.sin(phi)
    return body_in_angles(), Identity("omega_1", w_1 - value)


def omega_2() -> Case:
    """ω₂ by θ̇ and ω₃."""
    value = -Rate(theta) * sp.sin(phi) - w_3 * sp.cot(theta) * sp.cos(phi)
    return body_in_angles(), Identity("omega_2", w_2 - value)


def principal() -> Case:
    """B is the moment of inertia about the horizontal axis n through the contact."""
    moment = dot(n, I * n + m * cross(r, cross(n, r)))
    return body(), Identity("B", moment - (I_1 + m * dot(r, r)) * norm_squared(n))


def quadratures() -> tuple[System, Reduction]:
    """(5.2) in terms of γ₃ instead of θ."""
    return body(), catalogue.quadratures(body(), r + 0 * gamma, dot(r, gamma), ())


def kinematics() -> Case:
    """φ = arctan(γ₁/γ₂) along γ̇ = γ×ω for any ω, here that of a body with a fixed point."""
    value = w_3 - g_3 * (w_1 * g_1 + w_2 * g_2) / (g_1**2 + g_2**2)
    return spinning_general(), Identity("phi", Rate(sp.atan2(g_1, g_2)) - value)


CLAIMS = (
    Claim(
        "§5, first paragraph",
        r"The evolution of $\omega, \gamma$ is governed by equations (1.18), with $I_1 = I_2$ and "
        r"$f(r_1^2 + r_2^2, r_3) = 0$.",
        equations,
        note="(1.18) along γ×e₃ and e₃ − γ₃γ, the form used below, is the one of the mechanics",
    ),
    Claim(
        "§5, r",
        r"$r = (\chi_1(\gamma_3)\gamma_1, \chi_1(\gamma_3)\gamma_2, \chi_2(\gamma_3))$",
        contact_vector,
        note="χ₁ = −p + γ₃p′, χ₂ = −γ₃p − (1 − γ₃²)p′ with the height p of the centre of mass",
    ),
    Claim(
        "§5, χ₁ and χ₂",
        r"The functions $\chi_1, \chi_2$ are not independent because they are related by the "
        r"equation $f(\chi_1^2(1 - \gamma_3^2), \chi_2) = 0$.",
        tie,
        note="the normal −γ ties them too: −γ₃χ₁ + (1 − γ₃²)χ₁′ + γ₃χ₂′ = 0, which (5.1) needs",
    ),
    Claim(
        "§5, U",
        r"$U(\gamma_3) = -mg(\chi_1(1 - \gamma_3^2) + \chi_2\gamma_3)$",
        potential,
    ),
    Claim(
        "§5, geometric integral and constraint",
        r"$\gamma^2 = 1$, $(\omega, \gamma) = 0$ are preserved.",
        geometric,
    ),
    Claim(
        "§5, energy",
        r"By Theorem 1 the system admits the integral of energy "
        r"$\mathcal{E} = \frac{1}{2}(\omega, I\omega) + U(\gamma_3)$.",
        energy_printed,
        energy,
        r"$\mathcal{E} = \frac{1}{2}(\omega, \tilde{I}\omega) + U(\gamma_3)$",
        "missing tilde: I stands for the tensor about the contact point",
    ),
    Claim(
        "§5, symmetry field",
        r"(1.18) has the symmetry field $u = \omega_1 \partial/\partial\omega_2 - "
        r"\omega_2 \partial/\partial\omega_1 + \gamma_1 \partial/\partial\gamma_2 - "
        r"\gamma_2 \partial/\partial\gamma_1$.",
        rotation,
    ),
    Claim(
        "(5.1)",
        r"The system has the first integral $K = A(\gamma_3)\omega_3$, "
        r"$A(\gamma_3) = \sqrt{I_1\gamma_3^2 + I_3(1 - \gamma_3^2) + m(r, \gamma)^2}$.",
        spin,
    ),
    Claim(
        "§5, after (5.1)",
        "When spinning is allowed, the linear integral can be expressed in elementary functions "
        "only when the surface of the body is a sphere.",
        only_spheres,
        other_bodies,
        "There are other bodies: if, with the height p of the centre of mass and the radii of "
        "curvature ρ₁ along and ρ₂ across the meridian, "
        r"$I_3\gamma_3 r_3\rho_1 + (I_3 + m(r_1^2 + r_2^2))p\rho_2 = 0$, then "
        r"$M_3/\sqrt{I_3 + m(r_1^2 + r_2^2)}$ is an integral. They have an edge: at "
        r"$\gamma_3 = 0$ the left side is $(I_3 + mp^2)p^2 > 0$.",
        "too strong; read, as for (5.1), as elementary functions of ω and γ once r(γ) is given. A "
        "smooth closed strictly convex body has points with γ₃ = 0 and is none of these; a lens, "
        "two smooth caps that meet in an edge, is one. Whether a smooth closed body that is no "
        "sphere has an elementary integral of another form is not decided",
    ),
    Claim(
        "§5, Lie's theorem",
        "There are enough first integrals and symmetry fields for Lie's theorem: four integrals "
        "and one symmetry field, tangent to their common level, in dimension six.",
        lie,
    ),
    Claim(
        "§5, Lie's theorem, independence",
        r"The integrals $\gamma^2$, $(\omega, \gamma)$, $\mathcal{E}$, $K$ are independent.",
        lie_independent,
        argument="for every body of revolution: where γ is not along e₃, the last three have the "
        "derivatives γ, Ĩω and Ae₃ by ω, independent for almost all ω since Ĩ is invertible, and "
        "γ² does not contain ω; computed is Routh's sphere",
    ),
    Claim(
        "§5, γ in the angles",
        r"$\gamma = (\sin\theta\sin\varphi, \sin\theta\cos\varphi, \cos\theta)$ with the "
        "angles θ of nutation and φ of intrinsic rotation",
        angles,
    ),
    Claim(
        "(5.2), θ",
        r"$\frac{1}{2}B(\gamma_3)\dot{\theta}^2 + \frac{k^2}{2\sin^2\theta} + U(\gamma_3) = h$",
        nutation,
        note="h is the value of the energy as corrected",
    ),
    Claim("(5.2), ω₃", r"$\omega_3 = \frac{k}{A(\gamma_3)}$", spin),
    Claim("(5.2), φ", r"$\dot{\varphi} = \frac{\omega_3}{\sin^2\theta}$", own_rotation),
    Claim(
        "(5.2), ω₁",
        r"$\omega_1 = \dot{\theta}\cos\varphi - \omega_3 \mathrm{ctg}\theta\sin\varphi$",
        omega_1,
    ),
    Claim(
        "(5.2), ω₂",
        r"$\omega_2 = -\dot{\theta}\sin\varphi - \omega_3 \mathrm{ctg}\theta\cos\varphi$",
        omega_2,
    ),
    Claim("(5.2), B", r"$B(\gamma_3) = I_1 + m(r, r)$", principal),
    Claim(
        "§5, quadratures",
        "The system is solved in terms of quadratures.",
        quadratures,
        note="(5.2) as equations for γ₃ and γ₁ : γ₂ alone",
    ),
    Claim(
        "Remark 13",
        r"$\dot{\varphi} = \omega_3 - "
        r"\frac{\gamma_3(\omega_1\gamma_1 + \omega_2\gamma_2)}{\gamma_1^2 + \gamma_2^2}$",
        kinematics,
    ),
)
