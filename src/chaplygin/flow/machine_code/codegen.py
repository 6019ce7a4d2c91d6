"""From terms to vector instructions: one lane per trajectory, stage, deviation or parameter.

Every operation is exactly rounded and products are fused into sums where the graph says so, never
where a compiler likes to, so that a lane gives the same bits at every vector width and whatever
its neighbours do.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence

from ...formulas.graph import Term, topological_order
from . import elementary as special
from .arithmetic import Arithmetic, V
from .ir_writer import IRWriter


def evaluate(
    arithmetic: Arithmetic[V], terms: Sequence[Term], leaf: Callable[[Term], V | None]
) -> list[V]:
    """Instructions that compute terms.

    Parameters
    ----------
    arithmetic : Arithmetic
    terms : sequence of Term
    leaf : callable
        The value of a term that is known; None if it is to be computed.
    """
    known: dict[int, V] = {}

    def is_unknown(node: Term) -> bool:
        value = leaf(node)
        if value is not None:
            known[id(node)] = value
        return value is None

    nodes = topological_order(terms, is_unknown)
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
    """Terms in the parameters alone that are used by terms in the state.

    They are computed once for a trajectory; numbers are not among them.
    """
    nodes = topological_order(terms)
    moving: set[int] = set()
    for node in nodes:
        if node.kind == "state" or any(id(a) in moving for a in node.operands):
            moving.add(id(node))
    wanted: dict[int, Term] = {}
    for node in nodes:
        if id(node) in moving:
            wanted |= {id(a): a for a in node.operands if id(a) not in moving}
    wanted |= {id(t): t for t in terms if id(t) not in moving}
    return [t for t in wanted.values() if t.kind != "number"]


def functions(
    arithmetic: type[Arithmetic[V]],
    pieces: Mapping[str, Sequence[Term]],
    lanes: int,
    prepare: str = "prepare",
) -> tuple[str, int]:
    """The text of functions that compute formulas, and the number of shared constants.

    ``@prepare(constants, parameters)`` computes once what depends on parameters alone;
    ``@<piece>(result, state, constants)`` everything else.

    Parameters
    ----------
    arithmetic : Double or Pair
    pieces : mapping of str to sequence of Term
        The formulas of each function, by its name.
    lanes : int
    prepare : str
        The name of the first function.
    """
    constants = parameter_only_terms([term for terms in pieces.values() for term in terms])
    slots = {id(term): i for i, term in enumerate(constants)}
    texts = [_function(arithmetic, lanes, name, terms, slots) for name, terms in pieces.items()]
    number = arithmetic(IRWriter(lanes))

    def leaf(term: Term) -> V | None:
        return number.load("%parameters", term.args[0]) if term.kind == "parameter" else None

    for i, value in enumerate(evaluate(number, constants, leaf)):
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
) -> str:
    number = arithmetic(IRWriter(lanes))

    def leaf(term: Term) -> V | None:
        if id(term) in slots:
            return number.load("%constants", slots[id(term)])
        return number.load("%state", term.args[0]) if term.kind == "state" else None

    for i, value in enumerate(evaluate(number, terms, leaf)):
        number.store(value, "%result", i)
    arguments = "ptr noalias %result, ptr noalias %state, ptr noalias %constants"
    return number.writer.text(f"internal void @{name}({arguments})", "#1")
