"""Limits on computations that would take years, or more memory or disk space than available."""

from __future__ import annotations

import math
import shutil
import time
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import InputError
from .kernel.outcomes import STEPS

#: Longest accepted duration in seconds: one year.
YEAR = 365.25 * 86400.0
#: Time in seconds after which the speed is measured.
_WARM_UP = 0.5
#: Maximum number of steps of a motion, and number of steps used to estimate the cost of a motion.
MOST_STEPS, FEW_STEPS = 100_000_000, 2_000
_UNITS = ("bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB", "ZiB", "YiB")
_KIBI = 1024.0


class TooMuchError(InputError):
    """Computation that would take too long or too much space."""


@dataclass(frozen=True)
class Pace:
    """Estimate of the duration of a computation that starts when this object is created."""

    began: float = field(default_factory=time.perf_counter)

    def check(self, fraction: float, what: str) -> None:
        """Raise an error if the computation would take more than a year.

        Parameters
        ----------
        fraction : float
            Completed fraction.
        what : str
            Name of the computation with its size, to begin a sentence.

        Raises
        ------
        TooMuchError
            With the estimated duration.
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
    """Raise an error if a result does not fit into memory or on the disk.

    Parameters
    ----------
    size : float
        Size in bytes.
    folder : Path or None
        Folder of the result; None for memory.
    what : str
        Name of the computation, to begin a sentence.

    Raises
    ------
    InputError
        If the result is larger than the available space.
    """
    if folder is None:
        import psutil

        room, place = float(psutil.virtual_memory().total), "memory"
    else:
        there = next((p for p in (folder, *folder.absolute().parents) if p.is_dir()), Path("/"))
        usage = shutil.disk_usage(there)
        # A file system without free space of its own, such as /proc, gives no information.
        room, place = float(usage.free) if usage.total else math.inf, "disk"
    if size > room:
        raise TooMuchError(
            f"{what} would take {in_words(size)} of {place}, and there are {in_words(room)}"
        )


def require_steps(t_end: float, outcome: int, end_time: float, steps: int) -> None:
    """Raise an error if a time needs too many steps, as estimated from the first few steps.

    Parameters
    ----------
    t_end : float
        Final time.
    outcome, ended, steps
        Result for a motion with a small limit on its steps.

    Raises
    ------
    TooMuchError
        With the estimated number of steps.
    """
    if outcome != STEPS:
        return
    needed = steps * abs(t_end) / abs(float(end_time)) if end_time else math.inf
    if needed > MOST_STEPS:
        raise TooMuchError(
            f"to follow a motion for {t_end:g} s would take about {needed:.1g} steps, and it is "
            f"given up after {MOST_STEPS:.0e}: follow it for a shorter time"
        )


def in_words(size: float) -> str:
    """Number of bytes as text with two or three digits."""
    steps = 0
    while size >= _KIBI and steps < len(_UNITS) - 1:
        size, steps = size / _KIBI, steps + 1
    return f"{size:.3g} {_UNITS[steps]}"
