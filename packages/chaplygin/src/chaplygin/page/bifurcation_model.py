"""The bifurcation diagram of a page, if the system has one."""

from __future__ import annotations

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.system import System
from nonholonomic.closed_form.bifurcation.layout import heights, window

from ..experiment.closed_form import diagram_if_known
from ..experiment.study import Study
from .scene_model import Json

#: Number of states at which an axis of a diagram is compared with the integrals of the system.
_STATES = 5
_SAME = 1e-9


def bifurcation_model(study: Study, system: System) -> Json:
    """The boundaries of the diagram in terms of two integrals; None if there is none.

    Parameters
    ----------
    study : Study
    system : System
        The reduced system.
    """
    known = diagram_if_known(study)
    if known is None:
        return None
    diagram, mark = known
    names = [_integral_of(system, sp.sympify(axis.value)) for axis in diagram.axes]
    if None in names:
        return None
    frame = window(diagram, mark)
    lines = heights(diagram, frame)
    slope, offset = float(frame.slope), float(frame.offset)
    curves: list[Json] = []
    for boundary in diagram.boundaries:
        circles = "1 circle" if boundary.circles == 1 else f"{boundary.circles} circles"
        fate = "stable" if boundary.stable else "unstable"
        for column, rank in boundary.arcs:
            if column in lines:
                x, y = lines[column]
                curves.append(
                    {
                        "label": f"{boundary.words}: {circles}, {fate}",
                        "stable": bool(boundary.stable),
                        "x": x.tolist(),
                        "y": (y[:, rank] + slope * x + offset).tolist(),
                    }
                )
    return {"x": names[0], "y": names[1], "curves": curves}


def _integral_of(system: System, formula: sp.Expr) -> str | None:
    """The integral that agrees with a formula at all test states, if there is one."""
    states = np.random.default_rng(0).uniform(0.3, 1.2, (_STATES, len(system.symbols)))
    try:
        (wanted,) = values(system, [formula], states).T
    except InputError:
        return None
    for law in system.integrals:
        (numbers,) = values(system, [law.value], states).T
        if np.all(np.abs(numbers - wanted) <= _SAME * (1.0 + np.abs(wanted))):
            return law.name
    return None
