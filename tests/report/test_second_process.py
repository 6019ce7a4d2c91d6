"""Work done in a second process: its result, what it raises, and how it ends."""

from __future__ import annotations

import os
import signal
import time
from concurrent.futures import ThreadPoolExecutor
from multiprocessing import active_children
from pathlib import Path

import pytest

from chaplygin.errors import InputError
from chaplygin.report.second_process import beside


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
