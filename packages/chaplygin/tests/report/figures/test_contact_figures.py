"""Figures of a motion with friction: that they show its numbers, and its events in their time."""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from chaplygin.experiment.contact.mode_intervals import ModeInterval, mode_intervals
from chaplygin.geometry.mesh import outline_from_contact
from chaplygin.report.drawing.contact_values import (
    FrictionLimits,
    event_impulses,
    in_tangent_plane,
    relative_impulses,
)
from chaplygin.report.drawing.files import page_svg
from chaplygin.report.drawing.modes import MODE_STYLES, ModeColours, mode_runs
from chaplygin.report.drawing.shading import PlaneGround, SphereGround
from chaplygin.report.drawing.style import QUIET
from chaplygin.report.figures.contact_figures import contact_figures, near_support
from chaplygin.report.figures.contact_mode_bar import (
    EventGroup,
    EventNames,
    add_mode_bars,
    label_positions,
)
from chaplygin.report.figures.contact_plane import friction_cone, slip_hodograph, turned_steps
from chaplygin.report.figures.contact_time import energy_parts, energy_stack, friction_share
from chaplygin.report.figures.time_series import angular_velocity
from flowlanes.errors import InputError
from nonholonomic.contact.friction.modes import MODE_NAMES
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.shapes.shapes import Ball

MASS, RADIUS, MU, GRAVITY = 0.2, 0.05, 0.25, 9.81
BALL = Body(MASS, (2e-4, 2e-4, 2e-4), Ball(RADIUS))
OUTLINE = outline_from_contact(lambda gamma: -RADIUS * gamma)
SLIDING, ROLLING = MODE_NAMES.index("sliding"), MODE_NAMES.index("rolling")
#: A ball that starts with this velocity and without spin slides for 2|u|/(7μg).
SLIP = np.array([1.2, 0.9])
STICK = 2 * np.hypot(*SLIP) / (7 * MU * GRAVITY)


def billiard(samples: int = 301, until: float = 0.4) -> xr.Dataset:
    """A ball that slides and then rolls, in closed form; its axes do not turn on paper."""
    times = np.linspace(0.0, until, samples)
    sliding = times < STICK
    along = SLIP / np.hypot(*SLIP)
    brake = np.minimum(times, STICK)[:, None] * along
    velocity = SLIP - MU * GRAVITY * brake
    # I ω̇ = r×f with r = −R e_z
    turn = 2.5 * MU * GRAVITY / RADIUS * brake
    omega = np.stack([-turn[:, 1], turn[:, 0], 0 * times], axis=-1)
    slip = velocity - RADIUS * turn
    friction = np.where(sliding[:, None], -MU * MASS * GRAVITY * along, 0.0)
    kinetic = 0.5 * MASS * np.sum(velocity**2, 1) + 0.5 * 2e-4 * np.sum(omega**2, 1)
    height = RADIUS * np.ones(samples)
    energy = kinetic + MASS * GRAVITY * height
    path = np.cumsum(velocity, axis=0) * until / samples

    def flat(values: np.ndarray) -> np.ndarray:
        return np.concatenate([values, np.zeros((samples, 1))], axis=1)

    def row(vector: list[float]) -> np.ndarray:
        return np.tile(vector, (samples, 1))

    def known(values: np.ndarray, *dims: str, unit: str = "1") -> tuple[object, ...]:
        return (("time", *dims), values, {"long_name": "x", "units": unit, "source": ""})

    flags = {"flag_meanings": " ".join(name.replace(" ", "_") for name in MODE_NAMES)}
    state = np.array([[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]])
    columns = ["attitude_w", "attitude_x", "attitude_y", "attitude_z"]
    columns += ["gamma_1", "gamma_2", "gamma_3"]
    return xr.Dataset(
        {
            "attitude": known(row([1, 0, 0, 0]), "quaternion"),
            "gamma": known(row([0, 0, 1]), "axis"),
            "omega": known(omega, "axis", unit="rad/s"),
            "centre": known(np.column_stack([path, height]), "space", unit="m"),
            "contact": known(flat(path), "space", unit="m"),
            "velocity": known(flat(velocity), "space", unit="m/s"),
            "gap": known(0 * times, unit="m"),
            "slip": known(flat(slip), "axis", unit="m/s"),
            "spin": known(0 * times, unit="rad/s"),
            "normal_force": known(MASS * GRAVITY * np.ones(samples), unit="N"),
            "friction_force": known(flat(friction), "axis", unit="N"),
            "friction_couple": known(0 * flat(slip), "axis", unit="N m"),
            "energy": known(energy, unit="J"),
            "work_impact": known(0 * times, unit="J"),
            "work_coulomb": known(energy[0] - energy, unit="J"),
            "law_energy_balance": known(energy[0] + 0 * times, unit="J"),
            "mode": ("time", np.where(sliding, SLIDING, ROLLING).astype(np.int8), flags),
            "event_time": ("event", [STICK]),
            "event_kind": ("event", ["stick"]),
            "event_mode": ("event", np.array([ROLLING], dtype=np.int8), flags),
            "event_impulse": (("event", "axis"), np.zeros((1, 3))),
            "event_state_before": (("event", "state"), state),
        },
        {
            "time": ("time", times, {"long_name": "time", "units": "s", "source": ""}),
            "state": columns,
        },
        {"system": "A ball"},
    )


