"""Arguments of public functions, checked against their annotations.

An argument of the wrong type is a mistake of whoever wrote the call; `arguments_checked` answers it
at once with a sentence that names the function, the argument and what is allowed.  Where an
annotation alone says too little (a start may be a mapping or a sequence), the types below say it.
"""

from __future__ import annotations

import builtins
import inspect
import os
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, wraps
from importlib import import_module
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
    get_type_hints,
)

from .errors import InputError

if TYPE_CHECKING:
    from sympy import Expr, Symbol

T = TypeVar("T", bound=Callable[..., Any])

#: Characters of a refused value that are shown.
_LONGEST = 60
_TEXT = (str, bytes)


@dataclass(frozen=True)
class _Kind:
    """Allowed values in words, and a test for them."""

    words: str
    fits: Callable[[Any], bool]


def _is_number(value: Any) -> bool:
    """Whether it is one real number that a float can hold."""
    if isinstance(value, (bool, *_TEXT)) or _is_array(value) or _name(value) == "bool":
        return False
    return _is_readable(value)


def _is_written(value: Any) -> bool:
    """Whether it is a number, or a text with a number."""
    return _is_readable(value) if isinstance(value, str) else _is_number(value)


def _is_array(value: Any) -> bool:
    return getattr(value, "ndim", 0) != 0


