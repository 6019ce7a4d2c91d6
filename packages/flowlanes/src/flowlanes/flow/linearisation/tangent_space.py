"""Tangent vectors along many motions, and their growth.

The variational equations of :func:`flowlanes.flow.batch.batch_integrator` propagate deviations
over a short interval.  Then they are orthonormalized, and the sums of the logarithms of the
normalization factors give the Lyapunov exponents (Benettin et al. 1980).  Directions without
growth are projected out at the end of every interval, so that rounding cannot reintroduce them:
deviations stay tangent to relations and integrals, and are taken modulo the flow and the
symmetries.

Lengths and angles of deviations are computed after each variable has been divided by a fixed size,
so they are the same in all units.  "Orthonormal" and "gradient" below refer to these rescaled
variables; see :mod:`flowlanes.flow.linearisation.state_scales`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import sympy as sp

from ...arguments import Parameters
from ...formulas.array_formulas import Formulas
from ...system.arrays import FloatArray, IntArray
from ...system.system import System
from ..batch import BatchIntegrator
from ..level_projection import REDUNDANT, select_parameters

#: Fraction of its length below which the remainder of a vector is taken as zero (dependence).
DEPENDENT = 1e-12
#: Relative distance from its level above which a state is projected back.
LARGEST_DRIFT = 1e-11
#: Number of Newton steps of that projection.
STEPS = 3
#: Default sizes of the variables.
ONE = np.ones(1)
#: Seed of the initial frames of deviations.
SEED = 20080830


def orthonormal(
    vectors: FloatArray, basis: FloatArray | None = None
) -> tuple[FloatArray, FloatArray]:
    """Orthonormal vectors, one after the other, for many states at once.

    Gram–Schmidt process with every projection done twice, which is accurate to rounding.

    Parameters
    ----------
    vectors : (n, d, size) array
    given : (n, k, size) array, optional
        Orthonormal vectors, or zeros, to which the result is orthogonal too.

    Returns
    -------
    frames : (n, d, size) array
        Orthonormal vectors; zero for a vector that depends on earlier ones.
    lengths : (n, d) array
        Lengths of the remainders: the diagonal of R in the QR decomposition.
    """
    frame = np.array(vectors, dtype=np.float64)
    lengths = np.empty(frame.shape[:2])
    for i in range(frame.shape[1]):
        vector = frame[:, i]
        before = np.sqrt(_dot(vector, vector))
        # Twice, because one projection leaves errors of the size of rounding times the condition.
        for others in (basis, frame[:, :i]) * 2:
            if others is not None:
                _take_out(vector, others)
        left = np.sqrt(_dot(vector, vector))
        dependent = left <= DEPENDENT * before
        lengths[:, i] = np.where(dependent, 0.0, left)
        unit = vector / np.where(dependent, 1.0, left)[:, None]
        frame[:, i] = np.where(dependent[:, None], 0.0, unit)
    return frame, lengths


def _take_out(vector: FloatArray, others: FloatArray) -> None:
    """Subtract, in place, the projections of vectors (n, size) onto others (n, k, size)."""
    for other in np.moveaxis(others, 1, 0):
        vector -= _dot(vector, other)[:, None] * other


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    # The sum is taken along each row, so that its bits do not depend on other rows, as with
    # einsum.
    result: FloatArray = (a * b).sum(axis=1)
    return result


@dataclass(frozen=True)
class TangentSpace:
    """Space of the deviations along the motions of a system.

    Attributes
    ----------
    system : System
    conditions : tuple of formulas
        Independent relations and integrals, to which deviations are tangent.
    directions : tuple of tuples of formulas
        Fields, in flat order, that are invariant under the flow: the flow itself, symmetries.
    combinations : (directions, fields) array
        Constant combinations of the fields, tangent to the conditions, modulo which deviations are
        taken.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> oscillator = flowlanes.System("oscillator", "Oscillator", {x: v, v: -x})
    >>> law = flowlanes.Integral("energy", x**2 + v**2)
    >>> spectrum = flowlanes.lyapunov_spectrum(oscillator.with_laws(law), (1.0, 0.0), t_end=20.0)
    >>> len(spectrum.exponents)
    0
    """

    system: System
    conditions: tuple[sp.Expr, ...]
    directions: tuple[tuple[sp.Expr, ...], ...]
    combinations: FloatArray

    @property
    def dimension(self) -> int:
        """Number of independent deviations."""
        return len(self.system.symbols) - len(self.conditions) - len(self.combinations)

    @cached_property
    def _conditions(self) -> Formulas:
        return Formulas(self.system, self.conditions)

    @cached_property
    def _directions(self) -> Formulas:
        return Formulas(self.system, [part for field in self.directions for part in field])

    @cached_property
    def _rates(self) -> Formulas:
        return Formulas(self.system, self.system.rates)

    def normals(
        self, states: FloatArray, parameters: Parameters = None, sizes: FloatArray = ONE
    ) -> FloatArray:
        """Gradients of the conditions, (n, conditions, size)."""
        result: FloatArray = self._conditions.slopes(states, parameters) * sizes[..., None, :]
        return result

    def level(self, states: FloatArray, parameters: Parameters = None) -> FloatArray:
        """Values of the conditions, (n, conditions): zero for relations."""
        result: FloatArray = self._conditions(states, parameters)
        return result

    def on_level(
        self,
        states: FloatArray,
        level: FloatArray,
        parameters: Parameters = None,
        sizes: FloatArray = ONE,
    ) -> FloatArray:
        """States (n, size), projected back onto the level of the conditions after drift."""
        normals = self.normals(states, parameters, sizes)
        # A condition is compared with the change over a deviation of unit length.
        reach = np.abs(level) + np.sqrt((normals**2).sum(axis=2))
        missed = np.abs(self.level(states, parameters) - level)
        far = np.flatnonzero((missed > LARGEST_DRIFT * reach).any(axis=1))
        if not len(far):
            return states
        states, measures = states.copy(), np.broadcast_to(sizes, states.shape)
        for _ in range(STEPS):
            some = select_parameters(parameters, far)
            normals = self.normals(states[far], some, measures[far])
            lengths = np.sqrt((normals**2).sum(axis=2))
            excess = self.level(states[far], some) - level[far]
            usable = (np.isfinite(lengths) & np.isfinite(excess) & (lengths > 0)).all(axis=1)
            far, normals, lengths = far[usable], normals[usable], lengths[usable][:, :, None]
            if not len(far):
                break
            # Rows are normalized, so that conditions in different units have equal weight in the
            # pseudo-inverse.
            inverse = np.linalg.pinv(normals / lengths, rcond=REDUNDANT)
            steps = (inverse @ (excess[usable][:, :, None] / lengths))[:, :, 0]
            states[far] -= steps * measures[far]
        return states

    def fields(
        self, states: FloatArray, parameters: Parameters = None, sizes: FloatArray = ONE
    ) -> FloatArray:
        """Excluded directions, (n, mixed, size)."""
        fields = self._directions(states, parameters)
        fields = fields.reshape(len(fields), len(self.directions), len(self.system.symbols))
        mixed = [sum(c * fields[:, j] for j, c in enumerate(row)) for row in self.combinations]
        return (np.stack(mixed, axis=1) if mixed else fields[:, :0]) / sizes[..., None, :]

    def excluded_basis(
        self, states: FloatArray, parameters: Parameters = None, sizes: FloatArray = ONE
    ) -> tuple[FloatArray, FloatArray]:
        """Orthonormal basis of the excluded deviations.

        Parameters
        ----------
        states : (n, size) array
        parameters : mapping, optional
        sizes : (size,) or (n, size) array, optional
            Sizes of the variables for lengths of deviations.

        Returns
        -------
        basis : (n, conditions + mixed, size) array
        lengths : (n, conditions + mixed) array
            Logarithms of the lengths of the remainders of these vectors after projection onto the
            earlier ones, with the opposite sign for a gradient: the length of a deviation that
            changes its condition by one.
        """
        # A gradient of length g changes the condition by one over a deviation of length 1/g.
        normals, across = orthonormal(self.normals(states, parameters, sizes))
        fields, along = orthonormal(self.fields(states, parameters, sizes), normals)
        with np.errstate(divide="ignore"):
            lengths = np.concatenate([-np.log(across), np.log(along)], axis=1)
        return np.concatenate([normals, fields], axis=1), lengths

    def frames(
        self,
        states: FloatArray,
        parameters: Parameters = None,
        count: int | None = None,
        sizes: FloatArray = ONE,
    ) -> FloatArray:
        """Orthonormal initial deviations in rescaled variables, always the same at the same state.

        Parameters
        ----------
        states : (n, size) array
        parameters : mapping, optional
        count : int, optional
            Number of deviations; by default `dimension`.
        sizes : (size,) or (n, size) array, optional
            Sizes of the variables for lengths of deviations.

        Returns
        -------
        (n, count, size) array
        """
        shape = (self.dimension if count is None else count, len(self.system.symbols))
        # Random directions are almost surely independent of the excluded ones.
        chosen = np.random.default_rng(SEED).standard_normal(shape)
        vectors = np.broadcast_to(chosen, (len(states), *shape))
        return orthonormal(vectors, self.excluded_basis(states, parameters, sizes)[0])[0]

    def divergence(
        self,
        states: FloatArray,
        parameters: Parameters = None,
        relations: Sequence[sp.Expr] = (),
        sizes: FloatArray = ONE,
    ) -> FloatArray:
        """Divergence of the equations on the surface where the relations vanish, (n,).

        It is the logarithmic growth rate of a volume of deviations tangent to `relations`.
        """
        # The trace over the tangent space is the full trace minus that over the normals.
        jacobian = self._rates.slopes(states, parameters)
        jacobian *= sizes[..., None, :] / sizes[..., :, None]
        gradients = Formulas(self.system, relations).slopes(states, parameters)
        gradients *= sizes[..., None, :]
        normals, _ = orthonormal(gradients)
        across = np.einsum("nki,nij,nkj->n", normals, jacobian, normals)
        result: FloatArray = np.einsum("nii->n", jacobian) - across
        return result


@dataclass(frozen=True)
class Stretch:
    """Deviations at the end of an interval.

    Attributes
    ----------
    states : (n, nodes, size) array
        States at the inner times of the interval.
    ends : (n, size) array
        States at its end; NaN after a motion has failed.
    frames : (n, d, size) array
        Deviations in rescaled variables, again orthonormal.
    lengths : (n, d) array
        Logarithms of the normalization factors.
    sizes : (n, conditions + mixed) array
        Logarithms of the sizes of the excluded vectors at the end; see `TangentSpace.excluded`.
    outcome : (n,) array of int
        0, or the code of the reason for the end of a motion; see
        ``BatchIntegrator.status_message``.
    end_times : (n,) array
        Last times reached, from the start of the interval.
    """

    states: FloatArray
    ends: FloatArray
    frames: FloatArray
    lengths: FloatArray
    sizes: FloatArray
    outcome: IntArray
    end_times: FloatArray


def propagate(
    lanes: BatchIntegrator,
    space: TangentSpace,
    starts: FloatArray,
    interval: float,
    parameters: Parameters = None,
    *,
    sizes: FloatArray = ONE,
    frames: FloatArray | None = None,
    nodes: FloatArray | None = None,
    threads: int | None = None,
) -> Iterator[Stretch]:
    """Deviations along motions, interval by interval.

    They are orthonormalized and yielded after each interval, without end.

    Parameters
    ----------
    lanes : BatchIntegrator
        Integrator of ``space.system`` with as many deviations as there are frames.
    space : TangentSpace
    starts : (n, size) array
    interval : float
        Length of an interval.
    parameters : mapping of Symbol or name to number or (n,) array, optional
    sizes : (size,) or (n, size) array, optional
        Sizes of the variables for lengths of deviations.
    frames : (n, d, size) array, optional
        Orthonormal initial deviations in rescaled variables; by default those of ``space.frames``.
    nodes : (nodes,) array, optional
        Inner times of the interval, between 0 and `interval`, for states in the result.
    threads : int, optional

    Yields
    ------
    Stretch
    """
    states = np.asarray(starts, dtype=np.float64)
    inner = np.empty(0) if nodes is None else np.asarray(nodes, dtype=np.float64)
    times = np.append(inner, interval)
    measures = sizes[..., None, :]
    if frames is None:
        frames = space.frames(states, parameters, lanes.deviations, sizes)
    level = space.level(states, parameters)
    while True:
        # The integrator works with the original variables, the frames with rescaled ones.
        carried = frames * measures if frames.shape[1] else None
        run = lanes.propagate(states, times, parameters, deviations=carried, threads=threads)
        states = space.on_level(run.states[:, -1], level, parameters, sizes)
        basis, excluded = space.excluded_basis(states, parameters, sizes)
        if run.deviations is not None:
            frames = run.deviations[:, -1] / measures
        frames, lengths = orthonormal(frames, basis)
        with np.errstate(divide="ignore"):
            logs = np.log(lengths)
        yield Stretch(
            run.states[:, :-1], states, frames, logs, excluded, run.outcome, run.end_times
        )
