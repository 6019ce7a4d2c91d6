"""The section of an experiment: coordinates, starts, the figure."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.poincare import SectionSurface, Starts, coordinates_of, section_of
from chaplygin.experiment.study import Study
from chaplygin.report.figures import poincare as section_figure
from chaplygin.report.figures.poincare import draw_section
from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from nonholonomic.catalogue import entry

BALL = entry("unbalanced-ball").system({})


def study(name: str = "unbalanced-ball", *options: str) -> Study:
    return Study.from_experiment(
        parse_experiment(f'[system]\nname = "{name}"\n', "x", list(options))
    )


def test_coordinates() -> None:
    assert coordinates_of(BALL, "M_1, M_2, M_3") == (("M_1", "M_2", "M_3"), (), None)
    assert coordinates_of(BALL, "")[0] == ("l", "L_over_G")
    names, quantities, _ = coordinates_of(BALL, "phi = atan2(gamma_2, gamma_1), energy")
    assert names == ("phi", "energy")
    assert [item.unit for item in quantities] == ["rad", "J"]
    _, (spin,), _ = coordinates_of(BALL, "omega_1, M_2")
    assert spin.unit == "rad/s"
    names, _, reduced = coordinates_of(BALL, "andoyer-ratio: l, L/G")
    assert names == ("l", "L_over_G")
    assert reduced is not None
    state = np.array([[0.3, 0.4, 1.2, 0.6, 0.0, 0.8]])
    assert np.allclose(reduced(state), [[np.arctan2(0.3, 0.4), 1.2 / 1.3]], atol=1e-15)
    with pytest.raises(InputError, match="no 'Q' among l, L/G, g, G, H"):
        coordinates_of(BALL, "andoyer-ratio: l, Q")
    with pytest.raises(InputError, match="two or three names"):
        coordinates_of(BALL, "andoyer: l")
    with pytest.raises(InputError, match="no coordinates 'polar'"):
        coordinates_of(BALL, "polar: r, phi")


def test_a_single_motion_starts_where_the_experiment_does() -> None:
    task, names = section_of(study(), SectionSurface("M_1"), Starts(), 3, t_end=1e3)
    assert names == ("l", "L_over_G")
    own = [float(value) for value in study().start[:6]]
    assert np.array_equal(task.work.starts, [own])
    assert task.attributes["starts"] == "the start of the experiment"


@pytest.mark.slow
def test_many_start_on_the_level_of_the_experiment() -> None:
    task, _ = section_of(study(), SectionSurface("gamma_3"), Starts(7, seed=2), 3, t_end=100.0)
    assert task.size == 7
    found = compute(task)
    own = compute(section_of(study(), SectionSurface("M_1"), Starts(), 1, t_end=1e3)[0])
    for law in ("law_energy", "law_quadratic"):
        expected = float(own[law][0, 0])
        assert np.nanmax(np.abs(found[law] - expected)) < 1e-10 * abs(expected)
    assert "(seed 2)" in task.attributes["starts"]


@pytest.mark.slow
def test_a_body_under_gravity_is_followed_beyond_lift_off_only_when_that_is_wished() -> None:
    options = ("start.omega=[0, 12, 1]", "start.gamma=[0, 0, 1]")
    names = {}
    for wish in ("stop", "warn"):
        made = study("rattleback", *options, f"run.on_liftoff={wish}")
        task, _ = section_of(made, SectionSurface("gamma_3"), Starts(), 3, t_end=5.0)
        names[wish] = [guard.name for guard in task.work.returns.system.guards]
    assert set(names["warn"]) < set(names["stop"])


@pytest.fixture(scope="module")
def many() -> xr.Dataset:
    task, _ = section_of(
        study(),
        *(SectionSurface("gamma_3"), Starts(5, {"energy": 1.0}), 30),
        "phi = atan2(gamma_2, gamma_1), h = M_3/2",
        t_end=300.0,
    )
    return compute(task)


@pytest.mark.parametrize("names", [("phi", "h"), ("M_1", "M_2"), ("M_1", "h", "phi")])
@pytest.mark.parametrize("runs", [1, 5])
def test_the_figure_shows_every_point(many: xr.Dataset, names: tuple[str, ...], runs: int) -> None:
    some = many.isel(run=slice(0, runs), section_point=slice(0, 20))
    figure = draw_section(some, names)
    assert isinstance(figure, Figure)
    assert "Unbalanced ball" in figure.get_label()
    expected = int(np.minimum(some["points"], 20).sum())
    for axes in figure.axes[: 1 if len(names) == 2 else 5]:
        drawn = [len(item.get_offsets()) for item in axes.collections]
        assert sum(drawn) == expected
    words = [text.get_text() for text in figure.texts]
    assert f"{expected:,} points" in words
    assert any("γ" in word or r"\gamma_{3}" in word for word in words)


def test_few_starts_have_a_colour_of_their_own_each(many: xr.Dataset) -> None:
    figure = draw_section(many, ("M_1", "M_2"))
    (key,) = figure.legends
    assert key.get_title().get_text() == "start"
    named = dict(
        zip(
            (text.get_text() for text in key.get_texts()),
            (to_rgba(dot.get_color()) for dot in key.legend_handles),
            strict=True,
        )
    )
    assert list(named) == [str(n) for n in range(1, many.sizes["run"] + 1)]
    assert len(set(named.values())) == len(named)
    shown = {tuple(colour) for colour in figure.axes[0].collections[0].get_facecolors()}
    # a start that never passes has no point
    starts = np.flatnonzero(many["points"].values) + 1
    assert shown == {named[str(start)] for start in starts}


def test_many_starts_take_the_colours_by_turns(many: xr.Dataset) -> None:
    crowd = xr.concat([many] * 4, "run")
    assert crowd.sizes["run"] > len(section_figure.KINDS)
    figure = draw_section(crowd, ("M_1", "M_2"))
    assert not figure.legends
    assert any("12 colours" in text.get_text() for text in figure.texts)


def test_both_views_of_space_have_a_labelled_upright_axis(many: xr.Dataset) -> None:
    figure = draw_section(many, ("M_1", "M_2", "phi"))
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    for view in figure.axes[:2]:
        assert view.get_zlabel() == r"$\varphi$  (rad)"
        assert all(tick.get_text() for tick in view.get_zticklabels())
    one, two = (view.zaxis.label.get_window_extent(renderer) for view in figure.axes[:2])
    assert not one.overlaps(two)
    for box in (one, two):
        assert figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1


def test_of_very_many_points_some_are_drawn(
    many: xr.Dataset, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(section_figure, "MOST", 40)
    figure = draw_section(many, ("phi", "h"))
    (dots,) = figure.axes[0].collections
    assert 0 < len(dots.get_offsets()) <= 40
    assert any(f"{len(dots.get_offsets())} drawn" in text.get_text() for text in figure.texts)


def test_angles_have_ticks_in_turns(many: xr.Dataset) -> None:
    axes = draw_section(many, ("phi", "h")).axes[0]
    assert [tick.get_text() for tick in axes.get_xticklabels()][:3] == ["$-π$", "$-π/2$", "0"]
    shifted = many.assign(phi=np.mod(many["phi"], 2 * np.pi).assign_attrs(many["phi"].attrs))
    axes = draw_section(shifted, ("phi", "h")).axes[0]
    assert axes.get_xticklabels()[-1].get_text() == "$2π$"


def test_figures_that_cannot_be_drawn(many: xr.Dataset) -> None:
    for names, sentence in (
        (("M_1",), "two or three coordinates, not 1"),
        (("M_1", "M_4"), "no coordinate M_4"),
        (("M_1", "what"), "no coordinate what"),
        (("M_1", "what_1"), "no coordinate what_1"),
    ):
        with pytest.raises(InputError, match=sentence):
            draw_section(many, names)
    with pytest.raises(InputError, match="has no point to draw"):
        draw_section(many.where(many["time"] < 0), ("M_1", "M_2"))
