"""The two ways in which the package refuses to go on."""

from __future__ import annotations

from typing import Any


class InputError(ValueError):
    """A mistake of the user: what is wrong, where it stands and what is allowed.

    Parameters
    ----------
    message
        One sentence, written for the user; a mistake inside a formula adds a two-line excerpt.
    where
        Where the mistake stands, such as ``"body.toml, line 7, body.inertia"``; may be empty.
    """

    def __init__(self, message: str, where: str = "") -> None:
        super().__init__(message, where)
        self.message = message
        self.where = where

    def __str__(self) -> str:
        return f"{self.where}: {self.message}" if self.where else self.message


class RunError(RuntimeError):
    """A computation that could not be carried to its end.

    Parameters
    ----------
    reason
        One sentence saying what went wrong.
    time
        The last instant at which the solution was still good.
    partial
        What had been computed by then, such as a trajectory; nothing is lost.
    """

    def __init__(self, reason: str, time: float, partial: Any = None) -> None:
        super().__init__(reason, time)
        self.reason = reason
        self.time = time
        self.partial = partial

    def __str__(self) -> str:
        return f"{self.reason} (the last good time is {self.time:.9g})"


class InterruptionError(RunError):
    """A computation that the user interrupted; what had been computed by then is `partial`."""


class EarlyEndError(RunError):
    """A motion that ended before its time.

    Parameters
    ----------
    system
        Name of the system.
    reason, time
        As of a RunError.
    """

    def __init__(self, system: str, reason: str, time: float) -> None:
        super().__init__(reason, time)
        self.args = (system, reason, time)
        self.system = system

    def __str__(self) -> str:
        return f"{self.system}: the motion ends at t = {self.time:.6g} s: {self.reason}"
