"""Starts of n-dimensional bodies: attitude and angular velocity, as numbers of 50 digits."""

from __future__ import annotations

from collections.abc import MutableMapping, Sequence
from typing import TypeAlias

import mpmath
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.system import System

from ...mechanics.rolling.initial_state import SLACK, evaluate
from ...mechanics.rotations import Matrix, finite_numbers, rotation_near, upright_matrix
from ..catalogue_entry import Family
from .inertia import labels, pairs
from .motion_in_space import omega_of

#: A start as given, by name.
StartValues: TypeAlias = MutableMapping[str, float | Sequence[float]]

#: Names of a start that are not variables of the reduced state.
ATTITUDE, OMEGA, GAMMA, CONTACT = "attitude", "omega", "gamma", "contact"


def take_attitude(values: StartValues, n: int, family: Family) -> tuple[Matrix, list[mpmath.mpf]]:
    """Take attitude and γ out of a start: as given, or the shortest turn of γ to the last axis.

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
        return upright_matrix(gamma), gamma
    attitude = rotation_near(given, n)
    if gamma is None:
        return attitude, attitude[-1]
    if family.upright and max(abs(x - y) for x, y in zip(gamma, attitude[-1], strict=True)) > SLACK:
        raise InputError("gamma: must be the last row of the attitude; one of them may be left out")
    return attitude, attitude[-1] if family.upright else gamma


def take_contact(values: StartValues, n: int) -> list[mpmath.mpf]:
    """Take the contact point out of a start; the origin where it is left out."""
    return finite_numbers(CONTACT, values.pop(CONTACT, [0.0] * (n - 1)), n - 1)


def take_spin(values: StartValues, gamma: Sequence[mpmath.mpf], family: Family) -> Matrix | None:
    """Take ω out of a start, as a skew matrix; None where it is not given.

    Raises
    ------
    InputError
        If the constraint does not admit it; the message then names the nearest one.
    """
    components = values.pop(OMEGA, None)
    if components is None:
        return None
    n = len(gamma)
    names = labels(n)
    numbers = finite_numbers(OMEGA, components, len(names), f" ({', '.join(names)})")
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
    if not system.conventions.start_formulas:
        names = ", ".join(map(str, system.state))
        raise InputError(f"omega: does not determine this state; give {names}")
    n = len(gamma)
    known = {s: mpmath.mpf(repr(float(x))) for s, x in system.defaults.items()}
    known |= dict(zip(_symbols(system, GAMMA), gamma, strict=True))
    entries = (omega[i][j] for i, j in pairs(n))
    known |= dict(zip(omega_of(n).symbols, entries, strict=True))
    following = flat_pairs(system.conventions.start_formulas)
    numbers = evaluate(system, [value for _, value in following], known)
    known |= dict(zip((s for s, _ in following), numbers, strict=True))
    return [known[s] for s in system.symbols]


def _symbols(system: System, name: str) -> tuple[sp.Symbol, ...]:
    return next(tuple(v.symbols) for v in system.state if str(v) == name)


def _unit(values: float | Sequence[float], n: int) -> list[mpmath.mpf]:
    numbers = finite_numbers("gamma", values, n)
    length = mpmath.norm(numbers)
    if length == 0:
        raise InputError("gamma: must not be zero, as it is a direction")
    return [x / length for x in numbers]
