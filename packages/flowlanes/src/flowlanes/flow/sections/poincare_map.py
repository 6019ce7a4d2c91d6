"""Poincaré map of a flow: the first return to a surface.

Let a motion ẋ = f(x) start at a point x of the surface g = 0 and return to the surface, in the
same direction, after the time T(x).  The first return P(x) = φ_T(x) is a map of the surface into
itself, which can be iterated, inverted and differentiated.  Its derivative follows from that of
the flow, Φ = ∂φ_t/∂x at t = T, by a projection along the flow onto the surface,

    ∂P = (1 − f ∇gᵀ/(∇g·f)) Φ,    ∂T = −∇gᵀ Φ/(∇g·f),    f and ∇g at P(x).

The integrals of the flow are integrals of the map.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
import sympy as sp

from ...arguments import Positive, Quantity, arguments_checked
from ...errors import InputError
from ...formulas.array_evaluation import formula
from ...formulas.array_formulas import Formulas
from ...system.arrays import FloatArray
from ...system.named_formulas import scalars
from ...system.parameters import parameters_by_symbol
from ...system.system import System
from ...system.tolerance import ENSEMBLE_TOLERANCE
from ..batch import BatchIntegrator, batch_integrator
from ..devices.graphics import Device
from ..kernel.equations import Section

if TYPE_CHECKING:
    from ..batch_results import BatchCrossings


@dataclass(frozen=True)
class Derivative:
    """A map and its derivative at n points.

    Attributes
    ----------
    images : array (n, size)
        Returns of the points; NaN for points without a return.
    times : array (n,)
        Times of return.
    matrices : array (n, size, size)
        ∂(image)/∂(point), in flat order.  Its columns are tangent to the section at the image, and
        it is zero on the direction of the flow at the point; relations and integrals are
        conserved.
    time_slopes : array (n, size)
        ∂(time)/∂(point).
    """

    images: FloatArray
    times: FloatArray
    matrices: FloatArray
    time_slopes: FloatArray


@arguments_checked
@dataclass(frozen=True)
class PoincareMap:
    """First return to a section.

    Parameters
    ----------
    system : System
        Points are its states in flat order; a lifted system carries its reconstruction along.
    section : Section
        Section to which the motions return.
    parameters : mapping of Symbol or name to number or array (n,), optional
        Values that replace the defaults; an array has a value for every point.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    backward : bool
        True for the inverse map, backward in time.
    t_end : float
        Time in s after which a point is regarded as a point without a return.
    device : "cpu" or "gpu"
        Device for the computation; see :func:`flowlanes.flow.batch.batch_integrator`.

    Raises
    ------
    InputError
        If the section or a parameter does not belong to the system.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> returns = flowlanes.PoincareMap(top, flowlanes.poincare_section(top, "b"))
    >>> point = returns(flowlanes.sample_level(top, 1, {"energy": 2.0}, seed=1)[0])
    >>> bool(abs(returns.inverse(returns(point)) - point).max() < 1e-10), returns.dimension(point)
    (True, 1)
    """

    system: System
    section: Section
    parameters: Mapping[Any, Any] = field(default_factory=dict)
    tolerance: Positive = ENSEMBLE_TOLERANCE
    backward: bool = False
    t_end: float = np.inf
    device: Device = "cpu"

    def __post_init__(self) -> None:
        parameters_by_symbol(self.system, self.parameters)
        if not self.t_end > 0:
            raise InputError(f"until = {self.t_end}: it must be a positive number")

    @property
    def inverse(self) -> PoincareMap:
        """Inverse map."""
        return replace(self, backward=not self.backward)

    @property
    def size(self) -> int:
        """Number of coordinates of a point."""
        return len(self.system.symbols)

    @arguments_checked
    def __call__(self, points: npt.ArrayLike) -> FloatArray:
        """First return of points.

        Parameters
        ----------
        points : array (n, size) or (size,)
            Points on the section; for another point, the first crossing of its motion.

        Returns
        -------
        array of the same shape
            NaN for a point without a return; `crossings` gives the reason.
        """
        rows = np.asarray(points, dtype=float)
        images = self.crossings(np.atleast_2d(rows), 1).states[:, 0]
        return images.reshape(rows.shape)

    @arguments_checked
    def crossings(
        self, points: npt.ArrayLike, count: int, threads: int | None = None
    ) -> BatchCrossings:
        """Next `count` returns of n points, with their times, and the reasons for missing returns.

        Parameters
        ----------
        points : array (n, size)
        count : int
        threads : int, optional
            Number of threads, by default one per core; the result does not depend on it.
        """
        return self._integrator(0).crossings(
            points, count, self.parameters, t_end=self.t_end, threads=threads
        )

    @arguments_checked
    def iterate(self, points: npt.ArrayLike, count: int) -> FloatArray:
        """Apply the map `count` times; array of the shape of `points`.

        The motion is integrated in one piece, without stops at the section.
        """
        rows = np.asarray(points, dtype=float)
        if count == 0:
            return rows.copy()
        if count < 0:
            return self.inverse.iterate(rows, -count)
        images = self.crossings(np.atleast_2d(rows), count).states[:, -1]
        return images.reshape(rows.shape)

    @arguments_checked
    def derivative(self, points: npt.ArrayLike, count: int = 1) -> Derivative:
        """Apply the map `count` times, with its derivative.

        Parameters
        ----------
        points : array (n, size)
        count : int
        """
        starts = np.asarray(points, dtype=float)
        if starts.ndim != 2:
            raise InputError(
                f"PoincareMap.derivative: points must be an array (n, {self.size}), "
                f"not {starts.shape}"
            )
        if count < 1:
            raise InputError(f"a derivative of {count} returns: there must be one at least")
        frame = np.broadcast_to(np.eye(self.size), (len(starts), self.size, self.size))
        crossed = self._integrator(self.size).crossings(
            starts, count, self.parameters, t_end=self.t_end, deviations=frame.copy()
        )
        images, times = crossed.states[:, -1], crossed.times[:, -1]
        # Deviations are rows there, but columns here.
        flow = np.swapaxes(np.asarray(crossed.deviations)[:, -1], 1, 2)
        rates = self._rates(images, self.parameters)
        normals = self._value.slopes(images, self.parameters)[:, 0]
        across = np.einsum("ni,ni->n", normals, rates)[:, None]
        time_slopes = -np.einsum("ni,nij->nj", normals, flow) / across
        matrices = flow + rates[:, :, None] * time_slopes[:, None, :]
        return Derivative(images, times, matrices, time_slopes)

    @arguments_checked
    def status_message(self, code: int) -> str:
        """Reason for which a motion of `crossings` ended; empty for code 0."""
        return self._integrator(0).status_message(code)

    @arguments_checked
    def residual(self, points: npt.ArrayLike) -> FloatArray:
        """Section function at points (..., size); zero on the section."""
        result: FloatArray = self._value(points, self.parameters)[..., 0]
        return result

    @arguments_checked
    def dimension(self, point: npt.ArrayLike, *, integrals: bool = True) -> int:
        """Dimension of the section near a point.

        It is the rank of the derivatives of relations, of the section function and, unless they
        are excluded, of the known unconditional integrals, subtracted from the number of
        variables.

        Parameters
        ----------
        point : array (size,)
        integrals : bool
            True for the section within one level of the integrals.
        """
        fixed = [*self.system.relations, self.section.value]
        if integrals:
            fixed += [law.value for law in self.system.integrals if not law.level]
        values = _mapping_at(self.parameters, 0)
        formulas = Formulas(self.system, fixed)
        slopes = formulas.slopes(point, values)
        if not np.all(np.isfinite(slopes)):
            raise InputError("point: the derivatives of the integrals are not finite there")
        sizes = np.linalg.norm(slopes, axis=-1, keepdims=True)
        unit = slopes / np.where(sizes > 0.0, sizes, 1.0)
        return self.size - int(np.linalg.matrix_rank(unit, tol=1e-9))

    @arguments_checked
    def within(self, quantity: Quantity, width: float) -> PoincareMap:
        """Section of the section: the returns to a slab ``|quantity| < width``.

        The points of a map are discrete, so they do not cross a second surface but only come close
        to it.  The returns to a thin slab around it ("double section", after F. C. Moon and W. T.
        Holmes, 1985) form a map again, which is smooth as long as the number of intermediate
        returns does not change.

        Parameters
        ----------
        quantity : SymPy expression or str
            See :func:`flowlanes.formulas.array_evaluation.formula`.
        width : float
            Half the thickness of the slab, in the unit of the quantity.
        """
        near = formula(self.system, quantity)
        return replace(self, section=slab(self.section, near, width))

    # --- inner parts -----------------------------------------------------------------------

    def _integrator(self, deviations: int) -> BatchIntegrator:
        return batch_integrator(
            self.system,
            tolerance=self.tolerance,
            deviations=deviations,
            section=self.section,
            backward=self.backward,
            device=self.device,
        )

    @cached_property
    def _value(self) -> Formulas:
        return Formulas(self.system, (self.section.value,))

    @cached_property
    def _rates(self) -> Formulas:
        return Formulas(self.system, self.system.rates)


def slab(section: Section, quantity: sp.Expr, width: float) -> Section:
    """Section with the condition ``|quantity| < width``; see `PoincareMap.within`.

    Raises
    ------
    InputError
        If the width is not positive.
    """
    if not width > 0:
        raise InputError(f"a slab of half width {width}: it must be positive")
    inside = sp.Float(width) - sp.Abs(scalars(quantity)[0])
    if section.where is None:
        return replace(section, where=inside)
    return replace(section, where=_least(section.where, inside))


def _least(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    """Smaller of two numbers, which is positive where both are positive."""
    return (a + b - sp.Abs(a - b)) / 2


def _mapping_at(parameters: Mapping[Any, Any], index: int) -> dict[Any, Any]:
    """Parameters of one point."""
    return {
        name: value if np.ndim(value) == 0 else value[index] for name, value in parameters.items()
    }
