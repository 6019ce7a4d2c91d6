"""What the closed form of the Lagrange top looks like."""

from __future__ import annotations

from typing import Any

import sympy as sp

from ...catalogue.fixed_point.lagrange_top import I_1, I_3, P
from ...core.vectors import scalar
from ..base.solution import ClosedForm, Figure
from ..one_degree import Course, Steady
from ..one_degree.uniformisation import Asymptotic, Chart
from .top import Top

__all__ = ["form_of"]

#: Digits behind the figures.
DIGITS = 19

t, h, s, c = (scalar(name) for name in "thsc")
w, k, u_1, u_2 = (scalar(name) for name in ("w", "k", "u_1", "u_2"))
u, phi = (sp.Function(name)(t) for name in ("u", "varphi"))
sn = sp.Function("sn")


def form_of(top: Top, chart: Chart | Steady, course: Course | None) -> ClosedForm:
    """The form of a motion; the working precision must suffice."""
    figures = [
        Figure("h", top.h, "energy", "J"),
        Figure("s", top.s, "momentum about the axis", "kg m^2/s"),
        Figure("c", top.c, "area integral", "kg m^2/s"),
    ]
    equations: list[tuple[Any, Any]] = [
        (
            I_1 * u.diff(t) ** 2,
            (2 * (h - P * u) - s**2 / I_3) * (1 - u**2) - (c - s * u) ** 2 / I_1,
        ),
        (phi.diff(t), (1 / I_3 - 1 / I_1) * s + (s - c * u) / (I_1 * (1 - u**2))),
    ]
    if isinstance(chart, Steady):
        place = float(chart.place)
        figures.append(
            Figure("w^2", chart.rigidity, "square of the frequency of nutation", "rad^2/s^2")
        )
        return _form(_steady(chart), equations, figures, (place, place))
    low, high = sorted(float(end.place) for end in (chart.first, chart.second))
    if course is None or not course.periodic:
        assert isinstance(chart, Asymptotic)
        words = "asymptotic to a permanent rotation, in the past and in the future (separatrix)"
        return _form(words, equations, figures, (low, high))
    elliptic = top.elliptic(chart)
    if elliptic is not None:
        equations.append((u, u_1 + (u_2 - u_1) * sn(w * (t - scalar("t_0")), k) ** 2))
        figures += [
            Figure("k^2", elliptic.modulus, "square of the modulus"),
            Figure("w", elliptic.frequency, "argument of sn by time", "rad/s"),
        ]
    period, own = course.advances(DIGITS)
    figures += [
        Figure("u_1", min(chart.first.place, chart.second.place, key=float), "least cos θ"),
        Figure("u_2", max(chart.first.place, chart.second.place, key=float), "greatest cos θ"),
        Figure("T", period, "period of the nutation", "s"),
        Figure("<phi'>", own / period, "mean rate of intrinsic rotation", "rad/s"),
    ]
    words = "periodic in shape: the axis nods while it precesses, with two frequencies"
    return _form(words, equations, figures, (low, high))


def _steady(chart: Steady) -> str:
    if chart.stable is None:
        return "permanent rotation, on the border of stability"
    return f"permanent rotation, {'stable' if chart.stable else 'unstable'}"


def _form(
    motion: str, equations: list[Any], figures: list[Figure], oval: tuple[float, float]
) -> ClosedForm:
    return ClosedForm("Lagrange top", motion, tuple(equations), tuple(figures), (oval,), "§4.1")
