"""Motions on a torus in closed form: from theta functions to states at any time."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import arb, ctx

from ..errors import InputError
from ..mechanics.attitude import attitude
from ..system import System, flat_pairs
from .attitude import Cover, Triad, cover
from .mean import mean
from .numbers import array_function, ball, ball_function, components, number
from .phases import halves, turned
from .prepared import Prepared, chain, prepared
from .quadrature import Quadrature, quadrature, series
from .separable import Separable, nu, nuprime
from .solution import ClosedForm, Figure, Solution

__all__ = ["BITS", "GenusTwo", "solved"]

#: Working precision of the set-up, in bits.
BITS = 320
#: Newton steps for the clock; it takes four or five.
_STEPS = 40


@dataclass(frozen=True)
class Clock:
    """t as a function of τ and back.

    Attributes
    ----------
    flow : Quadrature
        ∫ (dt/dτ) dτ.
    mean : arb
        The mean of dt/dτ.
    Omega : pair of (float, float)
        Mean velocity of the phases in t, each as a sum of two doubles.
    V, v_0 : array (2,)
        Velocity in τ and start of the phases.
    """

    flow: Quadrature
    mean: Any
    Omega: tuple[tuple[float, float], tuple[float, float]]
    V: Any
    v_0: Any

    def phases(self, times: Any) -> tuple[Any, Any]:
        """Phases (n, 2), modulo 4, and τ (n,) at the times (n,)."""
        mean_clock = self.flow.mean
        ideal = np.stack([turned(rate, times, 4.0) for rate in self.Omega], axis=1) + self.v_0
        tau = times / mean_clock
        delta = np.zeros_like(tau)
        # mean δ + p(v) = 0 is the equation of the clock; its left side grows with δ
        low, high = np.full_like(tau, -np.inf), np.full_like(tau, np.inf)
        for _ in range(_STEPS):
            v = ideal + delta[:, None] * self.V
            value, rate = self.flow.quasi(v, tau + delta)
            miss = mean_clock * delta + value
            low, high = np.where(miss < 0, delta, low), np.where(miss > 0, delta, high)
            step = -miss / (mean_clock + rate)
            following = delta + step
            outside = (following <= low) | (following >= high)
            outside &= np.isfinite(low) & np.isfinite(high)
            following[outside] = (low[outside] + high[outside]) / 2
            settled = np.abs(following - delta) <= 4e-16 * np.maximum(1.0, np.abs(delta))
            delta = following
            if settled.all():
                break
        return ideal + delta[:, None] * self.V, tau + delta


@dataclass(frozen=True)
class GenusTwo(Solution):
    """A motion on a two-dimensional torus.

    Attributes
    ----------
    system : System
        Lifted to space where it has a motion.
    parameters : mapping of Symbol to number
    start : tuple of numbers
        The lifted state at t = 0, as given.
    prepared : Prepared
    """

    system: System
    parameters: Mapping[sp.Symbol, Any]
    start: tuple[Any, ...]
    prepared: Prepared

    # --- functions of ν and ν′ ---------------------------------------------------------------

    @property
    def separable(self) -> Separable:
        """The formulas."""
        return self.prepared.separable

    def _arrays(
        self, formulas: Sequence[sp.Expr], further: Sequence[sp.Symbol] = ()
    ) -> Callable[..., Any]:
        """Formulas of the system as a function of ν, ν′ (3, n) and `further` arrays."""
        arguments, steps = chain(self.separable, formulas)
        made = array_function((*arguments, *further), tuple(formulas), steps)
        fixed = [number(self.prepared.values[s]) for s in arguments[6:]]

        def function(direction: Any, turning: Any, *others: Any) -> Any:
            found = made(*direction, *turning, *fixed, *others)
            return np.stack([np.broadcast_to(x, direction[0].shape) for x in found])

        return function

    @cached_property
    def _clock_rate(self) -> Callable[..., Any]:
        return self._arrays(components(self.separable.clock))

    @cached_property
    def _state(self) -> Callable[..., Any]:
        return self._arrays(self.separable.system.symbols)

    @cached_property
    def _fixed(self) -> Callable[..., Any]:
        return self._arrays([c for vector in self.separable.fixed for c in components(vector)])

    @cached_property
    def _places(self) -> tuple[Callable[..., Any] | None, int]:
        """Rates of what the motion has besides the attitude, and how many they are."""
        motion = self.separable.system.motion
        rates = (
            []
            if motion is None
            else [
                formula
                for name, formula in flat_pairs(motion.field)
                if name not in attitude.symbols
            ]
        )
        if not rates:
            return None, 0
        return self._arrays(rates, attitude.symbols), len(rates)

    # --- set-up ------------------------------------------------------------------------------

    @cached_property
    def _v_0(self) -> Any:
        return np.array([number(x) for x in self.prepared.torus.v_0])

    @cached_property
    def triad(self) -> Triad:
        """The triad of the two vectors that are fixed in space."""
        first, second = self._vectors(*self.prepared.torus.values(self._v_0[None, :]))
        place = len(self.separable.system.symbols)
        quaternion = [float(x) for x in self.start[place : place + 4]]
        return Triad.through(first[:, 0], second[:, 0], quaternion)

    def _vectors(self, direction: Any, turning: Any) -> tuple[Any, Any]:
        six = self._fixed(direction, turning)
        return six[:3], six[3:]

    def _attitude(self, direction: Any, turning: Any) -> Any:
        return self.triad.attitude(*self._vectors(direction, turning))

    @cached_property
    def _flows(self) -> tuple[Clock, tuple[Quadrature, ...]]:
        """The clock, and the quadratures of the places in space."""
        torus = self.prepared.torus
        places, count = self._places

        def rates(v: Any) -> Any:
            direction, turning = torus.values(v)
            clock = self._clock_rate(direction, turning)
            if places is None:
                return clock
            turns = self._attitude(direction, turning).T
            return np.concatenate([clock, clock * places(direction, turning, *turns)])

        found = series(rates)
        arguments, steps = chain(self.separable, components(self.separable.clock))
        function = ball_function(arguments, components(self.separable.clock), steps)
        fixed = [self.prepared.values[s] for s in arguments[6:]]
        exact = mean(torus, lambda *six: function(*six, *fixed)[0], found[0])
        flow = quadrature(found[0], torus.V, self._v_0, None if exact is None else number(exact))
        average = arb(flow.mean) if exact is None else exact
        with ctx.workprec(BITS):
            Omega = (halves(torus.V[0] / average), halves(torus.V[1] / average))
        V = np.array([number(x) for x in torus.V])
        clock = Clock(flow, average, Omega, V, self._v_0)
        return clock, tuple(quadrature(f, torus.V, self._v_0) for f in found[1 : 1 + count])

    @property
    def clock(self) -> Clock:
        """t as a function of τ and back."""
        return self._flows[0]

    @cached_property
    def _cover(self) -> Cover:
        torus = self.prepared.torus
        return cover(lambda v: self._attitude(*torus.values(v)), self.clock.flow.whole.grid)

    # --- answers -----------------------------------------------------------------------------

    def states(self, times: Any) -> Any:
        """Lifted states (n, size) at `times` (n,), in double precision."""
        v, tau = self.clock.phases(np.asarray(times, dtype=float))
        direction, turning = self.prepared.torus.values(v)
        reduced = self._state(direction, turning)
        motion = self.separable.system.motion
        if motion is None:
            return reduced.T
        turns = self._cover.signed(v, self._attitude(direction, turning))
        first = len(self.separable.system.symbols)
        given = np.array([float(x) for x in self.start[first:]])
        # the sign of the quaternion is that of the start
        origin = self._cover.signed(
            self._v_0[None, :], self._attitude(*self.prepared.torus.values(self._v_0[None, :]))
        )
        turns = turns * (1.0 if float(origin[0] @ given[:4]) > 0 else -1.0)
        places = [
            start + flow.mean * tau + flow.quasi(v, tau)[0]
            for start, flow in zip(given[4:], self._flows[1], strict=True)
        ]
        return np.concatenate([reduced, turns.T, np.array(places).reshape(-1, len(tau))]).T

    def rigorous(self, time: Any, digits: int = 30) -> tuple[Any, ...]:
        """The lifted state at one time as balls."""
        from .rigorous import rigorous_state

        return rigorous_state(self, time, digits)

    @cached_property
    def form(self) -> ClosedForm:  # type: ignore[override]
        """The curve, its ovals, frequencies."""
        return _form(self)


def _form(solution: GenusTwo) -> ClosedForm:
    motion, separable = solution.prepared, solution.separable
    torus = motion.torus
    turns = torus.turns
    y, z, tau, t = sp.symbols("y z tau t")
    z_1, z_2, y_1, y_2 = sp.symbols("z_1 z_2 y_1 y_2")
    d = [sp.Symbol(f"d{name}") for name in ("z_1", "z_2", "tau", "t")]
    a, b = separable.speeds
    clock = solution.clock
    figures = [
        *(Figure(str(name), motion.values[name], "constant") for name, _ in separable.constants),
        *(Figure(f"e_{i}", root, "branch point") for i, root in enumerate(motion.curve.roots, 1)),
        *(Figure(f"V_{i}", x, f"turns of z_{i} per unit of τ") for i, x in enumerate(turns, 1)),
        Figure("V_1/V_2", turns[0] / turns[1], "rotation number"),
        *(
            Figure(f"Y_{i + 1}{j + 1}", torus.lattice.Y[i, j], "period matrix iY")
            for i, j in ((0, 0), (0, 1), (1, 1))
        ),
        Figure("mean dt/dtau", clock.mean, "mean rate of the clock"),
        *(
            Figure(f"Omega_{i}", x / clock.mean, f"frequency of z_{i}", "1/s")
            for i, x in enumerate(turns, 1)
        ),
    ]
    ends = [motion.curve.ends(left) for left in torus.lattice.ovals]
    return ClosedForm(
        title=separable.title,
        motion="two-frequency motion on a torus",
        equations=(
            (y**2, sp.Mul(separable.leading, *(z - root for root in separable.roots))),
            (d[0] / y_1 + d[1] / y_2, sp.sympify(a) * d[2]),
            (z_1 * d[0] / y_1 + z_2 * d[1] / y_2, sp.sympify(b) * d[2]),
            (d[3] / d[2], components(separable.clock)[0]),
        ),
        figures=tuple(figures),
        ovals=tuple((number(low), number(high)) for low, high in ends),
        source=separable.source,
    )


def solved(separable: Separable, values: Mapping[sp.Symbol, Any], start: Sequence[Any]) -> GenusTwo:
    """Solve one motion of a separable system.

    Parameters
    ----------
    separable : Separable
    values : mapping of Symbol to number
        The parameters of its system, taken as exact numbers.
    start : sequence of numbers
        The lifted state at t = 0, in flat order (the reduced one where there is no motion).

    Raises
    ------
    InputError
        If the start is off the phase space or off the level.
    DegenerateError
        If roots of the curve coincide.
    """
    system = separable.system
    lifted = system.lifted() if system.motion else system
    if len(start) != len(lifted.symbols):
        raise InputError(
            f"start: it has {len(start)} numbers; {lifted.name} needs {len(lifted.symbols)}"
        )
    with ctx.workprec(BITS):
        motion = prepared(separable, values, start[: len(system.symbols)])
    return GenusTwo(lifted, {s: ball(x) for s, x in values.items()}, tuple(start), motion)
