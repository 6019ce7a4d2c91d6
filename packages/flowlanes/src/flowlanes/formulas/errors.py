"""Reasons for the end of a proof attempt; they are caught and not shown to users."""

from __future__ import annotations


class OutOfReachError(Exception):
    """Raised if a computation would be too large, or finds an unsupported formula."""


class EffortSpentError(OutOfReachError):
    """Raised if a computation needs more operations than allowed."""


class NotExactError(Exception):
    """Raised if a value has no exact rational form."""


class NoRealValueError(OutOfReachError):
    """Raised if a radicand is negative at all points that were tried."""


class NoVolumeError(ZeroDivisionError):
    """Raised if the gradients of the conditions are dependent, so they define no volume."""


class NeedMoreGeneratorsError(Exception):
    """Raised if more auxiliary symbols are needed than were provided."""


class EmptyLevelError(Exception):
    """Raised if the conditions of a level contradict each other."""


class UnknownSymbolError(Exception):
    """Raised if a formula contains a symbol that is not in the system."""
