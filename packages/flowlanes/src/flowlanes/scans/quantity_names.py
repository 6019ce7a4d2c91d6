"""Quantities of motions, selected by name."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import InputError
from ..flow.devices.graphics import Device
from ..flow.kernel.equations import poincare_section
from ..flow.motion_observable import MotionObservable
from ..formulas.array_evaluation import formula
from ..lyapunov.indicators import (
    exponent_sum,
    fast_lyapunov_indicator,
    maximal_exponent,
    megno,
    smaller_alignment_index,
)
from ..parsing import nearest
from ..system.system import System
from ..system.tolerance import ENSEMBLE_TOLERANCE
from .observables import frequency, maximum, minimum, survival_time, time_average
from .scan_task import Rule
from .section_rotation import Winding
from .system_quantities import meaning


@dataclass(frozen=True)
class NamedQuantity:
    """A quantity computed for every motion.

    Attributes
    ----------
    rule : Rule
    name : str
        The name of its variable in a dataset.
    title, unit : str
        Its description and unit.
    """

    rule: Rule
    name: str
    title: str
    unit: str


_OBSERVABLES: dict[str, MotionObservable[Any]] = {
    item.name: item
    for item in (
        maximal_exponent,
        fast_lyapunov_indicator,
        megno,
        smaller_alignment_index,
        exponent_sum,
        survival_time,
        time_average,
        maximum,
        minimum,
        frequency,
    )
}

#: The name of rotation numbers, which also need a section.
ROTATION = "rotation"


def register(observable: MotionObservable[Any]) -> None:
    """Register an observable under its name.

    Raises
    ------
    InputError
        If another quantity has this name.
    """
    known = _OBSERVABLES.setdefault(observable.name, observable)
    if known != observable or observable.name == ROTATION:
        raise InputError(f"there are two numbers of motions with the name {observable.name!r}")


def observables() -> Mapping[str, MotionObservable[Any]]:
    """All observables by name.

    Observables of a formula are written ``mean:normal_force``. A rotation number also needs a
    section, where a quantity rises through zero: ``rotation:atan2(M_2,M_1) on n_3``.
    """
    return dict(_OBSERVABLES)


def quantity_from_text(
    system: System,
    text: str,
    t_end: float,
    *,
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: Device = "cpu",
    variables: Mapping[str, tuple[str, str]] | None = None,
) -> NamedQuantity:
    """The quantity described by a text, for the motions of a system.

    Parameters
    ----------
    system : System
    text : str
        A name in `observables`, followed by a colon and a formula if it is an observable of a
        formula.
    t_end : float
        Length of the motions.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Where the motions are computed; see :func:`flowlanes.flow.batch.batch_integrator`.
    variables : mapping of str to (str, str), optional
        Meaning and unit of vectors and scalars of the state.

    Raises
    ------
    InputError
        If there is no such quantity, the formula cannot be parsed, or `t_end` is not positive.
    """
    if not 0 < t_end < math.inf:
        raise InputError(f"t_end = {t_end:g}: motions must be followed for a positive, finite time")
    word, colon, quantity = (part.strip() for part in text.partition(":"))
    kind = _OBSERVABLES.get(word)
    if kind is None and word != ROTATION:
        known = nearest(word, (*_OBSERVABLES, ROTATION))
        raise InputError(
            f"{word}: no number has this name{known}; some are written with a formula, as in "
            "mean:FORMULA"
        )
    of_formula = kind is None or kind.of_formula
    if of_formula != bool(quantity) or (colon and not quantity):
        written = f"{word}:FORMULA" if of_formula else word
        raise InputError(f"{text}: this number is written {written}")
    if kind is None:
        return _rotation(system, quantity, t_end, tolerance, device)
    if not kind.of_formula:
        rule = kind(system, t_end, tolerance=tolerance, device=device)
        return NamedQuantity(rule, word, kind.title, kind.unit)
    value = formula(system, quantity)
    measured = meaning(system, quantity, variables or {})[1] or "unknown"
    if kind.require is not None:
        kind.require(system, text, value, measured)
    rule = kind(system, t_end, value, tolerance=tolerance, device=device)
    return NamedQuantity(rule, word, kind.title.format(quantity), kind.unit.format(measured))


def _rotation(
    system: System, text: str, t_end: float, tolerance: float, device: Device
) -> NamedQuantity:
    """A rotation number, from its angle and its section."""
    angle, on, place = text.partition(" on ")
    if not on:
        raise InputError(
            f"rotation:{text}: a section is needed, where a quantity rises through zero, such as "
            f"rotation:{text} on x"
        )
    where = poincare_section(system, place.strip())
    value = formula(system, angle.strip())
    rule = Winding(system, t_end, value, where, tolerance=tolerance, device=device)
    return NamedQuantity(rule, ROTATION, f"rotation number of {text}", "")
