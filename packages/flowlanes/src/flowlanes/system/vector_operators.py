"""Unit vectors, dyads, skew-symmetric matrices and gradients of 3-vectors."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr, Transpose

from ..arguments import arguments_checked
from ..errors import InputError
from .vectors import Components, Node, Scalar, Vector, constant, real_symbol, to_components, zero


@arguments_checked
def unit_vector(axis: int) -> MatrixExpr:
    """The unit vector along a coordinate axis.

    Parameters
    ----------
    axis : int
        1, 2 or 3; of the frame in which components are taken.

    Returns
    -------
    MatrixExpr (3, 1)

    Raises
    ------
    InputError
        If there is no such axis.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.system.to_components(
    ...     flowlanes.system.dot(flowlanes.system.unit_vector(3), flowlanes.system.Vector("u"))
    ... )
    u_3
    """
    if axis not in (1, 2, 3):
        raise InputError(f"unit_vector: axis must be 1, 2 or 3, not {axis}")
    return constant([int(axis == i) for i in (1, 2, 3)])


def outer(left: MatrixExpr, right: MatrixExpr) -> MatrixExpr:
    """The dyad u ⊗ v, as the matrix u vᵀ."""
    return left * Transpose(right)


def hat(vector: MatrixExpr) -> Components:
    """The skew-symmetric matrix with hat(u) v = u × v."""
    x, y, z = to_components(vector)
    return Components([[0, -z, y], [z, 0, -x], [-y, x, 0]])


class Gradient(Node, MatrixExpr):
    """The gradient ∂U/∂u of a scalar `U` in the components of the vector `u`.

    The third argument is the name under which U is printed.
    """

    shape = (sp.Integer(3), sp.S.One)

    def as_explicit(self) -> Components:
        """The partial derivatives."""
        value, variable, _ = self.args
        return Components([sp.diff(to_components(value), s) for s in variable.symbols])


def gradient(value: Scalar, variable: Vector, name: str = "U") -> MatrixExpr:
    """∂value/∂variable, printed as ∂U/∂u; zero if `value` does not depend on it."""
    if not to_components(value).has(*variable.symbols):
        return zero
    return Gradient(value, variable, real_symbol(name))
