"""Motions and instants of rolling bodies against the independent reference."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings

import reference
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.vectors import real_symbol, to_components
from mechanics import bodies
from mechanics.bodies import (
    CENTRE,
    FIELD,
    FULL,
    PRINCIPAL,
    ROTORS,
    SHAPES,
    SURFACES,
    portrait,
    state_of,
)
from mechanics.compare import (
    GAMMA,
    XYZ,
    begin,
    deviations,
    draw,
    equations,
    instant_of_package,
    instant_of_reference,
    told_by_package,
    told_by_reference,
    worst,
)
from mechanics.portrait import Portrait, coordinates, directions
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody, rolling_system
from nonholonomic.mechanics.shapes.shapes import Ball, Ellipsoid
from spread import spread

COMBINATIONS = [
    (shape, support, contact, inertia)
    for shape in ("ball centred", *reference.SHAPES)
    for support in reference.SUPPORTS
    for contact in reference.CONTACTS
    for inertia in reference.INERTIAS
    if shape != "hollow ball" or support == "outside"
]

FLAT_SHAPES = ("disk", "torus")

TIMES = np.linspace(0.0, 10.0, 11)


def prepare(shape, support, contact, inertia, seed):
    """A case, the package's equations and its start; a full inertia tensor comes loaded."""
    drawn = draw(shape, support, contact, inertia, seed, loaded=inertia == "turned")
    system = equations(drawn)
    case, state = begin(drawn, system)
    return case, system, state


def compare_motions(case, system, state):
    trajectory = integrate(system, state, TIMES, on_liftoff="warn")
    assert len(trajectory.times) == len(TIMES)
    return deviations(told_by_package(trajectory), told_by_reference(case, case.run(TIMES)))


@pytest.fixture(scope="module", params=COMBINATIONS, ids="-".join)
def prepared(request):
    return prepare(*request.param, seed=1)


@pytest.mark.slow
def test_instant_agrees_with_reference(prepared):
    case, system, state = prepared
    found = instant_of_package(system, state)
    deviation = deviations(found, instant_of_reference(case, system, state))
    assert worst(deviation) < 1e-11, deviation


@pytest.mark.slow
@pytest.mark.parametrize("prepared", spread(COMBINATIONS, 5), ids="-".join, indirect=True)
def test_motion_agrees_with_reference(prepared):
    deviation = compare_motions(*prepared)
    assert worst(deviation) < 1e-10, deviation


@pytest.mark.slow
@pytest.mark.parametrize("seed", [2, 3, 4])
@pytest.mark.parametrize("names", COMBINATIONS, ids="-".join)
def test_more_motions_agree_with_reference(names, seed):
    deviation = compare_motions(*prepare(*names, seed))
    assert worst(deviation) < 1e-10, deviation


@pytest.mark.slow
def test_torus_that_comes_to_lie_on_a_dome_ends_there():
    """On its flat side the contact is no longer one point; the reference gets as far as that."""
    drawn = reference.random_case(np.random.default_rng(1), "torus", "outside", "marble")
    system = equations(drawn)
    case, state = begin(drawn, system)
    trajectory = integrate(system, state, TIMES, on_liftoff="warn")
    end = trajectory.events[-1]
    assert end.is_terminal
    assert end.guard.name == "flat"
    assert trajectory.times[-1] == end.time < 4.0
    motion = case.run(trajectory.times)
    assert np.hypot(*motion["gamma"][-1, :2]) == pytest.approx(1e-6, abs=1e-11)
    deviation = deviations(told_by_package(trajectory), told_by_reference(case, motion))
    assert deviation["omega"] < 1e-10
    assert deviation["attitude"] < 1e-10


# ---------------------------------------------------------------------------------------------
# Whatever rolls: what every motion keeps


@pytest.mark.slow
@pytest.mark.parametrize("contact", reference.CONTACTS)
@pytest.mark.parametrize(("shape", "surface"), bodies.COMBINATIONS)
@given(omega=coordinates, gamma=directions, zeta=directions)
@settings(max_examples=25)
def test_energy_and_relations_are_kept(shape, surface, contact, omega, gamma, zeta):
    one = portrait(shape, surface, contact)
    assume(shape not in FLAT_SHAPES or np.hypot(gamma[0], gamma[1]) > 0.1)
    state = state_of(one, 3 * omega, gamma, zeta)
    here, rates = one.at(state), one.along(state)
    size = 1 + max(np.abs(here[f"rate of {name}"]).max() for name in one.system.state)
    for name in [name for name in here if name.startswith("relation")]:
        assert abs(here[name][0]) < 1e-12
        assert abs(rates[name][0]) < 1e-11 * size
    assert abs(rates["energy"][0]) < 1e-11 * size * (1 + abs(here["energy"][0]))


