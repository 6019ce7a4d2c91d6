"""From an experiment to everything a run needs: the System, its parameters and its start."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
import xarray as xr

from ..arguments import arguments_checked
from ..catalogue import entry, known_laws_of
from ..catalogue.balls.ball_entry import ball_variables
from ..catalogue.balls.ball_laws import known_ball_laws
from ..core.overview import Overview, WithOverview
from ..core.system import System
from ..errors import InputError
from ..flow.cost import TooMuchError
from ..flow.integrator import Trajectory, integrate
from ..flow.trajectory import require_pieces
from ..mechanics.ball.ball import RollingBall
from ..mechanics.ball.initial_state import ball_state
from ..mechanics.lagrangian.mechanism import TIME, Mechanism
from ..mechanics.lagrangian.plan import Plan
from ..mechanics.rolling.body import Body
from ..mechanics.rolling.equations import Forces, Rolling
from ..mechanics.rolling.gauss_map import centre_outside
from ..mechanics.rolling.initial_state import initial_state
from ..mechanics.rolling.shapes import Ball, Disk, Ellipsoid, Implicit, Revolution, Shape, Torus
from ..mechanics.rolling.surfaces import Plane, Sphere
from ..parsing import parse
from .ball import ball_title, potential_of, rolling_ball, smooth_surface
from .dataset import to_dataset
from .described_system import build_described_system
from .file.ball_tables import BallStartTable
from .file.models import (
    BallExperiment,
    EquationsExperiment,
    Experiment,
    MechanismExperiment,
    OwnExperiment,
    RollingExperiment,
    StateExperiment,
    SystemExperiment,
)
from .file.tables import (
    BallTable,
    DiskTable,
    EllipsoidTable,
    FormulaTable,
    ImplicitTable,
    PlaneTable,
    RevolutionTable,
    ShapeTable,
    StartTable,
    SystemStartTable,
    TorusTable,
)
from .initial_state import initial_state_from_values, normalised, on_level, unit_vectors
from .mechanism import identifier
from .plan import described_plan

__all__ = ["Study", "dataset_of", "described_study", "prepare", "shape_name"]


@dataclass(frozen=True, repr=False)
class Study(WithOverview):
    """An experiment made ready.

    Attributes
    ----------
    experiment : Experiment
    system : System
        With every integral that the catalogue knows of it.
    rolling : Rolling or None
        What rolls on what; None for a body about a fixed point.
    given : mapping of str to number or numbers
        The start as given, by name: ω and γ, or the variables of the state.
    until : float
        Duration (s).
    variables : mapping of str to (str, str)
        Meaning and unit of variables of the state, where the start is given by it.
    mechanism : Mechanism, optional
        The Lagrangian, frame and constraints from which the system was derived.
    ball : RollingBall, optional
        The homogeneous ball that rolls, and its surface.
    letters : mapping of str to str
        Meanings of letters that this system alone has.
    plan : Plan, optional
        What is drawn of a mechanism in the plane.

    Examples
    --------
    >>> import chaplygin as ch
    >>> experiment = ch.loads('system = {name = "veselova"}', overrides=["run.until=5"])
    >>> motion = ch.prepare(experiment).trajectory()
    >>> motion["omega"].shape
    (101, 3)
    """

    experiment: Experiment
    system: System
    rolling: Rolling | None
    given: Mapping[str, Any]
    until: float
    variables: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    mechanism: Mechanism | None = None
    ball: RollingBall | None = None
    letters: Mapping[str, str] = field(default_factory=dict)
    plan: Plan | None = None

    def overview(self) -> Overview:
        """The system, the start as given, and the duration."""
        start = ", ".join(f"{name} = {value}" for name, value in self.given.items())
        rows = (("system", repr(self.system)), ("start", start), ("until", f"{self.until:g} s"))
        return Overview(self.system.title, rows)

    @property
    def own(self) -> bool:
        """Whether it is a body of the user's, not a system of the catalogue."""
        return isinstance(self.experiment, RollingExperiment | BallExperiment)

    @property
    def by_state(self) -> bool:
        """Whether the start is given by the state, not by ω and γ."""
        return isinstance(self.experiment, StateExperiment | OwnExperiment)

    @property
    def remarks(self) -> tuple[str, ...]:
        """What was done to the input, one sentence each."""
        unit = unit_vectors(self.system) if self.by_state else {"gamma"}
        start = self.experiment.start
        words = start if isinstance(start, dict) else start.model_dump(exclude_none=True)
        lengths = tuple(
            f"start.{name} has length {length:.9g}; it was normalised to "
            f"[{', '.join(f'{x:.17g}' for x in direction)}]"
            for name, (length, direction) in normalised(words, unit).items()
        )
        if self.own and self.rolling is not None and centre_outside(self.rolling.body.shape):
            return (*lengths, "body.shape.centre puts the centre of mass outside the body")
        return lengths

    @cached_property
    def start(self) -> tuple[Any, ...]:
        """The state at time 0, on the phase space.

        Raises
        ------
        InputError
            If ω breaks the constraint, or no contact point belongs to γ.
        """
        start = self.experiment.start
        with _at(self.experiment, "start"):
            if isinstance(start, StartTable | SystemStartTable):
                return initial_state(
                    self.system,
                    self.given["omega"],
                    self.given["gamma"],
                    heading=start.heading,
                    normal=start.normal,
                )
            if self.ball is not None and isinstance(start, BallStartTable):
                place = self.given["contact" if self.ball.carrier == "support" else "centre"]
                return ball_state(self.ball, self.system, place, start.omega)
            return initial_state_from_values(self.system, self.given)

    @cached_property
    def watched(self) -> System:
        """The system with those integrals alone whose level the start lies on."""
        state = self.start[: len(self.system.symbols)]
        holding = [law for law in self.system.integrals if on_level(self.system, law.on, state)]
        return replace(self.system, laws=tuple(holding))

    @property
    def times(self) -> Any:
        """The sample times, equidistant, both ends included."""
        run = self.experiment.run
        sign = -1.0 if run.direction == "backward" else 1.0
        # adding zero turns −0 into 0
        return sign * np.linspace(0.0, self.until, run.samples) + 0.0

    def complete_toml(self) -> str:
        """The experiment file with nothing left to defaults of the catalogue."""
        tables = self.experiment.model_dump()
        tables["start"] |= self.given
        tables["run"] |= {"until": self.until}
        if isinstance(self.experiment, SystemExperiment | StateExperiment):
            table = self.experiment.system
            tables["system"]["parameters"] = entry(table.name).numbers(table.parameters)
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
            Called with the fraction done.
        pieces : int
            Into how many pieces each sample interval is divided; see `Trajectory.thinned`.
        dense : bool
            Keep the continuous trajectory.

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
        with _at(self.experiment, "start"):
            try:
                found = integrate(
                    self.watched,
                    start,
                    _divided(self.times, pieces),
                    # collocation always computes with all digits
                    tolerance=run.tolerance if run.method == "taylor" else None,
                    precision=run.precision,
                    on_liftoff=run.on_liftoff,
                    keep_integrals=run.keep_integrals,
                    time_limit=run.time_limit,
                    dense=dense,
                    progress=progress,
                    method=run.method,
                )
            except TooMuchError as error:
                where = self.experiment.where("run", "until")
                raise InputError(error.message, where) from None
        if len(found.times) == 1 and found.events:
            raise InputError(
                f"there is no motion from here: {found.events[-1].guard.message}; "
                'on_liftoff = "warn" in [run] follows it as if the surface held the body',
                self.experiment.where("start"),
            )
        return found


