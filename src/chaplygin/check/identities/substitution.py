"""Claims in other variables: angles as points of circles, variables expressed by others.

A proof may be one of a claim in which an angle φ has become s = sin(uφ) and c = cos(uφ), or in
which a state variable that a condition gives has become a definition.  That this claim implies
the one of the user is tested at random points that match, as the formulas of a proof are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from flint import arb

from ..claim.claim import Claim
from ..claim.domain import Domain, domain
from ..claim.errors import CheckError
from ..claim.evaluate import Point
from ..claim.formulas import Formula, call, parse, total
from ..claim.json_data import as_list, text
from .accuracy import agree, with_precision
from .change_of_variables import Change, PointPair, point_pairs, read_change, slopes_determinant
from .proof import Condition
from .substituted_law import says_consistency, says_law

#: Statements of a claim in other variables: the law, or that expressed variables move as they must.
LAW, CONSISTENCY = "law", "consistency"


def expressed_variables(data: object) -> tuple[tuple[str, str], ...]:
    """The variables that are expressed by others, with the texts of their formulas."""
    parts = [as_list(part, "a substitution") for part in as_list(data or [], "a substitution")]
    return tuple(
        sorted(
            (text(part[1], "a variable"), text(part[2], "a formula"))
            for part in parts
            if part[0] == "graph"
        )
    )


def statements(
    claim: Claim,
    claim_there: Claim,
    data: object,
    region: Sequence[Formula],
    conditions: Sequence[Condition],
    what: str,
) -> set[str]:
    """The statements of a claim in other variables: `LAW`, `CONSISTENCY` or both.

    It must be defined wherever `claim` is and `conditions` hold.

    Raises
    ------
    CheckError
        If it says neither.
    """
    change = read_change(claim, data, what)
    says: set[str] = with_precision(
        lambda: _what_is_said(claim, claim_there, change, region, conditions, what)
    )
    return says


def _what_is_said(
    claim: Claim,
    claim_there: Claim,
    change: Change,
    region: Sequence[Formula],
    conditions: Sequence[Condition],
    what: str,
) -> set[str]:
    new, old = claim_there.system, claim.system
    circles = {c.angle: c for c in change.circles}
    wanted = []
    for word in old.state:
        if word in circles:
            wanted += [circles[word].sine, circles[word].cosine]
        elif word not in change.graph:
            wanted.append(word)
    if sorted(wanted) != sorted(new.state):
        raise CheckError(f"the state of the claim of {what} is not the substituted one")
    pairs = point_pairs(claim, claim_there, change, what)

    def equal(first: Formula, second: Formula) -> bool:
        values = [p.old(first) for p in pairs]
        return agree(values, [p.new(second) for p in pairs])

    images = {w: f for c in change.circles for w, f in c.functions}
    rates = dict(zip(old.state, old.rates, strict=True))
    for word, rate in zip(new.state, new.rates, strict=True):
        before = call("Rate", [images[word]]) if word in images else rates[word]
        if not equal(before, rate):
            raise CheckError(
                f"the rate of {word} in the claim of {what} is not the substituted one"
            )
    _check_conditions(claim, claim_there, change, pairs, what)
    _check_domain(claim, claim_there, change, conditions, pairs, what)
    for guard in new.guards:
        if not any(equal(before, guard) for before in old.guards):
            raise CheckError(f"a guard in the claim of {what} is none of the system")
    if not (set(new.admissible) <= set(old.admissible) and set(new.either) <= set(old.either)):
        raise CheckError(f"what is admissible in the claim of {what} is not so in the system")
    for formula in region:
        if not equal(formula, formula):
            raise CheckError(f"the region of {what} is not the substituted one")
    says = set()
    if change.graph and says_consistency(claim, claim_there, change, pairs):
        says.add(CONSISTENCY)
    if says_law(claim, claim_there, change, pairs):
        says.add(LAW)
    if not says:
        raise CheckError(f"the law in the claim of {what} is not the substituted one")
    return says


def _check_conditions(
    claim: Claim, claim_there: Claim, change: Change, pairs: Sequence[PointPair], what: str
) -> None:
    """Conditions stay, but those that express variables; and points are on circles."""
    left = []
    for condition in claim.conditions:
        values = [pair.old(condition) for pair in pairs]
        if not (change.graph and agree(values, [arb(0)] * len(values))):
            left.append(values)
    expressed_variables = len(claim.conditions) - len(left)
    if expressed_variables != len(change.graph):
        raise CheckError(
            f"{what} expresses {len(change.graph)} variables by {expressed_variables} conditions"
        )
    others = []
    for condition in claim_there.conditions:
        values = [pair.new(condition) for pair in pairs]
        index = next((i for i, known in enumerate(left) if agree(values, known)), None)
        if index is None:
            others.append(condition)
        else:
            del left[index]
    if left:
        raise CheckError(f"a condition of the system is missing in the claim of {what}")
    _check_circles(others, change, what)


def _check_domain(
    claim: Claim,
    claim_there: Claim,
    change: Change,
    conditions: Sequence[Condition],
    pairs: Sequence[PointPair],
    what: str,
) -> None:
    """Check that the new claim is defined wherever the old one is.

    That the conditions cut out a volume does not depend on the variables.
    """
    before, after = (replace(domain(c, {}), gram=False) for c in (claim, claim_there))
    known = _columns([_of_domain(before, pair.old) for pair in pairs])
    new = _columns([_of_domain(after, pair.new) for pair in pairs])
    known[0] += [[pair.old(c.formula) for pair in pairs] for c in conditions]
    known[1] += [[pair.old(c.formula) for pair in pairs] for c in conditions if c.positive]
    factors = [_factors(claim, change, pair) for pair in pairs]
    new[0] += [list(column) for column in zip(*factors, strict=True)]
    constant = [arb(1)] * len(pairs)
    for values in new[0]:
        if not any(_vanish_alike(values, others) for others in [constant, *known[0], *known[1]]):
            raise CheckError(f"the claim of {what} divides by what the system does not")
    for values in new[1]:
        if not any(_positive_alike(values, others) for others in [constant, *known[1]]):
            raise CheckError(f"the claim of {what} takes a root that the system does not")


def _of_domain(own: Domain, point: Point) -> tuple[list[arb], list[arb]]:
    nonzero, positive, logarithms, _ = own.values(point)
    return nonzero, [*positive, *logarithms]


def _columns(rows: Sequence[Sequence[list[arb]]]) -> list[list[list[arb]]]:
    """Lists of values at all points, from lists at each."""
    return [
        [list(column) for column in zip(*lists, strict=True)] for lists in zip(*rows, strict=True)
    ]


def _vanish_alike(values: Sequence[arb], others: Sequence[arb]) -> bool:
    """Whether two functions, or one and the square of the other, differ by a number."""
    forms = [(values, others), ([v * v for v in values], others)]
    forms.append((values, [o * o for o in others]))
    return any(_proportional(a, b) for a, b in forms)


def _proportional(values: Sequence[arb], others: Sequence[arb]) -> bool:
    if any(v.contains(0) for v in (*values, *others)):
        return False
    ratios = [v / o for v, o in zip(values, others, strict=True)]
    return agree(ratios[:1] * len(ratios), ratios)


def _positive_alike(values: Sequence[arb], others: Sequence[arb]) -> bool:
    return _proportional(values, others) and bool(values[0] / others[0] > 0)


def _factors(claim: Claim, change: Change, pair: PointPair) -> list[arb]:
    """Determinant of the derivatives of the conditions by the variables they express."""
    return [slopes_determinant(claim, change, pair)] if change.graph else []


def _check_circles(conditions: Sequence[Formula], change: Change, what: str) -> None:
    """The conditions that are none of the system must be those of the circles."""
    circles = [parse(f"{c.sine}**2 + {c.cosine}**2 - 1", "a circle") for c in change.circles]
    stated, wanted = (sorted(map(_sorted_sum, group), key=id) for group in (conditions, circles))
    if stated != wanted:
        raise CheckError(f"the conditions of the claim of {what} are not the substituted ones")


def _sorted_sum(formula: Formula) -> Formula:
    """A sum with its terms in an order of its own."""
    return total(sorted(formula.parts, key=id)) if formula.kind == "sum" else formula
