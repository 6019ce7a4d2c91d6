"""Numbers of datasets as JSON."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import xarray as xr


def numbers(values: npt.ArrayLike) -> list[float | None]:
    """Numbers row by row; None for values that are not finite.

    Examples
    --------
    >>> numbers([[1.0, float("nan")], [2.5, 3.0]])
    [1.0, None, 2.5, 3.0]
    """
    flat = np.asarray(values, dtype=np.float64).ravel()
    if np.isfinite(flat).all():
        return list(map(float, flat))
    return [float(x) if good else None for x, good in zip(flat, np.isfinite(flat), strict=True)]


def columns(dataset: xr.Dataset) -> dict[str, list[float | None]]:
    """The quantities sampled along a motion by name, row by row."""
    return {
        str(name): numbers(item.transpose("time", ...).values)
        for name, item in dataset.data_vars.items()
        if "time" in item.dims and item.dtype.kind in "fiu"
    }
