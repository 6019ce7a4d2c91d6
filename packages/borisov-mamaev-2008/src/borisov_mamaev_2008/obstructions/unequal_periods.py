"""Closed motions of the Chaplygin ball on one torus with different periods.

At (M, γ) = 0 the roots z₁, z₂ of Σ Iᵢγᵢ²/(Iᵢ − z) = 0 move between I₁ and e = M²/2H − D and between
I₂ and I₃ (:mod:`nonholonomic.closed_form.separations.chaplygin_ball`).  With z₁ = I₁ + (e − I₁)
sin²α, z₂ = I₂ + (I₃ − I₂) sin²β and 2H = 1

    ds = dα/√(z₁(z₁ + D)(I₂ − z₁)(I₃ − z₁)) = dβ/√(z₂(z₂ + D)(z₂ − I₁)(z₂ − e)),
    dt = (z₂ − z₁) √(det I (z₁ + D)(z₂ + D)/(z₁z₂)) ds.

α and β, modulo 2π, are angles on a torus: γ₁ has the sign of sin α, and γ₂ and γ₃ have those of
sin β and cos β. Let A(e) and B(e) be the increase of s while α or β increases by π. If A = 2B,
every motion on the torus is closed, with two turns of β for one of α, and its period is twice the
integral of dt over 0 ≤ α ≤ π. Rigorous bounds show that A − 2B changes sign between two values of
e, with a non-zero derivative, and that for all e between them the motions from (0, 0) and (0, π/2)
have different periods.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import TypeAlias, TypeVar

import sympy as sp
from flint import acb, arb, arb_series, ctx

from flowlanes.system.laws import Identity
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import constant, dot, real_symbol
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import (
    DET_J,
    PARAMETERS,
    TENSORS,
    A,
    D,
    I,
)
from nonholonomic.closed_form.genus_two.separation import nu
from nonholonomic.closed_form.separations.chaplygin_ball import CLOCK, chaplygin_ball
from nonholonomic.closed_form.separations.fedorov import fedorov

from ..methods.derived_verdicts import computed_verdict

T = TypeVar("T", arb, arb_series)
#: I and D = mR² as decimal strings.
BallNumbers: TypeAlias = tuple[tuple[str, str, str], str]
#: A slender ball: 5 kg and a radius of 1 m are compatible with these moments.
BALL: BallNumbers = (("0.2", "2", "2.1"), "5")
#: Two values of e; the resonant torus lies between them.
BETWEEN = ("1.20074", "1.20075")
STEPS, ORDER = 64, 12
#: Bound of dβ/dα, verified on the boxes.
STEEPEST = 8
PRECISION = 128

z_1, z_2 = real_symbol("z_1"), real_symbol("z_2")


def _moments_and_lever(ball: BallNumbers) -> tuple[arb, arb, arb, arb]:
    (first, second, third), lever = ball
    return arb(first), arb(second), arb(third), arb(lever)


def _rates(alpha: T, beta: T, level: arb, ball: BallNumbers) -> tuple[T, T]:
    """dβ/dα and dt/dα, for numbers or power series."""
    i_1, i_2, i_3, lever = _moments_and_lever(ball)
    low, high = alpha.sin(), beta.sin()
    first = low * low * (level - i_1) + i_1
    second = high * high * (i_3 - i_2) + i_2
    gaps = (i_2 - first) * (i_3 - first)
    across = second * (second + lever) * (second - i_1) * (second - level)
    steep = (across / (first * (first + lever) * gaps)).sqrt()
    slow = ((second + lever) * (i_1 * i_2 * i_3) / (second * gaps)).sqrt() / first
    return steep, (second - first) * slow


def _series(alpha: arb, beta: arb, level: arb, ball: BallNumbers) -> tuple[list[arb], list[arb]]:
    """Taylor coefficients of β and t in α, up to `ORDER`, at a point or on a box."""
    place = arb_series([alpha, arb(1)])
    moved = arb_series([beta])
    # Picard iteration: every pass makes one more coefficient exact.
    for _ in range(ORDER):
        steep, _ = _rates(place, moved, level, ball)
        moved = steep.integral() + beta
    return moved.coeffs(), _rates(place, moved, level, ball)[1].integral().coeffs()


def _step(alpha: arb, beta: arb, step: arb, level: arb, ball: BallNumbers) -> tuple[arb, arb]:
    """Bounds of β at α + `step`, and of the increase of t.

    By Taylor's formula, with the last coefficient evaluated on a box that contains the motion.
    """
    across = alpha.union(alpha + step)
    box = beta.union(beta + STEEPEST * step)
    steep, _ = _rates(across, box, level, ball)
    if not 0 < steep < STEEPEST:
        raise ArithmeticError("the slope on the torus exceeds its assumed bound")
    here = _series(alpha, beta, level, ball)
    there = _series(across, box, level, ball)
    sums = []
    for near, far in zip(here, there, strict=True):
        terms = [c * step**i for i, c in enumerate(near[:ORDER])]
        sums.append(sum(terms, far[ORDER] * step**ORDER))
    return sums[0], sums[1]


def half_period(
    start: arb, ball: BallNumbers = BALL, between: Sequence[str] = BETWEEN
) -> tuple[arb, arb]:
    """The increase of t and β while α grows from 0 to π, for every e between two values.

    Parameters
    ----------
    start : arb
        β at α = 0.
    ball : moments and D
    between : two decimal fractions

    Returns
    -------
    tuple of arb
        Balls that contain both values for every e in the interval.

    Raises
    ------
    ArithmeticError
        If a slope exceeds the bound assumed for the boxes.
    """
    precision = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = PRECISION, ORDER + 1
    try:
        level = arb(between[0]).union(arb(between[1]))
        step = arb.pi() / STEPS
        beta, elapsed = start, arb(0)
        for i in range(STEPS):
            beta, grown = _step(step * i, beta, step, level, ball)
            elapsed += grown
        return elapsed, beta - start
    finally:
        ctx.prec, ctx.cap = precision


def resonance(level: arb, ball: BallNumbers = BALL) -> tuple[arb, arb]:
    """A − 2B and its derivative with respect to e, at one value or on an interval."""
    i_1, i_2, i_3, lever = (acb(x) for x in _moments_and_lever(ball))
    e = acb(level)

    def low(angle: acb, analytic: bool) -> tuple[acb, acb]:
        share = angle.sin() ** 2
        z = i_1 + (e - i_1) * share
        value = 1 / (z * (z + lever) * (i_2 - z) * (i_3 - z)).sqrt(analytic=analytic)
        return value, -value * share / 2 * (1 / z + 1 / (z + lever) - 1 / (i_2 - z) - 1 / (i_3 - z))

    def high(angle: acb, analytic: bool) -> tuple[acb, acb]:
        z = i_2 + (i_3 - i_2) * angle.sin() ** 2
        value = 1 / (z * (z + lever) * (z - i_1) * (z - e)).sqrt(analytic=analytic)
        return value, value / (2 * (z - e))

    def integral(rate: Callable[[acb, bool], tuple[acb, acb]], which: int) -> arb:
        whole = acb.integral(lambda s, analytic: rate(s, analytic)[which], acb(0), acb.pi())
        return whole.real

    return integral(low, 0) - 2 * integral(high, 0), integral(low, 1) - 2 * integral(high, 1)


def clock() -> tuple[System, Identity]:
    """(dt/dτ)² in terms of z₁ and z₂, with dτ = (z₂ − z₁) ds: det I (z₁ + D)(z₂ + D)/(z₁z₂)."""
    separable = chaplygin_ball()
    moments = sp.Mul(*I.symbols)
    places = [
        sp.sqrt(moments * weight * (z_1 - i) * (z_2 - i) / (z_1 * z_2))
        for i, weight in zip(I.symbols, separable.weights, strict=True)
    ]
    resting = System(
        name="chaplygin-ball-roots",
        title="The normal in the roots z₁, z₂",
        parameters=(
            *PARAMETERS,
            Parameter(z_1, "first root", 1.2),
            Parameter(z_2, "second root", 1.8),
        ),
        definitions={**TENSORS, nu: constant(places)},
        field={real_symbol("tau"): sp.S.One},
    )
    squared = DET_J * (1 - D * dot(nu, A * nu))
    law = Identity(
        "clock",
        (
            CLOCK**2 - squared,
            dot(nu, nu) - 1,
            squared - moments * (z_1 + D) * (z_2 + D) / (z_1 * z_2),
        ),
    )
    return resting, law


@cache
def unequal_periods() -> Verdict:
    """The verdict that two closed motions on one torus of a certain ball have different periods."""
    proofs = [
        prove(separable.system, law)
        for separable in (chaplygin_ball(), fedorov())
        for law in separable.laws
    ]
    proofs.append(prove(*clock()))
    low, high = (resonance(arb(e))[0] for e in BETWEEN)
    slope = resonance(arb(BETWEEN[0]).union(arb(BETWEEN[1])))[1]
    resonant = low * high < 0 and not slope.contains(0)
    first, second = (half_period(start)[0] for start in (arb(0), arb.pi() / 2))
    shown = all(proofs) and resonant and not first.overlaps(second)
    return computed_verdict(
        "unequal periods",
        shown,
        f"on a torus with M²/2H − D between {' and '.join(BETWEEN)} two closed motions have "
        f"the periods {2 * float(first):.3f} and {2 * float(second):.3f} for 2H = 1",
        "the bounds do not decide, or the separation is not proven",
    )
