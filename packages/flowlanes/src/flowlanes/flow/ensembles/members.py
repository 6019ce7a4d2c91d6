"""Members of an ensemble: lists and products of starts and parameters, and random starts.

>>> everyone = random_starts(100, {"energy": 1.0}, seed=7) * grid(a=[0.1, 0.2])
>>> everyone.size
200
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ...arguments import arguments_checked
from ...errors import InputError
from ...formulas.array_evaluation import as_float_array
from ...system.arrays import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class ListedMembers:
    """Values of some names, one row for each member.

    Parameters
    ----------
    values : mapping of str to array (n, …)
    """

    values: Mapping[str, FloatArray]

    @property
    def size(self) -> int:
        """Number of members."""
        return len(next(iter(self.values.values())))

    def __str__(self) -> str:
        return f"{self.size} of {', '.join(self.values)}"


@dataclass(frozen=True)
class SampledMembers:
    """Random starts on a level of the integrals.

    Parameters
    ----------
    size : int
        Number of starts.
    level : mapping of str to float
        Given values of the integrals.
    seed : int
    """

    size: int
    level: Mapping[str, float]
    seed: int

    def __str__(self) -> str:
        level = ", ".join(f"{name} = {value!r}" for name, value in self.level.items())
        return f"{self.size} drawn on {level} (seed {self.seed})"


@dataclass(frozen=True, eq=False)
class Members:
    """All combinations of the members of its factors; the last factor varies fastest.

    Two Members can be multiplied with ``*``.

    Parameters
    ----------
    factors : tuple of ListedMembers or SampledMembers

    Raises
    ------
    InputError
        If a name has two values, or starts are drawn twice.
    """

    factors: tuple[ListedMembers | SampledMembers, ...]

    def __post_init__(self) -> None:
        names = self.names
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise InputError(f"members of an ensemble: {', '.join(twice)} is given twice")
        if sum(isinstance(factor, SampledMembers) for factor in self.factors) > 1:
            raise InputError("members of an ensemble: starts are drawn twice")

    def __mul__(self, other: Members) -> Members:
        return Members(self.factors + other.factors)

    def __str__(self) -> str:
        return " × ".join(map(str, self.factors))

    @property
    def size(self) -> int:
        """Number of members."""
        return math.prod(factor.size for factor in self.factors)

    @property
    def names(self) -> list[str]:
        """Names of all quantities with given values."""
        return [
            n for factor in self.factors if isinstance(factor, ListedMembers) for n in factor.values
        ]

    @property
    def draw(self) -> SampledMembers | None:
        """Random starts, or None."""
        return next((factor for factor in self.factors if isinstance(factor, SampledMembers)), None)

    def rows(self, first: int, last: int) -> tuple[dict[str, FloatArray], IntArray | None]:
        """Values of the members first, …, last − 1.

        Returns
        -------
        values : dict of str to array (last − first, …)
        points : array (last − first,) of int, or None
            Numbers of the random starts, if there are any.
        """
        sizes = tuple(factor.size for factor in self.factors)
        places = np.unravel_index(np.arange(first, last), sizes)
        values: dict[str, FloatArray] = {}
        points = None
        for factor, place in zip(self.factors, places, strict=True):
            if isinstance(factor, SampledMembers):
                points = place
            else:
                values |= {name: array[place] for name, array in factor.values.items()}
        return values, points


@arguments_checked
def from_lists(**values: npt.ArrayLike) -> Members:
    """One member for every row: the first value of each name, then the second, and so on.

    Parameters
    ----------
    **values : array (n,) for a scalar, (n, components) for a vector
        State variables (a vector ``M``, or components ``M_1``), parameters, variables from which
        the state follows, or ``state`` for the whole state in flat order.

    Returns
    -------
    Members

    Raises
    ------
    InputError
        If there are no values, lengths differ, or a value is not a finite number.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.flow.ensembles.from_lists(I_1=[1.0, 1.2], M=[(1, 0, 0), (0, 1, 0)]).size
    2
    """
    arrays = {name: _finite(name, value) for name, value in values.items()}
    lengths = {name: len(array) for name, array in arrays.items()}
    if not arrays or 0 in lengths.values():
        raise InputError("members of an ensemble: at least one is needed")
    if len(set(lengths.values())) > 1:
        text = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise InputError(f"members of an ensemble: lists have different lengths ({text})")
    return Members((ListedMembers(arrays),))


@arguments_checked
def single(**values: npt.ArrayLike) -> Members:
    """A single member: numbers, and vectors by their components.

    Parameters
    ----------
    **values : number or components
        As in :func:`from_lists`.

    Returns
    -------
    Members

    Raises
    ------
    InputError
        If there are no values, or a value is not a finite number.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.flow.ensembles.single(x=0.1, M=(1, 0, 0)).size
    1
    """
    return from_lists(**{name: _numbers(name, value)[np.newaxis] for name, value in values.items()})


@arguments_checked
def grid(**values: npt.ArrayLike) -> Members:
    """Every combination of the values of each name; the last name varies fastest.

    Parameters
    ----------
    **values : array (n,) for a scalar, (n, components) for a vector
        As in :func:`from_lists`.

    Returns
    -------
    Members

    Raises
    ------
    InputError
        If there are no values, or a value is not a finite number.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.flow.ensembles.grid(I_1=[1.0, 1.2], I_2=[1.5, 1.6, 1.7]).size
    6
    """
    if not values:
        raise InputError("members of an ensemble: at least one is needed")
    return Members(
        tuple(factor for name, v in values.items() for factor in from_lists(**{name: v}).factors)
    )


@arguments_checked
def random_starts(count: int, level: Mapping[str, float], seed: int = 0) -> Members:
    """Random starts on a level of the integrals; see :func:`flowlanes.sample_level`.

    Start k depends only on seed and k; if parameters vary, each start lies on the level for its
    own parameters.

    Parameters
    ----------
    count : int
    level : mapping of str to float
        Values of integrals by name.
    seed : int

    Returns
    -------
    Members

    Raises
    ------
    InputError
        If the number of starts is not positive.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.flow.ensembles.random_starts(100, {"energy": 2.0}, seed=1).size
    100
    """
    if not isinstance(count, int | np.integer) or count < 1:
        raise InputError(
            f"members of an ensemble: {count} starts cannot be drawn; at least one is needed"
        )
    return Members((SampledMembers(count, dict(level), seed),))


def _numbers(name: str, value: npt.ArrayLike) -> FloatArray:
    result: FloatArray = as_float_array(f"members of an ensemble: {name}", value)
    return result


def _finite(name: str, value: npt.ArrayLike) -> FloatArray:
    array = np.atleast_1d(_numbers(name, value))
    if not np.all(np.isfinite(array)):
        raise InputError(f"members of an ensemble: {name} must be finite numbers")
    return array
