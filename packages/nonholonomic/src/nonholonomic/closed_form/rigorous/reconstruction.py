"""Attitude and path in space as formulas of ν and ν′, with error bounds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from flint import arb, arb_mat

from flowlanes.formulas.balls import components
from flowlanes.system.arrays import FloatArray
from flowlanes.system.vectors import real_symbol

from ...mechanics.rolling.attitude import attitude, place_rates
from ...mechanics.rotations import rotation_rows
from ..genus_two.attitude_one_axis import rotated_triad
from ..genus_two.reconstruction import spinning_pair
from ..genus_two.separated_motion import SeparatedMotion, steps_from_torus
from ..one_degree.vectors import quaternion_near, quaternion_products
from .branch_formula import Branch

_AXES = sp.Matrix(3, 3, lambda k, s: real_symbol(f"axis_{k + 1}{s + 1}"))
_TRIAD = sp.Matrix(3, 3, lambda k, b: real_symbol(f"triad_{k + 1}{b + 1}"))


@dataclass(frozen=True)
class Pair:
    """Two vectors in body axes that determine an attitude.

    Attributes
    ----------
    first, second : vectors
        The first is fixed in space.
    rate : formula or None
        At which the second turns about the first, in t; None where it is fixed too.
    """

    first: sp.MatrixExpr
    second: sp.MatrixExpr
    rate: sp.Expr | None

    @classmethod
    def of_motion(cls, separated_motion: SeparatedMotion) -> Pair | None:
        """Two fixed vectors, or a fixed one and another that stays away from it.

        None if none is fixed.
        """
        fixed = separated_motion.separable.fixed
        if not fixed:
            return None
        return (
            cls(fixed[0], fixed[1], None)
            if len(fixed) > 1
            else cls(*spinning_pair(separated_motion))
        )

    def turning(self, separated_motion: SeparatedMotion) -> Branch:
        """The rate in τ, as a function of ν and ν′."""
        formula = components(separated_motion.separable.time_rescaling)[0] * self.rate
        return Branch.of(separated_motion, [formula])


@dataclass(frozen=True)
class Turn:
    """A triad fixed in space, and its vectors in body axes.

    Attributes
    ----------
    body : Branch
        The triad in body axes, nine formulas, row by row.
    axes : arb_mat (3, 3)
        The triad in space axes, as rows.
    """

    body: Branch
    axes: arb_mat

    @classmethod
    def through(
        cls,
        separated_motion: SeparatedMotion,
        pair: Pair,
        there: Sequence[Sequence[arb]],
        quaternion: Sequence[arb],
    ) -> Turn:
        """The triad of a start with ν, ν′ and the attitude (w, x, y, z, body to space)."""
        body = Branch.of(separated_motion, list(_triad(pair.first, pair.second)))
        rows = arb_mat(3, 3, body.at(*there))
        length = sum((x * x for x in quaternion), arb(0)).sqrt()
        return cls(body, rows * _matrix([x / length for x in quaternion]).transpose())

    def after_rotation(self, angle: arb) -> Turn:
        """The triad rotated in space by an angle (arb) about its first vector."""
        rows = rotated_triad(self.axes.table(), angle.cos(), angle.sin())
        return Turn(self.body, arb_mat([list(row) for row in rows]))

    def matrix(self, there: Sequence[Sequence[arb]]) -> arb_mat:
        """The matrix from body to space components (arb_mat), at ν and ν′."""
        return self.axes.transpose() * arb_mat(3, 3, self.body.at(*there))

    def quaternion(self, there: Sequence[Sequence[arb]], rough: FloatArray) -> list[arb]:
        """The quaternion (w, x, y, z) at ν and ν′, with the sign closer to an approximate one."""
        return quaternion_near(self.matrix(there).table(), rough)


def _triad(first: sp.MatrixExpr, second: sp.MatrixExpr) -> sp.MatrixExpr:
    """Orthonormal: along the first vector, across it towards the second, and normal to both."""
    along, other = (sp.Matrix(components(vector)) for vector in (first, second))
    normal = along.cross(other)
    one, three = (u / sp.sqrt(u.dot(u)) for u in (along, normal))
    return sp.Matrix([one.T, three.cross(one).T, three.T])


def _matrix(q: Sequence[arb]) -> arb_mat:
    """Body to space, of a unit quaternion."""
    return arb_mat(rotation_rows(q))


@dataclass(frozen=True)
class PathRates:
    """Rates of coordinates in space, in τ: functions on the torus times axes.

    Attributes
    ----------
    functions : Branch
        The integrands, in ν and ν′.
    shares : tuple of tuples of (int, (int, int))
        For every coordinate, which functions, and the entry of `Turn.axes` that multiplies each.
    """

    functions: Branch
    shares: tuple[tuple[tuple[int, tuple[int, int]], ...], ...]


def path_rates(separated_motion: SeparatedMotion, pair: Pair) -> PathRates | None:
    """Derivatives of the coordinates in space other than the attitude; None if there are none.

    Quaternions enter the rates of a path quadratically, hence linearly in the rotation matrix,
    which is Σ axis_k triad_kᵀ.  The coefficient of each component of an axis is a function on the
    torus that at most changes sign with the periods, which need not hold for the rate itself.
    """
    names = attitude.symbols
    rates = place_rates(separated_motion.separable.system)
    if not rates:
        return None
    products = quaternion_products((_AXES.T * _TRIAD).tolist())
    clock = components(separated_motion.separable.time_rescaling)[0]
    functions: list[sp.Expr] = []
    shares = []
    for rate in rates:
        total = sp.S.Zero
        for powers, coefficient in sp.Poly(rate, *names).terms():
            both = [i for i, power in enumerate(powers) for _ in range(power)]
            total += coefficient * (products[both[0]][both[1]] / 4 if both else 1)
        linear = sp.Poly(total, *_AXES)
        own = []
        for place, axis in enumerate(_AXES):
            function = clock * linear.coeff_monomial(axis)
            if function != 0:
                if function not in functions:
                    functions.append(function)
                own.append((functions.index(function), divmod(place, 3)))
        shares.append(tuple(own))
    triad = list(zip(_TRIAD, _triad(pair.first, pair.second), strict=True))
    needed = [*functions, *(formula for _, formula in triad)]
    _, steps = steps_from_torus(separated_motion.separable, needed)
    return PathRates(Branch(functions, separated_motion.values, (*steps, *triad)), tuple(shares))
