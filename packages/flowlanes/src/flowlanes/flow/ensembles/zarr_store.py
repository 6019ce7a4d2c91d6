"""Zarr store of a computation in blocks, which may be killed at any moment.

A block has one chunk of every variable.  Each chunk is written atomically.  Once all of them are
on disk, their sizes and modification times are written to a table, and once the table is on disk,
the block is marked in the array ``done``, again atomically.  So a marked block is complete in any
case; an unmarked block is computed again, to the same bits.

Chunks may be deleted or damaged later.  When a store is opened, a chunk whose size and
modification time agree with the table is accepted.  Any other chunk (in a copy of the store, or
after damage) is read with its checksum, and a block with a missing or damaged chunk is computed
again.  So an unchanged store is opened without reading its data.  The store itself is also created
atomically, under a temporary name first.
"""

from __future__ import annotations

import errno
import shutil
import warnings
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ...errors import InputError
from ...files.partial_files import partial_folder, write_lock
from ...files.source_digest import computation_digest
from ...formulas.digest import digest, field_digests
from ...system.arrays import BoolArray
from .chunks import chunk_path, damaged_blocks, flush, write_chunk_table
from .task import Arrays, IncompleteError, Task

if TYPE_CHECKING:
    import xarray as xr
    import zarr

    ZarrArray: TypeAlias = zarr.Array[Any]

#: Name of the array that marks complete blocks.
MARKS = "done"

#: Attribute that identifies the stores written by this module.
FORMAT = "flowlanes blocks 1"


@dataclass
class Store:
    """Store that is being written by this process.

    Parameters
    ----------
    task : Task
        Computation of the result, with the block size of the store.
    folder : Path
    arrays : mapping of str to zarr.Array
    complete : ndarray of bool
        True for complete blocks.
    """

    task: Task
    folder: Path
    arrays: Mapping[str, ZarrArray]
    complete: BoolArray = field(repr=False)

    @property
    def missing(self) -> list[int]:
        """Indices of the incomplete blocks."""
        blocks: list[int] = np.flatnonzero(~self.complete).tolist()
        return blocks

    def write(self, block: int, arrays: Arrays) -> None:
        """Write a block and mark it when it is completely on disk.

        Raises
        ------
        IncompleteError
            If it cannot be written, for example to a full disk; the store is then unchanged.
        """
        first, last = self.task.members(block)
        try:
            for name, array in arrays.items():
                self.arrays[name][first:last] = array
                flush(chunk_path(self.folder, name, block, array.ndim))
            chunks = [
                chunk_path(self.folder, name, block, array.ndim)
                for name, array in self.arrays.items()
                if name != MARKS
            ]
            write_chunk_table(self.folder, block, chunks)
            marked = self.complete.copy()
            marked[block] = True
            self.arrays[MARKS][:] = marked
            flush(chunk_path(self.folder, MARKS, 0, 1))
        except OSError as problem:
            raise self._incomplete_error(problem) from problem
        self.complete = marked

    def _incomplete_error(self, problem: OSError) -> IncompleteError:
        return IncompleteError(
            f"{self.folder}: {_reason(problem)}; {self.complete.sum()} of {self.task.blocks} "
            "blocks are written and stay: remove the cause, and run the same again"
        )


def _reason(problem: OSError) -> str:
    return "the disk is full" if problem.errno == errno.ENOSPC else problem.strerror or str(problem)


@contextmanager
def open_store(task: Task, folder: Path) -> Iterator[Store]:
    """Create or resume the store of a task, to which no other process may write meanwhile.

    An existing store keeps its block size.

    Raises
    ------
    InputError
        If it cannot be written, is not a store of this program, or holds another experiment.
    """
    with ExitStack() as stack:
        try:
            if _is_empty(folder):
                _create(task, folder)
            group = _group(folder)
            stack.enter_context(write_lock(folder))
            store = _resumed_store(task, folder, group)
        except OSError as problem:
            raise InputError(f"{folder} cannot be written: {_reason(problem)}") from problem
        yield store


