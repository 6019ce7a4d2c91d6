"""Formulas of a System at many states at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import arguments_checked
from ..errors import InputError
from ..parsing import NamedQuantity, parse_formula
from ..system.arrays import BoolArray, FloatArray
from ..system.named_formulas import Quantity
from ..system.parameters import Parameters, parameters_by_symbol, require_admissible
from ..system.system import System
from .digest import canonical
from .graph import Reader, Term, of_system, term_values, topological_order


def _positive(test: FloatArray, yes: FloatArray, no: FloatArray) -> FloatArray:
    chosen: FloatArray = np.where(test > 0, yes, no)
    return chosen


#: The operations of terms as functions of arrays.
NUMPY: Mapping[str, Callable[..., FloatArray]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "neg": np.negative,
    "recip": np.reciprocal,
    "sqrt": np.sqrt,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "atan2": np.arctan2,
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "exp": np.exp,
    "log": np.log,
    "abs": np.abs,
    "sign": np.sign,
    "positive": _positive,
}


def relation_terms(system: System) -> tuple[Term, ...]:
    """Relations of a system as terms, followed by the sizes of their summands.

    The size of f is Σ |xᵢ ∂f/∂xᵢ|.
    """
    reader, _ = read_formulas(system)
    graph = reader.graph
    states = [graph.state(i) for i in range(len(system.symbols))]
    relations = [reader(relation) for relation in system.relations]
    sizes = []
    for row in graph.jacobian(relations, states):
        size = graph.number(0)
        for x, slope in zip(states, row, strict=True):
            size = size + graph.call("abs", x * slope)
        sizes.append(size)
    return (*relations, *sizes)


@lru_cache(maxsize=64)
def read_formulas(system: System) -> tuple[Reader, tuple[Term, ...]]:
    """Reader of the formulas of a system, and the rates of its state, from a cache."""
    # This form is the one that a worker receives, so that bits are the same everywhere.
    reader, rates = of_system(canonical(system))
    return reader, tuple(rates)


def as_float_array(name: str, numbers: object) -> FloatArray:
    """Numbers as doubles.

    Raises
    ------
    InputError
        If they are not real numbers; `name` is used in the message.
    """
    try:
        return np.asarray(numbers, dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{name}: all must be real numbers, in rows of one length") from None


def formula(system: System, quantity: sp.Expr | float | str, where: str = "") -> sp.Expr:
    """Scalar formula of a system, given as an expression or as text.

    Parameters
    ----------
    system : System
    quantity : SymPy expression, number or str
        A text is the name of a scalar observable or of an integral (``"energy"``), or a formula in
        the state, the definitions and the parameters (``"dot(M, M) - 0.3"``, ``"M_3"``).
    where : str
        Beginning of an error message; by default the name of the system.

    Raises
    ------
    InputError
        If the text cannot be parsed, or is not a scalar.
    """
    expression = quantity
    if isinstance(quantity, str):
        named = {item.name: item.value for item in system.observables}
        named |= {law.name: law.value for law in system.integrals}
        expression = named.get(quantity)
        if expression is None:
            expression = parse_formula(
                quantity, _names(system), where or f"{system.name}: quantity"
            )
    value = system.scalar.of(expression)
    if isinstance(value, sp.MatrixBase):
        raise InputError(
            f"{quantity} is a vector; name one of its components", where or system.name
        )
    return value


def _names(system: System) -> dict[str, NamedQuantity]:
    quantities: list[Quantity] = [*system.state, *(name for name, _ in system.definitions)]
    quantities.extend(p.symbol for p in system.parameters)
    # A symmetric tensor has no name in formulas.
    return {str(q): q for q in quantities if isinstance(q, NamedQuantity)}


def parameter_rows(system: System, parameters: Parameters | None, count: int) -> FloatArray:
    """Values of the parameters in order, (1, parameters), or (count, parameters) if some vary.

    Parameters
    ----------
    system : System
    parameters : mapping of Symbol or name to number or array (count,), optional
        Values that replace the defaults.
    count : int
        Number of motions.

    Raises
    ------
    InputError
        If a name is unknown, a value is not finite or not admissible, or an array has a different
        length.
    """
    if not parameters:
        return np.array([[value for _, value in system.default_values]])
    parameters_by_symbol(system, parameters)
    columns: dict[str, FloatArray | float] = dict(system.default_values)
    for key, value in parameters.items():
        column = as_float_array(f"{system.name}: {key}", value)
        if column.shape not in ((), (count,)):
            raise InputError(
                f"{system.name}: {key} has the shape {column.shape}; it must be one number or "
                f"{count}, one for each motion"
            )
        if not np.all(np.isfinite(column)):
            raise InputError(f"{system.name}: {key} must be finite numbers")
        columns[str(key)] = column
    varied = any(np.ndim(column) for column in columns.values())
    rows = np.empty((count if varied else 1, len(columns)))
    for i, entries in enumerate(columns.values()):
        rows[:, i] = entries
    require_admissible(system, dict(zip(system.defaults, rows.T, strict=True)))
    return rows


@arguments_checked
def values(
    system: System,
    formulas: Sequence[sp.Expr | float | str],
    states: npt.ArrayLike,
    parameters: Parameters | None = None,
) -> FloatArray:
    """Scalar formulas at many states.

    Parameters
    ----------
    system : System
    formulas : sequence of SymPy expressions or str
        See :func:`formula`.
    states : array (..., size)
    parameters : mapping of Symbol or name to number or array (n,), optional
        Arrays have a value for each row of `states` (first axis).

    Returns
    -------
    array (..., formulas)

    Raises
    ------
    InputError
        If a formula or a parameter is not valid.

    Examples
    --------
    >>> import flowlanes
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> flowlanes.formulas.values(pendulum, ["v**2/2", x * v], [[1.0, 2.0], [3.0, 4.0]])
    array([[ 2.,  2.],
           [ 8., 12.]])
    """
    terms, points, rows = _at_states(system, formulas, states, parameters)
    return numbers(terms, points, rows)


def overflows(
    system: System,
    formulas: Sequence[Quantity],
    states: npt.ArrayLike,
    parameters: Parameters | None = None,
) -> BoolArray:
    """True where an intermediate result of formulas overflows, at states (n, size).

    A quotient by zero and a logarithm of zero are not included: they have no value at any
    precision.

    Returns
    -------
    array (n,) of bool
    """
    terms, points, rows = _at_states(system, formulas, states, parameters)
    order = _in_order(tuple(terms))
    known = _values_by_term(order, points, rows)
    found = np.zeros(points.shape[:-1], dtype=bool)
    for node in order:
        if node.kind in _OVERFLOWING:
            operands = [known[id(operand)] for operand in node.operands]
            regular = np.all(
                [np.isfinite(value) for value in np.broadcast_arrays(*operands)], axis=0
            )
            if node.kind == "recip":
                regular = regular & (operands[0] != 0.0)
            found |= regular & np.isinf(known[id(node)])
    return found


#: Operations that may give infinity at finite arguments because the result is too large for a
#: double.
_OVERFLOWING = frozenset({"add", "sub", "mul", "recip", "exp", "sinh", "cosh"})


def _at_states(
    system: System,
    formulas: Sequence[Quantity],
    states: npt.ArrayLike,
    parameters: Parameters | None,
) -> tuple[list[Term], FloatArray, FloatArray]:
    """Formulas as terms, states as an array, and parameters as matching rows."""
    points = as_float_array("states", states)
    size = len(system.symbols)
    if points.shape[-1:] != (size,):
        raise InputError(
            f"{system.name}: states have the shape {points.shape}; their last axis must be {size}"
        )
    reader, _ = read_formulas(system)
    terms = [reader(formula(system, f)) for f in formulas]
    rows = parameter_rows(system, parameters, len(points))
    spread = rows.reshape(len(rows), *([1] * (points.ndim - 2)), rows.shape[1])
    if len(rows) == 1:
        spread = rows[0]
    return terms, points, spread


@lru_cache(maxsize=64)
def _in_order(terms: tuple[Term, ...]) -> tuple[Term, ...]:
    """Terms on which others depend, operands first.

    They are cached for terms that are evaluated often.
    """
    return tuple(topological_order(terms))


def numbers(terms: Sequence[Term], states: FloatArray, parameters: FloatArray) -> FloatArray:
    """Terms at states (..., size) with parameters (..., parameters): (..., terms)."""
    known = _values_by_term(_in_order(tuple(terms)), states, parameters)
    result = np.empty((*states.shape[:-1], len(terms)))
    for i, term in enumerate(terms):
        result[..., i] = known[id(term)]
    return result


def _values_by_term(
    order: tuple[Term, ...], states: FloatArray, parameters: FloatArray
) -> dict[int, FloatArray | np.float64]:
    """Values of terms in order, by their identity."""

    def leaf(node: Term) -> FloatArray | np.float64:
        if node.number is not None:
            return np.float64(float(node.number))
        return (states if node.kind == "state" else parameters)[..., node.args[0]]

    with np.errstate(all="ignore"):
        return term_values(order, leaf, NUMPY)
