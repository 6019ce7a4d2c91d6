"""Suslov's problem in n dimensions: ω in elementary functions.

With the column j = (J_1n, …), B = J′ + J_nn and w = (ω_1n, …) the equations are

    B ẇ = (j, w) w − w² j,    γ̇ = −ωγ.

* Where j = 0, w is constant and the body turns uniformly in one plane.  The same holds for w ∥ j.
* Where the plane of j and w is invariant under B, w stays in it.  In principal axes of B there,
  w = e (cos θ/√b_1, sin θ/√b_2), 2E = e², and

      θ̇ = λ sin(θ − θ_0),    tan ½(θ − θ_0) = exp(λt) tan ½(θ(0) − θ_0),

  with e κ = λ √(b_1 b_2), κ (cos θ_0, sin θ_0) = (j_1/√b_2, j_2/√b_1): from w ∥ j to w ∥ −j.  Every
  motion of three dimensions is of this kind.  γ and the attitude obey linear equations, which are
  integrated here; where θ has come so near to its limit that doubles see no difference, uniformly.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.balls import ball, exact, number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import dot

from ...catalogue import entry
from ..base.no_closed_form import not_among
from ..base.problem import Problem
from ..base.solution import ClosedForm, NamedConstant, Solution, finite_times
from .separation import unit

NAME = "suslov-nd"
#: λ|t| beyond which w equals its limit in double precision.
_LIMIT = 42.0
_TOLERANCE = 3e-14
#: Working precision of the set-up, in bits.
_BITS = 320
#: The dimension of a plane.
_PLANE = 2


@dataclass(frozen=True, repr=False)
class UniformTurning(Solution):
    """Constant w: a rotation in the plane of w and the last body axis.

    Attributes
    ----------
    system : System
        Lifted to space if it has a motion there.
    start : tuple of numbers
        The state at t = 0.
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    start: tuple[NumberOrText, ...]
    size: int

    def _rows(self, one: Callable[[NumberOrText], arb]) -> tuple[list[arb], list[list[arb]]]:
        """w, and γ with the rows of the attitude."""
        state = [one(x) for x in self.start]
        n = self.size
        vectors = [state[i : i + n] for i in range(n - 1, len(state), n)]
        return state[: n - 1], vectors

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """States at `times` (N,), as an array (N, size), in double precision."""
        moments = finite_times(times)
        w, vectors = self._rows(ball)
        speed = np.sqrt(sum(number(x) ** 2 for x in w))
        cosine, sine = np.cos(speed * moments), np.sin(speed * moments)
        fixed = [np.full(len(moments), number(x)) for x in w]
        unit = [number(x) / speed if speed else 0.0 for x in w]
        vectors_then = [
            _after_turn([number(x) for x in row], unit, cosine, sine) for row in vectors
        ]
        return np.stack([*fixed, *(x for row in vectors_then for x in row)], axis=1)

    @property
    def phase_rate(self) -> float:
        """Turns per unit of time."""
        return number(self._speed) / (2 * np.pi)

    @property
    def _speed(self) -> arb:
        w, _ = self._rows(ball)
        return sum((x * x for x in w), arb(0)).sqrt()

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The state at one time as balls that contain the exact one."""
        with ctx.workdps(digits + 30):
            w, vectors = self._rows(ball)
            speed = self._speed
            phase = speed * ball(time)
            unit = [arb(0) if speed.is_zero() else x / speed for x in w]
            rows = [_after_turn(row, unit, phase.cos(), phase.sin()) for row in vectors]
            return (*w, *(x for row in rows for x in row))

    @property
    def form(self) -> ClosedForm:
        """The rate of turning."""
        t, speed = sp.symbols("t Omega")
        return ClosedForm(
            title=self.system.title,
            motion="uniform rotation" if not self._speed.is_zero() else "rest",
            equations=(
                (sp.Symbol("g"), sp.Symbol("g_0") * sp.exp(t * sp.Symbol("omega"))),
                (speed, sp.sqrt(sp.Symbol("w") ** 2)),
            ),
            constants=(NamedConstant("Omega", self._speed, "rate of turning", "rad/s"),),
            source=self.system.source,
        )


@dataclass(frozen=True, repr=False)
class PlanarTurning(Solution):
    """w stays in one plane, from j to −j; γ and the attitude follow by integration.

    Attributes
    ----------
    basis : tuple of two tuples of n − 1 arb
        The principal axes of B in the plane of w.
    b : (arb, arb)
        Its eigenvalues.
    j : (arb, arb)
        The column j in these axes.
    w : (arb, arb)
        w at t = 0.
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    start: tuple[NumberOrText, ...]
    basis: tuple[tuple[arb, ...], tuple[arb, ...]]
    b: tuple[arb, arb]
    j: tuple[arb, arb]
    w: tuple[arb, arb]

    @property
    def _angles(self) -> tuple[arb, arb, arb, arb]:
        """e, λ, θ_0 and θ(0)."""
        (b, c), (j, k), (x, y) = self.b, self.j, self.w
        e = (b * x * x + c * y * y).sqrt()
        first, second = j / c.sqrt(), k / b.sqrt()
        rate = e * (first * first + second * second).sqrt() / (b * c).sqrt()
        return e, rate, _angle(second, first), _angle(c.sqrt() * y, b.sqrt() * x)

    @property
    def phase_rate(self) -> float:
        """The rate of convergence to the limit."""
        _, rate, _, _ = self._angles
        return number(rate) / (2 * np.pi)

    @property
    def not_rigorous(self) -> str:
        """Quantities without rigorous bounds."""
        return "γ and the attitude in formulas: they are integrated along the closed form of ω"

    def _velocity(self, times: FloatArray) -> FloatArray:
        """w at times (N,), as an array (n − 1, N)."""
        e, rate, zero, begin = map(number, self._angles)
        half = (begin - zero) / 2
        # at most e^700
        growth = np.exp(np.clip(rate * times, -700, 700))
        # The arctangent of two arguments stays finite where tan ½(θ(0) − θ_0) is infinite.
        theta = zero + 2 * np.arctan2(np.sin(half) * growth, np.cos(half))
        b, c = map(number, self.b)
        parts = np.array([e * np.cos(theta) / np.sqrt(b), e * np.sin(theta) / np.sqrt(c)])
        columns = np.array([[number(x) for x in axis] for axis in self.basis]).T
        velocity: FloatArray = columns @ parts
        return velocity

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """States at `times` (N,), as an array (N, size), in double precision."""
        moments = finite_times(times)
        size = len(self.basis[0]) + 1
        state = np.array([number(ball(x)) for x in self.start])
        rows = state[size - 1 :].reshape(-1, size)
        _, rate, _, _ = map(number, self._angles)
        last = _LIMIT / rate
        inner = np.clip(moments, -last, last)
        vectors_then = np.empty((len(moments), *rows.shape))
        for sign in (-1.0, 1.0):
            (chosen,) = np.nonzero((inner > 0) if sign > 0 else (inner <= 0))
            if len(chosen):
                vectors_then[chosen] = self._along(rows, inner[chosen], sign)
        velocity = self._velocity(moments)
        for place in np.flatnonzero(inner != moments):
            beyond = moments[place] - inner[place]
            vectors_then[place] = vectors_then[place] @ _turn(velocity[:, place], beyond)
        return np.concatenate([velocity.T, vectors_then.reshape(len(moments), -1)], axis=1)

    def _along(self, rows: FloatArray, times: FloatArray, sign: float) -> FloatArray:
        """Vectors fixed in space, at times of one sign."""
        from scipy.integrate import solve_ivp

        def rates(t: float, flat: FloatArray) -> FloatArray:
            w = self._velocity(np.array([t]))[:, 0]
            vectors = flat.reshape(rows.shape)
            # ẋ_i = −w_i x_n, ẋ_n = (w, x)
            change = np.column_stack([-vectors[:, -1:] * w, vectors[:, :-1] @ w])
            return change.ravel()

        ordered = np.unique(times)[:: int(sign)]
        if not ordered[-1]:
            return np.array([rows] * len(times))
        run = solve_ivp(
            rates,
            (0.0, ordered[-1]),
            rows.ravel(),
            method="DOP853",
            t_eval=ordered,
            rtol=_TOLERANCE,
            atol=_TOLERANCE,
        )
        found = {t: y.reshape(rows.shape) for t, y in zip(run.t, run.y.T, strict=True)}
        return np.array([found[t] for t in times])

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """Raise an error: γ is integrated in double precision."""
        raise InputError(
            f"{self.system.title}: γ and the attitude are integrated in double precision, without "
            "error bounds"
        )

    @property
    def form(self) -> ClosedForm:
        """The angle of w and its limits."""
        t, rate, theta, zero = sp.symbols("t lambda theta theta_0")
        with ctx.workprec(_BITS):
            e, speed, first, begin = self._angles
            constants = (
                NamedConstant("e", e, "square root of twice the energy"),
                NamedConstant("lambda", speed, "rate of the approach to the limit", "1/s"),
                NamedConstant("theta_0", first, "angle from which w comes"),
                NamedConstant("theta_1", begin, "angle at t = 0"),
                NamedConstant("b_1", self.b[0], "eigenvalue of B"),
                NamedConstant("b_2", self.b[1], "eigenvalue of B"),
            )
        half = sp.tan((sp.Symbol("theta_1") - zero) / 2)
        return ClosedForm(
            title=self.system.title,
            motion="from a steady rotation to the opposite one",
            equations=((sp.tan((theta - zero) / 2), half * sp.exp(rate * t)),),
            constants=constants,
            source=self.system.source,
        )


