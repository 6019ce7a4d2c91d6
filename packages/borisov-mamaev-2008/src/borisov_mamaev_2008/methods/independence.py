"""Independence of functions, by the exact rank of their differentials at a rational point."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.system import System
from lawproof.proof.verdict import Verdict

from .derived_verdicts import computed_verdict


def rational_point(system: System, state: Mapping[str, object]) -> dict[sp.Symbol, sp.Rational]:
    """A point with the default parameters, in exact rational numbers.

    Parameters
    ----------
    system : System
    state : mapping of str to number or text
        Values by scalar name, such as ``{"gamma_1": "2/7"}``.
    """
    point = {p.symbol: exact_number(p.default) for p in system.parameters}
    names = {str(s): s for s in (*system.symbols, *point)}
    return point | {names[name]: sp.Rational(str(value)) for name, value in state.items()}


def independent(
    system: System, functions: Sequence[sp.Expr], point: Mapping[sp.Symbol, sp.Expr]
) -> Verdict:
    """The verdict that functions on a phase space are independent.

    Parameters
    ----------
    system : System
        A system whose state variables are the coordinates.
    functions : sequence of sympy.Expr
        Functions in state, definitions and parameters.
    point : mapping of Symbol to number
        Exact values of state and parameters.

    Returns
    -------
    Verdict
        Proven if the rank of the differentials at the point is the number of functions, since it
        then is so on an open dense set; otherwise undecided.
    """
    rows = []
    for function in functions:
        value = system.expand(function)
        rows.append([sp.diff(value, s).xreplace(dict(point)) for s in system.symbols])
    rank = sp.Matrix(rows).rank()
    reached = rank == len(functions)
    return computed_verdict(
        "independence",
        reached,
        f"rank {rank} of {len(functions)} differentials at a rational point",
        f"the differentials have rank {rank} at the point tried",
    )
