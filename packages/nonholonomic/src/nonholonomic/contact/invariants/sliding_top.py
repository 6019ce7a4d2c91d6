"""A spherical body of revolution that slides on a plane under a friction force (§11.3).

The centre of the sphere lies on the axis e at the distance c from the centre of mass, so that the
contact is r = c e − Rγ and the height of the centre of mass R − cγ₃.  The force of the plane is
N(γ + p) with a friction p in proportion to the normal force, and from the height

    N [1/m + (c/I₁)(c(1 − γ₃²) + p₃(R − cγ₃))] = g − c [(γ̇×ω)₃ + (γ×(Iω×ω))₃/I₁].
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Integral, Law, Rate
from flowlanes.system.system import Guard, Observable, Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import constant, cross, dot, norm_squared, real_symbol, vectors

v, omega, gamma, r, slip, p = vectors("v omega gamma r slip p")
m, R, c, g, I_1, I_3, nu, N, slip_speed = (
    real_symbol(s) for s in ("m", "R", "c", "g", "I_1", "I_3", "nu", "N", "slip_speed")
)
AXIS = unit_vector(3)
INERTIA = constant(sp.diag(I_1, I_1, I_3))
SOURCE = "§11.3"

#: Friction proportional to slip and normal force, per unit of both.
NORMAL_VISCOUS = -nu * slip


def body_parameters(mass: float, across: float, about: float) -> tuple[Parameter, ...]:
    """Mass and moments of inertia of a body of revolution."""
    return (
        Parameter(m, "mass", mass, "kg", (m > 0,)),
        Parameter(I_1, "moment of inertia across the axis", across, "kg m^2", (I_1 > 0,)),
        Parameter(I_3, "moment of inertia about the axis", about, "kg m^2", (I_3 > 0,)),
    )


def sphere_parameters(radius: float, offset: float, gravity: float) -> tuple[Parameter, ...]:
    """Parameters of a top with a spherical surface: radius, offset of the centre, and gravity."""
    return (
        Parameter(R, "radius of the sphere", radius, "m", (R > 0,)),
        Parameter(c, "centre of the sphere less centre of mass, along the axis", offset, "m"),
        Parameter(g, "acceleration of gravity", gravity, "m/s^2", (g >= 0,)),
    )


def sliding_top(
    friction: MatrixExpr, parameters: tuple[Parameter, ...], name: str = "sliding-top"
) -> System:
    """The equations of a sliding top, without its position.

    Parameters
    ----------
    friction : MatrixExpr
        p, the friction force for each unit of normal force: tangential, a formula in `slip`.
    parameters : tuple of Parameter
        Those of the body, the sphere and the friction.
    name : str

    Returns
    -------
    System
        State: velocity `v` of the centre of mass, `omega` and `gamma`, body axes.

    Examples
    --------
    >>> import lawproof
    >>> from nonholonomic.contact.invariants.sliding_top import jellett, tippe_top
    >>> lawproof.prove(tippe_top(), jellett()).decision
    'proven'
    """
    pushed = gamma + p
    spun = cross(INERTIA * omega, omega)
    turned = cross(cross(gamma, omega), omega) + cross(gamma, spun) / I_1
    gamma_3, p_3 = gamma.symbols[2], p.symbols[2]
    response = 1 / m + c / I_1 * (c * (1 - gamma_3**2) + p_3 * (R - c * gamma_3))
    return System(
        name=name,
        title="Tippe top that slides",
        field={
            v: N / m * pushed - g * gamma - cross(omega, v),
            omega: INERTIA**-1 * (spun + N * cross(r, pushed)),
            gamma: cross(gamma, omega),
        },
        definitions={
            r: c * AXIS - R * gamma,
            slip: v + cross(omega, r),
            slip_speed: sp.sqrt(norm_squared(slip)),
            p: friction,
            N: (g - c * dot(turned, AXIS)) / response,
        },
        parameters=parameters,
        relations=(norm_squared(gamma) - 1, dot(gamma, slip)),
        observables=(
            Observable("slip", slip, "velocity of the contact over the plane", "m/s", "body"),
            Observable("normal_force", N, "normal force", "N"),
            Observable("friction_force", N * p, "friction force", "N", "body"),
            Observable("energy", ENERGY, "energy", "J"),
        ),
        guards=(Guard("contact", N, "the normal force changes sign", lift_off=True),),
        source=SOURCE,
        summary="A spherical body of revolution on a plane on which it slides with friction.",
    )


def _energy() -> sp.Expr:
    kinetic = (m * norm_squared(v) + dot(INERTIA * omega, omega)) / 2
    return kinetic + m * g * (R - c * gamma.symbols[2])


#: Kinetic and potential energy (J).
ENERGY = _energy()


def tippe_top() -> System:
    """The top of Leine and Glocker, with the friction −0.3 N u (in SI units)."""
    friction = Parameter(nu, "coefficient of friction", 0.3, "s/m", (nu >= 0,))
    shape = sphere_parameters(0.015, 0.003, 9.81)
    return sliding_top(NORMAL_VISCOUS, (*body_parameters(0.006, 8e-7, 7e-7), *shape, friction))


def jellett() -> Integral:
    """Jellett's integral (Iω, Rγ − c e)."""
    return Integral(
        "jellett",
        -dot(INERTIA * omega, r),
        "Jellett's integral",
        unit="kg m^3/s",
        source=SOURCE,
    )


def energy_decrease() -> Identity:
    """The rate of the energy, N(p, u): −νN u² for the viscous law, −μN |u| for the dry one."""
    return Identity(
        "energy_decrease",
        Rate(ENERGY) - N * dot(p, slip),
        "the energy changes by the power of the friction force",
        source="§11.1",
    )


def laws() -> tuple[Law, ...]:
    """Jellett's integral and the decrease of the energy."""
    return jellett(), energy_decrease()
