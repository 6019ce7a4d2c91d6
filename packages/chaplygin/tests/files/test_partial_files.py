"""What a killed process leaves is removed by the next one, and what a running one writes is not."""

from __future__ import annotations

import logging
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

import chaplygin as ch
from chaplygin.cli.terminal.stores import vacate
from chaplygin.experiment.files import atomic_file
from chaplygin.report.study_output import write_study
from counted import task
from flowlanes.errors import InputError
from flowlanes.files.partial_files import write_lock
from flowlanes.files.private_files import write_private
from flowlanes.flow.ensembles.computation import compute

WRITER = """
import sys, time
from pathlib import Path
from chaplygin.experiment.files import atomic_file
from flowlanes.files.partial_files import write_lock, partial_folder
folder = Path(sys.argv[1])
file = folder / "motion.nc"
with write_lock(folder / "a.zarr"), partial_folder(folder), atomic_file(file) as place:
    place.write_text("half of it")
    print("ready", flush=True)
    time.sleep(60)
"""


@contextmanager
def writer(folder: Path) -> Iterator[subprocess.Popen[str]]:
    """Another process that is writing into a folder; it is killed at the end."""
    process = subprocess.Popen(
        [sys.executable, "-c", WRITER, folder], stdout=subprocess.PIPE, text=True
    )
    with process:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        try:
            yield process
        finally:
            process.send_signal(signal.SIGKILL)


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def write_file(folder: Path) -> None:
    with atomic_file(folder / "new") as place:
        place.write_text("new")


def write_to_cache(folder: Path) -> None:
    folder.chmod(0o700)
    assert write_private(folder / "new", b"new")


def write_store(folder: Path) -> None:
    compute(task(), folder / "new").close()


@pytest.mark.parametrize("write", [write_file, write_to_cache, write_store])
def test_the_next_process_removes_what_a_killed_one_left(
    write: object, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    """They stayed in the user's folder for ever."""
    assert callable(write)
    with writer(tmp_path):
        write(tmp_path)
        # nothing of a process that is at work is touched
        assert len(names(tmp_path)) == 4
    left = set(names(tmp_path)) - {"new"}
    assert len(left) == 3
    with caplog.at_level(logging.INFO, "flowlanes"):
        write(tmp_path)
    assert names(tmp_path) == ["new"]
    (message,) = {record.message for record in caplog.records if "removed" in record.message}
    assert message.startswith(f"removed from {tmp_path} what a killed process had left: ")
    assert all(name in message for name in left)


def test_files_of_others_stay(tmp_path: Path) -> None:
    others = [".n87x.partial", "a.partial", ".yarn.lock", ".0123abcd-1-x.partial"]
    for name in others:
        (tmp_path / name).touch()
    write_file(tmp_path)
    assert names(tmp_path) == sorted([*others, "new"])
    # another machine may be at work, but not for a week on the same
    os.utime(tmp_path / others[-1], (1e9, 1e9))
    write_file(tmp_path)
    assert names(tmp_path) == sorted([*others[:-1], "new"])


def test_a_number_given_to_another_process_says_nothing(tmp_path: Path) -> None:
    with atomic_file(tmp_path / "new") as place:
        own = place.name
    (tmp_path / own).touch()
    os.utime(tmp_path / own, (1e9, 1e9))
    write_file(tmp_path)
    assert names(tmp_path) == ["new"]


def test_a_store_that_is_being_written_is_not_replaced(tmp_path: Path) -> None:
    """--force removed it below the other process."""
    store = tmp_path / "a.zarr"
    compute(task(), store).close()
    words = f"^{store} is being written by another process: wait for it, or choose another name$"
    with writer(tmp_path), pytest.raises(InputError, match=words):
        vacate(store, force=True)
    vacate(store, force=True)
    assert not store.exists()


def test_a_folder_holds_one_study_at_a_time(tmp_path: Path) -> None:
    """Two with --force both said that theirs was there."""
    study = ch.Study.from_experiment(
        ch.parse_experiment('system = {name = "veselova"}', overrides=["run.until=1"])
    )
    folder = tmp_path / "v"
    folder.mkdir()
    words = f"^{folder} is being written by another process: wait for it, or choose another name$"
    with write_lock(folder, inside=True), pytest.raises(InputError, match=words):
        write_study(study, folder, force=True, total_budget=0)
    assert names(folder) == []
