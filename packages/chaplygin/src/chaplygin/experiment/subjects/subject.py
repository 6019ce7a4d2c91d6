"""The system of a study, with everything that depends on its kind.

Three kinds differ in how their start is given, in the texts of a report and in its figures: a body
with an angular velocity ω and a unit vector γ (`BodySubject`), a homogeneous ball on a surface
(`BallSubject`), and any other system, whose start gives its state by name (`Subject`).  Those
described only by a file have separate modules: a ball with its position (`ball_subject.py`), a
user-defined system (`described_system.py`), a body with friction (`contact_subject.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar, TypeAlias

import mpmath
import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.printing.formula import text
from flowlanes.system.arrays import FloatArray
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal
from nonholonomic.mechanics.ball.ball import RollingBall
from nonholonomic.mechanics.conventions import start_vectors
from nonholonomic.mechanics.lagrangian.mechanism import TIME, Mechanism
from nonholonomic.mechanics.lagrangian.plan import Plan
from nonholonomic.mechanics.rolling.body import AnyBody
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.shapes.surfaces import Surface
from nonholonomic.starts import initial_state

from ..file.tables import CommonRunTable
from .glossary import glossary
from .initial_state import StartValues, initial_state_from_values, unit_vectors
from .setting import rolling_setting

if TYPE_CHECKING:
    from flowlanes.flow.trajectory import Trajectory

#: Meaning and unit of state variables, by name.
Variables: TypeAlias = Mapping[str, tuple[str, str]]

_UPWARDS = (0.0, 0.0, 1.0)
_BALL = (
    "In space axes: R centre of the ball, ω angular velocity, v velocity, n normal of the surface "
    "towards the ball, r = −bn from the centre to the contact point, F force at the centre, "
    "f = 0 the surface {on}, ℓ = |∇f|; m̃ = m + μ/b², σ = (ω, n)."
)


@dataclass(frozen=True, kw_only=True)
class Subject:
    """A system whose start gives its state by name.

    Attributes
    ----------
    system : System
    start_values : mapping of str to number or numbers
        The start as given, by name.
    until : float
        Duration (s).
    variables : mapping of str to (str, str)
        Meaning and unit of state variables, if the start gives the state.
    rolling : RollingBody, optional
        The rolling body and its surface.
    ball : RollingBall, optional
        The homogeneous ball and its surface.
    plan : Plan, optional
        The drawing of a mechanism in the plane.
    """

    system: System
    start_values: StartValues
    until: float
    variables: Variables = field(default_factory=dict)
    rolling: RollingBody | None = None
    ball: RollingBall | None = None
    plan: Plan | None = None

    starts_by_velocity: ClassVar[bool] = False
    """Whether the start gives ω and γ, from which the state follows."""

    changes_equations: ClassVar[bool] = False
    """Whether its equations change at events, as those of a contact with friction do."""

    has_own_reconstruction: ClassVar[bool] = False
    """Whether the equations of the motion in space are particular to this system."""

    @property
    def claims(self) -> tuple[tuple[System, Law], ...]:
        """The laws that can be proved, each with its system."""
        return tuple((self.system, law) for law in self.system.laws)

    @property
    def setting(self) -> str:
        """The body, its support, the contact and the forces in one line; empty for others."""
        return ""

    @property
    def model(self) -> RollingBody | Mechanism | None:
        """The body or mechanism from which the equations were derived, if known."""
        return self.rolling

    @property
    def kind(self) -> str:
        """``rolling``, ``ball``, ``mechanism`` or ``system``, as used on pages."""
        if self.body is not None:
            return "rolling"
        return "system" if self.plan is None else "mechanism"

    @property
    def body(self) -> AnyBody | None:
        """The body on a surface, or the equivalent body if it contains fluid.

        None without a body.
        """
        return None if self.rolling is None else self.rolling.equivalent.body

    @property
    def surface(self) -> Surface | None:
        """The plane or sphere that carries the body."""
        return None if self.rolling is None else self.rolling.surface

    @property
    def outline(self) -> Callable[[FloatArray], FloatArray] | None:
        """The points of a body with outward normals −γ, for γ (n, 3), body axes."""
        return None if self.body is None else self.body.shape.contact_points()

    @property
    def inertia(self) -> FloatArray | None:
        """The inertia tensor (3, 3) of a body, or given by I₁, I₂, I₃; None if there is none."""
        if self.body is not None:
            return self.body.tensor
        moments = [self.system.defaults.get(s) for s in Diagonal("I").symbols]
        return None if None in moments else np.diag(np.array(moments, dtype=np.float64))

    @property
    def start_words(self) -> Variables:
        """Meaning and unit of start values other than state variables."""
        return {}

    @property
    def summary(self) -> str:
        """One or two sentences on the system, if the catalogue or the file has them."""
        return self.system.summary

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences on unusual properties, such as a centre of mass outside the body."""
        return () if self.body is None else tuple(f"body.{words}" for words in self.body.remarks)

    @property
    def velocities(self) -> Collection[sp.Symbol]:
        """State variables to be changed first if a start violates a relation."""
        return ()

    @property
    def directions(self) -> set[str]:
        """Names of the start values that are normalised."""
        return unit_vectors(self.system)

    def start_vector(self, name: str) -> tuple[float, ...]:
        """A vector of the start as given."""
        value = self.start_values[name]
        return tuple(value) if isinstance(value, Sequence) else (value,)

    def initial_state(self) -> tuple[mpmath.mpf, ...]:
        """The state at time 0, on the phase space.

        Raises
        ------
        InputError
            If the start is not admissible.
        """
        return initial_state_from_values(self.system, self.start_values, self.velocities)

    def trajectory(
        self,
        system: System,
        start: Sequence[mpmath.mpf],
        times: FloatArray,
        run: CommonRunTable,
        dense: bool,
        progress: Callable[[float], None] | None,
    ) -> Trajectory:
        """The motion from a start.

        Parameters
        ----------
        system : System
            The system with the laws that hold at the start.
        start : sequence of mpf
        times : array (n,)
        run : CommonRunTable
            Settings of the computation.
        dense : bool
            Whether to keep the continuous trajectory.
        progress : callable or None
            Called with the fraction completed.

        Raises
        ------
        InputError
            If the body would leave the surface at the start.
        RunError
            If the integration fails; it carries the trajectory so far.
        """
        # A rejected subject needs none of these.
        from flowlanes.flow.integrator import integrate
        from flowlanes.flow.methods import methods

        trajectory = integrate(
            system,
            start,
            times,
            # Collocation always computes with all digits.
            tolerance=run.tolerance if "tolerance" in methods()[run.method].options else None,
            precision=run.precision,
            on_liftoff="warn" if run.on_liftoff == "warn" else "stop",
            keep_integrals=run.keep_integrals,
            time_limit=run.time_limit,
            dense=dense,
            progress=progress,
            method=run.method,
        )
        if len(trajectory.times) == 1 and trajectory.events:
            raise InputError(
                f"there is no motion from here: {trajectory.events[-1].guard.message}; "
                'on_liftoff = "warn" in [run] follows it as if the surface held the body'
            )
        return trajectory

    @property
    def legend(self) -> str:
        """The meaning of the letters of its equations; empty if unknown."""
        meanings = [
            f"{text(name)} {self.variables[str(name)][0]}"
            for name in self.system.state
            if str(name) in self.variables
        ]
        return f"The state: {'; '.join(meanings)}." if meanings else ""

    @property
    def weight(self) -> float | None:
        """The weight, for comparison with the normal force; None without gravity."""
        return None

    @property
    def two_sided(self) -> bool:
        """Whether only the contact acts, so that the surface holds the body from both sides."""
        return False

    @property
    def gamma_is_normal(self) -> bool:
        """Whether the unit vector γ is the normal of a surface."""
        return self.surface is not None

    @property
    def state_names(self) -> list[str]:
        """The variables that a figure of the state shows."""
        return [str(name) for name in self.system.state if name != TIME]

    @property
    def recorded_names(self) -> list[str]:
        """Additional quantities with their own figure."""
        return []

    @property
    def derivation_notes(self) -> tuple[str, ...]:
        """Sentences on quantities recorded besides the state, and on the constraints."""
        return ()


