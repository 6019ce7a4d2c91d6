"""Ensembles with different instruction sets: the same motions and bits as on older processors."""

from __future__ import annotations

import argparse
import json
import statistics
import time
from typing import Any

import numpy as np

import chaplygin as ch
import flowlanes
from flowlanes.flow.machine_code import jit

#: Instruction sets that are disabled, by their LLVM names.
SETS: dict[str, tuple[str, ...]] = {
    "AVX-512": (),
    "AVX2": ("avx512", "avx10"),
    "SSE4, no fused operations": ("avx", "f16c", "fma", "vaes", "vpclmul", "xop"),
}
BODIES = (("chaplygin-ball", 1.0), ("unbalanced-ball", 2.0), ("marble-body", 12.0))
MOTIONS, UNTIL, TURNS = 512, 10.0, 5


def flow_with(system: ch.System, left_out: tuple[str, ...]) -> Any:
    """Integrator of a system without some instruction sets."""
    whole, sets = jit.host, jit.instruction_sets(*left_out)
    jit.host = lambda: sets  # type: ignore[assignment]
    try:
        # past the memory of what has been compiled for this processor
        return flowlanes.batch_integrator.__wrapped__(system, tolerance=1e-10), sets.width
    finally:
        jit.host = whole


def main() -> None:
    """Print a table, or JSON."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    rows = []
    as_json = parser.parse_args().json
    for name, energy in BODIES:
        system = ch.from_catalogue(name)
        starts = flowlanes.sample_level(system, MOTIONS, {"energy": energy}, seed=1)
        flows = {words: flow_with(system, left_out) for words, left_out in SETS.items()}
        times: dict[str, list[float]] = {words: [] for words in SETS}
        states = {}
        for _ in range(TURNS):
            for words, (flow, _) in flows.items():
                began = time.process_time()
                states[words] = flow.propagate(starts, [UNTIL], threads=1).states
                times[words].append(time.process_time() - began)
        first = next(iter(states.values()))
        for words, (_, width) in flows.items():
            micro = statistics.median(times[words]) / MOTIONS * 1e6
            same = bool(np.array_equal(states[words], first, equal_nan=True))
            rows.append({"body": name, "sets": words, "width": width, "us": micro, "same": same})
    if as_json:
        print(json.dumps(rows, indent=1))
        return
    for row in rows:
        same = "same bits" if row["same"] else "OTHER BITS"
        print(f"{row['body']:16} {row['sets']:26} {row['width']:3} {row['us']:8.2f} µs  {same}")


if __name__ == "__main__":
    main()
