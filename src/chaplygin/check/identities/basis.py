"""The basis of a proof: equations, divisors and signs, compared with the claim."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..claim.errors import CheckError
from ..claim.formulas import Formula
from ..claim.json_data import as_list, field, mapping
from ..claim.polynomials import Poly, monic
from .case_tree import Signs
from .divisors import Entry, nonzero_factors, read_divisors
from .equations import read_equations
from .generators import POINTS, Generators, Sample
from .positivity import (
    check_radicand_positive,
    factors_of,
    learn_positive,
    positive_factors,
    read_derived,
    settle,
)
from .roots import check_bases, check_functions, check_radicands, check_roots, has_formal_roots

#: Points at which roots are compared of which the sign is not said.
FORMAL = 10


@dataclass(frozen=True)
class Basis:
    """The basis of a proof, checked against the claim.

    Attributes
    ----------
    equations : tuple of Poly
        Vanish on the level.
    nonzero : frozenset of str
        Keys of polynomials that do not vanish where the law is defined.
    signs : Signs
        Known signs, the assumed ones included.
    certain : Signs
        Signs that are known without assuming any.
    radicands : tuple of Entry
        Are positive where the law is defined.
    """

    generators: Generators
    samples: list[Sample]
    equations: tuple[Poly, ...]
    nonzero: frozenset[str]
    signs: Signs
    certain: Signs
    radicands: tuple[Entry, ...]


def read_basis(
    data: Mapping[str, object],
    generators: Generators,
    region: Sequence[Formula],
    what: str,
) -> Basis:
    """Equations, divisors and signs of a proof, compared with the claim at random points.

    All roots of the law must be those of factors with known signs: on others a formula may be
    another polynomial than at the points that happened to be drawn.
    """
    ring = generators.ring
    count = FORMAL if has_formal_roots(generators) else POINTS
    samples = generators.samples(count, positive_factors(data, ring, what))
    entries, matched, bases = read_divisors(data, generators, samples, what)
    nonzero = nonzero_factors(generators, entries)
    certain = Signs()
    for auxiliary in generators.auxiliary:
        if auxiliary.positive:
            certain.learn(generators.ring.generator(auxiliary.name), 1)
    positives = as_list(field(data, "positive", what), f"what is positive in {what}")
    for item in positives:
        learn_positive(item, generators, samples, certain, what)
    signs = certain.copy()
    for poly, sign in generators.signs:
        if not poly.is_constant() and monic(poly)[0] not in nonzero:
            raise CheckError(f"{what} assumes the sign of something that may vanish")
        signs.learn(poly, sign)
    radicands = tuple(entries[i] for i in matched if i is not None)
    derived = read_derived(positives, generators, what)
    written = [
        ring.read(field(mapping(item, what), "poly", what), what)
        for item in as_list(field(data, "equations", what), what)
    ]
    polys = [ring.read(field(mapping(item, what), "poly", what), what) for item in positives]
    nonzero |= factors_of(certain, polys)
    settle(certain, radicands, derived, nonzero, written)
    left = settle(signs, radicands, derived, nonzero, written)
    nonzero |= factors_of(signs, polys)
    if left:
        raise CheckError(f"what is positive in {what}: a sum is not")
    check_roots(generators, signs, nonzero, entries, matched, what)
    check_radicands(generators, signs, entries, matched, what)
    check_bases(signs, entries, bases, what)
    check_functions(generators, samples, nonzero, signs, what)
    for item in positives:
        check_radicand_positive(mapping(item, what), generators, signs, what)
    equations = read_equations(data, generators, samples, region, nonzero, signs, what)
    return Basis(generators, samples, equations, nonzero, signs, certain, radicands)
