"""States of a body with an axis of symmetry at any time: the angle about the axis, and the place.

The axes of the body follow from e by an angle φ: with k_r one of the vectors that stand still,

    f₁ ∥ k_r − (k_r, e)e,  f₂ = e×f₁,        φ̇ = (ω₃ − (k_r, e)(k_r, ω))/(1 − (k_r, e)²),

and the axes next to e are f₁ and f₂ turned by φ.  k_r is taken such that e stays away from it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import acb, arb, ctx
from scipy.spatial.transform import Rotation

from ..system import System
from .degenerate_axial import Axial
from .degenerate_quaternion import cross, dot, product, quaternion, times_array
from .one_variable import Course, Places
from .one_variable_charts import BALLS, DOUBLES, Chart
from .one_variable_panels import working_bits
from .revolution import balls_of, needed
from .revolution_angles import Turning
from .solution import ClosedForm, Figure, Solution

__all__ = ["AxialSolution", "Scene"]

FAST = 19
#: Points of σ at which signs of quaternions are remembered.
POINTS = 512


@dataclass(frozen=True)
class Scene:
    """What a motion has been asked of.

    Attributes
    ----------
    system : System
        Lifted.
    parameters : mapping of Symbol to number
    title, source : str
    symmetry : int
        Number of the body axis that is e, from 0.
    attitude : four arb
        At the start.
    place : tuple of arb
        At the start; empty for a body with a fixed point.
    """

    system: System
    parameters: Mapping[sp.Symbol, Any]
    title: str
    source: str
    symmetry: int
    attitude: tuple[Any, ...]
    place: tuple[Any, ...]

    def with_axis_last(self, vector: Sequence[Any]) -> list[Any]:
        """Components in the order in which e is the last one."""
        i = self.symmetry
        return [vector[(i + 1) % 3], vector[(i + 2) % 3], vector[i]]

    def as_given(self, vector: Sequence[Any]) -> list[Any]:
        """The opposite."""
        i = self.symmetry
        return [vector[(k - i - 1) % 3] for k in range(3)]


@dataclass(frozen=True, eq=False)
class AxialSolution(Solution):
    """A motion on which u changes."""

    scene: Scene
    axial: Axial
    chart: Chart
    u: Any
    rate: Any
    system: System = field(init=False)
    parameters: Mapping[sp.Symbol, Any] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "system", self.scene.system)
        object.__setattr__(self, "parameters", self.scene.parameters)

    # --- along the motion ------------------------------------------------------------------

    @cached_property
    def reference(self) -> int:
        """r."""
        largest = [0.0] * 3
        sigma = np.linspace(-np.pi, np.pi, 65)
        for place in sigma:
            u = self.chart.place(BALLS, arb(place))
            slope = self.chart.slope(BALLS, arb(place)) / self.chart.clock(acb(place)).real
            for r, part in enumerate(self.axial.axis(BALLS, u, slope)):
                largest[r] = max(largest[r], abs(float(part.mid())))
        return int(np.argmin(largest))

    def _rates(self, u: Any, rate: Any) -> list[Any]:
        e, omega = self.axial.axis(BALLS, u, rate), self.axial.omega(BALLS, u, rate)
        near = e[self.reference]
        turning = (dot(e, omega) - near * omega[self.reference]) / (1 - near * near)
        return [turning, *(self.axial.velocity(BALLS, u, rate) or [])]

    @cached_property
    def course(self) -> Course:
        """u with φ and the place."""
        return Course(self.chart, self.u, self.rate, self._rates)

    def _axes(self, F: Any, u: Any, rate: Any) -> list[list[Any]]:
        """f₁, f₂ and e."""
        e, r = self.axial.axis(F, u, rate), self.reference
        length = F.sqrt(1 - e[r] * e[r])
        first = [((1.0 if k == r else 0.0) - e[r] * e[k]) / length for k in range(3)]
        return [first, cross(e, first), e]

    @cached_property
    def _stand(self) -> list[list[Any]]:
        """k₁, k₂, k₃ in space axes."""
        return [product(self.scene.attitude, self.scene.as_given(k)) for k in self.axial.frame()]

    def _begin(self, digits: int) -> tuple[Any, list[Any]]:
        """φ at σ = 0 and the place there, in the frame k."""
        known = self.course.integrals(digits)
        sigma = self.chart.phase(self.u, self.rate)
        first, second, _ = self._axes(BALLS, self.u, self.rate)
        k = self.axial.frame()
        # the first of the axes next to e, in the frame k
        own = [x[0] for x in k]
        phi = arb.atan2(dot(own, second), dot(own, first)) - known.value(1, sigma)
        count = len(known.panels[0].series)
        return phi, [-known.value(i, sigma) for i in range(2, count)]

    # --- in double precision ---------------------------------------------------------------

    @cached_property
    def _fast(self) -> FastAxial:
        with ctx.workprec(working_bits(FAST)):
            return FastAxial(self)

    def states(self, times: Any) -> Any:
        """Lifted states at `times` (n,), in double precision."""
        return self._fast(np.asarray(times, dtype=float))

    # --- in balls --------------------------------------------------------------------------

    def rigorous(self, time: Any, digits: int = 30) -> tuple[Any, ...]:
        """The lifted state at one time as balls that contain the exact one.

        Raises
        ------
        InputError
            If more digits are needed than the start is carried with.
        """
        near = self.states(np.array([float(balls_of(time).mid())]))[0]
        work = needed(time, digits, 1)
        with ctx.workprec(working_bits(work)):
            at = self.course.place(balls_of(time), work)
            u = self.chart.place(BALLS, at.phase)
            rate = self.chart.slope(BALLS, at.phase) / self.chart.clock(acb(at.phase)).real
            phi, path = self._begin(work)
            gains = self.course.advances(work)[1:] if self.course.periodic else ()
            tail = self._tail(at, work, u)
            totals = [
                value + sum(more, arb(0))
                for value, *more in zip(
                    at.values,
                    [at.periods * gain for gain in gains] or [arb(0)] * len(at.values),
                    tail,
                    strict=True,
                )
            ]
            if at.beyond != 0:
                end = self.course.tails[1 if at.beyond > 0 else 0]
                u, rate = u.union(end.place), rate.union(arb(0))
            turned = self._turned(u, rate, phi + totals[0])
            place = [a + b for a, b in zip(path, totals[1:], strict=True)]
            return self._assembled(u, rate, turned, place, near)

    def _tail(self, at: Places, work: int, u: Any) -> list[Any]:
        if at.beyond == 0:
            return [arb(0)] * len(at.values)
        end = self.course.tails[1 if at.beyond > 0 else 0]
        return [rate * at.beyond for rate in self.course.limits(work, end)]

    def _turned(self, u: Any, rate: Any, phi: Any) -> list[list[Any]]:
        """The body's axes, e last, in the frame k."""
        first, second, e = self._axes(BALLS, u, rate)
        sine, cosine = phi.sin_cos()
        along = [cosine * a + sine * b for a, b in zip(first, second, strict=True)]
        return [along, cross(e, along), e]

    def _assembled(
        self, u: Any, rate: Any, axes: list[list[Any]], path: list[Any], near: Any
    ) -> tuple[Any, ...]:
        given = self.scene.as_given(axes)
        vectors = self.axial.vectors(BALLS, u, rate)
        state = [dot(axis, vector) for vector in vectors for axis in given]
        columns = [self._in_space(axis) for axis in given]
        rows = [[column[i] for column in columns] for i in range(3)]
        size = len(state)
        turn = quaternion(rows, near[size : size + 4])
        place = self._in_space(path)[:2] if path else []
        moved = [x + y for x, y in zip(self.scene.place, place, strict=True)]
        return (*state, *turn, *moved)

    def _in_space(self, vector: Sequence[Any]) -> list[Any]:
        """From the frame k to space axes."""
        return [dot(vector, [k[i] for k in self._stand]) for i in range(3)]

    # --- what it looks like ----------------------------------------------------------------

    @cached_property
    def form(self) -> ClosedForm:
        """The equation of u, its turning points, period and mean rates."""
        u = sp.Symbol("u")
        with ctx.workprec(working_bits(FAST)):
            ends = sorted(float(x.place.mid()) for x in (self.chart.first, self.chart.second))
            figures = [
                Figure("u_1", self.chart.first.place, "turning point of u = (γ, e)"),
                Figure("u_2", self.chart.second.place, "turning point of u"),
            ]
            motion = "asymptotic to a steady rotation"
            if self.course.periodic:
                period, turn, *_ = self.course.advances(FAST)
                figures.append(Figure("T", period, "period of u", "s"))
                figures.append(Figure("phi", turn / period, "mean rate of φ", "rad/s"))
                motion = "the axis of symmetry is periodic in space, the body turns about it"
        return ClosedForm(
            title=self.scene.title + ", two equal moments",
            motion=motion,
            equations=((sp.Symbol("udot") ** 2, sp.Function("P")(u)),),
            figures=tuple(figures),
            ovals=((ends[0], ends[1]),),
            source=self.scene.source,
        )