@dataclass(frozen=True, kw_only=True)
class BodySubject(Subject):
    """A rigid body on a surface, or about a fixed point, whose start gives ω and γ.

    Attributes
    ----------
    from_catalogue : bool
        Whether the body is described by the catalogue.
    heading : float
        Angle by which the body is turned about the normal at the start.
    normal : 3 floats
        Outward normal of the surface at the first contact, space axes.
    letters : mapping of str to str
        Meanings of letters particular to this system.
    """

    starts_by_velocity = True

    from_catalogue: bool = True
    heading: float = 0.0
    normal: Sequence[float] = _UPWARDS
    letters: Mapping[str, str] = field(default_factory=dict)

    @property
    def setting(self) -> str:
        """The body on its surface; empty for one about a fixed point."""
        return "" if self.rolling is None else rolling_setting(self.rolling)

    @property
    def summary(self) -> str:
        """The summary of the catalogue."""
        return self.system.summary if self.from_catalogue else ""

    @property
    def remarks(self) -> tuple[str, ...]:
        """The remarks of any subject; for a catalogue body without the names of file keys."""
        if self.from_catalogue and super().remarks:
            return ("the centre of mass lies outside the body",)
        return super().remarks

    @property
    def velocities(self) -> Collection[sp.Symbol]:
        """State variables to be changed first if a start violates a relation."""
        return ()

    @property
    def directions(self) -> set[str]:
        """γ alone."""
        return {"gamma"}

    def initial_state(self) -> tuple[mpmath.mpf, ...]:
        """The state that follows from ω and γ."""
        return initial_state(
            self.system,
            self.start_vector("omega"),
            self.start_vector("gamma"),
            heading=self.heading,
            normal=self.normal,
            fluid=[self.start_vector(str(name)) for name in start_vectors(self.system)],
        )

    @property
    def legend(self) -> str:
        """The meaning of the letters of its equations."""
        return glossary(self.system, self.rolling is not None, self.letters)

    @property
    def weight(self) -> float | None:
        """m g of a rolling body under gravity."""
        if self.rolling is None or not self.rolling.field.gravity:
            return None
        return self.rolling.equivalent.body.mass * self.rolling.field.gravity

    @property
    def two_sided(self) -> bool:
        """Whether it rolls without gravity."""
        return self.rolling is not None and not self.rolling.field.gravity

    @property
    def gamma_is_normal(self) -> bool:
        """Whether it rolls, or its letters have meanings of their own."""
        return self.rolling is not None or bool(self.letters)


@dataclass(frozen=True, kw_only=True)
class BallSubject(Subject):
    """A homogeneous ball on a surface.

    Attributes
    ----------
    ball : RollingBall
        The ball and its surface.
    """

    ball: RollingBall

    @property
    def kind(self) -> str:
        """``ball``."""
        return "ball"

    @property
    def outline(self) -> Callable[[FloatArray], FloatArray]:
        """The points of the sphere."""
        return lambda gamma: -self.ball.radius * gamma

    @property
    def legend(self) -> str:
        """The meaning of the letters of its equations."""
        on_centre = self.ball.kinematics.fit is None
        return _BALL.format(on="of the centre" if on_centre else "that carries the ball at x")

    @property
    def weight(self) -> float | None:
        """m g under gravity."""
        return self.ball.mass * self.ball.gravity or None

    @property
    def two_sided(self) -> bool:
        """Whether only the force of the surface acts on it."""
        return not self.ball.has_forces
