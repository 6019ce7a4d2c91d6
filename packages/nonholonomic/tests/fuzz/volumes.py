"""Measures on levels whose relations have factors: the volume is that of the relation as written.

Where a phase space is R = 0, its volume is dⁿx/dR.  With R = g F and g without zeros the points are
those of F = 0, but the volume is dⁿx/(g dF), so that a density by F has the factor g by R.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import Any

import sympy as sp

from flowlanes.system.laws import Law, Measure
from flowlanes.system.system import System
from fuzz.case import Case, Family, Truth, guards, parameter, real, system
from fuzz.levels import number, polynomial

__all__ = ["VOLUMES"]

x, y, z, w = real("x y z w")
a = real("a")
SPACE = (x, y, z)


def _surface(rng: random.Random) -> sp.Expr:
    """F of an irreducible surface F = 0 with real points."""
    quadric = number(rng, positive=True) * x**2 + y**2 + number(rng, positive=True) * z**2 - 1
    graph = z - polynomial(rng, x, y)
    return rng.choice([quadric, quadric, graph, x * y + z**2 - number(rng, positive=True)])


def _kept(rng: random.Random, surface: sp.Expr) -> tuple[sp.Expr, ...]:
    """A field without divergence that keeps F: ∇F × ∇G."""
    other = number(rng) * x**2 + number(rng) * y * z + number(rng) * y**2 + x
    first, second = (sp.Matrix([sp.diff(f, n) for n in SPACE]) for f in (surface, other))
    return tuple(map(sp.expand, first.cross(second)))


def _factor(rng: random.Random) -> tuple[sp.Expr, Mapping[str, Any]]:
    """A factor without zeros, and what the system needs for it."""
    c = number(rng, positive=True)
    n = rng.choice(SPACE)
    return rng.choice(
        [
            (c + n**2, {}),
            (1 + n**2 + c * n**4, {}),
            (c + 1 + n, {"guards": guards((n + c,))}),
            (a + n**2, {"parameters": (parameter(a, 1.3, a > 0),)}),
            (2 - n, {"guards": guards((1 - n**2,))}),
            (2 + sp.sin(n), {}),
        ]
    )


def _moves(rates: tuple[sp.Expr, ...], factor: sp.Expr, surface: sp.Expr) -> bool:
    """Whether the rate of a factor is not zero on the whole surface."""
    rate = sp.expand(sum(sp.diff(factor, n) * r for n, r in zip(SPACE, rates, strict=True)))
    rate = rate.subs({sp.cos(n): 1 for n in SPACE})
    return bool(sp.rem(rate, sp.expand(surface), z))


def _case(made: System, law: Law, truth: Truth, why: str) -> Case:
    return Case("volume of a relation", lambda: (made, law), truth, why, refusable=True)


def volume_of_a_relation(rng: random.Random) -> Case:
    """dⁿx/d(g F) moves as 1/g does: the density by g F is g times that by F."""
    while True:
        surface, (factor, needs) = _surface(rng), _factor(rng)
        rates = _kept(rng, surface)
        if _moves(rates, factor, surface):
            break
    relation = rng.choice([sp.expand, lambda r: r])(factor * surface)
    under_on = rng.random() < 0.3
    made = system(
        dict(zip(SPACE, rates, strict=True)), relations=() if under_on else (relation,), **needs
    )
    on = (relation,) if under_on else ()
    form = rng.choice(["true", "true", "true", "none", "inverse", "twice", "square", "far"])
    if form == "square":
        on = (surface**2,) if under_on else ()
        made = system(
            dict(zip(SPACE, rates, strict=True)), relations=() if under_on else (surface**2,)
        )
        law = Measure("volume", {sp.S.One: 1}, level=on)
        return _case(made, law, "malformed", "dF² vanishes where F does: there is no volume")
    if form == "far":
        # two surfaces of one field, each with its own multiple of the volume by F
        level = number(rng, positive=True) + 2
        both = sp.expand(surface * (surface - level) * factor)
        made = system(dict(zip(SPACE, rates, strict=True)), relations=(both,), **needs)
        right = rng.random() < 0.5
        law = Measure("volume", {factor: 1} if right else {sp.S.One: 1})
        return _case(made, law, "true" if right else "false", "g moves, F − c does not")
    power = {"true": 1, "none": 0, "inverse": -1, "twice": 2}[form]
    density = {factor: power} if power else {sp.S.One: 1}
    law = Measure("volume", density, level=on)
    return _case(made, law, "true" if power == 1 else "false", "the volume by g F is that by F/g")


def factor_that_moves(rng: random.Random) -> Case:
    """w F = 0 with ẇ = k w: the volume by w F grows with k, as the divergence does."""
    surface = _surface(rng)
    rates = _kept(rng, surface)
    k = rng.choice([*SPACE, number(rng), x * y])
    field = {**dict(zip(SPACE, rates, strict=True)), w: k * w}
    made = system(field, relations=(rng.choice([sp.expand, lambda r: r])(w * surface),))
    power = rng.choice([0, 0, 1, -1])
    law = Measure("volume", {w: power} if power else {sp.S.One: 1})
    return Case(
        "factor that moves",
        lambda: (made, law),
        "false" if power else "true",
        "the trace of the rates of the relation is k, and so is the divergence",
        refusable=True,
    )


def factor_in_two_relations(rng: random.Random) -> Case:
    """Relations g F = 0 and g w = 0: the volume has g twice."""
    while True:
        surface, (factor, needs) = _surface(rng), _factor(rng)
        rates = _kept(rng, surface)
        if _moves(rates, factor, surface):
            break
    field = {**dict(zip(SPACE, rates, strict=True)), w: sp.S.Zero}
    relations = (sp.expand(factor * surface), sp.expand(factor * w))
    made = system(field, relations=relations, **needs)
    power = rng.choice([2, 2, 1, 0])
    law = Measure("volume", {factor: power} if power else {sp.S.One: 1})
    return Case(
        "factor in two relations",
        lambda: (made, law),
        "true" if power == 2 else "false",
        "each relation brings a factor g",
        refusable=True,
    )


VOLUMES: dict[str, Family] = {
    "volume of a relation": volume_of_a_relation,
    "factor that moves": factor_that_moves,
    "factor in two relations": factor_in_two_relations,
}
