"""Why a proof attempt stops; none of these reaches a user as a traceback."""

from __future__ import annotations


class OutOfReachError(Exception):
    """The computation would be too large, or meets a formula it cannot treat."""


class EffortSpentError(OutOfReachError):
    """The computation takes more operations than are allowed."""


class NotExactError(Exception):
    """A value has no exact rational form."""


class NoRealValueError(OutOfReachError):
    """A root of what is negative, at all points that are spoken of."""


class NoVolumeError(ZeroDivisionError):
    """Conditions whose gradients depend on each other cut out no volume."""


class NeedMoreGeneratorsError(Exception):
    """More auxiliary symbols are needed than were provided."""


class EmptyLevelError(Exception):
    """The conditions of a level contradict each other."""


class UnknownSymbolError(Exception):
    """A formula uses a symbol that the system does not have."""
