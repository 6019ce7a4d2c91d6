"""What a law stands on: the phase space of a system, cut down to a level, made triangular."""

from __future__ import annotations

import random
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypeAlias, TypeVar

import sympy as sp
from flint import fmpq
from sympy.core.function import AppliedUndef

from ...core.named_formulas import expand
from ...core.system import System
from ...core.vectors import Symmetric, to_components
from ...errors import InputError
from ...formulas.errors import (
    EmptyLevelError,
    NeedMoreGeneratorsError,
    NotExactError,
    OutOfReachError,
    UnknownSymbolError,
)
from ...formulas.jets import Evaluator, GeneratorSwap, Inversion, Jet
from ...formulas.number_fields import Balls, Rationals
from ..fields.budget import Budget
from ..fields.function_field import FunctionField
from ..fields.signs import Sign, Signs
from .components import Component, Decomposition
from .sample_points import near, number_text, on_sphere, real_root
from .triangular_set import TriangularSet, numerator, triangle

__all__ = ["EmptyGroundError", "LevelSet"]


class EmptyGroundError(InputError):
    """The conditions of a level have no common real point on the domain."""


DECOMPOSITION = 5_000_000
"""Term operations for the components of a level."""

Kind = TypeVar("Kind", bound=FunctionField)
#: A random number from a default, a generator, and whether its sign is settled.
Draw: TypeAlias = Callable[[float | None, random.Random, bool], Any]


