"""§11.3: friction and the tippe top."""

from __future__ import annotations

import sympy as sp

from lawproof.proof.verdict import Verdict
from nonholonomic.contact.invariants import top_stability as top
from nonholonomic.contact.invariants.sliding_top import I_1, I_3, R, c, g, m, tippe_top
from nonholonomic.contact.pressure.pressure_ranges import hertz_ranges

from ..claim import Claim, Remark
from ..methods.derived_verdicts import computed_verdict, conclusion_verdict

#: Leine and Glocker's top, in exact numbers.
TOP = {
    m: sp.Rational(6, 1000),
    I_1: sp.Rational(8, 10**7),
    I_3: sp.Rational(7, 10**7),
    R: sp.Rational(15, 1000),
    c: sp.Rational(3, 1000),
    g: sp.Rational(981, 100),
}
#: Two angular velocities of it (rad/s).
SLOW, FAST = sp.Integer(20), sp.Integer(180)


def derived() -> bool:
    """True if the characteristic polynomial follows from the equations, and the minors from it."""
    minors = zip(top.hermitian_minors(), top.expected_minors(), strict=True)
    equal = all(sp.expand(minor - product) == 0 for minor, product in minors)
    return equal and top.characteristic_difference(tippe_top()) == 0


def margin(spin: sp.Expr, offset: int = 1) -> sp.Rational:
    """T of the top with its centre of mass below (1) or above (−1) the centre."""
    values = TOP | {top.n: spin, c: offset * TOP[c]}
    return top.stability_margin().subs(values)


def by_slowing_down() -> Verdict:
    """A slow rotation is stable and a fast one is not: slowing down makes nothing unstable."""
    slow, fast = margin(SLOW), margin(FAST)
    shown = derived() and slow > 0 > fast
    point = {str(s): str(value) for s, value in TOP.items()}
    return computed_verdict(
        "slowing",
        shown,
        f"the rotation of Leine and Glocker's top with the centre of mass below is stable at "
        f"{SLOW} rad/s and unstable at {FAST} rad/s, for every viscosity",
        "the minors do not have the expected form",
        decision="refuted",
        witness={"point": point | {"n": str(SLOW)}, "what": "T", "residual": str(slow)},
    )


def thresholds() -> Verdict:
    """T > 0 in terms of Jellett's integral, for the centre of mass below and above."""
    J, alpha = sp.symbols("J alpha", real=True)
    ratio = {top.n: J / (I_3 * R * (1 - alpha)), c: alpha * R}
    scaled = sp.expand(sp.simplify(top.stability_margin().subs(ratio) * I_3 * (1 - alpha) ** 2))
    below = m * g * R**3 * I_3 * alpha * (1 - alpha) ** 4 - J**2 * (I_1 / I_3 - 1 + alpha)
    above = J**2 * (1 + alpha - I_1 / I_3) - m * g * R**3 * I_3 * alpha * (1 + alpha) ** 4
    shown = (
        derived()
        and sp.expand(scaled - below) == 0
        and sp.expand(scaled.subs(alpha, -alpha) - above) == 0
    )
    return computed_verdict(
        "thresholds",
        shown,
        "the Hermitian form of the characteristic polynomial has the minors 2κmI₁(I₁ + mb²), "
        "4κ²m³I₁[(I₁ + mb²)T + n²(I₁R − I₃b)²] and 8κ³m⁷I₁c²g²b²T",
        "the minors do not have the expected form",
    )


def at_a_point() -> Verdict:
    """Friction at a single point destabilises the fast rotation and stabilises the inverted one."""
    below, above = margin(FAST), margin(FAST * _inverted_share(), -1)
    shown = derived() and below < 0 < above
    return computed_verdict(
        "point contact",
        shown,
        f"with friction at a single point, of any viscosity, the rotation of Leine and Glocker's "
        f"top at {FAST} rad/s is unstable with the centre of mass below, and that with the same "
        "Jellett integral stable with the centre of mass above",
        "the minors do not have the expected form",
    )


def _inverted_share() -> sp.Rational:
    """Ratio of the inverted to the upright angular velocity with the same Jellett integral."""
    ratio: sp.Rational = (TOP[R] - TOP[c]) / (TOP[R] + TOP[c])
    return ratio


