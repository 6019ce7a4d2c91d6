"""Allowed values of annotations, each with a description and a test."""

from __future__ import annotations

import inspect
import os
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin


@dataclass(frozen=True)
class Kind:
    """Allowed values: a description and a test."""

    words: str
    fits: Callable[[Any], bool]


# --- values ---------------------------------------------------------------------------------

TEXT = (str, bytes)


def is_number(value: Any) -> bool:
    """True for one real number that can be converted to a float."""
    is_other = isinstance(value, TEXT) or class_name(value) in ("bool", "bool_")
    return not is_other and getattr(value, "ndim", 0) == 0 and converts_to_float(value)


def is_number_or_text(value: Any) -> bool:
    """True for a number, or a string that represents one."""
    return converts_to_float(value) if isinstance(value, str) else is_number(value)


def converts_to_float(value: Any) -> bool:
    """True if `float` accepts the value."""
    try:
        float(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return True


def class_name(value: object) -> str:
    """Name of the class of a value."""
    return type(value).__name__


def is_integer(value: Any) -> bool:
    """True for one integer."""
    return not isinstance(value, bool) and hasattr(value, "__index__") and is_number(value)


def is_collection(value: Any) -> bool:
    """True for an iterable of values that is neither a string nor a mapping."""
    if isinstance(value, (type, Mapping, *TEXT)):
        return False
    return hasattr(value, "__len__") if hasattr(value, "shape") else isinstance(value, Iterable)


def are_numbers(value: Any) -> bool:
    """True for a sequence of numbers."""
    if not is_collection(value) or getattr(value, "ndim", 1) != 1:
        return False
    kind = getattr(getattr(value, "dtype", None), "kind", "O")
    # an iterator can be read only once, and the function itself needs its values
    return kind in "iuf" or (
        kind == "O" and (iter(value) is value or all(map(is_number_or_text, value)))
    )


def is_numeric_array(value: Any) -> bool:
    """True for an array that can hold numbers."""
    return getattr(getattr(value, "dtype", None), "kind", "") in ("i", "u", "f", "O")


def is_array_like(value: Any) -> bool:
    """True for a number, a sequence of numbers, or rows of numbers of equal lengths."""
    if is_number_or_text(value) or is_numeric_array(value):
        return True
    if not isinstance(value, list | tuple) or not all(map(is_array_like, value)):
        return False
    return len({getattr(row, "shape", ()) or length(row) for row in value}) <= 1


def length(value: Any) -> int:
    """Number of entries of a value; −1 if it has no length."""
    return len(value) if hasattr(value, "__len__") else -1


def is_row(value: Any) -> bool:
    """True for a number or a sequence of numbers."""
    return is_number(value) or are_numbers(value)


def is_start(value: Any) -> bool:
    """Whether it is a state: numbers in order, or numbers, vectors and matrices by name."""
    if isinstance(value, Mapping):
        return all(is_number_or_text(v) or are_numbers(v) or are_rows(v) for v in value.values())
    return are_numbers(value)


def are_rows(value: Any) -> bool:
    """True for rows of numbers."""
    return is_collection(value) and all(map(are_numbers, value))


def are_parameters(value: Any) -> bool:
    """True for a mapping of names to numbers, or to one number for each motion."""
    if value is None:
        return True
    return isinstance(value, Mapping) and all(
        is_number_or_text(v) or are_numbers(v) for v in value.values()
    )


def are_formula_parameters(value: Any) -> bool:
    """Whether it maps names or symbols to numbers, or lists declared parameters."""
    if isinstance(value, Mapping):
        return all(map(is_number, value.values()))
    return isinstance(value, list | tuple) and all(class_name(v) == "Parameter" for v in value)


def are_conditions(value: Any) -> bool:
    """True for relations, or combinations of relations by and, or, not."""
    return isinstance(value, tuple | list) and all(map(_is_condition, value))


def _is_condition(value: Any) -> bool:
    from sympy.core.relational import Relational
    from sympy.logic.boolalg import BooleanAtom, BooleanFunction

    if isinstance(value, BooleanFunction):
        return all(map(_is_condition, value.args))
    return isinstance(value, bool | Relational | BooleanAtom)


def is_formula(value: Any) -> bool:
    """True for an expression, a matrix of expressions, or a number."""
    if "sympy" in sys.modules:
        import sympy as sp

        if isinstance(value, (sp.Basic, sp.MatrixBase)):
            return True
    return is_number(value)


def are_formulas(value: Any) -> bool:
    """True for a formula, or formulas in nested rows of equal lengths."""
    if isinstance(value, list | tuple):
        lengths = {length(row) for row in value if isinstance(row, list | tuple)}
        return len(lengths) <= 1 and all(map(are_formulas, value))
    return is_formula(value)


def are_named_formulas(value: Any) -> bool:
    """True for pairs of names and formulas, where no formula is a string."""
    pairs = pairs_of(value)
    return pairs is not None and not any(
        isinstance(part, (*TEXT, NoneType)) for pair in pairs for part in pair
    )


def pairs_of(value: Any) -> list[tuple[Any, Any]] | None:
    """Sequence of pairs from a mapping or from such a sequence; otherwise None."""
    pairs = list(value.items()) if isinstance(value, Mapping) else value
    if not isinstance(pairs, list | tuple):
        return None
    return list(pairs) if all(isinstance(p, list | tuple) and len(p) == 2 for p in pairs) else None


# --- annotations ----------------------------------------------------------------------------

_ARRAY = Kind("an array of numbers", is_numeric_array)
_ARRAY_LIKE = Kind("numbers in an array or in nested sequences", is_array_like)

_SIMPLE: dict[Any, Kind | None] = {
    float: Kind("a number", is_number),
    int: Kind("a whole number", is_integer),
    # integers of NumPy too
    bool: Kind("True or False", lambda value: class_name(value) in ("bool", "bool_")),
    str: Kind("a text", lambda value: isinstance(value, str)),
    Path: Kind("a path", lambda value: isinstance(value, os.PathLike)),
    NoneType: Kind("None", lambda value: value is None),
    type: Kind("a class", lambda value: isinstance(value, type)),
    object: None,
    Any: None,
}


def kind_of(annotation: Any) -> Kind | None:
    """Values that an annotation allows; None if it allows any value."""
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        notes = [note for note in inner[1:] if isinstance(note, Kind)]
        return notes[0] if notes else kind_of(inner[0])
    if (origin or annotation) in _SIMPLE:
        return _SIMPLE[origin or annotation]
    if origin in (Union, UnionType) or (annotation,) == _array_like():
        return _one_of(inner or (annotation,))
    if origin is Literal:
        return Kind(
            " or ".join(map(repr, inner)),
            lambda value: any(type(value) is type(item) and value == item for item in inner),
        )
    if not isinstance(origin, type):
        return _instance(annotation) if isinstance(annotation, type) else None
    if origin.__name__ == "ndarray":
        return _ARRAY
    if issubclass(origin, Mapping):
        return _mapping(kind_of(inner[1]))
    return (
        _sequence(origin, inner) if issubclass(origin, Iterable) else Kind("a function", callable)
    )


def _one_of(choices: tuple[Any, ...]) -> Kind | None:
    alias = _array_like()
    is_array_first = choices[: len(alias)] == alias
    kinds = [kind_of(choice) for choice in choices[len(alias) if is_array_first else 0 :]]
    known = [*([_ARRAY_LIKE] if is_array_first else []), *filter(None, kinds)]
    if None in kinds:
        return None
    *others, last = dict.fromkeys(kind.words for kind in known)
    words = f"{', '.join(others)} or {last}" if others else last
    return Kind(words, lambda value: any(kind.fits(value) for kind in known))


def _array_like() -> tuple[Any, ...]:
    """Members of ``numpy.typing.ArrayLike``, or a placeholder if NumPy is not imported."""
    alias = getattr(sys.modules.get("numpy.typing"), "ArrayLike", ...)
    # a union, or from Python 3.12 on a type alias
    return get_args(alias) or (alias,)


def _instance(kind: type) -> Kind:
    if kind.__module__.startswith("sympy.core.expr"):
        return Kind("a SymPy expression", is_formula)
    article = "an" if kind.__name__[0] in "AEIO" else "a"
    is_static = getattr(kind, "_is_protocol", False) and not getattr(
        kind, "_is_runtime_protocol", False
    )
    if not is_static:
        return Kind(f"{article} {kind.__name__}", lambda value: isinstance(value, kind))
    # any value with the methods of a protocol; two are added to every protocol by typing
    needed = {
        name
        for base in kind.__mro__
        if getattr(base, "_is_protocol", False)
        for name, member in vars(base).items()
        if inspect.isfunction(member) and name not in ("__init__", "__subclasshook__")
    }
    words = "a function" if "__call__" in needed else f"{article} {kind.__name__}"
    return Kind(words, lambda value: all(hasattr(value, name) for name in needed))


def _mapping(of: Kind | None) -> Kind:
    return Kind(
        f"a mapping of names to {_plural(of)}",
        lambda value: isinstance(value, Mapping) and _all_fit(of, value.values()),
    )


def _sequence(origin: type, inner: tuple[Any, ...]) -> Kind | None:
    items = [item for item in inner if item is not ...]
    if pair := get_args(items[0]) if items and get_origin(items[0]) is tuple else ():
        if len(pair) != 2 or ... in pair or inner[1:] != (...,):
            # the function itself checks nested rows and gives a better message
            return None
        of = kind_of(pair[1])
        return Kind(
            f"a mapping of symbols to {_plural(of)}, or a sequence of such pairs",
            lambda value: are_named_formulas(value) and _all_fit(of, dict(value).values()),
        )
    kinds = {kind_of(item) for item in items}
    of = kinds.pop() if len(kinds) == 1 else None
    size = len(inner) if origin is tuple and ... not in inner else 0
    count = {0: "a sequence of", 2: "two", 3: "three", 4: "four"}.get(size, f"{size}")
    return Kind(
        f"{count} {_plural(of)}",
        lambda value: (
            (is_collection(value) or (isinstance(value, Mapping) and origin is Iterable))
            # the function itself checks the number of entries and gives a better message
            and (not size or of is not None or length(value) == size)
            # an iterator can be read only once, and the function itself needs its values
            and (iter(value) is value or _all_fit(of, value))
        ),
    )


def _all_fit(kind: Kind | None, values: Iterable[Any]) -> bool:
    return kind is None or all(map(kind.fits, values))


def _plural(kind: Kind | None) -> str:
    if kind is None:
        return "values"
    article, _, noun = kind.words.partition(" ")
    if article in ("a", "an") and " or " not in noun:
        head, of, rest = noun.partition(" of ")
        several = re.sub(r"(?<=[^aeiou])y$", "ie", head) + "s"
        return f"{several}{of}{rest}"
    return f"entries, each {kind.words}"
