"""Figures: that they show the numbers of the dataset, cut nothing off and can be written."""

import re
import subprocess
import sys
from xml.etree import ElementTree

import matplotlib as mpl
import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.text import Text

from chaplygin.geometry.mesh import outline_from_contact
from chaplygin.geometry.view import rotation_matrices
from chaplygin.report import figures
from chaplygin.report.drawing.dataset_access import readable
from chaplygin.report.drawing.phone_layout import make_narrow
from chaplygin.report.drawing.shading import PlaneGround, SphereGround
from chaplygin.report.figures.time_series import turning_angles
from flowlanes.errors import InputError
from spread import spread

# Contact vectors r(gamma).


def ball(gamma):
    return np.array([0.1, 0.0, -0.05]) - 0.5 * gamma


def shell(gamma):
    return np.array([0.1, 0.0, -0.05]) + 2.5 * gamma


def ellipsoid(gamma):
    squares = np.array([1.0, 0.25, 0.16])
    return -gamma * squares / np.sqrt(gamma**2 @ squares)[:, None]


def disk(gamma):
    flat = gamma * [1.0, 1.0, 0.0]
    return -flat / np.linalg.norm(flat, axis=1, keepdims=True)


def cushion(gamma):
    return -np.cbrt(gamma) * np.sum(np.abs(gamma) ** (4 / 3), axis=1, keepdims=True) ** -0.25


PLACES = {
    "ball on a plane": (ball, PlaneGround()),
    "ellipsoid on a plane": (ellipsoid, PlaneGround()),
    "disk on a plane": (disk, PlaneGround()),
    "cushion on a plane": (cushion, PlaneGround()),
    "ball on a sphere": (ball, SphereGround(2.0)),
    "ball on a large sphere": (ball, SphereGround(20.0)),
    "ball in a bowl": (ball, SphereGround(-2.0)),
    "shell around a sphere": (shell, SphereGround(2.0)),
}


PLANE = PlaneGround()


def trajectory(contact=ball, ground=PLANE, samples=301, until=3.0):
    """A body that rolls as prescribed: kinematics without dynamics."""
    times = np.linspace(0.0, until, samples)
    spin, nod = 2.1 * times, 1.3 + 0.4 * np.sin(1.3 * times)
    attitude = np.stack(
        [
            np.cos(nod / 2) * np.cos(spin / 2),
            np.sin(nod / 2) * np.cos(spin / 2),
            -np.sin(nod / 2) * np.sin(spin / 2),
            np.cos(nod / 2) * np.sin(spin / 2),
        ],
        axis=1,
    )
    rotation = rotation_matrices(attitude)
    if isinstance(ground, PlaneGround):
        normal = np.tile([0.0, 0.0, 1.0], (samples, 1))
    else:
        polar, round_ = 0.4 + 0.1 * np.sin(2 * times), 0.6 * times
        up = np.sign(ground.radius)
        normal = np.stack(
            [
                np.sin(polar) * np.cos(round_),
                np.sin(polar) * np.sin(round_),
                up * np.cos(polar),
            ],
            axis=1,
        )
        normal *= up
    gamma = np.einsum("nji,nj->ni", rotation, normal)
    arm = np.einsum("nij,nj->ni", rotation, contact(gamma))
    if isinstance(ground, PlaneGround):
        body = contact(gamma)
        steps = np.einsum("nij,nj->ni", rotation[:-1], np.diff(body, axis=0))
        place = np.concatenate([np.zeros((1, 3)), np.cumsum(steps, axis=0)]) * [1.0, 1.0, 0.0]
    else:
        place = ground.radius * normal
    omega = np.stack([np.cos(times), np.sin(2 * times), 0.3 * times], axis=1)
    noise = 1e-16 * np.round(3 * np.sin(1000 * times))

    def variable(values, *dims, meaning, units):
        return (("time", *dims), values, {"long_name": meaning, "units": units, "source": ""})

    return xr.Dataset(
        {
            "omega": variable(omega, "axis", meaning="angular velocity", units="rad/s"),
            "gamma": variable(gamma, "axis", meaning="normal", units="1"),
            "contact": variable(place, "space", meaning="contact point", units="m"),
            "centre": variable(place - arm, "space", meaning="centre of mass", units="m"),
            "attitude": variable(attitude, "quaternion", meaning="attitude", units="1"),
            "normal_force": variable(9 + np.cos(times), meaning="normal force", units="kg m/s^2"),
            "energy": variable(5.0 * (1 + noise), meaning="energy", units="J"),
            "law_area": variable(noise, meaning=r"area integral $(M, \gamma)$", units="1"),
            "law_momentum": variable(-2 * (1 + 1e-9 * times), meaning="momentum", units="1"),
        },
        {
            "time": ("time", times, {"long_name": "time", "units": "s", "source": ""}),
            "axis": [1, 2, 3],
            "space": ["x", "y", "z"],
            "quaternion": ["w", "x", "y", "z"],
        },
        {"system": "A body & its <ground>"},
    )


