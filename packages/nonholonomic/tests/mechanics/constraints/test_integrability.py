"""Which constraints are holonomic: planted disguises, bodies of every shape, and mistakes."""

from __future__ import annotations

import random

import pytest
import sympy as sp

from flowlanes import Integral, System
from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from lawproof import prove
from nonholonomic import (
    Ball,
    Body,
    Disk,
    Ellipsoid,
    Forces,
    ImplicitShape,
    Plane,
    RollingBody,
    ShapeOfRevolution,
    Sphere,
    Torus,
)
from nonholonomic.mechanics.ball.mechanism import ball_mechanism
from nonholonomic.mechanics.constraints.distribution import Distribution, distribution
from nonholonomic.mechanics.constraints.integrability import nonholonomy, nonholonomy_at
from nonholonomic.mechanics.lagrangian.mechanism import (
    TIME,
    Frame,
    Mechanism,
    coordinates,
    euclidean,
    rotations,
)
from nonholonomic.mechanics.lagrangian.structure_functions import lie_derivative
from nonholonomic.mechanics.rolling.contact import contact as contact_of
from nonholonomic.mechanics.rolling.mechanism import rolling_mechanism

x, y, z, k = (real_symbol(name) for name in "xyzk")
PLAIN = coordinates(x, y, z)
u, v, w = PLAIN.w
omega, velocity, gamma, r = vectors("omega v gamma r")


def mechanism(*constraints, value=1.0, **more) -> Mechanism:
    return Mechanism(
        "planted",
        PLAIN,
        sp.S.Zero,
        constraints,
        parameters=(Parameter(k, "k", value),),
        **more,
    )


def proven_by_the_prover(given: Distribution, function: sp.Expr) -> bool:
    """η_s(F) = 0 for a System that moves with any of the admissible velocities.

    Only coordinates on which F or their rates depend are kept.  Of logarithms and arcs SymPy
    decides.
    """
    if function.has(sp.log, sp.atan):
        own = given.with_numbers.fields
        return all(sp.simplify(lie_derivative(field, function)) == 0 for field in own)
    speeds = [real_symbol(f"speed_{i}") for i, _ in enumerate(given.fields)]
    table = {s: sp.Rational(repr(value)) for s, value in given.constants}
    rates = {
        q: sum(
            (s * f.get(q, sp.S.Zero) for s, f in zip(speeds, given.fields, strict=True)),
            sp.S.Zero,
        )
        for q in given.coordinates
    }
    steps = {s: value.xreplace(table) for s, value in given.steps}
    kept, waiting = set(), set(function.free_symbols)
    while waiting:
        symbol = waiting.pop()
        kept.add(symbol)
        waiting |= (rates.get(symbol, steps.get(symbol, sp.S.Zero))).free_symbols - kept
    system = System(
        name="admissible",
        title="Admissible motion",
        field={q: rate.xreplace(table) for q, rate in rates.items() if q in kept},
        definitions={s: value for s, value in steps.items() if s in kept},
        relations=tuple(
            f.xreplace(table) for f in given.relations if f.free_symbols <= kept | set(table)
        ),
        parameters=tuple(Parameter(s, "speed", 0.3 + i) for i, s in enumerate(speeds)),
    )
    law = Integral("holonomic", function.xreplace(table))
    return prove(system, law).decision == "proven"


# --- disguises -----------------------------------------------------------------------------

INTEGRABLE = {
    "differential of a product": ((y * u + x * v,), (2,), [x * y]),
    "integrating factor 1/xy": ((y * u - x * v,), (2,), [sp.log(x / y)]),
    "integrating factor a power": ((2 * y * u + 3 * x * v,), (2,), [x**2 * y**3]),
    "sphere": ((x * u + y * v + z * w,), (2,), [x**2 + y**2 + z**2]),
    "trigonometric": ((sp.sin(y) * u + x * sp.cos(y) * v,), (2,), [x * sp.sin(y)]),
    "half angle": (
        (sp.cos(y / 2) * u - x * sp.sin(y / 2) * v / 2,),
        (2,),
        [x * sp.cos(y / 2)],
    ),
    "exponential": ((u * sp.exp(y) + w, v), (1,), [y, z + x * sp.exp(y)]),
    "one after the other": ((w - x * v, u), (1,), [x, z - x * y]),
    "winding": ((w - (x * v - y * u) / (x**2 + y**2),), (2,), [z + sp.atan(x / y)]),
    "arc": (((1 + x**2) * v - y * u,), (2,), [sp.log(y) - sp.atan(x)]),
    "logarithm of a sum": (((1 + x**2) * v - x * y * u,), (2,), [y**2 / (1 + x**2)]),
    "root of a parameter": (
        (w - (x * v - y * u) / (x**2 + 4 * k * y**2),),
        (2,),
        [z + sp.atan(x / (2 * y)) / 2],
    ),
    "depends on the time": ((w - sp.sin(TIME),), (3,), [z + sp.cos(TIME)]),
    "affine": ((w - 2,), (3,), [z - 2 * TIME]),
    "any parameter": ((w - k * (x * v + y * u),), (2,), [z - k * x * y]),
}


