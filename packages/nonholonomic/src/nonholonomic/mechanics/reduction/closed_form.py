"""Rational functions of tangents of half angles, converted to angles or a unit vector."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from flint import fmpq_mpoly

from flowlanes.system.vectors import Vector

from .factors import HalfAngleChart, has_even_degrees, in_angles, on_sphere
from .horizontal_lift import PointwiseForm
from .linear_algebra import inverse, product
from .rational_evaluation import Formulas
from .rational_functions import Quotient, quotients


@dataclass(frozen=True)
class ClosedFormParts:
    """The parts of (4.4) in closed form.

    Attributes
    ----------
    metric : tuple of Expr
        g₁₁, g₁₂, g₂₂ of E₂ = ½ g_ij q̇_i q̇_j.
    inverse : tuple of Expr
        h₁₁, h₁₂, h₂₂ of E₂ = ½ h_ij P_i P_j.
    a : tuple of Expr
        a₁, a₂ of S = a₁q̇₁ + a₂q̇₂ + b.
    b : Expr
    rest : Expr
        E₀ without the potential of the mechanism.
    lifted : tuple of (Expr, Expr, Expr)
        For every velocity u the coefficients of q̇₁ and q̇₂, and the remaining term.
    """

    metric: tuple[sp.Expr, sp.Expr, sp.Expr]
    inverse: tuple[sp.Expr, sp.Expr, sp.Expr]
    a: tuple[sp.Expr, sp.Expr]
    b: sp.Expr
    rest: sp.Expr
    lifted: tuple[tuple[sp.Expr, sp.Expr, sp.Expr], ...]


def closed_forms(
    local: PointwiseForm,
    chart: HalfAngleChart,
    parameters: Sequence[sp.Symbol],
    vector: Vector | None,
) -> ClosedFormParts:
    """All parts of (4.4), with parameters and constants as symbols."""
    lift, owner = local.lift, local.owner
    one, names = quotients([*chart.variables, *parameters, *lift.constants])
    place = {**names, **chart.point([names[t] for t in chart.variables])}
    values = local.at(place, one)
    u = lift.base.motion.velocities
    size = len(u)
    K = Formulas(list(lift.matrix), owner).at(place, one)
    known = Formulas(list(lift.right_side), owner).at(place, one)
    solve = inverse([K[i : i + size] for i in range(0, len(K), size)], one)
    y = product(solve, known)
    at_rest = {**place, **dict(zip(u, y, strict=True))}
    (potential,) = Formulas([local.integral.value], owner).at(at_rest, one)

    def plain(value: Quotient) -> sp.Expr:
        return in_unit_vector(value, chart, vector)

    (g11, g12), (_, g22) = values.metric
    (h11, h12), (_, h22) = inverse(values.metric, one)
    return ClosedFormParts(
        metric=(plain(g11), plain(g12), plain(g22)),
        inverse=(plain(h11), plain(h12), plain(h22)),
        a=(plain(values.a[0]), plain(values.a[1])),
        b=plain(values.b),
        rest=plain(potential),
        lifted=tuple(
            (plain(row[0]), plain(row[1]), plain(x)) for row, x in zip(solve, y, strict=True)
        ),
    )


def in_unit_vector(value: Quotient, chart: HalfAngleChart, vector: Vector | None) -> sp.Expr:
    """A fraction converted to angles, with factors in the unit vector if possible."""
    if value.above == 0:
        return sp.S.Zero
    circles = [0, 0]
    total = sp.S.One
    for poly, sign in ((value.above, 1), (value.below, -1)):
        content, parts = poly.factor()
        total *= sp.Rational(int(content.p), int(content.q)) ** sign
        odd: fmpq_mpoly | None = None
        for factor, power in parts:
            e = int(power)
            circle, sine = (_angle_of_form(factor, chart, form) for form in ("{}^2 + 1", "{}"))
            if circle is not None:
                circles[circle] += sign * e
            elif sine is not None:
                # t/(1 + t²)
                circles[sine] += sign * e
                total *= (sp.sin(chart.coordinates[sine]) / 2) ** (sign * e)
            elif has_even_degrees(factor, chart):
                total *= _power_of_factor(factor, chart, vector, circles, sign * e)
            else:
                odd = factor**e if odd is None else odd * factor**e
        if odd is not None:
            total *= _power_of_factor(odd, chart, None, circles, sign)
    # 1 + t² = 2/(1 + cos x)
    for x, power in zip(chart.coordinates, circles, strict=True):
        total *= (2 / (1 + sp.cos(x))) ** power
    return total


def _power_of_factor(
    factor: fmpq_mpoly, chart: HalfAngleChart, vector: Vector | None, circles: list[int], power: int
) -> sp.Expr:
    """A power of a factor in angles; the compensating powers of 1 + t² are added to `circles`."""
    for i in (0, 1):
        if chart.angles[i]:
            circles[i] += power * ((int(factor.degrees()[i]) + 1) // 2)
    on_unit_sphere = on_sphere(factor, chart, vector) if vector is not None else None
    return (in_angles(factor, chart) if on_unit_sphere is None else on_unit_sphere) ** power


def _angle_of_form(factor: fmpq_mpoly, chart: HalfAngleChart, form: str) -> int | None:
    """The index of the angle for which a factor has the given form in t; None if there is none."""
    names = factor.context().names()
    for i in (0, 1):
        if chart.angles[i] and str(factor) == form.format(names[i]):
            return i
    return None
