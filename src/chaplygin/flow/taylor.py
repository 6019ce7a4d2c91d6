"""A System compiled for Taylor integration by heyoka."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Literal

import heyoka as hy
import numpy as np
import sympy as sp

from ..core.system import System
from ..core.vectors import to_components
from ..errors import InputError
from .heyoka_expressions import Translator, WorkingNumber
from .kernel import code_cache as cache
from .projection import Block

Precision = Literal["double", "quad"]
Direction = Literal["forward", "backward"]

# warnings of heyoka bypass Python on their way to the terminal; errors say the same here
hy.set_logger_level_error()

#: Tolerances finer than this are beyond the working precision.
FINEST = {"double": np.finfo(float).eps, "quad": 2e-34}


@dataclass(frozen=True)
class CompiledSystem:
    """Native code for one system at one tolerance and precision.

    Parameters of the system are run-time values; the code is shared by all of them.

    Attributes
    ----------
    integrator : heyoka.taylor_adaptive
        State of the core, then of the motion; a terminal event for each of `watched`.  After the
        parameters of the system come positive factors of these events.
    outputs : heyoka.cfunc
        Observables, laws and guards at a state.
    core, lift, laws : tuple of Block
        The relations of the reduced state, of its lift to space, and the integrals; at most one
        block each.
    variable_guards : tuple of int
        Guards that can change during a motion; others are the same in every state.
    from_cache : bool
        Whether the code came from the cache.
    """

    integrator: hy.taylor_adaptive
    outputs: hy.cfunc
    core: tuple[Block, ...]
    lift: tuple[Block, ...]
    laws: tuple[Block, ...]
    variable_guards: tuple[int, ...]
    from_cache: bool = False


def number_type(precision: Precision) -> type[WorkingNumber]:
    """The type of numbers of a precision: float, or 34 digits.

    Raises
    ------
    InputError
        If this machine's heyoka has no 34-digit numbers.
    """
    if precision == "double":
        return float
    wide: type[WorkingNumber] | None = getattr(hy, "real128", None)
    if wide is None:
        raise InputError("precision 'quad' is not available on this machine; use 'double'")
    return wide


@dataclass(frozen=True)
class _Plan:
    """A system to be compiled, and the name of its code in the cache."""

    system: System
    tolerance: float
    precision: Precision
    direction: Direction

    @cached_property
    def system_in_space(self) -> System:
        return self.system.lifted() if self.system.reconstruction else self.system

    @cached_property
    def name(self) -> str:
        system = self.system_in_space
        # each part in a list of its own: an observable is compiled otherwise than a guard
        shape = [
            self.system.symbols,
            self.system.relations,
            system.symbols,
            [p.symbol for p in system.parameters],
            [item for step in system.scalar_definitions for item in step],
            system.rates,
            system.relations,
            [law.value for law in system.integrals],
            [observable.value for observable in system.observables],
            [guard.value for guard in system.guards],
        ]
        # srepr keeps every digit of a decimal number, which str does not
        formulas = (sp.srepr([to_components(item) for item in part]) for part in shape)
        return cache.code_name(*formulas, repr(self.tolerance), self.precision, self.direction)

    def compile(self) -> CompiledSystem:
        system, kind = self.system_in_space, number_type(self.precision)
        translate = Translator(system)
        variables = translate.variables
        # heyoka looks at the derivative in time, whichever way it runs
        falling = {
            "forward": hy.event_direction.negative,
            "backward": hy.event_direction.positive,
        }[self.direction]
        guards = translate.all([guard.value for guard in system.guards])
        watched = tuple(i for i, guard in enumerate(guards) if hy.get_variables(guard))
        # heyoka chooses its steps by events as well as by the state: a guard that is large beside
        # the state would lengthen them, and is therefore divided by its size at the start
        first = len(system.parameters)
        events = [
            hy_event(kind)(guards[i] * hy.par[first + place], direction=falling)
            for place, i in enumerate(watched)
        ]
        integrator = hy.taylor_adaptive(
            list(zip(variables, translate.all(system.rates), strict=True)),
            [kind(1)] * len(variables),
            tol=kind(max(self.tolerance, FINEST[self.precision])),
            fp_type=kind,
            t_events=events,
            compact_mode=True,
        )
        recorded = [
            *(observable.value for observable in system.observables),
            *(law.value for law in system.integrals),
            *(guard.value for guard in system.guards),
        ]
        # a constant makes the list non-empty
        outputs = hy.cfunc([*translate.all(recorded), variables[0]], variables, fp_type=kind)
        size = len(self.system.symbols)
        core = list(self.system.relations)
        lift = list(self.system.reconstruction.relations) if self.system.reconstruction else []
        laws = [law.value for law in system.integrals]
        constrain = _constraints(translate)
        return CompiledSystem(
            integrator,
            outputs,
            constrain(core, slice(0, size), kind),
            constrain(lift, slice(size, None), kind),
            constrain(laws, slice(0, size), kind),
            watched,
        )


def hy_event(kind: type[WorkingNumber]) -> Callable[..., hy.t_event]:
    """The constructor of terminal events for numbers of a type."""
    if kind is float:
        result: Callable[..., hy.t_event] = hy.t_event
        return result

    def constructor(expression: hy.expression, direction: hy.event_direction) -> hy.t_event:
        return hy.t_event(expression, direction=direction, fp_type=kind)

    return constructor


def _constraints(
    translate: Translator,
) -> Callable[[Sequence[sp.Expr], slice, type[WorkingNumber]], tuple[Block, ...]]:
    def build(
        relations: Sequence[sp.Expr], columns: slice, kind: type[WorkingNumber]
    ) -> tuple[Block, ...]:
        if not relations:
            return ()
        residuals = translate.all(relations)
        moved = translate.variables[columns]
        slopes = [hy.diff(residual, variable) for residual in residuals for variable in moved]
        return (
            Block(
                hy.cfunc(residuals, translate.variables, fp_type=kind),
                hy.cfunc(slopes, translate.variables),
                len(residuals),
            ),
        )

    return build


def compile_system(
    system: System,
    tolerance: float = 1e-15,
    precision: Precision = "double",
    direction: Direction = "forward",
) -> CompiledSystem:
    """Compile a system, or fetch its code from the cache.

    Parameters
    ----------
    system : System
        Lifted to space if it has a motion.
    tolerance : float
        Relative error per step; limited by the working precision.
    precision : ``"double"`` or ``"quad"``
        16 or 34 digits.
    direction : ``"forward"`` or ``"backward"``
        Of time: a guard is passed where it falls to zero in this direction.

    Raises
    ------
    InputError
        If the tolerance is not between 0 and 1, or finer than the precision allows.
    """
    if not 0 < tolerance < 1:
        raise InputError(f"tolerance {tolerance}: it must lie between 0 and 1")
    if precision == "double" and tolerance < 1e-16:
        raise InputError(
            f"tolerance {tolerance} is beyond double precision: use at least 1e-16, or "
            "precision 'quad'"
        )
    plan = _plan(system, tolerance, precision, direction)
    code: CompiledSystem
    code, from_cache = cache.remember(plan.name, plan.compile)
    return replace(code, from_cache=from_cache)


@lru_cache(maxsize=32)
def _plan(system: System, tolerance: float, precision: Precision, direction: Direction) -> _Plan:
    """The plan of a system, cached because its name takes long to compute."""
    return _Plan(system, tolerance, precision, direction)
