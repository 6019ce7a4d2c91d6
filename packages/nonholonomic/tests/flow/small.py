"""Small systems whose motions are known, and starts of rolling bodies, for tests of the engine."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import Diagonal, cross, dot, vectors
from nonholonomic.catalogue import from_catalogue

x, y, u, v = sp.symbols("x y u v", real=True)
p, q = sp.symbols("p q", real=True)

#: x = x₀ cos √p t + …
OSCILLATOR = System(
    name="oscillator",
    title="Oscillator",
    parameters=(Parameter(p, "square of the frequency", 1.0, admissible=(p > 0,)),),
    field={x: y, y: -p * x},
    laws=(Integral("energy", y**2 + p * x**2, "energy"),),
)

#: Kepler's problem in the plane.
KEPLER = System(
    name="kepler",
    title="Kepler",
    definitions={q: (x**2 + y**2) ** sp.Rational(-3, 2)},
    field={x: u, y: v, u: -x * q, v: -y * q},
    laws=(
        Integral("energy", (u**2 + v**2) / 2 - 1 / sp.sqrt(x**2 + y**2), "energy"),
        Integral("area", x * v - y * u, "angular momentum"),
    ),
)

M, gamma, omega = vectors("M gamma omega")
A = Diagonal("A")

#: A free body with moments of inertia 1/A, and a direction fixed in space.
TOP = System(
    name="top",
    title="Free body",
    parameters=tuple(
        Parameter(a, "1/I", d) for a, d in zip(A.symbols, (1.0, 0.5, 0.25), strict=True)
    ),
    definitions={omega: A * M},
    field={M: cross(M, omega), gamma: cross(gamma, omega)},
    relations=(dot(gamma, gamma) - 1,),
)

#: x = x₀/(1 − x₀ t): a singularity at 1/x₀.
RUNAWAY = System(name="runaway", title="Runaway", field={x: x**2})

#: x = x₀ − t, y′ = log x: no number after x₀.
LOGARITHM = System(name="logarithm", title="Logarithm", field={x: -1, y: sp.log(x)})

#: The oscillator until x falls below −p or rises above q.
FENCED = System(
    name="fenced",
    title="Fenced oscillator",
    parameters=(Parameter(p, "left fence", 0.5), Parameter(q, "right fence", 10.0)),
    field={x: y, y: -x},
    guards=(Guard("left", x + p, "it went left"), Guard("right", q - x, "it went right")),
)

#: An angle that turns at a rate of its own, and a slow one.
TURNING = System(
    name="turning",
    title="Turning",
    parameters=(Parameter(p, "rate", 1.0),),
    field={x: p + sp.sin(y) / 4, y: sp.Rational(1, 3)},
)

BODIES = ("chaplygin-ball", "unbalanced-ball", "rattleback")


def body(name: str) -> System:
    """A rolling body of the catalogue with a contact that holds both ways, without its lift."""
    return replace(from_catalogue(name), reconstruction=None, guards=(), observables=())


def starts(name: str, count: int, seed: int = 0) -> Any:
    """States of a body: of the rattleback near its rest position, of others anywhere."""
    states = np.random.default_rng(seed).normal(size=(count, 6))
    if name == "rattleback":
        states *= [2e-3, 2e-3, 2e-3, 0.05, 0.05, 0.0]
        states[:, 5] = 1.0
    states[:, 3:] /= np.linalg.norm(states[:, 3:], axis=1)[:, None]
    return states


def exactly_on_the_sphere(states: Any) -> Any:
    """The same as numbers of many digits with γ² = 1."""
    with mpmath.workdps(45):
        exact = np.array([[mpmath.mpf(float(c)) for c in row] for row in states], dtype=object)
        for row in exact:
            row[3:6] = row[3:6] / mpmath.sqrt(sum(c**2 for c in row[3:6]))
    return exact
