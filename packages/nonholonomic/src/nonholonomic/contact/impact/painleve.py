"""Painlevé's paradox: sliding friction that presses the body into its support."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from flowlanes.arguments import arguments_checked
from flowlanes.system.arrays import FloatArray

from ...mechanics.shapes.rays import directions
from .mobility import Mobility, mobility as mobility_of_contact

#: Number of attitudes from which the search for the smallest coefficient starts.
ATTITUDES = 400


def painleve_margin(mobility: Mobility, direction: npt.ArrayLike, mu: float) -> float:
    """B = A_nn − μ(γ, A e): normal acceleration of the contact per normal force while it slides.

    Where B ≤ 0 no normal force keeps a contact that is pressed together from penetrating.

    Parameters
    ----------
    mobility : Mobility
    direction : (3,) array
        Of the sliding velocity, tangential, body axes; any length but zero.
    mu : float
        Coefficient of friction.

    Examples
    --------
    A rod that leans at the slope 2 and slides against the way in which it leans:

    >>> import numpy as np
    >>> from nonholonomic.contact.impact.mobility import mobility
    >>> from nonholonomic.contact.impact.painleve import painleve_margin
    >>> lean = np.arctan(2)
    >>> normal = [np.cos(lean), 0, np.sin(lean)]
    >>> rod = mobility(1.0, [1 / 3, 1 / 3, 1e-3], [0, 0, -1], normal)
    >>> slides = [np.sin(lean), 0, -np.cos(lean)]
    >>> round(painleve_margin(rod, slides, 4 / 3), 12) + 0
    0.0
    """
    gamma, e = mobility.gamma, np.asarray(direction, dtype=float)
    e = e - (e @ gamma) * gamma
    e = e / np.linalg.norm(e)
    return float(gamma @ mobility.A @ (gamma - mu * e))


def least_painleve_friction(mobility: Mobility) -> float:
    """The least μ for which B = 0 in some direction of sliding: A_nn/|A_nt|.

    Infinite for a contact whose normal impulses do not move it sideways.
    """
    response = mobility.A @ mobility.gamma
    sideways = float(np.linalg.norm(mobility.tangents @ response))
    rounding = 8 * float(np.finfo(float).eps) * float(np.linalg.norm(response))
    return float(mobility.gamma @ response) / sideways if sideways > rounding else np.inf


@arguments_checked
def least_painleve_friction_of_body(
    mass: float,
    inertia_tensor: npt.ArrayLike,
    contact: Callable[[FloatArray], FloatArray],
) -> tuple[float, FloatArray]:
    """The least μ for which B = 0 in some attitude and direction of sliding, and that attitude.

    Found by local minimisation from the best of 400 attitudes spread over the sphere.

    Parameters
    ----------
    mass : float
    inertia_tensor : (3,) or (3, 3) array
    contact : callable
        The contact r (3,) for a normal γ (3,), body axes.

    Returns
    -------
    mu : float
    gamma : (3,) array

    Raises
    ------
    InputError
        If the mass is not positive, or an argument is of another type.

    Examples
    --------
    >>> import numpy as np
    >>> from nonholonomic.contact import least_painleve_friction_of_body
    >>> axes = np.array([1.0, 1.0, 5.0])
    >>> inertia = [26 / 5, 26 / 5, 2 / 5]
    >>> mu, gamma = least_painleve_friction_of_body(
    ...     1.0, inertia, lambda g: -(axes**2) * g / np.linalg.norm(axes * g)
    ... )
    >>> round(mu, 5)
    1.00679
    """
    from scipy.optimize import minimize

    def inverse(direction: FloatArray) -> float:
        """−1/μ, finite in every attitude."""
        gamma = direction / np.linalg.norm(direction)
        body = mobility_of_contact(mass, inertia_tensor, contact(gamma), gamma)
        return -1 / least_painleve_friction(body)

    starts = directions(ATTITUDES)
    values = np.array([inverse(start) for start in starts])
    best = (np.inf, starts[0])
    for index in np.argsort(values, kind="stable")[:5]:
        options = {"xatol": 1e-9, "fatol": 1e-15, "maxiter": 2000}
        least = minimize(inverse, starts[index], method="Nelder-Mead", options=options)
        if least.fun < best[0]:
            best = (float(least.fun), least.x / np.linalg.norm(least.x))
    return -1 / best[0] if best[0] else np.inf, best[1]