def remove_store(folder: Path) -> None:
    """Delete a store that no process is writing to.

    Raises
    ------
    InputError
        If it is not a store of this program, or is being written.
    """
    with write_lock(folder):
        read_store(folder).close()
        shutil.rmtree(folder)


def read_store(folder: str | Path) -> xr.Dataset:
    """Open the dataset in a store; data are read from disk on demand.

    Values not yet computed are NaN (−1 for integers).

    Raises
    ------
    InputError
        If it does not exist, is not a store of this program, or part of it is missing.
    """
    import xarray as xr

    path = Path(folder)
    group = _group(path)
    damaged = damaged_blocks(path, _variables(group), _marks(path, group))
    if damaged:
        raise InputError(
            f"{path} is damaged: of its finished blocks {len(damaged)} have lost a part, the first "
            f"is {damaged[0]}; run the same into it again, and they are computed again"
        )
    try:
        dataset = xr.open_dataset(folder, engine="zarr", chunks=None, decode_times=False)
    except Exception as problem:
        # The libraries may raise any exception for damaged data.
        raise InputError(
            f"{path} is damaged: its coordinates cannot be read; delete it or choose another name "
            "for the store, and run the same again"
        ) from problem
    return dataset.drop_vars(MARKS)


def _create(task: Task, folder: Path) -> None:
    """Create an empty store under a temporary name, then rename it."""
    if not folder.parent.is_dir():
        raise InputError(f"{folder} cannot be written: there is no folder {folder.parent}")
    with partial_folder(folder.parent) as provisional:
        _write_layout(task, provisional)
        try:
            provisional.replace(folder)
        except OSError:
            # Another process may have created the store at the same moment.
            if _is_empty(folder):
                raise


def _is_empty(folder: Path) -> bool:
    return not folder.exists() or (folder.is_dir() and not any(folder.iterdir()))


