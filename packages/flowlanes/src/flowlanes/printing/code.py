"""Functions and source text for the vector field of a System.

In every target the state is a flat array `x` in the order of ``system.symbols`` and the parameters
are a flat array `p` in the order of ``system.parameters``; definitions are computed once, in
order, under their own names.
"""

from __future__ import annotations

import importlib
import keyword
import re
import textwrap
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence, Sized
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from ..arguments import arguments_checked
from ..errors import InputError
from ..system.arrays import FloatArray
from .system import field_text

if TYPE_CHECKING:
    from ..system.system import System

Field = Callable[..., Any]
Assignments = list[tuple[sp.Symbol, sp.Expr]]


@arguments_checked
def lambdify(system: System, target: str = "numpy") -> Field:
    """A function that returns the time derivative of the flat state.

    Parameters
    ----------
    system : System
    target : ``"numpy"``, ``"jax"`` or ``"numba"``
        ``"numpy"``: takes and returns NumPy arrays. ``"jax"``: compiled by ``jax.jit``; it
        supports ``jax.grad``, ``jax.jacfwd`` and ``jax.vmap``, and computes in single precision
        unless ``jax.config.update("jax_enable_x64", True)`` was called. ``"numba"``: compiled by
        ``numba.njit`` on the first call, and callable from other compiled functions.

    Returns
    -------
    callable
        ``f(t, x, p=None)``, the time derivative of `x` at time t. `x` has shape (n,) with n the
        length of ``system.symbols``; for ``"numpy"`` it may have shape (n, k) for k states at
        once. `p` contains the values of ``system.parameters``; by default their default values.

    Raises
    ------
    InputError
        If the target is unknown or its package is not installed. The functions for ``"numpy"`` and
        ``"jax"`` raise it for arrays of a wrong length.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> rate = flowlanes.lambdify(pendulum)
    >>> [float(number) for number in rate(0.0, [1.0, 2.0]).round(6)]
    [2.0, -0.841471]
    """
    if target not in TARGETS:
        raise InputError(f"target {target!r}: it must be one of {', '.join(map(repr, TARGETS))}")
    return TARGETS[target](system)


@arguments_checked
def source_code(system: System, language: str) -> str:
    """Readable source text of a function for the time derivative of the flat state.

    Parameters
    ----------
    system : System
    language : ``"c"``, ``"javascript"`` or ``"julia"``
        ``"c"``: C99, ``void pendulum(double t, const double *x, const double *p,
        double *dx)``.  ``"javascript"``: a module that exports ``pendulum(t, x, p, dx = [])``,
        which fills and returns ``dx``.  ``"julia"``: ``pendulum!(dx, x, p, t)``, as
        DifferentialEquations.jl takes it.  The name comes from the name of the system.

    Returns
    -------
    str
        The function, preceded by a comment with the order of state and parameters.

    Raises
    ------
    InputError
        If the language is unknown.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> code = flowlanes.source_code(pendulum, "julia")
    >>> [line for line in code.splitlines() if line.startswith("function")]
    ['function pendulum!(dx, x, p, t)']
    """
    if language not in LANGUAGES:
        allowed = ", ".join(map(repr, LANGUAGES))
        raise InputError(f"language {language!r}: it must be one of {allowed}")
    return LANGUAGES[language].render(system)


# --- functions -----------------------------------------------------------------------------


def _library(name: str, target: str) -> ModuleType:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise InputError(
            f"the target {target!r} needs the package {name}: pip install {name}"
        ) from None


def _field_function(system: System, modules: str) -> Field:
    """The function ``f(t, x, p)`` that returns the list of rates, from elements of x and p."""
    x, p = sp.DeferredVector("x"), sp.DeferredVector("p")
    names = _identifiers(system, _PYTHON)
    steps, rates = _assignments(system, names)
    used = _used_symbols(steps, rates)
    loads = [
        (names[symbol], array[index])
        for array, symbols in ((x, system.symbols), (p, [p.symbol for p in system.parameters]))
        for index, symbol in enumerate(symbols)
        if names[symbol] in used
    ]
    built: Field = sp.lambdify(
        [sp.Symbol("t"), x, p],
        rates,
        modules=modules,
        cse=lambda formulas: ([*loads, *steps], formulas),
    )
    return built


def _defaults(system: System) -> FloatArray:
    return np.array([p.default for p in system.parameters], dtype=float)


def _check_lengths(system: System, x: Sized, p: Sized) -> None:
    for name, values, wanted, order in (
        ("x", x, len(system.symbols), "symbols"),
        ("p", p, len(system.parameters), "parameters"),
    ):
        if len(values) != wanted:
            raise InputError(
                f"{system.name}: {name} has {len(values)} entries; it needs {wanted}, in the "
                f"order of system.{order}"
            )


