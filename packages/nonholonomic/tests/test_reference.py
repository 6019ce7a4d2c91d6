"""The reference motion against facts of mechanics that are older than either program."""

import numpy as np
import pytest

from reference import (
    CONTACTS,
    SHAPES,
    SUPPORTS,
    Body,
    Disk,
    Forces,
    ImplicitShape,
    Plane,
    ShapeOfRevolution,
    Sphere,
    acceleration,
    attitude_with_normal,
    ball,
    ellipsoid,
    integrate,
    random_case,
    rotation,
    torus,
)

UPRIGHT = (0.0, 0.0, 1.0)


def on_plane(gamma, omega, turn=0.3):
    gamma = np.asarray(gamma, dtype=float) / np.linalg.norm(gamma)
    return {
        "gamma": gamma,
        "omega": np.asarray(omega, dtype=float),
        "attitude": attitude_with_normal(gamma, turn=turn),
    }


def without_spin(start):
    gamma, omega = start["gamma"], start["omega"]
    return start | {"omega": omega - (omega @ gamma) * gamma}


def in_space(motion, vectors):
    return np.array([rotation(q) @ v for q, v in zip(motion["attitude"], vectors, strict=True)])


ALL_KINDS = [
    (shape, support, CONTACTS[(i + j + 1) % 2])
    for i, shape in enumerate(SHAPES)
    for j, support in enumerate(SUPPORTS)
    if shape != "hollow ball" or support == "outside"
]


# Random cases: what every motion keeps


@pytest.mark.slow
@pytest.mark.parametrize(("shape", "support", "contact"), ALL_KINDS)
def test_random_motion_keeps_energy_and_constraints(shape, support, contact):
    case = random_case(np.random.default_rng(11), shape, support, contact)
    motion = case.run(np.linspace(0.0, 4.0, 9))
    assert np.ptp(motion["energy"]) < 1e-11
    assert motion["residual"].max() < 1e-11
    assert np.abs(motion["omega"] - motion["omega"][0]).max() > 1e-3
    normal = in_space(motion, motion["gamma"])
    along = np.sum(motion["contact_force"] * normal, axis=1)
    np.testing.assert_allclose(along, motion["normal_force"], rtol=0, atol=1e-11)
    if support == "plane":
        np.testing.assert_allclose(normal, np.tile(UPRIGHT, (9, 1)), rtol=0, atol=1e-13)
        np.testing.assert_allclose(motion["contact"][:, 2], 0.0, rtol=0, atol=1e-11)
    else:
        radius = case.surface.radius
        np.testing.assert_allclose(motion["contact"], radius * normal, rtol=0, atol=1e-11)
    if contact == "marble":
        np.testing.assert_array_equal(motion["spin_torque"], 0.0)
    else:
        spin = np.sum(motion["omega"] * motion["gamma"], axis=1)
        np.testing.assert_allclose(spin, 0.0, rtol=0, atol=1e-12)
        assert np.abs(motion["spin_torque"]).max() > 1e-3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "support", "contact"),
    [
        ("ellipsoid", "inside", "rubber"),
        ("torus", "plane", "marble"),
        ("ball", "outside", "marble"),
    ],
)
def test_motion_at_ten_does_not_depend_on_tolerance(shape, support, contact):
    case = random_case(np.random.default_rng(3), shape, support, contact)
    arguments = (case.body, case.surface, case.contact, case.forces, case.start, [10.0])
    normal = integrate(*arguments)
    looser = integrate(*arguments, rtol=1e-13, atol=1e-14)
    finer = integrate(*arguments, max_step=0.02)
    for key in ("omega", "gamma", "attitude", "centre", "contact", "contact_force"):
        np.testing.assert_allclose(looser[key], normal[key], rtol=0, atol=1e-11)
        np.testing.assert_allclose(finer[key], normal[key], rtol=0, atol=1e-11)


