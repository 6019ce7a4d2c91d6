"""Experiment files: what is read, what is refused and in which words, and round trips."""

import re
from pathlib import Path

import pytest
from pydantic import ValidationError

from chaplygin.experiment.file.tables import StartTable
from chaplygin.experiment.models.catalogue_models import SystemExperiment
from chaplygin.experiment.models.experiment import load_experiment, parse_experiment
from chaplygin.experiment.models.rolling_model import RollingExperiment
from flowlanes.errors import InputError
from nonholonomic.system_files.body_tables import (
    BallTable,
    BodyTable,
    EllipsoidTable,
    ImplicitTable,
    RevolutionTable,
)
from nonholonomic.system_files.rolling_tables import FieldTable, PlaneTable, SphereTable

ROLLING = """\
[body]
mass = 1.0
inertia = [1.0, 1.5, 2.1]     # principal
gyrostat = [0.0, 0.0, 0.0]

[body.shape]
kind = "ball"
radius = 1.0
centre = [-0.1, 0.05, 0.2]

[surface]
kind = "plane"

[contact]
model = "marble"

[field]
gravity = 9.81

[start]
gamma = [0.2, -0.3, 0.93]
omega = [0.7, 0.4, 1.1]

[run]
until = 10.0
samples = 101
tolerance = 1e-15
"""

SHORTEST = """
[body]
mass = 2
inertia = [1, 1, 1]
shape = { kind = "ball", radius = 1 }
[start]
gamma = [0, 0, 1]
omega = [1, 0, 0]
"""

SYSTEM = """
[system]
name = "chaplygin-ball"
[system.parameters]
m = 2
"""


def rolling(*overrides: str, text: str = ROLLING) -> RollingExperiment:
    experiment = parse_experiment(text, "body.toml", overrides)
    assert isinstance(experiment, RollingExperiment)
    return experiment


def system(*overrides: str, text: str = SYSTEM) -> SystemExperiment:
    experiment = parse_experiment(text, "body.toml", overrides)
    assert isinstance(experiment, SystemExperiment)
    return experiment


def refused(text: str, *overrides: str) -> str:
    with pytest.raises(InputError) as caught:
        parse_experiment(text, "body.toml", overrides)
    return str(caught.value)


# --- what is read --------------------------------------------------------------------------


def test_values_of_a_file() -> None:
    experiment = rolling()
    assert experiment.body.mass == 1.0
    assert experiment.body.inertia == (1.0, 1.5, 2.1)
    assert experiment.body.shape == BallTable(radius=1.0, centre=(-0.1, 0.05, 0.2))
    assert experiment.surface == PlaneTable()
    assert experiment.contact.model == "marble"
    assert experiment.start.omega == (0.7, 0.4, 1.1)
    assert experiment.text == ROLLING


def test_defaults() -> None:
    experiment = rolling(text=SHORTEST)
    assert experiment.body.gyrostat == (0.0, 0.0, 0.0)
    assert experiment.surface == PlaneTable()
    assert experiment.contact.model == "marble"
    assert experiment.field == FieldTable(gravity=9.81, potential="")
    assert (experiment.start.heading, experiment.start.normal) == (0.0, (0.0, 0.0, 1.0))
    run = experiment.run
    assert (run.until, run.samples, run.tolerance) == (10.0, 101, 1e-15)
    assert (run.precision, run.direction, run.on_liftoff) == ("double", "forward", "stop")
    assert (run.keep_integrals, run.time_limit) == (False, None)


def test_empty_tables_are_defaults() -> None:
    assert rolling(text=SHORTEST + "[surface]\n[contact]\n[field]\n[run]\n") == rolling(
        text=SHORTEST
    )


def test_system_of_the_catalogue() -> None:
    experiment = system()
    assert experiment.system.name == "chaplygin-ball"
    assert experiment.system.parameters == {"m": 2.0}
    assert (experiment.start.gamma, experiment.start.omega) == (None, None)
    assert experiment.run.until is None
    again = system("start.omega=[1, 2, 3]", "run.until=3")
    assert (again.start.omega, again.run.until) == ((1.0, 2.0, 3.0), 3.0)


