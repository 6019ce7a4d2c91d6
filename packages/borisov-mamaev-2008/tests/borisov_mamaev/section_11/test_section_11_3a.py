"""§11.3: the numbers that the claims on the tippe top rest on."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import nonholonomic
from borisov_mamaev_2008.section_11 import section_11_3a as claims
from nonholonomic.contact import DryContact
from nonholonomic.contact.invariants import top_stability as top
from nonholonomic.contact.invariants.sliding_top import c
from nonholonomic.mechanics.rotations import upright


def growth(spin: float, offset: int, viscosity: float) -> float:
    """Largest real part of a root of the characteristic polynomial."""
    values = claims.TOP | {top.n: spin, top.kappa: viscosity}
    values[c] *= offset
    polynomial = sp.Poly(top.characteristic_polynomial().subs(values), top.rate)
    return float(np.roots([complex(x) for x in polynomial.all_coeffs()]).real.max())


def test_the_fast_top_is_unstable_and_the_slow_one_stable_for_every_viscosity() -> None:
    for viscosity in (1e-3, 1e-2, 1.0):
        assert growth(float(claims.SLOW), 1, viscosity) < 0 < growth(180.0, 1, viscosity)


def test_sliding_without_spin_has_the_friction_of_coulomb() -> None:
    assert claims.sliding_without_spin().decision == "proven"


def test_the_inverted_top_with_the_same_jellett_integral_is_stable() -> None:
    share = float(claims._inverted_share())
    assert growth(180.0 * share, -1, 0.02) < 0
    assert growth(20.0 * share, -1, 0.02) > 0


@pytest.mark.slow
def test_rolling_oscillates_and_does_not_grow() -> None:
    """Very viscous friction: the growth goes to zero, as that of the rolling top."""
    stable, discriminant = claims.steady_under_dry_friction()
    assert stable and discriminant > 0
    rates = [growth(180.0, 1, viscosity) for viscosity in (10.0, 100.0, 1000.0)]
    assert rates[0] > rates[1] > rates[2] > 0
    np.testing.assert_allclose(np.array(rates[:2]) / rates[1:], 10, rtol=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("tilt", [1e-3, 1e-2])
def test_a_fast_top_under_dry_friction_stays_near_the_vertical(tilt: float) -> None:
    """It slides at first, then rolls, and friction holds it for two seconds."""
    top_body = nonholonomic.Body(
        0.006, (8e-7, 8e-7, 7e-7), nonholonomic.Ball(0.015, centre=(0.0, 0.0, 0.003))
    )
    gamma = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
    height = 0.015 - 0.003 * np.cos(tilt)
    turn = [float(x) for x in upright(list(map(float, gamma)))]
    state = [*turn, 0.0, 0.0, height, 0.0, 0.0, 0.0, 0.0, 0.0, 180.0, *map(float, gamma)]
    motion = DryContact(top_body, state, (0.3, 0.6)).motion(0.3, np.linspace(0.02, 2.0, 100))
    assert np.arccos(motion[:, 15]).max() < tilt
