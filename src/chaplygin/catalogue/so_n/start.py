"""Starts of n-dimensional bodies: attitude and angular velocity, as numbers of 50 digits."""

from __future__ import annotations

from collections.abc import MutableMapping, Sequence
from typing import TypeAlias

import mpmath
import sympy as sp

from ...core.system import System, flat_pairs
from ...errors import InputError
from ...flow.initial_states import upright_matrix
from ...mechanics.rolling.initial_state import DIGITS, SLACK, evaluate
from ..entry import Family
from .inertia import labels, pairs
from .motion_in_space import omega_of

Matrix: TypeAlias = list[list[mpmath.mpf]]

#: A start as given, by name.
Given: TypeAlias = MutableMapping[str, float | Sequence[float]]

#: Names of a start that are not variables of the reduced state.
ATTITUDE, OMEGA, GAMMA, CONTACT = "attitude", "omega", "gamma", "contact"


def take_attitude(values: Given, n: int) -> Matrix:
    """Take the attitude out of a start: as given, or the shortest turn of γ to the last axis.

    Raises
    ------
    InputError
        If it is no rotation, or γ is not its last row.
    """
    given, direction = values.pop(ATTITUDE, None), values.pop(GAMMA, None)
    gamma = None if direction is None else _unit(direction, n)
    if given is None:
        if gamma is None:
            raise InputError("start: gamma or attitude is missing")
        return upright_matrix(gamma)
    attitude = _rotation(given, n)
    if gamma is None:
        return attitude
    if max(abs(x - y) for x, y in zip(gamma, attitude[-1], strict=True)) > SLACK:
        raise InputError("gamma: must be the last row of the attitude; one of them may be left out")
    return attitude


def take_contact(values: Given, n: int) -> list[mpmath.mpf]:
    """Take the contact point out of a start; the origin where it is left out."""
    return _numbers(CONTACT, values.pop(CONTACT, [0.0] * (n - 1)), n - 1)


def take_spin(values: Given, gamma: Sequence[mpmath.mpf], family: Family) -> Matrix | None:
    """Take ω out of a start, as a skew matrix; None where it is not given.

    Raises
    ------
    InputError
        If the constraint does not admit it; the message then names the nearest one.
    """
    given = values.pop(OMEGA, None)
    if given is None:
        return None
    n = len(gamma)
    names = labels(n)
    numbers = _numbers(OMEGA, given, len(names), f" ({', '.join(names)})")
    omega: Matrix = mpmath.zeros(n).tolist()
    for (i, j), x in zip(pairs(n), numbers, strict=True):
        omega[i][j], omega[j][i] = x, -x
    nearest: Matrix = family.admissible(omega, gamma)
    excess = max(abs(omega[i][j] - nearest[i][j]) for i, j in pairs(n))
    if excess > SLACK * max(map(abs, numbers)):
        shown = ", ".join(repr(float(nearest[i][j])) for i, j in pairs(n))
        raise InputError(f"omega: {family.constraint}; the nearest admissible omega is [{shown}]")
    return nearest


def state_of(system: System, omega: Matrix, gamma: Sequence[mpmath.mpf]) -> list[mpmath.mpf]:
    """The reduced state that follows from ω and γ.

    Raises
    ------
    InputError
        If these do not determine it.
    """
    if not system.start:
        names = ", ".join(map(str, system.state))
        raise InputError(f"omega: does not determine this state; give {names}")
    n = len(gamma)
    known = {s: mpmath.mpf(repr(float(x))) for s, x in system.defaults.items()}
    known |= dict(zip(_symbols(system, GAMMA), gamma, strict=True))
    entries = (omega[i][j] for i, j in pairs(n))
    known |= dict(zip(omega_of(n).symbols, entries, strict=True))
    following = flat_pairs(system.start)
    numbers = evaluate(system, [value for _, value in following], known)
    known |= dict(zip((s for s, _ in following), numbers, strict=True))
    return [known[s] for s in system.symbols]


def _symbols(system: System, name: str) -> tuple[sp.Symbol, ...]:
    return next(tuple(v.symbols) for v in system.state if str(v) == name)


def _unit(values: float | Sequence[float], n: int) -> list[mpmath.mpf]:
    numbers = _numbers("gamma", values, n)
    length = mpmath.norm(numbers)
    if length == 0:
        raise InputError("gamma: must not be zero, as it is a direction")
    return [x / length for x in numbers]


def _numbers(name: str, values: object, count: int, which: str = "") -> list[mpmath.mpf]:
    listed = list(values) if isinstance(values, Sequence) else []
    numeric = all(not isinstance(x, Sequence) and mpmath.isfinite(x) for x in listed)
    if len(listed) != count or not numeric:
        raise InputError(f"{name}: must be {count} finite numbers{which}")
    return [mpmath.mpf(repr(float(x))) for x in listed]


def _rotation(given: object, n: int) -> Matrix:
    """A matrix of SO(n) next to the one given, which may miss it by rounding."""
    rows = list(given) if isinstance(given, Sequence) else []
    if len(rows) == n * n and not any(isinstance(row, Sequence) for row in rows):
        rows = [rows[i * n : (i + 1) * n] for i in range(n)]
    if len(rows) != n or not all(isinstance(r, Sequence) and len(r) == n for r in rows):
        raise InputError(f"attitude: must be {n} rows of {n} finite numbers")
    matrix = mpmath.matrix([_numbers("attitude", row, n) for row in rows])
    defect = mpmath.mnorm(matrix * matrix.T - mpmath.eye(n), "f")
    if defect > 100 * SLACK:
        near = ""
        if defect < 1:
            nearest = _orthogonal(matrix).tolist()
            written = ", ".join(f"[{', '.join(repr(float(x)) for x in row)}]" for row in nearest)
            near = f"; the nearest rotation is [{written}]"
        raise InputError(f"attitude: its rows must be orthonormal{near}")
    if mpmath.det(matrix) < 0:
        raise InputError("attitude: its determinant must be 1, and it is −1 (a reflection)")
    rotation: Matrix = _orthogonal(matrix).tolist()
    return rotation


def _orthogonal(matrix: mpmath.matrix) -> mpmath.matrix:
    """The orthogonal factor of the polar decomposition, by Newton's method."""
    for _ in range(60):
        following = (matrix + (matrix**-1).T) / 2
        change = mpmath.mnorm(following - matrix, "f")
        matrix = following
        if change < mpmath.mpf(10) ** (5 - DIGITS):
            break
    return matrix
