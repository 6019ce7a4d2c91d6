"""The closed form of a rubber body of revolution, for printing: formulas and numbers of §5."""

from __future__ import annotations

import sympy as sp
from flint import arb

from flowlanes.system.vectors import real_symbol

from ..base.solution import ClosedForm, NamedConstant
from ..one_degree import FAST, Equilibrium, QuadratureMotion
from ..one_degree.uniformisation import Asymptotic, Heteroclinic, Uniformisation
from .body import Level, u

TITLE = "Rubber body of revolution on a plane"
SOURCE = "(5.1), (5.2), Theorem 4"

t, h, K = (real_symbol(name) for name in ("t", "h", "K"))
theta, phi, psi = (sp.Function(name)(t) for name in ("theta", "varphi", "psi"))


def _equations(level: Level) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """Equations (5.2) for the given profile."""
    body, tilted = level.body, {u: sp.cos(theta)}
    rates = [angle.diff(t) for angle in (theta, phi, psi)]
    principal, square = body.principal.subs(tilted), body.square.subs(tilted)
    nutation = principal * rates[0] ** 2 / 2
    weight = body.energy.subs(tilted)
    return (
        (nutation, h - weight - K**2 / (2 * sp.sin(theta) ** 2)),
        (rates[1], K / (sp.sqrt(square) * sp.sin(theta) ** 2)),
        (rates[2], -sp.cos(theta) * rates[1]),
    )


def _constants(level: Level) -> tuple[NamedConstant, ...]:
    return (
        NamedConstant("h", level.h, "energy", "J"),
        NamedConstant("K", level.K, "integral linear in the angular velocity", "kg^0.5 m/s"),
    )


def kind_of(chart: Uniformisation) -> str:
    """A description of the kind of motion if θ varies."""
    if isinstance(chart, Heteroclinic):
        return "asymptotic to one permanent rotation in the past and to another in the future"
    if isinstance(chart, Asymptotic):
        return "asymptotic to a permanent rotation, in the past and in the future (separatrix)"
    passed = [end.edge for end in (chart.first, chart.second)]
    if all(passed):
        return "periodic in shape: the body turns over and over in a vertical plane"
    if any(passed):
        return "periodic in shape: the axis swings through the vertical, in a vertical plane"
    return "periodic in shape: the axis nods while it precesses, with two frequencies"


def form_of(level: Level, motion: QuadratureMotion) -> ClosedForm:
    """The closed form of a motion with varying θ; requires sufficient working precision."""
    chart = motion.chart
    ends = sorted((chart.first, chart.second), key=lambda end: float(end.x))
    constants = [
        *_constants(level),
        NamedConstant("theta_min", ends[1].x.acos(), "least inclination of the axis", "rad"),
        NamedConstant("theta_max", ends[0].x.acos(), "greatest inclination of the axis", "rad"),
    ]
    if motion.periodic:
        period, own, precession, *_ = motion.advances(FAST)
        constants += [
            NamedConstant("T", period, "period of the nutation", "s"),
            NamedConstant("Omega", 2 * arb.pi() / period, "frequency of the nutation", "rad/s"),
            NamedConstant("<phi'>", own / period, "mean rate of intrinsic rotation", "rad/s"),
            NamedConstant("<psi'>", precession / period, "mean rate of precession", "rad/s"),
            NamedConstant("rho", own / (2 * arb.pi()), "rotation number, turns by nutation"),
        ]
    low, high = (float(end.x) for end in ends)
    return ClosedForm(
        TITLE, kind_of(chart), _equations(level), tuple(constants), ((low, high),), SOURCE
    )


def steady_form(level: Level, equilibrium: Equilibrium, rates: tuple[arb, arb]) -> ClosedForm:
    """The closed form of a permanent rotation with given φ̇ and ψ̇."""
    constants = (
        *_constants(level),
        NamedConstant("theta", equilibrium.x.acos(), "inclination of the axis", "rad"),
        NamedConstant("phi'", rates[0], "rate of intrinsic rotation", "rad/s"),
        NamedConstant("psi'", rates[1], "rate of precession", "rad/s"),
        NamedConstant(
            "w^2", equilibrium.rigidity, "square of the frequency of small nutations", "rad^2/s^2"
        ),
    )
    u = float(equilibrium.x)
    motion = equilibrium.description("permanent rotation" if level.K != 0 else "equilibrium")
    return ClosedForm(TITLE, motion, _equations(level), constants, ((u, u),), SOURCE)