@pytest.mark.slow
def test_reversed_motion_returns():
    case = random_case(np.random.default_rng(5), "implicit", "outside", "marble")
    forth = case.run([5.0])
    body = Body(case.body.mass, case.body.inertia, case.body.shape, -np.asarray(case.body.gyrostat))
    gamma = forth["gamma"][0] / np.linalg.norm(forth["gamma"][0])
    start = {"omega": -forth["omega"][0], "gamma": gamma, "attitude": forth["attitude"][0]}
    back = integrate(body, case.surface, case.contact, case.forces, start, [5.0])
    for key in ("gamma", "attitude"):
        np.testing.assert_allclose(back[key][0], case.start[key], rtol=0, atol=1e-11)
    np.testing.assert_allclose(back["omega"][0], -case.start["omega"], rtol=0, atol=1e-11)


@pytest.mark.slow
def test_random_case_is_admissible_and_reproducible():
    cases = [
        random_case(np.random.default_rng(8), "revolution", "inside", "rubber", kind)
        for kind in ("turned", "turned", "principal")
    ]
    first, again, principal = cases
    assert first.shape_table == again.shape_table
    np.testing.assert_array_equal(first.body.inertia, again.body.inertia)
    for case in cases:
        small, middle, large = np.linalg.eigvalsh(case.body.inertia)
        assert small > 0.0
        assert small + middle > large
        assert abs(case.start["omega"] @ case.start["gamma"]) < 1e-14
    off_diagonal = ~np.eye(3, dtype=bool)
    assert np.abs(first.body.inertia[off_diagonal]).max() > 1e-3
    np.testing.assert_array_equal(principal.body.inertia[off_diagonal], 0.0)


# Balls


@pytest.mark.parametrize("contact", CONTACTS)
def test_homogeneous_ball_on_plane_rolls_uniformly(contact):
    mass, radius, gravity = 1.3, 0.7, 9.81
    body = Body(mass, 0.4 * mass * radius**2 * np.eye(3), ball(radius))
    start = on_plane((0.3, -0.5, 0.8), (1.0, 2.0, -0.5))
    if contact == "rubber":
        start = without_spin(start)
    times = np.linspace(0.0, 5.0, 6)
    motion = integrate(body, Plane(), contact, Forces(gravity), start, times)
    spin = in_space(motion, motion["omega"])
    np.testing.assert_allclose(spin, np.tile(spin[0], (6, 1)), rtol=0, atol=1e-12)
    velocity = radius * np.cross(spin[0], UPRIGHT)
    path = (0.0, 0.0, radius) + times[:, None] * velocity
    np.testing.assert_allclose(motion["centre"], path, rtol=0, atol=1e-11)
    np.testing.assert_allclose(motion["normal_force"], mass * gravity, rtol=1e-12)


@pytest.mark.parametrize("contact", CONTACTS)
def test_small_oscillations_in_a_bowl(contact):
    mass, radius, bowl, gravity, tilt = 0.9, 0.3, 1.1, 9.81, 1e-4
    body = Body(mass, 0.4 * mass * radius**2 * np.eye(3), ball(radius))
    gamma = np.array([0.48, 0.6, 0.64])
    normal = (-np.sin(tilt), 0.0, np.cos(tilt))
    start = {
        "omega": np.zeros(3),
        "gamma": gamma,
        "attitude": attitude_with_normal(gamma, normal),
    }
    times = np.linspace(0.0, 4.0, 21)
    motion = integrate(body, Sphere(-bowl), contact, Forces(gravity), start, times)
    frequency = np.sqrt(5 * gravity / (7 * (bowl - radius)))
    swing = (bowl - radius) * tilt
    np.testing.assert_allclose(
        motion["centre"][:, 0] / swing, np.cos(frequency * times), rtol=0, atol=1e-6
    )
    np.testing.assert_allclose(motion["centre"][:, 1], 0.0, rtol=0, atol=1e-12)


