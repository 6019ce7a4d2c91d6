"""§11.4: loss of contact."""

from __future__ import annotations

from ...contact.invariants.loss_of_contact import WITHOUT_FORCE, any_contact, paradox
from ...proof.verdict import Verdict
from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import computed_verdict


def zero_force_presses() -> Verdict:
    """A ball that rolls with zero normal force, and that would enter the plane without it."""
    ball = WITHOUT_FORCE
    force, rise = ball.normal_force, ball.free_rise
    shown = ball.gamma.dot(ball.gamma) == 1 and force == 0 and rise < 0
    return computed_verdict(
        "zero normal force",
        shown,
        f"a loaded ball that rolls with N = 0, whose contact point would be accelerated into the "
        f"plane, by {rise}, in free motion; all numbers rational",
        "the state is not as it should be",
    )


def to_painleve() -> Case:
    """B = −b_n/N for the friction that rolling needs."""
    return any_contact(), paradox()


CLAIMS = (
    Claim(
        "§11.4, [104, 105]",
        "The zero normal reaction might be an insufficient condition for a correct "
        "characterization of the loss of contact.",
        zero_force_presses,
        note="an example in rational numbers: with zero normal reaction of the rolling body, free "
        "motion would press its contact point into the plane",
    ),
    Claim(
        "§11.4",
        "Since nonholonomic models are limiting cases of friction models, analysis of the loss of "
        "contact phenomenon in the context of nonholonomic mechanics inescapably leads to the "
        "familiar Painlevé paradoxes inherent to systems with friction.",
        to_painleve,
        note="read as: where rolling needs $N < 0$ though free motion presses the body into the "
        "plane, $b_n < 0$, the friction that rolling needs gives, for sliding against it, the "
        "response $B = -b_n/N < 0$ of the normal acceleration to the normal force; no $N \\ge 0$ "
        "then solves $b_n + BN = 0$",
    ),
)

REMARKS = (
    Remark(
        "§11.4",
        "Euler's disk may lose and gain contact alternately before it comes to rest.",
        "a conjecture on a toy, for which no equations are stated",
    ),
)
