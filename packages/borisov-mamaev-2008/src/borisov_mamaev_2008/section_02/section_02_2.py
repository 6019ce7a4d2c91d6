"""§2.2 and §2.3: homogeneous balls under a resultant force as particles.

The force F(R, ω) and the surface z = f(x, y) of the centre are unspecified.
"""

from __future__ import annotations

from functools import cache

from flowlanes.system.laws import Identity, Integral, Rate
from flowlanes.system.system import System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors, zero
from nonholonomic.catalogue.balls.rubber_ball_on_surface import any_graph, general
from nonholonomic.catalogue.chaplygin_ball import marble_ball
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.catalogue_laws import law_named, printed_form

R, omega, v, r, N, F, n, df = vectors("R omega v r N F n df")
m, mu, b, N_0 = (real_symbol(name) for name in ("m", "mu", "b", "N_0"))
EFFECTIVE_MASS = m + mu / b**2


@cache
def marble() -> System:
    """A marble ball on a plane under an unspecified force."""
    return marble_ball.general()


@cache
def rubber() -> System:
    """A rubber ball on an unspecified surface under an unspecified force."""
    return general()


# --- §2.2 ----------------------------------------------------------------------------------


def rolling() -> Case:
    """The material point at r is at rest."""
    return marble(), Identity("no_slip", (v + cross(omega, r), r + b * unit_vector(3)))


def marble_balance() -> Case:
    """(2.6), with Ṙ = v."""
    newton = m * rate(v) - N - F
    euler = mu * rate(omega) - cross(r, N)
    return marble(), Identity("balance", (newton, euler, rate(R) - v))


def differentiated() -> Case:
    """μ v̇ = μ r×ω̇ = r×(r×N) = r×(r×(m v̇ − F))."""
    first = mu * rate(v) - mu * cross(r, rate(omega))
    second = mu * rate(v) - cross(r, cross(r, N))
    third = mu * rate(v) - cross(r, cross(r, m * rate(v) - F))
    return marble(), Identity("differentiated", (first, second, third))


def regrouped() -> Case:
    """(m + μ/b²) v̇ = F − (F, e_z) e_z."""
    return marble(), Identity(
        "regrouped", EFFECTIVE_MASS * rate(v) - F + dot(F, unit_vector(3)) * unit_vector(3)
    )


def particle_in_plane() -> Case:
    """Proposition 2."""
    x, y, z = R.symbols
    first, second, _ = F.symbols
    speeds = v.symbols
    return marble(), Identity(
        "particle",
        (
            Rate(x) - speeds[0],
            Rate(y) - speeds[1],
            Rate(z),
            EFFECTIVE_MASS * Rate(speeds[0]) - first,
            EFFECTIVE_MASS * Rate(speeds[1]) - second,
        ),
    )


# --- §2.3 ----------------------------------------------------------------------------------


def equidistant() -> Case:
    """The contact point R + r moves orthogonally to n, at the distance b from the centre."""
    return rubber(), Identity("equidistant", (dot(rate(R + r), n), norm_squared(r) - b**2))


def direction() -> Case:
    """r = −bn with n = ∇f/|∇f|."""
    return rubber(), Identity("direction", (cross(r, df), r + b * n, norm_squared(n) - 1))


def constraints() -> Case:
    """(2.8)."""
    return rubber(), Identity("constraints", (v + cross(omega, r), dot(omega, r), rate(R) - v))


def particle_printed() -> Case:
    """λ is a vector, as printed, and λn the vector of products of components."""
    return rubber(), printed_form(law_named(rubber(), "particle"))


def particle() -> Case:
    """(2.9) with the number λ = −(F, n) − m̃(v, ṅ)."""
    return rubber(), law_named(rubber(), "particle")


def lagrange_multiplier_equations() -> Case:
    """Check Lagrange's equations with a multiplier for a particle on the surface.

    m̃v̇ − F is along the normal n of the surface, and (v, n) = 0 is preserved.
    """
    gathered = EFFECTIVE_MASS * rate(v) - F
    across = cross(gathered, n)
    tangent = (dot(v, n), Rate(dot(v, n)))
    return rubber(), Identity("multiplier", (across, tangent))


def balance() -> Case:
    """(2.10), which preserves both constraints."""
    newton = m * rate(v) - N - F
    euler = mu * rate(omega) - cross(r, N) - N_0 * r
    return rubber(), Identity("balance", (newton, euler, rate(R) - v))


