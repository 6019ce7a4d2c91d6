"""Shapes: points, normals and curvatures, one shape described in two ways, and wrong input."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings

from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector, real_symbol, to_components
from mechanics.bodies import CENTRE, FIELD, FULL, QUARTIC, ROTORS, SHAPES, SURFACES
from mechanics.compare import GAMMA, XYZ
from mechanics.portrait import Portrait, coordinates, directions
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane
from nonholonomic.starts import initial_state

X, Y, Z = XYZ
U = GAMMA[2]
EXPLICIT = [name for name in SHAPES if name != "implicit"]
few = settings(max_examples=20)


def compiled(shape):
    """The Gauss map of a shape: reach, support, trace, determinant, spread of two vectors."""
    body = shape.gauss()
    first, second = Vector("u"), Vector("v")
    formulas = [
        *to_components(body.reach),
        body.support,
        body.trace,
        body.determinant,
        *to_components(body.spread(first)),
        *to_components(body.spread(second)),
    ]
    steps = [
        step
        for name, value in body.definitions
        for step in (
            [(name, to_components(value))]
            if isinstance(name, sp.Symbol)
            else zip(name.symbols, name.independent(to_components(value)), strict=True)
        )
    ]
    names = [p.symbol for p in body.parameters]
    numbers = [p.default for p in body.parameters]
    function = sp.lambdify(
        [*names, *GAMMA, *first, *second],
        [to_components(e) for e in formulas],
        "numpy",
        cse=lambda e: (steps, e),
    )

    def at(gamma):
        gamma = np.asarray(gamma)
        across = np.cross(gamma, np.eye(3)[int(np.argmin(np.abs(gamma.real)))])
        across = across / np.sqrt(across @ across)
        along = np.cross(gamma, across)
        sentence = np.array(function(*numbers, *gamma, *across, *along))
        frame = np.stack([across, along])
        return (
            sentence[:3],
            *sentence[3:6],
            frame @ np.stack([sentence[6:9], sentence[9:12]], axis=1),
            frame,
        )

    return at


GAUSS_MAPS = {name: compiled(SHAPES[name]) for name in EXPLICIT}


def on_surface(name, s):
    """Vanishes at points of a shape, measured from its geometric centre."""
    shape, (x, y, z) = SHAPES[name], s
    match shape:
        case Ball():
            return s @ s - shape.radius**2
        case Ellipsoid():
            cos, sin = np.cos(shape.turn), np.sin(shape.turn)
            own = np.array([cos * x + sin * y, cos * y - sin * x, z])
            return np.sum((own / shape.axes) ** 2) - 1
        case Disk():
            return np.hypot(x, y) - shape.radius + abs(z)
        case Torus():
            return np.hypot(np.hypot(x, y) - shape.radius, z) - shape.tube
    raise TypeError(shape)


@pytest.mark.parametrize("name", [name for name in EXPLICIT if name != "revolution"])
@given(gamma=directions)
@few
def test_contact_point_lies_on_the_surface(name, gamma):
    assume(name not in ("disk", "torus") or np.hypot(gamma[0], gamma[1]) > 1e-3)
    reach, *_ = GAUSS_MAPS[name](gamma)
    assert abs(on_surface(name, reach)) < 1e-13


@pytest.mark.parametrize("name", EXPLICIT)
@given(gamma=directions, push=coordinates)
@few
def test_contact_point_moves_along_the_tangent_plane(name, gamma, push):
    """The derivative of the contact point is -W, a symmetric operator of the tangent plane."""
    assume(name not in ("disk", "torus") or np.hypot(gamma[0], gamma[1]) > 0.05)
    reach, support, trace, determinant, spread, frame = GAUSS_MAPS[name](gamma)
    push = push - (push @ gamma) * gamma
    moved = GAUSS_MAPS[name](gamma + 1e-30j * push)[0].imag / 1e-30
    size = 1 + abs(trace)
    assert abs(moved @ gamma) < 1e-13 * size
    assert np.abs(frame @ moved + spread @ (frame @ push)).max() < 1e-12 * size
    assert support == pytest.approx(-reach @ gamma, rel=1e-13)
    assert spread[0, 1] == pytest.approx(spread[1, 0], abs=1e-13 * size)
    assert trace == pytest.approx(np.trace(spread), rel=1e-12)
    assert determinant == pytest.approx(np.linalg.det(spread), rel=1e-11, abs=1e-12 * size)


@given(gamma=directions, other=directions)
@few
def test_contact_point_is_the_lowest(gamma, other):
    """No other point of a convex body is nearer to the plane that it touches."""
    assume(np.hypot(gamma[0], gamma[1]) > 1e-3 and np.hypot(other[0], other[1]) > 1e-3)
    for name in EXPLICIT:
        if not getattr(SHAPES[name], "hollow", False):
            lowest, elsewhere = GAUSS_MAPS[name](gamma)[0], GAUSS_MAPS[name](other)[0]
            assert elsewhere @ gamma >= lowest @ gamma - 1e-13


# ---------------------------------------------------------------------------------------------
# One shape described in two ways


AT = {"centre": CENTRE}
SPHEROID = sp.sqrt(sp.Rational(36, 25) * (1 - U**2) + sp.Rational(16, 25) * U**2)

TWINS = {
    "ellipsoid with equal axes": (Ball(0.9, **AT), Ellipsoid((0.9, 0.9, 0.9), **AT)),
    "turned ellipsoid with equal axes": (Ball(0.9, **AT), Ellipsoid((0.9,) * 3, turn=0.7, **AT)),
    "spheroid turned about its axis": (
        Ellipsoid((1.2, 1.2, 0.8), **AT),
        Ellipsoid((1.2, 1.2, 0.8), turn=1.1, **AT),
    ),
    "ellipsoid turned by a right angle": (
        Ellipsoid((1.2, 0.9, 0.8), **AT),
        Ellipsoid((0.9, 1.2, 0.8), turn=np.pi / 2, **AT),
    ),
    "ball by its support function": (Ball(0.9, **AT), ShapeOfRevolution(sp.Rational(9, 10), **AT)),
    "spheroid by its support function": (
        Ellipsoid((1.2, 1.2, 0.8), **AT),
        ShapeOfRevolution(SPHEROID, **AT),
    ),
    "spheroid by its profile": (
        Ellipsoid((1.2, 1.2, 0.8), **AT),
        ShapeOfRevolution.from_profile(
            -sp.Rational(36, 25) / SPHEROID, -sp.Rational(16, 25) * U / SPHEROID, **AT
        ),
    ),
    "ball moved along its axis": (
        Ball(0.9, centre=(0.1, -0.2, 0.35)),
        ShapeOfRevolution(sp.Rational(9, 10) - U / 5, **AT),
    ),
    "torus by its support function": (
        Torus(0.8, 0.2, **AT),
        ShapeOfRevolution(sp.Rational(1, 5) + sp.Rational(4, 5) * sp.sqrt(1 - U**2), **AT),
    ),
    "implicit ball": (
        Ball(0.9, **AT),
        ImplicitShape(X**2 + Y**2 + Z**2 - sp.Rational(81, 100), **AT),
    ),
    "implicit ball by its distance": (
        Ball(0.9, **AT),
        ImplicitShape(sp.sqrt(X**2 + Y**2 + Z**2 + 1) - sp.sqrt(sp.Rational(181, 100)), **AT),
    ),
    "implicit ellipsoid": (
        Ellipsoid((1.0, 1.25, 0.8), **AT),
        ImplicitShape(
            X**2 + sp.Rational(16, 25) * Y**2 + sp.Rational(25, 16) * Z**2 - 1,
            **AT,
        ),
    ),
    "implicit ellipsoid by parameters": (
        Ellipsoid((1.0, 1.25, 0.8), **AT),
        ImplicitShape(
            real_symbol("p_x") * X**2
            + Y**2 / real_symbol("l_y") ** 2
            + Z**2 / real_symbol("l_z") ** 2
            - 1,
            {real_symbol("p_x"): 1.0, real_symbol("l_y"): 1.25, real_symbol("l_z"): 0.8},
            **AT,
        ),
    ),
}

TOLD = ("omega", "omegadot", "N", "M", "energy", "normal_force", "friction_force")


def portraits(shapes, surface, contact):
    return [
        Portrait(rolling_system(Body(1.3, FULL, shape, ROTORS), SURFACES[surface], contact, FIELD))
        for shape in shapes
    ]


def assert_same(one, other, names=TOLD, tolerance=1e-11):
    for name in names:
        scale = 1 + np.abs(one[name]).max()
        assert np.abs(other[name] - one[name]).max() < tolerance * scale, name


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("twins", TWINS.values(), ids=TWINS)
def test_twins_move_alike(twins, surface, contact):
    """At random states; the contact point of the implicit ones is that of their twins."""
    first, second = portraits(twins, surface, contact)

    @given(omega=coordinates, gamma=directions, zeta=directions)
    @settings(max_examples=10, database=None)
    def compare(omega, gamma, zeta):
        assume(np.hypot(gamma[0], gamma[1]) > 0.05)
        if contact == "rubber":
            omega = omega - (omega @ gamma) * gamma
        one = first.at(first.state(omega=omega, gamma=gamma, zeta=zeta))
        r = one["r"]
        other = second.at(second.state(omega=omega, gamma=gamma, zeta=zeta, r=r))
        assert_same(one, other)
        if "rate of gamma" in other:
            assert_same(one, other, ["rate of gamma"])
        else:
            assert np.abs(other["gamma"] - gamma).max() < 1e-12
            assert (
                np.abs(
                    second.along(second.state(omega=omega, zeta=zeta, r=r))["gamma"]
                    - one["rate of gamma"]
                ).max()
                < 1e-10
            )

    compare()


@pytest.mark.slow
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("surface", SURFACES)
@given(omega=coordinates, gamma=directions, zeta=directions)
@settings(max_examples=5)
def test_torus_without_a_hole_is_a_ball_and_without_a_tube_a_disk(
    surface, contact, omega, gamma, zeta
):
    assume(np.hypot(gamma[0], gamma[1]) > 0.1)
    if contact == "rubber":
        omega = omega - (omega @ gamma) * gamma
    key = surface, contact
    if key not in RINGS:
        RINGS[key] = portraits([Torus(0.8, 0.2, **AT), Ball(0.2, **AT), Disk(0.8, **AT)], *key)
    torus, ball, disk = RINGS[key]
    for twin, change, tolerance in ((ball, {"R": 1e-12}, 1e-9), (disk, {"rho": 0.0}, 1e-12)):
        expected = twin.at(twin.state(omega=omega, gamma=gamma, zeta=zeta))
        found = torus.at(torus.state(change, omega=omega, gamma=gamma, zeta=zeta), change)
        assert_same(expected, found, [*TOLD, "rate of gamma"], tolerance)


RINGS: dict[tuple[str, str], list[Portrait]] = {}


@pytest.mark.parametrize("contact", ["marble", "rubber"])
@given(omega=coordinates, gamma=directions, zeta=directions)
@settings(max_examples=10)
def test_hollow_ball_is_a_ball_of_negative_radius(contact, omega, gamma, zeta):
    if contact == "rubber":
        omega = omega - (omega @ gamma) * gamma
    if contact not in HOLLOW:
        HOLLOW[contact] = portraits(
            [Ball(3.4, hollow=True, **AT), Ball(3.4, **AT)], "outside", contact
        )
    hollow, full = HOLLOW[contact]
    expected = hollow.at(hollow.state(omega=omega, gamma=gamma, zeta=zeta))
    change = {"R": -3.4}
    found = full.at(full.state(change, omega=omega, gamma=gamma, zeta=zeta), change)
    assert_same(expected, found, [*TOLD, "rate of gamma"])


HOLLOW: dict[str, list[Portrait]] = {}


# ---------------------------------------------------------------------------------------------
# Where the equations end


def guards(shape, gamma):
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), shape))
    one = Portrait(system, {f"{i}": guard.value for i, guard in enumerate(system.guards)})
    here = one.at(one.state(gamma=np.asarray(gamma)))
    return {(g.name, i): here[f"{i}"][0] for i, g in enumerate(system.guards)}


@pytest.mark.parametrize("shape", [Disk(1.0), Torus(1.0, 0.1)], ids=["disk", "torus"])
def test_edge_lies_flat_below_a_millionth_of_a_radian(shape):
    for lean, above in ((1.01e-6, True), (0.99e-6, False)):
        ((name, value),) = guards(shape, (0.6 * lean, -0.8 * lean, 1.0)).items()
        assert name[0] == "flat"
        assert (value > 0) == above


def test_body_of_revolution_ends_where_it_is_not_convex():
    """Radii of curvature p - u p' and that plus (1 - u^2) p'' for p = 1 + u^2/2."""
    shape = ShapeOfRevolution(1 + U**2 / 2)
    for u, parallel, meridian in ((0.5, 0.875, 1.625), (0.0, 1.0, 2.0)):
        values = list(guards(shape, (np.sqrt(1 - u**2), 0.0, u)).values())
        assert values == pytest.approx([parallel * meridian, parallel + meridian])
    dented = guards(ShapeOfRevolution(1 - sp.Rational(2, 3) * U**2), (1.0, 0.0, 0.0))
    assert min(dented.values()) < 0


