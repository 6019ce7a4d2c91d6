"""From a dimension and numbers, as a user gives them, to a system of that dimension."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence, Sized
from dataclasses import dataclass
from typing import Any

from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.system.parameters import require_parameters
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol

from ..catalogue_entry import Entry, Numbers, Start, Values
from ..entry_files import entry_file
from .inertia import (
    LARGEST,
    SMALLEST,
    Inertia,
    MassTensor,
    Moments,
    checked_mass_tensor,
    checked_moments,
    generic_mass_tensor,
    generic_moments,
    pairs,
)

m, R = real_symbol("m"), real_symbol("R")
D = m * R**2
SOURCE = "§12, problem 3"
MOMENTUM, SQUARE = "kg m^2/s", "kg^2 m^4/s^2"
DEFAULT_DIMENSION = 4

Settings = Mapping[str, object]


@dataclass(frozen=True, kw_only=True)
class Family(ABC):
    """A system for every dimension n from 3 to 9, and every operator of inertia.

    Attributes
    ----------
    name : str
    rolls : bool
        Whether it is a ball with a mass and a radius.
    tensor_by_default : bool
        Whether its example has a mass tensor and not moments.
    """

    name: str
    rolls: bool = False
    tensor_by_default: bool = False

    @property
    def title(self) -> str:
        """The title without the number of dimensions."""
        return entry_file(self.name).title

    @property
    def summary(self) -> str:
        """A description of the moving body."""
        return entry_file(self.name).summary

    @property
    def upright(self) -> bool:
        """Whether γ is the last row of the attitude: fixed in space."""
        return True

    @abstractmethod
    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The system with this inertia; `parameters` are the further ones of a ball."""

    @property
    def constraint(self) -> str:
        """The condition on ω, as a sentence; empty where it is free."""
        return ""

    def admissible(self, omega: Sequence[Sequence[Any]], gamma: Sequence[Any]) -> list[list[Any]]:
        """The nearest ω that the constraint admits, as a skew matrix."""
        return [list(row) for row in omega]

    @property
    def settings(self) -> tuple[str, ...]:
        """The settings besides those of a ball."""
        return ("dimension", "moments", "mass_tensor")

    @abstractmethod
    def start(self, dimension: int) -> Values:
        """A state worth starting from, by name."""

    @abstractmethod
    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""

    def entry(self, parameters: Settings | None = None) -> Entry:
        """The entry of the catalogue for a dimension and numbers.

        Parameters
        ----------
        parameters : mapping
            ``dimension``; ``moments`` or ``mass_tensor``, or their entries by symbol name; of a
            ball ``mass`` and ``radius``, or ``m`` and ``R``.

        Raises
        ------
        InputError
            If a name is unknown, or a number is not admissible.
        """
        settings = dict(parameters or {})
        inertia, numbers = self._inertia(settings)
        numbers |= self._ball(settings)
        n = inertia.dimension
        if settings:
            known = [*self.settings, *(["mass", "radius"] if self.rolls else [])]
            require_parameters(self.name, [*known, *numbers], settings)

        def build(values: Numbers) -> System:
            return self._system(type(inertia)(n, values), values)

        return Entry(
            name=self.name,
            title=self.title,
            summary=f"{self.summary} {inertia.words}",
            source=SOURCE,
            defaults=numbers,
            build=build,
            start=Start(state=self.start(n), until=60.0),
            variables=self.variables(),
            family=self,
            dimension=n,
        )

    def _system(self, inertia: Inertia, values: Numbers) -> System:
        return self.equations(inertia, self._ball_parameters(values) if self.rolls else ())

    def _ball_parameters(self, values: Numbers) -> tuple[Parameter, ...]:
        return (
            Parameter(m, "mass", values["m"], "kg", (m > 0,)),
            Parameter(R, "radius of the ball", values["R"], "m", (R > 0,)),
        )

    def _inertia(self, settings: dict[str, object]) -> tuple[Inertia, dict[str, float]]:
        """Take dimension and inertia out of the settings."""
        entries = {
            name: _number(name, settings.pop(name))
            for name in list(settings)
            if re.fullmatch(r"[IJ]_[1-9][1-9]", name)
        }
        moments, tensor = settings.pop("moments", None), settings.pop("mass_tensor", None)
        given = [
            name
            for name, value in (("moments", moments), ("mass_tensor", tensor))
            if value is not None
        ]
        letters = {name[0] for name in entries}
        if len(given) + len(letters - {{"moments": "I", "mass_tensor": "J"}[g] for g in given}) > 1:
            raise InputError("moments and mass_tensor are two ways to give the inertia; give one")
        by_tensor = tensor is not None or "J" in letters
        if not given and not letters:
            by_tensor = self.tensor_by_default
        n = self._dimension(settings.pop("dimension", None), moments=moments, mass_tensor=tensor)
        if by_tensor:
            rows = generic_mass_tensor(n) if tensor is None else _rows(tensor)
            numbers = checked_mass_tensor(n, rows)
        else:
            values = generic_moments(n) if moments is None else numbers_of("moments", moments)
            numbers = checked_moments(n, values)
        for name, value in entries.items():
            require_parameters(self.name, numbers, [name])
            numbers[name] = value
        if entries and by_tensor:
            full = [
                [numbers[f"J_{min(i, j)}{max(i, j)}"] for j in range(1, n + 1)]
                for i in range(1, n + 1)
            ]
            numbers = checked_mass_tensor(n, full)
        elif entries:
            numbers = checked_moments(n, list(numbers.values()))
        kind = MassTensor if by_tensor else Moments
        return kind(n, numbers), numbers

    def _dimension(self, dimension: object, **lists: object) -> int:
        """The dimension as given, or by the number of moments, rows or factors."""
        if dimension is None:
            for name, values in lists.items():
                if not isinstance(values, Sized) or isinstance(values, str):
                    continue
                dimensions = range(SMALLEST, LARGEST + 1)
                sizes = {len(pairs(n)) if name == "moments" else n: n for n in dimensions}
                if len(values) not in sizes:
                    what = "rows" if name == "mass_tensor" else "numbers"
                    raise InputError(
                        f"{name}: {len(values)} {what} belong to no dimension from {SMALLEST} to "
                        f"{LARGEST}; these have {', '.join(map(str, sizes))}"
                    )
                return sizes[len(values)]
            return DEFAULT_DIMENSION
        if (
            isinstance(dimension, bool)
            or not isinstance(dimension, int | float)
            or not (isinstance(dimension, int) or dimension.is_integer())
        ):
            count = 0
        else:
            count = int(dimension)
        if not SMALLEST <= count <= LARGEST:
            shown = list(dimension) if isinstance(dimension, tuple) else dimension
            raise InputError(
                f"dimension: must be a whole number from {SMALLEST} to {LARGEST}, not {shown}"
            )
        return count

    def _ball(self, settings: dict[str, object]) -> dict[str, float]:
        if not self.rolls:
            return {}
        numbers = {}
        for symbol, word in (("m", "mass"), ("R", "radius")):
            values = [settings.pop(name) for name in (symbol, word) if name in settings]
            if len(values) > 1:
                raise InputError(f"{word} and {symbol} are the same number; give one")
            number = _number(word, values[0]) if values else 1.0
            if not 0 < number < float("inf"):
                raise InputError(f"{word} {number}: it must be a positive finite number")
            numbers[symbol] = number
        return numbers