@pytest.fixture(scope="module")
def data():
    return trajectory()


@pytest.fixture(scope="module")
def outline():
    return outline_from_contact(ball)


def lines(axes):
    return {line.get_label(): line for line in axes.get_lines()}


def drawn_curves(axes):
    return [
        (np.concatenate(collection.get_segments()), collection)
        for collection in axes.collections
        if isinstance(collection, LineCollection)
    ]


def beyond_the_axes(figure):
    """Labels of ticks outside the limits, which matplotlib keeps but does not draw."""
    hidden = set()
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            ticks = [*axis.get_major_ticks(), *axis.get_minor_ticks()]
            outside = [tick for tick in ticks if not low <= tick.get_loc() <= high]
            hidden |= {label for tick in outside for label in (tick.label1, tick.label2)}
    return hidden


# All figures together


@pytest.mark.slow
@pytest.mark.parametrize("place", PLACES)
def test_every_figure_is_drawn_and_no_text_is_cut_or_covered(place, monkeypatch):
    contact, ground = PLACES[place]
    made = figures.all_figures(
        trajectory(contact, ground), (outline_from_contact(contact), ground), 9.81
    )
    assert list(made) == [
        "scene",
        "contact_path",
        "normal_on_sphere",
        "attitude",
        "angular_velocity",
        "normal_force",
        "drift",
    ]
    written = []
    draw = Text.draw

    def record(text, renderer):
        # Ticks outside the limits of the axes have texts, but do not get here.
        if text.get_text() and text.get_visible():
            written.append(text.get_window_extent(renderer))
        draw(text, renderer)

    monkeypatch.setattr(Text, "draw", record)
    for name, figure in made.items():
        written.clear()
        figure.draw(FigureCanvasAgg(figure).get_renderer())
        assert len(written) >= 2, name
        page = figure.bbox
        for box in written:
            assert box.x0 >= page.x0 - 1 and box.x1 <= page.x1 + 1, name
            assert box.y0 >= page.y0 - 1 and box.y1 <= page.y1 + 1, name
        for number, box in enumerate(written):
            assert not any(box.overlaps(other) for other in written[number + 1 :]), name


def test_figures_that_lack_variables_are_left_out(data, outline):
    fixed_point = data.drop_vars(["contact", "centre", "normal_force"])
    made = figures.all_figures(fixed_point, (outline, PlaneGround()))
    assert list(made) == ["normal_on_sphere", "attitude", "angular_velocity", "drift"]
    assert list(figures.all_figures(data[["omega"]])) == ["angular_velocity"]


@pytest.mark.slow
def test_without_a_ground_there_is_neither_scene_nor_path(data):
    assert not {"scene", "contact_path"} & set(figures.all_figures(data))


@pytest.mark.parametrize(
    ("draw", "missing"),
    [
        (lambda data, outline: figures.scene(data, outline, PlaneGround()), "contact, centre"),
        (lambda data, outline: figures.contact_path(data, PlaneGround()), "contact"),
        (lambda data, outline: figures.normal_force(data), "normal_force"),
    ],
)
def test_a_lacking_variable_is_named(data, outline, draw, missing):
    fixed_point = data.drop_vars(["contact", "centre", "normal_force"])
    with pytest.raises(InputError, match=f"needs {missing}, which the trajectory of A body"):
        draw(fixed_point, outline)


def test_nothing_conserved_is_said_so(data):
    with pytest.raises(InputError, match="needs an integral"):
        figures.drift(data[["omega"]])