@pytest.mark.parametrize(("signed_radius", "hollow"), [(2.0, False), (-2.5, False), (0.6, True)])
def test_homogeneous_marble_ball_on_sphere_keeps_its_spin(signed_radius, hollow):
    body = Body(1.0, 0.5 * np.eye(3), ball(0.9, hollow=hollow))
    start = {
        "omega": np.array([0.8, -0.6, 1.1]),
        "gamma": np.array([0.6, 0.0, 0.8]),
        "attitude": np.array([0.5, -0.5, 0.5, 0.5]),
    }
    motion = integrate(
        body, Sphere(signed_radius), "marble", Forces(2.0), start, np.linspace(0.0, 4.0, 5)
    )
    spin = np.sum(motion["omega"] * motion["gamma"], axis=1)
    np.testing.assert_allclose(spin, spin[0], rtol=0, atol=1e-12)
    to_centre = np.linalg.norm(motion["centre"], axis=1)
    distance = abs(signed_radius - 0.9 if hollow else signed_radius + 0.9)
    np.testing.assert_allclose(to_centre, distance, rtol=0, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("contact", "kept"), [("marble", 3), ("rubber", 2)])
def test_chaplygin_ball_keeps_its_momentum_about_the_contact(contact, kept):
    mass, radius, gyrostat = 1.4, 0.8, np.array([0.2, -0.4, 0.3])
    inertia = np.array([[0.9, 0.1, 0.05], [0.1, 0.7, -0.08], [0.05, -0.08, 0.5]])
    body = Body(mass, inertia, ball(radius), gyrostat)
    start = on_plane((0.2, 0.7, -0.4), (1.1, -0.3, 1.7))
    if contact == "rubber":
        start = without_spin(start)
    motion = integrate(body, Plane(), contact, Forces(9.81), start, np.linspace(0.0, 10.0, 5))
    arm = -radius * motion["gamma"]
    orbital = mass * np.cross(arm, np.cross(motion["omega"], arm))
    momentum = in_space(motion, motion["omega"] @ inertia + gyrostat + orbital)
    for axis in range(kept):
        np.testing.assert_allclose(momentum[:, axis], momentum[0, axis], rtol=0, atol=1e-11)


def test_jellett_integral_of_a_ball_of_revolution():
    across, along = 0.6, 0.45
    centre = np.array([0.0, 0.0, 0.25])
    body = Body(1.2, np.diag([across, across, along]), ball(0.9, centre))
    start = on_plane((0.4, -0.1, 0.7), (0.9, 1.4, 2.0))
    motion = integrate(body, Plane(), "marble", Forces(9.81), start, np.linspace(0.0, 5.0, 6))
    arm = centre - 0.9 * motion["gamma"]
    jellett = np.sum(motion["omega"] * (across, across, along) * arm, axis=1)
    np.testing.assert_allclose(jellett, jellett[0], rtol=0, atol=1e-11)
    assert np.ptp(motion["gamma"][:, 2]) > 0.1


# Disks


def thin_disk(mass, radius):
    across = mass * radius**2 / 4
    return Body(mass, np.diag([across, across, 2 * across]), Disk(radius)), across


@pytest.mark.parametrize("contact", CONTACTS)
def test_upright_disk_rolls_straight(contact):
    mass, radius, gravity, rate = 1.1, 0.6, 9.81, 3.0
    body, _ = thin_disk(mass, radius)
    start = on_plane((0.8, 0.6, 0.0), (0.0, 0.0, rate))
    times = np.linspace(0.0, 3.0, 4)
    motion = integrate(body, Plane(), contact, Forces(gravity), start, times)
    axis = rotation(start["attitude"])[:, 2]
    velocity = radius * rate * np.cross(axis, UPRIGHT)
    path = times[:, None] * velocity
    np.testing.assert_allclose(motion["contact"], path, rtol=0, atol=1e-11)
    np.testing.assert_allclose(motion["normal_force"], mass * gravity, rtol=1e-11)


