"""The domain of a search: a system, conditions on its parameters, a level, and sample points.

A sample is drawn modulo a large prime: first parameters and state at random, then one variable of
each relation by solving that relation, in which it has degree one or two.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.printing.formula import text
from flowlanes.system.arrays import BoolArray
from flowlanes.system.named_formulas import by_dependence, definition_values, scalars
from flowlanes.system.system import System

from .modular_jets import Evaluator, Integers, Jet, inverse, prime, square_root
from .real_points import has_real_points

_PROBE = 64
_MOST_FRUITLESS = 3
_NEXT = 1_000_003
_MOST = 120
"""Maximum number of parameter values that are tried."""


@dataclass(frozen=True)
class Sample:
    """Points on the phase space with all values and derivatives there.

    Attributes
    ----------
    evaluate : Evaluator
        Jets of formulas in state, definitions and parameters; slopes are gradients by the state.
    field : tuple of arrays, each of shape (N,)
        The components of the vector field, in flat order.
    rates : tuple of Jet
        The components with their gradients.
    """

    evaluate: Evaluator
    field: tuple[Integers, ...]
    rates: tuple[Jet, ...]

    def along(self, jet: Jet) -> Integers:
        """The derivative of a quantity along the vector field."""
        return jet.along(self.field)

    def __call__(self, formula: sp.Expr) -> Jet:
        """The jet of a scalar formula, written with or without vectors."""
        return self.evaluate(formula)

    def table(self, formulas: Sequence[sp.Expr]) -> Integers:
        """Values of several formulas, shape (formulas, N)."""
        values = np.empty((len(formulas), len(self.field[0])), dtype=np.int64)
        for row, formula in zip(values, formulas, strict=True):
            row[:] = self(formula).value
        return values


@dataclass(frozen=True)
class RestrictedSystem:
    """A system with conditions on its parameters, restricted to a level; see :func:`search_space`.

    Attributes
    ----------
    conditions : tuple of sympy.Expr
        Expressions that vanish, in parameters and definitions that depend on parameters only.
    level : tuple of sympy.Expr
        Expressions that vanish on an invariant level in the phase space.
    substitutions : pairs of Symbol and sympy.Expr
        The conditions solved for parameters.
    """

    system: System
    conditions: tuple[sp.Expr, ...]
    level: tuple[sp.Expr, ...]
    substitutions: tuple[tuple[sp.Symbol, sp.Expr], ...]

    @property
    def on(self) -> tuple[sp.Expr, ...]:
        """All expressions that vanish where a law found here is claimed."""
        return self.conditions + self.level

    @cached_property
    def free(self) -> tuple[sp.Symbol, ...]:
        """Parameters not determined by the conditions."""
        bound = {symbol for symbol, _ in self.substitutions}
        return tuple(p.symbol for p in self.system.parameters if p.symbol not in bound)

    @cached_property
    def constants(self) -> dict[sp.Symbol, sp.Expr]:
        """Definitions that depend only on parameters, in terms of the free parameters."""
        constants, _ = by_dependence(self.system.scalar_definitions, self.system.symbols)
        formulas = definition_values(constants, dict(self.substitutions))
        return {symbol: formulas[symbol] for symbol, _ in constants}

    @cached_property
    def relations(self) -> tuple[sp.Expr, ...]:
        """Relations and level as scalar formulas."""
        return (*self.system.scalar.relations, *scalars(self.level))

    @cached_property
    def order(self) -> tuple[tuple[sp.Expr, sp.Symbol], ...]:
        """The relations in the order in which they are solved, each with its variable.

        Raises
        ------
        InputError
            If the level has no points, or they cannot be found by this method.
        """
        order = self._order(self.relations, ())
        if order is None:
            shown = ", ".join(f"{text(e)} = 0" for e in self.level) or "the relations"
            raise InputError(
                f"no points can be found on {shown}: each must be of degree one or two in a "
                "state variable of its own"
            )
        return order

    # --- points ----------------------------------------------------------------------------

    def sample(self, points: int, seed: int, *, common: bool) -> Sample:
        """Draw random points of the phase space.

        Parameters
        ----------
        points : int
            Number of points.
        common : bool
            Whether all points share the values of the parameters.
        """
        rng = np.random.default_rng(seed)
        values: dict[sp.Symbol, Integers] = {}
        fruitless = 0
        shared = {s: int(rng.integers(1, prime())) for s in self.free}
        have = 0
        while have < points:
            # About half of the points are lost at each quadratic relation.
            batch = 3 * (points - have) + _PROBE
            drawn = {
                s: np.full(batch, shared[s]) if common else rng.integers(1, prime(), batch)
                for s in self.free
            }
            drawn |= {s: rng.integers(1, prime(), batch) for s in self.system.symbols}
            solved = self._regular(self._with_relations(drawn, self.order))
            values = {
                s: np.concatenate([values[s], new]) if values else new for s, new in solved.items()
            }
            fruitless = 0 if len(next(iter(values.values()))) > have else fruitless + 1
            have = len(next(iter(values.values())))
            if fruitless == _MOST_FRUITLESS:
                # A root of parameters alone that does not exist for these parameter values.
                return self._resample(points, seed, common)
        sample = self._jets({s: v[:points] for s, v in values.items()})
        if not sample.evaluate.good.all():
            return self._resample(points, seed, common)
        return sample

    def _resample(self, points: int, seed: int, common: bool) -> Sample:
        """Points for another choice of the parameters."""
        if seed > _MOST * _NEXT:
            raise InputError(
                f"{self.system.name}: no points were found modulo a prime at which the roots in "
                "the equations exist; give the root of a number a name, as a parameter"
            )
        return self.sample(points, seed + _NEXT, common=common)

    def _jets(self, values: Mapping[sp.Symbol, Integers]) -> Sample:
        symbols = self.system.symbols
        points = len(values[symbols[0]])
        directions = np.eye(len(symbols), dtype=np.int64)
        known = {
            s: Jet(values[s], np.repeat(directions[i][:, None], points, axis=1))
            for i, s in enumerate(symbols)
        }
        flat = np.zeros((len(symbols), points), dtype=np.int64)
        known |= {s: Jet(values[s], flat) for s in self.free}
        evaluate = Evaluator(known, points, len(symbols), self._definitions)
        rates = tuple(evaluate(rate) for rate in self.system.rates)
        return Sample(evaluate, tuple(rate.value for rate in rates), rates)

    @cached_property
    def _definitions(self) -> dict[sp.Symbol, sp.Expr]:
        return dict((*self.substitutions, *self.system.scalar_definitions))

    def _with_relations(
        self, values: Mapping[sp.Symbol, Integers], order: Sequence[tuple[sp.Expr, sp.Symbol]]
    ) -> dict[sp.Symbol, Integers]:
        """The points at which all relations could be solved, with the solutions inserted."""
        points = dict(values)
        for relation, variable in order:
            roots, good, _ = self._roots(relation, variable, points)
            points = {s: (roots if s == variable else v)[good] for s, v in points.items()}
        return points

    @cached_property
    def _formulas_with_roots(self) -> tuple[sp.Expr, ...]:
        """Definitions and rates with roots, which exist only at some points."""
        formulas = [*(formula for _, formula in self.system.scalar_definitions), *self.system.rates]
        return tuple(f for f in formulas if any(not p.exp.is_integer for p in f.atoms(sp.Pow)))

    def _regular(self, values: dict[sp.Symbol, Integers]) -> dict[sp.Symbol, Integers]:
        """The points at which the roots in the equations exist."""
        good: BoolArray = np.ones(len(next(iter(values.values()))), dtype=bool)
        for formula in self._formulas_with_roots:
            good = good & self._value(formula, values)[1]
        return {s: v[good] for s, v in values.items()}

    def _value(
        self, formula: sp.Expr, values: Mapping[sp.Symbol, Integers]
    ) -> tuple[Integers, BoolArray]:
        points = len(next(iter(values.values())))
        flat = np.zeros((0, points), dtype=np.int64)
        known = {s: Jet(v, flat) for s, v in values.items()}
        evaluate = Evaluator(known, points, 0, self._definitions)
        return evaluate(formula).value, evaluate.good

    def _roots(
        self, relation: sp.Expr, variable: sp.Symbol, values: Mapping[sp.Symbol, Integers]
    ) -> tuple[Integers, BoolArray, bool]:
        """Roots of a relation, a mask of existence, and whether its degree is one or two."""
        # Interpolate a quadratic through the values at 0, 1, 2 and test it at 3.
        at = []
        good: BoolArray = np.ones(len(values[variable]), dtype=bool)
        for number in range(4):
            moved = {**values, variable: np.full_like(values[variable], number)}
            value, fine = self._value(relation, moved)
            at.append(value)
            good = good & fine
        square = (at[2] - 2 * at[1] + at[0]) % prime() * pow(2, -1, prime()) % prime()
        linear = (at[1] - at[0] - square) % prime()
        suits = bool(np.all((9 * square + 3 * linear + at[0] - at[3]) % prime() == 0))
        if not np.any(square):
            return (
                -at[0] * inverse(linear) % prime(),
                good & (linear != 0),
                suits and bool(linear.any()),
            )
        root, exists = square_root((linear * linear - 4 * (square * at[0] % prime())) % prime())
        solution = (root - linear) % prime() * inverse(2 * square % prime()) % prime()
        return solution, good & exists & (square != 0), suits

    def _order(
        self,
        relations: tuple[sp.Expr, ...],
        solved_relations: tuple[tuple[sp.Expr, sp.Symbol], ...],
    ) -> tuple[tuple[sp.Expr, sp.Symbol], ...] | None:
        if not relations:
            return solved_relations
        rng = np.random.default_rng(len(solved_relations))
        symbols = (*self.free, *self.system.symbols)
        drawn = {s: rng.integers(1, prime(), _PROBE) for s in symbols}
        values = self._with_relations(drawn, solved_relations)
        settled = {s for relation, variable in solved_relations for s in self._depends(relation)}
        for relation in relations:
            others = tuple(r for r in relations if r is not relation)
            for variable in self._candidates(relation, settled):
                if self._roots(relation, variable, values)[2]:
                    order = self._order(others, (*solved_relations, (relation, variable)))
                    if order is not None:
                        return order
            value, _ = self._value(relation, values)
            if not value.any():
                return self._order(others, solved_relations)
        return None

    def _candidates(self, relation: sp.Expr, bound: set[sp.Symbol]) -> Iterator[sp.Symbol]:
        reached = self._depends(relation)
        return (s for s in reversed(self.system.symbols) if s in reached and s not in bound)

    def _depends(self, relation: sp.Expr) -> set[sp.Symbol]:
        steps = self.system.required_definitions([relation])
        reached: set[sp.Symbol] = set(relation.free_symbols)
        for _, value in steps:
            reached |= value.free_symbols
        return reached


def restricted_system(
    system: System, conditions: Sequence[sp.Expr] = (), level: Sequence[sp.Expr] = ()
) -> RestrictedSystem:
    """Restrict a system to conditions on its parameters and to a level.

    Parameters
    ----------
    conditions : sequence of sympy.Expr
        Expressions that vanish, in parameters and definitions that depend on parameters only, such
        as ``k + 1``.
    level : sequence of sympy.Expr
        Functions of the state with an invariant zero level.

    Raises
    ------
    InputError
        If a condition cannot be solved or contradicts the admissible set, or if the level is empty
        or not invariant.
    """
    bare = RestrictedSystem(system, tuple(conditions), (), ())
    space = RestrictedSystem(system, tuple(conditions), tuple(level), _solutions(bare))
    _check_level(space)
    return space


def _solutions(bare: RestrictedSystem) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    system = bare.system
    solved: dict[sp.Symbol, sp.Expr] = {}
    for condition in bare.conditions:
        formula = system.scalar.of(condition).xreplace(bare.constants).xreplace(solved)
        top, _ = sp.fraction(sp.together(formula))
        symbol, value = _linear_root(
            condition, sp.expand(top), [p.symbol for p in system.parameters]
        )
        solved = {s: sp.cancel(v.xreplace({symbol: value})) for s, v in solved.items()}
        solved[symbol] = value
    for parameter in system.parameters:
        for requirement in parameter.admissible:
            if requirement.xreplace(solved) == sp.false:
                conditions = ", ".join(f"{text(c)} = 0" for c in bare.conditions)
                raise InputError(
                    f"{conditions}{_meaning(bare.conditions, solved, parameter.symbol)}, "
                    f"but {text(requirement)} is required"
                )
    return tuple(solved.items())


def _meaning(
    conditions: Sequence[sp.Expr], values: Mapping[sp.Symbol, sp.Expr], symbol: sp.Symbol
) -> str:
    """What conditions imply for a parameter, unless they state it literally."""
    value = values.get(symbol, symbol)
    if [sp.expand(condition) for condition in conditions] == [sp.expand(symbol - value)]:
        return ""
    return f" means {text(symbol)} = {text(value)}"


def _linear_root(
    condition: sp.Expr, top: sp.Expr, parameters: Sequence[sp.Symbol]
) -> tuple[sp.Symbol, sp.Expr]:
    """A parameter in which a condition is linear, and its value."""
    candidates = []
    for symbol in parameters:
        if sp.degree(top, symbol) == 1 if top.has(symbol) else False:
            slope = sp.diff(top, symbol)
            value = sp.cancel(-top.xreplace({symbol: sp.S.Zero}) / slope)
            candidates.append(
                (not slope.is_number, abs(slope) != 1, sp.count_ops(value), symbol, value)
            )
    if not candidates:
        raise InputError(
            f"the condition {text(condition)} = 0 cannot be solved: it must be linear in one of "
            f"{', '.join(map(text, parameters)) or 'the parameters (there are none)'}"
        )
    *_, symbol, value = min(candidates, key=lambda item: item[:3])
    return symbol, value


def _check_level(space: RestrictedSystem) -> None:
    """Raise an error for a level without real points, or that is not invariant."""
    if not space.level:
        return
    shown = ", ".join(f"{text(e)} = 0" for e in space.level)
    if not has_real_points(space.system, space.relations, space.free, space.substitutions):
        raise InputError(f"the level {shown} is empty: no real point lies on it")
    sample = space.sample(_PROBE, 1, common=False)
    if any(sample.along(sample(formula)).any() for formula in space.level):
        raise InputError(f"the level {shown} is not invariant: the motion leaves it")
