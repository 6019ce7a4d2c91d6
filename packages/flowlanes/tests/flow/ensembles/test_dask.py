"""Blocks computed by Dask workers: the same bits, whatever happens to the workers."""

from __future__ import annotations

import logging
import os
import random
import signal
import sys
import time
import types
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from counted import deadly, mistaken, task
from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.flow.ensembles.task import IncompleteError, Task, Variable
from needs import optional

dask, distributed = optional("dask"), optional("distributed")


@pytest.fixture(scope="module")
def cluster() -> Iterator[distributed.LocalCluster]:
    with (
        dask.config.set({"distributed.deploy.lost-worker-timeout": "1 day"}),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=":0", silence_logs=logging.CRITICAL
        ) as made,
    ):
        yield made


@pytest.fixture(scope="module")
def client(cluster: distributed.LocalCluster) -> Iterator[distributed.Client]:
    with distributed.Client(cluster) as made:
        yield made


def test_the_same_bits_as_here(client: distributed.Client, tmp_path: Path) -> None:
    here = compute(task())
    for block in (3, 10):
        xr.testing.assert_identical(here, compute(task(block=block), client=client))
    stored = compute(task(), tmp_path / "a.zarr", client=client)
    assert here.orbit.to_numpy().tobytes() == stored.orbit.to_numpy().tobytes()


def test_a_scheduler_by_its_address(cluster: distributed.LocalCluster) -> None:
    xr.testing.assert_identical(compute(task()), compute(task(), client=cluster.scheduler_address))


@pytest.mark.slow
def test_processes_of_this_machine(tmp_path: Path) -> None:
    here = compute(task(), tmp_path / "a.zarr")
    xr.testing.assert_identical(here.load(), compute(task(), client=1))
    # nobody is called when there is nothing left to compute
    assert compute(task(), tmp_path / "a.zarr", client="nobody").identical(here)


def test_begun_on_a_cluster_and_ended_here(client: distributed.Client, tmp_path: Path) -> None:
    def stop(done: float) -> None:
        if done > 0.3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        compute(task(block=5), tmp_path / "a.zarr", client=client, progress=stop)
    xr.testing.assert_identical(compute(task()), compute(task(), tmp_path / "a.zarr").load())


def survives_kills(
    kills: int, blocks: int, seed: int, cluster: distributed.LocalCluster, folder: Path
) -> None:
    """Kill workers at random moments; compare with a computation in this process."""
    chance = random.Random(seed)
    moments = set(chance.sample(range(1, blocks - 2), kills))
    killed: list[int] = []
    log = folder / "log"

    def kill(done: float) -> None:
        if round(done * blocks) in moments:
            time.sleep(chance.uniform(0, 0.04))
            pids = [nanny.pid for nanny in cluster.workers.values() if nanny.pid]
            while not pids:
                time.sleep(0.05)
                pids = [nanny.pid for nanny in cluster.workers.values() if nanny.pid]
            killed.append(chance.choice(pids))
            os.kill(killed[-1], signal.SIGKILL)

    experiment = task(blocks, 1, log=str(log), delay=0.03)
    with distributed.Client(cluster) as client:
        found = compute(experiment, folder / "a.zarr", client=client, progress=kill)
    assert len(killed) == kills
    wanted = compute(task(blocks, 7))
    assert found.orbit.to_numpy().tobytes() == wanted.orbit.to_numpy().tobytes()
    # a worker costs the block it is at, and those it has not handed over yet
    assert blocks <= len(log.read_text().split()) <= blocks + 3 * kills


@pytest.mark.slow
def test_workers_killed(cluster: distributed.LocalCluster, tmp_path: Path) -> None:
    survives_kills(2, 40, 1, cluster, tmp_path)


@pytest.mark.slow
def test_workers_killed_twenty_times(cluster: distributed.LocalCluster, tmp_path: Path) -> None:
    survives_kills(20, 300, 2, cluster, tmp_path)


@pytest.mark.slow
def test_a_block_that_brings_down_its_workers(
    cluster: distributed.LocalCluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster.scheduler, "allowed_failures", 0)
    experiment = Task(deadly, 6, 2, {"x": Variable()})
    with (
        distributed.Client(cluster) as client,
        pytest.raises(IncompleteError, match="members 2 to 3 brought down one worker after"),
    ):
        compute(experiment, tmp_path / "a.zarr", client=client)


def test_a_mistake_comes_back_as_it_is(client: distributed.Client) -> None:
    with pytest.raises(InputError, match=r"^runs \d+ to \d+: the start misses the phase space$"):
        compute(replace(task(), work=mistaken), client=client)


def test_workers_without_the_package(
    client: distributed.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    unknown = types.ModuleType("unknown")
    exec("def work(first, last): return {}", vars(unknown))
    monkeypatch.setitem(sys.modules, "unknown", unknown)
    with pytest.raises(InputError, match=r"^the Dask workers cannot import unknown: install"):
        compute(replace(task(), work=vars(unknown)["work"]), client=client)


@pytest.mark.slow
@pytest.mark.parametrize("address", ["nonsense", "tcp://127.0.0.1:1"])
def test_no_scheduler(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("flowlanes.flow.ensembles.dask.CONNECTION_TIMEOUT", "0.2s")
    with pytest.raises(InputError, match=f"^there is no Dask scheduler at '{address}'"):
        compute(task(), client=address)


@pytest.mark.slow
@pytest.mark.parametrize("client", [0, -1, 2.5, False, np.int64(0), ["local"]], ids=repr)
def test_no_cluster(client: Any) -> None:
    with pytest.raises(InputError) as caught:
        compute(task(), client=client)
    assert str(caught.value) == (
        f"there is no cluster {client!r}: a Dask client, an address such as 'tcp://host:8786', "
        "'local' or a number of processes from 1 on is needed"
    )


@pytest.mark.slow
def test_dask_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(InputError, match=r"needs Dask: pip install cloudpickle dask distributed$"):
        compute(task(), client="local")