@pytest.mark.parametrize("name", INTEGRABLE)
def test_an_integrable_constraint_is_seen_through(name):
    constraints, growth, integrals = INTEGRABLE[name]
    made = mechanism(*constraints)
    found = nonholonomy(made)
    assert (found.verdict, found.growth, found.proven) == ("holonomic", growth, True)
    assert len(found.integrals) == len(integrals) == found.holonomic
    own = made.frame.coordinates + ((TIME,) if found.depends_on_time else ())
    point = {k: 1, **{s: sp.Rational(i + 2, 3) for i, s in enumerate(own)}}
    both = [f.formula for f in found.integrals] + integrals
    rank = sp.Matrix([[sp.diff(f, s) for s in own] for f in both]).subs(point).rank(simplify=True)
    assert rank == len(integrals)
    for each in found.integrals:
        assert proven_by_the_prover(distribution(made), each.formula)


NONHOLONOMIC = {
    "Heisenberg": ((w - x * v,), (2, 3)),
    "one sign wrong": ((y * u - x * v + w,), (2, 3)),
    "skate": ((sp.sin(z) * u - sp.cos(z) * v,), (2, 3)),
    "no integrating factor": ((u + x * y * v + z * w,), (2, 3)),
    "depends on the time": ((w - TIME * u,), (3, 4)),
    "affine": ((w - x * v - 1,), (3, 4)),
}


@pytest.mark.parametrize("name", NONHOLONOMIC)
def test_a_nonholonomic_constraint_is_called_so(name):
    constraints, growth = NONHOLONOMIC[name]
    found = nonholonomy(mechanism(*constraints))
    assert (found.verdict, found.growth, found.proven) == ("completely nonholonomic", growth, True)
    assert found.integrals == ()


def test_a_constraint_that_is_integrable_for_one_value_of_a_parameter():
    constraint = w - k * x * v - y * u
    usual = nonholonomy(mechanism(constraint, value=2.0))
    assert (usual.verdict, usual.elsewhere) == ("completely nonholonomic", ())
    special = nonholonomy(mechanism(constraint, value=1.0))
    assert (special.verdict, special.growth, special.elsewhere) == ("holonomic", (2,), (2, 3))
    (integral,) = special.integrals
    assert integral.proven
    assert sp.expand(integral.formula - (z - x * y)) == 0
    assert "for almost all others the dimensions are 2, 3" in str(special)
    assert "almost all others" not in str(usual)


def test_no_constraint_and_a_position_alone():
    assert nonholonomy(mechanism()).verdict == "free"
    found = nonholonomy(mechanism(positions=(x**2 + y**2 + z**2 - 1,)))
    assert (found.verdict, found.dimension, found.rank) == ("free", 2, 2)


def test_a_position_that_another_constraint_needs():
    """On the cylinder x² + y² = 1, ż = xẏ − yẋ winds up: holonomic there, but not in space."""
    winding = w - x * v + y * u
    assert nonholonomy(mechanism(winding)).verdict == "completely nonholonomic"
    found = nonholonomy(mechanism(winding, positions=(x**2 + y**2 - 1,)))
    assert (found.verdict, found.dimension, found.growth) == ("holonomic", 2, (1,))
    assert found.proven
    assert "no formula was found" in str(found)


@pytest.mark.slow
def test_frobenius_proves_what_no_formula_is_found_for():
    """The integral holds ∫dz/(1 + z⁴), which is not among the functions tried."""
    odd = sp.exp(x * y) + sp.sin(x + y)
    integrable = u * sp.diff(odd, x) + v * sp.diff(odd, y) - w / (1 + z**4)
    found = nonholonomy(mechanism(integrable))
    assert (found.verdict, found.proven) == ("holonomic", True)
    assert not found.integrals
    assert "not proven" not in str(found)
    spoilt = nonholonomy(mechanism(integrable + x * y * z * v))
    assert spoilt.verdict == "completely nonholonomic"


