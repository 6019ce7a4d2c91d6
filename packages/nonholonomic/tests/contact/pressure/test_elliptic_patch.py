"""Friction over an elliptic patch: the definition, the round patch, the far field, symmetries."""

from __future__ import annotations

import numpy as np
import pytest

from contact.patches import double_exponential
from flowlanes.errors import InputError
from nonholonomic.contact.pressure.elliptic_patch import EllipticHertz
from nonholonomic.contact.pressure.pressure import Hertz

PATCHES = [(1.0, 1.0), (2.0, 1.0), (0.3, 1.7), (10.0, 0.5), (1.0, 0.03)]
patches = pytest.mark.parametrize(("a", "b"), PATCHES)


def points(a, b, distances, seed=4):
    """Points at given distances in units of the ellipse, in random directions."""
    angles = np.random.default_rng(seed).uniform(0, 2 * np.pi, len(distances))
    return np.stack([a * distances * np.cos(angles), b * distances * np.sin(angles)], axis=-1)


def defined(a, b, d):
    """∫p|ρ−d|, ∫p(d−ρ)/|ρ−d| and ∫pρ·(ρ−d)/|ρ−d| for N = 1, over rays from the point d inside.

    The rays end on the ellipse; along them everything is summed, nothing integrated in closed form.
    """
    t, rest, weight = double_exponential()
    number = 60 + 40 * round(max(a, b) / min(a, b))
    phi = 2 * np.pi * np.arange(number) / number
    D = np.array(d) / [a, b]
    e = np.stack([np.cos(phi), np.sin(phi)], axis=-1)
    along = e @ D
    root = np.sqrt(along**2 + 1 - D @ D)
    length = (root - along)[:, None]
    # 1 − |D + t e|² factored at the end of the ray
    height = np.sqrt(length * rest * (length * t + (root + along)[:, None]))
    r = length * t
    area = 3 / (2 * np.pi) * height * r * length * weight * 2 * np.pi / number
    ray = e * [a, b]
    stretch = np.hypot(*ray.T)[:, None]
    unit = ray / stretch
    gradient = [-(area * unit[:, i : i + 1]).sum() for i in (0, 1)]
    lever = (unit @ np.array(d))[:, None] + r * stretch
    return (area * r * stretch).sum(), gradient, (area * lever).sum()


def defined_outside(a, b, d):
    """The same for a point outside, in elliptic polar coordinates about the centre."""
    t, rest, weight = double_exponential()
    number = 800
    theta = 2 * np.pi * np.arange(number)[:, None] / number
    rho = np.stack([a * t * np.cos(theta), b * t * np.sin(theta)], axis=-1)
    area = 3 / (2 * np.pi) * np.sqrt(rest * (1 + t)) * t * weight * 2 * np.pi / number
    away = np.array(d) - rho
    distance = np.hypot(away[..., 0], away[..., 1])
    unit = away / distance[..., None]
    return (
        (area * distance).sum(),
        [(area * unit[..., i]).sum() for i in (0, 1)],
        -(area * (rho * unit).sum(axis=-1)).sum(),
    )


@pytest.mark.parametrize(("a", "b"), PATCHES[:3])
@pytest.mark.parametrize("distance", [0.0, 0.4, 0.9])
def test_inside_it_follows_from_the_definition(a, b, distance):
    patch = EllipticHertz(a, b)
    (d,) = points(a, b, np.array([distance]), seed=int(10 * distance))
    potential, gradient, couple = defined(a, b, d)
    assert patch.potential(d) == pytest.approx(potential, rel=2e-14)
    np.testing.assert_allclose(patch.gradient(d), gradient, rtol=2e-14, atol=1e-14)
    assert patch.couple(d) == pytest.approx(couple, rel=2e-14)


@pytest.mark.parametrize(("a", "b"), PATCHES[:3])
@pytest.mark.parametrize("distance", [1.3, 2.0, 7.0])
def test_outside_it_follows_from_the_definition(a, b, distance):
    patch = EllipticHertz(a, b)
    (d,) = points(a, b, np.array([distance]), seed=int(10 * distance))
    potential, gradient, couple = defined_outside(a, b, d)
    assert patch.potential(d) == pytest.approx(potential, rel=2e-14)
    np.testing.assert_allclose(patch.gradient(d), gradient, rtol=2e-14, atol=1e-14)
    assert patch.couple(d) == pytest.approx(couple, rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("a", "b"), PATCHES[3:])
