"""Starts of motions with friction against what they must satisfy."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

import flowlanes
import nonholonomic
from flowlanes.system.arrays import FloatArray
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.dry_friction import Coulomb, SpinFriction
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.nearest_point import nearest_normal
from nonholonomic.contact.simulation.compiled import NORMAL, OMEGA, POSITION, VELOCITY, WORK
from nonholonomic.contact.starts import clearance, state_in_contact, state_in_space

SURFACES = {
    "plane": nonholonomic.Plane(),
    "turning plane": nonholonomic.Plane(turntable=1.3),
    "dome": nonholonomic.Sphere(3.0, turntable=-0.7),
    "bowl": nonholonomic.Sphere(4.0, side="inside", turntable=0.4),
}


def pebble(surface: nonholonomic.Plane | nonholonomic.Sphere) -> FrictionalContact:
    shape = nonholonomic.Ellipsoid((1.0, 0.8, 0.6), turn=0.3, centre=(0.05, -0.1, 0.04))
    body = nonholonomic.Body(1.3, (0.4, 0.5, 0.6), shape)
    return FrictionalContact(body, surface, (Coulomb(0.3),), nonholonomic.Forces(gravity=9.81))


def rotation(state: FloatArray) -> FloatArray:
    w, x, y, z = state[:4]
    return Rotation.from_quat([x, y, z, w]).as_matrix()


def random_start(seed: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Normal, angular velocity, and a slip across the normal."""
    draw = np.random.default_rng(seed)
    gamma, omega, slip = draw.normal(size=(3, 3))
    gamma /= np.linalg.norm(gamma)
    return gamma, omega, slip - (slip @ gamma) * gamma


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("seed", range(3))
def test_the_touching_particle_slips_as_given(name: str, seed: int) -> None:
    surface = SURFACES[name]
    contact = pebble(surface)
    gamma, omega, slip = random_start(seed)
    normal = (0.0, 0.0, 1.0) if name.endswith("plane") else (0.2, -0.3, 0.9)
    state = state_in_contact(contact, omega, 2.5 * gamma, slip, heading=0.7, normal=normal)
    Q, r = rotation(state), contact.body.shape.contact_points()(gamma[None])[0]
    touching = state[POSITION] + Q @ r
    support = np.cross([0, 0, surface.turntable], touching)
    found = Q @ (state[VELOCITY] + np.cross(state[OMEGA], r)) - support
    np.testing.assert_allclose(Q.T @ found, slip, atol=1e-14)
    up = np.array(normal) / np.linalg.norm(normal)
    np.testing.assert_allclose(Q @ gamma, up, atol=1e-14)
    np.testing.assert_allclose(state[NORMAL], gamma, atol=1e-15)
    expected = (
        np.zeros(3) if isinstance(surface, nonholonomic.Plane) else surface.signed_radius * up
    )
    np.testing.assert_allclose(touching, expected, atol=1e-14)
    assert not state[WORK:].any()


@pytest.mark.parametrize("name", SURFACES)
def test_both_kinds_of_start_give_one_state(name: str) -> None:
    contact = pebble(SURFACES[name])
    gamma, omega, slip = random_start(7)
    one = state_in_contact(contact, omega, gamma, slip)
    velocity = rotation(one) @ one[VELOCITY]
    other = state_in_space(contact, one[POSITION], 3 * one[:4], velocity, omega)
    np.testing.assert_allclose(other, one, atol=4e-15)


def test_heading_turns_the_body_about_the_normal() -> None:
    contact = pebble(nonholonomic.Plane())
    straight = rotation(state_in_contact(contact, (0, 0, 0), (0.3, 0.1, 0.9)))
    turned = rotation(state_in_contact(contact, (0, 0, 0), (0.3, 0.1, 0.9), heading=0.4))
    about = Rotation.from_rotvec([0, 0, 0.4]).as_matrix()
    np.testing.assert_allclose(turned, about @ straight, atol=1e-15)


@pytest.mark.parametrize("laws", [(), (Coulomb(0.3),), (Coulomb(0.3), SpinFriction(0.1))])
@pytest.mark.parametrize("surface", [nonholonomic.Plane(), nonholonomic.Plane(turntable=1.0)])
def test_a_state_has_all_columns(laws: tuple[Coulomb, ...], surface: nonholonomic.Plane) -> None:
    contact = replace(pebble(surface), laws=laws)
    state = state_in_contact(contact, (0, 0, 1), (0, 0, 1))
    assert len(state) == len(contact_equations(contact, Mode()).symbols)


def distance(contact: FrictionalContact, position: FloatArray, Q: FloatArray) -> float:
    """Gap over a sphere by the nearest or farthest point of the ellipsoid, by optimisation."""
    shape = contact.body.shape
    assert isinstance(shape, nonholonomic.Ellipsoid)
    cosine, sine = np.cos(shape.turn), np.sin(shape.turn)
    frame = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    sign = 1.0 if contact.surface.side == "outside" else -1.0

    def place(angles: FloatArray) -> FloatArray:
        theta, phi = angles
        unit = [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)]
        return position + Q @ (np.array(shape.centre) + frame @ (np.array(shape.axes) * unit))

    best = min(
        minimize(lambda x: sign * np.linalg.norm(place(x)), (theta, phi), tol=1e-12).fun
        for theta in (0.5, 1.5, 2.6)
        for phi in (0.0, 2.1, 4.2)
    )
    return float(best - sign * contact.surface.radius)


