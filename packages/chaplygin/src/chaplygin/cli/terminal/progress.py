"""Progress of a command: a bar on a terminal, or lines in a log."""

from __future__ import annotations

import logging
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

    from ...report.study_output import StudyProgress

#: Logger for messages other than results: notes and progress (info), timing (debug).
LOG = logging.getLogger("chaplygin")
LOG.setLevel(logging.INFO)

#: Loggers of the packages of the laboratory.
LOGGERS = (LOG, *map(logging.getLogger, ("flowlanes", "lawproof", "nonholonomic")))

#: Seconds before a task starts to report, and between two lines in a log.  Startup takes a quarter
#: of a second, and a short task may precede, so the first report appears within a second.
PATIENCE, BETWEEN = 0.4, 10.0


@contextmanager
def progress(task: str) -> Iterator[StudyProgress]:
    """Report of the activity and the completed fraction, after about half a second.

    Parameters
    ----------
    task : str
        Text for the first step.
    """
    if not LOG.isEnabledFor(logging.INFO):
        yield _Silence()
        return
    report = _Bar(task) if sys.stderr.isatty() else _Log(task)
    try:
        yield report
    finally:
        report.stop()


@contextmanager
def waiting(task: str) -> Iterator[StudyProgress]:
    """Report of the activity that is awaited, after about half a second.

    A terminal shows it temporarily; a log, which keeps its lines, contains only explicit messages.
    """
    with progress(task if sys.stderr.isatty() else "") as report:
        yield report


class _Silence:
    """No progress."""

    def __call__(self, share: float, /) -> None:
        pass

    def say(self, what: str) -> None:
        pass


class _Bar:
    """Bar that appears after a delay, even if nothing has been reported."""

    def __init__(self, task: str) -> None:
        self._task = task
        self._share: float | None = None
        self._bar: Progress | None = None
        self._number: TaskID | None = None
        self._lock = threading.Lock()
        self._timer = threading.Timer(PATIENCE, self._show)
        self._timer.daemon = True
        self._timer.start()

    def _show(self) -> None:
        from rich.console import Console
        from rich.progress import (
            BarColumn,
            Progress,
            TaskProgressColumn,
            TextColumn,
            TimeElapsedColumn,
            TimeRemainingColumn,
        )

        bar = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            TaskProgressColumn(),
            TimeElapsedColumn(),
            TimeRemainingColumn(),
            console=Console(stderr=True),
            transient=True,
        )
        with self._lock:
            if self._timer.finished.is_set():
                return
            self._bar = bar
            self._number = bar.add_task(self._task, total=None)
            self._tell()
            bar.start()

    def _tell(self) -> None:
        if self._bar is not None and self._number is not None:
            total = None if self._share is None else 1.0
            self._bar.update(
                self._number, description=self._task, completed=self._share or 0.0, total=total
            )

    def __call__(self, share: float, /) -> None:
        with self._lock:
            self._share = share
            self._tell()

    def say(self, what: str) -> None:
        with self._lock:
            self._task, self._share = what, None
            self._tell()

    def stop(self) -> None:
        self._timer.cancel()
        with self._lock:
            if self._bar is not None:
                self._bar.stop()


class _Log:
    """Log lines at intervals."""

    def __init__(self, task: str) -> None:
        self._task = task
        self._over = threading.Event()
        self._share: float | None = None
        self._last_line = ""
        self._writer = threading.Thread(target=self._write, daemon=True)
        self._writer.start()

    def _write(self) -> None:
        """Write a line after a moment, and whenever there is news."""
        pause = PATIENCE
        while not self._over.wait(pause):
            if not self._task:
                continue
            pause = BETWEEN
            line = self._task if self._share is None else f"{self._task}: {self._share:.0%}"
            if line != self._last_line:
                self._last_line = line
                sys.stderr.write(f"{line} …\n")
                sys.stderr.flush()

    def __call__(self, share: float, /) -> None:
        self._share = share

    def say(self, what: str) -> None:
        self._task, self._share = what, None

    def stop(self) -> None:
        """Stop; pending output is written before the next output of the program."""
        self._over.set()
        self._writer.join()
