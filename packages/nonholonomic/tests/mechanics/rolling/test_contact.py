"""Kinematics of the contact: for every shape on every surface, at random states."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings

from flowlanes.errors import InputError
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.vectors import Vector, constant, dot, real_symbol, to_components
from mechanics.bodies import (
    CENTRE,
    COMBINATIONS,
    FULL,
    SHAPES,
    SURFACES,
    on_quartic,
    portrait,
    state_of,
)
from mechanics.compare import GAMMA, XYZ
from mechanics.portrait import Portrait, coordinates, directions
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.contact import contact
from nonholonomic.mechanics.rolling.equations import rolling_system
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from nonholonomic.starts import initial_state

X, Y, Z = XYZ

every_contact = pytest.mark.parametrize(("shape", "surface"), COMBINATIONS)
random_states = given(omega=coordinates, gamma=directions, zeta=directions)
few = settings(max_examples=20)


def close(found, expected, size=0.0):
    return np.abs(found - expected).max() < 1e-11 * (1 + size + np.abs(expected).max())


def standing(shape, gamma):
    """Disks and tori are looked at on their edges."""
    return shape not in ("disk", "torus") or np.hypot(gamma[0], gamma[1]) > 0.1


@pytest.mark.slow
@every_contact
@random_states
@few
def test_contact_point_wanders_as_fast_over_the_body_as_over_the_surface(
    shape, surface, omega, gamma, zeta
):
    assume(standing(shape, gamma))
    one = portrait(shape, surface, "marble")
    state = state_of(one, omega, gamma, zeta)
    here, rates = one.at(state), one.along(state)
    curvature = 0 if surface == "plane" else 1 / SURFACES[surface].signed_radius
    normal, gammadot, rdot = here["gamma"], here["touch gammadot"], here["touch rdot"]
    size = np.abs(rdot).max()
    assert close(gammadot + np.cross(here["omega"], normal), curvature * rdot, size)
    assert close(rates["touch r"], rdot)
    assert close(rates["gamma"], gammadot, size)
    assert abs(rdot @ normal) < 1e-11 * (1 + size)


@pytest.mark.slow
@every_contact
@random_states
@few
def test_lengths_of_the_contact_vector(shape, surface, omega, gamma, zeta):
    assume(standing(shape, gamma))
    one = portrait(shape, surface, "rubber")
    here = one.at(state_of(one, omega, gamma, zeta))
    r = here["touch r"]
    assert here["square"][0] == pytest.approx(r @ r, rel=1e-13)
    assert here["height"][0] == pytest.approx(-r @ here["gamma"], rel=1e-12, abs=1e-13)


@pytest.mark.slow
@every_contact
@random_states
@few
def test_torque_of_a_potential_takes_its_energy(shape, surface, omega, gamma, zeta):
    """The power of the torque gamma x pull(dU) is -dU/dt, for whatever gradient."""
    assume(standing(shape, gamma))
    one = pulled(shape, surface)
    here = one.at(state_of(one, omega, gamma, zeta))
    power = np.cross(here["gamma"], here["pull"]) @ here["omega"]
    size = 1 + np.abs(here["gammadot of contact"]).max()
    assert abs(power + SLOPE @ here["gammadot of contact"]) < 1e-11 * size


SLOPE = np.array([0.7, -0.3, 0.5])
PULLED: dict[tuple[str, str], Portrait] = {}


def pulled(shape, surface):
    """A body without field, with the pull of a constant gradient told."""
    if (shape, surface) not in PULLED:
        touch = contact(SHAPES[shape], SURFACES[surface])
        further = {
            "pull": touch.pull(constant(SLOPE.tolist())),
            "gammadot of contact": touch.gammadot,
        }
        system = rolling_system(Body(1.3, FULL, SHAPES[shape]), SURFACES[surface], "marble")
        PULLED[shape, surface] = Portrait(system, further)
    return PULLED[shape, surface]


# ---------------------------------------------------------------------------------------------
# With slip, and with a sphere through the nearest point

SLIP, RADIUS = Vector("slip"), real_symbol("radius")


@cache
def slipping(shape, surface):
    """The contact with slip as a function of position, ω, slip and the radius of the support."""
    radius = {} if surface == "plane" else {"radius": RADIUS}
    touch = contact(SHAPES[shape], SURFACES[surface], SLIP, **radius)
    (place, _), *_ = touch.state
    other = Vector("other")
    formulas = [touch.gammadot, touch.rdot, Vector("gamma"), touch.spread(touch.gammadot)]
    formulas += [constant([dot(other, touch.spread(SLIP)), dot(SLIP, touch.spread(other)), 0])]
    scalars = [x for f in formulas for x in to_components(constant(list(to_components(f))))]
    names = [*place.symbols, *Vector("omega").symbols, *SLIP.symbols, *other.symbols, RADIUS]
    names += [p.symbol for p in touch.parameters]
    steps = list(flat_pairs(touch.definitions))
    function = sp.lambdify(names, scalars, "numpy", cse=lambda e: (steps, e))
    return function, [p.default for p in touch.parameters]


def slipping_at(shape, surface, direction, radius, random):
    function, constants = slipping(shape, surface)
    place = direction
    if shape == "implicit":
        place = np.array(CENTRE) + on_quartic(direction)
    empty = np.zeros(9)
    normal = np.reshape(function(*place, *empty, radius, *constants), (5, 3))[2]
    across = np.eye(3) - np.outer(normal, normal)
    omega, slip, other = (
        random.normal(size=3),
        across @ random.normal(size=3),
        random.normal(size=3),
    )
    found = function(*place, *omega, *slip, *(across @ other), radius, *constants)
    return omega, slip, np.reshape(found, (5, 3))


@pytest.mark.parametrize(("shape", "surface"), COMBINATIONS)
def test_contact_point_wanders_with_the_slip(shape, surface):
    """a(γ̇ + ω×γ) = ṙ + u, ṙ = −W γ̇, on a sphere of any radius; on a plane γ is at rest."""
    random = np.random.default_rng(7)
    for scale in (1.0, 1.3):
        direction = np.array([0.5, -0.4, 0.6]) / np.linalg.norm([0.5, -0.4, 0.6])
        a = 1.0 if surface == "plane" else scale * SURFACES[surface].signed_radius
        if shape == "hollow ball" and scale > 1:
            continue
        omega, slip, found = slipping_at(shape, surface, direction, a, random)
        gammadot, rdot, normal, spread, symmetric = found
        over = 0 if surface == "plane" else (rdot + slip) / a
        size = 1 + np.abs(found).max()
        np.testing.assert_allclose(gammadot + np.cross(omega, normal), over, atol=1e-13 * size)
        np.testing.assert_allclose(spread, -rdot, atol=1e-13 * size)
        assert symmetric[0] == pytest.approx(symmetric[1], rel=1e-12)


# ---------------------------------------------------------------------------------------------
# A plane is a sphere of infinite radius


@pytest.mark.slow
@pytest.mark.parametrize("contact_model", ["marble", "rubber"])
@pytest.mark.parametrize("shape", [name for name in SHAPES if name != "hollow ball"])
@given(omega=coordinates, gamma=directions)
@settings(max_examples=10)
def test_large_sphere_is_a_plane(shape, contact_model, omega, gamma):
    assume(standing(shape, gamma))
    plane, sphere = (portrait(shape, name, contact_model) for name in ("plane", "outside"))
    flat = plane.at(state_of(plane, omega, gamma, gamma))
    omega, upright = flat["omega"], flat["gamma"]
    curved = {
        radius: sphere.at(
            sphere.state(
                {"a": radius}, omega=omega, gamma=upright, r=flat["touch r"], zeta=upright
            ),
            {"a": radius},
        )
        for radius in (1e9, -1e9)
    }
    for name in ("omegadot", "N", "touch rdot", "touch gammadot"):
        for sentence in curved.values():
            assert np.abs(sentence[name] - flat[name]).max() < 1e-6 * (1 + np.abs(flat[name]).max())


# ---------------------------------------------------------------------------------------------
# Which bodies fit


HOLLOW = "rolls around the outside of a sphere of positive, smaller radius"


@pytest.mark.parametrize("surface", [Plane(), Sphere(1.0, side="inside"), Sphere(2.0), Sphere(3.0)])
def test_hollow_ball_goes_around_a_smaller_sphere(surface):
    with pytest.raises(InputError, match=f"hollow ball of radius 2: it {HOLLOW}"):
        contact(Ball(2.0, hollow=True), surface)


@pytest.mark.parametrize("radius", [-0.5, -1.0])
def test_ball_rolls_in_a_larger_bowl(radius):
    message = f"ball of radius 1 in a bowl of radius {-radius:g}: the bowl must be the larger one"
    with pytest.raises(InputError, match=message):
        contact(Ball(1.0), Sphere.of_signed_radius(radius))


LARGE = {
    "ellipsoid": Ellipsoid((1.0, 1.2, 0.9)),
    "revolution": ShapeOfRevolution(1 + GAMMA[2] ** 2 / 10),
    "implicit": ImplicitShape(X**2 + 2 * Y**2 + Z**2 - 1),
}


@pytest.mark.parametrize("shape", LARGE.values(), ids=LARGE)
def test_body_larger_than_its_bowl_is_refused_at_the_start(shape):
    """Both radii of curvature exceed that of the bowl, so that their product alone looks right."""
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), shape), Sphere(0.4, side="inside"))
    with pytest.raises(InputError, match="the body does not fit into the sphere at the contact"):
        initial_state(system, (1.0, 0.0, 0.0), (0.3, 0.2, 0.9))


@pytest.mark.parametrize("shape", [Disk(1.0), Torus(0.8, 0.2)], ids=["disk", "torus"])
@pytest.mark.parametrize(("lean", "fits"), [(0.3, False), (0.7, True)])
def test_edge_in_a_bowl_fits_where_it_stands_steeply(shape, lean, fits):
    """The edge touches all around where the sine of its lean is R/(|a| - rho): here 1/2."""
    tube = getattr(shape, "tube", 0.0)
    system = rolling_system(
        Body(1.0, (1.0, 1.0, 1.0), shape), Sphere(2 * shape.radius + tube, side="inside")
    )
    values = [guard.value for guard in system.guards if guard.name == "fits"]
    one = Portrait(system, {f"fits {i}": value for i, value in enumerate(values)})
    gamma = np.array([lean, 0.0, np.sqrt(1 - lean**2)])
    here = one.at(one.state(gamma=gamma))
    assert (here["fits 0"][0] > 0 and here["fits 1"][0] > 0) == fits


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("shape", ["ball", "ellipsoid", "implicit"])
def test_radius_of_the_sphere_is_a_parameter(shape, surface):
    touch = contact(SHAPES[shape], SURFACES[surface])
    radii = [p.default for p in touch.parameters if str(p.symbol) == "a"]
    assert radii == ([] if surface == "plane" else [SURFACES[surface].signed_radius])
