"""Closed-form motions of the n-dimensional systems with special operators."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.balls import number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.matrices import Skew
from flowlanes.system.system import System

from ..base.solution import ClosedForm, NamedConstant, Solution, finite_times
from .clock import ProductClock
from .operators import Kind
from .separation import real_roots
from .torus_motion import Places, TorusMotion

#: Working precision of the set-up, in bits.
BITS = 320


class WaveSolution(Solution):
    """A motion of p and γ as a sum of waves in double precision."""

    @property
    def not_rigorous(self) -> str:
        """Quantities without rigorous bounds."""
        return "error bounds: the waves of this motion are summed up in double precision"

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """Raise an error: the waves are summed in double precision."""
        raise InputError(
            f"{self.system.title}: its closed form is evaluated in double precision alone, without "
            "error bounds"
        )


@dataclass(frozen=True, repr=False, eq=False)
class SphereSolution(WaveSolution):
    """A motion on the cotangent bundle of a sphere, on a torus of n' − 1 phases.

    Attributes
    ----------
    system : System
        The reduced system, without the motion in space.
    kind : Kind
    factors : tuple of arb
        a_i of the axes on which the motion takes place.
    D : arb
    axes : array (n, n')
        These axes, as columns, n' ≤ n.
    motion : TorusMotion
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    kind: Kind
    factors: tuple[arb, ...]
    D: arb
    axes: FloatArray
    motion: TorusMotion

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """States at `times` (N,), as an array (N, size), in double precision."""
        return self._states(self.motion.at(finite_times(times)))

    def parameters_at(self, times: FloatArray) -> FloatArray:
        """τ at times (N,)."""
        return self.motion.tau(times)

    def along(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """States (N, size) and dt/dτ at τ = x (N,)."""
        places = self.motion.along(x)
        return self._states(places), places.clock

    def _states(self, places: Places) -> FloatArray:
        a = np.array([number(x) for x in self.factors])
        velocity = places.rate / places.clock
        p, gamma = _MAPS[self.kind](a, number(self.D), places.vector, velocity)
        return in_state(self.system, self.axes @ p, self.axes @ gamma)

    @property
    def phase_rate(self) -> float:
        """The rate at which the phases grow with time, in turns."""
        return sum(abs(number(x)) for x in self.motion.frequencies)

    @cached_property
    def form(self) -> ClosedForm:
        """The curve, its roots, frequencies."""
        with ctx.workprec(BITS):
            return _form(self)


def in_state(system: System, p: FloatArray, gamma: FloatArray) -> FloatArray:
    """States (N, size) from p and γ (n, N), with k = p∧γ."""
    if not any(isinstance(name, Skew) for name in system.state):
        return np.concatenate([p, gamma]).T
    rows, columns = np.triu_indices(len(p), 1)
    k = p[rows] * gamma[columns] - p[columns] * gamma[rows]
    return np.concatenate([k, gamma]).T


def _of_veselova(
    a: FloatArray, D: float, y: FloatArray, velocity: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """γ = y, γ̇ = −u."""
    return _heavier(a, y, -velocity), y


def _heavier(a: FloatArray, gamma: FloatArray, u: FloatArray) -> FloatArray:
    """p = W A u − (Au, γ) A γ."""
    turned, weighted = a[:, None] * u, a[:, None] * gamma
    p: FloatArray = np.sum(weighted * gamma, axis=0) * turned - (
        np.sum(turned * gamma, axis=0) * weighted
    )
    return p


def _of_ball(
    a: FloatArray, D: float, y: FloatArray, velocity: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """D W γ̇ = −(W − ΠAΠ/D) p, where Π is the projection orthogonal to γ = y."""
    W = np.sum(y * y / a[:, None], axis=0)
    gamma = y.T
    across = np.eye(len(a)) - gamma[:, :, None] * gamma[:, None, :]
    operator = W[:, None, None] * np.eye(len(a)) - across @ (a[:, None] * across) / D
    sides = (-D * W * velocity).T
    return np.linalg.solve(operator, sides[:, :, None])[:, :, 0].T, y


def _of_surrounding(
    a: FloatArray, D: float, y: FloatArray, velocity: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """γ = W^(1/2) A^(−1/2) y, 1/W = (y, A⁻¹y), γ̇ = u."""
    root = np.sqrt(a)[:, None]
    W = 1 / np.sum(y * y / a[:, None], axis=0)
    # `growth` is dW/dt.
    growth = -2 * W**2 * np.sum(y * velocity / a[:, None], axis=0)
    gamma = np.sqrt(W) * y / root
    u = np.sqrt(W) * velocity / root + growth / (2 * W) * gamma
    return _heavier(a, gamma, u), gamma


_MAPS = {
    Kind.VESELOVA: _of_veselova,
    Kind.BALL: _of_ball,
    Kind.SURROUNDING: _of_surrounding,
}
_WORDS = {
    Kind.VESELOVA: "y = γ, c = 1/a",
    Kind.BALL: "y = γ, c = a",
    Kind.SURROUNDING: "y = A^(1/2)γ/|A^(1/2)γ|, c = 1/a",
}


def _form(solution: SphereSolution) -> ClosedForm:
    motion = solution.motion
    separation = motion.separation
    genus = len(separation.ovals)
    z = [sp.Symbol(f"z_{k + 1}") for k in range(genus)]
    own = [sp.Symbol(f"y_{k + 1}") for k in range(genus)]
    d = [sp.Symbol(f"dz_{k + 1}") for k in range(genus)]
    dtau, dt, top, y = sp.symbols("dtau dt z y")
    c = [sp.Symbol(f"c_{i + 1}") for i in range(genus + 1)]
    f = [sp.Symbol(f"f_{i + 1}") for i in range(separation.integral.degree())]
    clock = motion.clock
    product = isinstance(clock, ProductClock)
    lead = sp.Symbol("P_0")
    first = [sp.Symbol("c_0")] if product else []
    equations = [
        (y**2, -4 * lead * sp.Mul(*(top - x for x in (*first, *c, *f)))),
        *(
            (
                sp.Add(*(a**i * b / e for a, b, e in zip(z, d, own, strict=True))),
                _speed(separation.speeds[i], i) * dtau,
            )
            for i in range(genus)
        ),
        (
            dt / dtau,
            sp.Symbol("s_0") * sp.sqrt(sp.Mul(*z))
            if product
            else 1 / sp.sqrt(sp.Add(*c) - sp.Add(*z)),
        ),
    ]
    integral = separation.integral.coeffs()
    poles = [*([arb(0)] if product else []), *sorted(separation.poles, key=number)]
    figures = [
        *(
            NamedConstant(f"c_{i}", x, "root of the curve")
            for i, x in enumerate(poles, 0 if product else 1)
        ),
        *(
            NamedConstant(f"f_{i}", x, "root of the curve, an integral")
            for i, x in enumerate(sorted(real_roots(separation.integral), key=number), 1)
        ),
        NamedConstant("P_0", integral[-1], "leading coefficient, an integral"),
        *(
            NamedConstant(f"v_{i}", x, "speed of an Abelian integral")
            for i, x in enumerate(separation.speeds)
            if not x.is_zero() and x != 1
        ),
        *(
            NamedConstant(f"V_{i}", x, f"turns of z_{i} per unit of τ")
            for i, x in enumerate(motion.turns, 1)
        ),
        *(
            [NamedConstant("s_0", clock.scale, "factor of the clock")]
            if isinstance(clock, ProductClock)
            else []
        ),
        NamedConstant("mean dt/dtau", motion.mean, "mean rate of the clock (error estimated)"),
        *(
            NamedConstant(f"Omega_{i}", x, f"frequency of z_{i} (error estimated)", "turns/s")
            for i, x in enumerate(motion.frequencies, 1)
        ),
    ]
    return ClosedForm(
        title=f"Separation on a curve of genus {genus}, {_WORDS[solution.kind]}",
        motion=f"quasi-periodic on a torus, {genus} frequencies",
        equations=tuple(equations),
        constants=tuple(figures),
        ovals=motion.ends,
        source=solution.system.source,
    )


def _speed(value: arb, index: int) -> sp.Expr:
    if value.is_zero():
        return sp.S.Zero
    return sp.S.One if value == 1 else sp.Symbol(f"v_{index}")
