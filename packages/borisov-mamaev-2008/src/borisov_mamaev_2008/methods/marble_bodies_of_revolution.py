"""Marble bodies of revolution: general ones, and those with an elementary integral linear in ω.

Let p(γ₃) be the height of the centre of mass above the plane, ρ₁ and ρ₂ the radii of curvature
along and across the meridian, and ξ² = r₁² + r₂². Suppose that the profile satisfies

    I₃ γ₃ r₃ ρ₁ + (I₃ + mξ²) p ρ₂ = 0.

This is a second-order equation for p. Around a pole its solutions are smooth convex caps, two of
which form a lens; M₃/√(I₃ + mξ²) is then constant in any potential U(γ₃).
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol, vectors
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution

M, omega, gamma, r = vectors("M omega gamma r")
m, I_1, I_2, I_3 = (real_symbol(s) for s in ("m", "I_1", "I_2", "I_3"))
#: The names of the support function and its derivatives in the mechanics package.
height, slope, bend = real_symbol("p"), real_symbol("pprime"), real_symbol("pprime2")
g_1, g_2, g_3 = gamma.symbols
LEAN = 1 - g_3**2
POTENTIAL = sp.Function("U")(g_3)


def any_body() -> System:
    """A marble body of revolution with any profile p(γ₃), in gravity and any potential U(γ₃)."""
    profile = sp.Function("p_s")(g_3)
    values = {name: sp.diff(profile, g_3, n) for n, name in enumerate((height, slope, bend))}
    system = _with_some_profile(POTENTIAL)
    return replace(
        system,
        name="marble-body-of-revolution",
        title="Marble body of revolution",
        definitions=tuple(
            (name, values.get(name, formula) if isinstance(name, sp.Symbol) else formula)
            for name, formula in system.definitions
        ),
    )


def _with_some_profile(potential: sp.Expr) -> System:
    """A body of revolution with a placeholder profile."""
    some = ShapeOfRevolution(1 + g_3**2 / 4)
    system = rolling_system(Body(1.0, (0.3, 0.3, 0.2), some), field=Forces(9.81, potential))
    return replace(system, guards=(), observables=(), reconstruction=None, laws=())


def curvatures() -> tuple[sp.Expr, sp.Expr]:
    """ρ₁ and ρ₂ of a lens in terms of γ₃, p and p′."""
    across = height - g_3 * slope
    r_3 = -(g_3 * height + LEAN * slope)
    along = -(I_3 + m * LEAN * across**2) * height * across / (I_3 * g_3 * r_3)
    return along, across


def lens(potential: sp.Expr = POTENTIAL) -> System:
    """A lens with marble contact, in gravity and a potential U(γ₃), by default unspecified.

    The state is M, γ, and p, p′ at the contact, whose rates follow from the equation of the
    profile.
    """
    system = _with_some_profile(potential)
    along, across = curvatures()
    nod = g_1 * omega.symbols[1] - g_2 * omega.symbols[0]
    definitions = tuple(item for item in system.definitions if item[0] not in (height, slope, bend))
    return replace(
        system,
        name="marble-lens",
        title="Marble lens",
        field=(*system.field, (height, slope * nod), (slope, bend * nod)),
        definitions=((bend, (along - across) / LEAN), *definitions),
    )


def linear_integral() -> Integral:
    """The integral M₃/√(I₃ + m(r₁² + r₂²))."""
    reach = r.symbols[0] ** 2 + r.symbols[1] ** 2
    value = M.symbols[2] / sp.sqrt(I_3 + m * reach)
    return Integral("linear", value, "integral linear in ω", level=(I_1 - I_2,))
