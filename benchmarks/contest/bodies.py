"""The three bodies, random starts, and motions with 34 digits as references for errors."""

from __future__ import annotations

import hashlib
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import heyoka as hy
import numpy as np
import sympy as sp

import chaplygin
import nonholonomic
from chaplygin import Forces, System
from flowlanes.flow.initial_states import flat_starts
from flowlanes.flow.machine_code import code_cache as cache
from flowlanes.flow.taylor.heyoka_expressions import Translator

__all__ = ["BEYOND", "BODIES", "Body", "deviation", "rows"]

GRAVITY = 9.81
#: Tolerance of the motions with 34 digits, far below every measured error.
FINE = 1e-21
#: Bits and tolerance of the references for motions with 30 digits.
BITS, FINEST = 160, 1e-38


@dataclass(frozen=True)
class Body:
    """Body rolling on a plane, and the durations of its motions.

    Attributes
    ----------
    span, long, short : float
        Duration in seconds of the motions of an ensemble, of a single motion, and of motions with
        tangent vectors or 30 digits; short enough that chaos does not amplify rounding much.
    spin : float
        The components of the angular velocity at the start are uniform between −spin and spin.
    """

    name: str
    system: System
    span: float
    long: float
    short: float
    spin: float = 2.0

    @property
    def size(self) -> int:
        """Number of state variables."""
        return len(self.system.symbols)

    @cached_property
    def numbers(self) -> list[float]:
        """Values of the parameters."""
        return [float(p.default) for p in self.system.parameters]

    @cached_property
    def taylor(self) -> list[tuple[Any, Any]]:
        """Equations for heyoka, with numbers for the parameters."""
        translate = Translator(self.system)
        rates = translate.all(self.system.rates)
        values = {hy.par[i]: hy.expression(x) for i, x in enumerate(self.numbers)}
        return list(zip(translate.variables, hy.subs(rates, values), strict=True))

    @property
    def height(self) -> Any:
        """Function that vanishes on the section: the last component of γ."""
        return self.taylor[-1][0]

    def starts(self, seed: int, count: int) -> np.ndarray:
        """Random states: γ uniform on the sphere, ω uniform in a cube."""
        dice = np.random.default_rng([seed, *self.name.encode()])
        n = sum(str(s).startswith("gamma_") for s in self.system.symbols)
        # one after the other, so that a smaller number of starts is the beginning of a larger one
        drawn = [
            (dice.normal(size=n), dice.uniform(-self.spin, self.spin, size=n * (n - 1) // 2))
            for _ in range(count)
        ]
        gamma, omega = (np.array(rows) for rows in zip(*drawn, strict=True))
        return np.asarray(flat_starts(self.system, {"omega": omega, "gamma": gamma}))

    def ends(self, starts: np.ndarray, until: float) -> np.ndarray:
        """States at a time, computed with 34 digits and rounded."""
        return np.array([self._wide(start, until)[0] for start in starts])

    def crossings(self, starts: np.ndarray, until: float) -> np.ndarray:
        """Crossings of γ₃ = 0 with increasing γ₃ before a time: (starts, points, size)."""
        return rows([self._wide(start, until)[1] for start in starts], self.size)

    def tangents(self, starts: np.ndarray, until: float) -> np.ndarray:
        """State and derivative with respect to the start at a time: (starts, size + size²)."""
        return np.array([self._wide_tangent(start, until) for start in starts])

    def thirty(self, starts: np.ndarray, until: float) -> np.ndarray:
        """States at a time, computed with more than 34 digits and rounded to 34."""
        return np.array([self._finest(start, until) for start in starts])

    # --- references, kept on disk ------------------------------------------------------------

    def _wide(self, start: np.ndarray, until: float) -> tuple[np.ndarray, np.ndarray]:
        def compute() -> tuple[np.ndarray, np.ndarray]:
            found, motion = self._watched
            found.clear()
            motion.time, motion.state[:] = hy.real128(0), start.astype(hy.real128)
            motion.propagate_until(hy.real128(until))
            points = np.array(found, dtype=float).reshape(-1, self.size)
            return motion.state.astype(float), points

        return self._kept("motion", start, until, compute)

    @cached_property
    def _watched(self) -> tuple[list[Any], Any]:
        """List of crossings, and an integrator with 34 digits that appends to it."""
        found: list[Any] = []

        def seen(motion: Any, time: Any, _: int) -> None:
            motion.update_d_output(time)
            found.append(motion.d_output.astype(float))

        wide = hy.real128
        event = hy.nt_event(self.height, seen, direction=hy.event_direction.positive, fp_type=wide)
        motion = hy.taylor_adaptive(
            self.taylor,
            [wide(1)] * self.size,
            tol=wide(FINE),
            fp_type=wide,
            compact_mode=True,
            nt_events=[event],
        )
        return found, motion

    def _wide_tangent(self, start: np.ndarray, until: float) -> np.ndarray:
        def compute() -> np.ndarray:
            motion = self._varied
            motion.time = hy.real128(0)
            identity = np.eye(self.size).ravel()
            motion.state[:] = np.concatenate([start, identity]).astype(hy.real128)
            motion.propagate_until(hy.real128(until))
            return np.asarray(motion.state.astype(float))

        return self._kept("tangent", start, until, compute)

    @cached_property
    def _varied(self) -> Any:
        wide = hy.real128
        return hy.taylor_adaptive(
            hy.var_ode_sys(self.taylor, hy.var_args.vars, order=1),
            [wide(1)] * self.size,
            tol=wide(FINE),
            fp_type=wide,
            compact_mode=True,
        )

    def _finest(self, start: np.ndarray, until: float) -> np.ndarray:
        def compute() -> np.ndarray:
            many = hy.real
            motion = hy.taylor_adaptive(
                self.taylor,
                [many(float(x), BITS) for x in start],
                tol=many(FINEST, BITS),
                fp_type=many,
                prec=BITS,
                compact_mode=True,
            )
            motion.propagate_until(many(until, BITS))
            return np.array([hy.real128(str(x)) for x in motion.state])

        return self._kept("finest", start, until, compute)

    def _kept(self, what: str, start: np.ndarray, until: float, compute: Callable[[], Any]) -> Any:
        """Result of `compute`, from disk if it has been computed before."""
        text = sp.srepr(
            sp.Matrix([*self.system.rates, *(f for _, f in self.system.scalar_definitions)])
        )
        how = repr((self.numbers, start.tolist(), until, FINE, BITS, FINEST))
        name = hashlib.sha256(f"{what}\0{text}\0{how}".encode()).hexdigest()
        return cache.cached_entry(f"reference-{name}", compute)[0]


def _reduced(system: System) -> System:
    return replace(system, reconstruction=None, observables=(), guards=())


def _bodies() -> dict[str, Body]:
    catalogue = nonholonomic.CATALOGUE
    ball, ellipsoid = catalogue["chaplygin-ball"].system(), catalogue["marble-body"].system()
    rolling = catalogue["unbalanced-ball"].rolling()
    assert rolling is not None
    heavy = replace(rolling, field=Forces(GRAVITY)).system("heavy-unbalanced-ball")
    made = (
        Body("chaplygin-ball", _reduced(ball), span=20.0, long=1000.0, short=5.0),
        Body("unbalanced-ball", _reduced(heavy), span=20.0, long=50.0, short=5.0),
        Body("ellipsoid", _reduced(ellipsoid), span=10.0, long=20.0, short=2.5),
    )
    return {body.name: body for body in made}


def _beyond() -> dict[str, Body]:
    """Balls in four dimensions: moments in the coordinate planes, and a mass tensor."""
    tensor = [
        [0.4, 0.1, 0.0, 0.05],
        [0.1, 0.6, 0.0, 0.0],
        [0.0, 0.0, 0.9, 0.1],
        [0.05, 0, 0.1, 1.2],
    ]
    numbers = {"ball-4": {"dimension": 4}, "ball-4-tensor": {"mass_tensor": tensor}}
    made = (
        Body(
            name, _reduced(chaplygin.from_catalogue("chaplygin-ball-nd", **given)), 20.0, 50.0, 5.0
        )
        for name, given in numbers.items()
    )
    return {body.name: body for body in made}


BODIES = _bodies()
#: Bodies that are compared only if they are named.
BEYOND = _beyond()


def rows(found: list[np.ndarray], size: int) -> np.ndarray:
    """Lists of points of different lengths as one array, NaN beyond their ends."""
    most = max(1, *map(len, found))
    filled = np.full((len(found), most, size), np.nan)
    for row, points in zip(filled, found, strict=True):
        row[: len(points)] = np.reshape(points, (-1, size))
    return filled


def deviation(found: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """Largest error of each row, relative to the largest component.

    Points on only one side (a crossing just before or after the end) are omitted; a row without
    other points is NaN.
    """
    if exact.ndim == 3:
        common = min(found.shape[1], exact.shape[1])
        found, exact = found[:, :common], exact[:, :common]
    axes = tuple(range(1, exact.ndim))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        wrong = np.nanmax(np.abs(found - exact).astype(float), axis=axes)
        return np.asarray(wrong / np.nanmax(np.abs(exact).astype(float), axis=axes))
