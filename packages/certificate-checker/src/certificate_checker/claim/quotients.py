"""Exact quotients of polynomials from rational formulas."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from .errors import UndefinedError
from .evaluate import exact_value
from .formulas import Formula
from .polynomials import Poly, Ring

#: Numerator and denominator.
Quotient = tuple[Poly, Poly]

TERMS = 200_000


def quotient(
    formula: Formula,
    ring: Ring,
    symbol_value: Callable[[str], Quotient | None],
    definitions: Mapping[str, Formula],
    other_value: Callable[[Formula, Callable[[Formula], Quotient]], Quotient] | None = None,
) -> Quotient:
    """Numerator and denominator of a rational formula.

    Parameters
    ----------
    symbol_value : callable
        Value of a symbol, or None if it is not known in the ring.
    other_value : callable, optional
        Value of a root or a function; the second argument gives values of formulas inside it.

    Raises
    ------
    UndefinedError
        If the formula is not rational, or divides by zero.
    """
    one = ring.constant(1)
    seen: dict[Formula, Quotient] = {}

    def value_of(node: Formula) -> Quotient:
        if node not in seen:
            seen[node] = _within_limit(fresh_value(node))
        return seen[node]

    def fresh_value(node: Formula) -> Quotient:
        if node.kind == "number":
            return ring.constant(node.word), one
        if node.kind == "name":
            value = symbol_value(node.word)
            if value is None and node.word in definitions:
                value = value_of(definitions[node.word])
            if value is None:
                raise UndefinedError(f"{node.word} has no value here")
            return value
        if node.kind == "sum":
            above, below = value_of(node.parts[0])
            for part in node.parts[1:]:
                upper, lower = value_of(part)
                if below == lower:
                    above = above + upper
                else:
                    above, below = above * lower + upper * below, below * lower
            return above, below
        if node.kind == "product":
            above, below = one, one
            for part in node.parts:
                upper, lower = value_of(part)
                above, below = above * upper, below * lower
            return above, below
        if node.kind == "power":
            return power_of(node)
        return irrational(node)

    def irrational(node: Formula) -> Quotient:
        if other_value is None:
            raise UndefinedError("the formula is not rational")
        return other_value(node, value_of)

    def power_of(node: Formula) -> Quotient:
        exponent = exact_value(node.parts[1], definitions)
        if exponent is None or exponent.denominator != 1 or abs(exponent) > 200:
            return irrational(node)
        above, below = value_of(node.parts[0])
        if exponent < 0:
            above, below = below, above
            if below.is_zero():
                raise UndefinedError("a division by zero")
        return above ** abs(int(exponent)), below ** abs(int(exponent))

    return value_of(formula)


def _within_limit(fraction: Quotient) -> Quotient:
    if len(fraction[0]) + len(fraction[1]) > TERMS:
        raise UndefinedError("the formula is too large")
    return fraction
