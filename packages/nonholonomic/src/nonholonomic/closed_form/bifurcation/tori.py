"""Tori over the ovals of a curve of genus two, and the motions at their ends.

On a level of the integrals z₁ lies between the first and the second pole of y² = P(z), z₂ between
the second and the third, each where P ≥ 0: in ovals.  A pair of ovals is a torus of the points
(z₁, y₁, z₂, y₂); over each of them lie eight states, one for every choice of the signs of the
components ν_i.  As νᵢ² has a simple zero at the pole e_i, a component changes its sign wherever a
coordinate turns at that pole, once in every round of an oval that ends there.  The states over a
pair of ovals are therefore eight sheets over a torus, exchanged by the flips of the two rounds,
and fall into 8/|G| tori, G being the group that the flips generate.

Where a root of P meets a pole e_i or another root at z*, P = c (z − z*)² + … there, and a
coordinate can rest at z* while the other one moves: an invariant set of circles, surrounded by
tori if c < 0 (an oval has shrunk; stable) and with motions that leave it and come back if c > 0
(two ovals meet, or z = e_i repels; unstable).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise, product

from flint import arb, fmpq, fmpq_poly

from .arrangement import highest, lowest, ordered_roots, rational, short_rational

#: One bit for each of the three components of ν.
SHEETS = 8


@dataclass(frozen=True, order=True)
class Oval:
    """An interval in which a separated coordinate moves.

    Attributes
    ----------
    low, high : int
        Number 1, 2, 3 of the pole at that end; 0 where the end is another root.
    """

    low: int
    high: int

    @property
    def flips(self) -> int:
        """Components of ν that change sign during one revolution, as bits."""
        return _bit(self.low) ^ _bit(self.high)

    @property
    def text(self) -> str:
        """The interval as text, with e for poles and r for other roots."""
        low, high = (f"e{end}" if end else "r" for end in (self.low, self.high))
        return f"[{low}, {high}]"


@dataclass(frozen=True)
class Family:
    """The tori over one pair of ovals.

    Attributes
    ----------
    first, second : Oval
        The intervals of z₁ and z₂.
    tori : int
        Number of tori in the phase space on every level of the region.
    nonvanishing : tuple of int
        Components of ν (1, 2, 3) that never vanish on these tori.
    two_way : bool
        Whether a torus contains the motions with ν′ reversed as well.
    """

    first: Oval
    second: Oval
    tori: int
    nonvanishing: tuple[int, ...]
    two_way: bool


def _bit(pole: int) -> int:
    return 1 << (pole - 1) if pole else 0


def group(flips: Iterable[int]) -> set[int]:
    """All sign changes of ν that are compositions of flips."""
    elements = {0}
    for flip in flips:
        elements |= {flip ^ other for other in elements}
    return elements


def family(first: Oval, second: Oval) -> Family:
    """The tori over a pair of ovals."""
    reached = group((first.flips, second.flips))
    nonvanishing = tuple(i for i in (1, 2, 3) if not any(flips & _bit(i) for flips in reached))
    # At the lower ends y₁ = y₂ = 0.  Reversing the motion there changes only the sign of ν_i′,
    # where i is a pole at which a coordinate turns; a sheet is identified by the sign of that ν_i′.
    reversal = _bit(first.low) ^ _bit(second.low)
    return Family(first, second, SHEETS // len(reached), nonvanishing, reversal in reached)


def families(poles: Sequence[fmpq], cofactor: fmpq_poly) -> tuple[Family, ...]:
    """The tori of a level with the curve y² = ∏(z − e_i) · cofactor(z).

    Parameters
    ----------
    poles : three fmpq
        Increasing.
    cofactor : fmpq_poly
        With simple roots, none of them a pole.
    """
    lines = [fmpq_poly([-pole, 1]) for pole in poles]
    whole = lines[0] * lines[1] * lines[2] * cofactor
    roots = ordered_roots([cofactor, *lines])
    low, middle, high = (next(n for n, r in enumerate(roots) if r[1] == i) for i in (1, 2, 3))
    first, second = (
        ovals(roots[a : b + 1], lambda z: whole(z) > 0) for a, b in ((low, middle), (middle, high))
    )
    return tuple(family(a, b) for a, b in product(first, second))


def ovals(roots: Sequence[tuple[arb, int]], is_allowed: Callable[[fmpq], bool]) -> tuple[Oval, ...]:
    """Intervals between neighbouring roots in which a condition holds.

    Parameters
    ----------
    roots : sequence of (arb, int)
        Increasing, each with the number of its pole or 0.
    is_allowed : callable
        The condition on a rational number.
    """
    return tuple(
        Oval(low, high)
        for (below, low), (above, high) in pairwise(roots)
        if is_allowed(rational(short_rational(highest(below), lowest(above))))
    )
