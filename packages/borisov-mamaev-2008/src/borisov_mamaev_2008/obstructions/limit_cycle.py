"""Limit cycles of an unbalanced rubber ball, with rigorous bounds.

On the torus of :func:`~nonholonomic.catalogue.bodies.unbalanced_rubber_ball_centred.torus` the
motion satisfies dα/dβ = f(α, β) > 0, and one turn of β gives a map of the circle of α. If its
displacement from two full turns is negative at one α and positive at another, the map has a fixed
point and is not the identity. A circle map that preserves a continuous positive density and has a
fixed point is the identity. On this torus, and hence near it in the phase space, there is no
invariant measure with such a density.

The displacements are enclosed by polygons: if f ≤ F on a box that contains the line of slope F
from a corner, that line lies above the solution, and likewise below.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from flint import arb, ctx

from lawproof.proof.verdict import Verdict

from ..methods.derived_verdicts import computed_verdict

Case = tuple[tuple[str, ...], tuple[str, ...], str]

#: J, κ and λ: a ball with m = 1 kg, R = 0.5 m, c = κ/(2mR) and I = J − mR² − m(c² − c⊗c).
CASE: Case = (("0.5", "2.75", "2.8"), ("0.05", "-0.1", "0.15"), "0.95")
#: Angles α at which the displacement is negative and positive.
BELOW, ABOVE = Fraction(13, 5), Fraction(11, 2)
STEPS = 1500
#: Precision of the polygons, in bits.
BITS = 64
#: Bound of f, verified on the boxes.
STEEPEST = 8


def _slope(alpha: arb, beta: arb, case: Case) -> arb:
    """dα/dβ of the torus, on a box of angles."""
    J_1, J_2, J_3 = (arb(x) for x in case[0])
    level = arb(case[2])
    sin_a, cos_a, sin_b = alpha.sin(), alpha.cos(), beta.sin()
    xi = J_1 + (level - J_1) * sin_b**2
    eta = J_2 + (J_3 - J_2) * sin_a**2
    gamma = (
        sin_b * ((level - J_1) * (eta - J_1) / ((J_2 - J_1) * (J_3 - J_1))).sqrt(),
        sin_a * ((J_2 - xi) / (J_2 - J_1)).sqrt(),
        cos_a * ((J_3 - xi) / (J_3 - J_1)).sqrt(),
    )
    s = sum((arb(x) * g for x, g in zip(case[1], gamma, strict=True)), arb(0))
    above = (eta - J_1) * (eta - level) * (eta - s)
    return (above / ((J_2 - xi) * (J_3 - xi) * (xi - s))).sqrt()


def displacement(start: Fraction, upwards: bool, case: Case = CASE, steps: int = STEPS) -> arb:
    """A bound of α after one turn of β from zero, minus the start and two full turns.

    Parameters
    ----------
    start : Fraction
        α at β = 0.
    upwards : bool
        Whether the bound is an upper one.
    case : tuple
        J, κ and λ as decimal strings.
    steps : int
        Number of sides of the polygon.

    Returns
    -------
    arb
        A ball that contains the bound.

    Raises
    ------
    ArithmeticError
        If a slope exceeds the bound assumed for the boxes.
    """
    with ctx.workprec(BITS):
        step = 2 * arb.pi() / steps
        alpha = arb(start.numerator) / start.denominator
        for i in range(steps):
            # The solution stays in the box [α, α + STEEPEST·step] during the step, since f <
            # STEEPEST there.
            beta = (step * i).union(step * (i + 1))
            slope = _slope(alpha.union(alpha + STEEPEST * step), beta, case)
            if not slope < STEEPEST:
                raise ArithmeticError("the slope on the torus exceeds its assumed bound")
            side = slope.upper() if upwards else slope.lower()
            alpha = alpha + step * side
        return alpha - arb(start.numerator) / start.denominator - 4 * arb.pi()


def limit_cycle(proofs: Sequence[Verdict] = ()) -> Verdict:
    """The verdict that the circle map has a fixed point and is not the identity.

    Parameters
    ----------
    proofs : sequence of Verdict
        The verdicts on the reduction to the torus, which must all be proven.
    """
    below = displacement(BELOW, upwards=True)
    above = displacement(ABOVE, upwards=False)
    shown = all(proofs) and below < 0 and above > 0
    numbers = f"{float(below):.3f} < 0 at α = {BELOW} and {float(above):.3f} > 0 at α = {ABOVE}"
    return computed_verdict(
        "limit cycle",
        shown,
        f"on the torus F/2H = {CASE[2]} one turn moves α from 4π by {numbers}",
        "the bounds do not decide, or the reduction to the torus is not proven",
    )
