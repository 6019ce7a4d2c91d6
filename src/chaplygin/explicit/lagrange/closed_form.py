"""What the closed form of the Lagrange top looks like."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ...catalogue.fixed_point.lagrange_top import I_1, I_3, P
from ...core.vectors import real_symbol
from ..base.solution import ClosedForm, NamedConstant
from ..one_degree import Equilibrium, QuadratureMotion
from ..one_degree.uniformisation import Asymptotic, Uniformisation
from .top import Top

__all__ = ["form_of"]

#: Digits behind the figures.
DIGITS = 19

t, h, s, c = (real_symbol(name) for name in "thsc")
w, k, u_1, u_2 = (real_symbol(name) for name in ("w", "k", "u_1", "u_2"))
u, phi = (sp.Function(name)(t) for name in ("u", "varphi"))
sn = sp.Function("sn")


def form_of(
    top: Top, chart: Uniformisation | Equilibrium, course: QuadratureMotion | None
) -> ClosedForm:
    """The form of a motion; the working precision must suffice."""
    figures = [
        NamedConstant("h", top.h, "energy", "J"),
        NamedConstant("s", top.s, "momentum about the axis", "kg m^2/s"),
        NamedConstant("c", top.c, "area integral", "kg m^2/s"),
    ]
    equations: list[tuple[Any, Any]] = [
        (
            I_1 * u.diff(t) ** 2,
            (2 * (h - P * u) - s**2 / I_3) * (1 - u**2) - (c - s * u) ** 2 / I_1,
        ),
        (phi.diff(t), (1 / I_3 - 1 / I_1) * s + (s - c * u) / (I_1 * (1 - u**2))),
    ]
    if isinstance(chart, Equilibrium):
        place = float(chart.place)
        figures.append(
            NamedConstant("w^2", chart.rigidity, "square of the frequency of nutation", "rad^2/s^2")
        )
        return _form(_steady(chart), equations, figures, (place, place))
    low, high = sorted(float(end.place) for end in (chart.first, chart.second))
    if course is None or not course.periodic:
        assert isinstance(chart, Asymptotic)
        words = "asymptotic to a permanent rotation, in the past and in the future (separatrix)"
        return _form(words, equations, figures, (low, high))
    elliptic = top.elliptic(chart)
    if elliptic is not None:
        equations.append((u, u_1 + (u_2 - u_1) * sn(w * (t - real_symbol("t_0")), k) ** 2))
        figures += [
            NamedConstant("k^2", elliptic.modulus, "square of the modulus"),
            NamedConstant("w", elliptic.frequency, "argument of sn by time", "rad/s"),
        ]
    period, own = course.advances(DIGITS)
    figures += [
        NamedConstant("u_1", min(chart.first.place, chart.second.place, key=float), "least cos θ"),
        NamedConstant(
            "u_2", max(chart.first.place, chart.second.place, key=float), "greatest cos θ"
        ),
        NamedConstant("T", period, "period of the nutation", "s"),
        NamedConstant("<phi'>", own / period, "mean rate of intrinsic rotation", "rad/s"),
    ]
    words = "periodic in shape: the axis nods while it precesses, with two frequencies"
    return _form(words, equations, figures, (low, high))


def _steady(chart: Equilibrium) -> str:
    if chart.stable is None:
        return "permanent rotation, on the border of stability"
    return f"permanent rotation, {'stable' if chart.stable else 'unstable'}"


def _form(
    motion: str, equations: list[Any], figures: list[NamedConstant], oval: tuple[float, float]
) -> ClosedForm:
    return ClosedForm("Lagrange top", motion, tuple(equations), tuple(figures), (oval,), "§4.1")
