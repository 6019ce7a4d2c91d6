"""Chunk files of a store, and the check that they are unchanged since they were written."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ...system.arrays import BoolArray, IntArray

if TYPE_CHECKING:
    import zarr

    ZarrArray: TypeAlias = zarr.Array[Any]

#: File with the sizes and modification times of all chunks, in the folder of the block marks: one
#: row of pairs of 64-bit integers for each block.
CHUNK_TABLE = Path("done", "chunks")


def chunk_path(folder: Path, name: str, block: int, dimensions: int) -> Path:
    """Path of the chunk that holds one block of an array."""
    return folder.joinpath(name, "c", str(block), *["0"] * (dimensions - 1))


def write_chunk_table(folder: Path, block: int, chunks: Sequence[Path]) -> None:
    """Store the sizes and modification times of the chunks of a block on disk."""
    row = np.array([_status(chunk) for chunk in chunks], dtype="<i8").tobytes()
    table = folder / CHUNK_TABLE
    table.touch()
    with table.open("r+b") as stream:
        stream.seek(block * len(row))
        stream.write(row)
        stream.flush()
        os.fsync(stream.fileno())


def _chunk_table(folder: Path, blocks: int, variables: int) -> IntArray:
    """Sizes and modification times (blocks, variables, 2) of the chunks; zero if not written."""
    table = np.zeros((blocks, variables, 2), dtype="<i8")
    with contextlib.suppress(OSError):
        content = (folder / CHUNK_TABLE).read_bytes()[: table.nbytes]
        rows = len(content) // 8
        table.reshape(-1)[:rows] = np.frombuffer(content[: 8 * rows], dtype="<i8")
    return table


def _status(chunk: Path) -> tuple[int, int]:
    """Size and modification time (ns) of a file; zeros if it does not exist."""
    try:
        status = chunk.stat()
    except (FileNotFoundError, NotADirectoryError):
        return 0, 0
    return status.st_size, status.st_mtime_ns


def flush(chunk: Path) -> None:
    """Wait until a file is physically on disk, so that its mark is written later."""
    # Windows can only flush files opened for writing.
    with chunk.open("r+b") as stream:
        os.fsync(stream.fileno())


def _is_complete(folder: Path, array: ZarrArray, block: int, status: tuple[int, ...]) -> bool:
    """True if the chunk of a block is the one that was written.

    Parameters
    ----------
    folder : Path
    array : zarr.Array
    block : int
    status : (int, int)
        Size and modification time when it was written; a chunk with other values is read and
        checked.
    """
    chunk = chunk_path(folder, array.basename, block, array.ndim)
    present = _status(chunk)
    if present[0] == 0 or present == status:
        return present[0] > 0
    first = block * array.chunks[0]
    try:
        array[first : first + array.chunks[0]]
    except Exception:
        # The library may raise any exception for damaged data.
        return False
    return True


def damaged_blocks(folder: Path, arrays: Sequence[ZarrArray], complete: BoolArray) -> list[int]:
    """Blocks that are marked as complete but have a missing, empty or damaged chunk.

    Parameters
    ----------
    folder : Path
    arrays : sequence of zarr.Array
        The variables of the store, in the order of the table.
    complete : array (blocks,) of bool
        The marks.
    """
    table = _chunk_table(folder, len(complete), len(arrays)).tolist()
    return [
        block
        for block in np.flatnonzero(complete).tolist()
        if not all(
            _is_complete(folder, array, block, tuple(status))
            for array, status in zip(arrays, table[block], strict=True)
        )
    ]