def with_events(times: np.ndarray, kinds: list[str], mode: str = "sliding") -> xr.Dataset:
    """The same motion with other events, all of which lead into one mode."""
    plain = billiard().drop_dims("event")
    count = len(times)
    state = np.tile(billiard()["event_state_before"].values, (count, 1))
    return plain.assign(
        event_time=("event", times),
        event_kind=("event", np.array(kinds)),
        event_mode=("event", np.full(count, MODE_NAMES.index(mode), dtype=np.int8)),
        event_impulse=(("event", "axis"), np.zeros((count, 3))),
        event_state_before=(("event", "state"), state),
    )


# --- modes ---------------------------------------------------------------------------------------


def test_modes_change_at_the_events_and_not_at_samples() -> None:
    data = billiard(samples=7)
    assert STICK not in data["time"].values
    assert mode_intervals(data) == [
        ModeInterval("sliding", 0.0, STICK),
        ModeInterval("rolling", STICK, 0.4),
    ]


def test_an_event_at_the_first_sample_and_simultaneous_events() -> None:
    data = with_events(np.array([0.0, 0.2, 0.2, 0.3]), ["landing", "stick", "slip", "rest"])
    data["event_mode"].values[:] = [1, 3, 1, 5]
    assert mode_intervals(data) == [
        ModeInterval("sliding", 0.0, 0.3),
        ModeInterval("rest", 0.3, 0.4),
    ]


def test_a_curve_is_cut_at_every_event_even_if_the_mode_stays() -> None:
    data = with_events(np.array([0.1, 0.25]), ["landing", "landing"], "flight")
    data["mode"].values[:] = 0
    runs = [run for _, run in mode_runs(data)]
    times = data["time"].values
    assert [times[run.start] >= t for run, t in zip(runs[1:], (0.1, 0.25), strict=True)]
    assert [times[run.stop - 1] < t for run, t in zip(runs, (0.1, 0.25), strict=False)]
    assert sum(run.stop - run.start for run in runs) == len(times)


def test_a_path_changes_its_colour_at_the_event() -> None:
    colours = ModeColours(billiard(), 0.0, 0.4)
    share = STICK / 0.4
    assert tuple(colours(share - 1e-9)[:3]) == to_rgb(MODE_STYLES["sliding"].colour)
    assert tuple(colours(share + 1e-9)[:3]) == to_rgb(MODE_STYLES["rolling"].colour)
    shares = np.linspace(0.0, 1.0, 41)
    pieces = colours.pieces(shares)
    assert pieces[0] == 0 and pieces[-1] == 40 and len(pieces) == 4
    assert shares[pieces[1]] < share <= shares[pieces[2]]


