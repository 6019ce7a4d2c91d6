"""Classes known by a keyword: a class registers itself when its module is imported."""

from __future__ import annotations

from typing import Any, ClassVar, TypeVar

from flowlanes.errors import InputError

Kind = TypeVar("Kind", bound="Registered")


class Registered:
    """Base of classes that experiment files refer to by a keyword.

    Each direct subclass keeps the register of its own subclasses.

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
    """The keyword of the class in experiment files."""

    _register: ClassVar[dict[str, Any]]

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if Registered in cls.__bases__:
            cls._register = {}
        word = cls.__dict__.get("kind")
        if isinstance(word, str):
            known = cls._register.get(word)
            if known is not None and _origin(known) != _origin(cls):
                raise InputError(
                    f"kind {word!r} of {cls.__qualname__}: {_origin(known)} has it already; choose "
                    "another word"
                )
            cls._register[word] = cls

    @classmethod
    def kinds(cls: type[Kind]) -> dict[str, type[Kind]]:
        """The registered classes, by keyword."""
        return dict(cls._register)

    @classmethod
    def of_kind(cls: type[Kind], word: str) -> type[Kind]:
        """The class registered under a keyword.

        Raises
        ------
        KeyError
            If there is none.
        """
        found: type[Kind] = cls._register[word]
        return found


def _origin(kind: type) -> str:
    return f"{kind.__module__}.{kind.__qualname__}"
