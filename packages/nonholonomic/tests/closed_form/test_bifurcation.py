"""Bifurcation diagrams: known ones, what holds of every one, and what is refused."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.vectors import real_symbol
from nonholonomic.closed_form.bifurcation import Diagram, bifurcation_diagram, locate
from nonholonomic.closed_form.bifurcation.families import PLANES, SEPARATIONS, plane_named
from nonholonomic.closed_form.separations.chaplygin_ball_area_constant import chaplygin_area
from nonholonomic.closed_form.separations.veselova import veselova

NAMES = (*SEPARATIONS, *PLANES)
#: Moments in another order than the usual, and a parameter that some systems have.
MOMENTS = {"I_1": "2.1", "I_2": "1", "I_3": "1.5"}
h, F, f, g = (real_symbol(name) for name in "hFfg")


@pytest.fixture(scope="module")
def diagrams() -> dict[str, Diagram]:
    return {name: bifurcation_diagram(name) for name in NAMES}


def told(diagram):
    """Curves, up to a factor, with what is said of them."""
    return {
        (sp.Poly(b.curve).monic().as_expr(), b.pole, b.circles, b.stable)
        for b in diagram.boundaries
    }


def line(expression):
    return sp.Poly(expression).monic().as_expr()


# --- known diagrams ------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "further", "values"),
    [
        ("veselova", {}, {1: "2.1", 2: "1", 3: "1.5"}),
        # J = I + mR²
        ("rubber-chaplygin-ball", {"m": "2", "R": "0.5"}, {1: "2.6", 2: "1.5", 3: "2"}),
        ("chaplygin-ball", {"m": "2", "R": "0.5"}, {1: "2.6", 2: "1.5", 3: "2"}),
        # f = M² = J_i² ω² and 2h = J_i ω², as on a plane
        ("ball-around-sphere", {"m": "2", "R": "0.5", "a": "0.25"}, {1: "2.6", 2: "1.5", 3: "2"}),
        # u(tr J − u) at u = J_i, tr J = 6.1
        (
            "rubber-ball-around-sphere",
            {"m": "2", "R": "0.5", "a": "0.25"},
            {1: "9.1", 2: "6.9", 3: "8.2"},
        ),
    ],
)
def test_rays_of_permanent_rotations(name, further, values):
    diagram = bifurcation_diagram(name, {**MOMENTS, **further})
    x, y = (axis.symbol for axis in diagram.axes)
    # the smallest moment belongs to axis 2, the largest to axis 1
    assert told(diagram) == {
        (line(2 * x * sp.Rational(value) - y), axis, 2, axis != 3) for axis, value in values.items()
    }
    assert [region.tori for region in diagram.regions if region.tori] == [2, 2]
    assert diagram.equilibria == ()


def test_chaplygin_ball_with_any_area():
    """Rotation about axis i, inclined at will: I_i (2hJ_i − f) = Dg², up to M vertical, g² = f."""
    diagram = bifurcation_diagram("chaplygin-ball-area", {**MOMENTS, "m": "2", "R": "0.5", "f": 3})
    inertia = {axis: sp.Rational(MOMENTS[f"I_{axis}"]) for axis in (1, 2, 3)}
    D = sp.Rational(1, 2)
    rotations = {
        (line(i * (2 * h * (i + D) - 3) - D * g**2), axis, 2, axis != 3)
        for axis, i in inertia.items()
    }
    assert told(diagram) == {*rotations, (g**2 - 3, 0, 2, True)}
    assert {region.tori for region in diagram.regions} == {0, 2}


@pytest.mark.slow
def test_neumann(diagrams):
    """Jacobi's diagram: three lines and the parabola that touches two of them."""
    diagram = diagrams["neumann"]
    at_rest = {(e.axis, e.centres, e.place[0]) for e in diagram.equilibria}
    # h = ½cI_i where Γ rests on axis i
    assert at_rest == {(1, 2, Fraction("0.4")), (2, 1, Fraction("0.6")), (3, 0, Fraction("0.84"))}
    assert sorted(region.tori for region in diagram.regions if region.tori) == [2, 2, 2, 4]
    (four,) = (region for region in diagram.regions if region.tori == 4)
    (family,) = four.families
    assert (family.nonvanishing, family.two_way) == ((1,), False)
    around = next(region for region in diagram.regions if region.families[0].two_way)
    assert around.families[0].nonvanishing == (1,)
    (parabola,) = (b for b in diagram.boundaries if b.pole == 0)
    c = sp.Rational("0.8")
    z = sp.Symbol("z")
    discriminant = sp.discriminant(c * z**2 / 2 + (h - c * sp.Rational("4.6") / 2) * z - f, z)
    assert line(parabola.curve) == line(discriminant)
    assert (parabola.circles, parabola.stable) == (4, True)


