"""A new shape, a new surface and a new law of friction, each in one file, go everywhere."""

from __future__ import annotations

import json
import math
from base64 import b64decode
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import chaplygin as ch
import nonholonomic
from chaplygin.experiment.file.contact_tables import LAWS
from chaplygin.experiment.models.schema import experiment_schema
from chaplygin.page.page_model import page_model
from chaplygin.report.study_output import write_study
from chaplygin.report.subject_figures import subject_figures
from nonholonomic.contact.equations.structure import SharedEquations
from nonholonomic.contact.invariants.dissipation import decrease_of_energy, dissipation
from nonholonomic.mechanics import ball as balls
from nonholonomic.mechanics.shapes.rays import directions
from planted_kinds.die import Die
from planted_kinds.drag import Drag
from planted_kinds.gutter import Gutter
from planted_kinds.wave import Wave

DIE = """
title = "A die"
[body]
mass = 1.0
inertia = [0.4, 0.5, 0.6]
shape = {kind = "die", radius = 1.0, corners = -0.03, centre = [0.0, 0.0, 0.05]}
[field]
gravity = 9.81
[start]
gamma = [0.0, 0.6, 0.8]
omega = [1.0, -0.5, 0.3]
[run]
until = 1.0
samples = 21
"""

GUTTER = """
[body]
mass = 1.0
inertia = [0.1, 0.1, 0.1]
shape = {kind = "ball", radius = 0.5}
[surface]
kind = "gutter"
radius = 2.0
[field]
gravity = 9.81
[start]
gamma = [0.0, 0.6, 0.8]
omega = [1.0, 2.0, 0.5]
normal = [0.0, 0.6, 0.8]
[run]
until = 1.0
samples = 21
"""

DRAG = """
[body]
mass = 1.0
inertia = [0.4, 0.4, 0.4]
shape = {kind = "ball", radius = 1.0}
[contact]
model = "friction"
[contact.laws.drag]
drag = 0.5
[field]
gravity = 9.81
[start]
gamma = [0.0, 0.0, 1.0]
omega = [0.0, 0.0, 0.0]
slip = [2.0, 0.0, 0.0]
[run]
until = 2.0
samples = 21
"""


def report_of(text: str, folder: Path) -> tuple[str, Mapping[str, object]]:
    """The page of a study, and the model of its interactive page."""
    study = ch.Study.from_experiment(ch.parse_experiment(text))
    _, failure = write_study(study, folder, force=True, total_budget=0)
    assert failure is None
    model = page_model(study, study.trajectory().to_dataset())
    json.dumps(model, allow_nan=False)
    return (folder / "report.html").read_text(encoding="utf-8"), model


# --- a shape -------------------------------------------------------------------------------


def test_contact_points_of_a_die_are_the_gradient_of_its_support_function() -> None:
    """Independent of its Gauss map: differences of h(x) = |x| (R + ε Σ(x/|x|)⁴)."""
    die, normals, step = Die(1.0, -0.03), directions(50), 1e-6

    def support(x: np.ndarray) -> np.ndarray:
        size = np.linalg.norm(x, axis=1)
        return size * (1.0 - 0.03 * ((x / size[:, None]) ** 4).sum(axis=1))

    shifts = step * np.eye(3)
    gradient = np.stack(
        [(support(normals + s) - support(normals - s)) / (2 * step) for s in shifts], axis=1
    )
    np.testing.assert_allclose(die.contact_points()(-normals), gradient, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("surface", "contact"),
    [(ch.Plane(), "marble"), (ch.Plane(), "rubber"), (ch.Sphere(5.0, side="inside"), "rubber")],
)
def test_the_energy_of_a_die_is_proven(surface: ch.Plane, contact: str) -> None:
    body = ch.Body(1.0, (0.4, 0.5, 0.6), Die(1.0, -0.03, centre=(0.0, 0.0, 0.05)))
    field = ch.Forces(gravity=9.81 if surface == ch.Plane() else 0.0)
    system = ch.rolling_system(body, surface, contact, field)
    assert ch.prove(system, "energy").decision == "proven"


