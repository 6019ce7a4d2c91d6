"""The velocities of the mechanism in terms of those of the base, and the form (4.4).

On a level c of the linear integrals q̇ determines the velocities u: the equations
ρu = q̇, (ℓ, u) = c − ℓ₀, Cu = 0 have the solution u = q̇₁Y₁ + q̇₂Y₂ + y.  An integral Φ(q, u) that is
quadratic in u becomes E₂ + E₁ + E₀ by degrees in q̇.  If E₁ = 0 and E₂ is not degenerate, let
L = E₂ − E₀: along every motion 0 = Φ̇ = Σ q̇_i (d/dt ∂L/∂q̇_i − ∂L/∂q_i), and the terms in
parentheses are of degree two in q̇, hence equal to (q̇₂S, −q̇₁S) with S = a₁q̇₁ + a₂q̇₂ + b. With μ
= ∂Φ/∂u

    P_i = ∂L/∂q̇_i = (Y_i, μ),    Ṗ_i = (Ẏ_i, μ) + (Y_i, μ̇),

and μ̇ contains no accelerations if Φ is the energy or a quadratic function of the momenta.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from .base_coordinates import Base
from .integrals import Linear
from .linear_algebra import inverse, product
from .momenta import ReducedMomenta
from .rational_evaluation import Formulas
from .rational_functions import Value

Point = Any


@dataclass(frozen=True)
class Quadratic:
    """An integral quadratic in the velocities, restricted to the base.

    Attributes
    ----------
    value : Expr
        The quadratic part of Φ(q, u), that of the kinetic energy.
    potential : Expr
        The remaining part of Φ.
    slope : Matrix
        μ = ∂Φ/∂u.
    rate : Matrix
        μ̇ along the motion, in q and u, without the forces of the constraints C u = 0.
    """

    value: sp.Expr
    potential: sp.Expr
    slope: sp.Matrix
    rate: sp.Matrix

    def multiple(self, factor: sp.Expr) -> Quadratic:
        """The integral multiplied by a factor."""
        return Quadratic(
            factor * self.value,
            factor * self.potential,
            factor * self.slope,
            factor * self.rate,
        )

    def __add__(self, other: Quadratic) -> Quadratic:
        return Quadratic(
            self.value + other.value,
            self.potential + other.potential,
            self.slope + other.slope,
            self.rate + other.rate,
        )


def energy(motion: ReducedMomenta, base: Base) -> Quadratic:
    """The energy ½(u, Gu) + U."""
    u = sp.Matrix(motion.velocities)
    moved = motion.metric * u
    rate = motion.force - motion.gyroscopic.applyfunc(motion.rate)
    return _on_base((u.T * moved)[0] / 2, motion.potential, moved, rate, base)


def in_momenta(
    motion: ReducedMomenta, base: Base, form: sp.Matrix, potential: sp.Expr
) -> Quadratic:
    """The integral ½(m, Bm) + φ(q) for a constant symmetric matrix B."""
    m = motion.momenta
    turned = motion.metric * form * m
    rate = motion.metric.applyfunc(motion.rate) * form * m + motion.metric * form * motion.force
    return _on_base((m.T * form * m)[0] / 2, potential, turned, rate, base)


def _on_base(
    value: sp.Expr, potential: sp.Expr, slope: sp.Matrix, rate: sp.Matrix, base: Base
) -> Quadratic:
    place = base.inside
    return Quadratic(
        value.xreplace(place),
        potential.subs(place, simultaneous=True),
        slope.xreplace(place),
        rate.xreplace(place),
    )


@dataclass(frozen=True)
class Lift:
    """The linear equations K u = e for the velocities u.

    Attributes
    ----------
    base : Base
    matrix : Matrix
        K: the rows of ρ, of the integrals ℓ, and of C.
    right_side : Matrix
        The column (0, 0, c − ℓ₀, 0).
    integrals : tuple of Linear
        The linear integrals, in the coordinates of the mechanism.
    levels : tuple of Expr
        Their values c: symbols or numbers.
    """

    base: Base
    matrix: sp.Matrix
    right_side: sp.Matrix
    integrals: tuple[Linear, ...]
    levels: tuple[sp.Expr, ...]

    @property
    def constants(self) -> tuple[sp.Symbol, ...]:
        """The levels that are symbols."""
        return tuple(c for c in self.levels if isinstance(c, sp.Symbol))

    @property
    def level_expressions(self) -> tuple[sp.Expr, ...]:
        """Expressions that vanish on the level, in the mechanism's coordinates."""
        pairs = zip(self.integrals, self.levels, strict=True)
        return tuple(integral.value - level for integral, level in pairs)

    @property
    def constraint_rows(self) -> sp.Matrix:
        """The rows of ℓ and C."""
        return self.matrix[2:, :]


