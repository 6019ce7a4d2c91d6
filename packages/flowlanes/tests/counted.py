"""A piece of work for tests of blocks: cheap, and it leaves a note of what it was asked for."""

from __future__ import annotations

import importlib
import os
import signal
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.flow.ensembles.task import Coordinate, Task, Variable


@dataclass(frozen=True)
class Counted:
    """Numbers of members from their own number and a seed; every block asked for adds a line."""

    seed: int
    log: str = ""
    delay: float = 0.0

    def __call__(self, first: int, last: int) -> dict[str, np.ndarray]:
        if self.log:
            with Path(self.log).open("a") as stream:
                stream.write(f"{first}\n")
        time.sleep(self.delay)
        members = np.arange(first, last)
        orbit = np.sin(np.outer(members + self.seed, np.arange(1.0, 7.0))).reshape(-1, 2, 3)
        orbit[members % 5 == 0] = np.nan
        orbit[members % 7 == 0] = -0.0
        return {
            "orbit": orbit,
            "outcome": (members % 3).astype("int8"),
            "mass": 1.0 + members,
        }


def deadly(first: int, last: int) -> dict[str, np.ndarray]:
    """A block that brings down whoever computes it, and others."""
    if first == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    return {"x": np.arange(first, last, dtype=float)}


def mistaken(first: int, last: int) -> dict[str, np.ndarray]:
    """A user's mistake that is found in a block."""
    raise InputError("the start misses the phase space", f"runs {first} to {last - 1}")


def task(size: int = 35, block: int = 10, seed: int = 1, log: str = "", delay: float = 0) -> Task:
    """An experiment of `Counted`."""
    notes = {"long_name": "a made-up orbit", "units": "1", "source": ""}
    return Task(
        Counted(seed, log, delay),
        size,
        block,
        {
            "orbit": Variable(("time", "axis"), (2, 3), attributes=notes),
            "outcome": Variable(dtype="int8"),
            "mass": Variable(coordinate=True, attributes={"units": "kg"}),
        },
        coordinates={
            "time": Coordinate(("time",), [0.0, 1.0], {"units": "s"}),
            "space": Coordinate(("space",), ["x", "y", "z"]),
        },
        attributes={"system": "made up", "seed": seed, "tolerance": 1e-13},
    )


def begin_when_told() -> None:
    """Compute into a store, for a test that kills this process: only what follows "ready"."""
    importlib.import_module("zarr")
    importlib.import_module("xarray")
    print("ready", flush=True)
    sys.stdin.readline()
    compute(task(int(sys.argv[2]), int(sys.argv[3]), log=sys.argv[4]), sys.argv[1])
