"""Lyapunov exponents that must be zero.

Every integral F forces a zero exponent: the motion preserves dF, so that the component of a
deviation across its levels neither grows nor shrinks. The same holds for every bounded vector
field that the flow maps to itself: the flow, or a symmetry. Deviations that violate relations are
not admissible at all. The remaining exponents form the genuine spectrum.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np
import sympy as sp

from ..arguments import Parameters
from ..flow.linearisation.linear_stability import components, essential_variables
from ..flow.linearisation.state_scales import state_scales_at
from ..flow.linearisation.tangent_space import TangentSpace
from ..formulas.array_formulas import Formulas
from ..printing.formula import text
from ..printing.laws import equation
from ..system.arrays import FloatArray
from ..system.laws import Symmetry
from ..system.system import System

Kind = Literal["relation", "integral", "flow", "symmetry", "quadrature"]

#: Relative size below which a vector counts as linearly dependent.
DEPENDENT = 1e-8
#: Relative size below which a number counts as zero.
ZERO = 1e-10
#: Number of nearby states, their distance in units of the state, and the seed of directions.
BESIDE, NEAR, SEED = 4, 0.1, 20080830

_REASONS: Mapping[Kind, str] = {
    "relation": "holds on the phase space",
    "integral": "constant along the motion",
    "flow": "direction of the motion",
    "symmetry": "carried along by the flow",
    "quadrature": "nothing depends on it",
}


@dataclass(frozen=True)
class TrivialExponent:
    """A dimension that is removed from the tangent space.

    Attributes
    ----------
    name : str
        ``"flow"``, the name of an integral or a symmetry, the relation, or the variable.
    kind : str
        ``"relation"``, ``"integral"``, ``"flow"``, ``"symmetry"`` or ``"quadrature"``.
    """

    name: str
    kind: Kind

    @property
    def exponent(self) -> float | None:
        """0, or None for a relation, whose violation is not an admissible deviation."""
        return None if self.kind == "relation" else 0.0

    @property
    def reason(self) -> str:
        """The reason why it has no genuine exponent."""
        return _REASONS[self.kind]


@dataclass(frozen=True)
class TrivialDirections:
    """The directions with trivial exponents along a motion, and the remaining deviations.

    Attributes
    ----------
    space : TangentSpace
        The genuine deviations.
    trivial : tuple of TrivialExponent
    dependent : tuple of str
        Integrals and fields that depend at this start on those already removed, and force no
        further zero.
    sizes : (size,) array
        The units of deviations.
    """

    space: TangentSpace
    trivial: tuple[TrivialExponent, ...]
    dependent: tuple[str, ...]
    sizes: FloatArray


def trivial_directions(
    system: System,
    start: Sequence[float],
    parameters: Parameters = None,
    fading: Collection[str] = (),
    sizes: FloatArray | None = None,
) -> TrivialDirections:
    """The exponents of the motion from a start that laws and relations force to be zero.

    Parameters
    ----------
    system : System
    start : sequence of float
        State in flat order, on the phase space.
    parameters : mapping of Symbol or name to number, optional
        Parameters that replace the defaults.
    fading : collection of str
        Names of fields and integrals to keep, because they force no zero on this motion.
    sizes : (size,) array, optional
        The units of deviations; by default those of the start.

    Returns
    -------
    TrivialDirections
        With integrals and fields that are independent at the start; the motion preserves
        dependence.
    """
    state = np.array([start], dtype=np.float64)
    measures = state_scales_at(system, state[:, None], parameters)[0] if sizes is None else sizes
    at = _LocalSystem(system, state, measures, parameters)
    across, along = _Span(), _Span()
    removed: list[TrivialExponent] = []
    dependent: list[str] = []
    conditions: list[sp.Expr] = []
    for item in _conditions(at):
        if item.trivial.name in fading:
            continue
        if item.level and not at.on_level(item.level, across):
            continue
        gradients = at.slopes(item.formulas)[:, 0]
        if across.take(gradients[0], _floor(gradients)):
            conditions.append(item.formulas[0])
            removed.append(item.trivial)
        else:
            dependent.append(item.trivial.name)
    fields = [
        item
        for item in _fields(at)
        if item.trivial.name not in fading and (not item.level or at.on_level(item.level, across))
    ]
    rows: list[FloatArray] = []
    for named, row in _tangent(at, fields, across):
        vectors = row @ at.vectors(fields)
        if along.take(vectors[0], _floor(vectors)):
            rows.append(row)
            removed.append(named)
        else:
            dependent.append(named.name)
    directions = tuple(item.formulas for item in fields)
    mixed = np.array(rows).reshape(len(rows), len(fields))
    space = TangentSpace(system, tuple(conditions), directions, mixed)
    return TrivialDirections(space, tuple(removed), tuple(dependent), measures)


def vanishes_to_rounding(
    system: System,
    level: Sequence[sp.Expr],
    state: FloatArray,
    parameters: Parameters,
    sizes: FloatArray,
) -> bool:
    """True if formulas vanish at a state up to the rounding errors of their terms.

    Parameters
    ----------
    system : System
    level : sequence of sympy.Expr
    state, sizes : (size,) arrays
    parameters : mapping of Symbol or name to number, optional
    """
    # The scale of a value is the sum of its changes with the state and with the parameters.
    values = np.abs(Formulas(system, level)(state, parameters))
    reach = np.linalg.norm(Formulas(system, level).slopes(state, parameters) * sizes, axis=1)
    named = [item.symbol for item in system.parameters]
    parts = [symbol * sp.diff(formula, symbol) for formula in level for symbol in named]
    shares = np.abs(Formulas(system, parts)(state, parameters)).reshape(len(level), len(named))
    return bool(np.all(values <= ZERO * (reach + shares.sum(axis=1))))


def _floor(vectors: FloatArray) -> float:
    """The length below which the first of some vectors counts as zero."""
    lengths = np.linalg.norm(vectors, axis=1)
    return ZERO * float(np.fmax.reduce(lengths, initial=0.0))


@dataclass(frozen=True)
class _Item:
    """A function or vector field that may force a zero exponent."""

    trivial: TrivialExponent
    formulas: tuple[sp.Expr, ...]
    level: tuple[sp.Expr, ...] = ()


@dataclass
class _Span:
    """The span of independent vectors, as an orthonormal basis."""

    basis: list[FloatArray] = field(default_factory=list)

    def remainder(self, vector: FloatArray) -> FloatArray:
        """A vector minus its projection onto the span."""
        # Two passes of Gram–Schmidt: one pass loses orthogonality by cancellation.
        for _ in range(2):
            for other in self.basis:
                vector = vector - (vector @ other) * other
        return vector

    def take(self, vector: FloatArray, floor: float) -> bool:
        """Add a vector to the basis if it is independent; return whether it was added."""
        left = self.remainder(vector)
        size = float(np.linalg.norm(left))
        independent = size > max(floor, DEPENDENT * float(np.linalg.norm(vector)))
        if independent:
            self.basis.append(left / size)
        return independent


@dataclass(frozen=True)
class _LocalSystem:
    """A system at one state."""

    system: System
    state: FloatArray
    sizes: FloatArray
    parameters: Parameters

    @cached_property
    def places(self) -> FloatArray:
        """The state and nearby ones, which give typical sizes of vectors that vanish here."""
        moves = np.random.default_rng(SEED).standard_normal((BESIDE, self.state.shape[1]))
        return np.concatenate([self.state, self.state + NEAR * self.sizes * moves])

    def slopes(self, formulas: Sequence[sp.Expr]) -> FloatArray:
        """Gradients in units of the state, (places, formulas, size)."""
        result: FloatArray = (
            Formulas(self.system, formulas).slopes(self.places, self.parameters) * self.sizes
        )
        return result

    def vectors(self, items: Sequence[_Item]) -> FloatArray:
        """The vector fields of some items in units of the state, (places, items, size)."""
        parts = [part for item in items for part in item.formulas]
        flat = Formulas(self.system, parts)(self.places, self.parameters)
        result: FloatArray = flat.reshape(len(flat), len(items), len(self.sizes)) / self.sizes
        return result

    def on_level(self, level: Sequence[sp.Expr], span: _Span) -> bool:
        """True if the state lies on a level whose gradients are in the span."""
        return vanishes_to_rounding(
            self.system, level, self.state[0], self.parameters, self.sizes
        ) and all(
            np.linalg.norm(span.remainder(row)) <= DEPENDENT * np.linalg.norm(row)
            for row in self.slopes(level)[0]
        )


def _conditions(at: _LocalSystem) -> Iterator[_Item]:
    """Relations, then integrals; unconditional integrals first."""
    system = at.system
    for relation, scalar in zip(system.relations, system.scalar.relations, strict=True):
        name = " = ".join(map(text, equation(relation)))
        yield _Item(TrivialExponent(name, "relation"), (scalar,))
    idle = set(_idle(system))
    for law in sorted(system.integrals, key=lambda law: bool(law.level)):
        value = law.scalar.value
        used = {s for _, step in system.required_definitions([value]) for s in step.free_symbols}
        # A variable on which nothing depends is removed separately.
        if not idle & (used | value.free_symbols):
            yield _Item(TrivialExponent(law.name, "integral"), (value,), law.scalar.level)


def _fields(at: _LocalSystem) -> Iterator[_Item]:
    """Ignorable variables, symmetries, and the flow.

    The flow comes last: if it is a combination of the others it forces no further zero, and if the
    motion comes to rest only the flow fades.
    """
    system = at.system
    for symbol in _idle(system):
        unit = tuple(sp.Integer(s == symbol) for s in system.symbols)
        yield _Item(TrivialExponent(str(symbol), "quadrature"), unit)
    for law in system.laws_of(Symmetry):
        parts = tuple(components(law, system.symbols))
        yield _Item(TrivialExponent(law.name, "symmetry"), parts, law.scalar.level)
    yield _Item(TrivialExponent("flow", "flow"), system.rates)


def _idle(system: System) -> list[sp.Symbol]:
    active = essential_variables(system)
    return [s for s in system.symbols if s not in active]


def _tangent(
    at: _LocalSystem, fields: Sequence[_Item], across: _Span
) -> Iterator[tuple[TrivialExponent, Any]]:
    """Vector fields tangent to the conditions, and tangent combinations of the others.

    The combinations have constant coefficients, since the derivative of an integral along a
    symmetry is again an integral.
    """
    vectors = at.vectors(fields)[0]
    sizes = np.linalg.norm(vectors, axis=1)
    outward = vectors @ np.array(across.basis).reshape(-1, vectors.shape[1]).T
    within = np.linalg.norm(outward, axis=1) <= DEPENDENT * sizes
    loose = [i for i, tangent in enumerate(within) if not tangent]
    if loose:
        # The kernel of the outward components gives the tangent combinations.
        _, strengths, rotation = np.linalg.svd(outward[loose].T / sizes[loose])
        rank = int((strengths > DEPENDENT * strengths[0]).sum())
        names = " and ".join(fields[i].trivial.name for i in loose)
        for row in rotation[rank:]:
            mixed = np.zeros(len(fields))
            mixed[loose] = row / sizes[loose]
            yield TrivialExponent(f"a combination of {names}", "symmetry"), mixed
    for item, tangent, row in zip(fields, within, np.eye(len(fields)), strict=True):
        if tangent:
            yield item.trivial, row