@pytest.mark.parametrize("name", ["scene", "contact_path", "normal_on_sphere"])
def test_a_trajectory_without_a_finite_sample_is_refused(data, outline, name):
    empty = data * np.nan
    with pytest.raises(InputError, match=f"the figure {name} has no sample to show"):
        {
            "scene": lambda: figures.scene(empty, outline, PlaneGround()),
            "contact_path": lambda: figures.contact_path(empty, PlaneGround()),
            "normal_on_sphere": lambda: figures.normal_on_sphere(empty),
        }[name]()


@pytest.mark.slow
@pytest.mark.parametrize("ground", spread([PlaneGround(), SphereGround(2.0), SphereGround(-2.0)]))
def test_one_sample_and_a_body_at_rest_are_drawn(outline, ground):
    moving = trajectory(ball, ground)
    one = moving.isel(time=[0])
    resting = moving.isel(time=[0] * 20).assign_coords(time=np.linspace(0, 1, 20))
    for still in (one, resting):
        for figure in figures.all_figures(still, (outline, ground), 9.81).values():
            assert figures.svg_text(figure).startswith("<svg")


@pytest.mark.slow
def test_samples_that_are_missing_at_the_end_are_left_out(data, outline):
    ended = data.where(data.time < 2.0)
    figure = figures.scene(ended, outline, PlaneGround())
    assert "1.99 s" in [text.get_text() for text in figure.findobj(Text)]


@pytest.mark.slow
def test_global_settings_stay_as_they_were(data, outline):
    before = dict(mpl.rcParams)
    figures.svg_text(figures.scene(data, outline, PlaneGround()))
    assert dict(mpl.rcParams) == before


@pytest.mark.slow
def test_pyplot_is_not_imported():
    code = "import sys, chaplygin.report.figures; sys.exit('matplotlib.pyplot' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_recorded_energy_that_is_no_integral_does_not_drift(data):
    open_system = data.drop_vars([n for n in data.data_vars if str(n).startswith("law_")])
    assert "energy" in open_system
    assert "drift" not in figures.all_figures(open_system)


def test_what_stays_to_the_last_bit_has_no_empty_plot(data):
    still = data.copy()
    for name in [n for n in data.data_vars if str(n).startswith("law_")]:
        still[name] = data[name] * 0 + data[name][0]
    assert "drift" not in figures.all_figures(still)


def test_friction_over_normal_force(data):
    times = data.time.values
    normal = np.where(times < 1.0, -1.0, 2.0)
    friction = np.stack([0.6 * normal, 0.8 * normal, 0 * normal], axis=1)
    pressed = data.assign(
        normal_force=("time", normal), friction_force=(("time", "axis"), friction)
    )
    made = figures.all_figures(pressed, None, 9.81)
    assert list(made).index("friction_ratio") == list(made).index("normal_force") + 1
    (curve,) = made["friction_ratio"].axes[0].get_lines()
    assert np.isnan(curve.get_ydata()[times < 1.0]).all()
    assert np.allclose(curve.get_ydata()[times >= 1.0], 1.0)
    # a contact that holds both ways needs no friction
    assert "friction_ratio" not in figures.all_figures(pressed)
    lifted = pressed.assign(normal_force=-abs(pressed["normal_force"]))
    assert "friction_ratio" not in figures.all_figures(lifted, None, 9.81)


def test_a_contact_without_any_force_has_no_figure(data):
    idle = data.assign(normal_force=0.0 * data["normal_force"] - 1e-17)
    assert "normal_force" not in figures.all_figures(idle)


