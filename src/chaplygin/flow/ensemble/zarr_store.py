"""The Zarr store of a computation in blocks: written so that it can be killed at any moment.

A block has a chunk of every variable.  Each chunk appears whole or not at all, and when all of them
are there (and on the disk), the block is marked in the array ``done``, which again appears whole or
not at all.  So a block that is marked is complete, whatever happened; one that is not is computed
again, to the same bits, and so is one whose chunks have been deleted since.  The store as such
appears at once too, under a provisional name first.
"""

from __future__ import annotations

import errno
import fcntl
import os
import shutil
import warnings
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...core.source_digest import computation_digest
from ...errors import InputError
from ...formulas.digest import digest, field_digests
from .task import Arrays, IncompleteError, Task

if TYPE_CHECKING:
    import xarray as xr
    import zarr

__all__ = ["Store", "open_store", "read_store"]

#: The array that says which blocks are complete.
DONE = "done"

#: Written into every store, so that ours are known from others.
FORMAT = "chaplygin blocks 1"


@dataclass
class Store:
    """A store that is being written, by this process alone.

    Parameters
    ----------
    task : Task
        What it is to hold, in the blocks that it has.
    folder : Path
    arrays : mapping of str to zarr.Array
    done : ndarray of bool
        Which blocks are complete.
    """

    task: Task
    folder: Path
    arrays: Mapping[str, zarr.Array[Any]]
    done: np.ndarray = field(repr=False)

    @property
    def missing(self) -> list[int]:
        """The blocks that are not complete."""
        found: list[int] = np.flatnonzero(~self.done).tolist()
        return found

    def write(self, block: int, arrays: Arrays) -> None:
        """Write a block; it counts as done when all of it is on the disk.

        Raises
        ------
        UnfinishedError
            If it cannot be written (a full disk); the store stays as it was before.
        """
        first, last = self.task.members(block)
        try:
            for name, array in arrays.items():
                self.arrays[name][first:last] = array
                _settle(_chunk(self.folder, name, block, array.ndim))
            marked = self.done.copy()
            marked[block] = True
            self.arrays[DONE][:] = marked
            _settle(_chunk(self.folder, DONE, 0, 1))
        except OSError as problem:
            raise self._unfinished(problem) from problem
        self.done = marked

    def _unfinished(self, problem: OSError) -> IncompleteError:
        return IncompleteError(
            f"{self.folder}: {_reason(problem)}; {self.done.sum()} of {self.task.blocks} blocks "
            "are written and stay: put right what is wrong, and run the same again"
        )


def _reason(problem: OSError) -> str:
    return "the disk is full" if problem.errno == errno.ENOSPC else problem.strerror or str(problem)


def _chunk(folder: Path, name: str, block: int, dimensions: int) -> Path:
    """The file that holds an array's share of a block."""
    return folder.joinpath(name, "c", str(block), *["0"] * (dimensions - 1))