class FastAxial:
    """The same in double precision, for many times at once."""

    def __init__(self, whole: AxialSolution) -> None:
        self._whole = whole
        course = whole.course
        phi, path = whole._begin(FAST)
        self._path = np.array([float(x.mid()) for x in path])
        self._phi = Turning.of(arb(0), phi)
        self._periodic = course.periodic
        if self._periodic:
            _, turn, *gains = course.advances(FAST)
            self._phi = Turning.of(turn, phi)
            self._gains = np.array([float(x.mid()) for x in gains])
        else:
            ends = [course.limits(FAST, end) for end in course.tails]
            self._tails = np.array([[float(x.mid()) for x in end] for end in ends])
        self._stand = np.array([[float(x.mid()) for x in k] for k in whole._stand])
        self._origin = np.array([float(x.mid()) for x in whole.scene.place])
        limit = np.pi if self._periodic else float(course.horizon(FAST).mid())
        self._low, self._step = -limit, 2 * limit / POINTS
        sigma = self._low + self._step * np.arange(POINTS + 1)
        clock = [float(whole.chart.clock(acb(x)).real.mid()) for x in sigma]
        table = self._frames(sigma, 1 / np.array(clock))[0]
        change = np.where(np.sum(table[1:] * table[:-1], axis=1) < 0, -1.0, 1.0)
        self._table = table * np.concatenate([[1.0], np.cumprod(change)])[:, None]
        self._flip = float(np.sign(self._table[0] @ self._table[-1])) if self._periodic else 1.0
        self._sign = 1.0
        start = np.array([float(x.mid()) for x in whole.scene.attitude])
        size = len(whole.scene.system.symbols) - 4 - len(self._origin)
        first = self(np.zeros(1))[0, size : size + 4]
        self._sign = 1.0 if float(first @ start) > 0 else -1.0

    def _frames(self, sigma: Any, pace: Any) -> tuple[Any, Any, Any]:
        """Quaternions (scalar first) of f₁, f₂, e in space, with any signs; u and u̇.

        `pace` is dσ/dt.
        """
        whole = self._whole
        u = whole.chart.place(DOUBLES, sigma)
        rate = whole.chart.slope(DOUBLES, sigma) * pace
        axes = [np.array(np.broadcast_arrays(*axis)) for axis in whole._axes(DOUBLES, u, rate)]
        given = np.array(whole.scene.as_given(axes))
        matrices = np.einsum("ikn,ks->nsi", given, self._stand)
        return np.roll(Rotation.from_matrix(matrices).as_quat(), 1, axis=1), u, rate

    def __call__(self, times: Any) -> Any:
        whole = self._whole
        at = whole.course.fast.place(times)
        turns, u, rate = self._frames(at.phase, at.rate)
        place = np.clip(np.rint((at.phase - self._low) / self._step), 0, POINTS).astype(int)
        sign = np.where(np.sum(self._table[place] * turns, axis=1) < 0, -1.0, 1.0)
        phi, *path = at.values
        path = np.array(path).reshape(-1, len(times)) + self._path[:, None]
        if self._periodic:
            sign = sign * np.where(at.periods % 2 == 1, self._flip, 1.0)
            phi = phi + self._phi(at.periods)
            path = path + np.multiply.outer(self._gains, at.periods)
        else:
            rates = np.where(at.beyond < 0, self._tails[0][:, None], self._tails[1][:, None])
            phi = phi + self._phi(np.zeros_like(phi)) + rates[0] * at.beyond
            path = path + rates[1:] * at.beyond
        half = np.zeros((len(times), 4))
        half[:, 0], half[:, 1 + whole.scene.symmetry] = np.cos(phi / 2), np.sin(phi / 2)
        turns = (self._sign * sign)[:, None] * times_array(turns, half)
        vectors = [np.array(np.broadcast_arrays(*v)) for v in whole.axial.vectors(DOUBLES, u, rate)]
        body = Rotation.from_quat(np.roll(turns, -1, axis=1)).inv()
        state = [body.apply(v.T @ self._stand) for v in vectors]
        columns = [*state, turns]
        if len(self._origin):
            columns.append((path.T @ self._stand)[:, :2] + self._origin)
        return np.concatenate(columns, axis=1)
