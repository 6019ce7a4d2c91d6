"""Refusal of computations that would take years, or more memory or disk than there is."""

from __future__ import annotations

import math
import shutil
import time
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import InputError
from .kernel.outcomes import STEPS

#: A computation that would take longer is refused: seconds in a year.
YEAR = 365.25 * 86400.0
#: Seconds after which the pace is known.
_WARM_UP = 0.5
#: Steps that a motion may take, and steps by which the length of a motion is estimated.
MOST_STEPS, FEW_STEPS = 100_000_000, 2_000
_UNITS = ("bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB", "ZiB", "YiB")
_KIBI = 1024.0


class TooMuchError(InputError):
    """A computation that asks for more time or room than there is."""


@dataclass(frozen=True)
class Pace:
    """The pace of a computation, from the creation of this object on."""

    began: float = field(default_factory=time.perf_counter)

    def check(self, fraction: float, what: str) -> None:
        """Refuse a computation that would take more than a year.

        Parameters
        ----------
        fraction : float
            The share that is done by now, of 1.
        what : str
            The computation, with its size: the beginning of the sentence.

        Raises
        ------
        TooMuchError
            With the estimate.
        """
        elapsed = time.perf_counter() - self.began
        if elapsed < _WARM_UP or elapsed <= YEAR * fraction:
            return
        years = f"{elapsed / fraction / YEAR:.1g}" if fraction else "endless"
        raise TooMuchError(
            f"{what} would take about {years} years: in {elapsed:.2g} s it has come "
            f"{fraction:.1g} of the way"
        )


def require_room(size: float, folder: Path | None, what: str) -> None:
    """Refuse a result that finds no room.

    Parameters
    ----------
    size : float
        In bytes.
    folder : Path or None
        The result is to be written there; in memory if None.
    what : str
        The computation: the beginning of the sentence.

    Raises
    ------
    InputError
        With both sizes.
    """
    if folder is None:
        import psutil

        room, place = float(psutil.virtual_memory().total), "memory"
    else:
        there = next((p for p in (folder, *folder.absolute().parents) if p.is_dir()), Path("/"))
        usage = shutil.disk_usage(there)
        # a file system without room of its own says nothing about it
        room, place = float(usage.free) if usage.total else math.inf, "disk"
    if size > room:
        raise TooMuchError(
            f"{what} would take {in_words(size)} of {place}, and there are {in_words(room)}"
        )


def require_steps(until: float, outcome: int, end_time: float, steps: int) -> None:
    """Refuse a time that needs more steps than are allowed, by the first few of them.

    Parameters
    ----------
    until : float
        The time.
    outcome, ended, steps
        Of a motion that was allowed few steps.

    Raises
    ------
    TooMuchError
        With the estimate.
    """
    if outcome != STEPS:
        return
    needed = steps * abs(until) / abs(float(end_time)) if end_time else math.inf
    if needed > MOST_STEPS:
        raise TooMuchError(
            f"to follow a motion for {until:g} s would take about {needed:.1g} steps, and it is "
            f"given up after {MOST_STEPS:.0e}: follow it for a shorter time"
        )


def in_words(size: float) -> str:
    """A number of bytes with two or three digits."""
    steps = 0
    while size >= _KIBI and steps < len(_UNITS) - 1:
        size, steps = size / _KIBI, steps + 1
    return f"{size:.3g} {_UNITS[steps]}"
