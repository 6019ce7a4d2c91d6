"""``chaplygin animate``: a motion as a film, or as an animated 3D model."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ..interruption import NOTHING_SAVED, message_on_interrupt
from .terminal.options import inform, study_of
from .terminal.output_destination import STANDARD_OUTPUT, check_output
from .terminal.progress import progress

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..experiment.study import Study
    from ..report.film.frames import Picture
    from ..report.study_output import StudyProgress

#: Minimum number of samples of a motion through which paths are drawn.
SMOOTH = 2000

SUFFIXES = (".mp4", ".webm", ".gif", ".glb")

#: Maximum number of frames of a film.
MOST_FRAMES = 20_000


def command(
    what: str,
    output: Path,
    rate: int = 25,
    speed: float = 1.0,
    width: int = 1280,
    height: int = 720,
    overrides: list[str] | None = None,
    force: bool = False,
) -> None:
    r"""Write the motion as a film, or as a model in space that moves (.glb); needs no browser.

    .mp4 (H.264) and .webm (VP9) need the extra: pip install 'chaplygin\[film]'.
    """
    from flowlanes.errors import InputError

    suffix = output.suffix.lower()
    if output == STANDARD_OUTPUT or suffix not in SUFFIXES:
        raise InputError(f"--output {output}: its name must end in {', '.join(SUFFIXES)}")
    if not 0 < speed < float("inf"):
        raise InputError(f"--speed {speed:g}: it must be a positive number")
    check_output("--output", output, force, False, what)
    if suffix != ".glb":
        from ..report.film.encoders import require_encoder

        require_encoder(suffix)
    study = study_of(what, overrides)
    count = abs(study.until) / speed * rate
    if count > MOST_FRAMES:
        raise InputError(
            f"the film would have {count:.6g} frames, and at most {MOST_FRAMES:,} are drawn: a "
            "shorter motion (--set run.until=…), a larger --speed or a smaller --rate has fewer"
        )
    if count < 1:
        raise InputError(
            f"--speed {speed:g}: the motion of {abs(study.until):g} s would be over before the "
            f"second frame; it must be at most {abs(study.until) * rate:g}"
        )
    _require_something_to_show(study, suffix)
    steps = round(count)
    with (
        message_on_interrupt(NOTHING_SAVED),
        progress(f"integrating: {study.system.title}") as report,
    ):
        if suffix == ".glb":
            _model(study, steps, output)
        else:
            # An encoder halves the colour resolution.
            size = (width - width % 2, height - height % 2)
            _film(study, steps, output, rate, size, report)
    inform(f"written to {output}")


def _require_something_to_show(study: Study, suffix: str) -> None:
    """Raise an error for a motion without body and drawing, before the integration."""
    from flowlanes.errors import InputError

    from ..report.film.frames import require_scene

    subject = study.subject
    if suffix != ".glb":
        require_scene(subject)
    elif subject.outline is None and subject.plan is None:
        raise InputError(
            f"{study.system.title} has no body that could be a model in space, and no drawing of a "
            "mechanism (the table [plan])"
        )


def _with_frames(study: Study, steps: int) -> Study:
    """Study with one sample per frame."""
    from dataclasses import replace

    run = study.experiment.run.model_copy(update={"samples": steps + 1})
    return replace(study, experiment=study.experiment.model_copy(update={"run": run}))


def _film(
    study: Study, steps: int, output: Path, rate: int, size: tuple[int, int], report: StudyProgress
) -> None:
    from ..experiment.study import dataset_of
    from ..experiment.subjects.plan import plan_motion
    from ..report.film.encode import write_film
    from ..report.film.frames import frames

    pieces = -(-SMOOTH // steps)
    trajectory = _with_frames(study, steps).trajectory(report, pieces)
    drawn = None if study.subject.plan is None else plan_motion(study.subject.plan, trajectory)
    count, pictures = frames(study.subject, dataset_of(study, trajectory), drawn, pieces, size)
    report.say(f"drawing {count} frames")

    def counting() -> Iterator[Picture]:
        for number, picture in enumerate(pictures, 1):
            yield picture
            report(number / count)

    write_film(counting(), output, rate, size)


def _model(study: Study, steps: int, output: Path) -> None:
    from ..experiment.study import dataset_of
    from ..experiment.subjects.plan import plan_motion
    from ..geometry.mesh import outline_from_contact
    from ..report.film.gltf import Solid, body_solid, write_gltf
    from ..report.film.mechanism_solids import mechanism_solids

    outline, plan = study.subject.outline, study.subject.plan
    sampled = _with_frames(study, steps)
    trajectory = sampled.trajectory()
    dataset = dataset_of(sampled, trajectory)
    solids: list[Solid] = []
    if outline is not None:
        solids.append(body_solid(dataset, outline_from_contact(outline)))
    if plan is not None:
        solids.extend(mechanism_solids(plan_motion(plan, trajectory)))
    write_gltf(dataset, solids, output)
