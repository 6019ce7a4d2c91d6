"""Algebraic formulas on complex balls, on one branch of every root and away from every pole.

A formula of a real motion is real-analytic; it continues to complex arguments as long as no
radicand meets the negative real axis and no denominator vanishes.  :class:`Branch` evaluates
formulas on complex balls and refuses where it cannot be sure of that.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import prod
from typing import Any

import sympy as sp
from flint import arb

from ...formulas.balls import Steps, Values, ball
from ..genus_two.separation import nu, nuprime
from .affine import Affine

__all__ = ["Branch", "LeavesBranchError", "direction"]


class LeavesBranchError(Exception):
    """On this ball the formula may meet a branch point, a branch cut or a pole."""


def _root(x: Any) -> Any:
    if isinstance(x, arb) and not x > 0:
        raise LeavesBranchError
    return x.sqrt()


def _inverse(x: Any, sign: int) -> Any:
    if isinstance(x, Affine):
        return x.inverse(sign)
    if not x * sign > 0:
        raise LeavesBranchError
    return 1 / x


def direction(N: Sequence[Any], rate: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """ν = N/|N| and ν′ from N and N′, both arb or both affine.

    Raises
    ------
    LeavesBranchError
        If N·N may meet the negative real axis or zero.
    """
    shorter = _inverse(_root(N[0] * N[0] + N[1] * N[1] + N[2] * N[2]), 1)
    nu = [x * shorter for x in N]
    along = nu[0] * rate[0] + nu[1] * rate[1] + nu[2] * rate[2]
    return nu, [(r - x * along) * shorter for x, r in zip(nu, rate, strict=True)]


class Branch:
    """Formulas in ν, ν′ and constants, continued from the real torus to complex arguments.

    Parameters
    ----------
    formulas : scalar formulas
        Sums, products, integer powers and square roots.
    constants : mapping of Symbol to arb
        Everything in the formulas beside ν and ν′ and the steps.
    steps : pairs of Symbol and formula, optional
        Intermediate quantities, in order.

    Raises
    ------
    ValueError
        If a formula contains another operation or a symbol without a value.
    """

    def __init__(self, formulas: Iterable[sp.Expr], constants: Values, steps: Steps = ()) -> None:
        inputs = (*nu.symbols, *nuprime.symbols)
        self._places: dict[Any, int] = {symbol: i for i, symbol in enumerate(inputs)}
        self._constants = constants
        self._tape: list[tuple[str, Any]] = []
        for name, formula in steps:
            self._places[name] = self._place(formula)
        self._results = [self._place(sp.sympify(formula)) for formula in formulas]
        self._signs: dict[int, int] = {}

    def _add(self, operation: str, operands: Any) -> int:
        self._tape.append((operation, operands))
        return 6 + len(self._tape) - 1

    def _place(self, node: Any) -> int:
        if node not in self._places:
            self._places[node] = self._built(node)
        return self._places[node]

    def _built(self, node: Any) -> int:
        if node.is_Rational:
            return self._add("constant", ball(node))
        if node in self._constants:
            return self._add("constant", self._constants[node])
        if node.is_Add or node.is_Mul:
            operation = "sum" if node.is_Add else "product"
            return self._add(operation, tuple(self._place(part) for part in node.args))
        if node.is_Pow and node.exp.is_Rational and node.exp.q in (1, 2):
            place = self._place(node.base)
            place = place if node.exp.q == 1 else self._add("root", place)
            place = self._add("power", (place, abs(int(node.exp.p))))
            return place if node.exp > 0 else self._add("inverse", place)
        raise ValueError(f"{node}: neither a sum, a product nor a root, and without a value")

    def at(self, vector: Sequence[Any], rate: Sequence[Any]) -> list[Any]:
        """Values at real ν and ν′ (arb).

        Raises
        ------
        LeavesBranchError
            If a radicand or denominator may vanish there.
        """
        return self._run(vector, rate, {})

    def learn(self, vector: Sequence[Any], rate: Sequence[Any]) -> None:
        """Take from one real point which sign every denominator has on the real torus."""
        self._signs = {}
        self._run(vector, rate, self._signs)

    def continued(self, vector: Sequence[Affine], rate: Sequence[Affine]) -> list[Any]:
        """Values on boxes, after :meth:`learn`; rests are infinite where a branch may be left.

        Where the rests are finite on boxes that cover the four tori Im v = (±r₁, ±r₂), every
        radicand and every denominator has a single-valued argument there, so by the argument
        principle, first in v₁ and then in v₂, no zero inside, and the formulas are analytic for
        |Im v₁| ≤ r₁, |Im v₂| ≤ r₂.  (The argument is harmonic along every line and its bound
        passes from the tori to the inside, so that the branch is the principal one there too.)
        """
        zero = vector[0] * 0
        # a constant is a function on the torus too
        return [zero + value for value in self._run(vector, rate, self._signs)]

    def parities(self, flips: Sequence[int]) -> list[int]:
        """How the formulas change when ν_i and ν_i′ are multiplied by flips_i = ±1.

        Returns
        -------
        list of int
            1 or −1 for every formula, as its form shows; 0 where it shows neither.
        """
        signs = [*flips, *flips]
        for operation, operand in self._tape:
            if operation == "constant":
                signs.append(1)
            elif operation == "sum":
                kinds = {signs[place] for place in operand}
                signs.append(kinds.pop() if len(kinds) == 1 else 0)
            elif operation == "product":
                signs.append(prod(signs[place] for place in operand))
            elif operation == "power":
                signs.append(signs[operand[0]] ** operand[1])
            elif operation == "root":
                signs.append(1 if signs[operand] == 1 else 0)
            else:
                signs.append(signs[operand])
        return [signs[place] for place in self._results]

    def _run(self, vector: Sequence[Any], rate: Sequence[Any], signs: dict[int, int]) -> list[Any]:
        values = [*vector, *rate]
        for place, (operation, operand) in enumerate(self._tape):
            if operation == "constant":
                value = operand
            elif operation == "sum":
                value = values[operand[0]]
                for term in operand[1:]:
                    value = value + values[term]
            elif operation == "product":
                value = values[operand[0]]
                for factor in operand[1:]:
                    value = value * values[factor]
            elif operation == "power":
                # a ball around zero has no power in python-flint, but it has a product
                value = values[operand[0]]
                for _ in range(operand[1] - 1):
                    value = value * values[operand[0]]
            elif operation == "root":
                value = _root(values[operand])
            else:
                if place not in signs:
                    signs[place] = 1 if values[operand] > 0 else -1
                value = _inverse(values[operand], signs[place])
            values.append(value)
        return [values[place] for place in self._results]