@pytest.mark.parametrize("upright", [True, False])
def test_angles_of_the_attitude(upright):
    """The rotation is that of the angles, and whole turns are counted on."""
    a = np.linspace(0.0, 15.0, 400)
    b = 0.2 * np.sin(a) + (0.0 if upright else 1.4)
    c = 3.0 * a if not upright else 0.3 * np.cos(a)

    def about(axis, angle):
        q = np.zeros((len(angle), 4))
        q[:, 0], q[:, 1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
        return q

    def after(p, q):
        w, x, y, z = p.T
        s, t, u, v = q.T
        return np.stack(
            [
                w * s - x * t - y * u - z * v,
                w * t + x * s + y * v - z * u,
                w * u - x * v + y * s + z * t,
                w * v + x * u - y * t + z * s,
            ],
            axis=1,
        )

    axes = (2, 1, 0) if upright else (2, 0, 2)
    turned = after(after(about(axes[0], a), about(axes[1], b)), about(axes[2], c))
    names, angles = turning_angles(turned)
    assert ("yaw" in names) == upright
    for found, given in zip(angles, (a, b, c), strict=True):
        shift = (found - given)[0]
        assert np.isclose(np.cos(shift), 1.0)
        assert np.allclose(found - given, shift, atol=1e-9)


@pytest.mark.parametrize("count", [4, 9, 20])
def test_the_state_fits_on_a_page(data, count):
    names = [f"{letter}_{n}x" for n, letter in enumerate("abcdefghijklmnopqrst"[:count])]
    many = data.assign({name: ("time", np.sin(data.time.values)) for name in names})
    figure = figures.state(many, names)
    assert figure.get_figheight() <= 9.5
    assert sum(axes.axison for axes in figure.axes) == count
    labelled = [axes for axes in figure.axes if axes.get_xlabel()]
    assert len(labelled) == (1 if count <= 5 else 2)


def test_a_page_may_choose_the_colours(data):
    text = figures.page_svg(figures.drift(data))
    assert "var(--ink, #1f2730)" in text
    assert "var(--paper, #ffffff)" in text
    assert not re.search(r"(?<!, )#1f2730", text)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["angular_velocity", "normal_force", "drift", "scene"])
def test_on_a_telephone_letters_can_be_read(data, outline, name):
    """Figures as wide as the screen, or with larger letters; the figure itself stays."""
    figure = figures.all_figures(data, (outline, PlaneGround()), 9.81)[name]
    size = tuple(figure.get_size_inches())
    wide, narrow = figures.page_svg(figure), figures.page_svg(figure, narrow=True)
    assert tuple(figure.get_size_inches()) == size
    assert narrow != wide
    points = float(re.search(r'width="([\d.]+)pt"', narrow)[1])
    if name != "scene":
        assert points <= 3.7 * 72


def test_a_long_legend_is_broken_on_a_telephone():
    """It stayed as wide as a page, and its letters were too small to be read."""
    figure = Figure(figsize=(6.3, 2.6), layout="constrained")
    axes = figure.add_subplot()
    for name in ("energy", "the square of the momentum in planes that contain γ"):
        axes.plot([0.0, 1.0], [0.0, 1.0], label=name)
    axes.legend(loc="lower right", bbox_to_anchor=(0.0, 1.0, 1.0, 0.0), ncols=2)
    narrow = figures.page_svg(figure, narrow=True)
    assert float(re.search(r'width="([\d.]+)pt"', narrow)[1]) <= 3.7 * 72


# Scene


@pytest.mark.slow
def test_scene_is_drawn_at_the_wanted_instant(data, outline):
    figure = figures.scene(data, outline, PlaneGround(), until=1.504)
    assert "1.5 s" in [text.get_text() for text in figure.findobj(Text)]
    with pytest.raises(InputError, match="has no sample"):
        figures.scene(data, outline, PlaneGround(), until=-1.0)


@pytest.mark.slow
def test_long_way_is_cut_to_its_last_part(outline):
    """The whole way is too long for the body to be seen beside it."""
    far = trajectory(until=30.0, samples=3001)
    far["contact"] = far.contact + xr.where(far.space == "x", 3 * far.time, 0.0)
    far["centre"] = far.centre + xr.where(far.space == "x", 3 * far.time, 0.0)
    figure = figures.scene(far, outline, PlaneGround())
    (start,) = [t.get_text() for t in figure.findobj(Text) if t.get_text().startswith("$t$")]
    assert 20.0 < float(start.removeprefix("$t$ = ")) < 29.0
    box = figure.axes[0].dataLim
    assert box.width < 12 * outline.diameter


@pytest.mark.slow
def test_body_stands_at_the_end_of_its_path(data, outline):
    """The border of the drawn ball touches the picture of the plane where the path ends."""
    figure = figures.scene(data, outline, PlaneGround())
    axes = figure.axes[0]
    path, _ = drawn_curves(axes)[0]
    border = axes.patches[-1].get_path().vertices
    middle, radius = border.mean(axis=0), np.ptp(border[:, 0]) / 2
    assert radius == pytest.approx(0.5, rel=0.01)
    # The contact lies straight under the middle, seen from 0.5 rad above the plane.
    np.testing.assert_allclose(path[-1] - middle, [0.0, -0.5 * np.cos(0.5)], atol=0.01)


@pytest.mark.slow
def test_scene_is_scaled_alike_in_both_directions(data, outline):
    axes = figures.scene(data, outline, PlaneGround()).axes[0]
    assert axes.get_aspect() == 1.0


