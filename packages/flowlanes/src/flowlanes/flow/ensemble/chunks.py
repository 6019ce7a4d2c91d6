"""The chunks of a store: their files, and the check that they are the ones that were written."""

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

#: The table of sizes and times of change of all chunks, in the folder of the marks: a row of pairs
#: of 64-bit numbers for each block.
CHUNK_TABLE = Path("done", "chunks")


def chunk_path(folder: Path, name: str, block: int, dimensions: int) -> Path:
    """The file that holds an array's share of a block."""
    return folder.joinpath(name, "c", str(block), *["0"] * (dimensions - 1))


def write_chunk_table(folder: Path, block: int, chunks: Sequence[Path]) -> None:
    """Write sizes and times of change of the chunks of a block to the disk."""
    row = np.array([_status(chunk) for chunk in chunks], dtype="<i8").tobytes()
    table = folder / CHUNK_TABLE
    table.touch()
    with table.open("r+b") as stream:
        stream.seek(block * len(row))
        stream.write(row)
        stream.flush()
        os.fsync(stream.fileno())


def _chunk_table(folder: Path, blocks: int, variables: int) -> IntArray:
    """Sizes and times of change (blocks, variables, 2) of chunks; zero if unwritten."""
    table = np.zeros((blocks, variables, 2), dtype="<i8")
    with contextlib.suppress(OSError):
        content = (folder / CHUNK_TABLE).read_bytes()[: table.nbytes]
        rows = len(content) // 8
        table.reshape(-1)[:rows] = np.frombuffer(content[: 8 * rows], dtype="<i8")
    return table


def _status(chunk: Path) -> tuple[int, int]:
    """Size and time of change (ns) of a file; zeros if there is none."""
    try:
        status = chunk.stat()
    except (FileNotFoundError, NotADirectoryError):
        return 0, 0
    return status.st_size, status.st_mtime_ns


def flush(chunk: Path) -> None:
    """Wait until a file is on the disk itself, so that no mark gets there before it."""
    # Windows flushes only what it may write to
    with chunk.open("r+b") as stream:
        os.fsync(stream.fileno())


def _is_complete(folder: Path, array: ZarrArray, block: int, status: tuple[int, ...]) -> bool:
    """Whether an array's chunk of a block is the one that was written.

    Parameters
    ----------
    folder : Path
    array : zarr.Array
    block : int
    status : (int, int)
        Size and time of change when it was written; a chunk with others is read.
    """
    chunk = chunk_path(folder, array.basename, block, array.ndim)
    present = _status(chunk)
    if present[0] == 0 or present == status:
        return present[0] > 0
    first = block * array.chunks[0]
    try:
        array[first : first + array.chunks[0]]
    except Exception:
        # damage may make the library raise anything
        return False
    return True


def damaged_blocks(folder: Path, arrays: Sequence[ZarrArray], complete: BoolArray) -> list[int]:
    """Blocks that are marked, but of which a chunk is missing, empty or damaged.

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
