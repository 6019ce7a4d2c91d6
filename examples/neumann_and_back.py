"""Isomorphisms put to use: a body under a constraint moved by a point on a sphere, and back.

Theorem 8 takes the Veselova system on a level of its energy to the Neumann system, Theorem 10 the
Chaplygin ball at zero area constant, on a level of its momentum, to a Clebsch case, Proposition 6
the Veselova system on e(3) to another one.  Here the closed form of the target, carried back, gives
the motion of the body at any time; and the closed form of the body, carried forward, that of the
target.  Each is compared with the closed form that its own separation gives, and with integration.

    python examples/neumann_and_back.py
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np
from flint import ctx

from chaplygin import System, from_catalogue, integrate
from flowlanes import Isomorphism
from flowlanes.formulas import ball, ball_values
from flowlanes.formulas.balls import number
from flowlanes.system import to_components
from flowlanes.system.named_formulas import flat_pairs
from nonholonomic.closed_form import SeparatedSystem, pull_back, push_forward
from nonholonomic.closed_form.genus_two_solution import BITS, GenusTwo, solve_on_torus
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.clebsch import clebsch_case
from nonholonomic.closed_form.separations.neumann import neumann_system
from nonholonomic.closed_form.separations.veselova import veselova

#: Times at which motions are compared, s.
SHORT, LONG = np.linspace(0.0, 100.0, 11), np.array([1e3, 1e4, 1e5])


@dataclass(frozen=True)
class Case:
    """An isomorphism of the catalogue and a start on its level.

    Attributes
    ----------
    words : str
    name, law : str
        The system and the isomorphism.
    target : callable
        The target, separated.
    own : callable or None
        The system itself, separated; None where only its target is.
    start : tuple of str
        The reduced state.
    """

    words: str
    name: str
    law: str
    target: Callable[[], SeparatedSystem]
    own: Callable[[], SeparatedSystem] | None
    start: tuple[str, ...]

    @property
    def system(self) -> System:
        """Without its motion in space."""
        return _reduced(from_catalogue(self.name))

    @property
    def isomorphism(self) -> Isomorphism:
        """The law."""
        return next(
            law for law in self.system.laws if isinstance(law, Isomorphism) and law.name == self.law
        )


GAMMA = ("0.48", "-0.64", "0.6")
CASES = (
    Case(
        "Veselova ↔ Neumann (Theorem 8)",
        "veselova",
        "neumann",
        neumann_system,
        veselova,
        ("0.9", "-0.3", "-1.04", *GAMMA),
    ),
    Case(
        "Chaplygin ball ↔ Clebsch (Theorem 10)",
        "chaplygin-ball",
        "clebsch_case",
        clebsch_case,
        chaplygin_ball,
        ("2", "-0.3", "-1.92", *GAMMA),
    ),
    Case(
        "Veselova on e(3) ↔ Clebsch (Proposition 6)",
        "veselova-geodesic-flow",
        "clebsch",
        clebsch_case,
        None,
        ("2", "-0.3", "-1.92", *GAMMA),
    ),
)


def _reduced(system: System) -> System:
    return replace(system, reconstruction=None, observables=(), guards=())


def _defaults(system: System) -> dict[Any, Fraction]:
    return {symbol: Fraction(str(value)) for symbol, value in system.defaults.items()}


def image(case: Case) -> tuple[dict[Any, Any], tuple[Any, ...]]:
    """Parameters and start of the target, as balls."""
    system, law = case.system, case.isomorphism
    with ctx.workprec(BITS):
        known = {symbol: ball(value) for symbol, value in _defaults(system).items()}
        known |= dict(zip(system.symbols, map(ball, case.start), strict=True))
        for symbol, formula in system.scalar_definitions:
            known[symbol] = ball_values([formula], known)[0]
        shared = {p.symbol: known.get(p.symbol) for p in law.target.parameters}
        parameters = {
            p: ball_values([to_components(formula)], known)[0] for p, formula in law.constants
        }
        return {**shared, **parameters}, ball_values([f for _, f in flat_pairs(law.map)], known)


def back(case: Case) -> GenusTwo:
    """The motion of the system, from the closed form of the target."""
    carried = pull_back(case.system, case.isomorphism, case.target())
    return solve_on_torus(carried, _defaults(case.system), case.start)


def forth(case: Case, own: SeparatedSystem) -> tuple[GenusTwo, GenusTwo]:
    """The motion of the target, from the closed form of the system; and its own closed form."""
    values, start = image(case)
    near = replace(own, system=case.system)
    carried = push_forward(case.system, case.isomorphism, near)
    target = case.target()
    return (
        solve_on_torus(carried, {**_defaults(carried.system), **values}, start),
        solve_on_torus(replace(target, system=_reduced(target.system)), values, start),
    )


def apart(first: Any, second: Any) -> float:
    """The largest difference of two tables of states."""
    return float(np.abs(np.asarray(first, dtype=float) - np.asarray(second, dtype=float)).max())


def report(case: Case) -> None:
    """How well everything agrees."""
    print(case.words)
    carried = back(case)
    integrated = integrate(case.system, case.start, SHORT, precision="quad")
    miss = apart(carried.states(SHORT), integrated.states)
    print(f"  back, against 34 digits to t = 100         {miss:.1e}")
    if case.own is not None:
        itself = solve_on_torus(
            replace(case.own(), system=case.system), _defaults(case.system), case.start
        )
        for time, one, other in zip(LONG, carried.states(LONG), itself.states(LONG), strict=True):
            print(f"  back, against its own closed form, t = {time:.0e} {apart(one, other):.1e}")
        pushed, target = forth(case, case.own())
        for time, one, other in zip(LONG, pushed.states(LONG), target.states(LONG), strict=True):
            print(f"  forth, against the target's,      τ = {time:.0e} {apart(one, other):.1e}")
    values, _ = image(case)
    print("  target:", ", ".join(f"{name} = {number(x):.12g}" for name, x in values.items()))
    with ctx.workdps(25):
        turns = carried.separated_motion.torus.turns
        print(f"  rotation number {(turns[0] / turns[1]).str(20, radius=False)}\n")


def main() -> None:
    for case in CASES:
        report(case)


if __name__ == "__main__":
    main()