@pytest.mark.slow
def test_pictures_stay_small(data, outline):
    made = figures.all_figures(data, (outline, PlaneGround()))
    assert all(len(figures.svg_text(figure)) < 600_000 for figure in made.values())


# Paths


def test_contact_path_shows_every_sample_to_scale(data):
    axes = figures.contact_path(data, PlaneGround()).axes[0]
    ((curve, _),) = drawn_curves(axes)
    gaps = np.linalg.norm(curve[:, None] - data.contact.values[None, :, :2], axis=2).min(axis=0)
    assert np.max(gaps) < 1e-12
    assert axes.get_aspect() == 1.0
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("$x$  (m)", "$y$  (m)")
    low, high = np.min(curve, axis=0), np.max(curve, axis=0)
    assert axes.get_xlim()[0] < low[0] and axes.get_xlim()[1] > high[0]
    assert axes.get_ylim()[0] < low[1] and axes.get_ylim()[1] > high[1]


def test_colours_of_time_go_from_first_to_last(data):
    axes = figures.contact_path(data, PlaneGround()).axes[0]
    ((_, collection),) = drawn_curves(axes)
    colours = [to_hex(colour) for colour in collection.get_colors()]
    brightness = collection.get_colors()[:, :3] @ [0.3, 0.6, 0.1]
    assert len(set(colours)) > 50
    assert np.all(np.diff(brightness) < 0.01)


def test_normal_is_split_into_near_and_pale_far_side():
    axes = figures.normal_on_sphere(trajectory(until=30.0)).axes[0]
    curves = drawn_curves(axes)
    widths = [float(collection.get_linewidths()[0]) for _, collection in curves]
    assert {1.0, 1.8} == set(widths)
    for curve, collection in curves:
        assert np.max(np.linalg.norm(curve, axis=1)) < 1 + 1e-9
        pale = float(np.min(collection.get_colors()[:, :3])) > 0.5
        assert pale == (collection.get_linewidths()[0] == 1.0)
    assert {"$\\gamma_1$", "$\\gamma_2$", "$\\gamma_3$"} <= {t.get_text() for t in axes.texts}


# Against time


def test_angular_velocity_shows_components_and_length(data):
    shown = lines(figures.angular_velocity(data).axes[0])
    for axis in range(3):
        np.testing.assert_array_equal(
            shown[rf"$\omega_{axis + 1}$"].get_ydata(), data.omega.values[:, axis]
        )
    np.testing.assert_allclose(
        shown[r"$|\omega|$"].get_ydata(), np.linalg.norm(data.omega, axis=1), rtol=1e-15
    )


def test_components_are_found_whatever_the_order_of_dimensions(data):
    shown = lines(figures.angular_velocity(data.transpose("axis", ...)).axes[0])
    np.testing.assert_array_equal(shown[r"$\omega_2$"].get_ydata(), data.omega.values[:, 1])


def test_units_are_written_with_raised_exponents(data):
    assert figures.normal_force(data).axes[0].get_ylabel() == "normal force  (kg m/s$^{2}$)"
    bare = data.copy()
    bare["omega"].attrs["units"] = "1"
    assert figures.angular_velocity(bare).axes[0].get_ylabel() == "angular velocity"


def test_normal_force_marks_the_weight_and_where_contact_is_lost(data):
    pressed = figures.normal_force(data, 9.81).axes[0]
    assert pressed.get_ylim()[0] == 0.0
    assert not pressed.collections
    assert list(lines(pressed)["weight  $mg$"].get_ydata()) == [9.81, 9.81]
    lifted = data.copy()
    lifted["normal_force"] = data.normal_force - 9.0
    axes = figures.normal_force(lifted).axes[0]
    assert axes.get_ylim()[0] < -0.9
    (lost,) = axes.collections
    assert lost.get_label() == "contact would be lost"
    # cos t is negative between pi/2 and the end.
    vertices = lost.get_paths()[0].vertices
    assert np.min(vertices[:, 0]) == pytest.approx(np.pi / 2, abs=1e-3)
    assert np.max(vertices[:, 1]) == pytest.approx(0.0, abs=1e-12)


