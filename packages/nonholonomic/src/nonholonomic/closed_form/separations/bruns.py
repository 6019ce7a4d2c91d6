"""The Veselova system in Bruns' field U = ½K(γ, Iγ), and the rubber ball (Remark 15).

Without a field, the energy and the momentum integral separate in the coordinates z₁, z₂ of γ, the
roots of Σ γᵢ²/(Iᵢ − z) = 0.  That is an identity at each instant, and also holds for the kinetic
parts of the integrals in the field, where

    (γ, Iγ) = tr I − z₁ − z₂,     det I (γ, I⁻¹γ) = z₁z₂

eliminate the coordinate with the other index.  The curve, again of genus two, is

    y² = 4 z p(z) (Kz² + (2h − K tr I) z − F)/det I,     p(z) = ∏(Iᵢ − z).

One root of the quadratic lies between z₁ and z₂, so both are real.  The ball with rubber contact
moves as the Veselova system, with J for I and U = ½K(γ, Jγ) − ½KD.
"""

from __future__ import annotations

from typing import TypeAlias

import sympy as sp

from flowlanes.system.system import System
from flowlanes.system.vectors import constant, cross, dot, real_symbol, vectors

from ...catalogue import from_catalogue
from ...catalogue.chaplygin_ball.chaplygin_ball import K
from ...catalogue.chaplygin_ball.chaplygin_bracket import D
from ...catalogue.fixed_point import veselova
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import with_laws
from .neumann import quadratic

#: The diagonal of a tensor.
Tensor: TypeAlias = tuple[sp.Expr, sp.Expr, sp.Expr]

gamma, omega = vectors("gamma omega")
I = veselova.I
#: Values of the energy and of the momentum integral.
h, F = real_symbol("h"), real_symbol("F")


#: J = I + D, in parameters.
ROLLING = (I.symbols[0] + D, I.symbols[1] + D, I.symbols[2] + D)


def diagonal(entries: Tensor) -> sp.MatrixExpr:
    """The matrix with these entries on its diagonal."""
    return constant(sp.diag(*entries))


def integral(system: System, name: str) -> sp.Expr:
    """The integral with a given name."""
    return next(law.value for law in system.integrals if law.name == name)


def _kept_from_spinning(name: str, title: str, moments: Tensor, offset: sp.Expr) -> SeparatedSystem:
    """A body with (ω, γ) = 0 and given moments in the field ½K(γ, Iγ) − `offset`."""
    system = from_catalogue(name)
    inverse = diagonal(tuple(1 / s for s in moments))
    clock = sp.sqrt(dot(nu, inverse * nu))
    linear = 2 * (h + offset) - K * sp.Add(*moments)
    return with_laws(
        SeparatedSystem(
            name=name,
            title=title,
            system=system,
            constants=((h, integral(system, "energy")), (F, integral(system, "momentum"))),
            direction=gamma,
            turning=clock.xreplace({nu: gamma}) * cross(gamma, omega),
            poles=moments,
            weights=tuple(1 / gap for gap in gaps(moments)),
            leading=-4 * K / sp.Mul(*moments),
            roots=(*moments, sp.S.Zero, *quadratic(K, linear, -F)),
            speeds=(sp.S.Zero, sp.S.One),
            time_rescaling=clock,
            state=((omega, cross(nuprime, nu) / clock), (gamma, nu)),
            fixed=(gamma,),
            source="Remark 15",
        )
    )


def veselova_in_bruns_field() -> SeparatedSystem:
    """The Veselova system in Bruns' field, K ≠ 0; ν = γ, dt = (γ, I⁻¹γ)^(1/2) dτ."""
    title = "Veselova system in Bruns' field"
    return _kept_from_spinning("veselova-bruns", title, I.symbols, sp.S.Zero)


def rubber_ball_in_bruns_field() -> SeparatedSystem:
    """The Chaplygin ball with rubber contact in Bruns' field, K ≠ 0: J for I, U less ½KD."""
    title = "Chaplygin ball with rubber contact in Bruns' field"
    return _kept_from_spinning("rubber-chaplygin-ball-bruns", title, ROLLING, K * D / 2)
