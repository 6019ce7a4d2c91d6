"""The bifurcation diagram of a rubber body of revolution on the plane of its integrals (h, K).

A motion exists where V_K(u) = U(u) + K²/2(1 − u²) ≤ h.  Permanent rotations are the critical points
of V_K, the zeros of

    G(u) = (1 − u²)² U′(u) + K²u,

stable if G′ > 0; each one is isolated by the signs of G and G′ in ball arithmetic.  By Morse theory
on a line, the number of separate motions with the same (h, K) increases by one where h passes the
value of a minimum, and decreases by one where it passes that of a maximum.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
import sympy as sp
from flint import arb, ctx, fmpq

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.system.arrays import FloatArray
from flowlanes.system.overview import Overview, WithOverview

from ...mechanics.rolling.equations import RollingBody
from ..one_degree.divided_differences import Argument, Formula, jet
from .body import AxisymmetricBody, body_of, u

#: Working precision in bits.
BITS = 120

#: Permanent rotations closer than this to the vertical (in cos θ) are omitted.
MARGIN = 2.0**-20

#: Points (h, K, cos θ) of a curve.
Points = list[tuple[float, float, float]]

#: Width below which intervals are not halved.
NARROWEST = 1e-14


@dataclass(frozen=True)
class PermanentRotation:
    """A permanent rotation at given K.

    Attributes
    ----------
    u : flint.arb
        cos θ.
    h : flint.arb
        Its energy.
    stable : bool
    """

    u: arb
    h: arb
    stable: bool


@dataclass(frozen=True)
class Column:
    """All motions with one value of K, except those within MARGIN of the vertical.

    Attributes
    ----------
    K : float
    rests : tuple of PermanentRotation
        In order of their energy.
    counts : tuple of int
        Numbers of separate motions below the first rotation (none), between the first and the
        second, …, above the last.
    """

    K: float
    rests: tuple[PermanentRotation, ...]
    counts: tuple[int, ...]

    def motions_at(self, h: float) -> int | None:
        """The number of separate motions with the energy h; None if this is undecided."""
        with ctx.workprec(BITS):
            value = exact(h)
            energy = arb(fmpq(value.numerator, value.denominator))
            if any(rotation.h.overlaps(energy) for rotation in self.rests):
                return None
            return self.counts[sum(bool(rotation.h < energy) for rotation in self.rests)]


@dataclass(frozen=True, repr=False)
class Diagram(WithOverview):
    """The bifurcation diagram.

    Attributes
    ----------
    columns : tuple of Column
        By increasing K.
    curves : tuple of arrays (n, 3)
        Families of permanent rotations: rows (h, K, cos θ), for K ≥ 0; the diagram is symmetric.
    stable : tuple of bool
        Of each curve.
    """

    columns: tuple[Column, ...]
    curves: tuple[FloatArray, ...]
    stable: tuple[bool, ...]

    def overview(self) -> Overview:
        """The spins and the families of permanent rotations."""
        spins = [column.K for column in self.columns]
        stable = sum(self.stable)
        return Overview(
            "Bifurcation diagram of a rubber body of revolution in the plane of h and K",
            (
                ("columns", f"{len(spins)}, K from {spins[0]:.4g} to {spins[-1]:.4g}"),
                ("families", f"{stable} stable, {len(self.stable) - stable} unstable"),
            ),
        )


@arguments_checked
def revolution_diagram(
    rolling: RollingBody,
    spins: Sequence[float],
    parameters: Mapping[sp.Symbol, NumberOrText] | None = None,
) -> Diagram:
    """The bifurcation diagram of a rubber body of revolution in the plane of h and K of (5.1).

    Parameters
    ----------
    rolling : RollingBody
        A rubber body of revolution on a plane.
    spins : sequence of float
        Positive values of K, increasing.
    parameters : mapping of Symbol to number, optional
        Values that replace the body's.

    Returns
    -------
    Diagram
        One column of permanent rotations and numbers of motions for each K.

    Raises
    ------
    InputError
        If the body is another one, or K is not positive.

    Examples
    --------
    Upright rolling of a disk is unstable for K² < mga, here 9.81 J; disks then also roll leaning.

    >>> import nonholonomic
    >>> from nonholonomic.closed_form import revolution_diagram
    >>> body = nonholonomic.Body(1.0, (0.25, 0.25, 0.5), nonholonomic.Disk(1.0))
    >>> disk = nonholonomic.RollingBody(body, contact="rubber", field=nonholonomic.Forces(9.81))
    >>> diagram = revolution_diagram(disk, [1.0, 4.0])
    >>> [[rotation.stable for rotation in column.rests] for column in diagram.columns]
    [[True, True, False], [True]]
    >>> diagram.columns[0].motions_at(8.0)
    2
    """
    body = body_of(rolling, {**rolling.system().defaults, **(parameters or {})})
    if body is None:
        raise InputError("the diagram of (h, K) belongs to a rubber body of revolution on a plane")
    spins = [float(K) for K in spins]
    if not spins or any(first >= second for first, second in pairwise(spins)):
        raise InputError("spins: they must be one or more values of K, each above the one before")
    columns = tuple(columns_at(body, K) for K in spins)
    curves = _curves(columns)
    return Diagram(columns, tuple(c for c, _ in curves), tuple(stable for _, stable in curves))


def columns_at(body: AxisymmetricBody, K: float) -> Column:
    """The permanent rotations at one K > 0, and the numbers of motions between them.

    Raises
    ------
    InputError
        If K is not positive, or two permanent rotations are too close together to be separated.
    """
    if not 0 < K < np.inf:
        raise InputError(
            f"K = {K}: it must be positive and finite; the diagram is symmetric, and ends at K = 0"
        )
    with ctx.workprec(BITS):
        value = exact(K)
        square = arb(fmpq(value.numerator, value.denominator))
        square = square * square
        slope = _slope(body.energy)

        def G(x: Argument) -> Argument:
            return body.value(slope, x) + square * x

        rests = []
        for x, rising in _zeros(G):
            energy = body.value(body.energy, x) + square / (2 * (1 - x * x))
            rests.append(PermanentRotation(x, energy, rising))
        rests.sort(key=lambda rotation: float(rotation.h))
        counts = [0]
        for rotation in rests:
            counts.append(counts[-1] + (1 if rotation.stable else -1))
        return Column(float(K), tuple(rests), tuple(counts))


@lru_cache(maxsize=64)
def _slope(energy: sp.Expr) -> sp.Expr:
    """(1 − u²)² U′ as a formula whose denominator does not vanish in the upright position."""
    return sp.expand_mul((1 - u**2) ** 2 * energy.diff(u))


def _zeros(G: Formula) -> list[tuple[arb, bool]]:
    """The zeros of G between the poles, in order, and whether G increases there."""
    zeros: list[tuple[arb, bool]] = []
    waiting = [(arb(-1 + MARGIN), arb(1 - MARGIN))]
    while waiting:
        left, right = waiting.pop()
        value, rate, _ = jet(G, left.union(right))
        if value > 0 or value < 0:
            continue
        first, last = jet(G, left)[0], jet(G, right)[0]
        apart = (first > 0 or first < 0) and (last > 0 or last < 0)
        if apart and (rate > 0 or rate < 0):
            if (first > 0) != (last > 0):
                zeros.append((_zero_between(G, left, right), bool(rate > 0)))
            continue
        if right - left < NARROWEST:
            raise InputError(
                f"near cos(theta) = {float(left):.6g} two permanent rotations merge at this K: it "
                "lies on the border of two regions"
            )
        # Not in the middle, where symmetric bodies have a zero.
        middle = (left + (right - left) * arb("0.4871")).mid()
        waiting += [(middle, right), (left, middle)]
    return sorted(zeros, key=lambda pair: float(pair[0]))


def _zero_between(G: Formula, left: arb, right: arb) -> arb:
    """The zero of a monotone function, by interval Newton steps."""
    ball = left.union(right)
    for _ in range(60):
        middle = ball.mid()
        value = jet(G, middle)[0]
        image = middle - value / jet(G, ball)[1]
        narrower = image.intersection(ball)
        if not narrower.rad() < ball.rad() / 2:
            return narrower
        ball = narrower
    return ball


def _curves(columns: Sequence[Column]) -> list[tuple[FloatArray, bool]]:
    """Connect permanent rotations of neighbouring columns to curves of one stability.

    Each curve continues with the nearest rotation of the next column; a curve without a partner
    ends, as where a stable and an unstable rotation merge.
    """
    running: list[tuple[Points, bool]] = []
    done: list[tuple[Points, bool]] = []
    for column in columns:
        free = [
            ((float(rotation.h), column.K, float(rotation.u)), rotation.stable)
            for rotation in column.rests
        ]
        pairs = sorted(
            (abs(points[-1][2] - point[2]), i, j)
            for i, (points, stable) in enumerate(running)
            for j, (point, kind) in enumerate(free)
            if kind == stable
        )
        partner: dict[int, int] = {}
        for _, i, j in pairs:
            if i not in partner and j not in partner.values():
                partner[i] = j
        done += [curve for i, curve in enumerate(running) if i not in partner]
        continued = [([*running[i][0], free[j][0]], free[j][1]) for i, j in partner.items()]
        fresh = [k for k in range(len(free)) if k not in partner.values()]
        running = [*continued, *(([free[k][0]], free[k][1]) for k in fresh)]
    return [(np.array(points), stable) for points, stable in (*done, *running)]