def _turn(w: FloatArray, time: float) -> FloatArray:
    """exp(tω) with ω_in = w_i."""
    speed = float(np.linalg.norm(w))
    size = len(w) + 1
    turning = np.zeros((size, size))
    turning[:-1, -1], turning[-1, :-1] = w, -w
    # Rodrigues' formula holds in any dimension here, since ω has rank 2 and ω³ = −w²ω.
    turn: FloatArray = (
        np.eye(size)
        + np.sin(speed * time) / speed * turning
        + (1 - np.cos(speed * time)) / speed**2 * turning @ turning
    )
    return turn


def _after_turn(row: Sequence[Any], unit: Sequence[Any], cosine: Any, sine: Any) -> list[Any]:
    """A vector fixed in space, x exp(tω) with ω_in = unit_i Ω, given its value x at t = 0."""
    *first, last = row
    along = sum(x * y for x, y in zip(first, unit, strict=True))
    # In the plane of the unit vector and the last axis: ẋ_i = −ω_in x_n, ẋ_n = ω_in x_i.
    change = along * (cosine - 1) - last * sine
    return [
        *(x + 0 * cosine + change * y for x, y in zip(first, unit, strict=True)),
        last * cosine + along * sine,
    ]


def solve_suslov(problem: Problem) -> Solution | None:
    """Solve Suslov's problem; None for any other problem.

    Raises
    ------
    NoClosedFormError
        If the plane of j and w is not invariant.
    """
    system = problem.system
    if system.name != NAME:
        return None
    numbers = problem.numbers
    n = next(place.stop for name, place in system.slices if str(name) == "w") + 1
    own = entry(NAME).system({"dimension": n} | {s: float(x) for s, x in numbers.items()})
    if (own.field, own.definitions) != (system.field, system.definitions):
        return None
    lifted = system.lifted() if system.reconstruction else system
    w = [exact(x) for x in problem.start[: n - 1]]
    j = [numbers.get(f"J_{i + 1}{n}", Fraction(0)) for i in range(n - 1)]
    if all(x * b == y * a for x, a in zip(w, j, strict=True) for y, b in zip(w, j, strict=True)):
        return UniformTurning(lifted, problem.parameters, problem.start, n)
    with ctx.workprec(_BITS):
        return _planar(problem, lifted, _matrix(numbers, n), j, w)


