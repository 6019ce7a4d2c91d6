"""The symbols of the unbalanced ball for the claims of §10.1 and §10.2."""

from __future__ import annotations

from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Rate
from flowlanes.system.vectors import Diagonal, constant, cross, real_symbol, vectors

M, omega, gamma, r, c = vectors("M omega gamma r c")
I = Diagonal("I")
m, R = real_symbol("m"), real_symbol("R")

NORMAL: dict[str, object] = {"gamma_1": "2/7", "gamma_2": "-3/7", "gamma_3": "6/7"}
#: The vector a of r = −Rγ − a; c points from the centre of mass to the geometric centre.
OFFSET = -c

M_RATE, OMEGA_RATE, GAMMA_RATE, R_RATE = (
    constant([Rate(s) for s in vector.symbols]) for vector in (M, omega, gamma, r)
)


def about_contact(turning: MatrixExpr) -> MatrixExpr:
    """Ĩ applied to a vector: I u + m r×(u×r)."""
    momentum: MatrixExpr = I * turning + m * cross(r, cross(turning, r))
    return momentum
