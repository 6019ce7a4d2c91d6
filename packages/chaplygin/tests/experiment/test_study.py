"""From the text of an experiment to its system, start and motion."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy as sp

from catalogue import built
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.report.summary import drift
from flowlanes.errors import InputError, RunError
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from spread import spread
from studies import catalogue_study

BODY = """\
[body]
mass = 1.3
inertia = {inertia}
gyrostat = [0.0, 0.1, 0.0]
[body.shape]
{shape}
[surface]
{surface}
[contact]
model = "{contact}"
[field]
gravity = 2.0
potential = "q*gamma_3**2"
parameters = {{ q = 0.3 }}
[start]
gamma = [0.48, -0.6, 0.64]
omega = {omega}
[run]
until = 2.0
samples = 5
on_liftoff = "warn"
"""

PLAIN = {
    "inertia": "[1.0, 1.5, 2.1]",
    "shape": 'kind = "ball"\nradius = 0.9\ncentre = [0.1, 0.05, -0.1]',
    "surface": 'kind = "plane"',
    "contact": "marble",
    "omega": "[0.7, 0.4, 1.1]",
}


def text(**changes: str) -> str:
    return BODY.format(**{**PLAIN, **changes})


def study(**changes: str) -> Study:
    return Study.from_experiment(parse_experiment(text(**changes), "body.toml"))


def refusal(source: str) -> str:
    """What is said of an experiment that cannot be prepared or begun."""
    experiment = parse_experiment(source, "body.toml")
    with pytest.raises(InputError) as caught:
        Study.from_experiment(experiment).trajectory()
    return str(caught.value)


# --- what rolls on what ----------------------------------------------------------------------

P = sp.Symbol("b", real=True)
X, Y, Z = ImplicitShape.coordinates

SHAPES = {
    "ball": ('kind = "ball"\nradius = 0.9', Ball(0.9), "Ball on a plane"),
    "ellipsoid": (
        'kind = "ellipsoid"\naxes = [1.0, 0.8, 0.6]\nturn = 0.3\ncentre = [0.0, 0.0, 0.1]',
        Ellipsoid((1.0, 0.8, 0.6), 0.3, centre=(0.0, 0.0, 0.1)),
        "Ellipsoid on a plane",
    ),
    "disk": ('kind = "disk"\nradius = 0.9', Disk(0.9), "Disk on a plane"),
    "torus": (
        'kind = "torus"\nradius = 0.9\ntube = 0.2',
        Torus(0.9, 0.2),
        "Disk with a rounded edge on a plane",
    ),
    "revolution": (
        'kind = "revolution"\nsupport = "sqrt(1 + b*gamma_3**2)"\nparameters = { b = 0.4 }',
        ShapeOfRevolution(sp.sqrt(1 + P * sp.Symbol("gamma_3", real=True) ** 2), {P: 0.4}),
        "Body of revolution on a plane",
    ),
    "profile": (
        'kind = "revolution"\nchi_1 = "-1"\nchi_2 = "-gamma_3"',
        ShapeOfRevolution(sp.Integer(1)),
        "Body of revolution on a plane",
    ),
    "implicit": (
        'kind = "implicit"\nsurface = "x**2 + y**2/b + z**2 - 1"\nparameters = { b = 0.8 }',
        ImplicitShape(X**2 + Y**2 / P + Z**2 - 1, {P: 0.8}),
        "Convex body on a plane",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", SHAPES)
def test_every_shape_is_made_and_rolls(kind):
    table, shape, title = SHAPES[kind]
    made = study(shape=table)
    found = made.rolling.body.shape
    if isinstance(found, ShapeOfRevolution):
        assert sp.simplify(found.support - shape.support) == 0
        assert found.parameters == shape.parameters
    else:
        assert found == shape
    assert made.system.title == title
    assert made.system.name == "-".join(re.findall(r"\w+", title.lower()))
    motion = made.trajectory()
    assert motion.times.tolist() == [0.0, 0.5, 1.0, 1.5, 2.0]
    assert drift(motion["law_energy"]) < 1e-14


def test_a_body_has_what_the_file_says():
    made = study()
    body = made.rolling.body
    assert (body.mass, body.inertia, body.gyrostat) == (1.3, (1.0, 1.5, 2.1), (0.0, 0.1, 0.0))
    assert made.rolling.surface == Plane()
    assert made.rolling.contact == "marble"
    assert made.rolling.field.gravity == 2.0
    values = {str(symbol): value for symbol, value in made.system.defaults.items()}
    assert values["q"] == 0.3
    assert values["c_1"] == 0.1
    assert values["k_2"] == 0.1
    assert not made.subject.from_catalogue
    assert made.subject.summary == ""


@pytest.mark.parametrize(
    ("side", "title"),
    [("outside", "Ball on a sphere"), ("inside", "Ball on the inside of a sphere")],
)
def test_spheres(side, title):
    made = study(surface=f'kind = "sphere"\nradius = 2.0\nside = "{side}"')
    assert made.rolling.surface == Sphere(2.0, side)
    assert made.system.title == title


def test_rubber_contact():
    made = study(contact="rubber", omega="[0.8, 0.64, 0.0]")
    assert made.rolling.contact == "rubber"
    assert made.system.title == "Ball on a plane, rubber contact"
    motion = made.trajectory()
    assert np.abs((motion["omega"] * motion["gamma"]).sum(axis=1)).max() < 1e-14


def test_a_full_tensor_of_inertia():
    made = study(inertia="[[1.0, 0.1, 0.0], [0.1, 1.5, 0.2], [0.0, 0.2, 2.1]]")
    assert made.rolling.body.tensor.tolist() == [[1.0, 0.1, 0.0], [0.1, 1.5, 0.2], [0.0, 0.2, 2.1]]
    assert drift(made.trajectory()["law_energy"]) < 1e-14


def test_a_potential_acts():
    """The couple γ×∂U/∂γ of U = qγ₃², seen in the momentum that a body at rest gains."""
    step = 1e-5
    source = text(omega="[0.0, 0.0, 0.0]").replace("until = 2.0", f"until = {step}")
    free, loaded = (
        Study.from_experiment(parse_experiment(source.replace("q = 0.3", f"q = {q}"))).trajectory()
        for q in (0.0, 0.3)
    )
    gamma = np.array([0.48, -0.6, 0.64])
    couple = np.cross(gamma, [0.0, 0.0, 2 * 0.3 * gamma[2]])
    assert (loaded["M"][-1] - free["M"][-1]) / step == pytest.approx(couple, abs=1e-6)


# --- the catalogue ---------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOGUE)
def test_a_name_is_enough(name):
    made = catalogue_study(name)
    item = CATALOGUE[name]
    assert made.subject.summary == item.summary
    assert made.system == built.system(name)
    assert (made.start_values, made.until) == (item.start.values, item.start.until)
    assert (made.rolling is None) == isinstance(item.build(item.numbers()), System)
    assert made.times[-1] == item.start.until
    assert len(made.times) == 101
    assert made.remarks == ()


def test_what_a_file_says_goes_before_the_catalogue():
    made = Study.from_experiment(
        parse_experiment(
            """