def test_slender_patches_follow_from_the_definition(a, b):
    patch = EllipticHertz(a, b)
    for d in points(a, b, np.array([0.3, 0.8])):
        potential, gradient, couple = defined(a, b, d)
        assert patch.potential(d) == pytest.approx(potential, rel=1e-13)
        np.testing.assert_allclose(patch.gradient(d), gradient, rtol=1e-13, atol=1e-13)
        assert patch.couple(d) == pytest.approx(couple, rel=1e-13)


def test_a_round_patch_is_that_of_hertz():
    a = 0.7
    patch = EllipticHertz(a, a)
    ratios = np.concatenate(
        [np.linspace(0.01, 1, 40), 1 + np.geomspace(1e-14, 1e7, 60), 1 - np.geomspace(1e-14, 0.1)]
    )
    d = points(a, a, ratios)
    k = np.hypot(*d.T) / a
    force, couple = Hertz().force(k), Hertz().couple(k)
    np.testing.assert_allclose(patch.gradient(d), force[:, None] * d / (a * k)[:, None], atol=2e-15)
    np.testing.assert_allclose(patch.couple(d), a * couple, rtol=4e-15)
    np.testing.assert_allclose(patch.potential(d), a * (couple + k * force), rtol=2e-15)
    np.testing.assert_array_equal(np.abs(patch.gradient([0.0, 0.0])) < 1e-16, True)


@patches
def test_couple_gradient_and_potential_are_tied(a, b):
    patch = EllipticHertz(a, b)
    d = points(a, b, np.array([0.2, 0.7, 0.99, 1.01, 1.5, 4.0]))
    virial = patch.potential(d) - (d * patch.gradient(d)).sum(axis=-1)
    np.testing.assert_allclose(patch.couple(d), virial, atol=1e-14 * patch.potential(d).max())
    # differences of sixth order, away from the edge, where ψ is not smooth
    d, step = d[[0, 1, 4, 5]], 1e-3 * min(a, b)
    for i in (0, 1):
        shift = step * np.eye(2)[i]
        one, two, three = (
            (patch.potential(d + n * shift) - patch.potential(d - n * shift)) / (2 * n * step)
            for n in (1, 2, 3)
        )
        slope = 1.5 * one - 0.6 * two + 0.1 * three
        tolerance = 4e-13 * patch.potential(d).max() / min(a, b)
        np.testing.assert_allclose(patch.gradient(d)[:, i], slope, atol=tolerance)


@patches
def test_inside_it_is_a_polynomial_of_degree_four(a, b):
    patch = EllipticHertz(a, b)
    t = np.linspace(-1, 1, 12)
    line = np.stack([a * (0.1 + 0.6 * t), b * (0.2 - 0.5 * t)], axis=-1)
    values = patch.potential(line) / max(a, b)
    fitted = np.polynomial.Polynomial.fit(t, values, 4)
    assert np.abs(fitted(t) - values).max() < 1e-14
    cubic = np.polynomial.Polynomial.fit(t, values, 3)
    assert np.abs(cubic(t) - values).max() > 1e-5


@patches
def test_inside_and_outside_meet(a, b):
    patch = EllipticHertz(a, b)
    angles = np.linspace(0.1, 6, 9)
    edge = np.stack([a * np.cos(angles), b * np.sin(angles)], axis=-1)
    for function in (patch.potential, patch.gradient, patch.couple):
        inside, outside = function(edge * (1 - 1e-13)), function(edge * (1 + 1e-13))
        scale = np.abs(inside).max()
        np.testing.assert_allclose(inside, outside, atol=1e-11 * scale * max(a / b, b / a))


@patches
def test_far_away_the_couple_is_a_second_moment(a, b):
    # ψ = |d| + ⟨(ρ·t)²⟩/(2|d|) + …, t across d; Hertz's second moments are a²/5 and b²/5
    angles = np.linspace(0, 6, 13)
    t = np.stack([-np.sin(angles), np.cos(angles)], axis=-1)
    d = 1e8 * max(a, b) * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    patch = EllipticHertz(a, b)
    moments = (t**2 @ [a**2, b**2]) / 5
    computed = patch.couple(d) * np.hypot(*d.T)
    np.testing.assert_allclose(computed, moments, atol=1e-13 * max(a, b) ** 2)
    np.testing.assert_allclose(patch.gradient(d), d / np.hypot(*d.T)[:, None], atol=1e-14)