def _number(name: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        try:
            return float(value)  # type: ignore[arg-type]
        except (TypeError, ValueError):
            raise InputError(f"{name}: must be a number, not {value!r}") from None
    return float(value)


def numbers_of(name: str, value: object) -> list[float]:
    """Numbers in brackets, or an InputError that names them."""
    if isinstance(value, str) or not hasattr(value, "__iter__"):
        raise InputError(f"{name}: must be numbers in brackets, not {value!r}")
    return [_number(name, x) for x in value]


def _rows(value: object) -> list[list[float]]:
    if isinstance(value, str) or not hasattr(value, "__iter__"):
        raise InputError(f"mass_tensor: must be rows of numbers in brackets, not {value!r}")
    return [numbers_of("mass_tensor", row) for row in value]


# --- starts --------------------------------------------------------------------------------


def cycle(numbers: Sequence[float], count: int) -> tuple[float, ...]:
    """As many numbers as needed, from the beginning again where they end."""
    return tuple(numbers[i % len(numbers)] for i in range(count))


def direction(dimension: int) -> tuple[float, ...]:
    """A unit vector γ that is no body axis."""
    numbers = [exact(x) for x in cycle((0.2, -0.4, 0.8, -0.4), dimension)]
    square = sum(x * x for x in numbers)
    # a length of 1 leaves the decimals as they are
    length = 1 if square == 1 else float(square) ** 0.5
    return tuple(float(x / length) for x in numbers)


def across(numbers: Sequence[float], gamma: Sequence[float]) -> tuple[float, ...]:
    """The part of a vector orthogonal to the unit vector γ; of decimals an exact decimal."""
    vector, normal = [exact(x) for x in numbers], [exact(y) for y in gamma]
    along = sum(x * y for x, y in zip(vector, normal, strict=True))
    return tuple(float(x - along * y) for x, y in zip(vector, normal, strict=True))


def momentum_and_direction(rolls: bool) -> Mapping[str, tuple[str, str]]:
    """Meaning and unit of p and γ; γ is the normal of a hyperplane on which a ball rolls."""
    fixed = "normal of the hyperplane" if rolls else "direction fixed in space"
    return {
        "p": ("momentum in planes through γ", MOMENTUM),
        "gamma": (f"{fixed}, body axes", "1"),
    }


@dataclass(frozen=True, kw_only=True)
class WithoutTwist(Family):
    """A family of systems whose ω lies in planes through γ."""

    @property
    def constraint(self) -> str:
        """The condition on ω."""
        return "it must turn in planes through gamma alone, omega = u gamma^T - gamma u^T"

    def admissible(self, omega: Sequence[Sequence[Any]], gamma: Sequence[Any]) -> list[list[Any]]:
        """(ωγ) ∧ γ."""
        u = [sum(x * y for x, y in zip(row, gamma, strict=True)) for row in omega]
        return [
            [a * y - x * b for b, y in zip(u, gamma, strict=True)]
            for a, x in zip(u, gamma, strict=True)
        ]
