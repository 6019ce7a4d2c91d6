"""Arguments of public functions, checked against their annotations.

An argument of the wrong type is a mistake of whoever wrote the call; `arguments_checked` answers it
at once with a sentence that names the function, the argument and what is allowed.  Where an
annotation alone says too little (a start may be a mapping or a sequence), the types below say it.
Names that only type checkers import are looked up when a function is called first.
"""

from __future__ import annotations

import ast
import builtins
import inspect
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import is_dataclass
from functools import cache, wraps
from importlib import import_module
from importlib.util import resolve_name
from math import inf, isfinite
from types import ModuleType, NoneType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    SupportsFloat,
    TypeAlias,
    TypeVar,
    cast,
    get_type_hints,
)

from .argument_kinds import (
    Kind,
    are_conditions,
    are_formulas,
    are_named_formulas,
    are_numbers,
    are_parameters,
    class_name,
    is_collection,
    is_formula,
    is_number,
    is_number_or_text,
    is_row,
    is_start,
    kind_of,
)
from .errors import InputError

if TYPE_CHECKING:
    from sympy import Expr, Symbol

T = TypeVar("T", bound=Callable[..., Any])

#: Characters of a refused value that are shown.
_LONGEST = 60

#: A state: numbers in flat order, or by name.
Start: TypeAlias = Annotated[
    Any, Kind("a state: numbers in order, or numbers by name in a mapping", is_start)
]
#: The value of a parameter, or one for each motion; text keeps all digits of a number.
ParameterValue: TypeAlias = SupportsFloat | str | Iterable[SupportsFloat | str]
#: Values of parameters by symbol or name, or None for the defaults.
Parameters: TypeAlias = Annotated[
    "Mapping[str, ParameterValue] | Mapping[Symbol, ParameterValue] | None",
    Kind("a mapping of parameters to numbers", are_parameters),
]
#: One number, as a length or a duration is.
Positive: TypeAlias = Annotated[
    float,
    Kind("a positive finite number", lambda value: is_number(value) and 0 < float(value) < inf),
]
Finite: TypeAlias = Annotated[
    float, Kind("a finite number", lambda value: is_number(value) and isfinite(float(value)))
]
Numbers: TypeAlias = Annotated[
    Iterable[SupportsFloat | str], Kind("a sequence of numbers", are_numbers)
]
#: One number; in quotes it keeps digits that a float has not.
NumberOrText: TypeAlias = Annotated[SupportsFloat | str, Kind("a number", is_number_or_text)]
Formula: TypeAlias = Annotated["Expr | float", Kind("a SymPy expression", is_formula)]
#: One formula, or several in a matrix or in nested sequences.
Formulas: TypeAlias = Annotated[
    Any, Kind("a SymPy expression, a matrix or a sequence of these", are_formulas)
]
#: A scalar of a system by its name, as a formula in text, or as an expression.
Quantity: TypeAlias = Annotated[
    Any,
    Kind(
        "a name, a formula in quotes or a SymPy expression",
        lambda value: isinstance(value, str) or is_formula(value),
    ),
]
#: A parameter of a system of the catalogue: a number, or numbers in rows.
Setting: TypeAlias = Annotated[
    Any,
    Kind(
        "a number, or numbers in a list",
        lambda value: is_number(value) or (is_collection(value) and all(map(is_row, value))),
    ),
]
#: Conditions on parameters: relations, or several joined by and, or, not.
Conditions: TypeAlias = Annotated[
    tuple[Any, ...],
    Kind("a tuple of relations such as a > 0, or of several joined by & and |", are_conditions),
]
#: Named quantities with their formulas, as a mapping or as pairs.
NamedFormulas: TypeAlias = Annotated[
    Any,
    Kind(
        "a mapping of symbols to SymPy expressions, or a sequence of such pairs", are_named_formulas
    ),
]


def _short_text(value: Any) -> str:
    """A refused value in a few words."""
    if isinstance(value, str):
        return f"the text {value[:_LONGEST]!r}"
    if isinstance(value, type):
        return f"the class {value.__name__} itself"
    plain = (bool, int, float, complex, NoneType, list, tuple, dict, set, bytes)
    if isinstance(value, plain) or class_name(value) in ("ndarray", "mpf"):
        try:
            text = " ".join(repr(value).split())
        except ValueError:  # an integer of too many digits
            text = "a number too large"
        return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."
    return f"{'an' if class_name(value)[0] in 'AEIO' else 'a'} {class_name(value)}"


def _kinds(thing: Any, modules: Iterable[str]) -> dict[str, Kind]:
    # a module may use the types above without what they are made of
    hints = annotations_of(thing, modules, globals())
    kinds = {name: kind_of(hint) for name, hint in hints.items()}
    return {name: kind for name, kind in kinds.items() if kind is not None}


