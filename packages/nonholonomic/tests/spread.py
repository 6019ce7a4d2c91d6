"""Parameters of which some are tested every time, and the rest among the slow tests."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any
from zlib import crc32

import pytest


def spread(values: Iterable[Any], every: int = 8) -> list[Any]:
    """The values; all but one in so many, chosen by its text, are marked slow."""
    listed = [(crc32(str(value).encode()), value) for value in values]
    least = min((code for code, _ in listed), default=0)
    return [
        value if code % every == 0 or code == least else pytest.param(value, marks=pytest.mark.slow)
        for code, value in listed
    ]
