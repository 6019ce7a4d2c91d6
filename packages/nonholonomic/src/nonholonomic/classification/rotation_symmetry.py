"""Symmetry under rotations about a body axis, proven definition by definition.

The expanded equations of a body of revolution are too long to compute their commutator with a
rotation.  But every vector among their definitions rotates with the earlier vectors, and every
scalar is invariant. Each of these statements is a short identity, and together they prove the
symmetry by induction.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from flowlanes.formulas.exact_zero import vanishes
from flowlanes.system.named_formulas import flat_pairs, scalars
from flowlanes.system.vectors import Diagonal, Symmetric, Vector

from .ranks import RankSample


def proven_rotation_symmetry(sample: RankSample, axis: int) -> RotationSymmetry | None:
    """The rotation about a body axis, if it is proven to be a symmetry.

    Parameters
    ----------
    sample : RankSample
        The system at its present parameters.
    axis : int
        0, 1 or 2.

    Returns
    -------
    RotationSymmetry or None
        None if it is not a symmetry, or if the proof does not apply because the state or a
        definition is not a vector, scalar or tensor of space in body axes.
    """
    symmetry = RotationSymmetry(sample, axis)
    system = sample.system
    vectors = all(isinstance(name, Vector) and len(name.symbols) == 3 for name in system.state)
    if not vectors:
        return None
    for name in system.state:
        symmetry.motion.update(zip(name.symbols, symmetry.rotation(name.symbols), strict=True))
    if not all(symmetry.follows(name, formula) for name, formula in system.definitions):
        return None
    rates = [symmetry.expand(rate) for rate in system.rates]
    wanted = [
        component
        for i in range(0, len(rates), 3)
        for component in symmetry.rotation(rates[i : i + 3])
    ]
    shown = all(map(symmetry.keeps, system.relations)) and symmetry.agree(rates, wanted)
    return symmetry if shown else None


class RotationSymmetry:
    """The known changes of symbols under an infinitesimal rotation."""

    def __init__(self, sample: RankSample, axis: int) -> None:
        self.hat = sp.ImmutableMatrix(3, 3, lambda i, j: -sp.LeviCivita(axis, i, j))
        self.across = [i for i in range(3) if i != axis]
        self.motion: dict[sp.Symbol, sp.Expr] = {}
        self.equal: dict[sp.Symbol, sp.Expr] = dict(sample.parameters)

    def rotation(self, triple: Sequence[sp.Expr]) -> list[sp.Expr]:
        """The change of a vector: e × x."""
        return list(self.hat * sp.Matrix(triple))

    def expand(self, formula: sp.Expr) -> sp.Expr:
        """A formula with numbers for parameters and one symbol for equal quantities."""
        return formula.xreplace(self.equal)

    def follows(self, name: sp.Expr, formula: sp.Expr) -> bool:
        """Whether a definition transforms according to its kind.

        If so, the changes of its symbols are recorded.
        """
        symbols, parts = zip(*flat_pairs(((name, formula),)), strict=True)
        values = [self.expand(part) for part in parts]
        # infinitesimal rotation: e × x of vectors, [ê, T] of tensors, zero for scalars; a diagonal
        # tensor is invariant if its two entries across the axis agree
        if isinstance(name, Symmetric):
            here, there = (_square(t) for t in (values, symbols))
            wanted, change = (
                Symmetric.independent(self.hat * t - t * self.hat) for t in (here, there)
            )
        elif isinstance(name, Vector) and len(symbols) == 3:
            wanted, change = tuple(self.rotation(values)), tuple(self.rotation(symbols))
        elif isinstance(name, Diagonal | sp.Symbol):
            wanted = change = (sp.S.Zero,) * len(symbols)
        else:
            return False
        if isinstance(name, Diagonal):
            first, second = self.across
            if not vanishes(values[first] - values[second]):
                return False
            self.equal[symbols[second]] = symbols[first]
        self.motion.update(zip(symbols, change, strict=True))
        return self.agree(values, wanted)

    def keeps(self, formula: sp.Expr) -> bool:
        """Whether a scalar formula is proven invariant."""
        return vanishes(self._change(self.expand(*scalars(formula))))

    def agree(self, values: Sequence[sp.Expr], goals: Sequence[sp.Expr]) -> bool:
        """Whether formulas have the given changes."""
        return all(vanishes(self._change(v) - w) for v, w in zip(values, goals, strict=True))

    def _change(self, value: sp.Expr) -> sp.Expr:
        moved = sorted(value.free_symbols & self.motion.keys(), key=str)
        return sp.Add(*(sp.diff(value, s) * self.motion[s] for s in moved))


def _square(entries: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """A symmetric matrix from its six entries."""
    pairs = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
    places = {frozenset(pair): entry for pair, entry in zip(pairs, entries, strict=True)}
    return sp.ImmutableMatrix(3, 3, lambda i, j: places[frozenset((i, j))])
