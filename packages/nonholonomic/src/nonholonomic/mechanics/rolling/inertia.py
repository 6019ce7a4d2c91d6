"""Checks of the inertia of a rigid body; free of SymPy, so that invalid files fail at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flowlanes.errors import InputError


def check_inertia(inertia: Sequence[float] | Sequence[Sequence[float]]) -> None:
    """Raise InputError unless `inertia` belongs to a rigid body.

    Accepts three principal moments or a full symmetric 3×3 matrix.
    """
    array, shown = _numbers(inertia), " ".join(str(inertia).split())
    if array.shape not in ((3,), (3, 3)) or not np.all(np.isfinite(array)):
        raise InputError(
            f"inertia {shown}: it must be three principal moments or a symmetric 3x3 matrix"
        )
    rounding = 1e-12 * np.abs(array).max()
    if array.ndim == 2 and not np.allclose(array, array.T, rtol=0, atol=rounding):
        raise InputError(f"inertia {shown}: the matrix must be symmetric")
    moments = np.sort(array if array.ndim == 1 else np.linalg.eigvalsh(array))
    shown = ", ".join(f"{x:.12g}" for x in moments)
    if moments[0] <= 0:
        raise InputError(f"inertia: principal moments {shown} must all be positive")
    if moments[2] > (moments[0] + moments[1]) * (1 + 1e-12):
        raise InputError(
            f"inertia: principal moments {shown} break the triangle inequality "
            f"({moments[2]:.12g} > {moments[0]:.12g} + {moments[1]:.12g}); each moment must be at "
            "most the sum of the other two"
        )


def _numbers(inertia: Sequence[float] | Sequence[Sequence[float]]) -> np.ndarray:
    """The entries as an array; an empty array if they do not form one."""
    try:
        return np.asarray(inertia, dtype=float)
    except (TypeError, ValueError, OverflowError):
        return np.empty(0)
