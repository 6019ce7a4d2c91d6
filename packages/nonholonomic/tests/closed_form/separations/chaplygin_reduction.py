"""Motions of the Chaplygin ball from those at zero area constant.

A ball with D′, I′ at (M′, γ′) = 0 and a number b give a ball with D, I, M, γ by

    N² = 1 + b²f′,  e = 1 + 2h′D′b²:      D = D′N²/e,      I = I′ + D′ − D,
    M = (M′ + 2h′D′bγ′)/e,      γ = (γ′ − bM′)/N,      dt = (1 + bD′(ω′, γ′)) dt′,

with the energy h′ and f′ = M′².  Read the other way this is the module
`chaplygin_ball_area_constant`, with b = β/n.  Here nothing but N is a root,
and the claims there come in parts that can be proven:

- `chart`: h′ and f′ are constant; M is the momentum that belongs to ω, γ, I and D; its
  energy, square and area constant.  So M and γ, which like M′ and γ′ stay in space, move as those
  of a ball.
- `chart_at_level`: for all values of h′ and f′ the constants of that module are D′, β/n = b, …, its
  formulas lead from M, γ to γ′ and from γ′, M′ back, and its curve, clock and momentum M′ are those
  of the module `chaplygin_ball` with I′, D′, h′, f′, the curve shifted by δ.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Law
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import A, D, I, J, R, m
from nonholonomic.closed_form.genus_two.separation import nu, nuprime
from nonholonomic.closed_form.separations.chaplygin_ball import SPIN, chaplygin_ball
from nonholonomic.closed_form.separations.chaplygin_ball_area_constant import (
    BETA,
    D_ZERO,
    MOMENTUM,
    NORMAL,
    chaplygin_area,
    delta,
    e as stretch,
    f,
    g,
    h,
    n,
    original_vectors,
    sigma,
)

M, gamma, omega, Mprime, gammaprime, omegaprime = vectors(
    "M gamma omega Mprime gammaprime omegaprime"
)
Iprime = Diagonal("Iprime")
Dprime, hprime, fprime, b, N, e, slowness = (
    real_symbol(name) for name in ("Dprime", "hprime", "fprime", "b", "N", "eprime", "slowness")
)

SOURCE = "§7, Chaplygin (1903)"
#: Energy, square of the momentum and area constant of the ball that is made.
LEVELS = {
    h: hprime / e,
    f: (fprime + 4 * hprime**2 * Dprime**2 * b**2) / e**2,
    g: b * (2 * hprime * Dprime - fprime) / (e * N),
}


def chart() -> System:
    """The ball in M′, γ′ and the time t, with M, γ, ω, I, m and dt/dt′ as definitions."""
    spread = 1 - Dprime * dot(gammaprime, A * gammaprime)
    spin = dot(A * gammaprime, Mprime) / spread
    return System(
        name="chaplygin-ball-from-zero-area",
        title="Chaplygin ball from one at zero area constant",
        summary="Chaplygin's reduction, read backwards.",
        source=SOURCE,
        parameters=(
            Parameter(Dprime, "D′ of the ball at zero area constant", 0.8, "kg m^2", (Dprime > 0,)),
            *(
                Parameter(s, f"I′ of that ball, body axis {i}", value, "kg m^2", (s > 0,))
                for i, (s, value) in enumerate(
                    zip(Iprime.symbols, (1.0, 1.5, 2.1), strict=True), start=1
                )
            ),
            Parameter(R, "radius", 1.0, "m", (R > 0,)),
            Parameter(b, "by which the plane of M′ and γ′ is turned", 0.4, "s/(kg m^2)"),
        ),
        definitions={
            J: Iprime + Dprime * identity,
            A: J**-1,
            omegaprime: A * Mprime + Dprime * spin * (A * gammaprime),
            hprime: dot(Mprime, omegaprime) / 2,
            fprime: norm_squared(Mprime),
            N: sp.sqrt(1 + b**2 * fprime),
            e: 1 + 2 * hprime * Dprime * b**2,
            m: Dprime * N**2 / (e * R**2),
            I: J - D * identity,
            M: (Mprime + 2 * hprime * Dprime * b * gammaprime) / e,
            gamma: (gammaprime - b * Mprime) / N,
            slowness: 1 + b * Dprime * dot(omegaprime, gammaprime),
            omega: omegaprime / slowness,
        },
        field={Mprime: cross(Mprime, omega), gammaprime: cross(gammaprime, omega)},
        relations=(norm_squared(gammaprime) - 1, dot(Mprime, gammaprime)),
        laws=_moving(),
    )


def chart_at_level() -> System:
    """The chart with h′ and f′ as positive numbers."""
    system = chart()
    gone = (hprime, fprime)
    return replace(
        system,
        name=f"{system.name}-at-a-level",
        parameters=(
            *system.parameters,
            Parameter(hprime, "energy of the ball at zero area constant", 0.9, "J", (hprime > 0,)),
            Parameter(fprime, "square of its momentum", 4.0, "kg^2 m^4/s^2", (fprime > 0,)),
        ),
        definitions=tuple(pair for pair in system.definitions if pair[0] not in gone),
        guards=(
            Guard(
                "reach",
                fprime - 2 * hprime * Dprime,
                "no motion at zero area constant has this energy and momentum",
            ),
        ),
        laws=_still(),
    )


def _moving() -> tuple[Law, ...]:
    energy, square, area = LEVELS.values()
    return (
        Integral("energy", hprime, "energy at zero area constant", source=SOURCE, unit="J"),
        Integral("square", fprime, "square of M′", source=SOURCE, unit="kg^2 m^4/s^2"),
        Identity(
            "momentum",
            J * omega - D * dot(omega, gamma) * gamma - M,
            "M is the momentum of the ball with ω, γ, I and D",
            source=SOURCE,
        ),
        Identity(
            "levels",
            (
                dot(M, omega) / 2 - energy,
                norm_squared(M) - square,
                dot(M, gamma) - area,
                norm_squared(gamma) - 1,
            ),
            "energy, square of the momentum, area constant",
            source=SOURCE,
        ),
        Identity(
            "time",
            e - slowness * (1 - b * e / N * D * dot(omega, gamma)),
            "dt/dt′ in ω and γ",
            source=SOURCE,
        ),
    )


def _still() -> tuple[Law, ...]:
    separable, zero = chaplygin_area(), chaplygin_ball()
    computed = {**LEVELS, **dict(separable.constants[len(LEVELS) :])}
    # as the first of the laws gives them
    known = {
        **LEVELS,
        sigma: -g * N / (b * e),
        delta: D - Dprime,
        D_ZERO: Dprime,
        stretch: e,
        n: e / N,
    }
    # any two vectors may stand for ν and ν′
    known |= {nu: gammaprime, nuprime: Mprime}
    constants = Identity(
        "constants",
        (D_ZERO - Dprime, stretch - e, n - e / N, BETA / n - b),
        "D′, e, n and β/n = b",
        computed,
        source=SOURCE,
    )
    claims = {
        "normal": ("γ′ from M and γ", to_components(NORMAL - gammaprime)),
        "state": (
            "M and γ from M′ and γ′",
            [
                component
                for vector, formula in original_vectors(Mprime, gammaprime)
                for component in to_components(vector - formula)
            ],
        ),
        "curve": (
            "the curve at zero area constant, shifted by δ",
            [
                separable.leading - _at_zero(zero.leading),
                *(
                    here + delta - _at_zero(there)
                    for here, there in zip(separable.roots, zero.roots, strict=True)
                ),
                *(
                    here - _at_zero(there)
                    for here, there in zip(separable.weights, zero.weights, strict=True)
                ),
            ],
        ),
        "time_rescaling": (
            "clock and M′ at zero area constant",
            [
                separable.time_rescaling - _at_zero(zero.time_rescaling * (1 + b * D * SPIN)),
                *to_components(MOMENTUM - _at_zero(dict(zero.state)[M])),
            ],
        ),
    }
    return (
        constants,
        *(
            Identity(name, tuple(equations), meaning, known, source=SOURCE)
            for name, (meaning, equations) in claims.items()
        ),
    )


def _at_zero(formula: sp.Expr) -> sp.Expr:
    """A formula of the ball at zero area constant, for the ball with I′, D′, h′ and f′."""
    primed = dict(zip(I.symbols, Iprime.symbols, strict=True))
    primed |= {m: Dprime / R**2, h: hprime, f: fprime}
    return to_components(formula).xreplace(primed)
