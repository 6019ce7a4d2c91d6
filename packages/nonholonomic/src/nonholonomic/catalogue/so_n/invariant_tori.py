"""The flow of the n-dimensional Veselova top or rubber ball on a level of its quadratic integrals.

For a rigid body with the mass tensor J = diag(c_1, …, c_n) let σ_1 < … < σ_{n−1} be the eigenvalues
of J across γ: the sphero-conical coordinates of γ, c_k < σ_k < c_{k+1}.  There the integrals
(:mod:`nonholonomic.catalogue.so_n.quadratic_pencil`) say

    P(λ) F_λ = 2E ∏ (λ − f_j),    P(λ) = ∏ (λ − c_i),    j = 1, …, n − 2,

and, as the operator of inertia is diagonal in the same frame,

    β_k ∏_{l≠k} (σ_k − σ_l)² σ̇_k² = −8E P(σ_k) ∏ (σ_k − f_j),    β_k = tr J + mR² − Σ_{l≠k} σ_l.

The roots c_i and f_j in order bound n − 1 intervals, and σ_k moves to and fro in the k-th.  With
σ_k = m_k − a_k cos φ_k this becomes a flow on the torus of the angles φ_1, …, φ_{n−1}.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol

_SMALLEST = 3


@arguments_checked
def torus_system(
    masses: Sequence[float | sp.Expr], zeros: Sequence[float | sp.Expr], shift: float | sp.Expr = 0
) -> System:
    """The flow on the invariant torus with given zeros of the integrals, at the energy E = ½.

    Parameters
    ----------
    masses : sequence of n numbers
        The distinct eigenvalues c_1 < … < c_n of the mass tensor, kg m².
    zeros : sequence of n − 2 numbers
        f_1 < … < f_{n−2}, different from all c_i, such that each of the n − 1 intervals between the
        first and second, third and fourth, … of all these numbers in order contains a σ_k.
    shift : number, optional
        m R² of a rubber ball; 0 for a body about a fixed point.

    Returns
    -------
    System
        With the state φ_1, …, φ_{n−1} (radians), the definitions σ_k and an invariant measure.

    Raises
    ------
    InputError
        If the numbers are not in order, not distinct, or belong to no motion.

    Examples
    --------
    >>> system = torus_system([1, 4, 13, 30], [7, 20])
    >>> system.symbols
    (phi_1, phi_2, phi_3)
    >>> system.scalar_definitions[0]
    (sigma_1, 5/2 - 3*cos(phi_1)/2)
    """
    c, f = [_exact(x) for x in masses], [_exact(x) for x in zeros]
    ends = _intervals(c, f)
    total = sum(c, _exact(shift))
    n = len(ends) + 1
    phi = [real_symbol(f"phi_{k + 1}") for k in range(n - 1)]
    sigma = [real_symbol(f"sigma_{k + 1}") for k in range(n - 1)]
    rates, density = {}, {}
    for k in range(n - 1):
        others = [x for i, x in enumerate(sigma) if i != k]
        roots = [x for i, pair in enumerate(ends) if i != k for x in pair]
        beyond = sp.Mul(*(_distance(sigma[k], x, ends[k]) for x in roots))
        gap = sp.Mul(*(sigma[k] - x if k > i else x - sigma[k] for i, x in _others(sigma, k)))
        factor = total - sp.Add(*others)
        rates[phi[k]] = 2 * sp.sqrt(beyond / factor) / gap
        density[beyond] = -sp.Rational(1, 2)
    for i in range(n - 1):
        for k in range(i + 1, n - 1):
            density[sigma[k] - sigma[i]] = sp.S.One
    return System(
        name="invariant-torus",
        title=f"Invariant torus of the Veselova top in {n} dimensions",
        field=rates,
        definitions={
            s: (low + high) / 2 - (high - low) / 2 * sp.cos(angle)
            for s, (low, high), angle in zip(sigma, ends, phi, strict=True)
        },
        laws=(Measure("measure", density, "invariant measure"),),
    )


def _others(sigma: Sequence[sp.Symbol], k: int) -> list[tuple[int, sp.Symbol]]:
    return [(i, x) for i, x in enumerate(sigma) if i != k]


def _distance(sigma: sp.Symbol, root: sp.Expr, interval: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """|σ − root| for σ in an interval that does not contain the root."""
    return sigma - root if root <= interval[0] else root - sigma


def _exact(number: float | sp.Expr) -> sp.Expr:
    return sp.nsimplify(str(number)) if isinstance(number, float) else sp.sympify(number)


def _intervals(c: Sequence[sp.Expr], f: Sequence[sp.Expr]) -> list[tuple[sp.Expr, sp.Expr]]:
    """The interval of each σ_k, between consecutive roots."""
    n = len(c)
    if n < _SMALLEST or len(f) != n - 2:
        raise InputError(
            f"masses and zeros: n ≥ {_SMALLEST} and n − 2 numbers are needed, not {n} and {len(f)}"
        )
    for name, numbers in (("masses", c), ("zeros", f)):
        if any(x >= y for x, y in pairwise(numbers)):
            raise InputError(f"{name}: the numbers must be distinct and in increasing order")
    roots = sorted([*c, *f])
    if len(set(roots)) != len(roots):
        raise InputError("zeros: each must differ from all masses")
    ends = list(zip(roots[::2], roots[1::2], strict=True))
    for k, (low, high) in enumerate(ends):
        if not (c[k] <= low and high <= c[k + 1]):
            raise InputError(
                f"zeros: there is no motion with them; σ_{k + 1} would have to lie both between "
                f"{c[k]} and {c[k + 1]} and between {low} and {high}"
            )
    return ends
