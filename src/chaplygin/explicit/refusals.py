"""Motions without a known closed form: what stands in the way, and what is known instead."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..errors import InputError
from ..mechanics.rolling import Rolling
from ..mechanics.shapes import Ball
from ..mechanics.surfaces import Sphere
from ..statements import ConformallyHamiltonian, Integral, Law, Measure
from ..systems.ball_on_sphere import ratio
from .problem import Problem

__all__ = ["NoClosedFormError", "refusal"]


class NoClosedFormError(InputError):
    """No closed form of this motion is known; the message says what is."""


@dataclass(frozen=True)
class _Obstacle:
    """What keeps a rolling body from being solved.

    Attributes
    ----------
    subject : str
        The body, as the subject of a sentence.
    solvable : str
        What is solvable nearby.
    """

    subject: str
    solvable: str


def refusal(problem: Problem) -> NoClosedFormError:
    """Why a motion cannot be solved, in one sentence that says what is known of it.

    Parameters
    ----------
    problem : Problem
        Which no recogniser has recognised.
    """
    obstacle = _obstacle(problem)
    sentence = f"{obstacle.subject} has no known closed form: {_known(problem)}"
    if obstacle.solvable:
        sentence += f"; solvable {obstacle.solvable}"
    return NoClosedFormError(sentence)


def _known(problem: Problem) -> str:
    """The laws that hold at the start, in words."""
    laws = [law for law in problem.system.laws if problem.vanish(law.on)]
    words = [law.meaning or law.name for law in laws if isinstance(law, Integral)]
    words += [phrase for kind, phrase in _FORMS.items() if any(isinstance(x, kind) for x in laws)]
    if not words:
        return "nothing but its equations is known"
    last = words.pop()
    listed = f"{', '.join(words)} and {last}" if words else last
    return f"known {'are' if words else 'is'} {listed}"


_FORMS: dict[type[Law], str] = {
    Measure: "an invariant measure",
    ConformallyHamiltonian: "a conformally Hamiltonian form",
}


def _obstacle(problem: Problem) -> _Obstacle:
    rolling = problem.rolling
    if rolling is None:
        return _Obstacle(f"the {_lowered(problem.system.title)}", "")
    found = (rule(problem, rolling) for rule in _RULES)
    return next(
        (obstacle for obstacle in found if obstacle is not None),
        _Obstacle(f"the {_lowered(problem.system.title)}", ""),
    )


def _lowered(title: str) -> str:
    """A title inside a sentence; names of people keep their capital."""
    first, space, rest = title.partition(" ")
    names = ("Chaplygin", "Veselova", "Suslov", "Clebsch", "Neumann", "Lagrange", "Bruns")
    kept = first in names or first.isupper()
    return title if kept else f"{first.lower()}{space}{rest}"


# --- what stands in the way ----------------------------------------------------------------

Rule = Callable[[Problem, Rolling], _Obstacle | None]


def _rotors(problem: Problem, rolling: Rolling) -> _Obstacle | None:
    if not any(rolling.body.gyrostat):
        return None
    return _Obstacle(f"{_body(rolling)} that carries rotors", "is the same ball without rotors")


def _potential(problem: Problem, rolling: Rolling) -> _Obstacle | None:
    if rolling.field.potential == 0:
        return None
    return _Obstacle(f"{_body(rolling)} in this potential", "is the same ball without it")


def _shape(problem: Problem, rolling: Rolling) -> _Obstacle | None:
    shape = rolling.body.shape
    if isinstance(shape, Ball) and not any(shape.centre):
        return None
    force = " under gravity" if rolling.field.gravity else ""
    body = "unbalanced ball" if isinstance(shape, Ball) else f"{type(shape).__name__.lower()}"
    return _Obstacle(
        f"the {body} {_place(rolling)}{force}, {_contact(rolling)},",
        "are a balanced ball, and a body of revolution with rubber contact on a plane",
    )


def _gravity_on_sphere(problem: Problem, rolling: Rolling) -> _Obstacle | None:
    if not (rolling.field.gravity and isinstance(rolling.surface, Sphere)):
        return None
    return _Obstacle(
        f"the ball on a sphere under gravity, {_contact(rolling)},",
        "is a ball on a sphere without gravity",
    )


def _ratio(problem: Problem, rolling: Rolling) -> _Obstacle | None:
    k = ratio(rolling)
    if k is None or k == -1:
        return None
    further = " with zero linear integral" if rolling.contact == "marble" else ""
    return _Obstacle(
        f"the ball on a sphere with k = {k:.9g}, {_contact(rolling)},",
        f"are k = 1 (a plane) and k = −1 (a hollow ball of twice the sphere's radius){further}",
    )


def _linear(problem: Problem, rolling: Rolling) -> _Obstacle | None:
    laws = [law for law in problem.system.integrals if law.name == "linear"]
    if not laws:
        return None
    (value,) = problem.values([laws[0].value])
    return _Obstacle(
        f"the ball on a sphere with k = −1 whose linear integral is {float(value):.6g}, not 0,",
        "are its motions on which the linear integral vanishes",
    )


_RULES: tuple[Rule, ...] = (_shape, _rotors, _potential, _gravity_on_sphere, _ratio, _linear)


def _body(rolling: Rolling) -> str:
    return f"the ball {_place(rolling)}, {_contact(rolling)},"


def _place(rolling: Rolling) -> str:
    return "on a sphere" if isinstance(rolling.surface, Sphere) else "on a plane"


def _contact(rolling: Rolling) -> str:
    return f"{rolling.contact} contact"
