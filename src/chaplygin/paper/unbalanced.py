"""What the claims of §10.1 and §10.2 share: the symbols of the unbalanced ball."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from sympy.matrices.expressions import MatrixExpr

from ..statements import Rate
from ..system import System
from ..vectors import Diagonal, constant, cross, explicit, scalar, vectors

M, omega, gamma, r, c = vectors("M omega gamma r c")
I = Diagonal("I")
m, R = scalar("m"), scalar("R")

PLACE = (Fraction(2, 7), Fraction(-3, 7), Fraction(6, 7))
NORMAL: dict[str, object] = {"gamma_1": "2/7", "gamma_2": "-3/7", "gamma_3": "6/7"}
#: a of r = −Rγ − a; c goes from the centre of mass to the geometric centre.
OFFSET = -c

M_RATE, OMEGA_RATE, GAMMA_RATE, R_RATE = (
    constant([Rate(s) for s in explicit(vector)]) for vector in (M, omega, gamma, r)
)


def about_contact(turning: Any) -> MatrixExpr:
    """Ĩ applied to a vector: I u + m r×(u×r)."""
    made: MatrixExpr = I * turning + m * cross(r, cross(turning, r))
    return made


def obstructed(
    made: System, obstruction: Callable[[System, Sequence[Fraction]], Fraction], what: str
) -> tuple[bool, str, float]:
    """Whether an obstruction is not zero at a rational point; words for it; seconds."""
    started = time.monotonic()
    value = obstruction(made, PLACE)
    shown = f"{what} is {value} at γ = (2, −3, 6)/7 for the parameters of the catalogue"
    return value != 0, shown, time.monotonic() - started