def _numpy(system: System) -> Field:
    rates, defaults = _field_function(system, "numpy"), _defaults(system)

    def field(t: float, x: Any, p: Any = None) -> Any:
        x, p = np.asarray(x, dtype=float), defaults if p is None else p
        _check_lengths(system, x, p)
        return np.array(np.broadcast_arrays(*rates(t, x, p), x[0])[:-1])

    return field


def _jax(system: System) -> Field:
    jax, jnp = _library("jax", "jax"), _library("jax.numpy", "jax")
    rates, defaults = _field_function(system, "jax"), _defaults(system)

    def field(t: float, x: Any, p: Any = None) -> Any:
        p = defaults if p is None else p
        _check_lengths(system, x, p)
        x, p = jnp.asarray(x), jnp.asarray(p)
        return jnp.stack(jnp.broadcast_arrays(*rates(t, x, p), x[0])[:-1])

    compiled: Field = jax.jit(field)
    return compiled


def _numba(system: System) -> Field:
    numba = _library("numba", "numba")
    rates, defaults = numba.njit(_field_function(system, "numpy")), _defaults(system)

    def field(t: float, x: Any, p: Any = None) -> Any:
        # The branch is resolved at compile time by the type of p.
        if p is None:
            return np.array(rates(t, x, defaults), dtype=np.float64)
        return np.array(rates(t, x, p), dtype=np.float64)

    compiled: Field = numba.njit(field)
    return compiled


TARGETS: Mapping[str, Callable[[System], Field]] = {"numpy": _numpy, "jax": _jax, "numba": _numba}
"""The targets of :func:`lambdify`."""


# --- names and assignments -----------------------------------------------------------------


def _word_set(*lines: str) -> frozenset[str]:
    return frozenset(word for line in lines for word in line.split())


_FUNCTIONS = _word_set(
    "sqrt cbrt sin cos tan asin acos atan atan2 sinh cosh tanh exp log pow abs fabs pi"
)

_PYTHON = _word_set("t x p jax math numpy arcsin arccos arctan arctan2 e E", *keyword.kwlist)


def _identifiers(system: System, reserved_words: Iterable[str]) -> dict[sp.Symbol, sp.Symbol]:
    """Identifiers of the symbols; clashing ones get a trailing underscore."""
    reserved_words = _FUNCTIONS.union(reserved_words)
    ours = [
        *system.symbols,
        *(p.symbol for p in system.parameters),
        *dict(system.scalar_definitions),
    ]
    spelt = {str(symbol) for symbol in ours}
    names = {}
    for symbol in ours:
        name = str(symbol)
        while name in reserved_words or (name != str(symbol) and name in spelt):
            name += "_"
        names[symbol] = sp.Symbol(name, real=True)
    return names


def _assignments(
    system: System, names: Mapping[sp.Symbol, sp.Symbol]
) -> tuple[Assignments, list[sp.Expr]]:
    """The definitions that the vector field needs, and the rates, with the given identifiers."""
    steps = [
        (names[symbol], value.xreplace(names))
        for symbol, value in system.required_definitions(system.rates)
    ]
    return steps, [value.xreplace(names) for value in system.rates]


def _used_symbols(steps: Assignments, rates: Iterable[sp.Expr]) -> set[sp.Symbol]:
    return set().union(*(e.free_symbols for e in (*rates, *(value for _, value in steps))))


# --- source text ---------------------------------------------------------------------------

#: Line length of running text in comments.
_WIDTH = 96


class _Language(ABC):
    """The rules for writing a function in a programming language."""

    reserved_words: frozenset[str]
    comment: str

    def render(self, system: System) -> str:
        """The complete source text."""
        identifier = re.sub(r"\W", "_", system.name, flags=re.ASCII)
        identifier = f"f_{identifier}" if identifier[:1].isdigit() else identifier
        if identifier in self.reserved_words:
            identifier += "_"
        names = _identifiers(system, {*self.reserved_words, identifier})
        steps, rates = _assignments(system, names)
        used = _used_symbols(steps, rates)
        parameters = [p.symbol for p in system.parameters]
        body = [
            self.assignment(str(names[symbol]), self.element(array, index))
            for array, symbols in (("x", system.symbols), ("p", parameters))
            for index, symbol in enumerate(symbols)
            if names[symbol] in used
        ]
        body += [self.assignment(str(name), self.write(value)) for name, value in steps]
        body += [
            self.store(self.element("dx", index), self.write(value))
            for index, value in enumerate(rates)
        ]
        # A backslash at the end of a line would continue a comment in C.
        header = [f"{self.comment} {line}".rstrip(" \\") for line in self._header(system)]
        return "\n".join([*header, *self.wrap(identifier, body)]) + "\n"

    def _header(self, system: System) -> list[str]:
        """Equations, order of state and parameters, and source, as comment lines."""
        lines = [system.title, *textwrap.wrap(system.summary, _WIDTH)]
        lines += ["", "Equations of motion:"]
        lines += field_text(system)
        if system.source:
            lines.append(f"Source: {system.source}")
        lines += ["", "State:"]
        lines += [f"  {self.element('x', i)} = {s}" for i, s in enumerate(system.symbols)]
        if system.parameters:
            lines += ["", "Parameters, with their default values:"]
        for i, p in enumerate(system.parameters):
            unit = f" {p.unit}" if p.unit else ""
            lines.append(
                f"  {self.element('p', i)} = {p.symbol} = {float(p.default)!r}{unit}: {p.meaning}"
            )
        return [" ".join(line.splitlines()) for line in lines]

    @abstractmethod
    def element(self, array: str, index: int) -> str:
        """Element `index` of an array, counted from 0."""

    @abstractmethod
    def write(self, formula: sp.Expr) -> str:
        """A scalar formula as source text."""

    @abstractmethod
    def assignment(self, name: str, value: str) -> str:
        """The definition of a local variable."""

    @abstractmethod
    def store(self, place: str, value: str) -> str:
        """The assignment of a result."""

    @abstractmethod
    def wrap(self, identifier: str, body: Sequence[str]) -> list[str]:
        """The function around its body."""


