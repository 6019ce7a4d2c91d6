"""The initial state as terms in the numbers of a start.

These are the formulas of :func:`chaplygin.initial_state`, which evaluates the same numbers with 50
digits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import sympy as sp

from flowlanes.formulas.graph import Graph, Reader, Term
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import cross, dot
from flowlanes.system.vectors import Vector
from nonholonomic.mechanics.conventions import start_vectors
from nonholonomic.mechanics.rolling.attitude import attitude
from nonholonomic.mechanics.rolling.initial_state import is_no_spin
from nonholonomic.mechanics.rotations import quaternion_product

from ..experiment.subjects.subject import BodySubject

_OMEGA, _GAMMA, _ZETA = (Vector(name).symbols for name in ("omega", "gamma", "zeta"))
_PLACE = Vector("place", 2)

Quaternion = tuple[Term, Term, Term, Term]


@dataclass(frozen=True)
class StartTerms:
    """The initial state, as terms.

    Attributes
    ----------
    inputs : tuple of str
        Names of the inputs.
    state : tuple of Term
        The state lifted to space.
    excess : tuple of Term
        Terms that must vanish: (ω, γ) if the body must not spin.
    nearest : tuple of Term
        The nearest inputs for which they vanish.
    """

    inputs: tuple[str, ...]
    state: tuple[Term, ...]
    excess: tuple[Term, ...]
    nearest: tuple[Term, ...]


def start_terms(subject: BodySubject, system: System) -> StartTerms | None:
    """The initial state of a body in terms of ω and γ.

    Parameters
    ----------
    subject : BodySubject
        The subject with heading and normal.
    system : System

    Returns
    -------
    StartTerms or None
        None if the contact point is not a formula in γ (an implicit shape).
    """
    if Vector("r") in system.state:
        return None
    graph = Graph()
    fluids = [s for name in start_vectors(system) for s in name.symbols]
    names = (*map(str, (*_OMEGA, *_GAMMA, *fluids)), "heading")
    given = [graph.state(i) for i in range(len(names))]
    spin, up = given[:3], _unit(graph, given[3:6])
    reader = _StartReader(system, graph)
    reader.know(dict(zip((*_OMEGA, *_GAMMA), (*spin, *up), strict=True)))
    reader.know(dict(zip(fluids, given[6:-1], strict=True)))
    turn = _attitude(graph, up, subject.normal, given[-1])
    reader.know(dict(zip(attitude.symbols, turn, strict=True)))
    reader.know(dict(zip(_ZETA, _third_row(graph, turn), strict=True)))
    for symbol, formula in flat_pairs(system.conventions.start_formulas):
        reader.know({symbol: reader(formula)})
    lifted = system.lifted() if system.reconstruction else system
    if _PLACE in lifted.state:
        zero = graph.number(0)
        origin = reader.copy()
        origin.know(dict.fromkeys(_PLACE.symbols, zero))
        contact = next(item.value for item in lifted.scalar.observables if item.name == "contact")
        shifted = [-origin(part) for part in contact[:2]]
        reader.know(dict(zip(_PLACE.symbols, shifted, strict=True)))
    excess: tuple[Term, ...] = ()
    nearest = tuple(given)
    if any(is_no_spin(relation) for relation in system.relations):
        along = dot(spin, up)
        excess = (along,)
        nearest = (*(w - along * g for w, g in zip(spin, up, strict=True)), *given[3:])
    state = tuple(reader(symbol) for symbol in lifted.symbols)
    return StartTerms(names, state, excess, nearest)


class _StartReader(Reader):
    """Formulas of a system whose state is not yet known, as terms in the inputs."""

    def __init__(self, system: System, graph: Graph) -> None:
        super().__init__(system, graph)
        for symbol in system.symbols:
            del self._elements[symbol]

    def know(self, terms: Mapping[sp.Symbol, Term]) -> None:
        """Assign terms to symbols."""
        self._elements.update(terms)

    def copy(self) -> _StartReader:
        """An independent copy of the reader."""
        other = object.__new__(_StartReader)
        other.graph = self.graph
        other._elements, other._definitions = dict(self._elements), self._definitions
        return other


def _unit(graph: Graph, vector: Sequence[Term]) -> list[Term]:
    length = graph.call("sqrt", dot(vector, vector))
    return [x / length for x in vector]


def _attitude(
    graph: Graph, up: Sequence[Term], normal: Sequence[float], heading: Term
) -> Quaternion:
    """The quaternion that maps `up` (body) to `normal` (space), rotated by `heading`."""
    direction = np.asarray(normal, dtype=np.float64)
    n = [_constant(graph, x) for x in direction / np.linalg.norm(direction)]
    cosine = dot(up, n)
    axis = cross(up, n)
    # opposite directions: a half turn about a perpendicular axis
    least = int(np.argmin(np.abs(direction)))
    lateral = cross(up, [graph.number(int(i == least)) for i in range(3)])
    one, zero = graph.number(1), graph.number(0)
    apart = one + cosine - _constant(graph, 1e-15)
    short = (
        graph.where_positive(apart, one + cosine, zero),
        *(graph.where_positive(apart, a, b) for a, b in zip(axis, lateral, strict=True)),
    )
    half = heading * _constant(graph, 0.5)
    sine = graph.call("sin", half)
    turn = (graph.call("cos", half), *(sine * x for x in n))
    product = quaternion_product(turn, short)
    square = product[0] * product[0] + dot(product[1:], product[1:])
    length = graph.call("sqrt", square)
    a, b, c, d = (x / length for x in product)
    return a, b, c, d


def _constant(graph: Graph, value: float) -> Term:
    return graph.number(Fraction(value))


def _third_row(graph: Graph, turn: Quaternion) -> list[Term]:
    """The vertical of space in body axes."""
    w, x, y, z = turn
    two, one = graph.number(2), graph.number(1)
    return [two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)]
