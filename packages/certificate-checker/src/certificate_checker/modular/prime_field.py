"""Prime field with random elements and roots."""

from __future__ import annotations

import hashlib
import math
from fractions import Fraction

from flint import fmpz, fmpz_mod, fmpz_mod_ctx

from ..claim.errors import CheckError, UndefinedError
from ..claim.jets import Number

#: Number of candidates for a prime; about one in 500 is prime.
CANDIDATES = 1_000_000


class PrimeField:
    """Residues modulo a random prime p ≡ 1 modulo the degrees of roots.

    All random choices are derived from SHAKE-256 of the seed, so a verdict can be reproduced.

    Parameters
    ----------
    seed : str
    bits : int
        Bits of the prime.
    degrees : iterable of int
        Degrees of roots; n is their least common multiple, and p = 1 + n c with c prime to n.
    """

    def __init__(self, seed: str, bits: int, degrees: list[int]) -> None:
        self._seed, self._bits = seed, bits
        self._order = math.lcm(2, *degrees)
        for number in range(CANDIDATES):
            cofactor = self._number(f"prime {number}") % 2**bits // self._order
            modulus = 1 + self._order * cofactor
            if (
                modulus >> (bits - 1)
                and math.gcd(cofactor, self._order) == 1
                # The fast test comes first; only the second one is a proof.
                and fmpz(modulus).is_probable_prime()
                and fmpz(modulus).is_prime()
            ):
                break
        else:
            raise CheckError("no prime was found")
        self.modulus, self._cofactor = modulus, cofactor
        self._context = fmpz_mod_ctx(modulus)
        self._unit = self._root_of_unity()

    def _number(self, word: str) -> int:
        """Integer below 2^(bits + 128)."""
        digest = hashlib.shake_256(f"{self._seed} {word}".encode()).digest((self._bits + 135) // 8)
        return int.from_bytes(digest, "big")

    def random(self, word: str) -> Number:
        """Element that is the same for the same word."""
        return self._context(self._number(word))

    def number(self, value: Fraction) -> Number:
        """Rational number as a residue; UndefinedError if its denominator is zero."""
        if value.denominator == 1:
            return self._context(value.numerator)
        below = self._context(value.denominator)
        if below == 0:
            raise UndefinedError("a division by zero")
        return self._context(value.numerator) / below

    def _root_of_unity(self) -> Number:
        """Element of order n."""
        primes = [
            q for q in range(2, self._order + 1) if self._order % q == 0 and fmpz(q).is_prime()
        ]
        for number in range(CANDIDATES):
            # u^c has an order that divides n; the order is n if no u^(c n/q) is 1.
            unit = self.random(f"unit {number}") ** self._cofactor
            if all(unit ** (self._order // q) != 1 for q in primes):
                return unit
        raise CheckError("no root of unity was found")

    def is_square(self, element: fmpz_mod) -> bool:
        """True if an element is a square; UndefinedError at zero."""
        if element == 0:
            raise UndefinedError("zero has no inverse")
        return bool(element ** ((self.modulus - 1) // 2) == 1)

    def root(self, element: fmpz_mod, degree: int, which: int) -> Number:
        """One of the roots of an element; UndefinedError if it is not one of the powers used.

        Let p − 1 = s t, where t is prime to the degree and all prime factors of s divide the
        degree.  The s-th powers form the group of order t.  In it every element has a root, which
        is a power of the element.
        """
        order = self.modulus - 1
        while (common := math.gcd(order, degree)) > 1:
            order //= common
        if element**order != 1:
            raise UndefinedError("a root of an element that is not a power")
        first = element ** pow(degree, -1, order)
        return first * self._unit ** (which * (self._order // degree))