def _settle(chunk: Path) -> None:
    """Wait until a chunk is on the disk itself, so that no mark gets there before it."""
    handle = os.open(chunk, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


@contextmanager
def open_store(task: Task, folder: Path) -> Iterator[Store]:
    """The store of a task, begun or gone on with; nobody else may write to it meanwhile.

    The blocks are those in which it was begun.

    Raises
    ------
    InputError
        If it cannot be written, is none of ours, or holds another experiment.
    """
    with ExitStack() as stack:
        try:
            if _nothing_in(folder):
                _begin(task, folder)
            group = _ours(folder)
            stack.enter_context(_alone(folder))
            store = _gone_on_with(task, folder, group)
        except OSError as problem:
            raise InputError(f"{folder} cannot be written: {_reason(problem)}") from problem
        yield store


def read_store(folder: str | Path) -> xr.Dataset:
    """The dataset in a store, read from the disk when it is used.

    What is not computed yet is not-a-number (−1 in whole numbers).

    Raises
    ------
    InputError
        If there is none, it is none of ours, or part of it has been lost.
    """
    import xarray as xr

    place = Path(folder)
    group = _ours(place)
    lost = _lost(place, group, _marks(place, group))
    if lost:
        raise InputError(
            f"{place} is damaged: of its finished blocks {len(lost)} have lost a part, the first "
            f"is {lost[0]}; run the same into it again, and they are computed again"
        )
    try:
        dataset = xr.open_dataset(folder, engine="zarr", chunks=None, decode_times=False)
    except Exception as problem:
        # what damage makes the libraries raise may be anything
        raise InputError(
            f"{place} is damaged: its coordinates cannot be read; delete it or choose another name "
            "for the store, and run the same again"
        ) from problem
    return dataset.drop_vars(DONE)


def _begin(task: Task, folder: Path) -> None:
    """An empty store under a provisional name, then under its own."""
    if not folder.parent.is_dir():
        raise InputError(f"{folder} cannot be written: there is no folder {folder.parent}")
    provisional = folder.with_name(f".{folder.name}.begun")
    with _held(folder.parent, fcntl.LOCK_EX):
        shutil.rmtree(provisional, ignore_errors=True)
        try:
            if _nothing_in(folder):
                _lay_out(task, provisional)
                provisional.replace(folder)
        finally:
            shutil.rmtree(provisional, ignore_errors=True)


def _nothing_in(folder: Path) -> bool:
    return not folder.exists() or (folder.is_dir() and not any(folder.iterdir()))


def _lay_out(task: Task, folder: Path) -> None:
    import zarr
    from zarr.codecs import ZstdCodec

    # so that damage is seen and not read as numbers
    checked = ZstdCodec(checksum=True)
    with warnings.catch_warnings():
        # texts and consolidated metadata are read everywhere, but not in the standard yet
        warnings.simplefilter("ignore")
        coordinates = [name for name, item in task.variables.items() if item.coordinate]
        group = zarr.create_group(
            zarr.storage.LocalStore(folder), zarr_format=3, attributes=dict(task.attributes)
        )
        for name, item in task.coordinates.items():
            values = np.asarray(item.values)
            group.create_array(
                name,
                data=values,
                chunks=values.shape,
                compressors=checked,
                config={"write_empty_chunks": True},
                dimension_names=item.dimensions,
                attributes=dict(item.attributes),
            )
        for name, variable in task.variables.items():
            here = {"coordinates": " ".join(coordinates)} if coordinates else {}
            group.create_array(
                name,
                shape=(task.size, *variable.shape),
                chunks=(min(task.block, task.size), *variable.shape),
                dtype=variable.dtype,
                compressors=checked,
                fill_value=_absent(np.dtype(variable.dtype)),
                dimension_names=(task.member, *variable.dimensions),
                attributes={**variable.attributes, **({} if variable.coordinate else here)},
            )
        group.create_array(
            DONE,
            shape=(task.blocks,),
            chunks=(task.blocks,),
            dtype="bool",
            compressors=checked,
            dimension_names=("block",),
            attributes={
                "long_name": f"whether a block of {task.block} is complete",
                "units": "1",
                "source": "",
                "format": FORMAT,
                "block": task.block,
                "task": _description(task),
                "program": computation_digest(),
            },
        )
        zarr.consolidate_metadata(group.store)


def _absent(dtype: np.dtype[Any]) -> Any:
    """What stands for a number that is not computed yet."""
    return {"f": float("nan"), "i": -1}.get(dtype.kind, 0)


def _description(task: Task) -> dict[str, str]:
    """What tells this experiment from others, by the names of its parts; not its blocks."""
    return {
        **{f"attribute {name}": digest(item) for name, item in task.attributes.items()},
        **{f"{name} of the work": value for name, value in field_digests(task.work).items()},
        "size": str(task.size),
        "leading axis": task.member,
        **{f"variable {name}": digest(item) for name, item in task.variables.items()},
        **{f"coordinate {name}": digest(item) for name, item in task.coordinates.items()},
    }


def _ours(folder: Path) -> zarr.Group:
    """The group in a folder that this module has made."""
    import zarr

    if not folder.exists():
        raise InputError(f"{folder}: there is no such folder")
    try:
        group = zarr.open_group(zarr.storage.LocalStore(folder), mode="r+")
        known = group[DONE].attrs.get("format") == FORMAT
    except OSError as problem:
        if not isinstance(problem, FileExistsError | FileNotFoundError | NotADirectoryError):
            raise
        known = False
    except Exception:
        # what a foreign or damaged folder makes the library raise may be anything
        known = False
    if not known:
        raise InputError(f"{folder} is no store of a computation in blocks: choose another name")
    return group


def _marks(folder: Path, group: Any) -> Any:
    """Which blocks are marked as complete."""
    try:
        return np.asarray(group[DONE][:])
    except Exception as problem:
        raise InputError(
            f"{folder} is damaged: which of its blocks are finished cannot be read; delete it or "
            "choose another name for the store, and run the same again"
        ) from problem


def _lost(folder: Path, group: Any, done: Any) -> list[int]:
    """Blocks that are marked, but of which a chunk is missing, empty or damaged."""
    text = (name.partition("variable ") for name in group[DONE].attrs["task"])
    arrays = [group[name] for before, found, name in text if found and not before]
    return [
        block
        for block in np.flatnonzero(done).tolist()
        if not all(_whole(folder, array, block) for array in arrays)
    ]


def _whole(folder: Path, array: zarr.Array[Any], block: int) -> bool:
    """Whether an array's share of a block is there and can be read, its checksum included."""
    chunk = _chunk(folder, array.basename, block, array.ndim)
    if not chunk.is_file() or chunk.stat().st_size == 0:
        return False
    first = block * array.chunks[0]
    try:
        array[first : first + array.chunks[0]]
    except Exception:
        # what damage makes the library raise may be anything
        return False
    return True


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Write to a store alone."""
    with ExitStack() as stack:
        try:
            stack.enter_context(_held(folder, fcntl.LOCK_EX | fcntl.LOCK_NB))
        except BlockingIOError as problem:
            raise InputError(
                f"{folder} is being written by another process: wait for it"
            ) from problem
        yield


@contextmanager
def _held(folder: Path, how: int) -> Iterator[None]:
    """Hold a folder for this process; the hold ends with the process, however that ends."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        try:
            fcntl.flock(handle, how)
        except BlockingIOError:
            raise
        except OSError:
            # some network file systems know no such hold
            pass
        yield
    finally:
        os.close(handle)


def _gone_on_with(task: Task, folder: Path, group: Any) -> Store:
    """The store with its own blocks, if it belongs to the task."""
    notes = group[DONE].attrs
    there, here = notes["task"], _description(task)
    for name in [*here, *there]:
        if here.get(name) != there.get(name):
            raise InputError(f"{folder} holds another experiment: {_difference(name, task, group)}")
    done = _marks(folder, group)
    done[_lost(folder, group, done)] = False
    if notes.get("program") != computation_digest() and not done.all():
        raise InputError(
            f"{folder} was begun by another version of the program, whose numbers may differ in "
            f"their last digits; {_CHOICE}"
        )
    for leftover in folder.rglob("*.partial"):
        leftover.unlink()
    arrays = {
        name: group[name].with_config({"write_empty_chunks": True})
        for name in (*task.variables, DONE)
    }
    return Store(replace(task, block=notes["block"]), folder, arrays, done)


#: What a user may do about a store that is there.
_CHOICE = "choose another name for the store, or remove it (commands: --force)"


def _difference(name: str, task: Task, group: zarr.Group) -> str:
    """In words what is another one there: with both values if they can be told."""
    _, _, attribute = name.partition("attribute ")
    if not attribute:
        return f"its {name} is another one; {_CHOICE}"
    called = attribute.replace("section_value", "section").replace("_", " ")
    there, here = (str(notes.get(attribute)) for notes in (group.attrs, task.attributes))
    if "\n" in there + here:
        return f"its {called} is another one; {_CHOICE}"
    return f"its {called} is {there}, not {here}; {_CHOICE}"
