"""Parse an axis as typed, without expensive imports."""

from __future__ import annotations

from ..errors import InputError

#: Maximum number of cells along an axis.
MOST = 100_000


def axis_parts(text: str, where: str = "") -> tuple[str, str, str, int]:
    """The name, the first and last value as typed, and the count.

    Raises
    ------
    InputError
        If the text does not have the form ``NAME=FIRST:LAST:COUNT``.
    """
    name, equals, span = (part.strip() for part in text.partition("="))
    parts = span.split(":")
    if not equals or not name.isidentifier() or len(parts) != 3:
        raise InputError(
            f"{text}: an axis is written NAME=FIRST:LAST:COUNT, such as k=-2:2:300", where
        )
    if not parts[2].strip().isdecimal() or not 1 <= int(parts[2]) <= MOST:
        raise InputError(
            f"{text}: the last number, the count, must be a whole number from 1 to {MOST}", where
        )
    return name, parts[0], parts[1], int(parts[2])
