"""Attitude from two directions fixed in space, and its sign as a quaternion."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from flowlanes.system.arrays import FloatArray


@dataclass(frozen=True)
class Triad:
    """An orthonormal triad fixed in space.

    Attributes
    ----------
    axes : array (3, 3)
        Its vectors in space axes, as rows.
    """

    axes: FloatArray

    @classmethod
    def through(
        cls, first: FloatArray, second: FloatArray, quaternion: Sequence[float] | FloatArray
    ) -> Triad:
        """The triad of two vectors (body axes) for a known attitude.

        Parameters
        ----------
        first, second : array (3,)
        quaternion : 4 floats
            (w, x, y, z), body to space.
        """
        body = _triad(first[:, None], second[:, None])[0]
        turn = Rotation.from_quat(np.roll(np.asarray(quaternion, dtype=float), -1))
        return cls(turn.apply(body))

    def attitude(self, first: FloatArray, second: FloatArray) -> FloatArray:
        """Quaternions (n, 4) from two vectors in body axes, each (3, n).

        Their signs are arbitrary.
        """
        matrices = np.einsum("ks,nkb->nsb", self.axes, _triad(first, second))
        return np.roll(Rotation.from_matrix(matrices).as_quat(), 1, axis=-1)


def _triad(first: FloatArray, second: FloatArray) -> FloatArray:
    """Orthonormal triads (n, 3, 3) of pairs of vectors, as rows, body axes."""
    one = first / np.linalg.norm(first, axis=0)
    normal = np.cross(first, second, axis=0)
    three = normal / np.linalg.norm(normal, axis=0)
    return np.stack([one, np.cross(three, one, axis=0), three]).transpose(2, 0, 1)


@dataclass(frozen=True)
class Cover:
    """Quaternions on the torus with signs that make them continuous.

    Attributes
    ----------
    table : array (n_1, n_2, 4)
        On the grid of phases 2j/n.
    turns : (±1, ±1)
        By what they are multiplied when a phase grows by 2.
    """

    table: FloatArray
    turns: tuple[float, float]

    def with_signs(self, v: FloatArray, attitude: FloatArray) -> FloatArray:
        """The given quaternions (n, 4) at phases v (n, 2), modulo 4, with the correct signs."""
        sizes = np.array(self.table.shape[:2])
        places = np.floor(v * (sizes / 2) + 0.5).astype(int)
        wraps, cells = np.divmod(places, sizes)
        near = self.table[cells[:, 0], cells[:, 1]]
        sign = np.where(np.sum(near * attitude, axis=1) < 0, -1.0, 1.0)
        for axis in (0, 1):
            sign = np.where(wraps[:, axis] % 2 == 1, sign * self.turns[axis], sign)
        return sign[:, None] * attitude


def cover(attitude: Callable[[FloatArray], FloatArray], grid: Sequence[int]) -> Cover:
    """Follow quaternions continuously over the torus.

    Parameters
    ----------
    attitude : callable
        Phases (n, 2) ↦ quaternions (n, 4), sign open.
    grid : (int, int)
        Points for the period 2 in each phase.
    """
    sizes = [size + 1 for size in grid]
    lines = [2.0 * np.arange(size) / (size - 1) for size in sizes]
    v = np.array(np.meshgrid(*lines, indexing="ij")).reshape(2, -1).T
    table = attitude(v).reshape(*sizes, 4)
    table[:, 0] *= continuous_signs(table[:, 0])[:, None]
    table *= np.array([continuous_signs(row) for row in table])[:, :, None]
    turns = (_sign(table[-1, 0], table[0, 0]), _sign(table[0, -1], table[0, 0]))
    return Cover(table[:-1, :-1], turns)


def continuous_signs(line: FloatArray) -> FloatArray:
    """Signs that make neighbouring quaternions along a line agree."""
    steps = np.where(np.sum(line[1:] * line[:-1], axis=1) < 0, -1.0, 1.0)
    return np.concatenate([[1.0], np.cumprod(steps)])


def _sign(one: FloatArray, other: FloatArray) -> float:
    return -1.0 if float(one @ other) < 0 else 1.0
