"""Time and memory of whole processes of the command line, with cold and warm cache."""

from __future__ import annotations

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

COMMAND = str(Path(sys.executable).with_name("chaplygin"))


def process(arguments: list[str], cache: Path) -> tuple[float, float]:
    """Wall-clock seconds and peak memory in MB of one process."""
    environment = os.environ | {"FLOWLANES_CACHE": str(cache)}
    began = time.perf_counter()
    child = subprocess.Popen(
        [COMMAND, *arguments],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    _, status, usage = os.wait4(child.pid, 0)
    seconds = time.perf_counter() - began
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f"chaplygin {' '.join(arguments)} exited with {child.returncode}")
    return seconds, usage.ru_maxrss / 1024


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("-n", type=int, default=7, help="runs of each command")
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder, cache = Path(name), Path(name) / "cache"
        run = ["run", "unbalanced-ball", "-o", str(folder / "ball.nc"), "--force"]
        jobs = {
            "--help": (["--help"], False),
            "run unbalanced-ball to t = 100, cold cache": (run, True),
            "run unbalanced-ball to t = 100, warm cache": (run, False),
            "study rattleback, warm cache": (
                ["study", "rattleback", "-o", str(folder / "study"), "--force"],
                False,
            ),
        }
        for job, (arguments, cold) in jobs.items():
            process(arguments, cache)
            results = []
            for _ in range(options.n):
                if cold:
                    shutil.rmtree(cache, ignore_errors=True)
                results.append(process(arguments, cache))
            seconds, memory = zip(*results, strict=True)
            rows.append(
                {
                    "command": job,
                    "seconds": statistics.median(seconds),
                    "fastest": min(seconds),
                    "slowest": max(seconds),
                    "megabytes": statistics.median(memory),
                }
            )
    if options.json:
        print(json.dumps(rows, indent=2))
        return
    print(f"{'command':44} {'median s':>9} {'min':>6} {'max':>6} {'MB':>5}")
    for row in rows:
        print(
            f"{row['command']:44} {row['seconds']:9.2f} {row['fastest']:6.2f} "
            f"{row['slowest']:6.2f} {row['megabytes']:5.0f}"
        )


if __name__ == "__main__":
    main()
