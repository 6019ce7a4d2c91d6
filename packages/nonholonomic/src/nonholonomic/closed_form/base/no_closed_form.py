"""Motions without a closed form: the obstacle, and what is known instead."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.relative_zero import ROUNDING
from flowlanes.printing.formula import text
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, of_kind

from ...catalogue.ball_on_sphere import rubber_ball_ratio
from ...catalogue.ball_on_sphere.ball_on_sphere import radius_ratio
from ...mechanics.rolling.equations import RollingBody
from .problem import Problem

#: Names of circulation vectors, for one cavity and for several.
CIRCULATIONS = ("N", *(f"N{i}" for i in range(1, 100)))

#: Number of operations up to which a condition is written out as a formula.
SHORT = 30


class NoClosedFormError(InputError):
    """The motion is not solved in closed form; the message says what is known about it."""


@dataclass(frozen=True)
class _Obstacle:
    """A property that prevents a rolling body from being solved.

    Attributes
    ----------
    subject : str
        The body, as the subject of a sentence.
    solvable : str
        The solvable cases of the same family, in words.
    """

    subject: str
    solvable: str


@dataclass(frozen=True)
class Condition:
    """A level condition that a motion violates.

    Attributes
    ----------
    paper_formula : sympy.Expr
        The formula in the notation of the paper.
    formula : sympy.Expr
        The same in state and parameters of the problem.
    """

    paper_formula: sp.Expr
    formula: sp.Expr


def refusal(problem: Problem, level: Sequence[Condition] = ()) -> NoClosedFormError:
    """Explain in one sentence why a motion cannot be solved, and what is known about it.

    Parameters
    ----------
    problem : Problem
        A problem without a known solution.
    level : sequence of Condition
        The violated conditions, if a closed form is known on their common level.
    """
    start = any(c.formula.free_symbols & set(problem.system.symbols) for c in level)
    obstacle = _off_level(problem, level) if start else _obstacle(problem)
    sentence = f"{obstacle.subject} is not solved in closed form here: {_known_laws(problem)}"
    if obstacle.solvable:
        sentence += f"; solvable {obstacle.solvable}"
    return NoClosedFormError(sentence)


def not_among(problem: Problem, solvable: str) -> NoClosedFormError:
    """Error for a motion without a closed form here; its text names the motions that have one."""
    return NoClosedFormError(
        f"this motion of {_title_in_sentence(problem.system.title)} is not solved in closed form "
        f"here: {_known_laws(problem)}; solvable are its motions {solvable}"
    )


def degenerate(problem: Problem) -> NoClosedFormError:
    """The error for a solvable system whose curve has double roots of an unsolved kind."""
    return NoClosedFormError(
        f"this motion of {_title_in_sentence(problem.system.title)} is not solved, since roots "
        f"of its curve coincide, as they do for equal moments: {_known_laws(problem)}"
    )


def _known_laws(problem: Problem) -> str:
    """The laws that hold at the start, as text."""
    laws = [law for law in problem.system.laws if problem.vanish(law.level, ROUNDING)]
    words = [law.meaning or law.name for law in of_kind(laws, Integral)]
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


def _off_level(problem: Problem, level: Sequence[Condition]) -> _Obstacle:
    """The error for a start off the level on which the system is solvable."""
    conditions = " and ".join(f"{_condition_text(problem, condition)}" for condition in level)
    return _Obstacle(
        f"this motion of {_title_in_sentence(problem.system.title)}",
        f"are its motions on which {conditions}",
    )


def _condition_text(problem: Problem, condition: Condition) -> str:
    """A condition by its formula, or by the name of the integral if the formula is long."""
    written = text(condition.paper_formula)
    if len(written) <= SHORT:
        return f"{written} = 0"
    laws = [law for law in problem.system.integrals if problem.vanish(law.level, ROUNDING)]
    value, *others = problem.sized_values([condition.formula, *(law.value for law in laws)])
    same = [law for law, other in zip(laws, others, strict=True) if (value - other).vanishes()]
    return f"the {same[0].meaning} vanishes" if same else f"{written} = 0"


def _obstacle(problem: Problem) -> _Obstacle:
    fluid = _fluid(problem)
    if fluid is not None:
        return fluid
    obstacles = (rule(problem, problem.rolling) for rule in _RULES if problem.rolling is not None)
    plain = _Obstacle(_title_in_sentence(problem.system.title), _family(problem))
    return next((obstacle for obstacle in obstacles if obstacle is not None), plain)


def _family(problem: Problem) -> str:
    """The solvable members of the family of a system."""
    return _SOLVABLE.get(problem.system.name, "")


_ON_SPHERE = " around a sphere of half its radius, a = −R/2"
_TWO_BLOCKS = ", and those with the symmetry SO(r)×SO(n − r)"
#: The solvable cases of each family of systems, by name.
_SOLVABLE: Mapping[str, str] = {
    rubber_ball_ratio.NAME: "are k = 1 and k = −1",
    "veselova-nd": f"are moments I_ij that are products a_i a_j{_TWO_BLOCKS}",
    "rubber-chaplygin-ball-nd": "are moments for which I_ij + m R² are products a_i a_j"
    + _TWO_BLOCKS,
    "chaplygin-ball-nd": "are, on k = p∧γ, moments with 1/I_ij + 1/(m R²) = 1/(a_i a_j)",
    "chaplygin-ball-on-level-nd": "are moments with 1/I_ij + 1/(m R²) = 1/(a_i a_j)",
    "rubber-ball-on-sphere-nd": "are moments for which I_ij + m R² are products a_i a_j"
    f"{_ON_SPHERE}{_TWO_BLOCKS}",
    "special-rubber-ball-on-sphere-nd": f"is the ball{_ON_SPHERE}",
}


def _title_in_sentence(title: str) -> str:
    """A title within a sentence, with its article; proper names keep their capital."""
    first, space, remainder = title.partition(" ")
    names = (
        "Chaplygin",
        "Veselova",
        "Suslov",
        "Clebsch",
        "Neumann",
        "Lagrange",
        "Bruns",
    )
    if first.endswith("'s"):
        return title
    capitalised = first in names or first.isupper()
    return f"the {title if capitalised else f'{first.lower()}{space}{remainder}'}"


Rule = Callable[[Problem, RollingBody], _Obstacle | None]


def _fluid(problem: Problem) -> _Obstacle | None:
    if not any(str(name) in CIRCULATIONS for name in problem.system.state):
        return None
    return _Obstacle(
        "the motion of a body whose fluid has vorticity in a cavity that is no sphere",
        "may be the same body with the fluid in potential flow, fluid = −Cω in each such cavity",
    )


def _rotors(problem: Problem, rolling: RollingBody) -> _Obstacle | None:
    if not any(rolling.body.gyrostat):
        return None
    return _Obstacle(f"{_body(rolling)} that carries rotors", "is the same ball without rotors")


def _potential(problem: Problem, rolling: RollingBody) -> _Obstacle | None:
    if rolling.field.potential == 0:
        return None
    return _Obstacle(f"{_body(rolling)} in this potential", "is the same ball without it")


def _shape(problem: Problem, rolling: RollingBody) -> _Obstacle | None:
    shape = rolling.body.shape
    if shape.is_balanced_ball:
        return None
    force = " under gravity" if rolling.field.gravity else ""
    body = "unbalanced ball" if shape.is_ball else shape.kind
    return _Obstacle(
        f"the {body} {_surface_name(rolling)}{force}, {_contact(rolling)},",
        "are a balanced ball, and a body of revolution with rubber contact on a plane",
    )


def _gravity_on_sphere(problem: Problem, rolling: RollingBody) -> _Obstacle | None:
    if not rolling.field.gravity or rolling.surface.is_flat:
        return None
    return _Obstacle(
        f"the ball {_surface_name(rolling)} under gravity, {_contact(rolling)},",
        "is a ball on a sphere without gravity",
    )


def _ratio(problem: Problem, rolling: RollingBody) -> _Obstacle | None:
    k = radius_ratio(rolling)
    if k is None or k == -1:
        return None
    further = " with zero linear integral" if rolling.contact == "marble" else ""
    return _Obstacle(
        f"the ball on a sphere with k = {k:.15g}, {_contact(rolling)},",
        f"are k = 1 (a plane) and k = −1 (a hollow ball of twice the sphere's radius){further}",
    )


_RULES: tuple[Rule, ...] = (_shape, _rotors, _potential, _gravity_on_sphere, _ratio)


def _body(rolling: RollingBody) -> str:
    return f"the ball {_surface_name(rolling)}, {_contact(rolling)},"


def _surface_name(rolling: RollingBody) -> str:
    return f"on a {rolling.surface.kind}"


def _contact(rolling: RollingBody) -> str:
    return f"{rolling.contact} contact"
