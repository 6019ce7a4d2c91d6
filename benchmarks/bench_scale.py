"""Memory, disk and processor time of large ensembles, written to a store by workers of Dask.

Motions of the unbalanced ball start on a level of the energy and run to t = 10; the last state,
the energy and the outcome are stored.  Each size runs in a process of its own.
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

from chaplygin import ensemble, from_catalogue
from flowlanes.flow.ensembles import random_starts

SIZES = (100_000, 1_000_000, 10_000_000)


def run(size: int, workers: int, block: int | None) -> dict[str, float]:
    """One ensemble; the peaks are those of the writing process and of the largest worker."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "ensemble.zarr"
        began = time.perf_counter()
        data = ensemble(
            from_catalogue("unbalanced-ball"),
            random_starts(size, {"energy": 20.0}, seed=1),
            [10.0],
            record=("energy",),
            tolerance=1e-10,
            block=block,
            store=place,
            client=workers,
        )
        complete = int((data["outcome"] == 0).sum())
        seconds = time.perf_counter() - began
        files = [path for path in place.rglob("*") if path.is_file()]
        stored = sum(path.stat().st_size for path in files)
    own, others = (resource.getrusage(r) for r in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return {
        "motions": size,
        "complete": complete,
        "files": len(files),
        "bytes_per_motion": stored / size,
        "writer_MiB": own.ru_maxrss / 2**10,
        "worker_MiB": others.ru_maxrss / 2**10,
        "writer_us": (own.ru_utime + own.ru_stime) / size * 1e6,
        "workers_us": (others.ru_utime + others.ru_stime) / size * 1e6,
        "seconds": seconds,
    }


def main() -> None:
    """Print a line for each size, or JSON."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--sizes", type=int, nargs="+", default=SIZES, metavar="N")
    parser.add_argument("--workers", type=int, default=2, help="processes of Dask")
    parser.add_argument("--block", type=int, help="motions of a block; default: 4096")
    parser.add_argument("--one", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(run(options.one, options.workers, options.block)))
        return
    rows = []
    for size in options.sizes:
        command = [sys.executable, __file__, "--one", str(size), "--workers", str(options.workers)]
        if options.block:
            command += ["--block", str(options.block)]
        told = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        rows.append(json.loads(told))
        if not options.json:
            print(
                "{motions:>9} motions, {complete} to the end, {files} files, "
                "{bytes_per_motion:.0f} B each; peaks {writer_MiB:.0f} and {worker_MiB:.0f} MiB; "
                "{writer_us:.1f} + {workers_us:.1f} µs each; {seconds:.0f} s".format(**rows[-1]),
                flush=True,
            )
    if options.json:
        print(json.dumps(rows))


if __name__ == "__main__":
    main()