@pytest.mark.parametrize(
    "overrides",
    [
        ["body.inertia=[[2, 0.1, 0], [0.1, 2, 0], [0, 0, 2]]"],
        ["body.inertia=[0.1, 0.7, 0.8]"],  # flat, though 0.1 + 0.7 < 0.8 in floating point
        ['body.shape={kind="ellipsoid", axes=[3, 2, 1], turn=0.3}'],
        ['body.shape={kind="disk", radius=2}'],
        ['body.shape={kind="torus", radius=2, tube=0.5}'],
        ['body.shape={kind="revolution", support="1 + a*gamma_3**2", parameters={a=0.1}}'],
        ['body.shape={kind="revolution", chi_1="-2", chi_2="-2*gamma_3"}'],
        ['body.shape={kind="implicit", surface="x**4 + y**4 + z**4/b - 1", parameters={b=2}}'],
        ["surface.kind=sphere", "surface.radius=2"],
        [
            "surface.kind=sphere",
            "surface.radius=2",
            "surface.side=inside",
            "start.normal=[0, 1, -1]",
        ],
        ["surface.kind=sphere", "surface.radius=0.5", "body.shape.hollow=true"],
        ["contact.model=rubber"],
        ["field.gravity=0", "field.potential=k*(I_1*gamma_1**2 + m)/2", "field.parameters.k=3"],
        ["run.precision=quad", "run.tolerance=1e-28"],
        ["run.direction=backward", "run.on_liftoff=warn", "run.time_limit=60"],
        ["start.heading=-1.5"],
    ],
)
def test_allowed_and_written_completely(overrides: list[str]) -> None:
    experiment = rolling(*overrides)
    again = parse_experiment(experiment.toml())
    assert again == experiment
    assert hash(again) == hash(experiment)
    assert again.toml() == experiment.toml()
    assert experiment.overrides == tuple(overrides)
    assert experiment != rolling()


def test_names_that_formulas_may_use() -> None:
    shape = rolling('body.shape={kind="implicit", surface="x**2 - b", parameters={b=2}}').body.shape
    assert isinstance(shape, ImplicitTable)
    assert shape.names == ("x", "y", "z", "b")
    assert RevolutionTable(support="1").names == ("gamma_3",)


def test_places_of_keys_for_later_errors() -> None:
    experiment = rolling("body.mass=2")
    assert experiment.where("body", "shape", "radius") == "body.toml, line 8, body.shape.radius"
    assert experiment.where("body", "mass") == "--set body.mass"


def test_made_in_python() -> None:
    body = BodyTable(mass=1, inertia=(1, 1, 1), shape=BallTable(radius=2))
    start = StartTable(gamma=(0, 0, 1), omega=(1, 0, 0))
    experiment = RollingExperiment(body=body, start=start)
    assert parse_experiment(experiment.text) == experiment
    assert experiment.where("body", "mass") == "<experiment>, body.mass"
    with pytest.raises(ValidationError, match="bowl of radius 1 is too small"):
        RollingExperiment(body=body, start=start, surface=SphereTable(radius=1, side="inside"))
    with pytest.raises(ValidationError, match="frozen"):
        experiment.body.mass = 2


def test_kinds_of_experiment_differ() -> None:
    assert rolling() != system()


# --- what is refused -----------------------------------------------------------------------