@patches
def test_symmetries_and_scale(a, b):
    patch, turned = EllipticHertz(a, b), EllipticHertz(b, a)
    d = points(a, b, np.array([0.5, 0.9, 1.2, 3.0]))
    np.testing.assert_allclose(patch.potential(d), turned.potential(d[:, ::-1]), rtol=4e-15)
    np.testing.assert_allclose(patch.couple(d), patch.couple(d * [-1, 1]), rtol=1e-13)
    np.testing.assert_allclose(patch.gradient(-d), -patch.gradient(d), atol=1e-14)
    larger = EllipticHertz(8 * a, 8 * b)
    np.testing.assert_allclose(larger.potential(8 * d), 8 * patch.potential(d), rtol=1e-15)


def test_the_force_is_not_against_the_sliding():
    patch = EllipticHertz(2.0, 1.0)
    for d, sheer in (((0.5, 0.0), 0), ((0.0, 0.5), 0), ((0.5, 0.5), 0.01)):
        gradient = patch.gradient(d)
        across = abs(gradient[0] * d[1] - gradient[1] * d[0])
        assert across > sheer if sheer else across < 1e-15


def test_shapes():
    patch = EllipticHertz(2.0, 1.0)
    d = np.linspace(-3, 3, 24).reshape(3, 4, 2)
    assert patch.potential(d).shape == patch.couple(d).shape == (3, 4)
    assert patch.gradient(d).shape == (3, 4, 2)
    assert patch.potential([1.0, 5.0]).shape == ()
    many = points(2.0, 1.0, np.linspace(0, 3, 100_000 // 2))
    np.testing.assert_allclose(patch.potential(many)[::9999], patch.potential(many[::9999]))


@pytest.mark.parametrize("axes", [(0.0, 1.0), (1.0, -1.0), (np.nan, 1.0), (1.0, np.inf)])
def test_semi_axes_must_be_positive(axes):
    with pytest.raises(InputError, match="positive and finite"):
        EllipticHertz(*axes)


def test_a_patch_may_be_too_slender():
    assert EllipticHertz(1.0, 0.01).couple([2.0, 3.0]) > 0
    with pytest.raises(InputError, match="100 times"):
        EllipticHertz(0.009, 1.0)


@pytest.mark.parametrize("wrong", [[1.0, 2.0, 3.0], 1.0, [np.nan, 1.0], [[1.0], [2.0]]])
def test_points_that_are_none_are_refused(wrong):
    with pytest.raises(InputError, match="shape"):
        EllipticHertz(1.0, 2.0).potential(wrong)


@pytest.mark.parametrize("spin", [0.6, -0.6])
def test_force_and_couple_are_what_coulombs_law_sums_up_to(spin):
    # sliding fast enough that no point of the patch is at rest
    a, b, u = 2.0, 1.0, np.array([0.9, -1.4])
    t, rest, weight = double_exponential()
    theta = 2 * np.pi * np.arange(400)[:, None] / 400
    first, second = a * t * np.cos(theta), b * t * np.sin(theta)
    area = 3 / (2 * np.pi) * np.sqrt(rest * (1 + t)) * t * weight * 2 * np.pi / 400
    slip = np.stack([u[0] - spin * second, u[1] + spin * first])
    friction = -area * slip / np.hypot(*slip)
    patch = EllipticHertz(a, b)
    d = np.array([-u[1], u[0]]) / spin
    slope = patch.gradient(d)
    force = np.sign(spin) * np.array([-slope[1], slope[0]])
    np.testing.assert_allclose(force, [friction[0].sum(), friction[1].sum()], rtol=1e-13)
    torque = (first * friction[1] - second * friction[0]).sum()
    assert -np.sign(spin) * patch.couple(d) == pytest.approx(torque, rel=1e-12)
    assert abs(force[0] * u[1] - force[1] * u[0]) > 0.01
