"""The angles of nutation θ and of intrinsic rotation φ, for systems with (ω, γ) = 0 (§5, §6.2).

γ = (sin θ sin φ, sin θ cos φ, cos θ),   ψ̇ = −cos θ φ̇,
ω = θ̇ (cos φ, −sin φ, 0) + φ̇ (e₃ − cos θ γ).
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import constant, real_symbol, vectors

from ..mechanics.conventions import BODY

omega, gamma = vectors("omega gamma")
theta, phi, thetadot, phidot = (real_symbol(s) for s in ("theta", "phi", "thetadot", "phidot"))

#: γ and ω (body axes) in the angles and their rates.
NORMAL = constant([sp.sin(theta) * sp.sin(phi), sp.sin(theta) * sp.cos(phi), sp.cos(theta)])
SPIN = constant(
    [
        thetadot * sp.cos(phi) - phidot * sp.sin(theta) * sp.cos(theta) * sp.sin(phi),
        -thetadot * sp.sin(phi) - phidot * sp.sin(theta) * sp.cos(theta) * sp.cos(phi),
        phidot * sp.sin(theta) ** 2,
    ]
)


def in_angles(system: System) -> System:
    """The system with the state θ, φ, θ̇, φ̇ instead of ω, γ.

    The accelerations follow from the field that is given, by differentiating ω; the only law is
    that the angles lead back to that field.

    Parameters
    ----------
    system : System
        With the state ω, γ on γ² = 1, (ω, γ) = 0.
    """
    rates: dict[MatrixExpr, MatrixExpr] = dict(system.field)
    first, second, third = scalars(rates[omega])
    return replace(
        system,
        name=f"{system.name}-angles",
        title=f"{system.title}, in Euler angles",
        definitions={gamma: NORMAL, omega: SPIN, **dict(system.definitions)},
        field={
            theta: thetadot,
            phi: phidot,
            thetadot: first * sp.cos(phi)
            - second * sp.sin(phi)
            + phidot**2 * sp.sin(theta) * sp.cos(theta),
            phidot: third / sp.sin(theta) ** 2 - 2 * phidot * thetadot * sp.cot(theta),
        },
        relations=(),
        laws=(
            Isomorphism(
                "vectors",
                system,
                {omega: SPIN, gamma: NORMAL},
                meaning="the same motion in the variables ω, γ",
                source="(6.5)",
            ),
        ),
        observables=(),
        guards=(),
        reconstruction=None,
        conventions=BODY,
    )
