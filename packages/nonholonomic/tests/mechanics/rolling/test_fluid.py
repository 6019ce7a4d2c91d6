"""Rolling bodies with fluid in cavities, against the unreduced equations and in their limits."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from flowlanes import Isomorphism
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Integral
from flowlanes.system.vectors import Diagonal, Vector, cross, dot, real_symbol, to_components
from lawproof import prove
from mechanics.rolling.fluid_reference import Chamber, Filled, turn_of
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.cavity import Cavity
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.rolling.initial_state import evaluate
from nonholonomic.mechanics.rolling.mechanism import rolling_mechanism
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from nonholonomic.starts import initial_state

x, y, z = (real_symbol(name) for name in "xyz")
GAMMA = np.array([0.2, -0.3, 0.93]) / np.linalg.norm([0.2, -0.3, 0.93])
FULL = ((0.5, 0.05, -0.03), (0.05, 0.6, 0.04), (-0.03, 0.04, 0.7))
CENTRED = Cavity((0.5, 0.4, 0.3), 0.8)
TURNED = Cavity((0.5, 0.4, 0.3), 0.8, (0.9, 0.1, 0.3, -0.2), (0.1, -0.2, 0.05))
SMALL = Cavity((0.2, 0.3, 0.25), 0.3, (0.3, -0.5, 0.2, 0.8), (-0.55, 0.3, -0.25))
UNTIL = 10.0

BODIES = {
    "ball": Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=CENTRED),
    "ball, turned cavity off its centre": Body(
        1.0, FULL, Ball(1.0, centre=(0.05, 0.1, -0.1)), (0.1, 0.2, -0.3), TURNED
    ),
    "ellipsoid": Body(1.0, (0.4, 0.5, 0.6), Ellipsoid((1.0, 0.9, 0.8)), cavity=CENTRED),
    "ellipsoid, two cavities": Body(
        1.0,
        FULL,
        Ellipsoid((1.2, 1.0, 0.9), 0.3, centre=(0.05, 0.1, -0.1)),
        cavity=(TURNED, SMALL),
    ),
}
CASES = [
    (name, contact, gravity)
    for name in BODIES
    for contact in ("marble", "rubber")
    for gravity in (0.0, 2.0)
]


def reference_of(rolling: RollingBody) -> Filled:
    """The unreduced equations of a body."""
    body = rolling.body
    shape = body.shape
    if isinstance(shape, Ball):
        squares = shape.radius**2 * np.eye(3)
    else:
        c, s = np.cos(shape.turn), np.sin(shape.turn)
        Q = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        squares = Q @ np.diag(np.square(shape.axes)) @ Q.T
    chambers = [
        Chamber(c.mass, np.array(c.axes), np.array(c.centre), np.array(c.turn))
        for c in body.cavities
    ]
    return Filled(
        body.mass,
        body.tensor,
        chambers,
        np.array(shape.centre),
        squares,
        rolling.contact == "rubber",
        rolling.field.gravity,
        np.array(body.gyrostat),
        0.0 if isinstance(rolling.surface, Plane) else 1 / rolling.surface.signed_radius,
    )


def omega_of(contact: str) -> np.ndarray:
    """An angular velocity that the contact allows."""
    omega = np.array([0.7, 0.4, 1.1])
    return omega if contact == "marble" else omega - omega @ GAMMA * GAMMA


def start_of(rolling: RollingBody) -> tuple[np.ndarray, list[np.ndarray]]:
    """Angular velocity and motion of the fluids at the start."""
    xi = [np.array([0.5, -0.8, 1.2]), np.array([-0.3, 0.6, 0.4])]
    return omega_of(rolling.contact), xi[: len(rolling.body.cavities)]


def end_of(rolling: RollingBody, until: float = UNTIL) -> dict[str, np.ndarray]:
    """The end of a motion, by the package."""
    omega, xi = start_of(rolling)
    system = rolling.system()
    state = initial_state(system, tuple(omega), tuple(GAMMA), fluid=[tuple(x) for x in xi])
    run = integrate(system, state, [0.0, until], on_liftoff="warn")
    fluids = [o.name for o in system.observables if o.name.startswith("fluid")]
    state_names = set(map(str, system.state))
    values = {
        name: np.array(run[name] if name in state_names else run.records[name])[-1]
        for name in ("omega", "gamma", "centre", *fluids)
    }
    return values | {"fluid": np.array([values.pop(name) for name in fluids])}


def largest_difference(rolling: RollingBody) -> float:
    """Between the package and the unreduced equations, at the end."""
    reference = reference_of(rolling)
    omega, xi = start_of(rolling)
    theirs, ours = reference.motion(reference.start(omega, GAMMA, xi), UNTIL), end_of(rolling)
    return max(float(np.abs(theirs[name] - ours[name]).max()) for name in theirs)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "contact", "gravity"), CASES)
def test_the_motion_is_that_of_the_unreduced_equations(name, contact, gravity):
    rolling = RollingBody(BODIES[name], Plane(), contact, Forces(gravity))
    assert largest_difference(rolling) < 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("gravity", [0.0, 2.0])
def test_so_it_is_on_a_sphere(contact, gravity):
    body = BODIES["ball, turned cavity off its centre"]
    rolling = RollingBody(body, Sphere(3.0), contact, Forces(gravity))
    assert largest_difference(rolling) < 1e-10


def accelerations(rolling, omega, gamma, xi):
    """Omega' and N' by the package, and by the unreduced equations."""
    system = rolling.system()
    start = initial_state(system, tuple(omega), tuple(gamma), fluid=[tuple(x) for x in xi])
    known = dict(zip(system.lifted().symbols, start, strict=True))
    turning = Vector("omegadot").symbols
    circulations = [v for v in system.state if str(v).startswith("N")]
    rates = dict(system.field)
    formulas = [*turning, *(e for v in circulations for e in to_components(rates[v]))]
    numbers = {**known, **{s: mpmath.mpf(v) for s, v in system.defaults.items()}}
    with mpmath.workdps(30):
        ours = np.array([float(x) for x in evaluate(system, formulas, numbers)])
    reference = reference_of(rolling)
    flat = reference.rates(0.0, reference.start(omega, gamma, xi))
    # N = (m/5) det A A^-1 w
    momenta = [
        c.mass / 5 * np.linalg.det(c.A) * c.inverse @ rate
        for c, rate in zip(reference.chambers, flat[18:].reshape(-1, 3), strict=True)
    ]
    return ours, np.concatenate([flat[15:18], *momenta])


NUMBER = st.floats(-1.0, 1.0, allow_nan=False, width=16)
VECTOR = st.tuples(NUMBER, NUMBER, NUMBER)


@settings(max_examples=2)
@given(
    inertia=st.tuples(*3 * [st.floats(0.5, 0.9)]),
    axes=st.tuples(*3 * [st.floats(0.1, 0.4)]),
    turn=st.tuples(*4 * [st.floats(0.1, 1.0)]),
    place=VECTOR,
    spins=st.tuples(VECTOR, VECTOR, VECTOR),
    contact=st.sampled_from(["marble", "rubber"]),
    ball=st.booleans(),
)
def test_accelerations_of_any_body(inertia, axes, turn, place, spins, contact, ball):
    shape = Ball(1.0, centre=(0.1, 0.0, -0.1)) if ball else Ellipsoid((1.2, 1.0, 0.9), 0.3)
    cavity = Cavity(axes, 0.7, turn, tuple(0.2 * x for x in place))
    body = Body(1.0, inertia, shape, spins[2], cavity)
    omega, xi = np.array(spins[0]), np.array(spins[1])
    if contact == "rubber":
        omega = omega - omega @ GAMMA * GAMMA
    ours, theirs = accelerations(
        RollingBody(body, Plane(), contact, Forces(1.0)), omega, GAMMA, [xi]
    )
    assert np.abs(ours - theirs).max() < 1e-12


# --- the same from the Lagrangian ----------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_poincares_equations_are_carried_onto_them(contact):
    """Those of the Lagrangian in omega, v, xi, multipliers eliminated: proven."""
    body = Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), (0.1, 0.2, 0.3), CENTRED)
    rolling = RollingBody(body, Plane(), contact, Forces(9.81))
    closed = rolling.system()
    moving = {Vector("fluid"): Vector("xi")}
    same = {n: n for n in closed.state} | {
        n: f.xreplace(moving) for n, f in closed.conventions.start_formulas
    }
    radius = dot(-real_symbol("R") * Vector("gamma"), Vector("gamma"))
    law = Isomorphism("same motion", closed, same, level=(real_symbol("R_3") + radius,))
    assert prove(equations_of_motion(rolling_mechanism(rolling)), law).decision == "proven"


def test_with_helmholtz_turned_around_a_sphere_does_not_decouple():
    """The sign of Ṅ = ξ×N: the vorticity in a sphere is fixed in space only with the right one."""
    body = Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=Cavity((0.4, 0.4, 0.4), 0.8))
    system = RollingBody(body, Plane(), "marble").system()
    N, xi = Vector("N"), Vector("xi")
    assert dict(system.field)[N] == cross(xi, N)
    C_is_one = tuple(s - 1 for s in Diagonal("C").symbols)
    alike = tuple(s - t for s, t in pairwise(Diagonal("W").symbols))
    vorticity = Integral("vorticity", dot(N, Vector("gamma")), level=(*C_is_one, *alike))
    assert prove(system, vorticity).decision == "proven"
    wrong = replace(system, field={**dict(system.field), N: cross(N, xi)})
    assert prove(wrong, vorticity).decision == "refuted"


# --- limits --------------------------------------------------------------------------------


def motion(body, contact, fluid, gravity=2.0, until=5.0):
    """Omega, gamma and M along a motion, and what is recorded of the fluid."""
    rolling = RollingBody(body, Plane(), contact, Forces(gravity))
    system = rolling.system()
    state = initial_state(system, tuple(omega_of(contact)), tuple(GAMMA), fluid=fluid)
    run = integrate(system, state, [0.0, until / 2, until], on_liftoff="warn")
    names = set(map(str, system.state))
    return {
        name: np.array(run[name] if name in names else run.records[name])
        for name in ("omega", "gamma", "M", "centre", "N", "fluid", "attitude")
        if name in names | run.records.keys()
    }


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_an_empty_cavity_is_none(contact):
    empty = Cavity((0.5, 0.4, 0.3), 0.0, (0.9, 0.1, 0.3, -0.2), (0.1, -0.2, 0.05))
    shape = Ellipsoid((1.2, 1.0, 0.9), 0.3)
    dry, with_it = Body(1.0, FULL, shape), Body(1.0, FULL, shape, cavity=empty)
    assert (
        RollingBody(dry, Plane(), contact).system()
        == RollingBody(with_it, Plane(), contact).system()
    )


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_little_fluid_does_little(contact):
    """The limit of an empty cavity: the difference falls as the mass of the fluid."""
    shape = Ellipsoid((1.2, 1.0, 0.9), 0.3)
    dry = motion(Body(1.0, FULL, shape), contact, ())["omega"]
    differences = [
        np.abs(
            motion(Body(1.0, FULL, shape, cavity=cavity), contact, (0.5, -0.8, 1.2))["omega"] - dry
        )
        for cavity in (Cavity((0.5, 0.4, 0.3), mass) for mass in (1e-6, 1e-9))
    ]
    first, second = (d.max() for d in differences)
    assert 0 < first < 1e-4
    assert second / first == pytest.approx(1e-3, rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_a_potential_flow_is_a_rigid_body(contact):
    """N = 0 stays, and the body moves as the one with Zhukovsky's equivalent inertia."""
    body = BODIES["ball, turned cavity off its centre"]
    rolling, omega = RollingBody(body, Plane(), contact), omega_of(contact)
    C = np.array(TURNED.coupling.tolist(), dtype=float)
    wet = motion(body, contact, tuple(-C @ omega))
    assert np.abs(wet["N"]).max() < 1e-15
    dry = motion(rolling.equivalent.body, contact, ())
    for name in ("omega", "gamma", "centre"):
        assert np.abs(wet[name] - dry[name]).max() < 1e-13


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_a_spherical_cavity_decouples(contact):
    """Its vorticity is fixed in space, and its fluid a mass point for the body."""
    sphere = Cavity((0.4, 0.4, 0.4), 0.8, centre=(0.1, -0.2, 0.05))
    shape = Ellipsoid((1.2, 1.0, 0.9), 0.3)
    body = Body(1.0, FULL, shape, cavity=sphere)
    wet = motion(body, contact, (0.5, -0.8, 1.2))
    # the mass point in the centre of the cavity, by hand
    whole, d = 1.8, np.array(sphere.centre)
    inertia = np.array(FULL) + 1.0 * 0.8 / whole * (d @ d * np.eye(3) - np.outer(d, d))
    moved = replace(shape, centre=tuple(-0.8 / whole * d))
    dry = motion(Body(whole, tuple(map(tuple, inertia)), moved), contact, ())
    for name in ("omega", "gamma", "centre"):
        assert np.abs(wet[name] - dry[name]).max() < 1e-13
    turned = np.array([turn_of(q) @ n for q, n in zip(wet["attitude"], wet["N"], strict=True)])
    assert np.abs(turned - turned[0]).max() < 1e-13


