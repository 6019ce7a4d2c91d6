"""§11.4: loss of contact."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol, vectors
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue
from nonholonomic.contact.invariants.loss_of_contact import (
    WITHOUT_FORCE,
    any_contact,
    zero_normal_acceleration,
)

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import computed_verdict


def zero_force_presses() -> Verdict:
    """A ball that rolls with zero normal force, and that would penetrate the plane without it."""
    ball = WITHOUT_FORCE
    force, rise = ball.normal_force, ball.free_rise
    shown = ball.gamma.dot(ball.gamma) == 1 and force == 0 and rise < 0
    return computed_verdict(
        "zero normal force",
        shown,
        f"a loaded ball that rolls with N = 0, whose contact point would be accelerated into the "
        f"plane, by {rise}, in free motion; all numbers rational",
        "the state does not have the expected properties",
    )


def to_painleve() -> Case:
    """B = −b_n/N for the friction needed for rolling."""
    return any_contact(), zero_normal_acceleration()


def whirling() -> Case:
    """Steady motions of a heavy disk at every inclination α, with its centre of mass at rest.

    The angular velocity Ω(γ₁, γ₂, 0) is along the diameter through the contact point, which moves
    around at the rate Ω. On this level the root √(γ, Bγ) equals R sin α, since both are positive,
    and is replaced by it.
    """
    disk = from_catalogue("heavy-disk")
    m, g, R, I_1, I_2, height, sine, turn = map(
        real_symbol, ("m", "g", "R", "I_1", "I_2", "s", "sin_alpha", "Omega")
    )
    M, gamma = vectors("M gamma")
    level = (
        I_1 - I_2,
        gamma.symbols[0] ** 2 + gamma.symbols[1] ** 2 - sine**2,
        *(M.symbols[i] - I_1 * turn * gamma.symbols[i] for i in (0, 1)),
        M.symbols[2],
        I_1 * turn**2 * sine - m * g * R,
    )
    further = (
        Parameter(sine, "sine of the inclination", 0.1, admissible=(sine > 0,)),
        Parameter(turn, "rate of the point of contact", 20.0),
    )
    law = Identity("whirling", Rate(gamma.symbols[2]), "constant inclination", level=level)
    definitions = (
        (name, R * sine if name == height else value) for name, value in disk.definitions
    )
    return replace(
        disk,
        parameters=(*disk.parameters, *further),
        definitions=tuple(definitions),
        laws=(),
    ), law


CLAIMS = (
    Claim(
        "§11.4, Euler's disk",
        "When spun on a table, its motion at the final stage (before it abruptly comes to rest) is "
        "characterized by oscillations and a whirring sound of rapidly increasing frequency.",
        whirling,
        note="read as: at every inclination α the disk has a steady motion with its centre at "
        "rest, in which the point of contact runs round at the rate Ω, $\\Omega^2 = mgR/(I_1 "
        "\\sin\\alpha)$, which is $4g/(R \\sin\\alpha)$ if the mass is spread evenly: it grows "
        "without bound as the disk sinks. That friction lets it sink, and come to rest in a finite "
        "time, is computed and not proven (nonholonomic/docs/friction.md)",
        where=("the disk passes through the steady motions of the note as it sinks",),
    ),
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
    Remark(
        "§11.4",
        "Bounces invisible to the human eye were mentioned by Appell and Coriolis; loss of contact "
        "is very little studied in nonholonomic mechanics, and can lead to intriguing effects.",
        "history and opinion; bodies that leave their support and land again are computed in "
        "nonholonomic/docs/friction.md",
    ),
)
