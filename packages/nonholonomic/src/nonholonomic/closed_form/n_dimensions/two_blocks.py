"""Bodies with the symmetry SO(r)×SO(n − r) without twist: one degree of freedom.

Let the moments be A for planes of the first r axes, B for those of the last n − r and C between
(with m R² added for a ball), γ = (γ′, γ″), s = γ′² and γ̇ = −εu; ε = 1 about a fixed point and on a
plane, a/(R + a) on a sphere.  The bivectors

    L′ = φ′^(1/2ε) u′∧γ′,    φ′ = A s + C (1 − s),    L″ = φ″^(1/2ε) u″∧γ″,    φ″ = B (1 − s) + C s

are constant in the body (borisov-mamaev-2008/docs/open-problems.md), so that γ′ and γ″ stay in
two planes.  With q = 1 − 1/ε the energy is

    2E s(1 − s) = L′² (1 − s) φ′^q + L″² s φ″^q + C ṡ²/(4ε²),

and the angles in the planes grow at the rates |ε| |L′|/(s φ′^(1/2ε)) and
|ε| |L″|/((1 − s) φ″^(1/2ε)).  Where L′ = 0, γ′ moves on a line, and passes through the origin.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

from flint import acb, arb, fmpq

from flowlanes.formulas.balls import ball

from ..one_degree.divided_differences import Argument, Formula, power
from ..one_degree.uniformisation import Equation


@dataclass(frozen=True)
class Blocks:
    """The moments of a body with two blocks of axes.

    Attributes
    ----------
    first, second : tuple of int
        The axes of the blocks.
    A, B, C : Fraction
        Moments in the first block, in the second, and between.
    """

    first: tuple[int, ...]
    second: tuple[int, ...]
    A: Fraction
    B: Fraction
    C: Fraction


def blocks_of(n: int, K: Mapping[tuple[int, int], Fraction], least: int) -> Blocks | None:
    """Two blocks of at least the given sizes with moments K_ij; None if there are none."""
    for size in range(least, n // 2 + 1):
        for first in combinations(range(n), size):
            second = tuple(i for i in range(n) if i not in first)
            between = {K[i, j] for i in first for j in second}
            # A single axis has no moment of its own.
            own, other = (
                {K[pair] for pair in combinations(block, 2)} or set(between)
                for block in (first, second)
            )
            if len(own) == len(other) == len(between) == 1:
                return Blocks(first, second, own.pop(), other.pop(), between.pop())
    return None


@dataclass(frozen=True)
class Half:
    """One part of γ.

    Attributes
    ----------
    axes : tuple of int
    own : arb
        The moment in its block.
    L : arb
        |L|; zero where the part moves on a line.
    """

    axes: tuple[int, ...]
    own: arb
    L: arb

    @property
    def turns(self) -> bool:
        """Whether the part turns in its plane."""
        return not self.L.is_zero()


@dataclass(frozen=True)
class Level:
    """The values of the constants.

    Attributes
    ----------
    C : arb
        The moment between the blocks.
    epsilon : Fraction
    energy : arb
        2E.
    halves : (Half, Half)
    """

    C: arb
    epsilon: Fraction
    energy: arb
    halves: tuple[Half, Half]

    @property
    def turning(self) -> int:
        """The number of parts that turn."""
        return sum(half.turns for half in self.halves)

    @property
    def exponent(self) -> fmpq:
        """1/2ε."""
        half = 1 / (2 * self.epsilon)
        return fmpq(half.numerator, half.denominator)

    @property
    def equation(self) -> Equation:
        """The equation of s."""
        first, second = self.halves

        def squared(half: Half, x: Argument) -> Argument:
            phi = x * (half.own - self.C) + self.C
            return half.L * half.L * power(phi, 1 - 2 * self.exponent)

        def numerator(s: Argument) -> Argument:
            value = self.energy * s * (1 - s)
            if first.turns:
                value = value - (1 - s) * squared(first, s)
            return value - s * squared(second, 1 - s) if second.turns else value

        def beyond_low(s: Argument) -> Argument:
            return self.energy * (1 - s) - squared(second, 1 - s)

        def beyond_high(s: Argument) -> Argument:
            return self.energy * s - squared(first, s)

        def constant(s: Argument) -> arb:
            return self.energy

        def denominator(s: Argument) -> arb:
            inertia: arb = self.C / ball(4 * self.epsilon**2)
            return inertia

        inner: dict[tuple[bool, bool], Formula] = {
            (True, True): numerator,
            (False, True): beyond_low,
            (True, False): beyond_high,
            (False, False): constant,
        }
        closed = (not first.turns, not second.turns)
        edges = (arb(0), arb(1))
        return Equation(numerator, denominator, *edges, inner[first.turns, second.turns], closed)

    def rates(self, s: acb, _: acb) -> list[acb]:
        """The rates of the angles of the turning parts."""
        size, found = ball(abs(self.epsilon)), []
        for half, x in zip(self.halves, (s, 1 - s), strict=True):
            if half.turns:
                phi = half.own * x + self.C * (1 - x)
                found.append(size * half.L * power(phi, -self.exponent) / x)
        return found
