"""Time derivatives of vectors in laws."""

from __future__ import annotations

from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Rate
from flowlanes.system.named_formulas import scalars
from flowlanes.system.vectors import constant


def rate(vector: MatrixExpr) -> MatrixExpr:
    """The rates of the components of a vector formula along the field of its system."""
    return constant([Rate(component) for component in scalars(vector)])
