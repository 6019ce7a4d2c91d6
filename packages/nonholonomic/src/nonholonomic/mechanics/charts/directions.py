"""Angles of γ and of the velocity or momentum relative to it, with the energy.

For a rubber contact (ω, γ) = 0: γ and the direction of γ̇ = γ × ω form the unit tangent bundle of
the sphere, and the energy gives the length of ω.  On a level of the area integral the momentum
similarly lies in a plane (M, γ) = const; its direction is measured from the point of that plane
with the least energy.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from flowlanes.arguments import Parameters
from flowlanes.errors import InputError
from flowlanes.flow.batched_linalg import row_dots
from flowlanes.flow.sampling.level_set_fibration import find_fibration
from flowlanes.formulas.array_evaluation import parameter_rows
from flowlanes.formulas.compiled import SystemFormulas
from flowlanes.system.arrays import FloatArray, IntArray
from flowlanes.system.system import System

#: Below this the sine of an angle is rounding.
_FLAT = 1e-7
#: Tolerance for a linear condition on the component along γ.
_ALONG = 1e-12


class Directions:
    """Maps between states and (theta, phi, psi, energy).

    γ = (sin θ cos φ, sin θ sin φ, cos θ) in body axes; ψ is the angle of ω or M, seen from the
    centre of its ellipse, from the direction in which θ rises towards that in which φ rises.

    Parameters
    ----------
    system : System
        Its state must be a vector and the unit vector γ.
    level : mapping of str to float
        The area integral, or nothing for a system with (ω, γ) = 0.
    parameters : mapping of Symbol or name to float, optional

    Raises
    ------
    InputError
        If the energy does not bound an ellipse in a plane across γ.
    """

    names = ("theta", "phi", "psi", "energy")

    def __init__(self, system: System, level: Mapping[str, float], parameters: Parameters) -> None:
        if "energy" not in {law.name for law in system.integrals}:
            raise InputError(f"{system.name}: these coordinates need an integral named energy")
        levels = {**level, "energy": 0.0}
        self.values = parameter_rows(system, parameters, 1)[0]
        self.fibration = find_fibration(system, SystemFormulas(system), levels, self.values)
        shape = [
            len(part) for part in (self.fibration.base, self.fibration.fibre, self.fibration.linear)
        ]
        if (
            shape != [3, 3, 1]
            or self.fibration.further
            or self.fibration.quadratic.name != "energy"
        ):
            raise InputError(
                f"{system.name}: these coordinates need a vector beside the unit vector gamma and "
                "one linear condition on it: hold the area integral, or take a system with "
                "(omega, gamma) = 0"
            )
        self._check(system)

    def _check(self, system: System) -> None:
        gamma = np.array([[0.6, 0.0, -0.8], [0.48, 0.64, 0.6]]).T
        states = np.zeros((self.fibration.size, 2))
        states[list(self.fibration.base)] = gamma
        normals = self.fibration.parts(states, self.values)[0][:, 0]
        if np.abs(np.cross(normals, gamma.T)).max() > _ALONG * np.abs(normals).max():
            raise InputError(
                f"{system.name}: these coordinates need a linear condition on the component along "
                f"gamma, which {self.fibration.linear[0].name} is not"
            )

    def states(self, points: FloatArray) -> tuple[IntArray, FloatArray]:
        """Indices of the points (4, k) that have a state, and these states (size, n)."""
        theta, phi, psi, energy = points
        gamma, rising, turning = frame(theta, phi)
        base = np.zeros((self.fibration.size, theta.size))
        base[list(self.fibration.base)] = gamma
        level = replace(self.fibration, quadratic=replace(self.fibration.quadratic, target=energy))
        rays = level.fill(base, rising * np.cos(psi) + turning * np.sin(psi), self.values)
        here = np.flatnonzero(rays.excess > 0)
        return here, rays.states[:, here]

    def points(self, states: FloatArray) -> FloatArray:
        """(theta, phi, psi, energy) of states; NaN where an angle is undefined."""
        x, y, z = gamma = states[list(self.fibration.base)]
        theta = np.arctan2(np.hypot(x, y), z)
        phi = np.where(np.hypot(x, y) > _FLAT, np.arctan2(y, x), np.nan)
        _, rising, turning = frame(theta, phi)
        base = np.zeros_like(states)
        base[list(self.fibration.base)] = gamma
        level = replace(self.fibration, quadratic=replace(self.fibration.quadratic, target=np.inf))
        with np.errstate(invalid="ignore"):
            centre = level.fill(base, np.nan_to_num(rising), self.values).centre
        vector = states[list(self.fibration.fibre)].T
        off = vector - centre
        psi = np.arctan2(row_dots(off, turning.T), row_dots(off, rising.T))
        _, _, A, b, c = self.fibration.parts(base, self.values)
        applied = (A * vector[:, None, :]).sum(axis=2)
        energy = c + row_dots(b, vector) + 0.5 * row_dots(vector, applied)
        return np.stack([theta, phi, psi, energy])

    @staticmethod
    def span(name: str, others: Mapping[str, float]) -> tuple[float, float]:
        """The range of one variable, given the others."""
        if name == "energy":
            raise InputError("the energy is a coordinate here: fix it, rather than solve for it")
        return 0.0, np.pi if name == "theta" else 2 * np.pi


def frame(theta: FloatArray, phi: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """γ and the unit vectors in the directions of increasing θ and φ, arrays (3, k)."""
    s, c, sp, cp = np.sin(theta), np.cos(theta), np.sin(phi), np.cos(phi)
    return (
        np.stack([s * cp, s * sp, c]),
        np.stack([c * cp, c * sp, -s]),
        np.stack([-sp, cp, np.zeros_like(sp)]),
    )