def test_drift_lines_are_the_largest_drifts_so_far(data):
    shown = lines(figures.drift(data).axes[0])
    expected = np.abs(data.law_momentum.values + 2.0) / 2.0
    line = shown["momentum"].get_ydata()
    np.testing.assert_allclose(line[1:], np.maximum.accumulate(expected)[1:], rtol=1e-15)
    assert line[0] == 1e-17


def test_drift_at_zero_lies_on_a_line_marked_zero():
    moving = trajectory()
    constant = xr.Dataset({"law_energy": xr.full_like(moving.energy, 5.0)})
    axes = figures.drift(constant).axes[0]
    np.testing.assert_array_equal(lines(axes)["energy"].get_ydata(), 1e-17)
    ticks = {
        tick: label.get_text()
        for tick, label in zip(axes.get_yticks(), axes.get_yticklabels(), strict=True)
    }
    assert ticks[1e-17] == "0"
    assert axes.get_ylim()[0] < 1e-17


def test_drift_of_what_starts_at_zero_is_absolute(data):
    np.testing.assert_array_equal(
        figures.relative_drift(data, "law_area"), np.abs(data.law_area - data.law_area[0])
    )
    assert r"area integral $(M, \gamma)$  (absolute)" in lines(figures.drift(data).axes[0])


def test_drift_of_a_small_quantity_is_relative():
    small = xr.Dataset({"law_small": ("time", 1e-12 * (1 + 1e-14 * np.arange(5)))})
    np.testing.assert_allclose(
        figures.relative_drift(small, "law_small"), 1e-14 * np.arange(5), rtol=0.02
    )


def test_drift_counts_the_low_parts_of_long_numbers(data):
    precise = xr.Dataset({"law_energy": xr.full_like(data.energy, 4.0)})
    precise["law_energy_low"] = ("time", 1e-30 * np.arange(len(data.time)))
    np.testing.assert_allclose(
        figures.relative_drift(precise, "law_energy"), 0.25e-30 * np.arange(len(data.time))
    )
    axes = figures.drift(precise).axes[0]
    assert axes.get_ylim()[0] < 1e-31
    assert set(lines(axes)) & {"energy", "energy_low"} == {"energy"}


def test_energy_is_shown_once(data):
    twice = data.assign(law_energy=data.energy)
    assert sum(line.get_label() == "energy" for line in figures.drift(twice).axes[0].lines) == 1


def test_meaning_that_is_no_formula_is_written_as_it_stands(data):
    broken = data.copy()
    broken["law_momentum"].attrs["long_name"] = r"\frac costs 5$ or $\nonsense{$"
    text = figures.svg_text(figures.drift(broken))
    assert text.rstrip().endswith("</svg>")


# Files


@pytest.mark.slow
def test_svg_is_an_element_with_ids_of_its_own(data):
    first = figures.svg_text(figures.angular_velocity(data))
    second = figures.svg_text(figures.normal_on_sphere(data))
    page = f"<html>{first}{second}</html>"
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids)) > 20
    references = {a or b for a, b in re.findall(r'href="#([^"]+)"|url\(#([^)]+)\)', page)}
    assert references == set(ids)
    root = ElementTree.fromstring(page)
    assert [child.tag for child in root] == ["{http://www.w3.org/2000/svg}svg"] * 2
    for part in ("<?xml", "<!DOCTYPE", "<style", "<metadata", "<!--"):
        assert part not in page


def test_svg_says_what_it_shows(data):
    root = ElementTree.fromstring(figures.svg_text(figures.angular_velocity(data)))
    assert root.get("aria-label") == "Angular velocity in body axes: A body & its <ground>"
    assert root.get("role") == "img"


@pytest.mark.slow
def test_svg_is_the_same_every_time(data, outline):
    figure = figures.scene(data, outline, PlaneGround())
    once, again = figures.svg_text(figure), figures.svg_text(figure)
    anew = figures.svg_text(figures.scene(data, outline, PlaneGround()))
    assert once == again == anew


@pytest.mark.slow
@pytest.mark.parametrize(
    ("suffix", "start"), [(".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")]
)
def test_files_are_the_same_every_time(data, tmp_path, suffix, start):
    first = figures.save(figures.drift(data), tmp_path / f"a{suffix}")
    second = figures.save(figures.drift(data), str(tmp_path / f"b{suffix.upper()}"))
    assert first.read_bytes() == second.read_bytes()
    assert first.read_bytes().startswith(start)


