"""Arguments of public functions, checked against their annotations.

An argument of the wrong type is a mistake of whoever wrote the call; `arguments_checked` answers it
at once with a sentence that names the function, the argument and what is allowed.  Where an
annotation alone says too little (a start may be a mapping or a sequence), the types below say it.
"""

from __future__ import annotations

import inspect
import os
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, is_dataclass
from functools import cache, wraps
from math import inf, isfinite
from pathlib import Path
from types import NoneType, UnionType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Literal,
    SupportsFloat,
    TypeAlias,
    TypeVar,
    Union,
    cast,
    get_args,
    get_origin,
)

from .annotations import annotations_of
from .argument_values import (
    are_formulas,
    are_named_formulas,
    are_numbers,
    are_parameters,
    class_name,
    is_array_like,
    is_collection,
    is_formula,
    is_integer,
    is_number,
    is_number_or_text,
    is_numeric_array,
    is_row,
    is_start,
    length,
)
from .errors import InputError

if TYPE_CHECKING:
    from sympy import Expr, Symbol

T = TypeVar("T", bound=Callable[..., Any])

#: Characters of a refused value that are shown.
_LONGEST = 60


@dataclass(frozen=True)
class _Kind:
    """Allowed values in words, and a test for them."""

    words: str
    fits: Callable[[Any], bool]


#: A state: numbers in flat order, or by name.
Start: TypeAlias = Annotated[
    Any, _Kind("a state: numbers in order, or numbers by name in a mapping", is_start)
]
#: The value of a parameter, or one for each motion; text keeps all digits of a number.
ParameterValue: TypeAlias = SupportsFloat | str | Iterable[SupportsFloat | str]
#: Values of parameters by symbol or name, or None for the defaults.
Parameters: TypeAlias = Annotated[
    "Mapping[str, ParameterValue] | Mapping[Symbol, ParameterValue] | None",
    _Kind("a mapping of parameters to numbers", are_parameters),
]
#: One number, as a length or a duration is.
Positive: TypeAlias = Annotated[
    float,
    _Kind("a positive finite number", lambda value: is_number(value) and 0 < float(value) < inf),
]
Finite: TypeAlias = Annotated[
    float, _Kind("a finite number", lambda value: is_number(value) and isfinite(float(value)))
]
Numbers: TypeAlias = Annotated[
    Iterable[SupportsFloat | str], _Kind("a sequence of numbers", are_numbers)
]
#: One number; in quotes it keeps digits that a float has not.
NumberOrText: TypeAlias = Annotated[SupportsFloat | str, _Kind("a number", is_number_or_text)]
Formula: TypeAlias = Annotated["Expr | float", _Kind("a SymPy expression", is_formula)]
#: One formula, or several in a matrix or in nested sequences.
Formulas: TypeAlias = Annotated[
    Any, _Kind("a SymPy expression, a matrix or a sequence of these", are_formulas)
]
#: A scalar of a system by its name, as a formula in text, or as an expression.
Quantity: TypeAlias = Annotated[
    Any,
    _Kind(
        "a name, a formula in quotes or a SymPy expression",
        lambda value: isinstance(value, str) or is_formula(value),
    ),
]
#: A parameter of a system of the catalogue: a number, or numbers in rows.
Setting: TypeAlias = Annotated[
    Any,
    _Kind(
        "a number, or numbers in a list",
        lambda value: is_number(value) or (is_collection(value) and all(map(is_row, value))),
    ),
]
#: Named quantities with their formulas, as a mapping or as pairs.
NamedFormulas: TypeAlias = Annotated[
    Any,
    _Kind(
        "a mapping of symbols to SymPy expressions, or a sequence of such pairs", are_named_formulas
    ),
]

_ARRAY = _Kind("an array of numbers", is_numeric_array)
_ARRAY_LIKE = _Kind("numbers in an array or in nested sequences", is_array_like)

_SIMPLE: dict[Any, _Kind] = {
    float: _Kind("a number", is_number),
    int: _Kind("a whole number", is_integer),
    bool: _Kind(
        "True or False", lambda value: isinstance(value, bool) or class_name(value) == "bool"
    ),
    str: _Kind("a text", lambda value: isinstance(value, str)),
    Path: _Kind("a path", lambda value: isinstance(value, os.PathLike)),
    NoneType: _Kind("None", lambda value: value is None),
}


def _kind(annotation: Any) -> _Kind | None:
    """The values that an annotation allows; None if it allows any."""
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return next((note for note in inner[1:] if isinstance(note, _Kind)), _kind(inner[0]))
    if origin in (Union, UnionType) and inner[: len(_array_like())] == _array_like():
        rest = inner[len(_array_like()) :]
        return _one_of([_ARRAY_LIKE, *map(_kind, rest)]) if rest else _ARRAY_LIKE
    if origin in (Union, UnionType):
        return _one_of([_kind(choice) for choice in inner])
    if origin is Literal:
        return _Kind(
            " or ".join(map(repr, inner)),
            lambda value: any(type(value) is type(item) and value == item for item in inner),
        )
    if origin is not None and _is_array_class(origin):
        return _ARRAY
    if isinstance(origin, type):
        return _collection(origin, inner)
    if annotation is Any or annotation is object:
        return None
    if annotation in _SIMPLE:
        return _SIMPLE[annotation]
    return _instance(annotation) if isinstance(annotation, type) else None