def lift(base: Base, integrals: Sequence[Linear], levels: Sequence[sp.Expr]) -> Lift:
    """The equations for given linear integrals and their values."""
    u = base.motion.velocities
    placed = [f.value.xreplace(base.inside) for f in integrals]
    inhomogeneous = [f.xreplace(dict.fromkeys(u, sp.S.Zero)) for f in placed]
    rows = [[sp.diff(f, s) for s in u] for f in placed]
    matrix = sp.Matrix.vstack(
        base.rates,
        sp.Matrix(len(rows), len(u), [x for row in rows for x in row]),
        base.motion.constraints,
    )
    level = [c - f for c, f in zip(levels, inhomogeneous, strict=True)]
    known = sp.Matrix([0, 0, *level, *([0] * base.motion.constraints.rows)])
    return Lift(base, matrix, known, tuple(integrals), tuple(levels))


@dataclass(frozen=True)
class ChaplyginFormAtPoint:
    """The parts of (4.4) at one point.

    Attributes
    ----------
    metric : list of rows
        G of E₂ = ½(q̇, Gq̇).
    linear : list
        Coefficients of E₁, which must vanish.
    a : list
        a₁, a₂ of S.
    b : Value
    """

    metric: list[list[Value]]
    linear: list[Value]
    a: list[Value]
    b: Value

    def form(self, like: Value) -> tuple[Value, Value]:
        """The 1-form d ln N = A₂ dq₁ − A₁ dq₂ of Theorem 6, with A = G⁻¹a."""
        first, second = product(inverse(self.metric, like), self.a)
        return second, -first


@dataclass(frozen=True)
class PointwiseForm:
    """Exact evaluation of (4.4) at points."""

    lift: Lift
    integral: Quadratic
    owner: str

    @cached_property
    def _place(self) -> Formulas:
        q, u = self.lift.base.coordinates, self.lift.base.motion.velocities
        still = dict.fromkeys(u, sp.S.Zero)
        form = self.integral.slope.jacobian(u)
        parts: list[sp.Expr] = []
        for matrix in (self.lift.matrix, form):
            parts += [*matrix, *matrix.diff(q[0]), *matrix.diff(q[1])]
        parts += [*self.lift.right_side, *self.integral.slope.xreplace(still)]
        return Formulas(parts, self.owner)

    @cached_property
    def _moving(self) -> Formulas:
        return Formulas([*self.integral.slope, *self.integral.rate], self.owner)

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols that need a value."""
        u = self.lift.base.motion.velocities
        both = {*self._place.symbols, *self._moving.symbols} - set(u)
        return tuple(sorted(both, key=str))

    def at(self, point: Point, like: Value) -> ChaplyginFormAtPoint:
        """The parts of (4.4) at a point.

        Raises
        ------
        ZeroDivisionError
            If K is singular there.
        """
        u = self.lift.base.motion.velocities
        size = len(u)
        values = iter(self._place.at(point, like))

        def matrix() -> list[list[Value]]:
            return [[next(values) for _ in range(size)] for _ in range(size)]

        K, *dK = (matrix() for _ in range(3))
        Q, *dQ = (matrix() for _ in range(3))
        e, h = ([next(values) for _ in range(size)] for _ in range(2))
        solve = inverse(K, like)
        # the columns of K⁻¹ that belong to ρu = q̇; dY = −K⁻¹ dK Y
        Y = [[row[i] for row in solve] for i in (0, 1)]
        y = product(solve, e)
        dY = [[_minus(product(solve, product(dK[j], Y[i]))) for j in (0, 1)] for i in (0, 1)]
        QY = [product(Q, v) for v in Y]
        G = [[_dot(Y[i], QY[j]) for j in (0, 1)] for i in (0, 1)]

        def slope(k: int, i: int, j: int) -> Value:
            own = _dot(dY[i][k], QY[j]) + _dot(dY[j][k], QY[i])
            return own + _dot(Y[i], product(dQ[k], Y[j]))

        def force(i: int, k: int, speed: int) -> Value:
            """Ṗ_i where q̇_k = speed and the other one vanishes."""
            at = dict(zip(u, (speed * a + b for a, b in zip(Y[k], y, strict=True)), strict=True))
            moving = self._moving.at({**point, **at}, like)
            mu, mudot = moving[:size], moving[size:]
            return _dot([speed * x for x in dY[i][k]], mu) + _dot(Y[i], mudot)

        # At q̇ = (0, s) the equation Ṗ₁ = ∂L/∂q₁ + q̇₂S is ½s² ∂g₂₂/∂q₁ − ∂E₀/∂q₁ + s²a₂ + sb: its
        # even part in s gives a₂ and its odd part b.  At q̇ = (s, 0) the even part of Ṗ₂ = ∂L/∂q₂ −
        # q̇₁S gives a₁.
        forward, back, still = (force(0, 1, s) for s in (1, -1, 0))
        second = (forward + back) / 2 - still
        other = (force(1, 0, 1) + force(1, 0, -1)) / 2 - force(1, 0, 0)
        carried = [a + b for a, b in zip(product(Q, y), h, strict=True)]
        return ChaplyginFormAtPoint(
            metric=G,
            linear=[_dot(v, carried) for v in Y],
            a=[slope(1, 0, 0) / 2 - other, second - slope(0, 1, 1) / 2],
            b=(forward - back) / 2,
        )


def _dot(first: Sequence[Value], second: Sequence[Value]) -> Value:
    return product([first], second)[0]


def _minus(column: Sequence[Value]) -> list[Value]:
    return [-x for x in column]
