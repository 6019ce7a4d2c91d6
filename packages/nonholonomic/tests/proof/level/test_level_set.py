"""Phase spaces and levels: triangular sets, points, settled and exchanged parameters."""

from __future__ import annotations

import random

import pytest
import sympy as sp

from catalogue import built
from flowlanes.errors import InputError
from flowlanes.formulas.errors import OutOfReachError
from flowlanes.formulas.number_fields import ball_precision
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Vector,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from lawproof.proof.level.level_set import LevelSet
from nonholonomic.catalogue import CATALOGUE, from_catalogue

M, gamma, omega = vectors("M gamma omega")
I_1, I_2, I_3, R, a, m = (real_symbol(n) for n in ("I_1", "I_2", "I_3", "R", "a", "m"))


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOGUE)
def test_points_lie_on_the_phase_space(name):
    system = built.system(name)
    ground = LevelSet(system)
    with ball_precision():
        for seed in range(3):
            values, exact = ground.point(random.Random(seed))
            field = ground.numbers(values, exact)
            evaluate = ground.evaluator(field)
            for relation in ground.conditions:
                assert field.vanishes(evaluate.value(relation))


def test_points_on_a_level_are_exactly_rational():
    ground = LevelSet(from_catalogue("chaplygin-ball"), (dot(M, gamma),))
    values, exact = ground.point(random.Random(0))
    assert exact
    evaluate = ground.evaluator(ground.numbers(values, exact))
    assert evaluate.value(ground.conditions[0]) == 0
    assert evaluate.value(ground.conditions[1]) == 0


def test_points_of_an_orthonormal_frame():
    alpha = Vector("alpha")
    system = System(
        name="frame",
        title="frame",
        field={alpha: 0 * gamma, gamma: 0 * gamma},
        relations=(norm_squared(alpha) - 1, norm_squared(gamma) - 1, dot(alpha, gamma)),
    )
    ground = LevelSet(system)
    with ball_precision():
        values, exact = ground.point(random.Random(0))
        field = ground.numbers(values, exact)
        evaluate = ground.evaluator(field)
        assert all(field.vanishes(evaluate.value(c)) for c in ground.conditions)
        assert not field.vanishes(evaluate.value(to_components(norm_squared(cross(alpha, gamma)))))


def test_a_ratio_of_radii_settles_a_radius():
    system = from_catalogue("ball-around-sphere")
    (linear,) = (law for law in system.laws if law.name == "linear")
    ground = LevelSet(system, linear.level)
    assert ground.fixed_parameters
    assert set(ground.fixed_parameters) <= {p.symbol for p in system.parameters}
    assert not set(ground.fixed_parameters) & set(ground.generators)


def test_equal_moments_settle_one_of_them():
    ground = LevelSet(from_catalogue("chaplygin-ball"), (I_1 - I_2,))
    assert ground.fixed_parameters == {I_1: I_2}


def test_the_inertia_at_the_contact_takes_the_place_of_the_inertia():
    ground = LevelSet(from_catalogue("unbalanced-ball"))
    names = {str(e.name): str(e.parameter) for e in ground.swapped_generators}
    assert names["J_1"] == "I_1"
    assert names["r_1"] == "c_1"


def test_exchanged_parameters_have_their_value_and_do_not_move():
    ground = LevelSet(from_catalogue("unbalanced-ball"))
    values, exact = ground.point(random.Random(1))
    field = ground.numbers(values, exact)
    along = ground.along(field)
    plain = ground.evaluator(field)
    steps = dict(ground.system.scalar_definitions)
    for change in ground.swapped_generators:
        assert along.slope(change.parameter) == 0
        assert plain.value(steps[change.name]) == values[str(change.name)]


def test_an_empty_level_is_refused():
    with pytest.raises(InputError, match="empty"):
        LevelSet(from_catalogue("chaplygin-ball"), (norm_squared(gamma) - 2,)).point(
            random.Random(0)
        )


def test_a_level_without_real_points_is_empty():
    ground = LevelSet(from_catalogue("chaplygin-ball"), (norm_squared(M) + 1,))
    with ball_precision(), pytest.raises(InputError, match="empty"):
        ground.point(random.Random(0))


def test_a_level_on_which_no_real_point_is_found_is_said():
    ground = LevelSet(from_catalogue("chaplygin-ball"), (norm_squared(M) - M.symbols[0] + 1,))
    with ball_precision(), pytest.raises((OutOfReachError, InputError)):
        ground.point(random.Random(0))


def test_a_level_with_an_unknown_symbol_is_refused():
    with pytest.raises(InputError, match="w"):
        LevelSet(from_catalogue("chaplygin-ball"), (real_symbol("w") - 1,)).point(random.Random(0))


def test_a_factor_that_a_special_body_annuls_is_not_taken_for_zero():
    """e₃ω₃ = 0 with e a parameter means ω₃ = 0."""
    e_3 = real_symbol("e_3")
    system = System(
        name="blade",
        title="blade",
        field={omega: 0 * omega},
        parameters=(Parameter(e_3, "component", 1.0),),
        relations=(e_3 * omega.symbols[2],),
    )
    values, _ = LevelSet(system).point(random.Random(0))
    assert values["e_3"] != 0
    assert values["omega_3"] == 0


def test_unspecified_functions_that_vanish_on_the_surface():
    x, y = real_symbol("x"), real_symbol("y")
    f = sp.Function("f")(x, y)
    system = System(
        name="curve", title="curve", field={x: sp.diff(f, y), y: -sp.diff(f, x)}, relations=(f,)
    )
    ground = LevelSet(system)
    values, exact = ground.point(random.Random(0))
    evaluate = ground.along(ground.numbers(values, exact))
    assert evaluate.value(f) == 0
    assert evaluate.slope(f) == 0
