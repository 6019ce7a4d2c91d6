"""σ by quadrature along great circles of the sphere of normals."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import sympy as sp

from ...errors import InputError
from ...system import System
from .form import OneForm

__all__ = ["log_density"]

NODES = 24
MORE_NODES = 40
#: Pieces into which an arc is cut.
PIECES = 8


def _evaluated(system: System, wanted: Sequence[sp.Symbol]) -> Callable[..., np.ndarray]:
    """Definitions as functions of γ, with the default parameters."""
    numbers = {p.symbol: p.default for p in system.parameters}
    steps = [(s, f.xreplace(numbers)) for s, f in system.steps]
    code = [
        (s, sp.lambdify([*system.symbols, *(t for t, _ in steps[:i])], f, "numpy"))
        for i, (s, f) in enumerate(steps)
    ]

    def values(normals: np.ndarray) -> np.ndarray:
        known = list(normals)
        named = {}
        for symbol, function in code:
            made = function(*known)
            known.append(made)
            named[symbol] = made
        return np.array([np.broadcast_to(named[s], normals.shape[1:]) for s in wanted])

    return values


def log_density(
    form: OneForm, base: Sequence[float] = (0.36, -0.48, 0.8)
) -> Callable[[Sequence[float]], tuple[float, float]]:
    """σ with dσ = θ, zero at `base`, as a function of the normal γ (body axes).

    Parameters
    ----------
    form : OneForm
        Closed; its numbers are the default parameters.
    base : 3 floats
        A unit vector.

    Returns
    -------
    callable
        γ ↦ (σ, estimate of the error): the integral of θ along the shorter great circle from
        `base`, by Gauss's rule with 40 nodes on each of 8 pieces, and its difference from 24.
        It raises InputError if γ is no unit vector, or opposite to `base`.
    """
    theta = _evaluated(form.system, form.form.symbols)
    start = np.asarray(base, dtype=float)

    def along(end: np.ndarray, nodes: int) -> float:
        angle = float(np.arctan2(np.linalg.norm(np.cross(start, end)), start @ end))
        if angle == 0:
            return 0.0
        across = (end - np.cos(angle) * start) / np.sin(angle)
        places, weights = np.polynomial.legendre.leggauss(nodes)
        edges = np.linspace(0.0, angle, PIECES + 1)
        half = np.diff(edges)[:, None] / 2
        t = (edges[:-1, None] + half * (1 + places)).ravel()
        w = (half * weights).ravel()
        normals = np.outer(start, np.cos(t)) + np.outer(across, np.sin(t))
        tangents = np.outer(across, np.cos(t)) - np.outer(start, np.sin(t))
        return float(np.sum(w * np.sum(theta(normals) * tangents, axis=0)))

    def sigma(normal: Sequence[float]) -> tuple[float, float]:
        end = np.asarray(normal, dtype=float)
        if end.shape != (3,) or abs(end @ end - 1) > 1e-12:
            raise InputError(f"gamma = {normal}: it must be a unit vector, three numbers")
        if start @ end < -1 + 1e-9:
            raise InputError(f"gamma = {normal}: it is opposite to the base point {tuple(base)}")
        fine = along(end, MORE_NODES)
        return fine, abs(fine - along(end, NODES))

    return sigma
