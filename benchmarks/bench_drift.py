"""Costs and benefits of the projection onto the phase space in long runs.

The same motion is integrated with different sizes of residuals below which the relations are not
corrected, and also with conserved integrals.  The results are the drift of every integral, the
error of the reduced state against a 34-digit integration at an early time, the number of
corrections, and seconds.
"""

from __future__ import annotations

import argparse
import json

import numpy as np

import chaplygin
import nonholonomic
from chaplygin.report.summary import drift
from flowlanes.flow import taylor_run as trajectory

CASES = {"chaplygin-ball": 1e5, "unbalanced-ball": 1e3, "heavy-disk": 1e3, "rattleback": 1e3}
LEFT_ALONE = {"never corrected": 1e9, "above 1e-15": 1e-15, "every step": 0.0}
EARLY = {"chaplygin-ball": 200.0, "unbalanced-ball": 200.0, "heavy-disk": 50.0, "rattleback": 2.0}


def measure(name: str, until: float) -> list[dict[str, object]]:
    entry = nonholonomic.CATALOGUE[name]
    system = entry.system()
    start = chaplygin.initial_state(system, entry.start.omega, entry.start.gamma)
    early = [0.0, EARLY[name]]
    exact = chaplygin.integrate(
        system, start, early, precision="quad", tolerance=1e-30, on_liftoff="warn"
    ).states[-1]
    size = len(system.symbols)
    chosen = trajectory.LEFT_ALONE["double"]
    rows: list[dict[str, object]] = []
    for manner in (*LEFT_ALONE, "integrals kept"):
        kept = manner == "integrals kept"
        trajectory.LEFT_ALONE["double"] = LEFT_ALONE.get(manner, chosen)
        options = {"on_liftoff": "warn", "keep_integrals": kept}
        near = chaplygin.integrate(system, start, early, **options).states[-1]
        long = chaplygin.integrate(system, start, np.linspace(0, until, 1001), **options)
        error = max(abs(float(a - b)) for a, b in zip(near[:size], exact[:size], strict=True))
        rows.append(
            {
                "system": name,
                "until": until,
                "manner": manner,
                "error": error,
                "drift": max(drift(long.records[f"law_{law.name}"]) for law in system.laws),
                "corrections": long.statistics.corrections,
                "steps": long.statistics.steps,
                "seconds": long.statistics.seconds,
            }
        )
    trajectory.LEFT_ALONE["double"] = chosen
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    rows = [row for name, until in CASES.items() for row in measure(name, until)]
    if options.json:
        print(json.dumps(rows, indent=2))
        return
    print(
        f"{'system':16} {'until':>7} {'relations':16} {'error':>8} {'drift':>8} "
        f"{'corrected':>10} {'steps':>7} {'s':>6}"
    )
    for row in rows:
        print(
            f"{row['system']:16} {row['until']:7g} {row['manner']:16} {row['error']:8.1e} "
            f"{row['drift']:8.1e} {row['corrections']:10d} {row['steps']:7d} {row['seconds']:6.2f}"
        )


if __name__ == "__main__":
    main()
