"""The dimension of an attractor from its Lyapunov exponents."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arguments import arguments_checked
from ..system.arrays import FloatArray


@arguments_checked
def kaplan_yorke(exponents: Sequence[float] | FloatArray) -> float:
    """The dimension of an attractor with given exponents (Kaplan and Yorke 1979).

    With the exponents in decreasing order, j is the largest number of them whose sum is
    nonnegative; the dimension is j + (λ_1 + … + λ_j)/|λ_{j+1}|, and the number of exponents if all
    sums are nonnegative.

    Parameters
    ----------
    exponents : sequence of float
        All exponents of a motion (1/s), in any order.

    Returns
    -------
    float
        The dimension.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import flowlanes
    >>> round(flowlanes.lyapunov.kaplan_yorke([0.9, 0.0, -14.6]), 3)
    2.062
    """
    ordered = np.sort(np.asarray(exponents, dtype=np.float64))[::-1]
    sums = np.cumsum(ordered)
    # argmax gives the first index with a negative sum, that is, j.
    count = int(np.argmax(sums < 0)) if (sums < 0).any() else len(ordered)
    if count == len(ordered):
        return float(count)
    excess = sums[count - 1] if count else 0.0
    return float(count + excess / abs(ordered[count]))