def test_a_frozen_fluid_moves_with_the_body_at_first():
    """ξ = 0: the momentum of the start is that of the body with its fluid frozen."""
    body = BODIES["ball"]
    frozen = np.diag([0.4, 0.5, 0.6]) + np.array(CENTRED.solid_inertia.tolist(), dtype=float)
    omega = np.array([0.7, 0.4, 1.1])
    ice = Body(1.8, tuple(np.diag(frozen)), Ball(1.0))
    momenta = [
        np.array(
            [float(x) for x in initial_state(RollingBody(b).system(), tuple(omega), tuple(GAMMA))]
        )
        for b in (body, ice)
    ]
    assert np.abs(momenta[0][:3] - momenta[1][:3]).max() < 1e-15


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_two_halves_of_fluid_in_two_cavities_alike_are_one_fluid(contact):
    """Fluids with one motion act as one of their common mass; here two of half the mass."""
    halves = (Cavity((0.2, 0.3, 0.25), 0.4, centre=(0.3, 0.0, 0.0)),)
    halves += (Cavity((0.2, 0.3, 0.25), 0.4, centre=(-0.3, 0.0, 0.0)),)
    xi = (0.5, -0.8, 1.2)
    two = motion(Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=halves), contact, (xi, xi))
    share = 0.8 * 0.3**2
    one = motion(
        Body(
            1.0,
            (0.4, 0.5 + share, 0.6 + share),
            Ball(1.0),
            cavity=Cavity((0.2, 0.3, 0.25), 0.8),
        ),
        contact,
        xi,
    )
    for name in ("omega", "gamma", "M", "centre"):
        assert np.abs(two[name] - one[name]).max() < 1e-13