# ---------------------------------------------------------------------------------------------
# One body described in two ways


TELLING = ("omegadot", "N", "M", "omega", "rate of gamma")
TURN = reference.rotation(np.array([0.6, -0.3, 0.5, 0.4]))
QUARTER = reference.rotation(np.array([np.cos(0.2), 0.0, 0.0, np.sin(0.2)]))
SLOPE, AXIS = np.array([0.4, -0.2, 0.3]), np.array([0.5, 0.1, -0.6])


def field_along(slope, axis):
    """Gravity and the potential (slope, gamma) + (axis, gamma)^2."""
    linear, square = (
        sum(float(x) * s for x, s in zip(v, GAMMA, strict=True)) for v in (slope, axis)
    )
    return Forces(1.7, linear + square**2)


def turned_pair(turn, shape, turned_shape, surface, contact):
    """One body in two sets of body axes; `turn` takes the first components to the second."""
    inertia = turn @ np.diag(PRINCIPAL) @ turn.T
    bodies = (
        (Body(1.3, PRINCIPAL, shape, ROTORS), field_along(SLOPE, AXIS)),
        (Body(1.3, inertia, turned_shape, turn @ ROTORS), field_along(turn @ SLOPE, turn @ AXIS)),
    )
    return [
        Portrait(rolling_system(body, SURFACES[surface], contact, field)) for body, field in bodies
    ]