def _write_layout(task: Task, folder: Path) -> None:
    """Write the metadata and the coordinates of an empty store."""
    import zarr
    from zarr.codecs import ZstdCodec

    # With a checksum, damaged data raise an error instead of giving wrong numbers.
    compressor = ZstdCodec(checksum=True)
    with warnings.catch_warnings():
        # Strings and consolidated metadata are widely supported, but are not yet part of the
        # standard.
        warnings.simplefilter("ignore")
        coordinates = [name for name, item in task.variables.items() if item.coordinate]
        group = zarr.create_group(
            zarr.storage.LocalStore(folder), zarr_format=3, attributes=_attributes(task.attributes)
        )
        for name, item in task.coordinates.items():
            values = np.asarray(item.values)
            group.create_array(
                name,
                data=values,
                chunks=values.shape,
                compressors=compressor,
                config={"write_empty_chunks": True},
                dimension_names=item.dimensions,
                attributes=_attributes(item.attributes),
            )
        for name, variable in task.variables.items():
            own = {"coordinates": " ".join(coordinates)} if coordinates else {}
            group.create_array(
                name,
                shape=(task.size, *variable.shape),
                chunks=(min(task.block, task.size), *variable.shape),
                dtype=variable.dtype,
                compressors=compressor,
                fill_value=_fill_value(np.dtype(variable.dtype)),
                dimension_names=(task.member, *variable.dimensions),
                attributes=_attributes(variable.attributes) | ({} if variable.coordinate else own),
            )
        group.create_array(
            MARKS,
            shape=(task.blocks,),
            chunks=(task.blocks,),
            dtype="bool",
            compressors=compressor,
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


def _attributes(notes: Mapping[str, object]) -> dict[str, Any]:
    """Attributes in the types that Zarr supports: numbers, strings, lists."""
    return dict(notes)


def _fill_value(dtype: np.dtype[np.generic]) -> float:
    """Placeholder for numbers that are not yet computed."""
    return {"f": float("nan"), "i": -1}.get(dtype.kind, 0)


def _description(task: Task) -> dict[str, str]:
    """Digests of everything that distinguishes this experiment from others, except its blocks."""
    return {
        **{f"attribute {name}": digest(item) for name, item in task.attributes.items()},
        **{f"{name} of the work": value for name, value in field_digests(task.work).items()},
        "size": str(task.size),
        "leading axis": task.member,
        **{f"variable {name}": digest(item) for name, item in task.variables.items()},
        **{f"coordinate {name}": digest(item) for name, item in task.coordinates.items()},
    }


def _group(folder: Path) -> zarr.Group:
    """Group in a folder, if it was written by this module."""
    import zarr

    if not folder.exists():
        raise InputError(f"{folder}: there is no such folder")
    try:
        group = zarr.open_group(zarr.storage.LocalStore(folder), mode="r+")
        known = group[MARKS].attrs.get("format") == FORMAT
    except OSError as problem:
        if not isinstance(problem, FileExistsError | FileNotFoundError | NotADirectoryError):
            raise
        known = False
    except Exception:
        # The library may raise any exception for a foreign or damaged folder.
        known = False
    if not known:
        raise InputError(f"{folder} is no store of a computation in blocks: choose another name")
    return group


def _array(group: zarr.Group, name: str) -> ZarrArray:
    """Array of a group."""
    array: ZarrArray = group[name]  # type: ignore[assignment]
    return array


def _variables(group: zarr.Group) -> list[ZarrArray]:
    """Arrays of the variables of the task, in order."""
    texts = (name.partition("variable ") for name in _notes(group)["task"])
    return [_array(group, name) for before, prefix, name in texts if prefix and not before]


def _marks(folder: Path, group: zarr.Group) -> BoolArray:
    """Marks (blocks,) of complete blocks."""
    try:
        return np.asarray(_array(group, MARKS)[:], dtype=bool)
    except Exception as problem:
        raise InputError(
            f"{folder} is damaged: which of its blocks are finished cannot be read; delete it or "
            "choose another name for the store, and run the same again"
        ) from problem


def _notes(group: zarr.Group) -> Mapping[str, Any]:
    """Attributes of the marks: format, block size, task and version of a store."""
    return group[MARKS].attrs


def _resumed_store(task: Task, folder: Path, group: zarr.Group) -> Store:
    """Existing store with its own block size, if it belongs to the task."""
    notes = _notes(group)
    stored, wanted = notes["task"], _description(task)
    for name in [*wanted, *stored]:
        if wanted.get(name) != stored.get(name):
            raise InputError(f"{folder} holds another experiment: {_difference(name, task, group)}")
    done = _marks(folder, group)
    done[damaged_blocks(folder, _variables(group), done)] = False
    if notes.get("program") != computation_digest() and not done.all():
        raise InputError(
            f"{folder} was begun by another version of the program, whose numbers may differ in "
            f"their last digits; {_CHOICE}"
        )
    for leftover in folder.rglob("*.partial"):
        leftover.unlink()
    arrays = {
        name: _array(group, name).with_config({"write_empty_chunks": True})
        for name in (*task.variables, MARKS)
    }
    return Store(replace(task, block=notes["block"]), folder, arrays, done)


#: Possible actions of a user if the store already exists.
_CHOICE = "choose another name for the store, or remove it (commands: --force)"


def _difference(name: str, task: Task, group: zarr.Group) -> str:
    """Description of the difference between two experiments, with both values if possible."""
    _, _, attribute = name.partition("attribute ")
    if not attribute:
        return f"its {name} is another one; {_CHOICE}"
    called = attribute.replace("section_value", "section").replace("_", " ")
    stored, wanted = str(group.attrs.get(attribute)), str(task.attributes.get(attribute))
    if attribute not in group.attrs or attribute not in task.attributes:
        return f"it is of another kind, as only one of them has a {called}; {_CHOICE}"
    if "\n" in stored + wanted:
        return f"its {called} is another one; {_CHOICE}"
    return f"its {called} is {stored}, not {wanted}; {_CHOICE}"
