"""The picture of a chart: what is coloured, what is pale and what is said of it."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from matplotlib.colors import LogNorm

from chaplygin.report.figures import save
from chaplygin.report.figures.scan import chart
from flowlanes.errors import InputError

MEANINGS = "followed_to_the_end not_computed_yet no_state the_disk_lies_flat"


def made(values: np.ndarray, outcome: np.ndarray | None = None) -> xr.Dataset:
    """A chart with these numbers."""
    rows, columns = values.shape
    codes = np.zeros(values.shape, np.int16) if outcome is None else outcome
    flags = {"flag_values": [0, -1, -2, 5], "flag_meanings": MEANINGS}
    return xr.Dataset(
        {
            "lyapunov": (("energy", "gamma_1"), values, {"long_name": "exponent", "units": "1/s"}),
            "outcome": (("energy", "gamma_1"), codes, flags),
        },
        {
            "gamma_1": ("gamma_1", np.linspace(-1.0, 1.0, columns), {"long_name": "normal"}),
            "energy": (
                "energy",
                np.linspace(1.0, 3.0, rows),
                {"long_name": "energy", "units": "J"},
            ),
        },
        {"system": "Coin", "number": "lyapunov"},
    )


def test_axes_bar_and_colours(tmp_path) -> None:
    figure = chart(made(np.arange(12.0).reshape(3, 4)))
    axes, bar = figure.axes
    assert axes.get_xlabel() == r"normal  $\gamma_{1}$"
    assert axes.get_ylabel() == "energy  (J)"
    assert bar.get_ylabel() == "exponent  (1/s)"
    (image,) = axes.images
    assert image.cmap.name == "viridis"
    # cells are drawn around their values
    assert np.allclose(image.get_extent(), [-4 / 3, 4 / 3, 0.5, 3.5])
    assert np.array_equal(image.get_array(), np.arange(12.0).reshape(3, 4))
    assert not figure.legends
    assert save(figure, tmp_path / "chart.png").stat().st_size > 10_000


def test_cells_without_a_number_are_explained() -> None:
    outcome = np.array([[-2, -2, 0], [0, 5, 0], [0, 0, 0]], np.int16)
    values = np.where(outcome == 0, 1.5, np.nan)
    figure = chart(made(values, outcome))
    (legend,) = figure.legends
    texts = [text.get_text() for text in legend.get_texts()]
    assert texts == ["no state (2 of 9 cells)", "the disk lies flat (1 of 9 cells)"]
    first, second = figure.axes[0].images[1:]
    assert np.array_equal(~np.ma.getmaskarray(first.get_array()), outcome == -2)
    assert np.array_equal(~np.ma.getmaskarray(second.get_array()), outcome == 5)
    shown = {tuple(image.cmap(0)) for image in (first, second)}
    assert len(shown) == 2


def test_numbers_of_many_decades_are_told_apart() -> None:
    figure = chart(named("fli", 10.0 ** np.arange(12.0).reshape(3, 4)))
    assert isinstance(figure.axes[0].images[0].norm, LogNorm)


def named(name: str, values: np.ndarray) -> xr.Dataset:
    """The same chart of another number."""
    return made(values).rename(lyapunov=name).assign_attrs(number=name)


@pytest.mark.parametrize(
    ("name", "low", "mark"), [("megno", 1.9, 2.0), ("megno", 2.6, 2.0), ("lyapunov", 0.01, 0.0)]
)
def test_the_value_that_parts_regular_from_chaotic_is_marked(name, low, mark) -> None:
    figure = chart(named(name, low + np.arange(12.0).reshape(3, 4)))
    bar = figure.axes[1]
    assert f"{mark:g} regular" in [tick.get_text() for tick in bar.get_yticklabels()]
    first, last = bar.get_ylim()
    assert first <= mark <= last
    assert any(np.allclose(line.get_ydata(), mark) for line in bar.get_lines())


def test_what_has_no_such_value_has_no_mark() -> None:
    bar = chart(named("fli", np.arange(12.0).reshape(3, 4))).axes[1]
    assert not any("regular" in tick.get_text() for tick in bar.get_yticklabels())


def test_few_extreme_numbers_do_not_take_all_colours() -> None:
    values = np.ones((30, 30)) + np.linspace(0.0, 1.0, 900).reshape(30, 30)
    values[3, 3] = 1e6
    norm = chart(made(values)).axes[0].images[0].norm
    assert 1.9 < norm.vmax < 2.1


def test_a_chart_without_numbers_can_be_drawn() -> None:
    figure = chart(made(np.full((2, 2), np.nan), np.full((2, 2), -2, np.int16)))
    assert figure.legends[0].get_texts()[0].get_text() == "no state (4 of 4 cells)"
    # nothing is coloured, so colours are not explained
    (axes,) = figure.axes
    assert axes.get_title(loc="left") == "Coin: exponent"


def test_formulas_are_set_as_mathematics_in_lines_of_the_height_of_the_chart() -> None:
    dataset = made(np.arange(12.0).reshape(3, 4))
    title = "rotation number of atan2(gamma_2 - gamma_1,gamma_1 + gamma_3) on M_1 + M_2 + M_3"
    dataset["lyapunov"].attrs.update(long_name=title, units="1")
    figure = chart(dataset)
    bar = figure.axes[1].yaxis.label
    assert bar.get_text().split("\n") == [
        r"rotation number of atan2($\gamma_{2}$ - $\gamma_{1}$, $\gamma_{1}$ + $\gamma_{3}$) on "
        "$M_{1}$ + $M_{2}$ +",
        "$M_{3}$",
    ]
    figure.draw_without_rendering()
    assert bar.get_window_extent().height < figure.axes[0].get_window_extent().height


def test_the_meaning_of_a_word_is_enough() -> None:
    dataset = made(np.arange(12.0).reshape(3, 4))
    dataset["energy"].attrs["long_name"] = "energy of the motion"
    assert chart(dataset).axes[0].get_ylabel() == "energy of the motion  (J)"


def test_what_is_no_chart() -> None:
    with pytest.raises(InputError, match="has no number 'energy' to be drawn"):
        chart(made(np.ones((2, 2))), "energy")