def test_turned_over():
    """A negative strength exchanges the roles of the first and the third axis."""
    upright = bifurcation_diagram("neumann", {"c": "0.8"})
    turned = bifurcation_diagram("neumann", {"c": "-0.8"})
    assert {(e.axis, e.centres) for e in upright.equilibria} == {(1, 2), (2, 1), (3, 0)}
    assert {(e.axis, e.centres) for e in turned.equilibria} == {(1, 0), (2, 1), (3, 2)}


# --- what holds of every diagram ------------------------------------------------------------


def _consistent(diagram):
    tori = {cell: region.tori for region in diagram.regions for cell in region.cells}
    circles, unstable = {}, set()
    for boundary in diagram.boundaries:
        for arc in boundary.arcs:
            if boundary.stable:
                circles[arc] = circles.get(arc, 0) + boundary.circles
            else:
                unstable.add(arc)
    assert diagram.boundaries
    for column, rank in circles.keys() | unstable:
        below, above = tori[column, rank], tori[column, rank + 1]
        if (column, rank) in unstable:
            assert below and above
        else:
            # every circle is what a torus shrinks to, and no torus ends otherwise
            assert abs(below - above) == circles[column, rank]


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_tori_end_in_circles(diagrams, name):
    _consistent(diagrams[name])


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("name", ["neumann", "veselova-bruns", "chaplygin-ball-area"])
def test_tori_end_in_circles_for_other_bodies(name, seed):
    generator = random.Random(f"{name} {seed}")
    moments = [Fraction(number, 50) for number in generator.sample(range(60, 101), 3)]
    further = {
        "neumann": {"c": Fraction(generator.choice([-3, 2, 5]), 7)},
        "veselova-bruns": {"K": Fraction(generator.choice([-3, 2, 5]), 7)},
        "chaplygin-ball-area": {"m": Fraction(3, 7), "R": 2, "f": 5},
    }
    parameters = {f"I_{i}": moment for i, moment in enumerate(moments, 1)}
    diagram = bifurcation_diagram(name, {**parameters, **further[name]})
    _consistent(diagram)
    assert {e.centres for e in diagram.equilibria} <= {0, 1, 2}


@pytest.mark.parametrize("name", NAMES)
def test_regions_cover_the_plane_once(diagrams, name):
    diagram = diagrams[name]
    cells = [cell for region in diagram.regions for cell in region.cells]
    assert sorted(cells) == sorted(diagram.arrangement.cells)
    for region in diagram.regions:
        assert diagram.region(*region.sample) is region
    generator = np.random.default_rng(1)
    for x, y in generator.normal(0, 3, (20, 2)):
        found = diagram.region(x, y)
        assert found is None or found in diagram.regions