def test_disk_does_not_start_flat():
    system = rolling_system(Body(1.0, (1.0, 1.0, 2.0), Disk(1.0)))
    with pytest.raises(InputError, match=r"the body lies flat \(tilt below 1e-06 rad\)"):
        initial_state(system, (0.0, 0.0, 1.0), (0.0, 0.0, 1.0))


# ---------------------------------------------------------------------------------------------
# Wrong input


A_PROFILE = "-gamma_3 chi_1 + (1 - gamma_3^2) chi_1' + gamma_3 chi_2' is"
bulge = real_symbol("bulge")

MISTAKES = {
    "ball": (lambda: Ball(-1.0), "radius -1.0 of the ball: it must be a positive finite number"),
    "point": (lambda: Ball(0.0), "radius 0.0 of the ball: it must be a positive finite number"),
    "infinite ball": (lambda: Ball(np.inf), "radius inf of the ball"),
    "disk": (lambda: Disk(np.nan), "radius nan of the disk"),
    "tube": (lambda: Torus(1.0, -0.1), "tube -0.1 of the torus: it must be a positive finite"),
    "ring": (lambda: Torus(0.0, 0.1), "radius 0.0 of the torus"),
    "semi-axis": (
        lambda: Ellipsoid((1.0, 0.0, 1.0)),
        "semi-axis 2 0.0 of the ellipsoid: it must be a positive finite number",
    ),
    "two semi-axes": (
        lambda: Ellipsoid((1.0, 2.0)),
        "axes (1.0, 2.0) of the ellipsoid: three semi-axes are needed",
    ),
    "turn": (
        lambda: Ellipsoid((1.0, 1.0, 1.0), turn=np.nan),
        "turn nan of the ellipsoid: it must be a finite angle",
    ),
    "centre": (
        lambda: Ball(1.0, centre=(0.0, 0.0)),
        "centre (0.0, 0.0): it must be three finite numbers",
    ),
    "centre far away": (
        lambda: Disk(1.0, centre=(0.0, np.inf, 0.0)),
        "centre (0.0, inf, 0.0): it must be three finite numbers",
    ),
    "support": (
        lambda: ShapeOfRevolution(U - sp.Rational(1, 2)),
        "support function gamma_3 - 1/2 is -1.5 at gamma_3 = -1: it must be positive, the distance",
    ),
    "imaginary support": (
        lambda: ShapeOfRevolution(sp.sqrt(U)),
        "support function sqrt(gamma_3) is nan at gamma_3 = -1: it must be positive",
    ),
    "symbol of a support": (
        lambda: ShapeOfRevolution(1 + bulge * U),
        "bulge is not known; it may use gamma_3 and the parameters of the shape",
    ),
    "parameter of a support": (
        lambda: ShapeOfRevolution(1 + bulge * U, {bulge: np.inf}),
        "parameter bulge = inf: it must be a finite number",
    ),
    "profile": (
        lambda: ShapeOfRevolution.from_profile(sp.Integer(-1), -2 * U),
        f"profile chi_1 = -1, chi_2 = -2*gamma_3: the surface has no normal -gamma, since "
        f"{A_PROFILE} 0.941176470588235 at gamma_3 = -16/17 and must be zero",
    ),
    "profile a little off": (
        lambda: ShapeOfRevolution.from_profile(sp.Integer(-1), -U * (1 + sp.Rational(1, 10**7))),
        "the surface has no normal -gamma",
    ),
    "profile inside out": (
        lambda: ShapeOfRevolution.from_profile(sp.Integer(1), U),
        "support function -1 is -1 at gamma_3 = -1: it must be positive",
    ),
    "symbol of a profile": (
        lambda: ShapeOfRevolution.from_profile(-bulge, -U),
        "profile chi_1 = -bulge, chi_2 = -gamma_3: bulge is not known; it may use gamma_3 and the "
        "parameters of the shape",
    ),
    "surface": (
        lambda: ImplicitShape(X**2 + Y**2 + Z**2 + 1),
        "surface x**2 + y**2 + z**2 + 1 = 0: the left side is 1.00000000000000 at the geometric "
        "centre x = y = z = 0, and must be negative there (negative inside, zero on the surface)",
    ),
    "surface through the centre": (
        lambda: ImplicitShape(X**2 + Y**2 + Z**2 - X),
        "the left side is 0",
    ),
    "surface with a pole": (lambda: ImplicitShape(1 / X - 1), "the left side is zoo"),
    "symbol of a surface": (
        lambda: ImplicitShape(X**2 + Y**2 + bulge * Z**2 - 1),
        "bulge is not known; it may use x, y, z and the parameters of the shape",
    ),
    "parameter of a surface": (
        lambda: ImplicitShape(X**2 + Y**2 + bulge * Z**2 - 1, {bulge: np.nan}),
        "parameter bulge = nan: it must be a finite number",
    ),
}


