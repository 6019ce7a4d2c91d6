"""Codes for the reasons why a motion ends."""

from __future__ import annotations

from ...system.system import System

#: Reasons by code; the guards of the system follow.
STATUS_MESSAGES = (
    "",
    "the step size collapsed (a singularity of the equations is near)",
    "the state stopped being a number",
    "the largest number of steps was reached",
    "the time limit was reached",
    "a million steps passed without a crossing",
)

COLLAPSED, NOT_A_NUMBER, STEPS, OVER, IN_VAIN = range(1, len(STATUS_MESSAGES))


def outcome_message(system: System, code: int) -> str:
    """Reason for which a motion ended; empty for code 0."""
    if code < len(STATUS_MESSAGES):
        return STATUS_MESSAGES[code]
    return system.guards[code - len(STATUS_MESSAGES)].message
