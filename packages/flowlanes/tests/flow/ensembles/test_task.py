"""Computations in blocks: in memory and in a store, killed at any moment, refused in a sentence."""

from __future__ import annotations

import errno
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
import zarr

import counted
import flowlanes
from counted import task
from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.flow.ensembles.task import IncompleteError, Task, Variable
from flowlanes.flow.ensembles.zarr_store import read_store


def same(first: xr.Dataset, second: xr.Dataset) -> None:
    """To the bit, signs of zeros included, with all names and attributes."""
    xr.testing.assert_identical(first.load(), second.load())
    for name in first.variables:
        assert first[name].dtype == second[name].dtype
        assert first[name].to_numpy().tobytes() == second[name].to_numpy().tobytes()


@pytest.mark.parametrize("block", [1, 7, 10, 35, 100])
def test_a_store_holds_what_memory_would(block: int, tmp_path: Path) -> None:
    here = compute(task())
    same(here, compute(task(block=block)))
    same(here, compute(task(block=block), tmp_path / "a.zarr"))


def test_a_store_is_read_by_others(tmp_path: Path) -> None:
    compute(task(), tmp_path / "a.zarr")
    # names of axes, attributes and consolidated metadata are where xarray looks for them
    read = xr.open_zarr(tmp_path / "a.zarr", consolidated=True, chunks=None)
    assert read.orbit.dims == ("run", "time", "axis")
    assert read.orbit.attrs == {"long_name": "a made-up orbit", "units": "1", "source": ""}
    assert set(read.coords) == {"time", "space", "mass"}
    assert read.attrs == {"system": "made up", "seed": 1, "tolerance": 1e-13}
    assert read.done.all()


def test_blocks_are_chunks(tmp_path: Path) -> None:
    compute(task(), tmp_path / "a.zarr")
    group = zarr.open_group(tmp_path / "a.zarr", mode="r")
    assert group["orbit"].chunks == (10, 2, 3)
    assert len(list((tmp_path / "a.zarr" / "orbit" / "c").iterdir())) == 4


def test_progress_goes_from_nothing_to_all(tmp_path: Path) -> None:
    told: list[float] = []
    compute(task(), tmp_path / "a.zarr", progress=told.append)
    assert told == [0, 0.25, 0.5, 0.75, 1]
    told.clear()
    compute(task(), tmp_path / "a.zarr", progress=told.append)
    assert told == [1]


def test_what_is_finished_is_not_computed_again(tmp_path: Path) -> None:
    log = tmp_path / "log"
    for _ in range(2):
        compute(task(log=str(log)), tmp_path / "a.zarr")
    assert len(log.read_text().split()) == 4


def test_a_store_goes_on_in_its_own_blocks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(IncompleteError):
        stopping_after(2, monkeypatch)
        compute(task(block=10), tmp_path / "a.zarr")
    monkeypatch.undo()
    same(compute(task()), compute(task(block=9), tmp_path / "a.zarr"))


def test_a_mistake_in_a_block_keeps_the_others(tmp_path: Path) -> None:
    def stop(done: float) -> None:
        if done >= 0.5:
            raise KeyboardInterrupt

    log = tmp_path / "log"
    with pytest.raises(KeyboardInterrupt):
        compute(task(log=str(log)), tmp_path / "a.zarr", progress=stop)
    same(compute(task(log=str(log))), compute(task(log=str(log)), tmp_path / "a.zarr"))
    assert log.read_text().split() == ["0", "10", *["0", "10", "20", "30"], "20", "30"]


# --- killed ---------------------------------------------------------------------------------------


TESTS, SOURCE = Path(counted.__file__).parent, Path(flowlanes.__file__).parents[1]


def beginning(store: Path, log: Path, size: int, block: int) -> subprocess.Popen[bytes]:
    """Another process that is about to compute."""
    script = "import counted; counted.begin_when_told()"
    process = subprocess.Popen(
        [sys.executable, "-c", script, str(store), str(size), str(block), str(log)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, (TESTS, SOURCE)))},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    assert process.stdout is not None
    process.stdout.readline()
    return process


def go(process: subprocess.Popen[bytes]) -> None:
    assert process.stdin is not None
    process.stdin.write(b"go\n")
    process.stdin.flush()