@pytest.mark.parametrize(("make", "message"), MISTAKES.values(), ids=MISTAKES)
def test_mistake_is_named(make, message):
    with pytest.raises(InputError, match=re.escape(message)):
        make()


def test_profile_may_be_rounded():
    """Decimals do not cancel to the last digit."""
    big = 1e6
    chi_2 = sp.Float(-big) * U + sp.Float("1e-7")
    assert ShapeOfRevolution.from_profile(sp.Float(-big), chi_2).support.has(U)


def test_parameters_carry_the_numbers():
    shape = ShapeOfRevolution(1 + bulge * U**2, {bulge: 0.1}, centre=(0.0, 0.0, 0.2))
    system = rolling_system(Body(1.0, (1.0, 1.0, 1.0), shape))
    assert system.defaults[bulge] == 0.1
    assert [system.defaults[s] for s in Vector("c").symbols] == [0.0, 0.0, 0.2]
    assert all(
        symbol not in rolling_system(Body(1.0, (1.0,) * 3, Ball(1.0))).defaults
        for symbol in Vector("c")
    )


def test_quartic_body_is_convex():
    """What the property tests roll is inside the domain of the equations."""
    hessian = sp.lambdify(XYZ, sp.hessian(QUARTIC, XYZ))
    points = np.random.default_rng(0).uniform(-1.1, 1.1, (200, 3))
    assert min(np.linalg.eigvalsh(np.array(hessian(*s), float))[0] for s in points) > 0


