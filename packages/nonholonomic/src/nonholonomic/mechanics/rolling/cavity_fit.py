"""Whether cavities fit into the shape of a body, and beside each other."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

import numpy as np

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ..shapes.rays import directions
from ..shapes.shape_base import Shape
from .cavity import Cavity

#: Tangent planes that are looked at, and how often the neighbourhood of the worst is looked at.
PLANES, ROUNDS = 2000, 12
#: By how much of its size a cavity may reach out of a body, for rounding.
SLACK = 1e-9


def check_cavities(shape: Shape, cavities: Sequence[Cavity]) -> None:
    """Refuse cavities that reach out of a shape, or overlap.

    A convex body contains an ellipsoid if and only if it reaches as far in every direction; what
    is refused reaches further in a direction that was looked at.  A hollow ball has its matter
    outside, and nothing is refused there.

    Raises
    ------
    InputError
        If a cavity does not fit.
    """
    for number, cavity in enumerate(cavities, 1):
        which = "the cavity" if len(cavities) == 1 else f"cavity {number}"
        if not shape.hollow and _reaches_out(shape, cavity):
            raise InputError(
                f"{which} with the semi-axes {', '.join(f'{b:.6g}' for b in cavity.axes)} does not "
                "fit into the body; make it smaller, or move its centre"
            )
    for (i, one), (j, other) in combinations(enumerate(cavities, 1), 2):
        if not _apart(one, other):
            raise InputError(
                f"cavities {i} and {j} overlap; move their centres apart, or make them smaller"
            )


def _support(cavity: Cavity, normals: FloatArray) -> FloatArray:
    """Extent of a cavity along unit vectors (n, 3), from the centre of mass."""
    turn = np.array(cavity.rotation.tolist(), dtype=float)
    lengths = np.linalg.norm((normals @ turn) * np.array(cavity.axes), axis=1)
    heights: FloatArray = normals @ np.array(cavity.centre) + lengths
    return heights


def _reaches_out(shape: Shape, cavity: Cavity) -> bool:
    """Whether it reaches further than the shape in some direction."""

    def excess(normals: FloatArray) -> FloatArray:
        with np.errstate(all="ignore"):
            # a direction without contact point (a flat face) tells nothing
            beyond = _support(cavity, normals) - shape.heights(normals)
            out: FloatArray = np.nan_to_num(beyond, nan=-np.inf)
            return out

    return _greatest(excess) > SLACK * max(cavity.axes)


def _apart(one: Cavity, other: Cavity) -> bool:
    """Whether a plane separates two cavities."""

    def gap(normals: FloatArray) -> FloatArray:
        return -_support(one, normals) - _support(other, -normals)

    return _greatest(gap) > -SLACK * max(*one.axes, *other.axes)


def _greatest(function: Callable[[FloatArray], FloatArray]) -> float:
    """The greatest value found of a function of unit vectors."""
    normals = directions(PLANES)
    values = function(normals)
    best = normals[int(np.argmax(values))]
    width = 4 / np.sqrt(PLANES)
    for _ in range(ROUNDS):
        near = best + width * directions(200)
        near /= np.linalg.norm(near, axis=1, keepdims=True)
        best = max((best, near[int(np.argmax(function(near)))]), key=lambda n: function(n[None])[0])
        width /= 3
    return float(function(best[None])[0])
