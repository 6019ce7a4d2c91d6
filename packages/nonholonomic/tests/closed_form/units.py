"""Random motions of every solvable system, told in several systems of units.

A motion is drawn in kg, m and s, in fractions; in other units its numbers are exact multiples.
Closed forms are compared with one integration of 34 digits.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import numpy as np

from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector
from nonholonomic import solve
from nonholonomic.catalogue import from_catalogue
from nonholonomic.starts import initial_state

#: Powers of mass, length and time.
Dimension = tuple[int, int, int]
Triple = tuple[Fraction, Fraction, Fraction]

RATE: Dimension = (0, 0, -1)
MOMENT: Dimension = (1, 2, 0)
MOMENTUM: Dimension = (1, 2, -1)
LENGTH: Dimension = (0, 1, 0)
NONE: Dimension = (0, 0, 0)


@dataclass(frozen=True)
class Units:
    """How many of its units a kilogram, a metre and a second are."""

    name: str
    mass: Fraction
    length: Fraction
    time: Fraction = Fraction(1)

    def factor(self, dimension: Dimension) -> Fraction:
        m, length, t = dimension
        return self.mass**m * self.length**length * self.time**t


SI = Units("kg m s", Fraction(1), Fraction(1))
SMALL = Units("g mm s", Fraction(1000), Fraction(1000))
LARGE = Units("t km s", Fraction(1, 1000), Fraction(1, 1000))
FAST = Units("g mm ms", Fraction(1000), Fraction(1000), Fraction(1000))
SLOW = Units("t km ks", Fraction(1, 1000), Fraction(1, 1000), Fraction(1, 1000))

#: Of parameters by name, and by system and name.
PARAMETERS: dict[str, Dimension] = {
    **{f"{letter}_{i}": MOMENT for letter in "IJ" for i in (1, 2, 3)},
    **{f"{letter}_{i}": LENGTH for letter in "bc" for i in (1, 2, 3)},
    **{"m": (1, 0, 0), "R": LENGTH, "a": LENGTH, "g": (0, 1, -2), "P": (1, 2, -2)},
    **{"K": (0, 0, -2), "k": NONE, "alpha": NONE},
}
#: A field in the reduced time of a point on the sphere: M is a rate there.
OWN: dict[tuple[str, str], Dimension] = {
    ("chaplygin-ball-fedorov", "beta"): (0, 0, -2),
    ("neumann", "c"): (-1, -2, -2),
    ("clebsch", "c"): (-1, -2, -2),
    ("clebsch", "beta"): (-1, -2, 0),
    ("neumann", "M"): RATE,
    ("clebsch", "M"): RATE,
    ("rubber-ball-on-e3", "M"): (4, 8, -1),
}
STATE: dict[str, Dimension] = {
    "omega": RATE,
    "M": MOMENTUM,
    "K": MOMENTUM,
    "place": LENGTH,
    **dict.fromkeys(("gamma", "Gamma", "n", "attitude"), NONE),
}

#: Systems of the catalogue that are solved, with a mark of what is drawn.
SYSTEMS = (
    "chaplygin-ball",
    "chaplygin-ball zero area",
    "chaplygin-ball equal moments",
    "chaplygin-ball-bruns",
    "chaplygin-ball-fedorov",
    "rubber-chaplygin-ball",
    "rubber-chaplygin-ball equal moments",
    "rubber-chaplygin-ball-bruns",
    "veselova",
    "veselova equal moments",
    "veselova-bruns",
    "neumann",
    "clebsch",
    "ball-around-sphere",
    "ball-around-sphere-bruns",
    "rubber-ball-around-sphere",
    "rubber-ball-of-ratio",
    "rubber-ball-on-e3",
    "lagrange-top",
    "rubber-body-of-revolution",
    "rubber-disk",
    "rubber-routh-sphere",
)


@dataclass(frozen=True)
class Motion:
    """A motion in kg, m and s.

    Attributes
    ----------
    system : System
        Not lifted.
    parameters : mapping of str to Fraction
    start : tuple of Fraction
        Lifted where there is a motion in space.
    """

    system: System
    parameters: Mapping[str, Fraction]
    start: tuple[Fraction, ...]

    @property
    def lifted(self) -> System:
        return self.system.lifted() if self.system.reconstruction else self.system

    def told(self, units: Units) -> tuple[tuple[Fraction, ...], dict[str, Fraction]]:
        """Start and parameters in other units."""
        name = self.system.name
        parameters = {
            key: x * units.factor(OWN.get((name, key), PARAMETERS.get(key, NONE)))
            for key, x in self.parameters.items()
        }
        factors = self.factors(units)
        return tuple(x * f for x, f in zip(self.start, factors, strict=True)), parameters

    def factors(self, units: Units) -> list[Fraction]:
        """By what the components of the state are multiplied."""
        found = []
        for item in self.lifted.state:
            count = len(item.symbols) if isinstance(item, Vector) else 1
            dimension = OWN.get((self.system.name, str(item)), STATE.get(str(item), NONE))
            found += [units.factor(dimension)] * count
        return found

    def solved(self, units: Units) -> Any:
        """The closed form, in other units."""
        start, parameters = self.told(units)
        return solve(self.system, start, parameters)

    def states(self, units: Units, times: Sequence[float]) -> Any:
        """States in kg, m and s at times in s, by the closed form in other units.

        They may be those of the reduced state alone, where a curve is degenerate.
        """
        factors = np.array([float(f) for f in self.factors(units)])
        moments = np.array([float(Fraction(str(t)) * units.time) for t in times])
        found = self.solved(units).states(moments)
        return found / factors[: found.shape[1]]

    def integrated(self, times: Sequence[float]) -> Any:
        """The same by integration with 34 digits (rows of mpmath numbers)."""
        with mpmath.workdps(40):
            start = [_long(x) for x in self.start]
            parameters = {key: _long(x) for key, x in self.parameters.items()}
            bare = replace(self.lifted, observables=(), guards=())
            run = integrate(bare, start, [0.0, *times], parameters=parameters, precision="quad")
            return run.states[1:]

    def apart(self, states: Any, others: Any) -> float:
        """The greatest difference of states (n, size), relative to each vector's length.

        Those of the first may be reduced.
        """
        one, other = np.asarray(states, dtype=float), np.asarray(others, dtype=float)
        found, first = 0.0, 0
        for item in self.lifted.state:
            if first == one.shape[1]:
                break
            count = len(item.symbols) if isinstance(item, Vector) else 1
            part = slice(first, first + count)
            size = np.linalg.norm(other[:, part], axis=1)
            if str(item) == "place":
                size = size + float(self.parameters.get("R", 1))
            gap = np.linalg.norm(one[:, part] - other[:, part], axis=1)
            found = max(found, float(np.max(gap / np.where(size == 0, 1.0, size))))
            first += count
        return found


# --- drawing -------------------------------------------------------------------------------


def motion(kind: str, generator: random.Random) -> Motion:
    """A random motion of one of `SYSTEMS`, now and then with a start of a special kind."""
    name, _, mark = kind.partition(" ")
    parameters = _parameters(name, mark, generator)
    system = _system(name)
    gamma, spin = _unit(generator), _vector(generator)
    along = _condition(name, mark, parameters, gamma)
    if along is not None:
        share = _dot(along, spin) / _dot(along, along)
        spin = tuple(x - share * y for x, y in zip(spin, along, strict=True))
    if system.reconstruction is None:
        return Motion(system, parameters, (*spin, *gamma))
    with mpmath.workdps(60):
        omega, up = ([_long(x) for x in v] for v in (spin, gamma))
        state = initial_state(
            system,
            omega,
            up,
            heading=generator.uniform(-3, 3),
            parameters={s: _long(parameters[str(s)]) for s in system.defaults},
        )
    return Motion(system, parameters, tuple(_exact(x) for x in state))


def _long(x: Fraction) -> Any:
    return mpmath.mpf(x.numerator) / x.denominator


@cache
def _system(name: str) -> System:
    return from_catalogue(name)


def _exact(x: Any) -> Fraction:
    sign, mantissa, exponent, _ = x._mpf_
    return Fraction((-1) ** sign * int(mantissa)) * Fraction(2) ** int(exponent)


def _dot(u: Sequence[Fraction], v: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(u, v, strict=True)), Fraction(0))


def _decimal(generator: random.Random, low: float, high: float) -> Fraction:
    return Fraction(round(1000 * generator.uniform(low, high)), 1000)


def _parameters(name: str, mark: str, generator: random.Random) -> dict[str, Fraction]:
    values = {str(s): Fraction(str(x)) for s, x in from_catalogue(name).defaults.items()}
    moments = [Fraction(m, 100) for m in generator.sample(range(100, 195), 3)]
    if mark == "equal moments":
        moments[generator.randrange(3)] = moments[0]
        moments[1] = moments[0]
        generator.shuffle(moments)
    letter = "I" if "I_1" in values else "J"
    lengths = {"R", "a"} & set(values)
    for key, value in list(values.items()):
        if key[:2] in ("I_", "J_"):
            continue
        if key in lengths or key in ("m", "g", "K", "P", "c", "beta", "alpha"):
            values[key] = _decimal(generator, 0.6, 1.4) * value
        elif key[0] == "c":
            values[key] = _decimal(generator, 0.2, 1.4) * value
    if "a" in values:
        # a hollow ball of twice the radius of the sphere
        values["R"] = 2 * values["a"]
    if {"b_1", "b_2"} <= set(values):
        values["b_1"] = values["b_2"] = _decimal(generator, 0.6, 1.0)
        values["b_3"] = _decimal(generator, 0.7, 1.2)
    if name.startswith(("rubber-body", "rubber-disk", "rubber-routh", "lagrange")):
        across = _decimal(generator, 0.3, 0.9)
        values["I_1"], values["I_3"] = across, across * _decimal(generator, 0.4, 1.6)
        if "I_2" in values:
            values["I_2"] = across
        return values
    for i, moment in enumerate(moments, 1):
        values[f"{letter}_{i}"] = moment
    return values


def _unit(generator: random.Random) -> Triple:
    """A unit vector in fractions; now and then along an axis, or in a coordinate plane."""
    special = generator.random()
    if special < 0.1:
        return _placed(generator, [Fraction(0), Fraction(0), Fraction(generator.choice((-1, 1)))])
    p, q = (Fraction(generator.randint(-20, 20), generator.randint(8, 16)) for _ in range(2))
    if special < 0.2:
        q = Fraction(0)
    square = 1 + p * p + q * q
    return _placed(generator, [2 * p / square, 2 * q / square, (square - 2) / square])


def _placed(generator: random.Random, parts: list[Fraction]) -> Triple:
    generator.shuffle(parts)
    first, second, third = parts
    return first, second, third


def _vector(generator: random.Random) -> Triple:
    size = 10 ** generator.uniform(-0.4, 0.4)
    parts = [_decimal(generator, -size, size) for _ in range(3)]
    special = generator.random()
    if special < 0.1:
        parts = [parts[0] or Fraction(1), Fraction(0), Fraction(0)]
    elif special < 0.2:
        parts = [parts[0] or Fraction(1)] * 2 + [parts[2]]
    return _placed(generator, parts)


def _condition(
    name: str, mark: str, values: Mapping[str, Fraction], gamma: Triple
) -> Sequence[Fraction] | None:
    """The coefficients of the linear condition on ω (or on M, where nothing rolls), if any."""
    if name in ("chaplygin-ball", "lagrange-top") and mark != "zero area":
        return None
    if name in ("chaplygin-ball", "chaplygin-ball-bruns"):
        return [values[f"I_{i}"] * n for i, n in enumerate(gamma, 1)]
    if name.startswith("ball-around-sphere"):
        d = values["m"] * values["R"] ** 2
        moments = [values[f"I_{i}"] for i in (1, 2, 3)]
        half = (sum(moments, Fraction(0)) + d) / 2
        lever = [(half - moment) * n for moment, n in zip(moments, gamma, strict=True)]
        # (AM, γ) with M = (I + d)ω − d(ω, γ)γ
        share = d * _dot(lever, gamma)
        return [
            (moment + d) * a - share * n for moment, a, n in zip(moments, lever, gamma, strict=True)
        ]
    return gamma