def reaction() -> Case:
    """N = m v̇ − F."""
    return rubber(), Identity("reaction", N - m * rate(v) + F)


def spin() -> Case:
    """Check b²ω = v × r for the rubber ball."""
    return rubber(), Identity("spin", b**2 * omega - cross(v, r))


def tangent() -> Case:
    """(ṙ, r) = (v, r) = 0."""
    return rubber(), Identity("tangent", (dot(rate(r), r), dot(v, r)))


def acceleration_printed() -> Case:
    """(v̇, r) = (v, ṙ) = 0."""
    return rubber(), Identity("acceleration", (dot(rate(v), r), dot(v, rate(r))))


def acceleration() -> Case:
    """(v̇, r) = −(v, ṙ)."""
    return rubber(), Identity("acceleration", dot(rate(v), r) + dot(v, rate(r)))


def slip_differentiated() -> Case:
    """μ v̇ = μ r×ω̇ + μ ṙ×ω = r×(r×N) + μ ṙ×ω."""
    first = mu * rate(v) - mu * cross(r, rate(omega)) - mu * cross(rate(r), omega)
    second = mu * rate(v) - cross(r, cross(r, N)) - mu * cross(rate(r), omega)
    return rubber(), Identity("differentiated", (first, second))


def _substituted(factor: object) -> Case:
    """μ v̇ = r×(r×m v̇) − r×(r×F) − μ(v, ṙ)r times a factor."""
    forces = cross(r, cross(r, m * rate(v))) - cross(r, cross(r, F))
    turned = mu * factor * dot(v, rate(r)) * r
    return rubber(), Identity("substituted", mu * rate(v) - forces + turned)


def substituted_printed() -> Case:
    """With μ(v, ṙ)r."""
    return _substituted(1)


def substituted() -> Case:
    """With (μ/b²)(v, ṙ)r."""
    return _substituted(1 / b**2)


def geodesic() -> Case:
    """Without forces the acceleration is along n and the speed is constant."""
    free = any_graph(zero)
    return (
        (free, Identity("geodesic", cross(rate(v), n))),
        (free, Integral("speed", norm_squared(v))),
    )