def killed(store: Path, log: Path, after: float, size: int, block: int) -> bool:
    """Compute in another process and kill it; whether it was killed before it was done."""
    with beginning(store, log, size, block) as process:
        go(process)
        time.sleep(after)
        process.send_signal(signal.SIGKILL)
    return process.returncode == -signal.SIGKILL


def survives_kills(kills: int, size: int, longest: float, seed: int, folder: Path) -> None:
    """Kill a computation so many times, then let it end, and compare with an undisturbed one."""
    chance = random.Random(seed)
    store, log, block = folder / "a.zarr", folder / "log", 4
    stopped = sum(killed(store, log, chance.uniform(0, longest), size, block) for _ in range(kills))
    same(compute(task(size, block)), final(store, log, size, block))
    blocks = size // block
    # nothing is lost, and what is repeated is the block that was under way
    assert blocks <= len(log.read_text().split()) <= blocks + stopped
    # nothing is left lying about
    assert not [*store.rglob("*.partial")]
    assert {item.name for item in folder.iterdir()} == {"a.zarr", "log"}


def final(store: Path, log: Path, size: int, block: int) -> xr.Dataset:
    """The rest, in this process; the log's name is part of the experiment."""
    return compute(task(size, block, log=str(log)), store)


@pytest.mark.slow
def test_killed_and_resumed_without_loss_or_repetition(tmp_path: Path) -> None:
    survives_kills(3, 240, 0.3, 1, tmp_path)


@pytest.mark.slow
def test_killed_twenty_times(tmp_path: Path) -> None:
    survives_kills(20, 600, 0.2, 2, tmp_path)


def test_a_store_half_begun_is_begun_again(tmp_path: Path) -> None:
    # what is left when the process is killed while the store is laid out
    script = (
        "import os, signal, sys; from pathlib import Path\n"
        "from flowlanes.files.partial_files import partial_folder\n"
        "with partial_folder(Path(sys.argv[1])) as place:\n"
        "    (place / 'orbit').mkdir(); os.kill(os.getpid(), signal.SIGKILL)"
    )
    subprocess.run([sys.executable, "-c", script, tmp_path], check=False)
    assert len(list(tmp_path.iterdir())) == 1
    same(compute(task()), compute(task(), tmp_path / "a.zarr"))
    assert [item.name for item in tmp_path.iterdir()] == ["a.zarr"]


def test_a_block_that_is_not_marked_does_not_count(tmp_path: Path) -> None:
    log = tmp_path / "log"
    compute(task(log=str(log)), tmp_path / "a.zarr")
    group = zarr.open_group(tmp_path / "a.zarr")
    group["done"][:] = [True, False, True, True]
    # some of its chunks are there, one is of other numbers, one is half a file of a killed writer
    group["orbit"][10:20] = 7.0
    (tmp_path / "a.zarr" / "mass" / "c" / "1").unlink()
    (tmp_path / "a.zarr" / "mass" / "c" / "1.0123.partial").write_bytes(b"half")
    same(compute(task()), compute(task(log=str(log)), tmp_path / "a.zarr"))
    assert log.read_text().split()[4:] == ["10"]
    assert not [*tmp_path.rglob("*.partial")]


@pytest.mark.parametrize("emptied", [True, False], ids=["emptied", "deleted"])
def test_a_finished_block_that_lost_a_part(emptied: bool, tmp_path: Path) -> None:
    place, log = tmp_path / "a.zarr", tmp_path / "log"
    compute(task(log=str(log)), place)
    for chunk in (place / "orbit" / "c" / "1" / "0" / "0", place / "mass" / "c" / "3"):
        chunk.unlink()
        if emptied:
            chunk.touch()
    with pytest.raises(InputError) as told:
        read_store(place)
    assert str(told.value) == (
        f"{place} is damaged: of its finished blocks 2 have lost a part, the first is 1; run the "
        "same into it again, and they are computed again"
    )
    same(compute(task()), compute(task(log=str(log)), place))
    assert log.read_text().split()[4:] == ["10", "30"]


