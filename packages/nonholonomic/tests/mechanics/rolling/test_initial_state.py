"""Starting states: fifty digits, on the phase space, and what is refused."""

from __future__ import annotations

import ast
import re
from dataclasses import replace

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings

import reference
from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector, real_symbol, to_components
from mechanics.bodies import CENTRE, FIELD, FULL, QUARTIC, SHAPES, SURFACES
from mechanics.compare import XYZ
from mechanics.portrait import coordinates, directions
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.rolling.initial_state import evaluate
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from nonholonomic.starts import initial_state

X, Y, Z = XYZ
MOMENTS = (1.0, 1.2, 1.5)
TINY = mpmath.mpf(10) ** -45


def simple(contact="marble", surface=None, shape=None):
    shape = shape or Ball(0.7, centre=CENTRE)
    return rolling_system(Body(1.3, FULL, shape), surface or Plane(), contact, FIELD)


def read(system, state, name):
    """A state variable, with all its digits."""
    values = dict(zip(system.lifted().symbols, state, strict=True))
    size = 4 if name == "attitude" else 2 if name == "place" else 3
    return [values[s] for s in Vector(name, size).symbols]


def told(system, state, formulas):
    with mpmath.workdps(50):
        known = {s: mpmath.mpf(repr(x)) for s, x in system.defaults.items()}
        known |= dict(zip(system.lifted().symbols, state, strict=True))
        return evaluate(system, [to_components(f) for f in formulas], known)


def observed(system, state, name):
    (value,) = [o.value for o in system.lifted().observables if o.name == name]
    return told(system, state, list(to_components(value)))


def floats(numbers):
    return np.array([float(x) for x in numbers])


# ---------------------------------------------------------------------------------------------
# On the phase space


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("shape", ["ball", "ellipsoid", "revolution", "implicit"])
def test_start_lies_on_the_phase_space_to_45_digits(shape, surface, contact):
    system = simple(contact, SURFACES[surface], SHAPES[shape])
    omega, gamma = (0.4, 0.8, 0.3), (0.36, -0.48, 0.8)
    normal = (0.0, 0.0, 1.0) if surface == "plane" else (0.1, -0.3, 0.9)
    state = initial_state(system, omega, gamma, heading=0.4, normal=normal)
    defects = told(system, state, system.lifted().relations)
    assert max(abs(defect) for defect in defects) < TINY
    spin, found = (told(system, state, [*Vector(name)]) for name in ("omega", "gamma"))
    with mpmath.workdps(50):
        given_spin, given_gamma = ([mpmath.mpf(repr(x)) for x in v] for v in (omega, gamma))
        assert max(abs(x - y) for x, y in zip(spin, given_spin, strict=True)) < TINY
        assert max(abs(x - y) for x, y in zip(found, given_gamma, strict=True)) < TINY


def test_decimals_mean_decimals():
    """0.1 is one tenth, not the nearest binary number."""
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), Ball(1.0)), contact="rubber")
    state = initial_state(system, (0.1, 0.2, 0.0), (0.0, 0.0, 1.0))
    with mpmath.workdps(50):
        tenth = mpmath.mpf(1) / 10
        assert abs(state[0] - tenth) < TINY
        assert abs(state[1] - 2 * tenth) < TINY


def test_numbers_of_many_digits_are_kept():
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), Ball(1.0)), contact="rubber")
    with mpmath.workdps(50):
        third = mpmath.mpf(1) / 3
        state = initial_state(system, (third, 0, 0), (0, 0, 1))
        assert state[0] == third


def test_parameters_replace_the_defaults():
    system = simple()
    start = {"omega": (0.3, -0.7, 0.4), "gamma": (0.0, 0.6, 0.8)}
    mass = real_symbol("m")
    light = initial_state(system, **start)
    heavy = initial_state(system, **start, parameters={mass: 2.6})
    arm = np.array(CENTRE) - 0.7 * np.array(start["gamma"])
    orbital = np.cross(arm, np.cross(start["omega"], arm))
    change = floats(heavy[:3]) - floats(light[:3])
    np.testing.assert_allclose(change, 1.3 * orbital, rtol=0, atol=1e-15)


# ---------------------------------------------------------------------------------------------
# In space


@pytest.mark.slow
@given(gamma=directions, normal=directions)
@settings(max_examples=15)
def test_attitude_carries_the_normal_and_heading_turns_about_it(gamma, normal):
    system = rolling_system(Body(1.0, MOMENTS, Ball(1.0)), Sphere(2.0), "marble", Forces(1.0))
    for heading in (0.0, 1.1):
        state = initial_state(system, (0.0, 0.0, 0.0), gamma, heading=heading, normal=normal)
        found = floats(read(system, state, "attitude"))
        short = reference.attitude_with_normal(gamma, normal, heading)
        np.testing.assert_allclose(reference.rotation(found) @ gamma, normal, rtol=0, atol=1e-14)
        assert abs(abs(found @ short) - 1) < 1e-12
        vertical = floats(read(system, state, "zeta"))
        np.testing.assert_allclose(vertical, reference.rotation(found)[2], rtol=0, atol=1e-15)


