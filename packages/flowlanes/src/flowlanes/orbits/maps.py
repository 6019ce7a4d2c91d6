"""Maps of a section to itself, with their derivatives and integrals.

Periodic orbits, multipliers and continuation require only a map, of whatever origin: an
`ExplicitMap` is given by NumPy functions, and :mod:`.return_map` provides the return map of a
System to a section.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from ..system.arrays import FloatArray

Function = Callable[[FloatArray], FloatArray]

#: Imaginary step h: f(x + ih) = f(x) + ih f′(x) + O(h²) has no cancellation, and h² underflows.
_STEP = 1e-100


@dataclass(frozen=True)
class Image:
    """The images of points under a map.

    Attributes
    ----------
    points : array (n, size)
        NaN where a point has no image.
    times : array (n,)
        Times of flight; zero for a map without time.
    slopes : array (n, size, size) or None
        Derivatives: entry [k, i, j] is ∂(image i)/∂(coordinate j) at point k.
    """

    points: FloatArray
    times: FloatArray
    slopes: FloatArray | None = None


@dataclass(frozen=True)
class ConservedFunctions:
    """Functions that a map conserves.

    Attributes
    ----------
    names : tuple of str
    values : callable
        From points (n, size) to values (n, len(names)).
    slopes : callable
        From points (n, size) to derivatives (n, len(names), size).
    """

    names: tuple[str, ...]
    values: Function
    slopes: Function


NOTHING = ConservedFunctions(
    (), lambda x: np.zeros((len(x), 0)), lambda x: np.zeros((len(x), 0, x.shape[1]))
)


class Map(Protocol):
    """A map whose periodic orbits can be computed.

    Attributes
    ----------
    names : tuple of str
        The coordinates.
    periods : array (size,)
        The periods of angles; infinite for other coordinates.
    domain : ConservedFunctions
        Functions that vanish on the domain of the map: relations and the section.
    integrals : ConservedFunctions
        Functions that are constant on each orbit.
    trivial : tuple of str
        Multipliers equal to one that are omitted in advance, by their origin, such as the flow.
    """

    @property
    def names(self) -> tuple[str, ...]:
        """See the class."""
        ...

    @property
    def periods(self) -> FloatArray:
        """See the class."""
        ...

    @property
    def domain(self) -> ConservedFunctions:
        """See the class."""
        ...

    @property
    def integrals(self) -> ConservedFunctions:
        """See the class."""
        ...

    @property
    def trivial(self) -> tuple[str, ...]:
        """See the class."""
        ...

    def sizes(self, points: FloatArray) -> FloatArray:
        """Units of the coordinates at points (n, size)."""
        ...

    def image(self, points: FloatArray, count: int = 1, *, slopes: bool = False) -> Image:
        """Images of points (n, size) after `count` steps, with derivatives on request."""
        ...


def normalised_functions(
    values: FloatArray, slopes: FloatArray, sizes: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Values (..., r) and gradients (..., r, size) of functions, divided by the gradient norms."""
    local = slopes * sizes
    lengths = np.sqrt((local**2).sum(axis=-1))
    lengths[lengths == 0] = 1.0
    return values / lengths, local / lengths[..., None]


def slope_of(function: Function) -> Function:
    """The derivative of an analytic function by complex steps, exact to rounding.

    Parameters
    ----------
    function : callable
        From points (n, size), possibly complex, to values (n, r).

    Returns
    -------
    callable
        From points (n, size) to derivatives (n, r, size).
    """

    def slopes(points: FloatArray) -> FloatArray:
        columns = []
        for j in range(points.shape[1]):
            moved = points.astype(complex)
            moved[:, j] += 1j * _STEP
            columns.append(function(moved).imag / _STEP)
        return np.stack(columns, axis=-1)

    return slopes


@dataclass(frozen=True)
class ExplicitMap:
    """A map given by an analytic function.

    Parameters
    ----------
    names : tuple of str
        The coordinates.
    step : callable
        From points (n, size), possibly complex, to their images (n, size).
    angles : mapping of str to float
        Periods of coordinates that are angles.
    keeps : mapping of str to callable
        Functions from points (n, size) to values (n,) that the map conserves.
    """

    names: tuple[str, ...]
    step: Function
    angles: Mapping[str, float] = field(default_factory=dict)
    keeps: Mapping[str, Function] = field(default_factory=dict)
    domain: ConservedFunctions = NOTHING
    trivial: tuple[str, ...] = ()

    @property
    def periods(self) -> FloatArray:
        """The periods of the coordinates."""
        return np.array([self.angles.get(name, np.inf) for name in self.names])

    @property
    def integrals(self) -> ConservedFunctions:
        """The functions of `keeps`."""
        if not self.keeps:
            return NOTHING

        def values(points: FloatArray) -> FloatArray:
            return np.stack([function(points) for function in self.keeps.values()], axis=1)

        return ConservedFunctions(tuple(self.keeps), values, slope_of(values))

    def sizes(self, points: FloatArray) -> FloatArray:
        """All ones: coordinates of explicit maps are not rescaled."""
        return np.ones(len(self.names))

    def image(self, points: FloatArray, count: int = 1, *, slopes: bool = False) -> Image:
        """Images of points (n, size) after `count` steps."""
        slope, total = slope_of(self.step), None
        for _ in range(count):
            if slopes:
                local = slope(points)
                total = local if total is None else local @ total
            points = self.step(points)
        return Image(points, np.zeros(len(points)), total)
