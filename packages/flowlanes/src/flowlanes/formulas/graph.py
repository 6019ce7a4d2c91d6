"""Formulas as a graph of terms in which equal subexpressions are one node.

SymPy formulas become terms with a few operations.  Each term is created only once, so common
subexpressions are shared without a search.  Named intermediate quantities of a System become shared
nodes and are never expanded.  Derivatives are terms as well.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy as sp

from ..errors import InputError
from ..system.named_formulas import scalars
from ..system.system import System
from .evaluation import Evaluation, N, numerator_and_denominator, with_absolute_values

#: Functions of one variable supported by the machine code, by their SymPy names.
FUNCTIONS: Mapping[Any, str] = {
    sp.sin: "sin",
    sp.cos: "cos",
    sp.tan: "tan",
    sp.asin: "asin",
    sp.acos: "acos",
    sp.atan: "atan",
    sp.sinh: "sinh",
    sp.cosh: "cosh",
    sp.tanh: "tanh",
    sp.exp: "exp",
    sp.log: "log",
    sp.Abs: "abs",
    sp.sign: "sign",
}


class Term:
    """Node of a graph: an operation and its operands; created only by `Graph`.

    Attributes
    ----------
    kind : str
        ``"state"``, ``"parameter"`` (`args`: the index), ``"number"`` (a fraction), ``"add"``,
        ``"sub"``, ``"mul"``, ``"neg"``, ``"recip"``, ``"sqrt"``, ``"atan2"``, ``"positive"``
        (args a, x, y: x where a > 0, else y) or the name of a function.
    args : tuple
    graph : Graph
    """

    __slots__ = ("args", "graph", "kind")

    def __init__(self, graph: Graph, kind: str, args: tuple[Any, ...]) -> None:
        self.graph, self.kind, self.args = graph, kind, args

    def __add__(self, other: Term) -> Term:
        return self.graph.add(self, other)

    def __sub__(self, other: Term) -> Term:
        return self.graph.sub(self, other)

    def __mul__(self, other: Term) -> Term:
        return self.graph.mul(self, other)

    def __truediv__(self, other: Term) -> Term:
        return self.graph.mul(self, self.graph.recip(other))

    def __neg__(self) -> Term:
        return self.graph.neg(self)

    @property
    def number(self) -> Fraction | None:
        """Value of a constant; None for any other term."""
        return self.args[0] if self.kind == "number" else None

    @property
    def operands(self) -> tuple[Term, ...]:
        """Terms that are operands of this one."""
        return () if self.kind in ("state", "parameter", "number") else self.args


class Graph:
    """Collection of terms, each created once."""

    def __init__(self) -> None:
        self._terms: dict[tuple[Any, ...], Term] = {}

    def _term(self, kind: str, *args: Any) -> Term:
        # Terms are compared by identity, because each is created only once.
        key = (kind, *(id(a) if isinstance(a, Term) else a for a in args))
        term = self._terms.get(key)
        if term is None:
            term = self._terms[key] = Term(self, kind, args)
        return term

    def state(self, index: int) -> Term:
        """State variable, by its index in flat order."""
        return self._term("state", index)

    def parameter(self, index: int) -> Term:
        """Parameter, by its index."""
        return self._term("parameter", index)

    def number(self, value: Fraction | int) -> Term:
        """Constant."""
        return self._term("number", Fraction(value))

    def add(self, a: Term, b: Term) -> Term:
        """a + b."""
        if a.number is not None and b.number is not None:
            return self.number(a.number + b.number)
        if a.number == 0:
            return b
        if b.number == 0:
            return a
        if b.kind == "neg":
            return self.sub(a, b.args[0])
        if a.kind == "neg":
            return self.sub(b, a.args[0])
        return self._term("add", a, b)

    def sub(self, a: Term, b: Term) -> Term:
        """a − b."""
        if a.number is not None and b.number is not None:
            return self.number(a.number - b.number)
        if b.number == 0:
            return a
        if a.number == 0:
            return self.neg(b)
        if a is b:
            return self.number(0)
        if b.kind == "neg":
            return self.add(a, b.args[0])
        return self._term("sub", a, b)

    def mul(self, a: Term, b: Term) -> Term:
        """a b."""
        if a.number is not None and b.number is not None:
            return self.number(a.number * b.number)
        if b.number is not None:
            a, b = b, a
        if a.number == 0:
            return a
        if a.number == 1:
            return b
        if a.number == -1:
            return self.neg(b)
        # Signs are moved outwards, so that terms that differ only in sign share the rest.
        if a.kind == "neg":
            return self.neg(self.mul(a.args[0], b))
        if b.kind == "neg":
            return self.neg(self.mul(a, b.args[0]))
        # a b and b a are the same term.
        if self._terms.get(("mul", id(b), id(a))) is not None:
            a, b = b, a
        return self._term("mul", a, b)

    def neg(self, a: Term) -> Term:
        """−a."""
        if a.number is not None:
            return self.number(-a.number)
        if a.kind == "neg":
            return self._operand(a)
        if a.kind == "sub":
            return self.sub(a.args[1], a.args[0])
        return self._term("neg", a)

    @staticmethod
    def _operand(a: Term) -> Term:
        inner: Term = a.args[0]
        return inner

    def recip(self, a: Term) -> Term:
        """1/a."""
        if a.number is not None and a.number != 0:
            return self.number(1 / a.number)
        if a.kind == "recip":
            return self._operand(a)
        return self._term("recip", a)

    def power(self, a: Term, exponent: int) -> Term:
        """Integer power of a, by squaring."""
        if exponent < 0:
            return self.power(self.recip(a), -exponent)
        if exponent == 0:
            return self.number(1)
        half = self.power(a, exponent // 2)
        square = self.mul(half, half)
        return self.mul(square, a) if exponent % 2 else square

    def call(self, name: str, *args: Term) -> Term:
        """Function of terms."""
        return self._term(name, *args)

    def where_positive(self, test: Term, yes: Term, no: Term) -> Term:
        """`yes` where `test` > 0, else `no`."""
        return yes if yes is no else self._term("positive", test, yes, no)

    # --- derivatives -----------------------------------------------------------------------

    def directional_derivative(
        self, terms: Sequence[Term], direction: Mapping[Term, Term]
    ) -> list[Term]:
        """Derivatives of terms when leaves change at the rates given by `direction`."""
        zero, known = self.number(0), {}
        for leaf, rate in direction.items():
            known[id(leaf)] = rate
        for node in topological_order(terms):
            if id(node) not in known:
                changes = [known[id(a)] for a in node.operands]
                known[id(node)] = self._change(node, changes) if changes else zero
        return [known[id(term)] for term in terms]

    def jacobian(self, terms: Sequence[Term], variables: Sequence[Term]) -> list[list[Term]]:
        """Partial derivatives: one row per term, one column per variable."""
        zero, one = self.number(0), self.number(1)
        columns = [
            self.directional_derivative(terms, {v: one if v is x else zero for v in variables})
            for x in variables
        ]
        return [list(row) for row in zip(*columns, strict=True)]

    def _change(self, node: Term, changes: Sequence[Term]) -> Term:
        kind = node.kind
        args: tuple[Term, ...] = node.args
        if all(change.number == 0 for change in changes):
            return self.number(0)
        if kind == "add":
            return changes[0] + changes[1]
        if kind == "sub":
            return changes[0] - changes[1]
        if kind == "mul":
            return args[1] * changes[0] + args[0] * changes[1]
        if kind == "neg":
            return -changes[0]
        if kind == "positive":
            return self.where_positive(args[0], changes[1], changes[2])
        if kind == "atan2":
            y, x = args
            return (x * changes[0] - y * changes[1]) / (x * x + y * y)
        return self.slope(node) * changes[0]

    def slope(self, node: Term) -> Term:
        """Derivative of a function of one variable."""
        one, (a,) = self.number(1), node.args
        slopes: dict[str, Callable[[], Term]] = {
            "recip": lambda: -(node * node),
            "sqrt": lambda: self.number(Fraction(1, 2)) / node,
            "sin": lambda: self.call("cos", a),
            "cos": lambda: -self.call("sin", a),
            "tan": lambda: one + node * node,
            "asin": lambda: one / self.call("sqrt", one - a * a),
            "acos": lambda: -(one / self.call("sqrt", one - a * a)),
            "atan": lambda: one / (one + a * a),
            "sinh": lambda: self.call("cosh", a),
            "cosh": lambda: self.call("sinh", a),
            "tanh": lambda: one - node * node,
            "exp": lambda: node,
            "log": lambda: one / a,
            "abs": lambda: self.call("sign", a),
            "sign": lambda: self.number(0),
        }
        return slopes[node.kind]()


def topological_order(
    terms: Iterable[Term], is_needed: Callable[[Term], bool] = lambda _: True
) -> list[Term]:
    """Given terms and all terms on which they depend, operands first.

    A term that is not `is_needed` is omitted, with those on which only it depends; each term is
    tested once.
    """
    seen: set[int] = set()
    order: list[Term] = []
    for root in terms:
        # An explicit stack, because formulas may be deeper than the limit of recursion.
        pending: list[tuple[Term, bool]] = [(root, False)]
        while pending:
            node, ready = pending.pop()
            if ready:
                order.append(node)
            elif id(node) not in seen:
                seen.add(id(node))
                if is_needed(node):
                    pending.append((node, True))
                    pending.extend((a, False) for a in reversed(node.operands))
    return order


def term_values(
    order: Iterable[Term],
    leaf: Callable[[Term], N],
    operations: Mapping[str, Callable[..., N]],
) -> dict[int, N]:
    """Values of terms, by their identity, in numbers of any kind.

    Parameters
    ----------
    order : iterable of Term
        Terms, operands first.
    leaf : callable
        Function for the value of a state variable, a parameter or a number.
    operations : mapping of str to callable
        Functions for the other kinds of terms.
    """
    values: dict[int, N] = {}
    for node in order:
        operands = node.operands
        values[id(node)] = (
            operations[node.kind](*(values[id(a)] for a in operands)) if operands else leaf(node)
        )
    return values


class Reader(Evaluation[Term]):
    """Conversion of formulas of one System to terms.

    State variables are numbered in flat order, parameters in the order of ``system.parameters``.
    """

    def __init__(self, system: System, graph: Graph) -> None:
        states = {s: graph.state(i) for i, s in enumerate(system.symbols)}
        parameters = {p.symbol: graph.parameter(i) for i, p in enumerate(system.parameters)}
        super().__init__({**states, **parameters}, dict(system.scalar_definitions))
        self.graph = graph

    def __call__(self, formula: sp.Expr | float) -> Term:
        """Term of a scalar formula."""
        return self._visit(*scalars(formula))

    def components(self, formulas: Iterable[sp.Expr]) -> list[Term]:
        """Terms of several formulas; for a vector, the terms of its components."""
        return list(map(self._visit, scalars(tuple(formulas))))

    def _rule(self, formula: sp.Expr) -> Callable[[sp.Expr], Term]:
        return self._constant if formula.is_number else super()._rule(formula)

    def _constant(self, number: sp.Expr) -> Term:
        if number.is_Rational or number.is_Float:
            return self.graph.number(Fraction(*map(int, sp.Rational(number).as_numer_denom())))
        # more digits than any arithmetic of the machine code uses
        decimal = sp.N(number, 50)
        if not (decimal.is_real and decimal.is_finite):
            raise InputError(f"{number}: a number in a formula must be real and finite")
        return self.graph.number(Fraction(str(decimal)))

    def _symbol(self, symbol: sp.Symbol) -> Term:
        raise InputError(f"{symbol}: neither a state variable, a definition nor a parameter")

    def _sum(self, formula: sp.Add) -> Term:
        # Subtracted terms last, so that no sign has to be changed.
        first, *others = sorted(self._parts(formula), key=lambda term: term.kind == "neg")
        for term in others:
            first = first + term
        return first

    def _product(self, formula: sp.Mul) -> Term:
        above, below = numerator_and_denominator(formula)
        divisors = [self._visit(factor) for factor in below]
        product = self.graph.number(1)
        for factor in above:
            product = product * self._visit(factor)
        if divisors:
            divisor = divisors[0]
            for factor in divisors[1:]:
                divisor = divisor * factor
            product = product / divisor
        return product

    def _power(self, formula: sp.Pow) -> Term:
        graph, (base, exponent) = self.graph, formula.args
        if base is sp.E:
            return graph.call("exp", self._visit(exponent))
        if exponent.is_Integer:
            return graph.power(self._visit(base), int(exponent))
        if exponent.is_Rational and exponent.q == 2:
            return graph.power(graph.call("sqrt", self._visit(base)), int(exponent.p))
        log = graph.call("log", self._visit(base))
        return graph.call("exp", self._visit(exponent) * log)

    def _function(self, formula: sp.Expr) -> Term:
        if isinstance(formula, sp.Max | sp.Min):
            return self._visit(with_absolute_values(formula))
        name = "atan2" if formula.func is sp.atan2 else FUNCTIONS.get(formula.func)
        if name is None:
            raise InputError(f"{formula}: the machine code has no function {formula.func.__name__}")
        return self.graph.call(name, *self._parts(formula))


def of_system(system: System) -> tuple[Reader, list[Term]]:
    """Reader of the formulas of a system, and the rates of its state as terms."""
    reader = Reader(system, Graph())
    return reader, [reader(rate) for rate in system.rates]
