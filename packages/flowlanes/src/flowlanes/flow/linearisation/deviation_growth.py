"""Deviations along many motions, orthonormalized after every interval within the loop.

The operations of :mod:`flowlanes.flow.linearisation.tangent_space` on arrays are written here as
terms, which become part of the machine code.  A motion is integrated to its end in one call, on
any device, and only the normalization factors of the deviations are returned.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TypeAlias

import numpy as np

from ...arguments import Parameters
from ...formulas.array_evaluation import parameter_rows, read_formulas
from ...formulas.graph import Graph, Reader, Term
from ...system.arrays import FloatArray, IntArray
from ..cost import MOST_STEPS
from ..devices.batch_arrays import BatchInput, BatchLoop
from ..devices.graphics import Device, graphics_loop
from ..devices.processor import processor_loop
from ..kernel.equations import equations_of
from ..kernel.projection_terms import dot, projection_terms
from .tangent_space import DEPENDENT, TangentSpace

#: The components of a vector.
Vector: TypeAlias = Sequence[Term]

#: Deviations of unit length orthogonal to a basis, and the normalization factors.
Normalisation: TypeAlias = Callable[
    [Graph, Sequence[Vector], Sequence[Vector]], tuple[list[list[Term]], list[Term]]
]

#: Additional recorded quantities, computed from deviations of unit length.
Record: TypeAlias = Callable[[Graph, Sequence[Vector]], Sequence[Term]]


def orthonormal_terms(
    graph: Graph, vectors: Sequence[Vector], basis: Sequence[Vector] = ()
) -> tuple[list[list[Term]], list[Term]]:
    """Orthonormal vectors by the Gram–Schmidt process, and the lengths of the remainders.

    The symbolic version of :func:`flowlanes.flow.linearisation.tangent_space.orthonormal`.
    """
    share, zero = graph.number(Fraction(DEPENDENT)), graph.number(0)
    frames: list[list[Term]] = []
    lengths = []
    for given in vectors:
        vector = list(given)
        before = _norm(graph, vector)
        for other in (*basis, *frames) * 2:
            shadow = dot(graph, vector, other)
            vector = [x - shadow * y for x, y in zip(vector, other, strict=True)]
        left = _norm(graph, vector)
        # Branches are not possible in terms, so dependent vectors are replaced by zero with a
        # selection.
        remains = left - share * before
        inverse = graph.where_positive(remains, graph.recip(left), zero)
        frames.append([x * inverse for x in vector])
        lengths.append(graph.where_positive(remains, left, zero))
    return frames, lengths


def _norm(graph: Graph, vector: Vector) -> Term:
    return graph.call("sqrt", dot(graph, vector, vector))


@dataclass(frozen=True)
class GrowthRun:
    """Growth of deviations along some motions.

    Attributes
    ----------
    lengths : (n, intervals, d) array
        Normalization factors of the deviations after each interval; NaN after the end of a motion.
    records : (n, intervals, numbers) array
        Further recorded numbers.
    outcome : (n,) array of int
        0, or the code of the reason for the end of a motion.
    end_times : (n,) array
        Last times reached.
    """

    lengths: FloatArray
    records: FloatArray
    outcome: IntArray
    end_times: FloatArray


@dataclass(frozen=True)
class DeviationGrowth:
    """Growth of deviations along the motions of a system, as machine code.

    Attributes
    ----------
    space : TangentSpace
        Space of the deviations.
    deviations : int
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    record_width : int
        Number of further values for every interval.
    loop : BatchLoop
    """

    space: TangentSpace
    deviations: int
    tolerance: float
    record_width: int
    loop: BatchLoop = field(repr=False)

    def run(
        self,
        starts: FloatArray,
        sizes: FloatArray,
        times: FloatArray,
        parameters: Parameters = None,
    ) -> GrowthRun:
        """Deviations followed along motions.

        Parameters
        ----------
        starts : (n, size) array
            In flat order, on the phase space.
        sizes : (n, size) array
            Sizes of the variables for lengths of deviations.
        times : (intervals,) array
            Ends of the intervals; the first interval begins at 0.
        parameters : mapping of Symbol or name to number or (n,) array, optional
        """
        system = self.space.system
        # Each row has the state and then the deviations; the sizes are parameters of the loop.
        frames = self.space.frames(starts, parameters, self.deviations, sizes)
        rows = np.concatenate([starts[:, None], frames * sizes[:, None]], axis=1)
        rows = rows.reshape(len(starts), -1, 1)
        values = parameter_rows(system, parameters, len(starts))
        values = np.broadcast_to(values, (len(starts), values.shape[1]))
        constants = np.concatenate([values, sizes], axis=1)[..., None]
        numbers = self.deviations + self.record_width
        task = BatchInput(
            *(rows, constants, times, len(times), self.tolerance, MOST_STEPS, numbers)
        )
        result = self.loop.run(task, None)
        lengths, records = np.split(result.states[..., 0], [self.deviations], axis=2)
        return GrowthRun(lengths, records, result.outcome, result.end_times)


def deviation_growth(
    space: TangentSpace,
    deviations: int,
    normalise: Normalisation,
    record: Record,
    *,
    tolerance: float,
    device: Device,
) -> DeviationGrowth:
    """Compile the growth of deviations to machine code.

    Parameters
    ----------
    space : TangentSpace
    deviations : int
    normalise : callable
        Function that normalizes deviations and removes the span of a basis, such as
        `orthonormal_terms`.
    record : callable
        Function for further recorded numbers.
    tolerance : float
    device : "cpu" or "gpu"
        Device for the computation.
    """
    system = space.system
    reader, _ = read_formulas(system)
    graph = reader.graph
    equations = equations_of(system, deviations, None, False)
    size, parameters = len(system.symbols), equations.parameters
    sizes = [graph.parameter(parameters + i) for i in range(size)]
    measured = [
        [graph.state(size * k + i) * graph.recip(sizes[i]) for i in range(size)]
        for k in range(1, deviations + 1)
    ]
    frames, lengths = normalise(graph, measured, _excluded_basis(space, reader, sizes))
    relations = [reader(relation) for relation in system.relations]
    correction = projection_terms(graph, (), relations, equations.groups, relations).correction
    # Rounding moves the state away from the phase space, so it is projected back.
    states = [graph.state(i) + change for i, change in enumerate(correction)]
    carried = [x * y for frame in frames for x, y in zip(frame, sizes, strict=True)]
    recorded = record(graph, frames)
    equations = replace(
        equations,
        parameters=parameters + size,
        renewal=(*states, *carried, *lengths, *recorded),
    )
    loop: BatchLoop
    if device == "gpu":
        loop = graphics_loop(equations, "double", tolerance)
    else:
        loop = processor_loop(equations, "double", tolerance)
    return DeviationGrowth(space, deviations, tolerance, len(recorded), loop)


def _excluded_basis(space: TangentSpace, reader: Reader, sizes: Vector) -> list[list[Term]]:
    """Orthonormal basis, in rescaled variables, of the excluded deviations."""
    graph, places = reader.graph, range(len(sizes))
    slopes = graph.jacobian(
        [reader(condition) for condition in space.conditions], [graph.state(i) for i in places]
    )
    gradients = [[slope * size for slope, size in zip(row, sizes, strict=True)] for row in slopes]
    normals, _ = orthonormal_terms(graph, gradients)
    directions = [[reader(part) for part in parts] for parts in space.directions]
    fields = []
    for row in space.combinations:
        weights = [graph.number(Fraction(float(weight))) for weight in row]
        mixed = [dot(graph, weights, [d[i] for d in directions]) for i in places]
        fields.append([x * graph.recip(y) for x, y in zip(mixed, sizes, strict=True)])
    across, _ = orthonormal_terms(graph, fields, normals)
    return [*normals, *across]
