"""The energy of mechanisms with constraints, each written in one of several ways.

With ideal constraints that are linear and homogeneous in the velocities, and without time in the
Lagrangian, T₂ − T₀ + V is an integral (Theorem 1).  Friction, a constraint with a drift and time in
the potential change it, and so does a term too many in the law.
"""

from __future__ import annotations

import random

import sympy as sp

import nonholonomic
from flowlanes.system.laws import Integral, Law
from flowlanes.system.system import System
from fuzz.case import Case, Family, Truth, parameter, real
from fuzz.levels import number

__all__ = ["CONSTRAINED"]

x, y, phi = real("x y phi")
xdot, ydot, phidot = real("xdot ydot phidot")
PLACES, SPEEDS = (x, y, phi), (xdot, ydot, phidot)
k = real("k")


def _constraint(rng: random.Random) -> sp.Expr:
    """One of the constraints that books have, and some that they have not."""
    a, b = number(rng), number(rng)
    return rng.choice(
        [
            ydot * sp.cos(phi) - xdot * sp.sin(phi),
            ydot * sp.cos(phi) - xdot * sp.sin(phi) + a * phidot,
            xdot - a * sp.cos(phi) * phidot,
            ydot - x * xdot,
            phidot + a * x * ydot + b * y * xdot,
            (1 + x**2) * xdot + a * ydot,
            k * phidot - xdot * sp.cos(phi) - ydot * sp.sin(phi),
        ]
    )


def _potential(rng: random.Random) -> sp.Expr:
    a, b = number(rng, positive=True), number(rng)
    return rng.choice(
        [sp.S.Zero, a * x**2 / 2, a * x + b * sp.cos(phi), k * (x**2 + y**2) / 2, b * sp.sin(x) * y]
    )


def _written(
    rng: random.Random, constraint: sp.Expr
) -> tuple[tuple[sp.Expr, ...], dict[sp.Symbol, sp.Expr]]:
    """A constraint and definitions, in one of several ways."""
    side, part, unused = real("side part unused")
    terms = sp.Add.make_args(sp.expand(constraint))
    return rng.choice(
        [
            ((constraint,), {}),
            ((side,), {side: constraint}),
            ((2 * side,), {part: constraint, side: part}),
            ((part + sp.Add(*terms[1:]),), {part: terms[0]}),
            ((constraint,), {unused: x * y + k}),
            ((number(rng) * constraint,), {}),
        ]
    )


def energy_with_constraints(rng: random.Random) -> Case:
    """T₂ − T₀ + V with ideal constraints, and what spoils it."""
    masses = [number(rng, positive=True) for _ in SPEEDS]
    kinetic = sum((m * v**2 / 2 for m, v in zip(masses, SPEEDS, strict=True)), sp.S.Zero)
    if rng.random() < 0.3:
        kinetic += rng.choice([x**2 * phidot**2, (1 + sp.cos(phi) ** 2) * xdot**2]) / 2
    potential = _potential(rng)
    gyroscopic = rng.choice([sp.S.Zero, sp.S.Zero, y * xdot, x**2 * phidot])
    constraint = _constraint(rng)
    written, definitions = _written(rng, constraint)
    energy = kinetic + potential
    spoilt = rng.choice(["", "", "", "", "term", "factor", "friction", "drift", "time"])
    forces, told, lagrangian, why = {}, energy, kinetic + gyroscopic - potential, "Theorem 1"
    t = real("t")
    if spoilt == "term":
        told, why = energy + number(rng) * rng.choice([x, xdot, x * ydot]), "a term too many"
    elif spoilt == "factor":
        told, why = kinetic + 2 * potential + x / 7, "a potential that is not the one"
    elif spoilt == "friction":
        forces, why = {v: -v / 3 for v in SPEEDS}, "friction in every velocity"
    elif spoilt == "drift":
        written, why = (*written[:-1], written[-1] + 1), "the constraint has a drift"
        lagrangian, told = lagrangian - x**2 - 3 * y, energy + x**2 + 3 * y
    elif spoilt == "time":
        lagrangian, why = lagrangian - t * (x + 2 * y + 3 * phi), "the potential depends on time"
        told = energy + t * (x + 2 * y + 3 * phi)
    frame = nonholonomic.coordinates(*PLACES)

    def make() -> tuple[System, Law]:
        mechanism = nonholonomic.Mechanism(
            "planted",
            frame,
            lagrangian,
            constraints=written,
            forces=forces,
            definitions=definitions,
            parameters=(parameter(k, 0.7, k > 0),),
        )
        return nonholonomic.equations_of_motion(mechanism), Integral("law", told)

    holds = not spoilt or _holds_still(make()[0], told)
    truth: Truth = "true" if holds else "false"
    return Case("energy with constraints", make, truth, why, refusable=True)


def _holds_still(system: System, told: sp.Expr) -> bool:
    """Whether the rate of a spoilt law vanishes all the same, by values at points of the level."""
    law = system.expand(told)
    rates = zip(system.symbols, system.rates, strict=True)
    rate = sp.Add(*(sp.diff(law, s) * system.expand(r) for s, r in rates))
    rng = random.Random(1)
    for _ in range(4):
        start = {s: sp.Rational(rng.randint(-9, 9), 7) for s in system.symbols}
        start |= {p.symbol: sp.Rational(7, 10) for p in system.parameters}
        point = _on_level(system, start)
        if point is None or abs(sp.N(rate.xreplace(point), 40)) > 1e-25:
            return False
    return True


def _on_level(system: System, start: dict[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr] | None:
    """A point of the level: one velocity is found from each relation."""
    point = dict(start)
    for relation in system.relations:
        formula = system.expand(relation)
        for speed in SPEEDS:
            if speed in formula.free_symbols and sp.diff(formula, speed, 2) == 0:
                slope = sp.N(sp.diff(formula, speed).xreplace(point), 60)
                if abs(slope) > 0.05:
                    rest = sp.N(formula.xreplace({**point, speed: sp.S.Zero}), 60)
                    point[speed] = -rest / slope
                    break
        else:
            return None
    return point


CONSTRAINED: dict[str, Family] = {"energy with constraints": energy_with_constraints}
