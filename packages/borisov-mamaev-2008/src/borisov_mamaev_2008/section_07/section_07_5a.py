"""§7.5, 1: the first isomorphism of the Chaplygin ball with the Clebsch case."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, dot, identity, norm_squared, to_components, vectors
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball import DENSITY
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_clebsch import onto_clebsch
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import (
    DET_J,
    A,
    D,
    I,
    L,
    gamma,
    hamiltonian_form,
    u,
)

from ..claim import Case, Claim
from ..methods.catalogue_laws import printed_form

M, omega = vectors("M omega")
B = Diagonal("B")
AREA = (dot(M, gamma),)


@cache
def ball() -> System:
    """The ball without a field, with L = ρM and B = IJ⁻¹."""
    system = CATALOGUE["chaplygin-ball"].system()
    definitions = (*system.definitions, (L, DENSITY * M), (B, I * A))
    return replace(system, definitions=definitions, laws=())


def bracket() -> Case:
    """(7.6) restricted to (L, γ) = 0 is the bracket of e(3)."""
    return hamiltonian_form(sp.S.Zero), Identity("bracket", u - L, level=(dot(L, gamma),))


def _spread(vector: MatrixExpr) -> sp.Expr:
    return dot(vector, B * vector)


def energy() -> Case:
    """The Hamiltonian at (M, γ) = 0, up to the factor det J/D."""
    value = (
        norm_squared(L) * _spread(gamma) / 2
        - (_spread(L) * _spread(gamma) - dot(gamma, B * L) ** 2) / 2
    )
    residual = dot(M, omega) / 2 - DET_J / D * value
    return ball(), Identity("energy", residual, level=AREA)


def integral() -> Case:
    """(7.4) in terms of L and γ, up to the factor det J."""
    return ball(), Identity(
        "integral", norm_squared(M) - DET_J * norm_squared(L) * _spread(gamma), level=AREA
    )


def tensor() -> Case:
    """B = E − DJ⁻¹ = IJ⁻¹."""
    return ball(), Identity("tensor", to_components(B - (identity - D * A)))


def theorem_printed() -> Case:
    """s with B^(−1/2)."""
    return CATALOGUE["chaplygin-ball"].system(), printed_form(onto_clebsch())


def theorem() -> Case:
    """s with B^(1/2)."""
    return CATALOGUE["chaplygin-ball"].system(), onto_clebsch()


CLAIMS = (
    Claim(
        "§7.5, first sentence",
        r"At $(M, \gamma) = (L, \gamma) = 0$ the bracket (7.6) is that of e(3).",
        bracket,
    ),
    Claim(
        "§7.5, H",
        r"$H = \frac{1}{2} L^2 (\gamma, B\gamma) - \frac{1}{2} [(L, BL)(\gamma, B\gamma) - "
        r"(\gamma, BL)^2]$, omitting inessential factors, where $U = 0$, $(M, \gamma) = 0$",
        energy,
        note="the factor omitted is det J / D",
    ),
    Claim(
        "§7.5, F",
        r"$F = L^2 (\gamma, B\gamma)$, omitting inessential factors",
        integral,
        note="the factor omitted is det J",
    ),
    Claim("§7.5, B", r"$B = E - DJ^{-1} = IJ^{-1}$", tensor),
    Claim(
        "Theorem 10",
        r"After the change of time (7.5) and $s = (\gamma, B\gamma)^{-1/2} B^{-1/2} \gamma$, "
        r"$\tilde{L} = B^{-1/2} L$, the field (7.1) for $U = 0$ on a fixed level of $(M, M)$ and "
        r"$(M, \gamma) = 0$ reduces to the Clebsch case with zero constant of areas.",
        theorem_printed,
        theorem,
        r"After the change of time (7.5), up to the constant factor $\frac{\det J}{D} "
        r"\sqrt{\det B}$, and $s = (\gamma, B\gamma)^{-1/2} B^{1/2} \gamma$, "
        r"$\tilde{L} = B^{-1/2} L$, the field (7.1) for $U = 0$ on a fixed level of $(M, M)$ and "
        r"$(M, \gamma) = 0$ reduces to the Clebsch case with zero constant of areas.",
        r"exponent of B in s: only with $B^{1/2}$ is $s^2 = 1$; the Clebsch case is (6.14) with "
        r"$I = B$, $\alpha = 1$, $\beta = -1$, $c = L^2 (\gamma, B\gamma) / \det B$",
    ),
)
