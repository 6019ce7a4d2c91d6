"""What a page computes, against Python: the same motions, columns, sections, starts."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp

import chaplygin as ch
import nonholonomic
from chaplygin.experiment.study import dataset_of
from chaplygin.page.page_model import live_page_model
from chaplygin.page.page_systems import reduced_system
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.recorded_quantities import recorded_values
from flowlanes.lyapunov.indicators import maximal_exponent
from flowlanes.system.vectors import Vector
from page.motions import (
    CLOSE,
    EXAMPLES,
    allowed_difference,
    motion_by_series,
    motion_in_python,
    replace_relations,
    study_of,
    whole_system,
)
from page.node import needs_node, rows, run_engine

pytestmark = needs_node

#: Systems of each kind: a body, a ball on a surface, a mechanism, one without motion in space.
FEW = [
    "unbalanced-ball",
    "chaplygin-sleigh",
    pytest.param("rubber-ball-on-torus", marks=pytest.mark.slow),
    pytest.param("clebsch", marks=pytest.mark.slow),
]

KINDS = ("megno", "lyapunov")


@cache
def model_of(name):
    return live_page_model(study_of(name))


def assert_same_motion(name, until=20.0):
    study, model = study_of(name), model_of(name)
    times = np.arange(1, 21) / 20 * until
    task = {"parameters": {}, "start": model["start"], "times": times.tolist()}
    (result,) = run_engine(model, ("motion", [task]))
    expected, moved, run = motion_in_python(study, times)
    got = rows(result["states"], len(model["start"]))
    count = int(np.isfinite(expected).all(axis=1).sum())
    assert len(got) == count
    size = np.abs(expected[:count]).max(initial=1e-300)
    off = np.abs(got - expected[:count]).max(axis=1, initial=0.0)
    allowed = allowed_difference(study, times, expected[:count], moved)
    assert np.all(off <= allowed), off / size
    series = motion_by_series(study, times)[:count]
    off = np.abs(got[: len(series)] - series).max(axis=1, initial=0.0)
    assert np.all(off <= allowed[: len(series)]), off / size
    if run.outcome[0]:
        assert result["end"]["reason"] == model["wasm_tables"]["reasons"][run.outcome[0]]
        assert abs(result["end"]["time"]) == pytest.approx(abs(run.end_times[0]), rel=1e-9)
    else:
        assert result["end"] is None


@pytest.mark.parametrize("name", FEW)
def test_motions_agree(name):
    assert_same_motion(name)


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(nonholonomic.CATALOGUE))
def test_motions_of_the_catalogue_agree(name):
    assert_same_motion(name)


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.toml")))
def test_motions_of_the_examples_agree(name):
    if study_of(name).subject.changes_equations:
        with pytest.raises(ch.InputError, match="friction"):
            model_of(name)
    else:
        assert_same_motion(name)


#: Motions in which errors of rounding grow most, by what was measured of all.
DELICATE = [
    "ball-around-sphere-hamiltonian",
    "ball_in_a_bowl.toml",
    "ball_in_a_pipe.toml",
    "coin.toml",
    "driven_pendulum.toml",
    "rattleback",
    "rattleback.toml",
    "spherical_pendulum.toml",
]


@pytest.mark.slow
@pytest.mark.parametrize("name", DELICATE)
def test_delicate_motions_are_those_of_thirty_digits(name):
    study, model = study_of(name), model_of(name)
    times = np.arange(1, 21.0)
    task = {"parameters": {}, "start": model["start"], "times": times.tolist()}
    (result,) = run_engine(model, ("motion", [task]))
    got = rows(result["states"], len(model["start"]))
    flow = replace_relations(
        batch_integrator(whole_system(study), tolerance=1e-20, precision="quad")
    )
    right = flow.propagate([model["start"]], times).states[0]
    assert np.abs(got - right).max() < CLOSE * np.abs(right).max()


@pytest.mark.parametrize("name", FEW)
def test_columns_are_those_of_the_dataset(name):
    study, model = study_of(name), model_of(name)
    task = {"parameters": {}, "start": model["start"], "times": [0.0, 0.5, 1.0]}
    (result,) = run_engine(model, ("motion", [task]))
    states = rows(result["states"], len(model["start"]))
    np.testing.assert_array_equal(states[0], model["start"])
    whole = whole_system(study)
    expected = recorded_values(replace(whole, laws=study.system_on_level.laws), states)
    widths = {column["name"]: column["width"] for column in model["columns"]}
    assert expected.keys() <= result["columns"].keys() == widths.keys()
    for key, values in expected.items():
        got = rows(result["columns"][key], widths[key])
        scale = np.abs(values).max() + 1e-300
        np.testing.assert_allclose(got, values.reshape(got.shape), atol=1e-12 * scale)


def test_sections_agree():
    """Points of a section of an integrable motion, and of one on an angle."""
    study, model = study_of("unbalanced-ball"), model_of("unbalanced-ball")
    start = [float(x) for x in study.start]
    reduced = reduced_system(study)
    for on, angle, direction in (("M_1", False, 1), ("M_1", False, -1), ("longitude", True, 0)):
        task = {
            "parameters": {},
            "start": start,
            "on": on,
            "value": 0.3,
            "direction": direction,
            "points": 30,
        }
        (result,) = run_engine(model, ("section", [task]))
        text = next(q["formula"] for q in model["quantities"] if q["name"] == on)
        section = poincare_section(reduced, text, 0.3, direction, angle)
        expected = batch_integrator(reduced, section=section).crossings([start[:6]], 30)
        assert expected.counts[0] == 30 and result["end"] is None
        np.testing.assert_allclose(rows(result["rows"], 6), expected.states[0], atol=1e-11)
        np.testing.assert_allclose(rows(result["times"], 1)[:, 0], expected.times[0], atol=1e-10)


def test_parameters_are_taken():
    study, model = study_of("unbalanced-ball"), model_of("unbalanced-ball")
    task = {"parameters": {"m": 1.7}, "start": model["start"], "times": [1.0, 2.0]}
    (result,) = run_engine(model, ("motion", [task]))
    flow = batch_integrator(whole_system(study))
    expected = flow.propagate([model["start"]], [1.0, 2.0], {"m": 1.7}).states[0]
    np.testing.assert_allclose(rows(result["states"], len(model["start"])), expected, atol=1e-13)
    (refused,) = run_engine(model, ("motion", [{**task, "parameters": {"mass": 1.0}}]))
    assert "no parameter mass; it has" in refused["error"]


@pytest.mark.parametrize(
    "name",
    [
        "unbalanced-ball",
        pytest.param("rubber-body", marks=pytest.mark.slow),
        pytest.param("veselova", marks=pytest.mark.slow),
        pytest.param("marble-ball-on-torus", marks=pytest.mark.slow),
        pytest.param("cushion.toml", marks=pytest.mark.slow),
    ],
)
def test_a_start_is_that_of_python(name):
    study, model = study_of(name), model_of(name)
    (result,) = run_engine(model, ("startFrom", [{"parameters": {}, "inputs": {}}]))
    expected = [float(x) for x in study.start]
    np.testing.assert_allclose([float(x) for x in result["state"]], expected, atol=1e-14)


def message_of_python(name, *changes):
    with pytest.raises(ch.InputError) as caught:
        study = ch.Study.from_experiment(
            ch.parse_experiment(f'system = {{name = "{name}"}}', overrides=list(changes))
        )
        study.trajectory()
    return caught.value.message


def message_of_engine(name, parameters, inputs):
    task = {"parameters": parameters, "inputs": inputs}
    (result,) = run_engine(model_of(name), ("startFrom", [task]))
    return result["message"]


@pytest.mark.slow
def test_starts_are_refused_in_the_words_of_python():
    spins = message_of_engine("rubber-body", {}, {"omega_3": 9.0})
    assert spins.startswith("omega: (omega, gamma) = ")
    study = study_of("rubber-body")
    omega = [*study.start_values["omega"][:2], 9.0]
    python = message_of_python("rubber-body", f"start.omega={omega}")
    cut = "the nearest admissible omega is ["
    # a file's place stands before the sentence, in place of the name
    assert spins.partition(cut)[0].removeprefix("omega: ") in python
    heavy = message_of_engine("unbalanced-ball", {"m": -1.0}, {})
    with pytest.raises(ch.InputError) as caught:
        ch.integrate(
            study_of("unbalanced-ball").system,
            model_of("unbalanced-ball")["start"],
            [0, 1],
            parameters={"m": -1.0},
        )
    assert heavy == caught.value.message


def test_points_of_a_section_come_back_to_their_states():
    """From the coordinates of points on a section to their states, on the level of another."""
    model = model_of("unbalanced-ball")
    section = {"on": "M_1", "value": 0.0, "direction": 1, "x": "longitude", "y": "M_3"}
    task = {"parameters": {}, "start": model["start"], "points": 12, **section}
    (result,) = run_engine(model, ("section", [task]))
    states = rows(result["rows"], 6)
    (flat,) = run_engine(model, ("quantities", [{}, states.ravel().tolist(), 6]))
    names = [q["name"] for q in model["quantities"]]
    points = rows(flat, len(names))[:, [names.index("longitude"), names.index("M_3")]]
    level = {"parameters": {}, "reference": states[0].tolist(), "section": section}
    tasks = [("startOnLevel", [{**level, "x": x, "y": y}]) for x, y in points[1:].tolist()]
    for found, state in zip(run_engine(model, *tasks), states[1:], strict=True):
        whole = np.array([float(x) for x in found["state"]])
        np.testing.assert_allclose(whole[:6], state, atol=1e-9)
        # the attitude takes the normal to the vertical
        w, x, y, z = whole[6:10]
        row = [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]
        np.testing.assert_allclose(row, whole[3:6], atol=1e-12)
    (none,) = run_engine(model, ("startOnLevel", [{**level, "x": 0, "y": 1e3}]))
    assert "no state on this level was found at longitude = 0, M_3 = 1000" in none["message"]


def test_an_attitude_belongs_to_every_state_of_a_section():
    """Also far from the reference, at whose attitude the search begins; five are off the level."""
    model = model_of("unbalanced-ball")
    section = {"on": "gamma_1", "value": 0, "direction": 1, "x": "gamma_2", "y": "M_3"}
    level = {"parameters": {}, "reference": model["start"], "section": section}
    points = [(x, y) for x in (0.3, 0.5, 0.7, 0.9) for y in (2.2, 2.4, 2.6)]
    tasks = [("startOnLevel", [{**level, "x": x, "y": y}]) for x, y in points]
    results = run_engine(model, *tasks)
    assert sum("state" in result for result in results) == 7
    assert not any("attitude" in result.get("message", "") for result in results)


@pytest.mark.slow
def test_integrals_may_be_coordinates():
    """A state with other values of two integrals, as for a click into a bifurcation diagram."""
    model = model_of("clebsch")
    names = [q["name"] for q in model["quantities"]]
    integrals = model["wasm_tables"]["integrals"]
    x, y = integrals[:2]
    start = model["start"]

    def integrals_at(state):
        (flat,) = run_engine(model, ("quantities", [{}, state, len(start)]))
        return {name: float(flat[names.index(name)]) for name in (*integrals, names[0])}

    before = integrals_at(start)
    section = {"on": names[0], "value": before[names[0]], "direction": 0, "x": x, "y": y}
    wanted = {x: 1.02 * before[x], y: 0.99 * before[y]}
    task = {
        "parameters": {},
        "reference": start,
        "section": section,
        "x": wanted[x],
        "y": wanted[y],
    }
    (found,) = run_engine(model, ("startOnLevel", [task]))
    after = integrals_at([float(value) for value in found["state"]])
    # the last of four integrals depends on the others
    for name, value in {**before, **wanted}.items():
        if name == integrals[3]:
            continue
        assert after[name] == pytest.approx(value, abs=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "until", "close"),
    [("chaplygin-ball", 200.0, 0.3), ("driven_pendulum.toml", 300.0, 0.4)],
)
def test_indicators_are_those_of_python(name, until, close):
    """A regular motion, and a chaotic one; deviations start in other directions than there."""
    study, model = study_of(name), model_of(name)
    task = {"parameters": {}, "start": model["start"], "until": until}
    megno, exponent = map(
        float, run_engine(model, *(("indicator", [{**task, "kind": k}]) for k in KINDS))
    )
    reduced = reduced_system(study)
    start = np.array([model["start"][: model["reduced"]]])
    expected = maximal_exponent(reduced, until)(start, {})
    assert abs(exponent - expected["value"][0]) < 2 * expected["error"][0]
    value = megno(reduced, until)(start, {})["value"][0]
    assert abs(megno - value) < close * value


@pytest.mark.slow
def test_the_mesh_of_a_body_follows_its_parameters():
    model = model_of("rattleback")
    first, changed = run_engine(model, ("surfaces", [{}]), ("surfaces", [{"b_1": 0.3}]))
    mesh = first["body"]
    body = model["scene"]["body"]
    grid = len(body["theta"]) * len(body["phi"])
    points = rows(mesh["positions"], 3)[:grid]
    gamma = -rows(mesh["normals"], 3)[:grid]
    expected = study_of("rattleback").rolling.body.shape.contact_points()(gamma)
    np.testing.assert_allclose(points, expected, atol=1e-7)
    long = np.ptp(rows(changed["body"]["positions"], 3)[:, 0])
    assert long == pytest.approx(0.6, rel=2e-3)


@pytest.mark.slow
def test_the_ellipsoid_of_inertia_follows_its_parameters():
    model = model_of("rattleback")
    changed = {"I_1": 0.0061}
    (result,) = run_engine(model, ("surfaces", [changed]))
    moments = {p["name"]: p["value"] for p in model["parameters"]} | changed
    points = rows(result["inertia"]["positions"], 3)
    inertia = [moments[f"I_{i}"] for i in (1, 2, 3)]
    # the caps at both poles are flat
    on_it = points**2 @ inertia
    assert np.median(on_it) == pytest.approx(1.0, abs=1e-6)
    assert on_it.max() < 1.0 + 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("name", ["marble-ball-on-ellipsoid", "marble-ball-on-paraboloid"])
def test_what_carries_a_ball_follows_its_parameters(name):
    """The corners lie one radius from places of the centre, on the surface f = 0 of those."""
    study = study_of(name)
    model = live_page_model(study, dataset_of(study, study.trajectory()))
    size = "a_1" if name.endswith("ellipsoid") else "b"
    changed = {size: 1.1 * next(p["value"] for p in model["parameters"] if p["name"] == size)}
    (result,) = run_engine(model, ("surfaces", [changed]))
    surface = result["ground"]
    points, normals = (rows(surface[key], 3) for key in ("positions", "normals"))
    ball, numbers = study.subject.ball, {**study.system.defaults}
    numbers |= {s: changed[str(s)] for s in numbers if str(s) in changed}
    b = next(value for s, value in numbers.items() if str(s) == "b")
    shifted = points + (b * normals if ball.carrier == "centre" else 0.0)
    f = sp.lambdify(Vector("x").symbols, ball.carrying.subs(numbers), "numpy")
    assert np.abs(f(*shifted.T)).max() < 1e-5


@pytest.mark.slow
def test_a_ball_follows_its_radius():
    model = model_of("marble-ball-on-cylinder")
    (result,) = run_engine(model, ("surfaces", [{"b": 0.2}]))
    assert np.ptp(rows(result["body"]["positions"], 3)[:, 2]) == pytest.approx(0.4, rel=1e-6)
