"""A heavy body of revolution with rubber contact on a plane (§5)."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism, with_any_parameters
from flowlanes.system.laws import Integral, Law, Measure, Rate, Reduction, Symmetry
from flowlanes.system.system import System
from flowlanes.system.vectors import dot, norm_squared, real_symbol, vectors

from ...mechanics.rolling.body import AnyBody, Body
from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.revolution import ShapeOfRevolution
from ...mechanics.shapes.surfaces import Plane
from ..catalogue_entry import laws_for
from .rubber_profile import HEIGHT, POTENTIAL, from_support, profile_system

M, omega, gamma, r, c = vectors("M omega gamma r c")
m, R, I_1, I_2, I_3 = (real_symbol(name) for name in ("m", "R", "I_1", "I_2", "I_3"))
#: γ₃ and the constants of the motion in the reduction to quadratures.
u, K, h = (real_symbol(name) for name in ("u", "K", "h"))

HALF = sp.Rational(1, 2)
g_1, g_2, g_3 = gamma.symbols
w_1, w_2, w_3 = omega.symbols


def _conditions(body: AnyBody) -> tuple[sp.Expr, ...] | None:
    """Vanish where shape and inertia are of revolution about body axis 3; None if they are not."""
    symmetry = body.shape.axial_symmetry
    if symmetry is None or not body.principal or any(body.shape.centre[:2]):
        return None
    numbers = {p.symbol: p.default for p in body.shape.parameters}
    if body.inertia[0] != body.inertia[1] or any(
        condition.xreplace(numbers) != 0 for condition in symmetry.conditions
    ):
        return None
    return symmetry.conditions


@laws_for("rubber", Plane())
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """(5.1) and (5.2), for every profile and every potential U(γ₃); symmetry and measure."""
    body = rolling.body
    # only a potential of γ₃ alone has no couple about the axis
    depends = rolling.field.potential.free_symbols & {g_1, g_2}
    conditions = _conditions(body)
    if depends or any(body.gyrostat) or conditions is None:
        return ()
    level: tuple[sp.Expr, ...] = (I_1 - I_2,)
    if any(body.shape.centre):
        level += tuple(c.symbols[:2])
    level += conditions
    reach, height = r + 0 * gamma, dot(r, gamma)
    if body.shape.is_ball:
        reach = body.shape.offset - R * gamma
        height = dot(body.shape.offset, gamma) - R
    known: tuple[Law, ...] = (
        spin(height, level),
        quadratures(system, reach, height, level),
    )
    if body.shape.is_ball or body.shape.edge_radius is not None:
        # for other shapes these are proven once for all, in `general`: one by one it takes minutes
        known += (rotation(level), measure(reach, height, level))
    return known


# --- laws ----------------------------------------------------------------------------------


def _square(height: sp.Expr) -> sp.Expr:
    """A² of (5.1), for (r, γ) = `height`."""
    return I_1 * g_3**2 + I_3 * (1 - g_3**2) + m * height**2


def spin(height: sp.Expr, level: tuple[sp.Expr, ...]) -> Integral:
    """(5.1); `level` vanishes when the body is one of revolution."""
    return Integral(
        "spin",
        sp.sqrt(_square(height)) * w_3,
        "integral linear in ω",
        level=level,
        source="(5.1)",
        unit="kg^0.5 m/s",
    )


def quadratures(
    system: System, reach: MatrixExpr, height: sp.Expr, level: tuple[sp.Expr, ...]
) -> Reduction:
    """(5.2), with γ₃ = cos θ and the angle φ from γ₁ : γ₂.

    Parameters
    ----------
    system : System
        State ω, γ, with the energy among its laws.
    reach, height : formulas
        r and (r, γ).
    level : tuple of sympy.Expr
        Vanish when the body is one of revolution.
    """
    (energy,) = (law.value for law in system.integrals if law.name == "energy")
    potential = energy - HALF * dot(M, omega)
    factor, principal = sp.sqrt(_square(height)), I_1 + m * norm_squared(reach)
    return Reduction(
        "quadratures",
        {u: g_3, K: factor * w_3, h: energy},
        (
            Rate(K),
            Rate(h),
            HALF * (principal * Rate(u) ** 2 + K**2) - (h - potential) * (1 - u**2),
            g_2 * Rate(g_1) - g_1 * Rate(g_2) - K / factor,
        ),
        "quadratures for γ₃ = cos θ and φ",
        level=level,
        source="(5.2)",
    )


def rotation(level: tuple[sp.Expr, ...] = ()) -> Symmetry:
    """The rotation of ω and γ about the axis."""
    return Symmetry(
        "rotation",
        {w_1: -w_2, w_2: w_1, g_1: -g_2, g_2: g_1},
        "rotation about the axis of symmetry",
        level=level,
        source="§5, before (5.1)",
    )


def measure(reach: MatrixExpr, height: sp.Expr, level: tuple[sp.Expr, ...] = ()) -> Measure:
    """ρ = BA, for the contact vector `reach` and (r, γ) = `height`."""
    return Measure(
        "measure",
        {I_1 + m * norm_squared(reach): sp.S.One, _square(height): HALF},
        "invariant measure ρ d³ω d³γ, ρ = BA",
        level=level,
        source="§5, after (5.2)",
    )


# --- every profile -------------------------------------------------------------------------


def general_system(potential: sp.Expr = POTENTIAL) -> System:
    """Any profile, in any potential U(γ₃) such as its weight, with all laws of §5."""
    return _with_all_laws(from_support(HEIGHT), potential)


def _with_all_laws(chi: tuple[sp.Expr, sp.Expr], potential: sp.Expr = POTENTIAL) -> System:
    system = profile_system(chi, potential)
    reach, height = r + 0 * gamma, dot(r, gamma)
    return system.with_laws(
        spin(height, ()),
        rotation(),
        measure(reach, height),
        quadratures(system, reach, height, ()),
    )


def rolling_equations(gravity: float = 0.0) -> System:
    """The body from the equations of any rolling body, with I_2 as a symbol."""
    body = Body(1.0, (0.3, 0.3, 0.2), ShapeOfRevolution(1 + g_3**2 / 4))
    field = Forces(gravity, POTENTIAL)
    system = RollingBody(body, contact="rubber", field=field).system("rubber-body-of-revolution")
    profile = {
        real_symbol("p"): HEIGHT,
        real_symbol("pprime"): HEIGHT.diff(g_3),
        real_symbol("pprime2"): HEIGHT.diff(g_3, 2),
    }
    return replace(
        system,
        definitions=tuple((name, profile.get(name, value)) for name, value in system.definitions),
    )


def onto_rolled() -> Isomorphism:
    """An isomorphism onto the equations of any rubber body: those of §5 are a special case."""
    return Isomorphism(
        "rolling",
        with_any_parameters(rolling_equations()),
        {omega: omega, gamma: gamma},
        constants={I_2: I_1},
        meaning="the equations of any rubber body on a plane",
        source="(1.18)",
    )


def general() -> System:
    """Any profile, with the proof that its equations are the general ones."""
    return general_system().with_laws(onto_rolled())


# --- catalogue -----------------------------------------------------------------------------
