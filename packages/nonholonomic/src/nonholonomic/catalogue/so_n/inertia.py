"""Operators of inertia on so(n): moments in the coordinate planes, and mass tensors."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, combinations_with_replacement

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.system.matrices import Image, SymmetricMatrix
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol, to_components

from ..catalogue_entry import Numbers

#: Dimensions whose indices are single digits.
SMALLEST, LARGEST = 3, 9

I, J = real_symbol("I"), "J"
MOMENT_UNIT = "kg m^2"
#: Moments of no special operator: 12, 13, 14, 23, 24, 34.
GENERIC = (0.5, 1.1, 1.6, 2.3, 0.9, 1.4)


def pairs(dimension: int) -> tuple[tuple[int, int], ...]:
    """The coordinate planes (0, 1), (0, 2), …, in the order of the entries of ω."""
    return tuple(combinations(range(dimension), 2))


def labels(dimension: int) -> tuple[str, ...]:
    """The planes as indices count them: ``"12"``, ``"13"``, …."""
    return tuple(f"{i + 1}{j + 1}" for i, j in pairs(dimension))


@dataclass(frozen=True)
class Inertia(ABC):
    """An operator ω ↦ I(ω) on so(n), symmetric for (A, B) = Σ A_ij B_ij over i < j.

    Attributes
    ----------
    dimension : int
        n.
    numbers : mapping of str to float
        Its parameters by name.
    """

    dimension: int
    numbers: Numbers

    @property
    @abstractmethod
    def parameters(self) -> tuple[Parameter, ...]:
        """Its parameters."""

    @property
    def definitions(self) -> Pairs:
        """Definitions by its parameters."""
        return ()

    @property
    @abstractmethod
    def words(self) -> str:
        """A sentence on how it acts."""

    @abstractmethod
    def image(self, omega: MatrixExpr) -> MatrixExpr:
        """I(ω), as a page shows it."""

    def of(self, omega: sp.MatrixBase) -> sp.MatrixBase:
        """I(ω) of a skew matrix given by entries."""
        return to_components(self.image(sp.ImmutableDenseMatrix(omega)))


class Moments(Inertia):
    """The operator that takes ω_ij to I_ij ω_ij, with positive I_ij."""

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The moments ``I_12``, ``I_13``, …."""
        symbols = [self.moment(i, j) for i, j in pairs(self.dimension)]
        return tuple(
            Parameter(
                s,
                f"moment of inertia in the plane of body axes {s.name[-2]} and {s.name[-1]}",
                self.numbers[s.name],
                MOMENT_UNIT,
                (s > 0,),
            )
            for s in symbols
        )

    @property
    def words(self) -> str:
        """A sentence on how it acts."""
        return "The inertia takes ωᵢⱼ to Iᵢⱼ ωᵢⱼ."

    def moment(self, i: int, j: int) -> sp.Symbol:
        """I_ij, in either order of the indices."""
        return real_symbol(f"I_{min(i, j) + 1}{max(i, j) + 1}")

    def image(self, omega: MatrixExpr) -> MatrixExpr:
        """I(ω), entry by entry."""
        entries = to_components(omega)
        n = self.dimension
        scaled = sp.Matrix(n, n, lambda i, j: self.moment(i, j) * entries[i, j] if i != j else 0)
        return Image(I, omega, scaled)


