"""Reasons why a motion in contact ends early."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

EndReason = Literal[
    "",
    "lift-off",
    "paradox",
    "pulled",
    "neither",
    "lifted",
    "rolling held",
    "no beginning",
    "no end",
    "many events",
    "singular",
    "guard",
    "failure",
    "impact",
    "many steps",
]

#: The reasons as text, in the order of their codes in datasets.
END_REASONS: Mapping[EndReason, str] = {
    "": "the last time was reached",
    "lift-off": "the body left the support",
    "paradox": "no motion in contact is possible (Painlevé's paradox)",
    "pulled": "the support would have to pull the rolling body",
    "neither": "the contact can neither be held nor slide",
    "lifted": "friction lifts the body, which cannot fly",
    "rolling held": "rolling can neither be held nor begin",
    "no beginning": "sliding begins, but no such motion was found",
    "no end": "sliding or rolling comes close to its end without reaching it",
    "many events": "too many events",
    "singular": "the state stops being a number",
    "guard": "the equations of motion end",
    "failure": "the integration failed",
    "impact": "the friction of an impact is not known",
    "many steps": "too many steps of integration",
}

SINGULAR = "the motion comes to a singular end: its state stops being a number"

NO_RETURN = (
    "friction that does not depend on the normal force lifts the body, which without it would be "
    "pressed into the support: neither contact nor flight is possible"
)


class EndError(Exception):
    """Raised to end a motion that cannot continue.

    Attributes
    ----------
    ending : str
        One of `END_REASONS`.
    """

    def __init__(self, ending: EndReason, message: str) -> None:
        super().__init__(message)
        self.ending = ending
