"""The unit quaternion of a rotation matrix in balls."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb


def quaternion(rows: Sequence[Sequence[arb]], near: Sequence[float]) -> list[arb]:
    """The unit quaternion of a rotation matrix, the one of two that is nearer to `near`.

    Parameters
    ----------
    rows : three rows of three arb
        Body to space.
    near : 4 floats
        Roughly the quaternion.
    """
    (a, b, c), (d, e, f), (g, h, i) = rows
    squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i]
    largest = max(range(4), key=lambda k: abs(near[k]))
    parts = [
        [squares[0], h - f, c - g, d - b],
        [h - f, squares[1], b + d, c + g],
        [c - g, b + d, squares[2], f + h],
        [d - b, c + g, f + h, squares[3]],
    ][largest]
    size = 2 * squares[largest].sqrt()
    sign = 1 if near[largest] > 0 else -1
    return [sign * part / size for part in parts]
