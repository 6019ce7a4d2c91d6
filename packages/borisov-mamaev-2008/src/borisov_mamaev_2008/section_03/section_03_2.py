"""§3.2: invariant measure."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Measure, Rate
from flowlanes.system.system import Parameter
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.mechanics.lagrangian.mechanism import Frame, Mechanism, rotations
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.shapes.shapes import Ellipsoid

from ..claim import Case, Claim, Remark
from ..methods.marble_bodies_of_revolution import any_body
from ..methods.measure_theorems import has_no_measure
from ..methods.unspecified_systems import fields, system, unspecified_functions

x = sp.symbols("x_1:4", real=True)
y = sp.symbols("y_1:4(1:4)", real=True)
omega, gamma, r = vectors("omega gamma r")
I, tensor = Diagonal("I"), Symmetric("I")


def volume() -> Case:
    """With ẏ = (∂v/∂x) y for the matrix y of displacements, (ρ det y)˙ = div(ρv) det y.

    The volume of Γ_t is the integral of ρ det y over Γ_0, for any v and ρ.
    """
    v, (rho,) = fields("v1 v2 v3", x), unspecified_functions("rho", *x)
    matrix = sp.Matrix(3, 3, y)
    moved = sp.Matrix(3, 3, lambda i, j: sp.diff(v[x[i]], x[j])) * matrix
    flow = system("flow", "ẋ = v(x) with displacements", {**v, **dict(zip(y, moved, strict=True))})
    spread = sp.Add(*(sp.diff(rho * v[s], s) for s in x))
    return flow, Identity("volume", Rate(rho * matrix.det()) - spread * matrix.det())


def chaplygin_ball() -> Case:
    """The measure of (7.3)."""
    dynamics = CATALOGUE["chaplygin-ball"].system()
    return dynamics, dynamics.laws_of(Measure)[0]


def body_of_revolution() -> Case:
    """Any profile in any potential U(γ₃): ρ = (I₁I₃ + m(r, Ir))^(−1/2) in the variables M, γ."""
    I_1, I_2, I_3 = I.symbols
    density = I_1 * I_3 + real_symbol("m") * dot(r, I * r)
    return any_body(), Measure("measure", {density: -sp.Rational(1, 2)}, level=(I_1 - I_2,))


def celtic_stone() -> Verdict:
    """An ellipsoid whose axes are not its principal axes of inertia."""
    inertia = ((1.0, 0.25, 0.0), (0.25, 1.5, 0.0), (0.0, 0.0, 2.0))
    return has_no_measure(
        RollingBody(Body(1.0, inertia, Ellipsoid((1.0, 0.75, 0.5)))), "celtic stone"
    )


def suslov_skew() -> Verdict:
    """For ω₃ = 0 and any tensor of inertia, a measure requires I_13 = I_23 = 0."""
    turning = cross(gamma, omega)
    frame = Frame(
        {gamma: turning}, (omega,), (norm_squared(gamma) - 1,), structure=rotations(omega)
    )
    numbers = zip(tensor.symbols, (2.0, 0.1, 0.2, 2.5, 0.3, 3.0), strict=True)
    mechanism = Mechanism(
        "suslov",
        frame,
        dot(omega, tensor * omega) / 2,
        (dot(omega, unit_vector(3)),),
        parameters=tuple(Parameter(s, "entry of the tensor of inertia", v) for s, v in numbers),
    )
    return has_no_measure(mechanism, "Suslov's problem")


CLAIMS = (
    Claim(
        "(3.4)",
        r"If $\operatorname{div}(\rho(\mathbf{x})\mathbf{v}(\mathbf{x})) = 0$, then "
        r"$\int_{\Gamma_t}\rho(\mathbf{x})\,d^n\mathbf{x} = \text{const}$ for any domain "
        r"$\Gamma_t$ carried by the flow",
        volume,
        note="for any v and ρ",
        argument="for any number of variables the matrix y of displacements has ẏ = (∂v/∂x) y, and "
        "Jacobi's formula (det y)˙ = det y tr(∂v/∂x); computed is n = 3",
    ),
    Claim(
        "§3.2, Chaplygin ball",
        "There are systems with an invariant measure: a Chaplygin ball",
        chaplygin_ball,
    ),
    Claim(
        "§3.2, body of revolution",
        "There are systems with an invariant measure: a body of revolution on a plane",
        body_of_revolution,
        note="for every profile and centre of mass on the axis, with any moments of inertia "
        "I₁ = I₂ and I₃, in any potential U(γ₃)",
    ),
    Claim(
        "§3.2, Celtic stones",
        "There are systems without an invariant measure: Celtic stones",
        celtic_stone,
        note="meant is a measure with a density that is smooth and positive up to rest",
        argument="nonholonomic/docs/measures.md, result 6; computed is one ellipsoid",
        where=(
            "the normal at a contact passes through the centre of mass, and the directions of "
            "curvature there differ from those of the inertia",
        ),
    ),
    Claim(
        "§3.2, Suslov's problem",
        "There are systems without an invariant measure: Suslov's problem",
        suslov_skew,
        note="otherwise, as in the problem behind (3.8), the volume is preserved in every "
        "potential",
        where=("the axis without rotation is not a principal axis of inertia",),
    ),
)

REMARKS = (
    Remark(
        "§3.2, obstructions",
        "Obstructions to the existence of an invariant measure are discussed in [24], the effects "
        "of its absence in [26]",
        "literature",
    ),
)