def steady_under_dry_friction() -> tuple[bool, sp.Rational]:
    """True if a rotation that is unstable under viscous friction is stable under dry friction.

    Near it the slip ends soon, since the friction is μN but the force needed for rolling is small.
    The rolling top has the oscillations η ~ e^{iwt} with

        (I₁ + mb²)w² − n(I₃ + mRb)w − mgc = 0,

    the limit of P(iw) for κ → ∞, whose two roots are real and different for c > 0. By the
    integrals of Routh's sphere it stays near the vertical, and friction continues to hold it.

    Returns
    -------
    stable : bool
    discriminant : sympy.Rational
        Discriminant of the equation for w.
    """
    b, w = R - c, sp.Symbol("w")
    rolling = (I_1 + m * b**2) * w**2 - top.n * (I_3 + m * R * b) * w - m * g * c
    limit = sp.Poly(sp.expand(top.characteristic_polynomial(sp.I * w)), top.kappa).nth(1)
    consistent = sp.expand(limit + rolling) == 0
    discriminant = sp.discriminant(rolling, w).subs(TOP | {top.n: FAST})
    return bool(derived() and consistent and discriminant > 0 > margin(FAST)), discriminant


_DRY = (
    f"under Coulomb friction the rotation of Leine and Glocker's top at {FAST} rad/s is stable for "
    "every μ > 0: near it the top soon rolls, and then stays near it"
)


def by_any_friction() -> Verdict:
    """Dry friction leaves the rotation stable."""
    stable, discriminant = steady_under_dry_friction()
    point = {str(s): str(value) for s, value in TOP.items()}
    return computed_verdict(
        "dry friction",
        stable,
        _DRY,
        "the polynomial of rolling does not have the expected form",
        decision="refuted",
        witness={
            "point": point | {"n": str(FAST)},
            "what": "discriminant of the frequencies of rolling, positive",
            "residual": str(discriminant),
        },
    )


def by_viscous_friction() -> Verdict:
    """Viscous friction destabilises the rotation, dry friction does not."""
    dry = computed_verdict("dry friction", steady_under_dry_friction()[0], _DRY, "not shown")
    viscous = at_a_point()
    return conclusion_verdict("viscous friction", viscous.finding, (viscous, dry))


def sliding_without_spin() -> Verdict:
    """𝓕 → 1 for k → ∞, with the first correction −1/(10k²)."""
    _, closed, _ = hertz_ranges()
    x = sp.Symbol("x", positive=True)
    series = sp.series(sp.simplify(closed.force.xreplace({closed.argument: 1 / x})), x, 0, 4)
    shown = series.removeO() == 1 - x**2 / 10
    return computed_verdict(
        "coulomb",
        shown,
        "for v ≫ ωa the force is μN (1 − (ωa/v)²/10 − …)",
        "the series does not have the expected form",
    )


