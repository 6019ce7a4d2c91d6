"""The controls of a page for the initial state."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flowlanes.flow.variable_metadata import variable_metadata
from flowlanes.printing.formula import text
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector

from ..experiment.section_coordinates import is_angle
from ..experiment.study import Study
from ..experiment.subjects.initial_state import unit_vectors
from .columns import symbol_mathml
from .page_systems import page_system
from .scene_model import Json
from .slider_range import value_range

#: Start values by ω and γ: meaning, unit.
_OF_BODY = {
    "omega": ("angular velocity, body axes", "rad/s"),
    "gamma": ("normal, body axes", "1"),
    "heading": ("turn about the normal", "rad"),
}


#: Error message for ω that must be horizontal, as in Python, with the relevant numbers among the
#: inputs.
SPINS: dict[str, Json] = {
    "message": "omega: (omega, gamma) = {excess}, and a body that must not spin about the normal "
    "needs 0; the nearest admissible omega is [{nearest}]",
    "among": [0, 1, 2],
}


def start_tables(study: Study, whole: System) -> dict[str, Json]:
    """Tables for the validation of a start by the engine, with error messages."""
    by_velocity = study.subject.starts_by_velocity
    places = {str(symbol): i for i, symbol in enumerate(whole.symbols)}
    directions: list[Json] = [
        {"name": str(name), "places": [places[str(s)] for s in name.symbols]}
        for name in whole.state
        if str(name) in unit_vectors(whole)
    ]
    return {
        "singular": "start: the equations are singular at this state",
        "directions": directions,
        "relation_texts": [text(relation) for relation in whole.relations],
        "start_messages": [
            f"gamma: this start is outside the domain; {guard.message}"
            if by_velocity and not guard.lift_off
            else f"there is no motion from here: {guard.message}; "
            'on_liftoff = "warn" in [run] follows it as if the surface held the body'
            for guard in page_system(study).guards
        ],
    }


def start_inputs(study: Study) -> list[Json]:
    """The inputs of the initial state: ω and γ of a body, otherwise the whole state.

    The components of one vector share their range. For a body with an implicit shape, whose contact
    point is not a formula in γ, it is the whole state.
    """
    if not study.subject.starts_by_velocity or Vector("r") in study.system.state:
        return _state_inputs(study)
    rows: list[Json] = []
    for name, value in study.start_values.items():
        vector = [float(x) for x in value] if isinstance(value, Sequence) else [float(value)]
        meaning, unit = _OF_BODY.get(name, ("motion of the fluid, body axes", "rad/s"))
        low, high = (-1.0, 1.0) if name == "gamma" else value_range(max(map(abs, vector)))
        rows += [
            _row(f"{name}_{i}", x, (low, high), meaning, unit) for i, x in enumerate(vector, 1)
        ]
    heading = float(getattr(study.subject, "heading", 0.0))
    rows.append(_row("heading", heading, (-np.pi, np.pi), *_OF_BODY["heading"]))
    return rows


def _state_inputs(study: Study) -> list[Json]:
    whole = study.system.lifted() if study.system.reconstruction else study.system
    numbers = [float(x) for x in study.start]
    rows: list[Json] = []
    for variable, place in whole.slices:
        symbols, vector = whole.symbols[place], numbers[place]
        meaning, unit, _, _ = variable_metadata(
            whole, str(variable), len(symbols), study.variables.get(str(variable))
        )
        span = value_range(max(map(abs, vector)))
        if len(symbols) == 1 and is_angle(whole, symbols[0]):
            span = (-np.pi, np.pi)
        rows += [
            _row(str(symbol), x, span, meaning, unit or "1")
            for symbol, x in zip(symbols, vector, strict=True)
        ]
    return rows


def _row(
    name: str, value: float, span: tuple[float, float], meaning: str, unit: str
) -> dict[str, Json]:
    return {
        "name": name,
        "mathml": symbol_mathml(name),
        "unit": unit,
        "meaning": meaning,
        "value": value,
        "low": min(span[0], value),
        "high": max(span[1], value),
    }