AXES_TURNS = {
    "ball": (TURN, Ball(0.9, centre=CENTRE), Ball(0.9, centre=tuple(TURN @ CENTRE))),
    "ellipsoid": (
        QUARTER,
        Ellipsoid((1.2, 0.9, 0.8), centre=CENTRE),
        Ellipsoid((1.2, 0.9, 0.8), turn=0.4, centre=tuple(QUARTER @ CENTRE)),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("contact", reference.CONTACTS)
@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("name", AXES_TURNS)
def test_motion_does_not_depend_on_body_axes(name, surface, contact):
    """Principal axes against any others, with a full tensor of inertia."""
    turn = AXES_TURNS[name][0]
    one, other = turned_pair(*AXES_TURNS[name], surface, contact)

    @given(omega=coordinates, gamma=directions, zeta=directions)
    @settings(max_examples=15, database=None)
    def compare(omega, gamma, zeta):
        if contact == "rubber":
            omega = omega - (omega @ gamma) * gamma
        vectors = {"omega": omega, "gamma": gamma, "zeta": zeta}
        first = one.at(one.state(**vectors))
        second = other.at(other.state(**{k: turn @ v for k, v in vectors.items()}))
        for quantity in TELLING:
            expected = turn @ first[quantity]
            scale = 1 + np.abs(expected).max()
            assert np.abs(second[quantity] - expected).max() < 1e-12 * scale
        assert second["energy"] == pytest.approx(first["energy"], rel=1e-12, abs=1e-12)

    compare()


@pytest.mark.parametrize("contact", reference.CONTACTS)
@pytest.mark.parametrize("surface", SURFACES)
@given(omega=coordinates, gamma=directions, zeta=directions)
@settings(max_examples=10)
def test_rotors_at_rest_are_none(surface, contact, omega, gamma, zeta):
    if (surface, contact) not in RESTING:
        RESTING[surface, contact] = [
            Portrait(
                rolling_system(
                    Body(1.3, FULL, SHAPES["ball"], rotors), SURFACES[surface], contact, FIELD
                )
            )
            for rotors in ((0.0, 0.0, 0.0), ROTORS)
        ]
    if contact == "rubber":
        omega = omega - (omega @ gamma) * gamma
    none, rotors = RESTING[surface, contact]
    rest = {f"k_{i}": 0.0 for i in (1, 2, 3)}
    expected = none.at(none.state(omega=omega, gamma=gamma, zeta=zeta))
    found = rotors.at(rotors.state(rest, omega=omega, gamma=gamma, zeta=zeta), rest)
    for name in (*TELLING, "energy"):
        assert np.abs(found[name] - expected[name]).max() < 1e-13 * (1 + np.abs(found[name]).max())


RESTING: dict[tuple[str, str], list[Portrait]] = {}


# ---------------------------------------------------------------------------------------------
# What the System is made of


@pytest.mark.parametrize("contact", reference.CONTACTS)
@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("shape", ["ball", "implicit"])
@pytest.mark.parametrize("gravity", [0.0, 9.81])
def test_state_has_what_it_needs(shape, surface, contact, gravity):
    system = rolling_system(
        Body(1.3, FULL, SHAPES[shape]), SURFACES[surface], contact, Forces(gravity)
    )
    expected = ["M" if contact == "marble" else "omega", "r" if shape == "implicit" else "gamma"]
    if gravity and surface != "plane":
        expected.append("zeta")
    assert [str(name) for name in system.state] == expected
    lift = ["attitude", "place"] if surface == "plane" else ["attitude"]
    assert [str(name) for name in system.lifted().state] == expected + lift
    assert ("contact" in {guard.name for guard in system.guards}) == bool(gravity)
    parameters = {str(symbol) for symbol in system.defaults}
    assert ("g" in parameters) == bool(gravity)
    assert not any(name.startswith("k_") for name in parameters)


def test_rolling_keeps_what_rolls_on_what():
    body, surface, field = Body(1.3, FULL, SHAPES["ball"], ROTORS), SURFACES["inside"], FIELD
    kept = RollingBody(body, surface, "rubber", field).system("name", "Title")
    made = rolling_system(body, surface, "rubber", field, "name", "Title")
    assert kept == made
    assert (kept.name, kept.title) == ("name", "Title")
    assert kept.defaults == made.defaults


def test_potential_may_use_the_parameters_of_the_body():
    strength = sp.Symbol("strength", real=True)
    moment, mass = sp.symbols("I_1 m", real=True)
    potential = strength * moment * mass * GAMMA[2]
    system = rolling_system(
        Body(2.0, PRINCIPAL, SHAPES["ball"]),
        field=Forces(potential=potential, parameters={strength: 0.5}),
    )
    one = Portrait(system)
    here = one.at(one.state(gamma=np.array([0.0, 0.6, 0.8])))
    assert here["energy"][0] == pytest.approx(0.5 * PRINCIPAL[0] * 2.0 * 0.8, rel=1e-14)


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("shape", ["ball", "ellipsoid", "implicit"])
def test_constant_potential_moves_nothing(shape, surface):
    body = Body(1.3, FULL, SHAPES[shape])
    free, constant = (
        rolling_system(body, SURFACES[surface], field=Forces(potential=value))
        for value in (sp.S.Zero, sp.Integer(2))
    )
    assert constant.rates == free.rates
    (difference,) = {
        to_components(one.value) - to_components(other.value)
        for one, other in zip(constant.laws, free.laws, strict=True)
    }
    assert difference == real_symbol("U")


MISTAKES = {
    "contact": (
        lambda: rolling_system(Body(1.0, PRINCIPAL, Ball(1.0)), contact="glue"),
        "contact must be 'marble' or 'rubber', not the text 'glue'",
    ),
    "gravity": (lambda: Forces(-9.81), "gravity -9.81: it must be finite and not negative"),
    "infinite gravity": (lambda: Forces(np.inf), "gravity inf: it must be finite and not negative"),
    "symbol of a potential": (
        lambda: rolling_system(
            Body(1.0, PRINCIPAL, Ball(1.0)),
            field=Forces(1.0, XYZ[0] * GAMMA[0] + sp.Symbol("depth")),
        ),
        "depth, x is not known; it may use gamma_1, gamma_2, gamma_3 and m, I_1, I_2, I_3, R, g",
    ),
    "parameter of a potential": (
        lambda: Forces(1.0, XYZ[0] * GAMMA[0], {XYZ[0]: np.nan}),
        "parameter x = nan: it must be a finite number",
    ),
    "name in use": (
        lambda: rolling_system(
            Body(1.0, PRINCIPAL, Ball(1.0)),
            field=Forces(1.0, real_symbol("m") * GAMMA[0], {real_symbol("m"): 2.0}),
        ),
        "m stands for two things",
    ),
}


@pytest.mark.parametrize(("make", "message"), MISTAKES.values(), ids=MISTAKES)
def test_mistake_is_named(make, message):
    with pytest.raises(InputError, match=re.escape(message)):
        make()