def _matrix(numbers: Mapping[str, Fraction], n: int) -> list[list[Fraction]]:
    """B = J′ + J_nn."""
    last = numbers[f"J_{n}{n}"]
    return [
        [
            numbers[f"J_{min(i, k) + 1}{max(i, k) + 1}"] + (last if i == k else 0)
            for k in range(n - 1)
        ]
        for i in range(n - 1)
    ]


def _planar(
    problem: Problem,
    lifted: System,
    B: Sequence[Sequence[Fraction]],
    j: Sequence[Fraction],
    w: Sequence[Fraction],
) -> PlanarTurning:
    images = [
        [sum((x * y for x, y in zip(row, v, strict=True)), Fraction(0)) for row in B]
        for v in (j, w)
    ]
    if any(_rank([j, w, image]) > _PLANE for image in images):
        raise not_among(
            problem, "with w and j = (J_1n, J_2n, …) in a plane that B = J′ + J_nn leaves invariant"
        )
    first = unit([ball(x) for x in j])
    other = [ball(x) for x in w]
    share = dot(first, other)
    second = unit([x - share * y for x, y in zip(other, first, strict=True)])
    matrix = [[ball(x) for x in row] for row in B]
    b, c, off = (
        dot(x, [dot(row, y) for row in matrix]).mid()
        for x, y in ((first, first), (second, second), (first, second))
    )
    # Of the two rotations that make B diagonal, take the smaller one.
    angle = arb.atan2(2 * off, b - c) / 2 if b > c else arb.atan2(-2 * off, c - b) / 2
    turn, across = angle.cos(), angle.sin()
    axes = (
        tuple((turn * x + across * y).mid() for x, y in zip(first, second, strict=True)),
        tuple((turn * y - across * x).mid() for x, y in zip(first, second, strict=True)),
    )
    values = [dot(axis, [dot(row, axis) for row in matrix]).mid() for axis in axes]
    along = [dot(axis, [ball(x) for x in j]).mid() for axis in axes]
    begin = [dot(axis, other).mid() for axis in axes]
    return PlanarTurning(
        lifted,
        problem.parameters,
        problem.start,
        axes,
        (values[0], values[1]),
        (along[0], along[1]),
        (begin[0], begin[1]),
    )


def _angle(y: arb, x: arb) -> arb:
    """The angle of a vector, modulo 2π, without a cut where x < 0."""
    return arb.pi() - arb.atan2(y, -x) if x < 0 else arb.atan2(y, x)


def _rank(rows: Sequence[Sequence[Fraction]]) -> int:
    return int(sp.Matrix([[sp.Rational(str(x)) for x in row] for row in rows]).rank())
