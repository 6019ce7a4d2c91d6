"""Points where random great circles over a fibration satisfy an additional condition.

Base points and ray directions form a point y of a product of spheres (and circles), which
determines a state.  A geodesic from a uniform point in a uniform direction intersects the
hypersurface F(y) = c at points whose density is the surface measure (Crofton's formula; Santaló),
that is |∇F| δ(F − c) dy.  Division by |∇F| gives exactly the measure δ(F − c), also at tangencies.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...formulas.compiled import CompiledTerms, SystemFormulas
from ...system.arrays import BoolArray, FloatArray, IntArray
from ..batched_linalg import batched_matvec, batched_solve, norm_squared_columns, row_dots
from .fibration import Fibration, FibrePoints
from .proposals import WeightedPoints

#: Length of a geodesic, and its initial number of pieces.
LENGTH = 0.5
PIECES = 1
#: A piece is halved, up to the given number of times, while the cubic through its ends differs at
#: its midpoint by more than this, relative to the largest value on the curve.
_HALVINGS = 10
_CUBIC = 0.01
#: Accuracy of a crossing, before the state is projected onto its level.
_FINE = 1e-12
#: Smallest parameter of a piece that ends at the edge of the level.
_EDGE = 1e-5

#: Maps curves and parameters on them to values and slopes.
Along = Callable[[IntArray, FloatArray], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True)
class GreatCircleProposal:
    """Additional condition of a fibration, with the terms of its slopes.

    Attributes
    ----------
    fibration : Fibration
    parameters : array (p,)
    target : float
    terms : Compiled
        At a point of the level: F, its slopes, the slopes of the quadratic condition.
    central : Compiled
        At the centre of a fibre, for each variable of the base: the slopes of the quadratic
        condition and of each linear condition, and the slopes of these in the fibre.
    """

    fibration: Fibration
    parameters: FloatArray
    target: float | FloatArray
    terms: CompiledTerms
    central: CompiledTerms

    @staticmethod
    def from_fibration(
        fibration: Fibration, sheet: SystemFormulas, parameters: FloatArray
    ) -> GreatCircleProposal:
        """Proposal for a fibration with one additional condition."""
        (further,) = fibration.further
        own, outer = sheet.slopes([further.term, fibration.quadratic.term])
        conditions = [fibration.quadratic.term, *(c.term for c in fibration.linear)]
        slopes = sheet.slopes(conditions)
        mixed = [sheet.slopes([row[i] for i in fibration.fibre]) for row in slopes]
        central = [
            term
            for row, second in zip(slopes, mixed, strict=True)
            for j in fibration.base
            for term in (row[j], *(line[j] for line in second))
        ]
        terms = CompiledTerms([further.term, *own, *outer])
        return GreatCircleProposal(
            fibration, parameters, further.target, terms, CompiledTerms(central)
        )

    # --- values and slopes ---------------------------------------------------------------------

    def excess(self, places: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Excess of the level over base points, and its slopes in y (k, y)."""
        rays = self.fibration.over(places, self.parameters)
        base, _ = self._central(rays)
        slopes = np.zeros(places.shape[::-1])
        # By the envelope theorem the slopes of the minimum in a fibre are those of the Lagrange
        # function.
        pulls = np.concatenate([np.ones((places.shape[1], 1)), rays.pull], axis=1)
        for j in range(len(self.fibration.base)):
            slopes[:, j] = -row_dots(pulls, base[:, :, j])
        return rays.excess, self._tangent(places, slopes)

    def value(self, places: FloatArray) -> tuple[FloatArray, FloatArray, FibrePoints]:
        """F − c, its slopes in y (k, y) and the points of the level."""
        fibration, size = self.fibration, self.fibration.size
        rays = fibration.over(places, self.parameters)
        flat = np.ascontiguousarray(self.terms(rays.states, self.parameters).T)
        F, own, outer = flat[:, 0], flat[:, 1 : size + 1], flat[:, size + 1 :]
        fibre, base = list(fibration.fibre), list(fibration.base)
        with np.errstate(invalid="ignore", divide="ignore"):
            # Derivative of F along the ray divided by that of the quadratic condition.
            rise = row_dots(own[:, fibre], rays.ray) / row_dots(outer[:, fibre], rays.ray)
        # Slopes of F along the level, where the length of the ray changes with its direction.
        free = own - rise[:, None] * outer
        across = free[:, fibre]
        inside = across - batched_matvec(
            np.swapaxes(rays.normals, 1, 2), self._shares(rays, across)
        )
        values, mixed = self._central(rays)
        slopes = np.concatenate(
            [free[:, base], inside * (rays.length / rays.span)[:, None]], axis=1
        )
        f = len(fibre)
        # The centre moves with the base point; its change follows from the same saddle-point
        # system.
        reach = batched_solve(
            rays.saddle, np.concatenate([across, np.zeros_like(rays.pull)], axis=1)
        )
        lean, push = reach[:, :f], reach[:, f:]
        shares, shadow = self._shares(rays, across), rays.ray
        for j in range(len(base)):
            turned = mixed[:, :, j]
            slopes[:, j] -= row_dots(lean, turned[:, 0]) + row_dots(push, values[:, 1:, j])
            slopes[:, j] -= row_dots(rays.pull, batched_matvec(turned[:, 1:], lean))
            tilt = row_dots(batched_matvec(turned[:, 1:], inside), rays.share) / rays.span
            tilt = tilt + row_dots(shares, batched_matvec(turned[:, 1:], shadow))
            slopes[:, j] -= rays.length * tilt
        return F - self.target, self._tangent(places, slopes), rays

    def _shares(self, rays: FibrePoints, vectors: FloatArray) -> FloatArray:
        """Coefficients of vectors in the basis of gradients of the linear conditions."""
        gram = rays.normals @ np.swapaxes(rays.normals, 1, 2)
        return batched_solve(gram, batched_matvec(rays.normals, vectors))

    def _central(self, rays: FibrePoints) -> tuple[FloatArray, FloatArray]:
        """`central` at the centres: slopes (k, 1 + m, b) and mixed ones (k, 1 + m, b, f)."""
        fibration = self.fibration
        f, b, m = len(fibration.fibre), len(fibration.base), len(fibration.linear)
        states = rays.states.copy()
        states[list(fibration.fibre)] = rays.centre.T
        flat = np.ascontiguousarray(self.central(states, self.parameters).T)
        table = flat.reshape(len(flat), 1 + m, b, 1 + f)
        return table[..., 0], table[..., 1:]

    def _tangent(self, places: FloatArray, slopes: FloatArray) -> FloatArray:
        """Slopes in y from those in the base variables and the direction of the ray."""
        tangents = slopes.copy()
        tangents[:, : len(self.fibration.axes)] *= self.fibration.axes
        return self._across(places, tangents)

    def _across(self, places: FloatArray, vectors: FloatArray) -> FloatArray:
        """Vectors without their components along the unit vectors."""
        tangents = vectors.copy()
        # Gradients on a sphere are the tangential parts.
        for part in self.fibration.balls:
            unit, own = places[part].T, vectors[:, part]
            tangents[:, part] = own - row_dots(own, unit)[:, None] * unit
        return tangents

    # --- proposals ---------------------------------------------------------------------------

    @property
    def numbers(self) -> int:
        """Number of normal random numbers per proposal: a point y and a direction."""
        return 2 * self.fibration.numbers

    @property
    def most(self) -> float:
        """Three: such a short geodesic rarely intersects a smooth surface more often."""
        return 3.0

    def weighted_points(self, gauss: FloatArray) -> WeightedPoints:
        """Points of the level on the geodesics given by normal random numbers (numbers, k)."""
        which, places = self.crossings(*self.curves(gauss))
        _, slopes, rays = self.value(places)
        with np.errstate(invalid="ignore", divide="ignore"):
            volume = rays.volume / np.sqrt(row_dots(slopes, slopes))
        real = np.flatnonzero(volume > 0)
        states = np.ascontiguousarray(rays.states[:, real])
        return WeightedPoints(which[real], places[:, real], states, volume[real])

    def nearby_proposals(self, gauss: FloatArray, fresh: FloatArray) -> FloatArray:
        """Geodesics that start at points given by `gauss` (y, k)."""
        return np.concatenate([gauss, fresh[self.fibration.numbers :]])

    # --- curves ----------------------------------------------------------------------------------

    def curves(self, gauss: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Uniform points and unit tangent vectors (y, k) from normal random numbers (2 y, k)."""
        half = gauss.shape[0] // 2
        places = self.fibration.uniform_points(gauss[:half])
        pushes = self._across(places, np.ascontiguousarray(gauss[half:].T)).T
        return places, pushes / np.sqrt(norm_squared_columns(pushes))

    def geodesic_points(
        self, places: FloatArray, pushes: FloatArray, way: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Points and velocities on geodesics after a length (k,) at unit speed."""
        there, speed = places + way * pushes, pushes.copy()
        for part in self.fibration.balls:
            # On a product of spheres a geodesic runs along a great circle of each factor, with
            # constant speed in each.
            rate = np.sqrt(norm_squared_columns(pushes[part]))
            turn = rate * way
            across = pushes[part] / rate
            there[part] = places[part] * np.cos(turn) + across * np.sin(turn)
            speed[part] = rate * (across * np.cos(turn) - places[part] * np.sin(turn))
        return there, speed

    def crossings(self, places: FloatArray, pushes: FloatArray) -> tuple[IntArray, FloatArray]:
        """Intersections of geodesics with the level: curve indices, points y (y, n)."""

        def reach(which: IntArray, way: FloatArray) -> tuple[FloatArray, FloatArray]:
            there, speed = self.geodesic_points(places[:, which], pushes[:, which], way)
            value, slopes = self.excess(there)
            return value, row_dots(slopes, speed.T)

        which, low, high = _parts(reach, places.shape[1])

        def along(index: IntArray, angle: FloatArray) -> tuple[FloatArray, FloatArray]:
            # Near the edge of the level rays have the length of a square root, which is smooth in
            # the new variable because of the cosine.
            half = (high[index] - low[index]) / 2
            way = low[index] + half * (1 - np.cos(np.pi * angle))
            there, speed = self.geodesic_points(
                places[:, which[index]], pushes[:, which[index]], way
            )
            value, slopes, _ = self.value(there)
            return value, row_dots(slopes, speed.T) * half * np.pi * np.sin(np.pi * angle)

        nodes = np.linspace(0.0, 1.0, PIECES + 1)
        nodes[0], nodes[-1] = _EDGE, 1 - _EDGE
        index, angle = crossings(along, which.size, nodes)
        half = (high[index] - low[index]) / 2
        way = low[index] + half * (1 - np.cos(np.pi * angle))
        return which[index], self.geodesic_points(
            places[:, which[index]], pushes[:, which[index]], way
        )[0]


def _parts(reach: Along, count: int) -> tuple[IntArray, FloatArray, FloatArray]:
    """Parts of curves over which the level has points: curves, start and end parameters."""
    which, way = crossings(reach, count, np.linspace(0.0, LENGTH, PIECES + 1))
    # The curve is cut where the excess of the level vanishes.
    curve = np.concatenate([np.arange(count), which, np.arange(count)])
    cut = np.concatenate([np.zeros(count), way, np.full(count, LENGTH)])
    order = np.lexsort((cut, curve))
    curve, cut = curve[order], cut[order]
    within = np.flatnonzero((curve[1:] == curve[:-1]) & (cut[1:] > cut[:-1]))
    curve, low, high = curve[within], cut[within], cut[within + 1]
    # Between two cuts the sign is constant, so the midpoint decides.
    over = reach(curve, (low + high) / 2)[0] > 0
    return curve[over], low[over], high[over]


@dataclass(frozen=True)
class Steps:
    """Intervals of functions: owner, ends, values and slopes at the ends (2, n)."""

    owner: IntArray
    ends: FloatArray
    values: FloatArray
    slopes: FloatArray

    def __getitem__(self, selection: IntArray) -> Steps:
        return Steps(
            self.owner[selection],
            self.ends[:, selection],
            self.values[:, selection],
            self.slopes[:, selection],
        )

    def union(self, other: Steps) -> Steps:
        """The union with other intervals."""
        return Steps(
            np.append(self.owner, other.owner),
            np.append(self.ends, other.ends, axis=1),
            np.append(self.values, other.values, axis=1),
            np.append(self.slopes, other.slopes, axis=1),
        )

    def halves(self, along: Along) -> tuple[Steps, FloatArray]:
        """Both halves of each interval, and the error of the cubic interpolant at the midpoint."""
        middle = self.ends.mean(axis=0)
        value, slope = along(self.owner, middle)
        # Value at the midpoint of the cubic Hermite interpolant.
        cubic = self.values.mean(axis=0) + np.diff(self.ends, axis=0)[0] / 8 * (
            self.slopes[0] - self.slopes[1]
        )
        inner = (middle, value, slope)
        outer = (self.ends, self.values, self.slopes)
        left = Steps(self.owner, *(np.stack([o[0], i]) for o, i in zip(outer, inner, strict=True)))
        right = Steps(self.owner, *(np.stack([i, o[1]]) for o, i in zip(outer, inner, strict=True)))
        return left.union(right), np.tile(np.abs(value - cubic), 2)


def crossings(along: Along, count: int, nodes: FloatArray) -> tuple[IntArray, FloatArray]:
    """All zeros of functions of one variable.

    Parameters
    ----------
    along : callable
        Numbers of functions (n,) and arguments (n,) ↦ values (n,) and slopes (n,).
    count : int
        Number of functions.
    nodes : array
        Initial arguments; intervals in which a function is not nearly a cubic are halved.

    Returns
    -------
    int array, array
        Functions and arguments, by function and in increasing order.
    """
    steps = _cubic_steps(along, count, nodes)
    # A function with equal signs at both ends can have two zeros in the interval only around an
    # extremum, whose sign is tested.
    sure = steps[np.flatnonzero(steps.values[0] * steps.values[1] < 0)]
    dips = steps[np.flatnonzero(_may_dip(steps))]
    turn = _zero(lambda which, s: along(dips.owner[which], s)[1], *dips.ends)
    there = along(dips.owner, turn)[0] if turn.size else turn
    past = np.flatnonzero(there * dips.values[0] < 0)
    owner = np.concatenate([sure.owner, dips.owner[past], dips.owner[past]])
    low = np.concatenate([sure.ends[0], dips.ends[0, past], turn[past]])
    high = np.concatenate([sure.ends[1], turn[past], dips.ends[1, past]])
    zeros = _zero(lambda which, s: along(owner[which], s)[0], low, high)
    order = np.lexsort((zeros, owner))
    return owner[order], zeros[order]


def _cubic_steps(along: Along, count: int, nodes: FloatArray) -> Steps:
    """Subdivide until every function is nearly a cubic in each interval."""
    flat = along(np.repeat(np.arange(count), nodes.size), np.tile(nodes, count))
    value, slope = (part.reshape(count, nodes.size) for part in flat)
    scale = np.abs(value).max(axis=1, initial=0.0)
    steps = Steps(
        np.repeat(np.arange(count), nodes.size - 1),
        np.stack([np.tile(nodes[:-1], count), np.tile(nodes[1:], count)]),
        np.stack([value[:, :-1].ravel(), value[:, 1:].ravel()]),
        np.stack([slope[:, :-1].ravel(), slope[:, 1:].ravel()]),
    )
    done = steps[np.arange(0)]
    for _ in range(_HALVINGS):
        steps, missed = steps.halves(along)
        rough = missed > _CUBIC * scale[steps.owner]
        done, steps = done.union(steps[np.flatnonzero(~rough)]), steps[np.flatnonzero(rough)]
    return done.union(steps)


def _may_dip(steps: Steps) -> BoolArray:
    """Intervals in which a function of constant sign may touch zero."""
    sign = np.sign(steps.values[0])
    left, right = sign * steps.values
    down, up = sign * steps.slopes
    with np.errstate(invalid="ignore", divide="ignore"):
        # Intersection of the tangents at both ends; a convex curve stays above it.
        meet = (right - left - up * np.diff(steps.ends, axis=0)[0]) / (down - up)
        lowest = left + down * meet
        result: BoolArray = (
            (right > 0) & (down < 0) & (up > 0) & (lowest < 0.5 * np.minimum(left, right))
        )
        return result


def _zero(
    function: Callable[[FloatArray, FloatArray], FloatArray], low: FloatArray, high: FloatArray
) -> FloatArray:
    """Zeros between parameters at which functions have opposite signs."""
    from scipy.optimize import elementwise

    if not low.size:
        return low
    which = np.arange(low.size)
    zeros = elementwise.find_root(
        lambda argument, own: function(own.astype(int), argument),
        (low, high),
        args=(which.astype(float),),
        tolerances={"xatol": _FINE},
    )
    result: FloatArray = zeros.x
    return result