def test_modes_differ_in_grey_print_or_by_stripes() -> None:
    def lightness(colour: str) -> float:
        linear = [
            c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in to_rgb(colour)
        ]
        luminance = float(np.dot([0.2126, 0.7152, 0.0722], linear))
        return 116 * luminance ** (1 / 3) - 16

    styles = list(MODE_STYLES.values())
    for i, first in enumerate(styles):
        for second in styles[:i]:
            striped = first.hatch != second.hatch and first.dashes != second.dashes
            assert striped or abs(lightness(first.colour) - lightness(second.colour)) > 12


# --- names of events -----------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(12))
def test_names_never_touch_and_no_event_is_lost(seed: int) -> None:
    rng = np.random.default_rng(seed)
    count = int(rng.integers(1, 300))
    places = np.sort(rng.uniform(0, 400, count) ** rng.uniform(0.5, 1.0))
    kinds = rng.choice(["slip", "stick", "impact without collision", "rest"], count)
    groups = [EventGroup(x, x, (kind,)) for x, kind in zip(places, kinds, strict=True)]
    names = label_positions(groups, lambda name: 4.0 * len(name), (0.0, 400.0), 3.0)
    assert tuple(kind for name in names for kind in name.group.kinds) == tuple(kinds)
    for left, right in pairwise(names):
        assert left.right + 3.0 <= right.left + 1e-9
    for name in names:
        assert name.right <= 400.0 + 1e-9
        assert name.left >= 0.0


def test_names_of_groups() -> None:
    assert EventGroup(0, 0, ("slip",)).name == "slip"
    assert EventGroup(0, 1, ("slip", "stick")).name == "slip, stick"
    assert EventGroup(0, 1, ("landing",) * 7).name == "7 × landing"
    assert EventGroup(0, 1, ("slip", "stick", "slip")).name == "3 events"
    far = [EventGroup(0, 0, ("slip",)), EventGroup(90, 90, ("stick",))]
    assert [n.group.name for n in label_positions(far, lambda _: 20, (0, 100), 3)] == [
        "slip",
        "stick",
    ]


