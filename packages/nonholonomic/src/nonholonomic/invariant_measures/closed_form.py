"""Densities in closed form: σ = Σ e_i log b_i with rational exponents.

The derivatives of log b_i for known functions b_i are compared with the 1-form at points, for the
numbers of the body.  The result is a conjecture that the prover decides.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

import numpy as np
import sympy as sp
from flint import arb

from flowlanes.formulas.jets import Evaluator
from flowlanes.formulas.number_fields import Balls, ball_precision
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import scalars
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, dot, norm_squared, real_symbol
from lawproof.proof.level.level_set import LevelSet

from ..mechanics.rolling.contact import contact
from ..mechanics.rolling.equations import RollingBody
from .one_form import OneForm, Powers

gamma, r, gammatilde = Vector("gamma"), Vector("r"), Vector("gammatilde")
I = Diagonal("I")
m, a = real_symbol("m"), real_symbol("a")
b = tuple(real_symbol(f"b_{i}") for i in (1, 2, 3))

POINTS = 10
SEED = 20080830
MOST_FACTORS = 4
#: Largest denominator of the exponents.
DENOMINATOR = 8
AGREE = 1e-9


def _determinant(principal: bool) -> tuple[sp.Expr, ...]:
    """Factors of det(I + m r²)."""
    if principal:
        return tuple(Diagonal("J").symbols)
    return (Symmetric("J").entries.det(method="berkowitz"),)


def _share(rolling: RollingBody) -> sp.Expr:
    """det Ĩ/det J = 1 − m (r, J⁻¹r)."""
    tensor = Diagonal("A") if rolling.body.principal else Symmetric("A")
    return 1 - m * dot(r, tensor * r)


def _across(rolling: RollingBody) -> tuple[sp.Expr, ...]:
    """Factors of det Ĩ (γ, Ĩ⁻¹γ)/det J; if r is parallel to γ this is (γ, J⁻¹γ)."""
    shape = rolling.body.shape
    if shape.is_balanced_ball:
        tensor = Diagonal("A") if rolling.body.principal else Symmetric("A")
        return (dot(gamma, tensor * gamma),)
    return _share(rolling), dot(gamma, gammatilde)


def _bases(rolling: RollingBody) -> tuple[sp.Expr, ...]:
    """Functions whose powers may form the density."""
    body = rolling.body
    principal = body.principal
    first = I.symbols[0] if principal else Symmetric("I").symbols[0]
    bases = [*_determinant(principal)]
    if rolling.contact == "rubber":
        bases += [*_across(rolling), first + m * dot(r, gamma) ** 2]
    else:
        bases.append(_share(rolling))
    if body.shape.is_ellipsoid and principal and not body.shape.is_turned:
        bases += _of_ellipsoid()
    return tuple(scalars(bases))


def _of_ellipsoid() -> list[sp.Expr]:
    """α + m r², and (γ, (βB + δE)γ) of the line α + βI_i b_i² + δ(I_i − m b_i²) = 0."""
    bases = [I.symbols[0] - m * b[0] ** 2 + m * norm_squared(r)]
    for i, j in ((0, 1), (1, 2)):
        beta, delta = (
            (I.symbols[i] - m * b[i] ** 2) - (I.symbols[j] - m * b[j] ** 2),
            I.symbols[j] * b[j] ** 2 - I.symbols[i] * b[i] ** 2,
        )
        bases.append(
            sp.Add(*((beta * s**2 + delta) * g**2 for s, g in zip(b, gamma.symbols, strict=True)))
        )
    return bases


def closed_form(rolling: RollingBody, form: OneForm, numbers: Sequence[sp.Expr]) -> Powers | None:
    """e^σ as a product of powers of known functions; None if there is no such product.

    Parameters
    ----------
    numbers : sequence of sympy.Expr
        The level on which every parameter has its value.
    """
    if (
        form.scale.xreplace({p.symbol: exact_number(p.default) for p in form.system.parameters})
        == 0
    ):
        return ()
    bases = _bases(rolling)
    rows, right = _samples(form, bases, tuple(numbers))
    if np.linalg.norm(right) < AGREE:
        return ()
    usable = [i for i in range(len(bases)) if AGREE < np.linalg.norm(rows[:, i]) < np.inf]
    # products of few factors first: by least squares the exponents must fit all samples and be
    # rational
    for size in range(1, MOST_FACTORS + 1):
        for chosen in combinations(usable, size):
            part = rows[:, chosen]
            solution = np.linalg.lstsq(part, right, rcond=None)[0]
            if np.linalg.norm(part @ solution - right) > AGREE * np.linalg.norm(right):
                continue
            exponents = [Fraction(float(e)).limit_denominator(DENOMINATOR) for e in solution]
            if max(abs(float(e) - x) for e, x in zip(exponents, solution, strict=True)) < AGREE:
                return tuple(
                    (
                        _sign(form, bases[i], tuple(numbers)) * bases[i],
                        form.scale * sp.Rational(e.numerator, e.denominator),
                    )
                    for i, e in zip(chosen, exponents, strict=True)
                )
    return None


def _sign(form: OneForm, base: sp.Expr, level: tuple[sp.Expr, ...]) -> int:
    """−1 for a base that is negative at one normal, and therefore everywhere, else 1."""
    ground = LevelSet(form.system, level)
    with ball_precision():
        values, _ = ground.point(random.Random(SEED))
        value = ground.partial(Balls(values))(base).value
    return -1 if value < 0 else 1


def _samples(
    form: OneForm, bases: Sequence[sp.Expr], level: tuple[sp.Expr, ...]
) -> tuple[FloatArray, FloatArray]:
    """Derivatives of log b_i, and θ/scale, along tangent vectors at some points."""
    ground = LevelSet(form.system, level)
    rng = random.Random(SEED)
    rows: list[list[float]] = []
    right: list[float] = []
    with ball_precision():
        while len(rows) < POINTS:
            try:
                row, value = _at_point(form, bases, ground, rng)
            except ZeroDivisionError:
                continue
            rows.append(row)
            right.append(value)
    return np.array(rows), np.array(right)


def _at_point(
    form: OneForm, bases: Sequence[sp.Expr], ground: LevelSet, rng: random.Random
) -> tuple[list[float], float]:
    """Derivatives along one tangent vector of the state, perpendicular to γ and a fixed vector."""
    values, _ = ground.point(rng)
    field = Balls(values)
    partial = ground.partial(field)
    fixed = (field.rational(3), field.rational(-5), field.rational(7))
    normal = [partial(s).value for s in gamma.symbols]
    along = [
        normal[(i + 1) % 3] * fixed[(i + 2) % 3] - normal[(i + 2) % 3] * fixed[(i + 1) % 3]
        for i in range(3)
    ]
    row = []
    for base in bases:
        try:
            jet = partial(base)
            slope = sum((jet.slopes.get(i, field.zero) * along[i] for i in range(3)), field.zero)
            row.append(float((slope / jet.value).mid()))
        except ZeroDivisionError:
            row.append(np.inf)
    scale = partial(form.scale).value
    total = field.zero
    for component, turned in zip(form.form.symbols, _turning(partial, along), strict=True):
        total = total + partial(component).value * turned
    return row, float((total / scale).mid())


def _turning(partial: Evaluator, along: Sequence[arb]) -> list[arb]:
    """The change of γ along a change of the state, γ or r."""
    jets = [partial(s) for s in gamma.symbols]
    zero = along[0] * 0
    return [sum((jet.slopes.get(i, zero) * along[i] for i in range(3)), zero) for jet in jets]


def density(rolling: RollingBody, powers: Powers) -> Powers:
    """The density in the state of the equations of motion, from that in momenta and γ.

    A marble body has the state M, γ, a rubber one ω, γ; r replaces γ if the shape is given by an
    equation.
    """
    factors_of_density = list(powers)
    principal = rolling.body.principal
    if rolling.contact == "rubber":
        # The momenta perpendicular to γ have the determinant det Ĩ (γ, Ĩ⁻¹γ) in ω.
        factors = (*_determinant(principal), *_across(rolling))
        factors_of_density += [(base, sp.S.One) for base in factors]
    kinematics = contact(rolling.body.shape, rolling.surface)
    factors_of_density += [(factor, sp.S.One) for factor in kinematics.volume]
    reach = kinematics.r
    written = {} if isinstance(reach, Vector) else dict(zip(r, scalars(reach), strict=True))
    total: dict[sp.Expr, sp.Expr] = {}
    for base, exponent in factors_of_density:
        formula = scalars(base)[0].xreplace(written)
        total[formula] = total.get(formula, sp.S.Zero) + exponent
    return tuple((base, exponent) for base, exponent in total.items() if exponent != 0)
