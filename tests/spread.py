"""Parameters of which a spread is tested every time, and the rest among the slow tests."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def spread(values: Iterable[Any], every: int = 8) -> list[Any]:
    """The values; all but every so manieth of them are marked slow."""
    return [
        pytest.param(value, marks=pytest.mark.slow) if place % every else value
        for place, value in enumerate(values)
    ]
