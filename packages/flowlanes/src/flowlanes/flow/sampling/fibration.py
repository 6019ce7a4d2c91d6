"""Level of integrals as fibres over a compact base.

In many systems of mechanics some variables lie on spheres (a unit vector u) or are angles: they
form the base.  In the remaining variables v, the fibre, the relations and integrals are linear or
quadratic: over every base point there are an ellipsoid (a level of the energy) and planes
((u, v) = const).  Rays from the centre of their intersection reach every point of the
level exactly once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...formulas.compiled import CompiledTerms
from ...formulas.graph import Term
from ...system.arrays import FloatArray
from ..batched_linalg import batched_matvec, batched_solve, norm_squared_columns, row_dots


@dataclass(frozen=True)
class LevelCondition:
    """Formula with a given value on the level.

    Attributes
    ----------
    name : str
        Name of the integral; empty for a relation.
    term : Term
    target : float or array (k,)
        Value on the level; an array has a value for each point.
    """

    name: str
    term: Term
    target: float | FloatArray


@dataclass(frozen=True)
class Fibration:
    """Base and fibre of a level, and the conditions in the fibre.

    Attributes
    ----------
    size : int
        Number of state variables.
    spheres : tuple of tuples of int
        Indices of the variables of each unit vector of the base, or of a vector on an ellipsoid.
    axes : tuple of float
        Semi-axis for each variable of the base; 1 for an angle.
    angles : tuple of int
        Indices of the variables with period 2π.
    fibre : tuple of int
        Indices of the other variables.
    quadratic : LevelCondition
        Condition that is quadratic in the fibre and makes it bounded.
    linear : tuple of LevelCondition
        Conditions that are linear in the fibre.
    further : tuple of LevelCondition
        Other conditions, of any form.
    coefficients : Compiled
        Coefficients of the linear conditions: slopes row by row, values at zero; of the quadratic
        condition: second derivatives row by row, slopes at zero, value at zero.
    """

    size: int
    spheres: tuple[tuple[int, ...], ...]
    axes: tuple[float, ...]
    angles: tuple[int, ...]
    fibre: tuple[int, ...]
    quadratic: LevelCondition
    linear: tuple[LevelCondition, ...]
    further: tuple[LevelCondition, ...]
    coefficients: CompiledTerms

    @property
    def rays(self) -> int:
        """Dimension of the space of ray directions in a fibre."""
        return len(self.fibre) - len(self.linear)

    @property
    def base(self) -> tuple[int, ...]:
        """Indices of the base variables: unit vectors, then angles."""
        return (*(place for places in self.spheres for place in places), *self.angles)

    @property
    def balls(self) -> tuple[slice, ...]:
        """Slices of the unit vectors among the coordinates y of a point: base and ray."""
        sizes = [*map(len, self.spheres)]
        ends = [sum(sizes[: i + 1]) for i in range(len(sizes))]
        start = len(self.base)
        parts = [slice(end - size, end) for end, size in zip(ends, sizes, strict=True)]
        return (*parts, slice(start, start + len(self.fibre)))

    @property
    def numbers(self) -> int:
        """Number of coordinates y of a point of the level."""
        return len(self.base) + len(self.fibre)

    def uniform_points(self, gauss: FloatArray) -> FloatArray:
        """Uniform points on the product of spheres and circles, from normal random numbers (y, k).

        Angles are obtained through the normal distribution function, uniform in (0, 2π).
        """
        from scipy.special import ndtr

        places = gauss.copy()
        for part in self.balls:
            places[part] = gauss[part] / np.sqrt(norm_squared_columns(gauss[part]))
        for row in range(len(self.base) - len(self.angles), len(self.base)):
            places[row] = 2 * np.pi * ndtr(gauss[row])
        return places

    def base_states(self, places: FloatArray) -> FloatArray:
        """Base variables (b, k) of points y (y, k)."""
        return np.array(self.axes)[:, None] * places[: len(self.base)]

    def gauss(self, places: FloatArray) -> FloatArray:
        """Numbers that `uniform_points` maps to the points y."""
        from scipy.special import ndtri

        numbers = places.copy()
        for row in range(len(self.base) - len(self.angles), len(self.base)):
            numbers[row] = ndtri(np.mod(places[row] / (2 * np.pi), 1.0))
        return numbers

    def over(self, places: FloatArray, parameters: FloatArray) -> FibrePoints:
        """Points of the level for points y (y, k)."""
        states = np.zeros((self.size, places.shape[1]))
        states[list(self.base)] = self.base_states(places)
        return self.fill(states, places[len(self.base) :], parameters)

    def fill(
        self, states: FloatArray, directions: FloatArray, parameters: FloatArray
    ) -> FibrePoints:
        """Points of the level over base points, along rays of given directions.

        Parameters
        ----------
        states : array (size, k)
            Base points; their fibre variables are computed.
        directions : array (f, k)
            Vectors in the fibre; the rays are parallel to their projections onto the linear
            conditions.
        parameters : array (p,)
        """
        # On a fibre the linear conditions are n x + a = targets, and the quadratic one is c + b·x
        # + x·A x/2.  Its minimum on the plane solves the saddle-point system [A nᵀ; n 0].
        n, a, A, b, c = self.parts(states, parameters)
        f, m = len(self.fibre), len(self.linear)
        targets = np.array([condition.target for condition in self.linear])
        corner = np.zeros((states.shape[1], f + m, f + m))
        corner[:, :f, :f], corner[:, :f, f:], corner[:, f:, :f] = A, np.swapaxes(n, 1, 2), n
        saddle = batched_solve(corner, np.concatenate([-b, targets - a], axis=1))
        centre, pull = saddle[:, :f], saddle[:, f:]
        excess = self.quadratic.target - (
            c + row_dots(b, centre) + 0.5 * row_dots(centre, batched_matvec(A, centre))
        )
        # Directions are projected onto the plane of the linear conditions.
        gram = n @ np.swapaxes(n, 1, 2)
        shadow = directions.T
        share = batched_solve(gram, batched_matvec(n, shadow))
        shadow = shadow - batched_matvec(np.swapaxes(n, 1, 2), share)
        span = np.sqrt(row_dots(shadow, shadow))
        ray = shadow / span[:, None]
        # Along the ray the quadratic condition is excess = length² stiffness/2.  With r ray
        # dimensions the volume element is length^(r−1) dlength, and dlength = dE/(length ·
        # stiffness); the determinant is that of δ(linear conditions).
        stiffness = row_dots(ray, batched_matvec(A, ray))
        with np.errstate(invalid="ignore", divide="ignore"):
            length = np.sqrt(2 * np.where(excess > 0, excess, np.nan) / stiffness)
            volume = length ** (self.rays - 2) / stiffness / np.sqrt(np.linalg.det(gram))
        filled = states.copy()
        filled[list(self.fibre)] = (centre + length[:, None] * ray).T
        return FibrePoints(
            states=filled,
            excess=excess,
            volume=np.where(excess > 0, volume, 0.0),
            centre=centre,
            pull=pull,
            ray=ray,
            length=length,
            share=share,
            span=span,
            normals=n,
            saddle=corner,
        )

    def parts(self, states: FloatArray, parameters: FloatArray) -> tuple[FloatArray, ...]:
        """Coefficients of the conditions in the fibres over base points.

        Slopes (k, m, f) and values (k, m) of the linear conditions at zero fibre; second
        derivatives (k, f, f), slopes (k, f) and values (k,) of the quadratic one.
        """
        k = states.shape[1]
        f, m = len(self.fibre), len(self.linear)
        flat = np.ascontiguousarray(self.coefficients(states, parameters).T)
        cuts = np.cumsum([m * f, m, f * f, f])
        n, a, A, b, c = np.split(flat, cuts, axis=1)
        return n.reshape(k, m, f), a, A.reshape(k, f, f), b, c[:, 0]


@dataclass(frozen=True)
class FibrePoints:
    """Points at the ends of rays.

    Attributes
    ----------
    states : array (size, k)
        NaN in the fibre where there is no point.
    excess : array (k,)
        Level of the quadratic integral minus its minimum in the fibre; negative if there is no
        point of the level over this base point.
    volume : array (k,)
        Volume δ(conditions) d(fibre) for a unit solid angle of rays; zero where there is no point.
    centre, pull : arrays (k, f), (k, m)
        Minimum of the quadratic integral in the fibre, and the multipliers of the linear
        conditions there.
    ray, length : arrays (k, f), (k,)
        Unit vectors and lengths of the rays.
    share, span : arrays (k, m), (k,)
        Coefficients of the projection of the directions that is removed by the linear conditions,
        and the lengths of the remainders.
    normals : array (k, m, f)
        Slopes of the linear conditions.
    saddle : array (k, f + m, f + m)
        Matrix of the equations for centre and pull.
    """

    states: FloatArray
    excess: FloatArray
    volume: FloatArray
    centre: FloatArray
    pull: FloatArray
    ray: FloatArray
    length: FloatArray
    share: FloatArray
    span: FloatArray
    normals: FloatArray
    saddle: FloatArray
