"""Reasons why a proof attempt stops; users never see them as a traceback."""

from __future__ import annotations


class OutOfReachError(Exception):
    """The computation would be too large, or meets an unsupported formula."""


class EffortSpentError(OutOfReachError):
    """The computation takes more operations than allowed."""


class NotExactError(Exception):
    """A value has no exact rational form."""


class NoRealValueError(OutOfReachError):
    """The radicand is negative at all points considered."""


class NoVolumeError(ZeroDivisionError):
    """The gradients of the conditions are dependent, so they define no volume."""


class NeedMoreGeneratorsError(Exception):
    """More auxiliary symbols are needed than were provided."""


class EmptyLevelError(Exception):
    """The conditions of a level contradict each other."""


class UnknownSymbolError(Exception):
    """A formula uses a symbol that the system does not have."""
