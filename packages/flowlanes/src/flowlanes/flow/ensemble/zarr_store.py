"""The Zarr store of a computation in blocks: written so that it can be killed at any moment.

A block has a chunk of every variable.  Each chunk appears whole or not at all.  When all of them
are on the disk, their sizes and times of change are written into a table, and when that is on the
disk too, the block is marked in the array ``done``, which again appears whole or not at all.  So a
block that is marked is complete, whatever happened; one that is not is computed again, to the same
bits.

Chunks may be deleted or damaged later.  On opening, a chunk whose size and time of change are those
in the table is the one that was written.  Any other one (in a copy of the store, after damage) is
read with its checksum, and a block with a chunk that is missing or damaged is computed again.  So
an ordinary opening lists the files of the store but reads none of its data.  The store as such
appears at once too, under a provisional name first.
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

#: The array of the marks of complete blocks.
MARKS = "done"

#: An attribute of every store, by which other stores are recognised.
FORMAT = "chaplygin blocks 1"


@dataclass
class Store:
    """A store that is being written, by this process alone.

    Parameters
    ----------
    task : Task
        The computation whose result it holds, in the blocks of the store.
    folder : Path
    arrays : mapping of str to zarr.Array
    complete : ndarray of bool
        Which blocks are complete.
    """

    task: Task
    folder: Path
    arrays: Mapping[str, ZarrArray]
    complete: BoolArray = field(repr=False)

    @property
    def missing(self) -> list[int]:
        """The blocks that are not complete."""
        blocks: list[int] = np.flatnonzero(~self.complete).tolist()
        return blocks

    def write(self, block: int, arrays: Arrays) -> None:
        """Write a block; it counts as done when all of it is on the disk.

        Raises
        ------
        IncompleteError
            If it cannot be written (a full disk); the store stays as it was before.
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
            "blocks are written and stay: put right what is wrong, and run the same again"
        )


def _reason(problem: OSError) -> str:
    return "the disk is full" if problem.errno == errno.ENOSPC else problem.strerror or str(problem)


@contextmanager
def open_store(task: Task, folder: Path) -> Iterator[Store]:
    """The store of a task, created or resumed; nobody else may write to it meanwhile.

    The blocks are those in which it was created.

    Raises
    ------
    InputError
        If it cannot be written, is none of ours, or holds another experiment.
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
    """Remove a store that nobody is writing.

    Raises
    ------
    InputError
        If it is none of ours, or is being written.
    """
    with write_lock(folder):
        read_store(folder).close()
        shutil.rmtree(folder)


def read_store(folder: str | Path) -> xr.Dataset:
    """The dataset in a store, read from the disk when it is used.

    Numbers that are not computed yet are not-a-number (−1 if they are whole numbers).

    Raises
    ------
    InputError
        If there is none, it is none of ours, or part of it has been lost.
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
        # damage may make the libraries raise anything
        raise InputError(
            f"{path} is damaged: its coordinates cannot be read; delete it or choose another name "
            "for the store, and run the same again"
        ) from problem
    return dataset.drop_vars(MARKS)


def _create(task: Task, folder: Path) -> None:
    """An empty store under a provisional name, then under its own."""
    if not folder.parent.is_dir():
        raise InputError(f"{folder} cannot be written: there is no folder {folder.parent}")
    with partial_folder(folder.parent) as provisional:
        _write_layout(task, provisional)
        try:
            provisional.replace(folder)
        except OSError:
            # another process may have been as far at the same moment
            if _is_empty(folder):
                raise


def _is_empty(folder: Path) -> bool:
    return not folder.exists() or (folder.is_dir() and not any(folder.iterdir()))


def _write_layout(task: Task, folder: Path) -> None:
    """Write the metadata and the coordinates of an empty store."""
    import zarr
    from zarr.codecs import ZstdCodec

    # with it damage is an error and no number
    compressor = ZstdCodec(checksum=True)
    with warnings.catch_warnings():
        # texts and consolidated metadata are widely read, but not in the standard yet
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
    """Attributes as Zarr takes them: numbers, texts, lists."""
    return dict(notes)


def _fill_value(dtype: np.dtype[np.generic]) -> float:
    """The number in place of one that is not computed yet."""
    return {"f": float("nan"), "i": -1}.get(dtype.kind, 0)


def _description(task: Task) -> dict[str, str]:
    """Digests of all that distinguishes this experiment from others, save its blocks."""
    return {
        **{f"attribute {name}": digest(item) for name, item in task.attributes.items()},
        **{f"{name} of the work": value for name, value in field_digests(task.work).items()},
        "size": str(task.size),
        "leading axis": task.member,
        **{f"variable {name}": digest(item) for name, item in task.variables.items()},
        **{f"coordinate {name}": digest(item) for name, item in task.coordinates.items()},
    }


def _group(folder: Path) -> zarr.Group:
    """The group in a folder, if this module has written it."""
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
        # a foreign or damaged folder may make the library raise anything
        known = False
    if not known:
        raise InputError(f"{folder} is no store of a computation in blocks: choose another name")
    return group


def _array(group: zarr.Group, name: str) -> ZarrArray:
    """An array of a group."""
    array: ZarrArray = group[name]  # type: ignore[assignment]
    return array


def _variables(group: zarr.Group) -> list[ZarrArray]:
    """The arrays of the variables of the task, in its order."""
    texts = (name.partition("variable ") for name in _notes(group)["task"])
    return [_array(group, name) for before, prefix, name in texts if prefix and not before]


def _marks(folder: Path, group: zarr.Group) -> BoolArray:
    """The marks (blocks,) of complete blocks."""
    try:
        return np.asarray(_array(group, MARKS)[:], dtype=bool)
    except Exception as problem:
        raise InputError(
            f"{folder} is damaged: which of its blocks are finished cannot be read; delete it or "
            "choose another name for the store, and run the same again"
        ) from problem


def _notes(group: zarr.Group) -> Mapping[str, Any]:
    """The attributes of the marks: format, blocks, task and program of a store."""
    return group[MARKS].attrs


def _resumed_store(task: Task, folder: Path, group: zarr.Group) -> Store:
    """The store with its own blocks, if it belongs to the task."""
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


#: The choices of a user whose store exists already.
_CHOICE = "choose another name for the store, or remove it (commands: --force)"


def _difference(name: str, task: Task, group: zarr.Group) -> str:
    """The difference between two experiments in words, with both values if possible."""
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
