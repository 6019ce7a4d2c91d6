"""Common interface of all motions."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, TypeVar

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import arguments_checked
from ..errors import InputError, nearest
from ..system.system import System
from .taylor.working_numbers import WorkingArray, WorkingNumber

if TYPE_CHECKING:
    import xarray as xr

Number = TypeVar("Number", bound=np.generic)


class UnknownVariableError(InputError, KeyError):
    """Name that is not a quantity of a motion; also a KeyError, as for any mapping."""


def read_only(array: npt.NDArray[Number]) -> npt.NDArray[Number]:
    """Read-only view of an array."""
    view = array.view()
    view.flags.writeable = False
    return view


def by_name(system: System, states: npt.NDArray[Number], name: str) -> npt.NDArray[Number]:
    """Variable of states (n, size) by name: (n, components), or (n,) for a scalar.

    Raises
    ------
    UnknownVariableError
        If the system has no such variable.
    """
    for variable, columns in system.slices:
        if str(variable) == name:
            block = states[:, columns]
            column: npt.NDArray[Number] = block[:, 0]
            return column if isinstance(variable, sp.Symbol) else block
    raise unknown_variable(system.name, name, map(str, system.state))


def unknown_variable(owner: str, name: object, known: Iterable[str]) -> UnknownVariableError:
    """Error for a quantity that is neither in the state nor recorded."""
    if not isinstance(name, str):
        return UnknownVariableError(
            f"{owner}: a quantity is asked for by its name in quotes, not by {name!r}"
        )
    return UnknownVariableError(f"{owner}: no quantity {name!r}{nearest(name, [*known])}")


def _frozen(value: object) -> object:
    """Read-only arrays, alone or in a mapping; other values unchanged."""
    if isinstance(value, np.ndarray):
        return read_only(value)
    if isinstance(value, dict):
        return {key: _frozen(item) for key, item in value.items()}
    return value


class Motion(ABC):
    """One motion: states at times, quantities by name; its arrays are read-only.

    Every integrator, every closed form and every plan gives one.  ``motion["x"]`` is a
    quantity by its name, (n,) or (n, components); iterating over a motion gives these names.

    Attributes
    ----------
    times : array (n,)
        Times in s.
    states : array (n, size)

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> motion = flowlanes.integrate(pendulum, {"x": 1, "v": 0}, [0.0, 5.0, 10.0], dense=True)
    >>> isinstance(motion, flowlanes.flow.Motion), "v" in motion
    (True, True)
    >>> motion([2.5, 7.5])["x"].shape
    (2,)
    """

    times: WorkingArray
    states: WorkingArray

    @abstractmethod
    def __getitem__(self, name: str) -> WorkingArray:
        """Quantity by name, (n,) or (n, components).

        Raises
        ------
        UnknownVariableError
            If the motion has no such quantity; also an InputError and a KeyError.
        """

    @abstractmethod
    def __iter__(self) -> Iterator[str]:
        """Names of all quantities."""

    @abstractmethod
    def to_dataset(self) -> xr.Dataset:
        """Motion as an ``xarray.Dataset`` with the dimension ``time``."""

    def __contains__(self, name: object) -> bool:
        return name in tuple(self)

    def __call__(self, times: npt.ArrayLike) -> Motion:
        """Motion at other times within its interval.

        Raises
        ------
        InputError
            If the motion is known only at its samples, or a time lies outside its interval.
        """
        raise InputError(f"{type(self).__name__}: it is known at its samples alone")

    def __setstate__(self, state: Mapping[str, object]) -> None:
        """Restore a pickled motion with read-only arrays."""
        for name, value in state.items():
            self.__dict__[name] = _frozen(value)


class SystemMotion(Motion):
    """Motion of a System.

    Attributes
    ----------
    system : System
    parameters : mapping of Symbol to number
    records : mapping of str to array
        Quantities besides the state, by name, (n,) or (n, components).
    """

    system: System
    parameters: Mapping[sp.Symbol, WorkingNumber]
    records: Mapping[str, WorkingArray]

    def __getitem__(self, name: str) -> WorkingArray:
        if isinstance(name, str) and name in self.records:
            return self.records[name]
        return self.variable(name)

    def variable(self, name: str) -> WorkingArray:
        """Variable of the state, (n,) or (n, components).

        Raises
        ------
        UnknownVariableError
            If the state has no such variable.
        """
        if isinstance(name, str) and name in map(str, self.system.state):
            return by_name(self.system, self.states, name)
        raise unknown_variable(self.system.name, name, self)

    def __iter__(self) -> Iterator[str]:
        names = [str(variable) for variable in self.system.state]
        return iter(dict.fromkeys([*names, *self.records]))

    def facts(self) -> dict[str, object]:
        """Method and options of the computation, for the attributes of the dataset."""
        return {}

    @arguments_checked
    def to_dataset(
        self,
        attributes: Mapping[str, object] | None = None,
        meanings: Mapping[str, tuple[str, str]] | None = None,
    ) -> xr.Dataset:
        """Motion as a dataset.

        Parameters
        ----------
        attributes : mapping, optional
            Additional global attributes, such as the text of the experiment file.
        meanings : mapping of str to (str, str), optional
            Meaning and SI unit of variables of the state, by name.

        Returns
        -------
        xarray.Dataset
            Dimension ``time``; vectors have the dimension of their frame, and
            vectors of the state in no known frame a dimension ``<name>_component``.  Every
            variable has ``long_name``, ``units`` and ``source``.  Numbers of 34 digits are split:
            the sum of ``<name>`` and ``<name>_low`` has all of them.

        Examples
        --------
        >>> import flowlanes
        >>> import sympy as sp
        >>> x, v = sp.symbols("x v", real=True)
        >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
        >>> motion = flowlanes.integrate(pendulum, {"x": 1, "v": 0}, [0.0, 5.0, 10.0])
        >>> dict(motion.to_dataset().sizes)
        {'time': 3}
        """
        from .motion_dataset import motion_dataset

        return motion_dataset(
            self.system,
            self.parameters,
            self.times,
            {name: self[name] for name in self},
            start=self.states[0],
            facts=self.facts(),
            meanings=meanings,
        ).assign_attrs(attributes or {})
