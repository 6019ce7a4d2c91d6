"""Initial states: many at once by name, or one by name or in flat order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ..arguments import Parameters
from ..errors import InputError
from ..system.arrays import FloatArray
from ..system.named_formulas import flat, in_words
from ..system.system import System
from .taylor.working_numbers import WorkingNumber


def reduced_start(
    system: System,
    start: Mapping[str, npt.ArrayLike] | Sequence[WorkingNumber],
    parameters: Parameters = None,
) -> tuple[WorkingNumber, ...]:
    """The state of a system without its reconstruction, in flat order.

    Parameters
    ----------
    system : System
    start : mapping of str to number or numbers, or sequence of numbers
        By name (the variables of the state, or what the conventions of the system take for them),
        or in flat order, with the reconstruction behind it or without.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the defaults where the state follows from other variables.

    Raises
    ------
    InputError
        If a name or the number of numbers is wrong.
    """
    if isinstance(start, Mapping):
        named, _ = system.conventions.split_motion(system, start)
        rows = {name: np.array([value], dtype=float) for name, value in named.items()}
        numbers = {str(key): value for key, value in (parameters or {}).items()}
        return tuple(flat_starts(system, rows, numbers)[0].tolist())
    _require_size(system, len(start))
    return tuple(start[: len(system.symbols)])


def whole_start(
    system: System,
    start: Mapping[str, npt.ArrayLike] | Sequence[WorkingNumber],
    parameters: Parameters = None,
) -> tuple[WorkingNumber, ...]:
    """The state of a system including its reconstruction, if it has one, in flat order.

    Variables of the reconstruction that a start omits begin where the conventions say, usually
    at zero.

    Parameters
    ----------
    system, start, parameters
        See `reduced_start`.

    Raises
    ------
    InputError
        If a name or the number of numbers is wrong.
    """
    placed: dict[str, list[WorkingNumber]] = {}
    if isinstance(start, Mapping):
        _, placed = system.conventions.split_motion(system, start)
        start = reduced_start(system, start, parameters)
    _require_size(system, len(start))
    if system.reconstruction is None or len(start) > len(system.symbols):
        return tuple(start)
    known = dict(zip(map(str, system.symbols), start, strict=True))
    state: list[WorkingNumber] = list(start)
    for name, _ in system.reconstruction.field:
        given = placed.get(str(name))
        state += system.conventions.first_values(system, name, known) if given is None else given
    return tuple(state)


def vector_components(system: System, name: object, value: Any) -> list[tuple[object, Any]]:
    """Expand a vector of the state into named components; other values are returned unchanged.

    Raises
    ------
    InputError
        If a vector has another number of components.
    """
    for vector in system.state:
        if str(vector) == str(name) and len(symbols := flat([vector])) > 1:
            numbers = list(value) if isinstance(value, Sequence | np.ndarray) else [value]
            if isinstance(value, str) or len(numbers) != len(symbols):
                raise InputError(f"{name}: must be {len(symbols)} numbers, not {value}")
            return list(zip(symbols, numbers, strict=True))
    return [(name, value)]


def reduced_rows(system: System, rows: FloatArray) -> FloatArray:
    """Starts (motions, size, …) without the columns of the reconstruction."""
    whole = system.reconstruction is not None and rows.ndim > 1
    if whole and rows.shape[1] == len(system.lifted().symbols):
        return rows[:, : len(system.symbols)]
    return rows


def _require_size(system: System, count: int) -> None:
    """Raise an error unless a start has the size of the state, reduced or lifted."""
    size = len(system.symbols)
    whole = system.lifted() if system.reconstruction else system
    if count in (size, len(whole.symbols)):
        return
    names = list(map(str, whole.symbols))
    more = f"; or {len(names)}, with {', '.join(names[size:])}" if len(names) > size else ""
    raise InputError(
        f"start has {count} numbers: {size} are needed ({', '.join(names[:size])}{more})"
    )


def flat_starts(
    system: System, arrays: Mapping[str, FloatArray], parameters: Parameters = None
) -> FloatArray:
    """States in flat order.

    Parameters
    ----------
    system : System
    given : mapping of str to array
        ``state`` (n, size), the whole state; or variables of the state, (n, components) for
        vectors and (n,) for scalars, or single components; or what the conventions of the system
        take in their place.
    parameters : mapping of str to number or array (n,), optional
        Values that replace the defaults.

    Returns
    -------
    array (n, size)

    Raises
    ------
    InputError
        If a name is unknown, a shape is wrong, or something of the state is not given.
    """
    if set(arrays) == {"state"}:
        states = reduced_rows(system, np.asarray(arrays["state"], dtype=float))
        return checked_shape(system, "state", states, len(system.symbols))
    return _flat_states(system, system.conventions.states(system, arrays, parameters))


def _flat_states(system: System, arrays: Mapping[str, FloatArray]) -> FloatArray:
    """The columns of the state, from variables and components by name."""
    columns: dict[str, FloatArray] = {}
    variables = {str(v): v for v in system.state}
    components = {str(s): s for s in system.symbols}
    for name, array in arrays.items():
        if name in variables:
            symbols = flat([variables[name]])
            block = checked_shape(system, name, array, len(symbols))
            columns |= {str(s): block[:, i] for i, s in enumerate(symbols)}
        elif name in components:
            columns[name] = checked_shape(system, name, array, 1)[:, 0]
        else:
            raise InputError(f"{system.name}: there is no {name}; {_names_in_words(system)}")
    missing = [name for name in components if name not in columns]
    if missing:
        raise InputError(f"{system.name}: the start does not tell {', '.join(missing)}")
    return np.column_stack([columns[name] for name in components])


def checked_shape(system: System, name: str, array: FloatArray, size: int) -> FloatArray:
    """An array (n, size); scalars may be (n,)."""
    block = np.asarray(array, dtype=float)
    if size == 1 and block.ndim == 1:
        return block[:, np.newaxis]
    if block.ndim != 2 or block.shape[1] != size:
        given = " × ".join(map(str, block.shape[1:])) or "1"
        raise InputError(
            f"{system.name}: {name} has {given} number{'s' * (given != '1')} for each motion, "
            f"not {size}"
        )
    return block


def _names_in_words(system: System) -> str:
    """The names that a start may use, as the end of a sentence."""
    numbers = ", ".join(str(p.symbol) for p in system.parameters)
    return f"its state has {in_words(system.state)}; its parameters are {numbers or 'none'}"
