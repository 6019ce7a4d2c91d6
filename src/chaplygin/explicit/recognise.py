"""Which solvable system a motion belongs to.

A motion is recognised by what it is, not by what it is called: the field of its system is compared
with those of the systems that separate, in exact numbers (:func:`.problem.same_field`), and its
start with the level on which they do.  So gravity on a balanced ball on a plane does nothing, and
a ball on a sphere is solved for those ratios of the radii for which a separation is known.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import lru_cache
from itertools import permutations
from typing import Any, TypeAlias

import sympy as sp
from flint import arb

from ..mechanics.rolling import Rolling
from ..statements import Isomorphism
from ..system import System, flat_pairs
from ..systems.entry import bruns_factor
from ..vectors import Diagonal, scalar
from .expressed import expressed
from .principal import in_principal_axes, told_back
from .problem import Problem, exact, same_field
from .refusals import refusal
from .separable import Separable
from .solution import Solution

__all__ = ["RECOGNISERS", "separated", "solution_of"]

#: A motion in closed form, or None where it is not of this kind.
Recogniser: TypeAlias = Callable[[Problem], Solution | None]
#: Parameters of one system as formulas in those of another.
Formulas: TypeAlias = Mapping[sp.Symbol, Any]

#: Parameters that are tried in every order, at most.
FEW = 5


def solution_of(problem: Problem) -> Solution:
    """The motion in closed form.

    Raises
    ------
    NoClosedFormError
        If none is known; the message says what is.
    """
    for recogniser in RECOGNISERS:
        solution = recogniser(problem)
        if solution is not None:
            return solution
    raise refusal(problem)


# --- systems that separate -----------------------------------------------------------------


@lru_cache(maxsize=1)
def separable_systems() -> tuple[Separable, ...]:
    """The systems that separate on a curve of genus two, those without a field first."""
    from . import bruns, chaplygin_ball, clebsch, neumann, rubber_sphere, veselova

    return (
        veselova.veselova(),
        chaplygin_ball.chaplygin_ball(),
        rubber_sphere.hollow_ball(),
        rubber_sphere.of_ratio(),
        neumann.neumann_system(),
        clebsch.clebsch_case(),
        bruns.veselova_in_bruns_field(),
        bruns.chaplygin_ball_in_bruns_field(),
        bruns.rubber_ball_in_bruns_field(),
    )


def separated(
    problem: Problem,
) -> tuple[Separable, Mapping[sp.Symbol, Any], tuple[Any, ...]] | None:
    """The separation of a motion, in its own symbols, with values and start.

    Parameters
    ----------
    problem : Problem

    Returns
    -------
    tuple of Separable, values by symbol, start; or None
        The start is the lifted state, as the problem has it.
    """
    numbers = {symbol: exact(value) for symbol, value in problem.parameters.items()}
    values = {s: x if isinstance(x, arb) else numbers[s] for s, x in problem.parameters.items()}
    for known in separable_systems():
        if len(known.system.symbols) != len(problem.system.symbols):
            continue
        for formulas in _matches(problem, known.system):
            if _agree(problem.system, numbers, known.system, formulas):
                made = expressed(known, problem.system, formulas)
                if problem.vanish(made.level):
                    return made, values, problem.start
                break
    return None


def _matches(problem: Problem, target: System) -> Iterator[Formulas]:
    """Ways to read the parameters of a known system in those of a problem."""
    own = {str(symbol): symbol for symbol in problem.parameters}
    wanted = [parameter.symbol for parameter in target.parameters]
    given = {s: own[str(s)] for s in wanted if str(s) in own} | _field(problem.rolling)
    if len(given) >= len(wanted) and all(s in given for s in wanted):
        yield {s: given[s] for s in wanted}
    for law in problem.system.laws:
        if isinstance(law, Isomorphism) and law.time == 1:
            told = _written_out(problem.system, law)
            if all(s in told for s in wanted):
                yield {s: told[s] for s in wanted}
    if set(_ROLLING) <= set(own) and set(wanted) == set(_INERTIA):
        yield {s: s + own["m"] * own["R"] ** 2 for s in wanted}
    if len(wanted) <= len(own) <= FEW:
        for chosen in permutations(problem.parameters, len(wanted)):
            yield dict(zip(wanted, chosen, strict=True))


_INERTIA = Diagonal("I").symbols
_ROLLING = ("m", "R", *map(str, _INERTIA))


def _field(rolling: Rolling | None) -> dict[sp.Symbol, Any]:
    """The strength of a Bruns field that is given as a potential."""
    if rolling is None or not rolling.body.principal:
        return {}
    factor = bruns_factor(rolling.field.potential)
    return {} if factor is None else {scalar("K"): factor}


def _written_out(system: System, law: Isomorphism) -> dict[sp.Symbol, sp.Expr]:
    """The constants of an isomorphism in the parameters of its system."""
    known: dict[sp.Symbol, sp.Expr] = {}
    for symbol, value in system.steps:
        known[symbol] = value.xreplace(known)
    return {symbol: value.xreplace(known) for symbol, value in flat_pairs(law.constants)}


def _agree(
    system: System, values: Mapping[sp.Symbol, Fraction], target: System, formulas: Formulas
) -> bool:
    """Whether a known system with these parameters has the field of the problem's."""
    there: dict[sp.Symbol, Fraction] = {}
    numbers = {s: sp.Rational(x.numerator, x.denominator) for s, x in values.items()}
    for symbol, formula in formulas.items():
        value = sp.sympify(formula).xreplace(numbers)
        if not value.is_Rational:
            return False
        there[symbol] = exact(value)
    return same_field(system, values, target, there)


def _genus_two(problem: Problem) -> Solution | None:
    from .genus_two import solved

    found = separated(problem)
    return None if found is None else solved(*found)


def _principal(problem: Problem) -> Solution | None:
    found = in_principal_axes(problem)
    return None if found is None else told_back(problem, solution_of(found[0]), found[1])


RECOGNISERS: tuple[Recogniser, ...] = (_principal, _genus_two)
