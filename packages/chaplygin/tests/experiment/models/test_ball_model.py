"""Experiment files with a homogeneous ball on a surface: read, refused, run, drawn."""

from __future__ import annotations

import re

import numpy as np
import pytest
from pydantic import ValidationError

from chaplygin.experiment.models.ball_model import BallExperiment
from chaplygin.experiment.models.experiment import catalogue_experiment, parse_experiment
from chaplygin.experiment.models.rolling_model import RollingExperiment
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.report.study_output import write_study
from flowlanes.errors import InputError
from lawproof.proof.prover import prove_all
from nonholonomic.system_files.ball_tables import CylinderTable, RoundTable
from nonholonomic.system_files.bodies import moment
from nonholonomic.system_files.body_tables import BallTable, BodyTable
from spread import spread

BALL = """\
[body]
mass = 1.0
inertia = [0.1, 0.1, 0.1]

[body.shape]
kind = "ball"
radius = 0.5

[surface]
kind = "cylinder"
radius = 2.0
side = "inside"

[start]
contact = [2.0, 0.0, 0.0]
omega = [0.0, 1.0, -12.0]

[run]
until = 1.0
samples = 11
"""

#: Every kind of surface with a contact point, and the height of the ball's centre there.
KINDS = {
    'kind = "plane"': ("[1.0, 0.0, 0.0]", 0.5),
    'kind = "sphere"\nradius = 2.0': ("[0.0, 0.0, 2.0]", 2.5),
    'kind = "sphere"\nradius = 2.0\nside = "inside"': ("[0.0, 0.0, -2.0]", -1.5),
    'kind = "cylinder"\nradius = 2.0\naxis = "x"': ("[1.0, 0.0, 2.0]", 2.5),
    'kind = "cylinder"\naxes = [2.0, 3.0]\naxis = "y"': ("[0.0, 1.0, 2.0]", 2.5),
    'kind = "cone"\nslope = 1.0\naxis = "x"': ("[1.0, 0.0, 1.0]", 1.0 + 0.5**1.5),
    'kind = "ellipsoid"\naxes = [3.0, 2.0, 1.0]': ("[0.0, 0.0, 1.0]", 1.5),
    'kind = "paraboloid"\nradii = [1.0, -1.0]': ("[0.0, 0.0, 0.0]", 0.5),
    'kind = "torus"\nradius = 3.0\ntube = 1.0': ("[3.0, 0.0, 1.0]", 1.5),
    'kind = "implicit"\nequation = "z - h*cos(x)"\nparameters = {h = 0.2}': (
        "[0.0, 0.0, 0.2]",
        0.7,
    ),
}


def on(surface, contact):
    text = re.sub(r'kind = "cylinder"\nradius = 2.0\nside = "inside"', surface, BALL)
    return text.replace("[2.0, 0.0, 0.0]", contact).replace("[0.0, 1.0, -12.0]", "[0.1, 0.2, 0.0]")


@pytest.mark.slow
@pytest.mark.parametrize("surface", KINDS)
def test_every_kind_of_surface_is_read_and_run(surface):
    contact, height = KINDS[surface]
    experiment = parse_experiment(on(surface, contact))
    assert isinstance(experiment, BallExperiment)
    assert parse_experiment(experiment.toml()) == experiment
    study = Study.from_experiment(experiment)
    centre = study.trajectory().records["centre"]
    assert centre[0, 2] == pytest.approx(height, rel=1e-14)
    assert parse_experiment(study.complete_toml()) == experiment


def test_laws_of_the_catalogue_are_known():
    study = Study.from_experiment(parse_experiment(BALL))
    names = {law.name for law in study.system.laws}
    assert names == {"energy", "volume", "rotation", "swing", "oscillation"}
    assert {verdict.decision for verdict in prove_all(study.system)} == {"proven"}


def test_the_surface_of_the_centre_may_be_given():
    text = BALL.replace('side = "inside"', 'side = "inside"\ngiven = "centre"')
    study = Study.from_experiment(parse_experiment(text.replace("contact =", "centre =")))
    assert study.start[0] == 2.0
    assert "with its centre on a cylinder" in study.system.title
    assert "the surface of the centre" in study.subject.legend


def test_a_potential_acts_on_the_centre():
    text = BALL + '[field]\ngravity = 0.0\npotential = "k*(x**2 + y**2 + z**2)/2"\n'
    text += "parameters = {k = 3.0}\n"
    study = Study.from_experiment(parse_experiment(text))
    found = study.trajectory().records
    speed = np.sum(found["velocity"] ** 2, axis=1) + 0.1 * np.sum(found["omega"] ** 2, axis=1)
    total = speed / 2 + 1.5 * np.sum(found["centre"] ** 2, axis=1)
    np.testing.assert_allclose(total, total[0], rtol=1e-12)


def test_a_plane_or_sphere_is_a_matter_of_the_start():
    contact = on('kind = "sphere"\nradius = 2.0', "[0.0, 0.0, 2.0]")
    assert isinstance(parse_experiment(contact), BallExperiment)
    rolling = contact.replace("contact = [0.0, 0.0, 2.0]", "gamma = [0.0, 0.0, 1.0]")
    assert isinstance(parse_experiment(rolling), RollingExperiment)


def test_a_full_tensor_may_be_spherical():
    shape = BallTable(radius=1.0)
    full = ((0.4, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.4))
    assert moment(BodyTable(mass=1.0, inertia=full, shape=shape)) == 0.4
    assert moment(BodyTable(mass=1.0, inertia=(0.4, 0.4, 0.5), shape=shape)) is None
    uneven = ((0.4, 0.01, 0.0), (0.01, 0.4, 0.0), (0.0, 0.0, 0.4))
    assert moment(BodyTable(mass=1.0, inertia=uneven, shape=shape)) is None