def test_a_die_in_a_file_rolls_and_is_drawn(tmp_path: Path) -> None:
    experiment = ch.parse_experiment(DIE)
    assert ch.parse_experiment(experiment.toml()) == experiment
    study = ch.Study.from_experiment(experiment)
    assert "Die on a horizontal plane" in study.subject.setting
    energy = study.trajectory().to_dataset()["law_energy"]
    assert np.ptp(energy.values) <= 1e-12 * abs(energy.values[0])
    page, model = report_of(DIE, tmp_path / "die")
    assert page.count('<figure class="scene">') == 1
    assert model["scene"]["body"] is not None  # type: ignore[index]


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("radius = 1.0", "radius = -1.0", "body.shape.radius: radius -1.0 of the die"),
        ("radius = 1.0", 'radius = "x"', "body.shape.radius: must be a finite number"),
        ("radius = 1.0", "radus = 1.0", "body.shape.radus: unknown key, did you mean .radius"),
        ('kind = "die"', 'kind = "dye"', "body.shape.kind: unknown kind .dye"),
    ],
)
def test_mistakes_in_the_table_of_a_die_have_their_place(old: str, new: str, sentence: str) -> None:
    with pytest.raises(ch.InputError, match=sentence):
        ch.Study.from_experiment(ch.parse_experiment(DIE.replace(old, new)))


def test_a_die_slides_on_a_plane() -> None:
    body = ch.Body(1.0, (0.4, 0.4, 0.4), Die(1.0, -0.02))
    contact = nonholonomic.contact.FrictionalContact(
        body, laws=(nonholonomic.contact.Coulomb(0.3),), field=ch.Forces(gravity=9.81)
    )
    start = ch.initial_state(contact, (0, 0.5, 1), (0, 0.6, 0.8), slip=(0.5, 0, 0))
    motion = nonholonomic.contact.contact_motion(contact, start, np.linspace(0.0, 0.3, 7))
    values = motion.observables
    balance = values["energy"] + motion.states[:, 16:].sum(axis=1)
    assert np.ptp(balance) <= 1e-10 * values["energy"][0]
    # its centre is not as high as that of a ball, and rises and falls
    assert np.ptp(motion.states[:, 6]) > 1e-5 and motion.states[0, 6] < 0.99


# --- a surface -----------------------------------------------------------------------------


def test_a_ball_in_a_gutter_moves_as_the_equations_of_homogeneous_balls_say() -> None:
    """The reference is derived apart, by the surface on which the centre moves."""
    study = ch.Study.from_experiment(ch.parse_experiment(GUTTER))
    data = study.trajectory().to_dataset()
    surface = balls.CircularCylinder(2.0, side="inside", axis="x")
    ball = balls.RollingBall(mass=1.0, inertia=0.1, radius=0.5, surface=surface, gravity=9.81)
    system = ball.system()
    # γ and the normal agree at the start, so that body and space axes do
    start = ch.initial_state(ball, (1.0, 2.0, 0.5), place=data["contact"].values[0])
    known = ch.integrate(system, start, data["time"].values).to_dataset()
    for name in ("contact", "centre"):
        np.testing.assert_allclose(data[name].values, known[name].values, rtol=0, atol=1e-11)
    energy = data["law_energy"].values
    assert np.ptp(energy) <= 1e-12 * abs(energy[0])
    assert np.ptp(data["contact"].values[:, 0]) > 0.5


def test_the_energy_in_a_gutter_is_proven() -> None:
    body = ch.Body(1.0, (0.1, 0.1, 0.1), ch.Ball(0.5))
    assert ch.prove(ch.rolling_system(body, Gutter(2.0)), "energy").decision == "proven"