def _is_readable(value: Any) -> bool:
    try:
        float(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return True


def _name(value: object) -> str:
    return type(value).__name__


def _is_whole(value: Any) -> bool:
    return not isinstance(value, bool) and hasattr(value, "__index__") and _is_number(value)


def _is_many(value: Any) -> bool:
    """Whether it holds values in order; a text or a mapping is no such thing."""
    if isinstance(value, (type, Mapping, *_TEXT)):
        return False
    return hasattr(value, "__len__") if hasattr(value, "shape") else isinstance(value, Iterable)


def _are_numbers(value: Any) -> bool:
    if not _is_many(value) or getattr(value, "ndim", 1) != 1:
        return False
    kind = getattr(getattr(value, "dtype", None), "kind", "O")
    # an iterator is read once, by the function itself
    return kind in "iuf" or (kind == "O" and (iter(value) is value or all(map(_is_written, value))))


def _is_row(value: Any) -> bool:
    return _is_number(value) or _are_numbers(value)


def _is_start(value: Any) -> bool:
    if isinstance(value, Mapping):
        return all(
            _is_written(v) or _are_numbers(v) or (k == "attitude" and _are_rows(v))
            for k, v in value.items()
        )
    return _are_numbers(value)


def _are_rows(value: Any) -> bool:
    return _is_many(value) and all(map(_are_numbers, value))


def _are_parameters(value: Any) -> bool:
    """Whether it maps names to numbers, or to one number for each motion."""
    if value is None:
        return True
    return isinstance(value, Mapping) and all(
        _is_written(v) or _are_numbers(v) for v in value.values()
    )


def _is_formula(value: Any) -> bool:
    if "sympy" in sys.modules:
        import sympy as sp

        if isinstance(value, (sp.Basic, sp.MatrixBase)):
            return True
    return _is_number(value)


def _are_formulas(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return all(map(_are_formulas, value))
    return _is_formula(value)


def _is_declared(value: Any) -> bool:
    """Whether these are names with formulas; neither is a text."""
    pairs = _pairs_of(value)
    return pairs is not None and not any(
        isinstance(part, (*_TEXT, NoneType)) for pair in pairs for part in pair
    )


def _are_pairs(value: Any, of: _Kind | None) -> bool:
    pairs = _pairs_of(value)
    return pairs is not None and (of is None or all(of.fits(item) for _, item in pairs))


def _pairs_of(value: Any) -> list[tuple[Any, Any]] | None:
    """A mapping or a sequence of pairs as such a sequence; None if it is neither."""
    pairs = list(value.items()) if isinstance(value, Mapping) else value
    if not isinstance(pairs, list | tuple):
        return None
    return list(pairs) if all(isinstance(p, list | tuple) and len(p) == 2 for p in pairs) else None


#: A state: numbers in flat order, or by name.
Start: TypeAlias = Annotated[
    Any, _Kind("a state: numbers in order, or numbers by name in a mapping", _is_start)
]
#: The value of a parameter, or one for each motion; text keeps all digits of a number.
ParameterValue: TypeAlias = SupportsFloat | str | Iterable[SupportsFloat | str]
#: Values of parameters by symbol or name, or None for the defaults.
Parameters: TypeAlias = Annotated[
    "Mapping[str, ParameterValue] | Mapping[Symbol, ParameterValue] | None",
    _Kind("a mapping of parameters to numbers", _are_parameters),
]
Numbers: TypeAlias = Annotated[
    Iterable[SupportsFloat | str], _Kind("a sequence of numbers", _are_numbers)
]
#: One number; in quotes it keeps digits that a float has not.
NumberOrText: TypeAlias = Annotated[SupportsFloat | str, _Kind("a number", _is_written)]
Formula: TypeAlias = Annotated["Expr | float", _Kind("a SymPy expression", _is_formula)]
#: One formula, or several in a matrix or in nested sequences.
Formulas: TypeAlias = Annotated[
    Any, _Kind("a SymPy expression, a matrix or a sequence of these", _are_formulas)
]
#: A scalar of a system by its name, as a formula in text, or as an expression.
Quantity: TypeAlias = Annotated[
    Any,
    _Kind(
        "a name, a formula in quotes or a SymPy expression",
        lambda value: isinstance(value, str) or _is_formula(value),
    ),
]
#: A parameter of a system of the catalogue: a number, or numbers in rows.
Setting: TypeAlias = Annotated[
    Any,
    _Kind(
        "a number, or numbers in a list",
        lambda value: _is_number(value) or (_is_many(value) and all(map(_is_row, value))),
    ),
]
#: Named quantities with their formulas, as a mapping or as pairs.
NamedFormulas: TypeAlias = Annotated[
    Any,
    _Kind("a mapping of symbols to SymPy expressions, or a sequence of such pairs", _is_declared),
]

_SIMPLE: dict[Any, _Kind] = {
    float: _Kind("a number", _is_number),
    int: _Kind("a whole number", _is_whole),
    bool: _Kind("True or False", lambda value: isinstance(value, bool) or _name(value) == "bool"),
    str: _Kind("a text", lambda value: isinstance(value, str)),
    Path: _Kind("a path", lambda value: isinstance(value, os.PathLike)),
    NoneType: _Kind("None", lambda value: value is None),
}


def _kind(annotation: Any) -> _Kind | None:
    """The values that an annotation allows; None if it allows any."""
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return next((note for note in inner[1:] if isinstance(note, _Kind)), _kind(inner[0]))
    if origin in (Union, UnionType):
        return _one_of([_kind(choice) for choice in inner])
    if origin is Literal:
        return _Kind(
            " or ".join(map(repr, inner)),
            lambda value: any(type(value) is type(item) and value == item for item in inner),
        )
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


def _instance(kind: type) -> _Kind:
    if kind.__module__.startswith("sympy.core.expr"):
        return _Kind("a SymPy expression", _is_formula)
    article = "an" if kind.__name__[0] in "AEIO" else "a"
    return _Kind(f"{article} {kind.__name__}", lambda value: isinstance(value, kind))


def _collection(origin: type, inner: tuple[Any, ...]) -> _Kind | None:
    if origin is type:
        return None
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
                _is_declared(value) and (not of or all(map(of.fits, dict(value).values())))
            ),
        )
    several = [_kind(item) for item in inner if item is not ...]
    if pair:
        # of rows in rows the function itself says more
        return None
    if len(set(several)) != 1:
        return _Kind("a sequence", _is_many)
    of = several[0]
    count = {2: "two ", 3: "three "}.get(len(several), "a sequence of ")
    return _Kind(
        f"{count}{_plural(of)}",
        lambda value: (
            (_is_many(value) or (isinstance(value, Mapping) and origin is Iterable))
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
    if isinstance(value, plain) or _name(value) in ("ndarray", "mpf"):
        try:
            text = " ".join(repr(value).split())
        except ValueError:  # an integer of too many digits
            text = "a number too large"
        return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."
    return f"{'an' if _name(value)[0] in 'AEIO' else 'a'} {_name(value)}"


class _Scope(dict[str, Any]):
    """Names of a module; those that it imports for type checkers alone are looked up."""

    def __missing__(self, name: str) -> Any:
        if hasattr(builtins, name):
            return getattr(builtins, name)
        if name in globals():
            # of the types above, which a module may use without what they are made of
            return globals()[name]
        package = import_module(__package__)
        if name in package.__all__:
            return getattr(package, name)
        return import_module("xarray") if name == "xr" else Any


def _kinds(thing: Any, modules: Iterable[str]) -> dict[str, _Kind]:
    scope = _Scope()
    for module in modules:
        scope |= vars(sys.modules[module])
    hints = get_type_hints(thing, None, scope, include_extras=True)
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
        checked_class.__init__ = _checking(
            checked_class.__init__, thing.__name__, lambda: _kinds(thing, modules)
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
