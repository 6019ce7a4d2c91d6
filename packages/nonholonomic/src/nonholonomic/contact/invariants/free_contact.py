"""A body under an arbitrary force and couple at its point of contact.

With the velocity v of the centre of mass, in body axes,

    m (v̇ + ω×v) = −mgγ + R,      I ω̇ + ω×(Iω + k) = r×R + K,      γ̇ = γ×ω,

where the force R and the couple K are unspecified functions: normal force and friction of any law,
on a plane at rest or in motion, or zero in flight.  Laws proved for this system hold in all these
cases.  Position, attitude and time are omitted, although R and K may depend on them: the rate of a
function of v, ω and γ involves only the values of R and K.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Identity, Integral, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    zero,
)

from ...mechanics.rolling.body import Body, body_parameters
from ...mechanics.rolling.contact import contact
from ...mechanics.shapes.surfaces import Plane
from ..friction.symbols import gamma, omega, r, v

m, g = real_symbol("m"), real_symbol("g")
k, slip = Vector("k"), Vector("slip")
SOURCE = "§11.3"


def _function_vector(name: str) -> MatrixExpr:
    """A vector of three unspecified functions of v, ω and γ."""
    arguments = (*v.symbols, *omega.symbols, *gamma.symbols)
    return constant([sp.Function(f"{name}_{i}")(*arguments) for i in (1, 2, 3)])


#: Unspecified force and couple of a support, body axes.
ANY_FORCE, ANY_COUPLE = _function_vector("R_c"), _function_vector("K_c")


@arguments_checked
def free_contact(
    body: Body,
    gravity: float = 9.81,
    force: MatrixExpr = ANY_FORCE,
    couple: MatrixExpr = zero,
) -> System:
    """The equations of a body under an arbitrary force, and possibly a couple, at its contact.

    Parameters
    ----------
    body : Body
        Of any shape that has a support function.
    gravity : float
        Acceleration of gravity (m/s²), along −γ.
    force, couple : MatrixExpr
        Force of the support (N) and its couple (N m), body axes; by default any force and no
        couple.  `ANY_COUPLE` stands for any couple.

    Returns
    -------
    System
        State: velocity `v` of the centre of mass (m/s), `omega` (rad/s) and `gamma`, body axes.
        It is for proofs; while the force is unspecified, it cannot be integrated.

    Raises
    ------
    InputError
        If the shape is an implicit one.

    Examples
    --------
    >>> import lawproof
    >>> import nonholonomic
    >>> from nonholonomic.contact.invariants.free_contact import free_contact, jellett
    >>> top = nonholonomic.Body(1.0, (0.4, 0.4, 0.3), nonholonomic.Ball(1.0, centre=(0, 0, 0.2)))
    >>> lawproof.prove(free_contact(top), jellett(top)).decision
    'proven'
    """
    body.shape.gauss()  # refuses a shape without formulas for its point of contact
    inertia = _inertia(body)
    kinematics = contact(body.shape, Plane())
    names = {name for name, _ in kinematics.definitions}
    place = () if r in names else ((r, kinematics.r),)
    rotors = k if any(body.gyrostat) else zero
    torque = cross(inertia * omega + rotors, omega) + cross(r, force) + couple
    return System(
        name="free-contact",
        title="Body under any force at its point of contact",
        field={
            v: force / m - g * gamma - cross(omega, v),
            omega: inertia**-1 * torque,
            gamma: kinematics.gammadot,
        },
        definitions=(*kinematics.definitions, *place, (slip, v + cross(omega, r))),
        parameters=(
            *body_parameters(body, inertia),
            *kinematics.parameters,
            Parameter(g, "acceleration of gravity", gravity, "m/s^2", (g >= 0,)),
        ),
        relations=kinematics.relations,
        guards=kinematics.guards,
        source=SOURCE,
        summary="A body that a support acts on at the point of contact, in a way not specified.",
    )


def _inertia(body: Body) -> Diagonal | Symmetric:
    return Diagonal("I") if body.principal else Symmetric("I")


def power(body: Body, force: MatrixExpr = ANY_FORCE, couple: MatrixExpr = ANY_COUPLE) -> Identity:
    """The rate of the energy: (R, u) + (K, ω), with the velocity u of the touching particle.

    Parameters
    ----------
    body : Body
    force, couple : MatrixExpr
        As in :func:`free_contact`.

    Returns
    -------
    Identity
        Of the system with the same force and couple; the rate of the height of the centre of mass
        is (γ, v).

    Examples
    --------
    >>> import lawproof
    >>> import nonholonomic
    >>> from nonholonomic.contact.invariants.free_contact import ANY_COUPLE, free_contact, power
    >>> disk = nonholonomic.Body(1.0, (0.25, 0.25, 0.5), nonholonomic.Disk(1.0))
    >>> lawproof.prove(free_contact(disk, couple=ANY_COUPLE), power(disk)).decision
    'proven'
    """
    half = sp.Rational(1, 2)
    kinetic = half * (m * norm_squared(v) + dot(_inertia(body) * omega, omega))
    lost = dot(force, slip) + dot(couple, omega)
    return Identity(
        "power",
        Rate(kinetic) + m * g * dot(gamma, v) - lost,
        "the energy changes by the power of force and couple at the contact",
        source="§11.1",
    )


def jellett_value(body: Body) -> sp.Expr:
    """Jellett's function −(Iω + k, r), for a sphere (Iω + k, Rγ − c) (kg m³/s)."""
    rotors = k if any(body.gyrostat) else zero
    return -dot(_inertia(body) * omega + rotors, r)


def symmetry_conditions(body: Body) -> tuple[sp.Expr, ...]:
    """The conditions for a body of revolution about its third axis, with its rotors.

    Raises
    ------
    InputError
        If the inertia tensor is not given by principal moments.
    """
    inertia = _inertia(body)
    if not isinstance(inertia, Diagonal):
        raise InputError("inertia: Jellett's integral needs principal axes as body axes")
    first, second, _ = inertia.symbols
    centre = (
        [real_symbol(f"c_{i}") for i in (1, 2)] if any(getattr(body.shape, "centre", ())) else []
    )
    rotors = list(k.symbols[:2]) if any(body.gyrostat) else []
    return (first - second, *centre, *rotors)


def jellett(body: Body) -> Integral:
    """Jellett's integral of a body of revolution that touches a plane with a sphere.

    Parameters
    ----------
    body : Body
        A ball, its centre anywhere; the integral holds where I₁ = I₂ and the centre and the
        rotors lie along the third axis.

    Returns
    -------
    Integral
        It is conserved under every force at the contact; for couples see `couple_on_jellett`.

    Raises
    ------
    InputError
        If the shape is not a ball, or the inertia tensor is not diagonal.
    """
    if not body.shape.is_ball:
        raise InputError("shape: Jellett's integral is that of a body with a spherical surface")
    return Integral(
        "jellett",
        jellett_value(body),
        "Jellett's integral",
        unit="kg m^3/s",
        level=symmetry_conditions(body),
        source=SOURCE,
    )


def couple_on_jellett(body: Body, couple: MatrixExpr = ANY_COUPLE) -> Identity:
    """The rate of Jellett's integral under a couple K: −(K, r).

    Parameters
    ----------
    body : Body
        As in :func:`jellett`.
    couple : MatrixExpr
        As in :func:`free_contact`.
    """
    return Identity(
        "couple_on_jellett",
        Rate(jellett_value(body)) + dot(couple, r),
        "a couple K changes Jellett's integral at the rate −(K, r)",
        level=symmetry_conditions(body),
        source=SOURCE,
    )
