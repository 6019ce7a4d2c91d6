"""States of a body with an axis of symmetry at any time: the angle about the axis, and the place.

The axes of the body follow from e by an angle φ: with k_r one of the vectors that stand still,

    f₁ ∥ k_r − (k_r, e)e,  f₂ = e×f₁,        φ̇ = (ω₃ − (k_r, e)(k_r, ω))/(1 − (k_r, e)²),

and the axes next to e are f₁ and f₂ turned by φ.  k_r is taken such that e stays away from it.

u always oscillates.  For the Veselova system u̇² is a quadratic in u.  For the Chaplygin ball e is
on the unit sphere and, by the formula of M₃, on a conic cylinder about its centre whose quadratic
form has an eigenvalue below 1: so where a vertex of the conic touches the sphere from within, it is
the only place of the conic inside, and e rests there.
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

from ...arguments import Numbers, Written, arguments_checked
from ...core.system import System
from ..base.solution import ClosedForm, NamedConstant, Solution
from ..one_degree import QuadratureMotion
from ..one_degree.chebyshev_integrals import working_bits
from ..one_degree.uniformisation import BALLS, DOUBLES, Oscillating
from ..revolution import balls_of, needed
from ..revolution.angles import LinearPhase
from .axisymmetric import Axial
from .quaternion import cross, dot, product, quaternion, times_array

__all__ = ["AxialSolution", "SpaceFrame"]

FAST = 19
#: Points of σ at which signs of quaternions are remembered.
POINTS = 512


@dataclass(frozen=True)
class SpaceFrame:
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


@dataclass(frozen=True, eq=False, repr=False)
class AxialSolution(Solution):
    """A motion on which u changes."""

    scene: SpaceFrame
    axial: Axial
    chart: Oscillating
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
    def course(self) -> QuadratureMotion:
        """u with φ and the place."""
        units = (1.0, *(float(self.axial.length.mid()),) * 3)
        return QuadratureMotion(self.chart, self.u, self.rate, self._rates, units=units)

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

    @property
    def pace(self) -> float:
        """How fast the phase of u grows with time."""
        return 1 / self.course.moment

    @arguments_checked
    def states(self, times: Numbers) -> Any:
        """Lifted states at `times` (n,), in double precision."""
        return self._fast(np.asarray(times, dtype=float))

    # --- in balls --------------------------------------------------------------------------

    @arguments_checked
    def rigorous(self, time: Written, digits: int = 30) -> tuple[Any, ...]:
        """The lifted state at one time as balls that contain the exact one.

        Raises
        ------
        InputError
            If more digits are needed than the start is carried with.
        """
        near = self.states(np.array([float(balls_of(time).mid())]))[0]
        work = needed(time, digits, 1, self.pace)
        with ctx.workprec(working_bits(work)):
            at = self.course.place(balls_of(time), work)
            u = self.chart.place(BALLS, at.phase)
            rate = self.chart.slope(BALLS, at.phase) / self.chart.clock(acb(at.phase)).real
            phi, path = self._begin(work)
            gains = self.course.advances(work)[1:]
            totals = [x + at.periods * gain for x, gain in zip(at.values, gains, strict=True)]
            turned = self._turned(u, rate, phi + totals[0])
            place = [a + b for a, b in zip(path, totals[1:], strict=True)]
            return self._assembled(u, rate, turned, place, near)

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
        with ctx.workprec(working_bits(FAST)):
            ends = sorted(float(x.place.mid()) for x in (self.chart.first, self.chart.second))
            period, turn, *_ = self.course.advances(FAST)
            figures = (
                *(NamedConstant(*line) for line in self.axial.constants),
                NamedConstant("u_1", self.chart.first.place, "turning point of u = (γ, e)"),
                NamedConstant("u_2", self.chart.second.place, "turning point of u"),
                NamedConstant("T", period, "period of u", "s"),
                NamedConstant("phi", turn / period, "mean rate of the angle φ about e", "rad/s"),
            )
        return ClosedForm(
            title=self.scene.title + ", two equal moments",
            motion="the axis of symmetry is periodic in space, the body turns about it",
            equations=self.axial.shown,
            figures=figures,
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
        _, turn, *gains = course.advances(FAST)
        self._phi = LinearPhase.of(turn, phi)
        self._gains = np.array([float(x.mid()) for x in gains])
        self._stand = np.array([[float(x.mid()) for x in k] for k in whole._stand])
        self._origin = np.array([float(x.mid()) for x in whole.scene.place])
        sigma = np.linspace(-np.pi, np.pi, POINTS + 1)
        clock = [float(whole.chart.clock(acb(x)).real.mid()) for x in sigma]
        table = self._frames(sigma, 1 / np.array(clock))[0]
        change = np.where(np.sum(table[1:] * table[:-1], axis=1) < 0, -1.0, 1.0)
        self._table = table * np.concatenate([[1.0], np.cumprod(change)])[:, None]
        self._flip = float(np.sign(self._table[0] @ self._table[-1]))
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
        place = np.clip(np.rint((at.phase / np.pi + 1) * POINTS / 2), 0, POINTS).astype(int)
        sign = np.where(np.sum(self._table[place] * turns, axis=1) < 0, -1.0, 1.0)
        phi, *path = at.values
        path = np.array(path).reshape(-1, len(times)) + self._path[:, None]
        sign = sign * np.where(at.periods % 2 == 1, self._flip, 1.0)
        phi = phi + self._phi(at.periods)
        path = path + np.multiply.outer(self._gains, at.periods)
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