# --- mistakes ------------------------------------------------------------------------------

MISTAKES = {
    "negative mass": (
        lambda: Cavity((0.5, 0.4, 0.3), -1.0),
        "mass -1.0 of the fluid in the cavity: it must be finite and not negative",
    ),
    "flat": (
        lambda: Cavity((0.5, 0.0, 0.3), 1.0),
        "semi-axis 2 0.0 of the cavity: it must be positive",
    ),
    "two axes": (
        lambda: Cavity((0.5, 0.3), 1.0),
        "axes (0.5, 0.3) of the cavity: three finite numbers are needed",
    ),
    "no turn": (
        lambda: Cavity((0.5, 0.4, 0.3), 1.0, (0.0, 0.0, 0.0, 0.0)),
        "turn of the cavity: a quaternion that turns must not be zero",
    ),
    "too large": (
        lambda: Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=Cavity((1.1, 0.4, 0.3), 1.0)),
        "the cavity with the semi-axes 1.1, 0.4, 0.3 does not fit into the body; make it smaller, "
        "or move its centre",
    ),
    "pushed out": (
        lambda: Body(
            1.0,
            (0.4, 0.5, 0.6),
            Ellipsoid((1.0, 0.8, 0.6)),
            cavity=(CENTRED, Cavity((0.2, 0.2, 0.2), 1.0, centre=(0.9, 0.0, 0.0))),
        ),
        "cavity 2 with the semi-axes 0.2, 0.2, 0.2 does not fit into the body; make it smaller, or "
        "move its centre",
    ),
    "disk": (
        lambda: Body(1.0, (0.3, 0.3, 0.6), Disk(1.0), cavity=CENTRED),
        "the cavity with the semi-axes 0.5, 0.4, 0.3 does not fit into the body; make it smaller, "
        "or move its centre",
    ),
    "overlap": (
        lambda: Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=(CENTRED, TURNED)),
        "cavities 1 and 2 overlap; move their centres apart, or make them smaller",
    ),
    "fluid without cavity": (
        lambda: initial_state(
            RollingBody(Body(1.0, (0.4, 0.5, 0.6), Ball(1.0))).system(),
            (1.0, 0.0, 0.0),
            (0.0, 0.0, 1.0),
            fluid=(1.0, 0.0, 0.0),
        ),
        "fluid: the body has no cavity with fluid in it; leave it out",
    ),
    "two fluids in one cavity": (
        lambda: initial_state(
            RollingBody(BODIES["ball"]).system(),
            (1.0, 0.0, 0.0),
            (0.0, 0.0, 1.0),
            fluid=((1.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
        ),
        "fluid: 1 vector of three numbers are needed, one for each cavity with fluid in it, not 2",
    ),
    "friction": (
        lambda: FrictionalContact(BODIES["ball"]),
        "cavity: a body with fluid inside rolls by a marble or rubber contact alone; with friction "
        "there may be none",
    ),
}


@pytest.mark.parametrize("case", MISTAKES)
def test_a_mistake_is_one_sentence(case):
    make, sentence = MISTAKES[case]
    with pytest.raises(InputError) as caught:
        make()
    assert caught.value.message == sentence


def test_what_just_fits_is_accepted():
    """A cavity that touches the wall in one point, and two that touch each other."""
    Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=Cavity((0.5, 0.4, 0.3), 1.0, centre=(0.5, 0, 0)))
    beside = [Cavity((0.2, 0.3, 0.3), 1.0, centre=(x, 0.0, 0.0)) for x in (0.2, -0.2)]
    Body(1.0, (0.4, 0.5, 0.6), Ball(1.0), cavity=beside)
    cushion = ImplicitShape(x**4 + y**4 + z**4 + x**2 + y**2 + z**2 - 1)
    Body(1.0, (0.4, 0.5, 0.6), cushion, cavity=Cavity((0.3, 0.4, 0.5), 1.0))


