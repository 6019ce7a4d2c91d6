"""The equations (8.1) of a ball on a sphere by themselves, for every ratio k.

All vectors in body axes: M is the momentum about the contact point, n the outward unit normal of
the supporting sphere at the contact, ω the angular velocity.  d = mR² for a ball of mass m and
radius R, J = I + d, and I_Q = J − d n⊗n takes ω to M.  With a the radius of the supporting
sphere (negative inside) k = a/(a + R) for a ball, and k = a/(a − R) for a hollow ball around it.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
)

M, n, omega, omegadot, ndot = vectors("M n omega omegadot ndot")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
d, k, rho_2 = real_symbol("d"), real_symbol("k"), real_symbol("rho_2")

_MOMENTS = (1.0, 1.5, 2.1)
_d = Parameter(d, "mass times the square of the ball's radius", 1.0, "kg m^2", (d >= 0,))
_k = Parameter(k, "ratio a/(a + R) of the radii", -1.0, "1")
_inertia = tuple(
    Parameter(s, f"moment of inertia about body axis {i}", value, "kg m^2", (s > 0,))
    for i, (s, value) in enumerate(zip(I.symbols, _MOMENTS, strict=True), 1)
)
_SOURCE = "§8.1, (8.1)"
_SUMMARY = "A balanced, dynamically asymmetric ball rolls without slipping on a fixed sphere."


def contact_inertia(vector: MatrixExpr) -> MatrixExpr:
    """I_Q u = J u − d n (n, u) for a vector u: from angular velocity to momentum."""
    return J * vector - d * dot(n, vector) * n


def _velocity(vector: MatrixExpr) -> MatrixExpr:
    """The inverse of I_Q applied to a vector, on |n| = 1."""
    return J**-1 * vector + (d / rho_2) * dot(n, J**-1 * vector) * J**-1 * n


_TENSORS = ((J, I + d * identity), (rho_2, 1 - d * dot(n, J**-1 * n)))


def equations_on_sphere() -> System:
    """(8.1) in M and n, for every k."""
    return System(
        name="ball-on-sphere-equations",
        title="Ball on a sphere, the equations alone",
        summary=_SUMMARY,
        source=_SOURCE,
        parameters=(*_inertia, _d, _k),
        definitions=(*_TENSORS, (omega, _velocity(M))),
        field={M: cross(M, omega), n: k * cross(n, omega)},
        relations=(norm_squared(n) - 1,),
        laws=(
            Integral("energy", sp.S.Half * dot(M, omega), "energy", source="(8.2)", unit="J"),
            Integral(
                "momentum",
                norm_squared(M),
                "square of the momentum",
                source="(8.2)",
                unit="kg^2 m^4/s^2",
            ),
            Integral(
                "linear",
                dot((sp.Add(*J.symbols) / 2 * identity - J) * M, n),
                "linear integral of the case k = −1",
                level=(k + 1,),
                source="(8.3)",
                unit="kg^2 m^4/s",
            ),
            Measure(
                "measure",
                {rho_2: -sp.S.Half},
                "invariant measure in M, n",
                source="§8.1, after (8.2)",
            ),
        ),
    )


def equations_in_omega() -> System:
    """(8.1) in ω and n, for every k."""
    return System(
        name="ball-on-sphere-velocities",
        title="Ball on a sphere, in the angular velocity",
        summary=_SUMMARY,
        source=_SOURCE,
        parameters=(*_inertia, _d, _k),
        definitions=(
            *_TENSORS,
            (M, contact_inertia(omega)),
            (ndot, k * cross(n, omega)),
            # the rate of I_Q is −d (ṅ⊗n + n⊗ṅ), and (ṅ, ω) = 0
            (omegadot, _velocity(cross(M, omega) + d * dot(n, omega) * ndot)),
        ),
        field={omega: omegadot, n: ndot},
        relations=(norm_squared(n) - 1,),
    )


def vanishing_area() -> System:
    """(8.1) for k = −1 on the level F₂ = (AM, n) = 0.

    The parameters are d and the tensor A = ½ tr J − J of the linear integral, J = tr A − A.
    """
    parameters = tuple(
        Parameter(s, f"tensor of the linear integral, body axis {i}", value, "kg m^2")
        for i, (s, value) in enumerate(zip(A.symbols, (1.8, 1.3, 0.7), strict=True), 1)
    )
    return System(
        name="ball-around-sphere-zero-area",
        title="Hollow ball around a sphere, k = −1, with zero area integral",
        summary="A hollow ball rolls without slipping around a fixed sphere of half its radius; "
        "its linear integral vanishes.",
        source="§8.2",
        parameters=(*parameters, _d),
        definitions=(
            (J, sp.Add(*A.symbols) * identity - A),
            (rho_2, 1 - d * dot(n, J**-1 * n)),
            (omega, _velocity(M)),
        ),
        field={M: cross(M, omega), n: cross(omega, n)},
        relations=(norm_squared(n) - 1, dot(A * M, n)),
    )
