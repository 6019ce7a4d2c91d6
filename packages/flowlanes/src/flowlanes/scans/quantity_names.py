"""Quantities of motions by the names with which a user asks for them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import InputError
from ..flow.devices.graphics import Device
from ..flow.kernel.equations import poincare_section
from ..formulas.array_evaluation import formula
from ..lyapunov.indicators import (
    ExponentSum,
    FastLyapunovIndicator,
    MaximalExponent,
    Megno,
    SmallerAlignmentIndex,
)
from ..parsing import nearest
from ..system.system import System
from .grid import directions
from .observables import Frequency, Maximum, Minimum, SurvivalTime, TimeAverage
from .scan_task import Rule
from .section_rotation import Winding
from .system_quantities import meaning


@dataclass(frozen=True)
class NamedQuantity:
    """A number that was asked for.

    Attributes
    ----------
    rule : Rule
    name : str
        The name of its variable.
    title, unit : str
        Its meaning in words, and its unit.
    """

    rule: Rule
    name: str
    title: str
    unit: str


@dataclass(frozen=True)
class _Kind:
    """A kind of number: its class, title and unit."""

    make: Callable[..., Rule]
    title: str
    unit: str = ""
    of: bool = False


KINDS: Mapping[str, _Kind] = {
    "lyapunov": _Kind(MaximalExponent, "largest Lyapunov exponent", "1/s"),
    "fli": _Kind(FastLyapunovIndicator, "fast Lyapunov indicator"),
    "megno": _Kind(Megno, "MEGNO"),
    "sali": _Kind(SmallerAlignmentIndex, "logarithm of SALI"),
    "sum": _Kind(ExponentSum, "sum of Lyapunov exponents", "1/s"),
    "duration": _Kind(SurvivalTime, "time until the motion ends", "s"),
    "mean": _Kind(TimeAverage, "mean of {}", "{}", of=True),
    "highest": _Kind(Maximum, "highest value of {}", "{}", of=True),
    "lowest": _Kind(Minimum, "lowest value of {}", "{}", of=True),
    "frequency": _Kind(Frequency, "frequency of {}", "1/s", of=True),
    "rotation": _Kind(Winding, "rotation number of {}", of=True),
}
"""Names of quantities; those with a formula are written ``mean:normal_force``.

A rotation number needs a section as well, where a quantity rises through zero:
``rotation:atan2(M_2,M_1) on n_3``.
"""


def quantity_from_text(
    system: System,
    text: str,
    until: float,
    *,
    tolerance: float = 1e-12,
    device: Device = "cpu",
    variables: Mapping[str, tuple[str, str]] | None = None,
) -> NamedQuantity:
    """A number of the motions of a system.

    Parameters
    ----------
    system : System
    text : str
        A word of `KINDS`, followed by a colon and a formula where it is a number of a formula.
    until : float
        Length of the motions.
    tolerance : float
        Error allowed in a step.
    device : "cpu" or "gpu"
        Where the motions are computed; see :func:`flowlanes.flow.batch.batch_integrator`.
    variables : mapping of str to (str, str), optional
        Meaning and unit of vectors and scalars of the state.

    Raises
    ------
    InputError
        If there is no such number, the formula cannot be read, or `until` is not positive.
    """
    if not 0 < until < math.inf:
        raise InputError(f"until = {until:g}: motions must be followed for a positive, finite time")
    word, colon, quantity = (part.strip() for part in text.partition(":"))
    kind = KINDS.get(word)
    if kind is None:
        raise InputError(
            f"{word}: no number has this name{nearest(word, KINDS)}; some are written with a "
            "formula, as in mean:FORMULA"
        )
    if kind.of != bool(quantity) or (colon and not quantity):
        written = f"{word}:FORMULA" if kind.of else word
        raise InputError(f"{text}: this number is written {written}")
    if kind.make is Winding:
        return _rotation(kind, system, quantity, until, tolerance, device)
    if not kind.of:
        return NamedQuantity(
            kind.make(system, until, tolerance=tolerance, device=device),
            word,
            kind.title,
            kind.unit,
        )
    value: Any = formula(system, quantity)
    rule = kind.make(system, until, value, tolerance=tolerance, device=device)
    measured = meaning(system, quantity, variables or {})[1] or "unknown"
    if kind.make is Frequency:
        _require_angle(system, text, value, measured)
    unit = kind.unit.format(measured)
    return NamedQuantity(rule, word, kind.title.format(quantity), unit)


def _require_angle(system: System, text: str, value: Any, unit: str) -> None:
    """Raise InputError where a formula is known to be no angle."""
    varying = value.free_symbols - set(system.defaults)
    if unit not in ("rad", "1", "unknown"):
        wrong = f"it is measured in {unit}"
    elif varying <= directions(system) and value.is_polynomial(*varying):
        wrong = "it stays within bounds and makes no turns"
    else:
        return
    raise InputError(f"{text}: {wrong}; an angle is needed, such as atan2(gamma_2, gamma_1)")


def _rotation(
    kind: _Kind, system: System, text: str, until: float, tolerance: float, device: Device
) -> NamedQuantity:
    """A rotation number, from its angle and its section."""
    angle, on, place = text.partition(" on ")
    if not on:
        raise InputError(
            f"rotation:{text}: a section is needed, where a quantity rises through zero, such as "
            f"rotation:{text} on gamma_3"
        )
    where = poincare_section(system, place.strip())
    rule = kind.make(
        system, until, formula(system, angle.strip()), where, tolerance=tolerance, device=device
    )
    return NamedQuantity(rule, "rotation", kind.title.format(text), kind.unit)
