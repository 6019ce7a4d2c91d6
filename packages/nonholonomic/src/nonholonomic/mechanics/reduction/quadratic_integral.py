"""A quadratic integral without terms linear in the velocities of the base.

On a level of the linear integrals the energy may have such terms, and is then not of the form E₂ +
E₀ required by (4.4). A combination with another integral may take its place.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from flint import fmpq

from flowlanes.errors import InputError
from flowlanes.printing.formula import text
from flowlanes.system.vectors import Vector, norm_squared, real_symbol

from ..lagrangian.mechanism import Mechanism
from .horizontal_lift import Lift, Point, PointwiseForm, Quadratic, energy, in_momenta
from .integrals import QuadraticForm, quadratic_integrals, solutions
from .momenta import ReducedMomenta
from .rational_evaluation import plain_symbols, rational_point
from .rational_functions import Value

SEED = 2008


@dataclass(frozen=True)
class EnergyLikeIntegral:
    """The integral used in place of the energy.

    Attributes
    ----------
    integral : Quadratic
    words : str
        Description of the integral.
    """

    integral: Quadratic
    words: str


@dataclass(frozen=True)
class _LinearParts:
    """E₁ of several integrals, with one row for each coordinate of the base."""

    locals: Sequence[PointwiseForm]

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols that need a value."""
        return tuple(sorted({s for local in self.locals for s in local.symbols}, key=str))

    def at(self, point: Point, like: Value) -> list[Value]:
        """The values, row by row."""
        columns = [local.at(point, like).linear for local in self.locals]
        return [column[i] for i in (0, 1) for column in columns]


def energy_like_integral(
    mechanism: Mechanism, motion: ReducedMomenta, lift: Lift
) -> EnergyLikeIntegral:
    """The energy if it has no linear part, else a combination with another integral.

    Raises
    ------
    InputError
        If none is found.
    """
    base, owner = lift.base, mechanism.name
    first = energy(motion, base)
    if solutions(mechanism, base, _LinearParts([PointwiseForm(lift, first, owner)]), 1):
        return EnergyLikeIntegral(first, "the energy")
    tied = base.motion.constraints.rows > 0
    forms = [] if tied else quadratic_integrals(mechanism, motion, base)
    others = [in_momenta(motion, base, form.matrix, form.potential) for form in forms]
    known = [first, *others]
    parts = _LinearParts([PointwiseForm(lift, each, owner) for each in known])
    for chosen in solutions(mechanism, base, parts, len(known)):
        combined = [known[i].multiple(factor) for i, factor in chosen.items()]
        total = combined[0]
        for each in combined[1:]:
            total = total + each
        if _regular(lift, total, owner):
            return EnergyLikeIntegral(total, _combination_text(chosen, forms))
    raise InputError(
        f"{owner}: on the level of its linear integral the energy has a part linear in the "
        "velocities of the base, and no integral with constant coefficients in the momenta "
        "removes it; the system is not shown to be of the form (4.4)"
    )


def _regular(lift: Lift, integral: Quadratic, owner: str) -> bool:
    """Whether E₂ is not degenerate."""
    local = PointwiseForm(lift, integral, owner)
    place = rational_point(
        [*plain_symbols(local.symbols), *lift.base.coordinates], random.Random(SEED)
    )
    (a, b), (_, c) = local.at(place, fmpq(1)).metric
    return bool(a * c != b * b)


def _combination_text(factors: Mapping[int, sp.Expr], forms: Sequence[QuadraticForm]) -> str:
    """The combination in the energy E and the momenta M."""
    E, M = real_symbol("E"), Vector("M")
    total = sp.S.Zero
    for i, factor in factors.items():
        if i == 0:
            total += factor * E
            continue
        form = forms[i - 1]
        if form.matrix == 2 * sp.eye(3):
            total += factor * norm_squared(M)
        else:
            momenta = [real_symbol(f"M_{k + 1}") for k in range(form.matrix.rows)]
            column = sp.Matrix(momenta)
            total += factor * sp.expand((column.T * form.matrix * column)[0] / 2)
        total += factor * form.potential
    return text(total)
