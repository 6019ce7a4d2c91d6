"""A skate on a slope as the limit of lateral friction, of added inertia, or of both.

A body of mass m and moment of inertia J has its centre of mass above a blade of direction
e = (cos φ, sin φ), with e′ = de/dφ, on a plane on which gravity acts along x with the acceleration
a. The blade resists sideways velocity w = (ẋ, e′) by the force −c w e′, and the energy has the term
½N w² of an added inertia.  With p = mẋ + N w e′ the equations are

    ṗ = m a e_x − c w e′,      J φ̈ = −N w (ẋ, e).

For c → ∞ alone the limit is the nonholonomic skate, for N → ∞ alone the vakonomic one of Kozlov,

    ṗ = m a e_x,      ẋ = (p, e) e/m,      J φ̈ = −(p, e)(p, e′)/m,

and for c = νN → ∞ a motion between both: ṗ = m a e_x − ν (p, e′) e′ in the last equations.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import Parameter, System
from flowlanes.system.tuple_vectors import dot
from flowlanes.system.vectors import real_symbol

x, y, p_x, p_y, phi, Omega, speed = (
    real_symbol(s) for s in ("x", "y", "p_x", "p_y", "phi", "Omega", "speed")
)
m, J, a, c, inertia, nu = (real_symbol(s) for s in ("m", "J", "a", "c", "N_a", "nu"))
ALONG, ACROSS = (sp.cos(phi), sp.sin(phi)), (-sp.sin(phi), sp.cos(phi))


def _parameters(slope: float) -> tuple[Parameter, ...]:
    return (
        Parameter(m, "mass", 1.0, "kg", (m > 0,)),
        Parameter(J, "moment of inertia", 1.0, "kg m^2", (J > 0,)),
        Parameter(a, "acceleration of gravity along the slope", slope, "m/s^2"),
    )


def resisting_skate(slope: float = 1.0) -> System:
    """The skate with side friction c and added inertia N.

    Parameters
    ----------
    slope : float
        Acceleration of gravity along the slope (m/s²).

    Returns
    -------
    System
        State: position `x`, `y`, momentum `p_x`, `p_y`, angle `phi` of the blade, `Omega` = φ̇.
    """
    momentum = (p_x, p_y)
    ahead = dot(momentum, ALONG) / m
    sideways = dot(momentum, ACROSS) / (m + inertia)
    velocity = [ahead * e + sideways * n for e, n in zip(ALONG, ACROSS, strict=True)]
    return System(
        name="resisting-skate",
        title="Skate with side friction and added inertia",
        field={
            x: velocity[0],
            y: velocity[1],
            p_x: m * a - c * sideways * ACROSS[0],
            p_y: -c * sideways * ACROSS[1],
            phi: Omega,
            Omega: -inertia * sideways * ahead / J,
        },
        parameters=(
            *_parameters(slope),
            Parameter(c, "side friction", 1.0, "kg/s", (c >= 0,)),
            Parameter(inertia, "added inertia", 1.0, "kg", (inertia >= 0,)),
        ),
        source="§11.2",
    )


def nonholonomic_skate(slope: float = 1.0) -> System:
    """The skate without sideways velocity: mv̇ = m a (e_x, e), φ̈ = 0."""
    return System(
        name="nonholonomic-skate",
        title="Skate on a slope",
        field={
            x: speed * ALONG[0],
            y: speed * ALONG[1],
            speed: a * ALONG[0],
            phi: Omega,
            Omega: 0 * Omega,
        },
        parameters=_parameters(slope),
        source="§11.2",
    )


def limit_of_added_inertia(slope: float = 1.0) -> System:
    """The limit N → ∞ with c = νN; for ν = 0 the vakonomic skate."""
    momentum = (p_x, p_y)
    ahead, held = dot(momentum, ALONG), dot(momentum, ACROSS)
    return System(
        name="skate-of-added-inertia",
        title="Skate as the limit of added inertia",
        field={
            x: ahead / m * ALONG[0],
            y: ahead / m * ALONG[1],
            p_x: m * a - nu * held * ACROSS[0],
            p_y: -nu * held * ACROSS[1],
            phi: Omega,
            Omega: -ahead * held / (m * J),
        },
        parameters=(
            *_parameters(slope),
            Parameter(nu, "side friction over added inertia", 0.0, "1/s", (nu >= 0,)),
        ),
        source="§11.2",
    )


@arguments_checked
@dataclass(frozen=True)
class Skate:
    """Skates with side friction c = viscosity·s and added inertia N = mass·s for growing s.

    They start at rest in the origin with the blade down the slope and the given spin; m = J = 1.

    Parameters
    ----------
    coefficients : sequence of float
        s, increasing.
    viscosity : float
        Share of the side friction (kg/s); zero for added inertia alone.
    mass : float
        Share of the added inertia (kg); zero for friction alone.
    spin : float
        φ̇ at the start (rad/s).
    slope : float
        Acceleration of gravity along the slope (m/s²).

    Raises
    ------
    InputError
        If a share is negative, or both are zero.

    Examples
    --------
    >>> from nonholonomic.contact.rolling_limit.skate import Skate
    >>> Skate((10.0, 20.0), mass=1.0).description
    'skates with added inertia s → ∞, against the vakonomic skate'
    """

    coefficients: tuple[float, ...]
    viscosity: float = 0.0
    mass: float = 0.0
    spin: float = 2.0
    slope: float = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "coefficients", tuple(map(float, self.coefficients)))
        shares = (self.viscosity, self.mass)
        if not all(math.isfinite(s) and s >= 0 for s in shares) or not any(shares):
            raise InputError(
                f"viscosity {self.viscosity}, mass {self.mass}: neither may be negative, and one "
                "must be positive"
            )

    @property
    def description(self) -> str:
        """A description of the family and its limit."""
        if not self.mass:
            return "skates with side friction s → ∞, against the nonholonomic skate"
        if not self.viscosity:
            return "skates with added inertia s → ∞, against the vakonomic skate"
        return (
            "skates with side friction and added inertia in the ratio "
            f"{self.viscosity / self.mass:g} 1/s, s → ∞, against their common limit"
        )

    @arguments_checked
    def motion(self, coefficient: float, times: FloatArray) -> FloatArray:
        """x, y, φ, φ̇ of a skate (n, 4)."""
        values = {"c": self.viscosity * coefficient, "N_a": self.mass * coefficient}
        start = {"x": 0.0, "y": 0.0, "p_x": 0.0, "p_y": 0.0, "phi": 0.0, "Omega": self.spin}
        return _columns(resisting_skate(self.slope), start, times, values)

    @arguments_checked
    def limit(self, times: FloatArray) -> FloatArray:
        """x, y, φ, φ̇ of the limit (n, 4)."""
        start = {"x": 0.0, "y": 0.0, "phi": 0.0, "Omega": self.spin}
        if not self.mass:
            return _columns(nonholonomic_skate(self.slope), {**start, "speed": 0.0}, times, {})
        momentum = {"p_x": 0.0, "p_y": 0.0}
        values = {"nu": self.viscosity / self.mass}
        return _columns(limit_of_added_inertia(self.slope), start | momentum, times, values)


def _columns(
    system: System, start: dict[str, float], times: FloatArray, values: dict[str, float]
) -> FloatArray:
    motion = integrate(system, start, [0.0, *times], parameters=values)
    columns = [motion[name][1:] for name in ("x", "y", "phi", "Omega")]
    return np.stack(columns, axis=1)
