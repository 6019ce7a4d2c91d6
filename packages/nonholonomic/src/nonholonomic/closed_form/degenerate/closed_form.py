"""The closed form of a degenerate motion, for printing."""

from __future__ import annotations

import sympy as sp
from flint import arb

from flowlanes.formulas.balls import components, number
from flowlanes.formulas.relative_zero import vanishes

from ..base.solution import ClosedForm, NamedConstant
from ..genus_two.separation import SeparatedSystem
from .exact_start import ExactStart
from .theta_motion import Asymptotic, Periodic


def form_of(
    separable: SeparatedSystem,
    start: ExactStart,
    motion: Periodic | Asymptotic,
    e: arb,
    turn: arb,
) -> ClosedForm:
    """The curve without its double root, the equations on it, frequencies.

    Parameters
    ----------
    separable : SeparatedSystem
    start : ExactStart
    motion : Periodic or Asymptotic
    e : arb
        The double root.
    turn : arb
        The gain of the clock in a period.
    """
    w, z, y, e_ = sp.symbols("w z y e")
    z_1, z_2, w_1, w_2 = sp.symbols("z_1 z_2 w_1 w_2")
    d = [sp.Symbol(f"d{name}") for name in ("z", "z_1", "z_2", "tau", "t")]
    a, b = (sp.sympify(speed) for speed in separable.speeds)
    curve = (y**2, sp.Mul(separable.leading, *(z - root for root in separable.roots)))
    asymptotic = isinstance(motion, Asymptotic)
    if asymptotic:
        equations: tuple[tuple[sp.Expr, sp.Expr], ...] = (
            (d[1] / w_1 + d[2] / w_2, (b - a * e_) * d[3]),
            (d[1] / ((z_1 - e_) * w_1) + d[2] / ((z_2 - e_) * w_2), a * d[3]),
        )
    else:
        equations = ((d[0] / w, (b - a * e_) * d[3]),)
    constants = [
        *(NamedConstant(str(s), start.values[s], "constant") for s, _ in separable.constants),
        NamedConstant("e", e, "root of the curve, double"),
        *(
            NamedConstant(f"r_{i}", r, "root of the curve")
            for i, r in enumerate(_others(start, e), 1)
        ),
        NamedConstant("y", motion.thetas.y, "period ratio iy of the elliptic curve"),
        NamedConstant("P", motion.period, "period in τ"),
        NamedConstant("T", turn, "period in t", "s"),
        NamedConstant("Omega", 2 * arb.pi() / turn, "frequency", "rad/s"),
    ]
    kind = "periodic in the body: one variable stays at a double root of the curve"
    if isinstance(motion, Asymptotic):
        kind = "separatrix: asymptotic to a periodic motion in both directions of time"
        constants.append(NamedConstant("lambda", abs(motion.growth), "rate of approach in τ"))
        constants.append(
            NamedConstant(
                "Lambda", abs(motion.growth) * motion.period / turn, "mean rate of approach", "1/s"
            )
        )
    return ClosedForm(
        title=separable.title,
        motion=kind,
        equations=(
            curve,
            (w, y / (z - e_)),
            *equations,
            (d[4] / d[3], components(separable.time_rescaling)[0]),
        ),
        constants=tuple(constants),
        ovals=tuple((number(x), number(y)) for x, y in _ovals(start, motion, e)),
        source=separable.source,
    )


def _ovals(start: ExactStart, motion: Periodic | Asymptotic, e: arb) -> tuple[tuple[arb, arb], ...]:
    """The intervals of z₁ and z₂."""
    z = start.total[0] - e
    others = _others(start, e)
    if isinstance(motion, Asymptotic):
        low = max((r for r in others if r < e), key=lambda r: r.mid())
        high = min((r for r in others if r > e), key=lambda r: r.mid())
        return (low, e), (e, high)
    low = max((r for r in others if r.mid() <= z.mid()), key=lambda r: r.mid(), default=z)
    high = min((r for r in others if r.mid() > z.mid()), key=lambda r: r.mid(), default=z)
    moving = (low, high)
    return ((e, e), moving) if e < z else (moving, (e, e))


def _others(start: ExactStart, e: arb) -> list[arb]:
    """The roots that have not collided, in increasing order."""
    apart = (r for r in start.roots if not vanishes((r - e).mid(), start.size))
    return sorted(apart, key=lambda r: r.mid())
