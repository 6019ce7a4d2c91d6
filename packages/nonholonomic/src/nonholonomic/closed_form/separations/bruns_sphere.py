"""The hollow ball around a sphere, k = −1, in Bruns' field U = ½K(n, In) (§8.3, §12).

On the zero level of the linear integral (AM, n), which the field does not change, the ball
separates as without the field: in the coordinates of :mod:`.ball_sphere`, the roots of Σ
Aᵢ²Iᵢnᵢ²/(Iᵢ − z) = 0, for z = z₁ and for z = z₂

    (n, In) zL + det J (n, J⁻¹n) Q = (¼T² + e₂) L − det J (½T − z)²,

which does not involve the other coordinate.  That the kinetic parts of both integrals separate is
an identity at every instant, proven as for :mod:`.ball_sphere`.  So with the energy h and the
momentum integral f = M² − K det J (n, J⁻¹n) the curve, again of genus two, is

    y² = p L (2hzL − fQ − K((¼T² + e₂) L − det J (½T − z)²)).

Its quadratic factor has one root between z₁ and z₂, as L > 0 there; so both are real.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Identity
from flowlanes.system.named_formulas import scalars
from flowlanes.system.vectors import Diagonal, dot, real_symbol, vectors

from ...catalogue import from_catalogue
from ...catalogue.chaplygin_ball.chaplygin_ball import K
from ..genus_two.separation import SeparatedSystem, gaps
from ..genus_two.separation_laws import separation_laws
from .ball_sphere import hollow_ball
from .bruns import integral
from .neumann import quadratic

(gamma,) = vectors("gamma")
I, J = Diagonal("I"), Diagonal("J")
D = real_symbol("m") * real_symbol("R") ** 2
#: ½T and A.
HALF = (sp.Add(*I.symbols) + D) / 2
LEVER = tuple(HALF - s for s in I.symbols)
E_2 = sp.Add(*(LEVER[i] * LEVER[i - 1] for i in range(3)))
E_3 = sp.Mul(*LEVER)
DET_J = sp.Mul(*(s + D for s in I.symbols))
#: ¼T² + e₂.
WEIGHT = HALF**2 + E_2
#: Values of the energy and of the momentum integral.
h, f = real_symbol("h"), real_symbol("f")

z = real_symbol("z")
total, product = (real_symbol(f"separation_{s}") for s in ("S", "P"))
#: (n, In) and det J (n, J⁻¹n).
form, inverse = (real_symbol(f"separation_{s}") for s in ("I", "A"))


def hollow_ball_in_bruns_field() -> SeparatedSystem:
    """A hollow ball around a sphere of half its radius, R = 2a, in Bruns' field."""
    system = from_catalogue("ball-around-sphere-bruns")
    # the quadratic factor in u = ½T − z
    square = f * D + K * DET_J - 2 * h * E_2
    linear = 2 * h * (HALF * E_2 + E_3) - (f + K * WEIGHT) * E_2
    constant = (f + K * WEIGHT - 2 * h * HALF) * E_3
    far, near = quadratic(square, linear, constant)
    separable = replace(
        hollow_ball(system),
        name=system.name,
        title="Hollow ball around a sphere of half its radius, in Bruns' field",
        constants=((h, integral(system, "energy")), (f, integral(system, "momentum"))),
        leading=E_2 * square,
        roots=(*I.symbols, HALF - E_3 / E_2, HALF - near, HALF - far),
        fixed=(),
        source="§8.3, §12",
    )
    laws = tuple(law for law in separation_laws(separable) if law.name != "separation")
    return replace(separable, laws=(*laws, _field(separable)))


def _field(separable: SeparatedSystem) -> Identity:
    """The law of the terms added by the field, modulo (z − z₁)(z − z₂)."""
    level = E_2 * (HALF - z) - E_3
    ratio = level - D * (HALF - z) ** 2
    added = form * z * level + inverse * ratio - WEIGHT * level + DET_J * (HALF - z) ** 2
    remainder = sp.Poly(added, z).rem(sp.Poly(z**2 - total * z + product, z))
    return Identity(
        "field",
        tuple(remainder.all_coeffs()),
        "what the field adds, in the coordinates",
        {
            **_coordinates(separable),
            form: dot(gamma, I * gamma),
            inverse: DET_J * dot(gamma, J**-1 * gamma),
        },
        source=separable.source,
    )


def _coordinates(separable: SeparatedSystem) -> dict[sp.Symbol, sp.Expr]:
    """z₁ + z₂ and z₁z₂, by interpolation at the poles."""
    poles = separable.poles
    shares = [
        s**2 / (weight * gap)
        for s, weight, gap in zip(
            scalars(separable.direction), separable.weights, gaps(poles), strict=True
        )
    ]
    others = [(poles[i - 1], poles[i - 2]) for i in range(3)]
    kappa = sp.Add(*shares)
    return {
        total: sp.Add(*(s * (e + g) for s, (e, g) in zip(shares, others, strict=True))) / kappa,
        product: sp.Add(*(s * e * g for s, (e, g) in zip(shares, others, strict=True))) / kappa,
    }
