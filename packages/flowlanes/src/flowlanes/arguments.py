"""Check of the arguments of public functions against their annotations.

An argument of the wrong type is a mistake in the call.  `arguments_checked` raises an error at
once, with a sentence that contains the function, the argument and the allowed values.  Where a
Python annotation is not precise enough (a start may be a mapping or a sequence), one of the types
below is used.
Annotations are resolved on the first call; a class that is imported under ``TYPE_CHECKING`` is
recognized by its name.
"""

from __future__ import annotations

import builtins
import inspect
import sys
from collections.abc import Callable, Iterable, Mapping
from functools import cache, wraps
from math import inf, isfinite
from types import NoneType
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
    are_formula_parameters,
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

#: Maximum number of characters of a refused value in a message.
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
#: Parameters of a formula: values by name or symbol, or declared with their meaning.
FormulaParameters: TypeAlias = Annotated[
    Any,
    Kind(
        "a mapping of names or symbols to numbers, or a sequence of Parameters",
        are_formula_parameters,
    ),
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
#: One number; as a string it may have more digits than a float.
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
    """Short description of a refused value."""
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


def arguments_checked(thing: T) -> T:
    """Function or class that raises InputError for arguments of other types than annotated.

    Parameters
    ----------
    thing
        A function, a method, or a class, whose constructor is checked.
    """
    if not isinstance(thing, type):
        name = thing.__qualname__.removesuffix(".__init__")
        return cast(T, _checking(thing, name, [thing.__module__]))
    # a dataclass inherits annotations that contain names of other modules
    modules = [base.__module__ for base in reversed(thing.__mro__)]
    checked_class: Any = thing
    checked_class.__init__ = _checking(checked_class.__init__, thing.__name__, modules)
    return thing


def _checking(function: Callable[..., Any], name: str, modules: list[str]) -> Callable[..., Any]:
    @cache  # delayed, because most functions of an imported module are never called
    def signature_and_kinds() -> tuple[inspect.Signature, dict[str, Kind | None]]:
        hints = get_type_hints(function, None, _Scope(modules), include_extras=True)
        return inspect.signature(function), {key: kind_of(hint) for key, hint in hints.items()}

    @wraps(function)
    def wrapper(*arguments: Any, **keywords: Any) -> Any:
        signature, kinds = signature_and_kinds()
        try:
            bound = signature.bind(*arguments, **keywords).arguments
        except TypeError:
            # Python's own message contains the name of the function
            return function(*arguments, **keywords)
        for argument, value in bound.items():
            if (kind := kinds.get(argument)) is None:
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


class _Scope(dict[str, Any]):
    """Names of given modules; any other name is taken as the name of a class."""

    def __init__(self, modules: Iterable[str]) -> None:
        super().__init__(vars(builtins) | globals())
        for module in modules:
            self |= vars(sys.modules[module])

    def __missing__(self, name: str) -> type:
        return _ByName(name, (), {})


class _ByName(type):
    """Class that is imported under ``TYPE_CHECKING``, or a module of such classes."""

    def __instancecheck__(cls, value: object) -> bool:
        return any(base.__name__ == cls.__name__ for base in type(value).__mro__)

    def __getattr__(cls, name: str) -> type:
        if name.startswith("__"):
            raise AttributeError(name)
        return _ByName(name, (), {})

    def __getitem__(cls, _: object) -> type:
        return cls
