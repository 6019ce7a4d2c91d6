"""Work done in a second process: its result, what it raises, and how it ends."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from multiprocessing import active_children
from pathlib import Path

import psutil
import pytest

from chaplygin.report.background_worker import beside
from flowlanes.errors import InputError


def test_a_result_comes_from_another_process_and_only_once() -> None:
    with beside(lambda: (os.getpid(), [1.5, "γ"])) as result:
        assert result() is result()
        process, value = result()
    assert value == [1.5, "γ"]
    assert process != os.getpid()


def test_in_a_thread_of_a_server_the_work_is_done_there() -> None:
    def work() -> int:
        with beside(os.getpid) as result:
            return result()

    with ThreadPoolExecutor(1) as threads:
        assert threads.submit(work).result() == os.getpid()


def test_what_the_work_raises_is_raised_here() -> None:
    def refused() -> None:
        raise InputError("no such colour")

    with beside(refused) as result, pytest.raises(InputError, match="no such colour"):
        result()


def test_a_large_result_does_not_block() -> None:
    with beside(lambda: "x" * 10_000_000) as result:
        time.sleep(0.1)
        assert len(result()) == 10_000_000


def test_nothing_goes_on_after_an_interruption(tmp_path: Path) -> None:
    begun, ended = tmp_path / "begun", tmp_path / "ended"

    def long() -> None:
        try:
            begun.touch()
            time.sleep(60.0)
        finally:
            ended.touch()

    def interrupted() -> None:
        with beside(long):
            while not begun.exists():
                time.sleep(0.01)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    # what was being written is removed
    assert ended.exists()
    assert not active_children()


def test_work_of_a_process_ended_from_outside_is_done_here() -> None:
    own = os.getpid()

    def fragile() -> int:
        if os.getpid() != own:
            os.kill(os.getpid(), signal.SIGKILL)
        return own

    with beside(fragile) as result:
        assert result() == own


#: A program with work beside it: what it prints last are the numbers of the second process.
PROGRAM = """
import os, sys, time
from pathlib import Path
from chaplygin.interruption import interruptible
from chaplygin.report.background_worker import beside

def work():
    Path("begun").write_text(str(os.getpid()))
    try:
        {work}
    finally:
        Path("ended").touch()

with interruptible(), beside(work) as result:
    while not Path("begun").exists():
        time.sleep(0.01)
    time.sleep(0.1)
    print(Path("begun").read_text(), flush=True)
    time.sleep(60)
"""
#: More than a pipe holds, and time that passes.
WORKS = {"sends": "return bytes(10_000_000)", "computes": "time.sleep(60)"}


@pytest.mark.skipif(sys.platform != "linux", reason="processes are copied on Linux alone")
@pytest.mark.parametrize("sent", [signal.SIGTERM, signal.SIGKILL, signal.SIGINT])
@pytest.mark.parametrize("work", WORKS)
def test_the_second_process_ends_with_the_first(
    work: str, sent: signal.Signals, tmp_path: Path
) -> None:
    """It stayed for ever, with 340 MB, after SIGTERM and SIGKILL."""
    script = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    program = subprocess.Popen(
        [sys.executable, "-c", script + PROGRAM.format(work=WORKS[work])],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert program.stdout is not None
    second = psutil.Process(int(program.stdout.readline()))
    try:
        program.send_signal(sent)
        _, words = program.communicate(timeout=10)
        second.wait(timeout=5)
    finally:
        for process in (program, second):
            with suppress(psutil.NoSuchProcess):
                process.kill()
    codes = {signal.SIGTERM: 143, signal.SIGKILL: -signal.SIGKILL, signal.SIGINT: 130}
    assert program.returncode == codes[sent]
    assert (tmp_path / "ended").exists()
    assert (words == "") == (sent == signal.SIGKILL)
    assert "Traceback" not in words
