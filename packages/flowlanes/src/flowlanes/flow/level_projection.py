"""Projection of states onto levels of formulas, for many states at once.

Each state is moved independently of the others.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import Parameters, ParameterValue, arguments_checked
from ..formulas.array_formulas import Formulas
from ..system.arrays import BoolArray, FloatArray

#: Maximum number of Newton steps.
STEPS = 60
#: Relative tolerance for being on the level.
LEVEL_TOLERANCE = 1e-12
#: Relative size below which a singular value is taken as zero: redundant conditions.
REDUNDANT = 1e-9


@arguments_checked
def project_to_level(
    formulas: Formulas,
    states: FloatArray,
    targets: npt.ArrayLike = 0.0,
    parameters: Parameters = None,
    movable: Sequence[bool] | BoolArray | None = None,
) -> tuple[FloatArray, BoolArray]:
    """Project states orthogonally onto given values of formulas.

    Parameters
    ----------
    formulas : Formulas
    states : (n, size) array
        In flat order.
    targets : number, (formulas,) or (n, formulas) array
        Required values.
    parameters : mapping of Symbol or name to number or (n,) array, optional
        Values that replace the defaults.
    movable : (size,) array of bool, optional
        True for state variables that may be changed; by default all.

    Returns
    -------
    states : (n, size) array
        Best states that were found.
    met : (n,) array of bool
        True where the values are attained.

    Raises
    ------
    InputError
        If `targets` or `movable` has the wrong shape.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> from flowlanes.formulas.array_formulas import Formulas
    >>> x, v = sp.symbols("x v", real=True)
    >>> oscillator = flowlanes.System("oscillator", "Oscillator", {x: v, v: -x})
    >>> square = Formulas(oscillator, (x**2 + v**2,))
    >>> states, met = flowlanes.flow.project_to_level(square, np.array([[0.0, 2.0]]), 1.0)
    >>> states.round(12).tolist(), met.tolist()
    ([[0.0, 1.0]], [True])
    """
    moving = np.array(states, dtype=np.float64)
    free = np.flatnonzero(np.ones(moving.shape[1], bool) if movable is None else movable)
    values = np.broadcast_to(
        np.asarray(targets, dtype=np.float64), (len(moving), len(formulas.formulas))
    )
    scale = 1.0 + np.abs(values).max(axis=1, initial=0.0)
    best, missed = moving.copy(), np.full(len(moving), np.inf)
    pending = np.arange(len(moving))
    for _ in range(STEPS):
        defects = (
            formulas(moving[pending], select_parameters(parameters, pending)) - values[pending]
        )
        size = np.abs(defects).max(axis=1, initial=0.0) / scale[pending]
        better = size < missed[pending]
        best[pending[better]] = moving[pending[better]]
        missed[pending[better]] = size[better]
        # A state on its level is refined until the residual no longer decreases.
        going = np.isfinite(size) & (size > 0.0) & (better | (size > LEVEL_TOLERANCE))
        pending, defects = pending[going], defects[going]
        if not len(pending) or not len(free):
            break
        slopes = formulas.slopes(moving[pending], select_parameters(parameters, pending))[
            :, :, free
        ]
        usable = np.isfinite(slopes).all(axis=(1, 2))
        pending, defects = pending[usable], defects[usable]
        inverse = _inverse(slopes[usable])
        moving[np.ix_(pending, free)] -= (inverse @ defects[:, :, None])[:, :, 0]
    return best, missed <= LEVEL_TOLERANCE


def _inverse(slopes: FloatArray) -> FloatArray:
    """Moore–Penrose inverses of gradients (n, formulas, size)."""
    if slopes.shape[1] > 1:
        return np.asarray(np.linalg.pinv(slopes, rcond=REDUNDANT), dtype=np.float64)
    # For a single row the inverse is g/|g|², without a decomposition.
    squares = (slopes**2).sum(axis=2, keepdims=True)
    return np.swapaxes(
        np.divide(slopes, squares, out=np.zeros_like(slopes), where=squares > 0), 1, 2
    )


def select_parameters(
    parameters: Parameters, selection: npt.NDArray[np.integer] | BoolArray
) -> dict[sp.Symbol | str, ParameterValue]:
    """Parameters of some of the motions: arrays are indexed, numbers are kept."""
    arrays = {name: np.asarray(value) for name, value in (parameters or {}).items()}
    return {name: value[selection] if value.ndim else value[()] for name, value in arrays.items()}
