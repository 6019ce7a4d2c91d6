"""Settings for all tests."""

from __future__ import annotations

import os
from collections.abc import Generator
from importlib.util import find_spec
from pathlib import Path
from zlib import crc32

import pytest
from hypothesis import HealthCheck, settings

# code compiled by tests stays out of the user's own cache
os.environ.setdefault(
    "FLOWLANES_CACHE", str(Path(__file__).parent / ".pytest_cache" / "compiled")
)

# the same examples every time, on a busy machine too
settings.register_profile(
    "tests", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("tests")

#: Of the slow tests one in so many is run, unless all are asked for or the mark says how many.
EVERY = 25


def pytest_addoption(parser: pytest.Parser) -> None:
    """The option ``--slow``."""
    parser.addoption(
        "--slow", action="store_true", help="run all slow tests, not a few of them, and campaigns"
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out most of the slow tests, and all campaigns."""
    if config.getoption("slow"):
        return
    chosen = [item for item in items if _is_chosen(item)]
    config.hook.pytest_deselected(items=list(set(items) - set(chosen)))
    items[:] = chosen


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """A test that compares with 34 digits is skipped where heyoka, which has them, is not there."""
    report = yield
    if call.excinfo is None or find_spec("heyoka") is not None:
        return report
    if "flowlanes[taylor]" in str(call.excinfo.value):
        report.outcome = "skipped"
        report.longrepr = (str(item.path), item.location[1] or 0, "heyoka is not installed")
    return report


def _is_chosen(item: pytest.Item) -> bool:
    """Whether a test is run, by its own name alone: a new test changes nothing for the others."""
    if item.get_closest_marker("campaign"):
        return False
    marks = list(item.iter_markers("slow"))
    every = max((mark.kwargs.get("every", EVERY) for mark in marks), default=1)
    return crc32(item.nodeid.encode()) % every == 0
