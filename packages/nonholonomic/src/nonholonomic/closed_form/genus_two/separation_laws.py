"""The claims of a separable system, as laws that :mod:`lawproof.proof` can prove.

The polynomial q(z) = κ(z − z₁)(z − z₂) is the one that takes the values ν_i²/weights_i at the three
poles, so that κ, z₁ + z₂ and z₁z₂ are rational in ν.  Written with S = z₁ + z₂, P = z₁z₂ and their
derivatives in τ, both separated equations are one statement about polynomials in z,

    (S′z − P′)² ≡ (b − a(S − z))² y²(z)      modulo z² − Sz + P,

because z₁′(z₁ − z₂) = S′z₁ − P′, and Σ dz/y = a dτ, Σ z dz/y = b dτ imply z₁′(z₁ − z₂) = (b −
az₂)y₁.  No root has to be computed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeAlias

import sympy as sp

from flowlanes.formulas.balls import components
from flowlanes.system.laws import Identity, Law, Rate, Reduction
from flowlanes.system.named_formulas import scalars
from flowlanes.system.vectors import Vector, cross, norm_squared, real_symbol, vectors

from .separation import SeparatedSystem, gaps, nu, nuprime

#: c₁z + c₀ as (c₁, c₀).
Linear: TypeAlias = tuple[sp.Expr, sp.Expr]

#: κ, S, P and their derivatives in τ.
kappa, total, product = (real_symbol(f"separation_{s}") for s in ("kappa", "S", "P"))
kappaprime, totalprime, productprime = (
    real_symbol(f"separation_{s}prime") for s in ("kappa", "S", "P")
)
omega, still = vectors("omega still")


def separation_laws(separable: SeparatedSystem) -> tuple[Law, ...]:
    """The laws of a separation: constants, direction, curve, state, fixed vectors.

    Parameters
    ----------
    separable : SeparatedSystem
        A separation; its attribute `laws` is not used.

    Returns
    -------
    tuple of Law
        Laws of ``separable.system``, each on ``separable.level``.  `direction` says that ν² = 1 and
        that ν′ is the derivative of ν in the time of the clock, `separation` that the separated
        equations hold, `reconstruction` that the formulas in ν, ν′ give the state.
    """
    constants = dict(separable.constants)
    # Constants given by parameters and other constants alone need no proof.
    given_by = {*constants, *(p.symbol for p in separable.system.parameters)}
    moving = [s for s, value in constants.items() if scalars(value)[0].free_symbols - given_by]
    known = {**constants, nu: separable.direction, nuprime: separable.turning}
    common: dict[str, Any] = {"level": separable.level, "source": separable.source}
    (clock,) = scalars(separable.time_rescaling)
    turned = [
        after - clock * Rate(before)
        for before, after in zip(nu.symbols, nuprime.symbols, strict=True)
    ]
    residuals = [
        difference for name, formula in separable.state for difference in components(name - formula)
    ]
    fixed = [
        Identity(
            f"fixed_{number}",
            tuple(scalars(cross(_rate(still) + cross(omega, still), still))),
            "a direction that stays in space",
            {**constants, still: vector},
            **common,
        )
        for number, vector in enumerate(separable.fixed, 1)
    ]
    conservation = [
        Reduction(
            "constants",
            constants,
            tuple(Rate(symbol) for symbol in moving),
            "constants of the motion",
            **common,
        )
    ]
    return (
        *(conservation if moving else ()),
        Identity(
            "direction",
            (norm_squared(nu) - 1, *turned),
            "a unit vector and its derivative in the new time",
            known,
            **common,
        ),
        Identity(
            "separation",
            _separated_equations(separable),
            "separated equations on a curve of genus two",
            {**known, **_symmetric(separable)},
            **common,
        ),
        Identity("reconstruction", tuple(residuals), "the state from ν and ν′", known, **common),
        *fixed,
    )


def with_laws(separable: SeparatedSystem) -> SeparatedSystem:
    """The separable system together with its laws."""
    return replace(separable, laws=separation_laws(separable))


def _rate(vector: Vector) -> sp.MatrixExpr:
    return sp.ImmutableDenseMatrix([Rate(s) for s in vector.symbols])


def _symmetric(separable: SeparatedSystem) -> Mapping[sp.Symbol, sp.Expr]:
    """κ, S, P and their derivatives, from ν and ν′ by interpolation at the poles."""
    poles = separable.poles
    others = [[e for e in poles if e != pole] for pole in poles]
    scales = [
        1 / (weight * gap) for weight, gap in zip(separable.weights, gaps(poles), strict=True)
    ]
    sums = [e + f for e, f in others]
    products = [e * f for e, f in others]
    here = [c * x**2 for c, x in zip(scales, nu.symbols, strict=True)]
    there = [2 * c * x * y for c, x, y in zip(scales, nu.symbols, nuprime.symbols, strict=True)]

    def against(shares: list[sp.Expr], values: list[sp.Expr]) -> sp.Expr:
        return sp.Add(*(share * value for share, value in zip(shares, values, strict=True)))

    return {
        kappa: sp.Add(*here),
        total: against(here, sums) / kappa,
        product: against(here, products) / kappa,
        kappaprime: sp.Add(*there),
        totalprime: (against(there, sums) - kappaprime * total) / kappa,
        productprime: (against(there, products) - kappaprime * product) / kappa,
    }


def _separated_equations(separable: SeparatedSystem) -> tuple[sp.Expr, sp.Expr]:
    """Both coefficients of (S′z − P′)² − (b − a(S − z))² y²(z), modulo z² − Sz + P."""
    a, b = separable.speeds
    moving = (totalprime, -productprime)
    other = (a, b - a * total)
    curve: Linear = (sp.S.Zero, separable.leading)
    # Multiply the poles last: roots of a quadratic first combine, and their square root disappears.
    for root in reversed(separable.roots):
        curve = _times(curve, (sp.S.One, -root))
    left = _times(moving, moving)
    right = _times(_times(other, other), curve)
    return left[0] - right[0], left[1] - right[1]


def _times(first: Linear, second: Linear) -> Linear:
    """The product of two linear polynomials modulo z² − Sz + P."""
    top = first[0] * second[0]
    return (
        first[0] * second[1] + first[1] * second[0] + top * total,
        first[1] * second[1] - top * product,
    )
