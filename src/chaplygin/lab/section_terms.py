"""A section that is chosen when the motion starts: which quantity passes which value, and how."""

from __future__ import annotations

from collections.abc import Sequence

from ..core.system import System
from ..flow.kernel.equations import Equations, equations_of
from ..formulas.array_evaluation import read_formulas
from ..formulas.graph import Term, topological_order
from .columns import Scalar

#: Operations that the rate of a quantity may take besides those of the equations of motion.
_MOST = 400


def sectionable(system: System, scalars: Sequence[Scalar]) -> tuple[Scalar, ...]:
    """The quantities on which sections can be taken: what changes, and has no long formula."""
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
    """The equations with a section chosen by further parameters.

    After those of the system come the value, the direction (1, −1 or 0, in the direction of time in
    which the motion runs), and one number for each quantity: 1 for the chosen one, 0 for others.
    """
    bare = equations_of(system, 0, None, backward)
    reader, _ = read_formulas(system)
    graph, first = reader.graph, len(system.parameters)
    level = graph.parameter(first)
    zero, one = graph.number(0), graph.number(1)
    value, where = zero, zero
    for i, scalar in enumerate(scalars):
        chosen = graph.parameter(first + 2 + i)
        difference = reader(scalar.formula) - level
        passed, counted = difference, one
        if scalar.angle:
            passed, counted = graph.call("sin", difference), graph.call("cos", difference)
        value = value + graph.where_positive(chosen, passed, zero)
        where = where + graph.where_positive(chosen, counted, zero)
    (slope,) = graph.directional_derivative(
        [value], {graph.state(i): rate for i, rate in enumerate(bare.rates)}
    )
    return Equations(
        bare.graph,
        bare.rates,
        bare.groups,
        first + 2 + len(scalars),
        value,
        slope,
        where if any(scalar.angle for scalar in scalars) else None,
        graph.parameter(first + 1),
        bare.guards,
    )


def terms_of(system: System, scalars: Sequence[Scalar]) -> tuple[Term, ...]:
    """The quantities as terms."""
    reader, _ = read_formulas(system)
    return tuple(reader(scalar.formula) for scalar in scalars)
