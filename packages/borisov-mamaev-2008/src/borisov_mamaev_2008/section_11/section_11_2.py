"""§11.2: constraints as limits of friction, and as the final stage of sliding."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Law, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, real_symbol, vectors, zero
from lawproof.proof.verdict import Verdict
from nonholonomic.contact.invariants import sliding_ball as ball
from nonholonomic.contact.invariants.friction_shares import HERTZ, UNIFORM, bounds, least_friction

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import computed_verdict, conclusion_verdict

x, r = vectors("x r")
inverse_inertia = Diagonal("Y")
m, spin_arm, spin_sign = real_symbol("m"), real_symbol("spin_arm"), real_symbol("spin_sign")


# --- viscous friction without bound ----------------------------------------------------------


def mobility_at_a_moment() -> System:
    """An arbitrary impulse x at an arbitrary point r of any body."""
    numbers = [Parameter(m, "mass", 1.3, "kg", (m > 0,))]
    numbers += [
        Parameter(s, "inverse of a moment of inertia", 1.0 + i / 4, "1/(kg m^2)", (s > 0,))
        for i, s in enumerate(inverse_inertia.symbols)
    ]
    return System(
        "impulse", "An impulse at a contact", {x: zero, r: zero}, parameters=tuple(numbers)
    )


def _positive_mobility() -> tuple[System, Identity]:
    """(x, Ax) = |x|²/m + (r×x, I⁻¹(r×x))."""
    lever = cross(r, x)
    answer = x / m - cross(r, inverse_inertia * lever)
    squares = norm_squared(x) / m + dot(lever, inverse_inertia * lever)
    identity = Identity("mobility", dot(x, answer) - squares, "the mobility as a sum of squares")
    return mobility_at_a_moment(), identity


def limit_of_viscosity() -> Verdict:
    """A stable layer with the rolling body as its slow motion: Tikhonov's theorem applies.

    With the force f = −cu and t = τ/c the slip obeys u′ = −S u + O(1/c) on the plane, where the
    matrix S = A_tt − A_tn A_nt/A_nn is positive, since A is: the layer is attracted to u = 0.  With
    u = 0 in the equations and f as an unknown they are those of the body that rolls.
    """
    return conclusion_verdict(
        "viscous limit",
        "the fast equation of the slip is −cSu with a positive symmetric S; where it is zero the "
        "equations are those without slip",
        [_positive_mobility()],
    )


# --- the homogeneous ball under dry friction -------------------------------------------------


def dry_ball() -> System:
    """A homogeneous ball with dry friction and a friction couple of constant arm."""
    mu = Parameter(ball.mu, "coefficient of friction", 0.2, "1", (ball.mu > 0,))
    arm = Parameter(spin_arm, "arm of the couple against spin", 0.01, "m", (spin_arm >= 0,))
    sign = Parameter(spin_sign, "sign of the spin", 1.0, "1")
    force = ball.against_slip(ball.mu * ball.m * ball.g / ball.slip_speed)
    couple = -spin_arm * ball.m * ball.g * spin_sign
    return ball.sliding_ball(force, couple, (*ball.ball_parameters(), mu, arm, sign))


def _even_decrease() -> tuple[Identity, Identity]:
    slowing = ball.mu * ball.g * (1 + ball.m * ball.R**2 / ball.inertia)
    turn = spin_arm * ball.m * ball.g / ball.inertia
    return (
        Identity("slip", Rate(ball.slip_speed) + slowing, "the slip falls evenly"),
        Identity("spin", Rate(ball.omega.symbols[2]) + turn * spin_sign, "the spin falls evenly"),
    )


def rolling_with_spin() -> Case:
    """Without the couple the slip ends after |u|/(μg(1 + mR²/I)), and the spin is constant."""
    slip, spin = _even_decrease()
    without = Identity("spin", spin.value, "the spin is constant", level=(spin_arm,))
    return (dry_ball(), slip), (dry_ball(), without)


def rolling_without_spin() -> Case:
    """With the couple both end in finite times; a ball that rolls uniformly needs no force."""
    slip, spin = _even_decrease()
    at_rest = ball.sliding_ball((sp.S.Zero, sp.S.Zero, ball.m * ball.g))
    steady = tuple(Rate(s) for s in (*ball.u.symbols, ball.omega.symbols[2]))
    rolls = Identity("rolls", steady, "slip and spin stay what they are without friction")
    return (dry_ball(), slip), (dry_ball(), spin), (at_rest, rolls)


# --- the coupled law -------------------------------------------------------------------------


def any_friction() -> tuple[tuple[System, Law], ...]:
    """Slip and spin of a ball change only by the force against the slip and the couple."""
    system = ball.sliding_ball(ball.against_slip(), ball.ANY_COUPLE)
    phi = ball.ANY_COEFFICIENT * ball.slip_speed
    answer = 1 / ball.m + ball.R**2 / ball.inertia
    turning = Rate(ball.omega.symbols[2]) - ball.ANY_COUPLE / ball.inertia
    return (
        (system, Identity("slip", Rate(ball.slip_speed) + answer * phi, "rate of the slip")),
        (system, Identity("spin", turning, "rate of the spin")),
    )


def simultaneous() -> Verdict:
    """Neither s = |u| nor w = a|Ω| reaches zero alone, and both vanish in a finite time.

    ṡ = −μ g s₁ 𝓕(s/w) and ẇ = −μ g w₁ 𝓜(s/w) with positive s₁, w₁. The bounds 𝓕 ≤ C k and k𝓜 ≤ D
    imply ṡ ≥ −μ g s₁ C s/w and ẇ ≥ −μ g w₁ D w/s: while the other stays above a positive number,
    neither decreases faster than exponentially. The energy s²/2s₁ + w²/2w₁ decreases at the rate μ
    g (𝓕s + 𝓜w) ≥ μ g E max(s, w), so that both end.
    """
    rests_on = conclusion_verdict("friction of a ball", "", any_friction())
    limits = [bounds(p) for p in (HERTZ, UNIFORM)]
    least = [least_friction(p) for p in (HERTZ, UNIFORM)]
    shown = bool(rests_on) and all(limits) and all(e is not None and e > 0 for e in least)
    constants = ", ".join(f"({C}, {D})" for C, D in filter(None, limits))
    return computed_verdict(
        "simultaneous",
        shown,
        f"𝓕 ≤ C k and k𝓜 ≤ D for all k with (C, D) = {constants} for a ball and a disk: neither "
        "ends while the other lasts",
        rests_on.reason or "the signs of the series do not show the bounds",
        terms=rests_on.terms,
        seconds=rests_on.seconds,
    )


CLAIMS = (
    Claim(
        "§11.2",
        "A nonholonomic constraint can be realized as the limit of infinitely large viscous "
        "friction.",
        limit_of_viscosity,
        note="by Tikhonov's theorem; in the first moments the normal force may be large and "
        "negative",
        where=(
            "a body rolls without slip on a plane",
            "the contact is two-sided",
            "the interval of time is finite and begins after the start",
        ),
    ),
    Claim(
        "§11.2, list",
        "The model in which the velocity of the point of contact is zero but spinning is allowed "
        "can be obtained as the intermediate stage of motion of a system in which only the sliding "
        "friction at the point of contact is taken into consideration and the frictional torque is "
        "neglected.",
        rolling_with_spin,
        note="the slip ends after the time "
        "$|\\mathbf u|/(\\mu g(1 + mR^2/I))$, and the spin stays constant",
        where=("the body is a homogeneous ball under Coulomb friction",),
    ),
    Claim(
        "§11.2, after the list",
        "For a homogeneous ball with Coulomb friction for both the force at the point of contact "
        "and the torque, after the onset of the constraint both the velocity at the point of "
        "contact and the projection of the angular velocity onto the normal to the surface are "
        "zero.",
        rolling_without_spin,
        note="read as a torque in constant ratio to the normal force: slip and spin fall evenly, "
        "each to its end, and stay zero without friction",
    ),
    Claim(
        "§11.2, [86, 93–95]",
        "In the Contensou–Erismann model sliding and spinning of a disk or a homogeneous ball "
        "terminate simultaneously.",
        simultaneous,
        where=(
            "the contact both slides and spins at the start",
            "the pressure is that of Hertz on a round patch of constant radius for the ball, "
            "constant for the disk on its face",
        ),
    ),
)

REMARKS = (
    Remark(
        "§11.2, first paragraph",
        "Ways to realize constraints, Carathéodory, Routh and Painlevé; as a rule nonholonomic "
        "constraints are a realistic representation of the final stage of a motion.",
        "history and opinion",
    ),
    Remark(
        "§11.2, first paragraph",
        "Due to the force of friction sliding ceases with the onset of the constraint.",
        "stated of conditions that are not given; without them it is wrong: for an open set of "
        "states of a sliding body with Coulomb friction the slip ends and begins again at once, as "
        "rolling would need more friction than there is (nonholonomic/docs/friction.md)",
    ),
    Remark(
        "§11.2, end",
        "The constraint of a rubber body decomposes into that of no slipping and that of Veselova.",
        "the definition of the model, (1.14) and (1.15)",
    ),
    Remark(
        "§11.2",
        "Zhuravlev and Klimov claim that the equations after the onset are not nonholonomic.",
        "an opinion of others; that the constraints are not integrable is judged in §2",
    ),
    Remark(
        "§11.2, end",
        "A body with a blade between two balls that roll over each other as a model of rubber "
        "rolling.",
        "a mechanism quoted from [13]; its equations are not stated",
    ),
)
