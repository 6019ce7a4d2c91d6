"""Translate pydantic's errors: the key and one sentence for each mistake."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from types import NoneType
from typing import TypeGuard, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from flowlanes.errors import nearest

from .open_kinds import choices_of
from .toml import Key

_LONGEST = 60
_DEEPEST = 2
_MOST_BITS = 1024


def validation_messages(
    error: ValidationError, model: type[BaseModel], data: object
) -> dict[Key, str]:
    """Translate the errors in the tables of a file.

    Parameters
    ----------
    error
        What pydantic says.
    model
        The model of the whole file.
    data
        The tables that were refused.

    Returns
    -------
    dict
        The path of each wrong key ↦ one sentence.
    """
    words: dict[Key, str] = {}
    for details in error.errors(include_url=False):
        place = _locate(model, details["loc"])
        if _as_written(data, place.key) in words:
            continue  # of a long array each element may be wrong
        key, sentence = _sentence(details, place, _value(data, place.key))
        words.setdefault(_as_written(data, key), sentence)
    return words


def value_text(value: object) -> str:
    """A short description of a value of the file, as TOML writes it."""
    if isinstance(value, str):
        return f"the text {_short(_plain(value, 0))}"
    return _short(_plain(value, 0))


def _plain(value: object, depth: int) -> str:
    match value:
        case Mapping():
            return "a table"
        case bool():
            return str(value).lower()
        case [Mapping(), *_] if not depth:
            return "several tables, which [[...]] makes"
        case list() | tuple() if depth < _DEEPEST:
            return f"[{', '.join(_plain(item, depth + 1) for item in value[:_LONGEST])}]"
        case list() | tuple():
            return "[...]"
        case str():
            return json.dumps(value[:_LONGEST], ensure_ascii=False)
        case int() if value.bit_length() > _MOST_BITS:
            return "a number too large"
        case _:
            return str(value)


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


@dataclass(frozen=True)
class _Location:
    """A key with its table and its description there, or a value by its name."""

    key: Key
    owner: type[BaseModel] | None = None
    field: FieldInfo | None = None
    table: object = None

    @property
    def allowed_values(self) -> str:
        """The allowed values, as text."""
        if self.field:
            return str(self.field.description)
        if _is_table(self.table):
            needed = [name for name, f in self.table.model_fields.items() if f.is_required()]
            return f"a table with {' and '.join(needed)}"
        return "a finite number"


def _locate(model: type[BaseModel], steps: tuple[int | str, ...]) -> _Location:
    """The location that a path of pydantic refers to."""
    place = _Location(())
    table: object = model
    for step in map(str, steps):
        if _is_choice(table):
            table = next(t for t in get_args(table) if t.model_fields["kind"].default == step)
        elif _is_table(table):
            place = _Location((*place.key, step), table, table.model_fields.get(step))
            table = _present(choices_of(place.field)) if place.field else None
        elif get_origin(table) is tuple and _is_table(get_args(table)[0]):
            # Of several tables [[a]] the second is called a.2.
            key = place.key if step == "0" else (*place.key, str(int(step) + 1))
            place = _Location(key, table=get_args(table)[0])
            table = get_args(table)[0]
        elif get_origin(table) is dict:
            table = get_args(table)[1]
            place = _Location((*place.key, step), table=table)
        else:
            break
    return place


def _present(annotation: object) -> object:
    """The type of an optional table."""
    choices = [choice for choice in get_args(annotation) if choice is not NoneType]
    left_out = NoneType in get_args(annotation)
    return choices[0] if left_out and len(choices) == 1 else annotation


def _is_table(annotation: object) -> TypeGuard[type[BaseModel]]:
    return isinstance(annotation, type) and issubclass(annotation, BaseModel)


def _is_choice(annotation: object) -> bool:
    """Whether the annotation is a union of tables, distinguished by their ``kind``."""
    choices = get_args(annotation)
    return bool(choices) and all(map(_is_table, choices))


def _value(data: object, key: Key) -> object:
    for part in key:
        if isinstance(data, list) and part.isdecimal() and 0 < int(part) <= len(data):
            data = data[int(part) - 1]
            continue
        if isinstance(data, list) and data:
            data = data[0]
        if not isinstance(data, Mapping) or part not in data:
            return None
        data = data[part]
    return data


def _as_written(data: object, key: Key) -> Key:
    """The key without the parts that exist only if a value is written as a table."""
    while len(key) > 1 and not isinstance(_value(data, key[:-1]), Mapping | None):
        key = key[:-1]
    return key


def _word_for(place: _Location) -> str:
    """The key that a table has for what another word is used for; empty if it has none."""
    words: Mapping[str, str] = getattr(place.owner, "other_words", {})
    return words.get(place.key[-1], "") if place.key else ""


def _sentence(details: ErrorDetails, place: _Location, value: object) -> tuple[Key, str]:
    allowed = place.allowed_values
    context = details.get("ctx", {})
    match details["type"]:
        case "missing" if details["loc"][-1] == place.key[-1]:
            return place.key, f"missing; it must be {allowed}"
        case "extra_forbidden" if word := _word_for(place):
            return place.key, f"unknown key; it is called {word}"
        case "extra_forbidden" if place.owner:
            return place.key, f"unknown key{nearest(place.key[-1], place.owner.model_fields)}"
        case "union_tag_invalid":
            kinds = context["expected_tags"].replace("'", "").split(", ")
            tag = context["tag"][:_LONGEST]
            sentence = f"unknown kind {_short(_plain(tag, 0))}{nearest(tag, kinds)}"
            return (*place.key, "kind"), sentence
        case "union_tag_not_found" if place.field:
            kinds = [t.model_fields["kind"].default for t in get_args(choices_of(place.field))]
            return (*place.key, "kind"), f"missing; allowed: {', '.join(kinds)}"
        case "value_error":
            return place.key, str(context["error"])
        case _:
            return place.key, f"must be {allowed}, not {_refused(value, details)}"


def _refused(value: object, details: ErrorDetails) -> str:
    """A refused value, and of a formula the number that it has."""
    last, number = details["loc"][-1], details["input"]
    if isinstance(value, list) and isinstance(last, int) and last < len(value):
        written = value[last]
    else:
        written = value
    if isinstance(written, str) and isinstance(number, float):
        return f"{written} = {number!r}"
    return value_text(value)