def test_points_on_curves(diagrams):
    """On a boundary there is no region; elsewhere on its curve, and on verticals, there is."""
    diagram = diagrams["neumann"]
    # Γ₁ = 0: f = h − 1.44, real from h = 0.6 on; 0.5 lies beyond
    assert diagram.region("0.7", "-0.74") is None
    assert diagram.region("0.5", "-0.94").tori == 0
    # above h = 0.6 a boundary ends, and others run through the vertical
    assert diagram.region("0.6", "-0.9").tori == 2
    assert diagrams["veselova"].region(1, 3) is None
    assert diagrams["veselova"].region(0, 3).tori == 0


# --- where a motion lies ---------------------------------------------------------------------


def test_located(diagrams):
    diagram = diagrams["chaplygin-ball-area"]
    state = dict(zip(diagram.plane.system.symbols, ("0.6", "0", "0.8", "0", "0", "1"), strict=True))
    x, y = locate(diagram, state)
    # 2h = (AM, M) + D (ω, γ)², (ω, γ) = (AM, γ)/(1 − (γ, Aγ)), with J = (2, 2.5, 3.1)
    spin = (0.8 / 3.1) / (1 - 1 / 3.1)
    assert x == pytest.approx((0.36 / 2 + 0.64 / 3.1 + spin * 0.8 / 3.1) / 2)
    assert y == pytest.approx(0.8)


@pytest.mark.parametrize(
    ("name", "state", "words"),
    [
        ("chaplygin-ball-area", ("1", "1", "0", "0", "0", "1"), "in this state and must vanish"),
        ("veselova", ("1", "0", "1", "0", "0", "1"), "must vanish"),
        ("chaplygin-ball", ("1", "0", "1", "0", "0", "1"), "must vanish"),
    ],
)
def test_a_state_off_the_level_is_refused(diagrams, name, state, words):
    symbols = diagrams[name].plane.system.symbols
    with pytest.raises(InputError, match=words):
        locate(diagrams[name], dict(zip(symbols, state, strict=True)))


def test_a_missing_variable_is_refused(diagrams):
    with pytest.raises(InputError, match="no value for omega_2"):
        locate(diagrams["veselova"], {"omega_1": 1, "omega_3": 0})


# --- what is refused ------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "parameters", "words"),
    [
        ("veselova", {"I_2": 1}, "three different numbers"),
        ("veselova", {"I_3": 5}, "triangle inequality"),
        ("veselova", {"J_3": 5}, "no parameter J_3"),
        ("veselova", {"I_3": "wide"}, "must be a mapping of names to numbers"),
        ("velesova", {}, "no bifurcation diagram 'velesova'"),
        ("veselova-bruns", {"K": 0}, "a field needs a strength other than 0"),
        ("neumann", {"c": 0}, "a field needs a strength other than 0"),
        ("rubber-ball-around-sphere", {"R": 3}, "must vanish"),
        ("chaplygin-ball-area", {"f": -1}, "it must be positive"),
    ],
)
def test_refused(name, parameters, words):
    with pytest.raises(InputError, match=words):
        bifurcation_diagram(name, parameters)


def test_a_vertical_boundary_is_refused():
    """With f = x + I₁y and h = y the motions with Γ₁ = 0 lie on a line x = const."""
    plane = plane_named("neumann")
    first = sp.Symbol("I_1", real=True)
    sheared = plane.cofactor.subs({f: h + first * f, h: f}, simultaneous=True)
    with pytest.raises(InputError, match="across a vertical line"):
        bifurcation_diagram(replace(plane, cofactor=sheared))


def test_three_constants_are_refused():
    with pytest.raises(InputError, match="two constants of the motion"):
        bifurcation_diagram(chaplygin_area())


def test_a_separable_by_itself():
    named = bifurcation_diagram("veselova")
    unnamed = bifurcation_diagram(replace(veselova(), name="own"))
    assert [b.curve for b in named.boundaries] == [b.curve for b in unnamed.boundaries]
    assert named.boundaries[0].words == "permanent rotation about axis 1"
    assert unnamed.boundaries[0].words == "motion in the plane ν_1 = 0"