def test_the_verdict_reads_as_a_paragraph():
    assert str(nonholonomy(mechanism(w - x * v))) == (
        "1 constraint on 3 velocities leaves 2; with their commutators the admissible fields span "
        "2, 3 dimensions of the configuration space. The constraints are completely nonholonomic: "
        "no function of the configuration is constant along all admissible motions."
    )
    text = str(nonholonomy(mechanism(y * u + x * v, w)))
    assert text.endswith("Constant along every admissible motion: z = const, x y = const.")
    assert "space of time and configuration" in str(nonholonomy(mechanism(w - 1)))


# --- rolling bodies ------------------------------------------------------------------------

h = sp.Function("h", real=True)(*gamma.symbols)
SHAPES = {
    "ball": (Ball(0.8), {"marble": (3, 5), "rubber": (2, 3, 5)}),
    "eccentric ball": (Ball(0.8, centre=(0.1, 0.2, 0.3)), {"marble": (3, 5), "rubber": (2, 3, 5)}),
    "disk": (Disk(0.5), {"marble": (3, 4, 5), "rubber": (2, 3, 4, 5)}),
    "torus": (Torus(0.5, 0.1), {"marble": (3, 5), "rubber": (2, 3, 5)}),
    "ellipsoid": (Ellipsoid((1.0, 0.8, 0.6)), {"marble": (3, 5), "rubber": (2, 3, 5)}),
    "turned ellipsoid": (
        Ellipsoid((1.0, 0.8, 0.6), turn=0.3),
        {"marble": (3, 5), "rubber": (2, 3, 5)},
    ),
    "revolution": (
        ShapeOfRevolution(1 + real_symbol("gamma_3") ** 2 / 10),
        {"marble": (3, 5), "rubber": (2, 3, 5)},
    ),
    "quartic": (ImplicitShape(x**4 + y**4 + z**4 - 1), {"marble": (3, 5), "rubber": (2, 3, 5)}),
}


def rolling(shape, surface, contact) -> Mechanism:
    body = Body(1.0, (0.3, 0.4, 0.5), shape)
    return rolling_mechanism(RollingBody(body, surface, contact, Forces(gravity=9.81)))


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("name", SHAPES)
def test_on_a_plane_the_height_is_the_only_holonomic_constraint(name, contact):
    """Remark 5: R_3 + (γ, r) = const for every shape, up to what vanishes identically."""
    shape, growth = SHAPES[name]
    made = rolling(shape, Plane(), contact)
    found = nonholonomy(made)
    assert (found.verdict, found.growth, found.dimension) == ("in between", growth[contact], 6)
    assert found.proven and found.holonomic == 1
    (integral,) = found.integrals
    given = distribution(made)
    assert proven_by_the_prover(given, integral.formula)
    height = real_symbol("R_3") + to_components(dot(gamma, contact_of(shape, Plane()).r))
    slope = sp.diff(integral.formula, real_symbol("R_3"))
    assert slope.is_Rational and slope > 0
    assert proven_by_the_prover(given, sp.expand(height - integral.formula / slope))


def any_body(contact) -> Mechanism:
    """A body of any shape, by its support function h(γ)."""
    slope = gradient(h, gamma, "h")
    return Mechanism(
        "any-body",
        Frame(
            {gamma: cross(gamma, omega)},
            (omega, velocity),
            (norm_squared(gamma) - 1,),
            euclidean(omega, velocity),
        ),
        sp.S.Zero,
        (velocity + cross(omega, r),) + ((dot(omega, gamma),) if contact == "rubber" else ()),
        definitions={r: -h * gamma - slope + dot(slope, gamma) * gamma},
    )


@pytest.mark.parametrize(("contact", "growth"), [("marble", (3, 5)), ("rubber", (2, 3, 5))])
def test_remark_5_for_every_support_function_at_once(contact, growth):
    found = nonholonomy(any_body(contact))
    assert (found.growth, found.proven) == (growth, True)
    assert [f.formula for f in found.integrals] == [real_symbol("R_3") - h]


@pytest.mark.parametrize("radius", [2.0, 2.4, 0.8, -2.0])
def test_a_marble_ball_on_a_sphere_is_completely_nonholonomic(radius):
    found = nonholonomy(rolling(Ball(0.8), Sphere.of_signed_radius(radius), "marble"))
    assert (found.growth, found.dimension) == ((3, 5), 5)
    assert (found.verdict, found.proven, found.elsewhere) == ("completely nonholonomic", True, ())


