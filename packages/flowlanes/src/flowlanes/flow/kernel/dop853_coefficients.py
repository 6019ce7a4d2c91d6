"""Coefficients of Dormand and Prince's method of order 8 with arbitrary precision.

The coefficients were published with thirty digits; SciPy has sixteen of them.  They are roots of
the order conditions: one equation for each rooted tree, 200 up to order 8 (Butcher 1963; Hairer,
Nørsett, Wanner 1993, II.2).  The nodes are known in closed form.  The equations leave one
direction in the rows of the last four stages undetermined, and some of the error estimates; there
the solution closest to the published numbers is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any, NamedTuple, TypeAlias

import flint
import numpy as np
import numpy.typing as npt
from flint import arb

#: A rooted tree, as the tuple of branches at its root.
Tree: TypeAlias = tuple["Tree", ...]

#: Numbers: doubles, complex numbers, or `arb` with many digits.
Numbers: TypeAlias = npt.NDArray[Any]

ORDER = 8
STAGES = 12

#: Working precision of the coefficients, in bits.
BITS = 240

#: Relative size below which a singular value of the conditions belongs to an undetermined
#: direction: the smallest of the others is 2e-11.
FREE = 1e-13

#: Number of Newton steps; each adds nine digits.
STEPS = 20


class Table(NamedTuple):
    """Coefficients with 70 digits, as fractions.

    Attributes
    ----------
    a : tuple of rows
        Row i: weights of the rates of earlier stages in the state of stage i.
    b, c : tuple
        Weights of the result, and nodes of the stages.
    e3, e5 : tuple
        Weights of the two error estimates.
    """

    a: tuple[tuple[Fraction, ...], ...]
    b: tuple[Fraction, ...]
    c: tuple[Fraction, ...]
    e3: tuple[Fraction, ...]
    e5: tuple[Fraction, ...]


# --- order conditions -------------------------------------------------------------------------


@lru_cache
def trees(order: int) -> tuple[Tree, ...]:
    """All rooted trees with a given number of nodes."""
    return tuple(_forests(order - 1, order - 1))


def _forests(nodes: int, largest: int) -> Iterator[Tree]:
    """Forests with a given number of nodes, with trees in decreasing order of size."""
    if nodes == 0:
        yield ()
    for size in range(min(nodes, largest), 0, -1):
        same = trees(size)
        for smaller in _forests(nodes - size, size):
            for i, tree in enumerate(same):
                if not smaller or _size(smaller[0]) < size or same.index(smaller[0]) >= i:
                    yield (tree, *smaller)


@cache
def _size(tree: Tree) -> int:
    return 1 + sum(map(_size, tree))


@cache
def _density(tree: Tree) -> int:
    """Density γ(t): the product of the sizes of all subtrees."""
    product = _size(tree)
    for branch in tree:
        product *= _density(branch)
    return product


def weights(a: Numbers, b: Numbers, order: int) -> Numbers:
    """Left sides γ(t) Σ b_i Φ_i(t) of the order conditions, which are equal to 1.

    Parameters
    ----------
    a : array (stages, stages)
    b : array (stages,)
        Weights of a result, or of an error estimate, for which the sums are equal to 0.
    order : int
        Order of the largest trees.
    """
    known: dict[Tree, Any] = {}

    def branch(tree: Tree) -> Numbers:
        """Factor A Φ(t) of a tree that is a branch of another tree."""
        if tree not in known:
            known[tree] = a @ stages(tree)
        result: Numbers = known[tree]
        return result

    def stages(tree: Tree) -> Numbers:
        product = b * 0 + 1
        for part in tree:
            product = product * branch(part)
        result: Numbers = product
        return result

    conditions = [_density(t) * (b @ stages(t)) for n in range(1, order + 1) for t in trees(n)]
    return np.array(conditions)


# --- roots ------------------------------------------------------------------------------------


def _root(
    function: Callable[[Numbers], Numbers],
    right: Numbers | arb,
    start: Numbers,
) -> Numbers:
    """Solution of f(x) = right that is closest to doubles that nearly solve it.

    Newton's method with the pseudo-inverse of the Jacobian at the starting point, so that there is
    no motion along the manifold of solutions.
    """
    step = 1e-30
    columns = [function(start + 1j * step * unit).imag / step for unit in np.eye(len(start))]
    inverse = _exact(np.linalg.pinv(np.array(columns).T, rcond=FREE))
    x = _exact(start)
    for _ in range(STEPS):
        change = _middles(inverse @ (right - function(x)))
        x = x + change
        if max(map(abs, change)) < arb(2) ** -BITS:
            result: Numbers = x
            return result
    raise ArithmeticError("the order conditions were not solved")


def _exact(values: Numbers) -> Numbers:
    """Doubles converted to multi-precision numbers."""
    result: Numbers = np.vectorize(arb, otypes=[object])(values)
    return result


def _middles(values: Numbers) -> Numbers:
    """Midpoints of balls, without their error bounds."""
    return np.array([value.mid() for value in values])


def _fractions(values: Numbers) -> tuple[Fraction, ...]:
    """Numbers converted exactly to fractions."""
    pairs = (arb(value).mid().man_exp() for value in values)
    return tuple(int(mantissa) * Fraction(2) ** int(exponent) for mantissa, exponent in pairs)


# --- the method -------------------------------------------------------------------------------


def _nodes() -> Numbers:
    """Nodes of the stages (Hairer, Nørsett, Wanner 1993, II.5)."""
    root = arb(6).sqrt()
    irrational = [arb(0), (12 - 2 * root) / 135, (6 - root) / 45, (6 - root) / 30, (6 + root) / 30]
    rational = [(1, 3), (1, 4), (4, 13), (127, 195), (3, 5), (6, 7), (1, 1)]
    return np.array(irrational + [arb(p) / q for p, q in rational])


@lru_cache
def explicit_table() -> Table:
    """Dormand and Prince's method with all digits, starting from the doubles of SciPy."""
    from scipy.integrate import DOP853

    doubles = DOP853.A[:STAGES, :STAGES]
    places, used = np.nonzero(doubles), np.nonzero(DOP853.B)
    count = len(places[0])

    def method_of(
        x: Numbers,
    ) -> tuple[Numbers, Numbers]:
        return _array_of((STAGES, STAGES), places, x[:count]), _array_of(STAGES, used, x[count:])

    def conditions(x: Numbers) -> Numbers:
        a, b = method_of(x)
        return np.concatenate([weights(a, b, ORDER), a.sum(axis=1)])

    with flint.ctx.workprec(BITS + 60):
        c = _nodes()
        ones = [arb(1)] * sum(len(trees(n)) for n in range(1, ORDER + 1))
        start = np.concatenate([doubles[places], DOP853.B[used]])
        a, b = method_of(_root(conditions, np.concatenate([ones, c]), start))
        return Table(
            a=tuple(_fractions(a[i, :i]) for i in range(STAGES)),
            b=_fractions(b),
            c=_fractions(c),
            e3=_fractions(b - _third_order(c)),
            e5=_fractions(_fifth_order(a, DOP853.E5[:STAGES])),
        )


def _array_of(
    shape: int | tuple[int, int],
    indices: tuple[Sequence[int] | npt.NDArray[np.intp], ...],
    values: Numbers,
) -> Numbers:
    """Array that is zero except at given indices."""
    array = np.zeros(shape, values.dtype)
    array[indices] = values
    return array


def _third_order(c: Numbers) -> Numbers:
    """Weights of the result of order 3: a quadrature with the nodes 0, c₉ and 1."""
    middle = c[8]
    inner = 1 / (6 * middle * (1 - middle))
    last = arb(1) / 2 - inner * middle
    return _array_of(STAGES, ([0, 8, 11],), np.array([1 - inner - last, inner, last]))


def _fifth_order(a: Numbers, doubles: Numbers) -> Numbers:
    """Fifth-order error estimate, which vanishes for all trees with at most 5 nodes."""
    places = np.nonzero(doubles)

    def conditions(x: Numbers) -> Numbers:
        matrix = a if x.dtype == object else np.array(a, dtype=float)
        return weights(matrix, _array_of(STAGES, places, x), 5)

    return _array_of(STAGES, places, _root(conditions, arb(0), doubles[places]))