def _c_power(base: str, exponent: str) -> str:
    """A power in C; small powers of a variable are products, for readability."""
    named = re.fullmatch(r"\w+", base)
    if named and exponent in ("2", "3", "4"):
        return f"({'*'.join([base] * int(exponent))})"
    reciprocal = f"(1.0/{base})" if named else f"(1.0/({base}))"
    written = {"-1": reciprocal, "1.0/2.0": f"sqrt({base})"}
    return written.get(exponent, f"pow({base}, {exponent})")


class _C(_Language):
    comment = "//"
    reserved_words = _word_set(
        "t x p dx auto break case char const continue default do double else enum extern float",
        "for goto if inline int long register restrict return short signed sizeof static struct",
        "switch typedef union unsigned void volatile while",
    )

    def element(self, array: str, index: int) -> str:
        return f"{array}[{index}]"

    def write(self, formula: sp.Expr) -> str:
        powers = {"Pow": [(lambda base, exponent: True, _c_power)]}
        # C99 has no names for these constants.
        numbers = {constant: constant.evalf(17) for constant in (sp.pi, sp.E)}
        return str(sp.ccode(formula.xreplace(numbers), standard="c99", user_functions=powers))

    def assignment(self, name: str, value: str) -> str:
        return f"const double {name} = {value};"

    def store(self, place: str, value: str) -> str:
        return f"{place} = {value};"

    def wrap(self, identifier: str, body: Sequence[str]) -> list[str]:
        return [
            "#include <math.h>",
            "",
            f"void {identifier}(double t, const double *x, const double *p, double *dx)",
            "{",
            "    (void)t; (void)x; (void)p;",
            *(f"    {line}" for line in body),
            "}",
        ]


class _Julia(_Language):
    comment = "#"
    reserved_words = _word_set(
        "t x p dx baremodule begin break catch const continue do else elseif end export false",
        "finally for function global if import in isa let local macro module quote return struct",
        "true try using where while",
    )

    def element(self, array: str, index: int) -> str:
        return f"{array}[{index + 1}]"

    def write(self, formula: sp.Expr) -> str:
        exact = formula.xreplace({sp.E: sp.Symbol("MathConstants.e")})
        written = sp.julia_code(exact, user_functions={"atan2": "atan"})
        # The printer assumes arrays; these are scalars.
        return re.sub(r" \.([*/^]) ", r" \1 ", str(written))

    def assignment(self, name: str, value: str) -> str:
        return f"{name} = {value}"

    def store(self, place: str, value: str) -> str:
        return f"{place} = {value}"

    def wrap(self, identifier: str, body: Sequence[str]) -> list[str]:
        lines = (f"    {line}" for line in (*body, "return nothing"))
        return [f"function {identifier}!(dx, x, p, t)", *lines, "end"]


class _JavaScript(_Language):
    comment = "//"
    reserved_words = _word_set(
        "t x p dx Math arguments await break case catch class const continue debugger default",
        "delete do else enum eval export extends false finally for function if implements import",
        "in instanceof interface let new null package private protected public return static super",
        "switch this throw true try typeof undefined var void while with yield NaN Infinity",
    )

    def element(self, array: str, index: int) -> str:
        return f"{array}[{index}]"

    def write(self, formula: sp.Expr) -> str:
        return str(sp.jscode(formula))

    def assignment(self, name: str, value: str) -> str:
        return f"const {name} = {value};"

    def store(self, place: str, value: str) -> str:
        return f"{place} = {value};"

    def wrap(self, identifier: str, body: Sequence[str]) -> list[str]:
        lines = (f"  {line}" for line in (*body, "return dx;"))
        return [f"export function {identifier}(t, x, p, dx = []) {{", *lines, "}"]


#: The languages of :func:`source_code`.
LANGUAGES: Mapping[str, _Language] = {"c": _C(), "javascript": _JavaScript(), "julia": _Julia()}
