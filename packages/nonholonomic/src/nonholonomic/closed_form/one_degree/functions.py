"""Elementary functions of balls and of arrays, for formulas that are written once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

import numpy as np
from flint import acb, arb

from flowlanes.system.arrays import FloatArray

from .divided_differences import analytic_root

#: Real or complex balls.
B = TypeVar("B", arb, acb)
#: Real numbers: balls, or arrays in double precision.
T = TypeVar("T", arb, FloatArray)
#: Balls, or arrays in double precision.
N = TypeVar("N", arb, acb, FloatArray)
#: An integer beside a ball, or an array of integers.
Count = TypeVar("Count", int, FloatArray)


@dataclass(frozen=True)
class Functions(Generic[N]):
    """Elementary functions of one kind of numbers.

    Attributes
    ----------
    number : callable
        A constant (arb) in these numbers.
    sin, cos, tanh, sech, sqrt, square : callable
    step : callable
        The logistic function 1/(1 + e^−2x).
    alternating : callable
        (count, x) ↦ (−1)^count x.
    """

    number: Callable[[arb], N]
    sin: Callable[[N], N]
    cos: Callable[[N], N]
    tanh: Callable[[N], N]
    sech: Callable[[N], N]
    step: Callable[[N], N]
    sqrt: Callable[[N], N]
    square: Callable[[N], N]
    alternating: Callable[[Any, N], N]


#: Functions of balls, not finite if a complex ball meets a branch cut.
BALLS: Functions[Any] = Functions(
    number=lambda x: x,
    sin=lambda x: x.sin(),
    cos=lambda x: x.cos(),
    tanh=lambda x: x.tanh(),
    sech=lambda x: x.sech(),
    step=lambda x: 1 / (1 + (-2 * x).exp()),
    sqrt=analytic_root,
    # A non-integer power of a ball that contains zero has no value.
    square=lambda x: x * x,
    alternating=lambda count, x: -x if count % 2 else x,
)

#: Functions of arrays.
DOUBLES: Functions[FloatArray] = Functions(
    number=lambda x: np.asarray(float(x)),
    sin=np.sin,
    cos=np.cos,
    tanh=np.tanh,
    sech=lambda x: 1 / np.cosh(np.clip(x, -350.0, 350.0)),
    step=lambda x: 1 / (1 + np.exp(-2 * np.clip(x, -350.0, 350.0))),
    sqrt=np.sqrt,
    square=np.square,
    alternating=lambda count, x: np.where(count % 2 != 0, -1.0, 1.0) * x,
)
