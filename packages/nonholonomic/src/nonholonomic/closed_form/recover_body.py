"""Recover a rolling body from its equations of motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

import sympy as sp

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Symmetric

from ..catalogue import CATALOGUE
from ..mechanics.rolling.body import Body
from ..mechanics.rolling.equations import ContactModel, Forces, RollingBody
from ..mechanics.shapes.shapes import Ball
from ..mechanics.shapes.surfaces import Plane, Sphere, Surface
from .base.problem import same_field

MODELS: tuple[ContactModel, ContactModel] = ("marble", "rubber")


def rolling_of(system: System, values: Mapping[sp.Symbol, NumberOrText]) -> RollingBody | None:
    """The rolling body whose equations a system holds, with its numbers.

    Bodies of the catalogue and balls with any inertia tensor are tried; their equations and numbers
    must be those of the system; equations are compared as formulas or in rational numbers at random
    points.

    Parameters
    ----------
    values : mapping of Symbol to number
        Its parameters.
    """
    numbers = {str(symbol): float(value) for symbol, value in values.items()}
    if "m" not in numbers:
        # Every rolling body has a mass.
        return None
    for rolling in _candidates(numbers):
        try:
            system_of_body = rolling.system()
        except InputError:
            # The body and the surface do not fit together.
            continue
        own = {str(symbol): float(value) for symbol, value in system_of_body.defaults.items()}
        if own == numbers and _have_same_field(system_of_body, system, values):
            return rolling
    return None


def _have_same_field(
    first: System, second: System, values: Mapping[sp.Symbol, NumberOrText]
) -> bool:
    """Whether two systems with the same parameters have the same field, in any notation."""
    if (first.field, first.definitions) == (second.field, second.definitions):
        return True
    exactly = {symbol: exact(value) for symbol, value in values.items()}
    return first.state == second.state and same_field(second, exactly, first, exactly)


def _candidates(numbers: Mapping[str, float]) -> Iterator[RollingBody]:
    """Rolling bodies described by these parameters, or by some of them."""
    entries = [entry for entry in CATALOGUE.values() if set(entry.defaults) <= set(numbers)]
    # A body of revolution has one moment for two axes, and no off-axis centre of mass.
    for entry in sorted(entries, key=lambda entry: -len(entry.defaults)):
        try:
            rolling = entry.rolling({name: numbers[name] for name in entry.defaults})
        except InputError:
            continue
        if rolling is not None:
            yield rolling
    yield from _balls(numbers)


def _balls(numbers: Mapping[str, float]) -> Iterator[RollingBody]:
    """Balanced balls with these parameters."""
    entries = [str(s) for s in Symmetric("I").symbols]
    moments = [str(s) for s in Diagonal("I").symbols]
    tensor = entries if entries[0] in numbers else moments
    if not {"m", "R", *tensor} <= set(numbers) <= {"m", "R", "a", "g", *tensor}:
        return
    inertia: Any = [numbers[name] for name in tensor]
    if tensor is entries:
        x, xy, xz, y, yz, z = inertia
        inertia = ((x, xy, xz), (xy, y, yz), (xz, yz, z))
    surface: Surface = Sphere.of_signed_radius(numbers["a"]) if "a" in numbers else Plane()
    field = Forces(numbers.get("g", 0.0))
    for hollow, model in product((False, True), MODELS):
        body = Body(numbers["m"], inertia, Ball(numbers["R"], hollow))
        yield RollingBody(body, surface, model, field)
