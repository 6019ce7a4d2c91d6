"""Laws of a homogeneous ball on a given surface, besides energy and measure.

In the integrals n is the normal towards the ball, σ = (ω, n), and ℓ = |∇f| of the surface on which
the centre moves.  A marble ball is a particle of mass m̃ = m + μ/b² with a further gyroscopic
force, m̃ v̇ = F + λn + (μ/b) σ n×ṅ, which does no work and leaves (v, Av) alone on a quadric
(R, AR) = 1: that is why a particle's integral survives on it.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Law, Rate, Reduction
from flowlanes.system.named_formulas import scalars
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import constant, cross, dot, real_symbol, vectors

from ..mechanics.ball.ball import RollingBall
from ..mechanics.ball.surface import (
    CircularCylinder,
    Cone,
    EllipsoidSurface,
    EllipticCylinder,
    FlatSurface,
    Paraboloid,
    Ring,
    SphericalSurface,
)

R, omega, v, n, F = vectors("R omega v n F")
m, mu, b, k, p, q = (real_symbol(name) for name in ("m", "mu", "b", "k", "p", "q"))
ell, mtilde, sigma = (real_symbol(name) for name in ("ell", "mtilde", "sigma"))
semi_axes = tuple(real_symbol(f"a_{i}") for i in (1, 2, 3))
Omega, swing = real_symbol("Omega"), real_symbol("J")

ROLLING = "Borisov, Mamaev, Kilin 2002"


def known_ball_laws(ball: RollingBall) -> tuple[Law, ...]:
    """The laws that hold for this ball, by the kind of its surface.

    Laws of the surface of the centre are stated only where that surface is known.
    """
    # every law below is for gravity alone; an entry with a potential states its own
    if ball.potential != 0:
        return ()
    if ball.contact == "rubber":
        return (*_rubber_revolution(ball), *_quadrics(ball))
    return (*_marble(ball), *_quadrics(ball))


def _third(ball: RollingBall) -> int:
    """Number of the space axis along the axis of the surface."""
    return "xyz".index(ball.surface.axis)


def _upright(ball: RollingBall) -> bool:
    """Whether no force acts but gravity along the axis of the surface."""
    across = [x for i, x in enumerate(ball.direction) if i != _third(ball)]
    return not ball.gravity or not any(across)


def _axis_of_revolution(ball: RollingBall) -> tuple[sp.Expr, ...] | None:
    """Conditions for symmetry about the axis; None if there is no such symmetry."""
    if not _upright(ball):
        return None
    match ball.surface:
        case FlatSurface() | SphericalSurface() | CircularCylinder() | Cone() | Ring():
            return ()
        # parameters are symbols in a law: that two of them are equal is a condition on it
        case EllipsoidSurface(axes=(first, second, _)) if first == second:
            return (semi_axes[0] - semi_axes[1],)
        case Paraboloid(radii=(first, second)) if first == second:
            return (p - q,)
    return None


def _marble(ball: RollingBall) -> tuple[Law, ...]:
    match ball.surface:
        case FlatSurface():
            return (_spin("plane"),)
        case SphericalSurface():
            return (_spin("sphere"), *_momenta(ball), *_revolution(ball))
        case CircularCylinder() if _upright(ball):
            return (_rotation(ball), *_golf(ball))
        case EllipticCylinder() if _upright(ball):
            return (_rotation(ball),)
        case Cone() if _upright(ball):
            return (_rotation(ball), _ray(ball))
        case Paraboloid() if _axis_of_revolution(ball) and ball.carrier == "centre":
            return (*_revolution(ball), *_paraboloid_of_revolution(ball))
        case Ring() | EllipsoidSurface() | Paraboloid():
            return _revolution(ball)
    return ()


def _spin(surface: str) -> Integral:
    meaning = f"spin about the normal of the {surface}"
    return Integral("spin", sigma, meaning, source="Routh 1884", unit="rad/s")


def _momenta(ball: RollingBall) -> tuple[Law, ...]:
    """m̃ω − mσn along every direction that gravity leaves alone."""
    value = mtilde * omega - m * sigma * n
    if not ball.gravity:
        return tuple(
            Integral(
                f"momentum_{axis}", part, f"momentum along {axis}", source="Routh 1884", unit="kg/s"
            )
            for axis, part in zip("xyz", scalars(value), strict=True)
        )
    down = constant(ball.force / (m * real_symbol("g")))
    return (
        Integral(
            "vertical", dot(value, down), "vertical momentum", source="Routh 1884", unit="kg/s"
        ),
    )


def _rotation(ball: RollingBall) -> Integral:
    value = omega.symbols[_third(ball)]
    return Integral(
        "rotation", value, "angular velocity about the axis", source=ROLLING, unit="rad/s"
    )


def _golf(ball: RollingBall) -> tuple[Law, ...]:
    """The ball in an upright pipe goes up and down: it does not fall."""
    i = _third(ball)
    x, y, z = ball.surface.own_coordinates(R.symbols)
    # inside, the normal points to the axis, and the ball goes round against its spin
    sign = ball.surface.sign
    about = 2 * sign * omega.symbols[i] / ell
    turn, total = b * about, sigma + about * z
    share = mu / (mu + m * b**2)
    return (
        Integral("swing", total, "height against spin", source=ROLLING, unit="rad/s"),
        Reduction(
            "oscillation",
            {Omega: turn, swing: total},
            (
                Rate(Omega),
                Rate(swing),
                Rate(x) + Omega * y,
                Rate(y) - Omega * x,
                Rate(Rate(z))
                + share * Omega**2 * z
                - share * b * swing * Omega
                - F.symbols[i] / mtilde,
            ),
            "going round at the rate Ω, the ball goes up and down harmonically at the rate "
            "Ω √(μ/(μ + mb²)), which is Ω √(2/7) for a solid ball",
            source=ROLLING,
        ),
    )


def _ray(ball: RollingBall) -> Integral:
    """(ω, R) with R from the apex of the cone on which the centre moves."""
    value = dot(omega, R)
    if ball.carrier == "support":
        # the cone of the centre is the given one moved by the radius along the normal
        apex = -ball.surface.sign * b * sp.sqrt(1 + k**2) / k
        value = value - apex * omega.symbols[_third(ball)]
    return Integral(
        "ray", value, "turning about the ruling times its length", source=ROLLING, unit="m rad/s"
    )


def _revolution(ball: RollingBall) -> tuple[Law, ...]:
    """The linear equations of ω₃ and σ along the meridian."""
    level = _axis_of_revolution(ball)
    return () if level is None else (meridian_law(ball.surface.axis, level),)


def meridian_law(axis: str = "z", on: tuple[sp.Expr, ...] = ()) -> Identity:
    """ω₃ and σ as functions of the place on the meridian, on any surface of revolution."""
    i = "xyz".index(axis)
    place, up, turn = R.symbols, n.symbols[i], omega.symbols[i]
    across = [j for j in range(3) if j != i]
    outward = sp.Add(*(place[j] * n.symbols[j] for j in across))
    slope = outward / sp.Add(*(place[j] ** 2 for j in across))
    return Identity(
        "meridian",
        (
            mtilde * Rate(turn) - m * sigma * Rate(up),
            (1 - up**2) * Rate(sigma) - (turn - up * sigma) * (Rate(up) - slope * Rate(place[i])),
        ),
        "two linear equations along the meridian, whose solutions give two linear integrals",
        level=on,
        source=ROLLING,
    )


def _paraboloid_of_revolution(ball: RollingBall) -> tuple[Law, ...]:
    sign = ball.surface.sign
    turn = ell * omega.symbols[_third(ball)]
    share = mu / (mu + m * b**2)
    linear = [
        Integral(
            name,
            ell ** (e * sp.sqrt(share)) * (turn - sign * (1 + e * sp.sqrt(share)) * sigma),
            f"{meaning} linear integral of the paraboloid of revolution",
            level=(p - q,),
            source=ROLLING,
            unit="rad/s",
        )
        for name, meaning, e in (("linear_first", "first", 1), ("linear_second", "second", -1))
    ]
    product = (turn - sign * sigma) ** 2 - share * sigma**2
    meaning = "product of the linear integrals of the paraboloid of revolution"
    both = Integral(
        "linear_product", product, meaning, level=(p - q,), source=ROLLING, unit="rad^2/s^2"
    )
    return (*linear, both)


def quadratic(ball: RollingBall, stiffness: sp.Expr = sp.S.Zero) -> Integral:
    """ℓ²((v, Av) + c): Joachimsthal's integral of a quadric, for a marble ball too.

    Parameters
    ----------
    ball : RollingBall
        Its centre moves on an ellipsoid or a paraboloid.
    stiffness : sympy.Expr
        κ of the potential κR²/2 on an ellipsoid.
    """
    speeds = ball.surface.own_coordinates(v.symbols)
    if isinstance(ball.surface, Paraboloid):
        x, y, _ = speeds
        units = "m/s^2"
        # gravity along the axis takes the place of the elastic force
        form = x**2 / p + y**2 / q - F.symbols[_third(ball)] / mtilde
    else:
        parts = zip(speeds, semi_axes, strict=True)
        units = "1/(m^2 s^2)"
        form = sp.Add(*(s**2 / axis**2 for s, axis in parts)) - stiffness / mtilde
    return Integral(
        "quadratic",
        ell**2 * form,
        "Joachimsthal's integral",
        source=ROLLING if ball.contact == "marble" else "Joachimsthal 1843",
        unit=units,
    )


def _quadrics(ball: RollingBall) -> tuple[Law, ...]:
    if ball.carrier == "support":
        return ()
    match ball.surface:
        case EllipsoidSurface() if not ball.gravity:
            return (quadratic(ball),)
        case Paraboloid() if _upright(ball):
            return (quadratic(ball),)
    return ()


def _rubber_revolution(ball: RollingBall) -> tuple[Law, ...]:
    """The areal velocity of a particle on a surface of revolution."""
    level = _axis_of_revolution(ball)
    if level is None:
        return ()
    value: sp.Expr = dot(cross(R, v), unit_vector(_third(ball) + 1))
    meaning = "areal velocity about the axis"
    return (Integral("area", value, meaning, level=level, source="Clairaut 1733", unit="m^2/s"),)
