"""Python source of the equations, for programs that compile or interpret Python.

It is generated from the graph of operations of the package, without repeated operations, and with
numbers for all parameter-only terms.  This is the best form that a user could write by hand.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from flowlanes.flow.kernel.tableaux import explicit
from flowlanes.formulas.graph import Term, of_system, topological_order

from .bodies import Body

__all__ = ["defined", "field_text", "increment", "operations", "step_text"]

_TEMPLATES: Mapping[str, str] = {
    "add": "{} + {}",
    "sub": "{} - {}",
    "mul": "{} * {}",
    "neg": "-{}",
    "recip": "1.0 / {}",
    "sqrt": "sqrt({})",
    "sin": "sin({})",
    "cos": "cos({})",
}


def field_text(body: Body) -> str:
    """Text of ``field(x0, …)``, which returns the rates as a tuple."""
    _, rates = of_system(body.system)
    names: dict[int, str] = {}
    lines = []
    for node in topological_order(rates):
        written = _write(node, names, body.numbers)
        if not (_number(written) or written.isidentifier()):
            lines.append(f"    v{len(lines)} = {written}")
            written = f"v{len(lines) - 1}"
        names[id(node)] = written
    state = _names("x", body.size)
    answer = ", ".join(names[id(rate)] for rate in rates)
    return "\n".join([f"def field({state}):", *lines, f"    return {answer}"])


def _write(node: Term, names: Mapping[int, str], numbers: Sequence[float]) -> str:
    if node.kind == "state":
        return f"x{node.args[0]}"
    if node.kind == "parameter":
        return repr(numbers[node.args[0]])
    if node.kind == "number":
        return repr(float(node.args[0]))
    operands = [names[id(a)] for a in node.operands]
    if node.kind == "mul" and "1.0" in operands:
        return operands[1 - operands.index("1.0")]
    written = _TEMPLATES[node.kind].format(*operands)
    if all(map(_number, operands)):
        return repr(defined(f"value = {written}", {})["value"])
    return written


def _number(text: str) -> bool:
    return text.lstrip("-")[:1].isdigit() and not any(c in text for c in "*+/ ")


def _names(letter: str, count: int, stage: str = "") -> str:
    return ", ".join(f"{letter}{stage}{i}" for i in range(count))


def step_text(size: int) -> str:
    """Text of ``step(h, x0, …)``: the state after a step of order 8, and two error estimates."""
    table = explicit()

    def combined(weights: Sequence[Any], i: int) -> str:
        return increment(weights, lambda stage: f"k{stage}_{i}")

    lines = []
    for stage, row in enumerate(table.a):
        places = ", ".join(f"x{i}{combined(row, i)}" for i in range(size))
        lines.append(f"    {_names('k', size, f'{stage}_')} = field({places})")
    wanted = [", ".join(f"x{i}{combined(table.b, i)}" for i in range(size))]
    for weights in (table.e3, table.e5):
        wanted += [", ".join(f"0.0{combined(weights, i)}" for i in range(size))]
    answer = ", ".join(wanted)
    return "\n".join([f"def step(h, {_names('x', size)}):", *lines, f"    return {answer}"])


def increment(weights: Sequence[Any], rate: Callable[[int], str]) -> str:
    """Increment of a component: h times weighted rates of stages."""
    terms = [f"{float(w)!r} * {rate(stage)}" for stage, w in enumerate(weights) if w != 0]
    return f" + h * ({' + '.join(terms)})" if terms else ""


def defined(text: str, known: Mapping[str, Any]) -> dict[str, Any]:
    """Names defined by a text."""
    names = dict(known)
    exec(text, names)
    return names


def operations(body: Body) -> dict[str, int]:
    """Arithmetic operations in one evaluation of the rates by this engine, by kind.

    Parameter-only terms are computed once per motion and are not included.
    """
    _, rates = of_system(body.system)
    nodes = topological_order(rates)
    moving: set[int] = set()
    for node in nodes:
        if node.kind == "state" or any(id(a) in moving for a in node.operands):
            moving.add(id(node))
    found = (n.kind for n in nodes if id(n) in moving and n.kind != "state")
    return dict(Counter(found))
