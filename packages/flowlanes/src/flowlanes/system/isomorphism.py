"""Isomorphisms: laws that speak of two systems."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import sympy as sp

from ..arguments import NamedFormulas, arguments_checked
from ..errors import InputError
from .laws import BasicLaw, Power, VectorField
from .named_formulas import Pairs, expand, repeated_name, scalar_names
from .system import System


@arguments_checked
@dataclass(frozen=True, repr=False)
class Isomorphism(BasicLaw):
    """A change of variables and time that carries the field onto another system's.

    A level is where the conditions of this system hold (its relations and `level`) and all
    `constants` that depend on the state have fixed values.  On almost all of every level the map
    is a local diffeomorphism onto the phase space of the target, which is cut out by the relations
    of the target and by `onto`: its differential is injective, and both have one dimension.
    dτ/dt is real and positive, and the parameters of the target are admissible; where they are
    not, nothing is said.

    Parameters
    ----------
    name : str
    target : System
    map : mapping or pairs of target state name to formula
        The new variables, as functions on the phase space of this system.
    time : sympy.Expr
        dτ/dt, for the time τ of the target.
    constants : mapping or pairs of target parameter to formula
        Values of the target's parameters: functions of the parameters, or integrals of this
        system (their constancy is proved too).  Parameters that are not named
        keep their symbol, which must be that of a parameter of this system.
    onto : tuple of sympy.Expr
        Formulas in the state and the parameters of the target that vanish where the map leads;
        empty if it leads to all of its phase space.  A symbol that the target does not have is a
        parameter of this system, or a definition that does not depend on the state.
    meaning : str

    Raises
    ------
    InputError
        If `map` or `constants` name something that the target does not have.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> slow = flowlanes.System("slow", "Slow oscillator", {x: v, v: -x})
    >>> fast = flowlanes.System("fast", "Fast oscillator", {x: v, v: -4 * x})
    >>> slowed = flowlanes.Isomorphism("slowed", slow, {x: x, v: v / 2}, time=2)
    >>> slowed.target.name, [value for _, value in slowed.map]
    ('slow', [x, v/2])
    """

    included: ClassVar[str] = "carried onto the target"

    target: System
    map: NamedFormulas
    time: sp.Expr = sp.S.One
    constants: NamedFormulas = ()
    meaning: str = ""
    onto: tuple[sp.Expr, ...] = ()

    @property
    def heading(self) -> str:
        """The title of the target."""
        return f"The same motion as: {self.target.title}"

    @property
    def formulas(self) -> tuple[sp.Basic, ...]:
        """The map, the constants and the time."""
        named = [value for _, value in (*self.map, *self.constants)]
        return tuple(map(sp.sympify, (*named, self.time, *self.level)))

    @property
    def powers(self) -> tuple[Power, ...]:
        """The rate of the new time, which must be positive."""
        return (("dτ/dt", self.time, sp.S.Half),)

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """Target, map, time and constants, and the image without definitions of the source."""
        target, scalar = self.target, self.scalar
        theirs = {*target.symbols, *target.defaults, *(s for s, _ in target.scalar_definitions)}
        steps = {s: value for s, value in system.scalar_definitions if s not in theirs}
        return {
            "target": target,
            "map": scalar.map,
            "time": scalar.time,
            "constants": scalar.constants,
            "onto": tuple(expand(condition, steps) for condition in scalar.onto),
        }

    def __post_init__(self) -> None:
        super().__post_init__()
        parameters = [p.symbol for p in self.target.parameters]
        self._must_be_among("map", self.map, self.target.symbols, "state variable")
        self._must_be_among("constants", self.constants, parameters, "parameter")

    def _must_be_among(
        self, part: str, pairs: Pairs, symbols: Iterable[sp.Symbol], kind: str
    ) -> None:
        named = scalar_names(pairs)
        if strange := sorted(map(str, set(named) - set(symbols))):
            raise InputError(
                f"the law {self.name!r}: its {part} names {', '.join(strange)}, which is no {kind} "
                f"of {self.target.name}"
            )
        if twice := repeated_name(named):
            raise InputError(f"the law {self.name!r}: its {part} names {twice} twice")


def with_any_parameters(system: System) -> System:
    """A system as equations alone, whatever its parameters: a target without a body behind it."""
    free = tuple(replace(p, admissible=()) for p in system.parameters)
    return replace(system, parameters=free)
