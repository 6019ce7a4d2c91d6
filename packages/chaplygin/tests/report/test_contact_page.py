"""The page of a motion with friction: its laws, its events, what became of the energy."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from chaplygin.report import page as report_page
from chaplygin.report.contact_section import law_row
from chaplygin.report.drawing.contact_values import FrictionLimits, friction_limits
from chaplygin.report.drawing.files import PAGE_COLOURS
from chaplygin.report.drawing.modes import MODE_STYLES
from chaplygin.report.figures.contact_time import LOSSES
from chaplygin.report.study_output import write_study
from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from nonholonomic.contact.friction.friction_law import FrictionLaw
from nonholonomic.contact.friction.rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
)
from nonholonomic.contact.friction.user_friction import UserFriction
from nonholonomic.contact.friction.viscous_friction import NormalViscous, PowerFriction, Viscous

LAWS: list[FrictionLaw] = [
    Coulomb(0.3),
    ContensouErismann(0.3, 5e-4),
    SpinFriction(1e-4),
    Viscous(0.5, 0.1),
    NormalViscous(0.4),
    RollingResistance(2e-3),
    ViscousRolling(1e-3),
    ContourResistance(0.01),
    PowerFriction(0.3, 0.5),
    UserFriction(
        "mu*(1 + 0.3*exp(-slip_speed/v))", mu_static=0.3, parameters={"mu": 0.2, "v": 0.1}
    ),
]

BOUNCING = """
title = "A ball that bounces"
[body]
mass = 0.2
inertia = [2e-4, 2e-4, 2e-4]
shape = { kind = "ball", radius = 0.05 }
[contact]
model = "friction"
mu = 0.25
restitution = 0.5
[field]
gravity = 9.81
[start]
position = [0, 0, 0.25]
attitude = [1, 0, 0, 0]
velocity = [0.5, 0, 0]
omega = [0, 0, 0]
[run]
until = 0.3
samples = 61
"""


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_every_law_is_told_in_words(law: FrictionLaw) -> None:
    row = law_row(law)
    assert row.words.endswith(".") and row.words != law.description
    assert law.name in LOSSES
    assert len(row.coefficients.split("; ")) == len(law.parameters)
    assert not re.search(r"\d[eE][+-]?\d", row.coefficients)


def test_dry_friction_without_limit() -> None:
    assert "never slips" in law_row(Coulomb(math.inf)).words


@pytest.mark.parametrize(
    ("laws", "limits"),
    [
        ((Coulomb(0.3),), FrictionLimits(0.3)),
        ((Coulomb(0.3), SpinFriction(0.01)), FrictionLimits(0.3, 0.01)),
        ((ContensouErismann(0.3, 0.02),), FrictionLimits(0.3, 0.02, coupled=True)),
        ((Coulomb(math.inf),), FrictionLimits()),
        ((Viscous(1.0),), FrictionLimits()),
        ((Coulomb(0.3), Viscous(1.0)), FrictionLimits(0.3)),
        ((UserFriction("0.2", couple="0.01", mu_static=0.3),), FrictionLimits(0.3, 0.01)),
    ],
)
def test_what_dry_friction_can_hold(laws: tuple[FrictionLaw, ...], limits: FrictionLimits) -> None:
    import chaplygin as ch
    from nonholonomic.contact import FrictionalContact

    ball = ch.Body(1.0, (0.4, 0.4, 0.4), ch.Ball(1.0))
    assert friction_limits(FrictionalContact(ball, laws=laws)) == limits


def test_every_mode_has_a_colour_for_the_night() -> None:
    """Sliding without rolling was dark red on a dark page."""
    template = (Path(report_page.__file__).parent / "templates" / "report.html").read_text("utf-8")
    night = template[template.index("prefers-color-scheme: dark") : template.index(".picture {")]
    for mode, style in MODE_STYLES.items():
        name = next(name for name, colour in PAGE_COLOURS.items() if colour == style.colour)
        assert mode == "rest" or f"--{name}: #" in night


@pytest.mark.slow
def test_the_page_of_a_bouncing_ball(tmp_path: Path) -> None:
    (tmp_path / "figures").mkdir()
    trajectory, failure = write_study(
        Study.from_experiment(parse_experiment(BOUNCING, "x", [])),
        tmp_path,
        force=True,
        total_budget=0,
    )
    assert failure is None
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    links = re.findall(r'<li><a href="#([\w-]+)">', page)
    assert set(links) <= set(re.findall(r'<h2 id="([\w-]+)"', page))
    assert "place" not in links and "friction" in links
    for name in ("slip_and_spin", "slip_hodograph", "friction_cone", "energy_stack", "drift"):
        assert page.count(f'<figure id="{name}">') == 1
    # it falls 0.2 m and rises to a quarter of it
    (table,) = re.findall(r'<table class="events">.*?</table>', page, re.S)
    (first, *_) = re.findall(r'<td class="number">([\d.]+)</td><td>(.*?)</td>', table)
    assert float(first[0]) == pytest.approx(math.sqrt(0.4 / 9.81), abs=2e-9)
    assert first[1] == "landing"
    # the normal impulse is m (1 + e) times the speed of landing, the other at most μ times that
    impulses = re.findall(r'<td class="number">([\d.]+)</td>', table)[1:3]
    normal = 0.2 * 1.5 * math.sqrt(2 * 9.81 * 0.2)
    assert float(impulses[0]) == pytest.approx(normal, rel=1e-4)
    assert float(impulses[1]) <= 0.25 * normal * (1 + 1e-4)
    assert "gives back 0.25 of the work" in page
    words = re.sub(r"<style.*?</style>|<svg.*?</svg>|<pre>.*?</pre>", "", page, flags=re.S)
    (energy,) = re.findall(r'<table id="energy" class="short">.*?</table>', words, re.S)
    rows = [re.findall(r"<td.*?>(.*?)</td>", row) for row in energy.split("<tr>")[2:]]
    assert [row[0] for row in rows][-1] == "together"
    assert float(rows[-1][1]) == pytest.approx(float(rows[-1][2]), rel=1e-5)
    assert len(trajectory.times) == 61


@pytest.mark.slow
def test_a_path_in_the_colours_of_modes_follows_those_of_the_page(tmp_path: Path) -> None:
    """It was a white card at night."""
    (tmp_path / "figures").mkdir()
    study = Study.from_experiment(
        parse_experiment(BOUNCING, "x", ["contact.restitution=0", "run.until=0.4"])
    )
    write_study(study, tmp_path, force=True, total_budget=0)
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert re.search(r'<figure id="contact_path">\s*<h4>[^<]*</h4>\s*<div class="chart ', page)
    assert re.search(r'<figure id="normal_on_sphere">\s*<h4>.*?</h4>\s*<div class="picture ', page)
