"""Cost of a random start, and its distance from its level; printed as a Markdown table.

Times are processor times, so other programs on the machine have no effect.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

from chaplygin import from_catalogue
from flowlanes.flow import level_sampler
from flowlanes.formulas.array_evaluation import values

LEVELS = (
    ("chaplygin-ball", {"energy": 1.0}),
    ("chaplygin-ball", {"energy": 1.0, "area": 0.3}),
    ("chaplygin-ball", {"energy": 1.0, "area": 0.3, "momentum": 5.0}),
    ("veselova", {"energy": 1.0, "momentum": 2.6}),
    ("unbalanced-ball", {"energy": 1.0, "quadratic": 2.0}),
    ("rattleback", {"energy": 1.0}),
    ("marble-ball-on-ellipsoid", {"energy": 1.0}),
    ("chaplygin-ball-4d", {"energy": 1.0}),
)


def row(name: str, level: dict[str, float], count: int) -> str:
    """Row for one level: preparation, time of a point, worst residual relative to 1 + |value|."""
    system = from_catalogue(name)
    clock = time.process_time()
    chosen = level_sampler(system, level)
    ready = time.process_time() - clock
    clock = time.process_time()
    states = chosen.draw(count, seed=1)
    each = (time.process_time() - clock) / count
    held = np.array(list(level.values()))
    off = np.abs(values(system, list(level), states) - held) / (1 + np.abs(held))
    relations = np.abs(values(system, system.relations, states)) if system.relations else off
    told = ", ".join(f"{integral} {value:g}" for integral, value in level.items())
    return (
        f"| {name} | {told} | {'invariant' if chosen.invariant else 'surface'} | {ready:.2f} | "
        f"{1e6 * each:.0f} | {max(off.max(), relations.max()):.1e} |"
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=2000)
    count = parser.parse_args().count
    print("| system | held | measure | ready, s | a point, µs | off its level |")
    print("|---|---|---|---|---|---|")
    for name, level in LEVELS:
        print(row(name, level, count), flush=True)


if __name__ == "__main__":
    main()
