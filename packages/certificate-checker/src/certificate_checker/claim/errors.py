"""Exceptions of a check; each message is one complete sentence."""

from __future__ import annotations


class CheckError(Exception):
    """Raised if a certificate is not valid."""


class BadInputError(Exception):
    """Raised if the data are not a certificate."""


class UndefinedError(Exception):
    """Raised if a formula is not defined at a point, or not certainly."""