def names_in(figure: Figure) -> list[list[Bbox]]:
    """Boxes of the names of events, panel by panel, as they are drawn."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    renderer = canvas.get_renderer()
    found = [child for axes in figure.axes for child in axes.get_children()]
    return [
        [Bbox.from_bounds(n.left, 0, n.width, 1) for n in names.drawn_names(renderer)]
        for names in found
        if isinstance(names, EventNames)
    ]


@pytest.mark.parametrize("wide", [6.3, 3.65])
def test_names_fit_whatever_the_width(wide: float) -> None:
    times = np.sort(np.random.default_rng(5).uniform(0.0, 0.4, 60))
    data = with_events(times, ["impact without collision", "slip"] * 30)
    figure = angular_velocity(data)
    add_mode_bars(figure, data)
    figure.set_figwidth(wide)
    (boxes,) = names_in(figure)
    assert boxes
    for left, right in pairwise(boxes):
        assert left.x1 < right.x0
    panel = figure.axes[0].get_window_extent()
    assert boxes[0].x0 >= panel.x0 - 1 and boxes[-1].x1 <= panel.x1 + 1


def test_the_bar_lies_between_plot_and_time() -> None:
    data = billiard()
    figure = angular_velocity(data)
    add_mode_bars(figure, data)
    FigureCanvasAgg(figure).draw()
    axes = figure.axes[0]
    bars = list(axes.patches)
    assert len(bars) == 2
    sizes = [bar.get_window_extent() for bar in bars]
    plot = axes.get_window_extent()
    assert (
        sizes[0].x1
        == pytest.approx(sizes[1].x0)
        == pytest.approx(plot.x0 + plot.width * STICK / 0.4)
    )
    axis = axes.spines["bottom"].get_window_extent().y1
    assert all(axis < box.y0 < box.y1 < plot.y0 for box in sizes)


# --- friction and slip ---------------------------------------------------------------------------


def curves(figure: Figure, colour: str, panel: int = 0) -> np.ndarray:
    """All points of lines of one colour."""
    lines = [line for line in figure.axes[panel].lines if line.get_color() == colour]
    return np.concatenate([np.asarray(line.get_xydata()) for line in lines])


def test_sliding_is_on_the_circle_and_a_rolling_ball_in_its_middle() -> None:
    figure = friction_cone(billiard(), FrictionLimits(MU))
    sliding = curves(figure, MODE_STYLES["sliding"].colour)
    assert np.allclose(sliding, -SLIP / np.hypot(*SLIP), atol=1e-12)
    assert np.allclose(curves(figure, MODE_STYLES["rolling"].colour), 0.0)
    # a wrong coefficient shows
    wrong = curves(friction_cone(billiard(), FrictionLimits(0.3)), MODE_STYLES["sliding"].colour)
    assert np.allclose(np.hypot(*wrong.T), MU / 0.3)


def test_the_share_of_the_limit_in_time() -> None:
    figure = friction_share(billiard(), FrictionLimits(MU))
    x, y = np.concatenate([np.asarray(line.get_xydata()) for line in figure.axes[0].lines[:2]]).T
    assert np.allclose(y, np.where(x < STICK, 1.0, 0.0), atol=1e-12)


def test_the_hodograph_of_a_billiard_ball_is_straight_and_ends_at_rest() -> None:
    figure = slip_hodograph(billiard())
    points = curves(figure, MODE_STYLES["sliding"].colour)
    assert np.allclose(points[0], SLIP)
    assert np.allclose(points[:, 0] * SLIP[1], points[:, 1] * SLIP[0], atol=1e-12)
    assert np.allclose(points[-1], 0.0, atol=1e-12)


def test_the_common_limit_of_force_and_couple() -> None:
    force, couple = FrictionLimits(0.3, 1e-3, coupled=True).curve
    assert (force[0], force[-1]) == (0.0, 1.0)
    assert (couple[0], couple[-1]) == (pytest.approx(3 * np.pi / 16), 0.0)
    # dM = −k dF, so that dM/dF = −k, with F = (3π/8) k (1 − k²/4) up to k = 1
    k = np.linspace(0.0, 2.0, 201)[:101]
    assert np.allclose(force[:101], 3 * np.pi / 8 * k * (1 - k**2 / 4))
    slope = np.diff(couple[:101]) / np.diff(force[:101])
    assert np.allclose(slope, -(k[1:] + k[:-1]) / 2, rtol=1e-3)


@pytest.mark.parametrize("seed", range(5))
def test_components_in_the_tangent_plane(seed: int) -> None:
    rng = np.random.default_rng(seed)
    vectors, gamma, attitude = (rng.normal(size=(20, n)) for n in (3, 3, 4))
    unit = gamma / np.linalg.norm(gamma, axis=1, keepdims=True)
    across = in_tangent_plane(vectors, gamma, attitude)
    tangential = vectors - np.sum(vectors * unit, axis=1, keepdims=True) * unit
    assert np.allclose(np.hypot(*across.T), np.linalg.norm(tangential, axis=1))
    others = in_tangent_plane(vectors + 3 * unit, gamma, attitude)
    assert np.allclose(across, others)


def test_components_on_a_plane_are_x_and_y() -> None:
    attitude = np.array([[np.cos(0.3), 0.0, 0.0, np.sin(0.3)]])
    across = in_tangent_plane(np.array([[1.0, 0.0, 7.0]]), np.array([[0.0, 0.0, 1.0]]), attitude)
    assert np.allclose(across, [[np.cos(0.6), np.sin(0.6)]])


def test_impulses_of_impacts_stand_beside_the_forces() -> None:
    data = billiard()
    data["event_impulse"].values[:] = [0.3 * MU, -0.4 * MU, 0.5]
    normal, across = event_impulses(data)
    assert np.allclose(normal, 0.5)
    assert np.allclose(across, [[0.3 * MU, -0.4 * MU]])
    assert np.allclose(relative_impulses(data, FrictionLimits(MU)), [[0.6, -0.8]])
    figure = friction_cone(data, FrictionLimits(MU))
    diamonds = [line for line in figure.axes[0].lines if line.get_marker() == "D"]
    assert np.allclose(diamonds[0].get_xydata(), [[0.6, -0.8]])
    joints = [line for line in slip_hodograph(data).axes[0].lines if line.get_color() == QUIET]
    assert len(joints) == 1


def test_rounding_across_the_normal_is_no_impulse() -> None:
    data = billiard()
    data["event_impulse"].values[:] = [3e-17, 0.0, 0.5]
    normal, across = event_impulses(data)
    assert np.allclose(normal, 0.5)
    assert not across.any()


def test_a_force_that_turns_fast_stays_on_its_circle() -> None:
    angles = np.array([0.0, 0.5, 2.0, 4.0])
    samples = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    points = turned_steps(samples)
    assert np.allclose(np.hypot(*points.T), 1.0)
    assert all(np.min(np.linalg.norm(points - sample, axis=1)) < 1e-12 for sample in samples)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert steps.max() < 0.051


# --- energy --------------------------------------------------------------------------------------


def test_the_parts_of_the_energy_add_up() -> None:
    data = billiard()
    kinetic, potential, lost = energy_parts(data, BALL)
    assert [kinetic.is_loss, potential.is_loss, lost.is_loss] == [False, False, True]
    assert np.allclose(potential.values, 0.0, atol=1e-15)
    total = kinetic.values + potential.values + lost.values
    assert np.allclose(total, 0.5 * MASS * SLIP @ SLIP)
    # a ball that starts without spin keeps 5/7 of its energy
    assert kinetic.values[-1] == pytest.approx(5 / 7 * total[0])
    (line,) = energy_stack(data, BALL).axes[0].lines
    assert np.allclose(line.get_ydata(), total)


def test_what_a_moving_support_gives_lies_below_zero() -> None:
    data = billiard()
    data["work_support"] = -data["work_coulomb"]
    data["energy"] = data["energy"][0] + 0 * data["energy"]
    axes = energy_stack(data, BALL).axes[0]
    lowest = min(area.get_paths()[0].vertices[:, 1].min() for area in axes.collections)
    assert lowest == pytest.approx(-float(data["work_coulomb"][-1]))
    assert np.ptp(np.asarray(axes.lines[0].get_ydata())) < 1e-12


# --- the whole -----------------------------------------------------------------------------------


@pytest.mark.slow
def test_all_figures_of_a_motion_are_described_and_on_paper() -> None:
    figures = contact_figures(
        billiard(61), (OUTLINE, PlaneGround()), BALL, FrictionLimits(MU), MASS * GRAVITY
    )
    assert {"scene", "slip_hodograph", "friction_cone", "energy_stack"} <= set(figures)
    for name, figure in figures.items():
        assert str(figure.get_label()).partition(":")[2], name
        FigureCanvasAgg(figure).draw()
        tight = figure.get_tightbbox()
        wide, high = figure.get_size_inches()
        assert tight.x0 > -0.02 and tight.x1 < wide + 0.02, name
        assert tight.y0 > -0.02 and tight.y1 < high + 0.02, name


@pytest.mark.parametrize("narrow", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_a_page_may_change_the_colours_of_stripes_too(narrow: bool) -> None:
    data = with_events(np.array([0.2]), ["spin stop"], "sliding without spin")
    figure = angular_velocity(data)
    add_mode_bars(figure, data)
    text = page_svg(figure, narrow)
    assert "<pattern" in text
    assert not re.search(r"(?<!, )#aa4499", text)


@pytest.mark.slow
def test_a_smooth_contact_has_no_figures_of_friction() -> None:
    data = billiard(21)
    data["friction_force"] = 0 * data["friction_force"]
    figures = contact_figures(data, (OUTLINE, PlaneGround()), BALL, FrictionLimits())
    assert "friction_cone" not in figures and "friction_share" not in figures
    assert "slip_and_spin" in figures


def test_a_body_far_from_a_sphere_is_not_drawn() -> None:
    data = billiard(41)
    data["gap"].values[:] = np.where(np.arange(41) < 30, 0.0, 1.0)
    assert near_support(data, (OUTLINE, SphereGround(1.0))).sizes["time"] == 30
    assert near_support(data, (OUTLINE, PlaneGround())).sizes["time"] == 41


def test_what_a_figure_needs() -> None:
    with pytest.raises(InputError, match="friction_cone needs friction_force"):
        friction_cone(billiard().drop_vars("friction_force"), FrictionLimits(MU))
