"""The same truth in many dresses: other names, units, formulas, fields, and kinds of law."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass
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
from flowlanes.system.system import Parameter, System
from fuzz.case import Case, guards, system
from fuzz.setting import Setting

__all__ = ["dressed"]

PLAIN = "u v w p q r s x_1 x_2 x_3 k m l theta phi psi omega_1 omega_2 M_1 M_2 gamma_1 gamma_3"
#: Names that programs are tempted to use themselves, or that mean something to SymPy or Python.
LEGAL = (
    "aux0 aux1 aux2 aux3 sin_phi cos_phi sin_theta cos_x s_phi c_phi lambda class None True def "
    "import is in I E S N O Q pi oo nan zoo beta gamma zeta log exp sin sqrt f g U U_1 t dt tau "
    "x_ _x __ X0 t0 rate_x d_x law c0 one zero main value x1y R0"
)
#: Names that are no words: taking them is as right as refusing them.
STRANGE = ("x+y", "x*y", "x y", "2", "x^2", "x'", "f(x)", "-x", "(x)", "x_{1}", "\\phi", "a,b")
PLACES = range(-12, 13)


def dressed(name: str, rng: random.Random, setting: Setting) -> Case:
    """One of the claims of a setting, as a law of a system."""
    setting = setting.one(rng)
    names = _names(rng, len(setting.symbols) + 7)
    fresh = names[len(setting.symbols) :]
    if rng.random() < 0.5:
        setting = setting.renamed(dict(zip(setting.symbols, names, strict=False)))
    else:
        fresh = [s for s in fresh if str(s) not in set(map(str, setting.symbols))]
        fresh += [s for s in _symbols("k1 k2 k3 k4 k5 k6 k7") if s not in setting.symbols]
    if rng.random() < 0.3 and not any(f.has(sp.Derivative) for f in setting.formulas):
        setting = setting.scaled({s: _unit(rng) for s in setting.symbols})
    strange = any(str(s) in STRANGE for s in (*setting.symbols, *fresh[:7]))
    (claim,) = setting.claims
    conditions = [_condition(rng, c, setting) for c in setting.conditions]
    formula = _formula(rng, claim.formula, setting)
    world = _world(rng, setting, conditions, fresh)
    kind = rng.choice(_kinds(setting, world))
    law = _LAWS[kind](rng, formula, world)
    at = claim.fails_at
    if at is not None:
        extra = set(world.field) - set(at)
        at = {**at, **{s: sp.S.Zero for s in extra}, **world.circle}

    def made() -> tuple[System, Law]:
        return system(
            world.field,
            parameters=setting.parameters,
            definitions=world.definitions,
            relations=world.relations,
            guards=guards(setting.guards),
        ), law

    return Case(
        name,
        made,
        "true" if claim.holds else "false",
        claim.why,
        at,
        setting.refusable or strange,
    )


def _symbols(names: str) -> list[sp.Symbol]:
    return [sp.Symbol(name, real=True) for name in names.split()]


def _names(rng: random.Random, count: int) -> list[sp.Symbol]:
    """Symbols, mostly with harmless names."""
    pool = PLAIN.split()
    chance = rng.random()
    if chance < 0.3:
        pool = [*pool, *LEGAL.split()]
    elif chance < 0.33:
        pool = [*pool, *STRANGE]
    return [sp.Symbol(name, real=True) for name in rng.sample(sorted(set(pool)), count)]


def _unit(rng: random.Random) -> sp.Rational:
    return sp.Integer(10) ** rng.choice(PLACES)


def _positive(rng: random.Random, setting: Setting) -> sp.Expr:
    """A formula that is positive everywhere."""
    s = rng.choice(setting.variables)
    return rng.choice([1 + s**2, 2 + s**4, sp.S.One, 3 + s**2, sp.Rational(1, 1) / (1 + s**2)])


def _condition(rng: random.Random, condition: sp.Expr, setting: Setting) -> sp.Expr:
    """A formula with the same zeros."""
    chance = rng.random()
    if chance < 0.15:
        return _unit(rng) * condition
    if chance < 0.25:
        return _positive(rng, setting) * condition
    if chance < 0.4:
        return sp.expand(condition)
    if chance < 0.45:
        return -condition
    return condition


def _formula(rng: random.Random, formula: sp.Expr, setting: Setting) -> sp.Expr:
    """A formula that is zero at the same points, if it is defined there."""
    chance = rng.random()
    if chance < 0.2:
        return _unit(rng) * formula
    if chance < 0.3:
        return formula**3
    if chance < 0.4:
        return formula + formula**3
    if chance < 0.5:
        return _positive(rng, setting) * formula
    if chance < 0.6:
        return sp.expand(formula)
    if chance < 0.65 and not formula.has(sp.log):
        return sp.exp(formula) - 1
    if chance < 0.7:
        return formula / (1 + formula**2)
    return formula


@dataclass(frozen=True)
class World:
    """A system in the making: its field, conditions, and variables that the level leaves alone.

    The clock has rate 1, the two free variables have rate 0.
    """

    field: Mapping[sp.Symbol, sp.Expr]
    definitions: Mapping[sp.Symbol, sp.Expr]
    relations: tuple[sp.Expr, ...]
    on: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...]
    clock: sp.Symbol
    free: tuple[sp.Symbol, sp.Symbol]
    spare: tuple[sp.Symbol, ...]
    resting: bool
    straight: bool
    circle: Mapping[sp.Symbol, sp.Expr]


def _world(
    rng: random.Random, setting: Setting, conditions: list[sp.Expr], fresh: list[sp.Symbol]
) -> World:
    clock, first, second, *spare = fresh
    rates, straight = _rates(rng, setting, conditions)
    definitions: dict[sp.Symbol, sp.Expr] = {}
    if conditions and rng.random() < 0.1:
        place = rng.randrange(len(conditions))
        definitions[spare[0]] = conditions[place]
        conditions = [*conditions[:place], spare[0], *conditions[place + 1 :]]
    moving = set(setting.variables)
    relations, on = [], []
    for condition in conditions:
        free = condition.xreplace(definitions).free_symbols
        (relations if free & moving and rng.random() < 0.4 else on).append(condition)
    circle: dict[sp.Symbol, sp.Expr] = {}
    turning: dict[sp.Symbol, sp.Expr] = {}
    if rng.random() < 0.08:
        p, q = spare[1], spare[2]
        relations.append(p**2 + q**2 - 1)
        turning = {p: q, q: -p}
        circle = {p: sp.Rational(3, 5), q: sp.Rational(4, 5)}
    rng.shuffle(on)
    field = list({clock: sp.S.One, first: sp.S.Zero, second: sp.S.Zero, **rates, **turning}.items())
    rng.shuffle(field)
    return World(
        dict(field),
        definitions,
        tuple(relations),
        tuple(on),
        setting.parameters,
        clock,
        (first, second),
        tuple(spare[3:]),
        resting=not turning and not any(rates.values()),
        straight=straight,
        circle=circle,
    )


def _rates(
    rng: random.Random, setting: Setting, conditions: list[sp.Expr]
) -> tuple[dict[sp.Symbol, sp.Expr], bool]:
    """A field that leaves the level, and each part of it, invariant; whether it has no divergence.

    It is zero everywhere, or zero on the level, or tangent to all levels of the one condition.
    """
    chance = rng.random()
    variables = setting.variables
    if conditions and chance < 0.15:
        factor = rng.choice(conditions)
        return {s: factor * rng.randint(-2, 2) for s in variables}, False
    smooth = not any(f.has(sp.Derivative) for f in conditions)
    if len(conditions) == 1 and len(variables) == 3 and chance < 0.35 and smooth:
        other = sum(rng.randint(-2, 2) * s for s in variables) + variables[0] * variables[2]
        first, second = (
            sp.Matrix([sp.diff(f, s) for s in variables]) for f in (conditions[0], other)
        )
        return dict(zip(variables, first.cross(second), strict=True)), True
    return dict.fromkeys(variables, sp.S.Zero), True


def _kinds(setting: Setting, world: World) -> list[str]:
    found = ["identity"] * 3 + ["integral", "integral", "rate", "symmetry", "casimir", "reduction"]
    found += ["reduction of two", "isomorphism"]
    if world.straight and setting.regular:
        found.append("measure")
    if world.resting:
        found.append("hamiltonian")
    return found


# --- kinds of law that hold exactly where a formula vanishes -----------------------------------


def _identity(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    return Identity("law", formula, level=world.on)


def _integral(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    """The clock times F grows as F does."""
    return Integral("law", world.clock * formula, level=world.on)


def _rate(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    return Identity("law", (Rate(world.clock * formula), sp.S.Zero), level=world.on)


def _symmetry(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    """A push along a free variable that grows as F does."""
    return Symmetry("law", {world.free[0]: world.clock * formula}, level=world.on)


def _bracket(world: World, pairs: list[tuple[sp.Symbol, sp.Symbol]], **others: Any) -> Any:
    names = list(world.field)
    matrix = sp.zeros(len(names), len(names))
    for a, b in pairs:
        i, j = names.index(a), names.index(b)
        matrix[i, j], matrix[j, i] = 1, -1
    return PoissonStructure("law", matrix, level=world.on, **others)


def _casimir(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    """With {p, q} = 1, the bracket of q and F p is −F."""
    rank = rng.choice([None, 2])
    return _bracket(world, [world.free], casimirs=(formula * world.free[0],), rank=rank)


def _hamiltonian(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    """The Hamiltonian p (1 + F) moves the clock q at the rate 1 + F."""
    first = world.free[0]
    structure = _bracket(world, [(world.clock, first)])
    factor = sp.Integer(rng.choice([1, 1, -1, 2, 7]))
    return ConformallyHamiltonian(
        "law", factor, structure, first * (1 + formula) / factor, level=world.on
    )


def _measure(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    """The density exp(F · clock) of a flow without divergence grows as F does."""
    return Measure("law", {sp.exp(world.clock * formula): 1}, level=world.on)


def _reduction(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    quantity = world.spare[0]
    return Reduction("law", {quantity: world.clock * formula}, (Rate(quantity),), level=world.on)


def _reduction_of_two(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    """A quantity with the rate F, and the clock."""
    one, other = world.spare[0], world.clock
    quantities = {one: other * formula + world.free[1]}
    return Reduction("law", quantities, (Rate(one), Rate(other) - 1), level=world.on)


def _isomorphism(rng: random.Random, formula: sp.Expr, world: World) -> Law:
    """Onto itself, with a free variable pushed by F times the clock."""
    moving = set(world.field)
    level = tuple(c for c in world.on if c.xreplace(dict(world.definitions)).free_symbols & moving)
    target = system(
        world.field,
        parameters=world.parameters,
        definitions=world.definitions,
        relations=(*world.relations, *level),
    )
    shifted = {**{s: s for s in world.field}, world.free[0]: world.free[0] + world.clock * formula}
    return Isomorphism("law", target, shifted, level=world.on)


_LAWS: dict[str, Callable[[random.Random, sp.Expr, World], Law]] = {
    "identity": _identity,
    "integral": _integral,
    "rate": _rate,
    "symmetry": _symmetry,
    "casimir": _casimir,
    "hamiltonian": _hamiltonian,
    "measure": _measure,
    "reduction": _reduction,
    "reduction of two": _reduction_of_two,
    "isomorphism": _isomorphism,
}
