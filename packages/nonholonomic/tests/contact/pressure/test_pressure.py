"""Force and couple of friction over a round patch: the definition, accuracy, shape."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from contact.patches import defined_factors, exact_factors, potential, relative_error
from flowlanes.errors import InputError
from nonholonomic.contact.pressure.pressure import Hertz, PowerPressure, Ring, Uniform

#: Laws and the exponent n of their pressure (1 − ρ²/a²)ⁿ; the ring is the limit n = −1.
LAWS = {
    "hertz": (Hertz(), 0.5),
    "uniform": (Uniform(), 0),
    "ring": (Ring(), -1),
    "punch": (PowerPressure(-0.5), -0.5),
    "nearly-ring": (PowerPressure(-0.99), -0.99),
    "nearly-uniform": (PowerPressure(1e-9), 1e-9),
    "paraboloid": (PowerPressure(1), 1),
    "steep": (PowerPressure(7.3), 7.3),
}
laws = pytest.mark.parametrize("name", LAWS)
RANDOM = np.random.default_rng(11)
RATIOS = np.concatenate(
    [
        [1e-300, 1e-9, 0.3, 0.999999, 1.0, 1.5, 2.0, 3.0, 1e8, 1e150, 1e300],
        10 ** RANDOM.uniform(-2, 2, 12),
        1 + 10 ** RANDOM.uniform(-13, -0.3, 6),
        1 - 10 ** RANDOM.uniform(-13, -0.3, 6),
    ]
)


@laws
def test_factors_are_accurate_to_a_few_units_in_the_last_place(name):
    law, n = LAWS[name]
    with mp.workdps(40):
        forces, couples = zip(*(exact_factors(n, k) for k in RATIOS), strict=True)
        assert relative_error(law.force(RATIOS), forces) < 8e-16
        assert relative_error(law.couple(RATIOS), couples) < 8e-16


def density(name, n):
    """The pressure for N = 1, a = 1."""
    constant = (n + 1) / np.pi
    return lambda r, from_edge: constant * (from_edge * (1 + r)) ** n


@pytest.mark.parametrize("name", [name for name, (_, n) in LAWS.items() if n > -0.9])
@pytest.mark.parametrize("k", [0.3, 0.8, 1.4, 6.0])
def test_factors_follow_from_the_definition(name, k):
    law, n = LAWS[name]
    phi, force, couple = defined_factors(density(name, n), k)
    assert law.force(k) == pytest.approx(force, rel=1e-13)
    assert law.couple(k) == pytest.approx(couple, rel=1e-12)
    assert law.couple(k) + k * law.force(k) == pytest.approx(phi, rel=1e-13)


@pytest.mark.parametrize("k", [0.3, 0.8, 1.4, 6.0])
def test_the_ring_follows_from_its_definition(k):
    with mp.workdps(20):
        distance = lambda t: mp.sqrt((1 - k) ** 2 + 4 * k * mp.sin(t / 2) ** 2)  # noqa: E731
        force = mp.quad(lambda t: (k - mp.cos(t)) / distance(t), [0, 0.5, mp.pi]) / mp.pi
        couple = mp.quad(lambda t: (1 - k * mp.cos(t)) / distance(t), [0, 0.5, mp.pi]) / mp.pi
    assert Ring().force(k) == pytest.approx(float(force), rel=1e-14)
    assert Ring().couple(k) == pytest.approx(float(couple), rel=1e-14)


@laws
@pytest.mark.parametrize("k", [0.2, 0.7, 1.2, 4.0])
def test_factors_are_derivatives_of_the_potential(name, k):
    law, n = LAWS[name]
    with mp.workdps(40):
        phi = potential(mp.mpf(n), mp.mpf(k))
        slope = mp.diff(lambda x: potential(mp.mpf(n), x), mp.mpf(k))
        assert relative_error([law.force(k), law.couple(k)], [slope, phi - k * slope]) < 1e-15


@laws
def test_force_rises_couple_falls_and_the_limit_set_is_convex(name):
    law, _ = LAWS[name]
    k = np.unique(
        np.concatenate([[0.0, 1.0], RANDOM.uniform(0, 3, 80), RANDOM.uniform(3, 100, 20)])
    )
    force, couple = law.force(k), law.couple(k)
    assert np.all(np.diff(force) > 0)
    assert np.all(np.diff(couple) < 0)
    # φ = M + kF is convex: each of its tangents, which has the slope F, lies below
    phi = couple + k * force
    tangents = phi[:, None] + force[:, None] * (k - k[:, None])
    assert np.all(phi - tangents >= -1e-15 * (1 + k))
    # and so is the set below the curve: −k is the slope dM/dF
    slopes = np.diff(couple) / np.diff(force)
    assert np.all(slopes <= -k[:-1] * (1 - 1e-9)) and np.all(slopes >= -k[1:] * (1 + 1e-9))


@laws
def test_ends(name):
    law, n = LAWS[name]
    np.testing.assert_array_equal(law.force([0.0, np.inf]), [0, 1])
    assert law.couple(np.inf) == 0
    with mp.workdps(30):
        at_rest = potential(mp.mpf(n), mp.mpf(0))
    assert law.couple(0.0) == pytest.approx(float(at_rest), rel=4e-16)
    assert law.force(1e-12) / 1e-12 == pytest.approx(float(at_rest) * (n + 1.5), rel=1e-15)
    assert 1e12 * law.couple(1e12) == pytest.approx(1 / (2 * (n + 2)), rel=1e-15)


def test_laws_agree_where_they_mean_the_same_pressure():
    k = np.linspace(0, 4, 60)
    for special, n in ((Hertz(), 0.5), (Uniform(), 0.0)):
        np.testing.assert_allclose(PowerPressure(n).force(k), special.force(k), rtol=1e-15, atol=0)
        np.testing.assert_allclose(
            PowerPressure(n).couple(k), special.couple(k), rtol=1.5e-15, atol=0
        )
    np.testing.assert_allclose(PowerPressure(-0.5).force(k[k <= 1]), np.pi / 4 * k[k <= 1])


def test_the_accuracy_test_sees_the_cancellation_of_the_closed_form():
    k = 30.0
    alpha, s = np.arcsin(1 / k), np.sqrt(k**2 - 1)
    closed = 3 / 64 * ((8 - 8 * k**2 + 3 * k**4) * alpha + 3 * (2 - k**2) * s)
    with mp.workdps(40):
        exact = exact_factors(0.5, k)[1]
        assert relative_error([closed], [exact]) > 1e-12
        assert relative_error([Hertz().couple(k)], [exact]) < 4e-16


def test_a_curling_stone_slides_and_spins_to_the_end():
    # dv/dt = −μg F, dΩ/dt = −2μg M/a: both end together at the ratio with F = 2kM
    stone = Uniform()
    k = 0.6530017892
    assert stone.force(k) == pytest.approx(2 * k * stone.couple(k), rel=1e-9)


def test_shape_of_the_answer():
    for law, _ in LAWS.values():
        assert law.force(0.5).shape == law.couple(2.0).shape == ()
        assert law.force(np.ones((2, 3))).shape == law.couple(np.ones((2, 3))).shape == (2, 3)
        assert law.force([]).shape == (0,)


@laws
@pytest.mark.parametrize("wrong", [-1.0, float("nan"), [0.5, -1e-9]])
def test_a_ratio_that_is_none_is_refused(name, wrong):
    law, _ = LAWS[name]
    for method in (law.force, law.couple):
        with pytest.raises(InputError, match=r"k = .*at least 0"):
            method(wrong)


@pytest.mark.parametrize("exponent", [-1, -2.0, float("nan"), float("inf")])
def test_an_exponent_that_is_none_is_refused(exponent):
    with pytest.raises(InputError, match="finite number above -1"):
        PowerPressure(exponent)
