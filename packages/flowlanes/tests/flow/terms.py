"""Terms of a graph in ball arithmetic, for tests of what is made from them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import flint
from flint import arb

from flowlanes.formulas.graph import Term, topological_order


def _positive(test: arb, yes: arb, no: arb) -> arb:
    return yes if test > 0 else no


_OPERATIONS: Mapping[str, Any] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "neg": lambda a: -a,
    "recip": lambda a: 1 / a,
    "abs": abs,
    "sign": arb.sgn,
    "atan2": arb.atan2,
    "positive": _positive,
}


def balls(
    terms: Sequence[Term], leaves: Mapping[tuple[str, int], float], bits: int
) -> list[list[arb]]:
    """Values of terms, and of everything they are made of, with bounds of their errors.

    Parameters
    ----------
    terms : sequence of Term
    leaves : mapping of (kind, index) to float
        Values of state variables and parameters.
    bits : int
        Every operation is rounded to so many, so that the radius bounds what an arithmetic of
        more bits can go wrong.

    Returns
    -------
    list of two lists
        Values of the terms, and of all terms.
    """
    known: dict[int, arb] = {}
    with flint.ctx.workprec(bits):
        for term in topological_order(terms):
            if term.kind == "number":
                value = arb(flint.fmpq(term.args[0].numerator, term.args[0].denominator))
            elif not term.operands:
                value = arb(leaves[term.kind, term.args[0]])
            else:
                operation = _OPERATIONS.get(term.kind) or getattr(arb, term.kind)
                value = operation(*(known[id(a)] for a in term.operands))
            known[id(term)] = value
    return [[known[id(term)] for term in terms], list(known.values())]