def test_sentence_of_the_triangle_inequality() -> None:
    text = ROLLING.replace("[1.0, 1.5, 2.1]", "[\n  1.0, # first\n  1.0, 3.0]")
    assert refused(text) == (
        "body.toml, line 3, body.inertia: principal moments 1, 1, 3 break the triangle "
        "inequality (3 > 1 + 1); each moment must be at most the sum of the other two"
    )


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("mass = 1.0", "", "line 1, body.mass: missing; it must be a positive finite number"),
        ("mass = 1.0", "mass = 0", "line 2, body.mass: must be a positive finite number, not 0"),
        ("mass = 1.0", "mass = -1", "line 2, body.mass: must be a positive finite number, not -1"),
        ("mass = 1.0", "mass = nan", "must be a positive finite number, not nan"),
        ("mass = 1.0", "mass = true", "must be a positive finite number, not true"),
        ("mass = 1.0", 'mass = "1"', 'must be a positive finite number, not the text "1"'),
        ("mass = 1.0", "mass = 1979-05-27", "must be a positive finite number, not 1979-05-27"),
        ("mass = 1.0", "mass = {}", "must be a positive finite number, not a table"),
        ("mass = 1.0", f"mass = 1{'0' * 400}", "not a number too large"),
        ("mass = 1.0", "mas = 1.0", "line 2, body.mas: unknown key, did you mean 'mass'?"),
        ("mass = 1.0", 'mass = 1\n"odd key" = 1', 'line 3, body."odd key": unknown key; allowed'),
        ("1.0, 1.5, 2.1", "1.0, 1.5", "body.inertia: must be 3 principal moments or a symmetric"),
        ("1.0, 1.5, 2.1", "1.0, 1.5, inf", "symmetric 3x3 matrix, not [1.0, 1.5, inf]"),
        ("1.0, 1.5, 2.1", "-1.0, 1.5, 2.1", "moments -1, 1.5, 2.1 must all be positive"),
        ("1.0, 1.5, 2.1", "[1, 2, 0], [2, 1, 0], [0, 0, 1]", "moments -1, 1, 3 must all be pos"),
        ("1.0, 1.5, 2.1", "[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]", "the matrix must be symmetric"),
        ("1.0, 1.5, 2.1", "[1, 0, 0], [0, 1, 0], [0, 0, 3]", "triangle inequality (3 > 1 + 1)"),
        ("1.0, 1.5, 2.1", "[[1]]", "symmetric 3x3 matrix, not [[[...]]]"),
        ("gyrostat = [0.0,", "gyrostat = [", "body.gyrostat: must be 3 finite numbers, not [0.0"),
        ('"ball"', '"bal"', "line 7, body.shape.kind: unknown kind \"bal\", did you mean 'ball'?"),
        ('kind = "ball"', "", "line 6, body.shape.kind: missing; allowed: ball, ellipsoid, disk,"),
        ("radius = 1.0", "", "line 6, body.shape.radius: missing; it must be a positive"),
        ("radius = 1.0", "radius = 1.0\nhollow = 1", "shape.hollow: must be true or false, not 1"),
        ('"plane"', '"bowl"', 'surface.kind: unknown kind "bowl"; allowed: plane, sphere'),
        ('"plane"', '"bowl"', 'unknown kind "bowl"; allowed: plane, sphere'),
        ('"plane"', '"implicit"', "surface.equation: missing; it must be a formula in quotes"),
        ('"plane"', '"plane"\nradius = 1', "line 13, surface.radius: unknown key; allowed: kind"),
        ('"plane"', '"sphere"', "surface.radius: missing; it must be a positive finite number"),
        (
            '"plane"',
            '"sphere"\nradius = -2',
            'surface.radius: must be positive; for the inside write radius = 2.0 and side = "ins',
        ),
        ('"plane"', '"sphere"\nradius = 0', "line 13, surface.radius: must be positive"),
        (
            '"marble"',
            '"ruber"',
            'contact.model: must be "marble", "rubber" or "friction", not the text "ru',
        ),
        ("9.81", "-9.81", "field.gravity: must be a finite number not below zero, not -9.81"),
        ("[0.2, -0.3, 0.93]", "[0, 0.0, -0.0]", "start.gamma: must not be zero"),
        ("[0.2, -0.3, 0.93]", "[1, nan, 0]", "3 finite numbers with at least one not zero, not [1"),
        ("[0.7, 0.4, 1.1]", "[1, 2]", "start.omega: must be 3 finite numbers, not [1, 2]"),
        ("omega = [0.7, 0.4, 1.1]", "", "line 20, start.omega: missing; it must be 3 finite"),
        ("[run]", "normal = [0, 0, 2]\n[run]", "start: normal is for a sphere alone"),
        ("until = 10.0", "until = -1", "run.until: must be a positive finite time, not -1"),
        ("until = 10.0", "until = inf", "run.until: must be a positive finite time, not inf"),
        ("until = 10.0", "until = 0", "run.until: must be a positive finite time, not 0"),
        ("samples = 101", "samples = 1", "run.samples: must be a whole number from 2 to"),
        ("samples = 101", "samples = 101.0", "whole number from 2 to 10000000, not 101.0"),
        ("samples = 101", "samples = 100000000000", "whole number from 2 to 10000000, not 1000"),
        ("1e-15", "1e-31", "run.tolerance: must be a number from 1e-30 to 0.001, not 1e-31"),
        ("1e-15", "0.1", "run.tolerance: must be a number from 1e-30 to 0.001, not 0.1"),
        ("1e-15", "1e-17", 'run.tolerance: 1e-17 needs run.precision = "quad"'),
        (
            "[run]",
            "[rum]",
            "line 24, rum: unknown key, did you mean 'run'? allowed: ",
        ),
        ("[start]", "[starts]", "body.toml, start: missing; it must be a table [start] with gam"),
        ("[start]", "[[start]]", "line 20, start: must be a table [start] with gamma and omega,"),
        ("mass = 1.0", "mass 1.0", "body.toml, line 2: not valid TOML: Expected '=' after a key"),
    ],
)
def test_refused_in_one_sentence(old: str, new: str, message: str) -> None:
    assert ROLLING.count(old) == 1
    said = refused(ROLLING.replace(old, new)).split("\n")
    assert any(message in line for line in said), said
    assert all(line.startswith("body.toml") for line in said)


