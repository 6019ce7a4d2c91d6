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

#: Number of tangent planes examined, and of refinements around the worst of them.
PLANES, ROUNDS = 2000, 12
#: Relative amount by which a cavity may protrude from a body, for rounding errors.
SLACK = 1e-9


def check_cavities(shape: Shape, cavities: Sequence[Cavity]) -> None:
    """Refuse cavities that protrude from a shape, or overlap.

    A convex body contains an ellipsoid if and only if its support function is nowhere smaller; a
    cavity is refused if it reaches further in one of the sampled directions. A hollow ball has its
    matter outside its surface, so nothing is refused there.

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
        if not _are_disjoint(one, other):
            raise InputError(
                f"cavities {i} and {j} overlap; move their centres apart, or make them smaller"
            )


def _support(cavity: Cavity, normals: FloatArray) -> FloatArray:
    """Support function of a cavity at unit vectors (n, 3), from the centre of mass."""
    turn = np.array(cavity.rotation.tolist(), dtype=float)
    # an ellipsoid x = T diag(b) u, |u| = 1, has the support function |diag(b) Tᵀ ν|
    lengths = np.linalg.norm((normals @ turn) * np.array(cavity.axes), axis=1)
    heights: FloatArray = normals @ np.array(cavity.centre) + lengths
    return heights


def _reaches_out(shape: Shape, cavity: Cavity) -> bool:
    """Whether a cavity extends beyond the shape in some direction."""

    def excess(normals: FloatArray) -> FloatArray:
        with np.errstate(all="ignore"):
            # a direction without a contact point (a flat face) is skipped
            beyond = _support(cavity, normals) - shape.heights(normals)
            out: FloatArray = np.nan_to_num(beyond, nan=-np.inf)
            return out

    return _greatest(excess) > SLACK * max(cavity.axes)


def _are_disjoint(one: Cavity, other: Cavity) -> bool:
    """Whether a plane separates two cavities."""

    def gap(normals: FloatArray) -> FloatArray:
        return -_support(one, normals) - _support(other, -normals)

    return _greatest(gap) > -SLACK * max(*one.axes, *other.axes)


def _greatest(function: Callable[[FloatArray], FloatArray]) -> float:
    """The greatest value found of a function on the unit sphere."""
    normals = directions(PLANES)
    values = function(normals)
    best = normals[int(np.argmax(values))]
    width = 4 / np.sqrt(PLANES)
    # the maximum is refined among 200 directions around the best one, in a neighbourhood that
    # shrinks by 3
    for _ in range(ROUNDS):
        near = best + width * directions(200)
        near /= np.linalg.norm(near, axis=1, keepdims=True)
        best = max((best, near[int(np.argmax(function(near)))]), key=lambda n: function(n[None])[0])
        width /= 3
    return float(function(best[None])[0])
