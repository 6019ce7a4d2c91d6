"""Why a proof attempt stops; none of these reaches a user as a traceback."""

from __future__ import annotations

__all__ = ["NotExact", "OutOfReach", "SpareNeeded"]


class OutOfReach(Exception):
    """The computation would be too large, take too long, or meets a formula it cannot treat."""


class NotExact(Exception):
    """A value has no exact rational form."""


class SpareNeeded(Exception):
    """More auxiliary symbols are needed than were provided."""
