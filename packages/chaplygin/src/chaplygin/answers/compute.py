"""The answers that come with the package, computed."""

from __future__ import annotations

from lawproof.proof.fields.budget import EFFORT
from lawproof.proof.prover import judgement_of, prove

from ..experiment.models.experiment import catalogue_experiment
from ..experiment.study import Study
from .sheet import SHEETS
from .stored import Answer
from .verdicts import LawVerdict, claims_of, law_report_record


def catalogue_answers(name: str) -> dict[str, Answer]:
    """All answers about a system of the catalogue, by command."""
    study = Study.from_experiment(catalogue_experiment(name, []))
    contents = {command: sheet(study, name) for command, sheet in SHEETS.items()}
    contents[f"prove {EFFORT}"] = _verdicts(study, name)
    return {command: Answer(study.remarks, content) for command, content in contents.items()}


def _verdicts(study: Study, name: str) -> list[LawVerdict]:
    return [
        law_report_record(
            system,
            law,
            judgement_of(prove, system, law, EFFORT),
            None if law.as_printed is None else judgement_of(prove, system, law.as_printed, EFFORT),
        )
        for system, law in claims_of(study, name)
    ]