CLAIMS = (
    Claim(
        "(2.5)",
        r"$\mathbf v+\boldsymbol\omega\times\mathbf r=0$, where $\mathbf r=-be_z$",
        rolling,
    ),
    Claim(
        "Proposition 2",
        r"the center of the ball moves in a horizontal plane as a particle of mass $\tilde m=m+"
        r"\frac\mu{b^2}$ under the law $\tilde m\ddot X=F_X$, $\tilde m\ddot Y=F_Y$",
        particle_in_plane,
        note="for every force that depends on place and angular velocity (and so on the velocity)",
    ),
    Claim(
        "(2.6)",
        r"$m\dot{\mathbf v}=\mathbf N+\mathbf F$, $\mu\dot{\boldsymbol\omega}=\mathbf r\times"
        r"\mathbf N$, $\dot{\mathbf R}=\mathbf v$",
        marble_balance,
        note="the reaction that preserves the constraint exists for every force",
    ),
    Claim(
        "§2.2, proof of Proposition 2",
        r"$\mu\dot{\mathbf v}=\mu\mathbf r\times\dot{\boldsymbol\omega}=\mathbf r\times(\mathbf r"
        r"\times\mathbf N)=\mathbf r\times(\mathbf r\times(m\dot{\mathbf v}-\mathbf F))$",
        differentiated,
    ),
    Claim(
        "§2.2, end of the proof",
        r"$\left(m+\frac\mu{b^2}\right)\dot{\mathbf v}=\mathbf F-(\mathbf F,\mathbf e_z)\mathbf "
        "e_z$",
        regrouped,
    ),
    Claim(
        "(2.7)",
        "surface (2.7) of the center is equidistant to the support surface",
        equidistant,
        note="for every surface z = f(x, y)",
    ),
    Claim(
        "§2.3, after (2.7)",
        r"$\mathbf r=-b\mathbf n$, $\mathbf n=\frac{\nabla f(\mathbf R)}{|\nabla f(\mathbf R)|}$, "
        r"their normals coincide and have the same direction as the vector $\mathbf r$",
        direction,
        note="n is opposite to r: 'the same direction' means the same line, as r = −bn has it",
    ),
    Claim(
        "(2.8)",
        r"$\mathbf v+\boldsymbol\omega\times\mathbf r=0$, $(\boldsymbol\omega,\mathbf r)=0$, where "
        r"$\mathbf v=\dot{\mathbf R}$",
        constraints,
    ),
    Claim(
        "(2.9), Proposition 3",
        r"$\tilde m\dot{\mathbf v}=\mathbf F+\lambda\mathbf n$, $\lambda=-(\mathbf F,\mathbf n)"
        r"\mathbf n-(\tilde m\mathbf v,\dot{\mathbf n})\mathbf n$, $\tilde m=m+\frac\mu{b^2}$",
        particle_printed,
        particle,
        r"$\tilde m\dot{\mathbf v}=\mathbf F+\lambda\mathbf n$, $\lambda=-(\mathbf F,\mathbf n)-"
        r"(\tilde m\mathbf v,\dot{\mathbf n})$",
        "λ is a number; the factor n in it is superfluous (as printed, λ is a vector: λn is read "
        "component by component)",
    ),
    Claim(
        "Remark 6",
        "equations (2.9) are the equations of motion of a particle on a surface with undetermined "
        "Lagrange multipliers",
        lagrange_multiplier_equations,
        note="m̃v̇ − F is along n and keeps (v, n) = 0",
    ),
    Claim(
        "(2.10)",
        r"$m\dot{\mathbf v}=\mathbf N+\mathbf F$, $\mu\dot{\boldsymbol\omega}=\mathbf r\times"
        r"\mathbf N+N_0\mathbf r$, $\dot{\mathbf R}=\mathbf v$",
        balance,
        note="the reactions that preserve both constraints exist for every force and surface",
    ),
    Claim("(2.11), first relation", r"$\mathbf N=m\dot{\mathbf v}-\mathbf F$", reaction),
    Claim(
        "(2.11), second relation",
        r"$b^2\boldsymbol\omega=\mathbf v\times\mathbf r$",
        spin,
    ),
    Claim(
        "(2.11), third relation",
        r"$(\dot{\mathbf r},\mathbf r)=(\mathbf v,\mathbf r)=0$",
        tangent,
    ),
    Claim(
        "(2.11), fourth relation",
        r"$(\dot{\mathbf v},\mathbf r)=(\mathbf v,\dot{\mathbf r})=0$",
        acceleration_printed,
        acceleration,
        r"$(\dot{\mathbf v},\mathbf r)=-(\mathbf v,\dot{\mathbf r})$",
        "sign, and neither side vanishes on a curved surface: it is the derivative of (v, r) = 0",
    ),
    Claim(
        "§2.3, proof of Proposition 3",
        r"$\mu\dot{\mathbf v}=\mu\mathbf r\times\dot{\boldsymbol\omega}+\mu\dot{\mathbf r}\times"
        r"\boldsymbol\omega=\mathbf r\times(\mathbf r\times\mathbf N)+\mu\dot{\mathbf r}\times"
        r"\boldsymbol\omega$",
        slip_differentiated,
    ),
    Claim(
        "§2.3, end of the proof",
        r"$\mu\dot{\mathbf v}=\mathbf r\times(\mathbf r\times m\dot{\mathbf v})-\mathbf r\times("
        r"\mathbf r\times\mathbf F)-\mu(\mathbf v,\dot{\mathbf r})\mathbf r$",
        substituted_printed,
        substituted,
        r"$\mu\dot{\mathbf v}=\mathbf r\times(\mathbf r\times m\dot{\mathbf v})-\mathbf r\times("
        r"\mathbf r\times\mathbf F)-\frac\mu{b^2}(\mathbf v,\dot{\mathbf r})\mathbf r$",
        "the last term lacks the factor 1/b²",
    ),
    Claim(
        "§2.3, after Proposition 3",
        r"if there are no external forces ($\mathbf F=0$), the center of mass of the ball moves "
        "along a geodesic",
        geodesic,
        note="for every surface z = f(x, y)",
    ),
)

REMARKS = (
    Remark(
        "§2.2",
        "an immovable coordinate system $OXYZ$, the ball of radius $b$ and moment of inertia "
        r"$\mathbf I=\mu\mathbf E$",
        "notation",
    ),
)
