"""A rubber body of any convex shape on a plane and on a sphere (§1.3, §1.4)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from ..mechanics.body import Body
from ..mechanics.rolling import Field, Rolling
from ..mechanics.shapes import Ellipsoid
from ..mechanics.surfaces import Sphere
from ..statements import Identity, Integral, Rate
from ..system import Parameter, System
from ..vectors import (
    Diagonal,
    Symmetric,
    constant,
    cross,
    dot,
    gradient,
    normed,
    scalar,
    vectors,
)
from .entry import Entry, Numbers, Start
from .rates import rate as rate_of

omega, gamma, r, rdot, gammadot = vectors("omega gamma r rdot gammadot")
M, X, q, dh, torque, c = vectors("M X q dh torque c")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
H = Symmetric("H")
m, a, h, lambda_0 = scalar("m"), scalar("a"), scalar("h"), scalar("lambda_0")

#: A support function and a potential, both arbitrary.
SUPPORT = sp.Function("h_s")(*gamma.symbols)
POTENTIAL = sp.Function("U")(*gamma.symbols)


@dataclass(frozen=True)
class Convex:
    """Contact of a convex body of arbitrary support function h(γ) about a point c of the body.

    h is the distance of c from the tangent plane with inner normal γ; only its values on the unit
    sphere matter.  The contact point is r = c − hγ − (∂h − (γ, ∂h)γ), and ṙ = −Wγ̇ with
    W = P∂²hP + (h − (γ, ∂h))E on the tangent plane, P = E − γ⊗γ.
    """

    definitions: tuple[tuple[Any, Any], ...] = (
        (h, SUPPORT),
        (dh, gradient(SUPPORT, gamma, "h")),
        (H, constant(sp.hessian(SUPPORT, gamma.symbols))),
        (r, c + (dot(gamma, dh) - h) * gamma - dh),
    )

    @property
    def lift(self) -> sp.Expr:
        """The multiple of the identity in W."""
        return h - dot(gamma, dh)

    def spread(self, vector: MatrixExpr) -> MatrixExpr:
        """W u for a tangent vector u."""
        turned = H * vector
        return turned - dot(gamma, turned) * gamma + self.lift * vector

    @property
    def trace(self) -> sp.Expr:
        """The sum of the principal radii of curvature."""
        total = sp.Add(*(H.entries[i, i] for i in range(3)))
        return total - dot(gamma, H * gamma) + 2 * self.lift

    @property
    def determinant(self) -> sp.Expr:
        """Their product."""
        minors = constant(H.entries.adjugate())
        bent = self.trace - 2 * self.lift
        return dot(gamma, minors * gamma) + self.lift * bent + self.lift**2


def any_rubber_body(curvature: sp.Expr = sp.S.Zero) -> System:
    """A rubber body of arbitrary support function h and potential U on a plane or a sphere.

    Parameters
    ----------
    curvature : sympy.Expr
        1/a of the supporting sphere in a symbol, which becomes a parameter; zero for a plane.

    Returns
    -------
    System
        State ω, γ (body axes).  On a sphere the couple is γ×(E + W/a)⁻¹∂U/∂γ: what does the
        work of U when γ̇ = (E + W/a)⁻¹γ×ω.
    """
    shape = Convex()
    swing, force = cross(gamma, omega), gradient(POTENTIAL, gamma)
    definitions = [*shape.definitions]
    rate, couple = swing, cross(gamma, force)
    parameters = tuple(
        Parameter(s, meaning, value, unit)
        for s, meaning, value, unit in (
            (m, "mass", 1.0, "kg"),
            *(
                (s, f"a point of the body, body axis {i}", i / 8, "m")
                for i, s in enumerate(c.symbols, 1)
            ),
            *(
                (s, f"moment of inertia about body axis {i}", 1.0 + i / 4, "kg m^2")
                for i, s in enumerate(I.symbols, 1)
            ),
        )
    )
    if curvature != 0:
        tau, area = scalar("tau"), scalar("A_a")
        definitions += [
            (tau, shape.trace),
            (area, 1 + curvature * tau + curvature**2 * shape.determinant),
        ]

        def solve(vector: MatrixExpr) -> MatrixExpr:
            """(E + W/a)⁻¹ u on the tangent plane, by Cayley and Hamilton."""
            inner = (1 + curvature * tau) * vector - curvature * shape.spread(vector)
            return inner / area

        tangent = force - dot(gamma, force) * gamma
        definitions.append((gammadot, solve(swing)))
        rate, couple = gammadot, cross(gamma, solve(tangent))
        parameters += tuple(
            Parameter(s, "radius of the supporting sphere or its reciprocal", 5.0, "")
            for s in sorted(curvature.free_symbols, key=str)
        )
    lever = A * r

    def inverse(vector: MatrixExpr) -> MatrixExpr:
        """Ĩ⁻¹u, by Sherman and Morrison from J = I + m r²."""
        return A * vector + (m * dot(lever, vector) / (1 - m * dot(r, lever))) * lever

    definitions += [
        (rdot, -shape.spread(rate)),
        (torque, couple),
        (J, I + m * normed(r) * constant(sp.eye(3))),
        (A, J**-1),
        (M, I * omega + m * cross(r, cross(omega, r))),
        (X, cross(M, omega) - m * cross(r, cross(omega, rdot)) + torque),
        (q, inverse(gamma)),
        (lambda_0, -(dot(q, X) + dot(omega, rate)) / dot(q, gamma)),
    ]
    where = "plane" if curvature == 0 else "sphere"
    return System(
        name=f"any-rubber-body-on-{where}",
        title=f"Rubber body of any shape on a {where}",
        field={omega: inverse(X) + lambda_0 * q, gamma: rate},
        definitions=tuple(definitions),
        parameters=parameters,
        relations=(normed(gamma) - 1, dot(omega, gamma)),
        source="(1.18), (1.19)" if curvature == 0 else "(1.23)",
    )


def _energy() -> Integral:
    value = sp.Rational(1, 2) * dot(M, omega) + POTENTIAL
    return Integral("energy", value, "energy", source="(3.3), Theorem 1")


def build(p: Numbers) -> Rolling:
    """A heavy ellipsoid with three different axes and its centre of mass away from its centre."""
    return Rolling(_body(p), contact="rubber", field=Field(p["g"]))


def build_on_sphere(p: Numbers) -> Rolling:
    """The same body on a sphere, without gravity."""
    return Rolling(_body(p), Sphere(p["a"]), "rubber")


def _body(p: Numbers) -> Body:
    shape = Ellipsoid((p["b_1"], p["b_2"], p["b_3"]), centre=(p["c_1"], p["c_2"], p["c_3"]))
    return Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), shape)


def general() -> System:
    """Any shape and potential on a plane."""
    return any_rubber_body().with_laws(
        Identity(
            "couple",
            Rate(POTENTIAL) + dot(torque, omega),
            "the couple does the work of the potential",
            source="(1.17)",
        ),
        Identity(
            "contact",
            (rdot - rate_of(r), dot(gamma, rdot)),
            "rate of the contact point, which stays in the tangent plane",
            source="§1.3",
        ),
        _energy(),
    )


def general_on_sphere() -> System:
    """Any shape and potential on a sphere of radius a."""
    return any_rubber_body(1 / a).with_laws(
        Identity(
            "kinematics",
            gammadot + cross(omega, gamma) - rdot / a,
            "the contact wanders over the body as fast as over the sphere",
            source="(1.23)",
        ),
        _energy(),
    )


_START = Start(omega=(0.9, -0.5, -0.35483870967741937), gamma=(0.2, -0.3, 0.93), until=30.0)
_DEFAULTS = {
    "m": 1.0,
    "I_1": 1.0,
    "I_2": 1.5,
    "I_3": 2.1,
    "b_1": 1.0,
    "b_2": 0.9,
    "b_3": 0.8,
    "c_1": 0.1,
    "c_2": -0.05,
    "c_3": 0.1,
}

ENTRIES = (
    Entry(
        name="rubber-body",
        title="Rubber body on a plane",
        summary="A heavy body of any convex shape, here an ellipsoid, rolls on a horizontal plane "
        "with neither slipping nor spinning.",
        source="§1.3, (1.17)–(1.19)",
        defaults={**_DEFAULTS, "g": 9.81},
        build=build,
        start=_START,
        general=general,
    ),
    Entry(
        name="rubber-body-on-sphere",
        title="Rubber body on a sphere",
        summary="A body of any convex shape, here an ellipsoid, rolls with neither slipping nor "
        "spinning on a fixed sphere of radius a, outside (a > 0) or inside (a < 0).",
        source="§1.4, (1.23)",
        defaults={**_DEFAULTS, "a": 5.0},
        build=build_on_sphere,
        start=_START,
        general=general_on_sphere,
    ),
)
