"""The example of the disk in closed form."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    sys.path.insert(0, str(EXAMPLES))
    try:
        import disk_closed_form

        yield disk_closed_form
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.mark.slow
def test_story(example, tmp_path, capsys):
    example.main(["-o", str(tmp_path)])
    sentence = capsys.readouterr().out
    assert "nods while it precesses" in sentence
    assert "mean rate of precession" in sentence
    assert {path.name for path in tmp_path.iterdir()} == {"paths.svg", "diagram.svg"}


def test_the_late_path_has_the_size_of_the_early_one(example):
    solution = example.closed_form()
    sizes = []
    for begin in (example.EARLY, example.LATE):
        place = solution([begin + 0.01 * k for k in range(3000)])["place"]
        sizes.append((place.max(axis=0) - place.min(axis=0)).max())
    assert 0.3 < sizes[1] / sizes[0] < 3