@pytest.mark.parametrize("content", [b"", b"half of it"], ids=["empty", "nonsense"])
def test_marks_that_cannot_be_read(content: bytes, tmp_path: Path) -> None:
    place = tmp_path / "a.zarr"
    compute(task(), place)
    (place / "done" / "c" / "0").write_bytes(content)
    told = (
        f"{place} is damaged: which of its blocks are finished cannot be read; delete it or "
        "choose another name for the store, and run the same again"
    )
    refused(told, task(), place)
    with pytest.raises(InputError) as error:
        read_store(place)
    assert str(error.value) == told


def test_marks_are_on_the_disk_before_a_block_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settled: list[str] = []

    def settle(chunk: Path) -> None:
        settled.append(chunk.relative_to(tmp_path / "a.zarr").parts[0])

    monkeypatch.setattr("flowlanes.flow.ensembles.zarr_store.flush", settle)
    compute(task(block=35), tmp_path / "a.zarr")
    assert set(settled[:-1]) == set(task().variables)
    assert settled[-1] == "done"


# --- what opening looks at ------------------------------------------------------------------------


@pytest.fixture
def arrays_read(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the arrays of which something is read."""
    names: list[str] = []
    read = zarr.Array.__getitem__

    def watched(array: Any, selection: Any) -> Any:
        names.append(array.basename)
        return read(array, selection)

    monkeypatch.setattr(zarr.Array, "__getitem__", watched)
    return names


def test_a_store_is_opened_without_reading_its_blocks(
    tmp_path: Path, arrays_read: list[str]
) -> None:
    place, log = tmp_path / "a.zarr", tmp_path / "log"
    compute(task(log=str(log)), place)
    arrays_read.clear()
    read_store(place)
    compute(task(log=str(log)), place)
    assert not set(arrays_read) & set(task().variables)
    assert len(log.read_text().split()) == 4


def bend(chunk: Path) -> None:
    """Change one bit of a file."""
    content = bytearray(chunk.read_bytes())
    content[len(content) // 2] ^= 1
    chunk.write_bytes(content)


@pytest.mark.parametrize("damage", ["bit", "cut", "longer"])
@pytest.mark.parametrize("table", ["there", "deleted", "cut"])
def test_a_damaged_chunk_is_computed_again(damage: str, table: str, tmp_path: Path) -> None:
    """Whether the table of the chunks can be read or not."""
    place, log = tmp_path / "a.zarr", tmp_path / "log"
    compute(task(log=str(log)), place)
    chunk = place / "orbit" / "c" / "2" / "0" / "0"
    content = chunk.read_bytes()
    {
        "bit": lambda: bend(chunk),
        "cut": lambda: chunk.write_bytes(content[:-1]),
        "longer": lambda: chunk.write_bytes(content + content[:7]),
    }[damage]()
    if table == "deleted":
        (place / "done" / "chunks").unlink()
    elif table == "cut":
        (place / "done" / "chunks").write_bytes((place / "done" / "chunks").read_bytes()[:13])
    with pytest.raises(InputError, match="of its finished blocks 1 have lost a part"):
        read_store(place)
    same(compute(task()), compute(task(log=str(log)), place))
    assert log.read_text().split()[4:] == ["20"]


def test_a_copy_with_other_times_is_read_once_more(tmp_path: Path, arrays_read: list[str]) -> None:
    compute(task(), tmp_path / "a.zarr")
    shutil.copytree(tmp_path / "a.zarr", tmp_path / "b.zarr", copy_function=shutil.copyfile)
    arrays_read.clear()
    same(compute(task()), read_store(tmp_path / "b.zarr"))
    assert set(arrays_read) >= {"done", "orbit", "mass"}


def test_damage_that_does_not_show_is_an_error_when_it_is_read(tmp_path: Path) -> None:
    """One bit of the disk: size and time of change of the file stay."""
    place = tmp_path / "a.zarr"
    compute(task(), place)
    chunk = place / "orbit" / "c" / "2" / "0" / "0"
    status = chunk.stat()
    bend(chunk)
    os.utime(chunk, ns=(status.st_atime_ns, status.st_mtime_ns))
    dataset = read_store(place)
    with pytest.raises(RuntimeError):
        dataset.orbit.load()


def test_a_table_is_on_the_disk_before_the_mark(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Killed in between, the block is computed again."""
    place, log = tmp_path / "a.zarr", tmp_path / "log"

    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("flowlanes.flow.ensembles.zarr_store.write_chunk_table", stop)
        with pytest.raises(KeyboardInterrupt):
            compute(task(log=str(log)), place)
    assert not zarr.open_group(place)["done"][:].any()
    same(compute(task()), compute(task(log=str(log)), place))
    assert log.read_text().split() == ["0", "0", "10", "20", "30"]


# --- what goes wrong with the store ---------------------------------------------------------------


def stopping_after(blocks: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """A disk that is full when so many blocks of `counted` are written."""
    put = zarr.storage._local._put
    chunks = 0

    def full(path: Path, value: Any, exclusive: bool = False) -> Any:
        nonlocal chunks
        if "orbit/c" in str(path):
            chunks += 1
        if chunks > blocks:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))
        return put(path, value, exclusive=exclusive)

    monkeypatch.setattr(zarr.storage._local, "_put", full)


