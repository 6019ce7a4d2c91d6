"""Vector invariants from which laws are built: products of (u, v), (u, Jv) and others.

The equations of a rolling body prefer no axes: a rotation of the body axes rotates all vectors and
tensors alike. Their laws are therefore scalars formed from these vectors and tensors.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations_with_replacement, islice
from typing import TypeAlias

import sympy as sp
from sympy.matrices.expressions import MatAdd, MatMul

from flowlanes.system.vectors import Diagonal, Symmetric, Vector, dot

from .ansatz import Ansatz
from .phase_space import RestrictedSystem
from .rational_reconstruction import Part, Scalars
from .scaling import Weight, total, weight_of

Tensor: TypeAlias = Diagonal | Symmetric

_MOMENTA = ("M", "omega")
_GROUPS = 4


def _parameters(space: RestrictedSystem, table: dict[sp.Symbol, Weight]) -> list[sp.Symbol]:
    """Free parameters, and definitions that depend only on parameters and are not tensors."""
    return [s for s in space.free if s in table]


def component_scalars(space: RestrictedSystem, table: dict[sp.Symbol, Weight]) -> Scalars:
    """The free parameters, and scalar definitions that depend only on parameters."""
    formulas: list[sp.Expr] = _parameters(space, table)
    scalars = [s for s in _numbers(space) if s in table]
    symbols = [*formulas, *scalars]
    return Scalars(tuple(symbols), tuple(table[s] for s in symbols))


def _numbers(space: RestrictedSystem) -> list[sp.Symbol]:
    """Scalar definitions that depend only on parameters, such as k = a/(a + R)."""
    named = {name for name, _ in space.system.definitions if isinstance(name, sp.Symbol)}
    return [s for s, value in space.constants.items() if s in named and value.free_symbols]


@dataclass(frozen=True)
class _Atom:
    """A scalar product and its degrees in momenta and coordinates."""

    formula: sp.Expr
    momenta: int
    coordinates: int
    effort: int
    weight: Weight


@dataclass(frozen=True)
class VectorInvariants:
    """The invariants from which formulas about a system are built.

    Parameters
    ----------
    ansatz : Ansatz
        Determines which vectors are momenta and which are coordinates.
    table : dict
        Weights of all symbols.
    """

    space: RestrictedSystem
    ansatz: Ansatz
    table: dict[sp.Symbol, Weight]

    @cached_property
    def _names(self) -> tuple[Vector | Tensor, ...]:
        """All vectors and tensors in the equations."""
        system = self.space.system
        names: dict[Vector | Tensor, None] = {}
        for name, formula in (*system.field, *system.definitions):
            if not isinstance(name, sp.Symbol):
                names[name] = None
            for atom in sorted(formula.atoms(Vector, Diagonal, Symmetric), key=str):
                names[atom] = None
        return tuple(name for name in names if set(name.symbols) <= set(self.table))

    @cached_property
    def _constant_symbols(self) -> set[sp.Symbol]:
        return {p.symbol for p in self.space.system.parameters} | set(self.space.constants)

    def _vectors(self) -> list[Vector]:
        return [n for n in self._names if isinstance(n, Vector) and n.shape[0] == 3]

    @cached_property
    def momenta(self) -> tuple[Vector, ...]:
        """The vectors among the momenta of the ansatz, and M and ω."""
        chosen = set(self.ansatz.momenta)
        return tuple(
            v
            for v in self._vectors()
            if set(v.symbols) <= chosen
            or (v.name in _MOMENTA and not set(v.symbols) & set(self.ansatz.coordinates))
        )

    @cached_property
    def coordinates(self) -> tuple[Vector, ...]:
        """The vectors among the coordinates of the ansatz, and those that are linear in them."""
        chosen = set(self.ansatz.coordinates)
        steps = dict(self.space.system.scalar_definitions)
        written = dict(self.space.system.definitions)
        vectors = []
        for vector in self._vectors():
            symbols = set(vector.symbols)
            if symbols <= chosen or (vector.name == "r" and symbols <= set(steps)):
                vectors.append(vector)
            elif isinstance(written.get(vector), MatAdd) and not symbols <= self._constant_symbols:
                values = [steps[s] for s in vector.symbols]
                reached = set().union(*(v.free_symbols for v in values))
                if reached <= chosen | self._constant_symbols and all(
                    v.is_polynomial(*chosen) and sp.total_degree(v, *chosen) == 1 for v in values
                ):
                    vectors.append(vector)
        return tuple(vectors)

    @cached_property
    def constants(self) -> tuple[Vector, ...]:
        """Vectors of parameters."""
        parameters = {p.symbol for p in self.space.system.parameters}
        return tuple(v for v in self._vectors() if set(v.symbols) <= parameters)

    @cached_property
    def tensors(self) -> tuple[tuple[Tensor, Tensor | None], ...]:
        """Constant tensors, each with its inverse if the equations name it.

        If both a tensor and its inverse are named, other tensors differ from it by a multiple of
        E.
        """
        constant = [
            n
            for n in self._names
            if isinstance(n, (Diagonal, Symmetric)) and set(n.symbols) <= self._constant_symbols
        ]
        definitions = dict(self.space.system.definitions)
        pairs = [(t, n) for t in constant for n in constant if definitions.get(n) == t**-1]
        return tuple(pairs[:1]) or tuple((t, None) for t in constant[:1])

    def _weight(self, vector: Vector | Tensor) -> Weight:
        return self.table[vector.symbols[0]]

    def _pairings(self, u: Vector, v: Vector) -> Iterator[tuple[sp.Expr, Weight, int]]:
        """(u, v), (u, Jv), (u, Av), (Ju, Jv), (Au, Av), without products expressible by others."""
        base = total(self._weight(u), self._weight(v))
        yield dot(u, v), base, 1
        if {u, v} & self._sums_of_vectors:
            return
        for pair in self.tensors:
            for number, tensor in enumerate(t for t in pair if t is not None):
                by = self._weight(tensor)
                once = total(base, by)
                yield dot(u, tensor * v), once, 2 + number
                if not {u, v} & self._images:
                    yield dot(tensor * u, tensor * v), total(once, by), 3 + number

    @cached_property
    def _sums_of_vectors(self) -> set[Vector]:
        """Vectors that are sums of others, such as r = c − Rγ."""
        chosen = set(self.ansatz.coordinates)
        return {v for v in self.coordinates if not set(v.symbols) <= chosen}

    @cached_property
    def _images(self) -> set[Vector]:
        """Momenta that are tensors applied to another momentum: M beside ω."""
        others = {v for v in self.momenta if v.name != "omega"}
        return others if len(others) < len(self.momenta) else set()

    @cached_property
    def _atoms(self) -> tuple[_Atom, ...]:
        graded: list[tuple[Vector, int, int]] = [
            *((v, 1, 0) for v in self.momenta),
            *((v, 0, 1) for v in self.coordinates),
            *((v, 0, 0) for v in self.constants),
        ]
        atoms = []
        for (u, m, c), (v, n, d) in combinations_with_replacement(graded, 2):
            if m + n + c + d:
                atoms += [
                    _Atom(formula, m + n, c + d, effort, weight)
                    for formula, weight, effort in self._pairings(u, v)
                ]
        return tuple(self._useful(atoms))

    def _useful(self, atoms: Iterable[_Atom]) -> Iterator[_Atom]:
        """The atoms that are not constant on the phase space."""
        # A product with equal values at random points of the phase space is a constant.
        sample = self.space.sample(8, 5, common=True)
        for atom in atoms:
            values = sample(atom.formula).value
            if (values != values[0]).any():
                yield atom

    @cached_property
    def scalars(self) -> Scalars:
        """Parameters, traces, determinants and products of constant vectors."""
        parts = {s for n in self._names for s in n.symbols}
        scalars: list[tuple[sp.Expr, Weight]] = [
            (s, self.table[s])
            for s in (*_parameters(self.space, self.table), *_numbers(self.space))
            if s not in parts and s in self.table and s in self._symbols_outside_tensors
        ]
        for group in self._groups({s for s, _ in scalars}):
            product = sp.Mul(*(base**exponent for base, exponent in group.items()))
            weight = weight_of(tuple(group), tuple(group.values()), self.table)
            scalars.append((product, weight))
        for tensor, _ in self.tensors:
            weight = self._weight(tensor)
            entries = tensor.entries
            scalars.append((sp.trace(entries), weight))
            scalars.append((entries.det(method="berkowitz"), tuple(3 * w for w in weight)))
        for u, v in combinations_with_replacement(self.constants, 2):
            scalars += [(formula, weight) for formula, weight, _ in self._pairings(u, v)]
        return Scalars(tuple(f for f, _ in scalars), tuple(w for _, w in scalars))

    @cached_property
    def _symbols_outside_tensors(self) -> set[sp.Symbol]:
        """Scalars that occur in the equations outside the constant tensors."""
        system = self.space.system
        solved = dict(self.space.substitutions)
        symbols: set[sp.Symbol] = set()
        for name, formula in (*system.field, *system.definitions):
            if (
                isinstance(name, (sp.Symbol, Vector))
                or not set(name.symbols) <= self._constant_symbols
            ):
                symbols |= {s for s in formula.free_symbols if isinstance(s, sp.Symbol)}
        return symbols | {
            s for symbol in symbols & set(solved) for s in solved[symbol].free_symbols
        }

    def _groups(self, scalars: set[sp.Expr]) -> list[dict[sp.Symbol, int]]:
        """Products of parameters that occur together in the equations, such as m R²."""
        system = self.space.system
        groups: list[dict[sp.Symbol, int]] = []
        for _, formula in (*system.field, *system.definitions):
            for node in sp.preorder_traversal(formula):
                if isinstance(node, (sp.Mul, MatMul)):
                    factor = sp.Mul(*(a for a in node.args if not getattr(a, "is_Matrix", False)))
                    group = {
                        base: int(exponent)
                        for base, exponent in factor.as_powers_dict().items()
                        if base in scalars and exponent.is_Integer
                    }
                    if sum(map(abs, group.values())) > 1 and group not in groups:
                        groups.append(group)
        return groups[:_GROUPS]

    def parts(self, degree: int, gamma_degree: int, most: int) -> tuple[Part, ...]:
        """Products of scalar products up to given degrees in momenta and coordinates.

        The degree in the coordinates is lowered until there are at most `most` products.
        """
        zero = tuple(0 for _ in next(iter(self.table.values())))
        one = Part(sp.S.One, zero, 0)
        for places in range(gamma_degree, -1, -1):
            parts = tuple(islice(self._products(one, self._atoms, degree, places), most + 1))
            if len(parts) <= most:
                return parts
        return ()

    def _products(
        self, below: Part, atoms: Sequence[_Atom], degree: int, gamma_degree: int
    ) -> Iterator[Part]:
        yield below
        for index, atom in enumerate(atoms):
            if atom.momenta <= degree and atom.coordinates <= gamma_degree:
                product = Part(
                    below.formula * atom.formula,
                    total(below.weight, atom.weight),
                    below.effort + atom.effort + 1,
                )
                yield from self._products(
                    product, atoms[index:], degree - atom.momenta, gamma_degree - atom.coordinates
                )
