"""A homogeneous ball whose centre moves on an ellipsoid, drawn to its middle by a spring.

With the potential κR²/2 Joachimsthal's integral of the particle on an ellipsoid (Jacobi's problem)
survives on the marble ball; energy, this integral and an invariant measure on five dimensions do
not make it integrable.  The rubber ball is the particle itself.
"""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Law
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)

from ...mechanics.ball.ball import RollingBall
from ...mechanics.ball.equations import ball_equations, ball_parameters, centre_surface
from ...mechanics.ball.surface import EllipsoidSurface
from ..ball_entry import ball_entry
from ..ball_laws import ROLLING, quadratic
from ..catalogue_entry import Numbers
from .ball_on_any_surface import TANGENT, any_rubber, particle

R, omega, v = vectors("R omega v")
A = Diagonal("A")
ell, mtilde, kappa = (real_symbol(name) for name in ("ell", "mtilde", "kappa"))
SPRING_STIFFNESS = Parameter(kappa, "stiffness of the spring", 0.1, "N/m")
SPRING = kappa / 2 * to_components(norm_squared(R))


def _ball(numbers: Numbers) -> RollingBall:
    return RollingBall(
        mass=numbers["m"],
        inertia=numbers["mu"],
        radius=numbers["b"],
        surface=EllipsoidSurface((numbers["a_1"], numbers["a_2"], numbers["a_3"]), side="inside"),
        carrier="centre",
        potential=SPRING,
        parameters=(replace(SPRING_STIFFNESS, default=numbers["kappa"]),),
    )


def _rubber_ball(numbers: Numbers) -> RollingBall:
    return replace(_ball(numbers), contact="rubber")


def _integral(ball: RollingBall) -> tuple[Law, ...]:
    return (quadratic(ball, kappa),)


def _particle(ball: RollingBall) -> tuple[Law, ...]:
    force = -gradient(SPRING, R)
    return (
        quadratic(ball, kappa),
        Isomorphism(
            "particle",
            particle(ball.kinematics.surface, force, SPRING_STIFFNESS, *ball.surface.parameters),
            {R: R, v: v},
            constants={mtilde: mtilde},
            meaning="the centre is a particle of mass m + μ/b² on the ellipsoid",
            onto=(ball.kinematics.surface, *TANGENT),
            source="Proposition 3",
        ),
    )


def any_quadric() -> System:
    """A marble ball whose centre moves on any quadric (R, AR) = const, with A of any signs."""
    form = to_components(dot(R, A * R)) / 2
    entries = tuple(Parameter(s, f"coefficient {s}", 1.0) for s in A.symbols)
    system = ball_equations(
        "marble",
        centre_surface(form),
        -gradient(SPRING, R),
        (*ball_parameters(1.0, 0.4, 1.0), SPRING_STIFFNESS, *entries),
        name="marble-ball-on-any-quadric",
        title="Marble ball on any quadric",
    )
    return replace(system, reconstruction=None).with_laws(
        Integral(
            "quadratic",
            ell**2 * (dot(v, A * v) - 2 * kappa / mtilde * form),
            "Joachimsthal's integral, on every quadric",
            source=ROLLING,
        )
    )


ENTRIES = (
    ball_entry(
        name="marble-ball-on-ellipsoid",
        ball=_ball,
        further=_integral,
        general=any_quadric,
    ),
    ball_entry(
        name="rubber-ball-on-ellipsoid",
        ball=_rubber_ball,
        further=_particle,
        general=any_rubber,
    ),
)
