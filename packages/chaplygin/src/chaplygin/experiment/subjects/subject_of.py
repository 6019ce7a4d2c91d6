"""The subject of any experiment."""

from __future__ import annotations

from ..models.ball_model import BallExperiment
from ..models.catalogue_models import StateExperiment, SystemExperiment
from ..models.described_models import EquationsExperiment, MechanismExperiment
from ..models.experiment import Experiment
from ..models.rolling_model import FrictionExperiment, RollingExperiment
from .ball_subject import ball_subject
from .catalogue_system import body_of_catalogue, system_of_catalogue
from .described_system import equations_subject, mechanism_subject
from .rolling_subject import rolling_subject
from .subject import Subject


def subject_of(experiment: Experiment) -> Subject:
    """The system of an experiment with its start.

    This validates all parameters, and imports little of the integrators.

    Raises
    ------
    InputError
        If parts of the experiment do not fit together, or a parameter is not admissible.
    """
    match experiment:
        case RollingExperiment():
            return rolling_subject(experiment)
        case FrictionExperiment():
            # Only contact with friction needs SciPy.
            from .contact_subject import contact_subject

            return contact_subject(experiment)
        case BallExperiment():
            return ball_subject(experiment)
        case SystemExperiment():
            return body_of_catalogue(experiment)
        case StateExperiment():
            return system_of_catalogue(experiment)
        case MechanismExperiment():
            return mechanism_subject(experiment)
        case EquationsExperiment():
            return equations_subject(experiment)