def test_steady_precession_of_a_disk():
    mass, radius, gravity, precession, tilt = 1.1, 0.6, 2.0, 1.5, 1.2
    body, across = thin_disk(mass, radius)
    sine, cosine = np.sin(tilt), np.cos(tilt)
    # Balance of momentum about the contact of a disk that precesses steadily (Routh).
    spin = (across * precession**2 * sine * cosine - mass * gravity * radius * cosine) / (
        (2 * across + mass * radius**2) * precession * sine
    )
    start = on_plane((sine, 0.0, cosine), (precession * sine, 0.0, spin))
    period = 2 * np.pi / precession
    motion = integrate(body, Plane(), "marble", Forces(gravity), start, np.linspace(0.0, period, 9))
    np.testing.assert_allclose(motion["gamma"][:, 2], cosine, rtol=0, atol=1e-11)
    np.testing.assert_allclose(motion["omega"][:, 2], spin, rtol=0, atol=1e-11)
    np.testing.assert_allclose(motion["contact"][-1], 0.0, rtol=0, atol=1e-10)
    diameter = 2 * radius * abs(spin - precession * cosine) / precession
    across_circle = np.linalg.norm(motion["contact"][4] - motion["contact"][0])
    assert across_circle == pytest.approx(diameter, abs=1e-10)


# One shape described in two ways


def spheroid(across, along, centre):
    """Ellipsoid of revolution by chi1, chi2."""
    a, c = across**2, along**2

    def size(g3):
        return (a * (1 - g3**2) + c * g3**2) ** 0.5

    return ShapeOfRevolution(
        lambda g3: -a / size(g3),
        lambda g3: -c * g3 / size(g3),
        lambda g3: a * (c - a) * g3 / size(g3) ** 3,
        lambda g3: -c / size(g3) + c * (c - a) * g3**2 / size(g3) ** 3,
        centre,
    )


