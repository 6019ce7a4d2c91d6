"""Initial states: many at once by name, or one by name or in flat order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import mpmath
import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import Parameters
from ..errors import InputError
from ..formulas.array_evaluation import values
from ..system.arrays import FloatArray
from ..system.matrices import Column, Skew, SquareMatrix
from ..system.named_formulas import flat, in_words
from ..system.rotations import finite_numbers, rotation_near, upright_matrix
from ..system.system import System
from ..system.vectors import Vector
from .taylor.working_numbers import WorkingNumber

#: Digits of the attitude computed for a start, and tolerance for recognising a half turn.
_DIGITS, _TURNED = 50, 1e-12
#: Tolerance for γ against the last row of an attitude, and for ω against the constraint.
_SLACK, _OF_SPIN = 1e-12, 1e-9

omega, gamma = Vector("omega"), Vector("gamma")


def reduced_start(
    system: System,
    start: Mapping[str, npt.ArrayLike] | Sequence[WorkingNumber],
    parameters: Parameters = None,
) -> tuple[WorkingNumber, ...]:
    """The state of a system without its motion in space, in flat order.

    Parameters
    ----------
    system : System
    start : mapping of str to number or numbers, or sequence of numbers
        By name (ω and γ, or the variables of the state; of an n-dimensional body also its
        attitude, of which γ is the last row, and contact), or in flat order, with the motion in
        space behind it or without.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the defaults where the state follows from ω and γ.

    Raises
    ------
    InputError
        If a name or the number of numbers is wrong.
    """
    if isinstance(start, Mapping):
        named, _ = _split_space_state(system, start)
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
    """The state of a system including its motion in space, if it has one, in flat order.

    Variables that a start omits begin at zero; the attitude turns ζ, or else γ, upward.

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
        _, placed = _split_space_state(system, start)
        start = reduced_start(system, start, parameters)
    _require_size(system, len(start))
    if system.reconstruction is None or len(start) > len(system.symbols):
        return tuple(start)
    known = dict(zip(map(str, system.symbols), start, strict=True))
    up = next((n for n in (Vector("zeta"), gamma) if n in system.state), None)
    state: list[WorkingNumber] = list(start)
    for name, _ in system.reconstruction.field:
        if str(name) in placed:
            state += placed[str(name)]
        elif isinstance(name, SquareMatrix):
            normal = [known[str(s)] for s in Column("gamma", int(name.shape[0])).symbols]
            state += [x for row in upright_matrix(normal) for x in row]
        elif str(name) == "attitude":
            state += upright([known[str(s)] for s in up.symbols]) if up else [1.0, 0.0, 0.0, 0.0]
        else:
            state += [0.0] * len(flat([name]))
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


def upright(vertical: Sequence[WorkingNumber]) -> list[mpmath.mpf]:
    """The quaternion of the shortest rotation that takes a unit vector (body) to the vertical."""
    with mpmath.workdps(_DIGITS):
        # float also converts NumPy scalars, whose repr is not a plain number.
        decimals = (repr(float(v)) if isinstance(v, float) else v for v in vertical)
        x, y, z = map(mpmath.mpf, decimals)
        turn = [1 + z, y, -x, mpmath.mpf(0)]
        if not 1 + z > _TURNED:
            turn = [mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(0), mpmath.mpf(0)]
        length = mpmath.norm(turn)
        return [part / length for part in turn]


def _split_space_state(
    system: System, start: Mapping[str, npt.ArrayLike]
) -> tuple[dict[str, npt.ArrayLike], dict[str, list[WorkingNumber]]]:
    """Split the start of an n-dimensional body into its reduced state and its motion in space."""
    named, lift = dict(start), system.reconstruction
    matrix = next((x for x, _ in lift.field if isinstance(x, SquareMatrix)), None) if lift else None
    if lift is None or matrix is None:
        return named, {}
    placed: dict[str, list[WorkingNumber]] = {}
    for name, _ in lift.field:
        if str(name) in named and name != matrix:
            placed[str(name)] = finite_numbers(str(name), named.pop(str(name)), len(flat([name])))
    if str(matrix) in named:
        rows = rotation_near(named.pop(str(matrix)), int(matrix.shape[0]))
        placed[str(matrix)] = [x for row in rows for x in row]
        last = [float(x) for x in rows[-1]]
        # On a sphere the normal γ moves in space, and no relation ties it to the attitude.
        ties = {str(s) for relation in lift.relations for s in relation.free_symbols}
        if "gamma" in named and "gamma_1" not in ties:
            return named, placed
        given = np.asarray(named.setdefault("gamma", last), dtype=float)
        if given.shape != (len(last),) or not np.allclose(
            given / (np.linalg.norm(given) or 1.0), last, rtol=0.0, atol=_SLACK
        ):
            raise InputError(
                "gamma: must be the last row of the attitude; one of them may be left out"
            )
    return named, placed