@dataclass(frozen=True)
class LevelSet:
    """The points at which a law is claimed.

    Parameters
    ----------
    system : System
    on : tuple of sympy.Expr
        The level: further expressions that vanish.
    equations : tuple of sympy.Expr, optional
        Of a component of the level: the polynomials in state and parameters that vanish on it,
        in place of the relations and of `on`.
    parent : tuple of sympy.Expr, optional
        Of a part of a component where an initial of it vanishes: the component's equations.
    chosen : tuple of sympy.Expr
        What sets a component apart from the others.
    inner : bool
        Whether this part lies in the closure of other components, so that motions may leave it:
        they are tangent to the parent alone.

    Raises
    ------
    InputError
        If the level is empty, or uses a symbol that the system does not have.
    """

    system: System
    on: tuple[Any, ...] = ()
    equations: tuple[Any, ...] | None = None
    parent: tuple[Any, ...] | None = None
    chosen: tuple[Any, ...] = ()
    inner: bool = False

    @cached_property
    def steps(self) -> dict[sp.Symbol, sp.Expr]:
        """The definitions, by symbol; and parameters that the level gives in terms of others."""
        return {**self._definitions, **self.settled}

    @cached_property
    def _definitions(self) -> dict[sp.Symbol, sp.Expr]:
        return dict(self.system.steps)

    @cached_property
    def settled(self) -> dict[sp.Symbol, sp.Expr]:
        """Parameters that conditions on parameters alone settle, such as k = −1."""
        return self._settlement[0]

    @cached_property
    def _settlement(self) -> tuple[dict[sp.Symbol, sp.Expr], tuple[sp.Expr, ...]]:
        """What is settled, and the conditions that remain."""
        parameters = {p.symbol for p in self.system.parameters}
        found: dict[sp.Symbol, sp.Expr] = {}
        remaining = []
        for condition in self.conditions:
            self._known(condition)
            formula = condition
            while formula.free_symbols & {*self._definitions, *found}:
                formula = formula.xreplace(self._definitions).xreplace(found)
            choice = None
            if formula.free_symbols and formula.free_symbols <= parameters:
                choice = _linear_in(sp.fraction(sp.together(formula))[0])
            if choice is None:
                remaining.append(condition)
            else:
                found = {p: v.xreplace(dict([choice])) for p, v in found.items()}
                found |= dict([choice])
        return found, tuple(remaining)

    @cached_property
    def exchanged(self) -> tuple[GeneratorSwap, ...]:
        """Definitions that take the place of a parameter as generators."""
        parameters = {p.symbol for p in self.system.parameters} - set(self.settled)
        for condition in self._settlement[1]:
            parameters -= self._reach(condition, set())
        found: dict[sp.Symbol, GeneratorSwap] = {}
        for name, raw in self.system.steps:
            formula = raw.xreplace(self.settled)
            gone = {e.parameter for e in found.values()}
            for parameter in sorted(formula.free_symbols & parameters - gone, key=str):
                factor = sp.diff(formula, parameter)
                rest = formula.xreplace({parameter: sp.S.Zero})
                if (
                    factor.is_Rational
                    and factor != 0
                    and not (gone | {parameter}) & self._reach(rest, set(found))
                ):
                    found[name] = GeneratorSwap(name, parameter, factor, rest)
                    break
        return tuple(found.values())

    def _reach(self, formula: sp.Expr, stop: set[sp.Symbol]) -> set[sp.Symbol]:
        """Symbols on which a formula depends, through all definitions but those in `stop`."""
        found: set[sp.Symbol] = set()
        waiting = set(formula.free_symbols)
        while waiting:
            symbol = waiting.pop()
            found.add(symbol)
            if symbol in self.steps and symbol not in stop:
                waiting |= self.steps[symbol].free_symbols - found
        return found

    @cached_property
    def inverted(self) -> tuple[Inversion, ...]:
        """Inverses of full symmetric tensors whose entries are exchanged."""
        names = {e.name for e in self.exchanged}
        found = []
        for name, formula in self.system.definitions:
            if isinstance(name, Symmetric):
                inverse = [t for t in formula.atoms(Symmetric) if formula == t**-1]
                if inverse and set(inverse[0].symbols) <= names:
                    found.append(Inversion(tuple(name.symbols), tuple(inverse[0].symbols)))
        return tuple(found)

    @cached_property
    def generators(self) -> tuple[sp.Symbol, ...]:
        """Independent symbols: state and parameters, some of them exchanged."""
        inverse = {j: a for i in self.inverted for a, j in zip(i.name, i.of, strict=True)}
        instead = {e.parameter: inverse.get(e.name, e.name) for e in self.exchanged}
        return tuple(instead.get(s, s) for s in self.symbols if s not in self.settled)

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """State and parameters."""
        return (*self.system.symbols, *(p.symbol for p in self.system.parameters))

    @cached_property
    def named(self) -> dict[str, sp.Symbol]:
        """State, parameters and definitions by name."""
        return {str(s): s for s in (*self.symbols, *self._definitions)}

    @cached_property
    def conditions(self) -> tuple[sp.Expr, ...]:
        """What vanishes: relations of the system and the level, or equations of a component."""
        if self.equations is not None:
            return self.equations
        return tuple(to_components(c) for c in (*self.system.relations, *self.on))

    @cached_property
    def moving(self) -> tuple[sp.Expr, ...]:
        """The conditions that involve the state, in terms of state and parameters alone."""
        state = set(self.system.symbols)
        conditions = self.parent if self.inner and self.parent else self.conditions
        expanded = (self.expanded(c) for c in conditions)
        return tuple(c for c in expanded if c.free_symbols & state)

    @cached_property
    def zeros(self) -> tuple[sp.Expr, ...]:
        """Values of unspecified functions that the conditions say are zero."""
        return tuple(c for c in self.conditions if isinstance(c, AppliedUndef))

    def expanded(self, formula: sp.Expr) -> sp.Expr:
        """A formula in which the definitions are written out."""
        return expand(formula, self.steps)

    # --- components ------------------------------------------------------------------------

    @cached_property
    def components(self) -> tuple[LevelSet, ...]:
        """The components of the level; this ground alone where it is a single one.

        Raises
        ------
        InputError
            If the level is empty.
        OutOfReachError
            If it cannot be decomposed.
        """
        if self.equations is not None:
            return (self,)
        budget = Budget(effort=DECOMPOSITION)
        draft = FunctionField([str(s) for s in self.symbols], budget=budget)
        evaluate = Evaluator(draft, self._seeds(draft, self.symbols), self._definitions)
        for condition in self.conditions:
            self._known(condition)
        conditions = [
            _polynomial(draft, evaluate.value(condition), condition)
            for condition in self.conditions
            if condition not in self.zeros
        ]
        names = [str(s) for s in self.symbols]
        moving = {str(s) for s in self.system.symbols}
        signs = self._signs_in(draft, evaluate, conditions)
        found = Decomposition(draft, names, moving, signs).components(conditions)
        if not found:
            raise self._empty()
        if len(found) == 1 and found[0].equations == tuple(conditions):
            return (self,)
        return tuple(self._component(part) for part in found)

    def _component(self, part: Component) -> LevelSet:
        by_name = {str(s): s for s in self.symbols}

        def written(polys: Sequence[Any]) -> tuple[sp.Expr, ...]:
            return tuple(_as_formula(poly, by_name) for poly in polys)

        equations = (*written(part.equations), *self.zeros)
        parent = None
        if part.parent is not None:
            parent = (*written(part.parent.equations), *self.zeros)
        return LevelSet(self.system, self.on, equations, parent, written(part.chosen), part.inner)

    def _empty(self) -> EmptyGroundError:
        return EmptyGroundError(
            f"{self.system.name}: the level {_listed(self.on)} is empty; its conditions "
            "contradict each other or the phase space"
        )

    # --- what is known of signs --------------------------------------------------------------

    @cached_property
    def requirements(self) -> tuple[sp.Expr, ...]:
        """What is known to be positive, negative, zero or not on the domain, as relations."""
        found = [
            to_components(guard.value) > 0 for guard in self.system.guards if not guard.lift_off
        ]
        for parameter in self.system.parameters:
            for condition in parameter.admissible:
                found += sp.And.make_args(sp.sympify(condition))
        for symbol in self.symbols:
            found += [
                relation
                for known, relation in (
                    (symbol.is_positive, symbol > 0),
                    (symbol.is_negative, symbol < 0),
                    (symbol.is_nonnegative, symbol >= 0),
                    (symbol.is_nonpositive, symbol <= 0),
                    (symbol.is_nonzero, sp.Ne(symbol, 0)),
                )
                if known
            ]
        if sp.false in found:
            guards = (
                g.name for g in self.system.guards if (to_components(g.value) > 0) == sp.false
            )
            what = next((f"the guard {name!r} is positive" for name in guards), "")
            raise InputError(
                f"{self.system.name}: {what or 'what is asked of the parameters holds'} nowhere"
            )
        return tuple(r for r in found if r != sp.true)

    def sign(self, formula: Any) -> Sign:
        """The sign of a formula on the domain, as far as it is known."""
        if any(r.func is sp.Gt and r.lhs - r.rhs == formula for r in self.requirements):
            return Sign.POSITIVE
        # as it is written, then reduced by the conditions: either may show what the other hides
        plain = replace(self, system=replace(self.system, relations=(), laws=()), on=())
        written = replace(plain, equations=None)._sign(formula)
        return self._sign(formula) if written is Sign.UNKNOWN else written

    def _sign(self, formula: Any) -> Sign:
        spare = 8
        while True:
            field = self.fractions(FunctionField, spare, None, Budget())
            try:
                element = self.evaluator(field).value(formula)
            except NeedMoreGeneratorsError:
                spare *= 2
                continue
            except (OutOfReachError, ZeroDivisionError):
                return Sign.UNKNOWN
            found = field.signs.of(element.poly)
            for factor, power in element.powers.items():
                if power % 2:
                    found = found.times(field.signs.of(field.factors[factor]))
            return found

    @cached_property
    def _signed(self) -> frozenset[str]:
        """State variables and parameters whose sign is settled."""
        found = set()
        for relation in self.requirements:
            if isinstance(relation, sp.Gt | sp.Ge | sp.Lt | sp.Le) and 0 in relation.args:
                found |= {str(a) for a in relation.args if a.is_Symbol}
        return frozenset(found)

    def signs(self, field: FunctionField) -> Signs:
        """What is known of signs, in the ring of a field of fractions."""
        return self.signs_with(field, [poly for _, poly, _ in field.relations])

    def signs_with(self, field: FunctionField, conditions: Sequence[Any]) -> Signs:
        """The same, where some polynomials vanish."""
        return self._signs_in(field, self.evaluator(field), conditions)

    def _signs_in(
        self, field: FunctionField, evaluate: Evaluator, conditions: Sequence[Any]
    ) -> Signs:
        known: dict[str, Sign] = {}
        facts: list[tuple[Any, Sign]] = []
        nonzero: list[Any] = []
        # signs of single symbols first, on which those of other quantities may rest
        for relation in sorted(self.requirements, key=lambda r: len(r.free_symbols)):
            decided = len(field.decisions)
            poly = _as_polynomial(field, evaluate, relation)
            if len(field.decisions) > decided:
                # it holds for one choice of signs only
                for key in list(field.decisions)[decided:]:
                    del field.decisions[key]
                continue
            if poly is None or poly.is_constant():
                continue
            if isinstance(relation, sp.Ne):
                nonzero.append(poly)
                continue
            strict = isinstance(relation, sp.StrictGreaterThan | sp.StrictLessThan)
            sign = Sign.POSITIVE if strict else Sign.NOT_NEGATIVE
            if len(poly) == 1 and poly.total_degree() == 1:
                name = next(n for n, d in zip(field.names, poly.degrees(), strict=True) if d)
                own = sign if poly.leading_coefficient() > 0 else Sign(-sign)
                known[name] = max(known.get(name, own), own, key=abs)
            facts.append((poly, sign))
            field.signs = Signs(field.ring, {**field.signs.known, **known}, facts, nonzero)
        known = {**field.signs.known, **known}
        return Signs(field.ring, known, facts, nonzero, conditions)

    # --- the triangular set ----------------------------------------------------------------

    @cached_property
    def _triangle(self) -> TriangularSet:
        draft = FunctionField([str(s) for s in self.generators])
        evaluate = self.evaluator(draft)
        conditions = [
            _polynomial(draft, evaluate.value(condition), condition)
            for condition in self._settlement[1]
            if condition not in self.zeros
        ]
        names = [str(s) for s in self.generators]
        moving = {str(s) for s in self.system.symbols}
        try:
            return triangle(draft, names, conditions, moving)
        except EmptyLevelError:
            raise self._empty() from None

    def _known(self, condition: Any) -> None:
        unknown = condition.free_symbols - set(self.symbols) - set(self._definitions)
        if unknown:
            raise InputError(
                f"{self.system.name}: the level {condition} = 0 uses "
                f"{', '.join(sorted(map(str, unknown)))}, which is neither a state variable, a "
                "definition nor a parameter"
            )

    def fractions(
        self,
        kind: type[Kind],
        spare: int,
        sample: Mapping[str, float] | None,
        budget: Budget,
        choices: Mapping[str, int] | None = None,
    ) -> Kind:
        """The field of fractions modulo the conditions, of the class given."""
        field = kind(self._triangle.order, spare, sample, budget, choices)
        for main, terms in self._triangle.relations:
            made = {}
            for named, number in terms.items():
                powers = dict(named)
                made[tuple(powers.get(n, 0) for n in field.names)] = number
            field.impose(main, field.ring.from_dict(made))
        field.signs = self.signs(field)
        return field

    # --- points ----------------------------------------------------------------------------

    def point(self, generator: random.Random, draw: Draw = near) -> tuple[dict[str, Any], bool]:
        """A random point that satisfies the conditions, and whether it is exactly rational.

        Of a level with several components, it is a point of the first.

        Parameters
        ----------
        generator : random.Random
        draw : callable
            How free numbers are drawn, from a default and the generator.

        Raises
        ------
        OutOfReachError
            If none was found.
        """
        ground = self._first
        for _ in range(60):
            try:
                return ground._try_point(generator, draw)
            except ZeroDivisionError:
                continue
        raise OutOfReachError(f"no real point was found on the level {_listed(self.on)}")

    @cached_property
    def _first(self) -> LevelSet:
        """The first component; the ground itself where it cannot be decomposed."""
        try:
            return self.components[0]
        except OutOfReachError:
            return self

    def _try_point(self, generator: random.Random, draw: Draw) -> tuple[dict[str, Any], bool]:
        names, chain = self._triangle.order, self._triangle.relations
        mains = {main for main, _ in chain}
        values: dict[str, Any] = {}
        for main, terms in chain:
            values |= on_sphere(main, terms, (mains - {main}) | {*values}, generator) or {}
        defaults = {str(p.symbol): p.default for p in self.system.parameters}
        exchanged = {str(s) for s in self.generators if s in self._definitions}
        involved = {n for _, terms in chain for named in terms for n, power in named if power}
        for name in names:
            if name in mains or name in values:
                continue
            if name not in exchanged:
                values[name] = draw(defaults.get(name), generator, name in self._signed)
            elif name in involved:
                values[name] = fmpq(generator.randint(20, 40), 20)
        exact = True
        for main, terms in chain:
            if main not in values:
                values[main] = real_root(main, terms, values, generator)
                exact = exact and isinstance(values[main], fmpq)
        return self._with_exchanged(values, generator, draw, exact)

    def _with_exchanged(
        self, values: dict[str, Any], generator: random.Random, draw: Draw, exact: bool
    ) -> tuple[dict[str, Any], bool]:
        """The point with its exchanged definitions, whose parameters stay near their defaults."""
        defaults = {str(p.symbol): p.default for p in self.system.parameters}
        known = {str(s): s for s in (*self.generators, *(e.parameter for e in self.exchanged))}
        given = {known[name]: value for name, value in values.items()}
        for change in self.exchanged:
            if change.name not in given:
                name = str(change.parameter)
                given[change.parameter] = draw(defaults[name], generator, name in self._signed)
        own = [s for s in self.generators if s in self._definitions]
        names = [s for s in own if s not in given]
        for rational in (True, False) if exact else (False,):
            numbers = {str(s): v for s, v in given.items()}
            field = self.numbers(numbers, rational)
            jets = {s: Jet(field.generator(str(s)), {}) for s in given}
            evaluate = Evaluator(field, jets.get, self.steps)
            try:
                found = {str(n): evaluate.value(n) for n in names}
            except NotExactError:
                continue
            # parameters that were drawn, beside what takes their place
            drawn = {n: v for n, v in numbers.items() if n not in values}
            return {**drawn, **values, **found}, rational
        raise ZeroDivisionError

    def inside(self, values: Mapping[str, Any], exact: bool) -> bool:
        """Whether a point lies in the domain of the system: guards and admissible parameters."""
        for rational in (True, False) if exact else (False,):
            field = self.numbers(values, rational)
            evaluate = self.evaluator(field)
            try:
                return all(
                    _certain(relation, evaluate.value(relation.lhs - relation.rhs))
                    for relation in self.requirements
                )
            except NotExactError:
                continue
            except (ZeroDivisionError, OutOfReachError):
                return False
        return False

    def point_shown(self, field: Any) -> dict[str, str]:
        """State and parameters at a point, for a reader."""
        evaluate = self.evaluator(field)
        return {str(s): number_text(evaluate.value(s)) for s in self.symbols}

    def roots(self, values: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
        """The main variables at a point that are not rational: roots of polynomials.

        Each is given by the polynomial, in the rational numbers put in, and by an interval that
        holds one root.
        """
        found: dict[str, dict[str, Any]] = {}
        for main, terms in self._triangle.relations:
            value = values[main]
            if isinstance(value, fmpq):
                continue
            made: dict[tuple[tuple[str, int], ...], fmpq] = {}
            for named, coefficient in terms.items():
                number, left = coefficient, []
                for name, power in named:
                    if power and isinstance(values[name], fmpq):
                        number = number * values[name] ** power
                    elif power:
                        left.append((name, power))
                made[tuple(left)] = made.get(tuple(left), fmpq(0)) + number
            names = list(dict.fromkeys(name for left in made for name, _ in left))
            written = [
                [str(number), [x for name, power in left for x in (names.index(name), power)]]
                for left, number in made.items()
                if number
            ]
            found[main] = {
                "poly": {"ring": names, "terms": written},
                "near": value.mid().str(60, radius=False),
                "radius": "1e-50",
            }
        return found

    def numbers(self, values: Mapping[str, Any], exact: bool) -> Rationals | Balls:
        """The field of numbers at a point."""
        return Rationals(values) if exact else Balls(values)

    # --- evaluation ------------------------------------------------------------------------

    def evaluator(self, field: Any) -> Evaluator:
        """Values alone."""
        seed = self._seeds(field, set(self.generators) - set(self.steps))
        return Evaluator(field, seed, self.steps, self.exchanged, self.zeros, self.inverted)

    @staticmethod
    def _seeds(field: Any, own: Collection[sp.Symbol]) -> Callable[[sp.Symbol], Jet | None]:
        def seed(symbol: sp.Symbol) -> Jet | None:
            return Jet(field.generator(str(symbol)), {}) if symbol in own else None

        return seed

    def along(self, field: Any) -> Evaluator:
        """Values with their time derivatives along the field of the system."""
        plain = self.evaluator(field)
        rates = dict(zip(self.system.symbols, self.system.rates, strict=True))

        def seed(symbol: sp.Symbol) -> Jet | None:
            known = plain.seed(symbol)
            if known is None or symbol not in rates:
                return known
            return Jet(known.value, {-1: plain.value(rates[symbol])})

        return Evaluator(field, seed, self.steps, self.exchanged, self.zeros, self.inverted, True)

    def partial(self, field: Any) -> Evaluator:
        """Values with their partial derivatives by the state variables, numbered."""
        plain = self.evaluator(field)
        number = {s: i for i, s in enumerate(self.system.symbols)}

        def seed(symbol: sp.Symbol) -> Jet | None:
            known = plain.seed(symbol)
            if known is None or symbol not in number:
                return known
            return Jet(known.value, {number[symbol]: field.one})

        return Evaluator(field, seed, self.steps, self.exchanged, self.zeros, self.inverted)


def _polynomial(draft: FunctionField, element: Any, condition: Any) -> Any:
    """The polynomial whose vanishing a condition states."""
    poly = numerator(draft, element)
    if poly and any(poly.degrees()[: draft.spare]):
        raise OutOfReachError(
            f"the condition {condition} = 0 contains a root or a function; state it as a polynomial"
        )
    return poly


def _as_formula(poly: Any, by_name: Mapping[str, sp.Symbol]) -> sp.Expr:
    """A polynomial as a formula."""
    names = poly.context().names()
    return sp.Add(
        *(
            sp.Rational(int(number.p), int(number.q))
            * sp.Mul(*(by_name[n] ** int(e) for n, e in zip(names, exponents, strict=True) if e))
            for exponents, number in poly.to_dict().items()
        )
    )


def _as_polynomial(field: FunctionField, evaluate: Evaluator, relation: Any) -> Any:
    """A polynomial with the sign of the greater side less the smaller one; None if there is none.

    What a relation is divided by is multiplied with where its power is odd.
    """
    if isinstance(relation, sp.Ne):
        formula = relation.lhs - relation.rhs
    elif isinstance(relation, sp.Gt | sp.Ge | sp.Lt | sp.Le):
        formula = relation.gts - relation.lts
    else:
        return None
    try:
        element = evaluate.value(formula)
    except (OutOfReachError, NeedMoreGeneratorsError, UnknownSymbolError, ZeroDivisionError):
        return None
    poly = element.poly
    for number, power in element.powers.items():
        if power % 2:
            poly = poly * field.factors[number]
    if not poly or any(poly.degrees()[: field.spare]):
        return None
    return poly


def _certain(relation: Any, difference: Any) -> bool:
    """Whether a relation certainly holds, the difference of its sides being a number or a ball."""
    exact = isinstance(difference, fmpq)
    if isinstance(relation, sp.Ne):
        return bool(difference != 0) if exact else 0 not in difference
    if isinstance(relation, sp.Eq):
        return exact and bool(difference == 0)
    if isinstance(relation, sp.Gt | sp.Ge):
        return bool(difference > 0 or (exact and relation.func is sp.Ge and difference == 0))
    if isinstance(relation, sp.Lt | sp.Le):
        return bool(difference < 0 or (exact and relation.func is sp.Le and difference == 0))
    return False


def _linear_in(formula: sp.Expr) -> tuple[sp.Symbol, sp.Expr] | None:
    """A symbol in which a formula is linear with a number as factor, and its value at zero."""
    for symbol in sorted(formula.free_symbols, key=str):
        factor = sp.diff(formula, symbol)
        if factor.is_Rational and factor != 0:
            return symbol, -formula.xreplace({symbol: sp.S.Zero}) / factor
    return None


def _listed(on: tuple[Any, ...]) -> str:
    from ...printing.formula import text

    return ", ".join(f"{text(c)} = 0" for c in on) or "given by the relations"