@pytest.mark.parametrize("radius", [2.0, 2.4, -2.0, -1.0])
def test_a_rubber_ball_on_a_sphere_is_completely_nonholonomic(radius):
    """Also at the ratio 1:3 of the radii, where the symmetry alone is larger."""
    found = nonholonomy(rolling(Ball(0.8), Sphere.of_signed_radius(radius), "rubber"))
    assert (found.growth, found.dimension) == ((2, 3, 5), 5)
    assert (found.verdict, found.proven, found.elsewhere) == ("completely nonholonomic", True, ())


@pytest.mark.slow
def test_a_rubber_ball_on_an_equal_one_is_its_mirror_image():
    """The attitude followed by the reflection in the common tangent plane never changes."""
    made = rolling(Ball(0.8), Sphere(0.8), "rubber")
    found = nonholonomy(made)
    assert (found.verdict, found.growth, found.elsewhere) == ("holonomic", (2,), (2, 3, 5))
    assert (found.holonomic, len(found.integrals), found.proven) == (3, 3, True)
    alpha = Vector("alpha")
    mirrored = alpha.symbols[0] - 2 * gamma.symbols[0] * sum(
        a * b for a, b in zip(alpha, gamma, strict=True)
    )
    assert proven_by_the_prover(distribution(made).with_numbers, mirrored)
    assert "(α, γ)" in str(found)


@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_a_homogeneous_ball_on_a_surface_that_nobody_specified(contact):
    place = Vector("R")
    surface = sp.Function("f", real=True)(*place.symbols)
    numbers = tuple(Parameter(real_symbol(s), s, 0.5) for s in ("m", "mu", "b"))
    found = nonholonomy(ball_mechanism(contact, surface, sp.S.Zero, numbers))
    assert found.growth == ((3, 5) if contact == "marble" else (2, 3, 5))
    assert [f.formula for f in found.integrals] == [surface]
    assert found.proven


def test_a_shape_that_turns_into_a_needle_has_more_constraints():
    """Of an ellipsoid with one semi-axis alone the end stays in place."""
    reach = constant([-gamma.symbols[0], 0, 0])
    made = Mechanism(
        "needle",
        Frame(
            {gamma: cross(gamma, omega)},
            (omega, velocity),
            (norm_squared(gamma) - 1,),
            euclidean(omega, velocity),
        ),
        sp.S.Zero,
        (velocity + cross(omega, r),),
        definitions={r: reach / gamma.symbols[0]},
    )
    found = nonholonomy(made)
    assert (found.verdict, found.growth, found.holonomic) == ("holonomic", (3,), 3)
    assert found.proven


# --- frames --------------------------------------------------------------------------------


def test_the_frame_does_not_matter():
    turned = Frame(
        {x: u * sp.cos(z) - v * sp.sin(z), y: u * sp.sin(z) + v * sp.cos(z), z: w}, (u, v, w)
    )
    sentence = Frame(
        turned.rates,
        (u, v, w),
        structure={(w, u): {v: sp.S.One}, (w, v): {u: -sp.S.One}},
    )
    for frame in (turned, sentence):
        found = nonholonomy(Mechanism("skate", frame, sp.S.Zero, (v,)))
        assert (found.growth, found.verdict) == ((2, 3), "completely nonholonomic")


def test_a_reduced_frame_stands_for_the_whole_group():
    """Rotations with one angular velocity forbidden: all attitudes can still be reached."""
    frame = Frame({}, (omega,), structure=rotations(omega))
    found = nonholonomy(Mechanism("suslov", frame, sp.S.Zero, (omega.symbols[2],)))
    assert (found.growth, found.dimension) == ((2, 3), 3)
    both = nonholonomy(Mechanism("axis", frame, sp.S.Zero, omega.symbols[1:]))
    assert (both.verdict, both.growth) == ("holonomic", (1,))


def test_rates_that_contradict_the_structure_are_refused():
    wrong = Frame({x: u, y: x * v}, (u, v, w), structure={(u, v): {w: sp.S.One}})
    with pytest.raises(InputError, match="contradict the structure functions"):
        nonholonomy(Mechanism("wrong", wrong, sp.S.Zero, (w - y * u,)))


