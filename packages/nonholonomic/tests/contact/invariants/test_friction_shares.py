"""Bounds of the shares of friction, against quadrature over the patch."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from nonholonomic.contact.invariants.friction_shares import (
    HERTZ,
    UNIFORM,
    Series,
    bounds,
    force_beyond,
    force_within,
    least_friction,
    pure_spin,
    slope,
)
from nonholonomic.contact.pressure.pressure_ranges import hertz_ranges, k


def shares(k: float, exponent: float, points: int = 900) -> tuple[float, float]:
    """𝓕 and 𝓜 of a unit patch with the pressure (p + 1)/π (1 − ρ²)^p, by quadrature."""
    # ρ² = 1 − s^{1/(p+1)} makes the pressure constant in s
    s = (np.arange(points) + 0.5) / points
    rho = np.sqrt(1 - s ** (1 / (exponent + 1)))[:, None]
    angle = (np.arange(points) + 0.5) / points * 2 * np.pi
    along, across = k - rho * np.sin(angle), rho * np.cos(angle)
    speed = np.hypot(along, across)
    lever = rho * (across * np.cos(angle) - along * np.sin(angle))
    return float(np.mean(along / speed)), float(np.mean(lever / speed))


@pytest.mark.parametrize("p", [HERTZ, UNIFORM])
@pytest.mark.parametrize("k", [0.3, 0.8, 1.3, 4.0])
def test_the_bounds_hold(p: sp.Rational, k: float) -> None:
    found = bounds(p)
    assert found is not None
    force, couple = shares(k, float(p))
    assert force <= float(found[0]) * k + 1e-4
    assert k * couple <= float(found[1]) + 1e-4
    assert k * force + couple >= float(least_friction(p)) * max(1.0, k) - 1e-4


@pytest.mark.parametrize("p", [HERTZ, UNIFORM])
def test_the_series_are_those_of_the_shares(p: sp.Rational) -> None:
    def value(series: Series, x: float) -> float:
        return float(sp.hyper((series.a, series.b), (series.c,), x).evalf())

    inner = float(slope(p)) * 0.6 * value(force_within(p), 0.36)
    assert shares(0.6, float(p))[0] == pytest.approx(inner, abs=2e-4)
    assert shares(2.0, float(p))[0] == pytest.approx(value(force_beyond(p), 0.25), abs=2e-4)
    assert shares(1e-9, float(p))[1] == pytest.approx(float(pure_spin(p)), abs=2e-4)


def test_the_closed_form_has_the_coefficients_of_the_series() -> None:
    y = sp.Symbol("y", positive=True)
    force, couple = (factor.subs(k, 1 / y) for factor in hertz_ranges()[1].factors())
    root = sp.sqrt(1 / y**2 - 1)
    straight = [f.subs(root, sp.sqrt(1 - y**2) / y) for f in (force, couple)]
    for formula, a, b, lead, denominator in (
        (straight[0], -sp.S.Half, sp.S.Half, 0, sp.Rational(5, 2)),
        (straight[1], sp.S.Half, sp.S.Half, 1, sp.Rational(7, 2)),
    ):
        series = sp.series(sp.expand(formula), y, 0, 9).removeO()
        for order in range(4):
            term = sp.rf(a, order) * sp.rf(b, order) / sp.rf(denominator, order)
            term = term / sp.factorial(order) / (5 if lead else 1)
            assert sp.expand(series).coeff(y, 2 * order + lead) == term


def test_signs_that_are_not_known_are_not_guessed() -> None:
    with pytest.raises(ArithmeticError, match="may be negative"):
        _ = Series(sp.Rational(-5, 2), sp.S.Half, sp.S.One).sign_after_first
    with pytest.raises(ArithmeticError, match="does not converge"):
        Series(sp.S.Half, sp.S.Half, sp.S.One).at_one()
    assert bounds(sp.Rational(-3, 4)) is None
