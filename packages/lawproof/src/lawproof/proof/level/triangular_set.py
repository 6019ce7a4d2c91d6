"""Triangular sets: each condition has a main variable that occurs in no condition below it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from flint import fmpq

from flowlanes.formulas.errors import EmptyLevelError, OutOfReachError

from ..fields.function_field import FunctionField
from ..fields.quotient_ring import Element, Poly, initial_of

#: A polynomial as a mapping from (name, exponent) pairs to coefficients, in any order.
Terms = Mapping[tuple[tuple[str, int], ...], fmpq]


@dataclass(frozen=True)
class TriangularSet:
    """A triangular set.

    Attributes
    ----------
    order : tuple of str
        The variables, highest first.
    relations : tuple of (str, Terms)
        Main variable and polynomial, from the lowest to the highest.
    """

    order: tuple[str, ...]
    relations: tuple[tuple[str, Terms], ...]


def triangle(
    draft: FunctionField, names: Sequence[str], conditions: Sequence[Poly], moving: set[str]
) -> TriangularSet:
    """A triangular set with the same zeros as the conditions where its initials do not vanish.

    Parameters
    ----------
    draft : FunctionField
        The field to which the conditions belong.
    names : sequence of str
        Variables that may be main variables.
    moving : set of str
        Names of the state variables.

    Raises
    ------
    EmptyLevelError
        If the conditions contradict each other.
    OutOfReachError
        If no choice of main variables was found.
    """
    ordered = chain(draft, names, conditions, moving)
    mains = [main for main, _ in ordered]
    order = (*reversed(mains), *(n for n in names if n not in mains))
    return TriangularSet(order, tuple((main, _terms(draft, poly)) for main, poly in ordered))


def chain(
    draft: FunctionField, names: Sequence[str], conditions: Sequence[Poly], moving: set[str]
) -> list[tuple[str, Poly]]:
    """Main variables and polynomials of a triangular set, lowest first.

    Parameters and errors are those of `triangle`.
    """
    relations = _chain(draft, names, conditions, moving, _merit)
    if relations is None:
        # Needed for orthonormal frames, where the linear conditions must come first.
        relations = _chain(draft, names, conditions, moving, _merit_by_degree)
    if relations is None:
        raise OutOfReachError("the conditions of the level cannot be made triangular")
    return _in_order(draft, relations)


def _terms(draft: FunctionField, poly: Poly) -> Terms:
    return {
        tuple(zip(draft.names, map(int, exponents), strict=True)): number
        for exponents, number in poly.to_dict().items()
    }


def _chain(
    draft: FunctionField,
    names: Sequence[str],
    conditions: Sequence[Poly],
    moving: set[str],
    merit: Callable[[FunctionField, Poly, str, set[str]], tuple[int, int, int]],
) -> list[tuple[str, Poly]] | None:
    """A chain built greedily by merit; None if no main variable is left for a condition."""
    # Ritt's procedure: each relation gets a main variable, and the conditions that remain are
    # pseudo-divided by the chain until none is left.
    waiting = list(conditions)
    chain: list[tuple[str, Poly]] = []
    while True:
        for main, relation in reversed(chain):
            waiting = [draft.pseudo_remainder(g, relation, main) for g in waiting]
        waiting = [g for g in waiting if g]
        if any(g.is_constant() for g in waiting):
            raise EmptyLevelError
        if not waiting:
            return chain
        choices = [
            (merit(draft, g, v, moving), i, v)
            for i, g in enumerate(waiting)
            for v in names
            if _possible(draft, g, v, chain)
        ]
        if not choices:
            return None
        _, index, main = min(choices)
        chain.append((main, waiting.pop(index)))


def numerator(draft: FunctionField, element: Element) -> Poly:
    """The polynomial whose zeros are those of an element."""
    poly = element.poly
    for number, power in element.powers.items():
        for _ in range(max(power, 0)):
            poly = poly * draft.factors[number]
    return poly


def _variables(draft: FunctionField, poly: Poly) -> set[str]:
    return {n for n, d in zip(draft.names, poly.degrees(), strict=True) if d}


def _merit(draft: FunctionField, poly: Poly, name: str, moving: set[str]) -> tuple[int, int, int]:
    """The cost of a variable as main variable of a relation; smaller is better."""
    position = draft.names.index(name)
    degree = int(poly.degrees()[position])
    lead = initial_of(poly, position)
    if lead.is_constant():
        kind = 0 if degree == 1 else degree - 1
    else:
        # An initial in parameters vanishes only for special bodies, one in the state anywhere.
        kind = 10 * degree + (len(lead) > 1) + 4 * bool(_variables(draft, lead) & moving)
    return kind, len(lead), -position


def _merit_by_degree(
    draft: FunctionField, poly: Poly, name: str, moving: set[str]
) -> tuple[int, int, int]:
    """The cost with linear relations first."""
    degree = int(poly.degrees()[draft.names.index(name)])
    return (degree, *_merit(draft, poly, name, moving)[:2])


def _possible(draft: FunctionField, poly: Poly, name: str, chain: list[tuple[str, Poly]]) -> bool:
    """True if a variable may be main: it occurs, is not main yet, and gives no cycle."""
    if name in {main for main, _ in chain} or name not in _variables(draft, poly):
        return False
    try:
        _in_order(draft, [*chain, (name, poly)])
    except OutOfReachError:
        return False
    return True


def _in_order(draft: FunctionField, chain: list[tuple[str, Poly]]) -> list[tuple[str, Poly]]:
    """The relations from the lowest main variable to the highest."""
    mains = {main for main, _ in chain}
    needs = {main: (_variables(draft, poly) & mains) - {main} for main, poly in chain}
    done: list[str] = []
    while len(done) < len(chain):
        ready = [m for m in needs if m not in done and needs[m] <= set(done)]
        if not ready:
            raise OutOfReachError("the conditions of the level cannot be made triangular")
        done.extend(ready)
    polys = dict(chain)
    return [(main, polys[main]) for main in done]
