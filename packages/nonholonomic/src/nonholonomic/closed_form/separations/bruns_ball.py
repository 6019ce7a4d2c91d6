"""The Chaplygin ball in Bruns' field U = ½K(γ, Iγ) at zero area constant (Remark 20).

The coordinates are those of the ball without a field, the roots of Σ Iᵢγᵢ²/(Iᵢ − z) = 0.  Let

    ⟨b, c⟩ = Σ Iᵢbᵢcᵢ (z − Iⱼ)(z − Iₖ) = (b, Ic)z² − (tr I (b, Ic) − (Ib, Ic))z + det I (b, c),

so that ⟨γ, γ⟩ = κ(z − z₁)(z − z₂) with κ = (γ, Iγ), and let g = γ̇×γ and p(z) = ∏(z − Iᵢ).  Then

    ⟨γ, γ⟩⟨γ̇, γ̇⟩ − ⟨γ, γ̇⟩² = det I p(z) (z (g, I⁻¹g) − g²)

by Lagrange's identity, and modulo ⟨γ, γ⟩, that is for z = z₁ and for z = z₂, with S = z₁ + z₂,

    (M, ω)(z + D) − M² ≡ (S + D − z)(S − z)(z (g, I⁻¹g) − g²)        on (M, γ) = 0,
    z ((M, ω)(z + D) − M²) ≡ 2hz² + (2hD − f − Ke) z + K det I       in the field,

where e = (det J − det I)/D.  As z₁z₂ = det I/κ, det I_Q = κ(z₁ + D)(z₂ + D) and, at z₁, 2⟨γ, γ̇⟩ =
−κ(z₁ − z₂)ż₁, all this together says with dt = (det I_Q)^(1/2) dτ that

    (z₁ − z₂)² z₁′² = −4 (z₁ + D) p(z₁) (2hz₁² + (2hD − f − Ke) z₁ + K det I),

and the same for z₂: a curve of genus two.  One root of the quadratic lies between z₁ and z₂, so
both are real.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from flowlanes.system.laws import Identity, Law
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, real_symbol, vectors

from ...catalogue import from_catalogue
from ...catalogue.chaplygin_ball.chaplygin_ball import K
from ...catalogue.chaplygin_ball.chaplygin_bracket import DET_IQ, D
from ..genus_two.separation import SeparatedSystem
from ..genus_two.separation_laws import separation_laws
from .bruns import integral
from .chaplygin_ball import chaplygin_ball
from .neumann import quadratic

M, gamma, omega, g = vectors("M gamma omega g")
I = Diagonal("I")
TRACE, DET_I = sp.Add(*I.symbols), sp.Mul(*I.symbols)
#: e = (det J − det I)/D.
EXCESS = D**2 + D * TRACE + sp.Add(*(DET_I / s for s in I.symbols))
#: Values of the energy and of the momentum integral.
h, f = real_symbol("h"), real_symbol("f")

z = real_symbol("z")
#: p(z).
POLES = sp.Mul(*(z - s for s in I.symbols))
kappa, total, product = (real_symbol(f"separation_{s}") for s in ("kappa", "S", "P"))
#: (M, ω), M², (g, I⁻¹g) and g².
twice, momentum, turned, square = (real_symbol(f"separation_{s}") for s in ("T", "N", "a", "g"))
#: κ, S and P, which determine z₁ and z₂.
SHAPE = {
    kappa: dot(gamma, I * gamma),
    total: TRACE - norm_squared(I * gamma) / kappa,
    product: DET_I / kappa,
}


def chaplygin_ball_in_bruns_field() -> SeparatedSystem:
    """The Chaplygin ball in Bruns' field at (M, γ) = 0; ν = γ, dt = (det I_Q)^(1/2) dτ."""
    system = from_catalogue("chaplygin-ball-bruns")
    first, second, third = _coefficients()
    separable = replace(
        chaplygin_ball(),
        name="chaplygin-ball-bruns",
        title="Chaplygin ball in Bruns' field at zero area constant",
        system=system,
        constants=((h, integral(system, "energy")), (f, integral(system, "momentum"))),
        leading=-4 * first,
        roots=(*I.symbols, -D, *quadratic(first, second, third)),
        fixed=(gamma,),
        source="Remark 20",
    )
    laws = tuple(law for law in separation_laws(separable) if law.name != "separation")
    return replace(separable, laws=(*laws, *_separation(separable)))


def _coefficients() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The coefficients of the quadratic factor of the curve."""
    return 2 * h, 2 * h * D - f - K * EXCESS, K * DET_I


def _separation(separable: SeparatedSystem) -> tuple[Law, ...]:
    """The identities from which the separated equations follow, as at the head of this file."""
    first, second, third = _coefficients()
    bent = z * turned - square
    kinetic = twice * (z + D) - momentum
    parts = {twice: dot(M, omega), momentum: norm_squared(M)}
    level: dict[str, Any] = {"level": separable.level, "source": separable.source}
    return (
        Identity(
            "clock",
            (DET_IQ - kappa * (D**2 + D * total + product),),
            "the clock in the coordinates",
            SHAPE,
            source=separable.source,
        ),
        Identity(
            "lagrange",
            _lagrange(cross(gamma, M)),
            "Lagrange's identity for a vector γ that turns with any velocity, here called M",
            source=separable.source,
        ),
        Identity(
            "kinetic",
            _modulo(kinetic - (total + D - z) * (total - z) * bent),
            "energy and momentum without a field",
            {**SHAPE, **parts, **_bend(cross(gamma, omega))},
            **level,
        ),
        Identity(
            "field",
            _modulo(z * kinetic - (first * z**2 + second * z + third)),
            "energy and momentum integral in the field",
            {**SHAPE, **parts, **dict(separable.constants)},
            **level,
        ),
    )


def _lagrange(rate: sp.MatrixExpr) -> tuple[sp.Expr, ...]:
    """The coefficients of the difference of both sides in Lagrange's identity."""
    crossed = cross(rate, gamma)
    bent = z * dot(crossed, I**-1 * crossed) - norm_squared(crossed)
    products = _pair(gamma, gamma) * _pair(rate, rate) - _pair(gamma, rate) ** 2
    return tuple(sp.Poly(products - DET_I * POLES * bent, z).all_coeffs())


def _pair(first: sp.MatrixExpr, second: sp.MatrixExpr) -> sp.Expr:
    """⟨b, c⟩."""
    form = dot(first, I * second)
    return (
        form * z**2 - (TRACE * form - dot(I * first, I * second)) * z + DET_I * dot(first, second)
    )


def _bend(rate: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """(g, I⁻¹g) and g² for γ with a given rate."""
    return {g: cross(rate, gamma), turned: dot(g, I**-1 * g), square: norm_squared(g)}


def _modulo(polynomial: sp.Expr) -> tuple[sp.Expr, ...]:
    """The coefficients of a polynomial in z modulo z² − Sz + P."""
    remainder = sp.Poly(polynomial, z).rem(sp.Poly(z**2 - total * z + product, z))
    return tuple(remainder.all_coeffs())
