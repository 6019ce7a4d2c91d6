"""The quadratures of the ball around a sphere and of the ball on a plane (§8.2).

With w = 1/u the separated equations of
:mod:`nonholonomic.catalogue.ball_on_sphere.ball_around_sphere_coordinates` are ẇ₁²/R(w₁) =
ẇ₂²/R(w₂) with the polynomial of degree six

    R(w) = (1 − A₁w)(1 − A₂w)(1 − A₃w)(e₂ − e₃w) q(w),
    q(w) = w² (h (τ − 1/w) L(1/w) − f Q(1/w)),

h = (M, ω), f = M²: p(u), L(u) and Q(u) of that module become its factors.  The trajectories are
Σ dw/√R(w) = 0, and those of the Chaplygin ball with (M, γ) = 0 are Σ dz/y = 0 with the six roots
I₁, I₂, I₃, 0, −D, f/h − D (:mod:`nonholonomic.closed_form.separations.chaplygin_ball`).

An equation of this kind keeps its form only under affine maps. Suppose that such a map, which may
depend on the level, takes the roots of R to those of a Chaplygin ball, for all levels in some
range. Five of the latter do not depend on the level f/h. Among any five roots of R at least three
belong to the four that do not depend on it either; these determine the map, which therefore does
not depend on the level. But one of the five is a root of q, and both roots of q depend on the
level: a contradiction.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Law
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.ball_on_sphere import (
    ball_around_sphere_coordinates as chart,
    ball_on_sphere_equations as ball,
)
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.fedorov import fedorov

from .derived_verdicts import computed_verdict, conclusion_verdict

h, f, w = real_symbol("h"), real_symbol("f"), real_symbol("w")


def level_factor() -> sp.Expr:
    """The factor q(w) of the polynomial R(w)."""
    u = 1 / w
    form = h * (chart.tau - u) * chart.scale(u) - f * chart.ratio_form(u)
    value: sp.Expr = sp.expand(w**2 * form)
    return value


def moving_root_counts() -> tuple[int, int]:
    """The numbers of roots that depend on f/h, around a sphere and on a plane.

    A root of q that does not depend on f/h would be a zero of its coefficient of h, that is, w =
    1/τ or e₂/e₃. There the coefficient of f is −I₁I₂I₃/τ² and d, which are non-zero.
    """
    tensor = chart.A.symbols
    e_3 = sp.Mul(*tensor)
    e_2 = sp.Add(*(e_3 / a for a in tensor))
    with_h, with_f = (level_factor().coeff(s) for s in (h, f))
    central = sp.Mul(*(chart.tau - a for a in tensor))
    # d = tr A − τ
    lever = sp.Add(*tensor) - chart.tau
    places = {1 / chart.tau: -central / chart.tau**2, e_2 / e_3: lever}
    vanishing = [sp.cancel(with_h.subs(w, place)) == 0 for place in places]
    known = [
        sp.cancel(with_f.subs(w, place).subs(chart.d, lever) - value) == 0
        for place, value in places.items()
    ]
    around = 2 if all(vanishing) and all(known) and sp.degree(with_h, w) == 2 else 0
    level = {real_symbol("f"), real_symbol("h")}
    own = sum(bool(sp.sympify(root).free_symbols & level) for root in chaplygin_ball().roots)
    return around, own


def _separations() -> tuple[tuple[System, Law], ...]:
    around = chart.coordinates_around_sphere()
    return (
        *(
            (separable.system, law)
            for separable in (chaplygin_ball(), fedorov())
            for law in separable.laws
        ),
        *((around, law) for law in around.laws),
        (ball.vanishing_area(), chart.of_ball()),
    )


def both_hyperelliptic() -> Verdict:
    """Both problems are separated on curves of genus two."""
    return conclusion_verdict(
        "alike",
        "both are separated, with polynomials of degree six",
        _separations(),
    )


def quadratures_differ() -> Verdict:
    """No Chaplygin ball has the quadratures of a ball around a sphere on all levels."""
    around, own = moving_root_counts()
    rests_on = both_hyperelliptic()
    shown = bool(rests_on) and (around, own) == (2, 1)
    return computed_verdict(
        "quadratures",
        shown,
        f"{around} of the six roots depend on the level, {own} of those of Chaplygin's ball",
        rests_on.reason or "the roots do not depend on the level as expected",
        terms=rests_on.terms,
        seconds=rests_on.seconds,
    )