@pytest.mark.slow
def test_svg_file_stands_alone(data, tmp_path):
    path = figures.save(figures.drift(data), tmp_path / "drift.svg")
    assert ElementTree.parse(path).getroot().tag == "{http://www.w3.org/2000/svg}svg"


@pytest.mark.parametrize("name", ["figure.gif", "figure"])
def test_unknown_format_is_refused(data, tmp_path, name):
    with pytest.raises(InputError, match=r"\.png, \.svg, \.pdf"):
        figures.save(figures.drift(data), tmp_path / name)


@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_place_that_cannot_be_written_is_named(data, tmp_path, suffix):
    with pytest.raises(InputError, match=r"nowhere.* cannot be written: No such file"):
        figures.save(figures.drift(data), tmp_path / "nowhere" / f"figure.{suffix}")


def test_raised_and_lowered_characters_are_set_as_exponents_and_indices(data):
    """The typeface has none of its own; a missing one would be a warning."""
    assert readable("M² along γ₁₂, s⁻¹") == "M$^{2}$ along γ$_{12}$, s$^{-1}$"
    own = data.copy()
    own["law_energy"] = own["energy"].assign_attrs(long_name="J₁ M₂² + γ₃⁴")
    assert figures.svg_text(figures.drift(own)).startswith("<svg")


def test_the_state_has_one_panel_for_each_variable(data):
    figure = figures.state(data, ["omega", "energy"])
    first, second = figure.axes
    assert len(first.lines) == 3
    assert len(second.lines) == 1
    assert second.get_xlabel().startswith("time")
    with pytest.raises(InputError, match="the figure state needs speed, which"):
        figures.state(data, ["omega", "speed"])
    with pytest.raises(InputError, match="at least one variable"):
        figures.state(data, [])


def test_scalars_of_one_letter_share_a_panel(data):
    own = data.copy()
    for name, unit in (("k_12", "m"), ("k_13", "m"), ("k_s", "s"), ("kappa", "m")):
        own[name] = own["energy"].assign_attrs(units=unit)
    panels = figures.state(own, ["k_12", "k_13", "k_s", "kappa", "attitude"]).axes
    assert [len(axes.lines) for axes in panels] == [2, 1, 1, 4]
    assert [axes.get_ylabel() for axes in panels[:3]] == [
        "$k$  (m)",
        "$k_{s}$  (s)",
        r"$\kappa$  (m)",
    ]
    labels = [line.get_label() for line in panels[3].lines]
    assert labels == [rf"$q_{{{index}}}$" for index in "wxyz"]


def test_an_angle_of_many_turns_has_a_plot_of_its_own() -> None:
    times = np.linspace(0.0, 10.0, 201)
    turned = {}
    for rate in (0.3, 30.0):
        half = rate * times / 2
        attitude = np.stack([np.cos(half), 0 * half, 0 * half, np.sin(half)], axis=1)
        dataset = xr.Dataset(
            {"attitude": (("time", "quaternion"), attitude)}, {"time": times}, {"title": "top"}
        )
        turned[rate] = [
            [line.get_label() for line in axes.get_lines() if not line.get_label().startswith("_")]
            for axes in figures.attitude(dataset).axes
        ]
    assert turned == {0.3: [["yaw", "pitch", "roll"]], 30.0: [["yaw"], ["pitch", "roll"]]}


def test_on_a_phone_no_label_is_cut() -> None:
    figure = Figure(figsize=(6.3, 4.0))
    axes = figure.add_axes((0.12, 0.2, 0.86, 0.75))
    axes.set(ylim=(-0.0375, 0.0375), ylabel="$y$  (m)")
    make_narrow(figure)
    figure.draw_without_rendering()
    assert axes.get_tightbbox().x0 >= -1e-6


def test_a_matrix_of_many_entries_has_a_panel_for_each_row() -> None:
    pairs = [f"{i}{j}" for i in range(1, 6) for j in range(i + 1, 7)]
    times = np.linspace(0.0, 1.0, 5)
    values = np.sin(np.outer(times, np.arange(1, 16)))
    dataset = xr.Dataset(
        {"omega": (("time", "pair"), values, {"units": "rad/s"})},
        {"time": ("time", times, {"units": "s"}), "pair": pairs},
        {"title": "Body"},
    )
    panels = figures.state(dataset, ["omega"]).axes
    assert [len(axes.lines) for axes in panels] == [5, 4, 3, 2, 1]
    assert len({axes.get_position().x0 for axes in panels}) == 1
