"""The closed form of the Lagrange top, for printing."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from flowlanes.system.vectors import real_symbol

from ...catalogue.fixed_point.lagrange_top import I_1, I_3, P
from ..base.solution import ClosedForm, NamedConstant
from ..one_degree import FAST, Equilibrium, QuadratureMotion
from ..one_degree.uniformisation import Uniformisation
from .top import Top

t, h, s, c = (real_symbol(name) for name in "thsc")
w, k, u_1, u_2 = (real_symbol(name) for name in ("w", "k", "u_1", "u_2"))
u, phi = (sp.Function(name)(t) for name in ("u", "varphi"))
sn = sp.Function("sn")


#: Equations of u and φ.
EQUATIONS = (
    (
        I_1 * u.diff(t) ** 2,
        (2 * (h - P * u) - s**2 / I_3) * (1 - u**2) - (c - s * u) ** 2 / I_1,
    ),
    (phi.diff(t), (1 / I_3 - 1 / I_1) * s + (s - c * u) / (I_1 * (1 - u**2))),
)


def _constants(top: Top) -> list[NamedConstant]:
    return [
        NamedConstant("h", top.h, "energy", "J"),
        NamedConstant("s", top.s, "momentum about the axis", "kg m^2/s"),
        NamedConstant("c", top.c, "area integral", "kg m^2/s"),
    ]


def steady_form(top: Top, equilibrium: Equilibrium) -> ClosedForm:
    """The closed form of a permanent rotation."""
    nutation = "square of the frequency of nutation"
    constants = [
        *_constants(top),
        NamedConstant("w^2", equilibrium.rigidity, nutation, "rad^2/s^2"),
    ]
    return _form(
        equilibrium.description("permanent rotation"),
        EQUATIONS,
        constants,
        (float(equilibrium.x),) * 2,
    )


def form_of(top: Top, chart: Uniformisation, motion: QuadratureMotion) -> ClosedForm:
    """The closed form of a motion with varying u; requires sufficient working precision."""
    constants = _constants(top)
    low, high = sorted((chart.first.x, chart.second.x), key=float)
    oval = (float(low), float(high))
    if not motion.periodic:
        words = "asymptotic to a permanent rotation, in the past and in the future (separatrix)"
        return _form(words, EQUATIONS, constants, oval)
    equations: tuple[tuple[sp.Expr, sp.Expr], ...] = EQUATIONS
    elliptic = top.elliptic_parameters(chart)
    if elliptic is not None:
        equations += ((u, u_1 + (u_2 - u_1) * sn(w * (t - real_symbol("t_0")), k) ** 2),)
        constants += [
            NamedConstant("k^2", elliptic[0], "square of the modulus"),
            NamedConstant("w", elliptic[1], "argument of sn by time", "rad/s"),
        ]
    period, own = motion.advances(FAST)
    constants += [
        NamedConstant("u_1", low, "least cos θ"),
        NamedConstant("u_2", high, "greatest cos θ"),
        NamedConstant("T", period, "period of the nutation", "s"),
        NamedConstant("<phi'>", own / period, "mean rate of intrinsic rotation", "rad/s"),
    ]
    words = "periodic in shape: the axis nods while it precesses, with two frequencies"
    return _form(words, equations, constants, oval)


def _form(
    motion: str,
    equations: Sequence[tuple[sp.Expr, sp.Expr]],
    constants: Sequence[NamedConstant],
    oval: tuple[float, float],
) -> ClosedForm:
    return ClosedForm("Lagrange top", motion, tuple(equations), tuple(constants), (oval,), "§4.1")
