"""Settings for all tests: the cache of compiled code, and tests that run only on request."""

from __future__ import annotations

import os
import re
from collections.abc import Generator
from datetime import date
from pathlib import Path
from zlib import crc32

import pytest
from _pytest.mark.structures import get_unpacked_marks
from hypothesis import HealthCheck, settings

from needs import EXTRAS, is_installed

# tests must not write to the cache of the user
os.environ.setdefault("FLOWLANES_CACHE", str(Path(__file__).parent / ".pytest_cache" / "compiled"))

# the same examples every time, and no time limit for a busy machine
settings.register_profile(
    "tests", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("tests")

#: Marks of tests that run only on request: by an option below, by the mark after ``-m``, or by the
#: name of the test (``file.py::test``).
ON_REQUEST = ("slow", "campaign", "browser", "server")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Options ``--slow`` and ``--slow-sample``."""
    parser.addoption(
        "--slow", action="store_true", help="run the slow tests and the campaigns as well"
    )
    parser.addoption(
        "--slow-sample",
        metavar="[K/]N",
        help="run one in N of the slow tests as well: part K of 0..N-1, by default today's",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Determine the part of the slow tests once, so that it is the same for all workers."""
    if config.option.slow_sample:
        config.option.slow_sample = "{}/{}".format(*_part(config.option.slow_sample))


def _part(text: str) -> tuple[int, int]:
    """K and N of ``K/N``; for ``N`` alone, K follows from the date."""
    if not re.fullmatch("([0-9]+/)?[1-9][0-9]*", text):
        raise pytest.UsageError(f"--slow-sample takes N or K/N, as 40 or 7/40, not {text}")
    first, _, number = text.rpartition("/")
    whole = int(number)
    if int(first or 0) >= whole:
        raise pytest.UsageError(f"--slow-sample {text}: the parts are numbered 0 to {whole - 1}")
    return int(first) if first else date.today().toordinal() % whole, whole


def _asked_for(config: pytest.Config) -> set[str]:
    """Marks of `ON_REQUEST` whose tests are collected."""
    if any("::" in argument for argument in config.args):
        return set(ON_REQUEST)
    found = {mark for mark in ON_REQUEST if re.search(rf"\b{mark}\b", config.option.markexpr)}
    if config.option.slow:
        found |= {"slow", "campaign"}
    return found


def pytest_pycollect_makeitem(
    collector: pytest.Module | pytest.Class, name: str, obj: object
) -> list[pytest.Item] | None:
    """Collect no tests of a function that was not requested; it may have hundreds of cases."""
    if not collector.istestfunction(obj, name):
        return None
    marks = {mark.name for mark in get_unpacked_marks(obj)}
    marks |= {mark.name for mark in collector.iter_markers()}
    asked = _asked_for(collector.config)
    if collector.config.option.slow_sample:
        asked.add("slow")
    return [] if marks & set(ON_REQUEST) - asked else None


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Remove single cases with a mark that was not requested, and select the sample."""
    asked = _asked_for(config)
    part = config.option.slow_sample and _part(config.option.slow_sample)

    def is_chosen(item: pytest.Item) -> bool:
        left = {mark.name for mark in item.iter_markers()} & set(ON_REQUEST) - asked
        if left == {"slow"} and part:
            # depends only on the name of the test, so a new test does not change the part of the
            # others
            return crc32(item.nodeid.encode()) % part[1] == part[0]
        return not left

    chosen = [item for item in items if is_chosen(item)]
    if len(chosen) < len(items):
        config.hook.pytest_deselected(items=[item for item in items if not is_chosen(item)])
        items[:] = chosen


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Skip a test if the package reports that an extra is not installed."""
    report = yield
    if call.excinfo is None:
        return report
    for extra, tool in EXTRAS.items():
        if f"[{extra}]" in str(call.excinfo.value) and not is_installed(tool):
            report.outcome = "skipped"
            report.longrepr = (str(item.path), item.location[1] or 0, f"{tool} is not installed")
    return report


@pytest.fixture(autouse=True)
def _answers_are_not_kept(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep no answer of a command between tests: the next one may change what computes it."""
    if "chaplygin/tests/" in request.path.as_posix() and request.path.stem != "test_stored":
        monkeypatch.setattr("chaplygin.answers.stored.keep", lambda question, answer: None)
