"""A system of the user's own: derived from what its file says, mistakes told by their place."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager

from ..core.system import System
from ..errors import InputError
from ..mechanics.lagrangian.mechanism import Mechanism
from ..mechanics.lagrangian.poincare_suslov import equations
from ..parsing import nearest
from .file.models import EquationsExperiment, MechanismExperiment, OwnExperiment
from .file.toml import Key
from .mechanism import claimed, identifier, mechanism_of, system_of

__all__ = ["build_described_system"]

#: What a refusal speaks of, and where that stands in the file.
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


def build_described_system(
    experiment: MechanismExperiment | EquationsExperiment,
) -> tuple[Mechanism | None, System]:
    """The system that a file describes, and the mechanism it was derived from if it was.

    Raises
    ------
    InputError
        For what is wrong in the file, or with the mechanics: dependent or contradictory
        constraints, a singular mass matrix, a frame that does not span.
    """
    mechanism: Mechanism | None = None
    with _placed(experiment):
        if isinstance(experiment, MechanismExperiment):
            mechanism = mechanism_of(experiment)
            system = claimed(experiment, equations(mechanism))
        else:
            system = system_of(experiment)
    _check_variables(experiment, mechanism, system)
    _check_names(experiment, system)
    return mechanism, system


@contextmanager
def _placed(experiment: OwnExperiment) -> Iterator[None]:
    """Say where in the file a mistake stands that only mechanics could see."""
    try:
        yield
    except InputError as error:
        if error.where:
            raise
        sentence = error.message.removeprefix(f"{identifier(experiment.title)}: ")
        key = next((key for words, key in _PLACES if re.match(words, sentence)), ())
        raise InputError(sentence, experiment.where(*key)) from None
    except (ArithmeticError, ValueError) as error:
        # what is tried at points of its own may leave the domain of a root or a logarithm
        sentence = f"a formula has no real value at a point where it was tried: {error}"
        raise InputError(sentence.removesuffix(": "), experiment.where()) from None


def _check_variables(
    experiment: OwnExperiment, mechanism: Mechanism | None, system: System
) -> None:
    """Refuse meanings of what is no variable."""
    lifted = system.lifted() if system.motion else system
    known = [str(name) for name in lifted.state]
    if mechanism is not None:
        known += [*map(str, mechanism.frame.velocities), *map(str, mechanism.symbols)]
    for name in experiment.variables:
        if name not in known:
            where = experiment.where("variables", name)
            raise InputError(f"unknown variable{nearest(name, dict.fromkeys(known))}", where)


def _check_names(experiment: OwnExperiment, system: System) -> None:
    """Refuse names under which two things would be recorded."""
    whole = system.lifted() if system.motion else system
    taken = Counter(law.name for law in whole.laws)
    for name in experiment.laws.integrals:
        if taken[name] > 1:
            where = experiment.where("laws", "integrals", name)
            raise InputError(f"another law has the name '{name}'; choose another", where)
    recorded = Counter(item.name for item in whole.observables)
    recorded += Counter([*map(str, whole.state), "time"])
    recorded += Counter(name for name in taken if name == "energy")
    for name in experiment.observables:
        if recorded[name] > 1:
            where = experiment.where("observables", name)
            raise InputError(f"something else is recorded as '{name}'; choose another", where)
