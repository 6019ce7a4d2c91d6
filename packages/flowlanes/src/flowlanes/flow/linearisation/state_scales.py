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
#: Fraction of the size by which it acts as strongly as others, below which a vector counts as zero.
SMALL = 1e-10
#: Smallest coupling of two vectors, relative to the fastest rate, that counts.
COUPLING = 1e-4


def state_scales(
    system: System,
    starts: FloatArray,
    t_end: float,
    parameters: Parameters = None,
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: Device = "cpu",
) -> FloatArray:
    """The largest sizes of the vectors of the state over the first tenth of motions.

    Parameters
    ----------
    system : System
    starts : (n, size) array
        In flat order, on the phase space.
    t_end : float
        Length of the motions.
    parameters : mapping of Symbol or name to number or (n,) array, optional
        Parameters that replace the defaults.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Where the motions are computed.

    Returns
    -------
    (n, size) array
        The size of the vector of each variable, positive; see `state_scales_at`.
    """
    times = STRETCH * t_end * np.arange(1, LOOKS + 1) / LOOKS
    flow = batch_integrator(system, tolerance=tolerance, device=device)
    run = flow.propagate(starts, times, parameters)
    first = np.asarray(starts, dtype=np.float64)
    return state_scales_at(system, np.concatenate([first[:, None], run.states], axis=1), parameters)


def state_scales_at(
    system: System, states: FloatArray, parameters: Parameters = None
) -> FloatArray:
    """The largest sizes of the vectors of the state among given states of each motion.

    A vector u that is zero beside others v gets the size with which both act on each other equally
    strongly, |v| √(|∂u̇/∂v| / |∂v̇/∂u|) at the first state, and 1 if no other vector is coupled to
    it.

    Parameters
    ----------
    system : System
    states : (n, states, size) array
        The first of a motion must be finite; others may be not a number.
    parameters : mapping of Symbol or name to number or (n,) array, optional

    Returns
    -------
    (n, size) array
    """
    vectors = groups(system)
    # Component by component, so that neighbours change no bit.
    squares = [sum(states[..., i] ** 2 for i in part) for part in vectors]
    norms = np.stack([np.sqrt(np.fmax.reduce(square, axis=1)) for square in squares], axis=1)
    slopes = Formulas(system, system.rates).slopes(states[:, 0], parameters)
    acting = np.array(
        [[np.abs(slopes[:, p][:, :, q]).max(axis=(1, 2)) for q in vectors] for p in vectors]
    )
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
