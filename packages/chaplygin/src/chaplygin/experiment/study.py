"""A study: an experiment with its system, start and trajectory."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, cast

import mpmath
import numpy as np

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.cost import TooMuchError
from flowlanes.flow.taylor.working_numbers import PrecisionError
from flowlanes.flow.trajectory import Trajectory, require_pieces
from flowlanes.system.arrays import FloatArray
from flowlanes.system.laws import Law
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.system import Guard, System
from nonholonomic.mechanics.conventions import start_vectors
from nonholonomic.mechanics.rolling.equations import RollingBody

from .models.experiment import Experiment
from .subjects.initial_state import StartValues, normalised_vectors, on_level
from .subjects.subject import Subject, Variables
from .subjects.subject_of import subject_of

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True, repr=False)
class Study(WithOverview):
    """An experiment with its system, ready to be integrated.

    Attributes
    ----------
    experiment : Experiment
    subject : Subject
        Its system, start and duration, with the texts and figures of its kind.

    Examples
    --------
    >>> import chaplygin as ch
    >>> experiment = ch.parse_experiment('system = {name = "veselova"}', overrides=["run.until=5"])
    >>> motion = ch.Study.from_experiment(experiment).trajectory()
    >>> motion["omega"].shape
    (101, 3)
    """

    experiment: Experiment
    subject: Subject

    @classmethod
    @arguments_checked
    def from_experiment(cls, experiment: Experiment) -> Study:
        """The study of an experiment.

        Parameters
        ----------
        experiment : Experiment
            The result of :func:`load_experiment` or :func:`parse_experiment`.

        Returns
        -------
        Study
            Its system, start and times; ``study.trajectory()`` integrates it.

        Raises
        ------
        InputError
            If its parts do not fit together; the message names the place in the file.

        Examples
        --------
        >>> import chaplygin as ch
        >>> experiment = ch.parse_experiment(
        ...     'system = {name = "veselova"}', overrides=["run.samples=11"]
        ... )
        >>> study = ch.Study.from_experiment(experiment)
        >>> study.system.title, study.times.shape
        ('Veselova system', (11,))
        """
        return cls(experiment, subject_of(experiment))

    @property
    def system(self) -> System:
        """The system, with all its known integrals."""
        return self.subject.system

    @property
    def claims(self) -> tuple[tuple[System, Law], ...]:
        """The laws that can be proved, each with its system."""
        return self.subject.claims

    @property
    def rolling(self) -> RollingBody | None:
        """The rolling body and its surface, if there is one."""
        return self.subject.rolling

    @property
    def start_values(self) -> StartValues:
        """The start as given, by name: ω and γ, or the variables of the state."""
        return self.subject.start_values

    @property
    def until(self) -> float:
        """Duration (s)."""
        return self.subject.until

    @property
    def variables(self) -> Variables:
        """Meaning and unit of state variables, if the start gives the state."""
        return self.subject.variables

    def overview(self) -> Overview:
        """The system, the start as given, the duration, and remarks."""
        start = ", ".join(f"{name} = {value}" for name, value in self.start_values.items())
        rows = (
            ("system", repr(self.system)),
            ("start", start),
            ("until", f"{self.until:g} s"),
            *(("note", remark) for remark in self.remarks),
        )
        return Overview(self.system.title, rows)

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences on corrections of the input, and on unusual properties."""
        start = self.experiment.start
        values = start if isinstance(start, dict) else start.model_dump(exclude_none=True)
        lengths = tuple(
            f"start.{name} has length {length:.9g}; it was normalised to "
            f"[{', '.join(f'{x:.17g}' for x in direction)}]"
            for name, (length, direction) in normalised_vectors(
                cast(StartValues, values), self.subject.directions
            ).items()
        )
        return (*lengths, *self.subject.remarks)

    @cached_property
    def start(self) -> tuple[mpmath.mpf, ...]:
        """The state at time 0, on the phase space.

        Raises
        ------
        InputError
            If ω breaks the constraint, or no contact point belongs to γ.
        """
        with self.experiment.placing_errors("start"):
            return self.subject.initial_state()

    @cached_property
    def system_on_level(self) -> System:
        """The system with only those integrals whose level contains the start."""
        state = self.start[: len(self.system.symbols)]
        holding = [law for law in self.system.integrals if on_level(self.system, law.level, state)]
        return replace(self.system, laws=tuple(holding))

    @property
    def guards(self) -> tuple[Guard, ...]:
        """The guards that end a motion; those of lift-off may only warn."""
        warns = self.experiment.run.on_liftoff == "warn"
        return tuple(item for item in self.system.guards if not (warns and item.lift_off))

    @property
    def times(self) -> FloatArray:
        """The sample times, equidistant, both ends included."""
        run = self.experiment.run
        sign = -1.0 if run.direction == "backward" else 1.0
        # Adding zero turns −0 into 0.
        return sign * np.linspace(0.0, self.until, run.samples) + 0.0

    def complete_toml(self) -> str:
        """The experiment file with all defaults of the catalogue written out."""
        tables = self.experiment.complete_tables()
        # The fluids of several cavities form one list in a file.
        single = {str(name) for name in start_vectors(self.system)} - {"fluid"}
        tables["start"] |= {n: v for n, v in self.start_values.items() if n not in single}
        tables["run"] |= {"until": self.until}
        return type(self.experiment).model_validate(tables).toml()

    @arguments_checked
    def trajectory(
        self,
        progress: Callable[[float], None] | None = None,
        pieces: int = 1,
        dense: bool = False,
    ) -> Trajectory:
        """Integrate the motion.

        Parameters
        ----------
        progress : callable, optional
            Called with the fraction completed.
        pieces : int
            Number of parts of each sample interval; see `Trajectory.subsample`.
        dense : bool
            Whether to keep the continuous trajectory.

        Raises
        ------
        InputError
            If the start is not admissible, or the body would leave the surface there.
        RunError
            If the integration fails; it carries the trajectory so far.
        """
        require_pieces(pieces)
        run = self.experiment.run
        start = self.start
        with self.experiment.placing_errors("start"):
            try:
                return self.subject.trajectory(
                    self.system_on_level,
                    start,
                    _subdivided_times(self.times, pieces),
                    run,
                    dense,
                    progress,
                )
            except TooMuchError as error:
                where = self.experiment.where("run", "until")
                raise InputError(error.message, where) from None
            except PrecisionError as error:
                where = self.experiment.where("run", "precision")
                raise InputError(error.message, where) from None


def _subdivided_times(times: FloatArray, pieces: int) -> FloatArray:
    """Times with each interval divided, keeping the given ones bit for bit."""
    indices = np.arange((len(times) - 1) * pieces + 1) / pieces
    return np.interp(indices, np.arange(len(times)), times)


def dataset_of(study: Study, trajectory: Trajectory, complete: bool = True) -> xr.Dataset:
    """The dataset of a trajectory, with the text of the experiment."""
    attributes = {"experiment": study.complete_toml(), "complete": int(complete)}
    return trajectory.to_dataset(attributes, study.variables)
