"""Short paths lead to the same places, and shared parts of SVGs are there."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given, strategies as st
from matplotlib.figure import Figure

from chaplygin.report.drawing.files import page_svg, page_svgs, svg_text
from chaplygin.report.drawing.svg_paths import short_path

NUMBERS = {"m": 2, "l": 2, "q": 4, "c": 6}
Segment = tuple[str, tuple[float, ...]]


def absolute(path: str) -> list[Segment]:
    """Segments of a path by a reader of its own, for relative commands with repetition."""
    tokens = re.findall(r"[a-zA-Z]|-?(?:\d+\.?\d*|\.\d+)", path)
    here = first = np.zeros(2)
    segments: list[Segment] = []
    command = ""
    while tokens:
        if tokens[0].isalpha():
            command = tokens.pop(0)
            if command in "zZ":
                segments.append(("z", ()))
                here = first
                continue
        size = NUMBERS[command.lower()]
        numbers = np.array([float(tokens.pop(0)) for _ in range(size)]).reshape(-1, 2)
        places = numbers + here if command.islower() else numbers
        here = places[-1]
        segments.append((command.lower(), tuple(np.round(places.ravel(), 9))))
        if command.lower() == "m":
            first = here
            command = "l" if command == "m" else "L"
    return segments


coordinates = st.floats(-500, 500, allow_nan=False).map(lambda x: round(x, 6))
commands = st.sampled_from(["M", "L", "Q", "C", "z"]).flatmap(
    lambda c: st.tuples(
        st.just(c), st.lists(coordinates, min_size=(n := NUMBERS.get(c.lower(), 0)), max_size=n)
    )
)


@given(st.lists(commands, max_size=30))
def test_a_short_path_leads_to_the_same_places(parts: list[tuple[str, list[float]]]) -> None:
    parts = [("M", [1.0, 2.0]), *parts]
    path = " ".join(f"{c} {' '.join(f'{x:.6f}' for x in numbers)}" for c, numbers in parts)
    there = absolute(path)
    # lines that lead nowhere are left out where another line came before
    back = absolute(short_path(path))
    there = _without_standstill(there)
    assert len(back) == len(there)
    for (c, places), (d, others) in zip(back, there, strict=True):
        assert c == d
        assert np.allclose(places, others, rtol=0, atol=0.005001)


def _without_standstill(segments: list[Segment]) -> list[Segment]:
    """Without lines that, rounded, stay where the line before has led."""
    kept: list[Segment] = []
    for command, places in segments:
        rounded = tuple(round(100 * x) for x in places)
        before = kept[-1] if kept else ("", ())
        stays = tuple(round(100 * x) for x in before[1]) == rounded
        if not (command == before[0] == "l" and stays):
            kept.append((command, places))
    return kept


@pytest.mark.parametrize("path", ["M 0 0 A 1 1 0 0 1 2 2", "M 1 1 H 3"])
def test_a_path_with_other_commands_stays_as_it_is(path: str) -> None:
    assert short_path(path) == path


def test_what_figures_share_is_in_the_page_once_and_nothing_is_missing() -> None:
    figure = Figure(figsize=(4, 3))
    figure.set_label("waves")
    axes = figure.add_axes((0.2, 0.2, 0.7, 0.7))
    x = np.linspace(0, 20, 400)
    axes.plot(x, np.sin(x))
    axes.set_title("letters that figures share")
    svg = svg_text(figure)
    both, letters = page_svgs({"one": figure, "other": figure}, {"one": svg, "other": svg})
    page = letters + "".join("".join(pair) for pair in both.values())
    alone = 2 * (len(page_svg(figure)) + len(page_svg(figure, narrow=True)))
    assert len(page) < 0.75 * alone
    names = re.findall(r' id="([^"]*)"', page)
    linked = set(re.findall(r'href="#([^"]*)"|url\(#([^)]*)\)', page))
    assert {a or b for a, b in linked} <= set(names)
    wide, narrow = both["one"]
    assert "href" in narrow
    assert len(narrow) < len(wide)