def _divided(times: Any, pieces: int) -> Any:
    """Times with each interval divided, the given ones unchanged to the bit."""
    places = np.arange((len(times) - 1) * pieces + 1) / pieces
    return np.interp(places, np.arange(len(times)), times)


def dataset_of(study: Study, trajectory: Trajectory, complete: bool = True) -> xr.Dataset:
    """The trajectory of a study as a dataset that also holds the experiment file's text."""
    return to_dataset(
        trajectory,
        {
            "experiment": study.complete_toml(),
            "complete": int(complete),
        },
        study.variables,
    )


@contextlib.contextmanager
def _at(experiment: Experiment, *key: str) -> Iterator[None]:
    """Say where in the file a mistake stands that only mechanics could see."""
    try:
        yield
    except InputError as error:
        if error.where:
            raise
        subject, colon, rest = error.message.partition(": ")
        if colon and subject == key[-1]:
            raise InputError(rest, experiment.where(*key)) from None
        if colon and experiment.has(*key, subject):
            raise InputError(rest, experiment.where(*key, subject)) from None
        raise InputError(error.message, experiment.where(*key)) from None


@arguments_checked
def prepare(experiment: Experiment) -> Study:
    """Make an experiment ready.

    Parameters
    ----------
    experiment : Experiment
        As :func:`load` and :func:`loads` give it.

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
    >>> experiment = ch.loads('system = {name = "veselova"}', overrides=["run.samples=11"])
    >>> study = ch.prepare(experiment)
    >>> study.system.title, study.times.shape
    ('Veselova system', (11,))
    """
    if isinstance(experiment, MechanismExperiment | EquationsExperiment):
        mechanism, system = build_described_system(experiment)
        return described_study(experiment, system, mechanism)
    if isinstance(experiment, BallExperiment):
        return _with_ball(experiment)
    if not isinstance(experiment, RollingExperiment):
        return _from_catalogue(experiment)
    rolling = _rolling(experiment)
    with _at(experiment, "body"):
        title = experiment.title or _title(rolling)
        system = rolling.system(identifier(title), title)
    system = system.with_laws(*known_laws_of(rolling, system))
    given = {"omega": experiment.start.omega, "gamma": experiment.start.gamma}
    return Study(experiment, system, rolling, given, experiment.run.until)


