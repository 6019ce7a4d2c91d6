"""The Veselova system and the Chaplygin ball in Bruns' field U = ½K(γ, Iγ) (Remarks 15, 20).

Without a field the two quadratic integrals of each separate in coordinates z₁, z₂ of γ; these
identities are of the instant, and hold for the kinetic parts of the integrals in the field too.
There U and what the second integral gains are made of

    (γ, Iγ) = tr I − z₁ − z₂,     det I (γ, I⁻¹γ) = z₁z₂                                (Veselova),
    (γ, Iγ) = det I/(z₁z₂),       det J (1 − D(γ, J⁻¹γ)) = det I (z₁ + D)(z₂ + D)/(z₁z₂)   (ball),

so that the coordinate with the other index drops out of each equation, and with p(z) = ∏(Iᵢ − z)

    y² = 4 z p(z) (Kz² + (2h − K tr I) z − F)/det I                                     (Veselova),
    y² = 4 (z + D) p(z) (2hz² + (2hD − f − Ke) z + K det I),  e = (det J − det I)/D       (ball).

These are curves of genus two.  One root of each quadratic lies between z₁ and z₂, so both are real.
The ball with rubber contact moves as the Veselova system, with J for I; on it U is ½K(γ, Jγ) − ½KD.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import sympy as sp

from ..system import System
from ..systems import from_catalogue, veselova
from ..systems.chaplygin_ball import K
from ..systems.chaplygin_bracket import D
from ..vectors import constant, cross, dot, scalar, vectors
from .neumann import quadratic
from .poles import gaps
from .separable import Separable, nu, nuprime
from .stated import with_laws

__all__ = ["chaplygin_ball_in_bruns_field", "rubber_ball_in_bruns_field", "veselova_in_bruns_field"]

#: The diagonal of a tensor.
Tensor: TypeAlias = tuple[sp.Expr, sp.Expr, sp.Expr]

M, gamma, omega = vectors("M gamma omega")
I = veselova.I
DET_I = veselova.DET_I
#: Values of the energy and of the second integrals.
h, F, f = scalar("h"), scalar("F"), scalar("f")


#: J = I + D, in parameters.
ROLLING = (I.symbols[0] + D, I.symbols[1] + D, I.symbols[2] + D)


def _diagonal(entries: Tensor) -> Any:
    return constant(sp.diag(*entries))


def _integral(system: System, name: str) -> sp.Expr:
    return next(law.value for law in system.integrals if law.name == name)


def _kept_from_spinning(name: str, title: str, moments: Tensor, offset: sp.Expr) -> Separable:
    """A body with (ω, γ) = 0 and the given moments in the field ½K(γ, Iγ) − `offset`."""
    system = from_catalogue(name)
    inverse = _diagonal(tuple(1 / s for s in moments))
    clock = sp.sqrt(dot(nu, inverse * nu))
    linear = 2 * (h + offset) - K * sp.Add(*moments)
    return with_laws(
        Separable(
            name=name,
            title=title,
            system=system,
            constants=((h, _integral(system, "energy")), (F, _integral(system, "momentum"))),
            direction=gamma,
            turning=clock.xreplace({nu: gamma}) * cross(gamma, omega),
            poles=moments,
            weights=tuple(1 / gap for gap in gaps(moments)),
            leading=-4 * K / sp.Mul(*moments),
            roots=(*moments, sp.S.Zero, *quadratic(K, linear, -F)),
            speeds=(sp.S.Zero, sp.S.One),
            clock=clock,
            state=((omega, cross(nuprime, nu) / clock), (gamma, nu)),
            fixed=(gamma,),
            source="Remark 15",
        )
    )


def veselova_in_bruns_field() -> Separable:
    """The Veselova system in Bruns' field, K ≠ 0; ν = γ, dt = (γ, I⁻¹γ)^(1/2) dτ."""
    title = "Veselova system in Bruns' field"
    return _kept_from_spinning("veselova-bruns", title, I.symbols, sp.S.Zero)


def rubber_ball_in_bruns_field() -> Separable:
    """The Chaplygin ball with rubber contact in Bruns' field, K ≠ 0: J for I, U less ½KD."""
    title = "Chaplygin ball with rubber contact in Bruns' field"
    return _kept_from_spinning("rubber-chaplygin-ball-bruns", title, ROLLING, K * D / 2)


def chaplygin_ball_in_bruns_field() -> Separable:
    """The Chaplygin ball in Bruns' field at (M, γ) = 0; ν = γ, dt = (det I_Q)^(1/2) dτ."""
    system = from_catalogue("chaplygin-ball-bruns")
    inverse = _diagonal(tuple(1 / s for s in ROLLING))
    excess = D**2 + D * sp.Add(*I.symbols) + sum(DET_I / s for s in I.symbols)
    clock = sp.sqrt(sp.Mul(*ROLLING) * (1 - D * dot(nu, inverse * nu)))
    turn = cross(nuprime, nu)
    spin = (turn - dot(I * nu, turn) / dot(I * nu, nu) * nu) / clock
    return with_laws(
        Separable(
            name="chaplygin-ball-bruns",
            title="Chaplygin ball in Bruns' field at zero area constant",
            system=system,
            level=(dot(M, gamma),),
            constants=((h, _integral(system, "energy")), (f, _integral(system, "momentum"))),
            direction=gamma,
            turning=clock.xreplace({nu: gamma}) * cross(gamma, omega),
            poles=I.symbols,
            weights=tuple(1 / (s * gap) for s, gap in zip(I.symbols, gaps(I.symbols), strict=True)),
            leading=-8 * h,
            roots=(*I.symbols, -D, *quadratic(2 * h, 2 * h * D - f - K * excess, K * DET_I)),
            speeds=(sp.S.Zero, sp.S.One),
            clock=clock,
            state=((M, _diagonal(ROLLING) * spin - D * dot(spin, nu) * nu), (gamma, nu)),
            fixed=(gamma,),
            source="Remark 20",
        )
    )