INSIDE = "surface.side=inside"


@pytest.mark.parametrize(
    ("overrides", "message"),
    [
        (
            ["surface.radius=1", INSIDE],
            "a bowl of radius 1 is too small for this ball, whose radius is 1",
        ),
        (
            ["surface.radius=0.5", INSIDE],
            "body.toml, line 11, surface: a bowl of radius 0.5 is too small",
        ),
        (
            ["surface.radius=4", INSIDE, 'body.shape={kind="ellipsoid", axes=[2, 1, 1]}'],
            "too small for this ellipsoid, whose largest radius of curvature is 4",
        ),
        (
            ["surface.radius=1", INSIDE, 'body.shape={kind="torus", radius=0.8, tube=0.3}'],
            "too small for this torus, whose outer radius is 1.1",
        ),
        (
            ["surface.radius=1", INSIDE, 'body.shape={kind="disk", radius=2}'],
            "this disk, whose radius",
        ),
        (
            ["surface.radius=1", "body.shape.hollow=true"],
            "a hollow ball of radius 1 does not go around a sphere of radius 1; the ball must be",
        ),
        (
            ["surface.radius=9", INSIDE, "body.shape.hollow=true"],
            'a hollow ball rolls around a sphere: its side must be "outside"',
        ),
        (
            ['surface={kind="plane"}', "body.shape.hollow=true"],
            "a hollow ball rolls around a sphere",
        ),
    ],
)
def test_body_that_does_not_fit(overrides: list[str], message: str) -> None:
    assert message in refused(ROLLING, "surface.kind=sphere", *overrides)


def test_ellipsoids_of_any_size_are_measured() -> None:
    shape = EllipsoidTable(axes=(1e300, 1e-300, 1.0))
    body = BodyTable(mass=1, inertia=(1, 1, 1), shape=shape)
    start = StartTable(gamma=(0, 0, 1), omega=(1, 0, 0))
    with pytest.raises(ValidationError, match="largest radius of curvature is inf"):
        RollingExperiment(body=body, start=start, surface=SphereTable(radius=1, side="inside"))


@pytest.mark.parametrize(
    ("overrides", "message"),
    [
        (["body.mass=-1"], "--set body.mass: must be a positive finite number, not -1"),
        (["body.mas=1"], "--set body.mas: unknown key, did you mean 'mass'?"),
        (["bod.mass=1"], "--set bod.mass: unknown key, did you mean 'body'?"),
        (
            ["contact.model=ruber"],
            '--set contact.model: must be "marble", "rubber" or "friction", not the te',
        ),
        (["field.potential=3"], "--set field.potential: must be a formula in quotes, not 3"),
        (
            ["field.potential=gama_1**2"],
            "--set field.potential: unknown name 'gama_1', did you mean 'gamma_1'? allowed: gamma",
        ),
        (["field.potential=k", "field.parameters.k=x"], "--set field.parameters.k: must be a fi"),
        (["field.parameters.gamma_1=1"], "the name 'gamma_1' has a meaning already"),
        (["field.parameters.pi=3"], "the name 'pi' has a meaning already"),
        (["field.parameters.lambda=3"], "'lambda' cannot be used in a formula"),
        (["field.parameters={'a b'=3}"], "'a b' cannot be used in a formula"),
        (["body.shape.parameters.a=1"], "only a shape given by a formula (revolution, implicit)"),
        (['body.shape={kind="revolution"}'], "either support or both chi_1 and chi_2, not neither"),
        (
            ['body.shape={kind="revolution", support="1", chi_1="1", chi_2="1"}'],
            "not support and chi_1 and chi_2",
        ),
        (['body.shape={kind="revolution", chi_2="1"}'], "both chi_1 and chi_2, not chi_2"),
        (['body.shape={kind="revolution", support="x"}'], "unknown name 'x'; allowed: gamma_3"),
        (['body.shape={kind="implicit", surface="1 - b", parameters={b=2}}'], "contain x, y or z"),
        (['body.shape={kind="implicit", surface="x^2"}'], "a power is written **"),
        (
            [
                'body.shape={kind="implicit", surface="x**2 - b", parameters={b=2}}',
                "field.parameters.b=1",
            ],
            "the parameter 'b' is one of body.shape.parameters too",
        ),
        (["body.shape=ball"], "--set body.shape: must be a table with the kind of shape, not the"),
        (["run=fast"], '--set run: must be a table, not the text "fast"'),
    ],
)
def test_refused_overrides(overrides: list[str], message: str) -> None:
    assert message in refused(ROLLING, *overrides)


