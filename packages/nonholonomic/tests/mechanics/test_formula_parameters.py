"""Parameters of a formula are given in one way: by name, by symbol, or declared."""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol
from nonholonomic import Forces, ImplicitShape, RollingBall, ShapeOfRevolution
from nonholonomic.contact import UserFriction
from nonholonomic.mechanics.ball import FlatSurface, ImplicitSurface

x, y, z, a, u, height = sp.symbols("x y z a gamma_3 R_3")

#: What takes parameters, each with a formula in `a`.
MAKERS: dict[str, Callable[..., Any]] = {
    "implicit shape": lambda given: ImplicitShape(x**2 + y**2 + a * z**2 - 1, parameters=given),
    "shape of revolution": lambda given: ShapeOfRevolution(2 + a * u**2, parameters=given),
    "profile": lambda given: ShapeOfRevolution.from_profile(-a, -a * u, parameters=given),
    "forces": lambda given: Forces(potential=a * u, parameters=given),
    "surface": lambda given: ImplicitSurface(x**2 + y**2 - a * z, parameters=given),
    "ball": lambda given: RollingBall(
        mass=1.0,
        inertia=0.4,
        radius=1.0,
        surface=FlatSurface(),
        potential=a * height,
        parameters=given,
    ),
    "friction": lambda given: UserFriction("a*slip_speed + 0.1", parameters=given),
}


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_names_and_symbols_mean_the_same(make: Callable[..., Any]) -> None:
    made = make({"a": 0.5})
    for other in (
        make({a: 0.5}),
        make({real_symbol("a"): 0.5}),
        replace(made, parameters=made.parameters),
        replace(made),
        pickle.loads(pickle.dumps(made)),
    ):
        assert other == made and hash(other) == hash(made)
        assert other.parameters == made.parameters
    assert made != make({"a": 0.25})
    assert made.parameters[0].default == 0.5


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_a_declared_parameter_keeps_its_meaning(make: Callable[..., Any]) -> None:
    declared = Parameter(real_symbol("a"), "stiffness of the spring", 0.5, "N/m")
    (found, *_) = make([declared]).parameters
    assert (found.meaning, found.unit, found.default) == ("stiffness of the spring", "N/m", 0.5)


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
@pytest.mark.parametrize("given", [{"a": "half"}, [a], [("a", 0.5)], 0.5, "a", {"a": math.nan}])
def test_other_parameters_are_refused_in_a_sentence(make: Callable[..., Any], given: Any) -> None:
    with pytest.raises(InputError, match="parameter"):
        make(given)


def test_the_parameters_of_a_law_of_friction_have_names_of_their_own() -> None:
    law = UserFriction("a*slip_speed + 0.1", parameters={"a": 0.5})
    assert [str(p.symbol) for p in law.parameters] == ["user_a", "mu_static"]
    assert replace(law, mu_static=0.3).parameters[1].default == 0.3
    with pytest.raises(InputError, match="'spin': this is no free name"):
        UserFriction("0.1", parameters={"spin": 1.0})
