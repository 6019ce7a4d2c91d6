"""Coefficients of the integration methods."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath

from ...system.tolerance import Precision
from ..machine_code.arithmetic import Arithmetic, Double, Pair
from . import dop853_doubles, verner_doubles

#: Tolerance below which rounding errors are larger than the errors of the method.
FINE = 1e-15


@dataclass(frozen=True)
class Explicit:
    """Explicit Runge–Kutta method with two error estimates.

    Attributes
    ----------
    a : tuple of rows
        Row i: weights of the rates of earlier stages in the state of stage i.
    b, e3, e5 : tuple
        Weights of the result and of the two error estimates.
    name : str
    halfway : int
        Stage at which section and guards are evaluated inside a step, besides its ends.
    steady : bool
        True for a method for the last digits, where the rounding error of the state is also used
        in the stages.
    order : int
    """

    a: tuple[tuple[Fraction, ...], ...]
    b: tuple[Fraction, ...]
    e3: tuple[Fraction, ...]
    e5: tuple[Fraction, ...]
    name: str
    halfway: int
    steady: bool = False
    order: int = 8

    @property
    def middle(self) -> int:
        """Stage with nonzero weight whose node is closest to the middle of a step."""
        # a stage with weight zero contributes nothing to the result
        weighty = [i for i, weight in enumerate(self.b) if weight != 0]
        return min(weighty, key=lambda i: abs(sum(self.a[i]) - Fraction(1, 2)))


@lru_cache
def explicit() -> Explicit:
    """Dormand and Prince's method of order 8 with 12 stages.

    Hairer, Nørsett, Wanner 1993, II.5.
    """
    return Explicit(
        a=tuple(map(_fractions, dop853_doubles.A)),
        b=_fractions(dop853_doubles.B),
        e3=_fractions(dop853_doubles.E3),
        e5=_fractions(dop853_doubles.E5),
        name="Dormand and Prince",
        halfway=9,
    )


@lru_cache
def explicit_steady() -> Explicit:
    """Verner's method of order 8 with 12 stages and positive weights.

    The norm of its weights (the root of the sum of their squares) is 0.39, compared with 7.6 for
    Dormand and Prince; errors of the rates are amplified by this factor within a step.  It needs
    more steps for the same accuracy.
    """
    return Explicit(
        a=tuple(map(_fractions, verner_doubles.A)),
        b=_fractions(verner_doubles.B),
        e3=_fractions(verner_doubles.E3),
        e5=_fractions(verner_doubles.E5),
        name="Verner",
        halfway=10,
        steady=True,
    )


@lru_cache
def explicit_fine() -> Explicit:
    """Dormand and Prince's method with coefficients of 60 digits."""
    from .dop853_coefficients import explicit_table

    table = explicit_table()
    return Explicit(table.a, table.b, table.e3, table.e5, "Dormand and Prince", 9)


def arithmetic_and_method(
    precision: Precision, tolerance: float
) -> tuple[type[Arithmetic[Any]], Explicit]:
    """Arithmetic with 16 or (quad) 30 digits, and the method for a step tolerance."""
    if precision == "quad":
        return Pair, explicit_fine()
    return Double, explicit_steady() if tolerance < FINE else explicit()


def _fractions(values: Iterable[float]) -> tuple[Fraction, ...]:
    return tuple(Fraction(float(v)) for v in values)


@dataclass(frozen=True)
class Gauss:
    """A Gauss–Legendre collocation method, of order twice its number of stages.

    Attributes
    ----------
    c, b : tuple
        Nodes and weights on [0, 1].
    a : tuple of rows
        Integrals of the Lagrange basis polynomials up to each node.
    ahead : tuple of rows
        Values of these polynomials at the nodes of the next step of the same length.
    top : tuple
        Coefficient of the highest Legendre polynomial in the interpolation through the stages.
    """

    c: tuple[Fraction, ...]
    b: tuple[Fraction, ...]
    a: tuple[tuple[Fraction, ...], ...]
    ahead: tuple[tuple[Fraction, ...], ...]
    top: tuple[Fraction, ...]


@lru_cache
def gauss(stages: int) -> Gauss:
    """Method with a given number of stages, with 70 digits.

    A polynomial p of degree < s is Σ_k (2k + 1) L_k(x) Σ_j b_j L_k(c_j) p(c_j) with the Legendre
    polynomials L_k on [0, 1], because the quadrature with s nodes is exact to degree 2s − 1.  The
    integral of L_k is a difference of its neighbours L_{k+1} and L_{k−1}.
    """
    with mpmath.workdps(80):
        nodes = sorted(_roots(stages))
        c = [(1 + x) / 2 for x in nodes]
        # the weights are 2/((1 − x²) P'(x)²) on [−1, 1], half of it on [0, 1]
        slopes = [stages * mpmath.legendre(stages - 1, x) / (1 - x * x) for x in nodes]
        b = [1 / ((1 - x * x) * d * d) for x, d in zip(nodes, slopes, strict=True)]
        at_nodes = [_legendre(stages, x) for x in c]
        expand = [
            [(2 * k + 1) * b[j] * at_nodes[j][k] for j in range(stages)] for k in range(stages)
        ]
        rows_a = [_combine(_primitives(stages, x), expand) for x in c]
        rows_ahead = [_combine(_legendre(stages, 1 + x), expand) for x in c]
        return Gauss(
            c=_exact(c),
            b=_exact(b),
            a=tuple(map(_exact, rows_a)),
            ahead=tuple(map(_exact, rows_ahead)),
            top=_exact(expand[stages - 1]),
        )


def _roots(stages: int) -> list[mpmath.mpf]:
    """Roots of the Legendre polynomial on [−1, 1], as eigenvalues of the Jacobi matrix."""
    jacobi = mpmath.matrix(stages)
    for k in range(1, stages):
        jacobi[k - 1, k] = jacobi[k, k - 1] = k / mpmath.sqrt(4 * k * k - 1)
    roots: list[mpmath.mpf] = list(mpmath.eigsy(jacobi, eigvals_only=True))
    return roots


def _legendre(count: int, x: mpmath.mpf) -> list[mpmath.mpf]:
    """L_0 … L_{count−1} on [0, 1]."""
    return [mpmath.legendre(k, 2 * x - 1) for k in range(count)]


def _primitives(count: int, x: mpmath.mpf) -> list[mpmath.mpf]:
    """The integrals of the Legendre polynomials from 0 to x."""
    values = _legendre(count + 1, x)
    higher = [(values[k + 1] - values[k - 1]) / (2 * (2 * k + 1)) for k in range(1, count)]
    return [x, *higher]


def _combine(values: list[mpmath.mpf], expand: list[list[mpmath.mpf]]) -> list[mpmath.mpf]:
    return [
        mpmath.fsum(v * row[j] for v, row in zip(values, expand, strict=True))
        for j in range(len(expand))
    ]


def _exact(values: list[mpmath.mpf]) -> tuple[Fraction, ...]:
    """Multi-precision numbers converted to fractions."""
    # 240 bits are 72 decimal digits
    scale = 2**240
    return tuple(Fraction(int(mpmath.nint(v * scale)), scale) for v in values)
