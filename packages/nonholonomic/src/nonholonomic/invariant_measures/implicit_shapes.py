"""σ of a body whose shape is given by an equation, by integration along contact points."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from flowlanes.errors import InputError
from flowlanes.system.vectors import Symmetric, Vector, real_symbol

from .one_form import OneForm
from .quadrature import arc, numerical_functions

TOLERANCES = (1e-9, 1e-12)
REACH = 60
"""Maximum number of doublings of the distance until a ray from the centre leaves the body."""


def log_density_on_surface(
    form: OneForm, toward: Sequence[float] = (0.36, -0.48, 0.8)
) -> Callable[[Sequence[float]], tuple[float, float]]:
    """σ with dσ = θ as a function of the normal γ, zero at the point where a ray leaves the body.

    While the normal moves on a great circle the contact point follows, ṙ = −Wγ̇, and σ̇ = (Θ, γ̇).

    Parameters
    ----------
    form : OneForm
        A closed 1-form of a body with the state r.
    toward : 3 floats
        The direction of the ray from the geometric centre.

    Returns
    -------
    callable
        γ ↦ (σ, estimate of the error), from two tolerances of the method DOP853. It raises
        InputError if γ is not a unit vector, or opposite to the normal at the start.
    """
    from scipy.integrate import solve_ivp

    system = form.system
    gamma, hessian = Vector("gamma").symbols, Symmetric("F").symbols
    curvatures = (real_symbol("ell"), real_symbol("sigma"), real_symbol("kappa"))
    values = numerical_functions(system, (*form.form.symbols, *gamma, *hessian, *curvatures))
    first = _leaving(form, np.asarray(toward, dtype=float))
    start = values(first)[3:6]

    def sigma(normal: Sequence[float]) -> tuple[float, float]:
        across, angle = arc(start, normal)
        if angle == 0:
            return 0.0, 0.0

        def rates(t: float, state: np.ndarray) -> np.ndarray:
            here = values(state[:3])
            tangent = across * np.cos(t) - start * np.sin(t)
            F = here[[6, 7, 8, 7, 9, 10, 8, 10, 11]].reshape(3, 3)
            ell, mean, gauss = here[12:]
            image = F @ tangent
            shape = (image - (here[3:6] @ image) * here[3:6]) / ell
            moved = -(mean * tangent - shape) / gauss
            return np.array([*moved, here[:3] @ tangent])

        roots = [
            float(
                solve_ivp(
                    rates, (0.0, angle), [*first, 0.0], method="DOP853", rtol=rtol, atol=rtol
                ).y[3, -1]
            )
            for rtol in TOLERANCES
        ]
        return roots[1], abs(roots[1] - roots[0])

    return sigma


def _leaving(form: OneForm, direction: np.ndarray) -> np.ndarray:
    """The point at which a ray from the geometric centre leaves the body."""
    system = form.system
    numbers = {p.symbol: p.default for p in system.parameters}
    centre = np.array([numbers.get(c, 0.0) for c in Vector("c").symbols])
    inside = numerical_functions(system, system.relations)

    def value(distance: float) -> float:
        return float(inside(centre + distance * direction)[0])

    low, high = 0.0, 1e-6
    for _ in range(REACH):
        if value(high) > 0:
            break
        low, high = high, 2 * high
    else:
        raise InputError("the body has no boundary in the direction taken for the start")
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (low, middle) if value(middle) > 0 else (middle, high)
    return centre + high * direction
