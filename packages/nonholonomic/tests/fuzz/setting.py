"""Levels whose real points are known, with formulas that vanish on them or do not."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from flowlanes.system.system import Parameter
from fuzz.case import Point

__all__ = ["Claim", "Setting", "SettingFamily", "no", "yes"]


@dataclass(frozen=True)
class Claim:
    """That a formula vanishes on a level.

    Parameters
    ----------
    formula : sympy.Expr
    holds : bool
    why : str
    fails_at : mapping of Symbol to number, optional
        A point of the level where the formula does not vanish.
    """

    formula: sp.Expr
    holds: bool
    why: str
    fails_at: Point | None = None


def yes(formula: Any, why: str) -> Claim:
    """A formula that vanishes on the whole level."""
    return Claim(sp.sympify(formula), True, why)


def no(formula: Any, why: str, fails_at: Point | None = None) -> Claim:
    """A formula that does not vanish somewhere on the level."""
    return Claim(sp.sympify(formula), False, why, fails_at)


@dataclass(frozen=True)
class Setting:
    """A level, and claims about it.

    Parameters
    ----------
    variables : tuple of Symbol
        State variables that occur.
    claims : tuple of Claim
    conditions : tuple of sympy.Expr
        They vanish on the level.
    parameters : tuple of Parameter
    guards : tuple of sympy.Expr
        They are positive.
    regular : bool
        Whether the differentials of the conditions are independent almost everywhere on the
        level, so that it carries a volume.
    refusable : bool
        Whether an InputError is as good an answer as the truth.
    """

    variables: tuple[sp.Symbol, ...]
    claims: tuple[Claim, ...]
    conditions: tuple[sp.Expr, ...] = ()
    parameters: tuple[Parameter, ...] = ()
    guards: tuple[sp.Expr, ...] = ()
    regular: bool = True
    refusable: bool = False

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """State and parameters."""
        return (*self.variables, *(p.symbol for p in self.parameters))

    @property
    def formulas(self) -> tuple[sp.Expr, ...]:
        """All formulas but those of the parameters."""
        return (*self.conditions, *self.guards, *(c.formula for c in self.claims))

    def one(self, rng: random.Random) -> Setting:
        """With one of its claims, as often a true one as a false one."""
        wanted = rng.random() < 0.5
        chosen = [c for c in self.claims if c.holds is wanted] or self.claims
        return replace(self, claims=(rng.choice(chosen),))

    def renamed(self, names: dict[sp.Symbol, sp.Symbol]) -> Setting:
        """With other symbols for state and parameters."""
        return self._changed(
            lambda f: f.xreplace(names),
            lambda at: {names.get(s, s): v for s, v in at.items()},
            tuple(names.get(s, s) for s in self.variables),
            tuple(
                replace(
                    p,
                    symbol=names.get(p.symbol, p.symbol),
                    admissible=tuple(c.xreplace(names) for c in p.admissible),
                )
                for p in self.parameters
            ),
        )

    def scaled(self, units: dict[sp.Symbol, sp.Rational]) -> Setting:
        """With each symbol s replaced by unit · s: the same things told in other units."""
        change = {s: unit * s for s, unit in units.items()}
        return self._changed(
            lambda f: f.xreplace(change),
            lambda at: {s: v / units.get(s, 1) for s, v in at.items()},
            self.variables,
            tuple(
                replace(
                    p,
                    default=float(sp.Rational(repr(p.default)) / units.get(p.symbol, 1)),
                    admissible=tuple(c.xreplace(change) for c in p.admissible),
                )
                for p in self.parameters
            ),
        )

    def _changed(
        self,
        formula: Callable[[Any], Any],
        point: Callable[[Point], Point],
        variables: tuple[sp.Symbol, ...],
        parameters: tuple[Parameter, ...],
    ) -> Setting:
        return replace(
            self,
            variables=variables,
            parameters=parameters,
            conditions=tuple(map(formula, self.conditions)),
            guards=tuple(map(formula, self.guards)),
            claims=tuple(
                replace(
                    c,
                    formula=formula(c.formula),
                    fails_at=None if c.fails_at is None else point(c.fails_at),
                )
                for c in self.claims
            ),
        )


SettingFamily = Callable[[random.Random], Setting]
