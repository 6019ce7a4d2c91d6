"""Growth vectors of distributions that everybody knows, and of random ones by another method."""

from __future__ import annotations

import random

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector, norm_squared, to_components
from nonholonomic.mechanics.constraints.distribution import distribution_spanned_by
from nonholonomic.mechanics.constraints.growth import filtration, generic, growth
from nonholonomic.mechanics.lagrangian.structure_functions import commutator, lie_derivative

x, y, z, u, w, p = sp.symbols("x y z u w p", real=True)
ONE = sp.S.One

FLAT = {
    "integrable": ([{x: ONE, z: y}, {y: ONE, z: x}], (x, y, z), (2,)),
    "Heisenberg": ([{x: ONE}, {y: ONE, z: x}], (x, y, z), (2, 3)),
    "Engel": ([{x: ONE}, {y: ONE, z: x, u: x**2 / 2}], (x, y, z, u), (2, 3, 4)),
    "Cartan": ([{x: ONE}, {y: ONE, z: x, u: x**2 / 2, w: x * y}], (x, y, z, u, w), (2, 3, 5)),
    "skate": ([{x: sp.cos(p), y: sp.sin(p)}, {p: ONE}], (x, y, p), (2, 3)),
    "spirals": ([{x: sp.exp(p), y: sp.exp(2 * p)}, {p: ONE}], (x, y, p), (2, 3)),
    "all directions": ([{x: ONE}, {y: 1 + x**2}], (x, y), (2,)),
}


@pytest.mark.parametrize("name", FLAT)
def test_growth_of_known_distributions(name):
    fields, coordinates, expected = FLAT[name]
    found = generic(distribution_spanned_by(name, fields, coordinates))
    assert found.growth == expected
    assert found.dimension == len(coordinates)
    assert found.is_final
    assert [len(step) for step in found.words] == [
        b - a for a, b in zip((0, *expected), expected, strict=False)
    ]


SINGULAR = [
    ({y: ONE, z: x**2}, {x: 0, y: 0, z: 0}, (2, 2, 3)),
    ({y: ONE, z: x**2}, {x: 1, y: 0, z: 0}, (2, 3)),
    ({y: ONE, z: x**2}, {x: sp.Rational(1, 3)}, (2, 3)),
    ({y: ONE, z: x**5}, {x: 0, y: 3, z: 1}, (2, 2, 2, 2, 2, 3)),
    ({y: ONE, z: sp.sin(x) ** 2}, {x: sp.pi, y: 0, z: 0}, (2, 2, 3)),
    ({y: ONE, z: sp.cos(x)}, {x: sp.pi, y: 0, z: 0}, (2, 2, 3)),
    ({y: ONE, z: sp.cos(x)}, {x: sp.pi / 3, y: 0, z: 0}, (2, 3)),
    ({y: ONE, z: sp.cos(x)}, {x: sp.Rational(1, 3), y: 0, z: 0}, (2, 3)),
    ({y: ONE, z: x**3 - 2 * x}, {x: sp.sqrt(sp.Rational(2, 3)), y: 0, z: 0}, (2, 2, 3)),
    ({y: ONE, z: x**3 - 2 * x}, {x: sp.sqrt(2), y: 0, z: 0}, (2, 3)),
]


@pytest.mark.parametrize(("second", "point", "expected"), SINGULAR)
def test_growth_drops_at_singular_points(second, point, expected):
    given = distribution_spanned_by("martinet", [{x: ONE}, second], (x, y, z))
    assert filtration(given, point).growth == expected
    assert generic(given).growth == (2, 3)


def test_a_point_that_no_commutator_leaves_is_not_called_settled():
    given = distribution_spanned_by("grushin", [{x: ONE}, {y: x**2, z: x**3 * y}], (x, y, z))
    assert filtration(given, {x: 0, y: 0, z: 0}).growth[0] == 1
    fixed = distribution_spanned_by("fixed", [{x: x}, {y: x}], (x, y))
    found = filtration(fixed, {x: 0, y: 0})
    assert found.growth[-1] == 0
    assert not found.is_final


@pytest.mark.parametrize("seed", range(6))
def test_growth_agrees_with_the_commutators_themselves(seed):
    """Every commutator written out, and its rank at a rational point by SymPy."""
    rng = random.Random(seed)
    coordinates = (x, y, z, u, w)
    fields = []
    for own in (x, y):
        rates = {
            s: sp.Rational(rng.randint(-2, 2)) * rng.choice((x, y, z, u, x * y, x**2))
            + rng.randint(-1, 1) * rng.choice((x, y, x * y))
            for s in (z, u, w)
        }
        fields.append({own: ONE, **rates})
    point = {s: sp.Rational(rng.randint(1, 9), rng.randint(2, 7)) for s in coordinates}
    span, last, ranks = list(fields), list(fields), []
    while len(ranks) < 2 or ranks[-1] > ranks[-2]:
        rows = [[f.get(s, sp.S.Zero).subs(point) for s in coordinates] for f in span]
        ranks.append(sp.Matrix(rows).rank())
        last = [commutator(f, g) for f in fields for g in last]
        span += last
    assert growth(fields, coordinates, point) == tuple(ranks[:-1])


def test_redundant_coordinates():
    """Rotations about two axes span all three."""
    gamma = Vector("gamma")
    a, b, c = gamma.symbols
    fields = [{b: c, c: -b}, {c: a, a: -c}]
    found = generic(
        distribution_spanned_by(
            "turns", fields, gamma.symbols, (to_components(norm_squared(gamma)) - 1,)
        )
    )
    assert (found.growth, found.dimension) == ((2,), 2)
    assert sum(value**2 for value in found.point.values()) == 1
    for field in fields:
        assert lie_derivative(field, to_components(norm_squared(gamma))) == 0


def test_a_point_off_the_relations_is_refused():
    given = distribution_spanned_by("circle", [{x: -y, y: x}], (x, y), (x**2 + y**2 - 1,))
    assert filtration(given, {x: sp.Rational(3, 5), y: sp.Rational(4, 5)}).growth == (1,)
    with pytest.raises(InputError, match="does not lie on"):
        filtration(given, {x: 1, y: 1})


def test_unknown_functions_are_refused():
    with pytest.raises(InputError, match=r"besselj.*cannot be computed exactly"):
        generic(distribution_spanned_by("drum", [{x: sp.besselj(0, y)}, {y: ONE}], (x, y, z)))