[system]
name = "chaplygin-ball"
[system.parameters]
I_1 = 1.25
[start]
omega = [0.0, 0.0, 0.0]
gamma = [0.0, 0.6, 0.8]
[run]
until = 3.0
samples = 4
"""
        )
    )
    assert made.system.defaults[sp.Symbol("I_1", real=True)] == 1.25
    assert made.system.defaults[sp.Symbol("I_2", real=True)] == 1.5
    motion = made.trajectory()
    assert motion["omega"].tolist() == [[0.0, 0.0, 0.0]] * 4
    assert motion["gamma"][-1] == pytest.approx([0.0, 0.6, 0.8], abs=1e-15)
    assert made.times.tolist() == [0.0, 1.0, 2.0, 3.0]


# --- start and times -------------------------------------------------------------------------


def test_gamma_is_normalised_with_a_remark():
    made = Study.from_experiment(
        parse_experiment(text().replace("[0.48, -0.6, 0.64]", "[0.96, -1.2, 1.28]"))
    )
    assert made.remarks == (
        "start.gamma has length 2; it was normalised to "
        "[0.47999999999999998, -0.59999999999999998, 0.64000000000000001]",
    )
    assert [float(x) for x in made.start] == [float(x) for x in study().start]
    assert study().remarks == ()


def test_heading_turns_the_body_about_the_vertical():
    turned = Study.from_experiment(
        parse_experiment(text().replace("[run]", "heading = 1.5707963267948966\n[run]"))
    )
    plain, other = study().trajectory(), turned.trajectory()
    x, y, z = plain["centre"].T - plain["contact"][0][:, None]
    turned_place = other["centre"].T - other["contact"][0][:, None]
    assert turned_place == pytest.approx(np.array([-y, x, z]), abs=1e-13)


def test_normal_places_the_contact_on_a_sphere():
    source = text(surface='kind = "sphere"\nradius = 2.0')
    made = Study.from_experiment(
        parse_experiment(source.replace("[run]", "normal = [3.0, 0.0, 4.0]\n[run]"))
    )
    assert made.trajectory()["contact"][0] == pytest.approx([1.2, 0.0, 1.6], abs=1e-15)


def test_backward_in_time():
    made = Study.from_experiment(
        parse_experiment(text().replace("[run]", '[run]\ndirection = "backward"'))
    )
    assert made.times.tolist() == [0.0, -0.5, -1.0, -1.5, -2.0]
    assert made.trajectory().times[-1] == -2.0


@pytest.mark.slow
def test_the_wishes_of_run_are_granted():
    wishes = {
        "precision = 'quad'\ntolerance = 1e-25": lambda motion: motion.states.dtype != float,
        "tolerance = 1e-6": lambda motion: motion.statistics.order < 12,
        "keep_integrals = true\ntolerance = 1e-6": lambda m: drift(m["law_energy"]) < 1e-14,
    }
    for wish, granted in wishes.items():
        source = text().replace("[run]", f"[run]\n{wish}")
        assert granted(Study.from_experiment(parse_experiment(source)).trajectory()), wish


def test_a_time_limit_is_kept():
    source = text().replace("until = 2.0", "until = 1e7\ntime_limit = 0.01")
    with pytest.raises(RunError, match=r"the time limit of 0\.01 s was reached"):
        Study.from_experiment(parse_experiment(source)).trajectory()


def test_finer_samples_do_not_disturb_the_given_ones():
    made = study()
    plain, fine = made.trajectory(), made.trajectory(pieces=3)
    assert len(fine.times) == 13
    thin = fine.subsample(3)
    assert thin.times.tolist() == plain.times.tolist()
    assert thin.states.tolist() == plain.states.tolist()
    for name, values in plain.records.items():
        assert thin.records[name].tolist() == values.tolist()


def test_a_dense_trajectory_on_request():
    assert study().trajectory().dense is None
    assert study().trajectory(dense=True).dense.span == (0.0, 2.0)


# --- the complete file -----------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", spread(CATALOGUE))
def test_the_complete_file_of_the_catalogue_makes_the_same_study(name):
    made = catalogue_study(name)
    again = Study.from_experiment(parse_experiment(made.complete_toml()))
    assert again.system == made.system
    assert again.start == made.start
    assert again.times.tolist() == made.times.tolist()
    assert again.complete_toml() == made.complete_toml()


@pytest.mark.parametrize("kind", SHAPES)
def test_the_complete_file_of_a_body_makes_the_same_motion(kind):
    made = study(shape=SHAPES[kind][0])
    again = Study.from_experiment(parse_experiment(made.complete_toml()))
    assert again.trajectory().states.tolist() == made.trajectory().states.tolist()


def test_the_dataset_holds_the_complete_file():
    made = study()
    motion = made.trajectory()
    dataset = dataset_of(made, motion)
    assert dataset.attrs["experiment"] == made.complete_toml()
    assert dataset.attrs["complete"] == 1
    assert dataset_of(made, motion, complete=False).attrs["complete"] == 0
    assert dataset.equals(motion.to_dataset())


# --- mistakes --------------------------------------------------------------------------------

SYSTEM = '[system]\nname = "{name}"\n[system.parameters]\n{parameters}\n'


@pytest.mark.parametrize(
    ("source", "place", "message"),
    [
        (
            SYSTEM.format(name="chaplygin-bal", parameters=""),
            "body.toml, line 2, system.name: ",
            "no system 'chaplygin-bal' in the catalogue (did you mean 'chaplygin-ball'?)",
        ),
        (
            SYSTEM.format(name="heavy-disk", parameters="I_2 = 1.0"),
            "body.toml, line 3, system.parameters: ",
            "heavy-disk: no parameter I_2 (did you mean I_",
        ),
        (
            SYSTEM.format(name="heavy-disk", parameters="I_3 = 5.0"),
            "body.toml, line 3, system.parameters",
            "break the triangle inequality",
        ),
        (
            text(contact="rubber"),
            "body.toml, line 19, start.omega: ",
            "the nearest admissible omega is [",
        ),
        (
            text(shape='kind = "disk"\nradius = 1.0').replace("[0.48, -0.6, 0.64]", "[0, 0, 1]"),
            "body.toml, line 17, start.gamma: ",
            "the body lies flat",
        ),
        (
            text(shape='kind = "revolution"\nchi_1 = "-1"\nchi_2 = "-2*gamma_3"'),
            "body.toml, line 5, body.shape",
            "the surface has no normal -gamma",
        ),
        (
            text(shape='kind = "revolution"\nsupport = "gamma_3"'),
            "body.toml, line 7, body.shape.support: ",
            "must be positive, the distance of the tangent plane from the centre",
        ),
        (
            text(shape='kind = "implicit"\nsurface = "x**2 + y**2 + z**2 + 1"'),
            "body.toml, line 7, body.shape.surface: ",
            "must be negative there (negative inside, zero on the surface)",
        ),
        (
            text(shape='kind = "implicit"\nsurface = "x**2 + y**2 + z - 1"'),
            "body.toml, line 7, body.shape.surface: ",
            "it is not closed",
        ),
    ],
    ids=[
        "system",
        "parameter",
        "inertia",
        "spin",
        "flat",
        "profile",
        "support",
        "inside out",
        "open surface",
    ],
)
def test_a_mistake_that_only_mechanics_sees_has_its_place(source, place, message):
    said = refusal(source)
    assert said.startswith(place)
    assert message in said
    assert "\n" not in said


@pytest.mark.slow
def test_one_word_chooses_the_method():
    taylor = Study.from_experiment(parse_experiment(text())).trajectory()
    gauss = Study.from_experiment(
        parse_experiment(text().replace("[run]", '[run]\nmethod = "gauss"'))
    ).trajectory()
    assert (taylor.statistics.order, gauss.statistics.order) == (19, 16)
    assert np.abs(taylor.states - gauss.states).max() < 1e-12


@pytest.mark.parametrize("key", ["tolerance = 1e-10", "time_limit = 5.0"])
def test_collocation_has_no_tolerance_and_no_time_limit(key: str) -> None:
    with pytest.raises(InputError, match=r'there is none with run\.method = "gauss"'):
        parse_experiment(text().replace("[run]", f'[run]\nmethod = "gauss"\n{key}'))