def arguments_checked(thing: T) -> T:
    """Refuse arguments of other types than annotated, with an InputError.

    Parameters
    ----------
    thing
        A function, a method, or a dataclass, whose making is then checked.
    """
    if isinstance(thing, type):
        modules = [base.__module__ for base in reversed(thing.__mro__)]
        checked_class: Any = thing
        typed = thing if is_dataclass(thing) else checked_class.__init__
        checked_class.__init__ = _checking(
            checked_class.__init__, thing.__name__, lambda: _kinds(typed, modules)
        )
        return thing
    name = thing.__qualname__.removesuffix(".__init__")
    return cast(T, _checking(thing, name, lambda: _kinds(thing, [thing.__module__])))


def _checking(
    function: Callable[..., Any], name: str, kinds: Callable[[], dict[str, Kind]]
) -> Callable[..., Any]:
    # when first called: most functions of a module that is imported never are
    signature_of, known = cache(lambda: inspect.signature(function)), cache(kinds)

    @wraps(function)
    def wrapper(*arguments: Any, **keywords: Any) -> Any:
        signature = signature_of()
        try:
            bound = signature.bind(*arguments, **keywords).arguments
        except TypeError:
            # Python's own sentence names the function
            return function(*arguments, **keywords)
        for argument, value in bound.items():
            if (kind := known().get(argument)) is None:
                continue
            match signature.parameters[argument].kind:
                case inspect.Parameter.VAR_KEYWORD:
                    each = list(value.items())
                case inspect.Parameter.VAR_POSITIONAL:
                    each = [(argument, item) for item in value]
                case _:
                    each = [(argument, value)]
            for place, item in each:
                if not kind.fits(item):
                    raise InputError(
                        f"{name}: {place} must be {kind.words}, not {_short_text(item)}"
                    )
        return function(*arguments, **keywords)

    return wrapper


# --- annotations ----------------------------------------------------------------------------


def annotations_of(
    thing: Any, modules: Iterable[str], further: Mapping[str, Any]
) -> dict[str, Any]:
    """The annotations of a function or a method by argument; Any where one cannot be had.

    Parameters
    ----------
    thing : function or class
    modules : iterable of str
        Names of the modules in whose names the annotations are written.
    further : mapping of str to object
        Names that those modules need not have.
    """
    return get_type_hints(thing, None, _Scope(modules, further), include_extras=True)


class _Scope(dict[str, Any]):
    """Names of modules; those that they import for type checkers alone are looked up."""

    def __init__(self, modules: Iterable[str], further: Mapping[str, Any]) -> None:
        self.further = further
        self.modules = [sys.modules[module] for module in modules]
        for module in self.modules:
            self |= vars(module)

    def __missing__(self, name: str) -> Any:
        if hasattr(builtins, name):
            return getattr(builtins, name)
        if name in self.further:
            return self.further[name]
        for module in self.modules:
            if (origin := _imports_for_type_checkers(module).get(name)) is None:
                continue
            where, what = origin
            own = where.partition(".")[0] == __package__
            # what is no part of this program, and not in use, has no values
            source = import_module(where) if own else sys.modules.get(where)
            return getattr(source, what, Any) if what else source or _UnknownModule()
        return Any


class _UnknownModule:
    """A module that is not in use, so that nothing is known of what it defines."""

    def __getattr__(self, name: str) -> Any:
        return Any


#: A block that only type checkers carry out, up to the next line that is not indented.
_FOR_TYPE_CHECKERS = re.compile(r"^if TYPE_CHECKING:.*\n(?:[ \t#)].*\n|\n)+", re.MULTILINE)


@cache
def _imports_for_type_checkers(module: ModuleType) -> dict[str, tuple[str, str]]:
    """The imports of a module under ``if TYPE_CHECKING``: name ↦ module and name there."""
    origins: dict[str, tuple[str, str]] = {}
    try:
        source = inspect.getsource(module)
    except (OSError, TypeError):  # a module that is not written in Python
        return origins
    # to parse a whole module of SymPy takes a tenth of a second
    for block in _FOR_TYPE_CHECKERS.findall(source + "\n"):
        for statement in cast("ast.If", ast.parse(block).body[0]).body:
            if isinstance(statement, ast.Import):
                origins |= {item.asname or item.name: (item.name, "") for item in statement.names}
            elif isinstance(statement, ast.ImportFrom):
                relative = "." * statement.level + (statement.module or "")
                where = resolve_name(relative, module.__package__ or "")
                origins |= {
                    item.asname or item.name: (where, item.name) for item in statement.names
                }
    return origins
