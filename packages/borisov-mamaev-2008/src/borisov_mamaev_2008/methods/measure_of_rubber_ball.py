"""Unbalanced rubber balls with a measure whose density depends on γ only.

In the momenta across γ a density e^σ(γ) gives an invariant measure if and only if

    dσ = −(q, dγ),      q = Ĩ⁻¹γ/(γ, Ĩ⁻¹γ)

(:mod:`nonholonomic.invariant_measures.one_form`).  With J = I + m(R² + c²)E − m c⊗c, in its
principal axes, κ = 2mRc, s = (κ, γ) and n_i = J_i − s, Ĩq is along γ and (γ, q) = 1 for

    q = ν N⁻¹γ − ½ N⁻¹κ,      ν (γ, N⁻¹γ) = 1 + ½ (γ, N⁻¹κ),      N = diag(n_1, n_2, n_3).

The component of the curl of q along γ must vanish on the sphere. At γ = e₃ it is κ₁κ₂(J₂ − J₁)(n₁
+ n₂)/(2n₁²n₂²), where n₁ and n₂ are moments about axes through the contact point and hence
positive; the same holds for the other indices. Therefore, if no component of κ vanishes, J is a
multiple of E; if one does, the other two belong to equal moments, and the axes can be chosen such
that only one component remains. If κ is along e₃, J₁ = J₂ follows from the curl at γ = (cos φ, sin
φ, 0). Hence either κ = 0, or the line of κ is an axis of symmetry of J, and thus of I. For these
bodies dσ is closed.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.vectors import Diagonal, Vector, real_symbol
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.invariant_measures.one_form import one_form
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball

from .derived_verdicts import computed_verdict

J, kappa, gamma = Diagonal("J").symbols, Vector("kappa").symbols, Vector("gamma").symbols
cosine, sine = real_symbol("C"), real_symbol("S")

Point = tuple[sp.Expr, sp.Expr, sp.Expr]


def curl(place: Point, offset: Point = kappa, moments: Point = J) -> sp.Expr:
    """(γ, rot q) at a unit vector, factored, in terms of J and κ.

    Parameters
    ----------
    place : 3 formulas
        γ.
    offset, moments : 3 formulas
        κ and J.
    """
    s = sp.Add(*(k * g for k, g in zip(offset, gamma, strict=True)))
    n = [j - s for j in moments]
    square = sp.Add(*(g**2 / x for g, x in zip(gamma, n, strict=True)))
    mixed = sp.Add(*(g * k / x for g, k, x in zip(gamma, offset, n, strict=True)))
    nu = (1 + mixed / 2) / square
    q = [(nu * g - k / 2) / x for g, k, x in zip(gamma, offset, n, strict=True)]
    total = sp.Add(
        *(
            gamma[i] * (sp.diff(q[k], gamma[j]) - sp.diff(q[j], gamma[k]))
            for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
        )
    )
    return sp.factor(sp.together(total.xreplace(dict(zip(gamma, place, strict=True)))))


def necessary() -> bool:
    """True if the two values of the curl stated above are correct."""
    n = [j - kappa[2] for j in J]
    at_pole = kappa[0] * kappa[1] * (J[1] - J[0]) * (n[0] + n[1]) / (2 * (n[0] * n[1]) ** 2)
    along = (sp.S.Zero, sp.S.Zero, kappa[2])
    below = 2 * J[2] * (J[0] * sine**2 + J[1] * cosine**2) ** 2
    moment = J[0] * sine**2 + J[1] * cosine**2 + 2 * J[2] * (cosine**2 + sine**2)
    at_equator = cosine * sine * kappa[2] * (J[1] - J[0]) * moment / below
    pole = curl((sp.S.Zero, sp.S.Zero, sp.S.One)) - at_pole
    equator = curl((cosine, sine, sp.S.Zero), along) - at_equator
    return bool(sp.cancel(pole) == 0 and sp.cancel(equator) == 0)


def sufficient() -> Verdict:
    """The verdict that dσ is closed if the centre of mass is on an axis of symmetry."""
    ball = Ball(1.0, centre=(0.1, 0.2, 0.3))
    form = one_form(RollingBody(Body(1.0, (1.0, 1.5, 2.1), ball), contact="rubber"))
    I, c = Diagonal("I").symbols, Vector("c").symbols
    return prove(form.system, replace(form.closed, level=(c[0], c[1], I[0] - I[1])))


def only_symmetric_balls() -> Verdict:
    """A measure exists if and only if c = 0 or c is along an axis of dynamical symmetry."""
    shown = necessary() and bool(sufficient())
    return computed_verdict(
        "measure",
        shown,
        "the curl of q at the principal axes and across them vanishes for these balls alone, "
        "and everywhere for these",
        "the curl does not have the expected value",
    )