def reduced_rows(system: System, rows: FloatArray) -> FloatArray:
    """Starts (motions, size, …) without the columns of the motion in space."""
    whole = system.reconstruction is not None and rows.ndim > 1
    if whole and rows.shape[1] == len(system.lifted().symbols):
        return rows[:, : len(system.symbols)]
    return rows


def _require_size(system: System, count: int) -> None:
    """Raise an error unless a start has the size of the state, reduced or in space."""
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
        vectors and (n,) for scalars, or single components; or ``omega`` and ``gamma``, (n, 3) in
        body axes, from which the system says how the state follows (γ is normalised then), with
        ``fluid`` for the motion of a fluid relative to the body, at rest there by default.
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
        return _checked_shape(system, "state", states, len(system.symbols))
    if "omega" in arrays and ("gamma" in arrays or omega not in system.state):
        return _flat_states(system, _state_from_omega(system, arrays, parameters))
    return _flat_states(system, arrays)


def _flat_states(system: System, arrays: Mapping[str, FloatArray]) -> FloatArray:
    """The columns of the state, from variables and components by name."""
    columns: dict[str, FloatArray] = {}
    variables = {str(v): v for v in system.state}
    components = {str(s): s for s in system.symbols}
    for name, array in arrays.items():
        if name in variables:
            symbols = flat([variables[name]])
            block = _checked_shape(system, name, array, len(symbols))
            columns |= {str(s): block[:, i] for i, s in enumerate(symbols)}
        elif name in components:
            columns[name] = _checked_shape(system, name, array, 1)[:, 0]
        else:
            raise InputError(f"{system.name}: there is no {name}; {_names_in_words(system)}")
    missing = [name for name in components if name not in columns]
    if missing:
        raise InputError(f"{system.name}: the start does not tell {', '.join(missing)}")
    return np.column_stack([columns[name] for name in components])


def _checked_shape(system: System, name: str, array: FloatArray, size: int) -> FloatArray:
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


def _state_from_omega(
    system: System, arrays: Mapping[str, FloatArray], parameters: Parameters
) -> dict[str, Any]:
    """The variables of the state that follow from ω and γ, and the remaining ones."""
    if not system.start and omega not in system.state:
        raise InputError(f"{system.name}: its state does not follow from omega; give the state")
    if "gamma" not in arrays:
        raise InputError(f"{system.name}: omega is given, but gamma is not")
    spin, direction = _spin_and_direction(system)
    turning = _checked_shape(system, "omega", arrays["omega"], len(spin.symbols))
    normal = _checked_shape(system, "gamma", arrays["gamma"], len(direction.symbols))
    lengths = np.linalg.norm(normal, axis=1, keepdims=True)
    if not np.all(lengths > 0):
        raise InputError(f"{system.name}: gamma is zero: it must point along the normal")
    further = [
        _checked_shape(system, str(v), arrays.get(str(v), np.zeros_like(turning)), 3)
        for v in system.start_vectors
    ]
    points = np.column_stack([turning, normal / lengths, *further])
    auxiliary, symbols = _spinning(system)
    numbers = values(auxiliary, symbols, points, parameters)
    following = {str(s): numbers[:, i] for i, s in enumerate(symbols)}
    if isinstance(spin, Skew):
        _require_spin(system, spin, np.column_stack([numbers, normal / lengths]), turning)
    read = ("omega", "gamma", *map(str, system.start_vectors))
    others = {name: array for name, array in arrays.items() if name not in read}
    unchanged = {
        str(name): block
        for name, block in ((spin, turning), (direction, normal / lengths))
        if name in system.state
    }
    return {**following, **unchanged, **others}


def _require_spin(system: System, spin: Skew, states: FloatArray, omega: FloatArray) -> None:
    """Raise an error for an ω that violates the constraint of an n-dimensional body."""
    has = values(system, list(spin.symbols), states)
    excess = np.abs(has - omega).max(axis=1)
    if np.any(excess > _OF_SPIN * np.abs(omega).max(axis=1)):
        raise InputError(f"{system.name}: the constraint does not admit this omega")


def _spin_and_direction(system: System) -> tuple[Vector | Skew, Vector]:
    """The names of ω and γ: vectors, or for n dimensions a skew matrix and a column."""
    direction = next((v for v in system.state if str(v) == "gamma"), gamma)
    if not isinstance(direction, Column):
        return omega, gamma
    return Skew("omega", int(direction.shape[0])), direction


@lru_cache(maxsize=16)
def _spinning(system: System) -> tuple[System, tuple[sp.Symbol, ...]]:
    """A system with the state ω, γ, whose other variables are definitions."""
    state = (*_spin_and_direction(system), *system.start_vectors)
    still = {name: sp.ImmutableDenseMatrix.zeros(*name.shape) for name in state}
    known = flat(state)
    formulas = [formula for _, formula in system.start]
    before = system.required_definitions(formulas, known)
    auxiliary = System(
        system.name,
        system.title,
        still,
        system.parameters,
        definitions=(*before, *system.start),
    )
    return auxiliary, flat([name for name, _ in system.start])
