"""Floquet multipliers of a periodic orbit, without the trivial ones.

For an integral F and the derivative S of the return map at a point of the orbit, dF·S = dF; S
therefore acts on the tangent space of the common level of all integrals, and its eigenvalues there
are the nontrivial multipliers. The errors of S and of the multipliers are estimated from the
defect of dF·S = dF and from how well S preserves the tangent spaces of the section and of the
relations.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arguments import arguments_checked
from ..errors import InputError
from ..system.arrays import FloatArray
from .maps import Map, normalised_functions

#: Relative size of its independent part below which a gradient counts as dependent.
DEPENDENT = 1e-7
#: Safety factor: rounding splits a double eigenvalue by twice the first-order estimate, and a
#: triple one by three times.
SAFETY = 4.0


@dataclass(frozen=True)
class Multipliers:
    """Eigenvalues of the return map at a periodic orbit.

    Attributes
    ----------
    values : complex array (d,)
        Multipliers on the level of all integrals, largest modulus first.
    trivial : tuple of str
        The origin of each trivial multiplier: ``"flow"``, integrals, promoted parameters.
    errors : array (d,)
        Effect of rounding and integration errors on each.
    matrix : array (d, d)
        The derivative of the return map in an orthonormal basis of the level, in units of the
        state.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> from flowlanes.orbits.maps import ExplicitMap
    >>> henon = ExplicitMap(
    ...     ("x", "y"),
    ...     lambda z: np.stack([1 - 1.4 * z[:, 0] ** 2 + z[:, 1], 0.3 * z[:, 0]], axis=1),
    ... )
    >>> orbit = flowlanes.orbits.find_periodic(henon, np.array([0.6, 0.2]))
    >>> orbit.multipliers.kind, orbit.multipliers.trivial
    ('saddle', ())
    """

    values: FloatArray
    trivial: tuple[str, ...]
    errors: FloatArray
    matrix: FloatArray

    @property
    def kind(self) -> str:
        """The kind of stability."""
        return stability_type(self.values, self.errors)


def stability_type(values: FloatArray, errors: FloatArray) -> str:
    """The stability type of an orbit in one or two words.

    Parameters
    ----------
    values, errors : arrays (d,)
        Multipliers with their errors; moduli within the error of one count as one.

    Returns
    -------
    str
        ``"attracting"`` or ``"repelling"``, followed by ``"node"`` or ``"focus"`` for two
        multipliers; ``"saddle"``; ``"elliptic"`` (all on the unit circle, away from ±1);
        ``"neutral"`` (all on it, some at ±1, or no multipliers); ``"saddle and elliptic"``;
        ``"undecided"`` if some are within their error of the circle and the others all on one side
        of it.
    """
    excess = np.abs(values) - 1
    inside, outside = excess < -errors, excess > errors
    if (inside | outside).all() and len(values):
        if inside.any() and outside.any():
            return "saddle"
        word = "attracting" if inside.any() else "repelling"
        if len(values) != 2:
            return word
        return f"{word} {'focus' if np.abs(values.imag).min() > errors.max() else 'node'}"
    if not inside.any() and not outside.any():
        turning = np.abs(values.imag) > errors
        return "elliptic" if turning.all() and len(values) else "neutral"
    return "saddle and elliptic" if inside.any() and outside.any() else "undecided"


@arguments_checked
def multipliers(section_map: Map, point: FloatArray, slope: FloatArray) -> Multipliers:
    """The nontrivial multipliers of an orbit.

    Parameters
    ----------
    section_map : Map
    point : array (size,)
        A point of the orbit.
    slope : array (size, size)
        The derivative of the return map at this point.

    Returns
    -------
    Multipliers
        The nontrivial multipliers, largest modulus first.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> from flowlanes.orbits.maps import ExplicitMap
    >>> henon = ExplicitMap(
    ...     ("x", "y"),
    ...     lambda z: np.stack([1 - 1.4 * z[:, 0] ** 2 + z[:, 1], 0.3 * z[:, 0]], axis=1),
    ... )
    >>> point, slope = np.array([0.631, 0.189]), np.array([[-1.767, 1.0], [0.3, 0.0]])
    >>> flowlanes.orbits.multipliers(henon, point, slope).values.real.round(3).tolist()
    [-1.923, 0.156]
    """
    point, slope = np.asarray(point, dtype=float), np.asarray(slope, dtype=float)
    count = len(section_map.names)
    for what, array, shape in (("point", point, (count,)), ("slope", slope, (count, count))):
        if array.shape != shape:
            raise InputError(f"multipliers: {what} must be an array {shape}, not {array.shape}")
        if not np.isfinite(array).all():
            raise InputError(f"multipliers: {what} must be an array of finite numbers")
    sizes = section_map.sizes(point[None])
    # From here on in units of the state: S_ij s_j / s_i.
    slope = slope * sizes / sizes[:, None]
    _, domain = normalised_functions(
        np.zeros(len(section_map.domain.names)), section_map.domain.slopes(point[None])[0], sizes
    )
    basis = complement(domain)
    forced = list(section_map.trivial)
    defect = float(np.finfo(float).eps) * max(1.0, float(np.linalg.norm(slope))) * len(point)
    for gradient in domain:
        left = gradient @ slope @ basis
        defect = max(defect, float(np.linalg.norm(left) / np.linalg.norm(gradient)))
    for name, gradient in zip(
        section_map.integrals.names,
        section_map.integrals.slopes(point[None])[0] * sizes,
        strict=True,
    ):
        # Restrict to the kernel of each gradient in turn; a gradient that vanishes on the basis
        # depends on the earlier ones.
        across = gradient @ basis
        size = float(np.linalg.norm(across))
        if size <= DEPENDENT * float(np.linalg.norm(gradient)):
            continue
        forced.append(name)
        mapped = gradient @ slope @ basis - across
        defect = max(defect, float(np.linalg.norm(mapped)) / size)
        basis = basis @ complement(across[None])
    matrix = basis.T @ slope @ basis
    values, vectors = np.linalg.eig(matrix)
    order = np.argsort(-np.abs(values), kind="stable")
    return Multipliers(
        values[order].astype(complex),
        tuple(forced),
        SAFETY * defect * _conditions(vectors)[order],
        matrix,
    )


def complement(rows: FloatArray) -> FloatArray:
    """An orthonormal basis (columns) of the common kernel of the rows."""
    if not len(rows):
        return np.eye(rows.shape[1])
    _, sizes, other = np.linalg.svd(rows)
    rank = int((sizes > DEPENDENT * sizes[0]).sum())
    basis: FloatArray = other[rank:].T
    return basis


def _conditions(vectors: FloatArray) -> FloatArray:
    """Condition numbers |y||x|/|y·x| of the eigenvalues, from left and right eigenvectors."""
    if not len(vectors):
        return np.zeros(0)
    # For a double eigenvalue the inverse is meaningless, and its size shows it.
    left = np.linalg.pinv(vectors, rcond=1e-15)
    conditions: FloatArray = np.linalg.norm(left, axis=1) * np.linalg.norm(vectors, axis=0)
    return conditions