# --- tensors -------------------------------------------------------------------------------


def test_tensors_of_a_turned_cavity_are_exact():
    """Rational to the last digit, whatever the length of the quaternion."""
    turned = Cavity((0.5, 0.4, 0.3), 0.8, (1.0, 1.0, 0.0, 0.0))
    quarter = sp.Matrix([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
    assert turned.rotation == quarter
    straight = Cavity((0.5, 0.3, 0.4), 0.8)
    assert (
        turned.solid_inertia
        == straight.solid_inertia
        == sp.diag(sp.Rational(4, 100), sp.Rational(656, 10000), sp.Rational(544, 10000))
    )
    assert turned.coupling == straight.coupling


def test_the_equivalent_body_may_break_the_triangle_inequality():
    """What no rigid body can do: docs/fluid.md."""
    shell = Body(1e-3, (1e-4, 1e-4, 1e-4), Ball(1.0), cavity=Cavity((0.9, 0.6, 0.3), 1.0))
    moments = sorted(np.diag(RollingBody(shell).equivalent.body.tensor))
    assert moments[2] > moments[0] + moments[1]


@given(axes=st.tuples(*3 * [st.floats(0.1, 1.0)]), mass=st.floats(0.1, 2.0))
@settings(max_examples=20)
def test_zhukovskys_inertia(axes, mass):
    """The moments (m/5)(b² − c²)²/(b² + c²)."""
    K = np.array(Cavity(axes, mass).equivalent_inertia.tolist(), dtype=float)
    b = np.square(axes)
    expected = [mass / 5 * (b[i - 2] - b[i - 1]) ** 2 / (b[i - 2] + b[i - 1]) for i in range(3)]
    assert np.allclose(K, np.diag(expected), rtol=1e-13, atol=1e-16)
