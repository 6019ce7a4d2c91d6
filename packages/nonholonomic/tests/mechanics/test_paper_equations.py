"""The derived equations against those of the paper, exactly, at rational points.

Every formula is written here once more, by hand, from the paper; misprints are corrected by
derivation and said so.  All numbers are rational: the points lie exactly on the phase space and
both sides are compared without any tolerance.
"""

from __future__ import annotations

from dataclasses import dataclass

import pytest
import sympy as sp

from flowlanes.system.vectors import Vector, real_symbol, to_components
from mechanics.compare import GAMMA, XYZ
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from spread import spread

E = sp.eye(3)
G = sp.Matrix(GAMMA)


def vector(*numbers):
    return sp.Matrix([sp.Rational(x) for x in numbers])


# Decimals, so that the package's floating-point numbers mean these rationals.
MASS, GRAVITY = sp.Rational("1.3"), sp.Rational("9.81")
RADIUS, TUBE = sp.Rational("0.75"), sp.Rational("0.25")
PRINCIPAL = sp.diag(*vector("1.2", "1.5", "2.1"))
FULL = vector("1.2", "0.1", "-0.2", "0.1", "1.5", "0.3", "-0.2", "0.3", "2.1").reshape(3, 3)
ROTORS = vector("0.3", "-0.4", "0.5")
CENTRE = vector("0.1", "-0.2", "0.3")
NONE = sp.zeros(3, 1)
POTENTIAL = GAMMA[0] * GAMMA[1] / 2 + GAMMA[2] ** 2 / 4 - GAMMA[0] / 3

# Unit vectors at which the roots in all shapes below are rational.
NORMALS = {
    "steep": vector("9/17", "-12/17", "8/17"),
    "shallow": vector("-25/169", "60/169", "-12/13"),
}
SPIN = vector("7/5", "-2/3", "9/4")
VERTICAL = vector("2/11", "6/11", "-9/11")

AXES = vector("0.8", "1", "1.25")
SQUARES = sp.diag(*(x**2 for x in AXES))
TURN = sp.atan(sp.Rational(3, 4))
TURNED = sp.Matrix([[4, -3, 0], [3, 4, 0], [0, 0, 5]]) / 5


def without_spin(omega, gamma):
    return omega - omega.dot(gamma) * gamma


def floats(numbers):
    return tuple(float(x) for x in numbers)


def body(shape, tensor=PRINCIPAL, rotors=NONE):
    principal = tensor == PRINCIPAL
    inertia = floats(tensor.diagonal()) if principal else tuple(map(floats, tensor.tolist()))
    return Body(float(MASS), inertia, shape, floats(rotors))


@dataclass
class Point:
    """A System at one rational point of its phase space."""

    system: object
    state: dict

    def __post_init__(self):
        self.known = {p.symbol: sp.Rational(str(p.default)) for p in self.system.parameters}
        if real_symbol("delta") in self.known:
            self.known[real_symbol("delta")] = TURN
        for name in self.system.state:
            self.known |= dict(zip(name.symbols, self.state[str(name)], strict=True))
        for symbol, formula in self.system.scalar_definitions:
            self.known[symbol] = formula.xreplace(self.known)
        self.rates = dict(zip(self.system.symbols, self.system.rates, strict=True))

    def __call__(self, formula):
        """The value of a formula."""
        value = to_components(formula)
        parts = sp.Matrix(value) if isinstance(value, sp.MatrixBase) else value
        return parts.xreplace(self.known)

    def __getitem__(self, name):
        """A state variable or a definition."""
        return sp.Matrix([symbol.xreplace(self.known) for symbol in Vector(name).symbols])

    def rate(self, name):
        return sp.Matrix([self.rates[s].xreplace(self.known) for s in Vector(name).symbols])

    def observable(self, name):
        return self(next(o.value for o in self.system.observables if o.name == name))


# ---------------------------------------------------------------------------------------------
# Any body on a plane or a sphere: (1.17)-(1.19), (1.23)


