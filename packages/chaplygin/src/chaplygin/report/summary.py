"""A trajectory in a few lines: method, conserved quantities, events."""

from __future__ import annotations

import math
from typing import Any, SupportsFloat

import numpy as np

from flowlanes.flow.motion_dataset import Samples
from flowlanes.flow.trajectory import NO_VALUE, TOO_LARGE, Trajectory
from flowlanes.printing.numerals import number
from flowlanes.system.system import System


def drift(values: Samples) -> float:
    """Largest |F(t) − F(0)|, relative to |F(0)|; absolute if F(0) = 0."""
    with np.errstate(invalid="ignore"):
        change = max(abs(float(v - values[0])) for v in values)
    size = abs(float(values[0]))
    return change / size if size else change


def summary(trajectory: Trajectory) -> dict[str, Any]:
    """The facts of a run as JSON-compatible data; 34-digit numbers are strings."""
    system, statistics = trajectory.system, trajectory.statistics
    return {
        "system": system.name,
        "time": _plain(trajectory.times[-1]),
        "final": {
            str(s): _plain(x) for s, x in zip(system.symbols, trajectory.states[-1], strict=True)
        },
        "drift": {law.name: _drift_or_none(trajectory, law.name) for law in system.integrals},
        "events": [
            {"time": h.time, "what": h.guard.message, "stopped": h.is_terminal}
            for h in trajectory.events
        ],
        "warnings": list(trajectory.warnings),
        "steps": statistics.steps,
        "order": statistics.order,
        "seconds": statistics.seconds,
    }


def drift_text(trajectory: Trajectory, law: str) -> str:
    """The drift as text, or a statement that there is none."""
    value = _drift_or_none(trajectory, law)
    return _words_of_none(trajectory, law) if value is None else number(value, 2)


def _words_of_none(trajectory: Trajectory, law: str) -> str:
    """The reason why a quantity has no drift."""
    return TOO_LARGE if f"law_{law}" in trajectory.overflows else NO_VALUE


def _drift_or_none(trajectory: Trajectory, law: str) -> float | None:
    """A drift; None for a quantity without a value, such as 0/0 at rest or above 1.8e308."""
    if f"law_{law}" in trajectory.overflows:
        return None
    value = drift(trajectory.records[f"law_{law}"])
    return None if math.isnan(value) else value


def _plain(number: SupportsFloat) -> float | str:
    return float(number) if isinstance(number, (float, np.floating)) else str(number)


def summary_text(system: System, trajectory: Trajectory, facts: dict[str, Any]) -> str:
    """The facts of a run as lines of text."""
    lines = [
        f"{system.title}: t = {trajectory.times[0]} … {facts['time']}, {facts['steps']} "
        f"steps of order {facts['order']} in {facts['seconds']:.3g} s"
    ]
    laws = {law.name: law for law in trajectory.system.integrals}
    for name, value in facts["drift"].items():
        source = f", {laws[name].source}" if laws[name].source else ""
        none = _words_of_none(trajectory, name)
        words = none if value is None else f"drift {value:.1e}"
        lines.append(f"  {laws[name].meaning}{source}: {words}")
    lines += [f"  {event}" for event in trajectory.events]
    lines += [f"  warning: {warning}" for warning in trajectory.warnings]
    return "\n".join(lines)
