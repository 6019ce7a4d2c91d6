"""Sizes of the vectors of a state along a motion, covariant under a change of units.

A momentum of 1e-10 kg m²/s beside a unit vector is not small, and a change of that vector by one
is not large beside a change of the momentum by 1e-10.  Deviations are therefore measured after
dividing each vector of the state by a fixed size of its own.
"""

from __future__ import annotations

import numpy as np

from ...arguments import Parameters
from ...formulas.array_formulas import Formulas
from ...system.arrays import FloatArray
from ...system.system import System
from ...system.tolerance import ENSEMBLE_TOLERANCE
from ..batch import batch_integrator
from ..devices.graphics import Device
from ..kernel.equations import groups

#: Fraction of a motion over which the sizes of its vectors are sampled, and the number of samples.
STRETCH, LOOKS = 0.1, 32
#: Fraction of the size of equal coupling below which a vector is taken as zero.
SMALL = 1e-10
#: Smallest coupling of two vectors, relative to the fastest rate.
COUPLING = 1e-4


def state_scales(
    system: System,
    starts: FloatArray,
    t_end: float,
    parameters: Parameters = None,
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: Device = "cpu",
) -> FloatArray:
    """Largest sizes of the vectors of the state over the first tenth of motions.

    Parameters
    ----------
    system : System
    starts : (n, size) array
        In flat order, on the phase space.
    t_end : float
        Duration of the motions.
    parameters : mapping of Symbol or name to number or (n,) array, optional
        Parameters that replace the defaults.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Device for the computation.

    Returns
    -------
    (n, size) array
        Positive size of the vector of each variable; see `state_scales_at`.
    """
    times = STRETCH * t_end * np.arange(1, LOOKS + 1) / LOOKS
    flow = batch_integrator(system, tolerance=tolerance, device=device)
    run = flow.propagate(starts, times, parameters)
    first = np.asarray(starts, dtype=np.float64)
    return state_scales_at(system, np.concatenate([first[:, None], run.states], axis=1), parameters)


def state_scales_at(
    system: System, states: FloatArray, parameters: Parameters = None
) -> FloatArray:
    """Largest sizes of the vectors of the state among given states of each motion.

    If a vector u is zero compared with other vectors v, its size is defined by equal coupling: |v|
    √(|∂u̇/∂v| / |∂v̇/∂u|) at the first state, or 1 without coupling to another vector.

    Parameters
    ----------
    system : System
    states : (n, states, size) array
        The first state of a motion must be finite; others may be NaN.
    parameters : mapping of Symbol or name to number or (n,) array, optional

    Returns
    -------
    (n, size) array
    """
    vectors = groups(system)
    # Component by component, so that no bit depends on other motions.
    squares = [sum(states[..., i] ** 2 for i in part) for part in vectors]
    # fmax ignores NaN after the end of a motion
    norms = np.stack([np.sqrt(np.fmax.reduce(square, axis=1)) for square in squares], axis=1)
    slopes = Formulas(system, system.rates).slopes(states[:, 0], parameters)
    acting = np.array(
        [[np.abs(slopes[:, p][:, :, q]).max(axis=(1, 2)) for q in vectors] for p in vectors]
    )
    # The coupling of two vectors is the geometric mean of the actions in both directions, which
    # does not depend on their units.
    back = np.swapaxes(acting, 0, 1)
    rates = np.sqrt(acting) * np.sqrt(back)
    coupled = rates > COUPLING * rates.max(axis=(0, 1))
    coupled &= ~np.eye(len(vectors), dtype=bool)[:, :, None]
    ratios = np.sqrt(np.divide(acting, back, out=np.zeros_like(acting), where=coupled))
    balanced = ratios * norms.T
    neighbours = balanced.max(axis=1).T
    scales = np.where(norms > SMALL * neighbours, norms, neighbours)
    scales = np.where(scales > 0, scales, 1.0)
    return np.concatenate(
        [np.repeat(scales[:, i : i + 1], len(p), axis=1) for i, p in enumerate(vectors)], axis=1
    )
