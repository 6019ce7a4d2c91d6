"""Sections of motions with friction."""

from __future__ import annotations

import math

import numpy as np
import pytest

import chaplygin as ch
from chaplygin.experiment.friction_studies.section import contact_section_task
from chaplygin.experiment.poincare import SectionSurface
from chaplygin.experiment.study import Study
from chaplygin.experiment.subjects.contact_subject import ContactSubject
from experiment.friction_studies.test_ensembles import BILLIARD, sticking
from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.flow.ensembles.members import from_lists, grid
from nonholonomic.contact import contact_motion


@pytest.fixture(scope="module")
def billiard() -> Study:
    return ch.Study.from_experiment(ch.parse_experiment(BILLIARD))


def test_points_while_a_ball_slides_and_while_it_rolls(billiard: Study) -> None:
    """The centre passes 0.2 m on a parabola, and 1 m at the speed of rolling."""
    mu, speed = 0.2, 1.4
    rolls = sticking(speed, mu)
    way = speed * rolls - mu * 9.81 * rolls**2 / 2
    for distance, expected in (
        (0.2, (speed - math.sqrt(speed**2 - 2 * mu * 9.81 * 0.2)) / (mu * 9.81)),
        (0.8, rolls + (0.8 - way) / (speed * 5 / 7)),
    ):
        place = SectionSurface("position_1", distance)
        task, names = contact_section_task(billiard, place, 1, t_end=2.0)
        data = compute(task)
        assert names == ("gamma_1", "gamma_2")
        assert float(data.time[0, 0]) == pytest.approx(expected, rel=1e-12)
        meanings = data.mode.attrs["flag_meanings"].split()
        assert meanings[int(data.mode[0, 0])] == ("sliding" if distance < way else "rolling")
        assert int(data.outcome[0]) == 0


def test_the_rolling_ball_turns_evenly(billiard: Study) -> None:
    """γ₃ falls through zero once in every turn: the times are equidistant."""
    task, _ = contact_section_task(
        billiard, SectionSurface("gamma_3", 0.0, "falling"), 5, t_end=5.0
    )
    data = compute(task)
    late = data.time.values[0, 1:]
    np.testing.assert_allclose(np.diff(late), 2 * math.pi * 0.05, rtol=1e-11)
    np.testing.assert_allclose(data.gamma[0, :, 2], 0.0, atol=1e-13)
    both, _ = contact_section_task(billiard, SectionSurface("gamma_3", 0.0, "both"), 9, t_end=5.0)
    np.testing.assert_allclose(compute(both).time.values[0, ::2][:4], data.time.values[0, :4])


@pytest.mark.slow
def test_points_lie_on_the_motion() -> None:
    """Each point is the state that the motion has at its time, through all events."""
    study = ch.Study.from_experiment(ch.load_experiment("examples/dry_rattleback.toml"))
    place = SectionSurface("omega_1", 0.0, "both")
    task, _ = contact_section_task(study, place, 40, t_end=1.5, tolerance=1e-16)
    data = compute(task)
    count = int(data.points[0])
    assert count > 10
    times = data.time.values[0, :count]
    assert np.all(np.diff(times) > 0)
    subject = study.subject
    assert isinstance(subject, ContactSubject)
    start = [float(x) for x in study.start]
    motion = contact_motion(subject.contact, start, [0.0, *times])
    np.testing.assert_allclose(motion.states[1:, 10:13], data.omega[0, :count], atol=2e-12)
    # none is missed, and none counted twice
    moments = np.linspace(0.0, times[-1] + 1e-6, 20001)
    signs = np.sign(contact_motion(subject.contact, start, moments).states[:, 10])
    assert np.count_nonzero(signs[1:] * signs[:-1] < 0) == count


def test_members_slabs_and_formulas(billiard: Study) -> None:
    place = SectionSurface("position_1", 0.2, within=(("mode_of_nothing", 1.0),))
    with pytest.raises(InputError, match="unknown name 'mode_of_nothing'"):
        contact_section_task(billiard, place, 1, t_end=1.0)
    place = SectionSurface("2*position_1", 0.4, within=(("omega_2 - 10", 5.0),))
    task, names = contact_section_task(
        billiard, place, 1, grid(mu=[0.2, 0.3]), "w=omega_2/2, slip_1", t_end=1.0
    )
    data = compute(task)
    assert names == ("w", "slip_1")
    assert data.sizes == {"run": 2, "section_point": 1, "quaternion": 4, "axis": 3} | {
        key: size for key, size in data.sizes.items() if key.endswith("_component")
    }
    np.testing.assert_allclose(data["w"], data.omega[:, :, 1] / 2)
    none = contact_section_task(
        billiard, SectionSurface("position_1", 0.2, within=(("omega_2", 1e-3),)), 1, t_end=1.0
    )[0]
    empty = compute(none)
    assert int(empty.points[0]) == 0
    reasons = dict(zip(empty.outcome.flag_values, empty.outcome.reasons, strict=True))
    assert reasons[int(empty.outcome[0])] == "the time limit"


def test_mistakes_in_sections(billiard: Study) -> None:
    for place, more, sentence in (
        (SectionSurface("gama_3"), {}, "unknown name 'gama_3', did you mean 'gamma_3'"),
        (SectionSurface("gamma_3", 0.0, "up"), {}, "must be one of rising, falling, both"),
        (SectionSurface("gamma_3"), {"t_end": 0.0}, "must be positive and finite"),
        (SectionSurface("gamma_3"), {"coordinates": "gamma_1"}, "two or three are needed"),
        (SectionSurface("gamma_3"), {"coordinates": "gamma_1, 2*gamma_2"}, "needs a name"),
    ):
        with pytest.raises(InputError, match=sentence):
            contact_section_task(billiard, place, 1, **{"t_end": 1.0, **more})  # type: ignore[arg-type]
    with pytest.raises(InputError, match="0 points: there must be one at least"):
        contact_section_task(billiard, SectionSurface("gamma_3"), 0, t_end=1.0)


def test_a_section_of_a_member_with_fewer_laws() -> None:
    study = ch.Study.from_experiment(
        ch.parse_experiment(BILLIARD.replace("mu = 0.2", "mu = 0.2\nviscous = 0.1"))
    )
    task, _ = contact_section_task(
        study,
        SectionSurface("slip_1", 0.7, direction="falling"),
        1,
        from_lists(mu=[0.2, 0.0]),
        "lost = work_viscous + work_coulomb, omega_2",
        t_end=30.0,
    )
    data = compute(task)
    assert data["points"].values.tolist() == [1, 1]
    assert not data["work_coulomb"].values[1].any()
    assert data["work_viscous"].values[1, 0] > data["work_viscous"].values[0, 0] > 0
    both = data["work_coulomb"].values + data["work_viscous"].values
    np.testing.assert_allclose(data["lost"].values, both, rtol=1e-14)


@pytest.mark.parametrize("text", ["1", "2*pi"])
def test_a_section_on_a_constant(billiard: Study, text: str) -> None:
    with pytest.raises(InputError, match="it is the same at all times"):
        contact_section_task(billiard, SectionSurface(text, 0.0), 1, t_end=1.0)
