"""Films: as many frames as there are instants, of the size asked for, and of what moves."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
import pytest

from chaplygin.experiment.models.experiment import load_experiment, parse_experiment
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.experiment.subjects.plan import plan_motion
from chaplygin.report.film.encode import write_film
from chaplygin.report.film.encoders import require_encoder
from chaplygin.report.film.frames import Picture, frames
from flowlanes.errors import InputError
from needs import optional

EXAMPLES = Path(__file__).parents[5] / "examples"
SIZE = (320, 180)


def drawn(study: Study, every: int = 4) -> tuple[int, list[Picture]]:
    trajectory = study.trajectory()
    plan = None if study.subject.plan is None else plan_motion(study.subject.plan, trajectory)
    count, pictures = frames(study.subject, dataset_of(study, trajectory), plan, every, SIZE)
    return count, list(pictures)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["coin", "sleigh", "ball_in_a_bowl", "ball_on_waves", "tippe_top"])
def test_frames_show_a_motion(name: str) -> None:
    study = Study.from_experiment(
        load_experiment(EXAMPLES / f"{name}.toml", ["run.until=1", "run.samples=13"])
    )
    count, pictures = drawn(study)
    assert count == len(pictures) == 4
    for before, after in itertools.pairwise(pictures):
        assert before.shape == (SIZE[1], SIZE[0], 3)
        assert np.mean(np.any(before != after, axis=2)) > 0.002


@pytest.mark.slow
def test_what_stays_in_sight_is_never_cut_off() -> None:
    study = Study.from_experiment(
        load_experiment(EXAMPLES / "rattleback.toml", ["run.until=2", "run.samples=9"])
    )
    for picture in drawn(study)[1]:
        # the paper is white at the border
        for edge in (picture[0], picture[:, 0], picture[:, -1]):
            assert edge.min() > 200


def test_a_system_without_a_body_has_no_film() -> None:
    study = Study.from_experiment(
        parse_experiment('system = {name = "veselova"}\nrun = {until = 1.0, samples = 3}')
    )
    with pytest.raises(InputError, match="no body"):
        drawn(study)


def squares(count: int) -> list[Picture]:
    """Frames with a square that moves to the right."""
    made = []
    for number in range(count):
        frame = np.full((SIZE[1], SIZE[0], 3), 255, np.uint8)
        frame[60:120, 20 * number : 20 * number + 60] = (20, 60, 120)
        made.append(frame)
    return made


@pytest.mark.parametrize("ending", [".mp4", ".webm"])
def test_a_film_is_read_back(tmp_path: Path, ending: str) -> None:
    av = optional("av")
    require_encoder(ending)
    made, path = squares(10), tmp_path / f"film{ending}"
    write_film(made, path, 10, SIZE)
    with av.open(str(path)) as film:
        stream = film.streams.video[0]
        assert stream.average_rate == 10
        back = [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]
    assert len(back) == 10
    for frame, original in zip(back, made, strict=True):
        assert np.mean(np.abs(frame.astype(int) - original.astype(int))) < 6.0
    assert list(tmp_path.iterdir()) == [path]


def test_a_gif_is_read_back(tmp_path: Path) -> None:
    from PIL import Image

    made, path = squares(6), tmp_path / "film.gif"
    write_film(made, path, 10, SIZE)
    with Image.open(path) as film:
        assert film.n_frames == 6  # type: ignore[attr-defined]
        assert film.info["duration"] == 100
        for number, original in enumerate(made):
            film.seek(number)
            frame = np.asarray(film.convert("RGB")).astype(int)
            assert np.mean(np.abs(frame - original)) < 4.0


def test_a_film_that_fails_leaves_nothing(tmp_path: Path) -> None:
    def broken() -> object:
        yield from squares(2)
        raise InputError("stopped")

    with pytest.raises(InputError, match="stopped"):
        write_film(broken(), tmp_path / "film.gif", 10, SIZE)  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == []
