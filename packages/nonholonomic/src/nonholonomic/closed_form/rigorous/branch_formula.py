"""Algebraic formulas on complex balls, on one branch of every root and away from every pole.

A formula of a real motion is real-analytic; it continues to complex arguments as long as no
radicand meets the negative real axis and no denominator vanishes.  :class:`Branch` evaluates
formulas on complex balls and raises an error where this is not certain.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import prod
from typing import Any

import numpy as np
import sympy as sp

from flowlanes.formulas.balls import Values
from flowlanes.formulas.straight_line_program import BallArithmetic, Steps, StraightLineProgram

from ..genus_two.separated_motion import SeparatedMotion, steps_from_torus
from ..genus_two.separation import nu, nuprime
from .affine import Affine


class LeavesBranchError(Exception):
    """The formula may meet a branch point, a branch cut or a pole on this ball."""


class _Continuation(BallArithmetic):
    """Arithmetic that raises an error where a radicand or a denominator may leave its branch.

    Parameters
    ----------
    signs : dict of int to int, optional
        The signs of denominators by their indices in the program; those that are missing are taken
        from the first numbers.
    """

    def __init__(self, signs: dict[int, int] | None = None) -> None:
        self.signs: dict[int, int] = {} if signs is None else signs

    def root(self, x: Any) -> Any:
        """The square root of a ball that is positive or does not meet the negative real axis."""
        if isinstance(x, Affine):
            return x.sqrt()
        if not np.all(x > 0):
            raise LeavesBranchError
        return np.sqrt(x) if isinstance(x, np.ndarray) else x.sqrt()

    def inverse(self, x: Any, index: int) -> Any:
        """The reciprocal of a ball that does not contain zero."""
        if index not in self.signs:
            self.signs[index] = 1 if np.all(x > 0) else -1
        return _inverse(x, self.signs[index])


def _inverse(x: Any, sign: int) -> Any:
    if isinstance(x, Affine):
        return x.inverse(sign)
    if not np.all(x * sign > 0):
        raise LeavesBranchError
    return 1 / x


def direction(N: Sequence[Any], rate: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """ν = N/|N| and ν′ from N and N′, both arb or both affine.

    Raises
    ------
    LeavesBranchError
        If N·N may meet the negative real axis or zero.
    """
    shorter = _inverse(_Continuation().root(N[0] * N[0] + N[1] * N[1] + N[2] * N[2]), 1)
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
        names = (*nu.symbols, *nuprime.symbols, *constants)
        self._program = StraightLineProgram(names, [sp.sympify(f) for f in formulas], steps)
        self._constants = tuple(constants.values())
        self._signs: dict[int, int] = {}

    @classmethod
    def of(cls, motion: SeparatedMotion, formulas: Sequence[sp.Expr]) -> Branch:
        """Formulas of a separable system along a motion."""
        return cls(formulas, motion.values, steps_from_torus(motion.separable, formulas)[1])

    def at(self, vector: Sequence[Any], rate: Sequence[Any]) -> list[Any]:
        """Values at real ν and ν′, each component an arb or an array of arb.

        Raises
        ------
        LeavesBranchError
            If a radicand or denominator may vanish there.
        """
        return self._run(vector, rate, {})

    def learn(self, vector: Sequence[Any], rate: Sequence[Any]) -> None:
        """Determine the sign of every denominator on the real torus from one real point."""
        self._signs = {}
        self._run(vector, rate, self._signs)

    def values_on_boxes(self, vector: Sequence[Affine], rate: Sequence[Affine]) -> list[Any]:
        """Values on boxes, after :meth:`learn`; remainders are infinite where a branch may be left.

        Suppose that the remainders are finite on boxes that cover the four tori Im v = (±r₁, ±r₂).
        Then every radicand and every denominator has a single-valued argument there, so by the
        argument principle, first in v₁ and then in v₂, no zero inside, and the formulas are
        analytic for |Im v₁| ≤ r₁, |Im v₂| ≤ r₂. (The argument is harmonic along every line, and its
        bound extends from the tori to the inside, so the branch is the principal one there too.)
        """
        zero = vector[0] * 0
        # A constant is a function on the torus too.
        return [zero + value for value in self._run(vector, rate, self._signs)]

    def parities(self, flips: Sequence[int], of_rates: Sequence[int] | None = None) -> list[int]:
        """Signs by which the formulas change if ν_i and ν_i′ are multiplied by flips_i = ±1.

        Parameters
        ----------
        of_rates : three of 1, -1, optional
            The factors of ν_i′, where they are others.

        Returns
        -------
        list of int
            1 or −1 for every formula, as its form shows; 0 where it shows neither.
        """
        signs = [*flips, *(flips if of_rates is None else of_rates), *(1 for _ in self._constants)]
        for kind, operands, _ in self._program.operations:
            kinds = [signs[index] for index in operands]
            if kind == "sum":
                signs.append(kinds[0] if len(set(kinds)) == 1 else 0)
            elif kind == "root":
                signs.append(1 if kinds == [1] else 0)
            else:
                signs.append(prod(kinds))
        return [signs[index] for index in self._program.results]

    def _run(self, vector: Sequence[Any], rate: Sequence[Any], signs: dict[int, int]) -> list[Any]:
        return self._program.run([*vector, *rate, *self._constants], _Continuation(signs))