def _one_of(kinds: list[_Kind | None]) -> _Kind | None:
    known = [kind for kind in kinds if kind is not None]
    if len(known) < len(kinds):
        return None
    return _Kind(
        _enumeration(list(dict.fromkeys(kind.words for kind in known))),
        lambda value: any(kind.fits(value) for kind in known),
    )


def _enumeration(words: list[str]) -> str:
    *others, last = words
    return f"{', '.join(others)} or {last}" if others else last


def _array_like() -> tuple[Any, ...]:
    """The parts of NumPy's union for what becomes an array; none's where NumPy is not in use."""
    return get_args(getattr(sys.modules.get("numpy.typing"), "ArrayLike", ...)) or (...,)


def _is_array_class(origin: Any) -> bool:
    return bool(origin is getattr(sys.modules.get("numpy"), "ndarray", ...))


def _instance(kind: type) -> _Kind:
    if getattr(kind, "_is_protocol", False):
        return _protocol(kind)
    if kind.__module__.startswith("sympy.core.expr"):
        return _Kind("a SymPy expression", is_formula)
    article = "an" if kind.__name__[0] in "AEIO" else "a"
    return _Kind(f"{article} {kind.__name__}", lambda value: isinstance(value, kind))


def _protocol(kind: type) -> _Kind:
    """What has the methods of a protocol."""
    if getattr(kind, "_is_runtime_protocol", False):
        return _Kind(f"a {kind.__name__}", lambda value: isinstance(value, kind))
    added = ("__init__", "__subclasshook__")  # to every protocol by the module typing
    needed = {
        name
        for base in kind.__mro__
        if getattr(base, "_is_protocol", False)
        for name, member in vars(base).items()
        if inspect.isfunction(member) and name not in added
    }
    words = "a function" if "__call__" in needed else f"a {kind.__name__}"
    return _Kind(words, lambda value: all(hasattr(value, name) for name in needed))


def _collection(origin: type, inner: tuple[Any, ...]) -> _Kind | None:
    if origin is type:
        return _Kind("a class", lambda value: isinstance(value, type))
    if issubclass(origin, Mapping):
        of = _kind(inner[1])
        return _Kind(
            f"a mapping of names to {_plural(of)}",
            lambda value: (
                isinstance(value, Mapping) and (not of or all(map(of.fits, value.values())))
            ),
        )
    if not issubclass(origin, Iterable):
        return _Kind("a function", callable)
    pair = get_args(inner[0]) if inner and get_origin(inner[0]) is tuple else ()
    if len(pair) == 2 and ... not in pair and inner[1:] == (...,):
        of = _kind(pair[1])
        return _Kind(
            f"a mapping of symbols to {_plural(of)}, or a sequence of such pairs",
            lambda value: (
                are_named_formulas(value) and (not of or all(map(of.fits, dict(value).values())))
            ),
        )
    several = [_kind(item) for item in inner if item is not ...]
    if pair:
        # of rows in rows the function itself says more
        return None
    size = len(inner) if origin is tuple and ... not in inner else 0
    if len(set(several)) != 1:
        words = f"a sequence of {size} values" if size else "a sequence"
        return _Kind(
            words, lambda value: is_collection(value) and (not size or length(value) == size)
        )
    of = several[0]
    count = {2: "two ", 3: "three "}.get(size, "a sequence of ")
    return _Kind(
        f"{count}{_plural(of)}",
        lambda value: (
            (is_collection(value) or (isinstance(value, Mapping) and origin is Iterable))
            and (not of or iter(value) is value or all(map(of.fits, value)))
        ),
    )


def _plural(kind: _Kind | None) -> str:
    if kind is None:
        return "values"
    article, _, noun = kind.words.partition(" ")
    if article in ("a", "an") and " or " not in noun:
        head, of, rest = noun.partition(" of ")
        several = re.sub(r"(?<=[^aeiou])y$", "ie", head) + "s"
        return f"{several}{of}{rest}"
    return f"entries, each {kind.words}"


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


def _kinds(thing: Any, modules: Iterable[str]) -> dict[str, _Kind]:
    # a module may use the types above without what they are made of
    hints = annotations_of(thing, modules, globals())
    kinds = {name: _kind(hint) for name, hint in hints.items()}
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
    function: Callable[..., Any], name: str, kinds: Callable[[], dict[str, _Kind]]
) -> Callable[..., Any]:
    signature, known = inspect.signature(function), cache(kinds)

    @wraps(function)
    def wrapper(*arguments: Any, **keywords: Any) -> Any:
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
