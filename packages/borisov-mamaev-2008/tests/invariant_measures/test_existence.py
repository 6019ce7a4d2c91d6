"""Whether an invariant measure exists whose density depends on the configuration alone."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
import sympy as sp

from borisov_mamaev_2008.obstructions.limit_cycle import CASE
from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.laws import Identity, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
)
from lawproof.proof.prover import prove
from nonholonomic.invariant_measures.closed_form import closed_form, density
from nonholonomic.invariant_measures.existence import invariant_measure
from nonholonomic.invariant_measures.implicit_shapes import log_density_on_surface
from nonholonomic.invariant_measures.one_form import one_form
from nonholonomic.mechanics.lagrangian.mechanism import (
    Frame,
    Mechanism,
    coordinates,
    euclidean,
    rotations,
)
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

MOMENTS = (1.0, 1.5, 2.1)
PLANE, SPHERE = Plane(), Sphere(3.0)
omega, v, gamma = Vector("omega"), Vector("v"), Vector("gamma")


def rolling(shape, moments=MOMENTS, surface=PLANE, contact="rubber", **more):
    return RollingBody(Body(1.0, moments, shape), surface, contact, **more)


def kept(body):
    """Whether dσ = θ is proven for a density in closed form, with the numbers of the body."""
    form = one_form(body)
    numbers = tuple(p.symbol - exact_number(p.default) for p in form.system.parameters)
    system, law = form.density_law(closed_form(body, form, numbers))
    spin = True if form.spin is None else prove(form.system, replace(form.spin, level=numbers))
    return spin and prove(system, replace(law, level=numbers))


def parameter(name, value, *, positive=False):
    symbol = real_symbol(name)
    return Parameter(symbol, name, value, admissible=(symbol > 0,) if positive else ())


# --- rolling bodies ------------------------------------------------------------------------


@pytest.mark.parametrize("surface", [PLANE, SPHERE])
@pytest.mark.parametrize("contact", ["marble", "rubber"])
class TestBall:
    @pytest.mark.slow
    def test_balanced(self, contact, surface):
        found = invariant_measure(rolling(Ball(1.0), surface=surface, contact=contact))
        assert found
        assert found.density.level == ()

    @pytest.mark.slow
    def test_on_its_axis(self, contact, surface):
        ball = Ball(1.0, centre=(0.0, 0.0, 0.3))
        body = rolling(ball, (1.0, 1.0, 1.5), surface, contact)
        found = invariant_measure(body)
        assert found
        assert prove(found.system, found.density)

    def test_axis_in_any_direction(self, contact, surface):
        tensor = ((1.25, 0.25, 0.0), (0.25, 1.25, 0.0), (0.0, 0.0, 1.0))
        ball = Ball(1.0, centre=(0.3, 0.3, 0.0))
        assert invariant_measure(rolling(ball, tensor, surface, contact))

    @pytest.mark.parametrize("centre", [(0.0, 0.0, 0.3), (0.3, 0.0, 0.1), (0.1, 0.2, 0.3)])
    def test_unbalanced(self, contact, surface, centre):
        found = invariant_measure(
            rolling(Ball(1.0, centre=centre), (1.0, 1.2, 1.2), surface, contact)
        )
        assert found.decision == "none"
        assert found.obstruction["point"]

    def test_axis_beside_the_centre(self, contact, surface):
        ball = Ball(1.0, centre=(0.3, 0.0, 0.1))
        assert not invariant_measure(rolling(ball, (1.0, 1.0, 1.5), surface, contact))


def test_rubber_ball_on_a_ball_of_its_size():
    ball = Ball(1.0, centre=(0.1, 0.2, 0.3))
    assert kept(rolling(ball, surface=Sphere(1.0)))
    assert not invariant_measure(rolling(ball, surface=Sphere(1.01)))


def test_the_ball_with_limit_cycles_keeps_none():
    moments, kappa, _ = CASE
    radius, c = 0.5, [float(x) for x in kappa]
    square = sum(x * x for x in c)
    tensor = tuple(
        tuple(
            (float(moments[i]) - radius**2 - square if i == j else 0.0) + c[i] * c[j]
            for j in range(3)
        )
        for i in range(3)
    )
    found = invariant_measure(rolling(Ball(radius, centre=tuple(c)), tensor))
    assert found.decision == "none"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("contact", "surface", "centre"),
    [
        ("marble", PLANE, (0.1, 0.2, 0.05)),
        ("rubber", PLANE, (0.1, 0.2, 0.05)),
        ("marble", SPHERE, (0.1, 0.2, 0.05)),
    ],
)
def test_equal_moments_are_enough(contact, surface, centre):
    shape = Ellipsoid((1.0, 0.8, 0.6), centre=centre)
    assert kept(rolling(shape, (1.0, 1.0, 1.0), surface, contact))


def test_equal_moments_are_not_enough_for_rubber_on_a_sphere():
    shape = Ellipsoid((1.0, 0.8, 0.6), centre=(0.1, 0.2, 0.05))
    assert not invariant_measure(rolling(shape, (1.0, 1.0, 1.0), SPHERE))


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("shape", [Disk(1.0), Torus(1.0, 0.3, centre=(0.0, 0.0, 0.1))])
def test_bodies_of_revolution(contact, shape):
    assert kept(rolling(shape, (1.0, 1.0, 1.5), contact=contact))
    assert not invariant_measure(rolling(shape, contact=contact))


@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_the_rattleback_keeps_none(contact):
    shape = Ellipsoid((0.2, 0.03, 0.02), turn=0.1, centre=(0.0, 0.0, 0.01))
    body = rolling(shape, (2e-4, 16e-4, 17e-4), contact=contact, field=Forces(9.81))
    found = invariant_measure(body)
    assert found.decision == "none"
    assert "point" in found.obstruction


def line_of(axes, beta, delta, alpha):
    """Moments with α + βI_i b_i² + δ(I_i − b_i²) = 0."""
    return tuple((delta * b**2 - alpha) / (beta * b**2 + delta) for b in axes)


class TestEllipsoid:
    AXES = (2.0, 1.0, 0.5)

    def test_points_on_a_line(self):
        # β = 0: the differences I_i − b_i² agree, and θ vanishes
        body = rolling(Ellipsoid(self.AXES), line_of(self.AXES, 0.0, 1.0, -4.0))
        assert kept(body)

    def test_points_off_a_line(self):
        first, *others = line_of(self.AXES, 0.0, 1.0, -4.0)
        found = invariant_measure(rolling(Ellipsoid(self.AXES), (first + 0.001, *others)))
        assert found.decision == "none"

    def test_general_line(self):
        axes = (1.0, 2.0, 4.0)
        moments = line_of(axes, 1.0, 4.0, -6.0)
        assert moments == (2.0, 2.75, 3.5)
        form = one_form(rolling(Ellipsoid(axes), moments))
        numbers = tuple(p.symbol - exact_number(p.default) for p in form.system.parameters)
        assert prove(form.system, replace(form.closed, level=numbers))
        # σ = −½ log (γ, (B + 4E)γ)
        squares = sp.Add(
            *((b**2 + 4) * g**2 for b, g in zip((1, 2, 4), gamma.symbols, strict=True))
        )
        slope = [-g * (b**2 + 4) / squares for b, g in zip((1, 2, 4), gamma.symbols, strict=True)]
        law = Identity("sigma", cross(gamma, form.form - constant(slope)), level=numbers)
        assert prove(form.system, law)

    def test_homogeneous(self):
        squares = [b**2 for b in self.AXES]
        moments = tuple((sum(squares) - s) / 5 for s in squares)
        assert not invariant_measure(rolling(Ellipsoid(self.AXES), moments))
        assert not invariant_measure(rolling(Ellipsoid(self.AXES), moments, contact="marble"))

    @pytest.mark.slow
    @pytest.mark.parametrize("surface", [PLANE, SPHERE])
    def test_marble_with_shifted_squares(self, surface):
        moments = tuple(4.0 + b**2 for b in self.AXES)
        assert kept(rolling(Ellipsoid(self.AXES), moments, surface, "marble"))


@pytest.mark.slow
def test_shape_given_by_an_equation():
    x, y, z = ImplicitShape.coordinates
    shape = ImplicitShape(x**2 + 2 * y**2 + 3 * z**2 + x**4 - 1)
    assert not invariant_measure(rolling(shape, contact="marble"))
    assert not invariant_measure(rolling(shape))


def test_density_by_quadrature():
    tensor = ((1.25, 0.25, 0.0), (0.25, 1.25, 0.0), (0.0, 0.0, 1.0))
    turned = invariant_measure(rolling(Ball(1.0, centre=(0.3, 0.3, 0.0)), tensor))
    # the same ball with its axis along body axis 3: σ = −½ log(J₃ − kγ₃ + γ₃²(J₁ − J₃))
    k, square = 2 * 0.18**0.5, 0.18
    J1, J3 = 1.0 + square + 1, 1.5 + 1

    def sigma(gamma):
        u = (gamma[0] + gamma[1]) / 2**0.5
        return -0.5 * float(sp.log(J3 - k * u + u * u * (J1 - J3)))

    start, end = (0.36, -0.48, 0.8), (0.6, 0.64, 0.48)
    value, error = turned.log_density(end)
    assert error < 1e-12
    assert value == pytest.approx(sigma(end) - sigma(start), abs=1e-12)
    with pytest.raises(InputError, match="unit vector"):
        turned.log_density((1.0, 1.0, 1.0))


def test_density_by_following_the_contact():
    """An ellipsoid of equal moments by its equation: σ = −½ log(1 + h²)."""
    x, y, z = ImplicitShape.coordinates
    centre = (0.1, 0.2, 0.05)
    shape = ImplicitShape(x**2 / 4 + y**2 + z**2 - 1, centre=centre)
    sigma = log_density_on_surface(one_form(rolling(shape, (1.0, 1.0, 1.0))))

    def stated(gamma):
        height = (4 * gamma[0] ** 2 + gamma[1] ** 2 + gamma[2] ** 2) ** 0.5
        height -= sum(c * g for c, g in zip(centre, gamma, strict=True))
        return -0.5 * math.log(1 + height**2)

    first, second = (0.0, 0.6, 0.8), (0.6, 0.0, 0.8)
    found = [sigma(first), sigma(second)]
    assert max(error for _, error in found) < 1e-7
    difference = stated(second) - stated(first)
    assert found[1][0] - found[0][0] == pytest.approx(difference, abs=1e-10)
    with pytest.raises(InputError, match="unit vector"):
        sigma((1.0, 1.0, 0.0))


@pytest.mark.slow
@pytest.mark.parametrize("surface", [PLANE, SPHERE])
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize(
    "shape",
    [
        Ball(1.0, centre=(0.1, 0.2, 0.3)),
        Torus(1.0, 0.3, centre=(0.1, 0.2, 0.1)),
        Ellipsoid((1.0, 0.8, 0.6), centre=(0.1, 0.2, 0.1)),
    ],
)
def test_the_form_is_the_divergence_of_the_equations_of_motion(contact, surface, shape):
    """With ż = θ the density e^z over momenta is invariant, whatever the body."""
    body = rolling(shape, surface=surface, contact=contact)
    form, made = one_form(body), body.system()
    z = real_symbol("z")
    given = {*made.symbols, *(p.symbol for p in made.parameters)}
    own = {s: real_symbol(f"own_{s}") for s, _ in form.system.scalar_definitions if s not in given}
    rates = dict(zip(made.symbols, made.rates, strict=True))
    share = sum(t * rates[g] for t, g in zip(form.form.symbols, gamma.symbols, strict=True))
    if form.spin is not None:
        share += real_symbol("m") * to_components(dot(gamma, omega) * form.spin.value)
    tied = System(
        name="tied",
        title="tied",
        field={**dict(made.field), z: share.xreplace(own)},
        definitions=(
            *made.definitions,
            *((own[s], f.xreplace(own)) for s, f in form.system.scalar_definitions if s in own),
        ),
        parameters=made.parameters,
        relations=made.relations,
    )
    law = Measure("tied", (*density(body, ()), (sp.exp(z), 1)))
    # effort for the points at which it would be refuted, not for a proof
    assert prove(tied, law, effort=10_000_000).decision != "refuted"
    wrong = Measure("tied", (*density(body, ()), (sp.exp(2 * z), 1)))
    assert prove(tied, wrong, effort=10_000_000).decision == "refuted"


# --- mechanisms ----------------------------------------------------------------------------


def sleigh(offset):
    x, y, phi, v_1, v_2, w = (real_symbol(s) for s in ("x", "y", "phi", "v_1", "v_2", "w"))
    m, I, a, b = (real_symbol(s) for s in ("m", "I", "a", "b"))
    frame = Frame(
        {
            x: v_1 * sp.cos(phi) - v_2 * sp.sin(phi),
            y: v_1 * sp.sin(phi) + v_2 * sp.cos(phi),
            phi: w,
        },
        (v_1, v_2, w),
    )
    kinetic = m / 2 * ((v_1 - b * w) ** 2 + (v_2 + a * w) ** 2) + I / 2 * w**2
    parameters = (
        parameter("m", 1.0, positive=True),
        parameter("I", 0.5, positive=True),
        parameter("a", offset),
        parameter("b", 0.2),
    )
    return Mechanism("sleigh", frame, kinetic, (v_2,), parameters=parameters)


def test_chaplygin_sleigh():
    found = invariant_measure(sleigh(0.3))
    assert found.decision == "conditional"
    assert found.conditions == ((real_symbol("a"),),)
    assert found.complete
    assert not found
    assert "if and only if a = 0" in str(found)
    assert invariant_measure(sleigh(0.0))


def test_suslov():
    I = Symmetric("I")
    frame = Frame(
        {gamma: cross(gamma, omega)}, (omega,), (norm_squared(gamma) - 1,), rotations(omega)
    )
    numbers = zip(I.symbols, (2.0, 0.1, 0.2, 2.5, 0.3, 3.0), strict=True)
    found = invariant_measure(
        Mechanism(
            "suslov",
            frame,
            dot(omega, I * omega) / 2,
            (dot(omega, unit_vector(3)),),
            parameters=tuple(parameter(str(s), x) for s, x in numbers),
        )
    )
    assert found.decision == "conditional"
    assert found.complete
    assert [set(level) for level in found.conditions] == [
        {real_symbol("I_13"), real_symbol("I_23")}
    ]


def test_veselova():
    I = Diagonal("I")
    frame = Frame(
        {gamma: cross(gamma, omega)}, (omega,), (norm_squared(gamma) - 1,), rotations(omega)
    )
    numbers = zip(I.symbols, MOMENTS, strict=True)
    found = invariant_measure(
        Mechanism(
            "veselova",
            frame,
            dot(omega, I * omega) / 2,
            (dot(omega, gamma),),
            parameters=tuple(parameter(str(s), x) for s, x in numbers),
        )
    )
    assert found.decision == "exists"
    ((base, exponent),) = found.density.density
    assert exponent == sp.Rational(1, 2)
    inverse = sum(g**2 / i for g, i in zip(gamma.symbols, I.symbols, strict=True))
    assert sp.cancel(base / inverse).free_symbols <= set(I.symbols)


@pytest.mark.slow
def test_chaplygin_ball_from_its_lagrangian():
    I, m, R = Diagonal("I"), real_symbol("m"), real_symbol("R")
    frame = Frame(
        {gamma: cross(gamma, omega)}, (omega, v), (norm_squared(gamma) - 1,), euclidean(omega, v)
    )
    numbers = zip((*I.symbols, m, R), (*MOMENTS, 1.0, 1.0), strict=True)
    found = invariant_measure(
        Mechanism(
            "ball",
            frame,
            m * norm_squared(v) / 2 + dot(omega, I * omega) / 2,
            (v - R * cross(omega, gamma),),
            parameters=tuple(parameter(str(s), x) for s, x in numbers),
        )
    )
    assert found.decision == "exists"


def test_vertical_disk():
    x, y, psi, theta = (real_symbol(s) for s in ("x", "y", "psi", "theta"))
    m, I, J, R = (real_symbol(s) for s in ("m", "I", "J", "R"))
    frame = coordinates(x, y, psi, theta)
    xdot, ydot, psidot, thetadot = frame.w
    kinetic = m / 2 * (xdot**2 + ydot**2) + I / 2 * psidot**2 + J / 2 * thetadot**2
    found = invariant_measure(
        Mechanism(
            "vertical-disk",
            frame,
            kinetic,
            (xdot - R * psidot * sp.cos(theta), ydot - R * psidot * sp.sin(theta)),
            parameters=tuple(parameter(str(s), 1.0, positive=True) for s in (m, I, J, R)),
        )
    )
    assert found.decision == "exists"
    assert found.density.density == ()


def test_what_it_needs_is_said():
    with pytest.raises(InputError, match="source must be a RollingBody or a Mechanism"):
        invariant_measure("ball")
