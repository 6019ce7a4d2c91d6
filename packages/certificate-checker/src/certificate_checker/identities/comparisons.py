"""Comparisons of formulas and polynomials at random points modulo a prime."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction

from ..claim.errors import CheckError, UndefinedError
from ..claim.formulas import Formula, walk
from ..claim.jets import Number, inverse
from ..claim.polynomials import Poly, Powers
from ..claim.residuals import gram_determinants, residuals
from ..modular.prime_field import PrimeField
from .bounds import Bounds
from .case_tree import Signs
from .error_bound import of_polynomial, prime_bits
from .generators import Generators, Sample
from .residues import Residues

#: Number of random points: equality is tested at one point, a constant ratio at two.
POINTS = 2

#: Number of primes to be tried, with 2^8 points modulo the first and 2^19 modulo the last.
ROUNDS = 12

#: Bits of the prime beyond those of a ratio, which make it improbable that another fraction with
#: small numbers is congruent to it.
SPARE = 164


class Comparisons:
    """Values of formulas and polynomials of a proof at common points.

    Parameters
    ----------
    seed : str
        Digest of the compared data, from which prime and points are derived.
    products : sequence of (number, powers)
        Products stated in the proof.
    formulas : iterable of formulas
        All formulas that are compared, besides those of the law.
    """

    def __init__(
        self,
        generators: Generators,
        seed: str,
        products: Sequence[tuple[Fraction, Powers]],
        formulas: Iterable[Formula],
        with_residuals: bool = True,
    ) -> None:
        self.generators = generators
        degrees = [root.number for root in generators.roots]
        bits = prime_bits(
            _bounds(generators, products, formulas, with_residuals),
            math.lcm(2, *degrees),
            _symbols(generators),
        )
        for number in range(ROUNDS):
            # A root of a number may not exist modulo this prime, any other root at this point.
            self.field = PrimeField(f"{seed} {number}", bits, degrees)
            draws = generators.samples(self.field, POINTS, 2 ** (8 + number))
            if draws is not None:
                break
        else:
            raise CheckError(
                "no random points were found at which the roots of a proof are defined"
            )
        self.draws = draws
        self.samples = [sample for draw in self.draws for sample in draw]
        self._memo: dict[tuple[str, Formula], list[Number] | None] = {}

    def set_signs(self, signs: Signs) -> None:
        """Set the signs used for roots from now on."""
        for sample in self.samples:
            assert isinstance(sample.functions, Residues)
            sample.functions.signs = signs

    def add_product(self, values: Sequence[Number], content: Fraction, powers: Powers) -> None:
        """Add a product that may be a radicand, with its values."""
        for sample, value in zip(self.samples, values, strict=True):
            assert isinstance(sample.functions, Residues)
            sample.functions.products.setdefault(value, []).append((content, powers))

    def formula(self, formula: Formula, where: str = "own") -> list[Number] | None:
        """Values of a formula, or None where it is not defined.

        Raises
        ------
        UnknownRootError
            If its roots are not known, or not yet known.
        """
        key = where, formula
        if key not in self._memo:
            try:
                self._memo[key] = [s.places[where](formula) for s in self.samples]
            except UndefinedError:
                self._memo[key] = None
        return self._memo[key]

    def polynomial(self, poly: Poly) -> list[Number]:
        """Values of a polynomial."""
        points = [(s.values, s.functions) for s in self.samples]
        return self.generators.ring.values(poly, points)

    def product(self, content: Fraction, powers: Powers) -> list[Number]:
        """Values of a product of powers."""
        result = [s.functions.number(content) for s in self.samples]
        for poly, power in powers:
            values = self.polynomial(poly)
            result = [
                value * (base**power if power > 0 else inverse(base) ** -power)
                for value, base in zip(result, values, strict=True)
            ]
        return result

    def fraction(self, above: Poly, below: Powers) -> list[Number]:
        """Values of a fraction."""
        values = zip(self.polynomial(above), self.product(Fraction(1), below), strict=True)
        return [upper * inverse(lower) for upper, lower in values]

    def ratio(self, poly: Poly, formula: Formula) -> Fraction | None:
        """Constant ratio of a polynomial and a formula, or None.

        Raises
        ------
        UnknownRootError
            As in `formula`.
        """
        try:
            second = [s.solver(formula) for s in self.samples]
        except UndefinedError:
            return None
        first = self.polynomial(poly)
        if any(value == 0 for value in (*first, *second)):
            return None
        ratios = {a / b for a, b in zip(first, second, strict=True)}
        return self._small_fraction(int(ratios.pop())) if len(ratios) == 1 else None

    def _small_fraction(self, residue: int) -> Fraction | None:
        """Fraction a/b ≡ residue with small a and b, or None, by Euclid's algorithm."""
        modulus = self.field.modulus
        limit = 2 ** ((modulus.bit_length() - SPARE) // 2)
        # Every remainder is factor · residue modulo p, and remainders decrease while factors grow;
        # the first small remainder gives the fraction.
        before, here, factor_before, factor = modulus, residue, 0, 1
        while here > limit:
            times = before // here
            before, here = here, before - times * here
            factor_before, factor = factor, factor_before - times * factor
        return Fraction(here, factor) if here and 0 < abs(factor) <= limit else None


def _symbols(generators: Generators) -> int:
    """Maximum number of function values that may be combined in one argument."""
    own = [a for a in generators.auxiliary if a.kind != "function"]
    calls = [node for node in walk(generators.claim.formulas) if node.kind == "call"]
    return len(own) + len(calls) + 2


def _bounds(
    generators: Generators,
    products: Sequence[tuple[Fraction, Powers]],
    formulas: Iterable[Formula],
    with_residuals: bool,
) -> Bounds:
    """Bounds of all compared expressions of a claim."""
    claim, domain = generators.claim, generators.domain
    stated = [(c, [(of_polynomial(p), n) for p, n in powers]) for c, powers in products]
    bounds = Bounds(len(generators.ring.names), generators.auxiliary, stated)
    sample: Sample = generators.sample(bounds)
    for where, formula in domain.formulas:
        bounds.note(sample.places[where](formula))
    for formula in formulas:
        bounds.note(sample.places["own"](formula))
    for value in gram_determinants(claim, sample.point) if domain.gram else ():
        bounds.note(value)
    for value in residuals(claim, sample.point) if with_residuals else ():
        bounds.note(value)
    for value in sample.point.values.values():
        bounds.note(value)
    return bounds
