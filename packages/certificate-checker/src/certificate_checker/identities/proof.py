"""Check of one proof: the residuals of a claim vanish wherever certain signs are as assumed.

The polynomials of a proof are compared with the claim modulo a random prime at a random point (see
:mod:`.residues`); the error probability is below 2^−100 (see :mod:`.error_bound`).  All
conclusions from the polynomials are computed exactly.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..claim.claim import Claim
from ..claim.errors import CheckError, UndefinedError
from ..claim.formulas import Formula
from ..claim.json_data import as_list, field, only, text
from ..claim.polynomials import Poly, monic
from ..claim.residuals import residuals
from .basis import Basis, read_basis
from .case_tree import Node, check_tree
from .read_generators import FIELDS, read_generators


@dataclass(frozen=True)
class Condition:
    """Condition of a verdict: a formula is positive, or is nonzero."""

    text: str
    formula: Formula
    positive: bool


def check_proof(
    data: Mapping[str, object],
    claim: Claim,
    what: str,
    conditions: Sequence[Condition],
    seed: str,
) -> Basis:
    """Check a proof of a claim under given conditions; CheckError if it fails.

    Parameters
    ----------
    seed : str
        Digest of the whole certificate, from which the points of comparison are derived.
    """
    only(data, what, *FIELDS, "residuals", "tree")
    generators = read_generators(data, claim, what)
    formulas = [condition.formula for condition in conditions]
    basis = read_basis(data, generators, formulas, f"{seed} {what}", what)
    numerators = _checked_residuals(data, basis, what)

    def leaf(node: Node, data: Mapping[str, object], where: str) -> None:
        _check_left(node, data, where, basis, conditions)

    node = Node(generators.ring, basis.equations, basis.nonzero, basis.signs, numerators, leaf)
    check_tree(node, field(data, "tree", what), f"the tree of {what}")
    return basis


def _checked_residuals(data: Mapping[str, object], basis: Basis, what: str) -> list[Poly]:
    """Numerators of the residuals, verified against the residuals of the law."""
    ring, claim = basis.generators.ring, basis.generators.claim
    stated = as_list(field(data, "residuals", what), f"the residuals of {what}")
    fractions = [ring.fraction(item, f"a residual of {what}") for item in stated]
    # An identity needs only one point; a second one is for constant ratios.
    draw = basis.comparisons.draws[0]
    points = [(s.values, s.functions) for s in draw]
    upper = [ring.values(above, points) for above, _ in fractions]
    lower = [[ring.value_of_powers(below, *point) for point in points] for _, below in fractions]
    for i, sample in enumerate(draw):
        try:
            values = residuals(claim, sample.point)
        except UndefinedError as error:
            raise CheckError(f"{what}: a residual is not defined: {error}") from None
        if len(values) != len(fractions):
            raise CheckError(
                f"{what} states {len(fractions)} residuals, but the law has {len(values)}"
            )
        for number, value in enumerate(values):
            if value * lower[number][i] != upper[number][i] or lower[number][i] == 0:
                raise CheckError(f"{what}: residual {number} is not that of the law")
    for number, (_, below) in enumerate(fractions):
        for poly, _ in below:
            _require_nonzero(basis, poly, f"the denominator of residual {number} of {what}")
    return [above for above, _ in fractions]


def _check_left(
    node: Node,
    data: Mapping[str, object],
    where: str,
    basis: Basis,
    conditions: Sequence[Condition],
) -> None:
    """Check that a condition of the verdict excludes a case that is left unproven."""
    if data["case"] != "unproven":
        raise CheckError(f"{where} has a case {data['case']!r}, which is not allowed there")
    only(data, where, "case", "condition")
    said = text(field(data, "condition", where), f"the condition of {where}")
    for condition in conditions:
        if condition.text == said and any(
            same(basis, equation, condition.formula) for equation in node.equations
        ):
            return
    raise CheckError(f"{where} is left unproven, which no condition of the verdict excludes")


def same(basis: Basis, poly: Poly, formula: Formula) -> int:
    """Sign of the constant ratio of a polynomial and a formula; 0 if there is none."""
    ratio = basis.comparisons.ratio(poly, formula)
    return 0 if ratio is None else 1 if ratio > 0 else -1


def _require_nonzero(basis: Basis, poly: Poly, what: str) -> None:
    if not poly.is_constant() and monic(poly)[0] not in basis.nonzero and not basis.signs.of(poly):
        raise CheckError(f"{what} may vanish")
