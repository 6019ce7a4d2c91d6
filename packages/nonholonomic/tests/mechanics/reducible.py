"""Mechanisms whose reduction is known, by Lagrangian and constraints alone."""

import sympy as sp

from flowlanes.system.system import Parameter
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)
from nonholonomic.mechanics.lagrangian.mechanism import (
    Frame,
    Mechanism,
    coordinates,
    euclidean,
    rotations,
)

HALF = sp.Rational(1, 2)
omega, v, gamma, rotors = vectors("omega v gamma k")
I = Diagonal("I")
m, R, ratio = real_symbol("m"), real_symbol("R"), real_symbol("kappa")
x, y, phi, theta, psi = (real_symbol(name) for name in ("x", "y", "phi", "theta", "psi"))
a, b = real_symbol("a"), real_symbol("b")

INERTIA = tuple(
    Parameter(s, f"moment of inertia about body axis {i}", value, "kg m^2", (s > 0,))
    for i, (s, value) in enumerate(zip(I.symbols, (1.0, 1.5, 2.1), strict=True), 1)
)
MASS = Parameter(m, "mass", 1.2, "kg", (m > 0,))
RADIUS = Parameter(R, "radius", 0.9, "m", (R > 0,))
ROTORS = tuple(
    Parameter(s, f"momentum of rotors, body axis {i}", value, "kg m^2/s")
    for i, (s, value) in enumerate(zip(rotors.symbols, (0.3, -0.2, 0.5), strict=True), 1)
)


def sleigh(ahead: sp.Expr = a) -> Mechanism:
    """The Chaplygin sleigh, its centre of mass `ahead` of the blade and b beside it."""
    frame = coordinates(x, y, phi)
    dx, dy, turning = frame.w
    along, across = dx * sp.cos(phi) + dy * sp.sin(phi), dy * sp.cos(phi) - dx * sp.sin(phi)
    moment = real_symbol("I")
    kinetic = HALF * m * ((along - b * turning) ** 2 + (across + ahead * turning) ** 2)
    distance = (Parameter(a, "distance of the centre of mass ahead", 0.3, "m"),)
    return Mechanism(
        "sleigh",
        frame,
        kinetic + HALF * moment * turning**2,
        (across,),
        parameters=(
            MASS,
            Parameter(moment, "moment of inertia", 0.7, "kg m^2", (moment > 0,)),
            Parameter(b, "distance of the centre of mass to the left", 0.1, "m"),
            *(distance if ahead == a else ()),
        ),
    )


def veselova(potential: sp.Expr = sp.S.Zero) -> Mechanism:
    """A body about a fixed point with (ω, γ) = 0."""
    frame = Frame(
        {gamma: cross(gamma, omega)}, (omega,), (norm_squared(gamma) - 1,), rotations(omega)
    )
    kinetic = HALF * dot(omega, I * omega)
    return Mechanism(
        "veselova", frame, kinetic - potential, (dot(omega, gamma),), parameters=INERTIA
    )


def ball(gyrostat: bool = False, potential: sp.Expr = sp.S.Zero) -> Mechanism:
    """The Chaplygin ball on a plane; v is the velocity of its centre."""
    frame = Frame(
        {gamma: cross(gamma, omega)}, (omega, v), (norm_squared(gamma) - 1,), euclidean(omega, v)
    )
    carried = dot(rotors, omega) if gyrostat else sp.S.Zero
    return Mechanism(
        "ball",
        frame,
        HALF * (dot(omega, I * omega) + m * norm_squared(v)) + carried - potential,
        (v - cross(omega, R * gamma),),
        parameters=(*INERTIA, MASS, RADIUS, *(ROTORS if gyrostat else ())),
    )


def ball_in_coordinates() -> Mechanism:
    """The same in the place x, y and Euler angles, with (7.8)."""
    frame = coordinates(x, y, theta, phi, psi)
    dx, dy, d_theta, d_phi, d_psi = frame.w
    sine, cosine = sp.sin, sp.cos
    spin = (
        d_psi * sine(theta) * sine(phi) + d_theta * cosine(phi),
        d_psi * sine(theta) * cosine(phi) - d_theta * sine(phi),
        d_psi * cosine(theta) + d_phi,
    )
    turning = sp.Add(*(i * w**2 for i, w in zip(I.symbols, spin, strict=True)))
    return Mechanism(
        "ball-in-coordinates",
        frame,
        HALF * (m * (dx**2 + dy**2) + turning),
        (
            dx - R * d_theta * sine(psi) + R * d_phi * sine(theta) * cosine(psi),
            dy + R * d_theta * cosine(psi) + R * d_phi * sine(theta) * sine(psi),
        ),
        parameters=(*INERTIA, MASS, RADIUS),
    )


#: The velocity along the tangent plane.
across = v - dot(gamma, v) * gamma


def on_sphere(k: sp.Expr, rubber: bool) -> Mechanism:
    """A balanced ball on a sphere; without slip γ̇ = k γ×ω.

    Its centre is at Rγ/(1 − k) from that of the sphere, which gives γ̇ for every v that keeps
    this distance.
    """
    frame = Frame(
        {gamma: cross(gamma, omega) + (1 - k) / R * across},
        (omega, v),
        (norm_squared(gamma) - 1,),
        euclidean(omega, v),
    )
    extra = (Parameter(ratio, "ratio a/(a + R)", 0.6),) if k == ratio else ()
    return Mechanism(
        "ball-on-sphere",
        frame,
        HALF * (dot(omega, I * omega) + m * norm_squared(v)),
        (v - cross(omega, R * gamma), *((dot(omega, gamma),) if rubber else ())),
        parameters=(*INERTIA, MASS, RADIUS, *extra),
    )


def hollow_ball(
    moments: tuple[sp.Rational, ...] = (sp.S(1), sp.Rational(3, 2), sp.S(2)),
) -> Mechanism:
    """The marble ball around a sphere of half its radius, k = −1, with numbers; m = R = 1."""
    frame = Frame(
        {gamma: cross(gamma, omega) + 2 * across},
        (omega, v),
        (norm_squared(gamma) - 1,),
        euclidean(omega, v),
    )
    tensor = constant(sp.diag(*moments))
    return Mechanism(
        "hollow-ball",
        frame,
        HALF * (dot(omega, tensor * omega) + norm_squared(v)),
        (v - cross(omega, gamma),),
    )
