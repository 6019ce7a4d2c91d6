"""Long computations in blocks: in memory or in a store, on one machine or on a cluster.

A computation has many members (runs of an ensemble, cells of a chart), and each member depends
only on its own index.  The members are computed in contiguous blocks.  A finished block is kept,
so a computation that was killed is resumed after the last one.  The numbers are the same, bit for
bit, for any order and size of the blocks and any number of machines.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
import numpy.typing as npt

from ...arguments import arguments_checked
from ...errors import InputError, RunError
from ...system.overview import WithShortRepr

if TYPE_CHECKING:
    pass

Arrays: TypeAlias = Mapping[str, np.ndarray]
#: A function called with the completed fraction.
Progress: TypeAlias = Callable[[float], Any]


class Work(Protocol):
    """Callable that computes blocks: first, last ↦ arrays by name, one row per member.

    The rows are for the members first, …, last − 1.

    It must be pure (the same numbers give the same bits in any block on any machine), picklable
    and identifiable by name: a function of a module, a :func:`functools.partial` of such a
    function, or a frozen dataclass with ``__call__``.
    """

    def __call__(self, first: int, last: int, /) -> Arrays:
        """Arrays by name; their first axis has length last − first."""


@runtime_checkable
class Divisible(Work, Protocol):
    """Work with so much data that each worker should receive only its own part."""

    def part(self, first: int, last: int, /) -> Work:
        """Work with the same values for these members, with the same numbering."""


@arguments_checked
@dataclass(frozen=True)
class Variable:
    """Array of the result.

    Parameters
    ----------
    dimensions : tuple of str
        Names of the axes after the leading one.
    shape : tuple of int
        Lengths of these axes.
    dtype : str
        Such as ``"float64"``, ``"int8"``, ``"bool"``.
    attributes : mapping
        ``long_name``, ``units``, ``source`` and others.
    coordinate : bool
        True for a coordinate of the members, not a result.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.flow.ensembles.Variable(("vector",), (3,), attributes={"units": "m"}).dtype
    'float64'
    """

    dimensions: tuple[str, ...] = ()
    shape: tuple[int, ...] = ()
    dtype: str = "float64"
    attributes: Mapping[str, object] = field(default_factory=dict)
    coordinate: bool = False


@dataclass(frozen=True)
class Coordinate:
    """A small array known in advance, such as the sampling times."""

    dimensions: tuple[str, ...]
    values: npt.ArrayLike
    attributes: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True, repr=False)
class Task(WithShortRepr):
    """Computation of many members in blocks.

    Parameters
    ----------
    work : callable
        See :class:`Work`.
    size : int
        Number of members.
    block : int
        Number of members in a block, which is computed and written as a whole.
    variables : mapping of str to Variable
        Arrays computed by `work`.
    member : str
        Name of the leading axis: ``"run"``, ``"cell"``, …
    coordinates : mapping of str to Coordinate
        Arrays that are known before the computation.
    attributes : mapping
        Attributes of the whole result: system, parameters, seed, tolerance, versions.  Together
        with `work` they identify the experiment, so they must be the same when it is resumed.
        Allowed are numbers, texts and lists of these.

    Raises
    ------
    InputError
        If size or block is not a positive integer.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> damping = flowlanes.Parameter(k, "damping", 0.1)
    >>> field = {x: v, v: -sp.sin(x) - k * v}
    >>> pendulum = flowlanes.System("pendulum", "Damped pendulum", field, (damping,))
    >>> axes = flowlanes.scans.axis("k=0:1:3"), flowlanes.scans.axis("v=0.5:1:2")
    >>> grid = flowlanes.scans.scan_grid(pendulum, *axes, {"x": 0.5, "v": 0.0})
    >>> rule = flowlanes.scans.survival_time(pendulum, 5.0)
    >>> task = flowlanes.scans.scan(flowlanes.scans.Scan(grid, rule, "survival", "Survival time"))
    >>> task.size, task.member
    (2, 'v')
    """

    work: Work
    size: int
    block: int
    variables: Mapping[str, Variable]
    member: str = "run"
    coordinates: Mapping[str, Coordinate] = field(default_factory=dict)
    attributes: Mapping[str, object] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("size", "block"):
            number = getattr(self, name)
            if not isinstance(number, int | np.integer) or number < 1:
                raise InputError(f"the {name} is {number}: a whole number, at least 1, is needed")

    def members(self, block: int) -> tuple[int, int]:
        """First member of a block, and the next member after its last one."""
        return block * self.block, min((block + 1) * self.block, self.size)

    @property
    def blocks(self) -> int:
        """Number of blocks."""
        return math.ceil(self.size / self.block)

    def require_arrays(self, arrays: Arrays, first: int, last: int) -> Arrays:
        """Arrays of a block, after a check of their names, shapes and dtypes.

        Raises
        ------
        InputError
            If a name, a shape or a kind of number differs from the declared one.
        """
        if set(arrays) != set(self.variables):
            raise InputError(
                f"the work gave {', '.join(sorted(arrays))} where "
                f"{', '.join(sorted(self.variables))} were announced"
            )
        for name, variable in self.variables.items():
            array, shape = arrays[name], (last - first, *variable.shape)
            if array.shape != shape or array.dtype != np.dtype(variable.dtype):
                raise InputError(
                    f"the work gave {name} with shape {array.shape} and type {array.dtype} where "
                    f"{shape} and {variable.dtype} were announced"
                )
        return arrays


class IncompleteError(RunError):
    """Computation in blocks that stopped early; the blocks already written are kept.

    Examples
    --------
    >>> import flowlanes
    >>> issubclass(flowlanes.flow.ensembles.IncompleteError, flowlanes.RunError)
    True
    """

    def __init__(self, reason: str) -> None:
        super().__init__(reason, float("nan"))

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.reason,)

    def __str__(self) -> str:
        return self.reason