@dataclass
class Motion:
    """Rates and reactions of a body whose contact point is r(gamma).

    (1.18) and (1.19) on a plane, (1.23) on a sphere of radius a.  Two things are not as printed
    for a sphere.  The printed torque gamma x dU/dgamma does the work of U only if gamma moves
    as on a plane; for gamma' = S omega it is -S^T dU/dgamma.  And (1.19) forgets that there
    (omega, gamma') does not vanish.
    """

    r_of_gamma: sp.Matrix
    gamma: sp.Matrix
    omega: sp.Matrix
    tensor: sp.Matrix
    rotors: sp.Matrix
    radius: sp.Rational | None
    rubber: bool

    def __post_init__(self):
        omega, gamma = self.omega, self.gamma
        here = dict(zip(GAMMA, gamma, strict=True))
        self.r = r = self.r_of_gamma.xreplace(here)
        slope = self.r_of_gamma.jacobian(GAMMA).xreplace(here)
        curvature = 0 if self.radius is None else 1 / self.radius
        hat = sp.Matrix(
            [[0, -gamma[2], gamma[1]], [gamma[2], 0, -gamma[0]], [-gamma[1], gamma[0], 0]]
        )
        turning = (E - curvature * slope).inv() * hat
        self.gammadot = turning * omega
        self.rdot = slope * self.gammadot
        self.about_contact = self.tensor + MASS * (r.dot(r) * E - r * r.T)

        vertical = gamma if self.radius is None else VERTICAL
        self.weight = -MASS * GRAVITY * vertical
        dU = sp.Matrix([POTENTIAL.diff(s) for s in GAMMA]).xreplace(here)
        torque = (
            (self.about_contact * omega + self.rotors).cross(omega)
            - MASS * r.cross(omega.cross(self.rdot))
            - r.cross(self.weight)
            - turning.T * dU
        )
        inverse = self.about_contact.inv()
        self.spin_torque = sp.S.Zero
        if self.rubber:
            along = (inverse * gamma).dot(torque) + omega.dot(self.gammadot)
            self.spin_torque = -along / gamma.dot(inverse * gamma)
        self.omegadot = inverse * (torque + self.spin_torque * gamma)

    @property
    def momentum(self):
        return self.about_contact * self.omega

    @property
    def momentum_rate(self):
        r, rdot = self.r, self.rdot
        change = MASS * (2 * r.dot(rdot) * E - r * rdot.T - rdot * r.T)
        return change * self.omega + self.about_contact * self.omegadot

    @property
    def force(self):
        """N = m (v' + omega x v) - F with v = r x omega, from the first of (1.17)."""
        r, omega = self.r, self.omega
        velocity = r.cross(omega)
        change = self.rdot.cross(omega) + r.cross(self.omegadot)
        return MASS * (change + omega.cross(velocity)) - self.weight


SUPPORT = 1 + GAMMA[2] ** 2 / 5 - GAMMA[2] / 10


def r_of_ellipsoid(matrix):
    return CENTRE - matrix * G / sp.sqrt((G.T * matrix * G)[0])


RIM = sp.Matrix([GAMMA[0], GAMMA[1], 0]) / sp.sqrt(GAMMA[0] ** 2 + GAMMA[1] ** 2)
AT = {"centre": floats(CENTRE)}
X, Y, Z = XYZ

# The shape, its r(gamma) by hand, and the turn of the normals at which roots are rational.
SHAPES = {
    "ball": (Ball(float(RADIUS), **AT), CENTRE - RADIUS * G, E),
    "ellipsoid": (Ellipsoid(floats(AXES), **AT), r_of_ellipsoid(SQUARES), E),
    "turned ellipsoid": (
        Ellipsoid(floats(AXES), turn=float(TURN), **AT),
        r_of_ellipsoid(TURNED * SQUARES * TURNED.T),
        TURNED,
    ),
    "disk": (Disk(float(RADIUS), **AT), CENTRE - RADIUS * RIM, E),
    "torus": (
        Torus(float(RADIUS), float(TUBE), **AT),
        CENTRE - RADIUS * RIM - TUBE * G,
        E,
    ),
    # The support function of a surface gives its points as the gradient of p(nu) of degree one.
    "revolution": (
        ShapeOfRevolution(SUPPORT, **AT),
        CENTRE - SUPPORT * G - SUPPORT.diff(GAMMA[2]) * (sp.Matrix([0, 0, 1]) - GAMMA[2] * G),
        E,
    ),
    "implicit": (
        ImplicitShape(
            X**2 / AXES[0] ** 2 + Y**2 / AXES[1] ** 2 + Z**2 / AXES[2] ** 2 - 1,
            **AT,
        ),
        r_of_ellipsoid(SQUARES),
        E,
    ),
}
RADII = {"plane": None, "outside": sp.Rational("2.5"), "inside": sp.Rational("-4.5")}


def surface(radius):
    return Plane() if radius is None else Sphere.of_signed_radius(float(radius))