def test_symbols_are_known_by_their_names() -> None:
    """A symbol without real=True is meant as the one of this name."""
    loose, a = sp.Symbol("gamma_3"), sp.Symbol("a")
    shape = ShapeOfRevolution(1 + a * loose / 10, {a: 0.5})
    assert shape == ShapeOfRevolution(
        1 + real_symbol("a") * real_symbol("gamma_3") / 10, {real_symbol("a"): 0.5}
    )
    assert ShapeOfRevolution.from_profile(sp.S(-1), -loose).support == 1
    x, y, z = sp.symbols("x y z")
    assert ImplicitShape(x**2 + y**2 + a * z**2 - 1, {a: 2.0}).surface.free_symbols == {
        *ImplicitShape.coordinates,
        real_symbol("a"),
    }
    body = Body(1.0, (1.0, 1.5, 2.1), Ball(1.0))
    loaded = [
        rolling_system(body, Plane(), "marble", Forces(0.0, potential, {b: 2.0}))
        for potential, b in (
            (a * loose**2, a),
            (real_symbol("a") * real_symbol("gamma_3") ** 2, real_symbol("a")),
        )
    ]
    assert loaded[0] == loaded[1]


@pytest.mark.parametrize("formula", ["x**2 + y**2 - z**2 - 1", "x**2 + y**2 - 1", "z + x**2 - 1"])
def test_an_open_surface_is_no_body(formula: str) -> None:
    with pytest.raises(InputError, match="it is not closed; in the direction "):
        ImplicitShape(sp.sympify(formula))
