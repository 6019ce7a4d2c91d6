"""Starts of n-dimensional bodies: an attitude and an angular velocity, or the state itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import mpmath

from ..catalogue import Entry
from ..catalogue.so_n.inertia import labels, pairs
from ..core.system import System, flat_pairs
from ..errors import InputError
from ..mechanics.rolling.initial_state import DIGITS, SLACK, evaluate
from .initial_state import StartValues, initial_state_from_values
from .subject import Subject

Matrix: TypeAlias = list[list[mpmath.mpf]]

#: Names of a start that are not variables of the state.
ATTITUDE, OMEGA, GAMMA, CONTACT = "attitude", "omega", "gamma", "contact"


@dataclass(frozen=True, kw_only=True)
class NDimensionalSubject(Subject):
    """A body of n dimensions, whose start gives attitude and ω, or γ and ω, or its state.

    Attributes
    ----------
    item : Entry
        The entry of its dimension.
    """

    item: Entry

    @property
    def directions(self) -> set[str]:
        """γ alone."""
        return {GAMMA}

    @property
    def legend(self) -> str:
        """The meaning of the letters of its equations."""
        words = "ω angular velocity, γ̇ = −ωγ; u = ωγ"
        return f"{super().legend} Body axes: {words}."

    @property
    def recorded_names(self) -> list[str]:
        """The angular velocity."""
        return [OMEGA]

    def initial_state(self) -> tuple[mpmath.mpf, ...]:
        """The state that follows from attitude and ω, on the phase space.

        Raises
        ------
        InputError
            If a shape is wrong, the attitude is no rotation, or ω breaks the constraint; the
            message then names the nearest admissible ω.
        """
        values = dict(self.start_values)
        with mpmath.workdps(DIGITS):
            attitude = self._attitude(values)
            spin = self._spin(values, attitude[-1])
            reduced, n = len(self.system.symbols), len(attitude)
            known = {s: mpmath.mpf(repr(float(x))) for s, x in self.system.defaults.items()}
            known |= dict(zip(self._gamma_symbols, attitude[-1], strict=True))
            contact = values.pop(CONTACT, [0.0] * (n - 1))
            if not isinstance(contact, Sequence) or len(contact) != n - 1:
                raise InputError(f"contact: must be {n - 1} finite numbers")
            if spin is None:
                state = initial_state_from_values(
                    _reduced(self), {**values, GAMMA: [float(x) for x in attitude[-1]]}
                )
            else:
                if not self.system.start:
                    names = ", ".join(str(v) for v in self.system.state)
                    raise InputError(f"omega: does not determine this state; give {names}")
                unknown = sorted(values)
                if unknown:
                    raise InputError(
                        f"{unknown[0]}: follows from omega; give either omega or the momentum"
                    )
                symbols = [self._omega(i, j) for i, j in pairs(n)]
                known |= dict(zip(symbols, (spin[i][j] for i, j in pairs(n)), strict=True))
                follow = flat_pairs(self.system.start)
                numbers = evaluate(self.system, [value for _, value in follow], known)
                known |= dict(zip((s for s, _ in follow), numbers, strict=True))
                state = tuple(known[s] for s in self.system.symbols)
            whole = [*state[:reduced], *(x for row in attitude for x in row)]
            size = len(self.system.lifted().symbols)
            whole += [mpmath.mpf(repr(float(x))) for x in contact][: size - len(whole)]
            return tuple(whole)

    @property
    def _gamma_symbols(self) -> Sequence[object]:
        return next(name.symbols for name in self.system.state if str(name) == GAMMA)

    def _omega(self, i: int, j: int) -> object:
        name = f"{OMEGA}_{i + 1}{j + 1}"
        return next(s for s, _ in self.system.scalar_definitions if str(s) == name)

    def _attitude(self, values: dict[str, float | Sequence[float]]) -> Matrix:
        """The attitude as given, or the one that turns γ upward along the shortest way."""
        n = len(list(self._gamma_symbols))
        given = values.pop(ATTITUDE, None)
        direction = values.pop(GAMMA, None)
        gamma = None if direction is None else _unit(direction, n)
        if given is None:
            if gamma is None:
                raise InputError("start: gamma or attitude is missing")
            return _upright(gamma)
        attitude = _rotation(given, n)
        if (
            gamma is not None
            and max(abs(x - y) for x, y in zip(gamma, attitude[-1], strict=True)) > SLACK
        ):
            raise InputError(
                "gamma: must be the last row of the attitude; one of them may be left out"
            )
        return attitude

    def _spin(
        self, values: dict[str, float | Sequence[float]], gamma: Sequence[mpmath.mpf]
    ) -> Matrix | None:
        """ω as a skew matrix that the constraint admits; None where it is not given."""
        given = values.pop(OMEGA, None)
        if given is None:
            return None
        n = len(gamma)
        names = labels(n)
        if not isinstance(given, Sequence) or len(given) != len(names):
            raise InputError(f"omega: must be {len(names)} finite numbers ({', '.join(names)})")
        omega: Matrix = mpmath.zeros(n).tolist()
        for (i, j), x in zip(pairs(n), given, strict=True):
            if isinstance(x, Sequence) or not mpmath.isfinite(x):
                raise InputError(f"omega: must be {len(names)} finite numbers ({', '.join(names)})")
            omega[i][j] = mpmath.mpf(repr(float(x)))
            omega[j][i] = -omega[i][j]
        if self.item.family is None:
            return omega
        nearest: Matrix = self.item.family.admissible(omega, gamma)
        size = max(abs(x) for row in omega for x in row)
        excess = max(abs(omega[i][j] - nearest[i][j]) for i, j in pairs(n))
        if excess > SLACK * size:
            shown = ", ".join(repr(float(nearest[i][j])) for i, j in pairs(n))
            raise InputError(
                f"omega: {self.item.family.constraint}; the nearest admissible omega is [{shown}]"
            )
        return nearest


def start_with_defaults(item: Entry, start: StartValues) -> StartValues:
    """A start, what it leaves out filled in from the example of the catalogue."""
    values = dict(item.start.values)
    if OMEGA in start:
        values = {GAMMA: values[GAMMA]}
    if ATTITUDE in start:
        values.pop(GAMMA)
    return {**values, **start}


def _reduced(subject: Subject) -> System:
    """The system without its motion in space."""
    return replace(subject.system, reconstruction=None)


def _unit(values: float | Sequence[float], n: int) -> list[mpmath.mpf]:
    numbers = _numbers("gamma", values, n)
    length = mpmath.norm(numbers)
    if length == 0:
        raise InputError("gamma: must not be zero, as it is a direction")
    return [x / length for x in numbers]


def _numbers(name: str, values: object, count: int) -> list[mpmath.mpf]:
    listed = list(values) if isinstance(values, Sequence) else []
    numeric = all(not isinstance(x, Sequence) and mpmath.isfinite(x) for x in listed)
    if len(listed) != count or not numeric:
        raise InputError(f"{name}: must be {count} finite numbers")
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


def _upright(gamma: Sequence[mpmath.mpf]) -> Matrix:
    """The shortest turn of γ (body) to the last axis of space."""
    n, last = len(gamma), gamma[-1]
    if 1 + last < mpmath.mpf(10) ** -20:
        # opposite: a half turn in the plane of the first and the last axis
        flipped = mpmath.diag([-1, *([1] * (n - 2)), -1])
        return list(flipped.tolist())
    total = mpmath.matrix([*gamma[:-1], last + 1])
    up = mpmath.matrix([0] * (n - 1) + [1])
    turn = mpmath.eye(n) - total * total.T / (1 + last) + 2 * up * mpmath.matrix(list(gamma)).T
    return list(turn.tolist())
