"""Kinematics of a body above its support, and definitions put in order."""

from __future__ import annotations

import numpy as np
import sympy as sp

from flowlanes.system.named_formulas import by_dependence
from flowlanes.system.vectors import Vector, cross, dot, real_symbol
from nonholonomic.contact.equations.free_body import free_body
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.dry_friction import Coulomb
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

x, y = real_symbol("x"), real_symbol("y")
u, w = Vector("u"), Vector("w")
BODY = Body(0.7, (0.3, 0.4, 0.5), Ball(0.9, centre=(0.1, 0.0, 0.0)))


def test_definitions_are_parted_by_what_they_depend_on():
    definitions = ((u, cross(w, Vector("n"))), (x, dot(w, w)), (y, 2 * x), (w, 3 * u))
    before, after = by_dependence(definitions, [u.symbols[0]])
    assert before == definitions[:3]
    assert after == definitions[3:]
    before, after = by_dependence(definitions, w.symbols)
    assert (before, after) == ((), definitions)


def names(situation, touching):
    return [str(name) for name, _ in free_body(situation, touching).definitions]


def test_every_quantity_is_defined_once_and_after_what_it_needs():
    for surface in (Plane(), Plane(turntable=1.0), Sphere(3.0), Sphere(3.0, turntable=0.4)):
        for touching in (True, False):
            found = names(FrictionalContact(BODY, surface, (Coulomb(0.1),)), touching)
            assert len(set(found)) == len(found)
            assert ("gap" in found) != touching


def test_a_support_at_rest_has_no_velocity():
    free = free_body(FrictionalContact(BODY), True)
    assert free.turning == 0
    assert not free.support_velocity.as_explicit().free_symbols
    turning = free_body(FrictionalContact(BODY, Plane(turntable=0.3)), True)
    assert [p.default for p in turning.parameters if str(p.symbol) == "Omega_s"] == [0.3]


def test_mobility_is_that_of_the_contact():
    free = free_body(FrictionalContact(BODY, field=Forces(gravity=1.0)), True)
    values = dict(free.definitions)
    mobility = values[free.mobility]
    r = np.array([0.2, -0.5, 0.7])
    inverse = np.diag([1 / 0.3, 1 / 0.4, 1 / 0.5])
    given = dict(zip(Vector("r").symbols, r, strict=True)) | {real_symbol("m"): 0.7}
    given |= dict(zip(free.inverse_inertia.symbols, inverse.diagonal(), strict=True))
    found = np.array(sp.Matrix(mobility).xreplace(given), dtype=float)
    for force in np.eye(3):
        turn = np.cross(inverse @ np.cross(r, force), r)
        np.testing.assert_allclose(found @ force, force / 0.7 + turn, atol=1e-15)
