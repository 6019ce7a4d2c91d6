"""Compilation of terms to vector instructions: one lane per motion, stage, deviation or parameter.

Every operation is correctly rounded, and products are fused with sums only where the graph
prescribes it, not by a choice of the compiler.  So a lane gives the same bits for every vector
width and every content of other lanes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from ...formulas.graph import Term, topological_order
from . import elementary as special
from .arithmetic import Arithmetic, V, pair_of
from .ir_writer import IRWriter

#: Derivatives of the circular functions, and their signs.
_SLOPES = {"sin": ("cos", 1), "cos": ("sin", -1)}


@dataclass(frozen=True)
class Clock:
    """State variable that is the time, as the sum of two doubles.

    Everything that depends only on the time is computed with twice the digits, because a phase of
    many turns exceeds the precision of a double.

    Attributes
    ----------
    piece : str
        Name of the function with this state.
    place, rest : int
        Indices of both doubles in the state.
    """

    piece: str
    place: int
    rest: int


def evaluate(
    arithmetic: Arithmetic[V], terms: Sequence[Term], leaf: Callable[[Term], V | None]
) -> list[V]:
    """Emit the instructions that compute terms.

    Parameters
    ----------
    arithmetic : Arithmetic
    terms : sequence of Term
    leaf : callable
        Value of a known term; None if it must be computed.
    """
    known: dict[int, V] = {}

    def is_unknown(node: Term) -> bool:
        value = leaf(node)
        if value is not None:
            known[id(node)] = value
        return value is None

    nodes = topological_order(terms, is_unknown)
    # A product with a single use is fused with the sum that uses it, which saves an instruction
    # and a rounding.
    uses = Counter(id(a) for node in nodes for a in node.operands)
    uses.update(id(term) for term in terms)

    def single(node: Term) -> bool:
        return node.kind == "mul" and uses[id(node)] == 1 and id(node) not in known

    fused: dict[int, int] = {}
    inside: set[int] = set()
    for node in nodes:
        if node.kind in ("add", "sub"):
            for place in (1, 0):
                if single(node.args[place]):
                    fused[id(node)] = place
                    inside.add(id(node.args[place]))
                    break
    for node in nodes:
        if id(node) not in inside:
            known[id(node)] = _compute(arithmetic, node, fused.get(id(node)), known)
    return [known[id(term)] for term in terms]


def _compute(
    arithmetic: Arithmetic[V], node: Term, product: int | None, numbers: Mapping[int, V]
) -> V:
    if product is not None:
        other = numbers[id(node.args[1 - product])]
        a, b = (numbers[id(x)] for x in node.args[product].args)
        if node.kind == "sub":
            if product == 1:
                a = arithmetic.neg(a)
            else:
                other = arithmetic.neg(other)
        return arithmetic.multiply_add(a, b, other)
    values = [numbers[id(a)] for a in node.operands]
    match node.kind:
        case "number":
            return arithmetic.number(node.args[0])
        case "add":
            return arithmetic.plus(*values)
        case "sub":
            return arithmetic.plus(values[0], arithmetic.neg(values[1]))
        case "mul":
            return arithmetic.mul(*values)
        case "neg":
            return arithmetic.neg(*values)
        case "recip":
            return arithmetic.recip(*values)
        case "sqrt":
            return arithmetic.sqrt(*values)
        case "positive":
            w = arithmetic.writer
            mask = w.compare("ogt", arithmetic.leading(values[0]), w.constant(0.0))
            return arithmetic.choose(mask, values[1], values[2])
        case _:
            value: V = special.FUNCTIONS[node.kind](arithmetic, *values)
            return value


def parameter_only_terms(terms: Sequence[Term]) -> list[Term]:
    """Terms that depend only on parameters and are used by terms in the state.

    They are computed once per motion; numbers are not included.
    """
    nodes = topological_order(terms)
    # Terms without a state variable below them are constant during a motion.
    moving = _ids_with(nodes, lambda node: node.kind == "state")
    return [t for t in _used_outside(terms, nodes, moving) if t.kind != "number"]


def _clock_terms(terms: Sequence[Term], place: int) -> list[Term]:
    """Terms in the time and parameters only that are used by other terms."""
    nodes = topological_order(terms)
    moving = _ids_with(nodes, lambda node: node.kind == "state" and node.args[0] != place)
    timed = _ids_with(nodes, lambda node: node.kind == "state")
    return [t for t in _used_outside(terms, nodes, moving) if id(t) in timed]


def _ids_with(nodes: Sequence[Term], among: Callable[[Term], bool]) -> set[int]:
    """Given nodes and all nodes that depend on them."""
    found: set[int] = set()
    for node in nodes:
        if among(node) or any(id(a) in found for a in node.operands):
            found.add(id(node))
    return found


def _used_outside(terms: Sequence[Term], nodes: Sequence[Term], inside: set[int]) -> list[Term]:
    """Nodes outside a set that are results or are used in the set."""
    wanted: dict[int, Term] = {}
    for node in nodes:
        if id(node) in inside:
            wanted |= {id(a): a for a in node.operands if id(a) not in inside}
    wanted |= {id(t): t for t in terms if id(t) not in inside}
    return list(wanted.values())


def functions(
    arithmetic: type[Arithmetic[V]],
    pieces: Mapping[str, Sequence[Term]],
    lanes: int,
    prepare: str = "prepare",
    clock: Clock | None = None,
    steady: bool = False,
) -> tuple[str, int]:
    """Emit functions that compute formulas; also return the number of shared constants.

    ``@prepare(constants, parameters)`` computes everything that depends only on parameters;
    ``@<piece>(result, state, constants)`` computes the rest.

    Parameters
    ----------
    arithmetic : Double or Pair
    pieces : mapping of str to sequence of Term
        Formulas of each function, by its name.
    lanes : int
    prepare : str
        Name of the first function.
    clock : Clock, optional
    steady : bool
        True if terms in parameters alone are computed with twice the digits and then rounded,
        because their errors are the same in all steps.
    """
    constants = parameter_only_terms([term for terms in pieces.values() for term in terms])
    slots = {id(term): i for i, term in enumerate(constants)}
    texts = [
        _function(
            *(arithmetic, lanes, name, terms, slots),
            clock if clock is not None and clock.piece == name else None,
        )
        for name, terms in pieces.items()
    ]
    number = arithmetic(IRWriter(lanes))

    def leaf(term: Term) -> V | None:
        return number.load("%parameters", term.args[0]) if term.kind == "parameter" else None

    if steady:
        values = _values_rounded_once(number, constants, leaf)
    else:
        values = evaluate(number, constants, leaf)
    for i, value in enumerate(values):
        number.store(value, "%constants", i)
    head = f"internal void @{prepare}(ptr noalias %constants, ptr noalias %parameters)"
    texts.append(number.writer.text(head, "#1"))
    return "\n".join(texts), len(constants)


def _function(
    arithmetic: type[Arithmetic[V]],
    lanes: int,
    name: str,
    terms: Sequence[Term],
    slots: Mapping[int, int],
    clock: Clock | None,
) -> str:
    number = arithmetic(IRWriter(lanes))
    timed = {} if clock is None else _timed_values(number, terms, slots, clock)

    def leaf(term: Term) -> V | None:
        if id(term) in timed:
            return timed[id(term)]
        if id(term) in slots:
            return number.load("%constants", slots[id(term)])
        return number.load("%state", term.args[0]) if term.kind == "state" else None

    for i, value in enumerate(evaluate(number, terms, leaf)):
        number.store(value, "%result", i)
    arguments = "ptr noalias %result, ptr noalias %state, ptr noalias %constants"
    return number.writer.text(f"internal void @{name}({arguments})", "#1")


def _values_rounded_once(
    number: Arithmetic[V], terms: Sequence[Term], leaf: Callable[[Term], V | None]
) -> list[V]:
    """Values of terms, computed with twice the digits and rounded once."""
    pair = pair_of(number)

    def exact(term: Term) -> tuple[str, str] | None:
        value = leaf(term)
        return None if value is None else pair.whole(number.leading(value))

    return [number.whole(pair.leading(value)) for value in evaluate(pair, terms, exact)]


def _timed_values(
    number: Arithmetic[V], terms: Sequence[Term], slots: Mapping[int, int], clock: Clock
) -> dict[int, V]:
    """Values of terms that depend only on the time, rounded once."""
    pair, wanted = pair_of(number), _clock_terms(terms, clock.place)

    def one(base: str, place: int) -> str:
        return number.leading(number.load(base, place))

    def leaf(term: Term) -> tuple[str, str] | None:
        if id(term) in slots:
            return pair.whole(one("%constants", slots[id(term)]))
        if term.kind == "state":
            return one("%state", clock.place), one("%state", clock.rest)
        if term.kind in _SLOPES:
            return pair.whole(circular(term.kind, evaluate(pair, term.operands, leaf)[0]))
        return None

    def circular(name: str, angle: tuple[str, str]) -> str:
        """Circular function of an angle with twice the digits, from its value and slope."""
        (other, sign), (head, rest) = _SLOPES[name], map(number.whole, angle)
        slope = special.FUNCTIONS[other](number, head)
        rest = rest if sign > 0 else number.neg(rest)
        value = number.multiply_add(rest, slope, special.FUNCTIONS[name](number, head))
        return number.leading(value)

    values = evaluate(pair, wanted, leaf)
    return {
        id(term): number.whole(pair.leading(value))
        for term, value in zip(wanted, values, strict=True)
    }
