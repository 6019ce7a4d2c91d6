"""Recognise the solvable system that a motion belongs to.

A motion is recognised by its equations, not by its name: the field of its system is compared with
those of the systems that separate, in exact arithmetic (:func:`.base.problem.same_field`), and its
start with the level on which they do.  So gravity on a balanced ball on a plane changes nothing,
and a ball on a sphere is solved for those ratios of the radii for which a separation is known.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import permutations
from typing import TypeAlias

import sympy as sp
from flint import arb, ctx, fmpq

from flowlanes.arguments import NumberOrText
from flowlanes.formulas.balls import ball, ball_values, exact
from flowlanes.formulas.relative_zero import RESOLUTION, ROUNDING
from flowlanes.memory import memory
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.matrices import Column, NamedMatrix
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, real_symbol

from ..catalogue import entry
from ..catalogue.catalogue_entry import bruns_factor
from ..mechanics.rolling.equations import RollingBody
from .base.no_closed_form import CIRCULATIONS, Condition, degenerate, refusal
from .base.problem import Problem, rational, same_field
from .base.solution import Solution
from .genus_two.change_of_symbols import in_symbols_of, translation
from .genus_two.separation import SeparatedSystem
from .principal_axes import about_fixed_point, in_principal_axes, to_original_axes
from .recover_body import rolling_of
from .separable import SEPARABLE, catalogue_system, separated_system

#: A motion in closed form, or None if it is of another kind.
Recogniser: TypeAlias = Callable[[Problem], Solution | None]
#: Parameters of one system as formulas in those of another.
Formulas: TypeAlias = Mapping[sp.Symbol, sp.Expr]
#: A parameter and its value.
Value: TypeAlias = tuple[sp.Symbol, Fraction]

#: Systems by the name of their separation whose bodies may have two equal moments.
VESELOVA_LIKE = ("veselova", "rubber-chaplygin-ball")
CHAPLYGIN_BALL_LIKE = ("chaplygin-ball", "chaplygin-ball-area")

#: Maximum number of parameters that are tried in every order.
FEW = 5


def solution_of(problem: Problem) -> Solution:
    """Solve a motion in closed form.

    Raises
    ------
    InputError
        If start or parameters are not numbers of the system.
    NoClosedFormError
        If none is known; the message says what is.
    """
    problem = problem.well_posed()
    vectors = [name for name in problem.system.state if isinstance(name, Vector)]
    fluids = tuple(name for name in vectors if str(name) in CIRCULATIONS)
    if fluids:
        return _solve_with_fluid(problem, fluids)
    if problem.rolling is None:
        problem = replace(problem, rolling=rolling_of(problem.system, problem.parameters))
    for recogniser in RECOGNISERS:
        solution = recogniser(problem)
        if solution is not None:
            return solution
    near = find_match(problem)
    raise refusal(problem, () if near is None else near.level)


def _solve_with_fluid(problem: Problem, fluids: tuple[Vector, ...]) -> Solution:
    from .body_with_fluid import solve_with_fluid

    solution = solve_with_fluid(problem, fluids, solution_of)
    if solution is None:
        raise refusal(problem)
    return solution


# --- systems that separate -----------------------------------------------------------------


@dataclass(frozen=True)
class Match:
    """A system that separates and has the field of a problem.

    Attributes
    ----------
    known_system : SeparatedSystem
        In the symbols of its own system.
    own : SeparatedSystem
        The same in the symbols of the problem.
    level : tuple of Condition
        The violated conditions of its level; empty if the start and the parameters satisfy all.
    """

    known_system: SeparatedSystem
    own: SeparatedSystem
    level: tuple[Condition, ...]


def find_match(problem: Problem) -> Match | None:
    """The system that separates and has the field of a problem.

    Conditions on parameters alone must hold exactly.  Conditions on the start must hold relative to
    the sizes of their terms: to the fifty digits of a start or, if no system matches the motion so
    exactly, up to the rounding of doubles.
    """
    numbers = {symbol: exact(value) for symbol, value in problem.parameters.items()}
    if not rational(problem.system, numbers):
        return None
    rounded: Match | None = None
    missed: Match | None = None
    places = [place for place in SEPARABLE if place.may_be(problem)]
    for place in sorted(places, key=lambda place: not place.fits(problem)):
        target = catalogue_system(place)
        if len(target.symbols) != len(problem.system.symbols):
            continue
        for formulas in _parameter_identifications(problem, target):
            if _same_vector_field(problem.system, numbers, target, formulas):
                known = separated_system(place)
                match = _match_with_defects(problem, known, formulas, RESOLUTION)
                if not match.level:
                    return match
                near = _match_with_defects(problem, known, formulas, ROUNDING)
                rounded = rounded or (None if near.level else near)
                missed = missed or near
                break
    return rounded or missed


def _match_with_defects(
    problem: Problem, separation: SeparatedSystem, formulas: Formulas, part: fmpq
) -> Match:
    """The known system in the symbols of the problem, with the level conditions that fail."""
    own = in_symbols_of(separation, problem.system, formulas)
    names = translation(separation.system, problem.system, formulas)
    numbers = {s: sp.Rational(str(exact(x))) for s, x in problem.parameters.items()}
    state = set(problem.system.symbols)
    # A relation of the known system may be a condition on the start of the problem.
    own_relations = {
        sp.expand(sign * relation)
        for relation in problem.system.scalar.relations
        for sign in (1, -1)
    }
    relations = [
        (r, scalar.xreplace(names))
        for r, scalar in zip(
            separation.system.relations, separation.system.scalar.relations, strict=True
        )
    ]
    conditions = [
        *zip(separation.level, own.level, strict=True),
        *(pair for pair in relations if sp.expand(pair[1]) not in own_relations),
    ]
    missed, moving = [], []
    for text, formula in conditions:
        if formula.free_symbols & state:
            moving.append(formula)
            holds = problem.vanish([formula], part)
        else:
            holds = sp.sympify(formula).xreplace(numbers) == 0
        if not holds:
            missed.append(Condition(text, formula))
    return Match(separation, replace(own, level=tuple(moving)), tuple(missed))


def _parameter_identifications(problem: Problem, target: System) -> Iterator[Formulas]:
    """Ways to express the parameters of a known system by those of a problem."""
    own = {str(symbol): symbol for symbol in problem.parameters}
    wanted = [parameter.symbol for parameter in target.parameters]
    readings = {s: own[str(s)] for s in wanted if str(s) in own} | _bruns_strength(problem.rolling)
    if len(readings) >= len(wanted) and all(s in readings for s in wanted):
        yield {s: readings[s] for s in wanted}
    for law in problem.system.laws:
        if isinstance(law, Isomorphism) and law.time == 1:
            text = {s: problem.system.expand(f) for s, f in flat_pairs(law.constants)}
            if all(s in text for s in wanted):
                yield {s: text[s] for s in wanted}
    if problem.rolling is None and len(wanted) <= len(own) <= FEW:
        for chosen in permutations(problem.parameters, len(wanted)):
            yield dict(zip(wanted, chosen, strict=True))


def _bruns_strength(rolling: RollingBody | None) -> dict[sp.Symbol, sp.Expr]:
    """The strength of a Bruns field that is given as a potential."""
    if rolling is None or not rolling.body.principal:
        return {}
    factor = bruns_factor(rolling.field.potential)
    return {} if factor is None else {real_symbol("K"): factor}


def _same_vector_field(
    system: System, values: Mapping[sp.Symbol, Fraction], target: System, formulas: Formulas
) -> bool:
    """Whether a known system with these parameters has the field of the problem."""
    there: dict[sp.Symbol, Fraction] = {}
    numbers = {s: sp.Rational(x.numerator, x.denominator) for s, x in values.items()}
    for symbol, formula in formulas.items():
        value = sp.sympify(formula).xreplace(numbers)
        if not value.is_Rational:
            return False
        there[symbol] = exact(value)
    return _same_field(system, tuple(values.items()), target, tuple(there.items()))


@memory(512)
def _same_field(
    system: System, values: Sequence[Value], target: System, there: Sequence[Value]
) -> bool:
    """Cached :func:`.base.problem.same_field`, used by both solutions and diagrams."""
    return same_field(system, dict(values), target, dict(there))


def _solve_separable(problem: Problem) -> Solution | None:
    from .degenerate import solve_degenerate
    from .degenerate.uniform_motion import equilibrium_solution
    from .genus_two.curve import DegenerateError
    from .genus_two_solution import solve_on_torus

    match = find_match(problem)
    if match is None:
        return None
    values = {s: x if isinstance(x, arb) else exact(x) for s, x in problem.parameters.items()}
    axial = _axisymmetric(problem, match, values)
    if axial is not None or match.level:
        return axial
    # A start has fifty digits; coinciding roots differ in the fiftieth, and are handled first.
    solution: Solution | None = equilibrium_solution(problem.system, values, problem.start)
    if solution is None:
        solution = solve_degenerate(match.own, values, problem.start)
    if solution is not None:
        return solution
    try:
        return solve_on_torus(match.own, values, problem.start)
    except DegenerateError:
        raise degenerate(problem) from None


def _axisymmetric(
    problem: Problem, match: Match, values: Mapping[sp.Symbol, NumberOrText]
) -> Solution | None:
    """Solve bodies with two equal moments, and uniform rotations."""
    from .degenerate.exact_start import PRECISION
    from .degenerate.recognise_axisymmetric import chaplygin_of_revolution, veselova_of_revolution

    own, name = match.own, match.known_system.name
    if problem.system.reconstruction is None or name not in (*VESELOVA_LIKE, *CHAPLYGIN_BALL_LIKE):
        return None
    with ctx.workprec(PRECISION):
        numbers = {symbol: ball(value) for symbol, value in values.items()}
        moments = ball_values(own.poles, numbers)
        if name in VESELOVA_LIKE:
            return veselova_of_revolution(problem.system, values, problem.start, moments)
        m, R = (numbers[real_symbol(s)] for s in ("m", "R"))
        D = m * R * R
        return chaplygin_of_revolution(problem.system, values, problem.start, moments, D, R)


def _solve_in_principal_axes(problem: Problem) -> Solution | None:
    if problem.rolling is None:
        return None
    principal = in_principal_axes(problem, problem.rolling)
    if principal is None:
        return None
    return to_original_axes(problem, solution_of(principal[0]), principal[1])


def _solve_about_fixed_point(problem: Problem) -> Solution | None:
    if problem.rolling is not None or set(Symmetric("I").symbols) != set(problem.parameters):
        return None
    turned = about_fixed_point(problem)
    if turned is None:
        return None
    return to_original_axes(problem, solution_of(turned[0]), turned[1])


def _solve_body_of_revolution(problem: Problem) -> Solution | None:
    from .revolution import solve_rolling

    if problem.rolling is None:
        return None
    return solve_rolling(problem.rolling, problem.system, problem.start, problem.parameters)


def _solve_lagrange_top(problem: Problem) -> Solution | None:
    from .lagrange.solution import solve_top

    if [str(name) for name in problem.system.state] != ["M", "Gamma"]:
        return None
    top = entry("lagrange-top").system()
    if problem.system.field != top.field or problem.system.definitions != top.definitions:
        return None
    return solve_top(problem.system, problem.start, problem.parameters)


def _solve_free_body(problem: Problem) -> Solution | None:
    from .euler_top.solution import solve_free_body

    symbols = Diagonal("I").symbols
    if [str(name) for name in problem.system.state] != ["M", "gamma"]:
        return None
    if not set(symbols) <= set(problem.parameters):
        return None
    free = entry("free-body").system()
    numbers = {symbol: exact(value) for symbol, value in problem.parameters.items()}
    if not same_field(problem.system, numbers, free, {s: numbers[s] for s in symbols}):
        return None
    moments = [problem.parameters[symbol] for symbol in symbols]
    return solve_free_body(problem.system, problem.start, problem.parameters, moments)


def _solve_in_three_dimensions(problem: Problem) -> Solution | None:
    from .three_dimensions import solve_in_three_dimensions

    if not any(isinstance(name, Column | NamedMatrix) for name in problem.system.state):
        return None
    return solve_in_three_dimensions(problem, solution_of)


def _solve_in_n_dimensions(problem: Problem) -> Solution | None:
    from .n_dimensions.sphere import solve_on_sphere
    from .n_dimensions.suslov import solve_suslov

    if not any(isinstance(name, Column | NamedMatrix) for name in problem.system.state):
        return None
    return solve_suslov(problem) or solve_on_sphere(problem, solution_of)


RECOGNISERS: tuple[Recogniser, ...] = (
    _solve_in_three_dimensions,
    _solve_in_n_dimensions,
    _solve_lagrange_top,
    _solve_free_body,
    _solve_body_of_revolution,
    _solve_in_principal_axes,
    _solve_about_fixed_point,
    _solve_separable,
)
