"""A System compiled for Taylor integration."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from importlib.metadata import version
from typing import Protocol, TypeAlias

import numpy as np
import sympy as sp

from ...errors import InputError
from ...formulas.graph import Graph, Reader, Term, topological_order
from ...system.formula_text import exact_text
from ...system.system import System
from ...system.tolerance import FINEST_TOLERANCE, TOLERANCE, Precision
from ..machine_code import code_cache as cache, jit
from ..machine_code.native_formulas import SIGNATURE, FormulaShape, NativeFormulas, emit_formulas
from .projection import Block
from .recurrences import SERIES_SIGNATURES, emit_series
from .state_series import SeriesLayout, Step, TaylorSeries, series_order
from .working_numbers import Direction, WorkingArray, WorkingNumber

#: Residuals by name, with the columns of the state that are corrected.
Residuals: TypeAlias = dict[str, tuple[list[sp.Expr], slice]]
#: Argument types of the formula functions, by name.
Shapes: TypeAlias = dict[str, FormulaShape]

#: Smallest tolerance for the working precision.
FINEST = {"double": np.finfo(float).eps, "quad": 2e-34}


class StateSeries(Protocol):
    """State that advances by steps of its Taylor series; see :class:`TaylorSeries`."""

    order: int
    time: WorkingNumber

    @property
    def state(self) -> WorkingArray:
        """State (size,); it may be changed in place."""
        ...

    @property
    def parameters(self) -> WorkingArray:
        """Parameters; they may be changed in place."""
        ...

    @property
    def series(self) -> WorkingArray:
        """Coefficients (size, order + 1) of the powers of time since the start of the last step."""
        ...

    def reset(self) -> None:
        """Reset the events of the last step and the stored rounding errors."""
        ...

    def copy(self) -> StateSeries:
        """Copy that advances independently with the same code."""
        ...

    def step(self, limit: WorkingNumber) -> Step:
        """Make one step, not longer than `limit`."""
        ...

    def state_at(self, time: WorkingNumber) -> WorkingArray:
        """State at a time within the last step."""
        ...


@dataclass(frozen=True)
class SignedOutputs:
    """Compiled outputs of a system without corners; the last outputs are the values σu.

    Attributes
    ----------
    outputs : callable
        Function of states and parameters, with the signs.
    arguments : tuple of sympy.Expr
    """

    outputs: Callable[[WorkingArray, WorkingArray], WorkingArray]
    arguments: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class CompiledSystem:
    """Native code for one system at one tolerance and precision.

    Parameters of the system are run-time values; the code is shared by all of them.

    Attributes
    ----------
    series : StateSeries
        State of the core, then of the motion; a terminal event for each of `variable_guards`.
        After the parameters of the system come positive factors of these events.  Stepping
        changes it, so that a user works with a copy.
    outputs : callable
        From states and parameters to observables, laws and guards.
    core, lift : tuple of Block
        Relations of the reduced state and of its lift to space; at most one block each.
    laws : callable
        Function that returns the block of the integrals, which are compiled on first use.
    variable_guards : tuple of int
        Guards that may change during a motion; others are the same in every state.
    from_cache : bool
        True if the code was read from the cache.
    signed : SignedOutputs, optional
        Given if the equations contain absolute values or signs.  Then the series are those of the
        system without corners, which has the signs as parameters after its own, and changes of
        signs as events after those of the guards.
    """

    series: StateSeries
    outputs: Callable[[WorkingArray, WorkingArray], WorkingArray]
    core: tuple[Block, ...]
    lift: tuple[Block, ...]
    laws: Callable[[], tuple[Block, ...]]
    variable_guards: tuple[int, ...]
    from_cache: bool = False
    signed: SignedOutputs | None = None


@dataclass(frozen=True)
class _Layout:
    """Sizes of the functions of a system.

    Attributes
    ----------
    series : SeriesLayout
    variable_guards : tuple of int
        Guards that depend on the state.
    formulas : mapping of str to FormulaShape
    """

    series: SeriesLayout
    variable_guards: tuple[int, ...]
    formulas: Shapes


@dataclass(frozen=True)
class _Plan:
    """System to be compiled, and the name of its code in the cache."""

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
        # Each part has its own list, because an observable is compiled differently from a guard.
        shape = [
            self.system.symbols,
            self.system.scalar.relations,
            system.symbols,
            [p.symbol for p in system.parameters],
            [item for step in system.scalar_definitions for item in step],
            system.rates,
            system.scalar.relations,
            [law.value for law in system.scalar.integrals],
            [observable.value for observable in system.scalar.observables],
            [guard.value for guard in system.scalar.guards],
        ]
        # The exact text keeps every digit of a decimal number, which str does not.
        formulas = (exact_text(list(part)) for part in shape)
        return cache.code_name(*formulas, repr(self.tolerance), self.precision, self.direction)

    @cached_property
    def _output_formulas(self) -> list[sp.Expr]:
        """Recorded quantities of a motion, and guards."""
        system = self.system_in_space
        groups = system.observables, system.integrals, system.guards
        return [item.value for group in groups for item in group]

    @cached_property
    def _blocks(self) -> Residuals:
        """Relations with the columns that they correct."""
        core = slice(0, len(self.system.symbols))
        lift = self.system.reconstruction
        blocks = {
            "core": (list(self.system.relations), core),
            "lift": (list(lift.relations) if lift else [], slice(core.stop, None)),
        }
        return {name: block for name, block in blocks.items() if block[0]}

    @cached_property
    def _law_blocks(self) -> Residuals:
        """Integrals, which correct the reduced state."""
        laws = [law.value for law in self.system_in_space.integrals]
        return {"laws": (laws, slice(0, len(self.system.symbols)))} if laws else {}

    def code(self) -> tuple[bytes, _Layout]:
        """Machine code and its layout."""
        system = self.system_in_space
        graph = Graph()
        reader = Reader(system, graph)
        rates = reader.components(system.rates)
        guards = reader.components([guard.value for guard in system.guards])
        variable = tuple(i for i, guard in enumerate(guards) if _depends_on_state(guard))
        first = len(system.parameters)
        # Step sizes depend on events as well as on the state.  A guard that is large compared with
        # the state would change them, so it is divided by its initial size.
        events = [
            graph.mul(graph.parameter(first + place), guards[i]) for place, i in enumerate(variable)
        ]
        size = len(rates)
        order = series_order(max(self.tolerance, FINEST["double"]))
        series = emit_series(rates, events, size, order)
        outputs = {"outputs": reader.components(self._output_formulas)}
        text, shapes = _with_slopes(graph, reader, size, self._blocks, outputs)
        layout = SeriesLayout(
            size, len(events), first + len(events), order, series.doubles, series.stride
        )
        return jit.object_code(f"{series.text}\n{text}"), _Layout(layout, variable, shapes)

    def law_code(self) -> tuple[bytes, Shapes]:
        """Machine code of the integrals and their derivatives."""
        system = self.system_in_space
        graph = Graph()
        text, shapes = _with_slopes(
            graph, Reader(system, graph), len(system.symbols), self._law_blocks, {}
        )
        return jit.object_code(text), shapes

    def laws(self) -> tuple[Block, ...]:
        """Block of the integrals in doubles."""
        if not self._law_blocks:
            return ()
        name = jit.code_name(f"{self.name} laws")
        (code, shapes), _ = cache.cached_entry(name, self.law_code)
        native = jit.Native(
            *jit.link(name, code, dict.fromkeys(shapes, SIGNATURE)), from_cache=True
        )
        values, slopes = (
            NativeFormulas(shapes[key], native, key) for key in ("laws", "laws_slopes")
        )
        return (Block(values, slopes, values.shape.count),)

    def compile(self) -> CompiledSystem:
        """System compiled in doubles."""
        name = jit.code_name(self.name)
        (code, layout), from_cache = cache.cached_entry(name, self.code)
        native = _functions_of(name, code, tuple(layout.formulas))
        formulas = {
            name: NativeFormulas(shape, native, name) for name, shape in layout.formulas.items()
        }
        blocks = {
            name: (Block(formulas[name], formulas[f"{name}_slopes"], formulas[name].shape.count),)
            for name in self._blocks
        }
        return CompiledSystem(
            TaylorSeries(native, layout.series),
            formulas["outputs"],
            blocks.get("core", ()),
            blocks.get("lift", ()),
            self.laws,
            layout.variable_guards,
            from_cache,
        )

    def compile_wide(self) -> CompiledSystem:
        """System compiled by heyoka with 34 digits; derivatives of relations in doubles."""
        from .heyoka_series import HeyokaFormulas, HeyokaSeries, heyoka_code

        double = replace(self, precision="double", tolerance=TOLERANCE["double"]).compile()
        every = {**self._blocks, **self._law_blocks}
        residuals = {name: block[0] for name, block in every.items()}
        code, from_cache = cache.cached_entry(
            cache.code_name(self.name, version("heyoka")),
            lambda: heyoka_code(
                self.system_in_space,
                {"outputs": self._output_formulas, **residuals},
                double.variable_guards,
                max(self.tolerance, FINEST["quad"]),
                self.direction,
            ),
        )
        wide = {name: HeyokaFormulas(function) for name, function in code.functions.items()}
        blocks = {
            name: (replace(getattr(double, name)[0], residual=wide[name]),) for name in self._blocks
        }

        def laws() -> tuple[Block, ...]:
            return tuple(replace(block, residual=wide["laws"]) for block in double.laws())

        return replace(
            double,
            series=HeyokaSeries(code.integrator),
            outputs=wide["outputs"],
            core=blocks.get("core", ()),
            lift=blocks.get("lift", ()),
            laws=laws,
            from_cache=from_cache,
        )


def _with_slopes(
    graph: Graph, reader: Reader, size: int, blocks: Residuals, more: Mapping[str, list[Term]]
) -> tuple[str, Shapes]:
    """LLVM assembly text of residuals and their derivatives, with additional formulas."""
    formulas = dict(more)
    for name, (residuals, columns) in blocks.items():
        formulas[name] = reader.components(residuals)
        moved = [graph.state(i) for i in range(size)[columns]]
        rows = graph.jacobian(formulas[name], moved)
        formulas[f"{name}_slopes"] = [slope for row in rows for slope in row]
    texts, shapes = [], {}
    for name, terms in formulas.items():
        text, shapes[name] = emit_formulas(name, terms, size)
        texts.append(text)
    return "\n".join(texts), shapes


@lru_cache(maxsize=64)
def _functions_of(name: str, code: bytes, formulas: tuple[str, ...]) -> jit.Native:
    """Functions of a system, linked once and used for all its integrations."""
    signatures = {**dict.fromkeys(formulas, SIGNATURE), **SERIES_SIGNATURES}
    return jit.Native(*jit.link(name, code, signatures), from_cache=True)


def _depends_on_state(term: Term) -> bool:
    return any(node.kind == "state" for node in topological_order([term]))


def compile_system(
    system: System,
    tolerance: float = TOLERANCE["double"],
    precision: Precision = "double",
    direction: Direction = "forward",
) -> CompiledSystem:
    """Compile a system, or read its code from the cache.

    Parameters
    ----------
    system : System
        Lifted to space if it has a motion in space.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`; limited by the working precision.
    precision : ``"double"`` or ``"quad"``
        16 or 34 digits.
    direction : ``"forward"`` or ``"backward"``
        Direction of time; a guard is violated where it decreases to zero in this direction.

    Raises
    ------
    InputError
        If the tolerance is not between 0 and 1, or too small for the precision.
    """
    if not 0 < tolerance < 1:
        raise InputError(f"tolerance {tolerance}: it must lie between 0 and 1")
    if precision == "double" and tolerance < FINEST_TOLERANCE["double"]:
        raise InputError(
            f"tolerance {tolerance} is beyond double precision: use at least 1e-16, or "
            "precision 'quad'"
        )
    plan = _plan(system, tolerance, precision, direction)
    return plan.compile() if precision == "double" else plan.compile_wide()


@lru_cache(maxsize=32)
def _plan(system: System, tolerance: float, precision: Precision, direction: Direction) -> _Plan:
    """Plan of a system, cached because its name takes long to compute."""
    return _Plan(system, tolerance, precision, direction)