CENTRE = (0.1, -0.05, 0.15)
QUADRIC = np.diag([1.0, 1.5, 2.0])
TWINS = {
    "ball as ellipsoid": (ball(0.9, CENTRE), ellipsoid((0.9, 0.9, 0.9), 0.4, CENTRE)),
    "spheroid": (ellipsoid((1.0, 1.0, 0.8), 0.7, CENTRE), spheroid(1.0, 0.8, CENTRE)),
    "quadric": (
        ellipsoid((1.0, 1.5**-0.5, 2.0**-0.5), 0.0, CENTRE),
        ImplicitShape(
            lambda s: float(np.exp(s @ QUADRIC @ s - 1) - 1),
            lambda s: 2 * np.exp(s @ QUADRIC @ s - 1) * (QUADRIC @ s),
            lambda s: (
                np.exp(s @ QUADRIC @ s - 1) * (2 * QUADRIC + 4 * np.outer(QUADRIC @ s, QUADRIC @ s))
            ),
            CENTRE,
        ),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("surface", [Plane(), Sphere(2.0), Sphere(-3.0)])
@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("name", TWINS)
def test_two_descriptions_of_a_shape_give_one_motion(name, contact, surface):
    start = without_spin(on_plane((0.3, 0.5, 0.8), (0.6, -0.9, 0.8)))
    inertia = np.array([[0.9, 0.1, 0.05], [0.1, 0.7, -0.08], [0.05, -0.08, 0.5]])
    motions = [
        integrate(
            Body(1.2, inertia, shape, (0.1, 0.2, -0.3)),
            surface,
            contact,
            Forces(1.0),
            start,
            [1.5],
        )
        for shape in TWINS[name]
    ]
    for key in ("omega", "gamma", "centre", "contact_force", "spin_torque"):
        np.testing.assert_allclose(motions[0][key], motions[1][key], rtol=0, atol=1e-11)


@pytest.mark.parametrize("surface", [Plane(), Sphere(2.0), Sphere(-3.0)])
@pytest.mark.parametrize("contact", CONTACTS)
def test_thin_torus_is_a_disk(contact, surface):
    start = without_spin(on_plane((0.8, 0.6, 0.2), (0.6, -0.9, 2.0)))
    body, _ = thin_disk(1.0, 1.0)
    angular, _, _ = acceleration(body, surface, contact, Forces(1.0), start)
    differences = []
    for tube in (1e-3, 1e-4):
        ring = Body(body.mass, body.inertia, torus(1.0 - tube, tube))
        near, _, _ = acceleration(ring, surface, contact, Forces(1.0), start)
        differences.append(np.linalg.norm(near - angular))
    assert differences[0] < 1e-2
    assert differences[1] == pytest.approx(differences[0] / 10, rel=0.05)


# Supports and forces


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_large_sphere_is_nearly_a_plane(side, contact):
    start = without_spin(on_plane((0.3, 0.5, 0.8), (0.6, -0.9, 0.8)))
    body = Body(1.2, np.diag([0.9, 0.7, 0.5]), ellipsoid((1.0, 1.2, 0.9), 0.3, CENTRE))
    flat, _, _ = acceleration(body, Plane(), contact, Forces(1.0), start)
    differences = []
    for radius in (1e3, 1e4):
        curved, _, _ = acceleration(body, Sphere(side * radius), contact, Forces(1.0), start)
        differences.append(np.linalg.norm(curved - flat))
    assert differences[0] < 1e-2
    assert differences[1] == pytest.approx(differences[0] / 10, rel=0.05)


@pytest.mark.parametrize("contact", CONTACTS)
def test_gravity_on_a_plane_is_a_potential_of_gamma(contact):
    mass, gravity = 1.2, 1.7
    shape = ellipsoid((1.0, 1.2, 0.9), 0.3, CENTRE)
    body = Body(mass, np.diag([0.9, 0.7, 0.5]), shape)
    start = without_spin(on_plane((0.3, 0.5, 0.8), (0.6, -0.9, 0.8)))

    def arm(gamma):
        return np.asarray(CENTRE) + shape.touching(gamma / np.linalg.norm(gamma))

    height = Forces(
        U=lambda gamma: -mass * gravity * float(arm(gamma) @ gamma),
        dU=lambda gamma: -mass * gravity * arm(gamma),
    )
    heavy = acceleration(body, Plane(), contact, Forces(gravity), start)
    potential = acceleration(body, Plane(), contact, height, start)
    np.testing.assert_allclose(potential[0], heavy[0], rtol=0, atol=1e-12)
    weight = mass * gravity * start["gamma"]
    np.testing.assert_allclose(heavy[1] - potential[1], weight, rtol=0, atol=1e-12)
    assert potential[2] == pytest.approx(heavy[2], abs=1e-12)


# Starts that are refused


@pytest.mark.parametrize(
    ("change", "contact", "times", "message"),
    [
        ({"gamma": np.array([0.0, 0.0, 1.1])}, "marble", [1.0], "gamma must have unit length"),
        ({"attitude": np.array([0.0, 1.0, 0.0, 0.0])}, "marble", [1.0], "attitude must carry"),
        ({}, "rubber", [1.0], "orthogonal to gamma"),
        ({}, "glue", [1.0], "allowed: marble, rubber"),
        ({}, "marble", [1.0, 0.5], "times must increase"),
    ],
)
def test_bad_start_is_refused(change, contact, times, message):
    start = on_plane(UPRIGHT, (1.0, 0.0, 0.5)) | change
    body = Body(1.0, np.eye(3), ball(1.0))
    with pytest.raises(ValueError, match=message):
        integrate(body, Plane(), contact, Forces(), start, times)


@pytest.mark.parametrize("turn", [0.0, 2.0])
@pytest.mark.parametrize("gamma", [(0.6, 0.0, 0.8), (0.0, 0.0, -1.0), (0.0, 1e-9, -1.0)])
def test_attitude_carries_gamma_to_the_normal(gamma, turn):
    gamma = np.asarray(gamma) / np.linalg.norm(gamma)
    attitude = attitude_with_normal(gamma, turn=turn)
    np.testing.assert_allclose(rotation(attitude) @ gamma, UPRIGHT, rtol=0, atol=1e-14)
    assert np.linalg.norm(attitude) == pytest.approx(1.0, abs=1e-14)
