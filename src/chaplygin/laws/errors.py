"""Why a proof attempt stops; none of these reaches a user as a traceback."""

from __future__ import annotations

__all__ = [
    "EmptyLevelError",
    "NotExactError",
    "OutOfReachError",
    "SpareNeededError",
    "UnknownSymbolError",
]


class OutOfReachError(Exception):
    """The computation would be too large, take too long, or meets a formula it cannot treat."""


class NotExactError(Exception):
    """A value has no exact rational form."""


class SpareNeededError(Exception):
    """More auxiliary symbols are needed than were provided."""


class EmptyLevelError(Exception):
    """The conditions of a level contradict each other."""


class UnknownSymbolError(Exception):
    """A formula uses a symbol that the system does not have."""
