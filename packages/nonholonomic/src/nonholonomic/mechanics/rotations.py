"""Rotations as matrices: of quaternions, and of n-dimensional space with many digits."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias

import mpmath

from flowlanes.errors import InputError
from flowlanes.system.tuple_vectors import R, cross, dot

Matrix: TypeAlias = list[list[mpmath.mpf]]

#: Digits that are worked with, what a given matrix may miss, and what is left of a half turn.
_DIGITS, _SLACK, _TURNED = 50, 1e-10, 1e-12


def rotation_rows(quaternion: Iterable[Any], double: Any = 2) -> list[list[Any]]:
    """The matrix from body to space components, row by row, of any kind of numbers.

    Parameters
    ----------
    quaternion : four numbers, arrays or formulas
        w, x, y, z.
    double : number
        2 divided by the square of the quaternion's length; 2 of a unit quaternion.

    Examples
    --------
    >>> rotation_rows((0, 0, 0, 1))
    [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]
    """
    w, x, y, z = quaternion
    return [
        [1 - double * (y * y + z * z), double * (x * y - w * z), double * (x * z + w * y)],
        [double * (x * y + w * z), 1 - double * (x * x + z * z), double * (y * z - w * x)],
        [double * (x * z - w * y), double * (y * z + w * x), 1 - double * (x * x + y * y)],
    ]


def quaternion_product(p: Sequence[R], q: Sequence[R]) -> list[R]:
    """The product pq of two quaternions w, x, y, z."""
    side = cross(p[1:], q[1:])
    scalar = p[0] * q[0] - dot(p[1:], q[1:])
    return [scalar] + [p[0] * q[k + 1] + q[0] * p[k + 1] + side[k] for k in range(3)]


def finite_numbers(name: str, values: object, count: int, which: str = "") -> list[mpmath.mpf]:
    """Numbers as they are written.

    Parameters
    ----------
    name : str
        What they are, for a message.
    values : object
        Numbers in a sequence or an array.
    count : int
        How many there must be.
    which : str
        Added to the message.

    Raises
    ------
    InputError
        If they are not so many finite numbers.
    """
    listed = _parts_of(values)
    if len(listed) != count or any(_is_listed(x) or not mpmath.isfinite(x) for x in listed):
        raise InputError(f"{name}: must be {count} finite numbers{which}")
    return [mpmath.mpf(repr(float(x))) for x in listed]


def rotation_near(approximation: object, n: int) -> Matrix:
    """The matrix of SO(n) next to one that misses it by rounding.

    Parameters
    ----------
    approximation : object
        n rows of n numbers, or n² numbers row by row.
    n : int

    Raises
    ------
    InputError
        If it is no matrix of that size, its rows are not orthonormal, or it is a reflection.

    Examples
    --------
    >>> [[float(x) for x in row] for row in rotation_near([[0, -1], [1, 0]], 2)]
    [[0.0, -1.0], [1.0, 0.0]]
    """
    rows = _parts_of(approximation)
    if len(rows) == n * n and not any(map(_is_listed, rows)):
        rows = [rows[i * n : (i + 1) * n] for i in range(n)]
    if len(rows) != n or any(len(_parts_of(row)) != n for row in rows):
        raise InputError(f"attitude: must be {n} rows of {n} finite numbers")
    with mpmath.workdps(_DIGITS):
        matrix = mpmath.matrix([finite_numbers("attitude", row, n) for row in rows])
        defect = mpmath.mnorm(matrix * matrix.T - mpmath.eye(n), "f")
        if defect > _SLACK:
            near = ""
            if defect < 1:
                nearest = _orthogonal(matrix).tolist()
                written = ", ".join(f"[{', '.join(repr(float(x)) for x in r)}]" for r in nearest)
                near = f"; the nearest rotation is [{written}]"
            raise InputError(f"attitude: its rows must be orthonormal{near}")
        if mpmath.det(matrix) < 0:
            raise InputError("attitude: its determinant must be 1, and it is −1 (a reflection)")
        rotation: Matrix = _orthogonal(matrix).tolist()
        return rotation


def upright(vertical: Sequence[float | mpmath.mpf]) -> list[mpmath.mpf]:
    """The quaternion of the shortest rotation that takes a unit vector (body) to the vertical."""
    with mpmath.workdps(_DIGITS):
        # float also converts NumPy scalars, whose repr is not a plain number.
        decimals = (repr(float(v)) if isinstance(v, float) else v for v in vertical)
        x, y, z = map(mpmath.mpf, decimals)
        turn = [1 + z, y, -x, mpmath.mpf(0)]
        if not 1 + z > _TURNED:
            turn = [mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(0), mpmath.mpf(0)]
        length = mpmath.norm(turn)
        return [part / length for part in turn]


def upright_matrix(vertical: Sequence[float | mpmath.mpf]) -> Matrix:
    """The shortest turn of a unit vector (body) to the last axis of space, n-dimensional."""
    with mpmath.workdps(_DIGITS):
        # float also turns numbers of NumPy into ones that repr writes as digits
        decimals = (repr(float(v)) if isinstance(v, float) else v for v in vertical)
        gamma = mpmath.matrix([mpmath.mpf(x) for x in decimals])
        n, last = len(gamma), gamma[len(gamma) - 1]
        if not 1 + last > _TURNED:
            # opposite: a half turn in the plane of the first and the last axis
            return list(mpmath.diag([-1, *([1] * (n - 2)), -1]).tolist())
        up = mpmath.matrix([0] * (n - 1) + [1])
        total = gamma + up
        turn = mpmath.eye(n) - total * total.T / (1 + last) + 2 * up * gamma.T
        return list(turn.tolist())


def _is_listed(value: object) -> bool:
    return hasattr(value, "__len__") and not isinstance(value, str)


def _parts_of(value: object) -> list[Any]:
    """The parts of a sequence or an array; none of anything else."""
    return list(value) if _is_listed(value) and isinstance(value, Iterable) else []


def _orthogonal(matrix: mpmath.matrix) -> mpmath.matrix:
    """The orthogonal factor of the polar decomposition, by Newton's method."""
    for _ in range(60):
        following = (matrix + (matrix**-1).T) / 2
        change = mpmath.mnorm(following - matrix, "f")
        matrix = following
        if change < mpmath.mpf(10) ** (5 - _DIGITS):
            break
    return matrix
