"""§3.2: invariant measure."""

from __future__ import annotations

import sympy as sp

from ...catalogue import CATALOGUE
from ...catalogue.fixed_point import suslov
from ...core.laws import Identity, Measure, Rate
from ...core.vectors import Diagonal, Vector, dot, real_symbol
from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces, roll
from ...mechanics.shapes.shapes import Ellipsoid
from ...parsing.exact_decimals import exact_number
from ...proof.verdict import Verdict
from ..claim import Case, Claim, Remark
from ..methods.unspecified_systems import fields, system, unspecified_functions
from ..obstructions.divergence_at_equilibria import excludes_measure

x = sp.symbols("x_1:4", real=True)
y = sp.symbols("y_1:4(1:4)", real=True)
gamma, M, r = Vector("gamma"), Vector("M"), Vector("r")
I = Diagonal("I")


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
    return dynamics, next(law for law in dynamics.laws if isinstance(law, Measure))


def body_of_revolution() -> Case:
    """A spheroid in any potential U(γ₃): ρ = (I₁I₃ + m(r, Ir))^(−1/2) in the variables M, γ."""
    potential = sp.Function("U")(gamma.symbols[2])
    body = Body(1.0, (1.0, 1.0, 1.5), Ellipsoid((1.0, 1.0, 2.0)))
    dynamics = roll(body, field=Forces(potential=potential))
    I_1, I_2, I_3 = I.symbols
    b_1, b_2, b_3 = sp.symbols("b_1:4", real=True)
    m = real_symbol("m")
    numbers = (m - 1, I_2 - I_1, b_1 - 1, b_2 - 1, b_3 - 2)
    density = I_1 * I_3 + m * dot(r, I * r)
    return dynamics, Measure("measure", {density: -sp.Rational(1, 2)}, on=numbers)


def celtic_stone() -> Verdict:
    """An ellipsoid whose axes are not its principal axes of inertia spins about the vertical."""
    inertia = ((1.0, 0.25, 0.0), (0.25, 1.5, 0.0), (0.0, 0.0, 2.0))
    dynamics = roll(Body(1.0, inertia, Ellipsoid((1.0, 0.75, 0.5))), field=Forces(10.0))
    point = {p.symbol: exact_number(p.default) for p in dynamics.parameters}
    upright = dict(zip((*M, *gamma), map(sp.Integer, (0, 0, 2, 0, 0, 1)), strict=True))
    return excludes_measure(dynamics, {**point, **upright})


def suslov_skew() -> Verdict:
    """Rotation about ω ∥ (I_23, −I_13, 0), which is also the vertical."""
    dynamics = CATALOGUE["suslov"].system(
        {"I_1": 5.0, "I_2": 6.0, "I_3": 7.0, "I_13": 1.5, "I_23": 2}
    )
    point = {p.symbol: exact_number(p.default) for p in dynamics.parameters}
    axis = (sp.Rational(4, 5), -sp.Rational(3, 5), sp.S.Zero)
    equilibrium = dict(zip((*suslov.omega, *suslov.gamma), (*axis, *axis), strict=True))
    return excludes_measure(dynamics, {**point, **equilibrium})


CLAIMS = (
    Claim(
        "(3.4)",
        r"If $\operatorname{div}(\rho(\mathbf{x})\mathbf{v}(\mathbf{x})) = 0$, then "
        r"$\int_{\Gamma_t}\rho(\mathbf{x})\,d^n\mathbf{x} = \text{const}$ for any domain "
        r"$\Gamma_t$ carried by the flow",
        volume,
        note="for three dimensions and any v and ρ",
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
        note="for spheroids of one shape, with any moments of inertia I₁ = I₂ and I₃, in any "
        "potential U(γ₃)",
    ),
    Claim(
        "§3.2, Celtic stones",
        "There are systems without an invariant measure: Celtic stones",
        celtic_stone,
        note="for one ellipsoid; meant is a measure with positive smooth density",
    ),
    Claim(
        "§3.2, Suslov's problem",
        "There are systems without an invariant measure: Suslov's problem",
        suslov_skew,
        note="when the axis is not a principal axis; otherwise, as in the problem behind (3.8), "
        "the volume is preserved in every potential",
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