@pytest.mark.slow
@pytest.mark.parametrize("normal", spread(NORMALS))
@pytest.mark.parametrize(("tensor", "rotors"), [(PRINCIPAL, NONE), (FULL, ROTORS)])
@pytest.mark.parametrize("contact", ["marble", "rubber"])
@pytest.mark.parametrize("support", RADII)
@pytest.mark.parametrize("name", SHAPES)
def test_body_on_plane_or_sphere(name, support, contact, tensor, rotors, normal):
    shape, r_of_gamma, turn = SHAPES[name]
    field = Forces(float(GRAVITY), POTENTIAL)
    system = rolling_system(body(shape, tensor, rotors), surface(RADII[support]), contact, field)
    gamma = turn * NORMALS[normal]
    omega = without_spin(SPIN, gamma) if contact == "rubber" else SPIN
    motion = Motion(r_of_gamma, gamma, omega, tensor, rotors, RADII[support], contact == "rubber")
    point = Point(
        system,
        {"gamma": gamma, "r": motion.r, "omega": omega, "M": motion.momentum, "zeta": VERTICAL},
    )

    assert [point(relation) for relation in system.relations] == [0] * len(system.relations)
    assert point["omega"] == omega
    assert point["M"] == motion.momentum
    assert point["gamma"] == gamma
    assert point["omegadot"] == motion.omegadot
    if contact == "marble":
        assert point.rate("M") == motion.momentum_rate
    else:
        assert point.rate("omega") == motion.omegadot
        assert point.observable("spin_torque") == motion.spin_torque
    if name == "implicit":
        assert point.rate("r") == motion.rdot
    else:
        assert point.rate("gamma") == motion.gammadot
    if support != "plane":
        assert point.rate("zeta") == VERTICAL.cross(omega)
    assert point.observable("normal_force") == motion.force.dot(gamma)
    assert point.observable("friction_force") == motion.force - motion.force.dot(gamma) * gamma


# ---------------------------------------------------------------------------------------------
# Balls, as the paper writes them


def ball_point(system, gamma, omega, momentum=NONE):
    return Point(system, {"gamma": gamma, "omega": omega, "M": momentum, "zeta": VERTICAL})


DU = sp.Matrix([POTENTIAL.diff(s) for s in GAMMA])


def gradient(gamma):
    return DU.xreplace(dict(zip(GAMMA, gamma, strict=True)))


@pytest.mark.parametrize("rotors", [NONE, ROTORS])
@pytest.mark.parametrize("normal", NORMALS)
def test_chaplygin_ball(normal, rotors):
    """(1.20), (7.1), and with rotors the equations of section 7.4."""
    gamma, omega, a, D = NORMALS[normal], SPIN, RADIUS, MASS * RADIUS**2
    system = rolling_system(body(Ball(float(a)), rotors=rotors), field=Forces(potential=POTENTIAL))
    M = PRINCIPAL * omega + D * gamma.cross(omega.cross(gamma))
    point = ball_point(system, gamma, omega, M)
    assert point["omega"] == omega
    couple = gamma.cross(gradient(gamma))
    gammadot = gamma.cross(omega)
    assert point.rate("gamma") == gammadot
    assert point.rate("M") == (M + rotors).cross(omega) + couple
    tilde = PRINCIPAL + D * E - D * gamma * gamma.T
    right = (tilde * omega + rotors).cross(omega) - D * gamma.cross(omega.cross(gammadot)) + couple
    assert tilde * point["omegadot"] == right


@pytest.mark.parametrize("normal", NORMALS)
def test_rubber_chaplygin_ball(normal):
    """Section 2.4: J omega' = J omega x omega + gamma x dU/dgamma + lambda_0 gamma."""
    gamma = NORMALS[normal]
    omega = without_spin(SPIN, gamma)
    system = rolling_system(
        body(Ball(float(RADIUS))), contact="rubber", field=Forces(potential=POTENTIAL)
    )
    point = ball_point(system, gamma, omega)
    J = PRINCIPAL + MASS * RADIUS**2 * E
    couple = gamma.cross(gradient(gamma))
    free = (J * omega).cross(omega) + couple
    multiplier = -(J.inv() * gamma).dot(free) / (J.inv() * gamma).dot(gamma)
    assert J * point.rate("omega") == free + multiplier * gamma
    assert point.observable("spin_torque") == multiplier


BALLS_ON_SPHERES = {
    "outside": (Ball(float(RADIUS)), sp.Rational("2.5"), RADIUS),
    "inside": (Ball(float(RADIUS)), sp.Rational("-2.5"), RADIUS),
    "around": (Ball(float(RADIUS), hollow=True), sp.Rational("0.5"), -RADIUS),
}


