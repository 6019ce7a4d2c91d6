"""The plan of a mechanism: the table [plan], what is inferred, and the figure."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection

from chaplygin.experiment.models.experiment import catalogue_experiment, parse_experiment
from chaplygin.experiment.python_file import load_python
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.experiment.subjects.plan import plan_motion
from chaplygin.report import figures
from flowlanes.errors import InputError
from spread import spread

EXAMPLES = Path(__file__).parents[5] / "examples"
SLEIGH = (EXAMPLES / "sleigh.toml").read_text(encoding="utf-8")
PLAIN = SLEIGH[: SLEIGH.index("[plan]")] + SLEIGH[SLEIGH.index("[start]") :]
IN_CATALOGUE = (
    "chaplygin-sleigh",
    "roller-racer",
    "snakeboard",
    "trailers",
    "vertical-rolling-disk",
)


def test_a_table_says_what_is_drawn():
    made = Study.from_experiment(parse_experiment(SLEIGH))
    again = Study.from_experiment(parse_experiment(made.complete_toml()))
    assert made.subject.plan == again.subject.plan
    assert [len(getattr(made.subject.plan, kind)) for kind in ("links", "blades", "points")] == [
        1,
        1,
        1,
    ]
    motion = plan_motion(made.subject.plan, made.trajectory())
    assert motion.path.shape == (301, 2)
    # the centre of mass is a = 0.3 ahead of the blade, along its heading
    ahead = motion.points[:, 0] - motion.blades[:, 0, :2]
    heading = motion.blades[:, 0, 2]
    assert np.allclose(ahead, 0.3 * np.stack([np.cos(heading), np.sin(heading)], axis=1))
    assert np.array_equal(motion.links[:, 0, 2:], motion.points[:, 0])


def test_without_a_table_the_constraints_say_it():
    made = Study.from_experiment(parse_experiment(PLAIN))
    assert len(made.subject.plan.wheels) == 1
    assert not made.subject.plan.links
    assert "plan" not in made.complete_toml()


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ('blades = [["x", "y"]]', r"plan.*three formulas"),
        ('path = ["x"]', r"plan.*two formulas for a place"),
        ("points = 3", r"plan.*must be a list of places"),
        ('wheels = [["x", "y", "angle"]]', r"plan.*angle"),
        ('tracks = [["x", "y"]]', r"plan.*unknown key"),
        ('path = ["x", "y +"]', r"plan"),
    ],
)
def test_mistakes_are_told_by_their_place(line, complaint):
    text = PLAIN.replace("[start]", f"[plan]\n{line}\n\n[start]", 1)
    with pytest.raises(InputError, match=complaint) as caught:
        Study.from_experiment(parse_experiment(text))
    assert "line" in str(caught.value)


def test_a_python_file_names_its_plan(tmp_path):
    lines = [
        "from nonholonomic.mechanics.lagrangian.plan import Plan",
        "from nonholonomic.mechanics.lagrangian.mechanism import Mechanism, coordinates",
        "from flowlanes.system.vectors import real_symbol",
        "x, y, xdot, ydot = map(real_symbol, ('x', 'y', 'xdot', 'ydot'))",
        "mechanism = Mechanism('edge', coordinates(x, y), (xdot**2 + ydot**2) / 2,",
        "                      constraints=(ydot - x * xdot,))",
        "start = {x: 0.1, y: 0, xdot: 1, ydot: 0.1}",
    ]
    path = tmp_path / "edge.py"
    path.write_text("\n".join(lines), encoding="utf-8")
    inferred = load_python(path)
    assert len(inferred.subject.plan.wheels) == 1
    path.write_text("\n".join([*lines, "plan = Plan((x, y), points=((x, y),))"]), encoding="utf-8")
    named = load_python(path)
    assert (len(named.subject.plan.wheels), len(named.subject.plan.points)) == (0, 1)
    assert (
        Study.from_experiment(parse_experiment(named.complete_toml())).subject.plan
        == named.subject.plan
    )
    path.write_text("\n".join([*lines, "plan = [x, y]"]), encoding="utf-8")
    with pytest.raises(InputError, match="plan must be a Plan, not list"):
        load_python(path)


@pytest.mark.slow
@pytest.mark.parametrize("name", spread(IN_CATALOGUE))
def test_the_picture_shows_the_mechanism_at_the_end(name):
    made = Study.from_experiment(catalogue_experiment(name))
    trajectory = made.trajectory()
    motion = plan_motion(made.subject.plan, trajectory)
    figure = figures.plan_view(dataset_of(made, trajectory), motion)
    figure.draw(FigureCanvasAgg(figure).get_renderer())
    axes = figure.axes[0]
    assert axes.get_xlabel() == "$x$  (m)"
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    assert left < motion.path[:, 0].min() and motion.path[:, 0].max() < right
    assert low < motion.path[:, 1].min() and motion.path[:, 1].max() < high
    # to scale
    box = axes.get_window_extent()
    assert np.isclose((right - left) / box.width, (high - low) / box.height, rtol=1e-3)
    drawn = [
        np.array(segment)
        for part in axes.collections
        if isinstance(part, LineCollection)
        for segment in part.get_segments()
    ]
    for rod in motion.links[-1].reshape(-1, 2, 2):
        assert any(len(s) == 2 and np.allclose(s, rod) for s in drawn)
    boxes = [
        path.vertices.mean(axis=0)
        for part in axes.collections
        if isinstance(part, PolyCollection)
        for path in part.get_paths()
    ]
    expected = len(motion.wheels[-1]) + 2 * len(motion.axles[-1]) + len(motion.blades[-1])
    assert len(boxes) >= expected > 0


def test_a_plan_without_a_finite_place_is_refused():
    made = Study.from_experiment(parse_experiment(SLEIGH))
    trajectory = made.trajectory()
    motion = plan_motion(made.subject.plan, trajectory)
    motion.path[:] = np.nan
    with pytest.raises(InputError, match="no sample to show"):
        figures.plan_view(dataset_of(made, trajectory), motion)
