"""A homogeneous ball that rolls on any surface (§2.2, §2.3), in space axes.

The normal n = ∇f/|∇f| of the surface points to the ball, r = −bn leads from the centre R to the
contact point, and the centre moves on the parallel surface at the distance b.  The moment of
inertia is μ about every axis through the centre.  With the force F at the centre, the contact
force N and, for a rubber ball, the torque N₀r about the normal,

    m v̇ = N + F,      μ ω̇ = r×N + N₀ r,      v = r×ω.

Without N these are, with m̃ = m + μ/b²,

    b² m̃ ω̇ = F×r + m b² (ω, n) ṅ            (marble),
    b² m̃ ω̇ = F×r − b² m̃ (ω, ṅ) n,  (ω, n) = 0      (rubber).

The rate of n depends on the surface that is given: that of the centre (`centre_surface`), or the
one that carries the ball (`supporting_surface`), with the contact point x in place of R.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Name, Observable, Parameter, Reconstruction, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)

from ..conventions import BODY
from ..rolling.attitude import attitude, attitude_observable, quaternion_rate, rotation, unit_length

R, x, omega, v, n, ndot, xdot = vectors("R x omega v n ndot xdot")
r, N, F, df, turned = vectors("r N F df vtilde")
m, mu, b = (real_symbol(name) for name in ("m", "mu", "b"))
ell, mtilde, spin, N_0 = (real_symbol(name) for name in ("ell", "mtilde", "sigma", "N_0"))
H, K, Delta = (real_symbol(name) for name in ("H", "K", "Delta"))

Carrier = Literal["centre", "support"]
Contact = Literal["marble", "rubber"]


@dataclass(frozen=True)
class Kinematics:
    """The normal of the surface as a function of the position of the ball.

    Attributes
    ----------
    surface : sympy.Expr
        f, which grows towards the ball, in the components of `place`.
    place : Vector
        R, or x.
    normal, turning : pairs
        Definitions of n and R; and those of ṅ and the rate of `place`, in terms of v.
    rate : MatrixExpr
        Rate of `place`.
    fit : sympy.Expr or None
        Δ, positive while the ball fits the curvature of the surface; None if f is the centre's.
    """

    surface: sp.Expr
    place: Vector
    normal: Pairs
    turning: Pairs
    rate: MatrixExpr
    fit: sp.Expr | None


def _normal(surface: sp.Expr, place: Vector) -> Pairs:
    return ((df, gradient(surface, place, "f")), (ell, sp.sqrt(norm_squared(df))), (n, df / ell))


def _shape_operator(surface: sp.Expr, place: Vector, vector: MatrixExpr) -> MatrixExpr:
    """S u = (Hu − (n, Hu)n)/|∇f| for tangent u, with the Hessian H of f."""
    bent = constant(sp.hessian(surface, place.symbols)) * vector
    return (bent - dot(n, bent) * n) / ell


def centre_surface(surface: sp.Expr) -> Kinematics:
    """The surface of the centre is given: f(R) = 0 and ṅ = S v.

    Parameters
    ----------
    surface : sympy.Expr
        f in ``R_1``, ``R_2``, ``R_3``.
    """
    turning = ((ndot, _shape_operator(surface, R, v)),)
    return Kinematics(surface, R, _normal(surface, R), turning, v, None)


def supporting_surface(surface: sp.Expr) -> Kinematics:
    """The supporting surface is given: f(x) = 0 and R = x + bn.

    From v = (1 + bS) ẋ on the tangent plane, with the trace 2H and the determinant K of S,
    Δẋ = (1 + 2bH) v − b S v and Δṅ = S v + bK v, where Δ = 1 + 2bH + b²K.

    Parameters
    ----------
    surface : sympy.Expr
        f in ``x_1``, ``x_2``, ``x_3``.
    """
    # On the tangent plane tr(1 + bS) = 2 + 2bH and det(1 + bS) = Δ, so that by Cayley and Hamilton
    # (1 + bS)⁻¹ = (1 + 2bH − bS)/Δ; the same theorem, S² = 2H S − K, gives ṅ = S ẋ. H and K of an
    # implicit surface: R. Goldman, Comput. Aided Geom. Design 22 (2005) 632.
    second = sp.hessian(surface, x.symbols)
    normal = (
        *_normal(surface, x),
        (R, x + b * n),
        (H, (second.trace() - dot(n, constant(second) * n)) / (2 * ell)),
        (K, dot(n, constant(second.adjugate()) * n) / ell**2),
        (Delta, 1 + 2 * b * H + b**2 * K),
    )
    turning = (
        (turned, _shape_operator(surface, x, v)),
        (xdot, ((1 + 2 * b * H) * v - b * turned) / Delta),
        (ndot, (turned + b * K * v) / Delta),
    )
    return Kinematics(surface, x, normal, turning, xdot, Delta)


def ball_parameters(mass: float, inertia: float, radius: float) -> tuple[Parameter, ...]:
    """m, μ and b with their numbers."""
    return (
        Parameter(m, "mass", mass, "kg", (m > 0,)),
        Parameter(mu, "moment of inertia about the centre", inertia, "kg m^2", (mu > 0,)),
        Parameter(b, "radius of the ball", radius, "m", (b > 0,)),
    )


def ball_equations(
    contact: Contact,
    kinematics: Kinematics,
    force: MatrixExpr,
    parameters: tuple[Parameter, ...],
    name: str = "ball-on-surface",
    title: str = "Homogeneous ball on a surface",
) -> System:
    """The ball on any surface, under any force at its centre.

    Parameters
    ----------
    contact : ``"marble"`` or ``"rubber"``
    kinematics : Kinematics
        From `centre_surface` or `supporting_surface`; f may be an unspecified function.
    force : vector
        F in space axes, in R, ω and parameters; it may be unspecified too.
    parameters : tuple of Parameter
        m, μ, b and those in the surface and the force.
    name, title : str

    Returns
    -------
    System
        State R or x, and ω, in space axes. f is a first integral; add it to the relations to
        require f = 0.
    """
    share = (mu / b**2) / mtilde
    # N follows from N = m v̇ − F. Its normal part uses (v, n) = 0, hence (v̇, n) = −(v, ṅ); its
    # tangential part is v̇ = ṙ×ω + r×ω̇ with ω̇ inserted.
    across = F - dot(F, n) * n
    pressed = -(m * dot(v, ndot) + dot(F, n)) * n
    turning: MatrixExpr = cross(F, r) / (b**2 * mtilde)
    push: dict[Name, sp.Expr]
    if contact == "marble":
        turning = turning + (m / mtilde) * spin * ndot
        push = {
            spin: dot(omega, n),
            N: pressed - share * across + m * share * b * spin * cross(n, ndot),
        }
        spare: tuple[sp.Expr, ...] = ()
    else:
        turning = turning - dot(omega, ndot) * n
        push = {N: pressed - share * across, N_0: mu * dot(omega, ndot) / b}
        spare = (dot(omega, df),)
    guards = [Guard("contact", dot(N, n), "the normal force changes sign", lift_off=True)]
    if kinematics.fit is not None:
        guards.append(Guard("fit", kinematics.fit, "the ball fits the surface no longer"))
    return System(
        name=name,
        title=title,
        parameters=parameters,
        definitions=(
            (mtilde, m + mu / b**2),
            *kinematics.normal,
            (r, -b * n),
            (v, cross(r, omega)),
            *kinematics.turning,
            (F, force),
            *push.items(),
        ),
        field={kinematics.place: kinematics.rate, omega: turning},
        relations=spare,
        observables=_observables(kinematics.place),
        guards=tuple(guards),
        reconstruction=_motion(),
        conventions=BODY,
        source="§2.2, §2.3",
    )


def _observables(place: Vector) -> tuple[Observable, ...]:
    where = "centre of the ball" if place == R else "contact point"
    return (
        Observable(place.name, place, where, "m", "space", "(2.7)"),
        Observable("omega", omega, "angular velocity", "rad/s", "space", "(2.8)"),
        Observable("velocity", v, "velocity of the centre", "m/s", "space", "(2.8)"),
        Observable("centre", R, "centre of the ball", "m", "space", "(2.7)"),
        Observable("contact", R + r, "contact point", "m", "space", "(2.8)"),
        Observable("normal", n, "normal of the surface at the contact", "", "space", "(2.7)"),
        Observable("normal_force", dot(N, n), "normal force", "N", source="(2.10)"),
        Observable("friction_force", N - dot(N, n) * n, "friction force", "N", "space", "(2.10)"),
    )


def _motion() -> Reconstruction:
    """The attitude of the ball, from its angular velocity in space axes."""
    turn = rotation().T
    return Reconstruction(
        field={attitude: quaternion_rate(turn * constant(omega.symbols))},
        relations=(unit_length(),),
        observables=(
            attitude_observable(),
            Observable("gamma", turn * n, "normal of the surface at the contact", "", "body"),
        ),
    )
