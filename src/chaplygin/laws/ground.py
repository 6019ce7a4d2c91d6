"""What a law stands on: the phase space of a system, cut down to a level, made triangular."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeVar

import sympy as sp
from flint import fmpq
from sympy.core.function import AppliedUndef

from ..errors import InputError
from ..system import System
from ..vectors import Symmetric, explicit
from .budget import Budget
from .errors import EmptyLevelError, NotExactError, OutOfReachError
from .functions import Fractions
from .jets import Evaluator, Exchange, Inversion, Jet
from .numbers import Balls, Rationals
from .points import near, on_sphere, shown, solved
from .triangular import Triangle, numerator, triangle

__all__ = ["Ground"]

Kind = TypeVar("Kind", bound=Fractions)


@dataclass(frozen=True)
class Ground:
    """The points at which a law is claimed.

    Parameters
    ----------
    system : System
    on : tuple of sympy.Expr
        The level: further expressions that vanish.

    Raises
    ------
    InputError
        If the level is empty, or uses a symbol that the system does not have.
    """

    system: System
    on: tuple[Any, ...] = ()

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
    def exchanged(self) -> tuple[Exchange, ...]:
        """Definitions that take the place of a parameter as generators."""
        parameters = {p.symbol for p in self.system.parameters} - set(self.settled)
        for condition in self._settlement[1]:
            parameters -= self._reach(condition, set())
        found: dict[sp.Symbol, Exchange] = {}
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
                    found[name] = Exchange(name, parameter, factor, rest)
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
    def conditions(self) -> tuple[sp.Expr, ...]:
        """What vanishes: relations of the system and the level."""
        return tuple(explicit(c) for c in (*self.system.relations, *self.on))

    @cached_property
    def moving(self) -> tuple[sp.Expr, ...]:
        """The conditions that involve the state, in terms of state and parameters alone."""
        state = set(self.system.symbols)
        expanded = (self.expanded(c) for c in self.conditions)
        return tuple(c for c in expanded if c.free_symbols & state)

    @cached_property
    def zeros(self) -> tuple[sp.Expr, ...]:
        """Values of unspecified functions that the conditions say are zero."""
        return tuple(c for c in self.conditions if isinstance(c, AppliedUndef))

    def expanded(self, formula: sp.Expr) -> sp.Expr:
        """A formula in which the definitions are written out."""
        while formula.free_symbols & set(self.steps):
            formula = formula.xreplace(self.steps)
        return formula

    # --- the triangular set ----------------------------------------------------------------

    @cached_property
    def _triangle(self) -> Triangle:
        draft = Fractions([str(s) for s in self.generators])
        evaluate = self.evaluator(draft)
        conditions = [
            numerator(draft, evaluate.value(condition), condition)
            for condition in self._settlement[1]
            if condition not in self.zeros
        ]
        names = [str(s) for s in self.generators]
        moving = {str(s) for s in self.system.symbols}
        try:
            return triangle(draft, names, conditions, moving)
        except EmptyLevelError:
            raise InputError(
                f"{self.system.name}: the level {_listed(self.on)} is empty; its conditions "
                "contradict each other or the phase space"
            ) from None

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
        kind: Callable[[Sequence[str], int, Mapping[str, float], Budget], Kind],
        spare: int,
        sample: Mapping[str, float],
        budget: Budget,
    ) -> Kind:
        """The field of fractions modulo the conditions, of the class given."""
        field = kind(self._triangle.order, spare, sample, budget)
        for main, terms in self._triangle.relations:
            made = {}
            for named, number in terms.items():
                powers = dict(named)
                made[tuple(powers.get(n, 0) for n in field.names)] = number
            field.impose(main, field.ring.from_dict(made))
        return field

    # --- points ----------------------------------------------------------------------------

    def point(self, generator: random.Random) -> tuple[dict[str, Any], bool]:
        """A random point that satisfies the conditions, and whether it is exactly rational.

        Raises
        ------
        OutOfReachError
            If none was found.
        """
        for _ in range(60):
            try:
                return self._try_point(generator)
            except ZeroDivisionError:
                continue
        raise OutOfReachError(f"no real point was found on the level {_listed(self.on)}")

    def _try_point(self, generator: random.Random) -> tuple[dict[str, Any], bool]:
        names, chain = self._triangle.order, self._triangle.relations
        mains = {main for main, _ in chain}
        values: dict[str, Any] = {}
        for main, terms in chain:
            values |= on_sphere(main, terms, mains - {main}, generator) or {}
        defaults = {str(p.symbol): p.default for p in self.system.parameters}
        exchanged = {str(s) for s in self.generators if s in self._definitions}
        involved = {n for _, terms in chain for named in terms for n, power in named if power}
        for name in names:
            if name in mains or name in values:
                continue
            if name not in exchanged:
                values[name] = near(defaults.get(name), generator)
            elif name in involved:
                values[name] = fmpq(generator.randint(20, 40), 20)
        exact = True
        for main, terms in chain:
            if main not in values:
                values[main] = solved(main, terms, values, generator)
                exact = exact and isinstance(values[main], fmpq)
        return self._with_exchanged(values, generator, exact)

    def _with_exchanged(
        self, values: dict[str, Any], generator: random.Random, exact: bool
    ) -> tuple[dict[str, Any], bool]:
        """The point with its exchanged definitions, whose parameters stay near their defaults."""
        defaults = {str(p.symbol): p.default for p in self.system.parameters}
        known = {str(s): s for s in (*self.generators, *(e.parameter for e in self.exchanged))}
        given = {known[name]: value for name, value in values.items()}
        for change in self.exchanged:
            if change.name not in given:
                given[change.parameter] = near(defaults[str(change.parameter)], generator)
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
            return {**values, **found}, rational
        raise ZeroDivisionError

    def inside(self, values: Mapping[str, Any], exact: bool) -> bool:
        """Whether a point lies in the domain of the system, as far as its guards tell."""
        for rational in (True, False) if exact else (False,):
            field = self.numbers(values, rational)
            evaluate = self.evaluator(field)
            try:
                return all(
                    evaluate.value(explicit(guard.value)) > 0
                    for guard in self.system.guards
                    if not guard.lift_off
                )
            except NotExactError:
                continue
            except (ZeroDivisionError, OutOfReachError):
                return False
        return False

    def point_shown(self, field: Any) -> dict[str, str]:
        """State and parameters at a point, for a reader."""
        evaluate = self.evaluator(field)
        return {str(s): shown(evaluate.value(s)) for s in self.symbols}

    def numbers(self, values: Mapping[str, Any], exact: bool) -> Rationals | Balls:
        """The field of numbers at a point."""
        return Rationals(values) if exact else Balls(values)

    # --- evaluation ------------------------------------------------------------------------

    def evaluator(self, field: Any) -> Evaluator:
        """Values alone."""
        own = set(self.generators) - set(self.steps)

        def seed(symbol: sp.Symbol) -> Jet | None:
            return Jet(field.generator(str(symbol)), {}) if symbol in own else None

        return Evaluator(field, seed, self.steps, self.exchanged, self.zeros, self.inverted)

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


def _linear_in(formula: sp.Expr) -> tuple[sp.Symbol, sp.Expr] | None:
    """A symbol in which a formula is linear with a number as factor, and its value at zero."""
    for symbol in sorted(formula.free_symbols, key=str):
        factor = sp.diff(formula, symbol)
        if factor.is_Rational and factor != 0:
            return symbol, -formula.xreplace({symbol: sp.S.Zero}) / factor
    return None


def _listed(on: tuple[Any, ...]) -> str:
    from ..notation import text

    return ", ".join(f"{text(c)} = 0" for c in on) or "given by the relations"