def test_a_die_in_a_gutter_keeps_its_energy() -> None:
    """Both are new, and neither knows of the other."""
    body = ch.Body(1.0, (0.1, 0.12, 0.15), Die(0.5, -0.01))
    system = ch.rolling_system(body, Gutter(2.0), "rubber", ch.Forces(gravity=9.81))
    start = ch.initial_state(
        system, (1.0, 0.8, -0.6), (0.0, 0.6, 0.8), normal=(0.0, 0.6, 0.8), heading=0.3
    )
    motion = ch.integrate(system, start, np.linspace(0.0, 1.0, 11))
    energy = motion.to_dataset()["law_energy"].values
    assert np.ptp(energy) <= 1e-12 * abs(energy[0])


def test_a_gutter_in_a_file_is_written_and_drawn() -> None:
    experiment = ch.parse_experiment(GUTTER)
    assert ch.parse_experiment(experiment.toml()) == experiment
    assert (
        "on the inside of a horizontal cylinder"
        in ch.Study.from_experiment(experiment).subject.setting
    )
    study = ch.Study.from_experiment(experiment)
    dataset = study.trajectory().to_dataset()
    assert "scene" in subject_figures(study.subject, dataset, None)
    scene = page_model(study, dataset)["scene"]
    assert scene["support"]["kind"] == "mesh"
    # its corners lie on the cylinder
    corners = np.frombuffer(b64decode(scene["support"]["positions"]), "<f4").reshape(-1, 3)
    np.testing.assert_allclose(np.hypot(corners[:, 1], corners[:, 2]), 2.0, rtol=1e-3)


@pytest.mark.slow
def test_the_page_of_a_ball_in_a_gutter(tmp_path: Path) -> None:
    page, _ = report_of(GUTTER.replace("gravity = 9.81", "gravity = 0.0"), tmp_path / "gutter")
    assert page.count('<figure class="scene">') == 1


def test_what_a_gutter_does_not_have_is_refused() -> None:
    with pytest.raises(ch.InputError, match=r"start: normal has no part along x in a gutter"):
        ch.parse_experiment(GUTTER.replace("normal = [0.0,", "normal = [0.1,"))
    body = ch.Body(1.0, (0.1, 0.1, 0.1), ch.Ball(0.5))
    with pytest.raises(ch.InputError, match=r"surface: a body touches a plane or a sphere"):
        nonholonomic.contact.FrictionalContact(body, Gutter(2.0))
    with pytest.raises(ch.InputError, match=r"invariant measures are known of bodies on planes"):
        ch.invariant_measure(ch.RollingBody(body, Gutter(2.0)))


WAVE = """
[body]
mass = 1.0
inertia = [0.1, 0.1, 0.1]
shape = {kind = "ball", radius = 0.5}
[surface]
kind = "wave"
height = 0.05
given = "centre"
[start]
centre = [0.0, 0.0, 0.05]
omega = [0.0, 1.0, 0.5]
[run]
until = 1.0
samples = 5
"""


def test_a_ball_rolls_over_a_new_surface() -> None:
    assert Wave.kind == "wave"
    experiment = ch.parse_experiment(WAVE)
    assert ch.parse_experiment(experiment.toml()) == experiment
    study = ch.Study.from_experiment(experiment)
    data = study.trajectory().to_dataset()
    centre, energy = data["centre"].values, data["law_energy"].values
    np.testing.assert_allclose(centre[:, 2], 0.05 * np.cos(centre[:, 0]), rtol=0, atol=1e-12)
    assert np.ptp(centre[:, 0]) > 0.1 and np.ptp(energy) <= 1e-12 * abs(energy[0])
    assert "scene" in subject_figures(study.subject, data, None)


# --- a law of friction ---------------------------------------------------------------------


def test_drag_slows_a_ball_as_its_equation_says() -> None:
    """u̇ = −(c/m)(1 + mR²/I) u² has the solution u₀/(1 + b u₀ t)."""
    motion = ch.Study.from_experiment(ch.parse_experiment(DRAG)).trajectory().to_dataset()
    b = 0.5 * (1 + 1 / 0.4)
    slip = np.linalg.norm(motion["slip"].values, axis=1)
    np.testing.assert_allclose(slip, 2 / (1 + 2 * b * motion["time"].values), rtol=1e-12)
    balance = motion["energy"].values + motion["work_drag"].values
    assert np.ptp(balance) <= 1e-12 * balance[0]


