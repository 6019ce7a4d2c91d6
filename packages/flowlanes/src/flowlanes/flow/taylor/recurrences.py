"""Taylor coefficients of solutions: recurrences of automatic differentiation in machine code.

With x = Σ xₙ tⁿ the coefficients of every term follow from those of its operands: for a product by
Cauchy's formula, for a quotient, a root and a function f(u) from the derivative f′ (Moore 1966;
Jorba, Zou 2005).  Sums of products, Σ a_j b_{n−j} for 0 < j < n, are scalar products of one series
with another in reversed order, in vectors of eight; both are stored with padding by zeros.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from ...formulas.graph import Graph, Term, topological_order
from ..machine_code.arithmetic import Double
from ..machine_code.codegen import evaluate, parameter_only_terms
from ..machine_code.ir_writer import IRWriter
from .scalar_product import WIDTH, emit_scalar_product
from .step_code import emit_step, emit_sums

_ONE = "<1 x double>"
_ATTRIBUTES = "#1"

_P = ctypes.c_void_p
#: Argument types of the functions.
SERIES_SIGNATURES: Mapping[str, tuple[type, ...]] = {
    "prepare_series": (_P,) * 2,
    "series": (_P,) * 2,
    "sums": (_P,) * 5,
    "step": (_P,) * 7,
}


@dataclass(frozen=True)
class SeriesText:
    """Code of the functions for the series of a system, and their memory layout.

    Attributes
    ----------
    text : str
        ``@prepare_series(memory, parameters)`` once for given parameters; ``@series(memory,
        state)`` for the coefficients at a state; ``@sums(memory, rest, time, result, lost)`` for
        the state after a time, where `rest` is added to the first state and `lost` to the last;
        and ``@step(memory, state, before, rest, ends, result, control)`` for a step, unless an
        event is possible within it.
    doubles : int
        Size of the memory in doubles.
    stride : int
        Distance in doubles between the series of two state variables; these come first, in flat
        order, and then those of the events.
    """

    text: str
    doubles: int
    stride: int


@dataclass(frozen=True)
class _Integral:
    """Term y with y′ = Σ q u′, as pairs (q, u)."""

    pairs: tuple[tuple[Term, Term], ...]


def _derivative(graph: Graph, node: Term) -> _Integral:
    """Derivative of a function, as such a term."""
    if node.kind == "atan2":
        y, x = node.args
        inverse = graph.recip(graph.add(graph.mul(x, x), graph.mul(y, y)))
        return _Integral(((graph.mul(x, inverse), y), (graph.neg(graph.mul(y, inverse)), x)))
    (u,) = node.operands
    return _Integral(((graph.slope(node), u),))


#: Functions with recurrences of their own; other functions follow from their derivatives.
_DIRECT = frozenset(("add", "sub", "neg", "mul", "recip", "sqrt", "abs", "sign", "positive"))
_LEAVES = frozenset(("state", "parameter", "number"))


def emit_series(rates: Sequence[Term], events: Sequence[Term], size: int, order: int) -> SeriesText:
    """Functions that compute the Taylor series of a motion, as code.

    Parameters
    ----------
    rates : sequence of Term
        Right-hand sides of the equations of motion.
    events : sequence of Term
        Values of events, whose series are computed as well.
    size : int
        Number of state variables.
    order : int
        Order of the series, at least 2.
    """
    return _Writer(rates, events, size, order).text()


class _Writer:
    """Terms of one system, in order, and the addresses of their series."""

    def __init__(
        self, rates: Sequence[Term], events: Sequence[Term], size: int, order: int
    ) -> None:
        graph = rates[0].graph
        self.rates, self.events, self.size, self.order = rates, events, size, order
        self.integrals: dict[int, _Integral] = {}
        terms = [*rates, *events]
        # The derivative of a function is a term as well, with derivatives of its own.
        while True:
            nodes = topological_order(terms)
            new = [
                node
                for node in nodes
                if node.kind not in _DIRECT | _LEAVES and id(node) not in self.integrals
            ]
            if not new:
                break
            for node in new:
                self.integrals[id(node)] = _derivative(graph, node)
                terms += [q for q, _ in self.integrals[id(node)].pairs]
        moving: dict[int, None] = {}
        for node in nodes:
            if node.kind == "state" or any(id(a) in moving for a in node.operands):
                moving[id(node)] = None
        self.nodes = [node for node in nodes if id(node) in moving]
        self.moving = moving
        self.constants = parameter_only_terms(terms)
        self._place_series()

    def _place_series(self) -> None:
        """Allocate memory for every series that is needed later."""
        groups = math.ceil((self.order - 1) / WIDTH)
        self.groups = groups
        # A vector may extend beyond the coefficients at either end.
        self.stride = WIDTH * (groups + 1)
        reversed_size = WIDTH * math.ceil(self.order / WIDTH + groups)
        self.forward: dict[int, int] = {}
        self.slopes: dict[int, int] = {}
        self.backward: dict[int, int] = {}
        self.first: dict[int, int] = {}
        graph = self.rates[0].graph
        next_free = 0
        for i in range(self.size):
            self.forward[id(graph.state(i))] = next_free
            next_free += self.stride
        # One term may be the value of two events, or a variable.
        self.event_places = [next_free + i * self.stride for i in range(len(self.events))]
        next_free += len(self.events) * self.stride
        lengths = {"forward": self.stride, "slopes": self.stride, "backward": reversed_size}
        for kind, ids in self._needs().items():
            places = getattr(self, kind)
            for key in ids:
                if key not in places:
                    places[key] = next_free
                    next_free += lengths.get(kind, 1)
        self.rate_places = range(next_free, next_free + self.size)
        next_free += self.size
        self.constant_places = {id(term): next_free + i for i, term in enumerate(self.constants)}
        self.doubles = next_free + len(self.constants)

    def _needs(self) -> dict[str, dict[int, None]]:
        """Terms whose series is needed forward, as a derivative, reversed, or only at order 0."""
        needs: dict[str, dict[int, None]] = {
            "forward": {},
            "slopes": {},
            "backward": {},
            "first": {},
        }

        def need(term: Term, *kinds: str) -> None:
            if id(term) in self.moving:
                for kind in kinds:
                    needs[kind][id(term)] = None

        for node in self.nodes:
            args = node.operands
            if id(node) in self.integrals:
                for q, u in self.integrals[id(node)].pairs:
                    if id(q) in self.moving and id(u) in self.moving:
                        need(u, "slopes")
                        need(q, "backward", "first")
            elif node.kind == "mul" and all(id(a) in self.moving for a in args):
                need(args[0], "forward", "first")
                need(args[1], "backward", "first")
            elif node.kind == "recip":
                need(args[0], "forward")
                need(node, "backward", "first")
            elif node.kind == "sqrt":
                need(node, "forward", "backward", "first")
            elif node.kind in ("abs", "positive"):
                need(args[0], "first")
        return needs

    # --- text --------------------------------------------------------------------------------

    def text(self) -> SeriesText:
        """Code of all functions."""
        functions = [
            emit_scalar_product(self.groups),
            self._prepare(),
            self._series(),
            emit_sums(self.size, self.stride, self.order),
            emit_step(self.size, len(self.events), self.stride, self.order),
        ]
        return SeriesText("\n".join(functions), self.doubles, self.stride)

    def _prepare(self) -> str:
        number = Double(IRWriter(1))

        def leaf(term: Term) -> str | None:
            if term.kind == "parameter":
                return number.load("%parameters", term.args[0])
            return None

        for term, value in zip(self.constants, evaluate(number, self.constants, leaf), strict=True):
            number.store(value, "%memory", self.constant_places[id(term)])
        head = "void @prepare_series(ptr noalias %memory, ptr noalias %parameters)"
        return number.writer.text(head, _ATTRIBUTES)

    def _series(self) -> str:
        w = IRWriter(1)
        number = Double(w)

        def leaf(term: Term) -> str | None:
            if id(term) in self.constant_places:
                return number.load("%memory", self.constant_places[id(term)])
            return number.load("%state", term.args[0]) if term.kind == "state" else None

        numbers = evaluate(number, [*self.nodes, *self.rates, *self.events], leaf)
        values = {id(n): v for n, v in zip(self.nodes, numbers, strict=False)}
        for node in self.nodes:
            self._keep(number, node, values[id(node)], "0")
        graph = self.rates[0].graph
        for i in range(self.size):
            # A variable on which nothing depends is not a node of any formula.
            state = number.load("%state", i)
            number.store(state, "%memory", self.forward[id(graph.state(i))])
        rest = numbers[len(self.nodes) :]
        for place, value in zip(self.rate_places, rest, strict=False):
            number.store(value, "%memory", place)
        for place, value in zip(self.event_places, rest[self.size :], strict=True):
            number.store(value, "%memory", place)
        with w.count(self.order + 1, 1) as n:
            self._one_order(number, n)
        head = "void @series(ptr noalias %memory, ptr noalias %state)"
        return w.text(head, _ATTRIBUTES)

    def _one_order(self, number: Double, n: str) -> None:
        """Emit the coefficients of order n of all terms."""
        w = number.writer
        graph = self.rates[0].graph
        order = w.emit(
            f"insertelement {_ONE} poison, double {w.emit(f'sitofp i64 {n} to double')}, i64 0"
        )
        coefficients: dict[int, str] = {}
        for i in range(self.size):
            change = number.load("%memory", self.rate_places[i])
            state = graph.state(i)
            coefficients[id(state)] = w.op("fdiv", change, order)
            self._keep(number, state, coefficients[id(state)], n, order)
        for node in self.nodes:
            if node.kind != "state":
                coefficients[id(node)] = self._coefficient(number, node, coefficients, n, order)
                self._keep(number, node, coefficients[id(node)], n, order)
        zero = number.number(Fraction(0))
        for place, rate in zip(self.rate_places, self.rates, strict=True):
            number.store(coefficients.get(id(rate), zero), "%memory", place)
        for place, term in zip(self.event_places, self.events, strict=True):
            self._store(number, coefficients.get(id(term), zero), place, n)

    def _keep(self, number: Double, node: Term, value: str, n: str, order: str = "") -> None:
        """Store a coefficient wherever it is needed later."""
        w, key = number.writer, id(node)
        if key in self.forward:
            self._store(number, value, self.forward[key], n)
        if n == "0":
            if key in self.first:
                number.store(value, "%memory", self.first[key])
            return
        if key in self.slopes:
            self._store(number, w.op("fmul", order, value), self.slopes[key], n)
        if key in self.backward:
            place = w.emit(f"sub i64 {self.backward[key] + self.order}, {n}")
            number.store(value, "%memory", place)

    def _store(self, number: Double, value: str, place: int, n: str) -> None:
        index = str(place) if n == "0" else number.writer.emit(f"add i64 {place}, {n}")
        number.store(value, "%memory", index)

    def _inner(self, number: Double, forward: int, backward: int, n: str) -> str:
        """Sum of a_j b_{n−j} over 0 < j < n."""
        w = number.writer
        a = w.address("double", "%memory", forward + 1)
        start = w.emit(f"sub i64 {backward + self.order + 1}, {n}")
        b = w.address("double", "%memory", start)
        return w.emit(f"call {_ONE} @scalar_product(ptr {a}, ptr {b})")

    def _first(self, number: Double, term: Term) -> str:
        """Value of a term."""
        places = self.first if id(term) in self.moving else self.constant_places
        if id(term) in places:
            return number.load("%memory", places[id(term)])
        return number.number(term.args[0])

    def _coefficient(
        self, number: Double, node: Term, coefficients: Mapping[int, str], n: str, order: str
    ) -> str:
        """Coefficient of order n of a term that depends on the state."""
        w, args = number.writer, node.operands
        zero = number.number(Fraction(0))
        moving = [id(a) in self.moving for a in args]
        values = [coefficients.get(id(a), zero) for a in args]
        if id(node) in self.integrals:
            return self._function(number, node, coefficients, n, order)
        match node.kind:
            case "add":
                return number.add(*values) if all(moving) else values[moving.index(True)]
            case "sub":
                if all(moving):
                    return number.sub(*values)
                return values[0] if moving[0] else number.neg(values[1])
            case "neg":
                return number.neg(values[0])
            case "mul" if all(moving):
                a, b = args
                total = self._inner(number, self.forward[id(a)], self.backward[id(b)], n)
                total = number.fma(values[0], self._first(number, b), total)
                return number.fma(values[1], self._first(number, a), total)
            case "mul":
                return number.mul(
                    *(
                        value if moves else self._first(number, a)
                        for a, value, moves in zip(args, values, moving, strict=True)
                    )
                )
            case "recip":
                total = self._inner(number, self.forward[id(args[0])], self.backward[id(node)], n)
                first = self._first(number, node)
                total = number.fma(values[0], first, total)
                return number.neg(number.mul(total, first))
            case "sqrt":
                total = self._inner(number, self.forward[id(node)], self.backward[id(node)], n)
                first = self._first(number, node)
                return w.op("fdiv", number.sub(values[0], total), number.add(first, first))
            case "abs":
                negative = w.compare("olt", self._first(number, args[0]), zero)
                return number.choose(negative, number.neg(values[0]), values[0])
            case "positive":
                mask = w.compare("ogt", self._first(number, args[0]), zero)
                return number.choose(mask, values[1], values[2])
            case _:
                # A sign is constant along a series.
                return zero

    def _function(
        self, number: Double, node: Term, coefficients: Mapping[int, str], n: str, order: str
    ) -> str:
        """Coefficient of a term with known derivative.

        y′ = Σ q u′ gives n y_n = Σ_{j=1}^n j u_j q_{n−j} for each pair (q, u); the q have lower
        order than y, so their coefficients are known.
        """
        w = number.writer
        total: str | None = None
        exact: str | None = None
        for q, u in self.integrals[id(node)].pairs:
            if id(u) not in self.moving:
                continue
            first = self._first(number, q)
            if id(q) not in self.moving:
                part = number.mul(first, coefficients[id(u)])
                exact = part if exact is None else number.add(exact, part)
                continue
            part = self._inner(number, self.slopes[id(u)], self.backward[id(q)], n)
            part = number.fma(w.op("fmul", order, coefficients[id(u)]), first, part)
            total = part if total is None else number.add(total, part)
        if total is None:
            # A term that depends on the state has an operand that depends on it.
            return exact or number.number(Fraction(0))
        total = w.op("fdiv", total, order)
        return total if exact is None else number.add(total, exact)
