"""Errors of a check; each message is one sentence for a reader."""

from __future__ import annotations


class CheckError(Exception):
    """A certificate is not valid."""


class BadInputError(Exception):
    """The data are not a certificate."""


class UndefinedError(Exception):
    """A formula is not defined at a point, or not certainly so."""
