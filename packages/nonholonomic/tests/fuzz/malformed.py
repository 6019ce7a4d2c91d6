"""Laws and systems in which there is nothing to judge: an InputError has to say why."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Symmetry,
)
from flowlanes.system.system import System
from fuzz.case import Case, Family, guards, parameter, real, system
from fuzz.levels import number

__all__ = ["MALFORMED"]

x, y, z, q, a = real("x y z q a")
unknown = sp.Symbol("nobody", real=True)


def _moving() -> System:
    return system({x: y, y: -x, z: sp.S.Zero}, parameters=(parameter(a, 1.5),))


def _laws(rng: random.Random) -> list[tuple[str, Callable[[], Law]]]:
    """What is wrong, and the law."""
    k = number(rng)
    circle = x**2 + y**2
    three = sp.zeros(3, 3)
    return [
        ("an unknown symbol", lambda: Integral("law", circle + unknown)),
        ("an unknown symbol", lambda: Identity("law", unknown - unknown * circle)),
        ("an unknown symbol", lambda: Identity("law", sp.S.Zero, level=(unknown - k,))),
        ("an unknown symbol", lambda: Measure("law", {unknown: 1})),
        ("an unknown symbol", lambda: Symmetry("law", {x: unknown})),
        ("an unknown symbol", lambda: PoissonStructure("law", three, (unknown,))),
        ("an unknown symbol", lambda: Reduction("law", {q: x}, (Rate(q) - unknown,))),
        ("no state variable", lambda: Symmetry("law", {unknown: x})),
        ("an empty level", lambda: Identity("law", x, level=(circle - 1, circle - 2))),
        ("an empty level", lambda: Identity("law", x, level=(sp.S.One * rng.randint(1, 3),))),
        ("an empty level", lambda: Integral("law", x, level=(a - 1, a - 2))),
        ("an empty level", lambda: Identity("law", x, level=(z, z * x - k))),
        ("a level without real points", lambda: Identity("law", x, level=(circle + k**2,))),
        ("a level without real points", lambda: Integral("law", z, level=(sp.exp(circle),))),
        ("a level without real points", lambda: Integral("law", z, level=(a**2 + 1,))),
        ("division by zero", lambda: Integral("law", 1 / (circle - x**2 - y**2 + 0 * z + (z - z)))),
        ("division by zero", lambda: Integral("law", 1 / (z - k), level=(z - k,))),
        ("division by zero", lambda: Identity("law", x / ((x + k) ** 2 - x**2 - 2 * k * x - k**2))),
        ("division by zero", lambda: Measure("law", {z - k: 1}, level=(z - k,))),
        ("no real value", lambda: Integral("law", sp.sqrt(-1 - circle))),
        ("no real value", lambda: Identity("law", sp.sqrt(-1 - circle) * 0 + sp.log(-1 - z**2))),
        ("no real value", lambda: Integral("law", sp.asin(2 + circle))),
        ("no real value", lambda: Identity("law", sp.I * circle)),
        ("no finite value", lambda: Identity("law", sp.oo)),
        ("no finite value", lambda: Identity("law", sp.nan)),
        ("no finite value", lambda: Integral("law", sp.zoo)),
        ("no number", lambda: Identity("law", sp.true)),
        ("no number", lambda: Identity("law", sp.Eq(x, y))),
        ("no number", lambda: Integral("law", sp.Matrix([x, y]))),
        ("no formula", lambda: Integral("law", "x**2 + y**2 + nobody")),
        ("no formula", lambda: Integral("law", None)),
        ("no formula", lambda: Identity("law", {"x": 1})),
        ("no tuple", lambda: Identity("law", x, level=x)),
        ("no formula in the level", lambda: Identity("law", x, level=("x", None))),
        ("a size", lambda: PoissonStructure("law", sp.zeros(2, 2))),
        ("a size", lambda: PoissonStructure("law", sp.zeros(3, 4))),
        ("a size", lambda: ConformallyHamiltonian(
            "law", sp.S.One, PoissonStructure("b", sp.zeros(4, 4)), circle)),
        ("an exponent that moves", lambda: Measure("law", {1 + circle: x})),
        ("a variable of the target", lambda: Isomorphism("law", system({x: y, y: -x}), {x: x})),
        ("a parameter of the target", lambda: Isomorphism(
            "law", system({x: y, y: -x}, parameters=(parameter(q, 1.0),)), {x: x, y: y})),
        ("a name given away", lambda: Reduction("law", {x: y}, (Rate(x),))),
        ("no kind of law", lambda: Law("law")),
    ]  # fmt: skip


def wrong_laws(rng: random.Random) -> Case:
    """A law with a mistake of its author."""
    why, make = rng.choice(_laws(rng))
    return Case("malformed laws", lambda: (_moving(), make()), "malformed", why)


def _systems(rng: random.Random) -> list[tuple[str, Callable[[], System]]]:
    k = number(rng)
    plain = {x: y, y: -x}
    return [
        ("an unknown symbol", lambda: system({x: unknown, y: -x})),
        ("an unknown symbol", lambda: system(plain, relations=(unknown - 1,))),
        ("an unknown symbol", lambda: system(plain, definitions={q: unknown})),
        ("a definition by a later one", lambda: system(plain, definitions={q: z, z: x})),
        ("a name twice", lambda: system(plain, parameters=(parameter(x, 1.0),))),
        ("a name twice", lambda: system(plain, definitions={y: x})),
        ("an empty phase space", lambda: system(plain, relations=(x**2 + y**2 - 1, x**2 + y**2))),
        ("an empty phase space", lambda: system(plain, relations=(x**2 + y**2 + k**2,))),
        ("division by zero", lambda: system({x: y / ((x + 1) ** 2 - x**2 - 2 * x - 1), y: -x})),
        ("no real value", lambda: system({x: sp.sqrt(-1 - x**2), y: -x})),
        ("no finite value", lambda: system({x: sp.oo, y: -x})),
        ("nothing admissible", lambda: system(
            plain, parameters=(parameter(a, 1.0, a > 0, a < 0),))),
        ("a default that is no number", lambda: system(
            {x: a * y, y: -x}, parameters=(parameter(a, float("nan")),))),
        ("a guard with an unknown symbol", lambda: _guarded(plain, unknown)),
        ("a guard that is never positive", lambda: _guarded(plain, -1 - x**2)),
    ]  # fmt: skip


def _guarded(field: dict[sp.Symbol, Any], formula: sp.Expr) -> System:
    return system(field, guards=guards((formula,)))


def wrong_systems(rng: random.Random) -> Case:
    """A system with a mistake of its author."""
    why, make = rng.choice(_systems(rng))
    law = Integral("law", x**2 + y**2)
    return Case("malformed systems", lambda: (make(), law), "malformed", why)


MALFORMED: dict[str, Family] = {
    "malformed laws": wrong_laws,
    "malformed systems": wrong_systems,
}