@pytest.mark.parametrize("normal", NORMALS)
@pytest.mark.parametrize("where", BALLS_ON_SPHERES)
def test_ball_on_sphere(where, normal):
    """(8.1).

    Printed is M = I omega + d n x (n x omega); the momentum about the contact has the other
    sign, as in (7.1).  The text also exchanges the radii: in k = a/(a + b) and d = m b^2 a is
    that of the sphere and b, counted negative for a hollow ball, that of the body.
    """
    shape, a, b = BALLS_ON_SPHERES[where]
    n, omega, d, k = NORMALS[normal], SPIN, MASS * b**2, a / (a + b)
    system = rolling_system(body(shape), Sphere.of_signed_radius(float(a)))
    M = PRINCIPAL * omega + d * n.cross(omega.cross(n))
    point = ball_point(system, n, omega, M)
    assert point["omega"] == omega
    assert point.rate("M") == M.cross(omega)
    assert point.rate("gamma") == k * n.cross(omega)


@pytest.mark.parametrize("normal", NORMALS)
@pytest.mark.parametrize("where", BALLS_ON_SPHERES)
def test_rubber_ball_on_sphere(where, normal):
    """(9.2), without external torque; (omega, n') vanishes for a ball."""
    shape, a, b = BALLS_ON_SPHERES[where]
    n = NORMALS[normal]
    omega = without_spin(SPIN, n)
    system = rolling_system(body(shape), Sphere.of_signed_radius(float(a)), "rubber")
    point = ball_point(system, n, omega)
    J = PRINCIPAL + MASS * b**2 * E
    gyroscopic = (J * omega).cross(omega)
    multiplier = -gyroscopic.dot(J.inv() * n) / n.dot(J.inv() * n)
    assert J * point.rate("omega") == gyroscopic + multiplier * n
    assert point.rate("gamma") == a / (a + b) * n.cross(omega)


@pytest.mark.parametrize("normal", NORMALS)
def test_unbalanced_ball(normal):
    """(10.1).

    With a from the centre of mass to the geometric centre it is r = a - R gamma; printed is
    -R gamma - a, which does not agree with r' = (r - a) x omega.
    """
    gamma, omega, a = NORMALS[normal], SPIN, CENTRE
    system = rolling_system(body(Ball(float(RADIUS), **AT)))
    r = a - RADIUS * gamma
    rdot = (r - a).cross(omega)
    M = PRINCIPAL * omega + MASS * r.cross(omega.cross(r))
    point = ball_point(system, gamma, omega, M)
    assert point["omega"] == omega
    assert point.rate("M") == M.cross(omega) + MASS * rdot.cross(omega.cross(r))
    assert -RADIUS * point.rate("gamma") == rdot


@pytest.mark.parametrize("normal", NORMALS)
def test_unbalanced_rubber_ball(normal):
    """(10.4), with r as in (10.1)."""
    gamma, a = NORMALS[normal], CENTRE
    omega = without_spin(SPIN, gamma)
    system = rolling_system(body(Ball(float(RADIUS), **AT)), contact="rubber")
    r = a - RADIUS * gamma
    gammadot = gamma.cross(omega)
    tilde = PRINCIPAL + MASS * (r.dot(r) * E - r * r.T)
    free = (tilde * omega).cross(omega) - MASS * r.cross(omega.cross(-RADIUS * gammadot))
    inverse = tilde.inv()
    multiplier = -(inverse * gamma).dot(free) / (inverse * gamma).dot(gamma)
    point = ball_point(system, gamma, omega)
    assert tilde * point.rate("omega") == free + multiplier * gamma
    assert point.rate("gamma") == gammadot
    assert point.observable("spin_torque") == multiplier


def test_potential_energy_is_that_of_the_height():
    """(1.16): U = mgh = -mg (r, gamma)."""
    gamma = NORMALS["steep"]
    motion = Motion(SHAPES["torus"][1], gamma, NONE, PRINCIPAL, NONE, None, False)
    system = rolling_system(body(SHAPES["torus"][0]), field=Forces(float(GRAVITY)))
    point = ball_point(system, gamma, NONE)
    assert point(system.laws[0].value) == -MASS * GRAVITY * motion.r.dot(gamma)


def test_profile_of_a_body_of_revolution():
    """Section 5: r = (chi_1 gamma_1, chi_1 gamma_2, chi_2), and its potential energy."""
    u = GAMMA[2]
    chi_1, chi_2 = -1 + u**2 / 5, -u * (1 + sp.Rational(2, 5)) + u**3 / 5
    shape = ShapeOfRevolution.from_profile(chi_1, chi_2, **AT)
    gamma = NORMALS["steep"]
    system = rolling_system(body(shape), field=Forces(float(GRAVITY)))
    point = ball_point(system, gamma, NONE)
    profile = sp.Matrix([chi_1 * gamma[0], chi_1 * gamma[1], chi_2]).xreplace({u: gamma[2]})
    assert point["r"] == profile + CENTRE
    height = -(chi_1 * (1 - u**2) + chi_2 * u).xreplace({u: gamma[2]}) - CENTRE.dot(gamma)
    assert point(system.laws[0].value) == MASS * GRAVITY * height
