"""One proof: that the residuals of a claim vanish wherever certain signs are as assumed.

The relation of the polynomials of a proof to the claim is tested at random points: a formula and
a polynomial that agree there, to sixty digits and more, are taken to be equal.  This is the test of
Schwartz and Zippel; it errs with a probability of about degree / 2^22 at every point, and is no
proof.  Everything that follows from the polynomials is computed exactly.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from ..claim.claim import Claim
from ..claim.errors import CheckError, UndefinedError
from ..claim.formulas import Formula, parse
from ..claim.json_data import as_list, field, only, text
from ..claim.polynomials import Poly, monic
from ..claim.residuals import residuals
from .accuracy import InaccurateError, agree, with_precision
from .basis import Basis, read_basis
from .case_tree import Node, check_tree
from .positivity import common_ratio
from .read_generators import FIELDS, read_generators


@dataclass(frozen=True)
class Condition:
    """A condition of a verdict: a formula is positive, or is not zero."""

    text: str
    formula: Formula
    positive: bool


def check_proof(
    data: Mapping[str, object], claim: Claim, what: str, conditions: Sequence[Condition]
) -> Basis:
    """Check a proof of a claim, where conditions hold; CheckError where it fails."""
    only(data, what, "claim", "substitution", "region", *FIELDS, "residuals", "tree")
    region = read_region(data, claim, what)
    basis: Basis = with_precision(lambda: _checked_residuals(data, claim, region, what))
    ring = basis.generators.ring
    numerators = [
        ring.fraction(item, f"a residual of {what}")[0]
        for item in as_list(field(data, "residuals", what), what)
    ]

    def leaf(node: Node, data: Mapping[str, object], where: str) -> None:
        check_left(node, data, where, basis, conditions)

    node = Node(ring, basis.equations, basis.nonzero, basis.signs, numerators, leaf)
    check_tree(node, field(data, "tree", what), f"the tree of {what}")
    return basis


def read_region(data: Mapping[str, object], claim: Claim, what: str) -> tuple[Formula, ...]:
    """The equations of the part of the level that a proof treats."""
    region = as_list(data.get("region", []), f"the region of {what}")
    formulas = tuple(parse(formula, f"the region of {what}") for formula in region)
    known = {*claim.system.symbols, *claim.system.definitions}
    for formula in formulas:
        if not claim.system.reach([formula]) <= known:
            raise CheckError(f"the region of {what} uses an unknown symbol")
    return formulas


def _checked_residuals(
    data: Mapping[str, object], claim: Claim, region: Sequence[Formula], what: str
) -> Basis:
    generators = read_generators(data, claim, what)
    basis = read_basis(data, generators, region, what)
    stated = as_list(field(data, "residuals", what), f"the residuals of {what}")
    fractions = [generators.ring.fraction(item, f"a residual of {what}") for item in stated]
    for sample in basis.samples:
        try:
            values = residuals(claim, sample.point)
        except UndefinedError as error:
            raise CheckError(f"{what}: a residual is not defined: {error}") from None
        if len(values) != len(fractions):
            raise CheckError(
                f"{what} states {len(fractions)} residuals, but the law has {len(values)}"
            )
        for number, ((above, below), value) in enumerate(zip(fractions, values, strict=True)):
            upper = generators.ring.value(above, sample.values)
            lower = generators.ring.value_of_powers(below, sample.values)
            if lower.contains(0):
                raise InaccurateError
            if not agree([value], [upper / lower]):
                raise CheckError(f"{what}: residual {number} is not that of the law")
    for number, (_, below) in enumerate(fractions):
        for poly, _ in below:
            _require_nonzero(basis, poly, f"the denominator of residual {number} of {what}")
    return basis


def check_left(
    node: Node,
    data: Mapping[str, object],
    where: str,
    basis: Basis,
    conditions: Sequence[Condition],
) -> None:
    """A case may be left unproven if a condition of the verdict excludes it."""
    if data["case"] != "unproven":
        raise CheckError(f"{where} has a case {data['case']!r}, which has no place there")
    only(data, where, "case", "condition")
    said = text(field(data, "condition", where), f"the condition of {where}")
    for condition in conditions:
        if condition.text == said and any(
            with_precision(partial(same, basis, equation, condition.formula)) is not None
            for equation in node.equations
        ):
            return
    raise CheckError(f"{where} is left unproven, which no condition of the verdict excludes")


def same(basis: Basis, poly: Poly, formula: Formula) -> int | None:
    """The sign of the number by which a polynomial and a formula differ; None if by none."""
    try:
        values = [basis.generators.ring.value(poly, sample.values) for sample in basis.samples]
        ratio = common_ratio(values, [sample.point(formula) for sample in basis.samples])
    except UndefinedError:
        return None
    return None if ratio is None else 1 if ratio > 0 else -1


def _require_nonzero(basis: Basis, poly: Poly, what: str) -> None:
    if not poly.is_constant() and monic(poly)[0] not in basis.nonzero and not basis.signs.of(poly):
        raise CheckError(f"{what} may vanish")
