"""Sections of a motion in a page: the initial one, and others chosen by parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.kernel.equations import Equations, SectionChoice, equations_of
from flowlanes.formulas.array_evaluation import read_formulas, values
from flowlanes.formulas.graph import Term, topological_order
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

from ..experiment.study import Study
from .columns import Scalar
from .scene_model import Json

#: Maximum number of operations in the rate of a quantity besides those of the equations of motion.
_MOST = 400

#: Number of samples of the motion, and of intervals searched for a crossing.
_LOOKS, _LONGER = 2000, 10.0

#: A section crossed less often than another by this factor is not chosen initially.
_SELDOM = 10

#: Coordinates and quantities of a section in order of preference.
_PREFERRED_ON = ("gamma_3", "M_3", "omega_3", "gamma_1")
_PREFERRED_X = ("longitude", "gamma_1", "gamma_2", "gamma_3")
_PREFERRED_Y = ("M_3", "omega_3", "M_1", "omega_1")


def section_choice(study: Study, system: System, places: Sequence[Scalar]) -> Json:
    """A quantity with repeated upward crossings, and two coordinates; None if none is found.

    The value is zero if it is crossed, and otherwise the middle of the range. Quantities that are
    crossed seldom are avoided, since a point of the section takes the time between two crossings.

    Parameters
    ----------
    study : Study
    system : System
        The reduced system.
    places : sequence of Scalar
        Quantities on which a section can be taken.
    """
    if len(places) < 3:
        return None
    sign = -1.0 if study.experiment.run.direction == "backward" else 1.0
    times = _LONGER * study.until * np.arange(1, _LOOKS + 1) / _LOOKS
    start = np.array([[float(x) for x in study.start[: len(system.symbols)]]])
    flow = batch_integrator(system, backward=sign < 0.0)
    states = flow.propagate(start, sign * times).states[0]
    states = states[np.isfinite(states).all(axis=1)]
    looks = values(system, [scalar.formula for scalar in places], states)
    crossings = [_rises(column) for column in looks.T]
    middles = (looks.min(axis=0) + looks.max(axis=0)) / 2 if len(looks) else np.zeros(len(places))
    ordered = sorted(range(len(places)), key=lambda i: _rank(places[i].name, _PREFERRED_ON))
    own = {str(symbol) for symbol in system.symbols}
    passages = zip(crossings, places, strict=True)
    most = max((n for n, place in passages if place.name in own and not place.angle), default=0)
    often = max(1, most / _SELDOM)
    chosen = next((i for i in ordered if crossings[i] > often and not places[i].angle), None)
    value = 0.0
    if chosen is None:
        middle = [_rises(column - m) for column, m in zip(looks.T, middles, strict=True)]
        chosen = next((i for i in ordered if middle[i] > 1 and not places[i].angle), None)
        if chosen is None:
            chosen = next((i for i in ordered if places[i].angle), ordered[0])
        else:
            value = float(f"{middles[chosen]:.3g}")
    on = places[chosen].name
    others = [scalar.name for i, scalar in enumerate(places) if i != chosen]
    if on in ("gamma_1", "gamma_2"):
        # on this section the longitude is constant up to half a turn
        others.remove("longitude")
    x = min(others, key=lambda name: _rank(name, _PREFERRED_X))
    y = min((n for n in others if n != x), key=lambda name: _rank(name, _PREFERRED_Y))
    return {"on": on, "value": value, "direction": 1, "x": x, "y": y}


def _rises(column: FloatArray) -> int:
    """The number of times that values increase through zero."""
    return int(np.count_nonzero((column[:-1] < 0.0) & (column[1:] >= 0.0)))


def _rank(name: str, order: Sequence[str]) -> int:
    return order.index(name) if name in order else len(order)


def sectionable(system: System, scalars: Sequence[Scalar]) -> tuple[Scalar, ...]:
    """The quantities on which sections can be taken: nonconstant, with a short formula."""
    reader, rates = read_formulas(system)
    graph = reader.graph
    flow = {graph.state(i): rate for i, rate in enumerate(rates)}
    moving = {id(node) for node in topological_order(rates)}
    constant = {law.name for law in system.integrals}
    chosen = []
    for scalar in scalars:
        value = reader(scalar.formula)
        (slope,) = graph.directional_derivative([value], flow)
        new = sum(id(node) not in moving for node in topological_order([value, slope]))
        if slope.number != 0 and scalar.name not in constant and new <= _MOST:
            chosen.append(scalar)
    return tuple(chosen)


def chosen_section(system: System, scalars: Sequence[Scalar], backward: bool) -> Equations:
    """The equations with a section chosen by additional parameters.

    The additional parameters are the value, the direction (1, −1 or 0, along the direction of
    integration), and one number for each quantity: 1 for the chosen one, 0 for others.
    """
    bare = equations_of(system, 0, None, backward)
    reader, _ = read_formulas(system)
    graph, first, size = reader.graph, len(system.parameters), len(bare.rates)
    level = graph.parameter(first)
    flow = {graph.state(i): graph.state(size + i) for i in range(size)}
    choices = []
    for i, scalar in enumerate(scalars):
        value, where = reader(scalar.formula) - level, graph.number(1)
        if scalar.angle:
            value, where = graph.call("sin", value), graph.call("cos", value)
        (slope,) = graph.directional_derivative([value], flow)
        choices.append(SectionChoice(first + 2 + i, value, slope, where))
    return replace(
        bare,
        parameters=first + 2 + len(scalars),
        direction=graph.parameter(first + 1),
        choices=tuple(choices),
    )


def terms_of(system: System, scalars: Sequence[Scalar]) -> tuple[Term, ...]:
    """The quantities as terms."""
    reader, _ = read_formulas(system)
    return tuple(reader(scalar.formula) for scalar in scalars)
