"""How many tori lie on a level, by following motions: no more is used than the equations.

A level over a pair of ovals is cut into pieces by the signs of ν₁, ν₂, ν₃, ż₁, ż₂; each piece is a
rectangle.  One motion is started in every piece and pieces that a motion visits belong together.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

from flowlanes.system.vectors import to_components
from nonholonomic.closed_form.bifurcation import Diagram, Region
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem, nu, nuprime


class Level:
    """A level of a separated system, in numbers."""

    def __init__(
        self, separable: SeparatedSystem, diagram: Diagram, place: tuple[Any, Any]
    ) -> None:
        self.system = separable.system
        self.separable = separable
        x, y = map(Fraction, place)
        self.place = (float(x), float(y))
        known = {s: sp.Rational(str(v)) for s, v in diagram.parameters.items()}
        known |= {
            axis.symbol: sp.Rational(str(v)) for axis, v in zip(diagram.axes, (x, y), strict=True)
        }
        self.known: dict[Any, Any] = {**known}
        for symbol, value in self.system.scalar_definitions:
            if not value.free_symbols - set(self.known):
                self.known[symbol] = value.xreplace(self.known)
        for symbol, value in separable.constants:
            if symbol not in self.known:
                self.known[symbol] = to_components(sp.sympify(value)).subs(self.known)
        self.poles = self.numbers(separable.poles)
        self.weights = self.numbers(separable.weights)
        self.speeds = self.numbers(separable.along or separable.speeds)
        self.order = np.argsort(self.poles)
        self.curve = self.numeric(
            [separable.leading * sp.Mul(*(sp.Symbol("z") - r for r in separable.roots))],
            [sp.Symbol("z")],
        )
        self.rates = self.numeric(self.system.rates, self.system.symbols)
        self.values = self.numeric([a.value for a in diagram.axes], self.system.symbols)
        self.direction = self.numeric(list(to_components(separable.direction)), self.system.symbols)
        flat = []
        for _, formula in separable.state:
            value = to_components(formula)
            flat += list(value) if isinstance(value, sp.MatrixBase) else [value]
        self.state = self.numeric(flat, (*nu.symbols, *nuprime.symbols))

    def numbers(self, formulas: Any) -> np.ndarray:
        return np.array([float(to_components(sp.sympify(f)).subs(self.known)) for f in formulas])

    def numeric(self, formulas: Any, symbols: Any) -> Any:
        """Formulas as a function of an array (symbols, n), definitions filled in."""
        wanted = [to_components(sp.sympify(f)) for f in formulas]
        for symbol, value in reversed(self.system.scalar_definitions):
            wanted = [f.xreplace({symbol: value}) for f in wanted]
        made = sp.lambdify(list(symbols), [f.subs(self.known) for f in wanted], "numpy", cse=True)
        return lambda values: np.array(
            [np.broadcast_to(v, np.shape(values)[1:]) for v in made(*values)], dtype=float
        )

    def starts(self, first: tuple[float, float], second: tuple[float, float]) -> np.ndarray:
        """States at one point of a pair of ovals, with all signs: (size, 32)."""
        z = np.array([a + 0.37 * (b - a) for a, b in (first, second)])
        y = np.sqrt(self.curve(z[np.newaxis])[0])
        e, w = self.poles[:, np.newaxis], self.weights[:, np.newaxis]
        found = []
        for signs in product((1, -1), repeat=5):
            squares = (w * (e - z[0]) * (e - z[1]))[:, 0]
            direction = np.array(signs[:3]) * np.sqrt(squares / squares.sum())
            a, b = self.speeds
            u, v = signs[3] * y[0], signs[4] * y[1]
            moving = np.array([u * (a * z[1] - b), v * (b - a * z[0])]) / (z[1] - z[0])
            slopes = (moving / (self.poles[:, np.newaxis] - z)).sum(axis=1)
            turning = direction / 2 * ((direction**2 * slopes).sum() - slopes)
            found.append(np.concatenate([direction, turning]))
        return np.asarray(self.state(np.array(found).T))

    def coordinates(self, direction: np.ndarray) -> np.ndarray:
        """z₁ and z₂ of directions (3, …)."""
        e = self.poles
        rows = np.moveaxis(
            direction**2 / self.weights.reshape(3, *[1] * (direction.ndim - 1)), 0, -1
        )
        # e² − e s + p = ν²/(κ w), linear in s, p and 1/κ
        matrix = np.stack(np.broadcast_arrays(e, -np.ones(3), rows), axis=-1)
        total, prod, _ = np.moveaxis(
            np.linalg.solve(matrix, np.broadcast_to(e**2, rows.shape)[..., np.newaxis])[..., 0],
            -1,
            0,
        )
        spread = np.sqrt(np.maximum(total**2 - 4 * prod, 0))
        return np.array([(total - spread) / 2, (total + spread) / 2])

    def pieces(self, starts: np.ndarray, until: float, samples: int) -> list[set[int]]:
        """The pieces that each motion visits: the signs of ν and ż, as bits."""
        size, count = starts.shape
        run = solve_ivp(
            lambda _, x: self.rates(x.reshape(size, count)).ravel(),
            (0, until),
            starts.ravel(),
            method="DOP853",
            rtol=1e-9,
            atol=1e-11,
            t_eval=np.linspace(0, until, samples),
        )
        direction = self.direction(run.y.reshape(size, -1)).reshape(3, count, -1)
        z = self.coordinates(direction)
        turns = np.diff(z, axis=-1) > 0
        sides = direction > 0
        # only between samples around which no sign changes
        steady = (sides[:, :, 1:-2] == sides[:, :, 2:-1]).all(axis=0)
        for other in (turns[:, :, :-2], turns[:, :, 2:]):
            steady &= (turns[:, :, 1:-1] == other).all(axis=0)
        codes = np.tensordot(
            1 << np.arange(5), np.concatenate([sides[:, :, 1:-2], turns[:, :, 1:-1]]), axes=1
        )
        return [set(row[quiet]) for row, quiet in zip(codes, steady, strict=True)]


def counted(
    separable: SeparatedSystem, diagram: Diagram, region: Region, until: float
) -> list[int]:
    """The number of tori over each pair of ovals of a region."""
    level = Level(separable, diagram, region.sample)
    poles = np.sort(level.poles)
    edges = np.unique(np.concatenate([poles, _real_roots(level)]))
    inside = [
        [
            (a, b)
            for a, b in pairwise(edges)
            if low <= a < b <= high and level.curve(np.array([[(a + b) / 2]]))[0, 0] > 0
        ]
        for low, high in (poles[:2], poles[1:])
    ]
    found = []
    for pair in product(*inside):
        starts = level.starts(*pair)
        np.testing.assert_allclose(
            level.values(starts), np.array(level.place)[:, np.newaxis] * np.ones(32), atol=1e-9
        )
        found.append(_joined(level.pieces(starts, until, int(40 * until))))
    return found


def _real_roots(level: Level) -> np.ndarray:
    roots = np.array(
        [complex(to_components(sp.sympify(r)).subs(level.known)) for r in level.separable.roots[3:]]
    )
    roots = roots.real[abs(roots.imag) < 1e-12]
    return roots[(roots > level.poles.min()) & (roots < level.poles.max())]


def _joined(sets: list[set[int]]) -> int:
    """The number of classes when sets that share a member are put together; all 32 are needed."""
    assert set().union(*sets) == set(range(32))
    classes: list[set[int]] = []
    for new in sets:
        touching = [c for c in classes if c & new]
        classes = [c for c in classes if not c & new] + [new.union(*touching)]
    return len(classes)
