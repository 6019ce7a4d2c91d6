"""Polynomial ansatz for the search of laws, and its cost."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.matrices import Skew
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector

from .modular_jets import Integers, prime
from .phase_space import Sample

MEMORY = 4_000_000_000
"""Maximum memory of the linear algebra of a search, in bytes."""
_BYTES = 72  # per entry of the square matrix: value, rate, a Python integer, FLINT's copies

Exponents = tuple[int, ...]


@dataclass(frozen=True)
class Ansatz:
    """All monomials in momenta and coordinates up to given degrees.

    Parameters
    ----------
    momenta, coordinates : tuples of sympy.Expr
        States, definitions, sines and cosines of angles.
    degree, gamma_degree : int
        Largest total degrees in the momenta and in the coordinates.
    """

    momenta: tuple[sp.Expr, ...]
    coordinates: tuple[sp.Expr, ...]
    degree: int
    gamma_degree: int

    @property
    def size(self) -> int:
        """The number of monomials."""
        return comb(len(self.momenta) + self.degree, self.degree) * comb(
            len(self.coordinates) + self.gamma_degree, self.gamma_degree
        )

    def check(self, components: int = 1) -> None:
        """Raise InputError if the ansatz does not fit into memory.

        Parameters
        ----------
        components : int
            Number of components that contain all monomials with independent coefficients.

        Raises
        ------
        InputError
        """
        terms = self.size * components
        need = _BYTES * terms**2
        if need > MEMORY:
            raise InputError(
                f"the ansatz has {terms:,} coefficients, whose equations need about "
                f"{need / 1e9:,.0f} GB; up to {MEMORY / 1e9:.0f} GB are allowed, so take a lower "
                f"degree than {self.degree} in the momenta or {self.gamma_degree} in the "
                "coordinates"
            )


@dataclass(frozen=True)
class Table:
    """The monomials of an ansatz evaluated at the points of a sample.

    Attributes
    ----------
    exponents : list of tuples
        One monomial each, by increasing degree.
    value, rate : arrays of int64, shape (monomials, points)
    """

    exponents: list[Exponents]
    value: Integers
    rate: Integers


def default_momenta(system: System) -> tuple[tuple[sp.Symbol, ...], ...]:
    """The momentum-like quantities: M or ω of the state, and also ω if it is defined in terms of M.

    If there is neither, the first vector of the state; if there is no vector, the whole state.
    """
    named = (*system.state, *(name for name, _ in system.definitions))
    vectors = {v.name: v.symbols for v in named if isinstance(v, Vector)}
    state = [v for v in system.state if isinstance(v, Vector | Skew)]
    if any(v.name == "M" for v in state):
        return tuple(vectors[name] for name in ("M", "omega") if name in vectors)
    for vector in sorted(state, key=lambda v: v.name != "omega"):
        return (vector.symbols,)
    return (system.symbols,)


def _exponents(variables: int, degree: int) -> list[Exponents]:
    """Exponents of total degree ≤ `degree`, by increasing degree."""
    if variables == 0:
        return [()]
    exponents = [
        (first, *others)
        for first in range(degree, -1, -1)
        for others in _exponents(variables - 1, degree - first)
    ]
    return sorted(exponents, key=sum)


def rates_of_products(
    left: tuple[Integers, Integers], right: tuple[Integers, Integers]
) -> tuple[Integers, Integers]:
    """Values and rates, modulo the prime, of the products of two families of arrays (broadcast)."""
    (value, rate), (other, change) = left, right
    return (value * other % prime(), (value * change % prime() + rate * other) % prime())


def _monomials(
    sample: Sample, variables: Sequence[sp.Expr], degree: int
) -> tuple[list[Exponents], Integers, Integers]:
    exponents = _exponents(len(variables), degree)
    jets = [sample(variable) for variable in variables]
    factors = [(jet.value, sample.along(jet)) for jet in jets]
    points = len(sample.field[0])
    one = np.ones(points, dtype=np.int64)
    monomials = {exponents[0]: (one, np.zeros_like(one))}
    # Each monomial is a lower one times a variable, which gives value and rate by one product.
    for powers in exponents[1:]:
        index = next(i for i, e in enumerate(powers) if e)
        below = (*powers[:index], powers[index] - 1, *powers[index + 1 :])
        monomials[powers] = rates_of_products(monomials[below], factors[index])
    value, rate = (np.array([monomials[e][i] for e in exponents]) for i in (0, 1))
    return exponents, value, rate


def table(ansatz: Ansatz, sample: Sample) -> Table:
    """Evaluate all monomials of an ansatz and their rates along the field."""
    first, *momenta = _monomials(sample, ansatz.momenta, ansatz.degree)
    second, *coordinates = _monomials(sample, ansatz.coordinates, ansatz.gamma_degree)
    value, rate = rates_of_products(
        (momenta[0][:, None], momenta[1][:, None]), (coordinates[0][None], coordinates[1][None])
    )
    points = value.shape[-1]
    exponents = [(*a, *b) for a in first for b in second]
    return Table(exponents, value.reshape(-1, points), rate.reshape(-1, points))