@pytest.mark.parametrize("gamma", [(0.0, 0.0, -1.0), (0.0, 1e-30, -1.0), (0.6, 0.0, -0.8)])
@pytest.mark.parametrize("heading", [0.0, 2.0])
def test_upside_down_start(gamma, heading):
    """The shortest way from a direction to its opposite is not unique, but there is one."""
    system = simple()
    state = initial_state(system, (0.1, 0.2, 0.3), gamma, heading=heading)
    turn = reference.rotation(floats(read(system, state, "attitude")))
    np.testing.assert_allclose(turn @ np.array(gamma), (0.0, 0.0, 1.0), rtol=0, atol=1e-15)
    assert max(abs(x) for x in told(system, state, system.lifted().relations)) < 1e-19


@pytest.mark.parametrize("shape", ["ball", "ellipsoid", "implicit"])
def test_contact_on_a_plane_begins_at_the_origin(shape):
    system = simple(shape=SHAPES[shape])
    state = initial_state(system, (0.1, 0.2, 0.3), (0.3, -0.2, 0.7), heading=0.8)
    assert max(abs(x) for x in observed(system, state, "contact")) < TINY
    height = observed(system, state, "centre")[2]
    assert height > 0.5


def test_contact_on_a_sphere_begins_at_the_normal():
    system = simple(surface=Sphere(2.5, side="inside"))
    normal = np.array([0.36, 0.48, -0.8])
    state = initial_state(system, (0.1, 0.2, 0.3), (0.3, -0.2, 0.7), normal=normal)
    found = floats(observed(system, state, "contact"))
    np.testing.assert_allclose(found, -2.5 * normal, rtol=0, atol=1e-15)


# ---------------------------------------------------------------------------------------------
# Spin


@pytest.mark.slow
@given(omega=coordinates, gamma=directions)
@settings(max_examples=25)
def test_nearest_admissible_omega_is_named_and_accepted(omega, gamma):
    system = rolling_system(Body(1.0, MOMENTS, Ball(1.0)), contact="rubber")
    spin = omega + gamma
    excess = spin @ gamma
    if abs(excess) < 1e-6:
        return
    with pytest.raises(InputError) as refused:
        initial_state(system, spin, gamma)
    message = str(refused.value)
    assert "a body that must not spin about the normal needs 0" in message
    shown = message.partition("the nearest admissible omega is ")[2]
    nearest = np.array(ast.literal_eval(shown))
    np.testing.assert_allclose(nearest, spin - excess * gamma, rtol=0, atol=1e-14)
    state = initial_state(system, nearest, gamma)
    assert abs(told(system, state, [system.relations[1]])[0]) < TINY


def test_spin_of_rounding_is_taken_out():
    system = rolling_system(Body(1.0, MOMENTS, Ball(1.0)), contact="rubber")
    state = initial_state(system, (1.0, 0.0, 1e-13), (0.0, 0.0, 1.0))
    assert abs(state[2]) < TINY


def test_marble_may_spin():
    system = simple()
    state = initial_state(system, (0.0, 0.0, 5.0), (0.0, 0.0, 1.0))
    spin = told(system, state, [*Vector("omega")])
    assert abs(spin[2] - 5) < TINY


# ---------------------------------------------------------------------------------------------
# Contact points of implicit bodies


@pytest.mark.slow
@given(gamma=directions)
@settings(max_examples=15)
def test_contact_point_of_an_implicit_body(gamma):
    """The gradient is opposite to gamma, on the surface."""
    system = simple(shape=SHAPES["implicit"])
    state = initial_state(system, (0.0, 0.0, 0.0), gamma)
    s = floats(read(system, state, "r")) - CENTRE
    gradient = np.array([float(QUARTIC.diff(v).subs(dict(zip(XYZ, s, strict=True)))) for v in XYZ])
    np.testing.assert_allclose(gradient / np.linalg.norm(gradient), -gamma, rtol=0, atol=1e-13)
    assert abs(float(QUARTIC.subs(dict(zip(XYZ, s, strict=True))))) < 1e-14


def test_very_long_body_has_its_contact_point():
    axes = (20.0, 1.0, 0.2)
    form = sum((v / sp.Rational(str(x))) ** 2 for v, x in zip(XYZ, axes, strict=True)) - 1
    gamma = np.array([0.02, 0.6, 0.8])
    gamma /= np.linalg.norm(gamma)
    system = rolling_system(Body(1.0, MOMENTS, ImplicitShape(form)))
    state = initial_state(system, (0.0, 0.0, 0.0), gamma)
    squares = np.array(axes) ** 2
    expected = -squares * gamma / np.sqrt(gamma @ (squares * gamma))
    np.testing.assert_allclose(floats(read(system, state, "r")), expected, rtol=1e-13)


# ---------------------------------------------------------------------------------------------
# Wrong input


