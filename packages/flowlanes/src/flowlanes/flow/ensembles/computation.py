"""Execution of a task block by block: in memory or into a Zarr store, locally or with Dask."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...arguments import arguments_checked
from ..cost import Pace, require_room
from .dask import results
from .task import Arrays, Progress, Task
from .zarr_store import open_store, read_store

if TYPE_CHECKING:
    import xarray as xr
    from distributed import Client


@arguments_checked
def compute(
    task: Task,
    store: str | Path | None = None,
    *,
    client: Client | str | int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Result of a task, computed block by block.

    Parameters
    ----------
    task : Task
    store : path, optional
        Folder of the Zarr store for the result, usually called ``….zarr``.  It is created, or
        resumed if it exists.  Without it the result is kept in memory.
    client : dask.distributed.Client, str or int, optional
        Cluster for the computation: a Dask client, the address of a scheduler
        (``"tcp://host:8786"``), a number of processes of this machine, or ``"local"`` for one
        process per processor.  By default the computation is done in this process.
    progress : callable, optional
        Function that is called with the completed fraction.

    Returns
    -------
    xarray.Dataset
        In memory; with a store, its values are read from disk when they are used.

    Raises
    ------
    InputError
        If the store cannot be written, is not a store of this program or holds another experiment,
        or if the cluster cannot be reached.
    IncompleteError
        If the disk is full, or a block terminates the workers; the blocks already written are
        kept.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> damping = flowlanes.Parameter(k, "damping", 0.1)
    >>> field = {x: v, v: -sp.sin(x) - k * v}
    >>> pendulum = flowlanes.System("pendulum", "Damped pendulum", field, (damping,))
    >>> axes = flowlanes.scans.axis("k=0:1:3"), flowlanes.scans.axis("v=0.5:1:2")
    >>> grid = flowlanes.scans.scan_grid(pendulum, *axes, {"x": 0.5, "v": 0.0})
    >>> rule = flowlanes.scans.survival_time(pendulum, 5.0)
    >>> task = flowlanes.scans.scan(flowlanes.scans.Scan(grid, rule, "survival", "Survival time"))
    >>> flowlanes.flow.ensembles.compute(task)["survival"].values.tolist()
    [[5.0, 5.0, 5.0], [5.0, 5.0, 5.0]]
    """
    text = progress if progress is not None else _no_progress
    _require_room(task, store)
    return _in_memory(task, client, text) if store is None else _in_store(task, store, client, text)


def _require_room(task: Task, store: str | Path | None) -> None:
    """Raise an error if the result does not fit into memory or on the disk."""
    sizes = [
        (task.size * math.prod(variable.shape), np.dtype(variable.dtype).itemsize)
        for variable in task.variables.values()
    ]
    folder = None if store is None else Path(store)
    if folder is None or not folder.exists():
        what = f"the {sum(count for count, _ in sizes):,} numbers of the result"
        require_room(sum(count * size for count, size in sizes), folder, what)


def _no_progress(share: float) -> None:
    """Ignore progress reports."""


def _results(
    task: Task, blocks: Sequence[int], client: Client | str | int | None, progress: Progress
) -> Iterator[tuple[int, Arrays]]:
    """Requested blocks with their numbers, as they become ready."""
    progress(1 - len(blocks) / task.blocks)
    pace = Pace()
    if client is None:
        pairs: Iterator[tuple[int, Arrays]] = (
            (block, task.work(*task.members(block))) for block in blocks
        )
    else:
        pairs = results(client, task.work, {block: task.members(block) for block in blocks})
    for count, (block, arrays) in enumerate(pairs, 1):
        yield block, task.require_arrays(arrays, *task.members(block))
        pace.check(count / len(blocks), f"{task.size:,} {task.member}s")
        progress(1 - (len(blocks) - count) / task.blocks)


def _in_memory(task: Task, client: Client | str | int | None, progress: Progress) -> xr.Dataset:
    import xarray as xr

    whole = {
        name: np.empty((task.size, *variable.shape), variable.dtype)
        for name, variable in task.variables.items()
    }
    for block, arrays in _results(task, range(task.blocks), client, progress):
        for name, array in arrays.items():
            whole[name][slice(*task.members(block))] = array
    placed = {
        name: xr.Variable((task.member, *variable.dimensions), whole[name], variable.attributes)
        for name, variable in task.variables.items()
    }
    known = {
        name: xr.Variable(item.dimensions, item.values, item.attributes)
        for name, item in task.coordinates.items()
    }
    of_members = [name for name, variable in task.variables.items() if variable.coordinate]
    return xr.Dataset(placed, known, task.attributes).set_coords(of_members)


def _in_store(
    task: Task, where: str | Path, client: Client | str | int | None, progress: Progress
) -> xr.Dataset:
    with open_store(task, Path(where)) as store:
        for block, arrays in _results(store.task, store.missing, client, progress):
            store.write(block, arrays)
    return read_store(where)
