"""§11.1: the model of Contensou and Erismann."""

from __future__ import annotations

import sympy as sp

from lawproof.proof.verdict import Verdict
from nonholonomic.contact.invariants.friction_shares import (
    HERTZ,
    couple_beyond,
    force_beyond,
    force_within,
    pure_spin,
    slope,
)

from ..claim import Claim, Remark
from ..methods.derived_verdicts import computed_verdict


def force_and_couple() -> Verdict:
    """𝓕 > 0 for every slip and 𝓜 > 0 for every spin, under Hertzian pressure.

    For k ≤ 1 the force is 𝓕 = 𝓕′(0) k (1 − k²/4), and 𝓜 = 𝓜(0)(1 − k² + 3k⁴/8) is a quadratic in
    k² without real roots; for k > 1, 𝓕 decreases with 1/k² to a positive limit and 𝓜 has positive
    terms.
    """
    k = sp.Symbol("k", positive=True)
    within = force_within(HERTZ)
    force = slope(HERTZ) * k * (1 + within.a * within.b / within.c * k**2)
    couple = sp.expand(sp.integrate(force, (k, 0, k)) + pure_spin(HERTZ) - k * force)
    quadratic = sp.Poly(sp.simplify(couple / pure_spin(HERTZ)).subs(k, sp.sqrt(k)), k)
    least = force_beyond(HERTZ).at_one()
    shown = (
        within.b == -1
        and quadratic == sp.Poly(1 - k + sp.Rational(3, 8) * k**2, k)
        and quadratic.discriminant() < 0
        and force_beyond(HERTZ).sign_after_first < 0
        and least == 9 * sp.pi / 32
        and couple_beyond(HERTZ).sign_after_first > 0
    )
    return computed_verdict(
        "force and couple",
        shown,
        "𝓕 > 0 for k > 0 and 𝓜 > 0 for k < ∞, by the signs of their series in k² and 1/k²",
        "the signs of the series do not show it",
    )


CLAIMS = (
    Claim(
        "§11.1",
        "The Contensou–Erismann model locally utilizes Coulomb friction which is then integrated "
        "over the contact area, thus yielding a non-zero net frictional force and a non-zero "
        "spinning friction torque.",
        force_and_couple,
        note="read as: the force is not zero where the contact slides, and the torque is not zero "
        "where it spins",
        where=("the pressure is that of Hertz on a disk",),
    ),
)

REMARKS = (
    Remark(
        "§11.1",
        "Friction models of Coulomb, viscous, and of Contensou and Erismann, with their history.",
        "a survey of the literature",
    ),
    Remark(
        "§11.1",
        "To model a number of dynamical phenomena it is essential to use dynamical rather than "
        "static friction.",
        "an opinion about modelling",
    ),
    Remark(
        "§11.1",
        "A bibliography on mechanical systems with friction is in the book by A. P. Markeev [86].",
        "an erratum: [86] is the book of Neimark and Fufaev, that of Markeev is [98]",
    ),
    Remark(
        "§11.1",
        "Contensou studied the motion of a top, Erismann kinematical problems of integrators.",
        "history",
    ),
)