def test_formula_is_shown_with_a_caret() -> None:
    text = ROLLING.replace("9.81", '9.81\npotential = "gamma_1 + gama_2"')
    first, excerpt, caret = refused(text).split("\n")
    assert first.startswith("body.toml, line 19, field.potential: unknown name 'gama_2'")
    assert excerpt[caret.index("^") :] == "gama_2"


def test_all_mistakes_are_listed_in_the_order_of_the_file() -> None:
    text = ROLLING
    for old, new in [
        ("mass = 1.0", "mass = -1"),
        ("[1.0, 1.5, 2.1]", "[1, 1, 3]"),
        ("[contact]", "[contacts]"),
        ("9.81", '-9.81\npotential = "q"'),
        ("[0.2, -0.3, 0.93]", "[0, 0, 0]"),
        ("samples = 101", "sample = 101"),
    ]:
        text = text.replace(old, new)
    places = [re.sub(":.*", "", line) for line in refused(text).split("\n") if line[0] != " "]
    assert places == [
        "body.toml, line 2, body.mass",
        "body.toml, line 3, body.inertia",
        "body.toml, line 14, contacts",
        "body.toml, line 18, field.gravity",
        "body.toml, line 19, field.potential",
        "body.toml, line 22, start.gamma",
        "body.toml, line 27, run.sample",
    ]


def test_a_body_or_a_system() -> None:
    assert refused("[contact]\nmodel = 1\n").split("\n")[1] == (
        "body.toml, body: missing; it must be a table [body], or [system], [lagrangian] or "
        "[equations] instead of it"
    )
    said = refused(ROLLING, "system.name=veselova")
    assert "body: gyrostat must be absent, as the table [system] decides the body" in said
    for name in ("surface", "contact", "field"):
        assert f"{name}: must be absent, as the table [system] decides the {name}" in said
    assert "system.name: missing; it must be the name of a system" in refused("[system]")
    assert "system.parameters.m: must be a finite number, not the text" in refused(
        SYSTEM, "system.parameters.m=heavy"
    )
    assert "start.gamma: must not be zero" in refused(SYSTEM, "start.gamma=[0, 0, 0]")


# --- files ---------------------------------------------------------------------------------


def test_load_reads_files_and_texts(tmp_path: Path) -> None:
    path = tmp_path / "body.toml"
    path.write_bytes(b"\xef\xbb\xbf" + ROLLING.replace("\n", "\r\n").encode())
    assert (
        load_experiment(path) == load_experiment(str(path)) == load_experiment(ROLLING) == rolling()
    )
    assert load_experiment(path, ["body.mass=2"]) == rolling("body.mass=2")
    path.write_text(ROLLING.replace("mass = 1.0", "mass = -1"), encoding="utf-8")
    with pytest.raises(InputError, match=f"^{re.escape(str(path))}, line 2, body.mass: must be"):
        load_experiment(path)


@pytest.mark.parametrize("path", ["", "  "])
def test_an_empty_path_is_refused(path: str) -> None:
    with pytest.raises(InputError) as error:
        load_experiment(path)
    assert str(error.value) == (
        "the path is empty; it must be that of an experiment file, or its text"
    )


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    latin = tmp_path / "latin.toml"
    latin.write_bytes("[body]\n# Kreisel für\n".encode("latin-1"))
    for path, message in [
        (tmp_path / "none.toml", "none.toml: there is no such file"),
        (tmp_path, "this is a directory, not an experiment file"),
        (latin, "latin.toml: byte 19 is not UTF-8 text"),
        (latin / "inner.toml", "the file cannot be read: Not a directory"),
        (Path("nul\0.toml"), "the file cannot be read: embedded null byte"),
    ]:
        with pytest.raises(InputError) as caught:
            load_experiment(path)
        assert message in str(caught.value)
        assert "\n" not in str(caught.value)
