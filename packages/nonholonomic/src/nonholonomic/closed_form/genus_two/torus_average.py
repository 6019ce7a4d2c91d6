"""Means over the torus to many digits: the trapezoidal rule with theta functions in balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flint import arb, arb_mat, ctx

from .quadrature import Series
from .theta import Theta
from .torus import InvariantTorus

#: Working precision of a mean.
BITS = 128
#: Number of grid points beyond which the mean is computed in doubles.
_MOST = 70_000


def mean(torus: InvariantTorus, function: Callable[..., arb], rough: Series) -> arb | None:
    """The mean of a function of ν and ν′ on the torus, to about 30 digits.

    Parameters
    ----------
    function : callable
        Six balls, ν and ν′ ↦ a ball.
    rough : Series
        The same function in double precision: its grid is doubled, and its periods kept.

    Returns
    -------
    arb or None
        None when the grid would be too fine.  The error of the rule decreases as the square of the
        truncation error of the series in doubles; 1e-28 of the mean is put into the radius for it,
        an estimate, not a proven bound.
    """
    periods = [1 if not any(waves % 2) else 2 for waves in (rough.first, rough.second)]
    sizes = [size * period for size, period in zip(rough.grid, periods, strict=True)]
    if sizes[0] * sizes[1] > _MOST:
        return None
    with ctx.workprec(BITS):
        places = [
            [arb(period * j) / size for j in range(size)]
            for size, period in zip(sizes, periods, strict=True)
        ]
        tables = [_table(theta, places, torus.along) for theta in torus.thetas]
        total = arb(0)
        for i in range(sizes[0]):
            for j in range(sizes[1]):
                N, rate = [], []
                for factor, (values, slopes) in zip(torus.factors, tables, strict=True):
                    N.append(factor * values[i, j])
                    rate.append(factor * slopes[i, j])
                square = N[0] * N[0] + N[1] * N[1] + N[2] * N[2]
                pull = (N[0] * rate[0] + N[1] * rate[1] + N[2] * rate[2]) / square
                scale = square.rsqrt()
                total += function(
                    *(x * scale for x in N),
                    *((r - pull * x) * scale for r, x in zip(rate, N, strict=True)),
                )
        average = total / (sizes[0] * sizes[1])
        return average + arb(0, abs(average) * arb("1e-28"))


def _table(
    theta: Theta, places: Sequence[Sequence[arb]], along: Sequence[arb]
) -> tuple[arb_mat, arb_mat]:
    """θ and its derivative on a grid, by products of matrices."""
    b = theta.characteristic[1]
    terms = theta.terms(BITS)
    sides = []
    for axis in (0, 1):
        phases = [[p[axis] * (x + arb(b[axis]) / 2) for p, _ in terms] for x in places[axis]]
        sides.append(
            (
                arb_mat([[x.cos_pi() for x in row] for row in phases]),
                arb_mat([[x.sin_pi() for x in row] for row in phases]),
            )
        )
    (cos_1, sin_1), (cos_2, sin_2) = sides
    count = len(terms)
    weights, rates = arb_mat(count, count), arb_mat(count, count)
    for k, (p, weight) in enumerate(terms):
        weights[k, k] = weight
        rates[k, k] = -arb.pi() * (p[0] * along[0] + p[1] * along[1]) * weight
    right_cos, right_sin = cos_2.transpose(), sin_2.transpose()
    values = cos_1 * weights * right_cos - sin_1 * weights * right_sin
    slopes = sin_1 * rates * right_cos + cos_1 * rates * right_sin
    return values, slopes
