"""σ by quadrature along great circles of the sphere of normals."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.compiled import CompiledTerms, SystemFormulas
from flowlanes.system.system import System

from .one_form import OneForm

NODES = 24
MORE_NODES = 40
#: Number of pieces of an arc.
PIECES = 8


def numerical_functions(
    system: System, formulas: Sequence[sp.Expr]
) -> Callable[[np.ndarray], np.ndarray]:
    """Formulas as functions of the state, at the default parameters."""
    read = SystemFormulas(system).term_of
    compiled = CompiledTerms([read(formula) for formula in formulas])
    numbers = np.array([value for _, value in system.default_values])

    def values(state: np.ndarray) -> np.ndarray:
        columns = compiled(state.reshape(len(state), -1), numbers)
        return columns.reshape(-1, *state.shape[1:])

    return values


def arc(start: np.ndarray, normal: Sequence[float]) -> tuple[np.ndarray, float]:
    """The unit vector perpendicular to `start` in the direction of a normal, and their angle.

    Raises
    ------
    InputError
        If the normal is not a unit vector, or opposite to the start.
    """
    end = np.asarray(normal, dtype=float)
    if end.shape != (3,) or abs(end @ end - 1) > 1e-12:
        raise InputError(f"gamma = {normal}: it must be a unit vector, three numbers")
    if start @ end < -1 + 1e-9:
        raise InputError(f"gamma = {normal}: it is opposite to the start {tuple(start)}")
    angle = float(np.arctan2(np.linalg.norm(np.cross(start, end)), start @ end))
    if angle == 0:
        return np.zeros(3), 0.0
    return (end - np.cos(angle) * start) / np.sin(angle), angle


def log_density(
    form: OneForm, base: Sequence[float] = (0.36, -0.48, 0.8)
) -> Callable[[Sequence[float]], tuple[float, float]]:
    """σ with dσ = θ, zero at `base`, as a function of the normal γ (body axes).

    Parameters
    ----------
    form : OneForm
        A closed 1-form, evaluated at the default parameters.
    base : 3 floats
        A unit vector.

    Returns
    -------
    callable
        γ ↦ (σ, estimate of the error): the integral of θ along the shorter great circle from
        `base`, by Gauss's rule with 40 nodes on each of 8 pieces, and its difference from 24.
        It raises InputError if γ is not a unit vector, or opposite to `base`.
    """
    theta = numerical_functions(form.system, form.form.symbols)
    start = np.asarray(base, dtype=float)

    def along(across: np.ndarray, angle: float, nodes: int) -> float:
        places, weights = np.polynomial.legendre.leggauss(nodes)
        edges = np.linspace(0.0, angle, PIECES + 1)
        half = np.diff(edges)[:, None] / 2
        t = (edges[:-1, None] + half * (1 + places)).ravel()
        w = (half * weights).ravel()
        normals = np.outer(start, np.cos(t)) + np.outer(across, np.sin(t))
        tangents = np.outer(across, np.cos(t)) - np.outer(start, np.sin(t))
        return float(np.sum(w * np.sum(theta(normals) * tangents, axis=0)))

    def sigma(normal: Sequence[float]) -> tuple[float, float]:
        across, angle = arc(start, normal)
        fine = along(across, angle, MORE_NODES)
        return fine, abs(fine - along(across, angle, NODES))

    return sigma
