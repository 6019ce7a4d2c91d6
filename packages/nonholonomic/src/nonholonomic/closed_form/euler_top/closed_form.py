"""The closed form of the free rigid body, for printing."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from flint import arb

from flowlanes.formulas.relative_zero import vanishes
from flowlanes.system.vectors import real_symbol

from ..base.solution import ClosedForm, NamedConstant
from ..one_degree import FAST, QuadratureMotion
from ..one_degree.uniform import Rotation
from .top import AXES, Top, Vector

TITLE, SOURCE = "Free rigid body", "Jacobi (1849)"

t, t_0, G, h, w, k, u_2 = (real_symbol(name) for name in ("t", "t_0", "G", "h", "w", "k", "u_2"))
u, phi, psi = (sp.Function(name)(t) for name in ("u", "varphi", "psi"))
dn = sp.Function("dn")


def steady_form(
    moments: Vector, momentum: Vector, spin: Rotation, precession: Rotation
) -> ClosedForm:
    """The closed form of rest, of a permanent rotation or of a regular precession."""
    energy = sum((x * x / (2 * I) for x, I in zip(momentum, moments, strict=True)), arb(0))
    size = sum((x * x for x in momentum), arb(0)).sqrt()
    constants = [*_integrals(energy, size)]
    if size == 0:
        return _form("at rest", (), constants)
    if spin.rate == 0:
        words = f"permanent rotation{_stability(moments, precession.axis)}"
        constants.append(NamedConstant("omega", precession.rate, "angular velocity", "rad/s"))
        return _form(words, (), constants)
    constants += [
        NamedConstant("phi'", spin.rate, "rate of intrinsic rotation", "rad/s"),
        NamedConstant("psi'", precession.rate, "rate of precession about the momentum", "rad/s"),
    ]
    return _form("regular precession about the momentum", (), constants)


def _stability(moments: Vector, axis: Vector) -> str:
    """Describe the stability of a rotation of a body with three different moments."""
    order = sorted(range(AXES), key=lambda i: moments[i].mid())
    equal = any(vanishes(moments[i - 1] - moments[i], moments[i]) for i in range(AXES))
    if equal:
        return ""
    place = next(k for k, i in enumerate(order) if axis[i] != 0)
    name = ("least", "middle", "greatest")[place]
    return f" about the axis of the {name} moment, {'unstable' if place == 1 else 'stable'}"


def form_of(top: Top, motion: QuadratureMotion) -> ClosedForm:
    """The closed form of a motion with varying M; requires sufficient working precision."""
    axis = top.axis + 1
    inertia, component = real_symbol(f"I_{axis}"), sp.Function(f"M_{axis}")(t)
    modulus, pace = top.elliptic_parameters
    energy = top.energy_ratio * top.G**2 / 2
    phase = w * (t - t_0)
    wave = sp.sech(phase) if top.separatrix else dn(phase, k)
    precession = (2 * h - G**2 * u**2 / inertia) / (G * (1 - u**2))
    equations = (
        (component, G * u),
        (u, u_2 * wave),
        (psi.diff(t), precession),
        (phi.diff(t), G * u / inertia - u * psi.diff(t)),
    )
    low, high = (x.sqrt() for x in top.squares)
    if top.direction[2] < 0:
        low, high = -high, -low
    constants = [*_integrals(energy, top.G)]
    oval = (float(low), float(high))
    edge = NamedConstant("u_2", low if top.direction[2] < 0 else high, "cos θ nearest to the axis")
    if top.separatrix:
        constants += [edge, NamedConstant("w", pace, "rate of approach", "1/s")]
        words = "separatrix: from one rotation about the axis of the middle moment to the opposite"
        return _form(words, equations, constants, (oval,))
    half, _, turn = motion.advances(FAST)
    constants += [
        NamedConstant("k^2", modulus, "square of the modulus"),
        NamedConstant("w", pace, "argument of dn by time", "rad/s"),
        edge,
        NamedConstant("T", 2 * half, "period in the body", "s"),
        NamedConstant("<psi'>", turn / half, "mean rate of precession about M", "rad/s"),
    ]
    name = "least" if top.slopes[0] < 0 else "greatest"
    words = f"the momentum circles the axis of the {name} moment, with two frequencies"
    return _form(words, equations, constants, (oval,))


def _integrals(energy: arb, size: arb) -> list[NamedConstant]:
    return [
        NamedConstant("h", energy, "energy", "J"),
        NamedConstant("G", size, "length of the momentum", "kg m^2/s"),
    ]


def _form(
    motion: str,
    equations: Sequence[tuple[sp.Expr, sp.Expr]],
    constants: Sequence[NamedConstant],
    ovals: Sequence[tuple[float, float]] = (),
) -> ClosedForm:
    return ClosedForm(TITLE, motion, tuple(equations), tuple(constants), tuple(ovals), SOURCE)
