"""Contact of a body of arbitrary support function with a plane or a sphere, for proofs (§1.3)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Integral
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    constant,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
)

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import ContactModel, RollingBody
from ...mechanics.shapes.shapes import Ellipsoid
from ...mechanics.shapes.surfaces import Sphere
from ..catalogue_entry import Entry, Numbers, entry_with

omega, gamma, r, rdot, gammadot = vectors("omega gamma r rdot gammadot")
M, dh, torque, c = vectors("M dh torque c")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
H = Symmetric("H")
m, h, tau, area = (real_symbol(name) for name in ("m", "h", "tau", "A_a"))

#: A support function and a potential, both arbitrary.
SUPPORT = sp.Function("h_s")(*gamma.symbols)
POTENTIAL = sp.Function("U")(*gamma.symbols)

#: Support function, its derivatives, and the contact point r = c − hγ − (∂h − (γ, ∂h)γ).
SHAPE: Pairs = (
    (h, SUPPORT),
    (dh, gradient(SUPPORT, gamma, "h")),
    (H, constant(sp.hessian(SUPPORT, gamma.symbols))),
    (r, c + (dot(gamma, dh) - h) * gamma - dh),
)

#: J = I + m r² and its inverse.
INERTIA: Pairs = ((J, I + m * norm_squared(r) * identity), (A, J**-1))

#: The multiple of the identity in W.
LIFT = h - dot(gamma, dh)
#: Sum and product of the principal radii of curvature.
TRACE = sp.Add(*(H.entries[i, i] for i in range(3))) - dot(gamma, H * gamma) + 2 * LIFT
DETERMINANT = (
    dot(gamma, constant(H.entries.adjugate()) * gamma) + LIFT * (TRACE - 2 * LIFT) + LIFT**2
)


def spread(vector: MatrixExpr) -> MatrixExpr:
    """W u for a tangent vector u, with W = P∂²hP + (h − (γ, ∂h))E and P = E − γ⊗γ."""
    turned = H * vector
    return turned - dot(gamma, turned) * gamma + LIFT * vector


@dataclass(frozen=True)
class ContactKinematics:
    """The contact of a body of any shape.

    Attributes
    ----------
    parameters : tuple of Parameter
        Of body and surface.
    definitions : pairs
        Rate ṙ and couple of the potential; they use ω.
    gammadot : MatrixExpr
        Rate of the normal, body axes.
    where : str
        ``"plane"`` or ``"sphere"``.
    """

    parameters: tuple[Parameter, ...]
    definitions: Pairs
    gammadot: MatrixExpr
    where: str


def contact_kinematics(curvature: sp.Expr = sp.S.Zero) -> ContactKinematics:
    """The contact with a surface of the given curvature 1/a, zero for a plane.

    h is the distance of a point c of the body from the tangent plane with inner normal γ; only
    its values on the unit sphere matter.  Then ṙ = −Wγ̇ and γ̇ = (E + W/a)⁻¹γ×ω, so that the
    couple γ×(E + W/a)⁻¹∂U/∂γ does the work of U.

    Parameters
    ----------
    curvature : sympy.Expr
        Its symbols become parameters.
    """
    swing, force = cross(gamma, omega), gradient(POTENTIAL, gamma)
    if curvature == 0:
        plain = ((rdot, -spread(swing)), (torque, cross(gamma, force)))
        return ContactKinematics(_parameters(), plain, swing, "plane")

    def solve(vector: MatrixExpr) -> MatrixExpr:
        """(E + W/a)⁻¹ u on the tangent plane, by Cayley and Hamilton."""
        return ((1 + curvature * tau) * vector - curvature * spread(vector)) / area

    definitions = (
        (tau, TRACE),
        (area, 1 + curvature * tau + curvature**2 * DETERMINANT),
        (gammadot, solve(swing)),
        (rdot, -spread(gammadot)),
        (torque, cross(gamma, solve(force - dot(gamma, force) * gamma))),
    )
    meaning = "radius of the supporting sphere, negative inside, or its reciprocal"
    surface = (Parameter(s, meaning, 5.0) for s in sorted(curvature.free_symbols, key=str))
    return ContactKinematics((*_parameters(), *surface), definitions, gammadot, "sphere")


def _parameters() -> tuple[Parameter, ...]:
    return (
        Parameter(m, "mass", 1.0, "kg"),
        *(
            Parameter(s, f"a point of the body, body axis {i}", i / 8, "m")
            for i, s in enumerate(c.symbols, 1)
        ),
        *(
            Parameter(s, f"moment of inertia about body axis {i}", 1.0 + i / 4, "kg m^2")
            for i, s in enumerate(I.symbols, 1)
        ),
    )


def momentum(spin: MatrixExpr) -> MatrixExpr:
    """Ĩu, the momentum about the contact point."""
    return I * spin + m * cross(r, cross(spin, r))


def inverse(vector: MatrixExpr) -> MatrixExpr:
    """Ĩ⁻¹u, by Sherman and Morrison from J = I + m r²."""
    lever = A * r
    return A * vector + (m * dot(lever, vector) / (1 - m * dot(r, lever))) * lever


def energy() -> Integral:
    """½(M, ω) + U."""
    value = sp.Rational(1, 2) * dot(M, omega) + POTENTIAL
    return Integral("energy", value, "energy", source="(3.3), Theorem 1", unit="J")


def kinematics(curvature: sp.Expr) -> Identity:
    """γ̇ + ω×γ = ṙ/a."""
    return Identity(
        "kinematics",
        gammadot + cross(omega, gamma) - curvature * rdot,
        "the contact wanders over the body as fast as over the sphere",
        source="(1.23)",
    )


# --- an example that can be run ------------------------------------------------------------


def on_sphere(contact: ContactModel, general: Callable[[], System]) -> Entry:
    """The entry of a body of any shape on a sphere, run as an ellipsoid.

    Parameters
    ----------
    contact : str
        ``"marble"`` or ``"rubber"``.
    general : callable
        The system with any shape and potential.
    """

    def build(p: Numbers) -> RollingBody:
        shape = Ellipsoid((p["b_1"], p["b_2"], p["b_3"]), centre=(p["c_1"], p["c_2"], p["c_3"]))
        body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), shape)
        # a negative radius stands for the inside of the sphere
        return RollingBody(body, Sphere.of_signed_radius(p["a"]), contact)

    return entry_with(f"{contact}-body-on-sphere", build=build, general=general)