CLAIMS = (
    Claim(
        "§11.3, after Remark 24",
        "Due to frictional forces, rotation of the tippe top about the axis of symmetry with the "
        "center of mass at the lowermost position gradually slows down and finally it becomes "
        "unstable; at the same time, rotation with the center of mass at the uppermost position "
        "gains stability.",
        by_slowing_down,
        thresholds,
        "The vertical rotation does not slip, and friction at the point of contact does not slow "
        "it down. Under viscous friction it is unstable with the center of mass at the lowermost "
        "position if $J^2 (I_1/I_3 - 1 + \\alpha) > m g R^3 I_3 \\alpha (1 - \\alpha)^4$, and "
        "stable with the center of mass at the uppermost position if "
        "$J^2 (1 + \\alpha - I_1/I_3) > m g R^3 I_3 \\alpha (1 + \\alpha)^4$, where $J$ is "
        "Jellett's integral and $\\alpha R$ the distance of the center of mass from the center: "
        "both hold for fast rotation, and are lost when it slows down.",
        note="the fast rotation is unstable and the slow one stable, not the other way round; "
        "stability by the roots of the linearised equations",
    ),
    Claim(
        "§11.3, after Remark 24, on [95]",
        "Whereas according to [95] the overturn is solely due to the finiteness of the contact "
        "area and to the distribution of pressure over it, the phenomenon is essentially "
        "independent of the type of contact (i.e. it could be a single point or an area).",
        at_a_point,
        note="read as: viscous friction at a single point suffices; the thresholds of stability do "
        "not depend on its coefficient",
    ),
    Claim(
        "§11.3, after Remark 24, [98]",
        "Any type of friction can serve as an explanation of the overturn: both Coulomb and "
        "viscous friction will cause overturn.",
        by_any_friction,
        by_viscous_friction,
        "Viscous friction causes overturn: above the threshold the rotation with the center of "
        "mass below is unstable for every coefficient. Coulomb friction at a point leaves it "
        "stable, and overturns at most a top that starts with a tilt and slides.",
        note="read as: friction makes the rotation with the center of mass below unstable. "
        "Observed, not proven: Leine and Glocker's top with $\\mu = 0.3$, started at 180 rad/s "
        "with a tilt of 0.1 rad, turns its center of mass above the center, but at $t = 1.10509$ "
        "s, with $\\gamma_3 = -0.7185$, begins to roll and does not complete the overturn",
    ),
    Claim(
        "§11.3, end of the paragraph after Remark 24, on slow rotation",
        "Simulations show that for pure sliding and small rotational velocity one can use the "
        "Coulomb friction.",
        sliding_without_spin,
        note="read as the limit $v/(\\omega a) \\to \\infty$",
        where=("the pressure is that of Hertz on a disk of radius a",),
    ),
)

REMARKS = (
    Remark(
        "§11.3",
        "Three categories of systems, and which model of friction each needs.",
        "an opinion about modelling",
    ),
    Remark(
        "§11.3, first paragraph",
        "Methods of nonholonomic mechanics are said to be unsuitable for rolling bodies, and the "
        "Contensou–Erismann theory the one to be used; the approach is excessively one-sided.",
        "opinions of others, and comments on them",
    ),
    Remark(
        "§11.3, before Remark 23",
        "Most phenomena of friction are explained, qualitatively and sometimes quantitatively, by "
        "simpler models of friction.",
        "an opinion about modelling",
    ),
    Remark(
        "Remark 23",
        "The loyalty to the Contensou–Erismann model seems incomprehensible: it is merely an "
        "approximation, which can be improved, and its analysis in [23, 88–90, 95] is reduced to "
        "the numerical determination of just one or two trajectories.",
        "judgement and literature. Of the approximation: the short formulas of [88] differ from "
        "the exact factors of the model by up to 0.34 and 0.20, the model with a patch of two "
        "curvatures is an improvement of it (nonholonomic/docs/friction.md); charts of several "
        "hundred motions are computed there",
    ),
    Remark(
        "§11.3, after Remark 23",
        "The rolling of Celtic stones essentially depends on geometry, masses and the absence of "
        "absolute sliding, while the preference for any particular friction model produces very "
        "little effect on the overall picture of motion; any nonholonomic model can be used.",
        "a judgement, and computed motions contradict it. Observed, not proven: the stone of Kane "
        "and Levinson spun at 5 rad/s on a table with dry friction, $\\mu = 0.3$, would need 0.76 "
        "of the normal force to roll; it slips 5.7 ms after the start, changes 26 times between "
        "slipping and rolling within half a second, and has lost half of its spin by then "
        "(`examples/dry_rattleback.toml`, nonholonomic/docs/friction.md). With friction enough "
        "to hold the contact it rolls as the nonholonomic model has it",
    ),
    Remark(
        "Remark 24",
        "Most problems of rigid-body dynamics are solved within Hamiltonian mechanics, without "
        "friction; so are foundations of hydrodynamics.",
        "opinion, a comparison",
    ),
    Remark(
        "§11.3, after Remark 24",
        "Friction plays a crucial role for the tippe top; modern researches contributed very "
        "little in comparison to the classical works; finer models are justified by the accuracy "
        "required.",
        "opinion and literature; the statements about stability are claims",
    ),
    Remark(
        "§11.3, end",
        "The choice of a friction model must be determined by the effect of interest, experimental "
        "data and the materials.",
        "an opinion about modelling",
    ),
)
