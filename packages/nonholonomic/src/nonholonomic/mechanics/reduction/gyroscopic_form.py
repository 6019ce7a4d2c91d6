"""The 2-form of gyroscopic forces S̄ dq₁ ∧ dq₂ with S̄ = N b, and its integral.

On a sphere the integral over all directions is the strength of a monopole: if it is not zero the
form is not exact, and there are no canonical momenta on the whole sphere. The integral is found
exactly if S̄/sin θ is odd in the unit vector, and if

    S̄ dθ ∧ dφ = g (γ, Bγ)^(−3/2) sin θ dθ ∧ dφ + dw,    w = R (Cγ, γ × dγ)/D.

Here R = (γ, Bγ)^(−1/2) is the irrational part of N, D divides the denominators of b, and g and C
follow from linear equations.  As w is smooth and (γ, Bγ)^(−3/2) sin θ dθ ∧ dφ is the solid angle
seen through an ellipsoid over √det B, the integral is 4πg/√det B.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement, product

import sympy as sp

from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.vectors import Vector

from ..constraints.zero_test import vanishes
from ..lagrangian.mechanism import Mechanism
from .base_coordinates import Base
from .integrals import solutions
from .multiplier import Multiplier, over_rational, positive_symbols
from .rational_evaluation import Formulas

HALF = sp.Rational(1, 2)
SHORT = 300
"""Largest number of operations of a form that is compared with the solid angle."""


@dataclass(frozen=True)
class Flux:
    """The integral of S̄ over the sphere.

    Attributes
    ----------
    value : Expr or None
        The exact integral; None if it was not found.
    words : str
        Description of how it was found.
    residual : Expr
        S̄ − g (γ, Bγ)^(−3/2) sin θ − (∂w₂/∂θ − ∂w₁/∂φ), in the angles, which vanishes; zero if no
        identity was used.
    potential : tuple of Expr or None
        w if g = 0: S̄ = ∂w₂/∂θ − ∂w₁/∂φ, smooth on the whole sphere.
    """

    value: sp.Expr | None
    words: str
    residual: sp.Expr = sp.S.Zero
    potential: tuple[sp.Expr, sp.Expr] | None = None


def flux(
    mechanism: Mechanism,
    base: Base,
    constants: Sequence[sp.Symbol],
    multiplier: Multiplier,
    b: sp.Expr,
) -> Flux:
    """The integral of S̄ = N b over the base.

    Parameters
    ----------
    mechanism : Mechanism
    base : Base
    constants : sequence of Symbol
        Constants of the linear integrals, in which b is affine.
    multiplier : Multiplier
    b : Expr
        S at rest.
    """
    zero = sp.S.Zero
    if b == 0:
        return Flux(zero, "no gyroscopic forces are left in the time τ", potential=(zero, zero))
    vector = base.normal
    if vector is None:
        return Flux(None, "the base is no sphere")
    if not _smooth(mechanism, vector, over_rational(multiplier, b)):
        return Flux(None, "S̄ is not shown to be smooth on the sphere")
    parts = [(sp.diff(b, c), c) for c in constants]
    parts.append((b.xreplace(dict.fromkeys(constants, zero)), sp.S.One))
    parts_of_flux = [
        (_of_part(mechanism, base, vector, multiplier, part), factor)
        for part, factor in parts
        if part != 0
    ]
    if any(each.value is None for each, _ in parts_of_flux):
        return Flux(None, "no closed form was found")
    total = sp.Add(
        *(factor * each.value for each, factor in parts_of_flux if each.value is not None)
    )
    residual = sp.Add(*(factor * each.residual for each, factor in parts_of_flux))
    potentials = [each.potential for each, _ in parts_of_flux if each.potential is not None]
    whole = None
    if len(potentials) == len(parts_of_flux):
        first, second = (
            sp.Add(
                *(factor * w[i] for w, (_, factor) in zip(potentials, parts_of_flux, strict=True))
            )
            for i in (0, 1)
        )
        whole = (first, second)
    words = "; ".join(f"{each.words}" for each, _ in parts_of_flux)
    return Flux(total, words, residual, whole)


def _of_part(
    mechanism: Mechanism, base: Base, vector: Vector, multiplier: Multiplier, part: sp.Expr
) -> Flux:
    if _is_odd(mechanism, base, part):
        return Flux(sp.S.Zero, "the form is odd in the unit vector")
    roots = [f for f, e in multiplier.powers if e.is_Rational and (2 * e) % 2 == 1]
    if not roots:
        g = _constant_density(base, vector, over_rational(multiplier, part))
        return Flux(None, "") if g is None else Flux(4 * sp.pi * g, "a multiple of the solid angle")
    if len(roots) != 1 or not all(e.is_Rational for _, e in multiplier.powers):
        return Flux(None, "")
    form = sp.hessian(roots[0], vector.symbols) / 2
    if not _definite(mechanism, vector, roots[0]):
        return Flux(None, "")
    return _through_ellipsoid(mechanism, base, vector, multiplier, part, roots[0], form)


def _constant_density(base: Base, vector: Vector, form: sp.Expr) -> sp.Expr | None:
    """The constant g of S̄ = g sin θ; None if there is none."""
    density = form / sp.sin(base.coordinates[0])
    if density.free_symbols & set(base.coordinates) or sp.count_ops(density) > SHORT:
        return None
    pole = dict(zip(vector.symbols, (sp.S.Zero, sp.S.Zero, sp.S.One), strict=True))
    g = density.xreplace(pole)
    unit = sp.Add(*(s**2 for s in vector.symbols)) - 1
    return g if g.is_finite is not False and vanishes(density - g, [unit]) else None


def indefinite_factors(
    mechanism: Mechanism, base: Base, multiplier: Multiplier
) -> tuple[sp.Expr, ...]:
    """Factors of N that change sign on the sphere, at the default parameters."""
    vector = base.normal
    if vector is None:
        return ()
    forms = [f for f, _ in multiplier.powers if f.has(*vector.symbols)]
    return tuple(f for f in forms if _has_both_signs(mechanism, vector, f))


def _has_both_signs(mechanism: Mechanism, vector: Vector, form: sp.Expr) -> bool:
    """Whether exact values at some directions differ in sign."""
    numbers = form.xreplace(_defaults(mechanism))
    directions = [x for x in product(range(-2, 3), repeat=3) if any(x)]
    values = (numbers.xreplace(dict(zip(vector.symbols, x, strict=True))) for x in directions)
    return {1, -1} <= {sp.sign(value) for value in values}


def _defaults(mechanism: Mechanism) -> dict[sp.Symbol, sp.Rational]:
    return {p.symbol: exact_number(p.default) for p in mechanism.parameters}


def _smooth(mechanism: Mechanism, vector: Vector, value: sp.Expr) -> bool:
    """Whether all denominators and radicands are definite forms at the defaults."""
    powers = value.as_powers_dict().items()
    delicate = [
        base
        for base, e in powers
        if base.has(*vector.symbols) and not (e.is_Integer and e.is_positive)
    ]
    return all(_definite(mechanism, vector, base) for base in delicate)


def _definite(mechanism: Mechanism, vector: Vector, base: sp.Expr) -> bool:
    """Whether a base is a definite quadratic form at the default parameters."""
    form = sp.hessian(base, vector.symbols)
    numbers = form.xreplace(_defaults(mechanism))
    if numbers.free_symbols:
        return False
    minors = [numbers[:i, :i].det() for i in (1, 2, 3)]
    # Sylvester's criterion, for positive and for negative definite forms
    signs = [sp.sign(x) for x in minors]
    return signs in ([1, 1, 1], [-1, 1, -1])


def _is_odd(mechanism: Mechanism, base: Base, part: sp.Expr) -> bool:
    """Whether part/sin θ changes sign with the unit vector."""
    theta, phi = base.coordinates
    opposite = {theta: sp.pi - theta, phi: phi + sp.pi}
    density = part.xreplace(dict(base.place)) / sp.sin(theta)
    even = Formulas([density + density.subs(opposite, simultaneous=True)], mechanism.name)
    return bool(solutions(mechanism, base, even, 1))


def _through_ellipsoid(
    mechanism: Mechanism,
    base: Base,
    vector: Vector,
    multiplier: Multiplier,
    part: sp.Expr,
    root: sp.Expr,
    form: sp.Matrix,
) -> Flux:
    """g and w from linear equations; all terms are divided by R."""
    place, (theta, phi) = dict(base.place), base.coordinates
    F = root.xreplace(place)
    rational = multiplier.value * sp.sqrt(root)
    density = (part * rational).xreplace(place)
    fields = list(_fields(base, vector, part))
    curls = [_curl(w, (theta, phi), F) for w in fields]
    terms = [density, sp.sin(theta) / F, *curls]
    for chosen in solutions(mechanism, base, Formulas(terms, mechanism.name), len(terms)):
        if 0 not in chosen:
            continue
        scale = -1 / chosen[0]
        g = scale * chosen.get(1, sp.S.Zero)
        w = [
            sp.Add(*(scale * chosen.get(i + 2, 0) * field[k] for i, field in enumerate(fields)))
            for k in (0, 1)
        ]
        shown = density - g * sp.sin(theta) / F - _curl((w[0], w[1]), (theta, phi), F)
        signs = positive_symbols(mechanism.parameters)
        back = {positive: s for s, positive in signs.items()}
        solid = sp.sqrt(sp.factor(form.det().xreplace(signs))).xreplace(back)
        value = _one_root(sp.factor(4 * sp.pi * g / solid))
        potential = (w[0] / sp.sqrt(F), w[1] / sp.sqrt(F)) if g == 0 else None
        words = "the solid angle through an ellipsoid and an exact form"
        return Flux(value, words, shown, potential)
    return Flux(None, "")


def _one_root(value: sp.Expr) -> sp.Expr:
    """A product with its square roots combined into one."""
    powers = value.as_powers_dict()
    halves = {base: e for base, e in powers.items() if e.is_Rational and e.q == 2}
    whole = sp.Mul(*(base**e for base, e in powers.items() if base not in halves))
    above = sp.Mul(*(base ** (2 * e) for base, e in halves.items() if e > 0))
    below = sp.Mul(*(base ** (-2 * e) for base, e in halves.items() if e < 0))
    return whole * sp.sqrt(above) / sp.sqrt(below)


def _fields(base: Base, vector: Vector, part: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    """(Cγ, γ × dγ)/D for elementary matrices C and factors D of the denominator."""
    place = dict(base.place)
    unit = sp.Matrix([place[s] for s in vector.symbols])
    moved = [unit.diff(q) for q in base.coordinates]
    below = sp.fraction(sp.together(part))[1]
    divisors = [f for f, _ in sp.factor_list(below)[1] if f.has(*vector.symbols)]
    forms = []
    for divisor in divisors or [sp.S.One]:
        # C = E gives (γ, γ×dγ) = 0, so that one diagonal entry is redundant
        for i, j in list(combinations_with_replacement(range(3), 2))[:-1]:
            C = sp.zeros(3)
            C[i, j] = C[j, i] = 1
            turned = [(C * unit).dot(unit.cross(d)) / divisor.xreplace(place) for d in moved]
            forms.append((turned[0], turned[1]))
    return forms


def _curl(w: tuple[sp.Expr, sp.Expr], q: tuple[sp.Symbol, sp.Symbol], F: sp.Expr) -> sp.Expr:
    """∂(R w₂)/∂q₁ − ∂(R w₁)/∂q₂ over R = F^(−1/2)."""
    bent = sp.diff(F, q[0]) * w[1] - sp.diff(F, q[1]) * w[0]
    return sp.diff(w[1], q[0]) - sp.diff(w[0], q[1]) - HALF * bent / F
