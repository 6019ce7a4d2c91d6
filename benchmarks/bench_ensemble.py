"""Memory and time of ensembles of the unbalanced ball for different numbers of motions.

Starts are drawn on a level of the energy, motions run to t = 10 with 101 samples of the state and
the energy, and are written to a store.  Each size runs in a process of its own, directly and with
two processes of Dask.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from chaplygin import ensemble, from_catalogue
from flowlanes.flow.ensembles import random_starts

SIZES = (1_000, 10_000, 100_000)
TIMES = np.linspace(0, 10, 101)


def run(size: int, client: str) -> dict[str, object]:
    """One ensemble in this process; its peak memory is that of the whole process."""
    system = from_catalogue("unbalanced-ball")
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "ensemble.zarr"
        began = time.perf_counter()
        data = ensemble(
            system,
            random_starts(size, {"energy": 20.0}, seed=1),
            TIMES,
            record=("energy",),
            store=place,
            client=client or None,
        )
        seconds = time.perf_counter() - began
        stored = sum(path.stat().st_size for path in place.rglob("*") if path.is_file())
        return {
            "motions": size,
            "on": client or "this process",
            "data_MiB": data.nbytes / 2**20,
            "store_MiB": stored / 2**20,
            "peak_MiB": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**10,
            "seconds": seconds,
        }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--quick", action="store_true", help="the two smaller sizes alone")
    parser.add_argument("--one", nargs=2, metavar=("SIZE", "CLIENT"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(run(int(options.one[0]), options.one[1])))
        return
    rows = []
    for size in SIZES[:2] if options.quick else SIZES:
        for client in ("", "local"):
            command = [sys.executable, __file__, "--one", str(size), client]
            told = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
            rows.append(json.loads(told))
            if not options.json:
                print(
                    "{motions:>8} {on:<13} data {data_MiB:6.0f} MiB, store {store_MiB:6.0f} MiB, "
                    "peak {peak_MiB:5.0f} MiB, {seconds:6.1f} s".format(**rows[-1]),
                    flush=True,
                )
    if options.json:
        print(json.dumps(rows))


if __name__ == "__main__":
    main()