@pytest.mark.parametrize("name", ["dome", "bowl"])
@pytest.mark.parametrize("seed", range(3))
def test_the_gap_over_a_sphere_is_that_of_the_nearest_point(name: str, seed: int) -> None:
    contact = pebble(SURFACES[name])
    draw = np.random.default_rng(seed)
    way = draw.normal(size=3)
    length = 5.0 if name == "dome" else 1.5
    position = length * way / np.linalg.norm(way)
    Q = Rotation.random(rng=seed)
    x, y, z, w = Q.as_quat()
    known = clearance(contact, position, (w, x, y, z))
    assert known.gap == pytest.approx(distance(contact, position, Q.as_matrix()), abs=1e-9)
    seen = Q.as_matrix().T @ position + known.r
    np.testing.assert_allclose(np.cross(known.gamma, seen), 0, atol=1e-14)


def test_the_sphere_in_a_hollow_ball_touches_at_its_top() -> None:
    ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(2.0, hollow=True))
    contact = FrictionalContact(ball, nonholonomic.Sphere(1.0))
    state = state_in_contact(contact, (0, 0, 0), (0, 0, 1))
    known = clearance(contact, state[POSITION], state[:4])
    np.testing.assert_allclose(known.gamma, [0, 0, 1], atol=1e-15)
    assert abs(known.gap) < 1e-15


def test_the_nearest_plane_of_a_sharp_disk() -> None:
    disk = nonholonomic.Disk(1.0).contact_points()
    turn = Rotation.from_euler("xz", [0.4, 1.1]).as_matrix()
    centre = turn.T @ np.array([0.3, -0.2, 4.0])
    gamma = nearest_normal(disk, centre, outside=True)
    edge = np.linspace(0, 2 * np.pi, 100_001)
    rim = centre + np.stack([np.cos(edge), np.sin(edge), 0 * edge], axis=1)
    y = centre + disk(gamma[None])[0]
    assert np.linalg.norm(y) == pytest.approx(np.linalg.norm(rim, axis=1).min(), abs=1e-8)


def test_decimals_that_almost_touch_are_put_on_the_support() -> None:
    contact = pebble(nonholonomic.Plane())
    exact = state_in_contact(contact, (1, 2, 3), (0.3, -0.4, 0.8))
    for shift in (4e-10, -4e-10):
        moved = exact[POSITION] + [0, 0, shift]
        velocity = rotation(exact) @ exact[VELOCITY] + [0, 0, shift]
        state = state_in_space(contact, moved, exact[:4], velocity, exact[OMEGA])
        assert abs(clearance(contact, state[POSITION], state[:4]).gap) < 1e-15
        np.testing.assert_allclose(state[VELOCITY], exact[VELOCITY], atol=1e-15)


def test_a_body_far_above_is_left_there() -> None:
    contact = pebble(nonholonomic.Plane())
    state = state_in_space(contact, (1, 2, 5), (1, 0, 0, 0), (0, 0, -3), (1, 0, 0))
    np.testing.assert_array_equal(state[POSITION], [1, 2, 5])
    np.testing.assert_array_equal(state[VELOCITY], [0, 0, -3])


def test_an_impact_at_the_start_is_left_as_it_is() -> None:
    contact = FrictionalContact(nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0)))
    state = state_in_space(contact, (0, 0, 1), (1, 0, 0, 0), (0, 0, -3), (1, 0, 0))
    np.testing.assert_array_equal(state[VELOCITY], [0, 0, -3])


def test_without_a_limit_of_friction_a_slip_of_decimals_is_removed() -> None:
    ball = FrictionalContact(
        nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0)), laws=(Coulomb(np.inf),)
    )
    state = state_in_space(ball, (0, 0, 1), (1, 0, 0, 0), (2 + 1e-10, 0, 0), (0, 2, 0))
    np.testing.assert_allclose(state[VELOCITY], [2, 0, 0], atol=1e-15)
    with pytest.raises(flowlanes.InputError, match="velocity: the contact would slip"):
        state_in_space(ball, (0, 0, 1), (1, 0, 0, 0), (2.1, 0, 0), (0, 2, 0))


@pytest.mark.parametrize(
    ("position", "words"),
    [((0, 0, 0.5), "0.5 m inside"), ((0, 0, 1 - 1e-8), "1e-08 m inside"), ((0, 0), "three")],
)
def test_places_that_are_refused(position: tuple[float, ...], words: str) -> None:
    ball = FrictionalContact(nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0)))
    with pytest.raises(flowlanes.InputError, match=words):
        state_in_space(ball, position, (1, 0, 0, 0), (0, 0, 0), (0, 0, 0))
