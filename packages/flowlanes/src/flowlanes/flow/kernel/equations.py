"""Formulas of a System, of its variations and of a section, for code generation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ...arguments import Quantity, arguments_checked
from ...errors import InputError
from ...formulas.array_evaluation import formula, read_formulas
from ...formulas.graph import Graph, Term, topological_order
from ...system.system import System


@arguments_checked
@dataclass(frozen=True)
class Section:
    """Poincaré section: the zeros of a function, at which motions are recorded.

    Attributes
    ----------
    value : sympy.Expr
        Function of the state, definitions and parameters.
    direction : int
        +1 for crossings where it increases, −1 where it decreases, 0 for both.
    where : sympy.Expr or None
        Only crossings where this is positive are recorded.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> flowlanes.flow.Section(sp.Symbol("x"), direction=1)
    Section(value=x, direction=1, where=None)
    """

    value: sp.Expr
    direction: int = 1
    where: sp.Expr | None = None


@arguments_checked
def poincare_section(
    system: System, quantity: Quantity, value: float = 0, direction: int = 1, angle: bool = False
) -> Section:
    """Section on which a quantity has a given value.

    Parameters
    ----------
    system : System
    quantity : SymPy expression or str
        See :func:`flowlanes.formulas.array_evaluation.formula`.
    value : float
    direction : int
        +1 for crossings where the quantity increases, −1 where it decreases, 0 for both.
    angle : bool
        True if the quantity is an angle (rad), which has the value up to multiples of 2π.

    Returns
    -------
    Section

    Raises
    ------
    InputError
        If the quantity cannot be parsed or is constant, or the direction is not one of these.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> section = flowlanes.poincare_section(top, "b")
    >>> starts = flowlanes.sample_level(top, 4, {"energy": 2.0}, seed=1)
    >>> flowlanes.batch_integrator(top, section=section).crossings(starts, 10).states.shape
    (4, 10, 3)
    """
    if not math.isfinite(value):
        raise InputError(f"value = {value}: it must be a finite number")
    if direction not in (-1, 0, 1):
        raise InputError(f"direction = {direction}: it must be 1 (rising), -1 (falling) or 0")
    difference = formula(system, quantity) - sp.sympify(value)
    reader, _ = read_formulas(system)
    if not any(term.kind == "state" for term in topological_order([reader(difference)])):
        raise InputError(f"{system.name}: the section {quantity} = {value} contains no state")
    if angle:
        return Section(sp.sin(difference), direction, sp.cos(difference))
    return Section(difference, direction)


@dataclass(frozen=True)
class SectionChoice:
    """One of several sections: the one whose parameter is positive.

    Attributes
    ----------
    parameter : int
        Index of that parameter.
    value, slope : Term
        Function that vanishes on the section, and its rate; in its arguments the rates of the
        state come after the state.
    where : Term
        Expression that must be positive at a crossing.
    """

    parameter: int
    value: Term
    slope: Term
    where: Term


@dataclass(frozen=True)
class Equations:
    """Formulas of a System as terms of one graph.

    Attributes
    ----------
    rates : tuple of Term
        Time derivatives of the state variables and then of the deviations.
    groups : tuple of tuple of int
        State variables whose error is measured relative to a common size: components of a vector.
    parameters : int
    section, slope, where : Term or None
        Function that vanishes on the section, its rate, and an expression that must be positive.
    direction : int or Term
        +1 for crossings where the function increases, −1 where it decreases, 0 for both; or the
        parameter with this value.
    guards : tuple of Term
        Expressions that are positive as long as the equations are valid.
    deviations : tuple of tuple of int
        Indices of each component in all deviations.
    choices : tuple of SectionChoice
        Several sections instead of one.
    renewal : tuple of Term
        New values of all numbers after each sample, and the values recorded there instead of the
        state.
    """

    graph: Graph
    rates: tuple[Term, ...]
    groups: tuple[tuple[int, ...], ...]
    parameters: int
    section: Term | None = None
    slope: Term | None = None
    where: Term | None = None
    direction: int | Term = 1
    guards: tuple[Term, ...] = ()
    deviations: tuple[tuple[int, ...], ...] = ()
    choices: tuple[SectionChoice, ...] = ()
    renewal: tuple[Term, ...] = ()

    @property
    def has_section(self) -> bool:
        """True if motions are recorded on a section."""
        return self.section is not None or bool(self.choices)

    @property
    def clock(self) -> tuple[int, int] | None:
        """Index of the state variable that is the time, and 1 if it runs forward."""
        for i in range(sum(map(len, self.groups))):
            rate = self.rates[i]
            if rate.kind == "number" and abs(rate.args[0]) == 1:
                return i, int(rate.args[0])
        return None

    @property
    def acting(self) -> tuple[int, ...]:
        """State variables on which a rate depends; a position on a plane is not one of them."""
        controlled = {i for group in self.groups for i in group}
        used = {term.args[0] for term in topological_order(self.rates) if term.kind == "state"}
        return tuple(sorted(controlled & used))

    @property
    def pieces(self) -> dict[str, tuple[Term, ...]]:
        """Formulas of each generated function, by name."""
        pieces = {"rates": self.rates}
        if self.section is not None and self.slope is not None:
            where = () if self.where is None else (self.where,)
            pieces["section"] = (self.section, self.slope, *where)
            pieces["halfway"] = (self.section,)
        for i, choice in enumerate(self.choices):
            pieces[f"section_{i}"] = (choice.value, choice.slope, choice.where)
        if self.guards:
            pieces["guards"] = self.guards
        if self.renewal:
            pieces["renewal"] = self.renewal
        return pieces


def equations_of(
    system: System, deviations: int, section: Section | None, backward: bool
) -> Equations:
    """Formulas of a system, of its deviations and of a section, as terms."""
    reader, forward = read_formulas(system)
    if not forward:
        raise InputError(f"{system.name}: a system without state has no motion")
    graph = reader.graph
    rates = tuple(-rate for rate in forward) if backward else forward
    size = len(rates)
    every = [*rates, *_variations(graph, rates, deviations)]
    value = slope = where = None
    if section is not None:
        value = reader(section.value)
        (slope,) = graph.directional_derivative(
            [value], {graph.state(i): rate for i, rate in enumerate(rates)}
        )
        where = None if section.where is None else reader(section.where)
    direction = 0 if section is None else -section.direction if backward else section.direction
    return Equations(
        graph,
        tuple(every),
        groups(system),
        len(system.parameters),
        value,
        slope,
        where,
        direction,
        tuple(reader(guard.value) for guard in system.guards),
        tuple(
            tuple(size * k + i for k in range(1, deviations + 1))
            for i in range(size if deviations else 0)
        ),
    )


def _variations(graph: Graph, rates: Sequence[Term], deviations: int) -> list[Term]:
    """Variational equations, one deviation after the other."""
    size = len(rates)
    variations: list[Term] = []
    for k in range(1, deviations + 1):
        direction = {graph.state(i): graph.state(k * size + i) for i in range(size)}
        variations.extend(graph.directional_derivative(rates, direction))
    return variations


def groups(system: System) -> tuple[tuple[int, ...], ...]:
    """Indices of the components of each vector of the state; scalars form their own group."""
    return tuple(tuple(range(place.start, place.stop)) for _, place in system.slices)


def serial(equations: Equations) -> str:
    """Text that contains everything on which the generated code depends."""
    pieces = equations.pieces
    heads = [f"{name} {len(piece)}" for name, piece in pieces.items()]
    terms = serial_terms([term for piece in pieces.values() for term in piece])
    layout = (equations.groups, equations.direction, equations.parameters, equations.deviations)
    return "\n".join([*heads, terms, *map(str, layout)])


def serial_terms(terms: Sequence[Term]) -> str:
    """Text of terms, in which each term is written once."""
    nodes = topological_order(terms)
    place = {id(node): i for i, node in enumerate(nodes)}
    lines = [
        f"{node.kind} {' '.join(str(place.get(id(a), a)) for a in node.args)}" for node in nodes
    ]
    return "\n".join([*lines, str([place[id(t)] for t in terms])])
