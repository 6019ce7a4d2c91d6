"""Initial states from values of the state by name.

As in :mod:`nonholonomic.mechanics.rolling.initial_state`, numbers are computed with 50 digits and
rounded once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import TypeAlias

import mpmath
import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.multiprecision import Multiprecision
from flowlanes.parsing import NamedQuantity, nearest
from flowlanes.printing.formula import text
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector, norm_squared
from nonholonomic.mechanics.lagrangian.mechanism import TIME
from nonholonomic.mechanics.rolling.attitude import attitude
from nonholonomic.mechanics.rolling.initial_state import DIGITS, SLACK
from nonholonomic.mechanics.rotations import upright
from nonholonomic.system_files.validation import value_text

#: Component labels that a vector may have.
SIZES = (2, 3, 4)
SPACE, QUATERNION = 3, 4

#: Maximum number of Newton steps that project a start onto the phase space.
_STEPS = 40

#: Tolerance for the length of a unit vector given in doubles.
ROUNDING = 4e-16

#: Step of the difference quotients for slopes.
_DIFFERENCE = mpmath.mpf(10) ** -20

#: A start as given: numbers, or the components of vectors, by name.
StartValues: TypeAlias = Mapping[str, float | Sequence[float]]


def initial_state_from_values(
    system: System, values: StartValues, velocities: Collection[sp.Symbol] = ()
) -> tuple[mpmath.mpf, ...]:
    """The state of a system, lifted to space if it has a motion, by named values.

    Parameters
    ----------
    system : System
    values : mapping of str to number or numbers
        Every variable of the state; those of the lift may be omitted. A vector with unit length by
        the relations is normalised. Values of definitions may be added as a check.
    velocities : collection of Symbol
        Variables that are changed to satisfy a relation in which they occur, with all others fixed.

    Returns
    -------
    tuple of mpmath.mpf
        The state in flat order, on the relations to 50 digits. Omitted lift variables start at
        zero, and the attitude such that γ, if there is one, points upwards.

    Raises
    ------
    InputError
        If a name is unknown or missing, a value has the wrong shape, or the state misses the
        relations; the message then names the nearest admissible state. Also if a definition has
        another value at this state.
    """
    lifted = system.lifted() if system.reconstruction else system
    values, claims = _state_and_given_definitions(lifted, values)
    with mpmath.workdps(DIGITS):
        known = _checked_values(system, values)
        _complete(lifted, known)
        state = [x for name in lifted.state for x in known[str(name)]]
        point = _on_relations(lifted, state, velocities)
        _check_given_definitions(lifted, point, claims)
        return tuple(point)


def lift_of(system: System, values: StartValues) -> dict[str, float | tuple[float, ...]]:
    """The completed values of lift variables that a start omits."""
    if system.reconstruction is None:
        return {}
    gamma = values.get("gamma")
    known: dict[str, list[mpmath.mpf]] = {}
    if isinstance(gamma, Sequence) and len(gamma) == SPACE:
        known["gamma"] = [mpmath.mpf(x) for x in gamma]
    _complete(system.lifted(), known)
    lift: dict[str, float | tuple[float, ...]] = {}
    for name, _ in system.reconstruction.field:
        if str(name) not in values:
            numbers = tuple(float(x) for x in known[str(name)])
            lift[str(name)] = numbers if _size(name) else numbers[0]
    return lift


def normalised_vectors(
    values: StartValues, names: Collection[str]
) -> dict[str, tuple[float, list[float]]]:
    """Length and direction of those vectors whose length is not one."""
    lengths = {}
    for name in names & values.keys():
        words = values[name]
        vector = list(map(float, words)) if isinstance(words, Sequence) else []
        length = math.hypot(*vector)
        if length and abs(length - 1) > ROUNDING:
            lengths[name] = length, [x / length for x in vector]
    return lengths


def on_level(system: System, level: Sequence[sp.Expr], state: Sequence[mpmath.mpf]) -> bool:
    """Whether all expressions of a level vanish at a state, up to rounding."""
    with mpmath.workdps(DIGITS):
        size = 1 + max((abs(x) for x in state), default=0)
        defects = _numerical_function(system, scalars(tuple(level)))(state)
        return all(abs(x) <= SLACK * size**2 for x in defects)


def _state_and_given_definitions(
    lifted: System, values: StartValues
) -> tuple[StartValues, dict[sp.Symbol, float]]:
    """Values of the state by its names, and of definitions by their symbols."""
    state = set(map(str, lifted.state))
    defined = {str(s): s for s, _ in lifted.scalar_definitions}
    words: dict[str, float | Sequence[float]] = {}
    claims: dict[sp.Symbol, float] = {}
    for name, whole in values.items():
        for part, value in _split_vector(name, whole, state, {*map(str, lifted.symbols), *defined}):
            if part in defined and not isinstance(value, Sequence):
                claims[defined[part]] = value
            else:
                words[part] = value
    return words, claims


def _split_vector(
    name: str, value: float | Sequence[float], state: Collection[str], scalars: Collection[str]
) -> list[tuple[str, float | Sequence[float]]]:
    """Split a vector that is not a whole vector of the system into its components."""
    if name in state or not isinstance(value, Sequence) or len(value) not in SIZES:
        return [(name, value)]
    symbols = list(map(str, Vector(name, len(value)).symbols))
    if not all(symbol in scalars for symbol in symbols):
        return [(name, value)]
    return list(zip(symbols, value, strict=True))


def _check_given_definitions(
    lifted: System, state: list[mpmath.mpf], claims: Mapping[sp.Symbol, float]
) -> None:
    """Raise an error if given values of definitions differ from those of the state."""
    values = _numerical_function(lifted, list(claims))(state) if claims else []
    for symbol, value in zip(claims, values, strict=True):
        claim = claims[symbol]
        if abs(value - claim) > SLACK * (1 + abs(claim)):
            raise InputError(
                f"{symbol}: follows from the others and is {float(value):.15g}, not {claim:.15g}; "
                "it may be left out"
            )


def _checked_values(system: System, values: StartValues) -> dict[str, list[mpmath.mpf]]:
    """The given values as numbers, with names and shapes checked, and unit vectors normalised."""
    lifted = system.lifted() if system.reconstruction else system
    sizes = {str(name): _size(name) for name in lifted.state}
    for name in values:
        if name not in sizes:
            raise InputError(f"{name}: unknown variable{nearest(name, sizes)}")
    missing = [str(name) for name in system.state if str(name) not in values]
    if missing:
        raise InputError(
            f"start: {', '.join(missing)} missing; the state of {system.name} is "
            f"{', '.join(map(str, system.state))}"
        )
    known = {name: _numbers(name, value, sizes[name]) for name, value in values.items()}
    for name in unit_vectors(lifted) & known.keys():
        length = mpmath.norm(known[name])
        if length == 0:
            raise InputError(f"{name}: must not be zero, as it is a direction")
        known[name] = [x / length for x in known[name]]
    return known


def _size(name: NamedQuantity) -> int:
    """Number of components; 0 for a scalar."""
    return 0 if isinstance(name, sp.Symbol) else len(name.symbols)


def _numbers(name: str, value: float | Sequence[float], size: int) -> list[mpmath.mpf]:
    listed = list(value) if isinstance(value, Sequence) else [value]
    fits = isinstance(value, Sequence) == (size > 0) and len(listed) == max(size, 1)
    if not fits or any(isinstance(x, Sequence) or not mpmath.isfinite(x) for x in listed):
        wanted = f"{size} finite numbers" if size else "a finite number"
        raise InputError(f"{name}: must be {wanted}, not {value_text(value)}")
    return [mpmath.mpf(repr(float(x))) for x in listed]


def unit_vectors(system: System) -> set[str]:
    """Names of the state vectors that have unit length by the relations."""
    relations = system.scalar.relations
    return {
        str(name)
        for name in system.state
        if isinstance(name, Vector) and system.scalar.of(norm_squared(name)) - 1 in relations
    }


def _complete(lifted: System, values: dict[str, list[mpmath.mpf]]) -> None:
    """Complete the variables of the lift to space."""
    zero, one = mpmath.mpf(0), mpmath.mpf(1)
    for name in lifted.state:
        if str(name) in unit_vectors(lifted) - {str(attitude)}:
            # The last axis, or the identity quaternion.
            others = [zero] * (_size(name) - 1)
            values.setdefault(
                str(name), [one, *others] if _size(name) == QUATERNION else [*others, one]
            )
        values.setdefault(str(name), [zero] * max(_size(name), 1))
    if attitude in lifted.state and not any(values[str(attitude)]):
        values[str(attitude)] = upright(values.get("gamma", [zero, zero, mpmath.mpf(1)]))


def _numerical_function(
    system: System, formulas: Sequence[sp.Expr]
) -> Callable[[Sequence[mpmath.mpf]], list[mpmath.mpf]]:
    """Scalar formulas of a system as an mpmath function of its flat state."""
    constants = {s: mpmath.mpf(repr(float(v))) for s, v in system.defaults.items()}
    steps = system.required_definitions(formulas)

    def values(state: Sequence[mpmath.mpf]) -> list[mpmath.mpf]:
        try:
            numbers = Multiprecision({**dict(zip(system.symbols, state, strict=True)), **constants})
            numbers.define(steps)
            results = [numbers(formula) for formula in formulas]
        except ZeroDivisionError:
            raise InputError("start: the equations are singular at this state") from None
        if any(isinstance(value, mpmath.mpc) for value in results):
            raise InputError("start: the equations have no real value at this state")
        return results

    return values


def _on_relations(
    lifted: System, state: list[mpmath.mpf], velocities: Collection[sp.Symbol]
) -> list[mpmath.mpf]:
    """The nearest state on the relations; raises InputError if it is far away."""
    if not lifted.relations:
        return state
    residual = _numerical_function(lifted, list(lifted.scalar.relations))
    near = _nearest(lifted, state, velocities)
    defects = residual(state)
    if near is not None and _distance(near, state) <= SLACK * (1 + max(map(abs, state))):
        return near
    worst = max(range(len(defects)), key=lambda i: abs(defects[i]))
    message = (
        f"start: the relation {text(lifted.relations[worst])} = 0 is missed by "
        f"{mpmath.nstr(defects[worst], 6, min_fixed=-5, max_fixed=6)}"
    )
    if near is not None:
        message += f"; the nearest admissible state is {_state_text(lifted, near)}"
    raise InputError(message)


def _nearest(
    lifted: System, state: Sequence[mpmath.mpf], velocities: Collection[sp.Symbol]
) -> list[mpmath.mpf] | None:
    """A state on the relations: positions are projected first, then velocities.

    Positions, and time with them, change only if positions alone violate a relation, or if no
    velocities at the given positions are admissible.
    """
    relations = list(lifted.scalar.relations)
    of_velocities = [r for r in relations if lifted.expand(r).free_symbols & {*velocities}]
    of_places = [r for r in relations if r not in of_velocities]
    names = lifted.symbols
    fast = [i for i, s in enumerate(names) if s in velocities]
    places = [i for i, s in enumerate(names) if s not in velocities and s != TIME]
    every = range(len(names))
    point = _project(lifted, of_places, state, (places, every))
    return point and (
        _project(lifted, of_velocities, point, (fast,))
        or _project(lifted, relations, state, (every,))
    )


def _project(
    lifted: System,
    relations: Sequence[sp.Expr],
    state: Sequence[mpmath.mpf],
    choices: Iterable[Sequence[int]],
) -> list[mpmath.mpf] | None:
    """A state on the relations, changing the first choice of variables that suffices."""
    if not relations:
        return list(state)
    residual = _numerical_function(lifted, relations)
    tries = (_newton(residual, state, indices) for indices in choices)
    return next((point for point in tries if point is not None), None)


def _newton(
    residual: Callable[[Sequence[mpmath.mpf]], list[mpmath.mpf]],
    state: Sequence[mpmath.mpf],
    indices: Sequence[int],
) -> list[mpmath.mpf] | None:
    """The point near `state` where all residuals vanish, if Newton's method finds one.

    Only the variables with given indices change.
    """
    point = list(state)
    for _ in range(_STEPS):
        defects = residual(point)
        if max(map(abs, defects)) < mpmath.mpf(10) ** (8 - DIGITS):
            return point
        if not indices:
            return None
        columns = []
        for index in indices:
            moved = list(point)
            moved[index] += _DIFFERENCE
            pairs = zip(residual(moved), defects, strict=True)
            columns.append([float((x - y) / _DIFFERENCE) for x, y in pairs])
        if not np.isfinite(columns).all():
            return None  # a state so large that doubles do not hold its slopes
        # Redundant relations (an attitude tied to a unit vector) make the rows dependent.
        inverse = np.linalg.pinv(np.array(columns).T, rcond=1e-9)
        for index, row in zip(indices, inverse, strict=True):
            point[index] -= sum(float(a) * x for a, x in zip(row, defects, strict=True))
    return None


def _distance(one: Sequence[mpmath.mpf], other: Sequence[mpmath.mpf]) -> mpmath.mpf:
    return max(abs(x - y) for x, y in zip(one, other, strict=True))


def _state_text(system: System, state: Sequence[mpmath.mpf]) -> str:
    """A state by names, in the form of a start."""
    parts = []
    numbers = [repr(float(x)) for x in state]
    for name in system.state:
        size = _size(name)
        values, numbers = numbers[: max(size, 1)], numbers[max(size, 1) :]
        parts.append(f"{name} = [{', '.join(values)}]" if size else f"{name} = {values[0]}")
    return ", ".join(parts)