def test_the_fields_satisfy_the_constraints():
    made = rolling(Ellipsoid((1.0, 0.8, 0.6)), Plane(), "rubber")
    given = distribution(made)
    assert len(given.fields) == 2
    heights = [lie_derivative(field, real_symbol("R_3")) for field in given.fields]
    assert any(height != 0 for height in heights)


# --- mistakes ------------------------------------------------------------------------------


def test_nonlinear_constraints_are_refused():
    with pytest.raises(InputError, match="not linear in the velocities"):
        nonholonomy(mechanism(u**2 + v**2 - w**2))


def test_contradictory_constraints_are_refused():
    with pytest.raises(InputError, match="contradict each other"):
        nonholonomy(mechanism(w - 1, w - 2))


def test_dependent_constraints_count_once():
    found = nonholonomy(mechanism(w - x * v, 2 * w - 2 * x * v))
    assert (found.constraints, found.growth) == (1, (2, 3))


def test_a_constraint_that_fails_at_a_point_is_refused_there():
    with pytest.raises(InputError, match="dependent or singular at this point"):
        nonholonomy_at(mechanism(x * w - x**2 * v), {x: 0, y: 1, z: 0})
    assert nonholonomy_at(mechanism(x * w - x**2 * v), {x: 1, y: 1, z: 0}).growth == (2, 3)


def test_a_configuration_space_without_points_is_refused():
    with pytest.raises(InputError, match="no point was found"):
        nonholonomy(mechanism(w - x * v, positions=(x**2 + 1 - x**2 + 0 * y,)))


def test_a_ball_whose_attitude_is_a_quaternion():
    """Rubber and marble balls in coordinates of space, with the quaternion body → space."""
    q, place = Vector("q", 4), Vector("R")
    spin, speed = vectors("Omega V")
    a, b, c = spin.symbols
    w_, i, j, l_ = q.symbols
    half = sp.Rational(1, 2)
    rates = {
        w_: half * (-i * a - j * b - l_ * c),
        i: half * (w_ * a + b * l_ - c * j),
        j: half * (w_ * b + c * i - a * l_),
        l_: half * (w_ * c + a * j - b * i),
        place: speed,
    }
    unit_length = w_**2 + i**2 + j**2 + l_**2 - 1
    frame = Frame(rates, (spin, speed), (unit_length,))
    rolls = speed - cross(spin, constant([0, 0, sp.Rational(4, 5)]))
    for constraints, growth in (((rolls,), (3, 5)), ((rolls, c), (2, 3, 5))):
        found = nonholonomy(Mechanism("ball", frame, sp.S.Zero, constraints))
        assert (found.growth, found.dimension, found.proven) == (growth, 6, True)
        assert [f.formula for f in found.integrals] == [place.symbols[2]]
        assert sum(found.point[s] ** 2 for s in q) == 1


@pytest.mark.parametrize("seed", range(6))
def test_random_integrals_are_recovered(seed):
    """μ dF = 0 for a random polynomial F and factor μ; one more term spoils it."""
    rng = random.Random(seed)
    terms = [x, y, z, x * y, y * z, x * z, x**2, y**2, z**2]
    hidden = sp.Add(*(rng.randint(-3, 3) * term for term in terms)) + z
    factor = rng.choice((1 + x**2, x * y, 1 / (2 + z**2), sp.cos(x), sp.exp(y)))
    rate = u * sp.diff(hidden, x) + v * sp.diff(hidden, y) + w * sp.diff(hidden, z)
    found = nonholonomy(mechanism(sp.expand(factor * rate)))
    assert (found.verdict, found.proven) == ("holonomic", True)
    (integral,) = found.integrals
    slopes = [[sp.diff(f, q) for q in (x, y, z)] for f in (hidden, integral.formula)]
    assert all(sp.expand(c) == 0 for c in sp.Matrix(slopes[0]).cross(sp.Matrix(slopes[1])))
    assert nonholonomy(mechanism(factor * rate + x * y * w - z**2 * u)).verdict == (
        "completely nonholonomic"
    )


def test_a_position_that_no_coordinate_is_solved_from():
    """A point is then found for other parameters; what is known is said of almost all of them."""
    position = sp.sqrt(1 + x**2) + sp.sqrt(2 + y**2) + sp.exp(z) - k
    found = nonholonomy(mechanism(x * u + y * v, positions=(position,), value=9.0))
    assert found.almost
    assert (found.dimension, found.rank, found.verdict) == (2, 1, "holonomic")
    assert "For almost all values of the parameters; these were not tried" in str(found)