def test_the_inside_is_a_side():
    assert RoundTable(radius=2.0, side="inside").surface().side == "inside"
    with pytest.raises(ValidationError, match=r'write radius = 2\.0 and side = "inside"'):
        RoundTable(radius=-2.0)


def test_the_setting_in_words():
    experiment = parse_experiment(BALL)
    study = Study.from_experiment(experiment)
    assert study.subject.setting == (
        "Homogeneous ball inside a cylinder, without slipping; gravity 9.81 m/s²"
    )
    free = parse_experiment(
        BALL + '[contact]\nmodel = "rubber"\n[field]\ngravity = 0.0\n', "f.toml"
    )
    assert (
        Study.from_experiment(free).system.title
        == "Homogeneous ball inside a cylinder, rubber contact"
    )
    assert Study.from_experiment(free).subject.setting == (
        "Homogeneous ball inside a cylinder, with neither slipping nor spinning; no gravity"
    )


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("inertia = [0.1, 0.1, 0.1]", "inertia = [0.1, 0.1, 0.11]", "line 1, body: on the surf"),
        ("radius = 0.5", "radius = 0.5\ncentre = [0, 0, 0.1]", "only a homogeneous ball rolls"),
        ('kind = "ball"\nradius = 0.5', 'kind = "disk"\nradius = 0.5', "only a homogeneous ball"),
        ("mass = 1.0", "mass = 1.0\ngyrostat = [0.1, 0, 0]", "only a homogeneous ball rolls"),
        ("radius = 0.5", "radius = 2.5", "line 7, body.shape.radius: 2.5 is too large for a ball"),
        (
            "radius = 2.0",
            "radius = 2.0\naxes = [1.0, 2.0]",
            "give either radius (circular) or axes",
        ),
        ("radius = 2.0", "radios = 2.0", "surface.radios: unknown key, did you mean 'radius'?"),
        ('"inside"', '"within"', 'surface.side: must be "outside" or "inside", not the text'),
        ('"cylinder"', '"implicit"', "surface.equation: missing; it must be a formula in quotes"),
        ("contact =", "centre =", "start: give contact and omega, not centre: the surface is"),
        ("contact = [2.0, 0.0, 0.0]\n", "", "start: give contact and omega, not centre"),
        (
            "contact = [2.0,",
            "contact = [2.1,",
            "line 15, start.contact: [2.1, 0.0, 0.0] misses the",
        ),
        ("contact = [2.0", "gamma = [0.0", "start.gamma: unknown key; allowed: contact, centre,"),
        ("[run]", "[field]\ndirection = [0, 0, 0]\n[run]", "field.direction: must not be zero"),
        ("[run]", '[field]\npotential = "2"\n[run]', "field.potential: a potential must contain x"),
        ("[run]", '[field]\npotential = "q*x"\n[run]', "unknown name 'q'"),
    ],
)
def test_refused_in_one_sentence(old, new, message):
    assert BALL.count(old) == 1
    with pytest.raises(InputError) as refused:
        _ = Study.from_experiment(parse_experiment(BALL.replace(old, new), "ball.toml")).start
    assert message in str(refused.value)


@pytest.mark.parametrize(
    ("surface", "message"),
    [
        ('equation = "5"', "surface.equation: the equation of a surface must contain x, y or z"),
        ('equation = "z - w"', "surface.equation: unknown name 'w'"),
        ('equation = "z - ell*x**2"\nparameters = {ell = 1.0}', "ell stands for two things"),
        ('equation = "z - m*x**2"\nparameters = {m = 1.0}', "the name 'm' has a meaning already"),
        ('equation = "z**2"', "start.contact: the surface has no normal at [0.0, 0.0, 0.0]"),
        ('equation = "z - log(x)"', "start.contact: the equation of the surface has no value"),
    ],
)
def test_bad_equations_are_refused(surface, message):
    text = on(f'kind = "implicit"\n{surface}', "[0.0, 0.0, 0.0]")
    with pytest.raises(InputError) as refused:
        _ = Study.from_experiment(parse_experiment(text, "ball.toml")).start
    assert message in str(refused.value)


def test_what_is_made_in_python_is_checked_too():
    with pytest.raises(ValidationError, match="give either radius"):
        CylinderTable()


@pytest.mark.slow
@pytest.mark.parametrize("made", spread(["file", "catalogue"], 2))
def test_a_study_draws_the_ball(made, tmp_path):
    experiment = (
        parse_experiment(BALL) if made == "file" else catalogue_experiment("marble-ball-on-cone")
    )
    study = Study.from_experiment(experiment)
    _, failure = write_study(study, tmp_path, force=False, total_budget=0)
    assert failure is None
    drawn = {path.name for path in (tmp_path / "figures").iterdir()}
    assert {"scene.png", "scene.svg", "state.png", "normal_force.png", "drift.png"} <= drawn
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "In space axes: R centre of the ball" in page


def test_vectors_in_space_axes_are_stored_as_such():
    study = Study.from_experiment(parse_experiment(BALL))
    dataset = dataset_of(study, study.trajectory())
    for name in ("R", "omega", "centre", "contact", "normal"):
        assert dataset[name].dims == ("time", "space")
    assert dataset["gamma"].dims == ("time", "axis")
    seen = np.linalg.norm(dataset["gamma"].values, axis=1)
    np.testing.assert_allclose(seen, 1.0, rtol=1e-12)
