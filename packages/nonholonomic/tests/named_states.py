"""Systems that ω and γ do not describe, entered in the catalogue for a test."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, real_symbol, vectors
from nonholonomic.catalogue import CATALOGUE, Entry, Start
from nonholonomic.catalogue.catalogue_entry import Numbers

u, omega, theta, x, y = (real_symbol(name) for name in ("u", "omega", "theta", "x", "y"))
m, a, inertia = (real_symbol(name) for name in ("m", "a", "I"))
M, gamma = vectors("M gamma")
A = Diagonal("A")
half = sp.Rational(1, 2)


def sleigh(p: Numbers) -> System:
    """The Chaplygin sleigh: a blade at the distance a behind the centre of mass."""
    return System(
        name="trial-sleigh",
        title="Sleigh",
        parameters=tuple(Parameter(s, f"number {s}", p[str(s)]) for s in (m, a, inertia)),
        field={
            u: a * omega**2,
            omega: -m * a * u * omega / (inertia + m * a**2),
            theta: omega,
            x: u * sp.cos(theta),
            y: u * sp.sin(theta),
        },
        laws=(
            Integral(
                "energy",
                half * m * u**2 + half * (inertia + m * a**2) * omega**2,
                "energy",
                unit="J",
            ),
            Integral("straight", theta, "direction", level=(omega,)),
            Measure("density", {omega: -1}, "measure", level=(a,)),
        ),
    )


def top(p: Numbers) -> System:
    """A symmetric heavy top, its momentum and the vertical in body axes."""
    return System(
        name="trial-top",
        title="Lagrange top",
        parameters=tuple(Parameter(s, f"number {s}", p[str(s)]) for s in (m, a, *A.symbols)),
        field={
            M: cross(M, A * M) + m * a * cross(unit_vector(3), gamma),
            gamma: cross(gamma, A * M),
        },
        relations=(norm_squared(gamma) - 1,),
        laws=(
            Integral("energy", half * dot(M, A * M) - m * a * gamma.symbols[2], "energy"),
            Integral("area", dot(M, gamma), "area integral"),
            Integral("spin", M.symbols[2], "momentum about the axis"),
        ),
    )


ENTRIES = (
    Entry(
        name="trial-sleigh",
        title="Sleigh",
        summary="A blade.",
        source="",
        defaults={"m": 1.0, "a": 0.5, "I": 0.2},
        build=sleigh,
        start=Start(state={"u": -0.4, "omega": 1.5, "theta": 0.0, "x": 0.0, "y": 0.0}, until=4.0),
        variables={
            "u": ("velocity along the blade", "m/s"),
            "omega": ("angular velocity", "rad/s"),
        },
    ),
    Entry(
        name="trial-top",
        title="Lagrange top",
        summary="A top.",
        source="",
        defaults={"m": 1.0, "a": 0.5, "A_1": 1.0, "A_2": 1.0, "A_3": 0.5},
        build=top,
        start=Start(state={"M": (0.2, 0.1, 3.0), "gamma": (0.0, 0.6, 0.8)}, until=3.0),
    ),
)


@pytest.fixture
def named_states(monkeypatch: pytest.MonkeyPatch) -> None:
    """The catalogue knows `trial-sleigh` and `trial-top`."""
    for item in ENTRIES:
        monkeypatch.setitem(CATALOGUE, item.name, item)
