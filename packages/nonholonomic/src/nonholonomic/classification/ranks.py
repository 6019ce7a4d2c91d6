"""A system at its present parameters: exact points of its phase space and ranks there."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias, TypeVar

import sympy as sp
from flint import arb, fmpq

from flowlanes.formulas.errors import NotExactError, OutOfReachError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.formulas.number_fields import Balls, Rationals, ball_precision
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Law
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from lawproof.proof.level.level_set import LevelSet
from lawproof.proof.level.named_formulas import components
from lawproof.proof.rank import rank

T = TypeVar("T")

#: Elements of the number fields, and numbers that convert to them.
Element: TypeAlias = fmpq | arb
Number: TypeAlias = sp.Rational | Element | float

POINTS = 2
ATTEMPTS = 400
SEED = 20130400


def rational_parameters(system: System) -> dict[sp.Symbol, sp.Rational]:
    """The values of all parameters as rational numbers, exactly their decimals.

    Parameters on a sphere defined by a relation, such as the sine and the cosine of an angle, get
    the values of a rational point of it, within rounding of their decimals.
    """
    values = {p.symbol: exact_number(p.default) for p in system.parameters}
    for relation in _between_parameters(system):
        values |= _on_sphere(relation, values)
    return values


def _between_parameters(system: System) -> list[sp.Expr]:
    """The relations of a system that involve only parameters."""
    parameters = {p.symbol for p in system.parameters}
    written = (system.expand(relation) for relation in system.relations)
    return [f for f in written if f.free_symbols and f.free_symbols <= parameters]


def _on_sphere(
    relation: sp.Expr, values: Mapping[sp.Symbol, sp.Rational]
) -> dict[sp.Symbol, sp.Rational]:
    """The point of a sphere on the line from a pole to a given point; empty for other relations.

    The pole is opposite to the largest coordinate, which keeps the result within rounding of the
    given point.
    """
    names = sorted(relation.free_symbols, key=str)
    if len(names) < 2 or not relation.is_polynomial(*names) or relation.xreplace(values) == 0:
        return {}
    weight = relation.coeff(names[0], 2)
    square = -relation.xreplace(dict.fromkeys(names, sp.S.Zero)) / weight if weight else sp.S.Zero
    if not (weight.is_Rational and square.is_Rational and square.is_positive):
        return {}
    # stereographic projection from the pole with x_top of opposite sign maps the rational given
    # point to rational parameters, and these to a rational point of the sphere
    radius = sp.sqrt(square)
    sphere = weight * (sp.Add(*(x**2 for x in names)) - square)
    if not radius.is_Rational or sp.expand(relation - sphere) != 0:
        return {}
    top = max(names, key=lambda x: abs(values[x]))
    height = radius + abs(values[top])
    shares = {x: values[x] / height for x in names if x != top}
    whole = 1 + sp.Add(*(share**2 for share in shares.values()))
    cap = sp.sign(values[top]) * radius * (2 / whole - 1)
    return {**{x: 2 * radius * share / whole for x, share in shares.items()}, top: cap}


def with_numeric_parameters(system: System, values: Mapping[sp.Symbol, Number]) -> System:
    """A system whose parameters are definitions with constant values."""
    return System(
        name=system.name,
        title=system.title,
        field=system.field,
        definitions=(*values.items(), *system.definitions),
        relations=system.relations,
        guards=system.guards,
    )


@dataclass(frozen=True)
class View:
    """Formulas with their derivatives at one point of the phase space.

    Attributes
    ----------
    field : Rationals or Balls
    evaluate : Evaluator
        Values with their partial derivatives by the state variables.
    level_set : LevelSet
        The level set of the system to which the formulas belong.
    size : int
        Number of state variables of the system from which the point comes.
    """

    field: Rationals | Balls
    evaluate: Evaluator
    level_set: LevelSet
    size: int

    def jet(self, formula: sp.Expr) -> Jet:
        """A formula of the system with its derivatives."""
        return self.evaluate(self.level_set.without_rates(*scalars(formula)))

    def differential(self, formula: sp.Expr) -> list[Element]:
        """The partial derivatives of a function by the state variables."""
        slopes = self.jet(formula).slopes
        return [slopes.get(i, self.field.zero) for i in range(self.size)]

    def through(self, law: Isomorphism) -> View:
        """The view of this point in the variables of the target of an isomorphism."""
        own = self.level_set
        named = [*components((*law.map, *law.constants), own).items()]
        values = {s: self.evaluate(f) for s, f in named}
        for parameter in law.target.parameters:
            if parameter.symbol not in values:
                values[parameter.symbol] = self.evaluate(parameter.symbol)
        there = LevelSet(law.target)
        reading = Evaluator(self.field, values.get, dict(law.target.scalar_definitions))
        return View(self.field, reading, there, self.size)


#: Covectors at a point.
Covectors: TypeAlias = Callable[[View], list[list[Element]]]


@dataclass(frozen=True)
class RankSample:
    """The points of a phase space, or of a level in it, at the present parameters.

    Parameters
    ----------
    system : System
    level : tuple of sympy.Expr
        Conditions on the state that define the level; none for the whole phase space.
    values : mapping of Symbol to number, optional
        Values of the parameters, in place of the present ones.
    """

    system: System
    level: tuple[sp.Expr, ...] = ()
    values: Mapping[sp.Symbol, Number] | None = None

    @cached_property
    def level_set(self) -> LevelSet:
        """The level, with numbers for parameters.

        Raises
        ------
        OutOfReachError
            If relations between parameters hold for no rational values near the present ones.
        """
        own = rational_parameters(self.system) if self.values is None else {}
        for relation in _between_parameters(self.system) if own else ():
            if relation.xreplace(own) != 0:
                raise OutOfReachError(
                    f"the relation {relation} = 0 between parameters does not hold exactly at "
                    "their present values"
                )
        return LevelSet(with_numeric_parameters(self.system, self.parameters), self.level)

    @property
    def parameters(self) -> Mapping[sp.Symbol, Number]:
        """Values of the parameters."""
        return rational_parameters(self.system) if self.values is None else self.values

    def expand(self, formula: sp.Expr) -> sp.Expr:
        """A formula in the state alone: definitions substituted, parameters as numbers."""
        return self.level_set.expand(sp.sympify(formula))

    def at_points(self, compute: Callable[[View], T]) -> list[T]:
        """Results at some points of the level, inside the domain of the equations.

        Raises
        ------
        OutOfReachError
            If no point was found at which it can be computed.
        """
        generator = random.Random(SEED)
        results: list[T] = []
        with ball_precision():
            for attempt in range(ATTEMPTS):
                values, exact = self.level_set.point(generator)
                if attempt < ATTEMPTS // 2 and not self.level_set.inside(values, exact):
                    continue
                results += self._results(compute, values, exact)
                if len(results) == POINTS:
                    return results
        raise OutOfReachError("no point was found at which the laws could be evaluated")

    def _results(
        self, compute: Callable[[View], T], values: Mapping[str, Number], exact: bool
    ) -> list[T]:
        for rational in (True, False) if exact else (False,):
            field = self.level_set.numbers(values, rational)
            partial = self.level_set.partial(field)
            view = View(field, partial, self.level_set, len(self.system.symbols))
            try:
                return [compute(view)]
            except NotExactError:
                continue
            except ZeroDivisionError:
                break
        return []

    def bounds(self, view: View) -> list[list[Element]]:
        """Differentials of the relations and of the level."""
        return [view.differential(condition) for condition in self.level_set.moving]

    @cached_property
    def dimension(self) -> int:
        """Dimension of the level: number of state variables minus the rank of the conditions.

        If conditions have full rank at one point, they have it at almost all points.
        """
        ranks = self.at_points(lambda view: rank(view.field, self.bounds(view)))
        return len(self.system.symbols) - max(ranks)

    def independent(self, rows: Sequence[Covectors]) -> tuple[list[int], int]:
        """Covectors that are independent of the conditions and of earlier ones.

        Parameters
        ----------
        rows : sequence of callable
            Functions from a view to covectors; the covectors of an entry count together or not at
            all.

        Returns
        -------
        tuple of (list of int, int)
            Indices of the entries that add all their covectors to the rank, and the number of
            covectors that they add; the largest found at a point, exact or certain.
        """

        def independent_indices(view: View) -> tuple[list[int], int]:
            covectors = self.bounds(view)
            first = reached = rank(view.field, covectors)
            indices = []
            for index, make in enumerate(rows):
                more = make(view)
                now = rank(view.field, [*covectors, *more])
                if now == reached + len(more):
                    indices.append(index)
                    covectors += more
                    reached = now
            return indices, reached - first

        return max(self.at_points(independent_indices), key=lambda pair: pair[1])

    def full(self, least: int, rows: Covectors) -> bool:
        """Whether vectors span enough dimensions at one point, and therefore at almost all."""
        return max(self.at_points(lambda view: rank(view.field, rows(view)))) >= least

    def vanishes(self, condition: sp.Expr) -> bool:
        """Whether a condition on parameters holds exactly at the present ones."""
        try:
            return all(self.at_points(lambda view: _zero(view, condition)))
        except OutOfReachError:
            return False

    def signs(self, formula: sp.Expr, points: int = 24) -> set[int]:
        """Signs that a formula certainly takes, at points of the level."""
        generator = random.Random(SEED)
        signs: set[int] = set()
        with ball_precision():
            for _ in range(points):
                values, exact = self.level_set.point(generator)
                signs.update(self._results(lambda view: _sign(view, formula), values, exact))
        return signs - {0}


def conditions_on_parameters(sample: RankSample, laws: Sequence[Law]) -> tuple[sp.Expr, ...]:
    """Conditions on parameters under which some laws hold."""
    state = set(sample.system.symbols)
    conditions = (c for law in laws for c in law.scalar.level)
    fixed = (c for c in conditions if not sample.expand(c).free_symbols & state)
    return tuple(dict.fromkeys(fixed))


def _zero(view: View, formula: sp.Expr) -> bool:
    value = view.jet(formula).value
    return bool(value == 0) if view.field.exact else False


def _sign(view: View, formula: sp.Expr) -> int:
    value = view.jet(formula).value
    if isinstance(value, arb) or view.field.exact:
        return int(value > 0) - int(value < 0)
    return 0