def test_a_full_disk_keeps_what_was_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stopping_after(2, monkeypatch)
    with pytest.raises(IncompleteError) as told:
        compute(task(), tmp_path / "a.zarr")
    assert str(told.value) == (
        f"{tmp_path / 'a.zarr'}: the disk is full; 2 of 4 blocks are written and stay: remove "
        "the cause, and run the same again"
    )
    monkeypatch.undo()
    same(compute(task()), compute(task(), tmp_path / "a.zarr"))


def test_a_full_disk_at_the_beginning(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stopping_after(-1, monkeypatch)
    with pytest.raises(InputError, match=r"a\.zarr cannot be written: the disk is full$"):
        compute(task(), tmp_path / "a.zarr")
    assert not [*tmp_path.iterdir()]


def test_a_limit_of_the_operating_system(tmp_path: Path) -> None:
    # the real thing: the kernel itself refuses to write more than 20 kB into a file
    wide = Task(counted_rows, 40, 10, {"x": Variable(("place",), (1000,))})
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, hard))
    try:
        with pytest.raises(IncompleteError, match="File too large; 0 of 4 blocks are written"):
            compute(wide, tmp_path / "a.zarr")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    same(compute(wide), compute(wide, tmp_path / "a.zarr"))


def counted_rows(first: int, last: int) -> dict[str, np.ndarray]:
    """Rows that cannot be compressed."""
    return {"x": np.sin(np.outer(np.arange(first, last) + 1.0, np.arange(1.0, 1001.0)) ** 2)}


def refused(told: str, wanted: Task, place: Path) -> None:
    with pytest.raises(InputError) as error:
        compute(wanted, place)
    assert str(error.value) == told


@pytest.mark.parametrize("name", ["folder", "file", "zarr", "broken"])
def test_a_foreign_store_is_left_alone(name: str, tmp_path: Path) -> None:
    place = tmp_path / name
    if name == "file":
        place.write_text("mine")
    elif name == "zarr":
        zarr.create_group(place, attributes={"mine": True}).create_array("x", data=np.ones(3))
    else:
        place.mkdir()
        (place / ("zarr.json" if name == "broken" else "notes")).write_text("mine")
    before = {p: p.read_bytes() for p in [place, *place.rglob("*")] if p.is_file()}
    refused(
        f"{place} is no store of a computation in blocks: choose another name",
        task(),
        place,
    )
    assert before == {p: p.read_bytes() for p in [place, *place.rglob("*")] if p.is_file()}


def test_reading_what_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a\.zarr: there is no such folder$"):
        read_store(tmp_path / "a.zarr")
    with pytest.raises(InputError, match="is no store of a computation in blocks"):
        read_store(tmp_path)


def test_an_empty_folder_will_do(tmp_path: Path) -> None:
    (tmp_path / "a.zarr").mkdir()
    same(compute(task()), compute(task(), tmp_path / "a.zarr"))


def test_a_missing_folder(tmp_path: Path) -> None:
    place = tmp_path / "nowhere" / "a.zarr"
    refused(f"{place} cannot be written: there is no folder {place.parent}", task(), place)


def test_a_place_where_nothing_can_be_written() -> None:
    # a file system in which nobody at all can make a folder
    place = Path("/proc/self/a.zarr")
    with pytest.raises(InputError, match=r"^/proc/self/a\.zarr cannot be written: [^\n]*$"):
        compute(task(), place)