class ProductMoments(Moments):
    """The moments I_ij = a_i a_j, or such that other moments are products (special operators).

    Each kind says by `value` how I_ij follows from a_i a_j.
    """

    law = "a_i a_j"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The factors ``a_1``, …, ``a_n``."""
        return tuple(
            Parameter(
                s,
                f"factor of the moments of body axis {i}",
                self.numbers[s.name],
                "kg^(1/2) m",
                (s > 0,),
            )
            for i, s in enumerate(self.factors, 1)
        )

    @property
    def factors(self) -> tuple[sp.Symbol, ...]:
        """The symbols a_1, …, a_n."""
        return tuple(real_symbol(f"a_{i + 1}") for i in range(self.dimension))

    @property
    def definitions(self) -> Pairs:
        """The moments by the factors."""
        a = self.factors
        return tuple((self.moment(i, j), self.value(a[i] * a[j])) for i, j in pairs(self.dimension))

    @property
    def words(self) -> str:
        """A sentence on how it acts."""
        return f"The inertia takes ωᵢⱼ to Iᵢⱼ ωᵢⱼ, Iᵢⱼ = {self.law}."

    def value(self, product: sp.Expr) -> sp.Expr:
        """I_ij from the product a_i a_j."""
        return product


class MassTensor(Inertia):
    """The operator I(ω) = J ω + ω J of a rigid body with the mass tensor J = ∫ x xᵀ dm."""

    @property
    def matrix(self) -> SymmetricMatrix:
        """J."""
        return SymmetricMatrix(J, self.dimension)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The entries ``J_11``, ``J_12``, … on and above the diagonal."""
        diagonal = [self.matrix.entries[i, i] for i in range(self.dimension)]
        entries = []
        for (i, j), s in zip(self.matrix.places, self.matrix.symbols, strict=True):
            others = tuple(s + d > 0 for d in diagonal if i == j and d != s)
            words = f"entry {i + 1}{j + 1} of the mass tensor"
            entries.append(Parameter(s, words, self.numbers[s.name], MOMENT_UNIT, others))
        return tuple(entries)

    @property
    def words(self) -> str:
        """A sentence on how it acts."""
        return "The inertia takes ω to Jω + ωJ, with the mass tensor J."

    def image(self, omega: MatrixExpr) -> MatrixExpr:
        """J ω + ω J."""
        return self.matrix * omega + omega * self.matrix


def checked_moments(dimension: int, moments: Sequence[float]) -> dict[str, float]:
    """Moments by symbol name.

    Raises
    ------
    InputError
        If their number is wrong, or one is not positive.
    """
    names = labels(dimension)
    if len(moments) != len(names):
        raise InputError(
            f"moments: {len(names)} numbers are needed in {dimension} dimensions "
            f"({', '.join(names)}), not {len(moments)}"
        )
    for name, value in zip(names, moments, strict=True):
        if not (np.isfinite(value) and value > 0):
            raise InputError(f"moments: I_{name} = {value:g} must be positive and finite")
    return {f"I_{name}": float(value) for name, value in zip(names, moments, strict=True)}


def checked_mass_tensor(dimension: int, rows: Sequence[Sequence[float]]) -> dict[str, float]:
    """The entries of a mass tensor by symbol name.

    Raises
    ------
    InputError
        If it is not a symmetric n × n matrix, or its operator of inertia is not positive.
    """
    sizes = {len(row) for row in rows}
    if len(rows) != dimension or sizes != {dimension}:
        raise InputError(
            f"mass_tensor: a symmetric matrix of {dimension} rows of {dimension} numbers is needed"
        )
    matrix = np.array(rows, dtype=float)
    if not np.isfinite(matrix).all():
        raise InputError("mass_tensor: all entries must be finite")
    if np.abs(matrix - matrix.T).max() > 1e-14 * np.abs(matrix).max():
        raise InputError("mass_tensor: must be symmetric")
    least = np.linalg.eigvalsh(matrix)[:2]
    if not least.sum() > 0:
        raise InputError(
            "mass_tensor: the sum of any two of its eigenvalues is a moment of inertia and must be "
            f"positive; the two smallest are {least[0]:.6g} and {least[1]:.6g}"
        )
    places = combinations_with_replacement(range(dimension), 2)
    return {f"J_{i + 1}{j + 1}": float(matrix[i, j]) for i, j in places}


def progression(first: float, step: float, count: int) -> tuple[float, ...]:
    """The numbers first + i step, i = 0, 1, …, each the double nearest to the exact decimal.

    A sum of doubles is not: 0.4 + 3 · 0.3 is 1.2999999999999998.
    """
    return tuple(float(exact(first) + i * exact(step)) for i in range(count))


def generic_moments(dimension: int) -> tuple[float, ...]:
    """Moments of an instructive example, of no special operator."""
    if dimension == 3:
        return (2.1, 1.5, 1.0)
    if dimension == 4:
        return GENERIC
    return tuple((5 + (7 * k) % 19) / 10 for k in range(len(pairs(dimension))))


def generic_mass_tensor(dimension: int) -> tuple[tuple[float, ...], ...]:
    """A mass tensor of an instructive example, not diagonal."""
    matrix = np.diag(progression(0.4, 0.3, dimension))
    for i, j in pairs(dimension):
        matrix[i, j] = matrix[j, i] = (-1) ** (i + j) * (1 + (i + 2 * j) % 3) / 20
    return tuple(map(tuple, matrix.tolist()))
