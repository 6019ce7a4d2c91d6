"""Speed of a graphics processor compared with the processors of the same machine.

Both compute the same motions, sections and charts with the same code, alternately, and the results
are compared bit by bit.  Times are wall-clock times with the copies to the device and back;
medians are printed.
"""

from __future__ import annotations

import argparse
import json
import os
import time
from collections.abc import Callable
from statistics import median
from typing import Any

import numpy as np

import chaplygin as ch
import flowlanes
from chaplygin.experiment.models.experiment import catalogue_experiment
from chaplygin.experiment.scan import chart_of
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from flowlanes.flow.devices.graphics import Device
from flowlanes.scans.grid import axis

BODIES = (("chaplygin-ball", 1.0), ("unbalanced-ball", 2.0), ("marble-body", 12.0))
TOLERANCE, UNTIL, TURNS = 1e-10, 10.0, 3
DEVICES: tuple[Device, ...] = ("cpu", "gpu")


def motions(name: str, energy: float, count: int) -> dict[Device, Callable[[], Any]]:
    """Functions that compute motions of a body over 10 s, by device."""
    body = ch.from_catalogue(name)
    starts = many(flowlanes.sample_level(body, 4096, {"energy": energy}, seed=1), count)
    flows = {d: flowlanes.batch_integrator(body, tolerance=TOLERANCE, device=d) for d in DEVICES}
    return {
        device: lambda flow=flow: flow.propagate(starts, [UNTIL]) for device, flow in flows.items()
    }


def section(count: int) -> dict[Device, Callable[[], Any]]:
    """Functions for ten section points of each motion of the unbalanced ball, by device."""
    body = ch.from_catalogue("unbalanced-ball")
    starts = many(flowlanes.sample_level(body, 4096, {"energy": 2.0}, seed=1), count)
    cut = flowlanes.poincare_section(body, "gamma_3")
    flows = {
        d: flowlanes.batch_integrator(body, tolerance=TOLERANCE, section=cut, device=d)
        for d in DEVICES
    }
    return {
        device: lambda flow=flow: flow.crossings(starts, 10, t_end=100.0)
        for device, flow in flows.items()
    }


def chart(number: str, rows: int) -> dict[Device, Callable[[], Any]]:
    """Functions that compute rows of a chart with 2000 columns, to t = 100, by device."""
    study = Study.from_experiment(catalogue_experiment("unbalanced-ball"))
    x, y = axis("c_1=-0.4:0.4:2000"), axis("c_3=-0.4:0.4:2000")
    charts = {d: chart_of(study, number, x, y, t_end=100.0, device=d) for d in DEVICES}
    return {device: lambda scan=scan: scan(0, rows) for device, scan in charts.items()}


def many(starts: np.ndarray, count: int) -> np.ndarray:
    """Starts, repeated to a given number."""
    return np.tile(starts, (-(-count // len(starts)), 1))[:count]


def same(a: Any, b: Any) -> bool:
    """True if all arrays of two results have the same bits."""
    first, second = (x if isinstance(x, dict) else vars(x) for x in (a, b))
    return all(
        np.array_equal(first[name], value, equal_nan=value.dtype.kind == "f")
        for name, value in second.items()
        if isinstance(value, np.ndarray)
    )


def main() -> None:
    """Print a table, or JSON."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    parser.add_argument("--quick", action="store_true", help="a sixteenth of the motions")
    options = parser.parse_args()
    share = 16 if options.quick else 1
    tasks = {
        f"{name}, to t = 10": (motions(name, e, 2**20 // share), 2**20 // share)
        for name, e in BODIES
    }
    tasks["unbalanced-ball, 10 points of a section"] = section(2**17 // share), 2**17 // share
    for number in ("megno", "lyapunov"):
        rows = 64 // share
        tasks[f"unbalanced-ball, {number} to t = 100"] = chart(number, rows), 2000 * rows
    results = []
    for name, (calls, count) in tasks.items():
        times: dict[Device, list[float]] = {device: [] for device in DEVICES}
        values = {}
        for turn in range(TURNS + 1):
            for device, call in calls.items():
                began = time.perf_counter()
                values[device] = call()
                # the first run compiles
                if turn:
                    times[device].append(time.perf_counter() - began)
        cpu, gpu = (median(times[device]) / count * 1e6 for device in DEVICES)
        equal = same(values["gpu"], values["cpu"])
        results.append(
            {
                "task": name,
                "motions": count,
                "cpu_us": cpu,
                "gpu_us": gpu,
                "ratio": cpu / gpu,
                "same_bits": equal,
            }
        )
    if options.json:
        print(json.dumps(results, indent=1))
        return
    print(f"microseconds a motion; {os.cpu_count()} processors beside the graphics processor")
    for row in results:
        bits = "same bits" if row["same_bits"] else "OTHER BITS"
        print(
            f"{row['task']:40} {row['motions']:8,} motions  {row['cpu_us']:8.3f} "
            f"{row['gpu_us']:8.3f}  {row['ratio']:5.1f} times  {bits}"
        )


if __name__ == "__main__":
    try:
        main()
    except InputError as problem:
        raise SystemExit(f"error: {problem}") from None