def test_the_power_of_drag_is_proven() -> None:
    assert ch.prove(*decrease_of_energy(Drag(0.5))).decision == "proven"
    assert str(dissipation(Drag(0.5)).power) == "c_q*slip_speed**3"


def test_drag_in_a_file_is_written_and_told(tmp_path: Path) -> None:
    experiment = ch.parse_experiment(DRAG)
    assert ch.parse_experiment(experiment.toml()) == experiment
    page, _ = report_of(DRAG, tmp_path / "drag")
    assert "times the square of the slip" in page and "coefficient of drag" in page


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("drag = 0.5", "drag = -0.5", "contact.laws.drag.drag: drag -0.5: it must be a finite"),
        ("drag = 0.5", "dreg = 0.5", "contact.laws.drag.dreg: unknown key, did you mean .drag"),
        ("laws.drag]", "laws.drug]", "contact.laws.drug: unknown key, did you mean .drag"),
    ],
)
def test_mistakes_in_a_law_have_their_place(old: str, new: str, sentence: str) -> None:
    with pytest.raises(ch.InputError, match=sentence):
        ch.Study.from_experiment(ch.parse_experiment(DRAG.replace(old, new)))


def test_contacts_with_a_new_law_share_their_equations() -> None:
    body = ch.Body(1.0, (0.4, 0.4, 0.4), ch.Ball(1.0))
    one, other, none = (
        SharedEquations(nonholonomic.contact.FrictionalContact(body, laws=laws))
        for laws in ((Drag(0.5),), (Drag(0.2),), (nonholonomic.contact.Viscous(0.5),))
    )
    assert one == other and one != none


# --- all of them ---------------------------------------------------------------------------


def test_the_schema_has_the_new_tables() -> None:
    tables = experiment_schema()["$defs"]
    assert {"DieTable", "GutterTable", "DragTable"} <= tables.keys()
    number_or_formula = tables["DieTable"]["properties"]["corners"]["anyOf"]
    assert [choice["type"] for choice in number_or_formula] == ["number", "string"]


def test_every_law_of_the_package_has_its_keys() -> None:
    """What [contact.laws] offers are the laws of other modules alone."""
    ch.parse_experiment(DRAG)
    assert set(LAWS.table().model_fields) == {"drag"}


def test_a_word_that_is_taken_is_refused() -> None:
    with pytest.raises(ch.InputError, match=r"kind 'die' of .*Other: planted_kinds.die.Die has it"):

        class Other(Die):
            kind = "die"


def test_a_field_that_no_file_can_give_is_refused() -> None:
    from dataclasses import dataclass

    from nonholonomic.system_files.body_tables import ShapeTable
    from nonholonomic.system_files.open_kinds import table_of

    @dataclass(frozen=True)
    class Formula(Die):
        profile: sp.Expr = sp.S.Zero

    with pytest.raises(ch.InputError, match=r"Formula.profile: a file can give numbers, texts"):
        table_of(Formula, ShapeTable)


def test_a_module_of_an_entry_point_is_imported_when_its_kind_is_named(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from nonholonomic.system_files import open_kinds

    loaded = []

    class Point:
        name, value = "lens", "lens:Lens"

        def load(self) -> None:
            loaded.append(self.name)
            raise ImportError("no module named lens")

    monkeypatch.setattr(open_kinds, "entry_points", lambda group: [Point()])
    open_kinds.import_entry_points.cache_clear()
    ch.parse_experiment(DIE)
    assert not loaded
    with pytest.raises(ch.InputError, match=r"the plug-in lens = lens:Lens of nonholonomic.kinds"):
        ch.parse_experiment(DIE.replace('"die"', '"lens"'))
    open_kinds.import_entry_points.cache_clear()


def test_half_the_breadth_of_a_die_is_where_its_corners_are() -> None:
    assert math.isclose(Die(1.0, -0.03).half_breadth, 1.0 - 0.03 / 3, rel_tol=1e-3)
