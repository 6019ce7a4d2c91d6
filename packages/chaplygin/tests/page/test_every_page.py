"""The page of every system and example in headless Chromium, from a file and without a network."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import chaplygin as ch
import nonholonomic
from browser import Opened, browsers
from chaplygin.experiment.study import dataset_of
from chaplygin.page.element import page
from chaplygin.page.study_page import study_model
from flowlanes.errors import RunError
from page.motions import (
    EXAMPLES,
    allowed_difference,
    motion_by_series,
    motion_in_python,
    study_of,
    whole_system,
)

pytestmark = [pytest.mark.browser, pytest.mark.slow]

FILES = sorted(str(path.relative_to(EXAMPLES)) for path in EXAMPLES.rglob("*.toml"))

#: Bytes of a picture of the scene at least: one without anything in it has fewer.
PICTURE = 6000


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    with browsers() as launch:
        yield launch()


@pytest.mark.parametrize("name", [*sorted(nonholonomic.CATALOGUE), *FILES])
def test_a_page_opens_and_computes_what_python_does(
    name: str, chromium: Any, tmp_path: Path
) -> None:
    study = study_of(name)
    try:
        dataset = dataset_of(study, study.trajectory())
    except RunError as error:
        dataset = dataset_of(study, error.partial, False)
    path = tmp_path / "page.html"
    path.write_text(page(study_model(study, dataset)), "utf-8")
    opened = Opened(chromium, path).ready()
    run = opened.page.evaluate
    until = abs(float(dataset["time"][-1]))
    pose = run("t => (window.chaplygin.seek(t), window.chaplygin.pose())", until / 2)
    assert abs(pose["t"]) == pytest.approx(until / 2, abs=1e-9 * until)
    scene = opened.page.locator(".lab-scene")
    if scene.count():
        opened.page.wait_for_timeout(100)
        assert len(scene.screenshot()) > PICTURE
    if study.subject.changes_equations:
        sentence = "under friction the equations change at events"
        assert opened.page.get_by_text(sentence).count() == 1
    else:
        assert_same_motion(study, run("() => window.chaplygin.motion(20, 21)"))
    assert opened.strangers == []
    assert opened.complaints == []
    opened.context.close()


def assert_same_motion(study: ch.Study, motion: dict[str, list[float]]) -> None:
    """The states of a page are those of native code and of Taylor series."""
    times = np.arange(1, 21.0)
    expected, moved, _ = motion_in_python(study, times)
    count = len(motion["time"]) - 1
    assert count == np.isfinite(expected).all(axis=1).sum()
    allowed = allowed_difference(study, times, expected[:count], moved)
    series = motion_by_series(study, times)[:count]
    first = 0
    for variable in whole_system(study).state:
        width = len(getattr(variable, "symbols", (variable,)))
        if (found := motion.get(str(variable))) is not None:
            got = np.array(found, float).reshape(-1, width)[1:]
            for states in (expected[:count], series):
                number = len(states)
                off = np.abs(got[:number] - states[:, first : first + width])
                assert np.all(off <= allowed[:number, None]), variable
        first += width
