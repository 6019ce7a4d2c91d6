"""Ctrl-C: a command ends within a second, reports what it has saved, and exits with code 130.

SIGTERM, with which another process requests the end, has the same effect, with code 143.
Long-running machine code lets Python handle a signal only when it returns.  A second thread
therefore handles the interrupt if the main thread does not react.
"""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType

#: Exit code after an interruption, by Ctrl-C unless another signal arrived.
EXIT_CODE = 128 + signal.SIGINT

#: Signals that interrupt, with their default handlers.
_SIGNALS: dict[signal.Signals, Callable[[int, FrameType | None], object] | signal.Handlers] = {
    signal.SIGINT: signal.default_int_handler,
    signal.SIGTERM: signal.SIG_DFL,
}

#: Default message.
NOTHING_SAVED = "nothing was saved; the same command starts from the beginning"

#: Seconds that a command has to end by itself.
GRACE_PERIOD = 0.6


@dataclass(frozen=True)
class _Ending:
    """Messages for an immediate interruption, and for one while the command saves.

    Saving takes place when Python can react (`saving`), or also when machine code returns
    (`patient`).
    """

    words: Callable[[], str]
    saving: str = ""
    patient: bool = False


@dataclass
class _State:
    """The pending message, whether it was printed, and whether Python can react."""

    endings: list[_Ending]
    was_announced: bool = False
    was_interrupted: bool = False
    exit_code: int = EXIT_CODE

    @property
    def ending(self) -> _Ending:
        return self.endings[-1] if self.endings else _NOTHING

    @property
    def saves(self) -> bool:
        return self.ending.patient or bool(self.was_interrupted and self.ending.saving)


_NOTHING = _Ending(lambda: NOTHING_SAVED)
_STATE = _State([])


def exit_code() -> int:
    """The exit code of an interrupted program: 130 for Ctrl-C, 143 for SIGTERM."""
    return _STATE.exit_code


def print_interruption(words: str = "") -> None:
    """Print that the program was interrupted, with these words or those of the current block.

    The latter are printed only once.
    """
    if words or not _STATE.was_announced:
        _STATE.was_announced = True
        # A progress bar leaves its line on the terminal, and the cursor hidden.
        bar = "\r\x1b[K\x1b[?25h" if sys.stderr.isatty() else ""
        sys.stderr.write(f"{bar}interrupted: {words or _STATE.ending.words()}\n")
        sys.stderr.flush()


@contextmanager
def message_on_interrupt(words: str | Callable[[], str], saving: str = "") -> Iterator[None]:
    """Within the block, an interruption ends the program at once with these words.

    Parameters
    ----------
    words : str or callable
        A clause on the results stored and how to resume, without a full stop.
    saving : str, optional
        A clause on the saving that an interrupted block still does before it ends.
    """
    text = words if callable(words) else (lambda: words)
    with _during(_Ending(text, saving)):
        try:
            yield
        except KeyboardInterrupt:
            print_interruption()
            raise


@contextmanager
def results_on_interrupt(saving: str) -> Iterator[None]:
    """Within the block, an interruption is left to the block, which has results to print.

    Parameters
    ----------
    saving : str
        A clause on the work still awaited, without a full stop; printed if it takes longer than a
        moment.
    """
    with _during(_Ending(lambda: "the results were not printed", saving, patient=True)):
        yield


@contextmanager
def _during(block_ending: _Ending) -> Iterator[None]:
    _STATE.endings.append(block_ending)
    try:
        yield
    finally:
        _STATE.endings.pop()


@contextmanager
def interruptible() -> Iterator[None]:
    """End the program as described above if it is interrupted within this block.

    Nothing is changed outside the main thread, or if Ctrl-C is already handled.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    _STATE.was_announced = _STATE.was_interrupted = False
    # In background processes of tests and scripts Ctrl-C may be ignored.
    heard = [name for name, default in _SIGNALS.items() if signal.getsignal(name) == default]
    if not heard:
        yield
        return
    _STATE.exit_code = EXIT_CODE
    unraisable = sys.unraisablehook
    sys.unraisablehook = _without_interruptions(unraisable)
    ear, mouth = socket.socketpair()
    mouth.setblocking(False)
    before = signal.set_wakeup_fd(mouth.fileno(), warn_on_full_buffer=False)
    for name in heard:
        signal.signal(name, _act)
    over = threading.Event()
    threading.Thread(target=_listen, args=(ear, over), daemon=True).start()
    try:
        yield
    except KeyboardInterrupt:
        if signal.SIGINT not in heard and not _STATE.was_interrupted:
            raise
        _conclude()
    except SystemExit as end:
        if end.code == EXIT_CODE:
            _conclude()
        raise
    except Exception:
        # Compiled libraries convert an exception raised in their callbacks to one of their own.
        if _STATE.was_interrupted:
            _conclude()
        raise
    finally:
        over.set()
        sys.unraisablehook = unraisable
        signal.set_wakeup_fd(before)
        for name in heard:
            signal.signal(name, _SIGNALS[name])
        mouth.close()


def _act(number: int, frame: FrameType | None) -> None:
    _STATE.was_interrupted = True
    _STATE.exit_code = 128 + number
    raise KeyboardInterrupt


def _without_interruptions(
    report: Callable[[sys.UnraisableHookArgs], object],
) -> Callable[[sys.UnraisableHookArgs], object]:
    """Report exceptions that finalisers and callbacks cannot raise, except interruptions.

    The interruption itself is lost there; the listening thread ends the program.
    """

    def hook(unraisable: sys.UnraisableHookArgs) -> None:
        if not issubclass(unraisable.exc_type, KeyboardInterrupt):
            report(unraisable)

    return hook


def _conclude() -> None:
    """End the program without leaving a process behind."""
    print_interruption()
    _end_children()
    # If a string is executed when it is interrupted, Python ends by SIGINT under -m, unless another
    # one is executed afterwards.
    exec("")
    raise SystemExit(_STATE.exit_code)


def _listen(ear: socket.socket, over: threading.Event) -> None:
    """Wait for a signal; then print its message and end the program."""
    times = 0
    with ear:
        while heard := ear.recv(1):
            if heard[0] not in _SIGNALS:
                continue
            _STATE.exit_code = 128 + heard[0]
            times += 1
            if over.wait(0 if times > 1 else GRACE_PERIOD):
                return
            with contextlib.suppress(OSError, ValueError):
                if times == 1 and _STATE.saves:
                    print_interruption(f"{_STATE.ending.saving}; Ctrl-C again ends at once")
                    continue
                print_interruption()
            _end_children()
            _remove_partial_files()
            os._exit(_STATE.exit_code)


def _end_children() -> None:
    """End the worker processes of this one."""
    if "multiprocessing" in sys.modules:
        from multiprocessing import active_children

        from flowlanes.child_processes import end_processes

        end_processes(active_children(), GRACE_PERIOD)


def _remove_partial_files() -> None:
    """Remove partially written files, if there are any."""
    if "flowlanes.files.partial_files" in sys.modules:
        from flowlanes.files.partial_files import remove_own

        remove_own()
