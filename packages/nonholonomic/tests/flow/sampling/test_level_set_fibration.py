"""How levels lie over a base."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.sampling.counter_rng import counter_normals
from flowlanes.flow.sampling.fibration import Fibration
from flowlanes.flow.sampling.level_set_fibration import find_fibration
from flowlanes.formulas.array_evaluation import parameter_rows
from flowlanes.formulas.compiled import SystemFormulas
from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from nonholonomic.catalogue import from_catalogue

theta, p, x = (real_symbol(name) for name in ["theta", "p", "x"])


def found(system: System, level: dict[str, float]) -> Fibration:
    values = parameter_rows(system, None, 1)[0]
    return find_fibration(system, SystemFormulas(system), level, values)


@pytest.mark.parametrize(
    ("name", "level", "linear", "further"),
    [
        ("chaplygin-ball", {"energy": 1.0}, [], []),
        ("chaplygin-ball", {"momentum": 1.0, "area": 0.1}, ["area"], []),
        ("chaplygin-ball", {"momentum": 1.0, "energy": 1.0}, [], ["momentum"]),
        ("veselova", {"energy": 1.0, "momentum": 2.6}, [""], ["momentum"]),
        ("lagrange-top", {"spin": 0.1, "area": 0.1, "energy": 1.0}, ["spin"], ["area"]),
    ],
)
def test_what_is_held_where(
    name: str, level: dict[str, float], linear: list[str], further: list[str]
) -> None:
    made = found(from_catalogue(name), level)
    assert made.spheres == ((3, 4, 5),)
    assert made.fibre == (0, 1, 2)
    assert made.quadratic.name == ("energy" if "energy" in level else "momentum")
    assert [c.name for c in made.linear] == linear
    assert [c.name for c in made.further] == further


def pendulum(potential: Any) -> System:
    """A bead with the energy p²/2 + U(θ); x does not take part."""
    return System(
        name="bead",
        title="Bead",
        field={theta: p, p: -sp.diff(potential, theta), x: p},
        laws=(Integral("energy", p**2 / 2 + x**2 + potential),),
    )


def test_angles_are_seen_by_their_period() -> None:
    made = found(pendulum(sp.cos(theta)), {"energy": 2.0})
    assert made.angles == (0,)
    assert made.fibre == (1, 2)
    with pytest.raises(InputError, match="is not bounded"):
        found(pendulum(theta**4), {"energy": 2.0})


def test_half_axes_of_an_ellipsoid() -> None:
    made = found(from_catalogue("marble-ball-on-ellipsoid"), {"energy": 1.0})
    assert made.axes == (3.0, 2.5, 2.0)
    sphere = found(from_catalogue("marble-ball-on-sphere"), {"energy": 1.0})
    assert sphere.axes == pytest.approx((2.0, 2.0, 2.0))


def test_rays_end_on_the_level_and_weigh_its_volume() -> None:
    system = from_catalogue("veselova")
    made = found(system, {"energy": 1.0})
    values = parameter_rows(system, None, 1)[0]
    gauss = counter_normals(1, np.arange(40_000), np.zeros(40_000), made.numbers)
    # one base point: the mean over rays is the volume of the fibre, 2π/√(det I (γ, I⁻¹γ))
    gauss[:3] = np.array([[1.0], [2.0], [-2.0]])
    rays = made.over(made.uniform_points(gauss), values)
    gamma = np.array([1, 2, -2]) / 3
    wanted = 2 * math.pi / math.sqrt(values.prod() * (gamma**2 / values).sum())
    assert 2 * math.pi * rays.volume.mean() == pytest.approx(wanted, rel=5e-3)
    omega = rays.states[:3]
    assert np.abs((values[:, None] * omega**2).sum(axis=0) / 2 - 1).max() < 1e-14
    # a direction close to γ loses digits; points drawn are settled afterwards
    assert np.abs(gamma @ omega).max() < 1e-12
    assert np.median(np.abs(gamma @ omega)) < 1e-15


def test_normal_numbers_of_places() -> None:
    made = found(pendulum(sp.cos(theta)), {"energy": 2.0})
    places = made.uniform_points(counter_normals(2, np.arange(20), np.zeros(20), made.numbers))
    assert np.abs(made.uniform_points(made.gauss(places)) - places).max() < 1e-12
