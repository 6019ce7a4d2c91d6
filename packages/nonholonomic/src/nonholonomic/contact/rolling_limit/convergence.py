"""The rate at which a family of motions converges to a limit as its coefficient grows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray


@runtime_checkable
class Family(Protocol):
    """Motions that depend on a coefficient, and their possible limit."""

    @property
    def description(self) -> str:
        """A description of the family, its coefficient and its limit."""

    @property
    def coefficients(self) -> tuple[float, ...]:
        """The coefficients, increasing."""

    def motion(self, coefficient: float, times: FloatArray) -> FloatArray:
        """The compared quantities of the motion for one coefficient: (n, m) at n times."""

    def limit(self, times: FloatArray) -> FloatArray:
        """The same quantities of the limit."""


@dataclass(frozen=True, eq=False)
class Convergence:
    """Differences between the motions of a family and its limit.

    Attributes
    ----------
    description : str
        The family, its coefficient and its limit.
    times : array (n,)
        Times at which motions are compared.
    coefficients : array (k,)
        Increasing.
    errors : array (k,)
        Largest difference of a component of the states at these moments.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact import convergence
    >>> from nonholonomic.contact.rolling_limit.skate import Skate
    >>> viscous = convergence(Skate((100.0, 200.0, 400.0), viscosity=1.0), [2.0])
    >>> isinstance(viscous, nonholonomic.contact.Convergence), viscous.orders.round(1).tolist()
    (True, [1.0, 1.0])
    """

    description: str
    times: FloatArray
    coefficients: FloatArray
    errors: FloatArray

    @property
    def orders(self) -> FloatArray:
        """Exponents p (k − 1,) of a difference that falls like coefficient^−p, by neighbours."""
        steps: FloatArray = -np.diff(np.log(self.errors)) / np.diff(np.log(self.coefficients))
        return steps

    @property
    def order(self) -> float:
        """The exponent fitted to all coefficients by least squares."""
        slope = np.polyfit(np.log(self.coefficients), np.log(self.errors), 1)[0]
        return -float(slope)

    def table(self) -> str:
        """Coefficients, differences and orders as a Markdown table."""
        orders = ["", *(f"{order:.3f}" for order in self.orders)]
        rows = [
            f"| {coefficient:g} | {error:.3e} | {order} |"
            for coefficient, error, order in zip(
                self.coefficients, self.errors, orders, strict=True
            )
        ]
        return "\n".join(["| coefficient | difference | order |", "|---|---|---|", *rows])


@arguments_checked
def convergence(family: Family, times: Sequence[float]) -> Convergence:
    """The convergence of a family of motions with friction or added inertia to its limit.

    Parameters
    ----------
    family : Family
        `ViscousContact`, `DryContactLimit`, or `Skate`.
    times : sequence of float
        Increasing moments after zero, at which the motions are compared.  Where the motions begin
        off the constraint, they leave a layer at t = 0 whose width falls with the coefficient; all
        moments should lie beyond it.

    Returns
    -------
    Convergence

    Raises
    ------
    InputError
        If there are fewer than two coefficients, or these or the moments do not increase from
        zero.

    Examples
    --------
    >>> from nonholonomic.contact.rolling_limit.skate import Skate
    >>> from nonholonomic.contact.rolling_limit.convergence import convergence
    >>> viscous = convergence(Skate((100.0, 200.0, 400.0), viscosity=1.0), [2.0])
    >>> bool(abs(viscous.orders[-1] - 1) < 0.01)
    True
    """
    moments = np.asarray(times, dtype=float)
    coefficients = np.asarray(family.coefficients, dtype=float)
    _check_increasing("times", moments, 1)
    _check_increasing("coefficients", coefficients, 2)
    limit = family.limit(moments)
    errors = [float(np.abs(family.motion(c, moments) - limit).max()) for c in coefficients]
    return Convergence(family.description, moments, coefficients, np.array(errors))


def _check_increasing(name: str, numbers: FloatArray, least: int) -> None:
    positive = all(math.isfinite(x) and x > 0 for x in numbers)
    if len(numbers) < least or not positive or np.any(np.diff(numbers) <= 0):
        raise InputError(
            f"{name} {[float(x) for x in numbers]}: there must be {least} or more positive numbers "
            "that increase"
        )
