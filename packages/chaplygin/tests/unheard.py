"""A report of progress that nobody hears."""

from __future__ import annotations


class Unheard:
    """Progress of which nobody wants to hear."""

    def __call__(self, done: float, /) -> None:
        pass

    def say(self, what: str) -> None:
        pass
