"""The distribution of a mechanism with its kinetic metric."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
import sympy as sp

from flowlanes import InputError
from flowlanes.system.vectors import real_symbol
from nonholonomic import Ball, Body, Ellipsoid, Plane, RollingBody
from nonholonomic.mechanics.lagrangian.constrained_frame import constraint_distribution
from nonholonomic.mechanics.lagrangian.generic_points import GenericPoint, generic_points
from nonholonomic.mechanics.lagrangian.mechanism import TIME, Mechanism, coordinates
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.mechanics.rolling.mechanism import rolling_mechanism

x, y, phi, m, a, J = (real_symbol(n) for n in ("x", "y", "phi", "m", "a", "J"))
FRAME = coordinates(x, y, phi)
xdot, ydot, phidot = FRAME.w
AHEAD = xdot * sp.cos(phi) + ydot * sp.sin(phi)
BESIDE = ydot * sp.cos(phi) - xdot * sp.sin(phi)


def sleigh(constraint: sp.Expr = BESIDE, speed: sp.Expr = AHEAD) -> Mechanism:
    from flowlanes.system.system import Parameter

    return Mechanism(
        "sleigh",
        FRAME,
        (m * (speed**2 + (BESIDE + a * phidot) ** 2) + J * phidot**2) / 2,
        (constraint,),
        parameters=tuple(Parameter(s, "", 0.7) for s in (m, a, J)),
    )


def rolling(shape: Any, model: Any) -> Mechanism:
    return rolling_mechanism(RollingBody(Body(1.1, (1.0, 1.5, 2.1), shape), Plane(), model))


MECHANISMS = {
    "sleigh": sleigh,
    "marble ball": lambda: rolling(Ball(1.0, centre=(0.1, 0.0, 0.2)), "marble"),
    "rubber ball": lambda: rolling(Ball(1.0), "rubber"),
    "rubber ellipsoid": lambda: rolling(Ellipsoid((1.0, 0.8, 0.6)), "rubber"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", MECHANISMS)
def test_equations_on_the_distribution_are_those_of_the_mechanism(name: str) -> None:
    """Ṗ_s = C^t_rs P_t y_r with P = g y, against the closed equations, at a point, 40 digits."""
    mechanism = MECHANISMS[name]()
    made, system = constraint_distribution(mechanism), equations_of_motion(mechanism)
    count = range(len(made.velocities))
    point = dict(generic_points("test", mechanism.frame, mechanism)[0].point)
    with mpmath.workdps(50):
        chosen = {s: point[s] for s in made.velocities}
        base = {s: value for s, value in point.items() if s not in mechanism.frame.w}
        known = GenericPoint(base, [p for p in made.definitions if _still(p, mechanism)])
        w = {
            s: sum(known.value(row[i]) * chosen[made.velocities[i]] for i in count)
            for s, row in zip(mechanism.frame.w, made.basis, strict=True)
        }
        motion = GenericPoint(
            base | {s: w[s] for s in system.symbols if s in w}, system.scalar_definitions
        )
        rates = {s: motion.value(r) for s, r in zip(system.symbols, system.rates, strict=True)}
        g = [[known.value(e) for e in row] for row in made.kinetic]
        P = [sum(g[s][r] * chosen[made.velocities[r]] for r in count) for s in count]
        # Ṗ = g ẏ + ġ y, with ġ along the motion by a difference of high order
        moving = [_along(made, mechanism, base, chosen, s) for s in count]
        for s in count:
            ours = moving[s] + sum(g[s][r] * rates[made.velocities[r]] for r in count)
            force = sum(
                _structure(made, known, r, s)[t] * P[t] * chosen[made.velocities[r]]
                for r in count
                for t in count
            )
            slope = sum(
                _kinetic_slope(made, mechanism, base, s)[i][j]
                * chosen[made.velocities[i]]
                * chosen[made.velocities[j]]
                for i in count
                for j in count
            )
            assert abs(ours - force - slope / 2) < mpmath.mpf(10) ** -18


def _still(step: Any, mechanism: Mechanism) -> bool:
    return not step[1].free_symbols & set(mechanism.frame.w)


def _structure(made: Any, known: GenericPoint, r: int, s: int) -> list[Any]:
    if r == s:
        return [0] * len(made.velocities)
    sign = 1 if r < s else -1
    return [sign * known.value(e) for e in made.structure[min(r, s), max(r, s)]]


STEP = mpmath.mpf(10) ** -12


def _shifted(made: Any, mechanism: Mechanism, base: Any, by: Any) -> list[list[Any]]:
    """g at a configuration moved by a small vector, in the coordinates of the ambient space."""
    place = {q: base[q] + d for q, d in zip(mechanism.frame.coordinates, by, strict=True)}
    there = GenericPoint(base | place, [p for p in made.definitions if _still(p, mechanism)])
    return [[there.value(e) for e in row] for row in made.kinetic]


def _difference(
    made: Any, mechanism: Mechanism, base: Any, direction: list[Any]
) -> list[list[Any]]:
    ahead = _shifted(made, mechanism, base, [STEP * d for d in direction])
    back = _shifted(made, mechanism, base, [-STEP * d for d in direction])
    return [
        [(p - q) / (2 * STEP) for p, q in zip(*rows, strict=True)]
        for rows in zip(ahead, back, strict=True)
    ]


def _anchored(made: Any, mechanism: Mechanism, base: Any, y: list[Any]) -> list[Any]:
    here = GenericPoint(base, [p for p in made.definitions if _still(p, mechanism)])
    return [
        sum((here.value(e) * v for e, v in zip(row, y, strict=True)), mpmath.mpf(0))
        for row in made.anchor
    ]


def _along(made: Any, mechanism: Mechanism, base: Any, chosen: Any, s: int) -> Any:
    y_ = [chosen[v] for v in made.velocities]
    change = _difference(made, mechanism, base, _anchored(made, mechanism, base, y_))
    return sum(c * v for c, v in zip(change[s], y_, strict=True))


def _kinetic_slope(made: Any, mechanism: Mechanism, base: Any, s: int) -> list[list[Any]]:
    unit = [mpmath.mpf(int(i == s)) for i in range(len(made.velocities))]
    return _difference(made, mechanism, base, _anchored(made, mechanism, base, unit))


def test_the_sleigh_by_hand() -> None:
    made = constraint_distribution(sleigh())
    steps = dict(made.definitions)

    def plain(value: sp.Expr) -> sp.Expr:
        while value.free_symbols & steps.keys():
            value = value.xreplace(steps)
        return sp.simplify(value)

    assert made.velocities == (xdot, phidot)
    assert [plain(row[0]) for row in made.basis] == [1, sp.tan(phi), 0]
    assert plain(made.kinetic[0][0] - m / sp.cos(phi) ** 2) == 0
    assert plain(made.kinetic[1][1] - J - m * a**2) == 0
    assert made.nonzero == (sp.cos(phi),)


@pytest.mark.parametrize(
    ("mechanism", "words"),
    [
        (lambda: sleigh(BESIDE - 1), "is not linear and homogeneous"),
        (lambda: sleigh(xdot**2 - ydot**2), "is not linear and homogeneous"),
        (lambda: sleigh(BESIDE + TIME * xdot), "time enters"),
        (lambda: sleigh(speed=AHEAD**2), "not quadratic in the velocities"),
    ],
)
def test_what_is_not_of_this_kind_is_refused(mechanism: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        constraint_distribution(mechanism())