def _from_catalogue(experiment: SystemExperiment | StateExperiment) -> Study:
    table = experiment.system
    with _at(experiment, "system", "name"):
        item = entry(table.name)
    with _at(experiment, "system", "parameters"):
        system, rolling = item.system(table.parameters), item.rolling(table.parameters)
        ball = item.rolling_ball(table.parameters)
    if experiment.title:
        system = replace(system, title=experiment.title)
    start, suggested = experiment.start, item.start
    words = start if isinstance(start, dict) else {"omega": start.omega, "gamma": start.gamma}
    given = suggested.values | {name: value for name, value in words.items() if value is not None}
    until = experiment.run.until or suggested.until
    return Study(
        experiment,
        system,
        rolling,
        given,
        until,
        item.variables,
        ball=ball,
        letters=item.letters,
        plan=item.plan,
    )


def _with_ball(experiment: BallExperiment) -> Study:
    with _at(experiment, "surface"):
        surface = smooth_surface(experiment.surface)
    with _at(experiment, "field"):
        potential = potential_of(experiment)
    with _at(experiment, "body", "shape"):
        ball = rolling_ball(experiment, surface, potential)
    with _at(experiment, "surface"):
        title = experiment.title or ball_title(experiment, ball)
        system = ball.system(identifier(title), title)
    system = system.with_laws(*known_ball_laws(ball))
    given = experiment.start.model_dump(exclude_none=True)
    until = experiment.run.until
    return Study(experiment, system, None, given, until, ball_variables, ball=ball)


def described_study(
    experiment: MechanismExperiment | EquationsExperiment,
    system: System,
    mechanism: Mechanism | None = None,
) -> Study:
    """The study of a system of the user's own."""
    given = ({str(TIME): 0.0} if TIME in system.symbols else {}) | experiment.start
    variables = {name: (words.meaning, words.unit) for name, words in experiment.variables.items()}
    until = experiment.run.until
    plan = described_plan(experiment, system, mechanism)
    return Study(experiment, system, None, given, until, variables, mechanism, plan=plan)


def _rolling(experiment: RollingExperiment) -> Rolling:
    with _at(experiment, "body", "shape"):
        shape = _shape(experiment.body.shape)
    table = experiment.body
    with _at(experiment, "body"):
        body = Body(table.mass, table.inertia, shape, table.gyrostat)
    surface = experiment.surface
    ground = Plane() if isinstance(surface, PlaneTable) else Sphere(surface.radius)
    forces = experiment.field
    with _at(experiment, "field"):
        potential = _formula(forces, forces.potential) if forces.potential else sp.S.Zero
        field = Forces(forces.gravity, potential, _values(forces))
    return Rolling(body, ground, experiment.contact.model, field)


def _values(table: FormulaTable) -> tuple[tuple[sp.Symbol, float], ...]:
    return tuple((sp.Symbol(name, real=True), x) for name, x in table.parameters.items())


def _formula(table: FormulaTable, text: str) -> sp.Expr:
    return parse(text, {name: sp.Symbol(name, real=True) for name in table.names})


def _shape(table: ShapeTable) -> Shape:
    centre = table.centre
    match table:
        case BallTable():
            return Ball(table.radius, table.hollow, centre=centre)
        case EllipsoidTable():
            return Ellipsoid(table.axes, table.turn, centre=centre)
        case DiskTable():
            return Disk(table.radius, centre=centre)
        case TorusTable():
            return Torus(table.radius, table.tube, centre=centre)
        case RevolutionTable():
            values = _values(table)
            if table.support is not None:
                return Revolution(_formula(table, table.support), values, centre=centre)
            chi_1, chi_2 = (_formula(table, text or "0") for text in (table.chi_1, table.chi_2))
            return Revolution.from_profile(chi_1, chi_2, dict(values), centre)
        case ImplicitTable():
            return Implicit(_formula(table, table.surface), _values(table), centre=centre)


_SHAPES: Mapping[type, str] = {
    Ball: "Ball",
    Ellipsoid: "Ellipsoid",
    Disk: "Disk",
    Torus: "Disk with a rounded edge",
    Revolution: "Body of revolution",
    Implicit: "Convex body",
}


def _title(rolling: Rolling) -> str:
    """A name for a body that the catalogue has none for."""
    ground = "a plane"
    if isinstance(rolling.surface, Sphere):
        ground = "a sphere" if rolling.surface.radius > 0 else "the inside of a sphere"
    manner = "" if rolling.contact == "marble" else ", rubber contact"
    return f"{shape_name(rolling)} on {ground}{manner}"


def shape_name(rolling: Rolling) -> str:
    """What the body is, in words."""
    shape = rolling.body.shape
    return "Hollow ball" if isinstance(shape, Ball) and shape.hollow else _SHAPES[type(shape)]