CUBE = ImplicitShape(X**4 + Y**4 + Z**4 - 1)
NO_CONTACT = (
    "gamma: no contact point with this normal was found; the surface must be smooth and strictly "
    "convex there"
)

MISTAKES = {
    "zero gamma": ({"gamma": (0.0, 0.0, 0.0)}, "gamma is zero: it must point along the normal"),
    "zero normal": ({"normal": (0.0, 0.0, 0.0)}, "normal is zero: it must point along the normal"),
    "two numbers": ({"omega": (1.0, 2.0)}, "omega: three numbers are needed, not 2"),
    "four numbers": ({"gamma": (1.0,) * 4}, "gamma: three numbers are needed, not 4"),
    "infinite omega": (
        {"omega": (1.0, np.inf, 0.0)},
        "omega (1.0, inf, 0.0): all three numbers must be finite",
    ),
    "gamma that is no number": (
        {"gamma": (np.nan, 0.0, 1.0)},
        "gamma (nan, 0.0, 1.0): all three numbers must be finite",
    ),
}


@pytest.mark.parametrize(("wrong", "message"), MISTAKES.values(), ids=MISTAKES)
def test_mistake_is_named(wrong, message):
    right = {"omega": (0.1, 0.2, 0.3), "gamma": (0.0, 0.0, 1.0)}
    with pytest.raises(InputError, match=re.escape(message)):
        initial_state(simple(), **(right | wrong))


def test_spin_is_refused_with_its_amount():
    system = rolling_system(Body(1.0, MOMENTS, Ball(1.0)), contact="rubber")
    message = (
        "omega: (omega, gamma) = 0.5, and a body that must not spin about the normal needs 0; "
        "the nearest admissible omega is [1.0, 0.0, 0.0]"
    )
    with pytest.raises(InputError, match=re.escape(message)):
        initial_state(system, (1.0, 0.0, 0.5), (0.0, 0.0, 2.0))


@pytest.mark.parametrize("axis", range(3))
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_contact_at_a_flat_point_is_refused(axis, side):
    """x^4 + y^4 + z^4 = 1 is flat where an axis meets it."""
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), CUBE))
    gamma = side * np.eye(3)[axis]
    with pytest.raises(InputError, match=re.escape(NO_CONTACT)):
        initial_state(system, (0.1, 0.2, 0.3), gamma)


def test_contact_near_a_flat_point_is_found():
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), CUBE))
    gamma = np.array([1e-3, -2e-3, 1.0])
    gamma /= np.linalg.norm(gamma)
    state = initial_state(system, (0.1, 0.2, 0.3), gamma)
    r = floats(read(system, state, "r"))
    np.testing.assert_allclose(r**3 / np.linalg.norm(r**3), -gamma, rtol=0, atol=1e-14)


@pytest.mark.parametrize("form", [X**2 + Y**2 - 1, Z - 1, X**2 - Y**2 - 1])
def test_open_surface_is_refused(form):
    message = r"it is not closed; in the direction \(.*\) the left side stays negative"
    with pytest.raises(InputError, match=message):
        ImplicitShape(form)


def test_body_outside_the_domain_is_refused():
    system = rolling_system(
        Body(1.0, (1.0, 1.0, 1.0), Ellipsoid((1.0, 1.0, 2.0))), Sphere(3.0, side="inside")
    )
    with pytest.raises(InputError, match="gamma: this start is outside the domain; the body does"):
        initial_state(system, (1.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    assert initial_state(system, (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))


def test_body_of_revolution_does_not_start_on_a_flat_face():
    """A disk thickened by a ball, by its support function: its curvature at the pole is none."""
    rim = sp.sqrt(1 - Vector("gamma").symbols[2] ** 2)
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), ShapeOfRevolution(rim + sp.Rational(1, 5))))
    with pytest.raises(InputError, match="the contact leaves the convex part of the body"):
        initial_state(system, (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))


def test_system_with_more_to_its_state_is_refused():
    """A start gives omega and gamma; here one more angle would be needed."""
    system = simple()
    angle = real_symbol("angle")
    wider = replace(system, field=(*system.field, (angle, sp.S.One)), name="wider")
    with pytest.raises(InputError, match=r"wider: omega and gamma, .*, do not determine angle"):
        initial_state(wider, (0.1, 0.2, 0.3), (0.0, 0.0, 1.0))


@pytest.mark.parametrize(
    ("name", "missing"),
    [
        ("rubber-ball-sphero-conical", "xi, eta, p_xi, p_eta; give a state by name"),
        ("chaplygin-ball-angles", "theta, phi"),
        ("rubber-ball-on-cone", "R"),
    ],
)
def test_states_in_other_variables_are_refused(name: str, missing: str) -> None:
    """φ and η are numbers elsewhere; here they are symbols without a value."""
    with pytest.raises(
        InputError,
        match=f"{name}: omega and gamma, .*, do not determine {missing}",
    ):
        initial_state(from_catalogue(name), (0.3, -0.7, 1.1), (0.2, 0.5, 0.84))