@pytest.mark.parametrize(
    ("changed", "difference"),
    [
        (task(seed=2), "its seed is 1, not 2"),
        (task(size=36), "its size is another one"),
        (
            replace(task(), attributes={"seed": 1, "system": "made up"}),
            "only one of them has a tolerance",
        ),
        (replace(task(), work=counted.Counted(3)), "its seed of the work is another one"),
        (replace(task(), work=counted_rows), "its function of the work is another one"),
        (replace(task(), member="cell"), "its leading axis is another one"),
        (replace(task(), coordinates={}), "its coordinate time is another one"),
    ],
    ids=["seed", "size", "attribute", "work", "function", "axis", "coordinate"],
)
def test_a_store_of_another_experiment(changed: Task, difference: str, tmp_path: Path) -> None:
    place = tmp_path / "a.zarr"
    compute(task(), place)
    with pytest.raises(InputError) as error:
        compute(changed, place)
    assert str(error.value).startswith(f"{place} holds another experiment: ")
    assert difference in str(error.value)
    assert str(error.value).endswith(
        "; choose another name for the store, or remove it (commands: --force)"
    )
    same(compute(task()), compute(task(), place))


def test_a_store_of_another_version(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(IncompleteError):
        stopping_after(2, monkeypatch)
        compute(task(), tmp_path / "a.zarr")
    monkeypatch.undo()
    with monkeypatch.context() as patch:
        patch.setattr("flowlanes.flow.ensembles.zarr_store.computation_digest", lambda: "newer")
        with pytest.raises(InputError, match=r"a\.zarr was begun by another version"):
            compute(task(), tmp_path / "a.zarr")
    whole = compute(task(), tmp_path / "a.zarr")
    # what is complete can be read by any version
    monkeypatch.setattr("flowlanes.flow.ensembles.zarr_store.computation_digest", lambda: "newer")
    same(whole, compute(task(), tmp_path / "a.zarr"))


def test_one_writer_at_a_time(tmp_path: Path) -> None:
    place = tmp_path / "a.zarr"

    def meddle(done: float) -> None:
        if done == 0.5:
            refused(
                f"{place} is being written by another process: wait for it, or choose another name",
                task(),
                place,
            )

    same(compute(task()), compute(task(), place, progress=meddle))


@pytest.mark.slow
def test_two_begin_at_once(tmp_path: Path) -> None:
    store, log = tmp_path / "a.zarr", tmp_path / "log"
    both = [beginning(store, log, 200, 10) for _ in range(2)]
    for process in both:
        go(process)
    outcomes = []
    for process in both:
        with process:
            outcomes.append(process.wait())
    # one may be done before the other asks; but neither spoils what the other writes
    assert 0 in outcomes
    same(compute(task(200, 10)), final(store, log, 200, 10))
    assert len(log.read_text().split()) == 20


# --- what goes wrong with the work ----------------------------------------------------------------


def test_work_that_has_no_name_is_refused(tmp_path: Path) -> None:
    nameless = replace(task(), work=lambda first, last: {})
    with pytest.raises(InputError, match="what it is must show by a name"):
        compute(nameless, tmp_path / "a.zarr")
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize(
    ("variables", "told"),
    [
        ({"y": Variable(("place",), (1000,))}, "the work gave x where y were announced"),
        ({"x": Variable()}, r"gave x with shape \(10, 1000\) and type float64 where \(10,\) and"),
        ({"x": Variable(("place",), (1000,), "float32")}, "and float32 were announced"),
    ],
    ids=["name", "shape", "type"],
)
def test_work_that_gives_something_else(variables: dict[str, Variable], told: str) -> None:
    with pytest.raises(InputError, match=told):
        compute(Task(counted_rows, 40, 10, variables))


@pytest.mark.parametrize("number", [0, 2.5])
@pytest.mark.parametrize("name", ["size", "block"])
def test_no_members_are_refused(name: str, number: Any) -> None:
    told = f"^the {name} is {number}: a whole number, at least 1, is needed$"
    with pytest.raises(InputError, match=told):
        task(**{name: number})
