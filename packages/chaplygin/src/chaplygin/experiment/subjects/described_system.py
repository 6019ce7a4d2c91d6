"""The system of an experiment file that describes its own mechanics."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, cast

import mpmath
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing import nearest
from flowlanes.printing.formula import text
from flowlanes.system.system import Observable, System
from flowlanes.system.vectors import real_symbol
from nonholonomic.mechanics.constraints.integrability import nonholonomy
from nonholonomic.mechanics.lagrangian.mechanism import TIME, Mechanism
from nonholonomic.mechanics.lagrangian.plan import plan_of
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.starts import initial_state
from nonholonomic.system_files.equations import system_of
from nonholonomic.system_files.mechanisms import mechanism_of, with_claims
from nonholonomic.system_files.parts import name_of
from nonholonomic.system_files.plans import described_plan
from nonholonomic.system_files.toml import Key

from ..models.described_models import EquationsExperiment, MechanismExperiment, OwnExperiment
from .initial_state import StartValues
from .subject import Subject

#: Subjects of error messages, and the keys of the file that they refer to.
_PLACES: tuple[tuple[str, Key], ...] = (
    (r"(the )?(constraint|velocity constraint)\b", ("constraints", "velocity")),
    (r"(the )?position constraint\b", ("constraints", "position")),
    (
        r"the frame|a commutator|the field of|the structure|the relation|no configuration",
        ("frame",),
    ),
    (r"the force\b", ("forces",)),
    (r"the (mass matrix|Lagrangian|kinetic energy)", ("lagrangian",)),
    (r"the constraints\b", ("constraints",)),
)


@dataclass(frozen=True, kw_only=True)
class DescribedSubject(Subject):
    """A system that a user's file describes by a Lagrangian or by equations.

    Attributes
    ----------
    mechanism : Mechanism, optional
        The Lagrangian, frame and constraints from which the system was derived.
    """

    has_own_reconstruction = True

    mechanism: Mechanism | None = None

    @property
    def model(self) -> Mechanism | None:
        """The mechanism, if there is one."""
        return self.mechanism

    @property
    def velocities(self) -> tuple[sp.Symbol, ...]:
        """The velocities of the mechanism."""
        return () if self.mechanism is None else self.mechanism.frame.w

    def initial_state(self) -> tuple[mpmath.mpf, ...]:
        """The state by its variables, or by ω and γ as of a body.

        Raises
        ------
        InputError
            If a variable is unknown or missing, or the state is not on the phase space.
        """
        motion_of_body = (
            bool(self.system.conventions.start_formulas) or self.system.reconstruction is not None
        )
        if motion_of_body and self.start_values.keys() == {"omega", "gamma"}:
            omega, gamma = (self.start_vector(name) for name in ("omega", "gamma"))
            return initial_state(self.system, omega, gamma)
        return super().initial_state()

    @property
    def state_names(self) -> list[str]:
        """The variables of the state, and of the motion in space."""
        whole = self.system.lifted() if self.system.reconstruction else self.system
        return [str(name) for name in whole.state if name != TIME]

    @property
    def recorded_names(self) -> list[str]:
        """The observables."""
        return [item.name for item in self._observables]

    @property
    def derivation_notes(self) -> tuple[str, ...]:
        """Sentences on quantities recorded besides the state, and on the constraints.

        The verdict on the constraints, holonomic or not, is that of
        :func:`nonholonomic.mechanics.constraints.integrability.nonholonomy`.
        """
        return tuple(filter(None, (self._observables_note(), self._constraints_note())))

    @property
    def _observables(self) -> tuple[Observable, ...]:
        motion = self.system.reconstruction
        return (*self.system.observables, *(motion.observables if motion else ()))

    def _observables_note(self) -> str:
        names = [
            text(real_symbol(item.name))
            if item.meaning in ("", item.name)
            else f"{text(real_symbol(item.name))} ({item.meaning})"
            for item in self._observables
        ]
        return f"Also recorded: {'; '.join(names)}." if names else ""

    def _constraints_note(self) -> str:
        mechanism = self.mechanism
        if mechanism is None or not mechanism.f:
            return ""
        try:
            return str(nonholonomy(mechanism))
        except InputError as problem:
            reason = problem.message.removeprefix(f"{mechanism.name}: ")
            return f"Whether the constraints are holonomic is undecided: {reason}."


def mechanism_subject(experiment: MechanismExperiment) -> DescribedSubject:
    """The system that follows from the Lagrangian of a file.

    Raises
    ------
    InputError
        For what is wrong in the file, or with the mechanics: dependent or contradictory
        constraints, a singular mass matrix, a frame that does not span.
    """
    with _placing_errors(experiment):
        mechanism = mechanism_of(experiment)
        system = with_claims(experiment, equations_of_motion(mechanism), catalogue_system)
    return _checked_subject(experiment, system, mechanism)


def equations_subject(experiment: EquationsExperiment) -> DescribedSubject:
    """The system whose equations a file gives.

    Raises
    ------
    InputError
        For what is wrong in the file.
    """
    with _placing_errors(experiment):
        system = system_of(experiment, catalogue_system)
    return _checked_subject(experiment, system, None)


def described_subject(
    experiment: OwnExperiment, system: System, mechanism: Mechanism | None = None
) -> DescribedSubject:
    """A user-defined system with the start, variables and plan of an experiment."""
    variables = experiment.variables.items()
    instant: StartValues = {str(TIME): 0.0} if TIME in system.symbols else {}
    return DescribedSubject(
        system=system,
        start_values={**instant, **cast(StartValues, experiment.start)},
        until=experiment.run.until,
        variables={name: (table.meaning, table.unit) for name, table in variables},
        plan=described_plan(experiment, system)
        or (None if mechanism is None else plan_of(mechanism)),
        mechanism=mechanism,
    )


def catalogue_system(name: str, parameters: Mapping[str, Any]) -> System:
    """A system of the catalogue, onto which an isomorphism may lead."""
    # few files need one
    from nonholonomic.catalogue.systems import catalogue_system as found

    return found(name, parameters)


def _checked_subject(
    experiment: OwnExperiment, system: System, mechanism: Mechanism | None
) -> DescribedSubject:
    _check_variables(experiment, mechanism, system)
    _check_names(experiment, system)
    return described_subject(experiment, system, mechanism)


@contextmanager
def _placing_errors(experiment: OwnExperiment) -> Iterator[None]:
    """Add the location in the file to errors raised by the mechanics."""
    try:
        yield
    except InputError as error:
        if error.where:
            raise
        sentence = error.message.removeprefix(f"{name_of(experiment)}: ")
        key = next((key for words, key in _PLACES if re.match(words, sentence)), ())
        raise InputError(sentence, experiment.where(*key)) from None
    except (ArithmeticError, ValueError) as error:
        # Test points of the prover may leave the domain of a root or a logarithm.
        sentence = f"a formula has no real value at a point where it was tried: {error}"
        raise InputError(sentence.removesuffix(": "), experiment.where()) from None


def _check_variables(
    experiment: OwnExperiment, mechanism: Mechanism | None, system: System
) -> None:
    """Raise an error for meanings given to unknown variables."""
    lifted = system.lifted() if system.reconstruction else system
    known = [str(name) for name in lifted.state]
    if mechanism is not None:
        known += [*map(str, mechanism.frame.velocities), *map(str, mechanism.symbols)]
    for name in experiment.variables:
        if name not in known:
            where = experiment.where("variables", name)
            raise InputError(f"unknown variable{nearest(name, dict.fromkeys(known))}", where)


def _check_names(experiment: OwnExperiment, system: System) -> None:
    """Raise an error for names under which two quantities would be recorded."""
    whole = system.lifted() if system.reconstruction else system
    law_names = Counter(law.name for law in whole.laws)
    for name in experiment.laws.integrals:
        if law_names[name] > 1:
            where = experiment.where("laws", "integrals", name)
            raise InputError(f"another law has the name '{name}'; choose another", where)
    recorded = Counter(item.name for item in whole.observables)
    recorded += Counter([*map(str, whole.state), "time"])
    recorded += Counter(name for name in law_names if name == "energy")
    states = {item.name for item in whole.observables if str(item.value) == item.name}
    for name in experiment.observables.keys() - states:
        if recorded[name] > 1:
            where = experiment.where("observables", name)
            raise InputError(f"something else is recorded as '{name}'; choose another", where)
