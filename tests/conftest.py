"""Settings for all tests."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

# code compiled by tests stays out of the user's own cache
os.environ.setdefault(
    "CHAPLYGIN_CACHE", str(Path(__file__).parents[1] / ".pytest_cache" / "compiled")
)

#: Of the slow tests every so manieth is run unless all are asked for.
_FEW = 10


def pytest_addoption(parser: pytest.Parser) -> None:
    """The option ``--slow``."""
    parser.addoption(
        "--slow", action="store_true", help="run all slow tests, not a few of them, and campaigns"
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out most of the slow tests, and all campaigns."""
    if config.getoption("slow"):
        return
    slow = [item for item in items if item.get_closest_marker("slow")]
    left_out = {item for place, item in enumerate(slow) if place % _FEW}
    left_out |= {item for item in items if item.get_closest_marker("campaign")}
    config.hook.pytest_deselected(items=list(left_out))
    items[:] = [item for item in items if item not in left_out]
