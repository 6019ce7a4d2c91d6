"""The formulas of a level: definitions, conditions, generators and evaluators."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import cached_property

import sympy as sp
from flint import arb, fmpq
from sympy.core.function import AppliedUndef

from flowlanes.errors import InputError
from flowlanes.formulas.jets import Evaluator, GeneratorSwap, Inversion, Jet
from flowlanes.formulas.number_fields import Balls, Rationals
from flowlanes.system.laws import Rate
from flowlanes.system.named_formulas import expand, scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import Symmetric

from ..fields.field import Field, FieldElement


class EmptyLevelSetError(InputError):
    """The conditions of a level have no common real zero on the domain."""


@dataclass(frozen=True)
class LevelFormulas:
    """The conditions of a level and the symbols that they use.

    Parameters
    ----------
    level : tuple of sympy.Expr
        Level: expressions that vanish in addition to the relations.
    equations : tuple of sympy.Expr, optional
        For a component: polynomials in state and parameters that vanish on it; they replace the
        relations and `level`.
    parent : tuple of sympy.Expr, optional
        For a part where an initial of a component vanishes: the equations of the component.
    defining_factors : tuple of sympy.Expr
        The factors that distinguish a component from the others.
    inner : bool
        Whether this part lies in the closure of other components; then motions may leave it, and
        only the parent must be invariant.

    Raises
    ------
    InputError
        If the level is empty, or uses a symbol that the system does not have.
    """

    system: System
    level: tuple[sp.Expr, ...] = ()
    equations: tuple[sp.Expr, ...] | None = None
    parent: tuple[sp.Expr, ...] | None = None
    defining_factors: tuple[sp.Expr, ...] = ()
    inner: bool = False

    @cached_property
    def steps(self) -> dict[sp.Symbol, sp.Expr]:
        """The definitions, and the parameters fixed by the level, by symbol."""
        return {**self._definitions, **self.fixed_parameters}

    @cached_property
    def _definitions(self) -> dict[sp.Symbol, sp.Expr]:
        return dict(self.system.scalar_definitions)

    @cached_property
    def fixed_parameters(self) -> dict[sp.Symbol, sp.Expr]:
        """Parameters determined by conditions on parameters alone, such as k = −1."""
        return self._settlement[0]

    @cached_property
    def _settlement(self) -> tuple[dict[sp.Symbol, sp.Expr], tuple[sp.Expr, ...]]:
        """The fixed parameters and the remaining conditions."""
        parameters = {p.symbol for p in self.system.parameters}
        settled: dict[sp.Symbol, sp.Expr] = {}
        remaining = []
        for condition in self.conditions:
            self._check_symbols(condition)
            formula = expand(condition, {**self._definitions, **settled})
            choice = None
            if formula.free_symbols and formula.free_symbols <= parameters:
                choice = _linear_in(sp.fraction(sp.together(formula))[0])
            if choice is None:
                remaining.append(condition)
            else:
                settled = {p: v.xreplace(dict([choice])) for p, v in settled.items()}
                settled |= dict([choice])
        return settled, tuple(remaining)

    @cached_property
    def swapped_generators(self) -> tuple[GeneratorSwap, ...]:
        """Definitions that replace a parameter as generators."""
        # With D = A + μ as a generator in place of A, expressions in D stay short.
        parameters = {p.symbol for p in self.system.parameters} - set(self.fixed_parameters)
        for condition in self._settlement[1]:
            parameters -= self._reach(condition, set())
        swaps: dict[sp.Symbol, GeneratorSwap] = {}
        for name, raw in self.system.scalar_definitions:
            formula = raw.xreplace(self.fixed_parameters)
            gone = {e.parameter for e in swaps.values()}
            for parameter in sorted(formula.free_symbols & parameters - gone, key=str):
                factor = _number_times(formula, parameter)
                if factor == 0:
                    continue
                remainder = formula.xreplace({parameter: sp.S.Zero})
                if not (gone | {parameter}) & self._reach(remainder, set(swaps)):
                    swaps[name] = GeneratorSwap(name, parameter, factor, remainder)
                    break
        return tuple(swaps.values())

    def _reach(self, formula: sp.Expr, stop: set[sp.Symbol]) -> set[sp.Symbol]:
        """Symbols on which a formula depends, through all definitions but those in `stop`."""
        reached: set[sp.Symbol] = set()
        waiting = set(formula.free_symbols)
        while waiting:
            symbol = waiting.pop()
            reached.add(symbol)
            if symbol in self.steps and symbol not in stop:
                waiting |= self.steps[symbol].free_symbols - reached
        return reached

    @cached_property
    def exchanged_inverses(self) -> tuple[Inversion, ...]:
        """Inverses of full symmetric tensors whose entries replace the entries of the tensor."""
        names = {e.name for e in self.swapped_generators}
        inversions = []
        for name, formula in self.system.definitions:
            if isinstance(name, Symmetric):
                inverse = [t for t in formula.atoms(Symmetric) if formula == t**-1]
                if inverse and set(inverse[0].symbols) <= names:
                    inversions.append(Inversion(tuple(name.symbols), tuple(inverse[0].symbols)))
        return tuple(inversions)

    @cached_property
    def generators(self) -> tuple[sp.Symbol, ...]:
        """Independent symbols: state and parameters, some of them replaced."""
        inverse = {j: a for i in self.exchanged_inverses for a, j in zip(i.name, i.of, strict=True)}
        instead = {e.parameter: inverse.get(e.name, e.name) for e in self.swapped_generators}
        return tuple(instead.get(s, s) for s in self.symbols if s not in self.fixed_parameters)

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """State and parameters."""
        return (*self.system.symbols, *(p.symbol for p in self.system.parameters))

    @cached_property
    def symbols_by_name(self) -> dict[str, sp.Symbol]:
        """State, parameters and definitions by name."""
        return {str(s): s for s in (*self.symbols, *self._definitions)}

    @cached_property
    def conditions(self) -> tuple[sp.Expr, ...]:
        """The relations of the system and the level, or the equations of a component."""
        if self.equations is not None:
            return self.equations
        return tuple(map(self._in_sight, self._written))

    @cached_property
    def _written(self) -> tuple[sp.Expr, ...]:
        """The relations and the level, by components."""
        return (*self.system.scalar.relations, *scalars(self.level))

    def _in_sight(self, condition: sp.Expr) -> sp.Expr:
        """A condition that is a mere name, replaced by its definition."""
        while condition in self._definitions:
            condition = self._definitions[condition]
        return condition

    @cached_property
    def moving(self) -> tuple[sp.Expr, ...]:
        """The conditions that involve the state, in terms of state and parameters."""
        state = set(self.system.symbols)
        conditions = self.parent if self.inner and self.parent else self.conditions
        expanded = (self.expand(c) for c in conditions)
        return tuple(c for c in expanded if c.free_symbols & state)

    @cached_property
    def volume_conditions(self) -> tuple[sp.Expr, ...]:
        """The relations and the level conditions that involve the state, as stated.

        The conditions as stated define the volume on the level, not the equations of a component:
        g F = 0 gives 1/|g| times the volume of F = 0. A condition that vanishes identically for
        the parameters of a component is kept; no volume is defined there.
        """
        state = set(self.system.symbols)
        moving = [c for c in self._written if expand(c, self._definitions).free_symbols & state]
        return tuple(map(self.expand, moving))

    @cached_property
    def zeros(self) -> tuple[sp.Expr, ...]:
        """Values of unspecified functions that vanish by the conditions."""
        return tuple(c for c in self.conditions if isinstance(c, AppliedUndef))

    def expand(self, formula: sp.Expr) -> sp.Expr:
        """A formula with its definitions expanded."""
        return expand(formula, self.steps)

    def without_rates(
        self, formula: sp.Expr, quantities: Mapping[sp.Symbol, sp.Expr] | None = None
    ) -> sp.Expr:
        """A formula with all time derivatives replaced by formulas in the state.

        Parameters
        ----------
        quantities : mapping of Symbol to formula, optional
            Further names whose time derivatives may occur.
        """
        while rates := formula.atoms(Rate):
            innermost = [rate for rate in rates if not rate.args[0].has(Rate)]
            formula = formula.xreplace(
                {rate: self._rate(rate.args[0], quantities or {}) for rate in innermost}
            )
        return formula

    def without_second_rates(
        self, formula: sp.Expr, quantities: Mapping[sp.Symbol, sp.Expr]
    ) -> sp.Expr:
        """A formula without nested time derivatives."""
        deep = {rate for rate in formula.atoms(Rate) if rate.args[0].has(Rate)}
        outermost = {r for r in deep if not any(r in o.args[0].atoms(Rate) for o in deep - {r})}
        return formula.xreplace(
            {r: Rate(self.without_rates(r.args[0], quantities)) for r in outermost}
        )

    def _rate(self, formula: sp.Expr, quantities: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
        formula = self.expand(expand(formula, quantities))
        rates = zip(self.system.symbols, self.system.rates, strict=True)
        return sp.Add(*(sp.diff(formula, s) * rate for s, rate in rates))

    def _check_symbols(self, condition: sp.Expr) -> None:
        unknown = condition.free_symbols - set(self.symbols) - set(self._definitions)
        if unknown:
            raise InputError(
                f"{self.system.name}: the level {condition} = 0 uses "
                f"{', '.join(sorted(map(str, unknown)))}, which is neither a state variable, a "
                "definition nor a parameter"
            )

    def _empty(self) -> EmptyLevelSetError:
        return EmptyLevelSetError(
            f"{self.system.name}: the level {conditions_text(self.level)} is empty; its conditions "
            "contradict each other or the phase space"
        )

    # --- evaluation --------------------------------------------------------------------------

    def numbers(
        self, values: Mapping[str, sp.Rational | fmpq | arb | float], exact: bool
    ) -> Rationals | Balls:
        """The field of numbers at a point."""
        return Rationals(values) if exact else Balls(values)

    def evaluator(self, field: Field) -> Evaluator:
        """Evaluator of values."""
        seed = self._seeds(field, set(self.generators) - set(self.steps))
        return Evaluator(
            field, seed, self.steps, self.swapped_generators, self.zeros, self.exchanged_inverses
        )

    @staticmethod
    def _seeds(field: Field, own: Collection[sp.Symbol]) -> Callable[[sp.Symbol], Jet | None]:
        def seed(symbol: sp.Symbol) -> Jet | None:
            return Jet(field.generator(str(symbol)), {}) if symbol in own else None

        return seed

    def along(self, field: Field) -> Evaluator:
        """Evaluator of values and time derivatives along the vector field of the system."""
        plain = self.evaluator(field)
        rates = dict(zip(self.system.symbols, self.system.rates, strict=True))
        return self._with_slopes(plain, lambda symbol: {-1: plain.value(rates[symbol])}, True)

    def along_field(self, field: Field, components: Mapping[sp.Symbol, sp.Expr]) -> Evaluator:
        """Evaluator of values and derivatives along a vector field given by its components."""
        plain = self.evaluator(field)

        def slopes(symbol: sp.Symbol) -> dict[int, FieldElement]:
            component = sp.sympify(components.get(symbol, 0))
            return {} if component == 0 else {-1: plain.value(component)}

        return self._with_slopes(plain, slopes)

    def partial(self, field: Field) -> Evaluator:
        """Evaluator of values and partial derivatives by the state variables, by index."""
        number = {s: i for i, s in enumerate(self.system.symbols)}
        return self._with_slopes(self.evaluator(field), lambda s: {number[s]: field.one})

    def _with_slopes(
        self,
        plain: Evaluator,
        slopes: Callable[[sp.Symbol], dict[int, FieldElement]],
        moving: bool = False,
    ) -> Evaluator:
        """Evaluator of values and derivatives that follow from those of the state variables."""
        state = set(self.system.symbols)

        def seed(symbol: sp.Symbol) -> Jet | None:
            known = plain.seed(symbol)
            if known is None or symbol not in state:
                return known
            return Jet(known.value, slopes(symbol))

        more = (self.steps, self.swapped_generators, self.zeros, self.exchanged_inverses, moving)
        return Evaluator(plain.field, seed, *more)


def _number_times(formula: sp.Expr, parameter: sp.Symbol) -> sp.Rational:
    """The rational coefficient c of a formula c · parameter + terms without it; 0 if none."""
    for term in sp.Add.make_args(formula):
        number, rest = term.as_coeff_Mul()
        if rest == parameter and number.is_Rational:
            return sp.S.Zero if parameter in (formula - term).free_symbols else number
    return sp.S.Zero


def _linear_in(formula: sp.Expr) -> tuple[sp.Symbol, sp.Expr] | None:
    """A symbol with a rational coefficient in a linear formula, and its solution; or None."""
    for symbol in sorted(formula.free_symbols, key=str):
        factor = sp.diff(formula, symbol)
        if factor.is_Rational and factor != 0:
            return symbol, -formula.xreplace({symbol: sp.S.Zero}) / factor
    return None


def assumed_relations(symbol: sp.Symbol) -> list[sp.Basic]:
    """The sign assumptions of a symbol as relations, strongest first."""
    return [
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


def conditions_text(on: tuple[sp.Expr, ...]) -> str:
    """Text of the conditions of a level as equations."""
    from flowlanes.printing.formula import text

    return ", ".join(f"{text(c)} = 0" for c in on) or "given by the relations"
