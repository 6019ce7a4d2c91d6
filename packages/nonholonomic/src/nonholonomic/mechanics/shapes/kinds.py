"""Kinds that are known by a word: a class registers itself as its module is imported."""

from __future__ import annotations

from typing import Any, ClassVar, TypeVar

from flowlanes.errors import InputError

Kind = TypeVar("Kind", bound="Registered")


class Registered:
    """A base of classes of which each may have a word of its own, by which files name it.

    A class directly below it keeps the register of its subclasses.

    Examples
    --------
    >>> from nonholonomic.mechanics.shapes.kinds import Registered
    >>> class Tool(Registered):
    ...     pass
    >>> class Saw(Tool):
    ...     kind = "saw"
    >>> Tool.kinds() == {"saw": Saw}, Tool.of_kind("saw") is Saw
    (True, True)
    """

    kind: ClassVar[str]
    """The word that names it in an experiment file."""

    _register: ClassVar[dict[str, Any]]

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if Registered in cls.__bases__:
            cls._register = {}
        word = cls.__dict__.get("kind")
        if isinstance(word, str):
            known = cls._register.get(word)
            if known is not None and _place(known) != _place(cls):
                raise InputError(
                    f"kind {word!r} of {cls.__qualname__}: {_place(known)} has it already; choose "
                    "another word"
                )
            cls._register[word] = cls

    @classmethod
    def kinds(cls: type[Kind]) -> dict[str, type[Kind]]:
        """The classes known by now, by their words."""
        return dict(cls._register)

    @classmethod
    def of_kind(cls: type[Kind], word: str) -> type[Kind]:
        """The class of a word.

        Raises
        ------
        KeyError
            If there is none.
        """
        found: type[Kind] = cls._register[word]
        return found


def _place(kind: type) -> str:
    return f"{kind.__module__}.{kind.__qualname__}"
