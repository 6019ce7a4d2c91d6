"""What a law stands on: the phase space of a system, cut down to a level, made triangular."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, TypeVar

import sympy as sp
from flint import arb, fmpq, fmpq_poly
from sympy.core.function import AppliedUndef

from ..errors import InputError
from ..system import System
from ..vectors import explicit
from .algebra import Budget, Element, Fractions
from .errors import NotExactError, OutOfReachError
from .jets import Evaluator, Exchange, Jet
from .numbers import Balls, Rationals, exact_root

__all__ = ["Ground"]

Poly = Any
Kind = TypeVar("Kind", bound=Fractions)
Terms = dict[tuple[int, ...], Any]


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
    def generators(self) -> tuple[sp.Symbol, ...]:
        """Independent symbols: state and parameters, some of them exchanged."""
        instead = {e.parameter: e.name for e in self.exchanged}
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
    def forced(self) -> tuple[str, ...]:
        """Unspecified functions whose value the conditions say is zero."""
        return tuple(type(c).__name__ for c in self.conditions if isinstance(c, AppliedUndef))

    def expanded(self, formula: sp.Expr) -> sp.Expr:
        """A formula in which the definitions are written out."""
        while formula.free_symbols & set(self.steps):
            formula = formula.xreplace(self.steps)
        return formula

    # --- the triangular set ----------------------------------------------------------------

    @cached_property
    def _triangle(
        self,
    ) -> tuple[tuple[str, ...], tuple[tuple[str, dict[tuple[Any, ...], Any]], ...]]:
        """Names in order, highest first, and the relations from the lowest to the highest.

        A relation is kept as a mapping of named exponents to coefficients, since the ring in
        which it is used orders the variables otherwise.
        """
        names = [str(s) for s in self.generators]
        draft = Fractions(names)
        evaluate = self.evaluator(draft)
        waiting = []
        for condition in self._settlement[1]:
            if isinstance(condition, AppliedUndef):
                continue
            waiting.append(_numerator(evaluate.value(condition), condition))
        chain: list[tuple[str, Poly]] = []
        moving = {str(s) for s in self.system.symbols}
        while waiting:
            for main, relation in reversed(chain):
                waiting = [draft.pseudo_remainder(g, relation, main) for g in waiting]
            waiting = [g for g in waiting if g]
            for g in waiting:
                if g.is_constant():
                    raise InputError(
                        f"{self.system.name}: the level {_listed(self.on)} is empty; its "
                        "conditions contradict each other or the phase space"
                    )
            best = min(
                (
                    (_merit(draft, g, v, moving), i, v)
                    for i, g in enumerate(waiting)
                    for v in names
                    if _possible(draft, g, v, chain)
                ),
                default=None,
            )
            if waiting and best is None:
                raise OutOfReachError("the conditions of the level cannot be made triangular")
            if best is not None:
                _, index, main = best
                chain.append((main, waiting.pop(index)))
        ordered = _sorted(draft, chain)
        mains = [main for main, _ in ordered]
        order = (*reversed(mains), *(n for n in names if n not in mains))
        kept = tuple(
            (
                main,
                {
                    tuple(zip(draft.names, map(int, e), strict=True)): c
                    for e, c in poly.to_dict().items()
                },
            )
            for main, poly in ordered
        )
        return order, kept

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
        names, chain = self._triangle
        field = kind(names, spare, sample, budget)
        for main, terms in chain:
            made = {}
            for named, number in terms.items():
                powers = dict(named)
                made[tuple(powers.get(n, 0) for n in field.names)] = number
            field.impose(main, field.ring.from_dict(made))
        for name in self.forced:
            field.nothing(name)
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
        names, chain = self._triangle
        mains = {main for main, _ in chain}
        values: dict[str, Any] = {}
        for main, terms in chain:
            values |= _sphere(main, terms, mains - {main}, generator) or {}
        defaults = {str(p.symbol): p.default for p in self.system.parameters}
        exchanged = {str(e.name) for e in self.exchanged}
        involved = {n for _, terms in chain for named in terms for n, power in named if power}
        for name in names:
            if name in mains or name in values:
                continue
            if name not in exchanged:
                values[name] = _chosen(defaults.get(name), generator)
            elif name in involved:
                values[name] = fmpq(generator.randint(20, 40), 20)
        exact = True
        for main, terms in chain:
            if main not in values:
                values[main] = _solved(main, terms, values, generator)
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
                given[change.parameter] = _chosen(defaults[str(change.parameter)], generator)
        names = [e.name for e in self.exchanged if e.name not in given]
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

    def point_shown(self, field: Any) -> dict[str, str]:
        """State and parameters at a point, for a reader."""
        evaluate = self.evaluator(field)
        return {str(s): _shown(evaluate.value(s)) for s in self.symbols}

    def numbers(self, values: Mapping[str, Any], exact: bool) -> Rationals | Balls:
        """The field of numbers at a point."""
        made = Rationals(values) if exact else Balls(values)
        made.forced = self.forced
        return made

    # --- evaluation ------------------------------------------------------------------------

    def evaluator(self, field: Any) -> Evaluator:
        """Values alone."""
        own = set(self.generators) - set(self.steps)

        def seed(symbol: sp.Symbol) -> Jet | None:
            return Jet(field.generator(str(symbol)), {}) if symbol in own else None

        return Evaluator(field, seed, self.steps, self.exchanged)

    def along(self, field: Any) -> Evaluator:
        """Values with their time derivatives along the field of the system."""
        plain = self.evaluator(field)
        rates = dict(zip(self.system.symbols, self.system.rates, strict=True))

        def seed(symbol: sp.Symbol) -> Jet | None:
            known = plain.seed(symbol)
            if known is None or symbol not in rates:
                return known
            return Jet(known.value, {-1: plain.value(rates[symbol])})

        return Evaluator(field, seed, self.steps, self.exchanged)

    def partial(self, field: Any) -> Evaluator:
        """Values with their partial derivatives by the state variables, numbered."""
        plain = self.evaluator(field)
        number = {s: i for i, s in enumerate(self.system.symbols)}

        def seed(symbol: sp.Symbol) -> Jet | None:
            known = plain.seed(symbol)
            if known is None or symbol not in number:
                return known
            return Jet(known.value, {number[symbol]: field.one})

        return Evaluator(field, seed, self.steps, self.exchanged)


def _linear_in(formula: sp.Expr) -> tuple[sp.Symbol, sp.Expr] | None:
    """A symbol in which a formula is linear with a number as factor, and its value at zero."""
    for symbol in sorted(formula.free_symbols, key=str):
        factor = sp.diff(formula, symbol)
        if factor.is_Rational and factor != 0:
            return symbol, -formula.xreplace({symbol: sp.S.Zero}) / factor
    return None


def _listed(on: tuple[Any, ...]) -> str:
    return ", ".join(f"{c} = 0" for c in on) or "given by the relations"


def _numerator(element: Element, condition: Any) -> Poly:
    """The polynomial whose vanishing a condition states."""
    poly = element.poly
    for number, power in element.powers.items():
        for _ in range(max(power, 0)):
            poly = poly * element.home.factors[number]
    highest = poly.degrees()[: element.home.spare] if poly else ()
    if any(highest):
        raise OutOfReachError(
            f"the condition {condition} = 0 contains a root or a function; state it as a polynomial"
        )
    return poly


def _variables(draft: Fractions, poly: Poly) -> set[str]:
    return {n for n, d in zip(draft.names, poly.degrees(), strict=True) if d}


def _merit(draft: Fractions, poly: Poly, name: str, moving: set[str]) -> tuple[int, int, int]:
    """How well a variable serves as the main one of a relation; smaller is better."""
    position = draft.names.index(name)
    degree = int(poly.degrees()[position])
    lead = draft.coefficient(poly, position, degree)
    if lead.is_constant():
        kind = 0 if degree == 1 else degree - 1
    else:
        # a coefficient of parameters alone vanishes for special bodies, one of the state anywhere
        kind = 10 * degree + (len(lead) > 1) + 4 * bool(_variables(draft, lead) & moving)
    return kind, len(lead), -position


def _possible(draft: Fractions, poly: Poly, name: str, chain: list[tuple[str, Poly]]) -> bool:
    """Whether the variable can be the main one: in the relation, free, and without a circle."""
    if name in {main for main, _ in chain} or name not in _variables(draft, poly):
        return False
    try:
        _sorted(draft, [*chain, (name, poly)])
    except OutOfReachError:
        return False
    return True


def _sorted(draft: Fractions, chain: list[tuple[str, Poly]]) -> list[tuple[str, Poly]]:
    """The relations from the lowest main variable to the highest."""
    mains = {main for main, _ in chain}
    needs = {main: (_variables(draft, poly) & mains) - {main} for main, poly in chain}
    done: list[str] = []
    while len(done) < len(chain):
        ready = [m for m in needs if m not in done and needs[m] <= set(done)]
        if not ready:
            raise OutOfReachError("the conditions of the level cannot be made triangular")
        done.extend(ready)
    polys = dict(chain)
    return [(main, polys[main]) for main in done]


def _chosen(default: float | None, generator: random.Random) -> fmpq:
    """A random rational number, near the default of a parameter."""
    if default is None or default == 0:
        reach = generator.choice([17, 17, 60])
        return fmpq(
            generator.choice([-1, 1]) * generator.randint(3, reach), generator.randint(11, 19)
        )
    near = Fraction(repr(float(default))) * Fraction(generator.randint(90, 115), 100)
    return fmpq(near.numerator, near.denominator)


def _sphere(
    main: str, terms: Mapping[Any, Any], taken: set[str], generator: random.Random
) -> dict[str, Any] | None:
    """A rational point of x² + y² + … = c, if the relation is one and c is a square."""
    members, constant, scale = [], fmpq(0), None
    for named, number in terms.items():
        present = [(n, p) for n, p in named if p]
        if not present:
            constant = number
        elif len(present) == 1 and present[0][1] == 2 and scale in (None, number):
            members.append(present[0][0])
            scale = number
        else:
            return None
    if scale is None or len(members) < 2 or taken & set(members):
        return None
    try:
        radius = exact_root(-constant / scale, 2)
    except NotExactError:
        return None
    shares = [fmpq(generator.randint(-9, 9), generator.randint(7, 13)) for _ in members[1:]]
    square = sum((s * s for s in shares), fmpq(0))
    point = [2 * s / (1 + square) for s in shares] + [(square - 1) / (1 + square)]
    if any(x == 0 for x in point):
        raise ZeroDivisionError
    return {n: radius * x for n, x in zip(sorted(members), point, strict=True)}


def _solved(
    main: str, terms: Mapping[Any, Any], values: Mapping[str, Any], generator: random.Random
) -> Any:
    """A real value of the main variable, the others being given."""
    coefficients: dict[int, Any] = {}
    for named, number in terms.items():
        total: Any = number
        degree = 0
        for name, power in named:
            if name == main:
                degree = power
            elif power:
                total = values[name] ** power * total
        coefficients[degree] = coefficients.get(degree, fmpq(0)) + total
    top = max(coefficients)
    c = [coefficients.get(i, fmpq(0)) for i in range(top + 1)]
    if top == 1:
        return _divided(-c[0], c[1])
    if top == 2:
        square = c[1] * c[1] - 4 * c[0] * c[2]
        if not square > 0:
            raise ZeroDivisionError
        sign = generator.choice([-1, 1])
        try:
            if not isinstance(square, fmpq):
                raise NotExactError
            root: Any = exact_root(square, 2)
        except NotExactError:
            root = arb(square).sqrt()
        return _divided(sign * root - c[1], 2 * c[2])
    if all(isinstance(x, fmpq) for x in c):
        roots: Any = fmpq_poly(c).complex_roots()
        real = [z.real for z, _ in roots if z.imag == 0]
        if real:
            return generator.choice(real)
    raise ZeroDivisionError


def _shown(value: Any) -> str:
    return str(value) if isinstance(value, fmpq) else str(value.str(20))


def _divided(above: Any, below: Any) -> Any:
    if below == 0 or (not isinstance(below, fmpq) and 0 in below):
        raise ZeroDivisionError
    return above / below
