"""The answers of a worker to a page, part by part; a user error is one sentence."""

from __future__ import annotations

import base64
import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from flowlanes.errors import InputError, RunError

from ..experiment.study import Study
from .requests import (
    MOST_SAMPLES,
    BifurcationDiagram,
    Chart,
    ClosedForm,
    Computation,
    Data,
    Motion,
    Opening,
    PeriodicOrbit,
    Proof,
    Saving,
    Search,
    Subject,
)
from .workers import Message

Answer: TypeAlias = Iterator[Message]


@dataclass(frozen=True)
class Assignment:
    """A request with everything needed to answer it.

    Attributes
    ----------
    request : Computation
    experiment : str or None
        Text of the experiment file; None for a system of the catalogue.
    place : str
        Path of the data: the store of a chart, or the folder of an experiment.
    """

    request: Computation
    experiment: str | None
    place: str = ""


def answer(task: object) -> Answer:
    """The parts of the answer to an assignment; the last one is ``done`` or ``error``."""
    assert isinstance(task, Assignment)
    try:
        yield from _KINDS[type(task.request)](task)
        yield {"done": True}
    except (InputError, RunError) as error:
        yield {"error": str(error)}
    except MemoryError:
        yield {"error": "there is not enough memory for this"}
    except Exception as problem:
        traceback.print_exc()
        yield {"error": f"the computation failed: {type(problem).__name__}"}


def study_of(subject: Subject, experiment: str | None) -> Study:
    """The study that a subject refers to.

    Raises
    ------
    InputError
        If the experiment is not valid.
    """
    from ..experiment.models.experiment import catalogue_experiment, parse_experiment
    from ..experiment.study import Study

    if experiment is None:
        return Study.from_experiment(catalogue_experiment(subject.what, subject.options))
    return Study.from_experiment(parse_experiment(experiment, subject.what, subject.options))


def _study(task: Assignment) -> Study:
    assert not isinstance(task.request, Saving)
    return study_of(task.request.subject, task.experiment)


def _checked_study(study: Study) -> Study:
    """The study, if its motion is short enough to be sent."""
    samples = study.experiment.run.samples
    if samples > MOST_SAMPLES:
        raise InputError(
            f"run.samples is {samples:,}; the laboratory sends at most {MOST_SAMPLES:,}: use "
            "chaplygin run for more"
        )
    return study


def _open(task: Assignment) -> Answer:
    from ..page.study_page import laboratory_model

    assert isinstance(task.request, Opening)
    yield {"doing": "computing the motion"}
    yield {
        "model": laboratory_model(_checked_study(_study(task)), task.request.subject.model_dump())
    }


def _motion(task: Assignment) -> Answer:
    from ..experiment.study import dataset_of
    from .json_numbers import columns

    study = _checked_study(_study(task))
    dataset = dataset_of(study, study.trajectory())
    yield {"motion": {"times": dataset["time"].values.tolist(), "columns": columns(dataset)}}


def _data(task: Assignment) -> Answer:
    from ..experiment.formats import csv_text, netcdf
    from ..experiment.study import dataset_of

    request = task.request
    assert isinstance(request, Data)
    study = _checked_study(_study(task))
    dataset = dataset_of(study, study.trajectory())
    content = netcdf(dataset) if request.format == "nc" else csv_text(dataset).encode()
    name = f"{study.system.name}.{request.format}"
    yield {"file": {"name": name, "base64": base64.b64encode(content).decode()}}


def _prove(task: Assignment) -> Answer:
    from lawproof.proof.fields.budget import EFFORT
    from lawproof.proof.prover import judgement_of, prove

    from ..experiment.single_system import single_system

    request = task.request
    assert isinstance(request, Proof)
    system = single_system(_study(task))
    names = [law.name for law in system.laws]
    if request.law is not None and request.law not in names:
        raise InputError(f"no law {request.law!r}; the laws are {', '.join(names) or 'none'}")
    chosen = [law for law in system.laws if request.law in (None, law.name)]
    for count, law in enumerate(chosen, 1):
        yield {"doing": f"proving {law.name}, {count} of {len(chosen)}"}
        effort = max(1, round(request.effort * EFFORT))
        verdict = judgement_of(prove, system, law, effort)
        yield {
            "verdict": {
                "name": law.name,
                "verdict": verdict.decision,
                "stated": verdict.statement,
                "conditions": list(verdict.conditions),
                "reason": verdict.reason,
                "seconds": verdict.seconds,
            }
        }


def _find(task: Assignment) -> Answer:
    from .search import search_messages

    assert isinstance(task.request, Search)
    yield from search_messages(_study(task), task.request)


def _solve(task: Assignment) -> Answer:
    from flowlanes.printing.equations import equations_html

    from ..experiment.closed_form import ball, equation, letters, solution_of_study

    yield {"doing": "looking for a closed form"}
    study = _study(task)
    form = solution_of_study(study).form
    constants = []
    for figure in form.constants:
        middle, radius = ball(figure.value, 17)
        constants.append(
            {
                "symbol": letters(figure.symbol),
                "value": middle,
                "error": radius,
                "unit": "" if figure.unit == "1" else figure.unit,
                "meaning": letters(figure.meaning),
            }
        )
    yield {
        "closed_form": {
            "title": form.title,
            "motion": form.motion,
            "source": form.source,
            "equations": [equations_html([("", equation(*pair))]) for pair in form.equations],
            "constants": constants,
            "ovals": [list(map(float, oval)) for oval in form.ovals],
        }
    }


def _bifurcation(task: Assignment) -> Answer:
    from ..page.bifurcation_model import bifurcation_model
    from ..page.page_systems import reduced_system

    yield {"doing": "computing the diagram"}
    study = _study(task)
    yield {"bifurcation": bifurcation_model(study, reduced_system(study))}


def _chart(task: Assignment) -> Answer:
    from .charts import tiles

    assert isinstance(task.request, Chart)
    yield from tiles(_study(task), task.request, task.place)


def _orbit(task: Assignment) -> Answer:
    from .orbits import periodic_orbit

    assert isinstance(task.request, PeriodicOrbit)
    yield {"doing": "looking for a periodic orbit"}
    yield {"orbit": periodic_orbit(_study(task), task.request)}


def _save(task: Assignment) -> Answer:
    from .folder import Folder

    request = task.request
    assert isinstance(request, Saving)
    yield {"doing": "checking the experiment"}
    Folder(Path(task.place)).save(request.file, request.experiment, request.replace)
    yield {"saved": request.file}


_KINDS: dict[Any, Callable[[Assignment], Answer]] = {
    Opening: _open,
    Motion: _motion,
    Data: _data,
    Proof: _prove,
    Search: _find,
    ClosedForm: _solve,
    BifurcationDiagram: _bifurcation,
    Chart: _chart,
    PeriodicOrbit: _orbit,
    Saving: _save,
}
