"""Models of pages without a module, against the datasets that they show."""

from __future__ import annotations

import json
import re
from base64 import b64decode
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import chaplygin as ch
from chaplygin.experiment.study import dataset_of
from chaplygin.experiment.subjects.plan import plan_motion
from chaplygin.page.columns import symbol_mathml
from chaplygin.page.page_model import page_model
from chaplygin.page.wasm_module import positive_where
from chaplygin.report.drawing.modes import MODE_STYLES

EXAMPLES = Path(__file__).parents[4] / "examples"


def of_system(name, *more):
    settings = ["run.until=2", "run.samples=21", *more]
    study = ch.Study.from_experiment(
        ch.parse_experiment(f'system = {{name = "{name}"}}', overrides=settings)
    )
    trajectory = study.trajectory()
    dataset = dataset_of(study, trajectory)
    model = json.loads(json.dumps(page_model(study, dataset), allow_nan=False))
    return study, trajectory, dataset, model


def numbers(text):
    return np.frombuffer(b64decode(text), "<f8")


@pytest.mark.parametrize("name", ["rattleback", "suslov", "unbalanced-ball"])
def test_columns_are_those_of_the_dataset_to_the_bit(name):
    _, _, dataset, model = of_system(name)
    recorded = model["recorded"]
    np.testing.assert_array_equal(numbers(recorded["times"]), dataset["time"])
    known = set(recorded["columns"]) - {"contact_force"}
    assert known == set(dataset.data_vars)
    assert list(recorded["columns"]) == [column["name"] for column in model["columns"]]
    for column in model["columns"]:
        if column["name"] in dataset:
            expected = dataset[column["name"]].to_numpy()
            got = numbers(recorded["columns"][column["name"]]).reshape(expected.shape)
            np.testing.assert_array_equal(got, expected)
            assert column["width"] == expected[0].size
    assert recorded["end"] is None


def test_the_contact_force_is_the_sum_of_its_parts():
    _, _, dataset, model = of_system("rattleback")
    force = numbers(model["recorded"]["columns"]["contact_force"]).reshape(-1, 3)
    normal = dataset["normal_force"].to_numpy()[:, None] * dataset["gamma"].to_numpy()
    np.testing.assert_allclose(force, normal + dataset["friction_force"], rtol=1e-12)
    # three components that are nearly cancelled weigh the body: m g less what it accelerates
    assert np.all(np.linalg.norm(force, axis=1) > 0.0)


def test_modes_of_a_contact_change_at_its_events():
    settings = ["run.until=2", "run.samples=21"]
    study = ch.Study.from_experiment(ch.load_experiment(EXAMPLES / "bouncing_ball.toml", settings))
    dataset = dataset_of(study, study.trajectory())
    recorded = page_model(study, dataset)["recorded"]
    modes = recorded["modes"]
    assert modes[0]["begin"] == 0.0 and modes[-1]["end"] == 2.0
    assert [m["end"] for m in modes[:-1]] == [m["begin"] for m in modes[1:]]
    changes = {m["begin"] for m in modes[1:]}
    # no change is at a sample: they are the events' own instants
    assert changes and changes <= set(dataset["event_time"].values)
    assert not changes & set(dataset["time"].values)
    assert {m["mode"] for m in modes} <= set(MODE_STYLES)
    assert [e["kind"] for e in recorded["events"]] == list(dataset["event_kind"].values)
    assert [e["time"] for e in recorded["events"]] == list(dataset["event_time"].values)


def test_a_system_without_friction_has_no_modes():
    recorded = of_system("rattleback")[-1]["recorded"]
    assert recorded["modes"] == recorded["events"] == []


def test_live_pages_and_still_figures_have_the_same_colours_of_modes():
    palette = (Path(__file__).parents[4] / "packages/chaplygin/web/src/page/palette.ts").read_text(
        "utf-8"
    )
    day, night = (
        dict(re.findall(r'"?([a-z ]+?)"?: "(#[0-9a-f]{6})"', block))
        for block in re.findall(r"  modes: \{\n(.*?)\n  \},", palette, flags=re.S)
    )
    assert {mode.strip(): colour for mode, colour in day.items()} == {
        mode: style.colour for mode, style in MODE_STYLES.items()
    }
    assert {mode.strip() for mode in night} == set(MODE_STYLES)


def test_links_of_a_mechanism_are_those_of_its_drawing():
    study, trajectory, _, model = of_system("chaplygin-sleigh")
    assert model["kind"] == "mechanism" and model["scene"]["body"] is None
    motion = plan_motion(study.subject.plan, trajectory)
    columns = model["recorded"]["columns"]
    path = numbers(columns[model["scene"]["path"]]).reshape(-1, 2)
    np.testing.assert_allclose(path, motion.path, atol=1e-14)
    parts = {"rod": motion.links, "blade": motion.blades, "point": motion.points}
    links = model["scene"]["links"]
    assert [link["kind"] for link in links] == ["rod", "blade", "point"]
    for link in links:
        expected = parts[link["kind"]][:, 0]
        got = numbers(columns[link["column"]]).reshape(expected.shape)
        np.testing.assert_allclose(got, expected, atol=1e-14)


def test_the_body_of_a_page_is_the_body():
    study, _, _, model = of_system("rattleback")
    body = model["scene"]["body"]
    points = np.frombuffer(b64decode(body["positions"]), "<f4").reshape(-1, 3)
    assert len(points) == len(body["theta"]) * len(body["phi"])
    semi_axes = study.rolling.body.shape.axes
    np.testing.assert_allclose(np.ptp(points, axis=0).max(), 2 * max(semi_axes), rtol=1e-3)


def test_start_and_ranges():
    study, _, _, model = of_system("rattleback")
    np.testing.assert_array_equal(model["start"], [float(x) for x in study.start])
    assert len(model["state"]) == len(model["start"]) > model["reduced"] == 6
    names = [row["name"] for row in model["start_inputs"]]
    assert names == [*(f"{v}_{i}" for v in ("omega", "gamma") for i in (1, 2, 3)), "heading"]
    for row in [*model["start_inputs"], *model["parameters"]]:
        assert row["low"] <= row["value"] <= row["high"]
    assert all(p["low"] > 0 for p in model["parameters"] if p["name"] in ("m", "b_1", "I_1"))
    # it rocks many times before it turns the other way
    assert model["guards"] and model["section"]["on"] == "gamma_1"


def test_a_motion_that_ends_early_says_why():
    """A coin that falls over leaves the plane."""
    experiment = ch.load_experiment(
        EXAMPLES / "coin.toml", overrides=["start.omega=[0.0, 1.0, 0.0]"]
    )
    study = ch.Study.from_experiment(experiment)
    dataset = dataset_of(study, study.trajectory())
    end = page_model(study, dataset)["recorded"]["end"]
    assert dataset.attrs["events"].endswith(end["reason"])
    assert end["time"] == dataset["time"][-1] < study.until


def test_a_rate_is_written_with_a_dot_and_a_word_as_a_word() -> None:
    assert "<mover" in symbol_mathml("phidot")
    assert symbol_mathml("spin") == ""


def test_a_page_checks_alternatives_of_conditions():
    a, b = sp.symbols("a b", real=True)
    condition = sp.Or(a > 1, sp.And(a <= -1, sp.Ne(b, 0)))
    side = positive_where(condition)
    for values in ((2, 0), (-1, 3), (-4, -1), (1, 0), (0.3, 5), (-1, 0), (-0.9, 1)):
        point = dict(zip((a, b), map(sp.Float, values), strict=True))
        assert bool(side.xreplace(point) > 0) == bool(condition.xreplace(point))
